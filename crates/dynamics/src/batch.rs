//! Many landings in a batch. Each has its own time, step length, laws and events. Those whose next steps are of one
//! kind take them together, each in a lane of a register.
//!
//! A landing comes out the same, bit for bit, alone or beside any others.

mod lane_steps;

use std::sync::Arc;

use crate::land::land;
use crate::landing::{NextStart, Simulation, StepKind, Workspace};
use crate::methods::Method;
use crate::motion::Motion;
use crate::outcome::Outcome;
use crate::per_leg::PerLeg;
use crate::record::Landing;
use crate::registers::{Baseline, Transpose};
#[cfg(target_arch = "x86_64")]
use crate::registers::{Eight, Four};
use crate::rules::ContactRule;
use crate::scene::{Scene, Settings};
use crate::vehicle::Vehicle;

use lane_steps::LaneSteps;

/// Landings under way per lane: enough to fill the lanes of explicit or of implicit steps nearly always.
const UNDER_WAY: usize = 2;
/// Least number of filled lanes for a joint step to pay, of four or eight: it takes as long as so many steps alone.
const LEAST_FILLED: usize = 3;

/// A landing to be computed.
#[derive(Debug, Clone)]
pub struct Request {
    /// Identifies its result.
    pub key: usize,
    /// The vehicle.
    pub vehicle: Arc<Vehicle>,
    /// The touchdown.
    pub scene: Scene,
    /// Settings of the computation.
    pub settings: Settings,
}

impl Request {
    /// Computes it alone.
    fn land(&self) -> Landing {
        land(&self.vehicle, &self.scene, &self.settings)
    }
}

/// Occupancy of lanes.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Occupancy {
    /// Steps taken, rejected ones included.
    pub steps: u64,
    /// Lanes available for them; one for each step taken alone.
    pub lanes: u64,
}

impl Occupancy {
    /// Share of the lanes that were filled; NaN if there were no steps.
    pub fn share(&self) -> f64 {
        self.steps as f64 / self.lanes as f64
    }
}

/// Lanes of a batch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Width {
    /// One landing after the other.
    One,
    /// Two lanes, which any processor has.
    Two,
    /// Four lanes: AVX2 on x86-64.
    Four,
    /// Eight lanes: AVX-512 on x86-64.
    Eight,
}

impl Width {
    /// All widths, narrow to wide.
    pub const ALL: [Self; 4] = [Self::One, Self::Two, Self::Four, Self::Eight];

    /// Number of lanes.
    pub fn lanes(self) -> usize {
        match self {
            Self::One => 1,
            Self::Two => 2,
            Self::Four => 4,
            Self::Eight => 8,
        }
    }

    /// Returns whether this processor has registers this wide.
    pub fn is_supported(self) -> bool {
        match self {
            Self::One | Self::Two => true,
            #[cfg(target_arch = "x86_64")]
            Self::Four => Four::try_new().is_some(),
            #[cfg(target_arch = "x86_64")]
            Self::Eight => Eight::try_new().is_some(),
            #[cfg(not(target_arch = "x86_64"))]
            _ => false,
        }
    }

    /// Fastest width on this processor.
    pub fn fastest() -> Self {
        [Self::Eight, Self::Four]
            .into_iter()
            .find(|width| width.is_supported())
            .unwrap_or(Self::One)
    }
}

/// Computes the landings that `next` supplies, several at a time, and gives each result with its key to `done`. Ends
/// when `next` supplies none while none is under way. Until then `next` is called before every step for which there is
/// room.
pub fn land_many(
    next: &mut dyn FnMut() -> Option<Request>,
    done: &mut dyn FnMut(usize, Landing),
) -> Occupancy {
    land_in_lanes(Width::fastest(), next, done)
}

/// [`land_many`] in this many lanes, or in the most that this processor has.
pub fn land_in_lanes(
    width: Width,
    next: &mut dyn FnMut() -> Option<Request>,
    done: &mut dyn FnMut(usize, Landing),
) -> Occupancy {
    match width {
        Width::One => one_by_one(next, done),
        Width::Two => in_batch::<_, 2>(Baseline, next, done),
        #[cfg(target_arch = "x86_64")]
        Width::Four => match Four::try_new() {
            Some(registers) => in_batch::<_, 4>(registers, next, done),
            None => in_batch::<_, 2>(Baseline, next, done),
        },
        #[cfg(target_arch = "x86_64")]
        Width::Eight => match Eight::try_new() {
            Some(registers) => in_batch::<_, 8>(registers, next, done),
            None => land_in_lanes(Width::Four, next, done),
        },
        #[cfg(not(target_arch = "x86_64"))]
        _ => in_batch::<_, 2>(Baseline, next, done),
    }
}

fn one_by_one(
    next: &mut dyn FnMut() -> Option<Request>,
    done: &mut dyn FnMut(usize, Landing),
) -> Occupancy {
    let mut occupancy = Occupancy::default();
    while let Some(request) = next() {
        let landing = land(&request.vehicle, &request.scene, &request.settings);
        occupancy.steps += landing.steps;
        occupancy.lanes += landing.steps;
        done(request.key, landing);
    }
    occupancy
}

fn in_batch<R: Transpose<N>, const N: usize>(
    registers: R,
    next: &mut dyn FnMut() -> Option<Request>,
    done: &mut dyn FnMut(usize, Landing),
) -> Occupancy {
    // Lanes are made for hinged legs.
    let first = loop {
        let Some(request) = next() else {
            return Occupancy::default();
        };
        if request.vehicle.has_hinged_legs() {
            break request;
        }
        done(request.key, request.land());
    };
    let mut batch: Batch<R, N> = Batch::new(registers, &first);
    batch.start(&first, done);
    loop {
        while batch.under_way < UNDER_WAY * N
            && let Some(request) = next()
        {
            batch.start(&request, done);
        }
        if batch.under_way == 0 {
            return batch.occupancy;
        }
        batch.step(done);
    }
}

/// A landing of a batch.
struct Member {
    /// Identifies its result.
    key: usize,
    simulation: Simulation<'static>,
    /// Changes of each leg's coefficients that its lane has seen.
    changes_seen: PerLeg<u64>,
}

/// Landings that take steps of one kind.
struct LaneGroup<const N: usize> {
    steps: Box<LaneSteps<N>>,
    lanes: [Option<Box<Member>>; N],
    /// Landings that wait for a lane.
    waiting: Vec<Box<Member>>,
}

impl<const N: usize> LaneGroup<N> {
    fn new(motion: &Motion<f64>) -> Self {
        Self {
            steps: Box::new(LaneSteps::new(motion)),
            lanes: std::array::from_fn(|_| None),
            waiting: Vec::with_capacity(UNDER_WAY * N),
        }
    }

    fn filled(&self) -> usize {
        self.lanes.iter().flatten().count()
    }

    /// Gives free lanes to landings that wait.
    fn fill(&mut self) {
        for (lane, place) in self.lanes.iter_mut().enumerate() {
            if place.is_some() {
                continue;
            }
            let Some(mut member) = self.waiting.pop() else {
                return;
            };
            self.steps.load(lane, &member.simulation);
            member.changes_seen = member.simulation.trajectory.changes;
            *place = Some(member);
        }
    }
}

/// All landings under way. They share the first one's number of legs and contact rule.
struct Batch<R, const N: usize> {
    registers: R,
    legs: usize,
    contact_rule: ContactRule,
    under_way: usize,
    explicit: LaneGroup<N>,
    implicit: LaneGroup<N>,
    /// For steps of one landing alone.
    workspace: Workspace<f64>,
    /// Ended landings, whose places others take.
    ended: Vec<Box<Member>>,
    occupancy: Occupancy,
}

impl<R: Transpose<N>, const N: usize> Batch<R, N> {
    /// An empty batch for landings such as this one.
    fn new(registers: R, first: &Request) -> Self {
        let contact_rule = first.settings.rules(&first.vehicle).contact;
        let motion = Motion::new(&first.vehicle, &first.scene).with_contact_rule(contact_rule);
        Self {
            registers,
            legs: motion.leg_count(),
            contact_rule,
            under_way: 0,
            explicit: LaneGroup::new(&motion),
            implicit: LaneGroup::new(&motion),
            workspace: Workspace::new(&motion),
            ended: Vec::with_capacity(UNDER_WAY * N),
            occupancy: Occupancy::default(),
        }
    }

    fn group(&mut self, kind: StepKind) -> &mut LaneGroup<N> {
        match kind {
            StepKind::Explicit => &mut self.explicit,
            StepKind::Implicit => &mut self.implicit,
        }
    }

    /// Starts a landing. One by a method of 1966, with other legs, another number of them or another contact rule is
    /// computed at once, without a lane.
    fn start(&mut self, request: &Request, done: &mut dyn FnMut(usize, Landing)) {
        let Request {
            key,
            vehicle,
            scene,
            settings,
        } = request;
        let is_other = !vehicle.has_hinged_legs()
            || vehicle.leg_count() != self.legs
            || settings.rules(vehicle).contact != self.contact_rule;
        if settings.method() != Method::Located || is_other {
            return done(*key, request.land());
        }
        let member = Member {
            key: *key,
            simulation: Simulation::new(vehicle, scene, settings, None),
            changes_seen: PerLeg::same(self.legs, 0),
        };
        let mut member = match self.ended.pop() {
            Some(mut place) => {
                *place = member;
                place
            }
            None => Box::new(member),
        };
        self.under_way += 1;
        let goes_on = member.simulation.begin();
        self.go_on(member, goes_on, done);
    }

    /// Queues a landing for a lane, if it goes on.
    fn go_on(
        &mut self,
        member: Box<Member>,
        goes_on: Result<(), Outcome>,
        done: &mut dyn FnMut(usize, Landing),
    ) {
        match goes_on {
            Ok(()) => self.group(member.simulation.kind()).waiting.push(member),
            Err(outcome) => self.end(member, outcome, done),
        }
    }

    /// Ends a landing and reports its result.
    fn end(&mut self, member: Box<Member>, outcome: Outcome, done: &mut dyn FnMut(usize, Landing)) {
        self.under_way -= 1;
        done(member.key, member.simulation.result(outcome));
        self.ended.push(member);
    }

    /// Takes a step of the kind that fills more lanes, or one step of each landing alone where that is faster.
    fn step(&mut self, done: &mut dyn FnMut(usize, Landing)) {
        self.explicit.fill();
        self.implicit.fill();
        let [explicit, implicit] = [self.explicit.filled(), self.implicit.filled()];
        let (kind, filled) = if implicit > explicit {
            (StepKind::Implicit, implicit)
        } else {
            (StepKind::Explicit, explicit)
        };
        if filled < LEAST_FILLED.min(N) {
            self.step_alone(done);
        } else {
            self.occupancy.steps += filled as u64;
            self.occupancy.lanes += N as u64;
            self.step_in_lanes(kind, done);
        }
    }

    fn step_alone(&mut self, done: &mut dyn FnMut(usize, Landing)) {
        for lane in 0..N {
            for kind in [StepKind::Explicit, StepKind::Implicit] {
                if let Some(mut member) = self.group(kind).lanes[lane].take() {
                    self.occupancy.steps += 1;
                    self.occupancy.lanes += 1;
                    let goes_on = member.simulation.step(&mut self.workspace);
                    self.go_on(member, goes_on, done);
                }
            }
        }
    }

    fn step_in_lanes(&mut self, kind: StepKind, done: &mut dyn FnMut(usize, Landing)) {
        let registers = self.registers;
        let LaneGroup { steps, lanes, .. } = self.group(kind);
        steps.take(registers, kind);
        steps.store(
            registers,
            kind,
            lanes
                .each_mut()
                .map(|member| (member.as_mut()).map(|member| &mut member.simulation)),
        );

        let mut goes_on = [false; N];
        for (lane, goes_on) in goes_on.iter_mut().enumerate() {
            let group = self.group(kind);
            let Some(mut member) = group.lanes[lane].take() else {
                continue;
            };
            let simulation = &mut member.simulation;
            let (rate, errors) = (group.steps.rate(lane), group.steps.errors(lane));
            match simulation.end_lane_step(rate, errors) {
                Ok(next) if simulation.kind() == kind => {
                    match next {
                        NextStart::StepStart => {}
                        NextStart::StepEnd => *goes_on = true,
                        NextStart::Elsewhere => group.steps.load_start(lane, simulation),
                    }
                    let changes = simulation.trajectory.changes;
                    for leg in 0..changes.len() {
                        if member.changes_seen[leg] != changes[leg] {
                            group.steps.load_pieces(lane, leg, simulation);
                        }
                    }
                    group.steps.load_length(lane, simulation);
                    member.changes_seen = changes;
                    group.lanes[lane] = Some(member);
                }
                Ok(_) => self.group(simulation.kind()).waiting.push(member),
                Err(outcome) => self.end(member, outcome, done),
            }
        }
        self.group(kind).steps.finish_step(registers, goes_on);
    }
}
