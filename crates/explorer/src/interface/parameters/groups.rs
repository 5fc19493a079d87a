//! Display groups of parameters.

use touchdown_dynamics::quantity::Quantity;

/// All groups, in display order.
const ORDER: [&str; 16] = [
    "touchdown",
    "attitude",
    "ground",
    "soil",
    "thrust",
    "body",
    "inertia",
    "linkage",
    "strut",
    "primary",
    "secondary",
    "footpad",
    "block",
    "azimuth",
    "footing",
    "solver",
];
/// Position of a group.
pub fn place(group: &str) -> usize {
    let place = ORDER.iter().position(|known| *known == group);
    place.unwrap_or(ORDER.len())
}

/// Group of a parameter, and the number of the leg if it is one leg's own.
pub fn of(name: &str, quantity: &Quantity) -> (&'static str, Option<usize>) {
    let leg = |rest: &str| {
        rest.split(']')
            .next()
            .and_then(|number| number.parse().ok())
    };
    if let Some(rest) = name.strip_prefix("footing[") {
        return ("footing", leg(rest));
    }
    for table in ["thrust", "soil"] {
        if name
            .split_once('.')
            .is_some_and(|(start, _)| start == table)
        {
            return (table, None);
        }
    }
    let Some(path) = name.strip_prefix("vehicle.") else {
        return (quantity.group.unwrap_or("touchdown"), None);
    };
    let (path, leg) = match path
        .strip_prefix("legs[")
        .and_then(|rest| rest.split_once("]."))
    {
        Some((number, path)) => (path, number.parse().ok()),
        None => (path, None),
    };
    let group = match path.split('.').next().unwrap_or_default() {
        "inertia_slug_ft2" => "inertia",
        "linkage" => "linkage",
        "strut" => "strut",
        "primary" => "primary",
        "secondary" => "secondary",
        "footpad" => "footpad",
        "block" => "block",
        "azimuth_deg" => "azimuth",
        _ => "body",
    };
    (group, leg)
}
