//! Speeds and clamping of a run of tangential dressing.

use super::prepare::TangentialPrepared;
use crate::job::TangentialJob;
use generating_grinding::workflow::programs::Technology;
use generating_grinding::workflow::programs::cylinders::Cylinders;
use job::tables::Machine as JobMachine;

/// As the job says, for the worm of a run of tangential dressing.
pub fn technology(machine: &JobMachine, ready: &TangentialPrepared, job: &TangentialJob) -> Technology {
    let worm = ready.model.pair.worm.data();
    let hand = if worm.helix_angle < 0.0 { -1.0 } else { 1.0 };
    let sizes = (hand, ready.worm_tip_radius, worm.normal_module, job.worm.width);
    let cylinders = Cylinders {
        worm_radius: ready.worm_tip_radius,
        worm_half_width: job.worm.width.map(|width| 0.5 * width),
        radius: 0.5 * ready.blank.tip_diameter,
        half_width: 0.5 * ready.blank.face_width,
    };
    Technology {
        cylinders: Some(cylinders),
        ..Technology::new(machine, sizes, job.grinding.feed_per_revolution)
    }
}
