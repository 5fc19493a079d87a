use super::*;
use futures::executor::block_on;
use std::convert::Infallible;
use touchdown_dynamics::scene::CrushRule;

/// Tests the change at 1 ft/s of landings whose transition moves by `shift` at another tolerance.
fn tested(doubt: Doubt, jump: f64, shift: f64) -> (Certainty, usize) {
    let landings = std::cell::Cell::new(0);
    let land = async |speed: f64, variation: Variation| {
        landings.set(landings.get() + 1);
        let moved = match variation {
            Variation::At { .. } => shift,
            _ => 0.0,
        };
        let margin = if speed < 1.0 + moved { jump } else { -jump };
        Ok::<_, Infallible>(Sample::example(speed, margin).trial)
    };
    let (low, high) = (
        Sample::example(0.9995, jump),
        Sample::example(1.0005, -jump),
    );
    let Ok(certainty) = block_on(test(
        doubt,
        Variation::Unchanged,
        [&low, &high],
        0.25,
        &land,
    ));
    (certainty, landings.get())
}

#[test]
fn a_margin_through_zero_is_certain_without_a_landing() {
    assert_eq!(tested(Doubt::Doubtful, 1e-4, 0.0), (Certainty::Certain, 0));
    assert_eq!(tested(Doubt::None, 1.0, 0.0), (Certainty::Untested, 0));
    assert_eq!(tested(Doubt::All, 1e-4, 0.0), (Certainty::Certain, 2));
    assert_eq!(tested(Doubt::Doubtful, 0.1, 0.0), (Certainty::Certain, 2));
}

#[test]
fn disagreement_widens_the_interval_until_all_agree() {
    let (certainty, _) = tested(Doubt::Doubtful, 0.1, 0.005);
    let Certainty::Disputed([low, high]) = certainty else {
        panic!("{certainty:?}");
    };
    assert_eq!(low, 0.9995);
    assert!((1.005..1.012).contains(&high), "{high}");
    let (certainty, _) = tested(Doubt::Doubtful, 0.1, 9.0);
    assert_eq!(certainty, Certainty::Disputed([0.9995, 1.0005 + 0.25]));
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
        ground: touchdown_dynamics::ground::Ground::default(),
        gravity: None,
        thrust: touchdown_dynamics::thrust::Thrust::default(),
    })
    .unwrap();
    let settings = Settings::new(1e-6, 40.0, CrushRule::default()).unwrap();
    let varied = |variation: Variation| variation.of(&scene, &settings).unwrap();
    assert_eq!(varied(Variation::Unchanged), (scene, settings));
    assert_eq!(varied(Variation::Tolerance(0.1)).1.tolerance(), 1e-7);
    let scan = varied(Variation::Scan(10.0)).1;
    assert!((scan.tolerance() - 1e-5).abs() < 1e-20 && scan.ends_early());
    let (tested, tighter) = varied(Variation::testing(1e-6));
    assert!((tighter.tolerance() - 1e-7).abs() < 1e-20);
    let turn = tested.conditions().attitude.euler().pitch - attitude.euler().pitch;
    assert!((turn.to_degrees() - 1e-6).abs() < 1e-9, "{turn}");
    // No tighter than the solver can be.
    assert_eq!(varied(Variation::testing(1e-12)).1.tolerance(), 1e-12);
}
