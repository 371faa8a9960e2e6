//! A tensor-product cubic spline fitted to scattered points by least squares.

use nalgebra::{DMatrix, DVector};

use super::knots::{Knots, SplineError};
use super::tensor_spline::TensorSpline;

/// Smallest eigenvalue of the normal matrix over the largest below which the points don't determine the spline.
/// Full coverage gives 1e-5 to 1e-9; rounding fills a true gap to about 1e-16.
const RANK_LIMIT: f64 = 1e-12;

/// The C2 bicubic spline over `intervals[0]` x `intervals[1]` equal cells that passes closest to points (u, v, f),
/// in the sense of least squares, all weights equal. The cells span the bounding box of the points.
///
/// # Errors
/// [`SplineError::RankDeficient`] when the points leave coefficients open (fewer points than coefficients, or a
/// hole in the cloud wider than the cells), [`SplineError::ValueNotFinite`] for bad numbers.
pub fn fit_tensor_spline(points: &[[f64; 3]], intervals: [usize; 2]) -> Result<TensorSpline, SplineError> {
    let [rows, columns] = intervals.map(|n| n.max(1) + 3);
    let count = rows * columns;
    let deficient = SplineError::RankDeficient { points: points.len(), coefficients: count };
    if points.len() < count {
        return Err(deficient);
    }
    if let Some(index) = points.iter().position(|p| p.iter().any(|x| !x.is_finite())) {
        return Err(SplineError::ValueNotFinite { index });
    }
    let u = equal_knots(points, 0, rows - 3)?;
    let v = equal_knots(points, 1, columns - 3)?;

    let mut normal = DMatrix::<f64>::zeros(count, count);
    for point in points {
        let basis = local_basis(point, &u, &v, columns);
        for (a, x) in basis {
            for (b, y) in basis {
                normal[(a, b)] += x * y;
            }
        }
    }
    let Some(cholesky) = normal.clone().cholesky() else { return Err(deficient) };
    let largest = largest_eigenvalue(count, |x| &normal * x);
    let smallest = largest_eigenvalue(count, |x| cholesky.solve(x)).recip();
    if smallest.is_nan() || smallest <= RANK_LIMIT * largest {
        return Err(deficient);
    }
    let mut coefficients = DVector::<f64>::zeros(count);
    // The second pass works on the residual of the first: it gives back the digits that squaring the condition
    // number costs.
    for _ in 0..2 {
        let mut right = DVector::<f64>::zeros(count);
        for point in points {
            let basis = local_basis(point, &u, &v, columns);
            let residual = point[2] - basis.iter().map(|(a, x)| coefficients[*a] * x).sum::<f64>();
            for (a, x) in basis {
                right[a] += x * residual;
            }
        }
        coefficients += cholesky.solve(&right);
    }

    let cells = (0..rows - 3)
        .flat_map(|i| (0..columns - 3).map(move |j| (i, j)))
        .map(|(i, j)| cell(i, j, &coefficients, &u, &v, columns))
        .collect();
    TensorSpline::from_cells(u, v, cells)
}

fn equal_knots(points: &[[f64; 3]], axis: usize, intervals: usize) -> Result<Knots, SplineError> {
    let low = points.iter().map(|p| p[axis]).fold(f64::INFINITY, f64::min);
    let high = points.iter().map(|p| p[axis]).fold(f64::NEG_INFINITY, f64::max);
    let knots: Vec<f64> = (0..=intervals).map(|i| low + (high - low) * i as f64 / intervals as f64).collect();
    Knots::new(&knots, 2, axis)
}

/// The four pieces of the cubic B-spline with unit knot distance, ascending powers of t in [0, 1]: `[b]` is the
/// piece that basis function i + b shows in interval i.
const PIECES: [[f64; 4]; 4] = [
    [1.0 / 6.0, -0.5, 0.5, -1.0 / 6.0],
    [4.0 / 6.0, 0.0, -1.0, 0.5],
    [1.0 / 6.0, 0.5, 0.5, -0.5],
    [0.0, 0.0, 0.0, 1.0 / 6.0],
];

/// Index and value of the 16 basis functions that don't vanish at a point.
fn local_basis(point: &[f64; 3], u: &Knots, v: &Knots, columns: usize) -> [(usize, f64); 16] {
    let (i, du) = u.locate(point[0]);
    let (j, dv) = v.locate(point[1]);
    let value = |piece: &[f64; 4], t: f64| piece[0] + t * (piece[1] + t * (piece[2] + t * piece[3]));
    let s = du / width(u);
    let t = dv / width(v);
    std::array::from_fn(|n| {
        let (a, b) = (n / 4, n % 4);
        ((i + a) * columns + j + b, value(&PIECES[a], s) * value(&PIECES[b], t))
    })
}

fn width(knots: &Knots) -> f64 {
    knots.values()[1] - knots.values()[0]
}

fn cell(
    i: usize,
    j: usize,
    coefficients: &DVector<f64>,
    u: &Knots,
    v: &Knots,
    columns: usize,
) -> [[f64; 4]; 4] {
    let mut out = [[0.0; 4]; 4];
    for k in 0..4 {
        for l in 0..4 {
            let mut sum = 0.0;
            for a in 0..4 {
                for b in 0..4 {
                    sum += coefficients[(i + a) * columns + j + b] * PIECES[a][k] * PIECES[b][l];
                }
            }
            out[k][l] = sum / (width(u).powi(k as i32) * width(v).powi(l as i32));
        }
    }
    out
}

/// The largest eigenvalue of a symmetric map without negative ones, by its powers: within a few percent, which is enough to tell a gap from
/// full coverage, at the cost of some products in place of a decomposition.
fn largest_eigenvalue(size: usize, times: impl Fn(&DVector<f64>) -> DVector<f64>) -> f64 {
    const POWERS: usize = 24;
    // Along no axis of symmetry of a grid.
    let mut x = DVector::from_fn(size, |k, _| 1.0 + 0.7 * (2.4 * k as f64).sin()).normalize();
    let mut by = 0.0;
    for _ in 0..POWERS {
        let next = times(&x);
        by = next.norm();
        x = next / by;
    }
    by
}
