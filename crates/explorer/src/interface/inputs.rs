//! `inputs`: lists the named sources and results.

use serde::Deserialize;
use serde_json::{Value, json};
use touchdown_dynamics::outcome::Class;
use touchdown_sweep::output::results::program;

use super::complaint::Complaint;
use super::map::title;
use super::request::{class_words, read, written};
use crate::named::{Named, Results, Source};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {}

pub fn answer(named: &Named, request: &str) -> Result<String, Complaint> {
    let Request {} = read(request)?;
    let sources: Vec<Value> = named.sources.iter().map(source).collect();
    let results: Vec<Value> = (named.results.iter())
        .map(|one| results(named, one))
        .collect();
    written(&json!({
        "program": program(env!("CARGO_PKG_VERSION")),
        "units": named.units.to_string(),
        "sources": sources,
        "results": results,
        "classes": Class::ALL.map(class_words),
    }))
}

fn source(source: &Source) -> Value {
    let [from, to] = source.search;
    json!({
        "name": source.name,
        "title": source.title,
        "file": source.file,
        "kind": source.kind.word(),
        "legs": source.vehicle.vehicle.leg_count(),
        "search": {"from_fps": from, "to_fps": to},
    })
}

fn results(named: &Named, results: &Results) -> Value {
    json!({
        "name": results.name,
        "title": title(results),
        "file": results.file,
        "kind": results.kind.word(),
        "source": named.source_of(results),
        "axes": results.axes,
        "points": results.points,
    })
}
