//! Where the flank of a bevel gear has to begin for its mate: where the tip of the mate engages
//! (`docs/mathematics/milling.md#contact-with-the-mate`).
//!
//! On the sphere both gears touch on a great circle that touches both base cones, at the arc xi from the point of the own base cone and
//! at the rest of xi_p1 + xi_p2 from that of the mate's. A point at xi has the polar angle theta with cos theta = cos delta_b cos xi.

use super::mate_result::MateStartResult;
use foundation::geometry::BevelGear;
use verdict::Remark;

/// Angles that count as the same, rad: rounding.
pub(super) const SAME: f64 = 1e-9;

/// Polar angle of a gear's flank at which the tip of its mate engages, rad; `None` where that would be inside of the base cone.
pub fn needed_polar_angle(gear: &BevelGear, mate: &BevelGear) -> Option<f64> {
    let [_, tip] = mate.heights();
    let arc = gear.pitch_roll() + mate.pitch_roll() - tip * mate.base_angle().sin();
    (arc >= 0.0).then(|| (gear.base_angle().cos() * arc.cos()).acos())
}

/// Where the flank begins and where the mate needs it to, with a remark where it does not reach so far.
pub(super) fn start_of_flank(gear: &BevelGear, mate: &BevelGear) -> (MateStartResult, Option<Remark>) {
    let needed = needed_polar_angle(gear, mate);
    let active = gear.form_angle();
    let result = MateStartResult {
        active_deg: Some(active.to_degrees()),
        needed_deg: needed.map(f64::to_degrees),
        active_diameter_mm: None,
        needed_diameter_mm: None,
        covered: needed.is_some_and(|needed| active <= needed + SAME),
    };
    let remark = match needed {
        _ if result.covered => return (result, None),
        Some(needed) => Remark {
            code: "mate-needs-more-flank",
            text: format!(
                "the tip of the mate engages down to a polar angle of {:.4} degrees, the active flank begins at {:.4}: what is \
                 between them is not milled as a flank and not judged",
                needed.to_degrees(),
                active.to_degrees()
            ),
            way_out: "leave `bevel.start_polar_angle_deg` out, or relieve the tip of the mate".into(),
        },
        None => Remark {
            code: "mate-needs-more-flank",
            text: format!(
                "the tip of the mate reaches below the base cone at {:.4} degrees, where there is no involute: it meets the root",
                gear.base_angle().to_degrees()
            ),
            way_out: "give the mate a smaller addendum, or more teeth to this gear".into(),
        },
    };
    (result, Some(remark))
}
