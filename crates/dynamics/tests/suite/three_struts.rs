//! Landings on legs of three struts: tripods and cantilevers.



use std::f64::consts::TAU;
use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::crush_load::CrushLoad;
use touchdown_dynamics::land::land;
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::parts::Inertia;
use touchdown_dynamics::profile::Profile;
use touchdown_dynamics::scene::{Conditions, CrushRule, Scene, Settings};
use touchdown_dynamics::three_strut_leg::ThreeStrutLeg;
use touchdown_dynamics::three_struts::{
    Arrangement, BallFootpad, Foot, LegStrut, ThreeStrutDesign,
};
use touchdown_dynamics::vehicle::Vehicle;

const TRIPOD: Arrangement = Arrangement::Tripod;
const CANTILEVER: Arrangement = Arrangement::Cantilever { collar: 6.5 };

fn load(knots: &[[f64; 2]]) -> Option<CrushLoad> {
    Some(CrushLoad::new(knots.to_vec()).unwrap())
}

/// A leg of a lander of the size of Apollo's.
fn leg(arrangement: Arrangement, azimuth: f64) -> ThreeStrutDesign {
    ThreeStrutDesign {
        azimuth,
        arrangement,
        foot: Foot {
            radius: 14.0,
            depth: 5.0,
            mass: 2.0,
        },
        primary: LegStrut {
            hardpoint_radius: 7.2,
            hardpoint_height: 6.2,
            stiffness: 5e5,
            damping: 200.0,
            square_damping: 0.0,
            compression_stroke: 2.7,
            tension_stroke: 0.2,
            compression_load: load(&[[0.0, 4500.0], [0.83, 4500.0], [0.83, 9500.0]]),
            tension_load: None,
        },
        secondary: LegStrut {
            hardpoint_radius: 7.2,
            hardpoint_height: 0.0,
            stiffness: 5e5,
            damping: 200.0,
            square_damping: 0.0,
            compression_stroke: 1.0,
            tension_stroke: 1.33,
            compression_load: load(&[[0.0, 4500.0]]),
            tension_load: load(&[[0.0, 500.0], [0.33, 500.0], [0.33, 5000.0]]),
        },
        spread: 3.0,
        footpad: BallFootpad {
            diameter: 3.1,
            height: 0.6,
            crush_pressure: 3000.0,
            profile: Profile::new(vec![[0.0, 0.0], [0.02, 1.0], [0.6, 1.0]]).unwrap(),
        },
    }
}

const INERTIA: Inertia = Inertia {
    xx: 16_000.0,
    yy: 17_500.0,
    zz: 18_500.0,
    xy: 300.0,
    xz: -200.0,
    yz: 150.0,
};

/// A lander with so many such legs.
fn lander(arrangement: Arrangement, legs: usize, inertia: Inertia) -> Vehicle {
    let legs = (0..legs).map(|index| {
        let azimuth = index as f64 / legs as f64 * TAU;
        ThreeStrutLeg::new(leg(arrangement, azimuth)).unwrap()
    });
    let legs: Vec<ThreeStrutLeg> = legs.collect();
    Vehicle::new(480.0, 5.31, 4.0, inertia, legs).unwrap()
}

fn settings(tolerance: f64) -> Settings {
    Settings::new(tolerance, 20.0, CrushRule::Section).unwrap()
}

fn conditions() -> Conditions {
    let level = Euler {
        pitch: 0.0,
        yaw: 0.0,
        roll: 0.0,
    };
    Conditions {
        vertical_velocity: 10.0,
        horizontal_velocity: 0.0,
        cross_slope: 0.0,
        attitude: Attitude::from_euler(level),
        angular_velocity: [0.0; 3],
        slope: 0.0,
        pad_friction: 0.4,
        block_friction: 0.4,
        soil: Default::default(),
        ground: Default::default(),
        gravity: None,
        thrust: Default::default(),
    }
}

fn landed(vehicle: &Vehicle, conditions: Conditions, tolerance: f64) -> Landing {
    land(vehicle, &Scene::new(conditions).unwrap(), &settings(tolerance))
}

#[test]
fn trial() {
    for arrangement in [TRIPOD, CANTILEVER] {
        for speed in [0.0, 4.0, 8.0, 16.0] {
            for tolerance in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
                let vehicle = lander(arrangement, 4, INERTIA);
                let begun = std::time::Instant::now();
                let landing = landed(
                    &vehicle,
                    Conditions {
                        horizontal_velocity: speed,
                        cross_slope: 2.5,
                        slope: 0.1,
                        ..conditions()
                    },
                    tolerance,
                );
                println!(
                    "{arrangement:?} {speed} {tolerance:e} {:?} t {:.4} σ {:.5} stroke {:.5} share {:?} force {:.1} closure {:.2e} of {:.1} steps {} ev {} events {} {:.2} ms",
                    landing.outcome, landing.end_time, landing.min_stability_angle, landing.max_stroke[0], landing.max_stroke_share,
                    landing.max_strut_force[0], landing.energies.closure(), landing.energies.initial_kinetic, landing.steps, landing.evaluations, landing.events,
                    begun.elapsed().as_secs_f64() * 1e3
                );
            }
        }
    }

}
