//! How a clearing cutter is engaged: depth of the layers, and across the feed how far each pass lies beside those of its layer that went
//! before (`docs/mathematics/milling.md#root-and-clearance`).

use super::prepare::ToolData;
use super::result::EngagementResult;
use crate::{CutterPath, RoughingLayer};
use foundation::numerics::extremes;

/// Of layers from the top down by a cutter of this diameter; `None` for fewer than two layers, of which no depth is known.
pub(super) fn engagement(
    layers: &[RoughingLayer],
    diameter: f64,
    tool: &ToolData,
) -> Option<EngagementResult> {
    let depths = layers.windows(2).map(|pair| pair[0].height - pair[1].height).filter(|depth| *depth > 0.0);
    let [_, depth] = extremes(depths);
    if !depth.is_finite() {
        return None;
    }
    let (mut slots, mut width) = (0, 0.0f64);
    for layer in layers {
        for (number, pass) in layer.passes.iter().enumerate() {
            let beside = greatest_width(pass, &layer.passes[..number], diameter);
            if beside < diameter {
                width = width.max(beside);
            } else {
                slots += 1;
            }
        }
    }
    let feed_per_tooth = tool.edges.map(|edges| tool.feed / (tool.spindle_rpm * f64::from(edges)));
    // Of cylindrical edges: cos(arc) = 1 - 2 width/diameter; the chip is thickest where the arc ends, or at a right angle to the feed.
    let arc = (1.0 - 2.0 * width / diameter).acos();
    let thickest = if arc < std::f64::consts::FRAC_PI_2 { arc.sin() } else { 1.0 };
    let removal = |width: f64| 1e-3 * width * depth * tool.feed;
    Some(EngagementResult {
        layers: layers.len(),
        depth_mm: depth,
        full_width_passes: slots,
        width_mm: width,
        arc_deg: arc.to_degrees(),
        chip_thickness_mm: feed_per_tooth.map(|feed| feed * thickest),
        removal_cm3_per_min: removal(width),
        full_width_removal_cm3_per_min: removal(diameter),
    })
}

/// The greatest distance of a pass's places from the passes before it, the diameter where none is that near.
fn greatest_width(pass: &CutterPath, before: &[CutterPath], diameter: f64) -> f64 {
    let nearest = |place: &crate::CutterPlace| {
        let all = before.iter().flat_map(|pass| &pass.places);
        all.map(|other| (other.tip - place.tip).norm()).fold(diameter, f64::min)
    };
    pass.places.iter().map(nearest).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::CutterPlace;
    use crate::job::CutterCoolant;
    use nalgebra::Vector3;

    #[test]
    fn a_slot_and_passes_beside_it() {
        let pass = |aside: f64, height: f64| CutterPath {
            places: (0..5)
                .map(|k| CutterPlace {
                    tip: Vector3::new(aside, f64::from(k), height),
                    axis: Vector3::z(),
                    contact: None,
                })
                .collect(),
        };
        let layer = |height: f64| RoughingLayer {
            height,
            passes: vec![pass(0.0, height), pass(1.5, height), pass(2.5, height)],
        };
        let tool = ToolData {
            number: 3,
            length_offset: None,
            edges: Some(4),
            length: 0.0,
            spindle_rpm: 3000.0,
            feed: 1200.0,
            plunge_feed: 400.0,
            coolant: CutterCoolant::Off,
        };
        let found = engagement(&[layer(6.0), layer(4.0), layer(2.0)], 6.0, &tool).unwrap();
        assert_eq!((found.layers, found.full_width_passes), (3, 3));
        assert!((found.depth_mm - 2.0).abs() < 1e-12 && (found.width_mm - 1.5).abs() < 1e-12);
        // A quarter of the diameter: 60 degrees.
        assert!((found.arc_deg - 60.0).abs() < 1e-9);
        assert!((found.chip_thickness_mm.unwrap() - 0.1 * 60f64.to_radians().sin()).abs() < 1e-12);
        assert!((found.removal_cm3_per_min - 3.6).abs() < 1e-12);
        assert!((found.full_width_removal_cm3_per_min - 14.4).abs() < 1e-12);
        assert!(engagement(&[layer(6.0)], 6.0, &tool).is_none());
    }
}
