//! Why a combination of a study is refused.

use generating::GeneratingError;
use job::Diagnostic;
use run::RunFailure;
use schemars::JsonSchema;
use serde::Serialize;

/// Why a combination is not allowed or has no figures.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Refused {
    /// Stable code.
    pub code: &'static str,
    /// Why.
    pub text: String,
    /// What would help.
    pub way_out: String,
}

impl From<&GeneratingError> for Refused {
    fn from(error: &GeneratingError) -> Self {
        Self { code: error.code(), text: error.to_string(), way_out: error.way_out().into() }
    }
}

impl From<&Diagnostic> for Refused {
    fn from(finding: &Diagnostic) -> Self {
        let way_out = finding.way_out.as_deref().unwrap_or_default().to_string();
        Self { code: finding.code, text: finding.message.to_string(), way_out }
    }
}

impl From<RunFailure> for Refused {
    fn from(failure: RunFailure) -> Self {
        match &failure {
            RunFailure::BadInput(finding) | RunFailure::NotProducible(finding) => Self::from(&**finding),
        }
    }
}
