//! The touchdown of a request: a source with replaced numbers.

use std::path::Path;

use serde_json::Value as Json;
use touchdown_dynamics::method::Method;
use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_input::documents::document::{Document, Entry, Value};
use touchdown_input::documents::input_error::InputError;
use touchdown_input::points::assignment::{self, Assignment};
use touchdown_input::points::parameter::{Home, Parameter};
use touchdown_input::readers::scene_input::{NamedConditions, SceneFault};
use touchdown_input::readers::vehicle_file::VehicleFile;
use touchdown_input::sweeps::single_landing;

use super::complaint::Complaint;
use super::request::Asked;
use crate::named::{Named, Source};

/// Greatest time limit of a landing here, s, as a page waits for it.
const LONGEST: f64 = 1000.0;

/// A touchdown ready to be computed.
#[derive(Debug)]
pub struct Touchdown<'n> {
    /// Starting point.
    pub source: &'n Source,
    /// Assignments that replace numbers of the source.
    pub set: Vec<Assignment>,
    /// Vehicle.
    pub vehicle: VehicleFile,
    /// Touchdown conditions by name.
    pub conditions: NamedConditions,
    /// The table `[solver]`.
    pub solver: Document,
    /// Settings of the landing.
    pub settings: Settings,
}

impl<'n> Touchdown<'n> {
    /// Reads the touchdown of a request.
    ///
    /// # Errors
    /// Names the first value that is unknown or not allowed.
    pub fn of(named: &'n Named, asked: &Asked) -> Result<Self, Complaint> {
        let source = source(named, asked.source.as_deref())?;
        let set = asked
            .values
            .iter()
            .map(|(name, value)| assigned(name, value));
        let set: Vec<Assignment> = set.collect::<Result<_, _>>()?;
        if let Some(twice) = (1..set.len()).find(|&index| {
            let parameter = set[index].parameter();
            set[..index]
                .iter()
                .any(|other| other.parameter() == parameter)
        }) {
            let name = set[twice].parameter().name();
            return Err(Complaint::request(format!("{name}: given under two names")).about(name));
        }
        let vehicle = vehicle(source, asked.vehicle.as_deref(), &set)?;
        let mut conditions = source.conditions;
        let names: Vec<&str> = (set.iter())
            .map(|one| one.parameter().program_name())
            .collect();
        conditions.replace_attitude_form(&names);
        assignment::set_conditions(&mut conditions, &set);
        let mut solver = source.solver.clone();
        for one in set.iter().filter(|one| is_of_solver(one.parameter())) {
            solver.write(one.path(), one.value());
        }
        let settings =
            single_landing::settings(&solver).map_err(|error| under_names(error, "", &set))?;
        if settings.method() != Method::Located {
            let allowed = "located: the explorer computes landings by no other method";
            let method = touchdown_input::readers::method_input::method_name(&settings.method());
            return Err(Complaint::value("solver.method", method, allowed));
        }
        if settings.time_limit() > LONGEST {
            let allowed = format!("at most {LONGEST} s in the explorer");
            return Err(Complaint::value(
                "solver.time_limit_s",
                settings.time_limit(),
                &allowed,
            ));
        }
        Ok(Self {
            source,
            set,
            vehicle,
            conditions,
            solver,
            settings,
        })
    }

    /// The scene.
    ///
    /// # Errors
    /// Names the first condition that is missing or not allowed.
    pub fn scene(&self) -> Result<Scene, Complaint> {
        let (vehicle, settings) = (&self.vehicle.vehicle, &self.settings);
        (self.conditions.scene_for(vehicle, settings)).map_err(|fault| self.complain(&fault))
    }

    /// Entries of the table `[solver]`.
    pub fn solver_entries(&self) -> &[Entry] {
        match self.solver.root() {
            [table] => match &table.node.value {
                Value::Table(entries) => entries,
                _ => &[],
            },
            _ => &[],
        }
    }

    /// True if a key of the solver is given.
    pub fn gives_solver(&self, key: &str) -> bool {
        self.solver_entries().iter().any(|entry| entry.key == key)
    }

    fn complain(&self, fault: &SceneFault) -> Complaint {
        let given = (self.set.iter()).find(|one| one.parameter().program_name() == fault.name);
        match (given, fault.value) {
            (Some(one), Some(_)) => {
                let parameter = one.parameter();
                let allowed = match one.text().parse() {
                    Ok(number) => parameter.explain(&fault.allowed, number),
                    Err(_) => fault.allowed.clone(),
                };
                Complaint::value(parameter.name(), one.text(), &allowed)
            }
            _ => fault.error().into(),
        }
    }
}

/// Finds a source by name.
///
/// # Errors
/// If there is none.
pub fn source<'n>(named: &'n Named, name: Option<&str>) -> Result<&'n Source, Complaint> {
    named.source(name).ok_or_else(|| {
        let known: Vec<&str> = named.sources.iter().map(|one| one.name.as_str()).collect();
        let name = format!("{:?}", name.unwrap_or_default());
        Complaint::value("source", name, &format!("one of {}", known.join(", ")))
    })
}

/// True for a parameter of the solver.
pub fn is_of_solver(parameter: &Parameter) -> bool {
    parameter.program_name().starts_with("solver.")
}

fn assigned(name: &str, value: &Json) -> Result<Assignment, Complaint> {
    let text = match value {
        Json::Number(number) => number.as_f64().map(|number| number.to_string()),
        Json::String(text) => Some(text.clone()),
        _ => None,
    };
    let Some(text) = text else {
        return Err(Complaint::value(
            name,
            value,
            "a number, or a word in quotes",
        ));
    };
    let known = Parameter::named(name, MOST_LEGS);
    if known.is_some_and(|known| known.home() == Home::Sweep && !is_of_solver(&known)) {
        let allowed = "a number of the touchdown, the vehicle or the solver";
        return Err(Complaint::value(name, text, allowed));
    }
    Assignment::new(name, &text).map_err(|error| Complaint::from(error).about(name))
}

fn vehicle(
    source: &Source,
    text: Option<&str>,
    set: &[Assignment],
) -> Result<VehicleFile, Complaint> {
    let own;
    let file = match text {
        None => &source.vehicle,
        Some(text) => {
            let document = Document::parse(Path::new("vehicle"), text)?;
            own = VehicleFile::from_document(document)?;
            &own
        }
    };
    if set
        .iter()
        .all(|one| one.parameter().home() != Home::Vehicle)
    {
        return Ok(file.clone());
    }
    let legs = file.vehicle.leg_count();
    let is_absent = |one: &&Assignment| Parameter::named(one.parameter().name(), legs).is_none();
    if let Some(one) = set.iter().find(is_absent) {
        let allowed = format!("the number of a leg: the vehicle has {legs}");
        return Err(Complaint::value(
            one.parameter().name(),
            one.text(),
            &allowed,
        ));
    }
    let document = assignment::vehicle_document(file.document.clone(), set)?;
    VehicleFile::from_document(document)
        .map_err(|error| under_names(error.nowhere(), "vehicle.", set))
}

/// Converts an error of a document about a key to the name that the request used.
fn under_names(error: InputError, home: &str, set: &[Assignment]) -> Complaint {
    let complaint = Complaint::from(error);
    let Some(key) = &complaint.key else {
        return complaint;
    };
    let bare = key.split(" (").next().unwrap_or(key);
    let full = format!("{home}{bare}");
    let named = Parameter::named(&full, MOST_LEGS);
    let given = set
        .iter()
        .find(|one| Some(one.parameter()) == named.as_ref());
    match (given, &complaint.allowed) {
        (Some(one), Some(allowed)) if matches!(one.value(), Value::Number(_)) && bare == key => {
            let parameter = one.parameter();
            let allowed = match one.text().parse() {
                Ok(number) => parameter.explain(allowed, number),
                Err(_) => allowed.clone(),
            };
            Complaint::value(parameter.name(), one.text(), &allowed)
        }
        _ => {
            let message = format!("{home}{}", complaint.message);
            Complaint {
                message,
                ..complaint
            }
            .about(&full)
        }
    }
}
