//! The dresser as the referee sees it: its meridian as an axial position over the radius, a spline of the referee's own.

use super::RemovalError;
use crate::geometry::Revolution;
use crate::numerics::CubicSpline;
use num_dual::Dual64;

/// Largest distance between spline and meridian that ends the refinement, mm.
const TOLERANCE: f64 = 1e-11;
/// First and largest number of intervals. 256 nodes over some 10 mm are fine for smooth profiles; 65536 put the knots
/// 0.2 um apart, beyond which only the file of a measured profile would have structure.
const INTERVALS: [usize; 2] = [256, 65_536];

/// Z(r) of one flank of the dresser.
#[derive(Clone, Debug)]
pub(super) struct Meridian {
    spline: CubicSpline,
    /// +1 when the outward normal points to larger z.
    pub side: f64,
    /// Largest distance from the profile found midway between the knots, mm.
    pub error: f64,
}

impl Meridian {
    /// Samples a profile over its whole parameter interval, halving the steps until it is met.
    ///
    /// # Errors
    /// [`RemovalError::ProfileFolds`] where radius or normal turn back.
    pub fn new(profile: &Revolution) -> Result<Self, RemovalError> {
        let (first, last) = profile.interval();
        let (start, end) = (profile.at(first), profile.at(last));
        let side = start.n_z.signum();
        let rising = end.r > start.r;
        // Abscissae ascend in r; t runs with them or against them.
        let (t_low, low, high) = if rising { (first, start.r, end.r) } else { (last, end.r, start.r) };
        let direction = if rising { 1.0 } else { -1.0 };
        let sample = |radii: &[f64]| -> Result<Vec<f64>, RemovalError> {
            let mut t = t_low;
            radii.iter().map(|&r| axial_at(profile, r, &mut t, direction, side)).collect()
        };
        let radii = |count: usize, offset: f64, intervals: usize| -> Vec<f64> {
            (0..count).map(|k| low + (high - low) * (k as f64 + offset) / intervals as f64).collect()
        };
        let [mut intervals, most] = INTERVALS;
        let mut knots = radii(intervals + 1, 0.0, intervals);
        let mut values = sample(&knots)?;
        loop {
            let spline = CubicSpline::new(&knots, &values)?;
            let between = radii(intervals, 0.5, intervals);
            let exact = sample(&between)?;
            let error =
                between.iter().zip(&exact).map(|(&r, z)| (spline.value(r) - z).abs()).fold(0.0, f64::max);
            if error <= TOLERANCE || intervals >= most {
                return Ok(Self { spline, side, error });
            }
            intervals *= 2;
            knots = radii(intervals + 1, 0.0, intervals);
            values = interleaved(&values, &exact);
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

fn interleaved(knots: &[f64], between: &[f64]) -> Vec<f64> {
    let mut all = Vec::with_capacity(knots.len() + between.len());
    for (i, &value) in knots.iter().enumerate() {
        all.push(value);
        all.extend(between.get(i));
    }
    all
}

/// Axial position at radius r by Newton on r(t), from the parameter of the neighbour.
fn axial_at(
    profile: &Revolution,
    r: f64,
    t: &mut f64,
    direction: f64,
    side: f64,
) -> Result<f64, RemovalError> {
    // Newton settles in three steps from a neighbour; sixty mean that the profile turns back.
    for _ in 0..60 {
        let at = profile.at(Dual64::from_re(*t).derivative());
        if at.r.eps * direction <= 0.0 || at.n_z.re * side <= 0.0 {
            break;
        }
        let step = (r - at.r.re) / at.r.eps;
        // The last step is taken in z to first order instead of evaluating once more: its square is below rounding.
        if step.abs() < 1e-9 {
            return Ok(at.z.re + at.z.eps * step);
        }
        *t += step;
    }
    Err(RemovalError::ProfileFolds { t: *t, r })
}
