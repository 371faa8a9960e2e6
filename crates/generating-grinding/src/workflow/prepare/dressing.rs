//! How the job dresses the worm, beside the bodies and the profile.

use crate::job::{DressingFlanks, Job};

/// Discs and their use.
#[derive(Clone, Debug)]
pub struct DressingTask {
    /// Whether one stroke dresses both flanks.
    pub two_flanks: bool,
    /// Width of the land at the tip of the dresser that the job gives, mm.
    pub tip_land: Option<f64>,
    /// Tip diameters of further dressers, mm.
    pub other_tip_diameters: Vec<f64>,
    /// The disc that writes the worm line by line; `None` for every other tool.
    pub point: Option<PointDresser>,
}

/// A disc in point contact.
#[derive(Clone, Copy, Debug)]
pub struct PointDresser {
    /// Diameter over its rounded tip, mm.
    pub tip_diameter: f64,
    /// Radius of the tip, mm.
    pub tip_radius: f64,
    /// Height of the scallops that may be left between lines, mm.
    pub scallop: f64,
}

impl DressingTask {
    /// Of a job.
    pub(super) fn of_job(job: &Job) -> Self {
        Self {
            two_flanks: job.dressing.flanks == DressingFlanks::Two,
            tip_land: job.dresser.as_ref().and_then(|dresser| dresser.tip_land),
            other_tip_diameters: job
                .dresser
                .iter()
                .flat_map(|dresser| &dresser.others)
                .map(|other| other.tip_diameter)
                .collect(),
            point: job.point_dresser().map(|(dresser, tip_radius)| PointDresser {
                tip_diameter: dresser.tip_diameter,
                tip_radius,
                scallop: job.dressing.scallop_height_um() * 1e-3,
            }),
        }
    }

    /// Tip radius of the largest dresser beside the first one of this tip diameter, mm.
    pub fn largest_radius(&self, first: f64) -> f64 {
        0.5 * self.other_tip_diameters.iter().copied().fold(first, f64::max)
    }
}
