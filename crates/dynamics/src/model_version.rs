//! The version of the model, which results carry.

/// Counts the changes to the model, its integration or its searches that change any result, however little. Results of
/// different versions must not be mixed.
pub const MODEL_VERSION: u32 = 28;
