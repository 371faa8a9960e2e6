//! Measuring a skiving tool as a user meets it: a measurement simulated and read back, what is refused and how, the history.

use crate::command::{Run, example, replaced, repository, run};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// An example as a job of its own, with other things in it, without its machine and what takes long.
fn job(directory: &Path, name: &str, changes: &[(&str, &str)]) -> String {
    let text = example(&format!("skiving/{name}.toml"));
    let from = text.find("[output]").unwrap_or(text.len());
    let text = text[..from].replace("[monte_carlo]\nmeasurements = 1000\n", "");
    let path = directory.join("job.toml");
    std::fs::write(&path, replaced(text, changes)).expect("a written job");
    path.display().to_string()
}

fn ran(command: &str, job: &str, out: &Path, more: &[&str]) -> Run {
    let out = out.display().to_string();
    run(&[&[command, job, "-o", &out, "--json", "--quiet"], more].concat())
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|x| x.as_f64().expect("a number")).collect()
}

#[test]
fn a_simulated_measurement_is_read_back_as_it_was() {
    let directory = tempfile::tempdir().unwrap();
    let job = job(directory.path(), "internal-ring", &[]);
    let [first, second] = ["simulated", "inspected"].map(|name| directory.path().join(name));
    let simulated = ran("simulate", &job, &first, &[]);
    assert_eq!(simulated.exit, Some(0), "{}", simulated.stderr);
    let readings = first.join("readings.csv").display().to_string();
    let inspected = ran("inspect", &readings, &second, &["--job", &job]);
    assert_eq!(inspected.exit, Some(0), "{}", inspected.stderr);
    let (a, b) = (simulated.json(), inspected.json());
    // The angles come back bit for bit, and with them every figure.
    assert_eq!(a["measurement"], b["measurement"]);
    let rows = std::fs::read_to_string(&readings).unwrap().lines().count() - 1;
    assert_eq!(a["measurement"]["readings"], rows);
    assert_eq!(rows, 2 * 5 * 2 * 8 * 41);
    // Of a real tool nothing but its deviations is known: no usual way, and the referee takes the edges that they tell.
    assert!(a["conventional"].is_array() && b["conventional"][0]["reported_um"].is_null());
    for file in
        ["report.html", "result.json", "deviations.csv", "pitch.csv", "resharpening.csv", "motions/poses.csv"]
    {
        assert!(first.join(file).is_file() && second.join(file).is_file(), "{file}");
    }
    assert!(!second.join("readings.csv").exists());
    // Prediction and referee, tooth by tooth, within what a first order misses of some micrometres
    // (`docs/mathematics/skiving.md#how-it-is-verified`).
    for (result, flank) in [(&a, "left"), (&a, "right"), (&b, "left"), (&b, "right")] {
        let found = &result["flanks"][flank]["model_difference_um"];
        let [mean, each] = numbers(found)[..] else { panic!("{found}") };
        assert!(mean < 0.05 && each < 0.12, "{flank}: {mean} {each}");
    }
    // A reading that is gone in all revolutions is a tooth that is not judged; the others are.
    let text = std::fs::read_to_string(&readings).unwrap();
    let gone = |line: &&str| {
        let cells: Vec<&str> = line.split(',').collect();
        let number = || {
            text.lines()
                .filter(|l| l.rsplit_once(',').map(|(b, _)| b) == line.rsplit_once(',').map(|(b, _)| b))
        };
        cells[0] == "left" && cells[1] == "2" && number().nth(7) == Some(*line)
    };
    let shorter: String = text.lines().filter(|line| !gone(line)).map(|l| l.to_owned() + "\n").collect();
    let path = directory.path().join("shorter.csv");
    std::fs::write(&path, shorter).unwrap();
    let partial = ran("inspect", &path.display().to_string(), &second, &["--job", &job]);
    let found = partial.json();
    assert_eq!((partial.exit, &found["status"]), (Some(3), &Value::from("not_judged")), "{}", partial.stderr);
    assert_eq!(found["reason"]["code"], "switches-missing");
    let missing = found["measurement"]["missing"].as_array().unwrap();
    assert_eq!((missing.len(), &missing[0]["tooth"]), (1, &Value::from(7)));
    let at =
        |document: &Value, tooth: usize| document["measurement"]["deviation_um"]["left"][1][tooth].clone();
    assert!(at(&found, 7).is_null());
    let [with, without] = [&a, &found].map(|document| at(document, 8).as_f64().unwrap());
    assert!((with - without).abs() < 1e-3, "{with} {without}");
    // One that is half a pitch off belongs to no tooth.
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let (begin, angle) =
        lines[1].rsplit_once(',').map(|(b, a)| (b.to_owned(), a.parse::<f64>().unwrap())).unwrap();
    lines[1] = format!("{begin},{}", angle + 180.0 / 41.0);
    std::fs::write(&path, lines.join("\n") + "\n").unwrap();
    let refused = ran("inspect", &path.display().to_string(), &second, &["--job", &job]);
    assert_eq!((refused.exit, &refused.json()["error"]["code"]), (Some(4), &Value::from("ambiguous-tooth")));
    let nonsense = text.replacen("left", "middle", 1);
    std::fs::write(&path, nonsense).unwrap();
    let refused = ran("inspect", &path.display().to_string(), &second, &["--job", &job]);
    assert_eq!(refused.exit, Some(2), "{refused:?}");
}

/// Changes of the ring's job, the exit status, code and key of the answer.
type Refusal = (&'static [(&'static str, &'static str)], i32, &'static str, &'static str);

const REFUSALS: &[Refusal] = &[
    (
        &[("teeth = 41\nhelix_angle_deg = 0.0", "teeth = 41\nhelix_angle_deg = 20.0")],
        2,
        "axes-parallel",
        "skiving.crossed_axes_angle_deg",
    ),
    (
        &[("[light_barrier]", "[skiving]\ncentre_distance = 49.0\n\n[light_barrier]")],
        2,
        "invalid-centre-distance",
        "skiving.centre_distance",
    ),
    (
        &[
            ("start_diameter = 184.8, end_diameter = 177.4", "start_diameter = 184.8, end_diameter = 160.0"),
            ("tip_diameter = 177.2", "tip_diameter = 159.0"),
        ],
        2,
        "radius-below-base-circle",
        "gear.form_diameter",
    ),
    (
        &[(
            "tolerance_um = 5.0",
            "tolerance_um = 5.0\nmodifications = [ { kind = \"helix_crowning\", amount_um = 8 } ]",
        )],
        2,
        "lead-modification-not-supported",
        "target.modifications",
    ),
    (
        &[("clearance_angle_deg = 8.0", "clearance_angle_deg = 8.0\nclearance_chamfer_angle_deg = 10.0")],
        4,
        "contact-off-rounding",
        "skiving_tool.edge_radius",
    ),
    (&[("edge_radius = 0.03", "edge_radius = 5.0")], 4, "rounding-too-large", "skiving_tool.edge_radius"),
    (
        &[("revolutions = 8", "revolutions = 8\ntravel = { x = [0.0, 100.0] }")],
        4,
        "axis-limit",
        "measuring.travel",
    ),
    (
        &[("revolutions = 8", "revolutions = 8\nmost_off_flank_deg = 0.01")],
        4,
        "pose-not-reachable",
        "measuring.poses",
    ),
    (&[("radius = 0.05", "radius = 1.5")], 4, "shadowed", "light_barrier.radius"),
    (
        &[("revolutions = 8", "revolutions = 8\ntracks = [-1.0, 0.0, 1.0]")],
        4,
        "edge-end-touched",
        "measuring.tracks",
    ),
    (
        &[(
            "[tool_errors]",
            "[stylus]\npoint = [300.0, 20.0, 150.0]\nradius = 3.0\nteeth = [0, 14, 28]\n\n[tool_errors]",
        )],
        4,
        "shadowed",
        "stylus.radius",
    ),
    (
        &[("revolutions = 8", "revolutions = 8\ntracks = [0.0, 0.5]")],
        2,
        "too-few-tracks",
        "evaluation.curve_degree",
    ),
    (
        &[("edge_growth_um = [1.5, 0.5]", "edge_growth_um = [-40.0]")],
        2,
        "invalid-number",
        "tool_errors.edge_growth_um",
    ),
    (
        &[(
            "[tool_errors]",
            "[calibration]\nradius = 10.0\nheight = 5.0\nswitches = [\n  { along = \"Y\", place = [300.0, 9.95, 140.0] }, { along = \"Y\", place = [300.0, 30.05, 140.0] }, { along = \"X\", place = [289.95, 20.0, 140.0] },\n  { along = \"Y\", place = [300.0, 9.95, 140.0] }, { along = \"Y\", place = [300.0, 30.05, 140.0] }\n]\n\n[tool_errors]",
        )],
        4,
        "calibration-singular",
        "calibration",
    ),
];

/// What delay, hysteresis and clocking do to a measurement does not pass for what the tool is: neither in the verdict nor under the referee.
#[test]
fn the_clocking_of_a_tool_does_not_matter() {
    let directory = tempfile::tempdir().unwrap();
    let out = directory.path().join("out");
    let one_sense = job(
        directory.path(),
        "internal-ring",
        &[("revolutions = 8", "revolutions = 8\nsenses = \"positive\"")],
    );
    let run = ran("plan", &one_sense, &out, &[]);
    assert_eq!(run.exit, Some(0), "{}", run.stderr);
    let result = run.json();
    assert_eq!(result["warnings"][0]["code"], "latency-not-removed");
    for flank in ["left", "right"] {
        let [mean, each] = numbers(&result["flanks"][flank]["model_difference_um"])[..] else { panic!() };
        assert!(mean < 0.01 && each < 0.05, "{mean} {each}");
        assert!(result["flanks"][flank]["max_deviation_um"].as_f64().unwrap() < 2.0);
    }
    // A constant turn of all angles, far below a quarter of a pitch and near it, is taken off.
    let both = job(directory.path(), "internal-ring", &[]);
    let simulated = ran("simulate", &both, &out, &[]);
    let text = std::fs::read_to_string(out.join("readings.csv")).unwrap();
    let turned = |degrees: f64| {
        let line = |line: &str| match line
            .rsplit_once(',')
            .and_then(|(begin, angle)| Some((begin, angle.parse::<f64>().ok()?)))
        {
            Some((begin, angle)) => format!("{begin},{}\n", angle + degrees),
            None => format!("{line}\n"),
        };
        text.lines().map(line).collect::<String>()
    };
    let path = directory.path().join("turned.csv");
    for degrees in [0.3, 2.0] {
        std::fs::write(&path, turned(degrees)).unwrap();
        let run =
            ran("inspect", &path.display().to_string(), &directory.path().join("turned"), &["--job", &both]);
        assert_eq!(run.exit, Some(0), "{degrees}: {}", run.stderr);
        let found = run.json();
        let [e, true_e] =
            [&found, &simulated.json()].map(|r| numbers(&r["measurement"]["mounting"]["eccentricity_um"]));
        assert!((e[0] - true_e[0]).abs() < 1e-6 && (e[1] - true_e[1]).abs() < 1e-6, "{e:?} {true_e:?}");
        for flank in ["left", "right"] {
            let [mean, each] = numbers(&found["flanks"][flank]["model_difference_um"])[..] else { panic!() };
            assert!(mean < 0.05 && each < 0.12, "{degrees}: {mean} {each}");
        }
    }
    // Tracks in different senses would keep the delay in some and lose it in others.
    let mixed: String =
        text.lines().filter(|l| !l.starts_with("right,3,-1")).map(|l| l.to_owned() + "\n").collect();
    std::fs::write(&path, mixed).unwrap();
    let refused = ran("inspect", &path.display().to_string(), &out, &["--job", &both]);
    assert_eq!((refused.exit, &refused.json()["error"]["code"]), (Some(2), &Value::from("senses-differ")));
    // Readings that were taken otherwise than the job says are told.
    let first: String = text.lines().filter(|l| !l.contains(",-1,")).map(|l| l.to_owned() + "\n").collect();
    std::fs::write(&path, first).unwrap();
    let told = ran("inspect", &path.display().to_string(), &out, &["--job", &both]).json();
    let codes: Vec<&str> =
        told["warnings"].as_array().unwrap().iter().filter_map(|w| w["code"].as_str()).collect();
    assert_eq!(codes, ["latency-not-removed", "readings-differ"]);
    assert_eq!(told["measuring_time_s"], 10.0 * (8.0 * 0.5 + 2.0));
}

#[test]
fn what_cannot_be_measured_is_refused_by_its_key() {
    let directory = tempfile::tempdir().unwrap();
    for (changes, exit, code, field) in REFUSALS {
        let job = job(directory.path(), "internal-ring", changes);
        let out = directory.path().join(code);
        let run = ran("plan", &job, &out, &[]);
        assert_eq!(run.exit, Some(*exit), "{changes:?}: {run:?}");
        let error = &run.json()["error"];
        assert_eq!(
            (error["code"].as_str(), error["field"].as_str()),
            (Some(*code), Some(*field)),
            "{changes:?}: {error}"
        );
        for key in ["message", "way_out"] {
            assert!(error[key].as_str().is_some_and(|text| !text.is_empty()), "{code} has no {key}: {error}");
        }
        // What bodies cannot do is shown with them; a job that cannot be read has none.
        assert_eq!(out.join("report.html").exists(), *exit == 4, "{code}");
    }
}

#[test]
fn a_history_is_kept_once_and_tells_when_to_grind() {
    let directory = tempfile::tempdir().unwrap();
    let history = directory.path().join("history.jsonl");
    let before = std::fs::read_to_string(repository().join("examples/skiving/history.jsonl")).unwrap();
    std::fs::write(&history, &before).unwrap();
    let job = job(directory.path(), "worn-tool", &[]);
    let out = directory.path().join("out");
    let first = ran("plan", &job, &out, &[]);
    assert_eq!(first.exit, Some(3), "{}", first.stderr);
    // The example's own measurement is in its history already.
    assert_eq!(std::fs::read_to_string(&history).unwrap(), before);
    let result = first.json();
    assert_eq!(result["reason"]["code"], "tool-worn");
    let left = &result["history"]["flanks"]["left"];
    assert!(left["remaining_parts"].as_f64().unwrap() < 0.0, "{left}");
    let interval = numbers(&left["limit_interval"]);
    let at = left["limit_at_parts"].as_f64().unwrap();
    assert!(interval[0] < at && at < interval[1], "{left}");
    assert!(result["measurement"]["resharpening"]["depth_mm"].as_f64().unwrap() > 0.02);
    // Another measurement under the same time is refused, a later one is added.
    let text = std::fs::read_to_string(directory.path().join("job.toml")).unwrap();
    let other = text.replace("parts = 1800.0", "parts = 1900.0");
    std::fs::write(directory.path().join("job.toml"), &other).unwrap();
    let refused = ran("plan", &job, &out, &[]);
    assert_eq!(
        (refused.exit, &refused.json()["error"]["code"]),
        (Some(2), &Value::from("invalid-history")),
        "{refused:?}"
    );
    assert_eq!(std::fs::read_to_string(&history).unwrap(), before);
    let later = other.replace("2026-03-20", "2026-03-21");
    std::fs::write(directory.path().join("job.toml"), later).unwrap();
    let added = ran("plan", &job, &out, &[]);
    assert_eq!(added.exit, Some(3), "{}", added.stderr);
    let after = std::fs::read_to_string(&history).unwrap();
    assert_eq!(after.lines().count(), before.lines().count() + 1);
    assert!(after.starts_with(&before));
}

#[test]
fn poses_alone_are_a_job_as_well() {
    let directory = tempfile::tempdir().unwrap();
    let path = job(directory.path(), "internal-ring", &[]);
    let text = std::fs::read_to_string(&path).unwrap();
    let poses = &text[..text.find("[tool_errors]").unwrap()];
    std::fs::write(&path, poses).unwrap();
    let out = directory.path().join("out");
    let run = ran("plan", &path, &out, &[]);
    assert_eq!(run.exit, Some(0), "{}", run.stderr);
    assert!(run.json()["measurement"].is_null() && out.join("motions/poses.csv").is_file());
    assert_eq!(ran("simulate", &path, &out, &[]).json()["error"]["field"], "tool_errors");
    std::fs::write(&path, poses.to_owned() + "[monte_carlo]\nmeasurements = 10\n").unwrap();
    let refused = ran("plan", &path, &out, &[]);
    assert_eq!((refused.exit, &refused.json()["error"]["field"]), (Some(2), &Value::from("monte_carlo")));
    // A tool that does not go with the workpiece is not met because nothing was measured.
    std::fs::write(&path, poses.replace("teeth = 41", "teeth = 12")).unwrap();
    let run = ran("plan", &path, &out, &[]);
    assert_eq!(
        (run.exit, &run.json()["reason"]["code"]),
        (Some(3), &Value::from("above-tolerance")),
        "{run:?}"
    );
    assert_eq!(run.json()["warnings"][0]["code"], "prediction-unproven");
}

#[test]
fn commands_for_other_jobs_say_so() {
    let path: PathBuf = repository().join("examples/skiving/internal-ring.toml");
    let ring = path.display().to_string();
    for (command, more) in [("explore", vec![]), ("gearbox", vec![])] {
        let run = run(&[vec![command, &ring, "--json"], more].concat());
        assert_eq!(
            (run.exit, &run.json()["error"]["code"]),
            (Some(2), &Value::from("process-not-available")),
            "{command}"
        );
    }
    let run = run(&["inspect", "readings.csv", "--job", "examples/gearbox/feed-to-and-fro.toml", "--json"]);
    assert_eq!((run.exit, &run.json()["error"]["field"]), (Some(2), &Value::from("job.process")));
}
