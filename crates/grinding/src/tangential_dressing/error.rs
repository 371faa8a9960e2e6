//! Errors of tangential dressing (`docs/mathematics/tangential-dressing.md#limits`), each with its data, a stable code and a way out.

use crate::dressing::DressingError;
use contact::ContactError;
use foundation::geometry::{Flank, GeometryError};
use thiserror::Error;

/// What can go wrong in tangential dressing. Lengths mm.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum TangentialError {
    /// A body is impossible by itself.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// Worm and gear do not work together.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// The worm has no conjugate dresser.
    #[error(transparent)]
    Dressing(#[from] DressingError),
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
    /// A name that no design variable has.
    #[error("{name:?} is no design variable")]
    UnknownVariable {
        /// The name.
        name: String,
    },
    /// The flank would be ground by a part of the dresser that is not there.
    #[error(
        "the {flank} flank at radius {radius:.4} mm, z = {z:.4} mm needs the dresser at s = {s:.4} mm; it has {from:.4} to {to:.4} mm"
    )]
    OutsideTool {
        /// Flank concerned.
        flank: Flank,
        /// Radius on the gear.
        radius: f64,
        /// Axial position on the gear.
        z: f64,
        /// Height on the dresser over its pitch circle.
        s: f64,
        /// Lowest height of the dresser.
        from: f64,
        /// Largest height of the dresser.
        to: f64,
    },
    /// The envelope folds: the true surface lies deeper than it.
    #[error(
        "the envelope of the worm folds on the {flank} flank at radius {radius:.4} mm, z = {z:.4} mm (determinant ratio {ratio:.3}): the worm would gouge the flank there"
    )]
    Undercut {
        /// Flank concerned.
        flank: Flank,
        /// Radius on the gear.
        radius: f64,
        /// Axial position on the gear.
        z: f64,
        /// Last ratio of the determinants that a continuation reached.
        ratio: f64,
    },
    /// The search for the contact ends although the envelope is far from a fold.
    #[error(
        "the contact that grinds the {flank} flank at radius {radius:.4} mm, z = {z:.4} mm was not found: the search does not settle, although the envelope is far from folding there (determinant ratio {ratio:.3})"
    )]
    NotSettled {
        /// Flank concerned.
        flank: Flank,
        /// Radius on the gear.
        radius: f64,
        /// Axial position on the gear.
        z: f64,
        /// Ratio of the determinants where the search ended.
        ratio: f64,
    },
    /// None of the free variables moves the flank.
    #[error("none of the {count} free variables moves the flank")]
    NoLiveVariable {
        /// Free variables.
        count: usize,
    },
    /// Rounds ran out.
    #[error("no convergence after {rounds} rounds; best weighted rms {rms_um:.4} um")]
    NotConverged {
        /// Rounds made.
        rounds: usize,
        /// Weighted rms of the best variables.
        rms_um: f64,
        /// Those variables, in the order of the free ones: mm, rad.
        best: Vec<f64>,
    },
}

impl TangentialError {
    /// Stable kebab-case code.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Geometry(e) => e.code(),
            Self::Contact(e) => e.code(),
            Self::Dressing(e) => e.code(),
            Self::InvalidNumber { .. } => "invalid-number",
            Self::UnknownVariable { .. } => "unknown-variable",
            Self::OutsideTool { .. } => "outside-tool",
            Self::Undercut { .. } => "undercut",
            Self::NotSettled { .. } => "contact-not-found",
            Self::NoLiveVariable { .. } => "no-live-variable",
            Self::NotConverged { .. } => "not-converged",
        }
    }

    /// What the user can do about it, in one sentence.
    pub fn way_out(&self) -> &'static str {
        match self {
            Self::Geometry(e) => e.way_out(),
            Self::Contact(e) => e.way_out(),
            Self::Dressing(e) => e.way_out(),
            Self::InvalidNumber { .. } => "give a value inside the allowed range",
            Self::UnknownVariable { .. } => {
                "name a channel and its exponent, such as Fp1, Fz2, dX2, dA2, gA1, gam0, dist0, FC2, FT0, or kap"
            }
            Self::OutsideTool { .. } => {
                "give the dresser a larger tip diameter, the worm a larger one, or ask for less of the flank"
            }
            Self::Undercut { .. } => {
                "reduce the amount of the modification, raise the form diameter, or let other channels make it"
            }
            Self::NotSettled { .. } => {
                "take smaller amounts, or let other channels make them; that the flank cannot be made is not shown"
            }
            Self::NoLiveVariable { .. } => "free a variable that moves the flank, such as dX2, FC2 or Fp2",
            Self::NotConverged { .. } => {
                "step the target up, free fewer variables, or replace gam0 by dX1 and FC1"
            }
        }
    }

    /// Whether the input is wrong by itself, in distinction from a limit of the bodies.
    pub fn is_bad_input(&self) -> bool {
        matches!(
            self,
            Self::Geometry(_)
                | Self::InvalidNumber { .. }
                | Self::UnknownVariable { .. }
                | Self::NoLiveVariable { .. }
                | Self::Contact(ContactError::Geometry(_) | ContactError::InvalidNumber { .. })
                | Self::Dressing(DressingError::InvalidNumber { .. })
        )
    }
}
