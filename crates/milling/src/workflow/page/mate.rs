//! Contact with the mate as the page takes it.

use crate::page::{MateFlankView, MateView, PatternFigures};
use crate::workflow::result::{MateFlankResult, MateResult, PatternResult};
use crate::workflow::{MateFlank, MateOutcome};
use contact::{GapField, RollCourse};
use report::Quantity;

/// Mesh periods in the chart, and points between two roll positions: the corner where a pair hands over lies between them.
const PERIODS: usize = 3;
const BETWEEN: usize = 4;

pub(super) fn mate(outcome: &MateOutcome) -> MateView {
    let result = &outcome.result;
    let of_flank = |flank: &MateFlank| Some(view(flank, result, result.flanks.get(flank.side.name())?));
    MateView {
        quantities: vec![
            Quantity::count("teeth of the mate", "z_2", i64::from(result.teeth)),
            Quantity::number("its pitch cone angle", "δ_2", result.pitch_cone_angle_deg, "deg"),
            Quantity::number("shaft angle", "Σ", result.shaft_angle_deg, "deg"),
            Quantity::number("its mean pitch radius", "r_m2", result.mean_pitch_radius_mm, "mm"),
            Quantity::number("marking", "", result.marking_um, "µm"),
        ],
        marking_um: result.marking_um,
        flanks: outcome.flanks.iter().filter_map(of_flank).collect(),
    }
}

fn view(flank: &MateFlank, result: &MateResult, figures: &MateFlankResult) -> MateFlankView {
    let side = flank.side.name();
    let places_mm = developed(flank);
    let columns = flank.places.lengths.len();
    let gaps = |field: &GapField| {
        let um = |gap: &f64| gap.is_finite().then_some(1e3 * gap);
        field.gaps.chunks(columns).map(|row| row.iter().map(um).collect()).collect()
    };
    let [found, said] = &flank.courses;
    let pitch = found.step() * found.per_pitch() as f64;
    let per_pitch = BETWEEN * found.per_pitch();
    let count = PERIODS * per_pitch + 1;
    let rolls: Vec<f64> =
        (0..count).map(|k| (k as f64 / per_pitch as f64 - 0.5 * PERIODS as f64) * pitch).collect();
    let error = |course: &RollCourse| {
        rolls.iter().map(|roll| -1e3 * result.mean_pitch_radius_mm * course.at(*roll)).collect()
    };
    MateFlankView {
        name: format!("{}{} flank", side[..1].to_uppercase(), &side[1..]),
        rolled_um: gaps(&flank.gaps[0]),
        ease_off_um: gaps(&flank.gaps[1]),
        centre_mm: figures.rolled.map(|pattern| centre(&places_mm, &pattern)),
        places_mm,
        transmission_um: error(found),
        transmission_ease_off_um: error(said),
        roll_deg: rolls.iter().map(|roll| roll.to_degrees()).collect(),
        patterns: [figures.rolled, figures.ease_off].map(|pattern| pattern.as_ref().map(pattern_figures)),
        overlap_percent: figures.overlap_percent,
        peak_to_peak: [figures.transmission_error_arcsec, figures.transmission_error_um],
    }
}

/// Length from the toe, and the way up the profile from the root, mm.
fn developed(flank: &MateFlank) -> Vec<Vec<[f64; 2]>> {
    let places = &flank.places;
    let toe = places.lengths[0];
    let mut up = vec![0.0; places.lengths.len()];
    let mut rows = Vec::with_capacity(places.heights.len());
    for (i, height) in places.heights.iter().enumerate() {
        let mut row = Vec::with_capacity(places.lengths.len());
        for (j, length) in places.lengths.iter().enumerate() {
            if i > 0 {
                let below = flank.surface.point(places.heights[i - 1], *length);
                up[j] += (flank.surface.point(*height, *length) - below).norm();
            }
            row.push([length - toe, up[j]]);
        }
        rows.push(row);
    }
    rows
}

fn centre(places_mm: &[Vec<[f64; 2]>], pattern: &PatternResult) -> [f64; 2] {
    let nearest =
        |percent: f64, count: usize| ((0.01 * percent * (count - 1) as f64).round() as usize).min(count - 1);
    let row = &places_mm[nearest(pattern.centre_height_percent, places_mm.len())];
    row[nearest(pattern.centre_length_percent, row.len())]
}

fn pattern_figures(pattern: &PatternResult) -> PatternFigures {
    PatternFigures {
        area: pattern.area_percent,
        centre: [pattern.centre_length_percent, pattern.centre_height_percent],
        length: pattern.length_percent,
        height: pattern.height_percent,
    }
}
