//! A touch probe as a tool of the machine.

use crate::job::{CutterCoolant, TouchProbe};
use crate::workflow::prepare::ToolData;
use foundation::geometry::{Cutter, CutterShape, GeometryError, ShankStep};

/// A probe: a ball on a stem. Lengths in mm, angles in rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProbeTool {
    /// Its number.
    pub number: u32,
    /// Number of its length on the control, where the job names one.
    pub length_offset: Option<u32>,
    /// From the nose of the spindle to the tip of the ball.
    pub length: f64,
    /// Radii of ball and stem.
    pub radii: [f64; 2],
    /// Height of the ball's centre above the root body, where the job names one.
    pub height: Option<f64>,
    /// How far the table turns on beyond where the flank is expected.
    pub search: f64,
    /// Speed of the table towards a flank, rad/s.
    pub turn_speed: f64,
    /// Speed into the space and out of it, mm/s.
    pub feed: f64,
}

/// Thickness of the stem over that of the ball where the job does not give it.
const STEM: f64 = 0.6;

impl ProbeTool {
    /// Of a job.
    pub fn of_job(given: &TouchProbe) -> Self {
        let stem = given.stem_diameter.unwrap_or(STEM * given.diameter);
        Self {
            number: given.number,
            length_offset: given.length_offset,
            length: given.tool_length,
            radii: [0.5 * given.diameter, 0.5 * stem],
            height: given.height,
            search: given.search_deg.to_radians(),
            turn_speed: given.turn_deg_per_min.to_radians() / 60.0,
            feed: given.feed_mm_per_min / 60.0,
        }
    }

    /// As a body: half a ball, and the stem above.
    ///
    /// # Errors
    /// [`GeometryError`] for sizes that are no tool.
    pub fn body(&self) -> Result<Cutter, GeometryError> {
        let [ball, stem] = self.radii;
        Cutter::new(CutterShape::ball(ball), ball, vec![ShankStep { radius: stem, from: ball }])
    }

    /// As a tool that programs call.
    pub fn tool(&self) -> ToolData {
        ToolData {
            number: self.number,
            length_offset: self.length_offset,
            edges: None,
            length: self.length,
            spindle_rpm: 0.0,
            feed: 60.0 * self.feed,
            plunge_feed: 60.0 * self.feed,
            coolant: CutterCoolant::Off,
        }
    }
}
