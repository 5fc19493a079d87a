//! Hatching of parts of a regular table: lines along its diagonals through the places that are marked.

/// Lines between places, as indices of row and column, on every `apart`-th diagonal of a table of this many rows and
/// columns. They end half a step beyond the last marked place, or at the border.
pub fn lines(
    [rows, columns]: [usize; 2],
    apart: usize,
    is_marked: impl Fn(usize, usize) -> bool,
) -> Vec<[[f64; 2]; 2]> {
    let mut lines = Vec::new();
    for diagonal in (0..(rows + columns).saturating_sub(1)).step_by(apart) {
        let first = (diagonal + 1).saturating_sub(columns);
        let along: Vec<usize> = (first..=diagonal.min(rows - 1)).collect();
        let runs =
            along.chunk_by(|a, b| is_marked(*a, diagonal - a) == is_marked(*b, diagonal - b));
        let marked = runs.filter(|run| is_marked(run[0], diagonal - run[0]));
        lines.extend(marked.map(|run| {
            let end = |row: usize, is_last: bool| {
                let column = diagonal - row;
                let beyond = match is_last {
                    false if row == 0 || column + 1 == columns => 0.0,
                    true if row + 1 == rows || column == 0 => 0.0,
                    false => -0.5,
                    true => 0.5,
                };
                [row as f64 + beyond, column as f64 - beyond]
            };
            [end(run[0], false), end(run[run.len() - 1], true)]
        }));
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_run_through_what_is_marked_and_nothing_else() {
        let whole = lines([3, 4], 1, |_, _| true);
        assert_eq!(whole.len(), 6, "one for each diagonal");
        assert_eq!(whole[3], [[0.0, 3.0], [2.0, 1.0]]);
        assert_eq!(lines([3, 4], 2, |_, _| true).len(), 3);
        assert_eq!(lines([3, 4], 1, |_, _| false).len(), 0);
        // A gap in the middle of the third diagonal.
        let parted = lines([3, 4], 1, |row, column| row + column == 2 && row != 1);
        assert_eq!(parted, [[[0.0, 2.0], [0.5, 1.5]], [[1.5, 0.5], [2.0, 0.0]]]);
        assert!(lines([1, 1], 1, |_, _| true).len() == 1);
    }
}
