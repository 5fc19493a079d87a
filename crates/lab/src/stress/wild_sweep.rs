//! Vehicles with three to eight legs under the rules of 1966 and under physical ones, and their wild landings as sweeps.

use std::path::Path;

use touchdown_dynamics::scene::Settings;
use touchdown_input::documents::input_error::InputError;
use touchdown_input::documents::library::{Library, Source};
use touchdown_input::readers::settings_input::RULES;
use touchdown_input::sweeps::sweep_file::Sweep;

use super::{SURVEYOR, SURVEYOR_FILE};

/// The rules that its vehicle file states.
const SURVEYOR_RULES: &str = "rules = \"1966\"";
const SWEEP: &str = include_str!("../../../../sweeps/stress/wild.toml");
/// Numbers of legs of the vehicles, among which landings are shared out.
const LEGS: [usize; 6] = [3, 4, 5, 6, 7, 8];

/// Wild landings of a vehicle.
pub struct WildSweep {
    pub legs: usize,
    /// Name of the rules that its file states.
    rules: &'static str,
    /// Text of its vehicle file.
    pub vehicle: String,
    pub sweep: Sweep,
}

impl WildSweep {
    /// The sweep that comes with the program, with another number of legs, other rules, and another count, seed and tolerance.
    fn read(
        (legs, rules): (usize, &'static str),
        count: u64,
        seed: u32,
        settings: Settings,
    ) -> Result<Self, InputError> {
        let scene = SWEEP.split("[sample]").next().unwrap_or(SWEEP);
        let text = format!(
            "{scene}[sample]\ndesign = \"monte-carlo\"\ncount = {count}\nseed = {seed}\n\
             [solver]\ntolerance = {}\n",
            settings.tolerance()
        );
        let vehicle = surveyor(legs, rules);
        // Its name is that of the journal.
        let file = format!("sweeps/stress/{}.toml", stem(legs, rules));
        let file = Path::new(&file);
        let source = |path: &Path, text: &str| Source {
            path: path.to_owned(),
            text: text.to_owned(),
        };
        let beside = file.parent().unwrap_or(Path::new(""));
        let sources = [
            source(file, &text),
            source(&beside.join("..").join(SURVEYOR_FILE), &vehicle),
        ];
        let sweep = Sweep::read_from(file, Library::Copies(&sources))?;
        Ok(Self {
            legs,
            rules,
            vehicle,
            sweep,
        })
    }

    /// The vehicle in words.
    pub fn title(&self) -> String {
        format!("{} legs under {} rules", self.legs, self.rules)
    }

    pub fn case_name(&self, number: usize) -> String {
        format!("{}-legs-{}-{number}", self.legs, self.rules)
    }

    pub fn vehicle_file(&self) -> String {
        format!("{}.toml", stem(self.legs, self.rules))
    }
}

fn stem(legs: usize, rules: &str) -> String {
    format!("stress-{legs}-legs-{rules}")
}

/// The Surveyor with so many of its legs, evenly round the centreline, under these rules.
fn surveyor(legs: usize, rules: &str) -> String {
    let body = SURVEYOR.split("[[legs]]").next().unwrap_or(SURVEYOR);
    let leg = |leg: usize| {
        let azimuth = 360.0 * leg as f64 / legs as f64;
        format!("[[legs]]\nazimuth_deg = {azimuth}\n")
    };
    let stated = SURVEYOR_RULES.replace("1966", rules);
    body.replace(SURVEYOR_RULES, &stated) + &(0..legs).map(leg).collect::<String>()
}

/// So many wild landings, shared out among the vehicles.
pub fn sweeps(count: u64, seed: u32, settings: Settings) -> Result<Vec<WildSweep>, InputError> {
    let vehicles = LEGS.map(|legs| RULES.map(|(rules, _)| (legs, rules)));
    let vehicles = vehicles.as_flattened();
    let among = vehicles.len() as u64;
    let shares = vehicles.iter().zip(0..among);
    let shares = shares.map(|(vehicle, place)| (*vehicle, (count + among - 1 - place) / among));
    let shares = shares.filter(|(_, share)| *share > 0);
    shares
        .map(|(vehicle, share)| WildSweep::read(vehicle, share, seed, settings))
        .collect()
}
