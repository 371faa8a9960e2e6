//! The load along the cutting edge, beside that of one contact height for all rows.

use super::shown_flank::ShownFlank;
use crate::workflow::{MillingBodies, WearResult, histograms};
use report::charts::{ChartError, LineChart, Panel, Series, format_fixed, format_significant, line_chart};
use report::{Block, Figure};

/// A flank with its load, and the load if all rows touched at the height of the first.
type Worn<'a> = (&'a ShownFlank<'a>, &'a WearResult, Vec<f64>);

/// A histogram as the line around its bars.
fn steps(name: &str, bin: f64, load: &[f64]) -> Series {
    let edges = load.iter().enumerate().flat_map(|(k, &y)| [[k as f64 * bin, y], [(k + 1) as f64 * bin, y]]);
    let (x, y) = edges.map(|[x, y]| (x, y)).unzip();
    Series::new(name, x, y)
}

/// Load along the edge, flank by flank; nothing for cutters whose contact is not chosen.
pub(super) fn blocks(bodies: &MillingBodies, flanks: &[ShownFlank<'_>]) -> Result<Vec<Block>, ChartError> {
    let mut worn: Vec<Worn<'_>> = Vec::new();
    for flank in flanks {
        if let (Some(wear), Some([_, fixed])) = (&flank.result.wear, histograms(bodies, flank.plan)) {
            worn.push((flank, wear, fixed.load));
        }
    }
    let Some((_, first, _)) = worn.first() else { return Ok(Vec::new()) };
    let panel = |(flank, wear, fixed): &Worn<'_>| {
        let lines = vec![
            steps("heights of this plan", wear.bin_mm, &wear.load_m_per_mm),
            steps("one height for all rows", wear.bin_mm, fixed),
        ];
        Panel::linear(format!("{}: path per length of edge [m/mm]", flank.name()), 0.0, lines)
    };
    let svg = line_chart(&LineChart {
        title: "Load along the cutting edge".into(),
        x_title: "height above the cutter's tip [mm]".into(),
        panels: worn.iter().map(panel).collect(),
    })?;
    let figures: Vec<String> = worn
        .iter()
        .map(|(flank, wear, _)| {
            let [peak, spread] =
                [format_significant(wear.peak_over_fixed, 3), format_fixed(wear.spread_mm, 1)];
            format!("{}: {peak} times the peak of one height, over {spread} mm of the edge.", flank.name())
        })
        .collect();
    let caption =
        format!("{} Bins of {} mm, one space.", figures.join(" "), format_significant(first.bin_mm, 3));
    Ok(vec![Block::Figure(Figure::new("load-along-the-cutting-edge", svg, caption))])
}
