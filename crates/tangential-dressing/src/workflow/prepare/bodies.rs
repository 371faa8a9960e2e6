//! Gear, worm and dresser of a job of tangential dressing, each finding on the key of the drawing that it concerns.

use super::targets::evaluation_field;
use crate::job::{DresserProfile, LoadedTangentialJob, OffsetRule, ShiftRule, TangentialJob};
use crate::workflow::finding::on_field;
use crate::{
    CarriedProfile, ExistingDresser, ProfileKind, ShiftOffset, ShiftRatio, TangentialInput, TangentialModel,
    job as drawn,
};
use foundation::geometry::{Blank, Gear, Sides, WormChoice, worm_for_gear};
use generating_grinding::workflow::prepare::{check_designed_worm, designed_worm, dresser_profile};
use job::Diagnostic;
use run::{RunFailure, blank_of_job, gear_of_job, geometry_finding};
use std::sync::Arc;

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
    pub fn of_job(loaded: &LoadedTangentialJob) -> Result<Self, RunFailure> {
        let job = &loaded.job;
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
            None => pitch_radius_by_root(job, gear.pitch_radius() + gear.data().profile_shift * module),
        };
        let shift_ratio = match job.grinding.shift_ratio {
            drawn::ShiftRatio::Number(ratio) => ShiftRatio::Given(ratio),
            drawn::ShiftRatio::Rule(ShiftRule::Width) => ShiftRatio::Width,
            drawn::ShiftRatio::Rule(ShiftRule::Neutral) => {
                ShiftRatio::Neutral(Sides::from_fn(|flank| job.grinding.flanks.includes(flank)))
            }
        };
        let input = TangentialInput {
            gear,
            worm: made.worm,
            worm_tip_radius: Some(made.tip_radius),
            dresser_pitch_radius,
            dresser_tip_radius: Some(tip_radius),
            dresser_depth: job.dresser.flank_depth,
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
        if job.dresser.exists() {
            let dresser = existing_dresser(loaded, &model, &gear)?;
            model = model.with_dresser(&dresser).map_err(|e| on_field(&e, "dresser.modification"))?;
        }
        Ok(Self { model, blank, worm_tip_radius: made.tip_radius })
    }
}

/// Pitch radius of a dresser whose tip makes the root of a worm, which leaves the clearance to the gear's tip; `depth` is the radius on the
/// gear that meets the worm's pitch circle. mm.
fn pitch_radius_by_root(job: &TangentialJob, depth: f64) -> f64 {
    let clearance = job.dresser.root_clearance.unwrap_or(0.25 * job.gear.normal_module);
    0.5 * job.dresser.tip_diameter - (0.5 * job.gear.tip_diameter - depth) - clearance
}

/// The dresser that the job says is there, on the worm that it was made for.
fn existing_dresser(
    loaded: &LoadedTangentialJob,
    model: &TangentialModel,
    gear: &Gear,
) -> Result<ExistingDresser, RunFailure> {
    const FIELD: &str = "dresser.designed_for";
    let job = &loaded.job;
    let made_for = match &job.dresser.designed_for {
        None => model.clone(),
        Some(there) => {
            let of_job = (&job.gear, job.worm_hand());
            check_designed_worm(gear, of_job, there).map_err(RunFailure::bad_input)?;
            let made = worm_for_gear(gear, &designed_worm(of_job.0, of_job.1, there))
                .map_err(|e| RunFailure::bad_input(geometry_finding(&e, FIELD)))?;
            let on_worm = |dresser_pitch_radius: f64| {
                TangentialModel::new(TangentialInput {
                    worm: made.worm,
                    dresser_pitch_radius,
                    ..*model.input()
                })
                .map_err(|e| on_field(&e, FIELD))
            };
            let there = on_worm(model.input().dresser_pitch_radius)?;
            if job.dresser.pitch_diameter.is_some()
                || made.worm.data().pressure_angle == gear.data().pressure_angle
            {
                there
            } else {
                // On another rack the worm's pitch circle lies at another depth of the gear.
                let depth = there.pair.chain.centre_distance - made.worm.pitch_radius();
                on_worm(pitch_radius_by_root(job, depth))?
            }
        }
    };
    let specs = job.dresser.modification.given().unwrap_or_default();
    let carried = Sides::try_from_fn(|flank| -> Result<Option<CarriedProfile>, Diagnostic> {
        if specs.is_empty() {
            return Ok(None);
        }
        let field = evaluation_field(model, flank, "dresser.modification")?;
        let of_job = ("dresser.modification", "the motions");
        let profile = dresser_profile(loaded, specs, flank, &field, of_job)?;
        let (normal, z) = (field.normal_factor(), 0.5 * (model.input().faces[0] + model.input().faces[1]));
        Ok(Some(Arc::new(move |w| profile.value(w, z).ok().map(|f| f * normal))))
    })
    .map_err(RunFailure::bad_input)?;
    Ok(ExistingDresser { made_for, carried })
}
