//! From a checked job of tangential dressing to bodies, targets and passes. Every finding names the job's key.

use super::finding;
use crate::job::{
    DeviationMeasure, DresserProfile, FitWeights, LoadedTangentialJob, OffsetRule, Passes, ShiftRule,
    TangentialJob,
};
use crate::{
    Channel, EdgeAmounts, ProfileKind, ShiftOffset, ShiftRatio, TangentialError, TangentialInput,
    TangentialModel, Variable, Weights, job as drawn,
};
use contact::Measure;
use foundation::geometry::{Blank, Flank, Sides, WormChoice, worm_for_gear};
use foundation::modification::{EvaluationField, Modification};
use job::Diagnostic;
use run::{RunFailure, blank_of_job, gear_of_job, geometry_finding, specs_of_flank};

/// A job made ready for planning.
pub struct TangentialPrepared {
    /// The bodies.
    pub model: TangentialModel,
    /// Diameters and face width of the gear.
    pub blank: Blank,
    /// Tip radius of the worm, mm.
    pub worm_tip_radius: f64,
    /// What is wanted of the flanks that are ground.
    pub wanted: Sides<Option<WantedFlank>>,
    /// Flanks that are ground together, pass by pass.
    pub passes: Vec<Vec<Flank>>,
}

/// What is wanted of a flank.
pub enum WantedFlank {
    /// Amounts at the edge of the evaluated range, normal.
    Edge(EdgeAmounts),
    /// Modifications, transverse.
    Modifications(Box<Modification>),
}

impl WantedFlank {
    /// Material left, normal, mm; NaN where the modification has no value.
    pub fn value(&self, model: &TangentialModel, flank: Flank, w: f64, z: f64) -> f64 {
        match self {
            Self::Edge(amounts) => amounts.value(model, flank, w, z),
            Self::Modifications(modification) => {
                let normal = modification.field().normal_factor();
                modification.value(w, z).map_or(f64::NAN, |f| f * normal)
            }
        }
    }
}

impl TangentialPrepared {
    /// Material left that is wanted, normal, mm; 0 on a flank that is not ground.
    pub fn wanted(&self, flank: Flank, w: f64, z: f64) -> f64 {
        self.wanted[flank].as_ref().map_or(0.0, |wanted| wanted.value(&self.model, flank, w, z))
    }
}

/// How the job measures deviations.
pub fn measure_of(job: &TangentialJob) -> Measure {
    match job.dressing.measure {
        DeviationMeasure::Ray => Measure::Ray,
        DeviationMeasure::Arc => Measure::Arc,
    }
}

/// How the job weighs the points of the fit.
pub fn weights_of(job: &TangentialJob) -> Weights {
    match job.dressing.weights {
        FitWeights::Uniform => Weights::Uniform,
        FitWeights::Source => Weights::Source,
    }
}

/// The channel of the process with the name of the one in the job.
///
/// # Errors
/// A finding on `field` if the process knows no such channel.
pub fn channel_of(channel: drawn::Channel, field: &str) -> Result<Channel, RunFailure> {
    Channel::of_name(channel.name()).ok_or_else(|| {
        let error = TangentialError::UnknownVariable { name: channel.name().to_owned() };
        finding::on_field(&error, field)
    })
}

/// The variable of the process with the name of the one in the job.
///
/// # Errors
/// A finding on `field` if the process knows no such variable.
pub fn variable_of(variable: drawn::Variable, field: &str) -> Result<Variable, RunFailure> {
    variable.to_string().parse().map_err(|error| finding::on_field(&error, field))
}

/// Bodies, targets and passes of a job.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub fn prepare_tangential(loaded: &LoadedTangentialJob) -> Result<TangentialPrepared, RunFailure> {
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
    let ground: Vec<Flank> = Flank::BOTH.into_iter().filter(|&f| job.grinding.flanks.includes(f)).collect();
    let wanted = Sides::try_from_fn(|flank| {
        ground.contains(&flank).then(|| wanted_flank(loaded, &model, flank)).transpose()
    })
    .map_err(RunFailure::bad_input)?;
    let passes = match job.dressing.passes {
        Passes::One => vec![ground],
        Passes::Each => ground.into_iter().map(|flank| vec![flank]).collect(),
    };
    Ok(TangentialPrepared { model, blank, worm_tip_radius: made.tip_radius, wanted, passes })
}

fn wanted_flank(
    loaded: &LoadedTangentialJob,
    model: &TangentialModel,
    flank: Flank,
) -> Result<WantedFlank, Diagnostic> {
    let target = &loaded.job.target;
    if let Some(amounts) = &target.edge_amounts {
        let um = amounts.sides()[flank];
        return Ok(WantedFlank::Edge(EdgeAmounts {
            pressure_angle: um.pressure_angle_um * 1e-3,
            profile_crowning: um.profile_crowning_um * 1e-3,
            lead_conical: um.lead_conical_um * 1e-3,
            lead_crowning: um.lead_crowning_um * 1e-3,
        }));
    }
    let f = model.pair.work.flank(flank);
    let field =
        EvaluationField::new(model.rolls(flank), model.input().faces, f.base_radius, f.base_helix_angle)
            .map_err(|e| run::modification_finding(&e, "target.modifications"))?;
    let specs = target.modifications.as_deref().unwrap_or_default();
    specs_of_flank(loaded, specs, flank, &field).map(|m| WantedFlank::Modifications(Box::new(m)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_words_of_jobs_are_those_of_the_process() {
        let mut count = 0;
        for variable in drawn::Variable::all() {
            let own = variable_of(variable, "dressing.variables").unwrap();
            assert_eq!(own.to_string(), variable.to_string());
            assert_eq!(own.channel, channel_of(variable.channel(), "dressing.exclude").unwrap());
            count += 1;
        }
        // All powers of all channels but the constant of a profile, which is a thickness.
        let profiles = Channel::ALL.iter().filter(|c| matches!(c, Channel::Profile(_))).count();
        assert_eq!(count, (Channel::ALL.len() - 1) * 10 - profiles + 1);
        assert_eq!(drawn::Channel::ALL.map(drawn::Channel::name), Channel::ALL.map(Channel::name));
        let source = drawn::Variable::SOURCE.map(|v| v.to_string());
        assert_eq!(
            source,
            super::super::sensitivities::SOURCE_VARIABLES.map(|(c, k)| Variable::power(c, k).to_string())
        );
    }
}
