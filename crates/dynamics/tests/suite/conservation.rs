//! What has to be conserved: momentum and energy in free flight, the energy account of landings.

use std::sync::Arc;

use crate::common::bare::Bare;
use crate::common::random::{crush_rule, fixed_list, usual_conditions};
use crate::common::{
    PRINCIPAL, level, level_scene, off_center, sample_deck, side_by_side, surveyor_leg, table_4_1,
};
use nalgebra::{Vector3, Vector4};
use touchdown_dynamics::batch::Request;
use touchdown_dynamics::land::land;
use touchdown_dynamics::outcome::Outcome;
use touchdown_dynamics::rules::Rules;
use touchdown_dynamics::scene::{Conditions, CrushRule, Scene, Settings};
use touchdown_dynamics::state::{Body, State, rotation};
use touchdown_dynamics::touchdown::extended_legs;
use touchdown_dynamics::vehicle::{Leg, Vehicle};

/// A tumbling vehicle far above the ground.
fn tumbling(vehicle: &Vehicle) -> State<f64> {
    let legs = extended_legs(vehicle);
    let body = Body {
        position: Vector3::new(0.0, 0.0, -500.0),
        velocity: Vector3::new(3.0, -11.0, 14.0),
        quaternion: Vector4::new(0.9, 0.1, -0.2, 0.3),
        rate: Vector3::new(2.0, -1.5, 3.0),
    };
    State::new(&body, &legs)
}

/// Angular momentum about the CG in ground axes, slug·ft²/s.
fn angular_momentum(vehicle: &Vehicle, body: &Body<f64>) -> Vector3<f64> {
    rotation(&body.quaternion) * (vehicle.inertia() * body.rate)
}

/// Kinetic and potential energy, ft·lb.
fn energy(vehicle: &Vehicle, body: &Body<f64>) -> f64 {
    let translation = vehicle.mass() * body.velocity.norm_squared();
    let rotation = body.rate.dot(&(vehicle.inertia() * body.rate));
    0.5 * (translation + rotation) - vehicle.mass() * vehicle.gravity() * body.position.z
}

#[test]
fn free_flight_conserves_momentum_and_energy() {
    let vehicle = table_4_1();
    let bare = Bare::new(&vehicle, &level_scene(180.0, 0.0, 11.0));
    let start = tumbling(&vehicle);
    let before = start.body();
    let time = 2.0;
    let after = bare.march(&start, time, 4000).body();

    let turned = (rotation(&after.quaternion) - rotation(&before.quaternion)).norm();
    assert!(turned > 1.0, "it hardly turned: {turned}");
    let fallen = Vector3::new(0.0, 0.0, vehicle.gravity() * time);
    let momentum = after.velocity - before.velocity - fallen;
    assert!(
        momentum.norm() < 1e-12 * before.velocity.norm(),
        "{momentum}"
    );
    let (l0, l1) = (
        angular_momentum(&vehicle, &before),
        angular_momentum(&vehicle, &after),
    );
    assert!((l1 - l0).norm() < 1e-12 * l0.norm(), "{l0} became {l1}");
    let (e0, e1) = (energy(&vehicle, &before), energy(&vehicle, &after));
    assert!((e1 - e0).abs() < 1e-12 * e0.abs(), "{e0} became {e1}");
}

/// Works of crush and of friction that the pads of the Surveyor, at a multiple of their crush pressure, take from the motion in a
/// landing, ft·lb: of the pads whose crushing gave more than it took.
fn given_by_pads(factor: f64, rule: CrushRule, conditions: Conditions) -> [f64; 2] {
    let legs = [0.0, 120.0, 240.0].map(|azimuth| {
        let mut design = surveyor_leg(azimuth);
        design.footpad.crush_pressure *= factor;
        Leg::new(design).unwrap()
    });
    let vehicle = Vehicle::new(20.0, 5.31, 1.445, PRINCIPAL, legs)
        .unwrap()
        .with_rules(Rules::REPORT);
    let settings = Settings::new(1e-8, 10.0, rule).unwrap();
    let landing = land(&vehicle, &Scene::new(conditions).unwrap(), &settings);
    let energies = &landing.energies;
    assert!(energies.closure().abs() < 1e-3);
    // Where there is friction, it took more from each pad than crushing gave.
    if conditions.pad_friction > 0.0 {
        assert_eq!(energies.given_by_contact(), 0.0);
    }
    let lifting = energies.legs.iter().filter(|leg| leg.pad_crush < 0.0);
    lifting.fold([0.0; 2], |[crush, friction], leg| {
        [crush + leg.pad_crush, friction + leg.pad_friction]
    })
}

/// Forces act at the pivot, whose way into the ground is counted. A pad that friction tips about its hinge gets deeper
/// while its pivot stands still, and lifts it afterwards by what friction took: under either rule, where the pad is too stiff
/// to crush.
#[test]
fn stiff_pads_lift_the_vehicle_by_what_friction_took() {
    let baseline = level(180.0, 0.0, 11.0);
    for rule in [CrushRule::PivotRate, CrushRule::Section] {
        assert_eq!(given_by_pads(1.0, rule, baseline), [0.0; 2]);
        let [crush, _] = given_by_pads(30.0, rule, baseline);
        assert!(crush < -100.0, "{rule:?}: {crush}");
        let drop = |pad_friction| Conditions {
            slope: 0.0,
            pad_friction,
            ..level(180.0, 0.0, 0.0)
        };
        let [[rough, taken], [slippery, _]] =
            [1.0, 0.0].map(|friction| given_by_pads(30.0, rule, drop(friction)));
        assert!(
            rough < -200.0 && slippery > 0.02 * rough,
            "{rule:?}: {rough} {slippery}"
        );
        assert!(taken > -rough, "{rule:?}: {rough} {taken}");
    }
}

/// Greatest gap in the energy account, ft·lb; six times what was found.
const GAP: f64 = 1e-5;

#[test]
fn the_energy_account_of_landings_closes() {
    let strategy = (usual_conditions(), crush_rule(), proptest::bool::ANY);
    let cases = fixed_list(&strategy, 100);
    let requests = (cases.iter().enumerate()).map(|(key, (conditions, rule, first))| {
        let vehicle = if *first { table_4_1() } else { sample_deck() };
        Request {
            key,
            vehicle: Arc::new(if key.is_multiple_of(4) {
                off_center(vehicle)
            } else {
                vehicle
            }),
            scene: Scene::new(*conditions).unwrap(),
            settings: Settings::new(1e-8, 10.0, *rule).unwrap(),
        }
    });
    let gaps: Vec<_> = (side_by_side(requests).into_iter().zip(&cases))
        .filter_map(|(landing, (conditions, ..))| {
            let account = &landing.energies;
            // Energy in play: all that came in went somewhere or is left.
            assert!(account.initial_kinetic > 200.0);
            assert!(account.dissipated() > 0.0);
            let landed = !matches!(landing.outcome, Outcome::Failure(_));
            landed.then_some((account.closure().abs(), conditions))
        })
        .collect();
    assert!(gaps.len() > 95, "only {} landed", gaps.len());
    let worst = gaps.iter().max_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
    println!("gap at most {:.2e} ft·lb", worst.0);
    assert!(worst.0 < GAP, "{worst:?}");
}
