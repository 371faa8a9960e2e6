//! Interior points for cone programmes of few variables and many short rows: the normal equations of a step are small and dense there, and a
//! Cholesky factor of them costs a fraction of a sparse factor of the whole system. Columns are taken in fours, as splines have them. A
//! primal-dual method with the scaling of Nesterov and Todd and Mehrotra's corrector, as in L. Vandenberghe, "The CVXOPT linear and quadratic
//! cone program solvers" (2010). Knows no gears.

use super::super::PanelCholesky;
use super::parts::{Part, Scaling, UNIT, dot, length, longest, plus, product, quotient};
use super::rows::{Layout, Normal, Rows};
use super::{ConeOptimum, ConeProgramme};
use nalgebra::{DMatrix, DVector};

/// Steps at most; twenty to thirty are usual.
const STEPS: usize = 80;
/// Share of the way to the boundary of the cones that a step goes.
const SHARE: f64 = 0.99;
/// A step shorter than this gets no further.
const SHORTEST: f64 = 1e-7;
/// Weight of the variables themselves in the normal equations, over the mean of their diagonal: keeps them regular to rounding.
const RIDGE: f64 = 1e-14;

/// A programme in the form in which steps are found.
struct Dense {
    layout: Layout,
    cost: DVector<f64>,
    quadratic: DMatrix<f64>,
    rows: Vec<Rows>,
    constants: Vec<Part>,
}

/// Where the interior points are: variables, slacks, multipliers.
struct Point {
    x: DVector<f64>,
    s: Vec<Part>,
    z: Vec<Part>,
}

/// What is missing of feasibility and of an optimum.
struct Residual {
    /// P x + c - A^T z.
    dual: DVector<f64>,
    /// s - A x - b.
    primal: Vec<Part>,
    /// Sum of s z.
    gap: f64,
    /// Objective, and that of the multipliers.
    objective: [f64; 2],
}

impl Dense {
    /// With a few variables more, which stay 0, so that every piece is whole.
    fn new(programme: &ConeProgramme) -> Self {
        let layout = Layout::new(programme);
        let columns = layout.columns();
        let mut quadratic = DMatrix::zeros(columns, columns);
        for k in layout.fill() {
            quadratic[(k, k)] = 1.0;
        }
        for &(row, column, value) in &programme.quadratic {
            let (row, column) = (layout.place(row), layout.place(column));
            quadratic[(row, column)] += value;
            if row != column {
                quadratic[(column, row)] += value;
            }
        }
        let mut cost = DVector::zeros(columns);
        for (k, own) in programme.cost.iter().enumerate() {
            cost[layout.place(k)] = *own;
        }
        let rows = Rows::all(programme, layout);
        let constants = rows.iter().flat_map(Rows::constants).copied().collect();
        Self { layout, cost, quadratic, rows, constants }
    }

    /// A x.
    fn times(&self, x: &DVector<f64>) -> Vec<Part> {
        let mut parts = Vec::with_capacity(self.constants.len());
        self.rows.iter().for_each(|rows| rows.times(x.as_slice(), self.layout, &mut parts));
        parts
    }

    /// Adds A^T parts.
    fn add_transposed(&self, mut parts: &[Part], to: &mut DVector<f64>) {
        for rows in &self.rows {
            let (own, others) = parts.split_at(rows.count());
            rows.add_transposed(own, to.as_mut_slice(), self.layout);
            parts = others;
        }
    }

    /// P + A^T W^-2 A, factored; `None` where rounding makes it indefinite.
    fn factored(&self, mut scalings: &[Scaling]) -> Option<PanelCholesky> {
        let mut normal = Normal::new(&self.quadratic, self.layout);
        for rows in &self.rows {
            let (own, others) = scalings.split_at(rows.count());
            rows.add_square(own, &mut normal, self.layout);
            scalings = others;
        }
        let mut normal = normal.matrix();
        let ridge = RIDGE * normal.trace() / normal.nrows().max(1) as f64;
        for k in 0..normal.nrows() {
            normal[(k, k)] += ridge;
        }
        PanelCholesky::new(&normal)
    }

    fn residual(&self, at: &Point) -> Residual {
        let curved = &self.quadratic * &at.x;
        let mut dual = &curved + &self.cost;
        let pulls: Vec<Part> = at.z.iter().map(|z| z.map(|z| -z)).collect();
        self.add_transposed(&pulls, &mut dual);
        let along = self.times(&at.x);
        let missing = along.iter().zip(&at.s).zip(&self.constants);
        let primal = missing.map(|((ax, s), b)| plus(&plus(s, -1.0, ax), -1.0, b)).collect();
        let gap = at.s.iter().zip(&at.z).map(|(s, z)| dot(s, z)).sum();
        let constants: f64 = self.constants.iter().zip(&at.z).map(|(b, z)| dot(b, z)).sum();
        let half = 0.5 * at.x.dot(&curved);
        let objective = [half + self.cost.dot(&at.x), -half - constants];
        Residual { dual, primal, gap, objective }
    }

    /// Least squares of the bounds, moved into the cones.
    fn start(&self) -> Option<Point> {
        let same: Vec<Scaling> = self.constants.iter().map(|_| Scaling::NONE).collect();
        let mut right = -&self.cost;
        let pulls: Vec<Part> = self.constants.iter().map(|b| b.map(|b| -b)).collect();
        self.add_transposed(&pulls, &mut right);
        let x = DVector::from_vec(self.factored(&same)?.solve(right.as_slice()));
        let s: Vec<Part> =
            self.times(&x).iter().zip(&self.constants).map(|(ax, b)| plus(ax, 1.0, b)).collect();
        let z = s.iter().map(|s| s.map(|s| -s)).collect();
        let inside = |parts: Vec<Part>| -> Vec<Part> {
            let least = parts.iter().map(|v| v[0] - length(v)).fold(f64::INFINITY, f64::min);
            let by = if least > 0.0 { 0.0 } else { 1.0 - least };
            parts.iter().map(|v| [v[0] + by, v[1], v[2]]).collect()
        };
        Some(Point { x, s: inside(s), z: inside(z) })
    }

    /// The step for scaled residuals q of the products of slacks and multipliers.
    fn step(&self, factor: &PanelCholesky, scalings: &[Scaling], of: &Residual, q: &[Part]) -> Point {
        let each = scalings.iter().zip(q).zip(&of.primal);
        let pulls: Vec<Part> =
            each.map(|((scaling, q), primal)| plus(q, 1.0, &scaling.apply(-1.0, primal))).collect();
        let back: Vec<Part> = scalings.iter().zip(&pulls).map(|(w, pull)| w.apply(-1.0, pull)).collect();
        let mut right = -&of.dual;
        self.add_transposed(&back, &mut right);
        let x = DVector::from_vec(factor.solve(right.as_slice()));
        let (mut s, mut z) = (Vec::with_capacity(q.len()), Vec::with_capacity(q.len()));
        for (((along, scaling), pull), primal) in
            self.times(&x).iter().zip(scalings).zip(&pulls).zip(&of.primal)
        {
            z.push(scaling.apply(-1.0, &plus(pull, -1.0, &scaling.apply(-1.0, along))));
            s.push(plus(along, -1.0, primal));
        }
        Point { x, s, z }
    }
}

/// The largest step that keeps slacks and multipliers inside, at most `most`.
fn within(at: &Point, step: &Point, most: f64) -> f64 {
    let pairs = at.s.iter().zip(&step.s).chain(at.z.iter().zip(&step.z));
    pairs.map(|(v, d)| longest(v, d)).fold(most, f64::min)
}

/// Solves to `accuracy`; `None` where the steps get no nearer.
pub(super) fn solve(programme: &ConeProgramme, accuracy: f64) -> Option<ConeOptimum> {
    let dense = Dense::new(programme);
    let mut at = dense.start()?;
    let count = dense.constants.len().max(1) as f64;
    let largest_cost = dense.cost.amax().max(1.0);
    let largest_constant = dense.constants.iter().flatten().fold(1.0, |m: f64, c| m.max(c.abs()));
    for _ in 0..STEPS {
        let of = dense.residual(&at);
        let missing = of.primal.iter().flatten().fold(0.0, |m: f64, r| m.max(r.abs()));
        let size = of.objective[0].abs().min(of.objective[1].abs()).max(1.0);
        let met = of.dual.amax() <= accuracy * largest_cost && missing <= accuracy * largest_constant;
        if met && of.gap <= accuracy * size {
            let x = (0..programme.cost.len()).map(|k| at.x[dense.layout.place(k)]).collect();
            return Some(ConeOptimum { x, bound: of.objective[1] });
        }
        let scalings: Vec<Scaling> = at.s.iter().zip(&at.z).map(|(s, z)| Scaling::new(s, z)).collect();
        let factor = dense.factored(&scalings)?;
        let scaled: Vec<Part> = scalings.iter().zip(&at.z).map(|(w, z)| w.apply(1.0, z)).collect();
        let towards_boundary: Vec<Part> = scaled.iter().map(|l| l.map(|l| -l)).collect();
        let affine = dense.step(&factor, &scalings, &of, &towards_boundary);
        let reach = within(&at, &affine, 1.0);
        let centring = (1.0 - reach).powi(3) * of.gap / count;
        let corrected = |k: usize| {
            let (w, l) = (&scalings[k], &scaled[k]);
            let crossed = product(&w.apply(-1.0, &affine.s[k]), &w.apply(1.0, &affine.z[k]));
            let wanted = plus(&plus(&product(l, l), 1.0, &crossed), -centring, &UNIT);
            quotient(l, &wanted.map(|v| -v))
        };
        let q: Vec<Part> = (0..scalings.len()).map(corrected).collect();
        let step = dense.step(&factor, &scalings, &of, &q);
        let length = (SHARE * within(&at, &step, SHARE.recip())).min(1.0);
        if length <= SHORTEST || !step.x.iter().all(|x| x.is_finite()) {
            return None;
        }
        at.x.axpy(length, &step.x, 1.0);
        for (v, d) in at.s.iter_mut().zip(&step.s).chain(at.z.iter_mut().zip(&step.z)) {
            *v = plus(v, length, d);
        }
    }
    None
}
