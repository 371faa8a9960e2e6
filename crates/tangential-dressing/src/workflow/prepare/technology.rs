//! Speeds and clamping of a run of tangential dressing.

use foundation::geometry::{Blank, GearData};
use generating_grinding::workflow::programs::Technology;
use generating_grinding::workflow::programs::cylinders::Cylinders;
use job::tables::Machine as JobMachine;

/// As the job says of its machine, for a worm of this geometry, tip radius and width (mm).
pub(super) fn technology(
    machine: &JobMachine,
    (worm, tip_radius, width): (&GearData, f64, Option<f64>),
    blank: &Blank,
    feed_per_revolution: Option<f64>,
) -> Technology {
    let hand = if worm.helix_angle < 0.0 { -1.0 } else { 1.0 };
    let cylinders = Cylinders {
        worm_radius: tip_radius,
        worm_half_width: width.map(|width| 0.5 * width),
        radius: 0.5 * blank.tip_diameter,
        half_width: 0.5 * blank.face_width,
    };
    let sizes = (hand, tip_radius, worm.normal_module, width);
    Technology { cylinders: Some(cylinders), ..Technology::new(machine, sizes, feed_per_revolution) }
}
