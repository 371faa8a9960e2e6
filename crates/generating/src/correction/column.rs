//! Points of both flanks and what a unit of one setting does there.

use super::{CorrectionError, Setting};
use crate::FlankLines;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::MotionLaw;

/// A measured point of one tooth flank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlankPoint {
    /// Flank of the workpiece.
    pub flank: Flank,
    /// Length of roll, mm.
    pub w: f64,
    /// Axial position, mm.
    pub z: f64,
}

/// Effect of a unit of one setting on f_n2 at all points.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name of the setting.
    pub name: String,
    /// The setting, where it is one of grinding.
    pub setting: Option<Setting>,
    /// df_n2 per unit (mm per mm, rad or 1) at every point.
    pub values: Vec<f64>,
}

/// Column of anything that changes the worm by `change(flank, w_1, z_1)` = df_n1 per unit (mm), as dressing does, at diagonal motion
/// z_V1 = `shift`(z_V2): the gear flank changes by the opposite.
///
/// # Errors
/// [`CorrectionError::InvalidNumber`] where the change is not finite.
pub fn worm_column(
    name: &str,
    lines: &Sides<FlankLines>,
    shift: &MotionLaw,
    points: &[FlankPoint],
    change: impl Fn(Flank, f64, f64) -> f64,
) -> Result<Column, CorrectionError> {
    let at = |p: &FlankPoint| {
        let (w_1, z_1) = lines[p.flank].worm_point(p.w, p.z, shift);
        let value = -change(p.flank, w_1, z_1);
        let (name, allowed) = ("change of the worm", "finite numbers");
        if value.is_finite() {
            Ok(value)
        } else {
            Err(CorrectionError::InvalidNumber { name, value, allowed })
        }
    };
    let values = points.iter().map(at).collect::<Result<_, _>>()?;
    Ok(Column { name: name.into(), setting: None, values })
}
