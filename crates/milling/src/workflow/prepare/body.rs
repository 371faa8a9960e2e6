//! What gears, bevel gears and blades have in common before their space is planned.

use crate::{Land, LeadCurve, Retraction, SkewPlanes, Space, SpaceFlank};
use foundation::geometry::{Frustum, Modified, NormalOffset, OffsetBase, Surface};
use std::f64::consts::TAU;
use std::sync::Arc;
use verdict::Remark;

/// What the cutter stays away from the workpiece while it is moved from one path to another, mm.
pub(super) const CLEARANCE: f64 = 2.0;

/// A body with its flanks.
pub(super) struct Body {
    /// The space, or its halves.
    pub parts: Vec<Space>,
    pub spaces: usize,
    pub retraction: Retraction,
    pub blank: [[f64; 2]; 4],
    pub floor: Frustum,
    /// What is not known of it.
    pub unknown: Vec<Remark>,
}

/// A body between teeth from its radii and positions at both ends, its material towards the axis (+1) or outside (-1).
pub(super) fn floor(ends: [[f64; 2]; 2], outward: f64) -> Frustum {
    let [radii, positions] = [0, 1].map(|k| [ends[0][k], ends[1][k]]);
    Frustum { radii, positions, turns: [0.0; 2], outward }
}

/// A surface with or without an offset.
pub(super) fn with_offset<S: OffsetBase + 'static>(
    base: S,
    offset: Option<Arc<dyn NormalOffset>>,
) -> Arc<dyn Surface> {
    match offset {
        Some(offset) => Arc::new(Modified::new(base, offset)),
        None => Arc::new(base),
    }
}

/// Lets each of two halves, that at the ascending end of the teeth first, know the flanks and tops of the other.
pub(super) fn join_halves(parts: &mut [Space]) {
    let [upper, lower] = parts else { return };
    upper.other_half.clone_from(&lower.flanks);
    lower.other_half.clone_from(&upper.flanks);
    let own = upper.lands.clone();
    upper.lands.extend(&lower.lands);
    lower.lands.extend(own);
}

/// A space with its column planes turned about the normal of the base body, degrees.
pub(super) fn part(
    skew_deg: f64,
    flanks: Vec<SpaceFlank>,
    lead: Arc<dyn LeadCurve>,
    spaces: usize,
    lands: Vec<Land>,
) -> Space {
    let lead = if skew_deg == 0.0 {
        lead
    } else {
        Arc::new(SkewPlanes { curve: lead, angle: skew_deg.to_radians() })
    };
    Space { flanks, lead, pitch: TAU / spaces as f64, lands, other_half: Vec::new(), walls: Vec::new() }
}
