//! Errors of tangential dressing (`docs/mathematics/tangential-dressing.md#limits`), each with its data, a stable code and a way out.

use contact::ContactError;
use dressing::DressingError;
use finding::Finding;
use foundation::geometry::{Flank, GeometryError};
use thiserror::Error;

/// What a dresser needs that ends before the contact; mm, rounded up to the next hundredth.
fn deeper_or_larger(s: f64, from: f64, to: f64) -> String {
    let up = |mm: f64| (mm * 100.0).ceil() / 100.0;
    if s < from {
        format!(
            "give the dresser a flank that reaches {:.2} mm below its pitch circle (`dresser.flank_depth`), or ask for less of the flank",
            up(-s)
        )
    } else {
        format!(
            "give the dresser a tip diameter larger by {:.2} mm, or ask for less of the flank",
            up(2.0 * (s - to))
        )
    }
}

/// What can go wrong in tangential dressing. Lengths mm.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum TangentialError {
    /// A body is impossible by itself.
    #[error(transparent)]
    #[finding(transparent, bad_input)]
    Geometry(#[from] GeometryError),
    /// Worm and gear do not work together.
    #[error(transparent)]
    #[finding(transparent, bad_input = matches!(_0, ContactError::Geometry(_) | ContactError::InvalidNumber { .. }))]
    Contact(#[from] ContactError),
    /// The worm has no conjugate dresser.
    #[error(transparent)]
    #[finding(transparent, bad_input = matches!(_0, DressingError::InvalidNumber { .. }))]
    Dressing(#[from] DressingError),
    /// A number that is not usable.
    #[error("{field} = {value} is not usable; allowed: {allowed}")]
    #[finding(code = "invalid-number", bad_input)]
    #[way_out("give a value inside the allowed range")]
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
    #[finding(code = "unknown-variable", bad_input)]
    #[way_out(
        "name a channel and its exponent, such as Fp1, Fz2, dX2, dA2, gA1, gam0, dist0, FC2, FT0, or kap"
    )]
    UnknownVariable {
        /// The name.
        name: String,
    },
    /// The flank would be ground by a part of the dresser that is not there.
    #[error(
        "the {flank} flank at radius {radius:.4} mm, z = {z:.4} mm needs the dresser at s = {s:.4} mm; it has {from:.4} to {to:.4} mm"
    )]
    #[finding(code = "outside-tool")]
    #[way_out("{}", deeper_or_larger(*s, *from, *to))]
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
    #[finding(code = "undercut")]
    #[way_out(
        "reduce the amount of the modification, raise the form diameter, or let other channels make it"
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
    #[finding(code = "contact-not-found")]
    #[way_out(
        "take smaller amounts, or let other channels make them; that the flank cannot be made is not shown"
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
    #[finding(code = "no-live-variable", bad_input)]
    #[way_out("free a variable that moves the flank, such as dX2, FC2 or Fp2")]
    NoLiveVariable {
        /// Free variables.
        count: usize,
    },
    /// Rounds ran out.
    #[error("no convergence after {rounds} rounds; best weighted rms {rms_um:.4} um")]
    #[finding(code = "not-converged")]
    #[way_out("step the target up, free fewer variables, or replace gam0 by dX1 and FC1")]
    NotConverged {
        /// Rounds made.
        rounds: usize,
        /// Weighted rms of the best variables.
        rms_um: f64,
        /// Those variables, in the order of the free ones: mm, rad.
        best: Vec<f64>,
    },
}
