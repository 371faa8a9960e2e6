//! One worm over its life: each dressing takes a little of its diameter.

use super::error::{in_range, positive};
use super::{Bodies, TechnologyError};
use contact::Pair;
use foundation::geometry::{Flank, Gear, GearData, WormChoice, worm_for_gear};
use foundation::kinematics::GeneratingChain;
use std::f64::consts::PI;

/// Diameters and limits of a worm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WormLife {
    /// Tip diameter of the new worm, mm.
    pub first_tip_diameter: f64,
    /// Least tip diameter, mm.
    pub last_tip_diameter: f64,
    /// Taken from the radius by one dressing, mm.
    pub radial_per_dressing: f64,
    /// Wanted at the tip, m/s.
    pub cutting_speed: f64,
    /// Of the worm's spindle, 1/s.
    pub largest_worm_speed: f64,
    /// Of the workpiece's spindle, 1/s.
    pub largest_work_speed: f64,
    /// Largest V'_w, mm^3/mm.
    pub allowed: f64,
    /// Width of the worm that is used, mm.
    pub zone_width: f64,
    /// Sum of b a_e over the strokes of one part, mm^2.
    pub section_per_part: f64,
}

/// The worm after some dressings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LifeRow {
    /// Tip diameter, mm.
    pub tip_diameter: f64,
    /// Worm, 1/s.
    pub worm_speed: f64,
    /// At the tip, m/s.
    pub cutting_speed: f64,
    /// Crossed-axes angle, rad.
    pub crossed_axes_angle: f64,
    /// Workpiece, 1/s.
    pub work_speed: f64,
    /// Largest M, mm.
    pub wear_factor: f64,
    /// Parts until the next dressing, not whole.
    pub parts: f64,
}

/// Rows from the new worm to the last.
#[derive(Clone, Debug, PartialEq)]
pub struct Life {
    /// One for each state between two dressings.
    pub rows: Vec<LifeRow>,
}

impl Life {
    /// Parts that the worm grinds in all.
    pub fn parts_per_worm(&self) -> f64 {
        self.rows.iter().map(|row| row.parts.floor()).sum()
    }

    /// Dressings of the new worm that grind as many parts as the worm does in all.
    pub fn full_dressings(&self) -> f64 {
        let first = self.rows.first().map_or(1.0, |row| row.parts);
        self.rows.iter().map(|row| row.parts / first).sum()
    }
}

/// Diameters below the last one by rounding still count.
const ROUNDING: f64 = 1e-9;
/// The most dressings of one worm.
const MOST_DRESSINGS: f64 = 1e5;

impl WormLife {
    /// Of the worm of `bodies`, whose addendum it keeps.
    ///
    /// # Errors
    /// `OutOfRange`; those of a worm that is too small for its threads.
    pub fn rows(&self, bodies: &Bodies) -> Result<Life, TechnologyError> {
        for (field, value) in [
            ("life.radial_per_dressing", self.radial_per_dressing),
            ("life.last_tip_diameter", self.last_tip_diameter),
            ("life.cutting_speed_m_per_s", self.cutting_speed),
            ("life.largest_worm_speed_rpm", 60.0 * self.largest_worm_speed),
            ("life.largest_work_speed_rpm", 60.0 * self.largest_work_speed),
            ("life.allowed_Vw", self.allowed),
            ("life.zone_width", self.zone_width),
            ("life.section_per_part", self.section_per_part),
        ] {
            positive(field, value)?;
        }
        let span = self.first_tip_diameter - self.last_tip_diameter;
        let least = format!(">= last_tip_diameter = {}", self.last_tip_diameter);
        in_range("life.first_tip_diameter", self.first_tip_diameter, span >= 0.0, &least)?;
        let dressings = ((span + ROUNDING) / (2.0 * self.radial_per_dressing)).floor();
        let many = format!("at most {MOST_DRESSINGS} dressings, here {dressings}");
        in_range("life.radial_per_dressing", self.radial_per_dressing, dressings < MOST_DRESSINGS, &many)?;
        let diameters = (0..=dressings as usize)
            .map(|k| self.first_tip_diameter - 2.0 * k as f64 * self.radial_per_dressing);
        let rows = diameters.map(|diameter| self.row(bodies, diameter)).collect::<Result<_, _>>()?;
        Ok(Life { rows })
    }

    fn row(&self, bodies: &Bodies, tip_diameter: f64) -> Result<LifeRow, TechnologyError> {
        let bodies = with_tip_diameter(bodies, tip_diameter)?;
        let [threads, teeth] = [bodies.threads(), bodies.teeth()];
        let wanted = 1e3 * self.cutting_speed / (PI * tip_diameter);
        let worm_speed = wanted.min(self.largest_worm_speed).min(self.largest_work_speed * teeth / threads);
        let wear_factor = bodies.largest(Flank::BOTH.into_iter(), |engagement, w| engagement.wear_factor(w));
        Ok(LifeRow {
            tip_diameter,
            worm_speed,
            cutting_speed: 1e-3 * PI * tip_diameter * worm_speed,
            crossed_axes_angle: bodies.pair.chain.crossed_axes_angle,
            work_speed: worm_speed * threads / teeth,
            wear_factor,
            parts: self.allowed * self.zone_width / (wear_factor * self.section_per_part),
        })
    }
}

/// The same workpiece with the same worm at another tip diameter, its addendum and the gap of the pitch planes kept.
fn with_tip_diameter(bodies: &Bodies, tip_diameter: f64) -> Result<Bodies, TechnologyError> {
    let (worm, work) = (&bodies.pair.worm, &bodies.pair.work);
    let GearData { teeth, pressure_angle, helix_angle, profile_shift, .. } = *worm.data();
    let addendum = bodies.worm_tip_radius - worm.pitch_radius();
    let pitch_radius = 0.5 * tip_diameter - addendum;
    let gap = bodies.pair.chain.centre_distance - worm.pitch_radius() - work.pitch_radius();
    let choice = WormChoice {
        threads: teeth,
        hand: helix_angle.signum(),
        pitch_diameter: Some(2.0 * pitch_radius),
        tip_diameter: Some(tip_diameter),
        pressure_angle: Some(pressure_angle.left),
        profile_shift,
        cone_angle: 0.0,
    };
    let made = worm_for_gear(work, &choice)?;
    let chain = GeneratingChain {
        centre_distance: pitch_radius + work.pitch_radius() + gap,
        crossed_axes_angle: made.crossed_axes_angle,
        ..bodies.pair.chain
    };
    let made: Gear = made.worm;
    let pair = Pair::new(made, *work, chain)?;
    Bodies::new(
        pair,
        0.5 * tip_diameter,
        bodies.face_width,
        bodies.flanks.map(|_, engagement| engagement.roll),
    )
}
