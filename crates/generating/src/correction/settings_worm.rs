//! The worm with its profile slopes, crownings and twists as settings, on top of the modification that it has anyway.

use super::{Setting, SettingInfluence};
use contact::ThreadFunction;
use foundation::geometry::Flank;
use foundation::kinematics::MotionLaw;
use foundation::numerics::Jet2;

/// f_n1 of one flank of the worm, mm.
#[derive(Clone, Copy)]
pub struct SettingsWorm<'a> {
    influence: &'a SettingInfluence<'a>,
    base: Option<&'a dyn ThreadFunction>,
    shift: &'a MotionLaw,
    flank: Flank,
    slope: f64,
    crown: f64,
    twist: f64,
}

impl<'a> SettingsWorm<'a> {
    /// Of a flank under the diagonal motion `shift` for which the worm was made; settings of other kinds are no part of it.
    pub fn new(
        influence: &'a SettingInfluence<'a>,
        shift: &'a MotionLaw,
        flank: Flank,
        settings: &[(Setting, f64)],
    ) -> Self {
        let sum = |wanted: Setting| settings.iter().filter(|(s, _)| *s == wanted).map(|(_, x)| x).sum();
        Self {
            influence,
            base: None,
            shift,
            flank,
            slope: sum(Setting::ProfileSlope(flank)),
            crown: sum(Setting::ProfileCrown(flank)),
            twist: sum(Setting::Twist(flank)),
        }
    }

    /// The same on a worm that is modified.
    pub fn on(mut self, base: &'a dyn ThreadFunction) -> Self {
        self.base = Some(base);
        self
    }
}

impl ThreadFunction for SettingsWorm<'_> {
    fn jet(&self, w_1: f64, z_1: f64) -> Option<Jet2> {
        let base = match self.base {
            Some(base) => base.jet(w_1, z_1)?,
            None => Jet2::default(),
        };
        if self.slope == 0.0 && self.crown == 0.0 && self.twist == 0.0 {
            return Some(base);
        }
        let [w, z] = self.influence.lines()[self.flank].work_point(w_1, z_1, self.shift);
        let u = self.influence.u(self.flank, w.f);
        let mut own = u * -self.slope + u * u * self.crown;
        if self.twist != 0.0 {
            own += u * self.influence.v_x(self.flank, w.f, z.f) * -self.twist;
        }
        Some(base + own.of(w, z))
    }
}
