//! The profile that the measured tool will leave on the workpiece.

use crate::workflow::{SkivedFlankResult, SkivingResult};
use foundation::geometry::Flank;
use report::cells::flank_title;
use report::charts::{ChartError, LineChart, LineFrame, Panel, Series, line_chart_in};
use report::{Block, Figure};

const TALL: f64 = 170.0;
const LEAST_UM: f64 = 0.5;

/// Profiles of both flanks as deviations from the target.
pub(super) fn blocks(result: &SkivingResult) -> Result<Vec<Block>, ChartError> {
    let panel = |flank: Flank| {
        let title = format!("{}: f_n [µm]", flank_title(flank));
        let lines = series(&result.flanks[flank.name()], result.measurement.is_some(), result.tolerance_um);
        Panel::linear(title, LEAST_UM, lines)
    };
    let chart = LineChart {
        title: "Profile of the workpiece to come".into(),
        x_title: "length of roll w [mm]".into(),
        panels: Flank::BOTH.map(panel).into_iter().collect(),
    };
    let svg = line_chart_in(&chart, &LineFrame { panel_height: Some(TALL), beside: 0.0 })?;
    let caption = "Deviation normal to the flank, positive is material left. Least and greatest: over the single \
                   teeth of the tool.";
    Ok(vec![Block::Figure(Figure::new("profile-of-the-workpiece-to-come", svg, caption))])
}

/// Prediction, simulation and tolerance; of a measured tool its correction and its single teeth as well.
fn series(flank: &SkivedFlankResult, measured: bool, tolerance_um: f64) -> Vec<Series> {
    let target: Vec<f64> = flank.target_um.iter().flatten().copied().collect();
    let beyond = |values: &mut dyn Iterator<Item = f64>| -> Vec<f64> {
        values.zip(&target).map(|(value, target)| value - target).collect()
    };
    let line = |name: &str, values: Vec<f64>| Series::new(name, flank.w_mm.clone(), values);
    let mut series =
        vec![line("mean tooth, predicted", beyond(&mut flank.planned_um.iter().flatten().copied()))];
    if measured {
        let end = |k: usize| beyond(&mut flank.teeth_um.iter().map(|ends| ends[k]));
        series.push(line("after the correction", beyond(&mut flank.corrected_um.iter().copied())));
        series.push(line("least tooth", end(0)));
        series.push(line("greatest tooth", end(1)));
    }
    let simulated = beyond(&mut flank.simulated_um.iter().flatten().copied());
    if !simulated.is_empty() {
        series.push(Series::points("mean tooth, simulated", flank.w_mm.clone(), simulated));
    }
    if let (Some(from), Some(to)) = (flank.w_mm.first(), flank.w_mm.last()) {
        let limits = [-tolerance_um, tolerance_um];
        series.extend(limits.map(|um| Series::limit("tolerance", vec![*from, *to], vec![um; 2])));
    }
    series
}
