//! The report's two vehicles, and the reference data beside the tests.
#![allow(dead_code)]

pub mod bare;
pub mod boundary;
pub mod complaints;
pub mod random;
pub mod scenes;

use std::collections::HashMap;
use std::path::PathBuf;

use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::batch::{Request, land_many};
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::profile::Profile;
use touchdown_dynamics::rules::Rules;
use touchdown_dynamics::scene::{Conditions, CrushRule, Scene, Settings};
use touchdown_dynamics::vehicle::{
    Block, Damper, Footpad, Inertia, Leg, LegDesign, Linkage, Strut, StrutElement, Vehicle,
};

/// A table given in inches.
fn inches(x: &[f64], y: &[f64]) -> Profile {
    Profile::new(x.iter().zip(y).map(|(x, y)| [x / 12.0, *y]).collect()).unwrap()
}

/// A leg of the Surveyor at this azimuth.
pub fn surveyor_leg(azimuth_deg: f64) -> LegDesign {
    let stroke = [
        0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.25, 2.5, 2.75, 3.0, 3.25, 3.5, 3.75,
        4.0, 4.25, 4.5, 6.5,
    ];
    let spring = [
        1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.005, 1.012, 1.020, 1.028, 1.036, 1.044, 1.052, 1.062,
        1.076, 1.096, 1.114, 1.151, 1.447,
    ];
    let damping = [
        1.0, 1.08, 1.16, 1.24, 1.36, 1.48, 1.60, 1.74, 1.89, 2.13, 2.77, 3.81, 4.96, 6.09, 7.24,
        8.37, 9.52, 10.67, 11.80, 20.84,
    ];
    let pad_interference = [
        0.0, 0.1, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.49, 2.666, 3.5, 4.5,
    ];
    let pad_pressure = [
        0.0, 0.468, 0.503, 0.563, 0.629, 0.697, 0.767, 0.841, 0.920, 1.0, 1.0, 1.823, 1.823, 6.503,
    ];
    LegDesign {
        azimuth: azimuth_deg.to_radians(),
        linkage: Linkage {
            lower_hardpoint_radius: 3.1875,
            lower_link_length: 3.375,
            hardpoint_distance: 0.95833,
            hardpoint_angle: 41f64.to_radians(),
            inertia: 1.347,
        },
        strut: Strut {
            extended_length: 3.1275,
            minimum_length: 2.7525,
            friction_fraction: 0.05,
            element: StrutElement::Damper(Damper {
                structural_stiffness: 1e5,
                preload: 185.0,
                spring_constant: 3600.0,
                compression_damping: 54.0,
                rebound_damping: 864.0,
                rebound_growth: 1.776,
                spring_profile: inches(&stroke, &spring),
                damping_profile: inches(&stroke, &damping),
            }),
        },
        footpad: Footpad {
            diameter: 1.0,
            height: 0.54167,
            crush_pressure: 1578.8,
            inertia: 0.00373,
            hinge_damping: 0.0,
            minimum_angle: 0.75f64.to_radians(),
            maximum_angle: 45f64.to_radians(),
            profile: inches(&pad_interference, &pad_pressure),
            edge: None,
        },
        block: Some(Block {
            radius: 2.4167,
            height: 0.66667,
            diameter: 0.58333,
            crush_pressure: 5425.6,
            profile: inches(&[0.0, 0.1, 5.75, 7.75], &[0.0, 1.0, 1.0, 21.0]),
        }),
    }
}

/// The shock absorber of a strut that has one.
pub fn damper(strut: &mut Strut) -> &mut Damper {
    match &mut strut.element {
        StrutElement::Damper(damper) => damper,
        StrutElement::Honeycomb(_) => panic!("a strut with a shock absorber"),
    }
}

/// The Surveyor with given CG height and inertia.
pub fn surveyor(center_of_gravity_height: f64, inertia: Inertia) -> Vehicle {
    let legs = [0.0, 120.0, 240.0].map(|azimuth| Leg::new(surveyor_leg(azimuth)).unwrap());
    Vehicle::new(20.0, 5.31, center_of_gravity_height, inertia, legs)
        .unwrap()
        .with_rules(Rules::REPORT)
}

/// Inertia of Table 4-1 without its products.
pub const PRINCIPAL: Inertia = Inertia {
    xx: 138.12,
    yy: 134.29,
    zz: 145.78,
    xy: 0.0,
    xz: 0.0,
    yz: 0.0,
};

/// The vehicle of Table 4-1.
pub fn table_4_1() -> Vehicle {
    let inertia = Inertia {
        xy: 6.81,
        xz: -5.87,
        yz: 2.57,
        ..PRINCIPAL
    };
    surveyor(1.445, inertia)
}

/// The vehicle of the sample deck (3.4.5).
pub fn sample_deck() -> Vehicle {
    ring(3)
}

/// The same moment of inertia (slug·ft²) about every axis.
pub fn even_inertia(moment: f64) -> Inertia {
    Inertia {
        xx: moment,
        yy: moment,
        zz: moment,
        xy: 0.0,
        xz: 0.0,
        yz: 0.0,
    }
}

/// That vehicle with so many of its legs, evenly round the centreline.
pub fn ring(legs: usize) -> Vehicle {
    let azimuths = (0..legs).map(|leg| 360.0 * leg as f64 / legs as f64);
    let legs: Vec<Leg> = azimuths
        .map(|azimuth| Leg::new(surveyor_leg(azimuth)).unwrap())
        .collect();
    Vehicle::new(20.0, 5.31, 1.5417, even_inertia(142.22), legs)
        .unwrap()
        .with_rules(Rules::REPORT)
}

/// Where tests put the CG off the centreline, ft.
pub const OFFSET: [f64; 2] = [0.31, -0.23];

/// A vehicle with its CG off the centreline.
pub fn off_center(vehicle: Vehicle) -> Vehicle {
    vehicle.with_center_of_gravity_offset(OFFSET).unwrap()
}

/// The report's standard conditions: level, slope 15 deg, friction 1, V_V 14 ft/s.
pub fn level(cross_slope_deg: f64, roll_deg: f64, horizontal_velocity: f64) -> Conditions {
    Conditions {
        vertical_velocity: 14.0,
        horizontal_velocity,
        cross_slope: cross_slope_deg.to_radians(),
        attitude: Attitude::from_euler(Euler {
            pitch: 0.0,
            yaw: 0.0,
            roll: roll_deg.to_radians(),
        }),
        angular_velocity: [0.0; 3],
        slope: 15f64.to_radians(),
        pad_friction: 1.0,
        block_friction: 1.0,
        static_friction_ratio: None,
        soil: touchdown_dynamics::soil::Soil::Rock,
        ground: touchdown_dynamics::ground::Ground::default(),
        gravity: None,
        thrust: touchdown_dynamics::thrust::Thrust::default(),
    }
}

/// The checked scene of `level`.
pub fn level_scene(cross_slope_deg: f64, roll_deg: f64, horizontal_velocity: f64) -> Scene {
    Scene::new(level(cross_slope_deg, roll_deg, horizontal_velocity)).unwrap()
}

/// Landings computed in lanes, in the order of their keys, which count from 0.
pub fn side_by_side(mut requests: impl Iterator<Item = Request>) -> Vec<Landing> {
    let mut landings = Vec::new();
    land_many(&mut || requests.next(), &mut |key, landing| {
        let needed = landings.len().max(key + 1);
        landings.resize(needed, None);
        landings[key] = Some(landing);
    });
    landings.into_iter().map(Option::unwrap).collect()
}

/// Settings under the listing's crush rule with the report's time limit.
pub fn settings(tolerance: f64) -> Settings {
    Settings::new(
        tolerance,
        Settings::DEFAULT_TIME_LIMIT,
        CrushRule::PivotRate,
    )
    .unwrap()
}

/// A row of a reference file by column name.
pub struct Row(HashMap<String, String>);

impl Row {
    /// The text in a column.
    pub fn text(&self, column: &str) -> &str {
        self.0
            .get(column)
            .unwrap_or_else(|| panic!("no column {column}"))
    }

    /// The number in a column.
    pub fn number(&self, column: &str) -> f64 {
        self.text(column)
            .parse()
            .unwrap_or_else(|_| panic!("{column}: {}", self.text(column)))
    }
}

/// All rows of a reference file.
pub fn reference(file: &str) -> Vec<Row> {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("tests/reference")
        .join(file);
    let mut reader = csv::Reader::from_path(&path).unwrap();
    reader.deserialize().map(|row| Row(row.unwrap())).collect()
}

/// Vehicle and scene of a row of `landings.csv`.
pub fn landing_case(row: &Row) -> (Vehicle, Scene) {
    let vehicle = match row.text("vehicle") {
        "table-4-1" => table_4_1(),
        "sample-deck" => sample_deck(),
        other => panic!("unknown vehicle {other}"),
    };
    let angle = |column: &str| row.number(column).to_radians();
    let friction = row.number("friction");
    let scene = Scene::new(Conditions {
        vertical_velocity: row.number("vertical_velocity_fps"),
        horizontal_velocity: row.number("horizontal_velocity_fps"),
        cross_slope: angle("cross_slope_deg"),
        attitude: Attitude::from_euler(Euler {
            pitch: angle("pitch_deg"),
            yaw: angle("yaw_deg"),
            roll: angle("roll_deg"),
        }),
        angular_velocity: [0.0; 3],
        slope: angle("slope_deg"),
        pad_friction: friction,
        block_friction: friction,
        static_friction_ratio: None,
        soil: touchdown_dynamics::soil::Soil::Rock,
        ground: touchdown_dynamics::ground::Ground::default(),
        gravity: None,
        thrust: touchdown_dynamics::thrust::Thrust::default(),
    })
    .unwrap();
    (vehicle, scene)
}
