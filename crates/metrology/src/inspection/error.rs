//! What keeps measured values from being judged: one variant per meaning, with its data, a stable code and a way out
//! (`docs/mathematics/inspection.md`).

use finding::Finding;
use foundation::geometry::{Flank, GeometryError};
use thiserror::Error;

/// Errors of the evaluation of measurements. Lengths and deviations mm, angles rad inside; um and degrees in messages.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum InspectionError {
    /// The gear is impossible, or a measure that the gear does not have.
    #[error(transparent)]
    #[finding(transparent)]
    Geometry(#[from] GeometryError),
    /// A number that is not finite or outside the range that has a meaning.
    #[error("{field} = {value} is not usable; allowed: {allowed}")]
    #[finding(code = "invalid-number")]
    #[way_out("give a finite value inside the allowed range")]
    InvalidNumber {
        /// Name of the quantity.
        field: &'static str,
        /// The offending value.
        value: f64,
        /// Allowed range in words.
        allowed: &'static str,
    },
    /// Lists that belong together have different lengths, or one is too short.
    #[error("{field}: {found} values, {needed} are needed")]
    #[finding(code = "wrong-count")]
    #[way_out("give as many values as needed")]
    WrongCount {
        /// Name of the list.
        field: &'static str,
        /// Values found.
        found: usize,
        /// Values needed.
        needed: usize,
    },
    /// The evaluation range has no length.
    #[error("the evaluation range from {from} to {to} mm is empty")]
    #[finding(code = "empty-range")]
    #[way_out("let the evaluation range begin before it ends")]
    EmptyRange {
        /// Where it begins, mm.
        from: f64,
        /// Where it ends, mm.
        to: f64,
    },
    /// A line needs more samples than the range holds.
    #[error("{found} samples between {from:.4} and {to:.4} mm; at least {needed} are needed")]
    #[finding(code = "too-few-samples")]
    #[way_out("measure with more points or evaluate a longer range")]
    TooFewSamples {
        /// Defined samples in the range.
        found: usize,
        /// Samples needed.
        needed: usize,
        /// Where the range begins, mm.
        from: f64,
        /// Where it ends, mm.
        to: f64,
    },
    /// The trace does not cover the range.
    #[error("the range from {from:.4} to {to:.4} mm has no samples between {gap_from:.4} and {gap_to:.4} mm")]
    #[finding(code = "trace-incomplete")]
    #[way_out("measure the whole range or shorten the evaluation range to the trace")]
    TraceIncomplete {
        /// Where the range begins, mm.
        from: f64,
        /// Where it ends, mm.
        to: f64,
        /// Where the gap begins, mm.
        gap_from: f64,
        /// Where it ends, mm.
        gap_to: f64,
    },
    /// Two traces of one kind lie at the same place.
    #[error("two traces at {position} mm: nothing follows from their difference")]
    #[finding(code = "duplicate-trace")]
    #[way_out("measure the traces at different places")]
    DuplicateTrace {
        /// Where, mm.
        position: f64,
    },
    /// The lower limit of a band lies above its upper limit.
    #[error("the band is crossed at {at} mm: lower limit {:.3} um, upper limit {:.3} um", lower * 1e3, upper * 1e3)]
    #[finding(code = "band-crossed")]
    #[way_out("exchange or correct the limits of the band there")]
    BandCrossed {
        /// Abscissa, mm.
        at: f64,
        /// Lower limit, mm.
        lower: f64,
        /// Upper limit, mm.
        upper: f64,
    },
    /// A diameter of an evaluation range lies below the base circle.
    #[error("diameter {diameter} mm lies below the base circle of the {flank} flank ({base_diameter} mm)")]
    #[finding(code = "below-base-circle")]
    #[way_out("raise the diameter above the base circle, or check the gear data")]
    BelowBaseCircle {
        /// Flank concerned.
        flank: Flank,
        /// Diameter asked for, mm.
        diameter: f64,
        /// Base diameter, mm.
        base_diameter: f64,
    },
    /// A setting of the measuring machine whose meaning is not verified: no value is better than a guess.
    #[error("{setting} is not verified: its values cannot be evaluated")]
    #[finding(code = "unverified-setting")]
    #[way_out("measure again with a setting that is verified")]
    UnverifiedSetting {
        /// The setting in words.
        setting: &'static str,
    },
    /// The file does not tell something without which nothing can be evaluated.
    #[error("{setting} is not stated")]
    #[finding(code = "not-stated")]
    #[way_out(
        "export the file with its complete header; lengths of slopes can be stated (`--helix-slope-over`, `--profile-slope-over`), ranges come with a job (`--job`)"
    )]
    NotStated {
        /// What, in words.
        setting: &'static str,
    },
    /// The single pitch deviations of a flank do not add up to nothing.
    #[error("the pitch deviations add up to {:.3} um; allowed: {:.3} um", sum * 1e3, allowed * 1e3)]
    #[finding(code = "pitch-not-closed")]
    #[way_out("check that all teeth of one revolution are in the table, each once")]
    PitchNotClosed {
        /// Their sum, mm.
        sum: f64,
        /// Largest magnitude allowed, mm.
        allowed: f64,
    },
    /// Pitch deviations of some teeth are missing.
    #[error("pitch deviations of {found} teeth; the gear has {teeth}")]
    #[finding(code = "pitch-incomplete")]
    #[way_out("measure the pitch of all teeth of the flank")]
    PitchIncomplete {
        /// Teeth with a value.
        found: usize,
        /// Teeth of the gear.
        teeth: usize,
    },
    /// Too few teeth for a judgement of the pitch.
    #[error("{found} teeth; at least {needed} are needed")]
    #[finding(code = "too-few-teeth")]
    #[way_out("judge the teeth one by one")]
    TooFewTeeth {
        /// Teeth found.
        found: usize,
        /// Teeth needed.
        needed: usize,
    },
    /// The standard gives no tolerance for this gear.
    #[error("{name} = {value} is outside the range of {standard}, {from} to {to}")]
    #[finding(code = "out-of-standard-range")]
    #[way_out("agree upon tolerances for this gear: none are extrapolated")]
    OutOfStandardRange {
        /// The standard.
        standard: &'static str,
        /// Name of the quantity, with its unit.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Least value of the standard.
        from: f64,
        /// Greatest value of the standard.
        to: f64,
    },
    /// Statistics need more parts.
    #[error("{found} parts; at least {needed} are needed")]
    #[finding(code = "too-few-parts")]
    #[way_out("measure more parts")]
    TooFewParts {
        /// Parts found.
        found: usize,
        /// Parts needed.
        needed: usize,
    },
}

/// The value, if it is finite and `good`.
pub(super) fn usable(
    field: &'static str,
    value: f64,
    good: bool,
    allowed: &'static str,
) -> Result<f64, InspectionError> {
    if value.is_finite() && good {
        Ok(value)
    } else {
        Err(InspectionError::InvalidNumber { field, value, allowed })
    }
}
