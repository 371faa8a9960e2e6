//! A measured gear out of a REXS file: drawing data, modifications, profiles and helix traces.

use super::super::drawn::DrawnGear;
use super::super::files_content::MeasuredFiles;
use super::super::statements::Statements;
use super::{empty, tag};
use crate::workflow::convert::{of_rexs, remark};
use foundation::geometry::{Flank, Gear, Sides};
use job::{Diagnostic, Problem};
use measured_files::inspection::InspectedGear;
use measured_files::rexs::{RexsDocument, RexsError, RexsGear, gear_ids, gear_of};
use run::RunFailure;
use std::path::Path;
use verdict::Remark;

/// The first gear of a model that was read.
pub(super) fn measured(
    path: &Path,
    read: Result<RexsDocument, RexsError>,
    statements: &Statements,
) -> Result<MeasuredFiles, RunFailure> {
    statements.check_rexs()?;
    let refused = |error: RexsError| of_rexs(&error, path);
    let document = read.map_err(refused)?;
    let ids = gear_ids(&document);
    let Some(&first) = ids.first() else {
        let finding = Diagnostic::new(Problem::InvalidTable, "the file has no cylindrical gear")
            .field("components")
            .value(path.display())
            .allowed("a component cylindrical_gear or ring_gear")
            .way_out("export the model with its gears");
        return Err(RunFailure::bad_input(finding));
    };
    let (gear, warnings) = gear_of(&document, first).map_err(refused)?;
    let mut remarks: Vec<Remark> = warnings.iter().map(|w| remark(w, "compare with the drawing")).collect();
    if ids.len() > 1 {
        remarks.push(Remark {
            code: "first-gear-taken",
            text: format!("the file has {} gears; this is the one numbered {first}", ids.len()),
            way_out: "export the others as files of their own".into(),
        });
    }
    let body = gear.body().map_err(|error| refused(RexsError::NoGear { gear: first, error }))?;
    let drawn = drawn(&gear, &body)?;
    let mut inspection = empty(drawn.gear, path);
    inspection.name.clone_from(&gear.name);
    inspection.conditions = drawn.conditions;
    inspection.conditions.datum_face = gear.datum_face;
    inspection.traces = gear.deviations;
    tag(&mut inspection.traces);
    Ok(MeasuredFiles { remarks, modifications: gear.modifications, ..MeasuredFiles::new(inspection) })
}

fn drawn(gear: &RexsGear, body: &Gear) -> Result<DrawnGear, RunFailure> {
    let angles = gear.normal_pressure_angle_deg;
    if angles.left != angles.right {
        let finding = Diagnostic::new(Problem::InvalidNumber, "the pressure angles of the flanks differ")
            .field("normal_pressure_angle")
            .value(format!("{} and {} degrees", angles.left, angles.right))
            .allowed("the same on both flanks")
            .way_out("evaluate it with a job: `--job JOB`, from a table of traces");
        return Err(RunFailure::bad_input(finding));
    }
    let half = 0.5 * gear.face_width_mm;
    let roll = |flank: Flank, diameter: Option<f64>| {
        diameter.and_then(|d| body.flank(flank).length_of_roll(0.5 * d).ok())
    };
    let profile = Sides::from_fn(|flank| {
        let field = &gear.fields[flank];
        let tip = field.end_diameter_mm.or(gear.tip_diameter_mm);
        Some([roll(flank, field.start_diameter_mm)?, roll(flank, tip)?])
    });
    let helix =
        gear.fields.map(|_, field| [field.z_start_mm.unwrap_or(-half), field.z_end_mm.unwrap_or(half)]);
    let shift = gear.made_profile_shift().map_err(|error| {
        RunFailure::bad_input(Diagnostic::of(&error).field("span_measurement, size_over_balls"))
    })?;
    let drawn = InspectedGear {
        teeth: gear.teeth,
        normal_module_mm: gear.normal_module_mm,
        normal_pressure_angle_deg: angles.left,
        helix_angle_deg: gear.helix_angle_deg,
        profile_shift: Some(shift),
        face_width_mm: Some(gear.face_width_mm),
        tip_diameter_mm: gear.tip_diameter_mm,
        root_diameter_mm: gear.root_diameter_mm,
    };
    Ok(DrawnGear::new(drawn, profile, helix))
}
