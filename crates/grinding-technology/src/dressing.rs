//! Figures of dressing: speed ratio, advance, contact length, overlap.

use super::error::positive;
use super::{Bodies, TechnologyError};
use std::f64::consts::{PI, TAU};

/// Which way the dresser runs at the contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rotation {
    /// With the worm.
    Same,
    /// Against it.
    Opposite,
}

/// How the worm is dressed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DressingTechnology {
    /// 1/s.
    pub worm_speed: f64,
    /// 1/s.
    pub dresser_speed: f64,
    /// mm.
    pub dresser_tip_diameter: f64,
    /// mm.
    pub dresser_pitch_diameter: f64,
    /// At the contact.
    pub rotation: Rotation,
    /// Taken from the flank by one pass, mm.
    pub depth: f64,
    /// Passes for each side that the dresser works on at a time.
    pub passes: usize,
    /// Whether one flank is dressed at a time.
    pub one_flank: bool,
    /// Width that is dressed, mm.
    pub worm_width: f64,
}

/// What follows from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DressingFigures {
    /// Peripheral speed of the dresser over that of the worm, above 0 where both run the same way.
    pub speed_ratio: f64,
    /// Way of the thread past the dresser per revolution of the dresser, mm.
    pub advance: f64,
    /// mm.
    pub contact_length: f64,
    /// Contact length over advance.
    pub overlap: f64,
}

impl DressingTechnology {
    /// Checks every number.
    pub(crate) fn check(&self) -> Result<(), TechnologyError> {
        for (field, value) in [
            ("dressing.worm_speed_rpm", 60.0 * self.worm_speed),
            ("dressing.dresser_speed_rpm", 60.0 * self.dresser_speed),
            ("dressing.dresser_tip_diameter", self.dresser_tip_diameter),
            ("dressing.dresser_pitch_diameter", self.dresser_pitch_diameter),
            ("dressing.depth_um", 1e3 * self.depth),
            ("dressing.passes", self.passes as f64),
            ("dressing.worm_width", self.worm_width),
        ] {
            positive(field, value)?;
        }
        Ok(())
    }

    /// On the worm of `bodies`.
    ///
    /// # Errors
    /// `OutOfRange`.
    pub fn figures(&self, bodies: &Bodies) -> Result<DressingFigures, TechnologyError> {
        self.check()?;
        let sign = match self.rotation {
            Rotation::Same => 1.0,
            Rotation::Opposite => -1.0,
        };
        let speed_ratio = sign * PI * self.dresser_tip_diameter * self.dresser_speed
            / (TAU * bodies.worm_tip_radius * self.worm_speed);
        let worm_radius = bodies.pair.worm.pitch_radius();
        let advance = (TAU * worm_radius).hypot(bodies.thread_lead()) * self.worm_speed / self.dresser_speed;
        let flanks = &bodies.pair.flanks;
        let angle = 0.5 * (flanks.left.operating_alpha_n + flanks.right.operating_alpha_n);
        let curvature = angle.sin() * (2.0 / self.dresser_pitch_diameter + 1.0 / worm_radius);
        let contact_length = (2.0 * self.depth / curvature).sqrt();
        Ok(DressingFigures { speed_ratio, advance, contact_length, overlap: contact_length / advance })
    }
}

impl Bodies {
    /// Axial way of a thread per revolution of the worm, mm.
    pub fn thread_lead(&self) -> f64 {
        let worm = self.pair.worm.data();
        PI * self.threads() * worm.normal_module / worm.helix_angle.sin().abs()
    }
}
