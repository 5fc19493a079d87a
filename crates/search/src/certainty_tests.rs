use super::*;
use crate::trial::Trial;
use futures::executor::block_on;
use futures::future::{FutureExt, ready};

use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::outcome::Class;
use touchdown_dynamics::scene::{Conditions, CrushRule, Scene, Settings, Stop};

/// Tests the change at 1 ft/s of landings whose transition moves by `shift` at another tolerance.
fn tested(shift: f64) -> (Certainty, usize) {
    let landings = std::cell::Cell::new(0);
    let land = |speed: f64, variation: Variation| {
        landings.set(landings.get() + 1);
        let moved = match variation {
            Variation::At { .. } => shift,
            _ => 0.0,
        };
        let margin = if speed < 1.0 + moved { 0.1 } else { -0.1 };
        ready(Ok(Sample::example(speed, margin).trial)).boxed_local()
    };
    let (low, high) = (Sample::example(0.9995, 0.1), Sample::example(1.0005, -0.1));
    let certainty = block_on(test(Variation::Unchanged, [&low, &high], 0.25, &land)).unwrap();
    (certainty, landings.get())
}

#[test]
fn disagreement_widens_the_interval_until_all_agree() {
    assert_eq!(tested(0.0), (Certainty::Certain, 2));
    let (certainty, _) = tested(0.005);
    let Certainty::Disputed([low, high]) = certainty else {
        panic!("{certainty:?}");
    };
    assert_eq!(low, 0.9995);
    assert!((1.005..1.012).contains(&high), "{high}");
    let (certainty, _) = tested(9.0);
    assert_eq!(certainty, Certainty::Disputed([0.9995, 1.0005 + 0.25]));
}

#[test]
fn a_change_is_doubtful_where_the_margin_jumps_and_not_where_it_is_steep() {
    let landings = |samples: &[[f64; 2]]| -> Vec<Sample> {
        let sample = |&[speed, margin]: &[f64; 2]| Sample::example(speed, margin);
        samples.iter().map(sample).collect()
    };
    let doubtful =
        |below: &[[f64; 2]], above: &[[f64; 2]]| is_doubtful(&landings(below), &landings(above));
    // Gentle, whatever lies beside.
    assert!(!doubtful(&[[0.999, 0.001]], &[[1.0, -0.001]]));
    // 20 rad² per ft/s across the bracket: alone, then between flat, equally steep and half as steep stretches.
    let (low, high) = ([0.999, 0.01], [1.0, -0.01]);
    assert!(doubtful(&[low], &[high]));
    assert!(doubtful(&[[0.9, 0.011], low], &[high, [1.1, -0.011]]));
    assert!(!doubtful(&[[0.998, 0.03], low], &[high, [1.001, -0.03]]));
    assert!(!doubtful(&[[0.998, 0.02], low], &[high, [1.002, -0.03]]));
    // Steep on one side only.
    assert!(doubtful(&[[0.998, 0.03], low], &[high, [1.1, -0.011]]));
    assert!(doubtful(&[[0.998, 0.03], low], &[high]));
    // No margin tells of a change between toppling and failure.
    let mut failed = landings(&[high]);
    failed[0].trial = Trial::example(Class::Failure, 1);
    assert!(is_doubtful(&landings(&[[0.998, 0.03], low]), &failed));
}

#[test]
fn variations_change_what_they_say_and_little_of_it() {
    let attitude = Attitude::from_euler(Euler {
        pitch: 0.1,
        yaw: 0.2,
        roll: 0.3,
    });
    let scene = Scene::new(Conditions {
        vertical_velocity: 14.0,
        horizontal_velocity: 11.0,
        cross_slope: 3.0,
        slope: 0.25,
        attitude,
        angular_velocity: Default::default(),
        pad_friction: 1.0,
        block_friction: 1.0,
        static_friction_ratio: None,
        soil: touchdown_dynamics::soil::Soil::Rock,
        ground: touchdown_dynamics::ground::Ground::default(),
        gravity: None,
        thrust: touchdown_dynamics::thrust::Thrust::default(),
    })
    .unwrap();
    let settings = Settings::new(1e-6, 40.0, CrushRule::default()).unwrap();
    let settings = settings.stopping_at(Stop::Verdict);
    let varied = |variation: Variation| variation.of(&scene, &settings).unwrap();
    assert_eq!(varied(Variation::Unchanged), (scene, settings));
    assert_eq!(varied(Variation::Tolerance(0.1)).1.tolerance(), 1e-7);
    let scan = varied(Variation::Scan(10.0)).1;
    assert!((scan.tolerance() - 1e-5).abs() < 1e-20 && scan.ends_early());
    let (tested, tighter) = varied(testing(1e-6));
    assert!((tighter.tolerance() - 1e-7).abs() < 1e-20);
    let turn = tested.conditions().attitude.euler().pitch - attitude.euler().pitch;
    assert!((turn.to_degrees() - 1e-6).abs() < 1e-9, "{turn}");
    // No tighter than the solver can be.
    assert_eq!(varied(testing(1e-12)).1.tolerance(), 1e-12);
}
