//! Job files: documents with the place of every value, their JSON schema, the tables that jobs of several processes share, machines,
//! tables and writing. Knows the trait [`ProcessJob`] and no process: each brings its own job.

mod any;
pub mod bounded;
mod calendar;
pub mod checks;
mod contradiction;
pub mod control;
pub mod csv;
pub mod decimal_comma;
pub mod degrees;
mod diagnostic;
mod document;
mod files;
mod form;
mod format;
mod grid_file;
mod job_error;
mod job_format;
pub mod json_tree;
mod load;
pub mod machine;
mod node;
mod process_job;
mod profile_file;
mod read_source;
mod schema;
pub mod shape;
mod source;
pub mod table_rows;
pub mod tables;
pub mod testing;
mod toml_tree;
mod typed;
pub mod xml;

pub use any::{AnyJob, Loaded};
pub use bounded::{Unread, open_regular, read_bounded};
pub use csv::{Cell, Column, CsvError, CsvTable};
pub use diagnostic::{Diagnostic, Problem};
pub use document::Document;
pub use files::write_atomically;
pub use format::JobFormats;
pub use grid_file::{
    GridTarget, Layout, Row, TableForm, parse_grid_target, parse_points, parse_rows, parse_tolerances,
    parse_traces, read_grid_target, read_points, read_tolerances, read_traces, table_form,
};
pub use job_error::JobError;
pub use job_format::JobFormat;
pub use load::{parse_job_of, read_job_of};
pub use node::{Entry, Kind, Node, shown_number};
pub use process_job::ProcessJob;
pub use profile_file::{parse_profile, read_profile};
pub use read_source::MAXIMUM_BYTES;
pub use schema::schema_of;
pub use source::Source;
