//! Measuring programs in a `result.json`.

use super::{MandrelWay, Recording, Scanned, ToolProgram};
use crate::measuring::{Approach, Sense};
use schemars::JsonSchema;
use serde::Serialize;

/// One program.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ToolProgramResult {
    /// Path below the directory of the run.
    pub file: String,
    /// Control.
    pub control: &'static str,
    /// Blocks that move.
    pub blocks: usize,
    /// Time of the whole program.
    pub duration_s: f64,
    /// What is recorded at a light barrier, in the order of the program.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub recordings: Vec<RecordingResult>,
    /// What is scanned by a stylus, in the order of the program.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub scans: Vec<ScanResult>,
    /// Ways of a mandrel in the light barrier, in the order of the program.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub mandrel_ways: Vec<MandrelWayResult>,
    /// Profiles of the workpiece that a probe scans, in the order of the program.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub profiles: Vec<ProbedProfileResult>,
    /// What rounding of the numbers does at most.
    pub rounding_um: f64,
    /// Greatest difference of where the ideal tool touches from its nominal place, with the axes as the text says.
    pub proof_difference_um: f64,
    /// Greatest distance of the beam's axis from where the contact wants it.
    pub proof_axis_distance_um: f64,
    /// What rounding explains of both.
    pub proof_allowed_um: f64,
    /// Of a scan: what straight blocks leave between its places; of a stroke: beside its law.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub between_places_um: Option<f64>,
    /// Of a stroke: greatest difference between the flank of the text under the referee and the planned one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flank_difference_um: Option<f64>,
}

/// One stretch that is recorded. Angles are those of the tool spindle as the control counts them.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RecordingResult {
    /// "left" or "right" flank of the workpiece.
    pub flank: String,
    /// Track, from 1.
    pub track: usize,
    /// "positive" or "negative" sense of the tool.
    pub sense: &'static str,
    /// Where tooth 0 of the ideal tool switches.
    pub nominal_deg: f64,
    /// Where the switches that count begin.
    pub from_deg: f64,
    /// Where they end, one pitch beyond the whole turns.
    pub to_deg: f64,
}

/// A way of a mandrel on which the recorder takes down where the axes stand when the beam switches. Places: X and Y of its axis, Z of its
/// lower face.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MandrelWayResult {
    /// Axis along which it moves.
    pub along: &'static str,
    /// Turn of the spindle.
    pub spindle_deg: f64,
    /// Where it begins.
    pub from_mm: [f64; 3],
    /// Where it ends.
    pub to_mm: [f64; 3],
    /// Where the given beam switches.
    pub switches_mm: Vec<[f64; 3]>,
}

/// A profile of the workpiece that a probe scans.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ProbedProfileResult {
    /// Flank.
    pub flank: &'static str,
    /// Tooth space, from 0.
    pub gap: usize,
    /// Places of the scan.
    pub places: usize,
}

/// One edge that is scanned.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ScanResult {
    /// "left" or "right" flank of the workpiece.
    pub flank: String,
    /// Tooth, from 0.
    pub tooth: usize,
    /// Places of the scan.
    pub places: usize,
}

impl ToolProgram {
    /// What the result says about the program.
    pub fn result(&self) -> ToolProgramResult {
        let degrees = |angle: f64| (self.nc_sign * angle).to_degrees();
        let recording = |of: &Recording| RecordingResult {
            flank: of.flank.to_string(),
            track: of.track + 1,
            sense: match of.sense {
                Sense::Positive => "positive",
                Sense::Negative => "negative",
            },
            nominal_deg: degrees(of.nominal),
            from_deg: degrees(of.counted[0]),
            to_deg: degrees(of.counted[1]),
        };
        let scan = |of: &Scanned| ScanResult {
            flank: of.flank.to_string(),
            tooth: of.tooth,
            places: of.places.len(),
        };
        ToolProgramResult {
            file: self.file.clone(),
            control: self.dialect.name(),
            blocks: self.blocks,
            duration_s: self.duration,
            recordings: self.recordings.iter().map(recording).collect(),
            scans: self.scanned.iter().map(scan).collect(),
            mandrel_ways: self.mandrel_ways.iter().map(mandrel_way).collect(),
            profiles: self
                .probed
                .iter()
                .map(|of| ProbedProfileResult {
                    flank: of.flank.name(),
                    gap: of.gap,
                    places: of.lengths.len(),
                })
                .collect(),
            rounding_um: self.rounding.distance * 1e3,
            proof_difference_um: self.proof.difference * 1e3,
            proof_axis_distance_um: self.proof.axis_distance * 1e3,
            proof_allowed_um: self.proof.allowed * 1e3,
            between_places_um: self.proof.between_places.map(|x| x * 1e3),
            flank_difference_um: self.proof.flank.map(|x| x * 1e3),
        }
    }
}

fn mandrel_way(of: &MandrelWay) -> MandrelWayResult {
    MandrelWayResult {
        along: match of.along {
            Approach::X => "X",
            Approach::Y => "Y",
        },
        spindle_deg: of.turn.to_degrees(),
        from_mm: of.ends[0].into(),
        to_mm: of.ends[1].into(),
        switches_mm: of.switches.iter().map(|place| (*place).into()).collect(),
    }
}
