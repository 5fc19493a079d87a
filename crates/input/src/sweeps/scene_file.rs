//! Scene files: a touchdown, and cases that list only their differences from the case before, like the report's stacked
//! decks.
//!
//! A case may change any touchdown condition, `vehicle.…` and `solver.…` by dotted keys, and the vehicle file. An
//! attitude in the other form replaces the earlier one completely.

use std::path::{Path, PathBuf};

use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_dynamics::scene::{Scene, Settings};

use crate::documents::document::{Document, Value};
use crate::documents::input_error::{InputError, Place};
use crate::documents::library::Library;
use crate::documents::output_units::{OutputUnits, UNITS};
use crate::documents::section::{LocatedValue, Section};
use crate::documents::spelling::did_you_mean;
use crate::points::parameter::{Home, Parameter};
use crate::readers::scene_input::{self, NamedConditions, SceneFault};
use crate::readers::settings_input;
use crate::readers::vehicle_file::{self, VehicleFile};
use crate::sweeps::sweep_file::{VEHICLE, locate_condition, named_vehicle};

pub(crate) const SCENE_FILE: [&str; 6] = ["title", UNITS, "vehicle", "scene", "solver", "case"];
/// Keys of a case that are not parameters.
pub(crate) const CASE: [&str; 2] = ["name", "vehicle"];
const CASES: &str = "tables [[case]]";
const NAME: &str = "letters, digits, - and _ in quotes, not the name of a case before";

/// A scene file.
#[derive(Debug, Clone)]
pub struct SceneFile {
    /// Units of written and printed results.
    pub units: OutputUnits,
    /// The cases in order, or the single touchdown of a file without cases.
    pub cases: Vec<SceneCase>,
}

/// One landing of a scene file.
#[derive(Debug, Clone)]
pub struct SceneCase {
    /// Name, used in file names: the one in the file, or else its number.
    pub name: String,
    /// The vehicle.
    pub vehicle: VehicleFile,
    /// The touchdown.
    pub scene: Scene,
    /// Its conditions by name.
    pub conditions: NamedConditions,
    /// The scene file with the solver of this case.
    pub document: Document,
    /// Settings of the landing.
    pub settings: Settings,
}

/// Reads a scene file and the vehicle files that it names.
///
/// # Errors
/// Names file, line, case, key and value of the first fault, and the allowed values.
pub fn read(path: &Path) -> Result<SceneFile, InputError> {
    read_from(path, Library::Disk)
}

/// Reads a scene file and its vehicle files from a library.
///
/// # Errors
/// As [`read`].
pub fn read_from(path: &Path, library: Library) -> Result<SceneFile, InputError> {
    let document = Document::read_from(path, library)?;
    let root = Section::root(&document, &SCENE_FILE)?;
    if let Some(title) = root.optional("title") {
        title.text()?;
    }
    let units = OutputUnits::read(&root)?;
    let scene = root.section("scene", &scene_input::scene_keys())?;
    let stack = Stack::of(path, library, &document, &root, &scene)?;
    let cases = cases(&root, &scene, stack)?;
    Ok(SceneFile { units, cases })
}

fn cases(root: &Section, scene: &Section, mut stack: Stack) -> Result<Vec<SceneCase>, InputError> {
    let Some(found) = root.optional("case") else {
        return Ok(vec![stack.case("1".to_owned(), None, scene)?]);
    };
    let entries = found.items(CASES)?;
    if entries.is_empty() {
        return Err(found.complain(CASES));
    }
    let mut cases: Vec<SceneCase> = Vec::new();
    for (index, entry) in entries.iter().enumerate() {
        let changes = Changes::of(entry, index + 1)?;
        let name = match &changes.name {
            None => {
                let number = (index + 1).to_string();
                if cases.iter().any(|case| case.name == number) {
                    let said = format!("has no name, and another case is named {number}");
                    return Err(changes.complain(InputError::other(said), None));
                }
                number
            }
            Some(found) => {
                let name = found.text()?;
                let is_plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_');
                let is_fit = !name.is_empty() && name.chars().all(is_plain);
                if !is_fit || cases.iter().any(|case| case.name == name) {
                    return Err(found.complain(NAME));
                }
                name.to_owned()
            }
        };
        stack.change(&changes)?;
        cases.push(stack.case(name, Some(&changes), scene)?);
    }
    Ok(cases)
}

/// Changes that a case makes.
struct Changes<'d> {
    number: usize,
    place: Place,
    name: Option<LocatedValue<'d>>,
    vehicle: Option<LocatedValue<'d>>,
    parameters: Vec<(Parameter, LocatedValue<'d>)>,
}

impl<'d> Changes<'d> {
    fn of(entry: &LocatedValue<'d>, number: usize) -> Result<Self, InputError> {
        let mut changes = Self {
            number,
            place: entry.here(),
            name: None,
            vehicle: None,
            parameters: Vec::new(),
        };
        for (name, found) in entry.leaves()? {
            let [own_name, own_vehicle] = CASE;
            match (name.as_str(), &found.node.value) {
                (key, _) if key == own_name => changes.name = Some(found),
                (key, Value::Text(_)) if key == own_vehicle => changes.vehicle = Some(found),
                _ => {
                    let parameter = Parameter::named(&name, MOST_LEGS)
                        .filter(|known| !known.name().starts_with("search."));
                    let Some(parameter) = parameter else {
                        return Err(found.complain_that(&unknown(&name, MOST_LEGS)));
                    };
                    let mut before = changes.parameters.iter();
                    if let Some((other, _)) = before.find(|(other, _)| *other == parameter) {
                        let other = other.name();
                        let said = format!("said twice: expected one of {other} and {name}");
                        return Err(found.complain_that(&said));
                    }
                    changes.parameters.push((parameter, found));
                }
            }
        }
        Ok(changes)
    }

    /// First value of the case in a part of the input, if any.
    fn first_of(&self, part: Home) -> Option<&LocatedValue<'d>> {
        let vehicle = self.vehicle.as_ref().filter(|_| part == Home::Vehicle);
        let own = || self.parameters.iter().find(|(p, _)| p.home() == part);
        vehicle.or_else(|| own().map(|(_, found)| found))
    }

    /// Attributes an error in a part of the input to this case.
    fn blame(&self, part: Home, error: InputError) -> InputError {
        self.complain(error, self.first_of(part))
    }

    /// Attributes a fault of the scene to this case.
    fn blame_condition(&self, fault: &SceneFault) -> InputError {
        let said = (self.parameters.iter()).find(|(p, _)| p.program_name() == fault.name);
        let error = match (fault.value, said) {
            (Some(_), Some((parameter, found))) => {
                let allowed = parameter.allowed(fault);
                InputError::value(parameter.name(), &found.node.written, &allowed)
            }
            _ => fault.error(),
        };
        self.complain(error, said.map(|(_, found)| found))
    }

    fn complain(&self, error: InputError, found: Option<&LocatedValue>) -> InputError {
        let place = found.map_or_else(|| self.place.clone(), LocatedValue::here);
        error.within(&format!("case {}", self.number)).at(place)
    }
}

fn unknown(name: &str, legs: usize) -> String {
    let mut alike = Parameter::nearest(name, legs);
    alike.retain(|name| !name.starts_with("search."));
    let guess = did_you_mean(&alike);
    format!(
        "unknown key of a case; {guess}expected name, vehicle, a key of the scene, or a dotted key of the vehicle or \
         the solver, such as vehicle.strut.compression_damping"
    )
}

/// The input after the changes of all cases so far.
struct Stack<'l> {
    path: PathBuf,
    library: Library<'l>,
    /// The scene file, from which the solver settings are read.
    document: Document,
    vehicle: Document,
    conditions: NamedConditions,
}

impl<'l> Stack<'l> {
    fn of(
        path: &Path,
        library: Library<'l>,
        document: &Document,
        root: &Section,
        scene: &Section,
    ) -> Result<Self, InputError> {
        let vehicle = named_vehicle(&root.value("vehicle", VEHICLE)?, path, library)?;
        let conditions = NamedConditions::read(scene)?;
        // Errors in these files are reported for the files, not for the first case.
        settings_input::settings_of_landing(root)?;
        VehicleFile::from_document(vehicle.clone())?;
        Ok(Self {
            path: path.to_owned(),
            library,
            document: document.clone(),
            vehicle,
            conditions,
        })
    }

    fn change(&mut self, changes: &Changes) -> Result<(), InputError> {
        if let Some(found) = &changes.vehicle {
            self.vehicle = named_vehicle(found, &self.path, self.library)?;
        }
        let scene = changes
            .parameters
            .iter()
            .filter(|(p, _)| p.home() == Home::Scene);
        let names: Vec<&str> = scene
            .map(|(parameter, _)| parameter.program_name())
            .collect();
        self.conditions.replace_attitude_form(&names);
        for (parameter, found) in &changes.parameters {
            let value = match parameter.words() {
                [] => Value::Number(parameter.to_program(found.number()?)),
                words => match found.text() {
                    Ok(word) if words.contains(&word) => Value::Text(word.to_owned()),
                    _ => return Err(found.complain(&format!("one of {words:?}"))),
                },
            };
            match (parameter.home(), &value) {
                (Home::Scene, Value::Number(number)) => {
                    self.conditions.set(parameter.program_name(), *number);
                }
                (Home::Vehicle, _) => {
                    vehicle_file::write(
                        &mut self.vehicle,
                        parameter.name(),
                        parameter.path(),
                        value,
                    )
                    .map_err(|error| changes.complain(error, Some(found)))?;
                }
                _ => {
                    self.document.write(parameter.path(), value);
                }
            }
        }
        Ok(())
    }

    fn case(
        &self,
        name: String,
        changes: Option<&Changes>,
        scene: &Section,
    ) -> Result<SceneCase, InputError> {
        let blame = |part: Home| {
            move |error: InputError| match changes {
                Some(changes) => changes.blame(part, error),
                None => error,
            }
        };
        let vehicle = VehicleFile::from_document(self.vehicle.clone());
        let vehicle = vehicle.map_err(blame(Home::Vehicle))?;
        let settings = Section::root(&self.document, &SCENE_FILE)
            .and_then(|root| settings_input::settings_of_landing(&root));
        let settings = settings.map_err(blame(Home::Sweep))?;
        let touchdown = self.conditions.scene_for(&vehicle.vehicle, &settings);
        let touchdown = touchdown.map_err(|fault| match changes {
            Some(changes) => changes.blame_condition(&fault),
            None => locate_condition(&fault, scene, &[]),
        })?;
        Ok(SceneCase {
            name,
            vehicle,
            scene: touchdown,
            conditions: self.conditions,
            document: self.document.clone(),
            settings,
        })
    }
}

#[cfg(test)]
#[path = "scene_file_tests.rs"]
mod tests;
