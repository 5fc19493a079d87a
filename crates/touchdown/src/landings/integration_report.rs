//! The account of an integration, as the program of 1966 printed it at the end of a run (3.4.4.3).

use touchdown_dynamics::methods::{IntegrationSummary, variable_names};

/// The account for a reader; empty for a method that keeps none.
pub fn text(summary: &IntegrationSummary, legs: usize) -> String {
    if summary.critical.is_empty() {
        return String::new();
    }
    let mut text = format!(
        "\nintervals                    {}, {:.8} s on average, {} accepted although not good enough\n",
        summary.intervals,
        summary.mean_interval(),
        summary.bypassed
    );
    text += &row("from 0.1, 0.01, 0.001 s ...", &summary.by_decade);
    text += &row("after 0, 1, 2 cuts ...", &summary.by_cuts);
    text += "\nvariable                  critical     sum of errors   of absolute errors\n";
    let names = variable_names(legs);
    for (index, name) in names.iter().enumerate() {
        text += &format!(
            "{name:<24} {:>9} {:>17.7e} {:>20.7e}\n",
            summary.critical[index], summary.arithmetic[index], summary.absolute[index]
        );
    }
    text
}

fn row(name: &str, counts: &[u64]) -> String {
    let cells: String = counts.iter().map(|count| format!("{count:>7}")).collect();
    format!("{name:<28}{cells}\n")
}
