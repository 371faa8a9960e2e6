//! Example jobs, commented key by key, for `flankwright new`.

use super::job::Process;

/// A runnable job of the process with a comment on every key.
pub fn job_template(process: Process) -> &'static str {
    match process {
        Process::GeneratingGrinding => include_str!("template/generating-grinding.toml"),
        Process::TangentialDressing => include_str!("template/tangential-dressing.toml"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exchange::{Source, job_schema, parse_any_job, schema};

    #[test]
    fn templates_are_valid_jobs() {
        for process in Process::ALL {
            let job = parse_any_job(Source::new("new.toml", job_template(process)));
            assert_eq!(job.map(|job| job.info().process), Ok(process));
        }
    }

    #[test]
    fn every_key_of_the_format_is_mentioned() {
        let schema = job_schema();
        let properties = |referring: &serde_json::Value| {
            let pointer = referring["$ref"].as_str().unwrap().trim_start_matches('#');
            schema.pointer(pointer).unwrap()["properties"].as_object().unwrap()
        };
        for process in Process::ALL {
            let template = job_template(process);
            for (name, table) in properties(schema::of_process(process)) {
                assert!(template.contains(&format!("[{name}]")), "{process:?} [{name}]");
                for key in properties(table).keys() {
                    assert!(template.contains(&format!("{key} = ")), "{process:?} [{name}] {key}");
                }
            }
        }
    }

    #[test]
    fn what_is_behind_a_mark_is_valid_as_well() {
        // The settings, and keys that stand for each other's alternatives, are taken in one after the other.
        let template = job_template(Process::TangentialDressing);
        let plain = |text: &str| {
            text.lines()
                .map(|line| {
                    line.strip_prefix("# ")
                        .filter(|rest| rest.contains(" = ") || rest.starts_with('['))
                        .unwrap_or(line)
                })
                .map(|line| line.to_owned() + "\n")
                .collect::<String>()
        };
        let (jobs, settings) = template.split_at(template.find("# [settings]").unwrap());
        let text = format!("{jobs}{}", plain(settings));
        parse_any_job(Source::new("new.toml", &text)).unwrap_or_else(|error| panic!("{error}"));
        for line in jobs.lines().filter(|line| line.starts_with("# ")) {
            let entry = &line[2..];
            let Some((key, _)) = entry.split_once(" = ").filter(|(key, _)| !key.contains(' ')) else {
                continue;
            };
            let other = ["normal_tooth_thickness", "span", "over_balls"].contains(&key);
            let removed = match key {
                "modifications" => "edge_amounts",
                _ if other => "profile_shift",
                _ => key,
            };
            let text: String = jobs
                .lines()
                .map(|l| {
                    if l == line {
                        entry.to_owned()
                    } else if l.starts_with(&format!("{removed} = ")) {
                        String::new()
                    } else {
                        l.to_owned()
                    }
                })
                .map(|l| l + "\n")
                .collect();
            let read = parse_any_job(Source::new("new.toml", &text));
            assert!(read.is_ok(), "{key}: {}", read.unwrap_err());
        }
    }
}
