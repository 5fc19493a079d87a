//! Rules that the model leaves to choose.

/// When an element may crush further (model chapter 4).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CrushRule {
    /// The 1966 program's: only while the pad pivot (block centre) moves into the ground.
    #[default]
    PivotRate,
    /// Plain maximum-penetration hysteresis of the element itself.
    Section,
}

/// Where the ground acts on footpads and blocks (docs/model.md, "Contact at the face").
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ContactRule {
    /// The 1966 program's: forces on a footpad act at its pivot, by whose velocity friction is judged.
    #[default]
    Pivot,
    /// Forces act where the ground is touched, by the velocity of that place: contact only takes energy.
    Face,
}

/// When motion counts as subsided (model chapter 7).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RestRule {
    /// The 1966 program's: velocities and height of the CG are within limits that were made for the Surveyor.
    #[default]
    Limits,
    /// Once the vehicle has had too little energy to topple for a while (`landing/rest.rs`).
    Energy,
}

/// How friction sets in near rest (4.1.5).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FrictionProfile {
    /// Almost a step: viscous up to 0.0001 ft/s only.
    A,
    /// In between: viscous up to 0.005 ft/s. The report's figure is lost, the number is ours.
    B,
    /// That of the program's studies: viscous up to 0.05 ft/s.
    #[default]
    C,
}

impl FrictionProfile {
    /// Sliding speed up to which friction is viscous, ft/s.
    pub fn viscous_limit(self) -> f64 {
        match self {
            Self::A => 1e-4,
            Self::B => 5e-3,
            Self::C => 0.05,
        }
    }

    /// dμ/dS over μ0 near rest, s/ft: meets the falling branch.
    pub fn viscous(self) -> f64 {
        match self {
            Self::A => 12099.8,
            Self::B => 241.8,
            Self::C => 24.0,
        }
    }
}
