//! What a job asks to be written and this version does not write.

use job::tables::{Output, Table};
use verdict::Remark;

/// Parquet tables, which come with a later version.
pub fn parquet_warning(tables: &[Table]) -> Option<Remark> {
    let wanted = tables.contains(&Table::Parquet);
    wanted.then(|| not_written("parquet-not-written", "Parquet tables", "\"parquet\" in output.tables"))
}

fn not_written(code: &'static str, what: &str, key: &str) -> Remark {
    Remark {
        code,
        text: format!("{what} are not written by this version"),
        way_out: format!("take the tables in motions/*.csv, or leave {key} out"),
    }
}

/// Formats and machines that the job asks for and that come with later versions.
pub fn output_warnings(output: &Output, machine: bool) -> Vec<Remark> {
    let mut warnings = Vec::new();
    if !output.meshes.is_empty() {
        warnings.push(not_written("meshes-not-written", "meshes", "output.meshes"));
    }
    warnings.extend(parquet_warning(&output.tables));
    if !output.programs.is_empty() && !machine {
        warnings.push(Remark {
            code: "programs-without-machine",
            text: "no NC programs are written: the job names no machine".into(),
            way_out: "add [machine] with `file = \"machines/....toml\"`, or leave output.programs out".into(),
        });
    }
    warnings
}
