//! Examples of milling with some of their entries changed.

use job::{Source, parse_job_of};
use milling::job::LoadedMillingJob;
use std::path::Path;

/// An example with other things in it.
pub fn example(name: &str, changes: &[(&str, &str)]) -> LoadedMillingJob {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let file = root.join(format!("examples/milling/{name}.toml"));
    let mut text = std::fs::read_to_string(&file).unwrap();
    text = text.replace("../../machines", root.join("machines").to_str().unwrap());
    for (from, to) in changes {
        assert!(text.contains(from), "{name} has no {from}");
        text = text.replace(from, to);
    }
    parse_job_of(Source::new("job.toml", &text)).unwrap_or_else(|error| panic!("{error}"))
}
