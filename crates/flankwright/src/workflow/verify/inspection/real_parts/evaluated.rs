//! What the library evaluates of the whole gear from its measurement: pitch of both flanks, thickness, run-out, eccentricity.
//! What the files do not hold is absent.

use super::super::super::given::Checked;
use super::super::evaluation_case::mm;
use crate::exchange::inspection::{self as exchange, Inspection};
use crate::geometry::{Flank, Gear, Sides};
use crate::metrology::inspection::{
    BallContact, Eccentricity, FlankAngles, MeasuredThickness, PitchDeviations, PitchEvaluation,
    ProbePosition, RunOut, ThicknessSizes, eccentricity, measured_thickness, pitch_from_positions,
    run_out_from_pitch, thickness_variation,
};

/// Pitch of one flank.
pub(super) struct FlankPitch {
    pub deviations: PitchDeviations,
    pub evaluation: PitchEvaluation,
}

/// Everything evaluated of a gear. mm, rad
pub(super) struct EvaluatedGear {
    pub pitch: Sides<Option<FlankPitch>>,
    /// Rs.
    pub thickness_variation: Option<f64>,
    pub thickness: MeasuredThickness,
    /// Measure over balls of the gear that the span means.
    pub over_balls_by_span: Option<f64>,
    /// Run-out that the pitch means.
    pub run_out: Option<RunOut>,
    pub eccentricity: Option<Eccentricity>,
    /// Pitch from the positions of the probe.
    pub from_positions: Option<Sides<PitchDeviations>>,
}

impl EvaluatedGear {
    /// Of a measured gear.
    ///
    /// # Errors
    /// Those of the evaluations.
    pub fn of(inspection: &Inspection) -> Checked<Self> {
        let nominal = inspection.gear.checked()?;
        let sizes = sizes(&inspection.thickness);
        let thickness = measured_thickness(*nominal.data(), &sizes)?;
        // The sizes state the thickness of the teeth, the profile shift of the header does not. The expected values are those of the span.
        let by_span = thickness.by_span.map(|x| inspection.gear.gear(x)).transpose()?;
        let measured = match by_span {
            Some(gear) => Some(gear),
            None => thickness.by_balls.map(|x| inspection.gear.gear(x)).transpose()?,
        };
        let ball = inspection.thickness.ball_diameter_mm;
        let over_balls = |(gear, ball): (Gear, f64)| gear.over_balls(ball, 0.0).map(|found| found.size);
        let over_balls_by_span = by_span.zip(ball).map(over_balls).transpose()?;
        let pitch = Sides::try_from_fn(|flank| flank_pitch(inspection, flank))?;
        let both = cumulative(&pitch);
        let contact = measured.zip(ball).map(|(gear, ball)| BallContact::of(&gear, ball)).transpose()?;
        let run_out = both.as_ref().zip(contact.as_ref());
        Ok(Self {
            thickness_variation: both.as_ref().map(thickness_variation),
            run_out: run_out.map(|(both, contact)| run_out_from_pitch(both, contact)).transpose()?,
            eccentricity: (both.as_ref().zip(measured))
                .map(|(both, gear)| eccentricity(both, &FlankAngles::of(&gear)))
                .transpose()?,
            from_positions: from_positions(inspection, &nominal)?,
            pitch,
            thickness,
            over_balls_by_span,
        })
    }
}

/// Mean span and mean measure over balls with the teeth and the ball that they were taken with.
fn sizes(thickness: &exchange::Thickness) -> ThicknessSizes {
    let mean = |size: Option<exchange::Size>| size.and_then(|size| size.mean_mm);
    ThicknessSizes {
        span: thickness.span_teeth.zip(mean(thickness.span)),
        balls: thickness.ball_diameter_mm.zip(mean(thickness.over_balls)),
    }
}

fn flank_pitch(inspection: &Inspection, flank: Flank) -> Checked<Option<FlankPitch>> {
    let measured = inspection.pitch.as_ref().and_then(|pitch| pitch.flanks[flank].as_ref());
    let Some(measured) = measured else { return Ok(None) };
    let teeth = inspection.gear.teeth.unsigned_abs() as usize;
    let deviations = PitchDeviations::new(mm(&measured.fp_um), teeth)?;
    let evaluation = deviations.evaluate(None)?;
    Ok(Some(FlankPitch { deviations, evaluation }))
}

/// Fp_i of both flanks, if both were measured.
fn cumulative(pitch: &Sides<Option<FlankPitch>>) -> Option<Sides<Vec<f64>>> {
    let of = |flank: Flank| pitch[flank].as_ref().map(|pitch| pitch.evaluation.cumulative.clone());
    Some(Sides { left: of(Flank::Left)?, right: of(Flank::Right)? })
}

fn from_positions(inspection: &Inspection, gear: &Gear) -> Checked<Option<Sides<PitchDeviations>>> {
    let Some(pitch) = inspection.pitch.as_ref().filter(|pitch| !pitch.positions.is_empty()) else {
        return Ok(None);
    };
    let diameter =
        pitch.diameter_mm.ok_or("the files do not say on which diameter the pitch was measured")?;
    let position = |read: &exchange::ProbePosition| ProbePosition {
        flank: read.flank,
        number: read.number as usize,
        table_angle: read.angle_deg.to_radians(),
        x: read.centre_mm[0],
        y: read.centre_mm[1],
    };
    let positions: Vec<ProbePosition> = pitch.positions.iter().map(position).collect();
    Ok(Some(pitch_from_positions(&positions, gear, diameter)?))
}
