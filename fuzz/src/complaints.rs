//! What is expected of every error: a code, a message and a way out, each with words in it, and a place inside the text.

use flankwright::exchange::JobError;

/// A code in kebab case, a message, a way out.
pub fn told_in_full(code: &str, message: &str, way_out: &str) {
    assert!(!code.is_empty(), "{message}: no code");
    assert!(code.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-'), "code {code:?}");
    assert!(!message.trim().is_empty(), "{code}: no message");
    assert!(!way_out.trim().is_empty(), "{code}: {message}: no way out");
}

/// Findings about a text.
fn of_text(error: &JobError) {
    assert!(!error.diagnostics.is_empty(), "an error without a finding");
    assert!(error.diagnostics.len() <= JobError::MAXIMUM_FINDINGS);
    let text = error.source.text();
    for finding in &error.diagnostics {
        told_in_full(finding.code, &finding.message, finding.way_out.as_deref().unwrap_or_default());
        if let Some(span) = &finding.span {
            assert!(span.start <= span.end && span.end <= text.len(), "{finding}: {span:?}");
            let (line, column) = error.source.line_column(span.start);
            assert!(line >= 1 && column >= 1);
        }
    }
    assert!(!error.to_string().is_empty());
}

/// What was read, or the checked complaint about it.
pub fn taken<T>(found: Result<T, JobError>) -> Option<T> {
    found.inspect_err(of_text).ok()
}
