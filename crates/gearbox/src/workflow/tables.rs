//! Tables of a run of the electronic gearbox as CSV.

use super::additions::SplitChange;
use super::result::ExploreResult;
use super::run::GearboxOutcome;
use control::{EngagingRecord, FollowingRecord};
use electronic_gearbox::pulse::{PulseKind, TimedPulse};
use job::{Cell, Column, CsvError, CsvTable};

/// Errors over time: least and greatest in every stretch, along the feed and at the flank.
///
/// # Errors
/// A value that is not finite.
pub fn errors(outcome: &GearboxOutcome) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&[
        Column::new("time", "s"),
        Column::new("along_feed_least", "um"),
        Column::new("along_feed_greatest", "um"),
        Column::new("rotation_at_flank_least", "um"),
        Column::new("rotation_at_flank_greatest", "um"),
    ]);
    let um = outcome.result.coupling.flank_um_per_rad;
    for bin in &outcome.run.bins {
        let (axial, angle) = (bin.axial, bin.angle);
        table.push(&[
            bin.time,
            1e3 * axial.least,
            1e3 * axial.greatest,
            um * angle.least,
            um * angle.greatest,
        ])?;
    }
    Ok(table)
}

/// The servo over time: least and greatest in every stretch.
///
/// # Errors
/// A value that is not finite.
pub fn servo(record: &FollowingRecord, um: f64) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&[
        Column::new("time", "s"),
        Column::new("setpoint_least", "um"),
        Column::new("setpoint_greatest", "um"),
        Column::new("workpiece_least", "um"),
        Column::new("workpiece_greatest", "um"),
        Column::new("torque_least", "N_m"),
        Column::new("torque_greatest", "N_m"),
    ]);
    for bin in &record.bins {
        table.push(&[
            bin.time,
            um * bin.setpoint.least,
            um * bin.setpoint.greatest,
            um * bin.actual.least,
            um * bin.actual.greatest,
            bin.torque.least,
            bin.torque.greatest,
        ])?;
    }
    Ok(table)
}

/// Every pulse: R of the scale, Z at the spacing of the interval before, K at the clock's pace; and by how many parts it turned the
/// workpiece.
///
/// # Errors
/// A value that is not finite.
pub fn pulses(trace: &[(TimedPulse, i64)], clock: f64) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&[
        Column::new("tick", ""),
        Column::new("time", "s"),
        Column::new("sign", ""),
        Column::new("kind", ""),
        Column::new("turned", "parts"),
    ]);
    for (timed, turned) in trace {
        let kind = match timed.pulse.kind {
            PulseKind::Reference => "R",
            PulseKind::Intermediate => "Z",
            PulseKind::Correction => "K",
        };
        table.push_cells(&[
            Cell::Number(timed.tick as f64),
            Cell::Number(timed.tick as f64 / clock),
            Cell::Number(timed.pulse.direction.sign() as f64),
            Cell::Word(kind),
            Cell::Number(*turned as f64),
        ])?;
    }
    Ok(table)
}

/// Every change of whole workpiece pulses and voltage, with the pulses that went out.
///
/// # Errors
/// A value that is not finite.
pub fn split(trace: &[SplitChange], clock: f64) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&[
        Column::new("tick", ""),
        Column::new("time", "s"),
        Column::new("coarse_pulses", ""),
        Column::new("coarse", ""),
        Column::new("fine", "parts"),
        Column::new("voltage", "V"),
    ]);
    for change in trace {
        table.push(&[
            change.tick as f64,
            change.tick as f64 / clock,
            change.coarse_pulses as f64,
            change.coarse as f64,
            f64::from(change.fine),
            change.volts,
        ])?;
    }
    Ok(table)
}

/// The engagement over time.
///
/// # Errors
/// A value that is not finite.
pub fn engagement(record: &EngagingRecord) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&[
        Column::new("time", "s"),
        Column::new("speed", "deg_per_s"),
        Column::new("to_gap", "deg"),
    ]);
    for sample in &record.samples {
        table.push_cells(&[
            Cell::Number(sample.time),
            Cell::Number(sample.speed),
            sample.to_gap.map_or(Cell::Empty, Cell::Number),
        ])?;
    }
    Ok(table)
}

/// All set-ups in the order of the ranking.
///
/// # Errors
/// A value that is not finite.
pub fn set_ups(explored: &ExploreResult) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&[
        Column::new("rank", ""),
        Column::new("pulses_per_metre", ""),
        Column::new("clock", "Hz"),
        Column::new("pulses_per_interval", ""),
        Column::new("pulses_per_revolution", ""),
        Column::new("cost", ""),
        Column::new("flank", "um"),
        Column::new("quantisation", "um"),
        Column::new("of_clock", "um"),
        Column::new("acceleration", "um"),
        Column::new("resolution", "um"),
        Column::new("rounding", "um"),
        Column::new("measuring", "um"),
        Column::new("greatest_speed", "mm_per_min"),
        Column::new("feasible", ""),
        Column::new("refused", ""),
    ]);
    let number = |x: Option<f64>| x.map_or(Cell::Empty, Cell::Number);
    for s in &explored.set_ups {
        table.push_cells(&[
            Cell::Number(s.rank as f64),
            Cell::Number(s.pulses_per_metre),
            Cell::Number(s.clock_hz),
            Cell::Number(f64::from(s.pulses_per_interval)),
            Cell::Number(f64::from(s.pulses_per_revolution)),
            Cell::Number(s.cost),
            number(s.flank_um),
            Cell::Number(s.quantisation_um),
            Cell::Number(s.clock_um),
            Cell::Number(s.acceleration_um),
            Cell::Number(s.resolution_um),
            number(s.rounding_um),
            Cell::Number(s.measuring_um),
            Cell::Number(s.greatest_speed_mm_per_min),
            Cell::Word(if s.feasible { "yes" } else { "no" }),
            s.refused.map_or(Cell::Empty, Cell::Word),
        ])?;
    }
    Ok(table)
}
