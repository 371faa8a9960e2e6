//! Errors of interpolation and rotation over time, beside their limits.

use super::bands::{chart, panel, stretches};
use crate::workflow::{GearboxResult, RangeUm};
use control::ErrorBin;
use report::charts::{ChartError, Panel, format_significant};
use report::{Block, Figure, Quantity, Table};

/// How far beyond the limits of constant speed a chart reaches, as a share of their distance.
const BEYOND: f64 = 0.25;

pub(super) fn blocks(result: &GearboxResult, bins: &[ErrorBin]) -> Result<Vec<Block>, ChartError> {
    let panels = panels(result, bins);
    if panels.is_empty() {
        let text = "A train of pulses has no true position of the slide to compare with: counters only.";
        return Ok(vec![Block::Paragraph(text.into())]);
    }
    let svg = chart("Errors of interpolation and rotation", panels)?;
    let caption = "Least and greatest error in each stretch of time. The constant lag of the running sense is taken off. Limits hold at \
                   every instant; the first panel shows starts, stops and reversals, the second is cut off outside the limits of constant speed.";
    Ok(vec![
        Block::Figure(Figure::new("errors-of-interpolation-and-rotation", svg, caption)),
        Block::Table(Table::of_quantities("", &quantities(result))),
    ])
}

/// Nothing without a motion.
fn panels(result: &GearboxResult, bins: &[ErrorBin]) -> Vec<Panel> {
    let (Some(along), false) = (&result.along_feed, bins.is_empty()) else { return Vec::new() };
    let ends = |range: RangeUm| [range.least_um, range.greatest_um];
    let axial = stretches(bins, 1e3, |bin| (bin.time, bin.axial));
    let rotation = stretches(bins, result.coupling.flank_um_per_rad, |bin| (bin.time, bin.angle));
    let mut panels = vec![panel("along the feed [µm]", &axial, along.bound.map(ends), None)];
    panels.extend(along.steady_bound.map(ends).map(|limits| {
        let room = BEYOND * (limits[1] - limits[0]);
        let title = "along the feed, limits of constant speed [µm]";
        panel(title, &axial, Some(limits), Some([limits[0] - room, limits[1] + room]))
    }));
    let limits = result.angle.and_then(|angle| angle.bound).map(ends);
    panels.push(panel("rotation at the flank, normal [µm]", &rotation, limits, None));
    panels
}

fn quantities(result: &GearboxResult) -> Vec<Quantity> {
    let mut list = Vec::new();
    let range = |list: &mut Vec<Quantity>, name: &str, range: Option<RangeUm>| {
        if let Some(RangeUm { least_um, greatest_um }) = range {
            let text =
                format!("{} … {}", format_significant(least_um, 5), format_significant(greatest_um, 5));
            let mut quantity = Quantity::text(name, text);
            quantity.unit = "µm".into();
            list.push(quantity);
        }
    };
    if let Some(along) = &result.along_feed {
        range(&mut list, "along the feed, whole motion", along.whole);
        range(&mut list, "limits of it", along.bound);
        range(&mut list, "along the feed, constant speed", along.steady);
        range(&mut list, "limits of it", along.steady_bound);
        for (name, value) in [
            ("mean upwards", along.mean_up_um),
            ("mean downwards", along.mean_down_um),
            ("difference of the senses along the feed", along.direction_offset_um),
            ("difference of the senses at the flank", along.direction_offset_flank_um),
        ] {
            list.extend(value.map(|um| Quantity::number(name, "", um, "µm")));
        }
    }
    if let Some(angle) = &result.angle {
        range(&mut list, "rotation at the flank, whole motion", Some(angle.flank));
        range(&mut list, "limits of it", angle.bound);
    }
    list
}
