//! The motion of dressing as axes drive it: corrections over the worm position v_zS, in place of laws over x_D
//! (`docs/mathematics/tangential-dressing.md#channels-and-variables`, mapping to the chains).

use super::TangentialError;
use super::forward::TangentialFlank;
use foundation::geometry::Revolution;
use foundation::kinematics::{DressingMotion, DressingPosition, MotionLaw};
use foundation::numerics::Chebyshev;

/// Accuracy of the corrections as series over v_zS, mm and rad.
const ACCURACY: f64 = 3e-13;
/// Nodes of the series: first try, and most; splines need many.
const NODES: [usize; 2] = [24, 1536];

/// Where the axes of dressing stand at one x_D. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DressingRow {
    /// x_D.
    pub position: f64,
    /// v_zS: axial position of the worm.
    pub worm_shift: f64,
    /// phi_S.
    pub worm_angle: f64,
    /// gamma_A.
    pub crossing_angle: f64,
    /// d_A.
    pub centre_distance: f64,
    /// v_yA.
    pub offset: f64,
}

impl DressingRow {
    /// The same as worm and dresser stand.
    pub fn stand(&self) -> DressingPosition {
        DressingPosition {
            worm_angle: self.worm_angle,
            worm_shift: self.worm_shift,
            crossing_angle: self.crossing_angle,
            centre_distance: self.centre_distance,
            offset: self.offset,
        }
    }
}

impl TangentialFlank<'_> {
    /// The axes at x_D.
    pub fn dressing_row(&self, x_d: f64) -> DressingRow {
        let (laws, chain) = (&self.surface().laws, self.surface().chain);
        let crossing_angle = chain.crossing_angle + laws.angle.value(x_d);
        let tangential = laws.tangential.value(x_d);
        DressingRow {
            position: x_d,
            worm_shift: -(x_d + laws.axial.value(x_d)) + tangential * crossing_angle.tan(),
            worm_angle: self.surface().worm_angle(x_d),
            crossing_angle,
            centre_distance: chain.centre_distance + laws.distance.value(x_d),
            offset: tangential / crossing_angle.cos(),
        }
    }

    /// The motion over v_zS while x_D runs through `positions`, and the worm positions of its ends, ascending.
    ///
    /// # Errors
    /// [`TangentialError::InvalidNumber`] if v_zS does not follow x_D strictly: the axial offset then runs faster than the worm.
    pub fn dressing_motion(
        &self,
        positions: [f64; 2],
    ) -> Result<(DressingMotion, [f64; 2]), TangentialError> {
        let chain = self.surface().chain;
        let ends = positions.map(|x| self.dressing_row(x).worm_shift);
        let (from, to) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let [mut count, most] = NODES;
        loop {
            let rows = self.rows_at(&Chebyshev::nodes(from, to, count), positions)?;
            let fit = |value: &dyn Fn(&DressingRow) -> f64| {
                Chebyshev::interpolate(from, to, &rows.iter().map(value).collect::<Vec<_>>())
            };
            let series = [
                fit(&|r| r.worm_angle - chain.worm_angle - r.worm_shift / chain.screw_parameter),
                fit(&|r| r.crossing_angle - chain.crossing_angle),
                fit(&|r| r.centre_distance - chain.centre_distance),
                fit(&|r| r.offset),
            ];
            if series.iter().all(|s| s.tail() < ACCURACY) || count >= most {
                let correction = series.map(|s| MotionLaw::series(s.truncated(1e-17)));
                return Ok((DressingMotion { chain, correction }, [from, to]));
            }
            count *= 2;
        }
    }

    /// Rows at given worm positions.
    fn rows_at(&self, shifts: &[f64], positions: [f64; 2]) -> Result<Vec<DressingRow>, TangentialError> {
        let laws = &self.surface().laws;
        let angle_0 = self.surface().chain.crossing_angle;
        let one = |&v: &f64| {
            let mut x = -v;
            for _ in 0..50 {
                let (axial, tangential, angle) =
                    (laws.axial.jet(x), laws.tangential.jet(x), laws.angle.jet(x));
                let tan = (angle_0 + angle[0]).tan();
                let slope =
                    -(1.0 + axial[1]) + tangential[1] * tan + tangential[0] * (1.0 + tan * tan) * angle[1];
                let step = (-(x + axial[0]) + tangential[0] * tan - v) / slope;
                // Written so that NaN is refused as well.
                if !(slope < 0.0 && step.is_finite()) {
                    break;
                }
                x -= step;
                if step.abs() <= 1e-13 * (1.0 + x.abs()) {
                    return Ok(self.dressing_row(x));
                }
            }
            Err(TangentialError::InvalidNumber {
                field: "axial offset dX of the dresser near x_D",
                value: x.clamp(positions[0].min(positions[1]), positions[0].max(positions[1])),
                allowed: "where the worm advances all the time: smaller coefficients of dX and Fz",
            })
        };
        shifts.iter().map(one).collect()
    }

    /// The side of the dresser that dresses this flank, its profile function included, over s. It goes on beyond the tips of the tools, so
    /// that what lies beside the used part of the worm is a surface as well; that nothing used lies there is checked with the flank. A
    /// profile with a spline ends where the spline does.
    pub fn dresser(&self) -> Revolution {
        let surface = self.surface();
        let heights = spline_heights(&surface.laws.profile);
        surface.profile.revolution(surface.sigma, heights, |s| surface.laws.profile.value(s))
    }
}

/// How far the border pieces of a spline continue it, mm.
const BEYOND_SPLINE: f64 = 0.35;

/// Where all splines of a law hold; everywhere without one.
fn spline_heights(law: &MotionLaw) -> [f64; 2] {
    match law {
        MotionLaw::BSpline { spline, stretch, .. } => {
            let [a, b] = spline.basis().interval().map(|x| x / stretch);
            [a.min(b) - BEYOND_SPLINE, a.max(b) + BEYOND_SPLINE]
        }
        MotionLaw::Sum(laws) => laws
            .iter()
            .map(spline_heights)
            .fold([f64::NEG_INFINITY, f64::INFINITY], |[a, b], [from, to]| [a.max(from), b.min(to)]),
        _ => [f64::NEG_INFINITY, f64::INFINITY],
    }
}
