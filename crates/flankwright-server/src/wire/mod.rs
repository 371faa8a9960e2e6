//! What goes over the wire, as the interface document describes it. Knows how to tell a finding, and nothing of how it came about.

mod failure;
mod handed_in;
mod inspect_options;
mod job;
mod run;

pub use failure::{Failure, Finding, refused_run, unshelved, wrong_option};
pub use handed_in::HandedIn;
pub use inspect_options::{Asked, InspectOptions};
pub use job::{
    About, CatalogueAnswer, CheckAnswer, Edit, EditAnswer, EditRequest, ExampleAnswer, ExampleSummary, Job,
    MachineSummary, PreviewAnswer, PreviewRequest, ProcessSummary, ProgramRequest, Queue, Step,
    TemplateAnswer,
};
pub use run::{Advance, Chart, ListedRun, NewRunRequest, Request, Run, RunBegun, RunFile, RunStateAnswer};
