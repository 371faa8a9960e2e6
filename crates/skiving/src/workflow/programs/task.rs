//! What measuring programs are made from: tracks with their poses or edges to scan, the machine and how the tool sits in it. Knows no
//! text of a control.

use super::failure::invalid;
use crate::VirtualEdge;
use crate::measuring::{Beam, FlankTracks, Mandrel, ScanAxes, Sense};
use crate::runout::PeriodicLaw;
use crate::workflow::measurement::Measurement;
use crate::workflow::prepare::SkivingBodies;
use foundation::geometry::Sides;
use foundation::kinematics::SkivingMotion;
use job::machine::LoadedMachine;
use job::tables::Program as DialectName;
use machine::Mount;
use nalgebra::Vector3;
use run::RunFailure;

/// How the tool gets to the beam and away from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Retreat {
    /// How far it is drawn back between two tracks, mm.
    pub distance: f64,
    /// Unit direction on the bed in which it is drawn back; none: from the beam's point straight to the tool's axis.
    pub direction: Option<Vector3<f64>>,
    /// Speed of the way back and forth, mm/s.
    pub speed: f64,
}

/// What a carrier carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carried {
    /// The light barrier, beside the work spindle.
    Barrier,
    /// The tool with all its other axes.
    Tool,
}

/// An axis that brings the light barrier before the tool, or the tool before the light barrier. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carrier {
    /// Its number.
    pub axis: usize,
    /// Where it stands while the tool is measured.
    pub measuring: f64,
    /// Where it stands before and after.
    pub parked: f64,
    /// What it carries.
    pub carries: Carried,
}

/// The machine and the options of its control.
#[derive(Clone, Debug)]
pub struct ToolMachining<'a> {
    /// The machine. Its frame M is that of the beam and of the poses.
    pub machine: &'a LoadedMachine,
    /// How the tool sits in its spindle: distance of the datum face from the spindle's nose, angle of tooth 0.
    pub mount: Mount,
    /// The carrier of the light barrier or of the tool, if one has to move.
    pub carrier: Option<Carrier>,
    /// Ways to the beam and back.
    pub retreat: Retreat,
    /// Digital output that is on while the recorder takes down where the spindle stands, 1 to 15.
    pub output: u8,
    /// Dialects in the order of the programs.
    pub dialects: &'a [DialectName],
}

/// What is measured at a light barrier.
#[derive(Clone, Copy, Debug)]
pub struct MeasuringWork<'a> {
    /// Name of the job.
    pub name: &'a str,
    /// Tracks with their poses.
    pub flanks: &'a Sides<FlankTracks>,
    /// The beam.
    pub beam: &'a Beam,
    /// Senses of the tool, in the order of measuring.
    pub senses: &'a [Sense],
    /// Whole turns that are recorded in each sense, from 1.
    pub revolutions: usize,
    /// Speed of the tool, rad/s.
    pub speed: f64,
}

/// What is driven into a light barrier to calibrate it.
#[derive(Clone, Copy, Debug)]
pub struct CalibrationWork<'a> {
    /// Name of the job.
    pub name: &'a str,
    /// The beam, as it is expected.
    pub beam: &'a Beam,
    /// The mandrel.
    pub mandrel: &'a Mandrel,
    /// Z of its lower face, at two heights.
    pub heights: [f64; 2],
    /// From the spindle's origin to its lower face, mm.
    pub length: f64,
    /// Turns of the spindle, evenly spaced, from 1.
    pub spindle_positions: usize,
    /// Speed, mm/s.
    pub speed: f64,
    /// How far the beam may be from where it is expected, mm.
    pub reach: f64,
}

/// A workpiece that is scanned by a probe.
#[derive(Clone, Copy, Debug)]
pub struct ProbeWork<'a> {
    /// Name of the job.
    pub name: &'a str,
    /// Tool and workpiece.
    pub bodies: &'a SkivingBodies,
    /// Tooth spaces, at least three.
    pub gaps: &'a [usize],
    /// Lengths of roll of the places, ascending, mm.
    pub lengths: &'a Sides<Vec<f64>>,
    /// Radius of the ball, mm.
    pub ball_radius: f64,
    /// From the spindle's origin to the ball along the axis, and beside it along the spindle's x, mm.
    pub length: f64,
    /// The same beside the axis, along the spindle's x.
    pub reach: f64,
    /// A and B of the probe, rad.
    pub orientation: [f64; 2],
    /// Place along the face, from its middle, mm.
    pub height: f64,
    /// From the origin of the work spindle to the middle of the face, mm.
    pub work_height: f64,
    /// Radius of the tip circle, mm.
    pub tip_radius: f64,
    /// Speed of the ball, mm/s.
    pub speed: f64,
    /// How far it stays off before it is laid on, mm.
    pub clearance: f64,
}

/// A finishing stroke of a measured tool.
#[derive(Clone, Copy, Debug)]
pub struct SkivingWork<'a> {
    /// Name of the job.
    pub name: &'a str,
    /// Tool and workpiece.
    pub bodies: &'a SkivingBodies,
    /// The measured tool.
    pub measurement: &'a Measurement,
    /// The motion with the corrected setting.
    pub motion: SkivingMotion,
    /// The law over the turn of the tool.
    pub law: &'a PeriodicLaw,
    /// What the referee leaves with both, [track][tooth] of each flank, mm; without it the flank of a text is not compared.
    pub after: Option<&'a Sides<Vec<Vec<f64>>>>,
    /// How tooth 0 is clamped beside its nominal angle, rad.
    pub clocking: f64,
    /// Heights of the contacts beside the common normal, least and greatest, mm.
    pub engagement: [f64; 2],
    /// The faces of the workpiece, from the middle, mm.
    pub face: [f64; 2],
    /// Speed of the tool, rad/s.
    pub speed: f64,
    /// Feed per turn of the workpiece, mm.
    pub feed: f64,
    /// How far beside both faces the edges begin and end, mm.
    pub overrun: f64,
    /// Blocks per turn of the tool.
    pub blocks_per_turn: usize,
    /// From the origin of the work spindle to the middle of the face, mm.
    pub work_height: f64,
}

/// What is scanned by a stylus.
#[derive(Clone, Copy, Debug)]
pub struct ScanWork<'a> {
    /// Name of the job.
    pub name: &'a str,
    /// The edges.
    pub edges: &'a Sides<VirtualEdge>,
    /// The stylus.
    pub stylus: &'a Beam,
    /// Which axes follow.
    pub axes: ScanAxes,
    /// x from where to where, within -1 to 1.
    pub range: [f64; 2],
    /// Places of a scan, from 2.
    pub places: usize,
    /// Teeth that are scanned on both edges, at least three.
    pub teeth: &'a [usize],
    /// Speed of the stylus along the edge, mm/s.
    pub speed: f64,
}

/// Fewer tooth spaces tell no profile of a workpiece that runs out.
const LEAST_GAPS: usize = 3;
/// Fewer teeth tell no mounting error.
const LEAST_TEETH: usize = 3;
/// How far the direction of the retreat may be off a unit vector.
const UNIT: f64 = 1e-9;

impl ToolMachining<'_> {
    pub(super) fn check(&self) -> Result<(), RunFailure> {
        let Retreat { distance, direction, speed } = self.retreat;
        positive("machine.retreat", distance)?;
        positive("retreat.speed", speed)?;
        if let Some(length) = direction.map(|direction| direction.norm()) {
            // Written so that NaN fails.
            let unit = (length - 1.0).abs() <= UNIT;
            if !unit {
                return Err(invalid("retreat.direction", length, "a unit vector"));
            }
        }
        for (field, value) in
            [("machine.tool_length", self.mount.axial), ("machine.tooth_angle_deg", self.mount.angle)]
        {
            if !value.is_finite() {
                return Err(invalid(field, value, "a finite number"));
            }
        }
        Ok(())
    }
}

impl MeasuringWork<'_> {
    pub(super) fn check(&self) -> Result<(), RunFailure> {
        positive("measuring.speed_rpm", self.speed)?;
        let counts = [
            ("measuring.revolutions", self.revolutions),
            ("measuring.senses", self.senses.len()),
            ("measuring.tracks", self.flanks.left.tracks.len().min(self.flanks.right.tracks.len())),
        ];
        match counts.into_iter().find(|(_, count)| *count == 0) {
            Some((field, _)) => Err(invalid(field, 0.0, "at least 1")),
            None => Ok(()),
        }
    }

    /// z1.
    pub(super) fn teeth(&self) -> usize {
        self.flanks.left.edge.pair().tool().teeth() as usize
    }
}

impl ProbeWork<'_> {
    pub(super) fn check(&self) -> Result<(), RunFailure> {
        positive("workpiece_probe.ball_radius", self.ball_radius)?;
        positive("workpiece_probe.speed_mm_per_min", self.speed)?;
        positive("workpiece_probe.clearance", self.clearance)?;
        for (field, value) in [
            ("workpiece_probe.length", self.length),
            ("workpiece_probe.reach", self.reach),
            ("workpiece_probe.swivel_deg", self.orientation[0]),
            ("workpiece_probe.spindle_deg", self.orientation[1]),
            ("workpiece_probe.height", self.height),
            ("workpiece_probe.work_height", self.work_height),
        ] {
            if !value.is_finite() {
                return Err(invalid(field, value, "a finite number"));
            }
        }
        if self.gaps.len() < LEAST_GAPS {
            return Err(invalid("workpiece_probe.gaps", self.gaps.len() as f64, "at least 3 tooth spaces"));
        }
        Ok(())
    }

    /// Way of the workpiece under the ball for a turn, mm.
    pub(super) fn reach_of_turn(&self, turn: f64) -> f64 {
        turn.abs() * self.bodies.pair.gear().pitch_radius()
    }
}

impl CalibrationWork<'_> {
    pub(super) fn check(&self) -> Result<(), RunFailure> {
        positive("calibration.radius", self.mandrel.radius)?;
        positive("calibration.height", self.mandrel.height)?;
        positive("calibration.speed_mm_per_min", self.speed)?;
        positive("calibration.reach", self.reach)?;
        if !self.length.is_finite() {
            return Err(invalid("calibration.mandrel_length", self.length, "a finite number"));
        }
        match self.spindle_positions {
            0 => Err(invalid("calibration.spindle_positions", 0.0, "at least 1")),
            _ => Ok(()),
        }
    }
}

impl ScanWork<'_> {
    pub(super) fn check(&self) -> Result<(), RunFailure> {
        positive("stylus.speed_mm_per_min", self.speed)?;
        if self.teeth.len() < LEAST_TEETH {
            return Err(invalid("stylus.teeth", self.teeth.len() as f64, "at least 3 teeth"));
        }
        match self.teeth.iter().find(|&&tooth| tooth >= self.count()) {
            Some(&tooth) => Err(invalid("stylus.teeth", tooth as f64, "teeth of the tool, counted from 0")),
            None => Ok(()),
        }
    }

    /// z1.
    pub(super) fn count(&self) -> usize {
        self.edges.left.pair().tool().teeth() as usize
    }
}

fn positive(field: &str, value: f64) -> Result<(), RunFailure> {
    // Written so that NaN fails.
    let fits = value > 0.0 && value.is_finite();
    if fits { Ok(()) } else { Err(invalid(field, value, "above 0")) }
}
