//! What planned settings leave on a machine whose axes are off: the same motions with deviations, by rays.

use super::execution::Execution;
use super::forward::{Deviation, deviated_motion};
use super::prepare::Prepared;
use super::referee::{self, Cutting};
use super::result::{DeviatedFlank, DeviatedResult};
use crate::job::MachineDeviations;
use foundation::geometry::Sides;
use foundation::numerics::Progress;
use job::{Diagnostic, Problem};
use metrology::Topography;
use run::{CharacteristicsUm, RunFailure};

/// The execution of a plan with axes that are off; `place` is the table of the job that says so.
///
/// # Errors
/// [`RunFailure::BadInput`] for deviations of dressing of a tool that no disc dresses in line contact.
pub fn deviated(
    prepared: &Prepared,
    execution: &Execution,
    of: &MachineDeviations,
    place: &str,
) -> Result<Execution, RunFailure> {
    let mut off = execution.clone();
    off.motion = deviated_motion(prepared, execution, &of_motion(of))?;
    let dressing = of.dressing.values();
    if dressing != [0.0; 4] && !off.shift_dressing(dressing) {
        let finding = Diagnostic::new(Problem::InvalidJob, "no disc dresses this tool in line contact")
            .field(format!("{place}.dressing"))
            .value("deviations of the dressing axes")
            .allowed("none")
            .way_out("leave the table out; axes of grinding may be off");
        return Err(RunFailure::bad_input(finding));
    }
    Ok(off)
}

/// Deviations of the grinding motion, each in the unit of its name.
fn of_motion(of: &MachineDeviations) -> Vec<(Deviation, f64)> {
    let orders = |values: &[f64], of: fn(u8) -> Deviation| {
        (0..).zip(values).map(|(k, value)| (of(k), *value)).collect::<Vec<_>>()
    };
    let mut deviations = orders(&of.radial_feed_um, Deviation::RadialFeed);
    deviations.extend(orders(&of.work_angle_arcsec, Deviation::WorkAngle));
    deviations.push((Deviation::CrossingAngle, of.crossing_angle_deg));
    deviations
}

/// What the planned settings leave with the deviations of the job, by the referee; `None` where it gives none. `simulated` is what they leave
/// without.
pub(super) fn with_deviations(
    prepared: &Prepared,
    execution: &Execution,
    (simulated, cutting): (&Sides<Option<referee::Verdict>>, Cutting<'_>),
    progress: &dyn Progress,
) -> Result<Option<DeviatedResult>, RunFailure> {
    let Some(of) = &prepared.deviations else { return Ok(None) };
    let off = deviated(prepared, execution, of, "deviations")?;
    let cutting = Cutting { feed_per_revolution: None, ..cutting };
    let verdicts = referee::run(&prepared.setup, &off, cutting, progress)
        .map_err(|e| RunFailure::of_removal(&e, "deviations"))?;
    let flanks = verdicts.iter().filter_map(|(flank, verdict)| {
        let (off, good) = (verdict.as_ref()?, simulated[flank].as_ref()?);
        let target = &execution.flanks[flank].as_ref()?.target;
        let cos_b = prepared.setup.lines[flank].cos_b2;
        let (form, mean) = form_and_mean(&off.simulated.minus(&good.simulated));
        let left = form.plus(&good.simulated.minus(target));
        Some((
            flank.name(),
            DeviatedFlank {
                max_deviation_um: left.largest() * 1e3,
                tolerance_share: prepared.tolerance_share(&left),
                largest_change_um: form.largest() * 1e3,
                stock_um: mean * 1e3,
                characteristics: CharacteristicsUm::of(&off.simulated, cos_b),
                change_um: form.rows_um(),
            },
        ))
    });
    Ok(Some(DeviatedResult { flanks: flanks.collect() }))
}

/// What is the same over the whole flank is tooth thickness, not form.
fn form_and_mean(change: &Topography) -> (Topography, f64) {
    let mean = change.f.iter().sum::<f64>() / change.f.len() as f64;
    let f = change.f.iter().map(|f| f - mean).collect();
    (Topography { f, ..change.clone() }, mean)
}
