//! The template of every process: a valid job, with every key of the format in it, and what stands behind a mark is valid too.

use flankwright::exchange::{
    AnyJob, GearboxJob, Job, ProcessJob, Source, TangentialJob, job_schema, parse_any_job,
};
use flankwright::processes;

#[test]
fn templates_are_valid_jobs() {
    for format in processes().formats().formats() {
        let job = parse_any_job(Source::new("new.toml", format.template));
        assert_eq!(job.map(|job| job.info().process.name().to_owned()), Ok(format.name.to_owned()));
    }
}

#[test]
fn every_key_of_the_format_is_mentioned() {
    let schema = job_schema();
    let properties = |referring: &serde_json::Value| {
        let pointer = referring["$ref"].as_str().unwrap().trim_start_matches('#');
        schema.pointer(pointer).unwrap()["properties"].as_object().unwrap()
    };
    let formats = processes().formats();
    for (place, format) in formats.formats().iter().enumerate() {
        let (template, process) = (format.template, format.name);
        for (name, table) in properties(formats.tables(place)) {
            assert!(template.contains(&format!("[{name}]")), "{process} [{name}]");
            for key in properties(table).keys() {
                // A table within a table may stand for itself.
                let told = [format!("{key} = "), format!("[{name}.{key}]")];
                assert!(told.iter().any(|t| template.contains(t)), "{process} [{name}] {key}");
            }
        }
    }
}

#[test]
fn what_is_behind_a_mark_is_valid_as_well() {
    // The settings, and keys that stand for each other's alternatives, are taken in one after the other.
    let template = TangentialJob::TEMPLATE;
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
    let mut table = "";
    for line in jobs.lines() {
        // Keys of a table behind a mark come with it.
        let Some(entry) = line.strip_prefix("# ") else {
            table = "";
            continue;
        };
        if entry.starts_with('[') {
            table = entry;
        }
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
                if l == line && key == "designed_for" {
                    // Such a dresser is not made for the target.
                    format!("{entry}\nmodification = \"none\"")
                } else if l == line {
                    format!("{table}\n{entry}")
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
    let template = GearboxJob::TEMPLATE;
    let (tables, optional) = template.split_at(template.find("# [errors]").unwrap());
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
        let read = parse_any_job(Source::new("new.toml", &(text + optional)));
        assert!(read.is_ok(), "{key}: {}", read.unwrap_err());
    }
    assert!(keys > 15, "{keys}");
    // Reference pulses come from a scale or from a ball screw.
    for other in ["scale = ", "ball_screw = "] {
        let plain = optional.lines().map(|line| line.strip_prefix("# ").unwrap_or(line));
        let optional: String =
            plain.filter(|line| !line.starts_with(other)).map(|line| line.to_owned() + "\n").collect();
        assert!(optional.contains("[errors]") && optional.contains("split_trace = "));
        let text = tables.to_owned() + &optional;
        parse_any_job(Source::new("new.toml", &text)).unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn the_control_of_a_job_is_valid() {
    let of_grinding = Job::TEMPLATE;
    let feed = "# feed_per_revolution = 0.3";
    let of_tangential = TangentialJob::TEMPLATE.replace(feed, &feed[2..]);
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
    let control_of = |job: AnyJob| match job.of::<Job>() {
        Some(loaded) => loaded.job.control.clone(),
        None => job.of::<TangentialJob>().expect("a job of tangential dressing").job.control.clone(),
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

#[test]
fn every_process_has_its_closed_set_of_tables() {
    let (schema, formats) = (job_schema(), processes().formats());
    for (place, format) in formats.formats().iter().enumerate() {
        let pointer = formats.tables(place)["$ref"].as_str().unwrap().trim_start_matches('#');
        let tables = schema.pointer(pointer).unwrap();
        assert_eq!(tables["additionalProperties"], false, "{}", format.name);
        assert_eq!(tables["properties"]["job"]["$ref"], "#/$defs/JobInfo", "{}", format.name);
    }
    assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    assert_eq!(schema["required"], serde_json::json!(["job"]));
    assert_eq!(schema["allOf"].as_array().unwrap().len(), formats.formats().len());
    assert!(!schema.to_string().contains("\"null\""));
}

#[test]
fn ranges_stand_beside_their_keys() {
    let gear = &job_schema()["$defs"]["Gear"]["properties"];
    assert_eq!(gear["normal_module"]["exclusiveMinimum"], 0);
    assert_eq!(gear["teeth"]["not"]["const"], 0);
    assert_eq!(gear["form_diameter"]["type"], "number");
}

#[test]
fn processes_do_not_know_the_keys_of_others() {
    let text = Job::TEMPLATE.replacen("[gear]", "[gear]\ndouble_helical = { gap = 4.0 }", 1);
    let error = parse_any_job(Source::new("job.toml", &text)).unwrap_err();
    let unknown = |d: &flankwright::exchange::Diagnostic| {
        d.code == "unknown-key" && d.field.as_deref() == Some("gear.double_helical")
    };
    assert!(error.diagnostics.iter().any(unknown), "{error}");
}
