//! Convex quadratic programmes with linear bounds and bounds on the size of numbers and the length of vectors, by interior points. Knows no gears.

mod dense_interior_points;
mod parts;
mod rows;

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SecondOrderConeT, SolverStatus,
};

/// An affine function of the variables: entries (column, factor) and a constant.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Affine {
    /// Entries (column, factor).
    pub entries: Vec<(usize, f64)>,
    /// Constant.
    pub constant: f64,
}

/// Affine bounds on both sides of a number that is away from them by the length of a vector at least.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Band {
    /// Entries (column, factor) of the number; those of the last, common variables have no place here and in `others`.
    pub middle: Vec<(usize, f64)>,
    /// Entries of the vector.
    pub others: [Vec<(usize, f64)>; 2],
    /// ends[0] + middle and ends[1] - middle are no smaller than the length of the vector; entries of common variables only.
    pub ends: [Affine; 2],
}

impl Band {
    /// Its two cones.
    fn cones(&self) -> [[Affine; 3]; 2] {
        let vector = || self.others.clone().map(|entries| Affine { entries, constant: 0.0 });
        [(&self.ends[0], 1.0), (&self.ends[1], -1.0)].map(|(end, sign)| {
            let [b, c] = vector();
            let middle = self.middle.iter().map(|&(column, factor)| (column, sign * factor));
            let entries = middle.chain(end.entries.iter().copied()).collect();
            [Affine { entries, constant: end.constant }, b, c]
        })
    }
}

/// min x.P.x/2 + c.x with affine functions of x that are not negative, and others that are no smaller than the size of another or the length of
/// the vector of two more.
#[derive(Clone, Debug, Default)]
pub struct ConeProgramme {
    /// c, one number for each variable.
    pub cost: Vec<f64>,
    /// Entries (row, column, value) of P with row <= column; several of one place add up. P has no negative eigenvalue.
    pub quadratic: Vec<(usize, usize, f64)>,
    /// Each is at least 0.
    pub positive: Vec<Affine>,
    /// Of each the first is at least the size of the second.
    pub strips: Vec<[Affine; 2]>,
    /// Of each the first is at least the length of the vector of the others.
    pub cones: Vec<[Affine; 3]>,
    /// Two cones each with the same rows.
    pub bands: Vec<Band>,
    /// So many variables, the last ones, stand in many bounds.
    pub common: usize,
}

/// Where a programme ends.
#[derive(Clone, Debug, PartialEq)]
pub struct ConeOptimum {
    /// The variables.
    pub x: Vec<f64>,
    /// No x that meets the bounds has a smaller objective than this, to the accuracy of the interior points.
    pub bound: f64,
}

/// Residual of a step over the accuracy that is asked for.
const REFINED: f64 = 1e-3;

impl ConeProgramme {
    /// Solves; `None` if the interior points do not converge to `accuracy`, of a programme scaled to numbers of about 1. Few variables make small
    /// dense steps; where these lose their digits, the sparse ones of clarabel take over.
    pub fn solve(&self, accuracy: f64) -> Option<ConeOptimum> {
        dense_interior_points::solve(self, accuracy).or_else(|| self.solve_sparse(accuracy))
    }

    fn solve_sparse(&self, accuracy: f64) -> Option<ConeOptimum> {
        let columns = self.cost.len();
        let cones: Vec<[Affine; 3]> =
            self.cones.iter().cloned().chain(self.bands.iter().flat_map(Band::cones)).collect();
        let all = || self.positive.iter().chain(self.strips.iter().flatten()).chain(cones.iter().flatten());
        let (mut rows, mut places, mut values, mut right) = (vec![], vec![], vec![], vec![]);
        // Clarabel's form: right - A x in the cone.
        for (row, affine) in all().enumerate() {
            right.push(affine.constant);
            for &(column, factor) in &affine.entries {
                rows.push(row);
                places.push(column);
                values.push(-factor);
            }
        }
        let a = CscMatrix::new_from_triplets(right.len(), columns, rows, places, values);
        let (mut rows, mut places, mut values) = (vec![], vec![], vec![]);
        for &(row, column, value) in &self.quadratic {
            rows.push(row);
            places.push(column);
            values.push(value);
        }
        let p = CscMatrix::new_from_triplets(columns, columns, rows, places, values);
        let mut kinds = vec![NonnegativeConeT(self.positive.len())];
        kinds.extend(self.strips.iter().map(|_| SecondOrderConeT(2)));
        kinds.extend(cones.iter().map(|_| SecondOrderConeT(3)));
        let settings = DefaultSettings {
            verbose: false,
            max_threads: 1,
            direct_solve_method: "qdldl".into(),
            tol_gap_abs: accuracy,
            tol_gap_rel: accuracy,
            tol_feas: accuracy,
            // Steps need not be more exact than that: further refinement took a fifth of the time.
            iterative_refinement_reltol: REFINED * accuracy,
            iterative_refinement_abstol: REFINED * accuracy,
            ..DefaultSettings::default()
        };
        let mut solver = DefaultSolver::new(&p, &self.cost, &a, &right, &kinds, settings).ok()?;
        solver.solve();
        let solution = &solver.solution;
        let good = matches!(solution.status, SolverStatus::Solved | SolverStatus::AlmostSolved);
        let finite = solution.x.iter().all(|x| x.is_finite()) && solution.obj_val_dual.is_finite();
        (good && finite).then(|| ConeOptimum { x: solution.x.clone(), bound: solution.obj_val_dual })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn affine<const N: usize>(entries: [(usize, f64); N], constant: f64) -> Affine {
        Affine { entries: entries.to_vec(), constant }
    }

    #[test]
    fn the_nearest_point_of_a_disc_cut_by_a_line_is_known() {
        // Nearest to (3, 4) with |x| <= 1: (0.6, 0.8); with x_1 <= 0.5 besides: (0.5, sqrt 0.75).
        let mut programme = ConeProgramme {
            cost: vec![-3.0, -4.0],
            quadratic: vec![(0, 0, 1.0), (1, 1, 1.0)],
            positive: Vec::new(),
            strips: Vec::new(),
            cones: vec![[affine([], 1.0), affine([(0, 1.0)], 0.0), affine([(1, 1.0)], 0.0)]],
            ..ConeProgramme::default()
        };
        let disc = programme.solve(1e-9).unwrap();
        assert!((disc.x[0] - 0.6).abs() < 1e-6 && (disc.x[1] - 0.8).abs() < 1e-6, "{disc:?}");
        assert!((disc.bound - (0.5 - 5.0)).abs() < 1e-6);
        programme.positive.push(affine([(0, -1.0)], 0.5));
        let cut = programme.solve(1e-9).unwrap();
        assert!((cut.x[0] - 0.5).abs() < 1e-6 && (cut.x[1] - 0.75f64.sqrt()).abs() < 1e-6, "{cut:?}");
    }

    #[test]
    fn dense_and_sparse_steps_end_at_one_optimum() {
        // Smooth sequences near others, with bounds on differences as cones: many short rows, few variables.
        for seed in 1..20_usize {
            let columns = 8 + seed;
            let number = |k: usize| ((k * 7919 + seed * 104_729) % 1009) as f64 / 1009.0 - 0.5;
            let mut programme = ConeProgramme { cost: vec![0.0; columns + 1], ..ConeProgramme::default() };
            programme.cost[columns] = 100.0;
            programme.positive.push(affine([(columns, 1.0)], 0.0));
            for k in 0..columns {
                programme.quadratic.push((k, k, 1.0));
                let near = affine([(columns, 1.0)], 0.0);
                programme.strips.push([near, affine([(k, -1.0)], number(k))]);
            }
            for k in 1..columns - 1 {
                programme.quadratic.extend([(k - 1, k - 1, 1.0), (k - 1, k, -1.0), (k, k, 1.0)]);
                let first = affine([(k, 1.0), (k - 1, -1.0)], 0.01 * number(2 * k));
                let second = affine([(k + 1, 1.0), (k, -1.0)], 0.0);
                programme.cones.push([affine([(columns, 0.3)], 0.1), first, second]);
                let ends = [affine([(columns, 0.2)], 0.3), affine([(columns, 0.1)], 0.2)];
                let others = [vec![(k - 1, 0.1)], vec![(k, -0.2), (k + 1, 0.3)]];
                programme.bands.push(Band { middle: vec![(k, 0.5)], others, ends });
            }
            programme.common = seed % 2;
            let dense = dense_interior_points::solve(&programme, 1e-8).unwrap();
            let sparse = programme.solve_sparse(1e-8).unwrap();
            let apart = dense.x.iter().zip(&sparse.x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            // The objective, 50 at most, grows by half the square of the distance: the root of twice its accuracy.
            assert!(apart < 1e-3, "{seed}: {apart:e}");
            assert!((dense.bound - sparse.bound).abs() < 1e-6 * sparse.bound.abs(), "{dense:?} {sparse:?}");
        }
    }

    #[test]
    fn contradictions_have_no_optimum() {
        let apart = ConeProgramme {
            cost: vec![1.0],
            positive: vec![affine([(0, 1.0)], -1.0), affine([(0, -1.0)], 0.0)],
            ..ConeProgramme::default()
        };
        assert_eq!(apart.solve(1e-9), None);
    }
}
