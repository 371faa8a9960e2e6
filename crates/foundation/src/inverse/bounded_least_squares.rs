//! Weighted linear least squares with bounds on the unknowns by an active set, columns scaled to unit norm, with the rank and the directions
//! that the rows do not see. Knows no gears.

use super::RankReport;
use nalgebra::{DMatrix, DVector};

/// Solution of a bounded problem.
#[derive(Clone, Debug, PartialEq)]
pub struct BoundedLeastSquares {
    /// The minimiser; the shortest one in scaled unknowns where the rows leave some open.
    pub x: DVector<f64>,
    /// Whether an unknown is held at its lower (-1) or upper (1) bound, or is free (0).
    pub at_bound: Vec<i8>,
    /// Residual A x - b, unweighted.
    pub residual: DVector<f64>,
    /// Residual of the minimiser without bounds, unweighted: what these unknowns cannot remove.
    pub unremovable: DVector<f64>,
    /// Singular values of the weighted matrix with columns of unit norm, and its rank.
    pub rank: RankReport,
    /// Directions of the unknowns, in units of the largest one in scaled unknowns, that change nothing; one a missing rank.
    pub unseen: Vec<DVector<f64>>,
    /// Diagonal of (A^T W A)^-1; infinite for an unknown with a part in a direction unseen.
    pub variances: Vec<f64>,
}

/// Parts of a direction below this do not belong to it.
const PART: f64 = 1e-6;
/// A gradient below this share of the columns' and the right side's size is rounding.
const GRADIENT: f64 = 1e-12;

/// Scaled problem: columns of unit norm.
struct Scaled {
    a: DMatrix<f64>,
    b: DVector<f64>,
    norms: Vec<f64>,
    cut: f64,
}

impl Scaled {
    /// Shortest minimiser over the free unknowns with the others held.
    fn solve(&self, free: &[usize], y: &DVector<f64>) -> Option<Vec<f64>> {
        let mut right = self.b.clone();
        for j in (0..y.len()).filter(|j| !free.contains(j)) {
            right.axpy(-y[j], &self.a.column(j), 1.0);
        }
        let part = self.a.select_columns(free);
        let svd = part.svd(true, true);
        let limit = self.cut * svd.singular_values.max();
        Some(svd.solve(&right, limit.max(f64::MIN_POSITIVE)).ok()?.iter().copied().collect())
    }

    /// Shortest step from y to the bounds of the free unknowns on the way to z: share of the way and unknown that stops it.
    fn stop(free: &[usize], y: &DVector<f64>, z: &[f64], bounds: &[[f64; 2]]) -> Option<(f64, usize, i8)> {
        let mut nearest: Option<(f64, usize, i8)> = None;
        for (&j, &z) in free.iter().zip(z) {
            let [low, high] = bounds[j];
            let (bound, side) = if z < low {
                (low, -1)
            } else if z > high {
                (high, 1)
            } else {
                continue;
            };
            let share = ((bound - y[j]) / (z - y[j])).clamp(0.0, 1.0);
            if nearest.is_none_or(|(least, ..)| share < least) {
                nearest = Some((share, j, side));
            }
        }
        nearest
    }
}

/// Minimises |W (A x - b)| with `bounds[j]` = [lowest, highest] (may be infinite) of every unknown and the diagonal weights `weights` (all 1
/// when `None`), from the point of the bounds nearest to 0. Singular values below `cut` times the largest count as zero. `None` if a
/// number of A, b or the weights is not finite, a column is zero, a bound is NaN or lies the wrong way round, or the sizes do not fit.
pub fn bounded_least_squares(
    a: &DMatrix<f64>,
    b: &DVector<f64>,
    weights: Option<&[f64]>,
    bounds: &[[f64; 2]],
    cut: f64,
) -> Option<BoundedLeastSquares> {
    let unknowns = a.ncols();
    let fits = bounds.len() == unknowns
        && b.len() == a.nrows()
        && weights.is_none_or(|w| w.len() == b.len())
        && bounds.iter().all(|[low, high]| low <= high && *low < f64::INFINITY && *high > f64::NEG_INFINITY);
    if !fits || unknowns == 0 {
        return None;
    }
    let (mut wa, mut wb) = (a.clone(), b.clone());
    for (i, &w) in weights.into_iter().flatten().enumerate() {
        wa.row_mut(i).scale_mut(w);
        wb[i] *= w;
    }
    if wa.iter().chain(wb.iter()).any(|x| !x.is_finite()) {
        return None;
    }
    let norms: Vec<f64> = wa.column_iter().map(|column| column.norm()).collect();
    if norms.contains(&0.0) {
        return None;
    }
    norms.iter().enumerate().for_each(|(j, norm)| wa.column_mut(j).scale_mut(1.0 / norm));
    let scaled = Scaled { a: wa, b: wb, norms, cut };
    let limits: Vec<[f64; 2]> =
        bounds.iter().zip(&scaled.norms).map(|(bound, norm)| bound.map(|x| x * norm)).collect();
    let (y, at_bound) = active_set(&scaled, &limits)?;
    let all: Vec<usize> = (0..unknowns).collect();
    let open = DVector::from_vec(scaled.solve(&all, &y)?);
    let plain = |y: &DVector<f64>| y.map_with_location(|j, _, y| y / scaled.norms[j]);
    let x = DVector::from_fn(unknowns, |j, _| match at_bound[j] {
        // Bounds exactly as they were given.
        -1 => bounds[j][0],
        1 => bounds[j][1],
        _ => y[j] / scaled.norms[j],
    });
    let (rank, unseen, variances) = seen(&scaled)?;
    Some(BoundedLeastSquares {
        residual: a * &x - b,
        unremovable: a * plain(&open) - b,
        x,
        at_bound,
        rank,
        unseen,
        variances,
    })
}

/// The minimiser in scaled unknowns and which of them are held (Stark and Parker).
fn active_set(scaled: &Scaled, bounds: &[[f64; 2]]) -> Option<(DVector<f64>, Vec<i8>)> {
    let unknowns = bounds.len();
    let mut y = DVector::from_fn(unknowns, |j, _| 0.0_f64.clamp(bounds[j][0], bounds[j][1]));
    let mut held = vec![0i8; unknowns];
    let size = scaled.b.norm();
    // Every round holds or frees one unknown; the sum of squares falls, so that no set comes twice.
    for _ in 0..(100 + 20 * unknowns) {
        let free: Vec<usize> = (0..unknowns).filter(|&j| held[j] == 0).collect();
        if !free.is_empty() {
            let z = scaled.solve(&free, &y)?;
            if let Some((share, j, side)) = Scaled::stop(&free, &y, &z, bounds) {
                free.iter().zip(&z).for_each(|(&k, z)| y[k] += share * (z - y[k]));
                y[j] = bounds[j][usize::from(side > 0)];
                held[j] = side;
                continue;
            }
            free.iter().zip(&z).for_each(|(&k, z)| y[k] = *z);
        }
        // Down the gradient, away from a bound?
        let slope = scaled.a.tr_mul(&(&scaled.b - &scaled.a * &y));
        let inwards = |j: usize| -f64::from(held[j]) * slope[j];
        // Equal bounds leave nowhere to go.
        let candidates = (0..unknowns).filter(|&j| held[j] != 0 && bounds[j][0] < bounds[j][1]);
        let best = candidates.max_by(|&i, &j| inwards(i).total_cmp(&inwards(j)));
        match best.filter(|&j| inwards(j) > GRADIENT * size) {
            Some(j) => held[j] = 0,
            None => return Some((y, held)),
        }
    }
    None
}

/// Rank, directions unseen and variances of all unknowns.
fn seen(scaled: &Scaled) -> Option<(RankReport, Vec<DVector<f64>>, Vec<f64>)> {
    let unknowns = scaled.a.ncols();
    // With fewer rows than unknowns the missing singular values are zero.
    let square = if scaled.a.nrows() < unknowns {
        scaled.a.clone().resize_vertically(unknowns, 0.0)
    } else {
        scaled.a.clone()
    };
    let svd = square.svd(false, true);
    let directions = svd.v_t.as_ref()?;
    let mut order: Vec<usize> = (0..unknowns).collect();
    order.sort_by(|&i, &j| svd.singular_values[j].total_cmp(&svd.singular_values[i]));
    let singular_values: Vec<f64> = order.iter().map(|&k| svd.singular_values[k]).collect();
    let rank = singular_values.iter().filter(|s| **s > scaled.cut * singular_values[0]).count();
    let (mut unseen, mut variances) = (Vec::new(), vec![0.0; unknowns]);
    for (place, &k) in order.iter().enumerate() {
        let direction = directions.row(k);
        let largest = direction.amax();
        if place >= rank {
            unseen.push(DVector::from_fn(unknowns, |j, _| direction[j] / largest / scaled.norms[j]));
        }
        for j in 0..unknowns {
            variances[j] += match (place < rank, direction[j].abs() > PART) {
                (true, _) => (direction[j] / svd.singular_values[k] / scaled.norms[j]).powi(2),
                (false, true) => f64::INFINITY,
                (false, false) => 0.0,
            };
        }
    }
    Some((RankReport { singular_values, rank }, unseen, variances))
}

#[cfg(test)]
mod tests {
    use super::*;

    const OPEN: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

    fn problem() -> (DMatrix<f64>, DVector<f64>) {
        let a =
            DMatrix::from_fn(12, 4, |i, j| (0.7 * (i + 1) as f64 * (j as f64 + 0.4)).sin() + 0.1 * j as f64);
        let b = DVector::from_fn(12, |i, _| (1.3 * i as f64).cos() + 0.2 * i as f64);
        (a, b)
    }

    /// Every way of holding and freeing, with the unknowns found by normal equations.
    fn best_by_trying(a: &DMatrix<f64>, b: &DVector<f64>, bounds: &[[f64; 2]]) -> f64 {
        let n = a.ncols();
        let mut least = f64::INFINITY;
        for code in 0..3usize.pow(n as u32) {
            let state: Vec<usize> = (0..n).map(|j| code / 3usize.pow(j as u32) % 3).collect();
            let free: Vec<usize> = (0..n).filter(|&j| state[j] == 2).collect();
            let mut x = DVector::from_fn(n, |j, _| bounds[j][state[j].min(1)]);
            free.iter().for_each(|&j| x[j] = 0.0);
            if !free.is_empty() {
                let part = a.select_columns(&free);
                let z = (part.tr_mul(&part)).try_inverse().unwrap() * part.tr_mul(&(b - a * &x));
                free.iter().zip(z.iter()).for_each(|(&j, z)| x[j] = *z);
            }
            if (0..n).all(|j| x[j] >= bounds[j][0] - 1e-12 && x[j] <= bounds[j][1] + 1e-12) {
                least = least.min((a * x - b).norm());
            }
        }
        least
    }

    #[test]
    fn the_best_of_all_ways_of_holding_is_found() {
        let (a, b) = problem();
        for (k, width) in [0.01, 0.1, 0.3, 1.0, 3.0].into_iter().enumerate() {
            let bounds = [[-width, width], [-0.5 * width, 2.0 * width], [0.1, 0.1 + width], [-9.0, -width]];
            let found = bounded_least_squares(&a, &b, None, &bounds, 1e-9).unwrap();
            let wanted = best_by_trying(&a, &b, &bounds);
            assert!((found.residual.norm() - wanted).abs() < 1e-12 * wanted, "{k}");
            for j in 0..4 {
                assert!(found.x[j] >= bounds[j][0] && found.x[j] <= bounds[j][1], "{k} {j}");
            }
            assert!(found.unremovable.norm() <= found.residual.norm());
        }
        let free = bounded_least_squares(&a, &b, None, &[OPEN; 4], 1e-9).unwrap();
        assert!(
            free.at_bound.iter().all(|side| *side == 0) && (free.residual - free.unremovable).norm() < 1e-12
        );
        let covariance = (a.tr_mul(&a)).try_inverse().unwrap();
        for j in 0..4 {
            assert!((free.variances[j] / covariance[(j, j)] - 1.0).abs() < 1e-10);
        }
    }

    #[test]
    fn columns_that_say_the_same_are_named() {
        let (mut a, b) = problem();
        let twice = a.column(0) * 2.0;
        a.set_column(2, &twice);
        let found = bounded_least_squares(&a, &b, None, &[OPEN; 4], 1e-9).unwrap();
        assert_eq!((found.rank.rank, found.unseen.len()), (3, 1));
        let unseen = &found.unseen[0];
        assert!((unseen[0] + 2.0 * unseen[2]).abs() < 1e-12 && unseen[1].abs() < 1e-12);
        assert!(found.variances[0].is_infinite() && found.variances[1].is_finite());
        // The shortest in scaled unknowns shares evenly.
        assert!((found.x[0] - 2.0 * found.x[2]).abs() < 1e-12);
    }

    #[test]
    fn input_without_a_meaning_has_no_solution() {
        let (a, b) = problem();
        assert!(bounded_least_squares(&a, &b, None, &[OPEN; 3], 1e-9).is_none());
        assert!(bounded_least_squares(&a, &b, None, &[[1.0, -1.0], OPEN, OPEN, OPEN], 1e-9).is_none());
        assert!(bounded_least_squares(&a, &b, None, &[[f64::NAN; 2], OPEN, OPEN, OPEN], 1e-9).is_none());
        assert!(bounded_least_squares(&(a * f64::NAN), &b, None, &[OPEN; 4], 1e-9).is_none());
    }

    #[test]
    fn fewer_rows_than_unknowns_leave_directions_open() {
        let a = DMatrix::from_row_slice(1, 2, &[1.0, 1.0]);
        let b = DVector::from_row_slice(&[2.0]);
        let found = bounded_least_squares(&a, &b, None, &[[-5.0, 0.5], OPEN], 1e-9).unwrap();
        assert_eq!((found.rank.rank, found.unseen.len()), (1, 1));
        assert!((found.x[0] - 0.5).abs() < 1e-14 && (found.x[1] - 1.5).abs() < 1e-14);
    }
}
