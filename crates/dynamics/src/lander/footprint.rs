//! The ground covered by a vehicle that stands with its struts extended.

use crate::invalid::{Invalid, require};
use crate::quantities::OFFSET;
use crate::quantity::check;

/// Keys of the CG's offset from the centreline, along x and y of vehicle axes.
const KEYS: [&str; 2] = [OFFSET[0].quantity.key, OFFSET[1].quantity.key];

/// Checks that a CG off the centreline is over the polygon of the feet (x and y of vehicle axes, ft). Beyond it a
/// vehicle falls over where it stands.
///
/// # Errors
/// Names the component to change and its range.
pub(super) fn check_offset(offset: [f64; 2], feet: &[[f64; 2]]) -> Result<(), Invalid> {
    check("", &OFFSET, &offset)?;
    let (greater, lesser) = match offset[0].abs() >= offset[1].abs() {
        true => (0, 1),
        false => (1, 0),
    };
    let across = feet.iter().map(|foot| foot[lesser]);
    within(lesser, offset, ends(across), "")?;
    // Every line between two feet is in the polygon, its edges among them.
    let crossings = feet.iter().flat_map(|a| {
        let crossing = |b: &[f64; 2]| {
            let part = (offset[lesser] - a[lesser]) / (b[lesser] - a[lesser]);
            (0.0..=1.0)
                .contains(&part)
                .then(|| a[greater] + part * (b[greater] - a[greater]))
        };
        feet.iter().filter_map(crossing).collect::<Vec<_>>()
    });
    let at = format!(" at {} = {}", KEYS[lesser], offset[lesser]);
    within(greater, offset, ends(crossings), &at)
}

/// Least and greatest.
fn ends(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold(
        [f64::INFINITY, f64::NEG_INFINITY],
        |[least, most], value| [least.min(value), most.max(value)],
    )
}

fn within(
    component: usize,
    offset: [f64; 2],
    [least, most]: [f64; 2],
    at: &str,
) -> Result<(), Invalid> {
    let allowed = format!(
        "{least:.4} < value < {most:.4}, which keeps the CG over the polygon of the feet{at}"
    );
    require(KEYS[component], offset[component], &allowed, |value| {
        least < value && value < most
    })
    .map(|_| ())
}
