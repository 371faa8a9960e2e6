//! `new`, `schema`, `check` and the help of every command.

use crate::command::{example, repository, run, run_with};
use flankwright::exchange::{Document, Source, parse_any_job};
use flankwright::processes;
use serde_json::{Value, json};

const EXAMPLES: [&str; 3] = ["automotive-bias.toml", "radial-feed-crowning.toml", "twist-free-crowning.toml"];

#[test]
fn every_command_has_help_with_an_example() {
    let help = run(&["--help"]);
    assert_eq!(help.exit, Some(0));
    let commands = help.stdout.split("Commands:").nth(1).and_then(|t| t.split("Options:").next()).unwrap();
    let names: Vec<&str> = commands
        .lines()
        .filter_map(|line| line.split_whitespace().next())
        .filter(|name| *name != "help")
        .collect();
    assert!(names.len() >= 3, "{names:?}");
    for name in names {
        let help = run(&[name, "--help"]);
        assert_eq!(help.exit, Some(0));
        assert!(
            help.stdout.contains("Example:") && help.stdout.contains(&format!("flankwright {name}")),
            "{help:?}"
        );
        for option in ["--json", "--quiet", "-o"] {
            assert!(help.stdout.contains(option), "{name} {option}");
        }
    }
    assert!(run(&["--version"]).stdout.starts_with("flankwright "));
}

#[test]
fn the_new_job_is_valid_in_both_formats() {
    let toml = run(&["new", "generating-grinding"]);
    let json = run(&["new", "generating-grinding", "--json"]);
    assert_eq!((toml.exit, json.exit), (Some(0), Some(0)));
    assert!(toml.stdout.contains('#'));
    let checked = [toml, json].map(|made| run_with(&["check", "-", "--json"], made.stdout.as_bytes()));
    for run in &checked {
        assert_eq!(run.exit, Some(0), "{run:?}");
    }
    assert_eq!(checked[0].json()["job"], checked[1].json()["job"]);
}

#[test]
fn new_and_schema_write_to_a_directory() {
    let directory = tempfile::tempdir().unwrap();
    let told = directory.path().join("made/here");
    let told = told.to_str().unwrap();
    for (arguments, file) in [
        (&["new", "generating-grinding", "-o", told][..], "generating-grinding.toml"),
        (&["new", "generating-grinding", "--json", "-o", told], "generating-grinding.json"),
        (&["schema", "-o", told], "job.schema.json"),
    ] {
        let made = run(arguments);
        assert_eq!((made.exit, made.stdout.as_str()), (Some(0), ""), "{made:?}");
        assert!(directory.path().join("made/here").join(file).is_file());
    }
    let blocked = directory.path().join("made/here/job.schema.json");
    let refused = run(&["schema", "--json", "-o", blocked.to_str().unwrap()]);
    assert_eq!(refused.exit, Some(2));
    assert_eq!(refused.json()["error"]["code"], "unwritable-file");
}

#[test]
fn the_schema_admits_the_examples_and_nothing_unknown() {
    let schema = run(&["schema"]);
    assert_eq!(schema.exit, Some(0));
    let schema = schema.json();
    assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    let validator = jsonschema::draft202012::new(&schema).expect("a valid schema");
    let job = |name: &str| run(&["check", "--json", &format!("examples/{name}")]).json()["job"].clone();
    for name in EXAMPLES {
        // `check` prints the job as read; with and without its defaults the schema admits it.
        assert!(
            validator.is_valid(&job(name)),
            "{name}: {:?}",
            validator.iter_errors(&job(name)).collect::<Vec<_>>()
        );
    }
    let change = |change: &dyn Fn(&mut Value)| {
        let mut job = job(EXAMPLES[2]);
        change(&mut job);
        job
    };
    let wrong = [
        change(&|job| job["gear"]["normal_modul"] = json!(3.5)),
        change(&|job| job["surplus"] = json!({})),
        change(&|job| job["gear"]["teeth"] = json!(0)),
        change(&|job| job["gear"]["normal_module"] = json!("3.5")),
        change(&|job| job["gear"]["normal_pressure_angle_deg"] = json!({ "left": 20 })),
        change(&|job| job["target"]["modifications"][0]["amount"] = json!(1)),
        change(&|job| job["target"]["modifications"][0]["kind"] = json!("bump")),
        change(&|job| job["worm"]["hand"] = json!("up")),
        change(&|job| job["gear"]["form_diameter"] = json!(null)),
        change(&|job| {
            job.as_object_mut().unwrap().remove("dresser");
        }),
        change(&|job| job["worm"]["tool"] = json!("made")),
        change(&|job| job["grinding"]["active_threads"] = json!([0, 0])),
    ];
    for job in wrong {
        assert!(!validator.is_valid(&job), "{job}");
        let text = job.to_string();
        assert_eq!(run_with(&["check", "-"], text.as_bytes()).exit, Some(2), "{text}");
    }
}

#[test]
fn the_schema_admits_every_template_and_tells_the_processes_apart() {
    let schema = run(&["schema"]).json();
    let validator = jsonschema::draft202012::new(&schema).expect("a valid schema");
    let errors = |job: &Value| validator.iter_errors(job).map(|e| e.to_string()).collect::<Vec<_>>();
    for format in processes().formats().formats() {
        let process = format.name;
        // As written and with all defaults.
        let template = Source::new("new.toml", format.template);
        let written = Document::parse(template).expect("a template").to_value();
        for job in [written, run(&["new", process, "--json"]).json()] {
            assert!(validator.is_valid(&job), "{process:?}: {:?}", errors(&job));
        }
    }
    let tangential = run(&["new", "tangential-dressing", "--json"]).json();
    let change = |change: &dyn Fn(&mut Value)| {
        let mut job = tangential.clone();
        change(&mut job);
        job
    };
    let right = [
        change(&|job| {
            job["target"]["edge_amounts"] = json!({ "left": {}, "right": { "lead_conical_um": 5 } })
        }),
        change(&|job| job["dressing"]["variables"] = json!(["Fp1", "FpL9", "dX0", "kap"])),
        change(&|job| job["settings"] = json!({ "left": { "values": { "dX2": 0.1, "FpR1": 0 } } })),
    ];
    for job in right {
        assert!(validator.is_valid(&job), "{job}: {:?}", errors(&job));
        assert!(parse_any_job(Source::new("job.json", &job.to_string())).is_ok(), "{job}");
    }
    let wrong = [
        change(&|job| job["surplus"] = json!({})),
        change(&|job| job["job"]["process"] = json!("generating-grinding")),
        change(&|job| job["job"]["process"] = json!("five-axis-milling")),
        change(&|job| job["job"].as_object_mut().unwrap().clear()),
        change(&|job| job["target"]["edge_amounts"] = json!({ "left": {} })),
        change(&|job| job["target"]["edge_amounts"] = json!({ "crowning_um": 1 })),
        change(&|job| job["dressing"]["variables"] = json!(["Fp0"])),
        change(&|job| job["dressing"]["variables"] = json!(["dX2", "dX2"])),
        change(&|job| job["dressing"]["variables"] = json!("all")),
        change(&|job| job["dressing"]["exclude"] = json!(["FpL"])),
        change(&|job| job["dressing"]["splines"] = json!([{ "channel": "kap", "intervals": 2 }])),
        change(&|job| job["grinding"]["shift_ratio"] = json!("auto")),
        change(&|job| job["settings"] = json!({ "left": { "values": { "kap": 0.1 } } })),
        change(&|job| job["settings"] = json!({ "left": { "values": { "dX10": 0.1 } } })),
        change(&|job| job["settings"] = json!({ "left": { "values": { "dX1": 1001 } } })),
    ];
    for job in wrong {
        assert!(!validator.is_valid(&job), "{job}");
        assert!(parse_any_job(Source::new("job.json", &job.to_string())).is_err(), "{job}");
    }
}

#[test]
fn json_jobs_equal_toml_jobs() {
    let directory = tempfile::tempdir().unwrap();
    for name in EXAMPLES {
        let toml = run(&["check", "--json", &format!("examples/{name}")]).json();
        let path = directory.path().join("job.json");
        let mut job = toml["job"].clone();
        // Beside the copy there is no machine.
        let machine = repository().join("examples").join(job["machine"]["file"].as_str().unwrap());
        job["machine"]["file"] = machine.to_str().into();
        std::fs::write(&path, job.to_string()).unwrap();
        let json = run(&["check", "--json", path.to_str().unwrap()]);
        assert_eq!(json.exit, Some(0), "{json:?}");
        assert_eq!(json.json()["job"], job);
        assert_eq!(json.json()["derived"], toml["derived"]);
    }
}

#[test]
fn check_writes_nothing_and_keeps_quiet_when_told() {
    let before = std::fs::read_dir(repository().join("examples")).unwrap().count();
    let human = run(&["check", "examples/twist-free-crowning.toml"]);
    assert_eq!((human.exit, human.stderr.as_str()), (Some(0), ""));
    assert!(human.stdout.contains("twist-free-crowning.out"));
    let quiet = run(&["check", "--quiet", "examples/twist-free-crowning.toml"]);
    assert_eq!((quiet.exit, quiet.stdout.as_str(), quiet.stderr.as_str()), (Some(0), "", ""));
    let told = run(&["check", "examples/twist-free-crowning.toml", "-o", "elsewhere", "--json"]);
    assert_eq!(told.json()["output_directory"], "elsewhere");
    assert_eq!(std::fs::read_dir(repository().join("examples")).unwrap().count(), before);
}

#[test]
fn defaults_are_filled_in() {
    let text = example("radial-feed-crowning.toml");
    let short: String = text
        .lines()
        .filter(|line| {
            !["evaluation", "hand", "normal_pressure_angle_deg = 17.5\nwidth"]
                .iter()
                .any(|k| line.starts_with(k))
        })
        .map(|line| format!("{line}\n"))
        .collect();
    let run = run_with(&["check", "--json", "-"], short.as_bytes());
    assert_eq!(run.exit, Some(0), "{run:?}");
    let answer = run.json();
    assert_eq!(answer["derived"]["worm"]["hand"], "left");
    assert_eq!(
        answer["derived"]["evaluation"],
        json!({ "start_diameter": 76.2065, "end_diameter": 88.5315, "z_start": -20.0, "z_end": 20.0 })
    );
    assert_eq!(answer["job"]["dressing"]["conditions"], json!(["three-point", "radius-map"]));
    assert_eq!(answer["job"]["dressing"]["profile_crowning_by"], "auto");
}
