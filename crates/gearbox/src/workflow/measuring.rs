//! What errors of scale, ball screw and encoder come to at the flank, part by part.

use super::prepare::{Chain, Driven, Measured};
use super::result::{EncoderResult, MeasuringPart, MeasuringResult, RangeUm};
use control::{Extremes, LineErrors};

fn largest(range: Extremes) -> f64 {
    range.greatest.max(-range.least)
}

/// The table of a job; `None` without errors.
pub(super) fn measuring(measured: &Measured, chain: &Chain, driven: &Driven) -> Option<MeasuringResult> {
    if measured.line_parts.is_empty() && measured.encoder.is_none() {
        return None;
    }
    let gear = &chain.gear;
    let share = gear.flank_per_axial();
    let mut parts = Vec::new();
    if let Some(motion) = &driven.motion {
        let over = |lines: &LineErrors| motion.clone().with_line_errors(lines.clone()).line_limits();
        for part in &measured.line_parts {
            let along_feed_um = 1e3 * largest(over(&part.lines));
            parts.push(MeasuringPart {
                name: part.name,
                along_feed_um: Some(along_feed_um),
                flank_um: along_feed_um * share,
            });
        }
        let uneven_um = 1e3 * measured.lines.unevenness(chain.interpolation.pitch);
        if uneven_um > 0.0 {
            parts.push(MeasuringPart {
                name: "uneven lines between pulses",
                along_feed_um: Some(uneven_um),
                flank_um: uneven_um * share,
            });
        }
    }
    for part in &measured.encoder_parts {
        let flank_um = part.errors.amplitude() * gear.flank_per_angle();
        parts.push(MeasuringPart { name: part.name, along_feed_um: None, flank_um });
    }
    let encoder = measured.encoder.as_ref().map(|errors| {
        let teeth = errors.of_teeth(gear.teeth().unsigned_abs());
        let um = gear.flank_per_angle();
        EncoderResult {
            greatest_um: errors.amplitude() * um,
            teeth: RangeUm { least_um: teeth.index.least * um, greatest_um: teeth.index.greatest * um },
            single_pitch_um: teeth.single * um,
            cumulative_pitch_um: teeth.index.range() * um,
        }
    });
    Some(MeasuringResult { sum_flank_um: parts.iter().map(|part| part.flank_um).sum(), parts, encoder })
}
