//! The laws of the elements against what the model says of them, written out anew: shock absorber
//! (42)-(45), friction profile C, and crushing along a path worked by hand.

use crate::common::random::fixed_list;
use crate::common::surveyor_leg;
use touchdown_dynamics::contact::LegMode;
use touchdown_dynamics::crush::{Crush, CrushLaw, PressureLine};
use touchdown_dynamics::friction::{FrictionLaw, FrictionProfile, Sliding};
use touchdown_dynamics::integrator::event::Exit;
use touchdown_dynamics::motion::Signal;
use touchdown_dynamics::profile::Profile;
use touchdown_dynamics::scene::CrushRule;
use touchdown_dynamics::strut::{Stance, StrutLaw};
use touchdown_dynamics::vehicle::{Leg, Strut};

/// Ordinate of a table, its last segment extended.
fn look_up(profile: &Profile, x: f64) -> f64 {
    let knots = profile.knots();
    let k = (1..knots.len() - 1)
        .find(|&k| x < knots[k][0])
        .unwrap_or(knots.len() - 1);
    let [[x0, y0], [x1, y1]] = [knots[k - 1], knots[k]];
    y0 + (y1 - y0) * (x - x0) / (x1 - x0)
}

/// Strut force at stroke δ (ft), link rate γ̇ (rad/s) and dl_D/dt (ft/s), as the model states it.
fn strut_force(strut: &Strut, stroke: f64, link_rate: f64, length_rate: f64) -> f64 {
    let damper = strut.damper().unwrap();
    let elastic = damper.preload / damper.structural_stiffness;
    let spring = if stroke <= elastic {
        damper.structural_stiffness * stroke
    } else {
        let stiffness = damper.spring_constant * look_up(&damper.spring_profile, stroke);
        stiffness * (stroke - elastic) + damper.preload
    };
    let fraction = (link_rate.abs() / 0.2).min(1.0);
    let engaged = 1.0 - (1.0 - fraction).powi(3);
    let dry = strut.friction_fraction * spring.abs();
    let squared = length_rate * length_rate;
    if length_rate < 0.0 {
        let multiplier = if stroke < 0.0 {
            1.0
        } else {
            look_up(&damper.damping_profile, stroke)
        };
        spring + engaged * (dry + damper.compression_damping * multiplier * squared)
    } else {
        let damping = damper.rebound_damping * (1.0 + damper.rebound_growth * stroke);
        spring - engaged * (dry + damping * squared)
    }
}

/// The working strut at a stroke.
fn working(law: &StrutLaw, stroke: f64) -> Stance {
    let mut stance = Stance::extended(true, -1e-3);
    // On its stop, a link that starts to be pushed in begins to stroke.
    stance.cross_rate(law, true, stroke, -1e-3);
    stance
}

#[test]
fn strut_force_of_the_model() {
    let strut = surveyor_leg(0.0).strut;
    let law = StrutLaw::new(&strut);
    let lever = 0.9;
    let mut greatest: f64 = 0.0;
    for k in -20..=375 {
        // Off the knots of the tables and through the elastic limit of 0.00185 ft.
        let stroke = 0.001 * f64::from(k) + 3e-4;
        for link_rate in [-4.0, -0.5, -0.19, -0.07, -1e-3, 1e-3, 0.05, 0.19, 0.3, 3.0] {
            if stroke < 1e-6 && link_rate > 0.0 {
                continue;
            }
            let (piece, link) = working(&law, stroke).pieces(&law, &PressureLine::slack());
            let force = piece.force(stroke, link_rate, lever);
            let expected = strut_force(&strut, stroke, link_rate, lever * link_rate);
            let off = (force - expected).abs() / expected.abs().max(1.0);
            assert!(
                off < 1e-9,
                "{force} for {expected} lb at {stroke} ft, {link_rate} rad/s"
            );
            assert!((link.free, link.moving) == (1.0, 1.0));
            greatest = greatest.max(force.abs());
        }
    }
    assert!(greatest > 5000.0, "{greatest}");
}

#[test]
fn a_strut_leaves_its_stop_without_a_change_of_law() {
    let law = StrutLaw::new(&surveyor_leg(0.0).strut);
    let (on_stop, beyond, past_elastic) = (5e-7, 1e-4, 0.01);
    let mut leaving = Stance::at(&law, true, on_stop, -1.0);
    let strokes = leaving.stroke_bounds(&law);
    assert_eq!(strokes.exit(beyond), None);
    assert_eq!(strokes.exit(past_elastic), Some(Exit::Above));
    // On its way it may not turn back: there the stop would hold it.
    assert_eq!(leaving.rate_bounds(&law).exit(1e-3), Some(Exit::Above));
    let mut turned = leaving;
    turned.cross_rate(&law, true, beyond, 1e-3);
    assert!(leaving.follow(&law, beyond));
    assert_eq!(turned, leaving);
    assert!(leaving.rate_bounds(&law).is_free());
    assert_eq!(leaving.stroke_bounds(&law).exit(on_stop), Some(Exit::Below));
    let mut stopped = Stance::at(&law, true, on_stop, -1.0);
    stopped.cross_rate(&law, true, on_stop, 1e-3);
    assert!(stopped.is_extended());
}

#[test]
fn the_ranges_of_a_leg_stand_in_the_order_of_its_signals() {
    let leg = Leg::new(surveyor_leg(0.0)).unwrap();
    let laws = leg.laws().clone().with_crush_rule(CrushRule::PivotRate);
    let ranges = LegMode::untouched(&laws).ranges(&laws);
    let range = |signal: Signal| ranges[signal as usize];
    let elements = [
        Signal::OuterInterference,
        Signal::InnerInterference,
        Signal::BlockInterference,
    ];
    for element in elements {
        assert_eq!(range(element).exit(-3.0), None, "{element:?}");
        assert_eq!(range(element).exit(1e-5), Some(Exit::Above), "{element:?}");
    }
    // Between the stops, below the clip; and nothing else matters in the air.
    let pad = range(Signal::PadTurn);
    let limits = [0.74f64, 0.76, 44.9, 45.1].map(|degrees| pad.exit(degrees.to_radians()));
    assert_eq!(limits, [Some(Exit::Below), None, None, Some(Exit::Above)]);
    let hinge = range(Signal::HingeDrive);
    let limits = [-100.1, -99.9, 99.9, 100.1].map(|speed| hinge.exit(speed));
    assert_eq!(limits, [Some(Exit::Below), None, None, Some(Exit::Above)]);
    let restricted = Signal::ALL[..Signal::RANGED]
        .iter()
        .filter(|&&signal| !range(signal).is_free());
    assert_eq!(restricted.count(), elements.len() + 2);
}

#[test]
fn a_pad_that_has_touched_is_stopped_at_pressure_not_at_contact_while_its_strut_works() {
    let leg = Leg::new(surveyor_leg(0.0)).unwrap();
    let laws = leg.laws().clone().with_crush_rule(CrushRule::PivotRate);
    let mut mode = LegMode::untouched(&laws);
    let mut signals = [0.0; Signal::COUNT];
    signals[Signal::InnerInterference as usize] = -0.01;
    signals[Signal::BlockInterference as usize] = -1.0;
    let leaves = |mode: &LegMode, signal: Signal, value: f64| {
        mode.ranges(&laws)[signal as usize].exit(value).is_some()
    };
    let outer = Signal::OuterInterference;
    let [in_contact, pressed] = [2e-6, 1.1e-5];
    assert!(leaves(&mode, outer, in_contact));
    // It touches, is pressed, its link is pushed off its stop and turns; then it is lifted.
    for (signal, value, exit) in [
        (outer, in_contact, Exit::Above),
        (outer, pressed, Exit::Above),
        (Signal::LinkTorque, -1.0, Exit::Below),
        (Signal::LinkRate, -1e-3, Exit::Below),
        (outer, 9e-6, Exit::Below),
    ] {
        signals[signal as usize] = value;
        mode.cross(&laws, 0, signal, exit, &signals).unwrap();
    }
    for element in [outer, Signal::InnerInterference] {
        assert!(!leaves(&mode, element, in_contact), "{element:?}");
        assert!(!leaves(&mode, element, -0.1), "{element:?}");
        assert!(leaves(&mode, element, pressed), "{element:?}");
    }
    // The block has yet to touch.
    assert!(leaves(&mode, Signal::BlockInterference, in_contact));
    // Back on its stop, contact decides whether the leg hangs.
    signals[Signal::Stroke as usize] = 0.0;
    signals[Signal::LinkRate as usize] = 1e-3;
    (mode.cross(&laws, 0, Signal::LinkRate, Exit::Above, &signals)).unwrap();
    assert!(leaves(&mode, outer, 0.0));
    assert!(leaves(&mode, Signal::InnerInterference, in_contact));
}

#[test]
fn friction_profile_c() {
    let law = FrictionLaw::default();
    for k in 1..=2000 {
        let speed = 0.001 * f64::from(k) - 5e-4;
        let expected = if speed <= 0.05 {
            24.0 * speed
        } else if speed <= 1.05 {
            1.21 - 0.2 * speed
        } else {
            1.0
        };
        let squared = speed * speed;
        let sliding = Sliding::at(&law, squared);
        let coefficient = sliding.piece::<f64>(&law).per_speed(squared) * speed;
        assert!(
            (coefficient - expected).abs() < 1e-12,
            "{coefficient} at {speed} ft/s"
        );
        let range = sliding.bounds(&law);
        assert!(range.lower <= squared && squared <= range.upper);
    }
    // At rest there is no friction, and no division by nothing.
    let at_rest = Sliding::at(&law, 0.0).piece::<f64>(&law);
    assert_eq!(at_rest.per_speed(0.0), 24.0);
}

/// μ/μ0 at a sliding speed, ft/s.
fn coefficient(law: &FrictionLaw, speed: f64) -> f64 {
    let piece = Sliding::at(law, speed * speed).piece::<f64>(law);
    piece.per_speed(speed * speed) * speed
}

#[test]
fn static_friction_is_the_peak_from_which_friction_falls_to_sliding_friction() {
    use FrictionProfile::{A, B, C};
    for (profile, ratio) in [(A, 5.0), (B, 2.5), (C, 1.0), (C, 1.7), (C, 100.0)] {
        let law = FrictionLaw::new(profile, Some(ratio));
        let limit = profile.viscous_limit();
        assert!(law.is_viscous(0.999 * limit * limit) && !law.is_viscous(1.001 * limit * limit));
        let middle = 0.5 * (limit + 1.05);
        let known = [
            (0.5 * limit, 0.5 * ratio),
            (limit, ratio),
            (limit * (1.0 + 1e-12), ratio),
            (middle, 0.5 * (ratio + 1.0)),
            (1.05, 1.0),
            (1.06, 1.0),
            (40.0, 1.0),
        ];
        for (speed, expected) in known {
            let found = coefficient(&law, speed);
            let off = (found - expected).abs();
            assert!(
                off < 1e-9 * ratio,
                "{profile:?}, {ratio}: {found} at {speed} ft/s"
            );
        }
    }
    let of_1966 = FrictionLaw::new(C, Some(FrictionProfile::STATIC_RATIO));
    for speed in [0.01, 0.05, 0.3, 1.0, 2.0] {
        let off = coefficient(&of_1966, speed) - coefficient(&FrictionLaw::default(), speed);
        assert!(off.abs() < 1e-14, "{off} at {speed} ft/s");
    }
}

#[test]
fn friction_profiles_differ_only_near_rest() {
    let coefficient = |profile, speed| coefficient(&FrictionLaw::new(profile, None), speed);
    for profile in [FrictionProfile::A, FrictionProfile::B] {
        let limit = profile.viscous_limit();
        assert!(limit < FrictionProfile::C.viscous_limit());
        for speed in [0.0501, 0.3, 1.0, 1.1, 5.0] {
            let expected = coefficient(FrictionProfile::C, speed);
            assert_eq!(coefficient(profile, speed), expected);
        }
        // No jump where viscous friction ends, and half of it halfway.
        let before = coefficient(profile, limit * (1.0 - 1e-9));
        let after = coefficient(profile, limit * (1.0 + 1e-9));
        assert!((before - after).abs() < 1e-8, "{before} {after}");
        assert!((coefficient(profile, 0.5 * limit) - 0.5 * after).abs() < 1e-8);
    }
}

/// Over its own interference no element gives back more than it took, whenever it may crush.
#[test]
fn an_element_gives_back_at_most_what_it_took() {
    const FINE: u32 = 1000;
    let law = law();
    let steps = proptest::collection::vec((-0.1..0.1f64, proptest::bool::ANY), 100);
    let mut crushed = 0;
    for (number, path) in fixed_list(&steps, 50).into_iter().enumerate() {
        let [
            mut interference,
            mut set,
            mut given,
            mut taken,
            mut greatest,
        ] = [0.0f64; 5];
        for (step, may_crush) in path {
            // Fine steps h: the set follows the path, and where contact is lost a trapezoid is E h²/2 = 5e-8 off at most.
            for _ in 0..FINE {
                // Every other path is that of the section rule: an element crushes whenever it gets deeper.
                let driven = step > 0.0 && (number % 2 == 0 || may_crush);
                let pressure = |at: f64, set: f64| law.state_at(set, at, driven).line.at(at);
                let next = (interference + step / f64::from(FINE)).clamp(-0.2, 1.0);
                let before = pressure(interference, set);
                set = law.state_at(set, next, driven).set;
                let work = 0.5 * (before + pressure(next, set)) * (next - interference);
                (taken, given) = (taken + work.max(0.0), given + (-work).max(0.0));
                assert!(given <= taken + 1e-5, "path {number}: {given} of {taken}");
                interference = next;
                greatest = greatest.max(set);
            }
        }
        crushed += usize::from(greatest > 0.02 && given > 0.01);
    }
    assert!(crushed > 25, "{crushed} of 50 paths crush and give back");
}

/// A profile easy on the head: elastic slope 10 to 1 at 0.1 ft, then 1 to 1.2 at 0.5 ft, then 4
/// per foot.
fn law() -> CrushLaw {
    let knots = vec![[0.0, 0.0], [0.1, 1.0], [0.5, 1.2], [1.0, 3.2]];
    CrushLaw::new(&Profile::new(knots).unwrap(), 1e-5)
}

fn near(value: f64, expected: f64) {
    assert!(
        (value - expected).abs() < 1e-12,
        "{value} instead of {expected}"
    );
}

/// First contact, then the elastic line.
fn pressed(law: &CrushLaw) -> Crush {
    let mut crush = Crush::untouched(law);
    assert!(!crush.in_contact() && !crush.is_loaded());
    near(crush.interference_bounds(law, true).upper, 1e-6);
    crush.cross_interference(law, Exit::Above, 1e-6, true);
    assert!(crush.in_contact() && !crush.is_loaded());
    assert!(crush.line(law).is_slack());
    near(crush.interference_bounds(law, true).upper, 1e-5);
    crush.cross_interference(law, Exit::Above, 1e-5, true);
    assert!(crush.is_loaded());
    near(crush.line(law).at(0.06), 0.6);
    near(crush.interference_bounds(law, true).upper, 0.1);
    crush
}

#[test]
fn crushing_along_a_path() {
    let law = law();
    let mut crush = pressed(&law);
    // Along the front, through its knot at 0.5 ft, to 0.7 ft.
    crush.cross_interference(&law, Exit::Above, 0.1, true);
    near(crush.line(&law).at(0.3), 1.1);
    near(crush.set_at(&law, 0.3), 0.3 - 0.11);
    near(crush.interference_bounds(&law, true).upper, 0.5);
    crush.cross_interference(&law, Exit::Above, 0.5, true);
    near(crush.line(&law).at(0.7), 2.0);
    // Back: p(0.7)/E = 0.2 ft of it are elastic.
    crush.leave_front(&law, 0.7);
    near(crush.set_at(&law, 0.6), 0.5);
    near(crush.line(&law).at(0.6), 1.0);
    near(crush.line(&law).at(0.7), 2.0);
    let range = crush.interference_bounds(&law, true);
    near(range.lower, 0.5 + 1e-5);
    near(range.upper, 0.7);
    // Clear of the surface, down to the set of 0.5 ft: contact is lost there, not at zero.
    crush.cross_interference(&law, Exit::Below, 0.5 + 1e-5, false);
    assert!(crush.in_contact() && !crush.is_loaded());
    crush.cross_interference(&law, Exit::Below, 0.5 + 1e-6, false);
    assert!(!crush.in_contact());
    near(crush.set_at(&law, 0.2), 0.5);
    // Again down: elastic to where it left the front, then on along it.
    crush.cross_interference(&law, Exit::Above, 0.5 + 1e-6, true);
    crush.cross_interference(&law, Exit::Above, 0.5 + 1e-5, true);
    near(crush.line(&law).at(0.65), 1.5);
    crush.cross_interference(&law, Exit::Above, 0.7, true);
    near(crush.line(&law).at(0.8), 2.4);
    near(crush.set_at(&law, 0.8), 0.8 - 0.24);
}

#[test]
fn the_listing_rule_jumps() {
    let law = law();
    let mut crush = pressed(&law);
    // Driven past the front while its pivot rises: elastic without a cap, the set frozen.
    crush.cross_interference(&law, Exit::Above, 0.1, false);
    near(crush.line(&law).at(0.3), 3.0);
    near(crush.set_at(&law, 0.3), 0.0);
    assert!(crush.drive_bounds().exit(1e-9) == Some(Exit::Above));
    // The pivot turns: onto the front at once, from 3.0 down to 1.1, the set from 0 to 0.19 ft.
    crush.drive(&law, true, 0.3);
    near(crush.line(&law).at(0.3), 1.1);
    near(crush.set_at(&law, 0.3), 0.19);
    // And up again, off the front: the set stays.
    crush.drive(&law, false, 0.4);
    near(crush.set_at(&law, 0.45), 0.4 - 0.115);
    near(crush.line(&law).at(0.45), 10.0 * (0.45 - 0.285));
    // Driven past the front once more, but back within it before the pivot turns: no jump.
    crush.cross_interference(&law, Exit::Above, 0.4, false);
    near(crush.line(&law).at(0.45), 1.65);
    crush.cross_interference(&law, Exit::Below, 0.4, false);
    crush.drive(&law, true, 0.39);
    near(crush.line(&law).at(0.39), 1.05);
    near(crush.set_at(&law, 0.39), 0.285);
}
