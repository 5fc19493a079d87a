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

/// When a landing counts as stable (model chapter 7).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RestRule {
    /// The 1966 program's: velocities and height of the CG are within limits that were made for the Surveyor, or it has
    /// rocked back.
    #[default]
    Limits,
    /// Once the vehicle has stood for a while on supports that hold it (`landing/rest.rs`).
    Energy,
}

/// When a vehicle counts as toppled (model chapter 7).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum TopplingRule {
    /// The 1966 program's: the CG passes over the line through the critical feet, in the plane of its motion.
    #[default]
    CriticalFeet,
    /// The vertical through the CG has left the convex hull of all feet in plan and moves outward.
    Hull,
}

/// The rules by which a vehicle lands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rules {
    /// When an element may crush further.
    pub crush: CrushRule,
    /// Where the ground acts on footpads and blocks.
    pub contact: ContactRule,
    /// When a landing counts as stable.
    pub rest: RestRule,
    /// When a vehicle counts as toppled.
    pub toppling: TopplingRule,
}

impl Rules {
    /// Those of the program of 1966.
    pub const REPORT: Self = Self {
        crush: CrushRule::PivotRate,
        contact: ContactRule::Pivot,
        rest: RestRule::Limits,
        toppling: TopplingRule::CriticalFeet,
    };

    /// Those that hold for any lander on any ground.
    pub const PHYSICAL: Self = Self {
        crush: CrushRule::Section,
        contact: ContactRule::Face,
        rest: RestRule::Energy,
        toppling: TopplingRule::Hull,
    };
}

/// What settings say of rules: whatever they leave open is as the vehicle has it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct RuleChoices {
    /// All rules.
    pub set: Option<Rules>,
    /// In place of that of the set, as are the next.
    pub crush: Option<CrushRule>,
    /// Where the ground acts on footpads and blocks.
    pub contact: Option<ContactRule>,
    /// When a landing counts as stable.
    pub rest: Option<RestRule>,
    /// When a vehicle counts as toppled.
    pub toppling: Option<TopplingRule>,
}

impl RuleChoices {
    /// The rules in force for a vehicle with rules of its own.
    pub fn over(&self, vehicle: Rules) -> Rules {
        let set = self.set.unwrap_or(vehicle);
        Rules {
            crush: self.crush.unwrap_or(set.crush),
            contact: self.contact.unwrap_or(set.contact),
            rest: self.rest.unwrap_or(set.rest),
            toppling: self.toppling.unwrap_or(set.toppling),
        }
    }
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
