//! The range of profile crownings that a dresser can make by its position alone: the solutions of the three-point rows with
//! radius map, followed from a start both ways until something ends them (`docs/mathematics/dressing.md#conditions`). Works in the tilt
//! chart, because the pole of the K chart lies inside the range.

use crate::conditions::path_end::{axis_margin, reason_of_break, tilt_scale};
use crate::{DressedProfile, DressingError, FlankDresser, PathReason, TiltChart};
use foundation::inverse::{
    ContinuationOptions, NewtonOptions, ParameterLinearised, Path, PathEnd, PathPoint, Watch, follow, newton,
};
use foundation::kinematics::DressingCorrection;
use nalgebra::{SMatrix, SVector, Vector4};

/// Profile crowning of the gear by three pitch points (both ends and the middle of the used range) and the radius map.
#[derive(Clone, Copy, Debug)]
pub struct CrowningRows<'a> {
    dresser: &'a FlankDresser,
    reference_radius: f64,
    cos_gear_base_helix: f64,
    start: DressingCorrection,
    base: [f64; 3],
}

/// What else ends the range. By default nothing does.
#[derive(Clone, Copy, Default)]
pub struct CrowningLimits<'a> {
    /// Smallest and largest value of each component of DK: rad, rad, mm, mm.
    pub axes: Option<[[f64; 2]; 4]>,
    /// A margin of the caller at a correction, such as a clearance less the wanted one: finite, >= 0 allowed, < 0 or NaN not,
    /// continuous in DK.
    pub margin: Option<&'a (dyn Fn(&DressingCorrection) -> f64 + 'a)>,
}

/// A solution on the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrowningPoint {
    /// Profile crowning of the gear beyond that of the start, transverse, mm; > 0 convex gear.
    pub crowning: f64,
    /// DK, continuous along the path.
    pub dk: DressingCorrection,
    /// The same in the tilt chart, absolute.
    pub chart: TiltChart,
    /// Relative stretch P_FS of the profile.
    pub stretch: f64,
}

/// One end of the range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrowningEnd {
    /// Profile crowning c, mm.
    pub crowning: f64,
    /// What is there.
    pub reason: PathReason,
}

/// The range of crownings with all solutions on the way.
#[derive(Clone, Debug, PartialEq)]
pub struct CrowningRange {
    /// Smallest crowning.
    pub smallest: CrowningEnd,
    /// Largest crowning.
    pub largest: CrowningEnd,
    /// Solutions in ascending crowning, both ends with them; without those whose circle t_Nf touches nothing and which have no
    /// stretch therefore.
    pub path: Vec<CrowningPoint>,
}

/// Unit of the crowning on the path, mm: of the same order as a scaled step of the dresser.
const UNIT: f64 = 1e-3;
/// Largest turn of the dresser's axis about the pole within a step, rad: the corrections of the K chart follow that turn.
const TURN: f64 = 0.3;

/// Scaled position of the dresser with the roll parameters found last at the pitch points.
type Chart = SVector<f64, 4>;

impl<'a> CrowningRows<'a> {
    /// For one flank of a dresser on a worm of reference radius `reference_radius` (mm; scales the rotation) that grinds a gear
    /// of base helix angle `gear_base_helix` (rad). Starts at DK = 0 from the unmodified profile.
    pub fn new(dresser: &'a FlankDresser, reference_radius: f64, gear_base_helix: f64) -> Self {
        Self {
            dresser,
            reference_radius,
            cos_gear_base_helix: gear_base_helix.cos(),
            start: [0.0; 4],
            base: [0.0; 3],
        }
    }

    /// The same from another start: `base` is the modification of the worm (mm) that counts as crowning 0 at the three pitch
    /// points, `start` a correction near to that which makes it.
    pub fn from_start(self, start: DressingCorrection, base: [f64; 3]) -> Self {
        Self { start, base, ..self }
    }

    fn rolls(&self) -> [f64; 3] {
        let range = &self.dresser.range;
        [range.w_nf, range.middle(), range.w_na]
    }

    fn chart(&self, x: &Chart) -> TiltChart {
        let scale = tilt_scale(self.reference_radius);
        let [phi, gamma, d, tau] = std::array::from_fn(|j| x[j] * scale[j]);
        TiltChart { phi, gamma, d, tau }
    }

    /// Rows at a position and a crowning in [`UNIT`]s; `hints` holds the profile parameters of the last call.
    fn rows(&self, x: &Chart, crowning: f64, hints: &mut [f64; 3]) -> Option<ParameterLinearised<4>> {
        let profile = DressedProfile::tilted(self.dresser, &self.chart(x));
        let scale = tilt_scale(self.reference_radius);
        let change = -UNIT * self.cos_gear_base_helix;
        let mut residual = SVector::zeros();
        let mut jacobian = SMatrix::zeros();
        let mut by = SVector::zeros();
        for (i, w) in self.rolls().into_iter().enumerate() {
            let at = profile.at_roll_near(w, hints[i]).ok()?;
            hints[i] = at.t;
            by[i] = if i == 1 { -change } else { 0.0 };
            residual[i] = at.f - self.base[i] + by[i] * crowning;
            for j in 0..4 {
                jacobian[(i, j)] = at.df_dk[j] * scale[j];
            }
        }
        let (w, gradient) = profile.map_gradient(self.dresser.designed.w_na).ok()?;
        residual[3] = w - self.dresser.range.w_na;
        for j in 0..4 {
            jacobian[(3, j)] = gradient[j] * scale[j];
        }
        Some((residual, jacobian, by))
    }

    /// The range of crownings both ways from the start.
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`]; [`DressingError::NoZero`] if the start cannot be made or is not allowed by the limits;
    /// [`DressingError::Singular`]; [`DressingError::PoleOfChart`] at a nominal crossing angle of 0; those of the forward
    /// calculation at the start.
    pub fn range(&self, limits: &CrowningLimits<'_>) -> Result<CrowningRange, DressingError> {
        self.check(limits)?;
        let flank = self.dresser.worm.flank;
        let chain = &self.dresser.chain;
        let nominal = [chain.worm_angle, chain.crossing_angle, chain.centre_distance, chain.offset];
        let p = chain.screw_parameter;
        let absolute: [f64; 4] = std::array::from_fn(|j| nominal[j] + self.start[j]);
        let scale = tilt_scale(self.reference_radius);
        let chart = TiltChart::from_kinematics(absolute, p);
        chart.to_kinematics_along(p, &absolute)?;
        let x = [chart.phi, chart.gamma, chart.d, chart.tau];
        let x = Vector4::from_fn(|j, _| x[j] / scale[j]);
        let mut hints = DressedProfile::of_flank(self.dresser, self.start)
            .at_rolls(&self.rolls())
            .map(|points| [points[0].t, points[1].t, points[2].t])?;
        let none = |reason| DressingError::NoZero { flank, v: 0.0, fraction: 0.0, reason };
        let start =
            newton(x, &NewtonOptions::default(), |x| self.rows(x, 0.0, &mut hints).map(|(r, j, _)| (r, j)))
                .map_err(|_| none(PathReason::GivenUp))?;
        let here = self.chart(&start.x).to_kinematics_along(p, &absolute)?;
        let dk = |k: &[f64; 4]| -> DressingCorrection { std::array::from_fn(|j| k[j] - nominal[j]) };
        let one_way = |direction: f64| -> Result<(Vec<CrowningPoint>, CrowningEnd), DressingError> {
            let mut hints = hints;
            let watch = |before: &PathPoint<4>, at: &PathPoint<4>| {
                let chart = self.chart(&at.x);
                let margin = self.margin(limits, || chart.to_kinematics_along(p, &here).ok().map(|k| dk(&k)));
                if turn(&self.chart(&before.x), &chart) > TURN { Watch::TooFar } else { margin }
            };
            let path = follow::<4, 5, PathReason>(
                (start.x, 0.0),
                direction,
                None,
                &ContinuationOptions::default(),
                |x, c| self.rows(x, c, &mut hints),
                watch,
            )
            .ok_or(DressingError::Singular { ratio: 0.0 })?;
            let end = CrowningEnd { crowning: UNIT * path.last().parameter, reason: self.reason(&path) };
            Ok((self.solutions(&path, &here, dk), end))
        };
        let (ahead, largest) = one_way(1.0)?;
        let (behind, smallest) = one_way(-1.0)?;
        for end in [largest, smallest] {
            if end.crowning == 0.0 {
                return Err(none(end.reason));
            }
        }
        let path = behind.into_iter().skip(1).rev().chain(ahead).collect();
        Ok(CrowningRange { smallest, largest, path })
    }

    fn check(&self, limits: &CrowningLimits<'_>) -> Result<(), DressingError> {
        let invalid = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
        if !(self.reference_radius.is_finite() && self.reference_radius > 0.0) {
            return invalid("reference radius", self.reference_radius, "> 0 mm");
        }
        if self.cos_gear_base_helix.is_nan() || self.cos_gear_base_helix <= 0.0 {
            return invalid("cosine of the gear's base helix angle", self.cos_gear_base_helix, "> 0");
        }
        for (field, x) in self
            .start
            .iter()
            .map(|x| ("start correction", x))
            .chain(self.base.iter().map(|x| ("modification at the start", x)))
        {
            if !x.is_finite() {
                return invalid(field, *x, "finite numbers");
            }
        }
        for [low, high] in limits.axes.iter().flatten() {
            if low.is_nan() || high.is_nan() || low > high {
                return invalid("axis limit", *low, "the smallest value first, no NaN");
            }
        }
        Ok(())
    }

    /// The margin to the nearest of all limits, in scaled units or those of the caller.
    fn margin(
        &self,
        limits: &CrowningLimits<'_>,
        dk: impl Fn() -> Option<DressingCorrection>,
    ) -> Watch<PathReason> {
        if limits.axes.is_none() && limits.margin.is_none() {
            return Watch::Margin(1.0, PathReason::Limit);
        }
        let Some(dk) = dk() else { return Watch::Margin(f64::NAN, PathReason::AxisLimit(0)) };
        let mut nearest = (f64::MAX, PathReason::Limit);
        if let Some(axes) = &limits.axes {
            let scale = crate::conditions::path_end::correction_scale(self.reference_radius);
            let (margin, j) = axis_margin(&dk, axes, &scale);
            nearest = (margin.min(1e9), PathReason::AxisLimit(j));
        }
        if let Some(of) = limits.margin {
            let margin = of(&dk);
            if margin.is_nan() || margin < nearest.0 {
                nearest = (margin, PathReason::Limit);
            }
        }
        Watch::Margin(nearest.0, nearest.1)
    }

    fn reason(&self, path: &Path<4, PathReason>) -> PathReason {
        match path.end {
            PathEnd::Fold => PathReason::Fold,
            PathEnd::Stopped(reason) => reason,
            PathEnd::Target | PathEnd::TooLong => PathReason::GivenUp,
            PathEnd::Broken => {
                let profile = DressedProfile::tilted(self.dresser, &self.chart(&path.last().x));
                let used = self.rolls().into_iter().filter_map(|w| profile.at_roll(w).ok().map(|at| at.t));
                let circles: Vec<_> =
                    used.chain([self.dresser.designed.w_na]).map(|t| (profile, t)).collect();
                reason_of_break(&circles)
            }
        }
    }

    /// The points of a path in both charts.
    fn solutions(
        &self,
        path: &Path<4, PathReason>,
        start: &[f64; 4],
        dk: impl Fn(&[f64; 4]) -> DressingCorrection,
    ) -> Vec<CrowningPoint> {
        let mut before = *start;
        let (range, designed) = (&self.dresser.range, &self.dresser.designed);
        // A point exactly in the pole has no corrections, one whose circle t_Nf touches nothing no stretch.
        let solution = |at: &PathPoint<4>| {
            let chart = self.chart(&at.x);
            before = chart.to_kinematics_along(self.dresser.chain.screw_parameter, &before).ok()?;
            let dressed = DressedProfile::tilted(self.dresser, &chart).at_parameter(designed.w_nf).ok()?;
            let stretch = (dressed.w - range.w_nf) / (range.w_nf - range.w_na);
            Some(CrowningPoint { crowning: UNIT * at.parameter, dk: dk(&before), chart, stretch })
        };
        path.points.iter().filter_map(solution).collect()
    }
}

/// How far the axis of the dresser turns about the worm's direction between two positions, rad.
fn turn(from: &TiltChart, to: &TiltChart) -> f64 {
    let ([a_x, a_y, _], [b_x, b_y, _]) = (from.axis(), to.axis());
    (a_x * b_y - a_y * b_x).atan2(a_x * b_x + a_y * b_y).abs()
}
