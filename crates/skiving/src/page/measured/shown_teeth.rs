//! The deviations of a measured tool in um, by flank, number of the track and tooth.

use crate::workflow::{Measurement, SkivingBodies};
use foundation::geometry::Flank;
use foundation::numerics::power_series;

/// All teeth on all tracks.
pub(super) struct ShownTeeth<'a> {
    pub bodies: &'a SkivingBodies,
    pub measurement: &'a Measurement,
    /// D: width of the band about the compensation curve.
    pub band_um: f64,
}

impl<'a> ShownTeeth<'a> {
    pub fn new(bodies: &'a SkivingBodies, measurement: &'a Measurement, band_um: f64) -> Self {
        Self { bodies, measurement, band_um }
    }

    /// Number of tracks of a flank.
    pub fn tracks(&self, flank: Flank) -> usize {
        self.bodies.flanks[flank].tracks.len()
    }

    /// x = -1..1 along the edge.
    pub fn place(&self, flank: Flank, track: usize) -> f64 {
        self.bodies.flanks[flank].tracks[track].0.place
    }

    /// The compensation curve.
    pub fn curve_um(&self, flank: Flank, track: usize) -> f64 {
        let curve = &self.measurement.evaluation.profile.curve[flank];
        1e3 * power_series(curve, self.place(flank, track))[0]
    }

    /// Without the clocking of the tool.
    pub fn measured_um(&self, flank: Flank, track: usize, tooth: usize) -> f64 {
        1e3 * self.measurement.evaluation.clocked.of[flank][track][tooth]
    }

    /// What remains without eccentricity and wobble.
    pub fn remaining_um(&self, flank: Flank, track: usize, tooth: usize) -> f64 {
        1e3 * self.measurement.evaluation.remaining.of[flank][track][tooth]
    }
}
