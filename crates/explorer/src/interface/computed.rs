//! A map that a page computes place by place, as the table that it has so far.

use serde::Deserialize;
use serde_json::{Map, Value, json};
use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_input::documents::column::headings;
use touchdown_input::points::parameter::Parameter;
use touchdown_input::readers::scene_input::HORIZONTAL_VELOCITY;
use touchdown_input::readers::settings_input::solver_in_record;
use touchdown_input::sweeps::resolved_input;
use touchdown_sweep::output::results::COLUMNS;

use super::complaint::Complaint;
use super::request::Asked;
use super::strip::range;
use super::touchdown::Touchdown;
use crate::named::{Named, Results, ResultsKind};

/// Name of its table.
const NAME: &str = "map";

/// The slow and the fast axis.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
pub struct Axes([String; 2]);

/// A map as far as it is computed.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Computed {
    /// The touchdown, at whatever place.
    #[serde(default)]
    pub touchdown: Asked,
    axes: Axes,
    from_fps: Option<f64>,
    to_fps: Option<f64>,
    table: String,
}

impl Axes {
    /// Names, the slow axis first.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(String::as_str)
    }

    /// Checks that these are two numbers of a touchdown, other than V_H.
    ///
    /// # Errors
    /// If they are not.
    pub fn check(&self) -> Result<(), Complaint> {
        let [slow, fast] = [0, 1].map(|axis| Parameter::named(&self.0[axis], MOST_LEGS));
        let is_axis =
            |one: &Parameter| one.program_name() != HORIZONTAL_VELOCITY && one.words().is_empty();
        match (slow, fast) {
            (Some(slow), Some(fast)) if slow != fast && is_axis(&slow) && is_axis(&fast) => Ok(()),
            _ => {
                let allowed = "two different numbers of the touchdown or the vehicle, and not V_H";
                Err(Complaint::value("axes", json!(self.0), allowed))
            }
        }
    }

    /// First line of the table.
    pub fn heading(&self) -> String {
        let columns = headings(&COLUMNS, 0).map(|heading| heading.name);
        let names: Vec<String> = (self.0.iter().cloned()).chain(columns).collect();
        names.join(",")
    }
}

impl Computed {
    /// The table with a record of the touchdown, as a sweep would leave them.
    ///
    /// # Errors
    /// If the touchdown or the table is not one.
    pub fn results(&self, named: &Named) -> Result<Results, Complaint> {
        self.axes.check()?;
        let heading = self.axes.heading();
        if self.table.lines().next() != Some(&heading) {
            let allowed = format!("a table that begins with {heading}");
            return Err(Complaint::value("computed.table", "…", &allowed));
        }
        let touchdown = Touchdown::of(named, &self.touchdown)?;
        let [from, to] = range(&touchdown, self.from_fps, self.to_fps)?;
        let axes = [0, 1].map(|axis| Parameter::named(&self.axes.0[axis], MOST_LEGS));
        let is_varied = |name: &str| {
            let mut axes = axes.iter().flatten();
            name == HORIZONTAL_VELOCITY || axes.any(|axis| axis.program_name() == name)
        };
        let scene: Map<String, Value> = (touchdown.conditions.resolved().into_iter())
            .filter(|(name, _)| !is_varied(name))
            .map(|(name, value)| (name.to_owned(), json!(value)))
            .collect();
        let record = json!({
            "title": touchdown.source.title,
            "input": {
                "vehicle": resolved_input::vehicle(&touchdown.vehicle.document),
                "scene": scene,
                "search": {"from_fps": from, "to_fps": to},
                "solver": solver_in_record(&touchdown.settings, &touchdown.vehicle.vehicle),
            },
        });
        Ok(Results {
            name: NAME.to_owned(),
            file: format!("{NAME}.csv"),
            kind: ResultsKind::Map,
            axes: self.axes.0.to_vec(),
            points: self.table.lines().count() - 1,
            source: Some(touchdown.source.name.clone()),
            table: self.table.clone(),
            bands: None,
            surface: None,
            edges: None,
            record: Some(record.to_string()),
        })
    }
}
