//! What the title block of a report takes from a job, and from where.

use crate::diagnostic::{Diagnostic, Problem};
use crate::document::Document;

/// A machine that a job names twice: by its description and in words.
pub fn machine_named_twice(document: &Document) -> Option<Diagnostic> {
    let (name, _) = document.root().follow("job.machine_name")?;
    let (file, _) = document.root().follow("machine.file")?;
    let finding = Diagnostic::new(
        Problem::InvalidJob,
        format!("the job names its machine twice: `machine.file` is {}", file.shown()),
    );
    Some(
        finding
            .field("job.machine_name")
            .value(name.shown())
            .allowed("a name where the job has no `machine.file`")
            .way_out("delete job.machine_name: the report takes the name in the machine's description")
            .span(Some(name.span.clone())),
    )
}
