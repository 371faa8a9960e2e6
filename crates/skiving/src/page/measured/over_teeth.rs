//! All tracks over the tooth number.

use super::shown_teeth::ShownTeeth;
use super::worst_teeth::WorstTooth;
use foundation::geometry::Flank;
use report::cells::flank_title;
use report::charts::{ChartError, LineChart, LineFrame, Panel, Series, Svg, line_chart_in};

/// Height of a panel with one line for every track.
const TALL: f64 = 170.0;
/// Smallest span of an ordinate, um.
const LEAST_UM: f64 = 1.0;

/// Both flanks below each other; with the teeth to look at their rings and the band are drawn.
pub(super) fn over_teeth(
    title: &str,
    teeth: &ShownTeeth<'_>,
    value: impl Fn(Flank, usize, usize) -> f64,
    worst: Option<&[WorstTooth]>,
) -> Result<Svg, ChartError> {
    let count = teeth.bodies.teeth();
    let panel = |flank: Flank| {
        let line = |track: usize| {
            let x = (0..count).map(|tooth| tooth as f64).collect();
            let y = (0..count).map(|tooth| value(flank, track, tooth)).collect();
            Series::new(format!("track {}", track + 1), x, y)
        };
        let mut series: Vec<Series> = (0..teeth.tracks(flank)).map(line).collect();
        if let Some(worst) = worst {
            let last = count.saturating_sub(1) as f64;
            let limit = |y: f64| Series::limit("± D/2", vec![0.0, last], vec![y; 2]);
            series.extend([limit(0.5 * teeth.band_um), limit(-0.5 * teeth.band_um)]);
            let ring = |worst: &WorstTooth| {
                let (of, track, _) = worst.edge.filter(|(of, ..)| *of == flank)?;
                let at = [worst.tooth as f64, value(of, track, worst.tooth)];
                Some((at, format!("tooth {}", worst.tooth)))
            };
            let rings: Vec<([f64; 2], String)> = worst.iter().filter_map(ring).collect();
            if !rings.is_empty() {
                series.push(Series::rings("tooth to look at", rings));
            }
        }
        Panel::linear(format!("{}: deviation [µm]", flank_title(flank)), LEAST_UM, series)
    };
    let chart = LineChart {
        title: title.into(),
        x_title: "tooth".into(),
        panels: Flank::BOTH.map(panel).into_iter().collect(),
    };
    line_chart_in(&chart, &LineFrame { panel_height: Some(TALL), beside: 0.6 })
}
