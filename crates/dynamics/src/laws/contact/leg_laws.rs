//! The laws of one leg, from its design.

use libm::{cos, sincos};

use super::{Sets, Sinkages};
use crate::crush::CrushLaw;
use crate::friction::FrictionLaw;
use crate::hinge::Stops;
use crate::parts::{LegDesign, Strut, StrutElement};
use crate::rules::{ContactRule, CrushRule};
use crate::soil::Soil;
use crate::strut::{STOP_STROKE, StrutLaw};

/// cos 65 deg: the model has no law for a loaded pad inclined further.
const LEAST_PAD_INCLINATION: f64 = 0.422_618_261_740_699_4;

/// Distance from its resting place on a stop at which a pad counts as arrived, rad: at least this,
/// and at least this share of the tolerance.
const PAD_ARRIVAL: f64 = 1e-12;
const PAD_ARRIVAL_SHARE: f64 = 0.01;

/// The laws of one leg. A clone shares its tables.
#[derive(Debug, Clone, PartialEq)]
pub struct LegLaws {
    pub(super) pad: CrushLaw,
    pub(super) block: CrushLaw,
    pub(super) strut: StrutLaw,
    /// Cartridge of the strut: absent in a shock absorber.
    pub(super) cartridge: CrushLaw,
    /// See [`LegLaws::table_end`].
    pub(super) table_end: f64,
    pub(super) stops: Stops,
    /// Footpad on its edge: absent where such a landing ends.
    pub(super) edge: CrushLaw,
    /// cos ξ below which a footpad is on its edge, or has no law.
    pub(super) least_inclination: f64,
    pub(super) rule: CrushRule,
    pub(super) friction: FrictionLaw,
    pub(super) heights: Heights,
    /// Torque by which a strut pushes its link back before its stroke counts, ft·lb; a pad would not stay pushed by
    /// less.
    pub(super) torque_on_stop: f64,
    /// Torque of the surface that pushes a link off its extension stop, ft·lb.
    pub(super) least_push: f64,
}

/// Torque of a strut on its link where its stroke begins to count, ft·lb.
fn torque_on_stop(design: &LegDesign) -> f64 {
    let stiffness = match &design.strut.element {
        StrutElement::Damper(damper) => damper.structural_stiffness,
        StrutElement::Honeycomb(honeycomb) => honeycomb.unloading_stiffness,
    };
    stiffness * STOP_STROKE * design.linkage.hardpoint_distance
}

/// Greatest crush and sinkage of a footpad, ft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PadDepths {
    /// Crush of its sections, or of its edge.
    pub crush: f64,
    /// Crush with its hinge on the ground.
    pub height: f64,
    /// Sinkage into soil.
    pub sinkage: f64,
}

/// Interferences at which elements are crushed by the whole height up to their hinge or hardpoint, ft; on soil with the sinkage
/// there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Heights {
    pub(super) pad: f64,
    pub(super) edge: f64,
    pub(super) block: f64,
}

impl Heights {
    fn of(design: &LegDesign) -> Self {
        let footpad = &design.footpad;
        // A hardpoint is the end of a block only if the block hangs below it.
        let block = (design.block.as_ref()).filter(|block| block.height > 0.0);
        Self {
            pad: footpad.height,
            edge: footpad.edge.as_ref().map_or(f64::INFINITY, |edge| {
                let (sine, cosine) = sincos(edge.angle);
                0.5 * (footpad.diameter * sine + footpad.height * cosine)
            }),
            block: block.map_or(f64::INFINITY, |block| block.height),
        }
    }
}

/// See [`LegLaws::table_end`]. A single knot is a load for all strokes.
fn table_end(strut: &Strut) -> f64 {
    // Lengths in other units are rounded.
    const REACHES: f64 = 0.999;
    let reached = REACHES * (strut.extended_length - strut.minimum_length);
    let end = match &strut.element {
        StrutElement::Honeycomb(cartridge) => cartridge.crush_load.knots().last(),
        StrutElement::Damper(_) => None,
    };
    let end = end.map(|[end, _]| *end);
    let is_short = |end: &f64| *end > 0.0 && *end < reached;
    end.filter(is_short).unwrap_or(f64::INFINITY)
}

impl LegLaws {
    /// The laws of a leg of this design, under the default rules.
    pub fn of(design: &LegDesign) -> Self {
        Self {
            pad: CrushLaw::new(&design.footpad.profile, CrushLaw::PAD_PRESSURE_THRESHOLD),
            block: design
                .block
                .as_ref()
                .map_or_else(CrushLaw::absent, |block| {
                    CrushLaw::new(&block.profile, CrushLaw::BLOCK_PRESSURE_THRESHOLD)
                }),
            strut: StrutLaw::new(&design.strut),
            table_end: table_end(&design.strut),
            cartridge: match &design.strut.element {
                StrutElement::Damper(_) => CrushLaw::absent(),
                StrutElement::Honeycomb(honeycomb) => CrushLaw::of_cartridge(honeycomb),
            },
            stops: Stops {
                inner: design.footpad.minimum_angle,
                outer: design.footpad.maximum_angle,
                arrival: PAD_ARRIVAL,
                rule: ContactRule::default(),
            },
            edge: (design.footpad.edge.as_ref()).map_or_else(CrushLaw::absent, |edge| {
                CrushLaw::of_edge(edge, &design.footpad.profile)
            }),
            least_inclination: (design.footpad.edge.as_ref())
                .map_or(LEAST_PAD_INCLINATION, |edge| cos(edge.angle)),
            rule: CrushRule::default(),
            friction: FrictionLaw::default(),
            heights: Heights::of(design),
            torque_on_stop: torque_on_stop(design),
            least_push: 0.0,
        }
    }

    /// Returns these laws under another contact rule.
    pub fn with_contact_rule(self, rule: ContactRule) -> Self {
        // Forces that set in all at once make a light pad chatter.
        let [pad, block, least_push] = match rule {
            ContactRule::Pivot => [
                CrushLaw::PAD_PRESSURE_THRESHOLD,
                CrushLaw::BLOCK_PRESSURE_THRESHOLD,
                0.0,
            ],
            ContactRule::Face => [0.0, 0.0, self.torque_on_stop],
        };
        Self {
            pad: self.pad.with_pressure_threshold(pad),
            block: self.block.with_pressure_threshold(block),
            stops: Stops { rule, ..self.stops },
            least_push,
            ..self
        }
    }

    /// Greatest crush and sinkage of a pad whose sections have these sets: for methods that keep no more.
    pub fn pad_depths(&self, sets: &Sets) -> PadDepths {
        let [outer, inner] = sets.pad.map(|set| self.pad.deepest(set));
        self.pad_depths_at(outer.max(inner))
    }

    /// Crush and sinkage of a pad whose deepest section reached this interference, ft.
    pub(super) fn pad_depths_at(&self, deepest: f64) -> PadDepths {
        let sinkage = self.pad.sinkage_at(deepest);
        PadDepths {
            crush: deepest - sinkage,
            height: self.heights.pad - self.pad.sinkage_at(self.heights.pad),
            sinkage,
        }
    }

    /// These sets without those of the soil, and the sinkages that left them, if there is soil.
    pub fn without_soil(&self, sets: &Sets) -> (Sets, Option<Sinkages>) {
        let own = Sets {
            pad: sets.pad.map(|set| self.pad.own_set(set)),
            block: self.block.own_set(sets.block),
            ..*sets
        };
        let sinkage = |law: &CrushLaw, set: f64| law.sinkage_at(law.deepest(set));
        let sinkages = self.pad.is_on_soil().then(|| Sinkages {
            pad: sets.pad.map(|set| sinkage(&self.pad, set)),
            block: sinkage(&self.block, sets.block),
        });
        (own, sinkages)
    }

    /// Returns these laws on this soil, for the leg of this design. A pad on its edge stands as on rock.
    pub fn on_soil(self, soil: &Soil, design: &LegDesign) -> Self {
        let Soil::Yielding(bearing) = soil else {
            return self;
        };
        let of_block = design.block.as_ref();
        let of_block = of_block.map_or(0.0, |block| block.crush_pressure);
        let pad = self.pad.on_soil(bearing, design.footpad.crush_pressure);
        let block = self.block.on_soil(bearing, of_block);
        Self {
            heights: Heights {
                pad: pad.interference_at_crush(self.heights.pad),
                block: block.interference_at_crush(self.heights.block),
                ..self.heights
            },
            pad,
            block,
            ..self
        }
    }

    /// Returns these laws under another crush rule.
    pub fn with_crush_rule(self, rule: CrushRule) -> Self {
        Self { rule, ..self }
    }

    /// Returns these laws with another law of friction.
    pub fn with_friction(self, friction: FrictionLaw) -> Self {
        Self { friction, ..self }
    }

    /// Stroke at which the strut bottoms, ft.
    pub fn bottoming_stroke(&self) -> f64 {
        self.strut.bottoming_stroke()
    }

    /// Stroke at which the crush table of the cartridge ends, ft; infinite without a table, and where it reaches the
    /// stroke at which the strut bottoms.
    pub fn table_end(&self) -> f64 {
        self.table_end
    }

    /// Friction of the footpad and of the block.
    pub fn friction(&self) -> &FrictionLaw {
        &self.friction
    }

    /// Returns these laws with changes no more exact than landings at this tolerance need.
    pub fn within(self, tolerance: f64) -> Self {
        let arrival = PAD_ARRIVAL.max(PAD_ARRIVAL_SHARE * tolerance);
        Self {
            stops: Stops {
                arrival,
                ..self.stops
            },
            strut: self.strut.within(tolerance),
            ..self
        }
    }
}
