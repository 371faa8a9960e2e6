//! `[inspection.simulated]`: what the machine does wrong, and how the gear that it grinds is measured.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::deviations::{DressingDeviation, MachineDeviations};

/// Deviations of the machine and a measurement of the gear that it grinds with them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct SimulatedMeasurement {
    /// Deviation of the centre distance over the feed, um: coefficients of q^k, k = 0, 1, .., where q runs from -1 to 1 over the face
    /// width.
    #[schemars(extend("maxItems" = 6))]
    pub radial_feed_um: Vec<f64>,
    /// Deviation of the workpiece's angle over the feed, arcsec: coefficients of q^k.
    #[schemars(extend("maxItems" = 6))]
    pub work_angle_arcsec: Vec<f64>,
    /// Deviation of the crossing angle of worm and workpiece, degrees.
    #[schemars(extend("minimum" = -1, "maximum" = 1, "x-way-out" = "give a deviation of some thousandths of a degree"))]
    pub crossing_angle_deg: f64,
    /// Deviations of the dressing axes while the worm is dressed.
    pub dressing: DressingDeviation,
    /// Displacement of the gear on the measuring machine in x and y, um.
    pub eccentricity_um: [f64; 2],
    /// Standard deviation by which slopes and crownings of the teeth differ, um.
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give some tenths of a micrometre"))]
    pub tooth_um: f64,
    /// Standard deviation of a reading, um.
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give some tenths of a micrometre"))]
    pub noise_um: f64,
    /// Teeth that are measured, evenly around the gear.
    #[schemars(extend("minimum" = 1, "maximum" = 1000, "x-way-out" = "four teeth are usual; at least five tell the run-out"))]
    pub teeth: u32,
    /// Profiles on every tooth, from face to face.
    #[schemars(extend("minimum" = 1, "maximum" = 9, "x-way-out" = "three tell the twist"))]
    pub profiles: usize,
    /// Helix traces on every tooth, from root to tip.
    #[schemars(extend("minimum" = 1, "maximum" = 9, "x-way-out" = "three tell the twist"))]
    pub helices: usize,
    /// Rounds of measuring and correcting.
    #[schemars(extend("minimum" = 1, "maximum" = 10, "x-way-out" = "two rounds suffice"))]
    pub rounds: usize,
    /// Start of the random numbers.
    #[schemars(extend("minimum" = 0, "maximum" = 9_007_199_254_740_991_u64, "x-way-out" = "give a whole number"))]
    pub seed: u64,
}

impl SimulatedMeasurement {
    /// What the machine does wrong.
    pub fn deviations(&self) -> MachineDeviations {
        MachineDeviations {
            radial_feed_um: self.radial_feed_um.clone(),
            work_angle_arcsec: self.work_angle_arcsec.clone(),
            crossing_angle_deg: self.crossing_angle_deg,
            dressing: self.dressing,
        }
    }
}

impl Default for SimulatedMeasurement {
    fn default() -> Self {
        Self {
            radial_feed_um: Vec::new(),
            work_angle_arcsec: Vec::new(),
            crossing_angle_deg: 0.0,
            dressing: DressingDeviation::default(),
            eccentricity_um: [0.0; 2],
            tooth_um: 0.0,
            noise_um: 0.0,
            teeth: 4,
            profiles: 3,
            helices: 3,
            rounds: 2,
            seed: 1,
        }
    }
}
