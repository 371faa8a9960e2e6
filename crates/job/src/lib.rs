//! Files of jobs: documents of every process with the place of every value, their JSON schema, machines, catalogues, tables, meshes.
//! Reads and writes files; knows the shapes and targets that a job describes, but neither plans nor reports anything.

pub mod bounded;
pub mod catalogue;
mod checks;
pub mod control;
pub mod csv;
pub mod decimal_comma;
mod degrees;
mod diagnostic;
mod document;
mod files;
mod form;
pub mod gearbox_job;
mod grid_file;
pub mod job;
mod json_tree;
mod load;
pub mod machine;
pub mod mesh;
pub mod milling_job;
mod node;
mod reference_train;
mod schema;
mod shape;
pub mod skiving_history;
pub mod skiving_job;
mod skiving_readings;
mod source;
pub mod table_rows;
pub mod tangential_job;
mod template;
#[cfg(test)]
mod told;
mod toml_tree;

pub use bounded::open_regular;
pub use csv::{Cell, Column, CsvError, CsvTable};
pub use diagnostic::{Diagnostic, JobError, Problem};
pub use document::Document;
pub use files::write_atomically;
pub use gearbox_job::GearboxJob;
pub use grid_file::{
    GridTarget, TableForm, parse_grid_target, parse_points, parse_tolerances, parse_traces, read_grid_target,
    read_points, read_tolerances, read_traces, table_form,
};
pub use job::Job;
pub use load::{
    AnyJob, Loaded, LoadedGearboxJob, LoadedJob, LoadedMillingJob, LoadedSkivingJob, LoadedTangentialJob,
    parse_any_job, parse_job, read_any_job, read_job,
};
pub use milling_job::MillingJob;
pub use reference_train::{ReferenceTrain, parse_reference_train, read_reference_train};
pub use schema::job_schema;
pub use skiving_job::SkivingJob;
pub use skiving_readings::{parse_skiving_readings, read_skiving_readings, readings_table};
pub use source::{MAXIMUM_BYTES, Source};
pub use tangential_job::TangentialJob;
pub use template::job_template;
