//! Pseudo-arclength continuation: follows the solutions of N equations in N unknowns and one parameter, round folds of the
//! unknowns, up to the first event (`docs/mathematics/dressing.md#conditions`). Knows no gears.

use crate::numerics::brent;
use nalgebra::{Const, DMatrix, DimMin, SMatrix, SVector};

/// How a path is followed. Unknowns and parameter are taken as scaled by the caller: lengths are those of the scaled path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContinuationOptions {
    /// First step along the path.
    pub first_step: f64,
    /// Longest step along the path.
    pub longest_step: f64,
    /// Below this step the path counts as broken off.
    pub least_step: f64,
    /// Down to this step the monitor may ask for shorter ones.
    pub finest_step: f64,
    /// An event is placed on the path to this length.
    pub event_tolerance: f64,
    /// Most points of a path.
    pub points: usize,
}

impl Default for ContinuationOptions {
    fn default() -> Self {
        Self {
            first_step: 0.15,
            longest_step: 5.0,
            least_step: 1e-6,
            finest_step: 1e-3,
            event_tolerance: 1e-6,
            points: 2000,
        }
    }
}

/// A solution on the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPoint<const N: usize> {
    /// Unknowns.
    pub x: SVector<f64, N>,
    /// Parameter.
    pub parameter: f64,
    /// Change of the parameter per length of the path; its sign changes at a fold.
    pub slope: f64,
}

/// What the caller's monitor says of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Watch<S> {
    /// How far the caller's limit is away, in any unit (finite, continuous along the path; < 0 or NaN: beyond it), and which one it is.
    Margin(f64, S),
    /// The point before is too far away for the caller: come here in shorter steps.
    TooFar,
}

/// Why a path ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PathEnd<S> {
    /// The parameter has reached its target.
    Target,
    /// The parameter goes no further: the path turns back.
    Fold,
    /// The equations cannot be evaluated or solved beyond the last point.
    Broken,
    /// The monitor's limit is reached.
    Stopped(S),
    /// The path has as many points as allowed.
    TooLong,
}

/// A followed path; its last point is that of the event.
#[derive(Clone, Debug, PartialEq)]
pub struct Path<const N: usize, S> {
    /// Solutions from the start to the event.
    pub points: Vec<PathPoint<N>>,
    /// The event.
    pub end: PathEnd<S>,
}

impl<const N: usize, S> Path<N, S> {
    /// The point of the event.
    pub fn last(&self) -> &PathPoint<N> {
        // A path is made with its start in it.
        &self.points[self.points.len() - 1]
    }
}

/// Residual, Jacobian by the unknowns, derivative by the parameter.
pub type ParameterLinearised<const N: usize> = (SVector<f64, N>, SMatrix<f64, N, N>, SVector<f64, N>);

/// Smallest cosine between the tangents at both ends of a step.
const STRAIGHT: f64 = 0.9;
/// The step grows by this factor after an easy corrector, and shrinks by that one after a failure.
const GROWTH: (f64, f64) = (1.4, 0.5);
/// A corrector is easy with fewer iterations than this, and fails beyond that many.
const ITERATIONS: (usize, usize) = (5, 10);
/// Corrector: converged below the first, converged when stalled below the second (as [`super::NewtonOptions`]).
const CORRECTED: (f64, f64) = (1e-10, 1e-7);
/// A correction above this share of the step leads to another branch; tangents within [`STRAIGHT`] need a quarter.
const NEAR: f64 = 0.5;

/// A point with the unit tangent of the path; index N of both is the parameter.
struct Node<const M: usize> {
    y: SVector<f64, M>,
    tangent: SVector<f64, M>,
}

/// Follows the path from the solution (`x`, `parameter`), with the parameter rising (`direction` > 0) or falling first, until
/// an event: `target`, a fold, a margin of the monitor below 0, or the end of the domain. M is N + 1.
///
/// `equations` returns `None` outside their domain. `monitor` is asked of every new point, with the point before it.
/// `None` if the equations cannot be evaluated at the start or have no unique path there.
pub fn follow<const N: usize, const M: usize, S: Copy>(
    (x, parameter): (SVector<f64, N>, f64),
    direction: f64,
    target: Option<f64>,
    options: &ContinuationOptions,
    equations: impl FnMut(&SVector<f64, N>, f64) -> Option<ParameterLinearised<N>>,
    mut monitor: impl FnMut(&PathPoint<N>, &PathPoint<N>) -> Watch<S>,
) -> Option<Path<N, S>>
where
    Const<M>: DimMin<Const<M>, Output = Const<M>>,
{
    const { assert!(M == N + 1, "one unknown more than equations") };
    let sign = if direction < 0.0 { -1.0 } else { 1.0 };
    let mut tracer = Tracer { equations };
    let mut here = tracer.start(&x, parameter, sign)?;
    let mut points = vec![point(&here)];
    // Distances to the events: above 0 before, at most 0 from the event on.
    let to_fold = |node: &Node<M>| sign * node.tangent[N];
    let to_target = |node: &Node<M>| target.map_or(f64::INFINITY, |t| sign * (t - node.y[N]));
    let ended = |points, end| Some(Path { points: advancing(points, sign), end });
    let within = |margin: f64| margin >= 0.0;
    let mut margin_here = 1.0;
    if let Watch::Margin(margin, limit) = monitor(&points[0], &points[0]) {
        if !within(margin) {
            return ended(points, PathEnd::Stopped(limit));
        }
        margin_here = margin;
    }
    if to_target(&here) <= 0.0 {
        return ended(points, PathEnd::Target);
    }
    let mut step = options.first_step.min(options.longest_step);
    while points.len() < options.points {
        if step < options.least_step {
            return ended(points, PathEnd::Broken);
        }
        let Some((next, iterations)) =
            tracer.corrected(&here, step).filter(|(next, _)| next.tangent.dot(&here.tangent) >= STRAIGHT)
        else {
            step *= GROWTH.1;
            continue;
        };
        let before = point(&here);
        let (margin, limit) = match monitor(&before, &point(&next)) {
            Watch::TooFar if step > options.finest_step => {
                step *= GROWTH.1;
                continue;
            }
            Watch::TooFar => (margin_here, None),
            Watch::Margin(margin, limit) => (margin, Some(limit)),
        };
        let tolerance = options.event_tolerance;
        let mut events: Vec<(f64, Node<M>, PathEnd<S>)> = Vec::new();
        if to_fold(&next) <= 0.0 {
            let (at, node) = tracer.placed(&here, step, [&here, &next].map(to_fold), tolerance, to_fold);
            events.push((at, node, PathEnd::Fold));
        }
        if to_target(&next) <= 0.0 {
            let (at, node) = tracer.placed(&here, step, [&here, &next].map(to_target), tolerance, to_target);
            events.push((at, node, PathEnd::Target));
        }
        if let (false, Some(limit)) = (within(margin), limit) {
            let mut first = limit;
            // Beyond the domain of the margin the size of its last value keeps the search going.
            let beyond = |margin: f64| if margin.is_nan() { -margin_here.abs().max(1.0) } else { margin };
            let to_limit = |node: &Node<M>| match monitor(&before, &point(node)) {
                Watch::Margin(margin, limit) => {
                    first = if within(margin) { first } else { limit };
                    beyond(margin)
                }
                Watch::TooFar => margin_here,
            };
            let ends = [margin_here, beyond(margin)];
            let (at, node) = tracer.placed(&here, step, ends, tolerance, to_limit);
            events.push((at, node, PathEnd::Stopped(first)));
        }
        if let Some((at, node, end)) = events.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)) {
            if at > 0.0 {
                points.push(point(&node));
            }
            return ended(points, end);
        }
        (here, margin_here) = (next, margin);
        points.push(point(&here));
        if iterations < ITERATIONS.0 {
            step = f64::min(step * GROWTH.0, options.longest_step);
        }
    }
    ended(points, PathEnd::TooLong)
}

/// The points without those that a later one, off by the tolerance of the corrector, has not passed: near a fold or the end of
/// the domain the parameter hardly changes any more.
fn advancing<const N: usize>(points: Vec<PathPoint<N>>, sign: f64) -> Vec<PathPoint<N>> {
    let mut kept: Vec<PathPoint<N>> = Vec::with_capacity(points.len());
    for at in points {
        let passes = |earlier: &PathPoint<N>| sign * (at.parameter - earlier.parameter) > 0.0;
        while kept.len() > 1 && !passes(&kept[kept.len() - 1]) {
            kept.pop();
        }
        if kept.first().is_none_or(passes) {
            kept.push(at);
        }
    }
    kept
}

fn point<const N: usize, const M: usize>(node: &Node<M>) -> PathPoint<N> {
    PathPoint { x: SVector::from_fn(|i, _| node.y[i]), parameter: node.y[N], slope: node.tangent[N] }
}

struct Tracer<E> {
    equations: E,
}

impl<E> Tracer<E> {
    /// Residual, and its derivative by all unknowns with a last row left zero.
    fn linearised<const N: usize, const M: usize>(
        &mut self,
        y: &SVector<f64, M>,
    ) -> Option<(SVector<f64, M>, SMatrix<f64, M, M>)>
    where
        E: FnMut(&SVector<f64, N>, f64) -> Option<ParameterLinearised<N>>,
    {
        let (r, j, by) = (self.equations)(&SVector::from_fn(|i, _| y[i]), y[N])?;
        let residual: SVector<f64, M> = SVector::from_fn(|i, _| if i < N { r[i] } else { 0.0 });
        let matrix: SMatrix<f64, M, M> = SMatrix::from_fn(|i, k| match (i < N, k < N) {
            (true, true) => j[(i, k)],
            (true, false) => by[i],
            _ => 0.0,
        });
        residual.iter().chain(matrix.iter()).all(|x| x.is_finite()).then_some((residual, matrix))
    }

    /// The start with its tangent: the null vector of the derivative.
    fn start<const N: usize, const M: usize>(
        &mut self,
        x: &SVector<f64, N>,
        parameter: f64,
        sign: f64,
    ) -> Option<Node<M>>
    where
        E: FnMut(&SVector<f64, N>, f64) -> Option<ParameterLinearised<N>>,
    {
        let y = SVector::from_fn(|i, _| if i < N { x[i] } else { parameter });
        let (_, matrix) = self.linearised(&y)?;
        let svd = DMatrix::from_fn(M, M, |i, k| matrix[(i, k)]).svd(false, true);
        let rows = svd.v_t?;
        // The row of zeros is the smallest singular value; a second one as small leaves the path undetermined.
        let mut order: Vec<usize> = (0..M).collect();
        order.sort_by(|&a, &b| svd.singular_values[a].total_cmp(&svd.singular_values[b]));
        let largest = svd.singular_values[order[M - 1]];
        if N > 0 && svd.singular_values[order[1]] <= 1e-15 * largest {
            return None;
        }
        let tangent = SVector::from_fn(|k, _| rows[(order[0], k)]);
        let turned = if sign * tangent[N] < 0.0 { -tangent } else { tangent };
        Some(Node { y, tangent: turned })
    }

    /// The point of the path a step further on, and the iterations it took.
    fn corrected<const N: usize, const M: usize>(
        &mut self,
        from: &Node<M>,
        step: f64,
    ) -> Option<(Node<M>, usize)>
    where
        E: FnMut(&SVector<f64, N>, f64) -> Option<ParameterLinearised<N>>,
        Const<M>: DimMin<Const<M>, Output = Const<M>>,
    {
        let mut y = from.y + from.tangent * step;
        let mut last = f64::INFINITY;
        for iteration in 1..=ITERATIONS.1 {
            let (residual, mut matrix) = self.linearised(&y)?;
            // Bordered by the plane across the tangent, in which the corrector stays.
            matrix.set_row(N, &from.tangent.transpose());
            let lu = matrix.lu();
            let correction = lu.solve(&residual)?;
            let size = correction.norm();
            // A NaN is no correction either.
            if size.is_nan() || size > NEAR * step.max(CORRECTED.1) {
                return None;
            }
            y -= correction;
            if size < CORRECTED.0 || (size < CORRECTED.1 && size >= NEAR * last) {
                let mut border = SVector::<f64, M>::zeros();
                border[N] = 1.0;
                let tangent = lu.solve(&border)?;
                return Some((Node { y, tangent: tangent / tangent.norm() }, iteration));
            }
            last = size;
        }
        None
    }

    /// Where within `step` the distance falls from `ends[0]` to `ends[1]` <= 0: a point that is not beyond it by more than
    /// rounding, the tolerance before the place itself.
    fn placed<const N: usize, const M: usize>(
        &mut self,
        from: &Node<M>,
        step: f64,
        ends: [f64; 2],
        tolerance: f64,
        mut distance: impl FnMut(&Node<M>) -> f64,
    ) -> (f64, Node<M>)
    where
        E: FnMut(&SVector<f64, N>, f64) -> Option<ParameterLinearised<N>>,
        Const<M>: DimMin<Const<M>, Output = Const<M>>,
    {
        let root = brent([0.0, step], ends, tolerance, |at| {
            self.corrected(from, at).map(|(node, _)| distance(&node))
        });
        // Where the corrector fails on the way, the event is put at the start of the step: on the safe side.
        let at = root.map_or(0.0, |at| f64::max(at - tolerance, 0.0));
        match self.corrected(from, at) {
            Some((node, _)) if at > 0.0 => (at, node),
            _ => (0.0, Node { y: from.y, tangent: from.tangent }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix1, Matrix2, Vector1, Vector2};

    fn free<const N: usize>(_: &PathPoint<N>, _: &PathPoint<N>) -> Watch<()> {
        Watch::Margin(1.0, ())
    }

    fn one(r: f64, by_x: f64, by_parameter: f64) -> Option<ParameterLinearised<1>> {
        Some((Vector1::new(r), Matrix1::new(by_x), Vector1::new(by_parameter)))
    }

    /// parameter = x^3 - 3 x.
    fn cubic(x: &Vector1<f64>, c: f64) -> Option<ParameterLinearised<1>> {
        let x = x[0];
        one(x * x * x - 3.0 * x - c, 3.0 * x * x - 3.0, -1.0)
    }

    #[test]
    fn folds_are_found_and_placed() {
        let options = ContinuationOptions::default();
        let path = follow::<1, 2, ()>((Vector1::new(-3.0), -18.0), 1.0, None, &options, cubic, free).unwrap();
        assert_eq!(path.end, PathEnd::Fold);
        assert!((path.last().parameter - 2.0).abs() < 1e-10, "{}", path.last().parameter);
        assert!((path.last().x[0] + 1.0).abs() < 1e-5 && path.points.len() < 60);
        assert!(path.points.windows(2).all(|p| p[1].parameter > p[0].parameter));
        for p in &path.points {
            assert!((p.x[0].powi(3) - 3.0 * p.x[0] - p.parameter).abs() < 1e-12);
        }
        // From the middle branch the parameter falls towards the other fold.
        let path = follow::<1, 2, ()>((Vector1::new(0.0), 0.0), -1.0, None, &options, cubic, free).unwrap();
        assert_eq!(path.end, PathEnd::Fold);
        assert!((path.last().parameter + 2.0).abs() < 1e-10 && (path.last().x[0] - 1.0).abs() < 1e-5);
    }

    /// Steady temperature of a burning slab (Bratu in two nodes): 2 a - b = k e^a, 2 b - a = k e^b; on a = b the fold is at
    /// a = 1, k = 1/e.
    #[test]
    fn a_fold_of_two_equations() {
        let slab = |x: &Vector2<f64>, k: f64| {
            let (a, b) = (x[0], x[1]);
            Some((
                Vector2::new(2.0 * a - b - k * a.exp(), 2.0 * b - a - k * b.exp()),
                Matrix2::new(2.0 - k * a.exp(), -1.0, -1.0, 2.0 - k * b.exp()),
                Vector2::new(-a.exp(), -b.exp()),
            ))
        };
        let options = ContinuationOptions::default();
        let path = follow::<2, 3, ()>((Vector2::zeros(), 0.0), 1.0, None, &options, slab, free).unwrap();
        assert_eq!(path.end, PathEnd::Fold);
        assert!((path.last().parameter - (-1f64).exp()).abs() < 1e-10, "{}", path.last().parameter);
        assert!((path.last().x[0] - 1.0).abs() < 1e-4 && (path.last().x[1] - 1.0).abs() < 1e-4);
    }

    #[test]
    fn the_target_is_reached_before_the_fold() {
        let options = ContinuationOptions::default();
        let path =
            follow::<1, 2, ()>((Vector1::new(-3.0), -18.0), 1.0, Some(1.0), &options, cubic, free).unwrap();
        assert_eq!(path.end, PathEnd::Target);
        assert!((path.last().parameter - 1.0).abs() < 1e-5 && path.last().parameter <= 1.0);
        let at_once =
            follow::<1, 2, ()>((Vector1::new(-3.0), -18.0), 1.0, Some(-18.0), &options, cubic, free).unwrap();
        assert_eq!((at_once.end, at_once.points.len()), (PathEnd::Target, 1));
    }

    #[test]
    fn the_path_breaks_off_where_the_equations_end() {
        // The root's slope is infinite at the end of its domain, x = 1, which is reached at parameter 1.
        let root = |x: &Vector1<f64>, c: f64| {
            let rest = 1.0 - x[0];
            (rest > 0.0)
                .then(|| (Vector1::new(1.0 - rest.sqrt() - c), rest.sqrt()))
                .and_then(|(r, root)| one(r[0], 0.5 / root, -1.0))
        };
        let options = ContinuationOptions::default();
        let path = follow::<1, 2, ()>((Vector1::new(0.0), 0.0), 1.0, None, &options, root, free).unwrap();
        assert_eq!(path.end, PathEnd::Broken);
        assert!((path.last().parameter - 1.0).abs() < 1e-5, "{}", path.last().parameter);
        assert!(follow::<1, 2, ()>((Vector1::new(2.0), 0.0), 1.0, None, &options, root, free).is_none());
        // An equation that says nothing has no path.
        let nothing = |_: &Vector1<f64>, _: f64| one(0.0, 0.0, 0.0);
        assert!(follow::<1, 2, ()>((Vector1::new(2.0), 0.0), 1.0, None, &options, nothing, free).is_none());
    }

    #[test]
    fn the_monitor_stops_and_shortens() {
        let options = ContinuationOptions::default();
        let start = (Vector1::new(-3.0), -18.0);
        let limit = |_: &PathPoint<1>, p: &PathPoint<1>| Watch::Margin(-2.0 - p.x[0], 'x');
        let path = follow::<1, 2, char>(start, 1.0, None, &options, cubic, limit).unwrap();
        assert_eq!(path.end, PathEnd::Stopped('x'));
        let at = path.last().x[0];
        assert!(at <= -2.0 && (at + 2.0).abs() < 2e-6, "{at}");
        // A margin with a jump.
        let jump = |_: &PathPoint<1>, p: &PathPoint<1>| {
            Watch::Margin(if p.parameter < -7.0 { 5.0 } else { -0.1 }, 'j')
        };
        let path = follow::<1, 2, char>(start, 1.0, None, &options, cubic, jump).unwrap();
        assert!(path.end == PathEnd::Stopped('j') && (path.last().parameter + 7.0).abs() < 1e-5);
        // A margin that has no value beyond its limit.
        let sudden = |_: &PathPoint<1>, p: &PathPoint<1>| {
            Watch::Margin(if p.parameter < -7.0 { 5.0 } else { f64::NAN }, 's')
        };
        let path = follow::<1, 2, char>(start, 1.0, None, &options, cubic, sudden).unwrap();
        assert!(path.end == PathEnd::Stopped('s') && (path.last().parameter + 7.0).abs() < 1e-5);
        let closed = |_: &PathPoint<1>, _: &PathPoint<1>| Watch::Margin(-1.0, 'c');
        let path = follow::<1, 2, char>(start, 1.0, None, &options, cubic, closed).unwrap();
        assert_eq!((path.end, path.points.len()), (PathEnd::Stopped('c'), 1));
        let near = |a: &PathPoint<1>, b: &PathPoint<1>| {
            if (b.x[0] - a.x[0]).abs() > 0.01 { Watch::TooFar } else { Watch::Margin(1.0, 'n') }
        };
        let path = follow::<1, 2, char>(start, 1.0, None, &options, cubic, near).unwrap();
        assert!(
            path.end == PathEnd::Fold
                && path.points.windows(2).all(|p| (p[1].x[0] - p[0].x[0]).abs() <= 0.01)
        );
        let short = ContinuationOptions { points: 7, ..options };
        let path = follow::<1, 2, char>(start, 1.0, None, &short, cubic, near).unwrap();
        assert_eq!((path.end, path.points.len()), (PathEnd::TooLong, 7));
    }
}
