//! The active piece of every law of one leg, and its changes by events.
//!
//! A [`LegMode`] is the discrete side of a leg's state: crush memory, friction branches, strut and hinge. It yields the
//! coefficients for the equations of motion and the range of each signal over which they hold. When a signal leaves its
//! range, [`LegMode::cross`] sets the next piece.

mod bearing;
mod choice;
mod leg_laws;

use crate::crush::{Crush, CrushLaw, PressureLine};
use crate::friction::Sliding;
use crate::hinge::Hinge;
use crate::integrator::event::{Bounds, Exit};
use crate::leg_pieces::{EdgePiece, LegPieces};
use crate::outcome::{Failure, Outcome};
use crate::rules::{ContactRule, CrushRule};
use crate::signal::{LegSignals, Signal, by_signal};
use crate::strut::{GentleKinks, Stance};

pub use choice::Choice;
pub use leg_laws::{LegLaws, PadDepths};

/// Cosine below which the inclination of a pad is held in its interference.
const LEAST_INCLINATION: f64 = 0.1;

/// Slack of the guard on the cosine of a pad that has an edge.
const INCLINATION_SLACK: f64 = 1e-12;

/// Plastic sets of the elements of a leg, ft.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Sets {
    /// Outboard and inboard pad section.
    pub pad: [f64; 2],
    /// Block.
    pub block: f64,
    /// Cartridge of the strut.
    pub strut: f64,
}

/// Greatest sinkages so far of the elements of a leg into soil, ft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sinkages {
    /// Outboard and inboard pad section.
    pub pad: [f64; 2],
    /// Block.
    pub block: f64,
}

impl Sinkages {
    /// None, as on rock.
    pub const NONE: Self = Self {
        pad: [0.0; 2],
        block: 0.0,
    };
}

/// The discrete state of one leg.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LegMode {
    pad: [Crush; 2],
    edge: Crush,
    /// True if the footpad has turned over on its edge; its sections rest meanwhile.
    is_on_edge: bool,
    block: Crush,
    cartridge: Crush,
    /// True once any section has touched the surface.
    pad_has_touched: bool,
    block_has_touched: bool,
    pad_sliding: Sliding,
    block_sliding: Sliding,
    stance: Stance,
    hinge: Hinge,
}

impl LegMode {
    /// A leg before its first contact.
    pub fn untouched(laws: &LegLaws) -> Self {
        Self {
            pad: [Crush::untouched(&laws.pad); 2],
            edge: Crush::untouched(&laws.edge),
            is_on_edge: false,
            block: Crush::untouched(&laws.block),
            cartridge: Crush::untouched(&laws.cartridge),
            pad_has_touched: false,
            block_has_touched: false,
            pad_sliding: Sliding::Steady,
            block_sliding: Sliding::Steady,
            stance: Stance::extended(false, 0.0),
            hinge: Hinge::free(),
        }
    }

    /// Longest step that the laws allow, whatever its error, s, at a rate state α̇ (rad/s).
    pub fn longest_step(&self, pad_rate: f64) -> f64 {
        self.hinge.longest_step(pad_rate)
    }

    /// Angle α of the footpad with this turn, rad.
    pub fn pad_angle(&self, laws: &LegLaws, turn: f64) -> f64 {
        self.hinge.angle(laws.stops, turn)
    }

    /// Returns whether the hinge of the footpad is in another mode.
    pub fn has_other_hinge(&self, other: &Self) -> bool {
        self.hinge != other.hinge
    }

    /// Turn of the footpad at an angle α, rad.
    pub fn pad_turn(&self, laws: &LegLaws, angle: f64) -> f64 {
        self.hinge.turn(laws.stops, angle)
    }

    /// Returns whether the footpad is on a stop of its hinge, one with its link ([`ContactRule::Face`]).
    pub fn pad_is_on_stop(&self) -> bool {
        self.hinge.is_on_stop()
    }

    /// Returns whether the extension stop holds the link against opening ([`ContactRule::Face`]).
    pub fn is_held_by_stop(&self, laws: &LegLaws) -> bool {
        laws.stops.rule == ContactRule::Face && self.stance.is_on_stop()
    }

    /// Returns whether the leg hangs in the air with its link still.
    pub fn is_hanging(&self) -> bool {
        self.stance.is_hanging()
    }

    /// Element and law behind the signals of the outboard section: that section or, for a footpad on its edge, the
    /// edge.
    fn outer<'a>(&'a self, laws: &'a LegLaws) -> (&'a Crush, &'a CrushLaw) {
        if self.is_on_edge {
            (&self.edge, &laws.edge)
        } else {
            (&self.pad[0], &laws.pad)
        }
    }

    /// The same, mutable.
    fn outer_mut<'a>(&'a mut self, laws: &'a LegLaws) -> (&'a mut Crush, &'a CrushLaw) {
        if self.is_on_edge {
            (&mut self.edge, &laws.edge)
        } else {
            (&mut self.pad[0], &laws.pad)
        }
    }

    /// Elements of the footpad that can touch the surface: its sections, or its edge.
    fn pad_elements(&self) -> &[Crush] {
        if self.is_on_edge {
            std::slice::from_ref(&self.edge)
        } else {
            &self.pad
        }
    }

    /// Returns whether a section of the pad, or its edge, is in contact.
    pub fn pad_in_contact(&self) -> bool {
        self.pad_elements().iter().any(Crush::in_contact)
    }

    /// Returns whether the block is in contact.
    pub fn block_in_contact(&self) -> bool {
        self.block.in_contact()
    }

    /// Returns whether the leg is on the surface.
    fn on_surface(&self) -> bool {
        self.pad_in_contact() || self.block_in_contact()
    }

    /// Returns whether the ground pushes on the pad or the block.
    pub fn is_pressed(&self) -> bool {
        self.pad_loaded() || self.block.is_loaded()
    }

    /// Returns whether contact gained or lost by an element without pressure matters at once: the first contact of its
    /// pad or block is noted, and contact decides whether an extended leg hangs or rests on its stop, unless another
    /// element presses on the surface anyway.
    fn is_contact_watched(&self, has_touched: bool) -> bool {
        !has_touched || self.stance.is_extended() && !self.is_pressed()
    }

    /// Updates contacts that were not watched.
    fn update_contact(&mut self, signals: &LegSignals<f64>) {
        let [pad_is_watched, block_is_watched] =
            [self.pad_has_touched, self.block_has_touched].map(|has| self.is_contact_watched(has));
        let [outer, inner] = &mut self.pad;
        let outer = if self.is_on_edge {
            &mut self.edge
        } else {
            outer
        };
        for (element, is_watched, signal) in [
            (outer, pad_is_watched, Signal::OuterInterference),
            (inner, pad_is_watched, Signal::InnerInterference),
            (&mut self.block, block_is_watched, Signal::BlockInterference),
        ] {
            if !is_watched {
                element.update_contact(signals[signal as usize]);
            }
        }
    }

    fn pad_loaded(&self) -> bool {
        self.pad_elements().iter().any(Crush::is_loaded)
    }

    /// Coefficients of the active pieces.
    pub fn pieces(&self, laws: &LegLaws) -> LegPieces<f64> {
        let load = self.cartridge.line(&laws.cartridge);
        let (strut, link) = self.stance.pieces(&laws.strut, &load);
        let (pad, edge) = if self.is_on_edge {
            let edge = EdgePiece {
                load: self.edge.line(&laws.edge),
                is_active: 1.0,
            };
            ([PressureLine::slack(); 2], edge)
        } else {
            let sections = self.pad.map(|section| section.line(&laws.pad));
            (sections, EdgePiece::on_face())
        };
        LegPieces {
            pad,
            edge,
            block: self.block.line(&laws.block),
            pad_friction: self.pad_sliding.piece(&laws.friction),
            block_friction: self.block_sliding.piece(&laws.friction),
            strut,
            link,
            hinge: self.hinge.piece(laws.stops),
        }
    }

    /// Plastic sets at these signals.
    pub fn sets(&self, laws: &LegLaws, signals: &LegSignals<f64>) -> Sets {
        let value = |signal: Signal| signals[signal as usize];
        let [outer, inner] = &self.pad;
        Sets {
            pad: [
                outer.set_at(&laws.pad, value(Signal::OuterInterference)),
                inner.set_at(&laws.pad, value(Signal::InnerInterference)),
            ],
            block: (self.block).set_at(&laws.block, value(Signal::BlockInterference)),
            strut: (self.cartridge).set_at(&laws.cartridge, value(Signal::Stroke)),
        }
    }

    /// Centres the coefficients of gently bending laws on a stroke δ (ft), the leg's present one. Returns whether any
    /// changed.
    pub fn follow(&mut self, laws: &LegLaws, stroke: f64) -> bool {
        self.stance.follow(&laws.strut, stroke)
    }

    /// The gentle kinks of the strut law on either side of the leg's present state, with its link at a rate γ̇ (rad/s),
    /// if its strut works.
    pub fn gentle_kinks(&self, laws: &LegLaws, link_rate: f64) -> Option<GentleKinks> {
        self.stance.gentle_kinks(&laws.strut, link_rate)
    }

    /// Ranges of the signals over which the active pieces hold, signal by signal.
    pub fn ranges(&self, laws: &LegLaws) -> [Bounds; Signal::RANGED] {
        let only = |holds: bool, range: Bounds| if holds { range } else { Bounds::FREE };
        let by_pivot = laws.rule == CrushRule::PivotRate;
        let pad_loaded = self.pad_loaded();
        let interference = |element: &Crush, law: &CrushLaw, has_touched: bool, height: f64| {
            let bounds = element.interference_bounds(law, self.is_contact_watched(has_touched));
            let bears_as_stop = laws.stops.rule == ContactRule::Face && element.is_loaded();
            bounds.meet(only(bears_as_stop, Bounds::below(height)))
        };
        let (outer, outer_law) = self.outer(laws);
        let inner = &self.pad[1];
        let is_on_face = !self.is_on_edge;
        by_signal![
            OuterInterference: interference(
                outer,
                outer_law,
                self.pad_has_touched,
                self.pad_height(laws),
            ),
            InnerInterference: only(
                is_on_face,
                interference(inner, &laws.pad, self.pad_has_touched, laws.heights.pad),
            ),
            BlockInterference: interference(
                &self.block,
                &laws.block,
                self.block_has_touched,
                laws.heights.block,
            ),
            Stroke: (self.stance.stroke_bounds(&laws.strut)).meet(self.cartridge_bounds(laws)),
            OuterRate: outer.rate_bounds(),
            InnerRate: only(is_on_face, inner.rate_bounds()),
            BlockRate: self.block.rate_bounds(),
            StrokeRate: self.cartridge.rate_bounds(),
            PivotRate: only(
                by_pivot && is_on_face,
                outer.drive_bounds().meet(inner.drive_bounds()),
            ),
            BlockCentreRate: only(by_pivot, self.block.drive_bounds()),
            PadSliding: only(pad_loaded, self.pad_sliding.bounds(&laws.friction)),
            BlockSliding: only(
                self.block.is_loaded(),
                self.block_sliding.bounds(&laws.friction),
            ),
            LinkRate: self.stance.rate_bounds(&laws.strut),
            LinkTorque: self.stance.torque_bounds(laws.least_push),
            PadTurn: self.hinge.turn_bounds(laws.stops),
            PadRate: self.hinge.rate_bounds(),
            HingeDrive: self.hinge.drive_bounds(laws.stops),
            PadInclination: self.inclination_bounds(laws),
        ]
    }

    /// Height by which the outer element of the pad can be crushed, ft.
    fn pad_height(&self, laws: &LegLaws) -> f64 {
        if self.is_on_edge {
            laws.heights.edge
        } else {
            laws.heights.pad
        }
    }

    /// Outcome of the landing if an element has used up its height.
    fn bottomed(
        &self,
        laws: &LegLaws,
        leg: usize,
        signal: Signal,
        interference: f64,
    ) -> Option<Outcome> {
        let (element, height, outcome) = match signal {
            Signal::OuterInterference => (
                self.outer(laws).0,
                self.pad_height(laws),
                Outcome::BottomedPad { leg },
            ),
            Signal::InnerInterference => {
                (&self.pad[1], laws.heights.pad, Outcome::BottomedPad { leg })
            }
            Signal::BlockInterference => (
                &self.block,
                laws.heights.block,
                Outcome::BottomedBlock { leg },
            ),
            _ => return None,
        };
        let bears_as_stop = laws.stops.rule == ContactRule::Face && element.is_loaded();
        (bears_as_stop && interference >= height).then_some(outcome)
    }

    /// Range of cos ξ over which the pad stays on its face, or on its edge.
    fn inclination_bounds(&self, laws: &LegLaws) -> Bounds {
        let limit = laws.least_inclination;
        if laws.edge.is_absent() {
            if self.pad_loaded() {
                Bounds::above(limit)
            } else {
                Bounds::FREE
            }
        } else if self.is_on_edge {
            Bounds::below(limit).widened(INCLINATION_SLACK)
        } else {
            Bounds::above(limit).widened(INCLINATION_SLACK)
        }
    }

    /// Turns the pad over on its edge, or back on its face.
    fn turn_over(&mut self, laws: &LegLaws, signals: &LegSignals<f64>) {
        let value = |signal: Signal| signals[signal as usize];
        let (outer, law) = self.outer_mut(laws);
        outer.leave_front(law, value(Signal::OuterInterference));
        if !self.is_on_edge {
            self.pad[1].leave_front(&laws.pad, value(Signal::InnerInterference));
        }
        self.is_on_edge = !self.is_on_edge;
        if self.is_on_edge {
            self.edge.take_over();
        } else {
            self.pad.iter_mut().for_each(Crush::take_over);
        }
    }

    /// Range of the stroke over which the cartridge of the strut keeps its line.
    fn cartridge_bounds(&self, laws: &LegLaws) -> Bounds {
        (self.cartridge).interference_bounds(&laws.cartridge, false)
    }

    /// Sets the next piece after `signal` left its range. `leg` is this leg's index.
    ///
    /// # Errors
    /// The outcome, when the event ends the landing.
    pub fn cross(
        &mut self,
        laws: &LegLaws,
        leg: usize,
        signal: Signal,
        exit: Exit,
        signals: &LegSignals<f64>,
    ) -> Result<(), Outcome> {
        self.update_contact(signals);
        let before = *self;
        let value = |signal: Signal| signals[signal as usize];
        let driven = |rate: Signal| laws.rule == CrushRule::Section || value(rate) >= 0.0;
        if let Some(outcome) = self.bottomed(laws, leg, signal, value(signal)) {
            return Err(outcome);
        }
        match signal {
            Signal::OuterInterference => {
                let driven = self.is_on_edge || driven(Signal::PivotRate);
                let (outer, law) = self.outer_mut(laws);
                outer.cross_interference(law, exit, value(signal), driven);
            }
            Signal::InnerInterference => {
                let driven = driven(Signal::PivotRate);
                self.pad[1].cross_interference(&laws.pad, exit, value(signal), driven);
            }
            Signal::BlockInterference => {
                let driven = driven(Signal::BlockCentreRate);
                self.block
                    .cross_interference(&laws.block, exit, value(signal), driven);
            }
            Signal::OuterRate => {
                let (outer, law) = self.outer_mut(laws);
                outer.leave_front(law, value(Signal::OuterInterference));
            }
            Signal::InnerRate => {
                self.pad[1].leave_front(&laws.pad, value(Signal::InnerInterference));
            }
            Signal::BlockRate => {
                self.block
                    .leave_front(&laws.block, value(Signal::BlockInterference));
            }
            Signal::PivotRate => {
                let driven = exit == Exit::Above;
                self.pad[0].drive(&laws.pad, driven, value(Signal::OuterInterference));
                self.pad[1].drive(&laws.pad, driven, value(Signal::InnerInterference));
            }
            Signal::BlockCentreRate => {
                self.block.drive(
                    &laws.block,
                    exit == Exit::Above,
                    value(Signal::BlockInterference),
                );
            }
            Signal::PadSliding => {
                self.pad_sliding = self.pad_sliding.neighbour(exit == Exit::Above);
            }
            Signal::BlockSliding => {
                self.block_sliding = self.block_sliding.neighbour(exit == Exit::Above);
            }
            Signal::Stroke => {
                if exit == Exit::Above && value(signal) >= laws.strut.bottoming_stroke() {
                    return Err(Outcome::Bottomed { leg });
                }
                if let Some(exit) = self.cartridge_bounds(laws).exit(value(signal)) {
                    (self.cartridge).cross_interference(&laws.cartridge, exit, value(signal), true);
                } else {
                    let rate = value(Signal::LinkRate);
                    self.stance
                        .cross_stroke(&laws.strut, exit, before.on_surface(), rate);
                }
            }
            Signal::LinkRate => {
                let stroke = value(Signal::Stroke);
                let rate = value(signal);
                self.stance
                    .cross_rate(&laws.strut, before.on_surface(), stroke, rate);
            }
            Signal::LinkTorque => self.stance.cross_torque(exit),
            Signal::PadTurn => self.hinge.cross_turn(laws.stops, exit),
            Signal::PadRate => self.hinge.cross_rate(),
            Signal::HingeDrive => self.hinge.cross_drive(exit),
            Signal::StrokeRate => {
                (self.cartridge).leave_front(&laws.cartridge, value(Signal::Stroke));
            }
            Signal::StrutForce
            | Signal::StrutLever
            | Signal::FootX
            | Signal::FootY
            | Signal::FootZ
            | Signal::HardpointDepth => {}
            Signal::PadInclination if !laws.edge.is_absent() => self.turn_over(laws, signals),
            Signal::PadInclination => {
                return Err(Outcome::Failure(Failure::PadInclination { leg }));
            }
        }
        self.follow_contact(laws, &before, signals);
        Ok(())
    }

    /// Follows up gained or lost contact: chooses the friction branch, and whether the link hangs or rests on its stop.
    fn follow_contact(&mut self, laws: &LegLaws, before: &Self, signals: &LegSignals<f64>) {
        let value = |signal: Signal| signals[signal as usize];
        self.pad_has_touched |= self.pad_in_contact();
        self.block_has_touched |= self.block_in_contact();
        if self.pad_loaded() && !before.pad_loaded() {
            self.pad_sliding = Sliding::at(&laws.friction, value(Signal::PadSliding));
        }
        if self.block.is_loaded() && !before.block.is_loaded() {
            self.block_sliding = Sliding::at(&laws.friction, value(Signal::BlockSliding));
        }
        if self.on_surface() != before.on_surface() && self.stance.is_extended() {
            self.stance = Stance::extended(self.on_surface(), value(Signal::LinkRate));
        }
    }
}
