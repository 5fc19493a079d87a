//! Vehicles with three to six legs, and their wild landings as sweeps.

use std::path::Path;

use touchdown_dynamics::scene::Settings;
use touchdown_sweep::input_error::InputError;
use touchdown_sweep::library::{Library, Source};
use touchdown_sweep::sweep_file::Sweep;

use super::{SURVEYOR, SURVEYOR_FILE};

const SWEEP: &str = include_str!("../../../../sweeps/stress/wild.toml");
/// Numbers of legs of the vehicles, among which landings are shared out.
const LEGS: [usize; 4] = [3, 4, 5, 6];
/// Wild landings of a vehicle.
pub struct WildSweep {
    pub legs: usize,
    /// Text of its vehicle file.
    pub vehicle: String,
    pub sweep: Sweep,
}

impl WildSweep {
    /// The sweep that comes with the program, with another number of legs and another count, seed and tolerance.
    fn read(legs: usize, count: u64, seed: u32, settings: Settings) -> Result<Self, InputError> {
        const FILE: &str = "sweeps/stress/wild.toml";
        let scene = SWEEP.split("[sample]").next().unwrap_or(SWEEP);
        let text = format!(
            "{scene}[sample]\ndesign = \"monte-carlo\"\ncount = {count}\nseed = {seed}\n\
             [solver]\ntolerance = {}\n",
            settings.tolerance()
        );
        let vehicle = surveyor(legs);
        let file = Path::new(FILE);
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
            vehicle,
            sweep,
        })
    }

    pub fn case_name(&self, number: usize) -> String {
        format!("{}-legs-{number}", self.legs)
    }

    pub fn vehicle_file(&self) -> String {
        format!("stress-{}-legs.toml", self.legs)
    }

    pub fn journal_file(&self) -> String {
        format!("stress-{}-legs.journal", self.legs)
    }
}

/// The Surveyor with so many of its legs, evenly round the centreline.
fn surveyor(legs: usize) -> String {
    let body = SURVEYOR.split("[[legs]]").next().unwrap_or(SURVEYOR);
    let leg = |leg: usize| {
        let azimuth = 360.0 * leg as f64 / legs as f64;
        format!("[[legs]]\nazimuth_deg = {azimuth}\n")
    };
    body.to_owned() + &(0..legs).map(leg).collect::<String>()
}

/// So many wild landings, shared out among the vehicles.
pub fn sweeps(count: u64, seed: u32, settings: Settings) -> Result<Vec<WildSweep>, InputError> {
    let among = LEGS.len() as u64;
    let shares = LEGS.iter().zip(0..among);
    let shares = shares.map(|(legs, place)| (*legs, (count + among - 1 - place) / among));
    let shares = shares.filter(|(_, share)| *share > 0);
    shares
        .map(|(legs, share)| WildSweep::read(legs, share, seed, settings))
        .collect()
}
