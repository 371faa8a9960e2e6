//! What a reader of evaluated values has to know beside them (`docs/mathematics/inspection.md`).

use std::fmt;

/// A reservation about a value that was computed all the same.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum InspectionWarning {
    /// Span and balls mean different tooth thicknesses.
    ThicknessInconsistent {
        /// Profile shift coefficient by the span.
        by_span: f64,
        /// Profile shift coefficient by the balls.
        by_balls: f64,
        /// Largest difference that the resolution of the two sizes explains.
        allowed: f64,
    },
    /// The sign rule of run-out from pitch is not verified for internal gears.
    RunOutOfInternalGear,
    /// A capability from few parts says little.
    FewParts {
        /// Parts.
        parts: usize,
    },
    /// A course over the parts: capability indices mean nothing then.
    TrendSignificant {
        /// Change from part to part, in the unit of the values.
        slope: f64,
        /// Probability of such a slope by chance.
        probability: f64,
    },
}

impl InspectionWarning {
    /// Stable kebab-case code.
    pub fn code(&self) -> &'static str {
        match self {
            Self::ThicknessInconsistent { .. } => "thickness-inconsistent",
            Self::RunOutOfInternalGear => "run-out-of-internal-gear",
            Self::FewParts { .. } => "few-parts",
            Self::TrendSignificant { .. } => "trend-significant",
        }
    }
}

impl fmt::Display for InspectionWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ThicknessInconsistent { by_span, by_balls, allowed } => write!(
                f,
                "span gives the profile shift {by_span:.5}, balls give {by_balls:.5}; they should agree within {allowed:.5}"
            ),
            Self::RunOutOfInternalGear => {
                f.write_str("run-out from the pitch of an internal gear: its sign is not verified")
            }
            Self::FewParts { parts } => write!(f, "{parts} parts only: capability needs at least 25"),
            Self::TrendSignificant { slope, probability } => write!(
                f,
                "the values drift by {slope:.3e} a part (probability by chance {probability:.1e}): capability means nothing then"
            ),
        }
    }
}
