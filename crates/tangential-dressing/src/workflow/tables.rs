//! Tables of a run of tangential dressing as CSV.

use super::run::TangentialOutcome;
use crate::TangentialFlank;
use contact::Measure;
use foundation::geometry::Flank;
use foundation::numerics::equidistant;
use generating_grinding::workflow::tables::ROWS;
use job::{Column, CsvError, CsvTable};

/// Derivatives of the unmodified flank by the variables.
///
/// # Errors
/// A value that is not finite.
pub fn sensitivities(outcome: &TangentialOutcome) -> Result<CsvTable, CsvError> {
    // Millimetres per coefficient in mm are micrometres per micrometre; gA counts per mrad.
    let mut table = CsvTable::labelled(
        "flank variable",
        &[Column::new("w", "mm"), Column::new("z", "mm"), Column::new("dm_dc", "um per um or mrad")],
    );
    for s in &outcome.result.sensitivities {
        let label = format!("{} {}", s.flank, s.variable);
        for (i, &w) in s.w_mm.iter().enumerate() {
            for (j, &z) in s.z_mm.iter().enumerate() {
                table.push_labelled(&label, &[w, z, s.values[i][j]])?;
            }
        }
    }
    Ok(table)
}

/// The convergence of the fits: one row a round.
///
/// # Errors
/// A value that is not finite.
pub fn fit(outcome: &TangentialOutcome) -> Result<CsvTable, CsvError> {
    let mut table =
        CsvTable::labelled("pass", &[Column::new("round", ""), Column::new("weighted_rms", "um")]);
    for pass in &outcome.result.passes {
        let label = pass.flanks.join(" and ");
        let ends = pass.weighted_rms_by_round_um.iter().chain([&pass.weighted_rms_um]);
        for (k, &rms) in ends.enumerate() {
            table.push_labelled(&label, &[k as f64, rms])?;
        }
    }
    Ok(table)
}

/// The dressing motion of a flank over x_D; `None` if it is not ground.
///
/// # Errors
/// A value that is not finite.
pub fn dressing_motion(outcome: &TangentialOutcome, flank: Flank) -> Result<Option<CsvTable>, CsvError> {
    let Some(run) = &outcome.flanks[flank] else { return Ok(None) };
    let model = &outcome.prepared.model;
    let ground = TangentialFlank::new(model, flank, &run.pass, &run.settings, Measure::Ray);
    let mut table = CsvTable::new(&[
        Column::new("x_D", "mm"),
        Column::new("v_zS", "mm"),
        Column::new("phi_S", "deg"),
        Column::new("gamma_A", "deg"),
        Column::new("d_A", "mm"),
        Column::new("v_yA", "mm"),
        Column::new("d_phi_S", "deg"),
        Column::new("d_gamma", "deg"),
        Column::new("d_d", "mm"),
        Column::new("d_v_yA", "mm"),
    ]);
    for x in equidistant(run.strokes.dressing, ROWS) {
        let row = ground.dressing_row(x);
        let turn = row.worm_angle - model.chain.worm_angle - row.worm_shift / model.chain.screw_parameter;
        table.push(&[
            row.position,
            row.worm_shift,
            row.worm_angle.to_degrees(),
            row.crossing_angle.to_degrees(),
            row.centre_distance,
            row.offset,
            turn.to_degrees(),
            (row.crossing_angle - model.chain.crossing_angle).to_degrees(),
            row.centre_distance - model.chain.centre_distance,
            row.offset,
        ])?;
    }
    Ok(Some(table))
}
