//! Fills the section of the report on gearbox and servo.

use super::result::{ControlFlankResult, ControlResult, Trace};
use foundation::geometry::{Flank, Sides};
use report::Quantity;
use report::charts::{ChartError, Topography};
use report::control::{ControlFlankReport, ControlReport, ToothTrace};

/// The section's figures; `w` and `z` are the grid of the job, mm.
///
/// # Errors
/// [`ChartError`] for a topography that is none.
pub fn control_report(
    control: &ControlResult,
    grid: impl Fn(Flank) -> Option<(Vec<f64>, Vec<f64>)>,
) -> Result<ControlReport, ChartError> {
    let flank = |side: Flank| match (control.flanks.get(side.name()), grid(side)) {
        (Some(f), Some((w, z))) => flank_report(f, w, z).map(Some),
        _ => Ok(None),
    };
    Ok(ControlReport {
        quantities: vec![
            Quantity::number("speed of the worm", "n_1", control.worm_speed_rpm, "1/min"),
            Quantity::number("speed of the workpiece", "n_2", control.work_speed_rpm, "1/min"),
            Quantity::number("speed of the feed", "", control.feed_mm_per_min, "mm/min"),
            Quantity::number("pitch of the feed's scale", "p", control.scale_pitch_um, "µm"),
            Quantity::number("flank per part of the setpoint", "", control.setpoint_step_um, "µm"),
            Quantity::number("flank per count of the workpiece's encoder", "", control.encoder_step_um, "µm"),
            Quantity::number("rounding of the feed's ratio", "", control.ratio_error_um_per_m, "µm per m"),
            Quantity::number("frequency of the threads", "", control.thread_frequency_hz, "Hz"),
            Quantity::number(
                "flank per torque at that frequency",
                "",
                control.compliance_at_threads_um_per_n_m,
                "µm/Nm",
            ),
        ],
        flanks: Sides::try_from_fn(flank)?,
    })
}

fn flank_report(f: &ControlFlankResult, w: Vec<f64>, z: Vec<f64>) -> Result<ControlFlankReport, ChartError> {
    let traces = |list: &[Trace], at: &[f64]| {
        list.iter()
            .map(|trace| ToothTrace {
                tooth: trace.tooth,
                coordinate_mm: at.to_vec(),
                f_um: trace.f_um.clone(),
            })
            .collect()
    };
    Ok(ControlFlankReport {
        largest_um: f.largest_um,
        rms_um: f.rms_um,
        with_control_um: f.deviation_with_control_um,
        pitch_um: [f.single_pitch_um, f.cumulative_pitch_um],
        model_difference_um: (f.model_difference_um, f.sample),
        torque_n_m: (f.greatest_torque_n_m, f.torque_limited_share),
        first_tooth: Topography::new(w, z, f.topography_um.clone())?,
        profiles: traces(&f.profiles, &f.trace_w_mm),
        helices: traces(&f.helices, &f.trace_z_mm),
        tooth_means_um: f.tooth_means_um.clone(),
        feed_mm: f.error.feed_mm.clone(),
        setpoint_um: f.error.setpoint_um.clone(),
        actual_um: f.error.actual_um.clone(),
    })
}
