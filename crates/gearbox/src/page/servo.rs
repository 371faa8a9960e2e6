//! The servo of the workpiece spindle: errors and torque over time, figures, its answer to a torque.

use super::bands::{chart, panel, stretches};
use crate::workflow::ServoResult;
use control::FollowingRecord;
use report::charts::{ChartError, format_significant};
use report::{Block, Column, Figure, Quantity, Table};

/// Of a servo with its record; `um` is what the flank moves per angle, um/rad.
pub(super) fn blocks(
    servo: &ServoResult,
    record: &FollowingRecord,
    um: f64,
) -> Result<Vec<Block>, ChartError> {
    let bins = &record.bins;
    let panels = vec![
        panel(
            "setpoint of the gearbox [µm]",
            &stretches(bins, um, |bin| (bin.time, bin.setpoint)),
            None,
            None,
        ),
        panel("workpiece [µm]", &stretches(bins, um, |bin| (bin.time, bin.actual)), None, None),
        panel("torque of the motor [N m]", &stretches(bins, 1.0, |bin| (bin.time, bin.torque)), None, None),
    ];
    let svg = chart("Servo of the workpiece spindle over time", panels)?;
    let caption =
        "Least and greatest in each stretch of time; errors at the flank, normal, their means removed.";
    let response = Table {
        caption: "Answer to a disturbing torque, linear".into(),
        columns: vec![Column::number("Frequency", "Hz"), Column::number("Flank per torque", "µm/(N m)")],
        rows: servo
            .disturbance_response
            .iter()
            .map(|r| [r.frequency_hz, r.um_per_n_m].map(|x| format_significant(x, 4)).to_vec())
            .collect(),
        note: String::new(),
    };
    Ok(vec![
        Block::Figure(Figure::new("servo-of-the-workpiece-spindle-over-time", svg, caption)),
        Block::Tables(vec![Table::of_quantities("Figures", &quantities(servo)), response]),
    ])
}

fn quantities(result: &ServoResult) -> Vec<Quantity> {
    vec![
        Quantity::number("settling before the motion", "", result.settling_s, "s"),
        Quantity::number("setpoint, rms", "", result.setpoint.rms_um, "µm"),
        Quantity::number("setpoint, peak", "", result.setpoint.peak_um, "µm"),
        Quantity::number("workpiece, rms", "", result.workpiece.rms_um, "µm"),
        Quantity::number("workpiece, peak", "", result.workpiece.peak_um, "µm"),
        Quantity::number("workpiece, mean removed", "", result.workpiece.mean_um, "µm"),
        Quantity::number("greatest torque", "", result.greatest_torque_n_m, "N m"),
        Quantity::number("samples at the limit of the torque", "", 1e2 * result.torque_limited_share, "%"),
        Quantity::number("largest pole", "|z|", result.largest_pole, ""),
    ]
}
