//! What is wanted of a bevel flank beside the nominal one: its ease-off in three amounts and any modifications
//! (`docs/mathematics/milling.md#flanks-as-patches`).
//!
//! Modifications are functions of a length of roll and a position along the tooth. Of a bevel gear these are those of the cylinder
//! that touches the base cone at the mean distance from the apex R_m: w = R_m sin(delta_b) times the turn of the gear since the flank
//! left the base cone, z = R - R_m from toe to heel, and the base helix angle is that of the flank line there.

use crate::job::{self as drawn, BevelFlank, LoadedMillingJob, MillingJob};
use foundation::geometry::{
    BevelGear, EaseOff, EaseOffAmounts, Flank, GeometryError, NormalOffset, Octoid, OffsetBounds, OffsetSum,
};
use foundation::modification::{EvaluationField, Modification};
use foundation::numerics::Jet2;
use job::tables;
use run::{ModifiedFlank, RunFailure, geometry_finding, job_files, modification_finding};
use std::sync::Arc;

/// A modification over the heights and distances of a bevel flank.
#[derive(Clone, Debug)]
struct OnBevel {
    modified: ModifiedFlank,
    map: RollMap,
}

/// From height and distance of a bevel flank to length of roll and position, mm.
#[derive(Clone, Copy, Debug)]
pub(super) struct RollMap {
    /// mm of roll for each rad of height.
    roll_per_height: f64,
    /// Length of roll at the height 0.
    roll_at_zero: f64,
    /// R_m.
    middle: f64,
}

impl RollMap {
    pub fn of(gear: &BevelGear, form: BevelFlank) -> Self {
        let middle = gear.mean_distance();
        let roll_per_height = middle * gear.base_angle().sin();
        // The height of an octoid counts from the pitch cone.
        let roll_at_zero = match form {
            BevelFlank::SphericalInvolute => 0.0,
            BevelFlank::Octoid => middle * gear.pitch_roll(),
        };
        Self { roll_per_height, roll_at_zero, middle }
    }

    pub fn roll(&self, height: f64) -> f64 {
        self.roll_at_zero + self.roll_per_height * height
    }

    pub fn height(&self, roll: f64) -> f64 {
        (roll - self.roll_at_zero) / self.roll_per_height
    }

    /// Base helix angle in the middle of the face, rad.
    pub fn base_helix(&self, gear: &BevelGear) -> f64 {
        let [_, turn, ..] = gear.line().derivatives(self.middle);
        (self.roll_per_height * turn).atan()
    }

    pub fn middle(&self) -> f64 {
        self.middle
    }
}

impl NormalOffset for OnBevel {
    fn jet(&self, height: f64, length: f64) -> Jet2 {
        let by = self.map.roll_per_height;
        let jet = self.modified.jet(self.map.roll(height), length - self.map.middle);
        Jet2 { fu: by * jet.fu, fuu: by * by * jet.fuu, fuv: by * jet.fuv, ..jet }
    }

    fn bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> OffsetBounds {
        let by = self.map.roll_per_height;
        let positions = lengths.map(|length| length - self.map.middle);
        let bounds = self.modified.bounds(heights.map(|height| self.map.roll(height)), positions);
        let [aa, ab, bb] = bounds.second;
        OffsetBounds { by_height: by * bounds.by_height, second: [by * by * aa, by * ab, bb], ..bounds }
    }
}

/// Which of both gears of a pair is meant, for messages.
#[derive(Clone, Copy)]
pub(super) struct Keys {
    /// The table of the gear.
    pub gear: &'static str,
    /// The list of its modifications.
    pub modifications: &'static str,
}

/// Of the gear that is milled.
const OWN: Keys = Keys { gear: "bevel", modifications: "target.modifications" };
/// Where the list stands that paths are planned with beside the target.
const COMPENSATION: &str = "compensation.modifications";
/// Of its mate.
pub(super) const MATE: Keys = Keys { gear: "mate", modifications: "mate.modifications" };

/// What is wanted of a gear's flanks beside the nominal ones.
#[derive(Clone, Copy)]
pub(super) struct Wanted<'a> {
    /// Ease-off in three amounts.
    pub ease_off: Option<drawn::EaseOffAmounts>,
    /// What is added to it.
    pub modifications: &'a [tables::Modification],
    /// What paths are planned with beside all that.
    pub beside: &'a [tables::Modification],
    /// Where they stand in the job.
    pub keys: Keys,
}

/// Heights of a bevel flank at the form cone and at the tip cone, rad.
///
/// # Errors
/// Those of [`Octoid::height_of`].
pub(super) fn heights(gear: &BevelGear, form: BevelFlank, side: Flank) -> Result<[f64; 2], GeometryError> {
    match form {
        BevelFlank::SphericalInvolute => Ok(gear.heights()),
        BevelFlank::Octoid => {
            let octoid = Octoid::new(gear, side);
            Ok([octoid.height_of(gear.form_angle())?, octoid.height_of(gear.tip_angle())?])
        }
    }
}

impl<'a> Wanted<'a> {
    /// Of the gear that is milled.
    pub fn of_job(job: &'a MillingJob) -> Self {
        Self {
            ease_off: job.target.ease_off,
            modifications: job.target.modifications.as_deref().unwrap_or_default(),
            beside: &[],
            keys: OWN,
        }
    }

    /// With what paths are planned with beside the target.
    pub fn compensated(self, job: &'a MillingJob) -> Self {
        Self { beside: job.compensation.as_ref().map_or(&[], |beside| &beside.modifications), ..self }
    }

    /// The offset of a flank; `None` for the nominal one.
    ///
    /// # Errors
    /// [`RunFailure`] with a finding on the key concerned.
    pub fn offset(
        &self,
        loaded: &LoadedMillingJob,
        gear: &BevelGear,
        form: BevelFlank,
        side: Flank,
    ) -> Result<Option<Arc<dyn NormalOffset>>, RunFailure> {
        let on_gear = |error: &_| RunFailure::bad_input(geometry_finding(error, self.keys.gear));
        let heights = heights(gear, form, side).map_err(|error| on_gear(&error))?;
        let mut parts: Vec<Arc<dyn NormalOffset>> = Vec::new();
        if let Some(given) = self.ease_off {
            let ease = EaseOff::new(amounts(given), heights, gear.face()).map_err(|error| on_gear(&error))?;
            parts.push(Arc::new(ease));
        }
        let lists = [(self.modifications, self.keys.modifications), (self.beside, COMPENSATION)];
        for (list, key) in lists.into_iter().filter(|(list, _)| !list.is_empty()) {
            let map = RollMap::of(gear, form);
            parts.push(Arc::new(self.modified(loaded, gear, map, (side, heights), (list, key))?));
        }
        Ok(match parts.len() {
            0 | 1 => parts.pop(),
            _ => Some(Arc::new(OffsetSum(parts))),
        })
    }

    fn modified(
        &self,
        loaded: &LoadedMillingJob,
        gear: &BevelGear,
        map: RollMap,
        (side, heights): (Flank, [f64; 2]),
        (list, key): (&[tables::Modification], &str),
    ) -> Result<OnBevel, RunFailure> {
        let half = 0.5 * gear.width();
        let base_helix = map.base_helix(gear);
        let rolls = heights.map(|height| map.roll(height));
        let field = EvaluationField::new(rolls, [-half, half], map.roll_per_height, base_helix)
            .map_err(|error| RunFailure::bad_input(modification_finding(&error, self.keys.gear)))?;
        let of =
            Modification::of_entries(list, side, &field, &job_files(loaded)).map_err(|(index, error)| {
                let key = format!("{key}[{index}]");
                RunFailure::bad_input(modification_finding(&error, &key))
            })?;
        Ok(OnBevel { modified: ModifiedFlank::new(of), map })
    }
}

/// Amounts in mm.
fn amounts(given: drawn::EaseOffAmounts) -> EaseOffAmounts {
    EaseOffAmounts {
        length_crowning: 1e-3 * given.lengthwise_um,
        profile_crowning: 1e-3 * given.profile_um,
        bias: 1e-3 * given.bias_um,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_octoid_counts_its_roll_from_the_base_cone_as_the_involute_does() {
        let data = foundation::geometry::BevelData::new(5.0, 24, 0.98, 0.35, 20.0);
        let gear = BevelGear::new(data).unwrap();
        let pitch = gear.roll_angle(data.pitch_angle).unwrap();
        let [involute, octoid] =
            [BevelFlank::SphericalInvolute, BevelFlank::Octoid].map(|form| RollMap::of(&gear, form));
        assert!((involute.roll(pitch) - octoid.roll(0.0)).abs() < 1e-9);
        assert!((involute.roll(pitch) - gear.mean_distance() * gear.pitch_roll()).abs() < 1e-9);
        assert!((involute.roll_per_height - octoid.roll_per_height).abs() < 1e-12);
    }

    #[test]
    fn derivatives_are_those_of_heights() {
        let data = foundation::geometry::BevelData::new(5.0, 24, 0.98, 0.35, 20.0);
        let gear = BevelGear::new(data).unwrap();
        let map = RollMap::of(&gear, BevelFlank::SphericalInvolute);
        let [from, to] = gear.heights().map(|height| map.roll(height));
        let field = EvaluationField::new([from, to], [-10.0, 10.0], map.roll_per_height, 0.0).unwrap();
        let specs: Vec<tables::Modification> = serde_json::from_value(serde_json::json!([
            { "kind": "formula", "f_um": "30*u^2 + 12*u*v - 7*v^3", "flank": "both" }
        ]))
        .unwrap();
        let of = Modification::for_flank(&specs, Flank::Left, &field, &foundation::modification::NoFiles);
        let offset = OnBevel { modified: ModifiedFlank::new(of.unwrap()), map };
        let (height, length, by) = (0.5 * (gear.heights()[0] + gear.heights()[1]), 46.0, 1e-5);
        let jet = offset.jet(height, length);
        let at = |a: f64, b: f64| offset.jet(height + a * by, length + b * by).f;
        let slopes = [at(1.0, 0.0) - at(-1.0, 0.0), at(0.0, 1.0) - at(0.0, -1.0)].map(|d| d / (2.0 * by));
        assert!((slopes[0] - jet.fu).abs() < 1e-6 * jet.fu.abs(), "{slopes:?} {jet:?}");
        assert!((slopes[1] - jet.fv).abs() < 1e-6 * jet.fv.abs(), "{slopes:?} {jet:?}");
        let mixed = (at(1.0, 1.0) - at(1.0, -1.0) - at(-1.0, 1.0) + at(-1.0, -1.0)) / (4.0 * by * by);
        assert!((mixed - jet.fuv).abs() < 1e-3 * jet.fuv.abs(), "{mixed} {jet:?}");
        let bounds = offset.bounds(gear.heights(), gear.face());
        assert!(bounds.by_height >= jet.fu.abs() && bounds.by_length >= jet.fv.abs());
    }
}
