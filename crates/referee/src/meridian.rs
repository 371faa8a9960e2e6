//! The dresser as the referee sees it: its meridian as an axial position over the radius, a spline of the referee's own.

use super::RemovalError;
use foundation::geometry::Revolution;
use foundation::numerics::CubicSpline;
use num_dual::Dual64;

/// Largest distance between spline and meridian that ends the refinement, mm: for surfaces through many rays.
pub(super) const TOLERANCE: f64 = 1e-11;
/// The same where single rays are asked as exactly as can be.
pub(super) const FINEST: f64 = 1e-13;
/// Intervals to begin with: enough for a smooth profile.
const INTERVALS: usize = 256;
/// Rounds of halving. Where the profile has a kink, twenty bring the knots together to 1e-7 mm and less.
const ROUNDS: usize = 20;

/// Z(r) of one flank of the dresser.
#[derive(Clone, Debug)]
pub(super) struct Meridian {
    spline: CubicSpline,
    /// +1 when the outward normal points to larger z.
    pub side: f64,
    /// Largest distance from the profile found midway between the knots, mm.
    pub error: f64,
}

/// A point of the profile with its parameter.
#[derive(Clone, Copy)]
struct Node {
    t: f64,
    r: f64,
    z: f64,
}

impl Meridian {
    /// Samples a profile over its whole parameter interval and halves the intervals in whose middle the spline misses it by more than
    /// `tolerance`, mm.
    ///
    /// # Errors
    /// [`RemovalError::ProfileFolds`] where radius or normal turn back.
    pub fn new(profile: &Revolution, tolerance: f64) -> Result<Self, RemovalError> {
        let (first, last) = profile.interval();
        let (start, end) = (profile.at(first), profile.at(last));
        let side = start.n_z.signum();
        let direction = if end.r > start.r { 1.0 } else { -1.0 };
        let (mut t, low, high) =
            if direction > 0.0 { (first, start.r, end.r) } else { (last, end.r, start.r) };
        let mut knots = Vec::with_capacity(2 * INTERVALS);
        for k in 0..=INTERVALS {
            let r = low + (high - low) * k as f64 / INTERVALS as f64;
            let node = node_at(profile, r, t, direction, side)?;
            t = node.t;
            knots.push(node);
        }
        let middle =
            |a: &Node, b: &Node| node_at(profile, 0.5 * (a.r + b.r), 0.5 * (a.t + b.t), direction, side);
        let mut middles = knots.windows(2).map(|p| middle(&p[0], &p[1])).collect::<Result<Vec<_>, _>>()?;
        let mut round = 0;
        loop {
            let [r, z] =
                [|node: &Node| node.r, |node: &Node| node.z].map(|f| knots.iter().map(f).collect::<Vec<_>>());
            let spline = CubicSpline::new(&r, &z)?;
            let miss = |node: &Node| (spline.value(node.r) - node.z).abs();
            let error = middles.iter().map(miss).fold(0.0, f64::max);
            if error <= tolerance || round == ROUNDS {
                return Ok(Self { spline, side, error });
            }
            let mut finer = Vec::with_capacity(2 * knots.len());
            let mut between = Vec::with_capacity(2 * knots.len());
            for (pair, node) in knots.windows(2).zip(&middles) {
                finer.push(pair[0]);
                if miss(node) > tolerance {
                    between.push(middle(&pair[0], node)?);
                    between.push(middle(node, &pair[1])?);
                    finer.push(*node);
                } else {
                    between.push(*node);
                }
            }
            finer.extend(knots.last());
            (knots, middles) = (finer, between);
            round += 1;
        }
    }

    /// `[Z, Z']` at radius r; `None` where the profile ends.
    #[inline]
    pub fn at(&self, r: f64) -> Option<[f64; 2]> {
        let [low, high] = self.spline.domain();
        if r < low || r > high {
            return None;
        }
        let [z, slope, ..] = self.spline.derivatives(r);
        Some([z, slope])
    }
}

/// The profile point at radius r by Newton on r(t), from a parameter close by.
fn node_at(
    profile: &Revolution,
    r: f64,
    start: f64,
    direction: f64,
    side: f64,
) -> Result<Node, RemovalError> {
    let mut t = start;
    // Newton settles in three steps from a neighbour; sixty mean that the profile turns back.
    for _ in 0..60 {
        let at = profile.at(Dual64::from_re(t).derivative());
        if at.r.eps * direction <= 0.0 || at.n_z.re * side <= 0.0 {
            break;
        }
        let step = (r - at.r.re) / at.r.eps;
        t += step;
        // The last step is taken in z to first order instead of evaluating once more: its square is below rounding.
        if step.abs() < 1e-9 {
            return Ok(Node { t, r, z: at.z.re + at.z.eps * step });
        }
    }
    Err(RemovalError::ProfileFolds { t, r })
}
