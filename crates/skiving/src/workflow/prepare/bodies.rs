//! Edges, tracks and poses of a job.

use super::beam::nominal_beam;
use super::calibration::{CalibrationOutcome, calibrate};
use crate::evaluation::ProfileOptions;
use crate::job::{LoadedSkivingJob, MeasuringPoses, Rake, RakeForm, SkivingJob, ToolKinematics};
use crate::measuring::{
    BarrierData, Beam, FlankTracks, NearestFlank, PoseKind, PoseLimits, nearest_other_flank, reached_pose,
};
use crate::workflow::finding::failure;
use crate::{
    Kinematics, MeasuringTrack, PairData, Setting, SettingLimits, SkivedFlank, SkivingError, SkivingPair,
    VirtualEdge,
};
use foundation::geometry::{
    ConeRake, EdgeRounding, Flank, Gear, Helicoid, PlaneRake, RakeChange, RakeFace, Sides, SkivingTool,
    SphericalRake, VariableRake,
};
use foundation::modification::EvaluationField;
use run::{
    DrawingResult, ModifiedFlank, RunFailure, ToothMeasures, blank_of_job, gear_of_job, modification_finding,
    specs_of_flank,
};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Edges, tracks and poses, and what the tool is judged by.
#[derive(Clone, Debug)]
pub struct SkivingBodies {
    /// How the tooth thickness of the workpiece is measured, and the class of its drawing.
    pub measures: ToothMeasures,
    /// The same as results have it.
    pub drawing: DrawingResult,
    /// Tool, workpiece, motion.
    pub pair: SkivingPair,
    /// The ideal edges.
    pub edges: Sides<VirtualEdge>,
    /// The beam, calibrated if the job has switches of a mandrel.
    pub beam: Beam,
    /// Its calibration.
    pub calibration: Option<CalibrationOutcome>,
    /// Tracks with their poses.
    pub flanks: Sides<FlankTracks>,
    /// What comes nearest to the beam besides the edge, track by track.
    pub nearest: Sides<Vec<NearestFlank>>,
    /// Light barrier, spindle, encoder.
    pub barrier: BarrierData,
    /// What the machine and the user allow of poses.
    pub limits: PoseLimits,
    /// What the tool is judged by.
    pub options: ProfileOptions,
    /// Settings that the correction may change.
    pub free: Vec<Setting>,
    /// How far.
    pub setting_limits: SettingLimits,
    /// r_L - r_eff of a measurement in one sense, mm.
    pub radius_offset: f64,
    /// How tooth 0 is known to be clamped, rad; the nearest pitch to it counts.
    pub clocking: f64,
}

impl SkivingBodies {
    /// z_1.
    pub fn teeth(&self) -> usize {
        self.pair.tool().teeth() as usize
    }
}

/// Edges, tracks and poses of a job.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub(super) fn bodies_of_job(loaded: &LoadedSkivingJob) -> Result<SkivingBodies, RunFailure> {
    let job = &loaded.job;
    let on = |error: SkivingError| failure(&error);
    let gear = gear_of_job(&job.gear).map_err(RunFailure::bad_input)?;
    blank_of_job(&job.gear).check(&gear).map_err(|error| on(error.into()))?;
    let measures = ToothMeasures::of(&job.gear, &gear).map_err(RunFailure::bad_input)?;
    let setting = PairData {
        tool_shift: job.skiving.tool_shift,
        centre_distance: job.skiving.centre_distance,
        crossed_axes_angle: job.skiving.crossed_axes_angle_deg.map(f64::to_radians),
        kinematics: match job.skiving.kinematics {
            ToolKinematics::Skiving => Kinematics::Skiving,
            ToolKinematics::Shaping => Kinematics::Shaping,
        },
    };
    let pair = SkivingPair::new(tool(job).map_err(on)?, gear, setting).map_err(on)?;
    let edges = Sides::try_from_fn(|flank| {
        let wanted = wanted(loaded, &pair, flank)?;
        VirtualEdge::new(&pair, wanted).map_err(on)
    })?;
    let calibration =
        job.calibration.as_ref().map(|given| calibrate(&job.light_barrier, given)).transpose()?;
    let beam = match &calibration {
        Some(CalibrationOutcome { beam: Some(beam), .. }) => *beam,
        _ => nominal_beam(&job.light_barrier).map_err(on)?,
    };
    let (tracks, degree) = (job.measuring.tracks.len(), job.evaluation.curve_degree);
    if degree >= tracks {
        return Err(on(SkivingError::TooFewTracks { tracks, degree }));
    }
    let (kind, limits) = poses(job);
    let flanks = Sides::try_from_fn(|flank| {
        let edge = &edges[flank];
        let of_track = |(number, place): (usize, &f64)| {
            let track = MeasuringTrack::new(edge, *place)?;
            let pose = reached_pose(&edges, &track, &beam, kind, &limits, (flank, number))?;
            Ok((track, pose))
        };
        let tracks = job.measuring.tracks.iter().enumerate().map(of_track).collect::<Result<_, _>>();
        Ok::<_, RunFailure>(FlankTracks { edge: edge.clone(), tracks: tracks.map_err(on)? })
    })?;
    let nearest = flanks.map(|flank, of| {
        let gap = |(_, pose): &(_, _)| nearest_other_flank(&edges, flank, pose, &beam, limits.body_depth);
        of.tracks.iter().map(gap).collect()
    });
    let bounds = &job.evaluation.limits;
    Ok(SkivingBodies {
        drawing: measures.result(&gear),
        measures,
        pair,
        edges,
        calibration,
        flanks,
        nearest,
        barrier: barrier(job),
        limits,
        options: ProfileOptions {
            degree,
            band: 1e-3 * job.evaluation.band_um,
            wear_limit: 1e-3 * job.evaluation.wear_limit_um,
        },
        free: job.evaluation.settings.iter().map(|setting| setting.setting()).collect(),
        setting_limits: SettingLimits {
            of: [
                bounds.centre_distance,
                bounds.crossed_axes_angle_deg.to_radians(),
                bounds.tool_shift,
                bounds.tool_angle_deg.to_radians(),
            ],
        },
        radius_offset: job.evaluation.switching_radius.map_or(0.0, |radius| beam.radius - radius),
        clocking: job.measuring.clocking_deg.unwrap_or(0.0).to_radians(),
        beam,
    })
}

fn tool(job: &SkivingJob) -> Result<SkivingTool, SkivingError> {
    let given = &job.skiving_tool;
    let chamfer = given.rake_chamfer.map_or([0.0; 2], |chamfer| [chamfer.width, chamfer.angle_deg]);
    let rounding = EdgeRounding {
        radius: given.edge_radius,
        clearance_angle: given.clearance_angle_deg.to_radians(),
        rake_chamfer_width: chamfer[0],
        rake_chamfer_angle: chamfer[1].to_radians(),
        clearance_chamfer_angle: given.clearance_chamfer_angle_deg.to_radians(),
    };
    let face = |radius: f64| rake_face(&given.rake, radius);
    Ok(SkivingTool::new(
        given.teeth,
        given.helix_angle_deg.to_radians(),
        job.gear.normal_module,
        face,
        rounding,
    )?)
}

fn rake_face(rake: &Rake, pitch_radius: f64) -> Arc<dyn RakeFace> {
    let angle = rake.angle_deg.to_radians();
    match rake.form {
        RakeForm::Plane => Arc::new(PlaneRake::new(angle, rake.step_angle_deg.to_radians(), pitch_radius)),
        RakeForm::Cone => Arc::new(ConeRake::new(angle, pitch_radius)),
        RakeForm::Sphere => Arc::new(SphericalRake::new(angle, pitch_radius)),
        RakeForm::Variable => {
            let change = RakeChange {
                by_height: [rake.height_deg_per_mm.to_radians(), rake.height_deg_per_mm2.to_radians()],
                hollow: rake.hollow_deg_per_mm.to_radians(),
                twist: rake.twist_deg_per_mm.to_radians(),
            };
            Arc::new(VariableRake::new(angle, rake.step_angle_deg.to_radians(), change, pitch_radius))
        }
    }
}

/// The flank that the tool is to make, over the evaluated profile.
fn wanted(loaded: &LoadedSkivingJob, pair: &SkivingPair, flank: Flank) -> Result<SkivedFlank, RunFailure> {
    let job = &loaded.job;
    let on = |error: SkivingError| failure(&error);
    let range = job.gear.evaluation_range();
    let plain =
        pair.flank_between(flank, [0.5 * range.start_diameter, 0.5 * range.end_diameter]).map_err(on)?;
    let specs = job.target.modifications.as_deref().unwrap_or_default();
    if specs.is_empty() {
        return Ok(plain);
    }
    let faces = [range.z_start, range.z_end];
    let base = base_of(pair.gear(), flank);
    let field = EvaluationField::new(plain.range(), faces, base.base_radius(), base.base_helix_angle())
        .map_err(|error| RunFailure::bad_input(modification_finding(&error, "gear")))?;
    let modification = specs_of_flank(loaded, specs, flank, &field).map_err(RunFailure::bad_input)?;
    plain.modified(Arc::new(ModifiedFlank::new(modification)), faces).map_err(on)
}

fn base_of(gear: &Gear, flank: Flank) -> Helicoid {
    Helicoid::new(gear, flank)
}

fn barrier(job: &SkivingJob) -> BarrierData {
    let given = &job.light_barrier;
    BarrierData {
        speed: job.measuring.speed_rpm * TAU / 60.0,
        latency: 1e-6 * given.latency_us,
        jitter: 1e-6 * given.jitter_us,
        beam_noise: 1e-3 * given.noise_um,
        hysteresis: 1e-3 * given.hysteresis_um,
        encoder_step: given.encoder_step_deg.to_radians(),
    }
}

fn poses(job: &SkivingJob) -> (PoseKind, PoseLimits) {
    let given = &job.measuring;
    let kind = match given.poses {
        MeasuringPoses::Tangent => PoseKind::Tangent,
        MeasuringPoses::AlongFlank => PoseKind::AlongFlank,
    };
    let free = PoseLimits::default();
    let travel = &given.travel;
    let position = [travel.x, travel.y, travel.z];
    let limits = PoseLimits {
        swivel: travel.a_deg.map_or(free.swivel, |ends| ends.map(f64::to_radians)),
        position: std::array::from_fn(|k| position[k].unwrap_or(free.position[k])),
        off_flank: given.most_off_flank_deg.to_radians(),
        body_depth: given.body_depth,
    };
    (kind, limits)
}
