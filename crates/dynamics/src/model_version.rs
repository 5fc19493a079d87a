//! The version of the model, which results carry.

/// Counts the changes to the model, to its integration or to searches that change any result, however little:
/// results of different versions are not to be mixed.
pub const MODEL_VERSION: u32 = 22;
