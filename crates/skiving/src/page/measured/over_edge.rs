//! Mean and range of the teeth over the edge, with the compensation curve and its band.

use super::shown_teeth::ShownTeeth;
use foundation::geometry::Flank;
use report::cells::flank_title;
use report::charts::{ChartError, LineChart, LineFrame, Panel, Series, Svg, line_chart_in};

/// Smallest span of an ordinate, um.
const LEAST_UM: f64 = 1.0;

/// Both flanks below each other.
pub(super) fn chart(teeth: &ShownTeeth<'_>) -> Result<Svg, ChartError> {
    let count = teeth.bodies.teeth();
    let panel = |flank: Flank| {
        let tracks = 0..teeth.tracks(flank);
        let x: Vec<f64> = tracks.clone().map(|track| teeth.place(flank, track)).collect();
        let line = |of: &dyn Fn(usize) -> f64| tracks.clone().map(of).collect::<Vec<f64>>();
        let remaining = |track: usize| (0..count).map(move |tooth| teeth.remaining_um(flank, track, tooth));
        let mean = |track: usize| remaining(track).sum::<f64>() / count as f64;
        let extreme = |sign: f64| {
            move |track: usize| sign * remaining(track).map(|um| sign * um).fold(f64::NEG_INFINITY, f64::max)
        };
        let curve = |track: usize| teeth.curve_um(flank, track);
        let all = vec![true; x.len()];
        let limit =
            |by: f64| Series::limit("± D/2", x.clone(), line(&|track| curve(track) + by * teeth.band_um));
        let series = vec![
            Series::new("mean of all teeth", x.clone(), line(&mean)).marked(all),
            Series::new("compensation curve", x.clone(), line(&curve)),
            Series::new("greatest", x.clone(), line(&extreme(1.0))),
            Series::new("least", x.clone(), line(&extreme(-1.0))),
            limit(0.5),
            limit(-0.5),
        ];
        Panel::linear(format!("{}: deviation [µm]", flank_title(flank)), LEAST_UM, series)
    };
    let chart = LineChart {
        title: "Shape of the edge".into(),
        x_title: "place x along the edge".into(),
        panels: Flank::BOTH.map(panel).into_iter().collect(),
    };
    line_chart_in(&chart, &LineFrame { panel_height: None, beside: 0.05 })
}
