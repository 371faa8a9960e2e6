//! Errors of a pose or a rule asked of a machine (`docs/mathematics/generating-contact.md#machine-chains`).

use finding::Finding;
use thiserror::Error;

/// Why a machine cannot take up a pose.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum MachineError {
    /// A number that is not finite.
    #[error("{field} = {value} is not usable; allowed: a finite number")]
    #[finding(code = "invalid-number")]
    #[way_out("give a finite number")]
    InvalidNumber {
        /// Name of the quantity.
        field: &'static str,
        /// Its value.
        value: f64,
    },
    /// The axis that closes the system cannot have the wanted value in this pose.
    #[error("{axis} = {value} cannot be reached; allowed in this pose: {least} .. {greatest}")]
    #[finding(code = "unreachable")]
    #[way_out("take a value inside the range, or leave the axis free")]
    Unreachable {
        /// Name of the axis.
        axis: &'static str,
        /// Wanted value, deg or mm.
        value: f64,
        /// Least value that some solution has, deg or mm.
        least: f64,
        /// Greatest value that some solution has, deg or mm.
        greatest: f64,
    },
    /// Two axes of the machine do the same.
    #[error(
        "the tilted head stands across the bed (tilt {tilt_deg:.4} deg): its shift and the axial slide do the same"
    )]
    #[finding(code = "machine-singular")]
    #[way_out("tilt the head by less than 90 degrees")]
    Singular {
        /// Tilt, deg.
        tilt_deg: f64,
    },
    /// Dresser and worm axis are parallel: the worm angle is free.
    #[error("dresser and worm axis are parallel: the swivel does not determine the worm angle")]
    #[finding(code = "pole-of-chart")]
    #[way_out("give the worm angle wanted, or prescribe the axial slide instead of the swivel")]
    PoleOfChart,
    /// The machine has no axis of this role.
    #[error("the machine has no {role} axis")]
    #[finding(code = "missing-axis")]
    #[way_out("leave the swivel at 0, or take a machine that has the axis")]
    MissingAxis {
        /// Role of the axis.
        role: &'static str,
    },
    /// No solution stands within the travel of the machine.
    #[error("{axis} would stand {excess:.4} {unit} beyond its travel {from:.4} .. {to:.4}")]
    #[finding(code = "axis-limit")]
    #[way_out("leave branch and swivel free, move the zero of the axis, or take a smaller worm or dresser")]
    AxisLimit {
        /// Name of the axis.
        axis: &'static str,
        /// How far beyond, deg or mm.
        excess: f64,
        /// "deg" or "mm".
        unit: &'static str,
        /// Lower end of the travel.
        from: f64,
        /// Upper end of the travel.
        to: f64,
    },
}
