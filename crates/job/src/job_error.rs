//! All that is wrong with one input file, in the order of its text.

use super::diagnostic::Diagnostic;
use super::source::Source;
use std::fmt;

/// All findings about one input file, never empty.
#[derive(Clone, Debug, PartialEq)]
pub struct JobError {
    /// The file and, where it could be read, its text.
    pub source: Source,
    /// The findings in the order of the text; at most [`JobError::MAXIMUM_FINDINGS`].
    pub diagnostics: Vec<Diagnostic>,
    /// Findings beyond that number.
    pub omitted: usize,
}

impl JobError {
    /// Of millions of wrong keys in a file the first hundred are reported.
    pub const MAXIMUM_FINDINGS: usize = 100;

    /// Collects findings about a file, sorted by their place in the text.
    pub fn new(source: Source, mut diagnostics: Vec<Diagnostic>) -> Self {
        diagnostics.sort_by_key(|d| d.span.as_ref().map_or(usize::MAX, |span| span.start));
        let omitted = diagnostics.len().saturating_sub(Self::MAXIMUM_FINDINGS);
        diagnostics.truncate(Self::MAXIMUM_FINDINGS);
        Self { source, diagnostics, omitted }
    }

    /// A single finding about a file.
    pub fn single(source: Source, diagnostic: Diagnostic) -> Self {
        Self::new(source, vec![diagnostic])
    }
}

impl fmt::Display for JobError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, diagnostic) in self.diagnostics.iter().enumerate() {
            if i > 0 {
                writeln!(f)?;
            }
            f.write_str(self.source.name())?;
            if let Some(span) = &diagnostic.span {
                let (line, column) = self.source.line_column(span.start);
                write!(f, ":{line}:{column}")?;
            }
            write!(f, ": {diagnostic}")?;
        }
        if self.omitted > 0 {
            write!(f, "\nand {} more", self.omitted)?;
        }
        Ok(())
    }
}

impl std::error::Error for JobError {}
