//! The full input of a sweep with defaults filled in, as a tree of names and values.

use serde_json::{Map, Value, json};

use crate::documents::document::{Document, Entry, Value as Read};
use crate::documents::spelling::{Conversion, conversion};
use crate::points::design::Design;
use crate::points::distribution::Distribution;
use crate::points::levels::{Levels, rounded};
use crate::points::parameter::Parameter;
use crate::points::sample::SampledAxis;
use crate::readers::choice::word;
use crate::readers::scene_input::NamedConditions;
use crate::readers::search_input::{DOUBTS, EXTENTS, REFINEMENTS, SCANS};
use crate::readers::settings_input::solver_in_record;
use crate::readers::vehicle_file;
use crate::sweeps::sweep_file::{Job, Sweep};

/// Longest axis whose values are listed individually.
const MOST_VALUES: usize = 1000;

impl Sweep {
    /// Everything that determines the results, and nothing else: no title, no file names.
    pub fn resolved(&self) -> Value {
        let mut scene = scene(&self.fixed);
        scene.retain(|name, _| self.axes.iter().all(|axis| axis.program_name() != name));
        let mut input = json!({
            "job": match self.job {
                Job::Boundary(_) => "boundary",
                Job::Outcome { .. } => "outcome",
            },
            "vehicle": vehicle(&self.vehicle.document),
            "scene": scene,
            "axes": self.axes_resolved(),
            "axes_that_move_together": self.together(),
            "solver": solver_in_record(&self.settings, &self.vehicle.vehicle),
        });
        match self.job {
            Job::Boundary(search) => {
                input["search"] = json!({
                    "from_fps": search.from,
                    "to_fps": search.to,
                    "scan_step_fps": search.scan_step,
                    "parts_below": search.parts_below,
                    "tolerance_fps": search.tolerance,
                    "bands": word(&EXTENTS, search.extent),
                    "scan": word(&SCANS, search.scan),
                    "scan_looseness": search.scan_looseness,
                    "refinement": word(&REFINEMENTS, search.refinement),
                    "certainty": word(&DOUBTS, search.doubt),
                });
                if search.kept > 0.0 {
                    input["search"]["keep_deg"] = json!(rounded(search.kept.to_degrees()));
                }
            }
            Job::Outcome { enough } => input["stop_at_interval_width"] = json!(enough),
        }
        if !self.sensitivity.is_empty() {
            let names = self.sensitivity.iter().map(Parameter::name);
            input["sensitivity"] = names.collect();
        }
        if let Some(map) = self.map() {
            let named = map
                .axes()
                .iter()
                .map(|&axis| self.axes[axis].name().to_owned());
            let parts: Map<String, Value> = named
                .zip(map.parts())
                .map(|(name, parts)| (name, json!(parts)))
                .collect();
            input["map"] = json!({
                "parts_of_first_level": parts,
                "error_fps": map.rules.error,
                "jump_fps": map.rules.jump,
                "budget_landings": map.rules.budget,
                "grid_steps": map.rules.grid_steps,
            });
        }
        if let Design::Sample(sample) = &self.design {
            input["sample"] = json!({
                "design": sample.design().name(),
                "count": sample.count(),
                "seed": sample.seed(),
            });
        }
        input
    }

    fn axes_resolved(&self) -> Map<String, Value> {
        let value = |(index, axis): (usize, &Parameter)| {
            let value = match &self.design {
                Design::Grid(grid) => levels_of(axis, &grid.axes()[index]),
                Design::Map(map) => levels_of(axis, &map.first_level().axes()[index]),
                Design::Sample(sample) => self.sampled_axis(&sample.axes()[index]),
            };
            (axis.name().to_owned(), value)
        };
        self.axes.iter().enumerate().map(value).collect()
    }

    fn sampled_axis(&self, axis: &SampledAxis) -> Value {
        match axis {
            SampledAxis::Single { distribution, .. } => distribution_of(distribution),
            SampledAxis::Joint {
                mean, covariances, ..
            } => {
                let covariances = covariances
                    .iter()
                    .map(|(other, value)| (self.axes[*other].name().to_owned(), json!(value)));
                let covariances: Map<String, Value> = covariances.collect();
                json!({"jointly-normal": {"mean": mean, "covariance": covariances}})
            }
        }
    }

    /// Names of axes that move together, group by group.
    fn together(&self) -> Vec<Vec<&str>> {
        let groups: Vec<Vec<usize>> = match &self.design {
            Design::Grid(grid) => grid.dimensions().to_vec(),
            Design::Map(map) => map.first_level().dimensions().to_vec(),
            Design::Sample(sample) => {
                let mut groups = vec![Vec::new(); sample.axes().len()];
                for (index, axis) in sample.axes().iter().enumerate() {
                    if let SampledAxis::Single { number, .. } = axis {
                        groups[*number].push(index);
                    }
                }
                groups
            }
        };
        let name = |axis: &usize| self.axes[*axis].name();
        groups
            .iter()
            .filter(|together| together.len() > 1)
            .map(|together| together.iter().map(name).collect())
            .collect()
    }
}

/// Conditions, including defaults.
pub(crate) fn scene(conditions: &NamedConditions) -> Map<String, Value> {
    let mut scene: Map<String, Value> = (conditions.resolved().into_iter())
        .map(|(name, value)| (name.to_owned(), json!(value)))
        .collect();
    let knots = conditions.thrust_knots();
    if !knots.is_empty() {
        for (index, name) in ["thrust.time_s", "thrust.force_lb"].into_iter().enumerate() {
            let values: Value = knots.iter().map(|knot| knot[index]).collect();
            scene.insert(name.to_owned(), values);
        }
    }
    scene
}

fn distribution_of(distribution: &Distribution) -> Value {
    match distribution {
        Distribution::Uniform { from, to } => json!({"uniform": {"from": from, "to": to}}),
        Distribution::LogUniform { from, to } => json!({"log-uniform": {"from": from, "to": to}}),
        Distribution::Normal { mean, deviation } => {
            json!({"normal": {"mean": mean, "sd": deviation}})
        }
        Distribution::Truncated {
            mean,
            deviation,
            from,
            to,
        } => json!({"normal": {"mean": mean, "sd": deviation, "from": from, "to": to}}),
        Distribution::Lognormal { mean, deviation } => {
            json!({"lognormal": {"mean": mean, "sd": deviation}})
        }
        Distribution::Rayleigh { sigma } => json!({"rayleigh": {"sigma": sigma}}),
        Distribution::Triangular { from, mode, to } => {
            json!({"triangular": {"from": from, "mode": mode, "to": to}})
        }
        Distribution::Column(values) => json!({"column": values}),
    }
}

/// Values of an axis, with words as words; ends and count of a long axis.
fn levels_of(axis: &Parameter, levels: &Levels) -> Value {
    let value = |value: f64| match axis.word(value) {
        Some(word) => json!(word),
        None => json!(value),
    };
    match levels {
        Levels::List(_) => levels.values().map(value).collect(),
        short if short.count() <= MOST_VALUES => levels.values().map(value).collect(),
        Levels::Range { from, step, count } => json!({"from": from, "step": step, "count": count}),
        Levels::Even { from, to, count } => json!({"from": from, "to": to, "count": count}),
        Levels::Logarithmic { from, to, count } => {
            json!({"from": from, "to": to, "count": count, "spacing": "log"})
        }
    }
}

/// A vehicle file as a tree, in program units.
pub fn vehicle(document: &Document) -> Value {
    tree(document.root(), Conversion::NONE)
}

fn tree(entries: &[Entry], above: Conversion) -> Value {
    let fields = entries.iter().map(|entry| {
        let known = vehicle_file::KEYS.iter().copied().flatten();
        let (key, own) = known
            .filter_map(|key| Some((*key, conversion(&entry.key, key)?)))
            .next()
            .unwrap_or((&entry.key, Conversion::NONE));
        (key.to_owned(), value(&entry.node.value, own.or(above)))
    });
    Value::Object(fields.collect())
}

fn value(read: &Read, conversion: Conversion) -> Value {
    match read {
        Read::Number(number) => json!(conversion.to_program(*number)),
        Read::Text(text) => json!(text),
        Read::List(nodes) => (nodes.iter())
            .map(|node| value(&node.value, conversion))
            .collect(),
        Read::Table(entries) => tree(entries, conversion),
        Read::Foreign => Value::Null,
    }
}
