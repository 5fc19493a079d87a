// A lander of 500 kg with four legs on honeycomb struts, and its touchdown on the Moon, in feet, pounds and slugs.

use std::f64::consts::PI;

use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::crush_load::CrushLoad;
use touchdown_dynamics::ground::Ground;
use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::profile::Profile;
use touchdown_dynamics::scene::{Conditions, Scene};
use touchdown_dynamics::soil::Soil;
use touchdown_dynamics::thrust::Thrust;
use touchdown_dynamics::vehicle::{
    Footpad, Honeycomb, Inertia, Leg, LegDesign, Linkage, Strut, StrutElement, Vehicle,
};

/// The lander.
pub fn four_legs() -> Result<Vehicle, Invalid> {
    let leg = |azimuth_deg: f64| {
        Leg::new(LegDesign {
            azimuth: azimuth_deg.to_radians(),
            linkage: Linkage {
                lower_hardpoint_radius: 2.30,
                lower_link_length: 3.94,
                hardpoint_distance: 1.97,
                hardpoint_angle: 10f64.to_radians(),
                inertia: 2.14,
            },
            strut: Strut {
                extended_length: 4.94,
                minimum_length: 3.96,
                friction_fraction: 0.05,
                element: StrutElement::Honeycomb(Honeycomb {
                    unloading_stiffness: 68_500.0,
                    // Two cartridges in a row, the softer one first: stroke, ft, and load, lb.
                    crush_load: CrushLoad::new(vec![
                        [0.0, 562.0],
                        [0.39, 562.0],
                        [0.39, 1574.0],
                        [0.98, 1574.0],
                    ])?,
                }),
            },
            footpad: Footpad {
                diameter: 1.15,
                height: 0.33,
                crush_pressure: 627.0,
                inertia: 0.0148,
                hinge_damping: 0.0,
                minimum_angle: 10f64.to_radians(),
                maximum_angle: 45f64.to_radians(),
                // Interference, ft, and relative pressure.
                profile: Profile::new(vec![[0.0, 0.0], [0.016, 1.0], [0.20, 1.5], [0.31, 8.0]])?,
                edge: None,
            },
            block: None,
        })
    };
    let legs = [leg(0.0)?, leg(90.0)?, leg(180.0)?, leg(270.0)?];
    let inertia = Inertia {
        xx: 119.5,
        yy: 119.5,
        zz: 118.0,
        xy: 0.0,
        xz: 0.0,
        yz: 0.0,
    };
    let (mass, gravity, center_of_gravity_height) = (34.26, 5.31, 1.97);
    Vehicle::new(mass, gravity, center_of_gravity_height, inertia, legs)
}

/// Its touchdown upright and straight down a slope of 10 deg, at this horizontal velocity, ft/s.
pub fn downhill(horizontal_velocity: f64) -> Result<Scene, Invalid> {
    Scene::new(Conditions {
        vertical_velocity: 6.0,
        horizontal_velocity,
        cross_slope: PI,
        attitude: Attitude::from_euler(Euler {
            pitch: 0.0,
            yaw: 0.0,
            roll: 0.0,
        }),
        angular_velocity: [0.0; 3],
        slope: 10f64.to_radians(),
        pad_friction: 0.8,
        block_friction: 0.8,
        static_friction_ratio: None,
        soil: Soil::Rock,
        ground: Ground::default(),
        gravity: None,
        thrust: Thrust::default(),
    })
}
