//! `touchdown surface`: the surface from the times at which the footpads touched it (2.8).

use std::path::PathBuf;
use std::sync::atomic::Ordering;

use clap::Args;
use nalgebra::Vector3;
use rand::SeedableRng;
use rand_distr::{Distribution, Normal};
use rand_pcg::Pcg64;
use serde_json::{Value, json};
use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::impact_surface::{Approach, ImpactSurface, NoSurface, determine};
use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_dynamics::vehicle::Vehicle;
use touchdown_input::documents::input_error::InputError;
use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::points::parameter::Parameter;
use touchdown_input::readers::vehicle_file::VehicleFile;
use touchdown_sweep::threads::run::Observer;

use crate::interrupt;
use crate::options::UnitsOption;
use crate::progress::Progress;
use crate::report::degrees;
use crate::terminal::{Failure, print};
use crate::touchdown_options::{finite, triple};

/// Seed of the timing errors: the same command gives the same numbers.
const SEED: u64 = 1966;
const MOST_SAMPLES: u32 = 100_000;
/// Greatest standard deviation, s: that of the longest time.
const LONGEST: f64 = 100.0;
/// Greatest angle, a hundred turns, deg.
const GREATEST_ANGLE: f64 = 36_000.0;

const EXAMPLE: &str = "\
Example:
  Falling at 14 ft/s and drifting at 3 ft/s along Y, pads 1, 2 and 3 touched after 0, 0.21
  and 0.17 s, measured to 5 ms:
    touchdown surface --vehicle sweeps/vehicles/surveyor-table-4-1.toml --velocity 0,3,14 \\
      --impact-times 0,0.21,0.17 --friction 0.8 --timing-sigma 0.005";

/// Options of `surface`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Options {
    /// Vehicle file (TOML)
    #[arg(long, value_name = "FILE")]
    vehicle: PathBuf,
    /// Times at which the footpads touched the surface, s after time zero, in the order of the legs; of
    /// more than three the surface that fits best
    #[arg(long, value_name = "S,S,S", value_delimiter = ',', value_parser = finite, required = true,
          allow_hyphen_values = true)]
    impact_times: Vec<f64>,
    /// Velocity of the CG at time zero, ft/s, in any axes whose Z points down
    #[arg(long, value_name = "X,Y,Z", value_parser = triple, allow_hyphen_values = true,
          required_unless_present = "velocity_mps")]
    velocity: Option<[f64; 3]>,
    /// The same in m/s
    #[arg(long, value_name = "X,Y,Z", value_parser = triple, allow_hyphen_values = true,
          conflicts_with = "velocity")]
    velocity_mps: Option<[f64; 3]>,
    /// Pitch angle at time zero in the same axes
    #[arg(long, value_name = "DEG", default_value_t = 0.0, value_parser = finite,
          allow_hyphen_values = true)]
    pitch: f64,
    /// Yaw angle at time zero
    #[arg(long, value_name = "DEG", default_value_t = 0.0, value_parser = finite,
          allow_hyphen_values = true)]
    yaw: f64,
    /// Roll angle at time zero
    #[arg(long, value_name = "DEG", default_value_t = 0.0, value_parser = finite,
          allow_hyphen_values = true)]
    roll: f64,
    /// Angular velocity at time zero about the vehicle's axes, deg/s
    #[arg(long, value_name = "X,Y,Z", default_value = "0,0,0", value_parser = triple,
          allow_hyphen_values = true)]
    angular_velocity: [f64; 3],
    /// Friction coefficient between surface and vehicle
    #[arg(long, value_name = "MU", value_parser = finite, allow_hyphen_values = true)]
    friction: f64,
    /// Standard deviation of the impact times, s: gives the errors of slope and cross-slope
    #[arg(long, value_name = "S", value_parser = finite, allow_hyphen_values = true)]
    timing_sigma: Option<f64>,
    /// Samples of timing errors, from 2 to 100000
    #[arg(long, value_name = "N", default_value_t = 400, requires = "timing_sigma",
          value_parser = clap::value_parser!(u32).range(2..=i64::from(MOST_SAMPLES)))]
    samples: u32,
    /// Print the result as JSON
    #[arg(long, help_heading = "Output")]
    json: bool,
    #[command(flatten)]
    units: UnitsOption,
}

impl Options {
    /// Velocity of the CG at time zero, ft/s.
    fn velocity(&self) -> [f64; 3] {
        let in_si = Parameter::named("vertical_velocity_mps", MOST_LEGS).zip(self.velocity_mps);
        let given = in_si.map(|(speed, parts)| parts.map(|part| speed.to_program(part)));
        given.or(self.velocity).unwrap_or_default()
    }
}

/// What timing errors do to the result.
struct Uncertainty {
    sigma: f64,
    /// Samples that determine a surface, and all samples.
    solved: u32,
    samples: u32,
    /// Mean and standard deviation, deg.
    slope: (f64, f64),
    cross_slope: Option<(f64, f64)>,
}

/// Runs `surface`.
pub fn run(options: &Options) -> Result<(), Failure> {
    let vehicle = VehicleFile::read(&options.vehicle)?;
    for (option, angle) in [
        ("--pitch", options.pitch),
        ("--yaw", options.yaw),
        ("--roll", options.roll),
    ] {
        if angle.abs() > GREATEST_ANGLE {
            return Err(InputError::value(option, angle, "-36000 ≤ value ≤ 36000").into());
        }
    }
    let approach = Approach {
        velocity: Vector3::from(options.velocity()),
        attitude: Attitude::from_euler(Euler {
            pitch: options.pitch.to_radians(),
            yaw: options.yaw.to_radians(),
            roll: options.roll.to_radians(),
        }),
        angular_velocity: options.angular_velocity.map(f64::to_radians),
        friction: options.friction,
    };
    let surface = determine(&vehicle.vehicle, &approach, &options.impact_times);
    let surface = surface.map_err(|why| refused(why, options))?;
    let uncertainty = match options.timing_sigma {
        Some(sigma) => Some(uncertainty(
            options,
            &vehicle.vehicle,
            &approach,
            &surface,
            sigma,
        )?),
        None => None,
    };
    let units = options.units.given.unwrap_or_default();
    print(&if options.json {
        format!("{:#}\n", as_json(&surface, uncertainty.as_ref(), units))
    } else {
        text(&vehicle.name, &surface, uncertainty.as_ref(), units)
    })?;
    Ok(())
}

/// The complaint in the words of the command line.
fn refused(why: NoSurface, options: &Options) -> Failure {
    match why {
        NoSurface::Input(invalid) => {
            let option = match invalid.quantity.as_str() {
                name if name.starts_with("impact_time_s") => "--impact-times",
                "friction" => "--friction",
                name if name.starts_with("angular_velocity") => "--angular-velocity",
                _ if options.velocity_mps.is_some() => {
                    let (value, allowed) = (invalid.value, &invalid.allowed);
                    let said = format!("{allowed} (in ft/s: this is {value})");
                    return InputError::other(format!("--velocity-mps: expected {said}")).into();
                }
                _ => "--velocity",
            };
            InputError::value(option, invalid.value, &invalid.allowed).into()
        }
        other => Failure::running(other),
    }
}

fn uncertainty(
    options: &Options,
    vehicle: &Vehicle,
    approach: &Approach,
    surface: &ImpactSurface,
    sigma: f64,
) -> Result<Uncertainty, Failure> {
    if sigma <= 0.0 || sigma > LONGEST {
        let error = InputError::value("--timing-sigma", sigma, "0 < value ≤ 100");
        return Err(error.into());
    }
    let errors = Normal::new(0.0, sigma).map_err(Failure::running)?;
    let mut random = Pcg64::seed_from_u64(SEED);
    let mut slopes = Vec::new();
    let mut cross_slopes = Vec::new();
    let cancel = interrupt::flag()?;
    let progress = Progress::start("samples", options.samples as usize, false);
    for number in 0..options.samples as usize {
        if cancel.load(Ordering::Relaxed) {
            progress.finish();
            let work = "no result was printed".to_owned();
            return Err(Failure::Interrupted(work));
        }
        let times = options.impact_times.iter();
        let times: Vec<f64> = times
            .map(|time| time + errors.sample(&mut random))
            .collect();
        // Only differences matter where the first impact is at time zero.
        let earliest = times.iter().fold(0.0f64, |least, time| least.min(*time));
        let times: Vec<f64> = times.iter().map(|time| time - earliest).collect();
        let sample = determine(vehicle, approach, &times);
        progress.point(number);
        let Ok(sample) = sample else {
            continue;
        };
        slopes.push(sample.slope.to_degrees());
        if let (Some(here), Some(there)) = (sample.cross_slope, surface.cross_slope) {
            let apart = (here - there).to_degrees();
            cross_slopes.push(apart - 360.0 * (apart / 360.0).round() + there.to_degrees());
        }
    }
    progress.finish();
    Ok(Uncertainty {
        sigma,
        solved: slopes.len() as u32,
        samples: options.samples,
        slope: moments(&slopes).ok_or_else(|| {
            Failure::running("too few of the samples of impact times determine a surface")
        })?,
        cross_slope: moments(&cross_slopes),
    })
}

/// Mean and standard deviation of two values or more.
fn moments(values: &[f64]) -> Option<(f64, f64)> {
    let count = values.len() as f64;
    if values.len() < 2 {
        return None;
    }
    let mean = values.iter().sum::<f64>() / count;
    let squares = values
        .iter()
        .map(|value| (value - mean).powi(2))
        .sum::<f64>();
    Some((mean, (squares / (count - 1.0)).sqrt()))
}

fn text(
    vehicle: &str,
    surface: &ImpactSurface,
    uncertainty: Option<&Uncertainty>,
    units: OutputUnits,
) -> String {
    let [speed, length] = ["velocity_fps", "place_ft"].map(|name| units.quantity(name));
    let velocity = |value: f64| format!("{:.6} {}", speed.number(value), speed.unit());
    let angle_or = |angle: Option<f64>, why: &str| match angle {
        Some(angle) => format!("{} deg", degrees(angle, 6)),
        None => why.to_owned(),
    };
    let mut lines = vec![
        vehicle.to_owned(),
        String::new(),
        line("ground slope", &angle_or(Some(surface.slope), "")),
        line(
            "cross-slope",
            &angle_or(
                surface.cross_slope,
                "none: level ground or no horizontal motion",
            ),
        ),
        line(
            "rotation to ground axes",
            &angle_or(surface.rotation, "none: on level ground any axes serve"),
        ),
        String::new(),
        "at first contact, in ground axes (Y into the slope)".to_owned(),
        line("pitch", &angle_or(Some(surface.attitude.pitch), "")),
        line("yaw", &angle_or(Some(surface.attitude.yaw), "")),
        line("roll", &angle_or(Some(surface.attitude.roll), "")),
        line("vertical velocity", &velocity(surface.vertical_velocity)),
        line(
            "horizontal velocity",
            &velocity(surface.horizontal_velocity),
        ),
        String::new(),
        format!(
            "points of impact in the given axes, from the CG at time zero, {}",
            length.unit()
        ),
    ];
    for (leg, point) in surface.impact_points.iter().enumerate() {
        let [x, y, z] = [point.x, point.y, point.z].map(|part| length.number(part));
        let place = format!("{x:>10.5} {y:>10.5} {z:>10.5}");
        lines.push(line(&format!("footpad {}", leg + 1), &place));
    }
    lines.push(String::new());
    lines.push(line(
        "computation",
        &format!(
            "{} landings, impact times reproduced to {:.1e} s",
            surface.landings, surface.residual
        ),
    ));
    if let Some(Uncertainty {
        sigma,
        solved,
        samples,
        slope,
        cross_slope,
    }) = uncertainty
    {
        lines.push(String::new());
        lines.push(format!(
            "with timing errors of {sigma} s ({solved} of {samples} samples determine a surface)"
        ));
        let spread = |(mean, deviation): (f64, f64)| {
            format!("{mean:.3} deg, standard deviation {deviation:.3} deg")
        };
        lines.push(line("ground slope", &spread(*slope)));
        if let Some(cross_slope) = cross_slope {
            lines.push(line("cross-slope", &spread(*cross_slope)));
        }
    }
    lines.join("\n") + "\n"
}

fn line(name: &str, value: &str) -> String {
    format!("{name:<28} {value}")
}

fn as_json(
    surface: &ImpactSurface,
    uncertainty: Option<&Uncertainty>,
    units: OutputUnits,
) -> Value {
    let degrees = |angle: Option<f64>| angle.map(f64::to_degrees);
    let [vertical, horizontal, points] = [
        "vertical_velocity_fps",
        "horizontal_velocity_fps",
        "impact_points_ft",
    ]
    .map(|name| units.quantity(name));
    let place = |point: &Vector3<f64>| [point.x, point.y, point.z].map(|part| points.number(part));
    json!({
        "slope_deg": surface.slope.to_degrees(),
        "cross_slope_deg": degrees(surface.cross_slope),
        "rotation_deg": degrees(surface.rotation),
        "pitch_deg": surface.attitude.pitch.to_degrees(),
        "yaw_deg": surface.attitude.yaw.to_degrees(),
        "roll_deg": surface.attitude.roll.to_degrees(),
        (vertical.name()): vertical.number(surface.vertical_velocity),
        (horizontal.name()): horizontal.number(surface.horizontal_velocity),
        (points.name()): surface.impact_points.iter().map(place).collect::<Vec<_>>(),
        "residual_s": surface.residual,
        "timing": uncertainty.map(|u| json!({
            "sigma_s": u.sigma,
            "samples": u.samples,
            "with_a_surface": u.solved,
            "slope_mean_deg": u.slope.0,
            "slope_sigma_deg": u.slope.1,
            "cross_slope_mean_deg": u.cross_slope.map(|c| c.0),
            "cross_slope_sigma_deg": u.cross_slope.map(|c| c.1),
        })),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_those_of_a_sample() {
        assert_eq!(moments(&[1.0]), None);
        let (mean, deviation) = moments(&[1.0, 3.0]).unwrap();
        assert_eq!((mean, deviation), (2.0, 2f64.sqrt()));
    }
}
