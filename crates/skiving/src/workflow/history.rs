//! A measurement as a line of its tool's history, and what the lines since the last grinding say together.

use super::measurement::Measurement;
use super::prepare::{HistoryFile, PreparedSkiving, SkivingBodies};
use super::result::{FlankTrendResult, HistoryResult, MeasurementResult};
use crate::history::{
    HistoryRecord, RecordedEdge, RecordedFlank, RecordedFlanks, RecordedMounting, RecordedPitch,
    append_history,
};
use crate::job::ToolHistory;
use crate::wear::{WearPoint, WearTrend};
use foundation::geometry::{Flank, Sides};
use foundation::numerics::root_mean_square;
use run::JobFailure;
use verdict::Remark;

/// A noted measurement.
#[derive(Clone, Debug)]
pub struct Noted {
    /// Measurements of the tool since it was ground, this one the last.
    pub cycle: Vec<HistoryRecord>,
    /// Trend of each flank, where two counts of workpieces make one.
    pub trends: Sides<Option<WearTrend>>,
    /// Figures.
    pub result: HistoryResult,
    /// Remarks.
    pub remarks: Vec<Remark>,
}

/// What a linear evaluation is off at most where teeth deviate by some 20 um (`docs/mathematics/skiving.md#how-it-is-verified`), um: two
/// measurements differ by as much without any noise.
const LINEARISATION_UM: f64 = 0.03;
/// Decimals of um and urad that are noted: a repeated run notes the same, on any processor.
const DECIMALS: f64 = 1e4;

/// Adds the measurement to the history that the job names.
///
/// # Errors
/// [`JobFailure`]: a history that cannot be read, or that says otherwise.
pub(super) fn noted(
    prepared: &PreparedSkiving,
    result: Option<&MeasurementResult>,
    measurement: Option<&Measurement>,
) -> Result<Option<Noted>, JobFailure> {
    let (Some(given), Some(result), Some(measurement)) = (&prepared.history, result, measurement) else {
        return Ok(None);
    };
    let HistoryFile { path, entry } = given;
    let bodies = &prepared.bodies;
    let record = record(entry, bodies, result, measurement);
    let history = append_history(path, &record)?;
    let cycle: Vec<HistoryRecord> = history.cycle_until(&record).into_iter().cloned().collect();
    let trend = |flank: Flank| {
        let points: Vec<WearPoint> = cycle.iter().map(|record| record.wear_point(flank)).collect();
        WearTrend::fit(&points, bodies.options.wear_limit).ok()
    };
    let trends = Sides::from_fn(trend);
    let flanks = Flank::BOTH.into_iter().map(|flank| {
        let now = 1e3 * record.wear_point(flank).wear;
        (flank.name(), FlankTrendResult::new(now, trends[flank].as_ref()))
    });
    let result = HistoryResult {
        tool: entry.tool.clone(),
        measurements: cycle.len(),
        parts: entry.parts,
        resharpened: entry.resharpened,
        flanks: flanks.collect(),
    };
    let remarks = remarks(&trends);
    Ok(Some(Noted { cycle, trends, result, remarks }))
}

fn remarks(trends: &Sides<Option<WearTrend>>) -> Vec<Remark> {
    let bent: Vec<&str> = trends
        .iter()
        .filter(|(_, trend)| trend.as_ref().is_some_and(WearTrend::is_bent))
        .map(|(flank, _)| flank.name())
        .collect();
    if bent.is_empty() {
        return Vec::new();
    }
    vec![Remark {
        code: "wear-not-even",
        text: format!("the last measurement lies off the line of wear ({} flank)", bent.join(" and ")),
        way_out: "do not rely on the forecast: measure again soon".into(),
    }]
}

fn record(
    given: &ToolHistory,
    bodies: &SkivingBodies,
    result: &MeasurementResult,
    measurement: &Measurement,
) -> HistoryRecord {
    let sigma = measurement.deviations(bodies);
    // The means are those of the whole teeth.
    let teeth = measurement.evaluation.count().max(1) as f64;
    let flank = |flank: Flank| {
        let noise = 1e3 * root_mean_square(&sigma[flank]) / teeth.sqrt();
        RecordedFlank {
            places: bodies.flanks[flank].tracks.iter().map(|(track, _)| track.place).collect(),
            track_mean_um: result.profile.track_mean_um[flank.name()].iter().map(|um| rounded(*um)).collect(),
            sigma_um: rounded(noise.hypot(LINEARISATION_UM)),
        }
    };
    let out = &measurement.evaluation.profile.out_of_band;
    HistoryRecord {
        tool: given.tool.clone(),
        time: given.time.clone(),
        parts: given.parts,
        resharpened: given.resharpened,
        flanks: RecordedFlanks { left: flank(Flank::Left), right: flank(Flank::Right) },
        pitch: RecordedPitch {
            total_um: rounded(result.pitch.total_um),
            largest_single_um: rounded(result.pitch.largest_single_um),
        },
        mounting: RecordedMounting {
            eccentricity_um: result.mounting.eccentricity_um.map(rounded),
            wobble_urad: result.mounting.wobble_urad.map(rounded),
        },
        out_of_band: out
            .iter()
            .map(|(flank, tooth)| RecordedEdge { flank: *flank, tooth: *tooth as u32 })
            .collect(),
        version: env!("CARGO_PKG_VERSION").into(),
    }
}

fn rounded(value: f64) -> f64 {
    (DECIMALS * value).round() / DECIMALS
}
