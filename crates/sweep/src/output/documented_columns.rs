//! All columns of all tables, as `docs/output.md` lists them.

use touchdown_input::documents::column::{Column, described};
use touchdown_input::documents::history_columns::{OF_BODY, OF_LEG};

use crate::output::map_tables::{EDGE_COLUMNS, GRID_COLUMNS, SURFACE_COLUMNS};
use crate::output::{bands_table, landing_table, results, sensitivity_table};
use crate::summary::probabilities;
use crate::summary::transition_statistics::{DISTRIBUTION_COLUMNS, QUANTILE_COLUMNS};

/// Widths of edges, one for each refined axis.
const WITHIN: [Column<()>; 1] = [Column::number(
    "within_AXIS",
    |()| None,
    "for each refined axis: half the distance of these two points; the edge passes between them",
)
.in_unit("of the axis")];

/// Tables by their name in the document, each as its rows in Markdown.
pub fn all() -> Vec<(&'static str, String)> {
    vec![
        ("transitions", described(&results::COLUMNS)),
        ("bands", described(&bands_table::COLUMNS)),
        ("map points", described(&results::OF_MAP_POINTS)),
        ("map edges", described(&EDGE_COLUMNS) + &described(&WITHIN)),
        ("map grid", described(&GRID_COLUMNS)),
        ("map surface", described(&SURFACE_COLUMNS)),
        ("landings", described(&landing_table::COLUMNS)),
        ("reports", described(&landing_table::OF_REPORTS)),
        ("history", described(&OF_BODY) + &described(&OF_LEG)),
        ("sensitivities", described(&sensitivity_table::COLUMNS)),
        ("probabilities", described(&probabilities::columns())),
        ("quantiles", described(&QUANTILE_COLUMNS)),
        ("distribution", described(&DISTRIBUTION_COLUMNS)),
    ]
}
