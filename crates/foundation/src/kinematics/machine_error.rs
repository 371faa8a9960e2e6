//! Errors of a pose or a rule asked of a machine (`docs/mathematics/generating-contact.md#machine-chains`).

use thiserror::Error;

/// Why a machine cannot take up a pose.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum MachineError {
    /// A number that is not finite.
    #[error("{field} = {value} is not usable; allowed: a finite number")]
    InvalidNumber {
        /// Name of the quantity.
        field: &'static str,
        /// Its value.
        value: f64,
    },
    /// The axis that closes the system cannot have the wanted value in this pose.
    #[error("{axis} = {value} cannot be reached; allowed in this pose: {least} .. {greatest}")]
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
    Singular {
        /// Tilt, deg.
        tilt_deg: f64,
    },
    /// Dresser and worm axis are parallel: the worm angle is free.
    #[error("dresser and worm axis are parallel: the swivel does not determine the worm angle")]
    PoleOfChart,
    /// The machine has no axis of this role.
    #[error("the machine has no {role} axis")]
    MissingAxis {
        /// Role of the axis.
        role: &'static str,
    },
    /// No solution stands within the travel of the machine.
    #[error("{axis} would stand {excess:.4} {unit} beyond its travel {from:.4} .. {to:.4}")]
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

impl MachineError {
    /// Stable kebab-case code.
    pub fn code(&self) -> &'static str {
        match self {
            Self::InvalidNumber { .. } => "invalid-number",
            Self::Unreachable { .. } => "unreachable",
            Self::Singular { .. } => "machine-singular",
            Self::PoleOfChart => "pole-of-chart",
            Self::MissingAxis { .. } => "missing-axis",
            Self::AxisLimit { .. } => "axis-limit",
        }
    }

    /// What the user can do about it, in one sentence.
    pub fn way_out(&self) -> &'static str {
        match self {
            Self::InvalidNumber { .. } => "give a finite number",
            Self::Unreachable { .. } => "take a value inside the range, or leave the axis free",
            Self::Singular { .. } => "tilt the head by less than 90 degrees",
            Self::PoleOfChart => {
                "give the worm angle wanted, or prescribe the axial slide instead of the swivel"
            }
            Self::MissingAxis { .. } => "leave the swivel at 0, or take a machine that has the axis",
            Self::AxisLimit { .. } => {
                "leave branch and swivel free, move the zero of the axis, or take a smaller worm or dresser"
            }
        }
    }
}
