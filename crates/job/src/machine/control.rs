//! `[controls]`: what a machine's control understands.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The controls of a machine, by dialect.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Controls {
    /// LinuxCNC.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub linuxcnc: Option<Control>,
    /// Siemens 840D.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub siemens: Option<Control>,
    /// Fanuc 30i.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fanuc: Option<Control>,
}

/// How the rotations of tool and workpiece are kept together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ControlCoupling {
    /// All axes are interpolated: one straight block holds every linear coupling.
    #[default]
    Blocks,
    /// The control's electronic gearbox leads the workpiece.
    Gearbox,
}

/// One control of a machine.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Control {
    /// What programs call an axis, where it is not its `letter`: a letter, a name, "spindle 0", or "none" for an axis that
    /// programs cannot move.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub words: BTreeMap<String, String>,
    /// How the rotations of tool and workpiece are kept together; default by blocks.
    #[serde(default)]
    pub coupling: ControlCoupling,
    /// Axes that the electronic gearbox can take as leading ones; default all.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("maxItems" = 12))]
    pub leaders: Vec<String>,
    /// Whether the control counts rotary axes modulo 360 degrees: they are then moved by steps below one turn.
    #[serde(default)]
    pub modulo: bool,
    /// Number after O of the dressing program, Fanuc only; the grinding program has the next one; default 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1, "maximum" = 99_999_998, "x-way-out" = "write a number of up to eight digits"))]
    pub program_number: Option<u32>,
    /// Whether programs switch the contour mode on, Fanuc only.
    #[serde(default)]
    pub contour_mode: bool,
    /// Following error at which the guard of the gearbox opens, degrees, LinuxCNC only; default 0.5.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 360, "x-way-out" = "give an angle in degrees, e.g. 0.5"))]
    pub following_error_deg: Option<f64>,
    /// Digits behind the point; default 6 for mm, 7 for degrees, 6 for the feed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub decimals: Option<Decimals>,
    /// Largest deviation of the flank that a straight block in place of a curve may leave, um; default 0.05.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10, "x-way-out" = "give a tolerance in micrometres, e.g. 0.05"))]
    pub chord_tolerance_um: Option<f64>,
}

/// Digits behind the point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Decimals {
    /// Of lengths.
    #[schemars(extend("minimum" = 3, "maximum" = 9, "x-way-out" = "write 3 to 9 digits"))]
    pub mm: u8,
    /// Of angles.
    #[schemars(extend("minimum" = 3, "maximum" = 9, "x-way-out" = "write 3 to 9 digits"))]
    pub deg: u8,
    /// Of the feed.
    #[schemars(extend("minimum" = 6, "maximum" = 9, "x-way-out" = "write 6 to 9 digits"))]
    pub feed: u8,
}
