//! `touchdown ask`: V_H at any place of a sweep, searched there.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Map, Value as Json, json};
use touchdown_dynamics::land::land;
use touchdown_dynamics::landing::Landing;
use touchdown_input::documents::document::Value;
use touchdown_input::documents::input_error::InputError;
use touchdown_input::points::assignment::{self, Assignment};
use touchdown_input::readers::scene_input::HORIZONTAL_VELOCITY;
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_search::boundary::Boundary;
use touchdown_sweep::output::landing_table::{self, why};
use touchdown_sweep::output::{bands_table, results};
use touchdown_sweep::summary::findings::Finding;
use touchdown_sweep::summary::probabilities::wilson;
use touchdown_sweep::threads::run::Workers;

use crate::options::UnitsOption;
use crate::report::degrees;
use crate::summary::number;
use crate::terminal::{Failure, print};

const EXAMPLES: &str = "\
Examples:
  V_H between two points of Figure 4-9:
    touchdown ask results/figure-4-09.csv --at roll_deg=31

  Whether a landing at 12 ft/s is stable there, and how far it is from V_H:
    touchdown ask results/figure-4-09.csv --at roll_deg=31,horizontal_velocity_fps=12

  A place of a sweep that has not been run:
    touchdown ask sweeps/surface-4-20.toml --at cross_slope_deg=172,roll_deg=31

The search at the place is that of the sweep: about twenty landings, some hundredths of a second. It reads the record beside results,
which has the whole input, or the sweep file.";

/// Options of `ask`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Options {
    /// Results of a sweep (its table NAME.csv or its record NAME.json), or a sweep file (TOML)
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Value of each axis of the sweep, and of horizontal_velocity_fps (or _mps) to land at that velocity, too
    #[arg(long, value_name = "KEY=VALUE", value_delimiter = ',', value_parser = Assignment::parse, required = true,
          allow_hyphen_values = true)]
    at: Vec<Assignment>,
    /// Print the answer as JSON
    #[arg(long, help_heading = "Output")]
    json: bool,
    #[command(flatten)]
    units: UnitsOption,
}

/// Runs `ask`.
pub fn run(options: &Options) -> Result<(), Failure> {
    assignment::check_once(&options.at)?;
    let (speeds, place): (Vec<_>, Vec<_>) = (options.at.iter().cloned())
        .partition(|one| one.parameter().program_name() == HORIZONTAL_VELOCITY);
    let mut sweep = read(&options.file, &place)?;
    sweep.units = options.units.given.unwrap_or(sweep.units);
    if sweep.search().is_none() {
        let complaint = "expected a sweep that searches transitions";
        return Err(InputError::in_file(&options.file, complaint).into());
    }
    let found = Workers::start(None)?.points(&sweep, &[0])?;
    let Some(boundary) = found.first().and_then(Finding::boundary) else {
        return Err(Failure::running("the search gave no boundary"));
    };
    let landed = speeds.first().map(|speed| land_at(&sweep, speed));
    let answer = Answer {
        sweep: &sweep,
        boundary,
        landed: landed.transpose()?,
    };
    print(&match options.json {
        true => format!("{:#}\n", answer.json()),
        false => answer.text(),
    })
}

/// The sweep of a file at a place.
fn read(file: &Path, place: &[Assignment]) -> Result<Sweep, InputError> {
    let ending = file.extension().unwrap_or_default();
    if ending == "toml" {
        return Sweep::read(file)?.at(place);
    }
    if file.is_dir() {
        let complaint = "is a folder: expected one of the tables in it, such as NAME.csv";
        return Err(InputError::in_file(file, complaint));
    }
    let record = file.with_extension("json");
    let text = fs::read_to_string(&record).map_err(|error| {
        let complaint = format!("{error}: expected a sweep file, or results beside their record");
        InputError::in_file(&record, complaint)
    })?;
    Sweep::of_record(&text, &record, place)
}

/// The landing at the place at a horizontal velocity (ft/s), and that velocity.
fn land_at(sweep: &Sweep, speed: &Assignment) -> Result<(f64, Landing), Failure> {
    let case = sweep.case(0).map_err(Failure::running)?;
    let Value::Number(fps) = speed.value() else {
        return Err(speed.refuse("expected a number").into());
    };
    let scene = case.scene.with_horizontal_velocity(fps);
    let scene = scene.map_err(|fault| {
        InputError::value("--at horizontal velocity", speed.text(), &fault.allowed)
    })?;
    Ok((fps, land(&case.vehicle, &scene, &case.settings)))
}

/// Boundary at a place, and the landing there if asked for.
struct Answer<'a> {
    sweep: &'a Sweep,
    boundary: &'a Boundary,
    landed: Option<(f64, Landing)>,
}

impl Answer<'_> {
    fn text(&self) -> String {
        let (sweep, boundary) = (self.sweep, self.boundary);
        let speed = sweep.units.quantity("speed_fps");
        let told = |fps: f64| format!("{:.4} {}", speed.number(fps), speed.unit());
        let mut text = format!("{}\n  at {}\n", sweep.title, sweep.place(0));
        text += &match boundary.transition {
            None => format!("  stable up to {}\n", told(boundary.searched_to)),
            Some(found) => {
                let bracket = match found.low {
                    Some(low) => format!("between {} and {}", told(low), told(found.high)),
                    None => format!("at or below {}", told(found.high)),
                };
                let certainty = match found.certainty.word() {
                    "" => String::new(),
                    word => format!(", {word}"),
                };
                let to = results::transition_name(boundary);
                format!(
                    "  V_H {} ({to}{certainty}), {bracket}\n",
                    told(found.speed())
                )
            }
        };
        if let Some(patchy) = boundary.patchy {
            let share = wilson(patchy.not_stable, patchy.landings).map(|share| 100.0 * share);
            text += &format!(
                "  patchy up to {}: {} of {} landings there are not stable (95 % interval {:.0} to {:.0} %)\n",
                told(patchy.to),
                patchy.not_stable,
                patchy.landings,
                share[0],
                share[1]
            );
        }
        if boundary.transition.is_some() {
            let below = number(boundary.stable_below as usize, "landing");
            text += &format!("  {below} below, all stable\n");
        }
        for band in &boundary.bands {
            text += &format!(
                "  {} from {} to {}\n",
                band.class,
                told(band.from),
                told(band.to)
            );
        }
        text += &format!(
            "  {}, {} derivative evaluations\n",
            number(boundary.landings as usize, "landing"),
            boundary.evaluations
        );
        if let Some((fps, landing)) = &self.landed {
            let beside = boundary.transition.map_or(String::new(), |found| {
                let beyond = fps - found.speed();
                let side = if beyond < 0.0 { "below" } else { "above" };
                format!(", {} {side} V_H", told(beyond.abs()))
            });
            text += &format!(
                "  at {}{beside}: {}, {}; least stability angle {} deg\n",
                told(*fps),
                landing.outcome,
                why(&landing.outcome),
                degrees(landing.min_stability_angle, 1)
            );
        }
        text
    }

    fn json(&self) -> Json {
        let (sweep, boundary) = (self.sweep, self.boundary);
        let (units, legs) = (sweep.units, sweep.leg_count());
        let bands = bands_table::numbered(boundary);
        let bands: Vec<_> = bands
            .map(|band| units.by_name(&bands_table::COLUMNS, &band, legs))
            .collect();
        let place = sweep.headings([]).into_iter().zip(sweep.cells_of_point(0));
        let place: Map<String, Json> = place
            .map(|(heading, cell)| {
                let quantity = units.quantity(&heading.name);
                (quantity.name().to_owned(), quantity.cell(cell).into())
            })
            .collect();
        let mut answer = json!({
            "program": results::program(env!("CARGO_PKG_VERSION")),
            "title": sweep.title,
            "at": place,
            "boundary": units.by_name(&results::COLUMNS, boundary, legs),
            "bands": bands,
        });
        if let Some((fps, landing)) = &self.landed {
            let speed = units.quantity(HORIZONTAL_VELOCITY);
            let mut results = units.by_name(&landing_table::COLUMNS, landing, legs);
            results.insert(speed.name().to_owned(), json!(speed.number(*fps)));
            answer["landing"] = results.into();
        }
        answer
    }
}
