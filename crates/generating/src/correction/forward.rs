//! The flank that given settings leave, beyond first order: by the local envelope, which is quick, or by the exact contact.

use super::{CorrectionError, FlankPoint, Setting, SettingInfluence, SettingsWorm};
use crate::{GeneratingError, LocalEnvelope};
use contact::{ExactContact, ModifiedThread, Pair, ThreadFunction};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::{GeneratingMotion, MotionLaw};
use rayon::prelude::*;

/// A cylindrical pair with its motion and worm, to which settings are added.
#[derive(Clone, Copy)]
pub struct SettingsFlank<'a> {
    pair: &'a Pair,
    influence: &'a SettingInfluence<'a>,
    motion: &'a GeneratingMotion,
    worm: Option<Sides<&'a dyn ThreadFunction>>,
}

impl<'a> SettingsFlank<'a> {
    /// With a worm of no modification; `motion` as it is without corrections.
    pub fn new(pair: &'a Pair, influence: &'a SettingInfluence<'a>, motion: &'a GeneratingMotion) -> Self {
        Self { pair, influence, motion, worm: None }
    }

    /// The same with the modifications f_n1 of the worm.
    pub fn with_worm(mut self, worm: Sides<&'a dyn ThreadFunction>) -> Self {
        self.worm = Some(worm);
        self
    }

    /// The motion with the settings, and with the crossing angle off by `delta_gamma` (rad).
    pub fn motion(&self, settings: &[(Setting, f64)], delta_gamma: f64) -> GeneratingMotion {
        let half_width = self.influence.half_width();
        let over_feed = |order: &dyn Fn(Setting) -> Option<u8>| {
            let mut coefficients = Vec::new();
            for (setting, value) in settings {
                if let Some(k) = order(*setting) {
                    if coefficients.len() <= k.into() {
                        coefficients.resize(usize::from(k) + 1, 0.0);
                    }
                    coefficients[usize::from(k)] += value / half_width.powi(k.into());
                }
            }
            MotionLaw::polynomial(self.influence.pivot(), coefficients)
        };
        let sum =
            |wanted: Setting| settings.iter().filter(|(s, _)| *s == wanted).map(|(_, x)| x).sum::<f64>();
        let add = |law: &MotionLaw, more: MotionLaw| match law {
            law if more.is_zero() => law.clone(),
            law if law.is_zero() => more,
            law => MotionLaw::Sum(vec![law.clone(), more]),
        };
        let mut motion = self.motion.clone();
        let radial = |setting| if let Setting::RadialFeed(k) = setting { Some(k) } else { None };
        let angle = |setting| if let Setting::WorkAngle(k) = setting { Some(k) } else { None };
        motion.delta_d = add(&motion.delta_d, over_feed(&radial));
        motion.delta_phi_2 = add(&motion.delta_phi_2, over_feed(&angle));
        motion.delta_gamma = add(&motion.delta_gamma, MotionLaw::polynomial(0.0, vec![delta_gamma]));
        let shift = vec![sum(Setting::WormShift), sum(Setting::DiagonalRatio)];
        motion.shift = add(&motion.shift, MotionLaw::polynomial(0.0, shift));
        motion
    }

    fn each(
        &self,
        settings: &[(Setting, f64)],
        points: &[FlankPoint],
        value: impl Fn(&SettingsWorm<'_>, &FlankPoint) -> Result<f64, GeneratingError> + Sync,
    ) -> Result<Vec<f64>, CorrectionError> {
        let worms = Sides::from_fn(|flank: Flank| {
            let worm = SettingsWorm::new(self.influence, &self.motion.shift, flank, settings);
            match &self.worm {
                Some(base) => worm.on(base[flank]),
                None => worm,
            }
        });
        Ok(points.par_iter().map(|p| value(&worms[p.flank], p)).collect::<Result<_, _>>()?)
    }

    /// f_n2 by the local envelope, mm; settings in mm, rad and 1.
    ///
    /// # Errors
    /// Those of [`LocalEnvelope::value`].
    pub fn local(
        &self,
        settings: &[(Setting, f64)],
        points: &[FlankPoint],
    ) -> Result<Vec<f64>, CorrectionError> {
        let motion = self.motion(settings, 0.0);
        self.each(settings, points, |worm, p| {
            LocalEnvelope::new(&self.pair.flanks[p.flank], &motion, worm).value(p.w, p.z)
        })
    }

    /// f_n2 by the exact contact, with the crossing angle off by `delta_gamma` (rad) under an unchanged gearbox, mm.
    ///
    /// # Errors
    /// Those of [`ExactContact::solve`].
    pub fn exact(
        &self,
        settings: &[(Setting, f64)],
        delta_gamma: f64,
        points: &[FlankPoint],
    ) -> Result<Vec<f64>, CorrectionError> {
        let motion = self.motion(settings, delta_gamma);
        self.each(settings, points, |worm, p| {
            let thread = ModifiedThread::new(self.pair.flanks[p.flank].worm, worm);
            Ok(ExactContact::new(self.pair, p.flank, &motion, &thread).solve(p.w, p.z)?.f_n)
        })
    }
}
