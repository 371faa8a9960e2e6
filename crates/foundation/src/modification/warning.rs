//! What is accepted but looks unintended.

use std::fmt;

/// A remark on a valid modification.
#[derive(Clone, Debug, PartialEq)]
pub enum ModificationWarning {
    /// A relief reaches over the whole field and beyond.
    ReliefLongerThanField {
        /// Kind of the modification.
        kind: String,
        /// Key of the length.
        key: String,
        /// Length of the relief, mm.
        length: f64,
        /// Length of the field in that direction, mm.
        field_length: f64,
    },
    /// The field reaches far beyond the outermost trace.
    OutsideTraces {
        /// Kind of the modification.
        kind: String,
        /// Length of roll beyond the outermost trace, mm.
        beyond: f64,
        /// Length of the field in that direction, mm.
        field_length: f64,
    },
    /// A rounded start was asked for, but only straight reliefs (exponent 1) have one.
    TransitionWithoutEffect {
        /// Kind of the modification.
        kind: String,
        /// Exponent of the relief.
        exponent: f64,
    },
}

impl ModificationWarning {
    /// Stable kebab-case name of the remark.
    pub fn code(&self) -> &'static str {
        match self {
            Self::ReliefLongerThanField { .. } => "relief-longer-than-field",
            Self::OutsideTraces { .. } => "outside-traces",
            Self::TransitionWithoutEffect { .. } => "transition-without-effect",
        }
    }
}

impl fmt::Display for ModificationWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ReliefLongerThanField { kind, key, length, field_length } => {
                write!(
                    f,
                    "{kind}: {key} is {length} mm, longer than the evaluation field ({field_length} mm)"
                )
            }
            Self::OutsideTraces { kind, beyond, field_length } => {
                write!(
                    f,
                    "{kind}: the evaluation field ({field_length} mm) reaches {beyond} mm beyond the outermost trace; there the \
                     traces are continued, not known"
                )
            }
            Self::TransitionWithoutEffect { kind, exponent } => {
                write!(
                    f,
                    "{kind}: the transition has no effect with exponent {exponent} (only with exponent 1)"
                )
            }
        }
    }
}
