//! Rules of the model to choose from.

/// Rule by which an element may crush further (model chapter 4).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CrushRule {
    /// The 1966 program's: only while the pad pivot (block centre) moves into the ground.
    #[default]
    PivotRate,
    /// Plain maximum-penetration hysteresis of the element itself.
    Section,
}

/// Place where the ground acts on footpads and blocks (docs/model.md, "Contact at the face").
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ContactRule {
    /// The 1966 program's: forces on a footpad act at its pivot, whose velocity determines friction.
    #[default]
    Pivot,
    /// Forces act where the ground is touched, by the velocity of that place: contact only takes energy.
    Face,
}

/// Rule by which a landing counts as stable (model chapter 7).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RestRule {
    /// The 1966 program's: velocities and height of the CG are within limits made for the Surveyor, or it has rocked
    /// back.
    #[default]
    Limits,
    /// Once the vehicle has stood for a while on supports that hold it (`landing/rest.rs`).
    Energy,
}

/// Rule by which a vehicle counts as toppled (model chapter 7).
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
    /// Rule of further crushing.
    pub crush: CrushRule,
    /// Place where the ground acts on footpads and blocks.
    pub contact: ContactRule,
    /// Rule of stable landings.
    pub rest: RestRule,
    /// Rule of toppling.
    pub toppling: TopplingRule,
}

impl Rules {
    /// The rules of the program of 1966.
    pub const REPORT: Self = Self {
        crush: CrushRule::PivotRate,
        contact: ContactRule::Pivot,
        rest: RestRule::Limits,
        toppling: TopplingRule::CriticalFeet,
    };

    /// The rules that hold for any lander on any ground.
    pub const PHYSICAL: Self = Self {
        crush: CrushRule::Section,
        contact: ContactRule::Face,
        rest: RestRule::Energy,
        toppling: TopplingRule::Hull,
    };
}

/// Choices of rules in settings. Rules left open are the vehicle's.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct RuleChoices {
    /// All rules.
    pub set: Option<Rules>,
    /// Replaces that of the set, as do the next.
    pub crush: Option<CrushRule>,
    /// Place where the ground acts on footpads and blocks.
    pub contact: Option<ContactRule>,
    /// Rule of stable landings.
    pub rest: Option<RestRule>,
    /// Rule of toppling.
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

/// Onset of friction near rest (4.1.5).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FrictionProfile {
    /// Almost a step: viscous up to 0.0001 ft/s only.
    A,
    /// In between: viscous up to 0.005 ft/s. The report's figure is lost; this number is our own.
    B,
    /// The profile of the program's studies: viscous up to 0.05 ft/s.
    #[default]
    C,
}

impl FrictionProfile {
    /// Greatest friction near rest as a multiple of μ0, where viscous friction ends: 1.21 − 0.2 S, 1.2 in profile C.
    pub const STATIC_RATIO: f64 = 1.2;

    /// Sliding speed up to which friction is viscous, ft/s.
    pub fn viscous_limit(self) -> f64 {
        match self {
            Self::A => 1e-4,
            Self::B => 5e-3,
            Self::C => 0.05,
        }
    }

    /// dμ/dS over μ0 near rest, s/ft; it meets the falling branch.
    pub fn viscous(self) -> f64 {
        match self {
            Self::A => 12099.8,
            Self::B => 241.8,
            Self::C => 24.0,
        }
    }
}
