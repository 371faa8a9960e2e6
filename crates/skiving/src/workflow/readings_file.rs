//! A file of readings, for what is wrong with them.

use job::Diagnostic;

/// A file of readings, for what is wrong with them.
pub(super) struct ReadingsFile<'a> {
    /// Its name.
    pub name: &'a str,
    /// The key of the job that names it; none where the command does.
    pub key: Option<&'static str>,
}

impl ReadingsFile<'_> {
    /// A finding with the file's name in front, on its key.
    pub fn named(&self, finding: Diagnostic) -> Diagnostic {
        let message = format!("{}: {}", self.name, finding.message);
        Diagnostic { message: message.into(), field: self.key.map(Into::into), ..finding }
    }
}
