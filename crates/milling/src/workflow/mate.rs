//! A gear rolled against its mate: the wanted flanks of both, where they touch, and beside it what their ease-offs say; and the flank as
//! it is milled.

use super::mate_flank::start_of_flank;
use super::mate_result::{MateFlankResult, MateResult, PatternResult};
use super::mate_start::start_of_cylindrical_flank;
use super::prepare::{MateKind, MatePair, MillingBodies, PairSide};
use super::referee::predict;
use crate::{FlankPlan, MillingPlan};
use contact::{
    ContactError, ContactPattern, FlankDeviation, FlankPlaces, GapField, RollCourse, RolledGear, RolledPair,
    overlap, parts,
};
use foundation::geometry::{Flank, Surface};
use foundation::numerics::{equidistant, extremes};
use job::Diagnostic;
use run::RunFailure;
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
    /// The flank as it is milled, once it is planned.
    pub milled: Option<MilledContact>,
}

/// Contact of a flank as the cutters leave it.
#[derive(Clone, Debug)]
pub struct MilledContact {
    /// Where gaps are known: as many rows that scallops show.
    pub places: FlankPlaces,
    /// Gaps of the roll.
    pub gaps: GapField,
    /// Lag of the mate.
    pub course: RollCourse,
    /// Places of which nothing is predicted, so that they are not rolled.
    pub unknown: usize,
}

/// Places over height and length.
const PLACES: [usize; 2] = [33, 49];
/// Places from one row to the next on a milled flank, and the most in all: a scallop is a parabola, which eight places show to 1.6 % of
/// its height.
const PLACES_PER_ROW: usize = 8;
const MOST_HEIGHTS: usize = 401;
/// The most roll positions for each mesh period of a milled flank.
const MOST_POSITIONS: usize = 400;
/// Share of the flank below which a part of a pattern is a speck.
const SPECK: f64 = 0.005;

/// Contact of the gear with its mate.
///
/// # Errors
/// [`RunFailure`] for gears that do not come together.
pub(super) fn roll(pair: &MatePair, bodies: &MillingBodies) -> Result<MateOutcome, RunFailure> {
    let wanted = &bodies.options.sides;
    let sides: Vec<(Flank, &PairSide)> =
        pair.sides.iter().filter(|(side, _)| wanted.contains(side)).collect();
    let (start, remark) = match &pair.kind {
        MateKind::Conical(gears) => start_of_flank(&gears[0], &gears[1]),
        MateKind::Cylindrical { .. } => start_of_cylindrical_flank(&sides),
    };
    let mut flanks = Vec::new();
    let mut results = BTreeMap::new();
    for (side, of) in sides {
        let contact = contact(of, pair).map_err(|error| failure(&error))?;
        results.insert(side.name(), contact.figures(1e-3 * pair.marking_um, pair.radius));
        flanks.push(contact);
    }
    let mut result = MateResult {
        teeth: pair.teeth,
        pitch_cone_angle_deg: None,
        shaft_angle_deg: None,
        centre_distance_mm: None,
        backlash_um: None,
        mean_pitch_radius_mm: pair.radius,
        marking_um: pair.marking_um,
        start_of_flank: start,
        flanks: results,
    };
    match &pair.kind {
        MateKind::Conical(gears) => {
            let [own, mate] = gears.each_ref().map(|gear| gear.data().pitch_angle);
            result.pitch_cone_angle_deg = Some(mate.to_degrees());
            result.shaft_angle_deg = Some((own + mate).to_degrees());
        }
        MateKind::Cylindrical { centre_distance, backlash } => {
            result.centre_distance_mm = Some(*centre_distance);
            result.backlash_um = Some(1e3 * backlash);
        }
    }
    Ok(MateOutcome { result, flanks, remark })
}

fn rolled(pair: &MatePair, of: &PairSide, own: RolledGear) -> Result<RolledPair, ContactError> {
    let flank = of.conjugate.flank();
    let pair = RolledPair::new([own, of.gears[1].clone()], pair.arrangement, flank)?;
    Ok(pair.with_play_of(&of.nominal))
}

fn contact(of: &PairSide, pair: &MatePair) -> Result<MateFlank, ContactError> {
    let rolled = rolled(pair, of, of.gears[0].clone())?;
    let ease = [&*of.offsets[0], &*of.offsets[1]];
    let found = rolled.roll(pair.roll_positions)?;
    let said = of.conjugate.course(ease, pair.roll_positions);
    let gear = rolled.first();
    let places = FlankPlaces {
        heights: equidistant(gear.heights, PLACES[0]),
        lengths: equidistant(gear.lengths, PLACES[1]),
    };
    Ok(MateFlank {
        side: of.conjugate.flank(),
        surface: gear.surface.clone(),
        gaps: [rolled.field(&places, &found), of.conjugate.field(&places, ease, &said)],
        places,
        courses: [found, said],
        milled: None,
    })
}

impl MateOutcome {
    /// With the flanks as they are milled: what the rows of the plan leave on them, scallops and chords of the blocks, rolled as the wanted
    /// flanks were.
    ///
    /// # Errors
    /// [`RunFailure`] for places that nothing can be predicted of.
    pub(super) fn with_milled(
        mut self,
        pair: &MatePair,
        bodies: &MillingBodies,
        plan: &MillingPlan,
    ) -> Result<Self, RunFailure> {
        for flank in &mut self.flanks {
            let Some(planned) = plan.flanks.iter().find(|of| of.side.flank == flank.side) else { continue };
            let Some(milled) = milled(pair, &pair.sides[flank.side], bodies, planned)? else { continue };
            if let Some(result) = self.result.flanks.get_mut(flank.side.name()) {
                milled.add_to(1e-3 * pair.marking_um, pair.radius, &*flank.surface, result);
            }
            flank.milled = Some(milled);
        }
        Ok(self)
    }
}

/// A flank of the plan against its mate; `None` where nothing is predicted of it, or what stands of it never faces the mate.
fn milled(
    pair: &MatePair,
    of: &PairSide,
    bodies: &MillingBodies,
    planned: &FlankPlan,
) -> Result<Option<MilledContact>, RunFailure> {
    let active = &planned.active;
    let (heights, lengths) = (active.height_span(), active.face);
    let rows = (PLACES_PER_ROW * planned.rows.len().saturating_sub(1) + 1).clamp(PLACES[0], MOST_HEIGHTS);
    let counts = [rows, PLACES[1]];
    let places =
        FlankPlaces { heights: equidistant(heights, counts[0]), lengths: equidistant(lengths, counts[1]) };
    let left: Vec<Option<f64>> = predict(bodies, planned, &places.heights, &places.lengths)?
        .into_iter()
        .map(|left| left.map(|left| left.stock()))
        .collect();
    let unknown = left.iter().filter(|left| left.is_none()).count();
    let Some(deviation) = FlankDeviation::new(heights, lengths, counts, &left) else { return Ok(None) };
    let own = RolledGear { surface: active.surface.clone(), heights, lengths, ..of.gears[0].clone() };
    let rolled = rolled(pair, of, own).map_err(|error| failure(&error))?.deviating(Some(deviation));
    // As a row passes by the mate rises and falls with its crest.
    let [from, to] = extremes(heights.map(|height| of.conjugate.roll([height, lengths[0]])));
    let rows_per_pitch = planned.rows.len() as f64 * rolled.pitch() / (to - from);
    let positions = pair.roll_positions.max((PLACES_PER_ROW as f64 * rows_per_pitch).ceil() as usize);
    let Ok(course) = rolled.roll(positions.min(MOST_POSITIONS)) else { return Ok(None) };
    let gaps = rolled.field(&places, &course);
    Ok(Some(MilledContact { places, gaps, course, unknown }))
}

impl MilledContact {
    fn add_to(&self, marking: f64, radius: f64, surface: &dyn Surface, result: &mut MateFlankResult) {
        let areas = self.places.areas(surface);
        let pattern = ContactPattern::of(&self.gaps, marking, &self.places, &areas);
        let error = self.course.peak_to_peak();
        result.milled = pattern.map(|pattern| PatternResult::new(&pattern));
        result.transmission_error_milled_arcsec = Some(3600.0 * error.to_degrees());
        result.transmission_error_milled_um = Some(1e3 * radius * error);
        result.places_not_predicted = self.unknown;
    }
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
        let parts = parts(&self.gaps[0], marking, &self.places, &areas, SPECK);
        MateFlankResult {
            rolled,
            parts: parts.iter().map(PatternResult::new).collect(),
            ease_off,
            milled: None,
            overlap_percent: 100.0 * overlap(self.gaps.each_ref(), marking, &areas),
            transmission_error_arcsec: 3600.0 * error[0].to_degrees(),
            transmission_error_um: 1e3 * radius * error[0],
            transmission_error_ease_off_um: 1e3 * radius * error[1],
            transmission_error_milled_arcsec: None,
            transmission_error_milled_um: None,
            places_not_predicted: 0,
        }
    }
}

fn failure(error: &ContactError) -> RunFailure {
    let finding = Diagnostic::of(error).field("mate");
    RunFailure::bad_input(finding)
}
