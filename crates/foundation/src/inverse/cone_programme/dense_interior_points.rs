//! Interior points for cone programmes of few variables and many short rows: the normal equations of a step are small and dense there, and a
//! Cholesky factor of them costs a fraction of a sparse factor of the whole system. Columns are taken in fours, as splines have them. A
//! primal-dual method with the scaling of Nesterov and Todd and Mehrotra's corrector, as in L. Vandenberghe, "The CVXOPT linear and quadratic
//! cone program solvers" (2010). Knows no gears.

use super::{Affine, ConeOptimum, ConeProgramme};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// Steps at most; twenty to thirty are usual.
const STEPS: usize = 80;
/// Share of the way to the boundary of the cones that a step goes.
const SHARE: f64 = 0.99;
/// A step shorter than this gets no further.
const SHORTEST: f64 = 1e-7;
/// Weight of the variables themselves in the normal equations, over the mean of their diagonal: keeps them regular to rounding.
const RIDGE: f64 = 1e-14;

/// The numbers of a bound: one, two or three, the others 0.
type Part = [f64; 3];
/// The unit of their product.
const UNIT: Part = [1.0, 0.0, 0.0];

/// Columns that are taken together: a cubic B-spline has so many that count at a place.
const TOGETHER: usize = 4;
type Columns = [f64; TOGETHER];

/// A bound: one row, two whose first is no smaller than the size of the second, or three whose first is no shorter than the vector of the others.
struct Bound {
    /// First column of each piece, ascending; pieces have no column in common.
    firsts: Vec<usize>,
    /// Factors of the pieces, as many for each as there are rows.
    factors: Vec<Columns>,
    rows: usize,
    constant: Part,
}

impl Bound {
    fn new(rows: &[Affine]) -> Self {
        let mut columns: Vec<usize> = rows.iter().flat_map(|row| row.entries.iter().map(|e| e.0)).collect();
        columns.sort_unstable();
        let mut firsts: Vec<usize> = Vec::new();
        for column in columns {
            if firsts.last().is_none_or(|first| column >= first + TOGETHER) {
                firsts.push(column);
            }
        }
        let mut factors = vec![[0.0; TOGETHER]; firsts.len() * rows.len()];
        let mut constant = [0.0; 3];
        for (j, row) in rows.iter().enumerate() {
            constant[j] = row.constant;
            for (column, factor) in &row.entries {
                let piece = firsts.partition_point(|first| first <= column) - 1;
                factors[piece * rows.len() + j][column - firsts[piece]] += factor;
            }
        }
        Self { firsts, factors, rows: rows.len(), constant }
    }

    /// The first column of each piece and the factors of its rows.
    fn pieces(&self) -> impl Iterator<Item = (usize, &[Columns])> {
        self.firsts.iter().copied().zip(self.factors.chunks_exact(self.rows))
    }

    /// A x.
    fn times(&self, x: &[f64]) -> Part {
        let mut sum = [0.0; 3];
        for (first, rows) in self.pieces() {
            let x = &x[first..first + TOGETHER];
            for (sum, row) in sum.iter_mut().zip(rows) {
                *sum += row.iter().zip(x).map(|(a, x)| a * x).sum::<f64>();
            }
        }
        sum
    }

    /// Adds A^T part.
    fn add_transposed(&self, part: &Part, to: &mut [f64]) {
        for (first, rows) in self.pieces() {
            let to = &mut to[first..first + TOGETHER];
            for (part, row) in part.iter().zip(rows) {
                to.iter_mut().zip(row).for_each(|(to, a)| *to += part * a);
            }
        }
    }

    /// Adds A^T W^-2 A to the lower triangle of a matrix.
    fn add_square(&self, scaling: &Scaling, to: &mut DMatrix<f64>, scaled: &mut Vec<[Columns; 3]>) {
        scaled.clear();
        scaled.extend(self.pieces().map(|(_, rows)| scaling.shrink(rows)));
        match self.rows {
            1 => self.add_products::<1>(scaled, to),
            2 => self.add_products::<2>(scaled, to),
            _ => self.add_products::<3>(scaled, to),
        }
    }

    fn add_products<const ROWS: usize>(&self, scaled: &[[Columns; 3]], to: &mut DMatrix<f64>) {
        let height = to.nrows();
        let to = to.as_mut_slice();
        for (i, (&column, own)) in self.firsts.iter().zip(scaled).enumerate() {
            for (&row, other) in self.firsts[i..].iter().zip(&scaled[i..]) {
                for k in 0..TOGETHER {
                    // Pieces ascend: the lower triangle, down each column, and of a piece with itself the whole square.
                    let from = (column + k) * height + row;
                    let below = &mut to[from..from + TOGETHER];
                    for j in 0..ROWS {
                        let by = own[j][k];
                        below.iter_mut().zip(&other[j]).for_each(|(below, a)| *below += by * a);
                    }
                }
            }
        }
    }
}

fn dot(a: &Part, b: &Part) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// |b| of a vector (a, b).
fn length(v: &Part) -> f64 {
    (v[1] * v[1] + v[2] * v[2]).sqrt()
}

/// a^2 - |b|^2 of a vector (a, b).
fn determinant(v: &Part) -> f64 {
    let length = length(v);
    (v[0] - length) * (v[0] + length)
}

fn plus(a: &Part, by: f64, b: &Part) -> Part {
    [a[0] + by * b[0], a[1] + by * b[1], a[2] + by * b[2]]
}

/// The Jordan product; of numbers, their product.
fn product(a: &Part, b: &Part) -> Part {
    [dot(a, b), a[0] * b[1] + b[0] * a[1], a[0] * b[2] + b[0] * a[2]]
}

/// q with l o q = d.
fn quotient(l: &Part, d: &Part) -> Part {
    let first = (l[0] * d[0] - l[1] * d[1] - l[2] * d[2]) / determinant(l);
    [first, (d[1] - first * l[1]) / l[0], (d[2] - first * l[2]) / l[0]]
}

/// The largest step with v + step d inside the cone.
fn longest(v: &Part, d: &Part) -> f64 {
    let (a, b, c) = (determinant(d), v[0] * d[0] - v[1] * d[1] - v[2] * d[2], determinant(v));
    let root = (b * b - a * c).max(0.0).sqrt();
    // A step that is longer than wide leaves the cone if it goes back, for b is negative then.
    if a < 0.0 || b < 0.0 { c.max(0.0) / (root - b) } else { f64::INFINITY }
}

/// The scaling W = size [a, b; b, 1 + b b^T/(1 + a)] of one bound: W z = W^-1 s.
struct Scaling {
    size: f64,
    direction: Part,
}

impl Scaling {
    fn new(s: &Part, z: &Part) -> Self {
        let (of_s, of_z) = (determinant(s).max(f64::MIN_POSITIVE), determinant(z).max(f64::MIN_POSITIVE));
        let (s, z) = (s.map(|x| x / of_s.sqrt()), z.map(|x| x / of_z.sqrt()));
        let middle = (0.5 * (1.0 + dot(&s, &z))).sqrt();
        let direction = [s[0] + z[0], s[1] - z[1], s[2] - z[2]].map(|x| 0.5 * x / middle);
        Self { size: (of_s / of_z).sqrt().sqrt(), direction }
    }

    /// W v, or W^-1 v for a sign of -1.
    fn apply(&self, sign: f64, v: &Part) -> Part {
        let [a, b, c] = [self.direction[0], sign * self.direction[1], sign * self.direction[2]];
        let along = b * v[1] + c * v[2];
        let more = v[0] + along / (1.0 + a);
        let by = if sign > 0.0 { self.size } else { self.size.recip() };
        [by * (a * v[0] + along), by * (v[1] + b * more), by * (v[2] + c * more)]
    }

    /// W^-1 of the factors of a piece, column by column.
    fn shrink(&self, rows: &[Columns]) -> [Columns; 3] {
        let mut shrunk = [[0.0; TOGETHER]; 3];
        match rows {
            [row] => shrunk[0] = row.map(|a| a / self.size),
            rows => {
                for k in 0..TOGETHER {
                    let third = rows.get(2).map_or(0.0, |row| row[k]);
                    let column = self.apply(-1.0, &[rows[0][k], rows[1][k], third]);
                    shrunk.iter_mut().zip(column).for_each(|(row, a)| row[k] = a);
                }
            }
        }
        shrunk
    }
}

/// A programme in the form in which steps are found.
struct Dense {
    cost: DVector<f64>,
    quadratic: DMatrix<f64>,
    bounds: Vec<Bound>,
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
        let own = programme.cost.len();
        let columns = own + TOGETHER - 1;
        let mut quadratic = DMatrix::zeros(columns, columns);
        for k in own..columns {
            quadratic[(k, k)] = 1.0;
        }
        for &(row, column, value) in &programme.quadratic {
            quadratic[(row, column)] += value;
            if row != column {
                quadratic[(column, row)] += value;
            }
        }
        let rows = programme.positive.iter().map(|row| Bound::new(std::slice::from_ref(row)));
        let strips = programme.strips.iter().map(|strip| Bound::new(strip));
        let bounds = rows.chain(strips).chain(programme.cones.iter().map(|cone| Bound::new(cone))).collect();
        let cost = DVector::from_iterator(columns, programme.cost.iter().copied().chain([0.0; TOGETHER - 1]));
        Self { cost, quadratic, bounds }
    }

    /// P + A^T W^-2 A, factored; `None` where rounding makes it indefinite.
    fn factored(&self, scalings: &[Scaling]) -> Option<Cholesky<f64, Dyn>> {
        let mut normal = self.quadratic.clone();
        let mut scaled = Vec::new();
        for (bound, scaling) in self.bounds.iter().zip(scalings) {
            bound.add_square(scaling, &mut normal, &mut scaled);
        }
        let ridge = RIDGE * normal.trace() / normal.nrows().max(1) as f64;
        for k in 0..normal.nrows() {
            normal[(k, k)] += ridge;
        }
        Cholesky::new(normal)
    }

    fn residual(&self, at: &Point) -> Residual {
        let curved = &self.quadratic * &at.x;
        let mut dual = &curved + &self.cost;
        let mut primal = Vec::with_capacity(self.bounds.len());
        let (mut gap, mut constants) = (0.0, 0.0);
        for ((bound, s), z) in self.bounds.iter().zip(&at.s).zip(&at.z) {
            bound.add_transposed(&z.map(|z| -z), dual.as_mut_slice());
            primal.push(plus(&plus(s, -1.0, &bound.times(at.x.as_slice())), -1.0, &bound.constant));
            gap += dot(s, z);
            constants += dot(&bound.constant, z);
        }
        let half = 0.5 * at.x.dot(&curved);
        let objective = [half + self.cost.dot(&at.x), -half - constants];
        Residual { dual, primal, gap, objective }
    }

    /// Least squares of the bounds, moved into the cones.
    fn start(&self) -> Option<Point> {
        let same: Vec<Scaling> = self.bounds.iter().map(|_| Scaling { size: 1.0, direction: UNIT }).collect();
        let mut right = -&self.cost;
        for bound in &self.bounds {
            bound.add_transposed(&bound.constant.map(|b| -b), right.as_mut_slice());
        }
        let x = self.factored(&same)?.solve(&right);
        let s: Vec<Part> =
            self.bounds.iter().map(|b| plus(&b.times(x.as_slice()), 1.0, &b.constant)).collect();
        let z = s.iter().map(|s| s.map(|s| -s)).collect();
        let inside = |parts: Vec<Part>| -> Vec<Part> {
            let least = parts.iter().map(|v| v[0] - length(v)).fold(f64::INFINITY, f64::min);
            let by = if least > 0.0 { 0.0 } else { 1.0 - least };
            parts.iter().map(|v| [v[0] + by, v[1], v[2]]).collect()
        };
        Some(Point { x, s: inside(s), z: inside(z) })
    }

    /// The step for scaled residuals q of the products of slacks and multipliers.
    fn step(&self, factor: &Cholesky<f64, Dyn>, scalings: &[Scaling], of: &Residual, q: &[Part]) -> Point {
        let mut right = -&of.dual;
        let mut pulls = Vec::with_capacity(q.len());
        for (((bound, scaling), q), primal) in self.bounds.iter().zip(scalings).zip(q).zip(&of.primal) {
            let pull = plus(q, 1.0, &scaling.apply(-1.0, primal));
            bound.add_transposed(&scaling.apply(-1.0, &pull), right.as_mut_slice());
            pulls.push(pull);
        }
        let x = factor.solve(&right);
        let (mut s, mut z) = (Vec::with_capacity(q.len()), Vec::with_capacity(q.len()));
        for (((bound, scaling), pull), primal) in self.bounds.iter().zip(scalings).zip(&pulls).zip(&of.primal)
        {
            let along = bound.times(x.as_slice());
            z.push(scaling.apply(-1.0, &plus(pull, -1.0, &scaling.apply(-1.0, &along))));
            s.push(plus(&along, -1.0, primal));
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
    let count = dense.bounds.len().max(1) as f64;
    let largest_cost = dense.cost.amax().max(1.0);
    let largest_constant = dense.bounds.iter().flat_map(|b| b.constant).fold(1.0, |m: f64, c| m.max(c.abs()));
    for _ in 0..STEPS {
        let of = dense.residual(&at);
        let missing = of.primal.iter().flatten().fold(0.0, |m: f64, r| m.max(r.abs()));
        let size = of.objective[0].abs().min(of.objective[1].abs()).max(1.0);
        let met = of.dual.amax() <= accuracy * largest_cost && missing <= accuracy * largest_constant;
        if met && of.gap <= accuracy * size {
            let x = at.x.iter().copied().take(programme.cost.len()).collect();
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
