//! A skiving tool and its workpiece on crossed axes, or a shaping cutter on a parallel one: distances, coupling, direction of cutting
//! (`docs/mathematics/skiving.md#tool-and-workpiece`).

use super::{SkivedFlank, SkivingError};
use foundation::geometry::{Flank, Gear, Helicoid, SkivingTool};
use foundation::kinematics::SkivingMotion;
use std::f64::consts::PI;

/// How tool and workpiece move.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kinematics {
    /// Crossed axes: the turning tool cuts along its edge's way through the space.
    #[default]
    Skiving,
    /// Parallel axes: the tool cuts along its axis, stroke by stroke, turned along its own helix, while both roll.
    Shaping,
}

/// Setting of the machine.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PairData {
    /// z_V1: offset of the tool's datum face from the common normal, mm.
    pub tool_shift: f64,
    /// d with sign, mm; `None`: r_1 + s_I r_2.
    pub centre_distance: Option<f64>,
    /// gamma, rad; `None`: -(beta_1 + s_I beta_2).
    pub crossed_axes_angle: Option<f64>,
    /// How both move.
    pub kinematics: Kinematics,
}

/// A tool, its workpiece and their motion.
#[derive(Clone, Debug)]
pub struct SkivingPair {
    tool: SkivingTool,
    gear: Gear,
    motion: SkivingMotion,
    kinematics: Kinematics,
}

/// Below this sine the axes count as parallel (`docs/mathematics/skiving.md#limits`).
const PARALLEL: f64 = 1e-6;

impl SkivingPair {
    /// A pair at its nominal or a given setting.
    ///
    /// # Errors
    /// [`SkivingError::InvalidNumber`], [`SkivingError::AxesParallel`], [`SkivingError::AxesCrossed`] of a shaping cutter,
    /// [`SkivingError::InvalidCentreDistance`].
    pub fn new(tool: SkivingTool, gear: Gear, data: PairData) -> Result<Self, SkivingError> {
        check_gear(&gear)?;
        let sign = f64::from(gear.data().teeth.signum());
        let distance =
            data.centre_distance.unwrap_or_else(|| tool.pitch_radius() + sign * gear.pitch_radius());
        let angle =
            data.crossed_axes_angle.unwrap_or_else(|| -(tool.helix_angle() + sign * gear.data().helix_angle));
        for (field, value) in [
            ("tool_shift", data.tool_shift),
            ("centre_distance", distance),
            ("crossed_axes_angle_deg", angle.to_degrees()),
        ] {
            if !value.is_finite() {
                return Err(SkivingError::InvalidNumber { field, value, allowed: "a finite number" });
            }
        }
        let angle = match (data.kinematics, angle.sin().abs() < PARALLEL) {
            (Kinematics::Skiving, true) => return Err(SkivingError::AxesParallel { angle }),
            (Kinematics::Shaping, false) => {
                let [tool, work] = [tool.helix_angle(), gear.data().helix_angle];
                return Err(SkivingError::AxesCrossed { angle, tool, needed: -sign * work });
            }
            (Kinematics::Skiving, false) => angle,
            (Kinematics::Shaping, true) => 0.0,
        };
        if distance * sign <= 0.0 {
            return Err(SkivingError::InvalidCentreDistance { value: distance, internal: sign < 0.0 });
        }
        let motion = SkivingMotion {
            centre_distance: distance,
            crossed_axes_angle: angle,
            tool_shift: data.tool_shift,
            ratio: -f64::from(tool.teeth()) / f64::from(gear.data().teeth),
            tool_angle: data.tool_shift * tool.twist(),
            work_angle: if sign > 0.0 { PI } else { 0.0 },
            twist: gear.flank(Flank::Left).twist_per_length(),
        };
        Ok(Self { tool, gear, motion, kinematics: data.kinematics })
    }

    /// How both move.
    pub fn kinematics(&self) -> Kinematics {
        self.kinematics
    }

    /// The tool.
    pub fn tool(&self) -> &SkivingTool {
        &self.tool
    }

    /// The workpiece.
    pub fn gear(&self) -> &Gear {
        &self.gear
    }

    /// Their motion.
    pub fn motion(&self) -> &SkivingMotion {
        &self.motion
    }

    /// The same pair with another tool of as many teeth: sharp, or worn.
    ///
    /// # Errors
    /// [`SkivingError::InvalidNumber`] for another number of teeth.
    pub fn with_tool(&self, tool: SkivingTool) -> Result<Self, SkivingError> {
        if tool.teeth() != self.tool.teeth() {
            let (field, value) = ("tool.teeth", f64::from(tool.teeth()));
            return Err(SkivingError::InvalidNumber {
                field,
                value,
                allowed: "that of the tool it replaces",
            });
        }
        Ok(Self { tool, ..self.clone() })
    }

    /// A flank of the workpiece between two radii, mm, in any order.
    ///
    /// # Errors
    /// [`SkivingError::Geometry`] below the base circle, [`SkivingError::InvalidNumber`].
    pub fn flank_between(&self, flank: Flank, radii: [f64; 2]) -> Result<SkivedFlank, SkivingError> {
        let helicoid = Helicoid::new(&self.gear, flank);
        let roll = |radius: f64| helicoid.length_of_roll(radius).map_err(SkivingError::Geometry);
        let [a, b] = [roll(radii[0])?, roll(radii[1])?];
        SkivedFlank::new(helicoid, [a.min(b), a.max(b)])
    }
}

/// Ranges of `docs/mathematics/skiving.md#limits`.
fn check_gear(gear: &Gear) -> Result<(), SkivingError> {
    let data = gear.data();
    let wrong = |field, value: f64, allowed| Err(SkivingError::InvalidNumber { field, value, allowed });
    if data.teeth.abs() < 3 {
        return wrong("teeth", f64::from(data.teeth), "at least 3, negative for internal gears");
    }
    for (_, angle) in data.pressure_angle.iter() {
        if !(angle.to_degrees() > 0.0 && angle.to_degrees() < 45.0) {
            return wrong("normal_pressure_angle_deg", angle.to_degrees(), "between 0 and 45 deg");
        }
    }
    if data.helix_angle.to_degrees().abs() >= 60.0 {
        return wrong("helix_angle_deg", data.helix_angle.to_degrees(), "between -60 and 60 deg");
    }
    if data.cone_angle != 0.0 {
        return wrong(
            "cone_angle_deg",
            data.cone_angle.to_degrees(),
            "0: only cylindrical gears are skived here",
        );
    }
    Ok(())
}
