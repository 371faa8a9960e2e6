//! What was decided, assumed or lost between REXS and the model of this program.

use serde::{Deserialize, Serialize};

/// Kinds of remarks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum RexsWarningKind {
    /// The file does not say what a positive amount means; > 0 removed was assumed.
    SignAssumed,
    /// Something that REXS has no place for is not in the file.
    Lost,
    /// A kind that REXS does not know was sampled into a topography.
    Sampled,
    /// A default stands in for what the file does not state.
    Assumed,
    /// Parts of the file state different evaluation ranges.
    RangesDiffer,
    /// An attribute or component that is not used; it is kept for rewriting.
    NotUsed,
    /// Another version of REXS than 2.0.
    Version,
}

impl RexsWarningKind {
    /// A stable name, for scripts.
    pub fn code(self) -> &'static str {
        match self {
            Self::SignAssumed => "sign-assumed",
            Self::Lost => "lost-in-rexs",
            Self::Sampled => "sampled-for-rexs",
            Self::Assumed => "assumed",
            Self::RangesDiffer => "ranges-differ",
            Self::NotUsed => "not-used",
            Self::Version => "rexs-version",
        }
    }
}

/// A remark.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct RexsWarning {
    /// Its kind.
    pub kind: RexsWarningKind,
    /// The case in one sentence.
    pub message: String,
}

impl RexsWarning {
    /// A remark.
    pub fn new(kind: RexsWarningKind, message: impl Into<String>) -> Self {
        Self { kind, message: message.into() }
    }
}

impl std::fmt::Display for RexsWarning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} [{}]", self.message, self.kind.code())
    }
}
