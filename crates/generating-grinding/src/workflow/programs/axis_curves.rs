//! An axis of a machine over the time of a program, as curves.

use machine::Axis;
use motion::TraceRow;
use report::charts::{AxisChart, AxisChartLimits};

/// Beyond this (mm or deg, per s, per s^2) an axis jumps.
const JUMP: f64 = 1e9;

/// Curves of an axis in mm or deg; `None` if it jumps, as one without limits does.
pub fn chart(axis: &Axis, word: &str, number: usize, rows: &[TraceRow]) -> Option<AxisChart> {
    let shown = |x: f64| axis.joint.shown(x);
    let curve = |of: &dyn Fn(&TraceRow) -> f64| -> Option<Vec<f64>> {
        rows.iter().map(|row| Some(shown(of(row))).filter(|x| x.abs() < JUMP)).collect()
    };
    Some(AxisChart {
        axis: axis.name.clone(),
        word: word.to_owned(),
        unit: axis.joint.unit().into(),
        time_s: rows.iter().map(|row| row.t).collect(),
        position: curve(&|row| row.at[number])?,
        velocity: curve(&|row| row.velocity[number])?,
        acceleration: curve(&|row| row.acceleration[number])?,
        limits: AxisChartLimits {
            travel: axis.travel.map(|ends| ends.map(shown)),
            velocity: axis.limits.velocity.map(shown),
            acceleration: axis.limits.acceleration.map(shown),
        },
    })
}
