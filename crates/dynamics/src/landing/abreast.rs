//! Landings side by side: each takes its own way, with its own time, length of steps, laws and events, and
//! those that step alike do so in the lanes of registers.
//!
//! A landing comes out the same, bit for bit, as alone and whatever lands beside it.

mod steps;

use std::ops::Deref;

use super::account::History;
use super::advance::tell_pad_rates;
use super::{Attempt, Course, Flight, Way, land};
use crate::methods::Method;
use crate::motion::Motion;
use crate::outcome::Outcome;
use crate::record::{Instant, Landing};
#[cfg(target_arch = "x86_64")]
use crate::registers::Eight;
use crate::registers::{Four, Lanes};
use crate::scene::{Scene, Settings};
use crate::vehicle::Vehicle;

use steps::{Kind, Place, Spare, Steps};

/// Landings under way per lane: so many that the lanes of explicit or of implicit steps can nearly always be filled.
const UNDER_WAY: usize = 2;
/// So many lanes must be taken for a step in all of them to be worth its while, four or eight: it takes as long as so
/// many steps alone.
const WORTH: usize = 3;

/// A landing to be computed.
#[derive(Debug, Clone, Copy)]
pub struct Request<K, V> {
    /// What its result is told by.
    pub key: K,
    /// What lands: a reference to it, or something that owns it.
    pub vehicle: V,
    /// How it touches down.
    pub scene: Scene,
    /// How that is computed.
    pub settings: Settings,
}

/// How full lanes were.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Occupancy {
    /// Steps taken, rejected ones included.
    pub steps: u64,
    /// Lanes there were for them: one for each that was taken alone.
    pub lanes: u64,
}

impl Occupancy {
    /// Share of the lanes that were taken; not a number where nobody landed.
    pub fn share(&self) -> f64 {
        self.steps as f64 / self.lanes as f64
    }
}

/// Computes the landings that `next` asks for, side by side where that is faster than one after the other; `done`
/// gets each result with its key. Ends once `next` asks for none while none is under way: until then it is called
/// before every step for which there is room.
pub fn land_many<V, K, const LEGS: usize>(
    mut next: impl FnMut() -> Option<Request<K, V>>,
    mut done: impl FnMut(K, Landing<LEGS>),
) -> Occupancy
where
    V: Deref<Target = Vehicle<LEGS>>,
{
    #[cfg(target_arch = "x86_64")]
    if let Some(registers) = Eight::try_new() {
        return land_abreast(registers, next, done);
    }
    let registers = Four::new();
    if registers.are_whole() {
        return land_abreast(registers, next, done);
    }
    let mut occupancy = Occupancy::default();
    while let Some(request) = next() {
        let landing = land(&request.vehicle, &request.scene, &request.settings);
        occupancy.steps += landing.steps;
        occupancy.lanes += landing.steps;
        done(request.key, landing);
    }
    occupancy
}

/// [`land_many`] in the lanes of these registers.
pub fn land_abreast<R, V, K, const N: usize, const LEGS: usize>(
    registers: R,
    mut next: impl FnMut() -> Option<Request<K, V>>,
    mut done: impl FnMut(K, Landing<LEGS>),
) -> Occupancy
where
    R: Lanes<N>,
    V: Deref<Target = Vehicle<LEGS>>,
{
    let Some(request) = next() else {
        return Occupancy::default();
    };
    let motion = Motion::new(&request.vehicle, &request.scene);
    let mut fleet: Fleet<R, V, K, N, LEGS> = Fleet::new(registers, &motion);
    fleet.start(request, &mut done);
    loop {
        while fleet.under_way < UNDER_WAY * N
            && let Some(request) = next()
        {
            fleet.start(request, &mut done);
        }
        if fleet.under_way == 0 {
            return fleet.occupancy;
        }
        fleet.step(&mut done);
    }
}

/// Nobody sees the instants of these landings.
type Nobody<const LEGS: usize> = fn(&Instant<LEGS>);

/// A landing under way.
struct Sortie<V, K, const LEGS: usize> {
    /// What its result is told by, until it is.
    key: Option<K>,
    flight: Flight<V, Nobody<LEGS>, LEGS>,
    course: Course<LEGS>,
    attempt: Attempt,
    kind: Kind,
    /// Whether the step is known to be of that kind.
    is_sure: bool,
    /// Changes of the coefficients of each leg that its lane has seen.
    changes_seen: [u64; LEGS],
}

impl<V: Deref<Target = Vehicle<LEGS>>, K, const LEGS: usize> Sortie<V, K, LEGS> {
    /// Gets ready for the next step, after any free flight; whether it flew.
    ///
    /// # Errors
    /// The outcome, if no further step is to be taken.
    fn aim(&mut self) -> Result<bool, Outcome> {
        let flew = self.flight.fly(&mut self.course)?;
        self.attempt = self.flight.aim(&mut self.course)?;
        // After an implicit step the next is taken for one too: in lanes it shows whether that was right.
        self.is_sure = false;
        if self.kind == Kind::Explicit {
            self.make_sure();
        }
        Ok(flew)
    }

    /// Finds out of what kind the next step is.
    fn make_sure(&mut self) {
        self.is_sure = true;
        self.kind = if self.flight.is_stiff(self.attempt.length) {
            Kind::Implicit
        } else {
            Kind::Explicit
        };
    }

    /// Goes on to the end of the step just taken in its lane, or to what comes before, and gets ready for the next.
    ///
    /// # Errors
    /// The outcome, when the landing has ended.
    fn go_on<const N: usize>(
        &mut self,
        steps: &Steps<N, LEGS>,
        lane: usize,
    ) -> Result<Way, Outcome> {
        let flight = &mut self.flight;
        if !self.is_sure && !(flight.stiffness).exceeds_at(steps.rate(lane), self.attempt.length) {
            self.kind = Kind::Explicit;
            self.is_sure = true;
            return Ok(Way::Back);
        }
        flight.evaluations += self.kind.evaluations();
        flight.is_middle_seen = self.kind == Kind::Implicit;
        flight.step.length = self.attempt.length;
        flight.step.weights = self.kind.weights();
        if flight.is_middle_seen {
            let glances = [&mut flight.middle, flight.signals.ahead_mut()];
            tell_pad_rates(&flight.step, glances);
        }
        let tolerance = flight.settings.tolerance();
        let error = steps.error(lane, tolerance, flight.greatest_work_error());
        let way = if flight.accept(&mut self.course, self.attempt, error) {
            flight.go_on(&mut self.course)?
        } else {
            Way::Back
        };
        let flew = self.aim()?;
        Ok(if flew { Way::Elsewhere } else { way })
    }

    /// Takes a step alone and gets ready for the next.
    ///
    /// # Errors
    /// The outcome, when the landing has ended.
    fn step_alone(&mut self) -> Result<(), Outcome> {
        if !self.is_sure {
            self.make_sure();
        }
        let flight = &mut self.flight;
        let error = flight.take(self.attempt.length, self.kind == Kind::Implicit);
        if flight.accept(&mut self.course, self.attempt, error) {
            flight.go_on(&mut self.course)?;
        }
        self.aim()?;
        Ok(())
    }

    /// Where the numbers of its lane go.
    fn place(&mut self) -> Place<'_, LEGS> {
        Place {
            step: &mut self.flight.step,
            middle: &mut self.flight.middle,
            signals: self.flight.signals.ahead_mut(),
        }
    }
}

/// A lane's landing, if there is one.
struct Seat<V, K, const LEGS: usize> {
    sortie: Option<Box<Sortie<V, K, LEGS>>>,
    spare: Box<Spare<LEGS>>,
}

/// Landings that take steps of one kind.
struct Row<V, K, const N: usize, const LEGS: usize> {
    steps: Box<Steps<N, LEGS>>,
    seats: [Seat<V, K, LEGS>; N],
    /// Those that wait for a lane.
    waiting: Vec<Box<Sortie<V, K, LEGS>>>,
}

impl<V, K, const N: usize, const LEGS: usize> Row<V, K, N, LEGS> {
    fn new(motion: &Motion<LEGS>) -> Self {
        Self {
            steps: Box::new(Steps::new(motion)),
            seats: std::array::from_fn(|_| Seat {
                sortie: None,
                spare: Box::new(Spare::new()),
            }),
            waiting: Vec::with_capacity(UNDER_WAY * N),
        }
    }

    fn taken(&self) -> usize {
        (self.seats.iter())
            .filter(|seat| seat.sortie.is_some())
            .count()
    }

    /// Seats who waits.
    fn fill(&mut self) {
        for (lane, seat) in self.seats.iter_mut().enumerate() {
            if seat.sortie.is_some() {
                continue;
            }
            let Some(mut sortie) = self.waiting.pop() else {
                return;
            };
            let flight = &sortie.flight;
            self.steps.set_motion(lane, &flight.motion);
            for leg in 0..LEGS {
                self.steps.set_pieces(lane, leg, &flight.pieces);
            }
            self.steps.set_start(lane, &flight.step);
            self.steps.set_length(lane, sortie.attempt.length);
            sortie.changes_seen = flight.changes;
            seat.sortie = Some(sortie);
        }
    }
}

/// All landings under way.
struct Fleet<R, V, K, const N: usize, const LEGS: usize> {
    registers: R,
    under_way: usize,
    explicit: Row<V, K, N, LEGS>,
    implicit: Row<V, K, N, LEGS>,
    /// Those that have ended, whose places others take.
    ended: Vec<Box<Sortie<V, K, LEGS>>>,
    occupancy: Occupancy,
}

impl<R, V, K, const N: usize, const LEGS: usize> Fleet<R, V, K, N, LEGS>
where
    R: Lanes<N>,
    V: Deref<Target = Vehicle<LEGS>>,
{
    fn new(registers: R, motion: &Motion<LEGS>) -> Self {
        Self {
            registers,
            under_way: 0,
            explicit: Row::new(motion),
            implicit: Row::new(motion),
            ended: Vec::with_capacity(UNDER_WAY * N),
            occupancy: Occupancy::default(),
        }
    }

    fn row(&mut self, kind: Kind) -> &mut Row<V, K, N, LEGS> {
        match kind {
            Kind::Explicit => &mut self.explicit,
            Kind::Implicit => &mut self.implicit,
        }
    }

    /// Starts a landing; some are over at once, and methods of 1966 are not for lanes.
    fn start(&mut self, request: Request<K, V>, done: &mut impl FnMut(K, Landing<LEGS>)) {
        let Request {
            key,
            vehicle,
            scene,
            settings,
        } = request;
        if settings.method() != Method::Located {
            return done(key, land(&vehicle, &scene, &settings));
        }
        let history = History::new(f64::INFINITY, (|_| {}) as Nobody<LEGS>);
        let mut flight = Flight::new(vehicle, scene, settings, history);
        let course = match flight.begin() {
            Ok(course) => course,
            Err(outcome) => return done(key, flight.conclude(outcome)),
        };
        let sortie = Sortie {
            key: Some(key),
            flight,
            course,
            attempt: Attempt {
                whole: 0.0,
                length: 0.0,
            },
            kind: Kind::Explicit,
            is_sure: false,
            changes_seen: [0; LEGS],
        };
        let sortie = match self.ended.pop() {
            Some(mut place) => {
                *place = sortie;
                place
            }
            None => Box::new(sortie),
        };
        self.under_way += 1;
        self.go_on_or_end(sortie, |sortie| sortie.aim().map(|_| ()), done);
    }

    /// Lets a landing that is in no lane do something, and then wait for one.
    fn go_on_or_end(
        &mut self,
        mut sortie: Box<Sortie<V, K, LEGS>>,
        act: impl FnOnce(&mut Sortie<V, K, LEGS>) -> Result<(), Outcome>,
        done: &mut impl FnMut(K, Landing<LEGS>),
    ) {
        match act(&mut sortie) {
            Ok(()) => self.row(sortie.kind).waiting.push(sortie),
            Err(outcome) => self.end(sortie, outcome, done),
        }
    }

    /// Tells the result of a landing.
    fn end(
        &mut self,
        mut sortie: Box<Sortie<V, K, LEGS>>,
        outcome: Outcome,
        done: &mut impl FnMut(K, Landing<LEGS>),
    ) {
        if let Some(key) = sortie.key.take() {
            self.under_way -= 1;
            done(key, sortie.flight.conclude(outcome));
        }
        self.ended.push(sortie);
    }

    /// Takes a step of the kind that fills more lanes, or one of each landing alone where that is faster.
    fn step(&mut self, done: &mut impl FnMut(K, Landing<LEGS>)) {
        self.explicit.fill();
        self.implicit.fill();
        let (kind, taken) = if self.implicit.taken() > self.explicit.taken() {
            (Kind::Implicit, self.implicit.taken())
        } else {
            (Kind::Explicit, self.explicit.taken())
        };
        if taken < WORTH {
            self.step_alone(done);
        } else {
            self.occupancy.steps += taken as u64;
            self.occupancy.lanes += N as u64;
            self.step_abreast(kind, done);
        }
    }

    fn step_alone(&mut self, done: &mut impl FnMut(K, Landing<LEGS>)) {
        for lane in 0..N {
            for kind in [Kind::Explicit, Kind::Implicit] {
                if let Some(sortie) = self.row(kind).seats[lane].sortie.take() {
                    self.occupancy.steps += 1;
                    self.occupancy.lanes += 1;
                    self.go_on_or_end(sortie, Sortie::step_alone, done);
                }
            }
        }
    }

    fn step_abreast(&mut self, kind: Kind, done: &mut impl FnMut(K, Landing<LEGS>)) {
        let registers = self.registers;
        let Row { steps, seats, .. } = self.row(kind);
        steps.take(registers, kind);
        let places = seats.each_mut().map(|seat| match &mut seat.sortie {
            Some(sortie) => sortie.place(),
            None => seat.spare.place(),
        });
        steps.deal(registers, kind, places);

        let mut goes_on = [false; N];
        for (lane, goes_on) in goes_on.iter_mut().enumerate() {
            let row = self.row(kind);
            let Some(mut sortie) = row.seats[lane].sortie.take() else {
                continue;
            };
            match sortie.go_on(&row.steps, lane) {
                Ok(way) if sortie.kind == kind => {
                    match way {
                        Way::Back => {}
                        Way::On => *goes_on = true,
                        Way::Elsewhere => row.steps.set_start(lane, &sortie.flight.step),
                    }
                    for leg in 0..LEGS {
                        if sortie.changes_seen[leg] != sortie.flight.changes[leg] {
                            row.steps.set_pieces(lane, leg, &sortie.flight.pieces);
                        }
                    }
                    sortie.changes_seen = sortie.flight.changes;
                    row.steps.set_length(lane, sortie.attempt.length);
                    row.seats[lane].sortie = Some(sortie);
                }
                Ok(_) => self.row(sortie.kind).waiting.push(sortie),
                Err(outcome) => self.end(sortie, outcome, done),
            }
        }
        self.row(kind).steps.go_on(registers, goes_on);
    }
}
