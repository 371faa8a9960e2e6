//! What measuring programs are made from: tracks with their poses or edges to scan, the machine and how the tool sits in it. Knows no
//! text of a control.

use super::failure::invalid;
use crate::VirtualEdge;
use crate::measuring::{Beam, FlankTracks, ScanAxes, Sense};
use foundation::geometry::Sides;
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

/// The machine and the options of its control.
#[derive(Clone, Debug)]
pub struct ToolMachining<'a> {
    /// The machine. Its frame M is that of the beam and of the poses.
    pub machine: &'a LoadedMachine,
    /// How the tool sits in its spindle: distance of the datum face from the spindle's nose, angle of tooth 0.
    pub mount: Mount,
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
