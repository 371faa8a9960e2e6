//! Errors of a machine, a pose or a rule asked of it (`docs/mathematics/generating-contact.md#machine-chains`).

use finding::Finding;
use std::borrow::Cow;
use thiserror::Error;

/// Why a description is no machine.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("`{field}` of the machine: {problem}")]
pub struct InvalidMachine {
    /// Key of the description, e.g. `axes.X1.direction`.
    pub field: String,
    /// What is wrong with it.
    pub problem: String,
    /// What is allowed.
    pub allowed: String,
}

/// Why a machine cannot take up a pose.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum MachineError {
    /// A number that is not finite.
    #[error("{field} = {value} is not usable; allowed: a finite number")]
    #[finding(code = "invalid-number")]
    #[way_out("give a finite number")]
    InvalidNumber {
        /// Name of the quantity.
        field: String,
        /// Its value.
        value: f64,
    },
    /// A matrix that is no rotation.
    #[error(
        "the rotation of the pose is off a right-handed orthonormal one by {deviation:.3e}; allowed: 1e-9"
    )]
    #[finding(code = "invalid-pose")]
    #[way_out("give a rotation with at least ten correct digits")]
    InvalidPose {
        /// Largest deviation of an entry of R^T R from the unit matrix, or of the determinant from 1.
        deviation: f64,
    },
    /// Two axes of the machine do the same.
    #[error("{} do the same in this pose ({measure:.3e} from it): their positions are not determined", axes.join(" and "))]
    #[finding(code = "machine-singular")]
    #[way_out("take another angle between tool and counterpart axis")]
    Singular {
        /// Names of the axes that lose their difference.
        axes: Vec<String>,
        /// How far from it: sine of an angle, or a determinant.
        measure: f64,
    },
    /// Dresser and worm axis are parallel: the worm angle is free.
    #[error("dresser and worm axis are parallel: the swivel does not determine the angle of {axis}")]
    #[finding(code = "pole-of-chart")]
    #[way_out("give the worm angle wanted, or prescribe the axial slide instead of the swivel")]
    PoleOfChart {
        /// Axis of the worm.
        axis: String,
    },
    /// The machine lacks an axis or a limb.
    #[error("the machine {machine} has no {role} axis")]
    #[finding(code = "missing-axis")]
    #[way_out(with = another_machine(role))]
    MissingAxis {
        /// Name of the machine.
        machine: String,
        /// Role of the axis.
        role: &'static str,
    },
    /// More or fewer axes are free than a pose determines.
    #[error("{free} axes are free, a pose determines {determined}: {}", axes.join(", "))]
    #[finding(code = "axes-not-determined")]
    #[way_out(with = if free > determined { "fix the surplus axes by a rule" } else { "take a machine with more axes" })]
    NotDetermined {
        /// Axes that are free.
        free: usize,
        /// Axes that a pose determines.
        determined: usize,
        /// Their names.
        axes: Vec<String>,
    },
    /// No position of the axes gives the pose.
    #[error(
        "{what} cannot be reached: wanted {wanted:.6} {unit}, this machine reaches {least:.6} .. {greatest:.6} {unit} in this pose"
    )]
    #[finding(code = "unreachable")]
    #[way_out("take a value inside the range, or leave the axis free")]
    Unreachable {
        /// What cannot be reached: an axis under a rule, or the direction of the tool.
        what: String,
        /// Wanted value.
        wanted: f64,
        /// Least value that is reached.
        least: f64,
        /// Greatest value that is reached.
        greatest: f64,
        /// Unit of the three.
        unit: &'static str,
    },
    /// The iteration found no position of the axes that gives the pose.
    #[error("no position of the axes gives this pose: {starts} starts left at least {residual:.3e}")]
    #[finding(code = "unreachable")]
    #[way_out("look whether the directions of the axes span this pose, or take another machine")]
    NoSolution {
        /// Starts that were tried.
        starts: usize,
        /// Least residual: rad, and mm/100.
        residual: f64,
    },
    /// No solution stands within the travel of the machine.
    #[error(
        "{axis} = {value:.4} {unit} would stand {excess:.4} {unit} beyond its travel {from:.4} .. {to:.4}"
    )]
    #[finding(code = "axis-limit")]
    #[way_out(
        "bring the way within the travel: move the zero of {axis} or where the body is clamped, take a smaller body (a narrower worm shortens the shift) or another machine"
    )]
    AxisLimit {
        /// Name of the axis.
        axis: String,
        /// Its position, deg or mm.
        value: f64,
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

/// What helps where the machine lacks an axis.
fn another_machine(role: &str) -> Cow<'static, str> {
    match role {
        "swivel" => "leave the swivel at 0, or take a machine that has the axis".into(),
        _ => format!("take a machine whose description has a {role} axis").into(),
    }
}
