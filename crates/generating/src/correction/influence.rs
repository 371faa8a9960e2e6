//! What every setting of generating grinding does to both flanks, to first order. Knows no deviation and no second order.

use super::{Column, CorrectionError, FlankPoint, Setting};
use crate::FlankLines;
use contact::ThreadFunction;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::MotionLaw;
use foundation::numerics::Jet2;

/// First-order influence of the settings at one diagonal ratio.
#[derive(Clone, Copy)]
pub struct SettingInfluence<'a> {
    lines: &'a Sides<FlankLines>,
    ratio: f64,
    pivot: f64,
    half_width: f64,
    directions: Sides<f64>,
    worm: Option<Sides<&'a dyn ThreadFunction>>,
}

impl<'a> SettingInfluence<'a> {
    /// For a cylindrical pair ground at z_V1 = `ratio` z_V2 over the face width `face_width` (mm).
    ///
    /// # Errors
    /// [`CorrectionError::InvalidNumber`] for a face width that is not above 0 and a ratio that is not finite.
    pub fn new(lines: &'a Sides<FlankLines>, ratio: f64, face_width: f64) -> Result<Self, CorrectionError> {
        let invalid = |name, value, allowed| Err(CorrectionError::InvalidNumber { name, value, allowed });
        if !(face_width.is_finite() && face_width > 0.0) {
            return invalid("face width", face_width, "finite numbers above 0");
        }
        if !ratio.is_finite() {
            return invalid("diagonal ratio", ratio, "finite numbers");
        }
        let middle = |flank: Flank| lines[flank].path_feed(lines[flank].w_m, 0.0);
        Ok(Self {
            lines,
            ratio,
            pivot: 0.5 * (middle(Flank::Left) + middle(Flank::Right)),
            half_width: 0.5 * face_width,
            directions: lines.map(|_, l| l.work_direction(ratio)),
            worm: None,
        })
    }

    /// The same with the modifications f_n1 of the worm: without them worm shift and diagonal ratio change nothing.
    pub fn with_worm(mut self, worm: Sides<&'a dyn ThreadFunction>) -> Self {
        self.worm = Some(worm);
        self
    }

    /// Directions and mapping constants of both flanks.
    pub fn lines(&self) -> &'a Sides<FlankLines> {
        self.lines
    }

    /// z_p: the feed about which the laws over the feed are written, mm.
    pub fn pivot(&self) -> f64 {
        self.pivot
    }

    /// b/2, mm: the unit of q.
    pub fn half_width(&self) -> f64 {
        self.half_width
    }

    /// tan(rho_2) of both flanks: the lines that the worm's own lines leave.
    pub fn directions(&self) -> &Sides<f64> {
        &self.directions
    }

    /// Diagonal ratio.
    pub fn ratio(&self) -> f64 {
        self.ratio
    }

    /// q at a point: the feed that grinds it, over the half face width about the pivot.
    pub fn q(&self, flank: Flank, w: f64, z: f64) -> f64 {
        (self.lines[flank].path_feed(w, z) - self.pivot) / self.half_width
    }

    /// u as a function of (w, z).
    pub(super) fn u(&self, flank: Flank, w: f64) -> Jet2 {
        let [from, to] = self.lines[flank].roll;
        let scale = 2.0 / (to - from);
        Jet2 { f: scale * (w - self.lines[flank].w_m), fu: scale, ..Jet2::default() }
    }

    /// v_X as a function of (w, z).
    pub(super) fn v_x(&self, flank: Flank, w: f64, z: f64) -> Jet2 {
        let t_2 = self.directions[flank];
        let f = (z + t_2 * (w - self.lines[flank].w_m)) / self.half_width;
        Jet2 { f, fu: t_2 / self.half_width, fv: 1.0 / self.half_width, ..Jet2::default() }
    }

    /// Effect of a unit of a setting on f_n2 at a point, mm per mm, rad or 1. NaN where the worm has no surface.
    pub fn effect(&self, setting: Setting, at: &FlankPoint) -> f64 {
        let &FlankPoint { flank, w, z } = at;
        let lines = &self.lines[flank];
        if setting.flank().is_some_and(|own| own != flank) {
            return 0.0;
        }
        let u = || self.u(flank, w).f;
        match setting {
            Setting::RadialFeed(k) => lines.sin_an * self.q(flank, w, z).powi(k.into()),
            Setting::WorkAngle(k) => -lines.s * lines.lever * self.q(flank, w, z).powi(k.into()),
            Setting::ProfileSlope(_) => u(),
            Setting::ProfileCrown(_) => -u() * u(),
            Setting::Twist(_) => u() * self.v_x(flank, w, z).f,
            Setting::WormShift => self.worm_slope(at),
            Setting::DiagonalRatio => lines.path_feed(w, z) * self.worm_slope(at),
        }
    }

    /// df_n1/dz_1 at the worm point that grinds a point.
    fn worm_slope(&self, at: &FlankPoint) -> f64 {
        let Some(worm) = &self.worm else { return 0.0 };
        let law = MotionLaw::polynomial(0.0, vec![0.0, self.ratio]);
        let (w_1, z_1) = self.lines[at.flank].worm_point(at.w, at.z, &law);
        worm[at.flank].jet(w_1, z_1).map_or(f64::NAN, |f| f.fv)
    }

    /// Column of a free form over the feed: `shape(q)` mm or rad more per unit, carried by the radial feed or by the angle of the
    /// workpiece (any order of them says which). It acts along the contact path, as everything of the motion does.
    ///
    /// # Errors
    /// As [`SettingInfluence::columns`]; [`CorrectionError::SettingWithoutEffect`] also for settings that do not run over the feed.
    pub fn free_form(
        &self,
        name: &str,
        carrier: Setting,
        points: &[FlankPoint],
        shape: impl Fn(f64) -> f64,
    ) -> Result<Column, CorrectionError> {
        let unit = match carrier {
            Setting::RadialFeed(_) => Setting::RadialFeed(0),
            Setting::WorkAngle(_) => Setting::WorkAngle(0),
            _ => return Err(CorrectionError::SettingWithoutEffect { setting: name.into() }),
        };
        let value = |p: &FlankPoint| self.effect(unit, p) * shape(self.q(p.flank, p.w, p.z));
        checked(name.into(), None, points.iter().map(value).collect())
    }

    /// The columns of some settings.
    ///
    /// # Errors
    /// [`CorrectionError::InvalidNumber`] for points where an effect is not finite, as a twist at diagonal ratio 0;
    /// [`CorrectionError::SettingWithoutEffect`].
    pub fn columns(
        &self,
        settings: &[Setting],
        points: &[FlankPoint],
    ) -> Result<Vec<Column>, CorrectionError> {
        let column = |&setting: &Setting| {
            let values = points.iter().map(|p| self.effect(setting, p)).collect();
            checked(setting.name(), Some(setting), values)
        };
        settings.iter().map(column).collect()
    }
}

/// A column of finite numbers that are not all zero.
fn checked(name: String, setting: Option<Setting>, values: Vec<f64>) -> Result<Column, CorrectionError> {
    if let Some(&value) = values.iter().find(|x| !x.is_finite()) {
        let (name, allowed) = ("effect of a setting", "finite numbers");
        return Err(CorrectionError::InvalidNumber { name, value, allowed });
    }
    if values.iter().all(|x| *x == 0.0) {
        return Err(CorrectionError::SettingWithoutEffect { setting: name });
    }
    Ok(Column { name, setting, values })
}
