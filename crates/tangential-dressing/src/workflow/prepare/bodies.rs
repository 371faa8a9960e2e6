//! Gear, worm and dresser of a job of tangential dressing, each finding on the key of the drawing that it concerns.

use crate::job::{DresserProfile, OffsetRule, ShiftRule, TangentialJob};
use crate::{ProfileKind, ShiftOffset, ShiftRatio, TangentialInput, TangentialModel, job as drawn};
use foundation::geometry::{Blank, WormChoice, worm_for_gear};
use run::{RunFailure, blank_of_job, gear_of_job, geometry_finding};

/// The bodies.
pub(super) struct Bodies {
    /// How they stand.
    pub model: TangentialModel,
    /// Diameters and face width of the gear.
    pub blank: Blank,
    /// Tip radius of the worm, mm.
    pub worm_tip_radius: f64,
}

impl Bodies {
    /// Of a job.
    ///
    /// # Errors
    /// [`RunFailure`] with a finding on the key concerned.
    pub fn of_job(job: &TangentialJob) -> Result<Self, RunFailure> {
        let gear = gear_of_job(&job.gear).map_err(RunFailure::bad_input)?;
        let blank = blank_of_job(&job.gear);
        blank.check(&gear).map_err(|e| RunFailure::bad_input(geometry_finding(&e, "gear")))?;
        let choice = WormChoice {
            threads: i32::try_from(job.worm.threads).unwrap_or(i32::MAX),
            hand: job.worm_hand().sign(),
            pitch_diameter: job.worm.pitch_diameter,
            tip_diameter: job.worm.tip_diameter,
            pressure_angle: None,
            profile_shift: 0.0,
            cone_angle: 0.0,
        };
        let made =
            worm_for_gear(&gear, &choice).map_err(|e| RunFailure::bad_input(geometry_finding(&e, "worm")))?;
        let range = job.gear.evaluation_range();
        let module = gear.data().normal_module;
        let tip_radius = 0.5 * job.dresser.tip_diameter;
        let dresser_pitch_radius = match job.dresser.pitch_diameter {
            Some(diameter) => 0.5 * diameter,
            // The tip of the dresser makes the worm's root, which leaves the clearance to the gear's tip
            // (`docs/mathematics/involute-gears.md#the-worm-as-a-helical-gear`).
            None => {
                let clearance = job.dresser.root_clearance.unwrap_or(0.25 * module);
                let distance =
                    made.worm.pitch_radius() + gear.pitch_radius() + gear.data().profile_shift * module;
                let root_radius = distance - 0.5 * blank.tip_diameter - clearance;
                tip_radius + root_radius - made.worm.pitch_radius()
            }
        };
        let shift_ratio = match job.grinding.shift_ratio {
            drawn::ShiftRatio::Number(ratio) => ShiftRatio::Given(ratio),
            drawn::ShiftRatio::Rule(ShiftRule::Width) => ShiftRatio::Width,
            drawn::ShiftRatio::Rule(ShiftRule::Neutral) => ShiftRatio::Neutral,
        };
        let input = TangentialInput {
            gear,
            worm: made.worm,
            worm_tip_radius: Some(made.tip_radius),
            dresser_pitch_radius,
            dresser_tip_radius: Some(tip_radius),
            profile: match job.dresser.profile {
                DresserProfile::Conjugate => ProfileKind::Conjugate,
                DresserProfile::Straight => ProfileKind::Straight,
            },
            radii: [0.5 * range.start_diameter, 0.5 * range.end_diameter],
            faces: [range.z_start, range.z_end],
            face_width: job.gear.face_width,
            shift_width: job.shift_width().unwrap_or(job.gear.face_width),
            shift_ratio,
            shift_offset: match job.grinding.shift_offset {
                drawn::ShiftOffset::Number(offset) => ShiftOffset::Given(offset),
                drawn::ShiftOffset::Rule(OffsetRule::Contact) => ShiftOffset::Contact,
            },
        };
        let mut model = TangentialModel::new(input).map_err(|e| RunFailure::from(&e))?;
        if job.shift_width().is_none() {
            // The neutral ratio is known only now; the scale along the worm is what it shifts over the face width.
            let shift_width = model.shift_ratio.abs() * job.gear.face_width;
            model = TangentialModel::new(TangentialInput { shift_width, ..input })
                .map_err(|e| RunFailure::from(&e))?;
        }
        Ok(Self { model, blank, worm_tip_radius: made.tip_radius })
    }
}
