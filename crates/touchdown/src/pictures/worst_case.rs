//! A result table of many axes reduced to a few: of all rows that agree in these, the one with the
//! lowest first transition.

use csv::StringRecord;
use touchdown_sweep::results::COLUMNS;

/// The worst of each design: a table over `axes`, in their order, from a table over more.
///
/// # Errors
/// When the table has no such axis or is none that a sweep writes, in words.
pub fn over(table: &str, axes: &[String]) -> Result<String, String> {
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let heading = reader.headers().map_err(|error| error.to_string())?.clone();
    let column = |name: &str| {
        let names: Vec<&str> = heading.iter().collect();
        let found = heading.iter().position(|known| known == name);
        found.ok_or_else(|| format!("has no column {name}: there are {}", names.join(", ")))
    };
    let kept = axes
        .iter()
        .map(|axis| column(axis))
        .collect::<Result<Vec<_>, _>>()?;
    // Tables of earlier versions lack some of them.
    let told = COLUMNS.iter().filter_map(|name| column(name).ok());
    let told: Vec<usize> = told.collect();
    let speed = column("first_transition_fps")?;

    let mut rows: Vec<StringRecord> = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| error.to_string())?;
        let same = |row: &&mut StringRecord| kept.iter().all(|axis| row[*axis] == record[*axis]);
        match rows.iter_mut().find(same) {
            Some(row) if is_lower(&record[speed], &row[speed]) => *row = record,
            Some(_) => {}
            None => rows.push(record),
        }
    }
    sort(&mut rows, &kept);
    let mut writer = csv::Writer::from_writer(Vec::new());
    let columns: Vec<usize> = kept.into_iter().chain(told).collect();
    for row in std::iter::once(&heading).chain(&rows) {
        let cells = columns.iter().map(|column| &row[*column]);
        writer
            .write_record(cells)
            .map_err(|error| error.to_string())?;
    }
    let bytes = writer.into_inner().map_err(|error| error.to_string())?;
    String::from_utf8(bytes).map_err(|error| error.to_string())
}

/// Whether a speed is below another; no speed is above all.
fn is_lower(one: &str, other: &str) -> bool {
    let number = |text: &str| text.parse().unwrap_or(f64::INFINITY);
    number(one) < number(other)
}

/// Rows as a sweep over these axes would have them: the first slowest, values in the order in which
/// they came up.
fn sort(rows: &mut [StringRecord], axes: &[usize]) {
    let mut order: Vec<Vec<String>> = Vec::with_capacity(axes.len());
    for axis in axes {
        let mut values: Vec<String> = Vec::new();
        for row in rows.iter() {
            if !values.iter().any(|value| *value == row[*axis]) {
                values.push(row[*axis].to_owned());
            }
        }
        order.push(values);
    }
    rows.sort_by_key(|row| {
        let place = |(axis, values): (&usize, &Vec<String>)| {
            values.iter().position(|value| *value == row[*axis])
        };
        axes.iter().zip(&order).map(place).collect::<Vec<_>>()
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "\
a,roll_deg,b,first_transition_to,first_transition_fps,bracket_low_fps,bracket_high_fps,landings,\
derivative_evaluations
1,0,5,unstable,12,11,13,9,90
1,0,6,none,,,,9,90
1,5,5,unstable,11,10,12,8,80
1,5,6,bottomed,9,8,10,7,70
2,0,5,none,,,,9,90
2,5,5,none,,,,9,90
2,5,6,none,,,,9,90
";

    #[test]
    fn the_lowest_of_each_remains() {
        let axes = ["b".to_owned(), "a".to_owned()];
        let reduced = over(TABLE, &axes).unwrap();
        let rows: Vec<&str> = reduced.lines().collect();
        assert!(rows[0].starts_with("b,a,first_transition_to,"));
        assert_eq!(
            rows[1..],
            [
                "5,1,unstable,11,10,12,8,80",
                "5,2,none,,,,9,90",
                "6,1,bottomed,9,8,10,7,70",
                "6,2,none,,,,9,90"
            ]
        );
        let said = over(TABLE, &["c".to_owned()]).unwrap_err();
        assert!(
            said.contains("has no column c: there are a, roll_deg"),
            "{said}"
        );
    }
}
