//! Example jobs, commented key by key, for `flankwright new`.

use super::job::Process;

/// A runnable job of the process with a comment on every key.
pub fn job_template(process: Process) -> &'static str {
    match process {
        Process::GeneratingGrinding => include_str!("template/generating-grinding.toml"),
        Process::TangentialDressing => include_str!("template/tangential-dressing.toml"),
        Process::ElectronicGearbox => include_str!("template/electronic-gearbox.toml"),
        Process::FiveAxisMilling => include_str!("template/five-axis-milling.toml"),
        Process::SkivingToolMeasuring => include_str!("template/skiving-tool-measuring.toml"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{AnyJob, Source, job_schema, parse_any_job, schema};

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
                    // A table within a table may stand for itself.
                    let told = [format!("{key} = "), format!("[{name}.{key}]")];
                    assert!(told.iter().any(|t| template.contains(t)), "{process:?} [{name}] {key}");
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
                "root_clearance" => "pitch_diameter",
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

    /// The template with one line in place of another.
    fn with_line(template: &str, from: &str, to: &str) -> String {
        template.lines().map(|line| if line == from { to } else { line }.to_owned() + "\n").collect()
    }

    #[test]
    fn every_optional_key_of_the_gearbox_is_valid() {
        let template = job_template(Process::ElectronicGearbox);
        let (tables, explore) = template.split_at(template.find("# [explore]").unwrap());
        let list = &tables[tables.find("motion = [").unwrap()..tables.find("# start").unwrap()];
        let train = "reference_ticks = [100, 260, 420]\nreference_signs = [1, 1, -1]\n";
        let mut keys = 0;
        for line in tables.lines().filter(|line| line.starts_with("# ")) {
            let entry = &line[2..];
            let Some((key, _)) = entry.split_once(" = ").filter(|(key, _)| !key.contains(' ')) else {
                continue;
            };
            keys += 1;
            let text = with_line(tables, line, entry);
            let text = match key {
                "gains" => text.replace("\nbandwidth_hz", "\n# bandwidth_hz"),
                "references" => text.replace(list, ""),
                "tolerance_um" => text.replace("# [target]", "[target]"),
                "last_tick" => text.replace(list, train),
                "reference_ticks" | "reference_signs" => {
                    tables.replace(list, "").replace("# reference_", "reference_")
                }
                _ => text,
            };
            let read = parse_any_job(Source::new("new.toml", &(text + explore)));
            assert!(read.is_ok(), "{key}: {}", read.unwrap_err());
        }
        assert!(keys > 15, "{keys}");
        let explore: String =
            explore.lines().map(|line| line.strip_prefix("# ").unwrap_or(line).to_owned() + "\n").collect();
        let text = tables.to_owned() + &explore;
        parse_any_job(Source::new("new.toml", &text)).unwrap_or_else(|error| panic!("{error}"));
    }

    #[test]
    fn the_control_of_a_job_is_valid() {
        let of_grinding = job_template(Process::GeneratingGrinding);
        let feed = "# feed_per_revolution = 0.3";
        let of_tangential = job_template(Process::TangentialDressing).replace(feed, &feed[2..]);
        for template in [of_grinding, &of_tangential] {
            control_is_valid(template);
        }
    }

    fn control_is_valid(template: &str) {
        let from = template.find("# [control]").unwrap();
        let to = from + template[from..].find("\n\n").unwrap();
        let control: String =
            template[from..to].lines().map(|line| line.trim_start_matches("# ").to_owned() + "\n").collect();
        let text = template[..from].to_owned() + &control + &template[to..];
        let read = parse_any_job(Source::new("new.toml", &text));
        let control_of = |job: AnyJob| match job {
            AnyJob::Grinding(loaded) => loaded.job.control,
            AnyJob::Tangential(loaded) => loaded.job.control,
            other => panic!("{:?}", other.info().process),
        };
        let control = control_of(read.unwrap_or_else(|error| panic!("{error}")));
        assert!(control.is_some());
        // What the template calls defaults is what stands in for them.
        let short = text.replace(
            ", clock_hz = 1e6, pulses_per_interval = 16, mode = \"no-backlash\", counter_limit = 16777215",
            "",
        );
        assert_ne!(short, text);
        let short = parse_any_job(Source::new("new.toml", &short)).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(control_of(short), control);
    }
}
