//! Random landers and touchdowns, each known by its number.

use std::f64::consts::TAU;
use std::path::Path;
use std::sync::Arc;

use rand::{RngExt, SeedableRng};
use rand_distr::{Distribution, Normal};
use rand_pcg::Pcg64;
use touchdown_dynamics::attitude::{Attitude, Tip};
use touchdown_dynamics::crush_load::CrushLoad;
use touchdown_dynamics::ground::{Ground, LegFooting, Patch};
use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::parts::{Inertia, LegDesign, StrutElement};
use touchdown_dynamics::scene::{Conditions, Scene};
use touchdown_dynamics::soil::{Bearing, Soil};
use touchdown_dynamics::three_strut_leg::ThreeStrutLeg;
use touchdown_dynamics::three_struts::{Arrangement, Telescope};
use touchdown_dynamics::thrust::Thrust;
use touchdown_dynamics::vehicle::{Leg, Legs, Vehicle};
use touchdown_input::documents::document::Document;
use touchdown_input::documents::input_error::InputError;
use touchdown_input::readers::vehicle_file::VehicleFile;

/// Metres per second in a foot per second.
const MPS: f64 = 1.0 / 0.3048;
/// Highest speed of a touchdown either way, ft/s.
pub const HIGHEST: f64 = 4.0 * MPS;
/// Acceleration of gravity, ft/s²: of the Moon, of Mars, of the Earth and of Ceres.
const PLACES: [(&str, f64); 4] = [
    ("Moon", 1.62 * MPS),
    ("Mars", 3.71 * MPS),
    ("Earth", 9.81 * MPS),
    ("Ceres", 0.28 * MPS),
];
/// Kinds of landers.
const LANDERS: [&str; 4] = [
    "shipped",
    "Surveyor with 3 to 8 legs",
    "wild",
    "tripods and cantilevers",
];
/// Index of legs of three struts among them.
const THREE_STRUTS: usize = 3;
/// Kinds of ground.
const GROUNDS: [&str; 3] = ["even", "rough", "pits and rocks"];
/// Kinds of engines.
const ENGINES: [&str; 3] = ["off", "dies away", "stays on"];

/// Pressures under which soil gives way by 5 cm, lb/ft²: 5 to 200 kPa.
const STRENGTHS: [f64; 2] = [104.0, 4177.0];
const DEPTH: f64 = 0.05 / 0.3048;
/// Inertial drags, slug/ft³: 150 to 3000 kg/m³.
const DRAGS: [f64; 2] = [0.29, 5.82];

/// What random landers are made of.
pub struct Stock {
    shipped: [Vehicle; 2],
    surveyor: Vehicle,
    /// On legs of three struts.
    apollo_like: Vehicle,
    choice: Choice,
}

/// What landings are drawn.
#[derive(Debug, Clone, Copy)]
pub struct Choice {
    /// On soil in place of rock, all else the same.
    pub on_soil: bool,
    /// With less friction, of which static friction is a multiple.
    pub with_static_friction: bool,
    /// On legs of three struts in place of hinged ones.
    pub on_three_struts: bool,
}

/// A lander and its touchdown.
pub struct Draw {
    pub number: u64,
    pub vehicle: Arc<Vehicle>,
    pub scene: Scene,
    /// Places in the lists of kinds.
    place: usize,
    lander: usize,
    ground: usize,
    engine: usize,
}

impl Draw {
    /// The same touchdown of another vehicle at another horizontal speed, ft/s.
    pub fn at_speed(&self, speed: f64, vehicle: Arc<Vehicle>) -> Result<Self, Invalid> {
        Ok(Self {
            vehicle,
            scene: self.scene.with_horizontal_velocity(speed)?,
            ..*self
        })
    }

    /// Kinds of place, lander, ground and engine.
    pub fn kinds(&self) -> [&'static str; 4] {
        [
            PLACES[self.place].0,
            LANDERS[self.lander],
            GROUNDS[self.ground],
            ENGINES[self.engine],
        ]
    }
}

impl Stock {
    /// Reads the vehicles that come with the program.
    pub fn read(choice: Choice) -> Result<Self, InputError> {
        let read = |name: &str, text: &str| {
            let document = Document::parse(Path::new(name), text)?;
            Ok::<_, InputError>(VehicleFile::from_document(document)?.vehicle)
        };
        let four = include_str!("../../../../sweeps/vehicles/four-legs.toml");
        let six = include_str!("../../../../sweeps/vehicles/six-legs.toml");
        let surveyor = include_str!("../../../../sweeps/vehicles/surveyor-table-4-1.toml");
        let apollo_like = include_str!("../../../../sweeps/vehicles/apollo-like.toml");
        Ok(Self {
            shipped: [read("four-legs.toml", four)?, read("six-legs.toml", six)?],
            surveyor: read("surveyor-table-4-1.toml", surveyor)?,
            apollo_like: read("apollo-like.toml", apollo_like)?,
            choice,
        })
    }

    /// The lander and touchdown of a number. Those that are not valid are drawn again.
    pub fn draw(&self, seed: u64, number: u64) -> Draw {
        let mut random = Random(Pcg64::seed_from_u64(seed.rotate_left(32) ^ number));
        loop {
            if let Ok(draw) = self.attempt(number, &mut random) {
                return draw;
            }
        }
    }

    fn attempt(&self, number: u64, random: &mut Random) -> Result<Draw, Invalid> {
        let [place, lander, ground, engine] = [
            random.below(PLACES.len()),
            random.below(THREE_STRUTS),
            random.below(GROUNDS.len()),
            // Half of the engines are off, and few stay on.
            [0, 0, 0, 0, 1, 1, 1, 2][random.below(8)],
        ];
        let lander = match self.choice.on_three_struts {
            true => THREE_STRUTS,
            false => lander,
        };
        let vehicle = match lander {
            THREE_STRUTS => self.on_three_struts(random)?,
            0 => self.shipped[random.below(2)].clone(),
            1 => self.surveyor_with(3 + random.below(6), random)?,
            _ => self.wild(random)?,
        };
        let gravity = PLACES[place].1;
        let conditions = Conditions {
            vertical_velocity: random.between(0.0, HIGHEST),
            horizontal_velocity: random.between(0.0, HIGHEST),
            cross_slope: random.between(0.0, TAU),
            attitude: Attitude::from_tip(Tip {
                tip: random.between(0.0, 15f64.to_radians()),
                azimuth: random.between(0.0, TAU),
                nominal_roll: random.between(0.0, TAU),
            }),
            angular_velocity: [0.0; 3].map(|_: f64| random.between(-0.1, 0.1)),
            slope: random.between(-15f64.to_radians(), 15f64.to_radians()),
            pad_friction: random.between(0.2, 1.5),
            block_friction: random.between(0.2, 1.5),
            static_friction_ratio: None,
            ground: uneven(&vehicle, ground, random)?,
            gravity: Some(gravity),
            thrust: thrust(vehicle.mass() * gravity, engine, random)?,
            soil: match self.choice.on_soil {
                true => soil(random)?,
                false => Soil::Rock,
            },
        };
        let conditions = match self.choice.with_static_friction {
            true => Conditions {
                pad_friction: random.between(0.05, 0.5),
                block_friction: random.between(0.05, 0.5),
                static_friction_ratio: Some(random.between(1.0, 5.0)),
                ..conditions
            },
            false => conditions,
        };
        let scene = Scene::new(conditions)?;
        Ok(Draw {
            number,
            vehicle: Arc::new(vehicle),
            scene,
            place,
            lander,
            ground,
            engine,
        })
    }

    /// The Surveyor with so many of its legs, evenly round the centreline.
    fn surveyor_with(&self, legs: usize, random: &mut Random) -> Result<Vehicle, Invalid> {
        let first = random.between(0.0, TAU);
        let leg = |leg: usize| {
            Leg::new(LegDesign {
                azimuth: first + TAU * leg as f64 / legs as f64,
                ..self.surveyor.hinged_legs()[0].design().clone()
            })
        };
        let legs: Vec<Leg> = (0..legs).map(leg).collect::<Result<_, _>>()?;
        let height = self.surveyor.center_of_gravity_height();
        like(&self.surveyor, self.surveyor.mass(), height, legs)
    }

    /// A lander whose legs differ in place, strength and length, with its CG off the centreline.
    fn wild(&self, random: &mut Random) -> Result<Vehicle, Invalid> {
        let model = match random.below(3) {
            2 => &self.surveyor,
            shipped => &self.shipped[shipped],
        };
        let count = 3 + random.below(6);
        let apart = TAU / count as f64;
        let strength = random.log_between(0.3, 3.0);
        let stiffness = random.log_between(0.3, 3.0);
        let legs: Result<Vec<Leg>, Invalid> = (0..count)
            .map(|leg| {
                let mut design = model.hinged_legs()[0].design().clone();
                design.azimuth = apart * (leg as f64 + random.between(-0.2, 0.2));
                design.footpad.crush_pressure *= stiffness * random.log_between(0.9, 1.1);
                design.footpad.height *= random.between(0.7, 1.3);
                let longer = random.between(0.97, 1.03);
                design.linkage.lower_link_length *= longer;
                design.strut.extended_length *= longer;
                design.strut.minimum_length *= longer;
                if let StrutElement::Honeycomb(honeycomb) = &mut design.strut.element {
                    let knots = honeycomb.crush_load.knots().iter();
                    let stronger = knots.map(|[stroke, load]| [*stroke, load * strength]);
                    honeycomb.crush_load = CrushLoad::new(stronger.collect())?;
                }
                Leg::new(design)
            })
            .collect();
        let standing = model.standing_height();
        let height = model.center_of_gravity_height() + standing * random.between(-0.15, 0.3);
        let vehicle = like(model, model.mass(), height, legs?)?;
        let reach = 0.2 * standing;
        let offset = [0.0; 2].map(|_: f64| random.between(-reach, reach));
        vehicle.with_center_of_gravity_offset(offset)
    }

    /// A lander on three to six tripods or cantilevers of any strength, which differ in length and spread.
    fn on_three_struts(&self, random: &mut Random) -> Result<Vehicle, Invalid> {
        let model = &self.apollo_like;
        let Legs::ThreeStrut(legs) = model.legs() else {
            return Err(Invalid::new("legs", 0.0, "legs of three struts"));
        };
        let count = 3 + random.below(4);
        let apart = TAU / count as f64;
        let arrangement = match random.below(2) {
            0 => Arrangement::Tripod,
            _ => {
                let collar = random.between(1.2, 2.2) * MPS;
                Arrangement::Cantilever(Telescope::without_friction(collar))
            }
        };
        let strength = random.log_between(0.4, 4.0);
        let stiffness = random.log_between(0.3, 3.0);
        let depth = random.between(0.8, 1.3);
        let legs: Result<Vec<ThreeStrutLeg>, Invalid> = (0..count)
            .map(|leg| {
                let mut design = legs[0].design().clone();
                design.azimuth = apart * (leg as f64 + random.between(-0.2, 0.2));
                design.arrangement = arrangement;
                design.foot.depth *= depth * random.between(0.97, 1.03);
                design.foot.mass *= random.log_between(0.5, 2.0);
                design.spread *= random.between(0.6, 1.5);
                design.footpad.crush_pressure *= stiffness * random.log_between(0.9, 1.1);
                for strut in [&mut design.primary, &mut design.secondary] {
                    let loads = [&mut strut.compression_load, &mut strut.tension_load];
                    for load in loads.into_iter().flatten() {
                        let knots = load.knots().iter();
                        let stronger = knots.map(|[stroke, load]| [*stroke, load * strength]);
                        *load = CrushLoad::new(stronger.collect())?;
                    }
                }
                ThreeStrutLeg::new(design)
            })
            .collect();
        let standing = model.standing_height();
        let height = model.center_of_gravity_height() + standing * random.between(-0.15, 0.5);
        let vehicle = like(model, model.mass(), height, legs?)?;
        let reach = 0.2 * standing;
        let offset = [0.0; 2].map(|_: f64| random.between(-reach, reach));
        vehicle.with_center_of_gravity_offset(offset)
    }
}

/// A vehicle of the inertia of another, with this mass (slug), height of the CG (ft) and legs, under physical rules.
pub fn like(
    model: &Vehicle,
    mass: f64,
    height: f64,
    legs: impl Into<Legs>,
) -> Result<Vehicle, Invalid> {
    let j = model.inertia();
    let inertia = Inertia {
        xx: j[(0, 0)],
        yy: j[(1, 1)],
        zz: j[(2, 2)],
        xy: -j[(0, 1)],
        xz: -j[(0, 2)],
        yz: -j[(1, 2)],
    };
    Vehicle::new(mass, model.gravity(), height, inertia, legs)
}

/// Soil of any strength, one half of it with inertial drag.
fn soil(random: &mut Random) -> Result<Soil, Invalid> {
    let strength = random.log_between(STRENGTHS[0], STRENGTHS[1]);
    let bearing = Bearing::new(
        strength,
        DEPTH,
        random.between(0.7, 1.4),
        random.log_between(0.002, 0.1),
    );
    let drags = [0.0, random.log_between(DRAGS[0], DRAGS[1])];
    let drag = drags[random.below(drags.len())];
    bearing?.with_inertial_drag(drag).map(Soil::Yielding)
}

/// Ground of its own under each leg, but where it is even.
fn uneven(vehicle: &Vehicle, kind: usize, random: &mut Random) -> Result<Ground, Invalid> {
    let stances: Vec<f64> = match vehicle.legs() {
        Legs::Hinged(legs) => legs.iter().map(Leg::stance).collect(),
        Legs::ThreeStrut(legs) => legs.iter().map(ThreeStrutLeg::stance).collect(),
    };
    let legs: Vec<LegFooting> = (stances.into_iter())
        .map(|stance| {
            let (height, tilt) = match kind {
                0 => (0.0, 0.0),
                1 => (random.normal(0.1 * stance), random.normal(0.05)),
                // A pit, a rock or neither.
                _ => {
                    let height = [-0.5, 0.0, 0.0, 0.5][random.below(4)];
                    (height * stance, random.normal(0.1))
                }
            };
            let pad = Patch {
                height,
                tilt_along: tilt.clamp(-0.3, 0.3),
                tilt_across: if tilt == 0.0 {
                    0.0
                } else {
                    random.normal(0.1).clamp(-0.3, 0.3)
                },
            };
            LegFooting::of(pad, pad)
        })
        .collect();
    Ground::new(&legs)
}

fn thrust(weight: f64, kind: usize, random: &mut Random) -> Result<Thrust, Invalid> {
    let force = weight * random.between(0.2, 1.2);
    let offset = [0.0; 2].map(|_: f64| random.between(-0.3, 0.3));
    match kind {
        0 => Ok(Thrust::default()),
        1 => Thrust::new(&[[0.0, force], [random.between(0.1, 3.0), 0.0]], offset),
        _ => {
            let rest = 0.5 * force;
            Thrust::new(&[[0.0, force], [random.between(0.1, 3.0), rest]], offset)
        }
    }
}

/// Random numbers.
struct Random(Pcg64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0.random_range(0..count)
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        self.0.random_range(from..to)
    }

    fn log_between(&mut self, from: f64, to: f64) -> f64 {
        self.between(from.ln(), to.ln()).exp()
    }

    fn normal(&mut self, deviation: f64) -> f64 {
        Normal::new(0.0, deviation).map_or(0.0, |normal| normal.sample(&mut self.0))
    }
}
