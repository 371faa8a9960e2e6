//! One dresser on one worm at one diameter: corrections for the wanted profile crowning, stretch, what the profile misses, and
//! whether that is allowed (`docs/mathematics/dressing.md`). Knows neither a list of bodies nor a ranking.

use super::bodies::{CatalogueDresser, CatalogueWorm, DesignedDresser, Workshop};
use super::refusal::Refusal;
use crate::{
    DresserTool, DressingError, ProfileFit, WormSeat, fit_profile, fit_profile_on_path, profile_error,
    refit_profile, uncorrected_profile,
};
use foundation::geometry::{Flank, Sides, WormChoice};
use foundation::kinematics::DressingCorrection;

/// What a pair shall make. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted {
    /// Profile crowning of the gear over its whole involute, transverse, positive = convex; `None` for a flank that is not
    /// ground.
    pub crowning: Sides<Option<f64>>,
    /// cos(beta_b) of the gear per flank.
    pub cos_base_helix: Sides<f64>,
    /// Largest distance from the wanted profile, normal; `None`: not judged.
    pub tolerance: Option<f64>,
}

/// What is allowed. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairLimits {
    /// |d_phi_S|, |d_gamma|, |d_d|, |d_v_yA|.
    pub correction: [f64; 4],
    /// |P|; `None`: any.
    pub stretch: Option<f64>,
    /// Least width of the tip land of a dresser whose land the catalogue does not state.
    pub tip_land: f64,
    /// Least distance from the opposite flank and from the worm that is left later.
    pub clearance: f64,
}

/// A pair under judgement.
#[derive(Clone, Copy)]
pub struct Pair<'a> {
    /// The rule that puts worms in place.
    pub workshop: &'a dyn Workshop,
    /// The worm.
    pub worm: &'a CatalogueWorm,
    /// The dresser.
    pub dresser: &'a CatalogueDresser,
    /// The same where it was designed, for the hand of the worm.
    pub designed: &'a DesignedDresser,
    /// What it shall make.
    pub wanted: &'a Wanted,
    /// What is allowed.
    pub limits: &'a PairLimits,
    /// Whether tip land and undermining are looked at.
    pub collisions: bool,
}

/// How closely a pair is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// With the largest tip land.
    Whole,
    /// Whether it is allowed.
    Allowed,
}

/// One flank of a pair. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlankOfPair {
    /// Profile crowning asked of the dressing motion: the wanted one without that of the dresser, on the gear, transverse.
    pub crowning: f64,
    /// Corrections and stretch.
    pub fit: ProfileFit,
    /// Largest distance from the parabola, normal, on the worm.
    pub profile_error: f64,
    /// Smallest and largest radius of the dresser in contact.
    pub radii: [f64; 2],
    /// Largest tip land that clears the opposite flank, if that was looked at: `Some(None)` where none does.
    pub tip_land: Option<Option<f64>>,
}

/// What a pair does at one diameter of the worm. mm, rad.
#[derive(Clone, Debug, PartialEq)]
pub struct PairFigures {
    /// Pitch diameter of the worm.
    pub pitch_diameter: f64,
    /// The flanks that are ground.
    pub flanks: Sides<Option<FlankOfPair>>,
    /// max |DK_j/limit_j|.
    pub cost: f64,
    /// Why it is not allowed, if so.
    pub refusal: Option<Refusal>,
}

impl PairFigures {
    /// Corrections per flank, to start a neighbour from.
    pub fn corrections(&self) -> Sides<Option<DressingCorrection>> {
        self.flanks.map(|_, f| f.map(|f| f.fit.dk))
    }

    /// Largest |P| of the flanks with its sign.
    pub fn stretch(&self) -> Option<f64> {
        let flanks = self.flanks.iter().filter_map(|(_, f)| f.map(|f| f.fit.stretch));
        flanks.max_by(|a, b| a.abs().total_cmp(&b.abs()))
    }

    /// Smallest of the largest tip lands of the flanks, if collisions were looked at; `Some(None)` where no land fits.
    pub fn tip_land(&self) -> Option<Option<f64>> {
        let lands = self.flanks.iter().filter_map(|(_, f)| f.and_then(|f| f.tip_land));
        lands.min_by(|a, b| a.unwrap_or(f64::NEG_INFINITY).total_cmp(&b.unwrap_or(f64::NEG_INFINITY)))
    }

    /// Largest distance from the wanted profile, normal, mm.
    pub fn profile_error(&self) -> f64 {
        self.flanks.iter().filter_map(|(_, f)| f.map(|f| f.profile_error)).fold(0.0, f64::max)
    }
}

impl Pair<'_> {
    /// The worm in its present state under the dresser.
    ///
    /// # Errors
    /// Those of [`CatalogueWorm::seat`].
    pub fn seat(&self) -> Result<WormSeat, DressingError> {
        self.worm.seat(self.workshop, self.dresser.size)
    }

    /// The worm dressed down to a pitch diameter under the dresser.
    ///
    /// # Errors
    /// Those of [`Workshop::seat`].
    pub fn worn_seat(&self, now: &WormSeat, pitch_diameter: f64) -> Result<WormSeat, DressingError> {
        self.workshop.seat(&self.worm.worn(now, pitch_diameter), self.dresser.size)
    }

    /// Flanks that are ground with the crowning asked of the motion on each.
    pub(super) fn asked(&self) -> Sides<Option<f64>> {
        self.wanted.crowning.map(|flank, wanted| wanted.map(|c| c - self.dresser.crowning[flank]))
    }

    /// f in the middle of the worm's profile for a crowning of the gear.
    fn middle(&self, flank: Flank, crowning: f64) -> f64 {
        -crowning * self.wanted.cos_base_helix[flank]
    }

    /// A worm on the way from one that the dresser fits best to the one in `seat`: of the same threads and of the lead angle that
    /// the dresser was designed for at share 0.
    fn between(&self, choice: &WormChoice, seat: &WormSeat, share: f64) -> Result<WormSeat, DressingError> {
        if share >= 1.0 {
            return Ok(*seat);
        }
        let designed = &self.designed.seat;
        let first = 2.0 * designed.reference_radius() * seat.worm.tooth_count() / designed.worm.tooth_count();
        let mix = |a: f64, b: f64| a + share * (b - a);
        let angle = |seat: &WormSeat| seat.worm.data().pressure_angle.left;
        let choice = WormChoice {
            pitch_diameter: Some(mix(first, 2.0 * seat.reference_radius())),
            tip_diameter: None,
            pressure_angle: Some(mix(angle(designed), angle(seat))),
            ..*choice
        };
        self.workshop.seat(&choice, self.dresser.size)
    }

    /// Figures and verdict on the worm in `seat`, which was made by `choice`; `start`: corrections of a neighbour.
    ///
    /// # Errors
    /// [`Refusal::Dressing`] where no corrections make the profile; what is made but not allowed stands in the figures.
    pub fn judge(
        &self,
        choice: &WormChoice,
        seat: &WormSeat,
        start: Option<&PairFigures>,
        look: Look,
    ) -> Result<PairFigures, Refusal> {
        let tool = self.designed.tool.on_worm(seat)?;
        let radius = seat.reference_radius();
        let asked = self.asked();
        let flanks = Sides::try_from_fn(|flank| -> Result<_, Refusal> {
            let Some(crowning) = asked[flank] else { return Ok(None) };
            let middle = self.middle(flank, crowning);
            let neighbour = start.and_then(|s| s.flanks[flank]);
            let near = neighbour.and_then(|n| refit_profile(&tool, flank, radius, middle, &n.fit.dk).ok());
            let fit = match near {
                Some(fit) => fit,
                None => match fit_profile(&tool, flank, radius, middle, &[0.0; 4]) {
                    Ok(fit) => fit,
                    Err(refusal) => {
                        let path = |share: f64| self.between(choice, seat, share);
                        fit_profile_on_path(&self.designed.tool, flank, &path, middle).map_err(|_| refusal)?
                    }
                },
            };
            let (profile_error, radii) = profile_error(&tool, flank, fit.dk, middle)?;
            let tip_land = (self.collisions && look == Look::Whole)
                .then(|| self.largest_land(&tool, flank, &fit.dk))
                .transpose()?;
            Ok(Some(FlankOfPair { crowning, fit, profile_error, radii, tip_land }))
        })?;
        let mut figures = PairFigures { pitch_diameter: 2.0 * radius, flanks, cost: 0.0, refusal: None };
        let mut worst = None;
        for (flank, f) in flanks.iter() {
            let Some(f) = f else { continue };
            for j in 0..4 {
                let share = f.fit.dk[j].abs() / self.limits.correction[j];
                if share > figures.cost {
                    figures.cost = share;
                    worst = Some((flank, j, f.fit.dk[j]));
                }
            }
        }
        let refusal = self.refusal(&figures, worst).and_then(|()| self.check_collisions(&tool, &figures));
        figures.refusal = refusal.err();
        Ok(figures)
    }

    fn check_collisions(&self, tool: &DresserTool, figures: &PairFigures) -> Result<(), Refusal> {
        if !self.collisions {
            return Ok(());
        }
        for (flank, f) in figures.flanks.iter() {
            let Some(f) = f else { continue };
            match f.tip_land {
                Some(largest) => self.check_land(flank, largest)?,
                None => self.check_clearance(tool, flank, &f.fit.dk)?,
            }
        }
        Ok(())
    }

    /// Limits but collisions in the order: axes, stretch, accuracy, length of the dresser's flank.
    fn refusal(&self, figures: &PairFigures, worst: Option<(Flank, usize, f64)>) -> Result<(), Refusal> {
        if let Some((flank, j, value)) = worst.filter(|_| figures.cost > 1.0) {
            let (unit, factor) = if j < 2 { ("deg", 180.0 / std::f64::consts::PI) } else { ("mm", 1.0) };
            return Err(Refusal::AxisLimit {
                flank,
                axis: ["Δφ_S", "Δγ", "Δd", "Δv_yA"][j],
                value: value * factor,
                limit: self.limits.correction[j] * factor,
                unit,
            });
        }
        for (flank, f) in figures.flanks.iter() {
            let Some(f) = f else { continue };
            if let Some(limit) = self.limits.stretch
                && f.fit.stretch.abs() > limit
            {
                return Err(Refusal::Stretch { flank, stretch: f.fit.stretch, limit });
            }
            if let Some(tolerance) = self.wanted.tolerance
                && f.profile_error > tolerance
            {
                let (error_um, allowed_um) = (f.profile_error * 1e3, tolerance * 1e3);
                return Err(Refusal::ProfileError { flank, error_um, allowed_um });
            }
            let [from, to] = f.radii;
            let [has_from, has_to] = self.dresser.flank.unwrap_or([0.0, self.dresser.size.tip_radius]);
            if from < has_from || to > has_to {
                return Err(Refusal::FlankTooShort { flank, from, to, has_from, has_to });
            }
        }
        Ok(())
    }

    /// Profile crowning of the gear without corrections of crossing angle and offset on the worm in `seat`, transverse, per flank
    /// that is ground: what stands there before anything is corrected.
    ///
    /// # Errors
    /// As [`uncorrected_profile`].
    pub fn uncorrected(&self, seat: &WormSeat) -> Result<Sides<Option<f64>>, DressingError> {
        let tool = self.designed.tool.on_worm(seat)?;
        let asked = self.asked();
        Sides::try_from_fn(|flank| {
            if asked[flank].is_none() {
                return Ok(None);
            }
            let (_, middle) = uncorrected_profile(&tool, flank, seat.reference_radius())?;
            Ok(Some(self.dresser.crowning[flank] - middle / self.wanted.cos_base_helix[flank]))
        })
    }
}
