//! What the worm removes between two dressings, and the worm over its life.

use super::RPM;
use super::result::{WormLifeResult, WormLoadResult, ZoneLoadResult};
use crate::workflow::prepare::{Prepared, RemovalTask};
use foundation::numerics::extremes;
use grinding_technology::{
    Bodies, Cycle, Life, ROUGHING, STATIONS, TechnologyError, WidthUse, WormLife, ZoneLimits,
};

/// A speed that nothing limits, 1/s.
const NO_LIMIT: f64 = 1e9;

pub(super) fn worm_load(cycle: &Cycle, task: &RemovalTask) -> Option<WormLoadResult> {
    let (finishing, width) = (task.loads.finishing?, task.zone_width?);
    let limits = ZoneLimits {
        zone_width: width,
        zone_gap: task.zone_gap,
        allowed_roughing: task.loads.roughing.unwrap_or(finishing),
        allowed_finishing: finishing,
    };
    let level = cycle.level(&limits);
    let by_width = cycle.parts_by_width(width);
    let wear = cycle.wear();
    let by_shift = wear.parts_by_map(by_width, finishing);
    let by_load = level.parts;
    let maps = wear.after(by_shift.max(1));
    let [left, right] = [maps.left.ends(), maps.right.ends()];
    let (from, to) = (left[0].min(right[0]), left[1].max(right[1]));
    let removed = maps.map(|_, map| {
        let most = |bin: i64| (0..STATIONS).map(|station| map.value(station, bin)).fold(0.0, f64::max);
        (from..to).map(most).collect()
    });
    Some(WormLoadResult {
        parts_by_load: by_load,
        parts_by_width: match by_width {
            WidthUse::Parts(parts) => Some(parts),
            WidthUse::Unbounded => None,
        },
        parts_per_dressing: by_shift,
        zones: level.wear_per_part.iter().map(|zone| zone_load(cycle, zone, (&limits, by_load))).collect(),
        from_mm: from as f64,
        removed_mm3_per_mm: removed,
    })
}

/// An area with the width that lasts for so many parts.
fn zone_load(
    cycle: &Cycle,
    (name, per_part): &(String, f64),
    (limits, parts): (&ZoneLimits, f64),
) -> ZoneLoadResult {
    let allowed = if name == ROUGHING { limits.allowed_roughing } else { limits.allowed_finishing };
    let own = cycle.strokes.iter().filter(|figures| figures.stroke.zone == *name);
    ZoneLoadResult {
        zone: name.clone(),
        per_part_mm3: *per_part,
        allowed_mm3_per_mm: allowed,
        used_mm: extremes(own.flat_map(|figures| figures.occupation)),
        balanced_width_mm: parts * per_part / allowed,
    }
}

/// The worm's states between two dressings; how the parts change with the diameter is all that its `parts` tell.
pub(super) fn worm_life(
    bodies: &Bodies,
    (prepared, task): (&Prepared, &RemovalTask),
    [last_tip_diameter, radial_per_dressing]: [f64; 2],
) -> Result<Life, TechnologyError> {
    let tip_radius = bodies.worm_tip_radius;
    WormLife {
        first_tip_diameter: 2.0 * tip_radius,
        last_tip_diameter,
        radial_per_dressing,
        cutting_speed: prepared.technology.cutting_speed(tip_radius),
        largest_worm_speed: task.speeds.worm.unwrap_or(NO_LIMIT),
        largest_work_speed: task.speeds.work.unwrap_or(NO_LIMIT),
        allowed: 1.0,
        zone_width: 1.0,
        section_per_part: 1.0,
    }
    .rows(bodies)
}

pub(super) fn life_of(life: &Life, parts_per_dressing: usize) -> WormLifeResult {
    let (first, last) = match life.rows.as_slice() {
        [first, .., last] => (first, last),
        [only] => (only, only),
        [] => unreachable!("a life has at least its first state"),
    };
    WormLifeResult {
        dressings: life.rows.len(),
        parts_per_worm: life
            .rows
            .iter()
            .map(|row| (parts_per_dressing as f64 * row.parts / first.parts).floor())
            .sum(),
        crossed_axes_angle_deg: [first, last].map(|row| row.crossed_axes_angle.to_degrees()),
        worm_speed_rpm: [first, last].map(|row| RPM * row.worm_speed),
    }
}
