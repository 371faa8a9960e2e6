//! `[output]`: what to write beside result and report.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What to write beside result and report; all lists may be empty.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Output {
    /// Language of the report; default English.
    #[serde(default, skip_serializing_if = "Language::is_default")]
    pub language: Language,
    /// Dialects of the axis programs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("uniqueItems" = true))]
    pub programs: Vec<Program>,
    /// Whether programs are written although the target is missed or could not be judged; their first lines say so. Default false.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub programs_of_missed: bool,
    /// Formats of bodies and flanks.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("uniqueItems" = true))]
    pub meshes: Vec<Mesh>,
    /// Formats of tables.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("uniqueItems" = true))]
    pub tables: Vec<Table>,
}

/// Language of the report.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Language {
    /// English.
    #[default]
    En,
    /// German.
    De,
}

impl Language {
    /// Whether it is the default, which is not written.
    pub fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

/// Dialect of an axis program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Program {
    /// LinuxCNC.
    Linuxcnc,
    /// Siemens.
    Siemens,
    /// Fanuc.
    Fanuc,
}

/// Format of a body or flank.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Mesh {
    /// Triangles, binary.
    Stl,
    /// Triangles with units.
    #[serde(rename = "3mf")]
    ThreeMf,
    /// Grids with values.
    Vtk,
}

/// Format of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Table {
    /// Comma-separated text.
    Csv,
    /// Apache Parquet.
    Parquet,
}
