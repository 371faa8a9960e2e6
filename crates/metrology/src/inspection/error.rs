//! What keeps measured values from being judged: one variant per meaning, with its data, a stable code and a way out
//! (`docs/mathematics/inspection.md`).

use foundation::geometry::{Flank, GeometryError};
use thiserror::Error;

/// Errors of the evaluation of measurements. Lengths and deviations mm, angles rad inside; um and degrees in messages.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum InspectionError {
    /// The gear is impossible, or a measure that the gear does not have.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// A number that is not finite or outside the range that has a meaning.
    #[error("{field} = {value} is not usable; allowed: {allowed}")]
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
    EmptyRange {
        /// Where it begins, mm.
        from: f64,
        /// Where it ends, mm.
        to: f64,
    },
    /// A line needs more samples than the range holds.
    #[error("{found} samples between {from:.4} and {to:.4} mm; at least {needed} are needed")]
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
    DuplicateTrace {
        /// Where, mm.
        position: f64,
    },
    /// The lower limit of a band lies above its upper limit.
    #[error("the band is crossed at {at} mm: lower limit {:.3} um, upper limit {:.3} um", lower * 1e3, upper * 1e3)]
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
    UnverifiedSetting {
        /// The setting in words.
        setting: &'static str,
    },
    /// The file does not tell something without which nothing can be evaluated.
    #[error("{setting} is not stated")]
    NotStated {
        /// What, in words.
        setting: &'static str,
    },
    /// The single pitch deviations of a flank do not add up to nothing.
    #[error("the pitch deviations add up to {:.3} um; allowed: {:.3} um", sum * 1e3, allowed * 1e3)]
    PitchNotClosed {
        /// Their sum, mm.
        sum: f64,
        /// Largest magnitude allowed, mm.
        allowed: f64,
    },
    /// Pitch deviations of some teeth are missing.
    #[error("pitch deviations of {found} teeth; the gear has {teeth}")]
    PitchIncomplete {
        /// Teeth with a value.
        found: usize,
        /// Teeth of the gear.
        teeth: usize,
    },
    /// Too few teeth for a judgement of the pitch.
    #[error("{found} teeth; at least {needed} are needed")]
    TooFewTeeth {
        /// Teeth found.
        found: usize,
        /// Teeth needed.
        needed: usize,
    },
    /// The standard gives no tolerance for this gear.
    #[error("{name} = {value} is outside the range of ISO 1328-1, {from} to {to}")]
    OutOfStandardRange {
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
    TooFewParts {
        /// Parts found.
        found: usize,
        /// Parts needed.
        needed: usize,
    },
}

impl InspectionError {
    /// Stable kebab-case code.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Geometry(error) => error.code(),
            Self::InvalidNumber { .. } => "invalid-number",
            Self::WrongCount { .. } => "wrong-count",
            Self::EmptyRange { .. } => "empty-range",
            Self::TooFewSamples { .. } => "too-few-samples",
            Self::TraceIncomplete { .. } => "trace-incomplete",
            Self::DuplicateTrace { .. } => "duplicate-trace",
            Self::BandCrossed { .. } => "band-crossed",
            Self::BelowBaseCircle { .. } => "below-base-circle",
            Self::UnverifiedSetting { .. } => "unverified-setting",
            Self::NotStated { .. } => "not-stated",
            Self::PitchNotClosed { .. } => "pitch-not-closed",
            Self::PitchIncomplete { .. } => "pitch-incomplete",
            Self::TooFewTeeth { .. } => "too-few-teeth",
            Self::OutOfStandardRange { .. } => "out-of-standard-range",
            Self::TooFewParts { .. } => "too-few-parts",
        }
    }

    /// What the user can do about it, in one sentence.
    pub fn way_out(&self) -> &'static str {
        match self {
            Self::Geometry(error) => error.way_out(),
            Self::InvalidNumber { .. } => "give a finite value inside the allowed range",
            Self::WrongCount { .. } => "give as many values as needed",
            Self::EmptyRange { .. } => "let the evaluation range begin before it ends",
            Self::TooFewSamples { .. } => "measure with more points or evaluate a longer range",
            Self::TraceIncomplete { .. } => {
                "measure the whole range or shorten the evaluation range to the trace"
            }
            Self::DuplicateTrace { .. } => "measure the traces at different places",
            Self::BandCrossed { .. } => "exchange or correct the limits of the band there",
            Self::BelowBaseCircle { .. } => {
                "raise the diameter above the base circle, or check the gear data"
            }
            Self::UnverifiedSetting { .. } => "measure again with a setting that is verified",
            Self::NotStated { .. } => {
                "export the file with its complete header; lengths of slopes can be stated (`--helix-slope-over`, `--profile-slope-over`), ranges come with a job (`--job`)"
            }
            Self::PitchNotClosed { .. } => {
                "check that all teeth of one revolution are in the table, each once"
            }
            Self::PitchIncomplete { .. } => "measure the pitch of all teeth of the flank",
            Self::TooFewTeeth { .. } => "judge the teeth one by one",
            Self::OutOfStandardRange { .. } => "agree upon tolerances for this gear: none are extrapolated",
            Self::TooFewParts { .. } => "measure more parts",
        }
    }
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
