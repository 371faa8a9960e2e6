//! A bevel gear rolled against its mate: the wanted flanks of both, where they touch, and beside it what their ease-offs say.

use super::mate_flank::start_of_flank;
use super::prepare::{MatePair, MillingBodies};
use super::result::{MateFlankResult, MateResult, PatternResult};
use crate::job::BevelFlank;
use contact::{
    ConjugateFlanks, ContactError, ContactPattern, FlankPlaces, GapField, RollCourse, RolledGear, RolledPair,
    overlap,
};
use foundation::geometry::{
    BevelGear, EaseOff, EaseOffAmounts, Flank, Modified, NormalOffset, Octoid, OffsetBase, SphericalInvolute,
    Surface,
};
use foundation::numerics::equidistant;
use job::Diagnostic;
use run::{RunFailure, geometry_finding};
use std::collections::BTreeMap;
use std::sync::Arc;
use verdict::Remark;

/// What rolling a gear against its mate gave.
#[derive(Clone, Debug)]
pub struct MateOutcome {
    /// Its part of `result.json`.
    pub result: MateResult,
    /// The flanks that are milled.
    pub flanks: Vec<MateFlank>,
    /// What the mate needs and is not there.
    pub remark: Option<Remark>,
}

/// A flank with its contact.
#[derive(Clone, Debug)]
pub struct MateFlank {
    /// Which.
    pub side: Flank,
    /// The wanted flank.
    pub surface: Arc<dyn Surface>,
    /// Where gaps are known.
    pub places: FlankPlaces,
    /// Gaps of the roll, and gaps that the ease-offs say.
    pub gaps: [GapField; 2],
    /// Lag of the mate over the roll: found, and said by the ease-offs.
    pub courses: [RollCourse; 2],
}

/// Places over height and length.
const PLACES: [usize; 2] = [33, 49];

/// Contact of the gear with its mate.
///
/// # Errors
/// [`RunFailure`] for gears that do not come together.
pub(super) fn roll(pair: &MatePair, bodies: &MillingBodies) -> Result<MateOutcome, RunFailure> {
    let MatePair { gears, flank: form, .. } = pair;
    let (start, remark) = start_of_flank(&gears[0], &gears[1]);
    let [own, mate] = gears.each_ref().map(BevelGear::data);
    let shaft_angle = own.pitch_angle + mate.pitch_angle;
    let radius = gears[1].mean_distance() * mate.pitch_angle.sin();
    let mut flanks = Vec::new();
    let mut results = BTreeMap::new();
    for flank in bodies.flanks().filter(|flank| bodies.options.sides.contains(&flank.side)) {
        let side = flank.side;
        let conjugate = match form {
            BevelFlank::SphericalInvolute => ConjugateFlanks::involute(gears.clone(), side),
            BevelFlank::Octoid => {
                ConjugateFlanks::octoid(gears.clone(), side).map_err(|error| failure(&error))?
            }
        };
        let heights = conjugate.heights();
        let [own_ease, other_ease] = [0, 1].map(|k| ease_off(pair.ease_offs[k], heights[k], &gears[k]));
        let ease = [own_ease?, other_ease?];
        let surface = match form {
            BevelFlank::SphericalInvolute => modified(SphericalInvolute::new(&gears[1], side), &ease[1]),
            BevelFlank::Octoid => modified(Octoid::new(&gears[1], side), &ease[1]),
        };
        let active = &flank.active;
        let rolled = [
            RolledGear {
                surface: active.surface.clone(),
                heights: active.height_span(),
                lengths: active.face,
                teeth: own.teeth,
            },
            RolledGear { surface, heights: heights[1], lengths: gears[1].face(), teeth: mate.teeth },
        ];
        let contact = contact(rolled, shaft_angle, &conjugate, [&*ease[0], &*ease[1]], pair.roll_positions)
            .map_err(|error| failure(&error))?;
        results.insert(side.name(), contact.figures(1e-3 * pair.marking_um, radius));
        flanks.push(contact);
    }
    let result = MateResult {
        teeth: mate.teeth,
        pitch_cone_angle_deg: mate.pitch_angle.to_degrees(),
        shaft_angle_deg: shaft_angle.to_degrees(),
        mean_pitch_radius_mm: radius,
        marking_um: pair.marking_um,
        start_of_flank: start,
        flanks: results,
    };
    Ok(MateOutcome { result, flanks, remark })
}

fn ease_off(
    amounts: EaseOffAmounts,
    heights: [f64; 2],
    gear: &BevelGear,
) -> Result<Arc<dyn NormalOffset>, RunFailure> {
    let ease = EaseOff::new(amounts, heights, gear.face())
        .map_err(|error| RunFailure::bad_input(geometry_finding(&error, "mate")))?;
    Ok(Arc::new(ease))
}

fn modified<S: OffsetBase + 'static>(base: S, ease: &Arc<dyn NormalOffset>) -> Arc<dyn Surface> {
    Arc::new(Modified::new(base, ease.clone()))
}

fn contact(
    gears: [RolledGear; 2],
    shaft_angle: f64,
    conjugate: &ConjugateFlanks,
    ease: [&dyn NormalOffset; 2],
    positions: usize,
) -> Result<MateFlank, ContactError> {
    let pair = RolledPair::new(gears, shaft_angle, conjugate.flank())?;
    let found = pair.roll(positions)?;
    let said = conjugate.course(ease, positions);
    let gear = pair.first();
    let places = FlankPlaces {
        heights: equidistant(gear.heights, PLACES[0]),
        lengths: equidistant(gear.lengths, PLACES[1]),
    };
    Ok(MateFlank {
        side: conjugate.flank(),
        surface: gear.surface.clone(),
        gaps: [pair.field(&places, &found), conjugate.field(&places, ease, &said)],
        places,
        courses: [found, said],
    })
}

impl MateFlank {
    /// Lags as ways at a radius of the mate.
    fn figures(&self, marking: f64, radius: f64) -> MateFlankResult {
        let areas = self.places.areas(&*self.surface);
        let [rolled, ease_off] = self.gaps.each_ref().map(|gaps| {
            ContactPattern::of(gaps, marking, &self.places, &areas)
                .map(|pattern| PatternResult::new(&pattern))
        });
        let error = self.courses.each_ref().map(RollCourse::peak_to_peak);
        MateFlankResult {
            rolled,
            ease_off,
            overlap_percent: 100.0 * overlap(self.gaps.each_ref(), marking, &areas),
            transmission_error_arcsec: 3600.0 * error[0].to_degrees(),
            transmission_error_um: 1e3 * radius * error[0],
            transmission_error_ease_off_um: 1e3 * radius * error[1],
        }
    }
}

fn failure(error: &ContactError) -> RunFailure {
    let finding = Diagnostic::of(error).field("mate");
    RunFailure::bad_input(finding)
}
