//! Why results cannot be written.

use job::CsvError;
use report::charts::ChartError;
use scene::mesh::MeshError;
use std::path::PathBuf;
use thiserror::Error;

/// Why the files of a run could not be written.
#[derive(Debug, Error)]
pub enum WriteError {
    /// The directory or a file cannot be written.
    #[error("cannot write {path}: {source}")]
    Io {
        /// Where.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// Another run writes into the folder and does not come to an end.
    #[error("another run is writing into {path}")]
    Busy {
        /// The folder.
        path: PathBuf,
    },
    /// A table holds a value that is no number.
    #[error(transparent)]
    Table(#[from] CsvError),
    /// A chart cannot be drawn.
    #[error("the report cannot be drawn: {0}")]
    Chart(#[from] ChartError),
    /// A body cannot be written as a mesh.
    #[error("the mesh cannot be written: {0}")]
    Mesh(#[from] MeshError),
    /// The result cannot be written as JSON.
    #[error("the result cannot be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
}
