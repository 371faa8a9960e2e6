//! Why a pair of worm and dresser does not make a target: one variant a reason, each with its data, a stable code and a way out.

use crate::DressingError;
use finding::Finding;
use foundation::geometry::Flank;
use thiserror::Error;

/// A reason against a pair. Lengths mm, angles deg.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum Refusal {
    /// The bodies do not stand together or no correction makes the profile.
    #[error(transparent)]
    #[finding(transparent)]
    Dressing(#[from] DressingError),
    /// A correction is beyond its range.
    #[error("{axis} = {value:.4} {unit} on the {flank} flank exceeds its limit {limit} {unit}")]
    #[finding(code = "axis-limit")]
    #[way_out(
        "take a worm whose diameter and threads are nearer to those the dresser was designed for, or a dresser with more of the crowning in it"
    )]
    AxisLimit {
        /// Flank concerned.
        flank: Flank,
        /// Symbol of the correction.
        axis: &'static str,
        /// Value needed.
        value: f64,
        /// Limit.
        limit: f64,
        /// Unit.
        unit: &'static str,
    },
    /// The profile would be stretched too far.
    #[error("the profile of the {flank} flank is stretched by P = {stretch:.5}, beyond {limit}")]
    #[finding(code = "stretch-limit")]
    #[way_out(
        "take a worm of another profile angle or a diameter nearer to the one the dresser was designed for"
    )]
    Stretch {
        /// Flank concerned.
        flank: Flank,
        /// P.
        stretch: f64,
        /// Limit of |P|.
        limit: f64,
    },
    /// The dressed profile is too far from the wanted one.
    #[error(
        "the {flank} flank misses the wanted profile by {error_um:.3} um between the pitch points, more than {allowed_um} um"
    )]
    #[finding(code = "profile-error")]
    #[way_out(
        "take a dresser that carries more of the crowning, a smaller dresser or a worm with fewer threads"
    )]
    ProfileError {
        /// Flank concerned.
        flank: Flank,
        /// Largest distance, um.
        error_um: f64,
        /// Tolerance, um.
        allowed_um: f64,
    },
    /// The contact needs radii of the dresser at which it has no profile.
    #[error(
        "the {flank} flank needs the dresser's profile between radii {from:.3} and {to:.3} mm; it has {has_from:.3} to \
         {has_to:.3} mm"
    )]
    #[finding(code = "dresser-flank-too-short")]
    #[way_out("take a dresser with a longer flank or one designed for this worm")]
    FlankTooShort {
        /// Flank concerned.
        flank: Flank,
        /// Smallest radius needed.
        from: f64,
        /// Largest radius needed.
        to: f64,
        /// Smallest radius there is.
        has_from: f64,
        /// Largest radius there is.
        has_to: f64,
    },
    /// The tip land does not fit between the flanks of the thread space.
    #[error(
        "dressing the {flank} flank a tip land of {needed} mm touches the opposite flank; {}",
        largest.map_or_else(|| "no land is narrow enough".to_owned(), |b| format!("at most {b:.4} mm fit"))
    )]
    #[finding(code = "tip-land")]
    #[way_out("take a dresser with a narrower tip land")]
    TipLand {
        /// Flank concerned.
        flank: Flank,
        /// Largest land, if there is one.
        largest: Option<f64>,
        /// Land needed.
        needed: f64,
    },
    /// Dressing the worm in its present state cuts into the worn worm that remains later.
    #[error(
        "dressing the {flank} flank cuts {cut:.4} mm into the worm of {pitch_diameter:.3} mm pitch diameter at z = {b:.1} mm"
    )]
    #[finding(code = "undermined")]
    #[way_out("end the life of the worm at a larger diameter, or take a dresser with a narrower tip land")]
    Undermined {
        /// Flank concerned.
        flank: Flank,
        /// Depth of the cut.
        cut: f64,
        /// Pitch diameter of the later worm.
        pitch_diameter: f64,
        /// Where along the worm.
        b: f64,
    },
}
