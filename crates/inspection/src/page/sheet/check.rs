//! Whether the numbers of a sheet can be drawn: gaps may be anywhere, infinities nowhere.

use super::data::{SheetData, SheetTopography};
use super::traces_data::{SheetTrace, TraceRow};
use report::charts::{ChartError, check_ascending, check_length, check_values};

/// Checks every list that is drawn. Values of tables may be anything: what is no number is printed as a dash.
pub(super) fn check(sheet: &SheetData) -> Result<(), ChartError> {
    for row in [&sheet.profiles, &sheet.helices].into_iter().chain(&sheet.further) {
        check_row(row)?;
    }
    for (flank, pitch) in sheet.pitch.flanks.iter() {
        let Some(pitch) = pitch else { continue };
        let name = |what: &str| format!("{what} of the {flank} flanks");
        check_gappy(&name("single pitch deviations"), &pitch.single_um)?;
        for (what, list) in
            [("cumulative pitch deviations", &pitch.cumulative_um), ("eccentricity", &pitch.eccentric_um)]
        {
            check_gappy(&name(what), list)?;
            if !list.is_empty() {
                check_length(&name(what), pitch.single_um.len(), list.len())?;
            }
        }
    }
    let run_out = &sheet.pitch.run_out;
    check_gappy("run-out", &run_out.of_space_um)?;
    check_values("eccentricity of the run-out", &run_out.eccentric_um)?;
    if !run_out.eccentric_um.is_empty() {
        check_length("eccentricity of the run-out", run_out.of_space_um.len(), run_out.eccentric_um.len())?;
    }
    sheet.topographies.iter().try_for_each(check_topography)
}

/// Undefined values are gaps; all others are physical.
fn check_gappy(name: &str, values: &[f64]) -> Result<(), ChartError> {
    let wrong = values.iter().position(|v| !v.is_nan() && check_values("", &[*v]).is_err());
    let refused = |index| ChartError::InvalidNumber { quantity: name.into(), index, value: values[index] };
    wrong.map_or(Ok(()), |index| Err(refused(index)))
}

fn check_row(row: &TraceRow) -> Result<(), ChartError> {
    for (flank, field) in row.flanks.iter() {
        let name = |what: &str| format!("{what} of {}, {flank} flank", row.name);
        for line in &field.lines {
            check_values(&name("a line"), &[line.at_mm])?;
        }
        for trace in &field.traces {
            check_trace(&name(&format!("the trace of tooth {}", trace.tooth)), trace)?;
        }
    }
    Ok(())
}

fn check_trace(name: &str, trace: &SheetTrace) -> Result<(), ChartError> {
    check_length(name, trace.abscissa_mm.len(), trace.f_um.len())?;
    check_values(name, &trace.abscissa_mm)?;
    check_ascending(name, &trace.abscissa_mm)?;
    check_gappy(name, &trace.f_um)?;
    if let Some(line) = &trace.mean_line {
        check_values(name, line.as_flattened())?;
    }
    if let Some(band) = &trace.band {
        check_values(name, band.corners.as_flattened())?;
        check_values(name, &[band.shift_um])?;
    }
    Ok(())
}

fn check_topography(field: &SheetTopography) -> Result<(), ChartError> {
    let name = format!("the topography of tooth {}, {} flank", field.tooth, field.flank);
    for places in [&field.roll_mm, &field.face_mm] {
        check_values(&name, places)?;
        check_ascending(&name, places)?;
        if places.len() < 2 {
            return Err(ChartError::TooFewValues { quantity: name, actual: places.len(), least: 2 });
        }
    }
    check_length(&name, field.roll_mm.len(), field.f_um.len())?;
    for row in &field.f_um {
        check_length(&name, field.face_mm.len(), row.len())?;
        check_gappy(&name, row)?;
    }
    Ok(())
}
