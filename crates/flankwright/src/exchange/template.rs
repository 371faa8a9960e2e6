//! Example jobs, commented key by key, for `flankwright new`.

use super::job::Process;

/// A runnable job of the process with a comment on every key.
pub fn job_template(process: Process) -> &'static str {
    match process {
        Process::GeneratingGrinding => include_str!("template/generating-grinding.toml"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exchange::{Source, job_schema, parse_job};

    #[test]
    fn templates_are_valid_jobs() {
        for process in Process::ALL {
            let job = parse_job(Source::new("new.toml", job_template(process)));
            assert_eq!(job.map(|loaded| loaded.job.job.process), Ok(process));
        }
    }

    #[test]
    fn every_key_of_the_format_is_mentioned() {
        let schema = job_schema();
        let template = job_template(Process::GeneratingGrinding);
        for (name, table) in schema["properties"].as_object().unwrap() {
            let pointer = table["$ref"].as_str().unwrap().trim_start_matches('#');
            assert!(template.contains(&format!("[{name}]")), "[{name}]");
            for key in schema.pointer(pointer).unwrap()["properties"].as_object().unwrap().keys() {
                assert!(template.contains(&format!("{key} = ")), "[{name}] {key}");
            }
        }
    }
}
