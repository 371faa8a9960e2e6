//! The transmission error over the roll of the gear.

use super::shown::ShownContact;
use contact::RollCourse;
use report::Figure;
use report::charts::{ChartError, LineChart, Panel, Series, line_chart};

/// Mesh periods in the chart, and points between two roll positions: the corner where a pair hands over lies between them.
const PERIODS: usize = 3;
const BETWEEN: usize = 4;

/// Turn of the mate against an even one, as a way at its mean pitch radius, flank by flank.
pub(super) fn figure(flanks: &[ShownContact<'_>], radius_mm: f64) -> Result<Figure, ChartError> {
    let panel = |flank: &ShownContact<'_>| {
        let [found, said] = &flank.rolled.courses;
        let rolls = rolls(found);
        let roll_deg: Vec<f64> = rolls.iter().map(|roll| roll.to_degrees()).collect();
        let line = |name: &str, course: &RollCourse| {
            let lag_um = rolls.iter().map(|roll| -1e3 * radius_mm * course.at(*roll));
            Series::new(name, roll_deg.clone(), lag_um.collect())
        };
        let mut lines = vec![line("rolled", found), line("by the ease-offs", said)];
        lines.extend(flank.rolled.milled.as_ref().map(|milled| line("as milled", &milled.course)));
        Panel::linear(format!("{}: transmission error [µm]", flank.name()), 1e-3, lines)
    };
    let svg = line_chart(&LineChart {
        title: "Transmission error at the mean pitch circle of the mate".into(),
        x_title: "roll of the gear [deg]".into(),
        panels: flanks.iter().map(panel).collect(),
    })?;
    let caption = "Unloaded pair over three mesh periods; < 0: the mate lags behind an even turn.";
    Ok(Figure::new("transmission-error-at-the-mean-pitch-circle-of-the-mate", svg, caption))
}

/// Roll of the gear over the periods, rad.
fn rolls(course: &RollCourse) -> Vec<f64> {
    let pitch = course.step() * course.per_pitch() as f64;
    let per_pitch = BETWEEN * course.per_pitch();
    let count = PERIODS * per_pitch + 1;
    (0..count).map(|k| (k as f64 / per_pitch as f64 - 0.5 * PERIODS as f64) * pitch).collect()
}
