//! Jointly normal axes: `[[sample.covariance]]` of a sweep file.
//!
//! A point is mean + L z, with the Cholesky factor L of the covariance matrix and independent standard normal numbers z.

use crate::documents::input_error::InputError;
use crate::documents::section::{LocatedValue, Section};
use crate::points::axis_input::AxisEntry;

pub(crate) const COVARIANCE: [&str; 2] = ["axes", "matrix"];
const AXES: &str = "a list of at least two axes, each in one covariance only";
const MATRIX: &str = "a symmetric, positive definite matrix with a row for each of its axes";
/// Greatest difference between two equal elements, relative to the geometric mean of the variances.
const SYMMETRIC: f64 = 1e-9;
/// Least pivot of a positive definite matrix, relative to its variance.
const DEFINITE: f64 = 1e-12;

/// Axes that are jointly normal.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct JointNormal {
    /// Indices of the axes among all axes.
    pub(crate) axes: Vec<usize>,
    pub(crate) covariance: Vec<Vec<f64>>,
    /// Lower triangle.
    pub(crate) cholesky: Vec<Vec<f64>>,
}

/// Reads the covariances of a sample.
pub(crate) fn read(
    sample: &Section,
    entries: &[AxisEntry],
) -> Result<Vec<JointNormal>, InputError> {
    let mut joint: Vec<JointNormal> = Vec::new();
    for table in sample.sections("covariance", &COVARIANCE)? {
        let names = table.value("axes", AXES)?;
        let mut axes = Vec::new();
        for item in names.items(AXES)? {
            let name = item.text()?;
            let Some(axis) = entries
                .iter()
                .position(|entry| entry.parameter.name() == name)
            else {
                let known: Vec<&str> = entries.iter().map(|entry| entry.parameter.name()).collect();
                return Err(item.complain(&format!("one of the axes {}", known.join(", "))));
            };
            let mut taken = joint.iter().flat_map(|other| &other.axes).chain(&axes);
            if taken.any(|other| *other == axis) {
                return Err(item.complain(AXES));
            }
            axes.push(axis);
        }
        if axes.len() < 2 {
            return Err(names.complain(AXES));
        }
        let matrix = table.value("matrix", MATRIX)?;
        let covariance = square(&matrix, axes.len())?;
        let cholesky = cholesky(&covariance).ok_or_else(|| matrix.complain(MATRIX))?;
        joint.push(JointNormal {
            axes,
            covariance,
            cholesky,
        });
    }
    Ok(joint)
}

fn square(matrix: &LocatedValue, size: usize) -> Result<Vec<Vec<f64>>, InputError> {
    let rows = matrix.items(MATRIX)?;
    if rows.len() != size {
        return Err(matrix.complain(&format!("{MATRIX}: {size} rows")));
    }
    let row = |row: &LocatedValue| {
        let cells = row.items(MATRIX)?;
        match cells.len() == size {
            true => cells.iter().map(LocatedValue::number).collect(),
            false => Err(row.complain(&format!("{MATRIX}: {size} numbers a row"))),
        }
    };
    rows.iter().map(row).collect()
}

/// Cholesky factor L of a symmetric, positive definite matrix L Lᵀ; `None` for any other.
fn cholesky(matrix: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let size = matrix.len();
    let mut factor = vec![vec![0.0; size]; size];
    for i in 0..size {
        for j in 0..=i {
            let scale = (matrix[i][i] * matrix[j][j]).sqrt();
            let asymmetry = (matrix[i][j] - matrix[j][i]).abs();
            let sum: f64 = (0..j).map(|k| factor[i][k] * factor[j][k]).sum();
            let rest = matrix[i][j] - sum;
            let is_definite = i != j || rest > DEFINITE * scale;
            // The comparison is negated so that NaN fails too.
            if !(asymmetry <= SYMMETRIC * scale && is_definite) {
                return None;
            }
            factor[i][j] = if i == j {
                rest.sqrt()
            } else {
                rest / factor[j][j]
            };
        }
    }
    Some(factor)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_factor_gives_the_matrix_back() {
        let matrix = vec![
            vec![4.0, 1.2, -0.6],
            vec![1.2, 0.81, 0.1],
            vec![-0.6, 0.1, 0.5],
        ];
        let factor = cholesky(&matrix).unwrap();
        for (i, row) in matrix.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                let product: f64 = (0..3).map(|k| factor[i][k] * factor[j][k]).sum();
                assert!((product - value).abs() < 1e-14, "{i}, {j}: {product}");
            }
        }
    }

    #[test]
    fn matrices_of_no_distribution_have_no_factor() {
        for matrix in [
            [[1.0, 2.0], [2.0, 1.0]],
            [[1.0, 1.0], [1.0, 1.0]],
            [[1.0, 0.5], [0.4, 1.0]],
            [[0.0, 0.0], [0.0, 1.0]],
            [[-1.0, 0.0], [0.0, 1.0]],
        ] {
            let matrix: Vec<Vec<f64>> = matrix.iter().map(|row| row.to_vec()).collect();
            assert_eq!(cholesky(&matrix), None, "{matrix:?}");
        }
    }

    #[test]
    fn units_of_the_axes_do_not_decide_what_is_a_distribution() {
        for units in [[1e-9, 1e-9], [1e9, 1e9], [1e-6, 1e6]] {
            let in_units = |correlations: [[f64; 2]; 2]| -> Vec<Vec<f64>> {
                let row = |i: usize| (0..2).map(move |j| units[i] * correlations[i][j] * units[j]);
                (0..2).map(|i| row(i).collect()).collect()
            };
            assert!(cholesky(&in_units([[1.0, 0.5], [0.5, 1.0]])).is_some());
            assert_eq!(cholesky(&in_units([[1.0, 0.5], [0.4, 1.0]])), None);
            assert_eq!(cholesky(&in_units([[1.0, 1.0], [1.0, 1.0]])), None);
        }
    }
}
