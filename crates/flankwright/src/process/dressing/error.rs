//! Errors of dressing (spec 30 section 18).

use crate::geometry::{Flank, GeometryError};
use crate::kinematics::MachineError;
use thiserror::Error;

/// What can go wrong between dresser and worm. Lengths mm.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum DressingError {
    /// A body is impossible by itself.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// The machine cannot take up the poses of a dressing motion.
    #[error(transparent)]
    Machine(#[from] MachineError),
    /// A number that is not usable.
    #[error("{field} = {value} is not usable; allowed: {allowed}")]
    InvalidNumber {
        /// Name of the quantity.
        field: &'static str,
        /// Its value.
        value: f64,
        /// Allowed range in words.
        allowed: &'static str,
    },
    /// The involute flank has no conjugate dresser in the design range.
    #[error("the {flank} flank has no conjugate dresser at length of roll {w:.4} mm")]
    NoConjugate {
        /// Flank concerned.
        flank: Flank,
        /// Length of roll.
        w: f64,
    },
    /// A circle of the dresser touches nothing.
    #[error("the dresser circle at profile parameter {t:.4} mm does not touch the {flank} flank of the worm")]
    NoContact {
        /// Flank concerned.
        flank: Flank,
        /// Profile parameter.
        t: f64,
    },
    /// The contact leaves the dresser's profile.
    #[error(
        "length of roll {w:.4} mm of the {flank} worm flank needs dresser profile outside [{from:.3}, {to:.3}] mm"
    )]
    OutOfDresser {
        /// Flank concerned.
        flank: Flank,
        /// Length of roll on the worm.
        w: f64,
        /// Profile from.
        from: f64,
        /// Profile to.
        to: f64,
    },
    /// Pitch points and additional conditions must be four, and differ.
    #[error(
        "{count} conditions were given for the four dressing corrections; needed: exactly 4 different ones"
    )]
    ConditionCount {
        /// How many there were.
        count: usize,
    },
    /// The conditions do not determine the corrections.
    #[error("the conditions do not determine the corrections (singular value ratio {ratio:.1e})")]
    Singular {
        /// sigma_4/sigma_1.
        ratio: f64,
    },
    /// No corrections fulfil the conditions.
    #[error("no dressing correction fulfils the conditions on the {flank} flank at v_zS = {v:.3} mm; reached {:.1} percent ({reason})", fraction * 100.0)]
    NoZero {
        /// Flank concerned.
        flank: Flank,
        /// Worm position.
        v: f64,
        /// Reached share of the target, 0..1.
        fraction: f64,
        /// Why it went no further.
        reason: &'static str,
    },
    /// A disc in point contact is not round enough for a hollow of the worm.
    #[error(
        "the {flank} worm flank is hollower at w = {w:.3} mm, z = {z:.3} mm than the dresser's tip radius {tip_radius} mm allows; there at most {largest:.4} mm"
    )]
    TipRadiusTooLarge {
        /// Flank concerned.
        flank: Flank,
        /// Length of roll.
        w: f64,
        /// Axial position.
        z: f64,
        /// Tip radius r_T.
        tip_radius: f64,
        /// Largest tip radius that touches in a point only.
        largest: f64,
    },
    /// A disc in point contact cuts where it must not.
    #[error(
        "dressing the {flank} worm flank at w = {w:.3} mm, z = {z:.3} mm, the disc cuts {depth:.4} mm into the {with} flank"
    )]
    DiscCollides {
        /// Flank that is dressed.
        flank: Flank,
        /// Length of roll of the contact.
        w: f64,
        /// Axial position of the contact.
        z: f64,
        /// Flank that is cut.
        with: Flank,
        /// Depth.
        depth: f64,
    },
    /// A disc in point contact cannot stand so that it touches a point.
    #[error("the disc cannot touch the {flank} worm flank at w = {w:.3} mm, z = {z:.3} mm")]
    DiscTouchesNot {
        /// Flank concerned.
        flank: Flank,
        /// Length of roll.
        w: f64,
        /// Axial position.
        z: f64,
    },
    /// The wanted worm surface has no value where a line passes.
    #[error(
        "the modification of the {flank} worm flank has no value at w = {w:.3} mm, z = {z:.3} mm, where a dressing line passes"
    )]
    SurfaceUndefined {
        /// Flank concerned.
        flank: Flank,
        /// Length of roll.
        w: f64,
        /// Axial position.
        z: f64,
    },
    /// The wanted worm surface is too rough for a smooth motion along a line.
    #[error(
        "the {flank} worm flank bends too sharply along the dressing line through w = {w:.3} mm, z = {z:.3} mm"
    )]
    LineTooRough {
        /// Flank concerned.
        flank: Flank,
        /// Length of roll of the line's middle.
        w: f64,
        /// Axial position of the line's middle.
        z: f64,
    },
    /// Crossing angle 0 in the K chart.
    #[error("at crossing angle 0 the dressing corrections are not unique")]
    PoleOfChart,
}

impl DressingError {
    /// Stable kebab-case code.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Geometry(e) => e.code(),
            Self::Machine(e) => e.code(),
            Self::InvalidNumber { .. } => "invalid-number",
            Self::NoConjugate { .. } => "no-conjugate",
            Self::NoContact { .. } => "no-contact",
            Self::OutOfDresser { .. } => "out-of-dresser",
            Self::ConditionCount { .. } => "condition-count",
            Self::Singular { .. } => "singular",
            Self::NoZero { .. } => "no-zero",
            Self::TipRadiusTooLarge { .. } => "tip-radius-too-large",
            Self::DiscCollides { .. } => "disc-collides",
            Self::DiscTouchesNot { .. } => "disc-touches-not",
            Self::SurfaceUndefined { .. } => "worm-surface-undefined",
            Self::LineTooRough { .. } => "dressing-line-too-rough",
            Self::PoleOfChart => "pole-of-chart",
        }
    }

    /// What the user can do about it, in one sentence.
    pub fn way_out(&self) -> &'static str {
        match self {
            Self::Geometry(e) => e.way_out(),
            Self::Machine(e) => e.way_out(),
            Self::InvalidNumber { .. } => "give a value inside the allowed range",
            Self::NoConjugate { .. } => "use a larger worm, fewer threads or a smaller dresser",
            Self::NoContact { .. } | Self::OutOfDresser { .. } => {
                "reduce the modification made by the dressing motion, or let the dresser's profile make it"
            }
            Self::ConditionCount { .. } => {
                "give four different conditions: pitch points, map rows, head rows or fixed axes"
            }
            Self::Singular { .. } => "replace one pitch point by a radius-map row or a fixed axis",
            Self::NoZero { .. } => {
                "reduce the amount, take a worm with more threads or smaller diameter, or let the dresser's profile make it"
            }
            Self::TipRadiusTooLarge { .. } => {
                "take a smaller tip radius, or spread the modification over a longer way"
            }
            Self::DiscCollides { .. } => "take a smaller tip radius or a smaller disc",
            Self::DiscTouchesNot { .. } => {
                "let the crossing angle follow the thread, or take a larger profile angle"
            }
            Self::SurfaceUndefined { .. } => "let the modification reach beyond the area that is dressed",
            Self::LineTooRough { .. } => "round off kinks of the modification, or lay the lines along them",
            Self::PoleOfChart => "use the tilt chart or a crossing angle other than 0",
        }
    }
}
