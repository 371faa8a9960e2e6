//! Catalogues of worms and dressers as a user meets them: ranking, plan, free quantities, and everything that can be wrong with them.

use std::path::Path;

use serde_json::Value;

use crate::command::{Run, check, example, repository, run};

/// The example job with the path of its catalogue written out.
fn job() -> String {
    let bodies = repository().join("examples/catalogue/bodies.toml");
    example("catalogue.toml").replace("catalogue/bodies.toml", bodies.to_str().unwrap())
}

/// The first worms and dressers of the example, which fit each other: quick to plan.
fn small() -> String {
    let text = std::fs::read_to_string(repository().join("examples/catalogue/bodies.toml")).unwrap();
    let entry = |list: &str, name: &str| {
        let head = format!("[[{list}]]\nname = \"{name}\"");
        let start = text.find(&head).unwrap();
        let end = text[start + 2..].find("[[").map_or(text.len(), |k| start + 2 + k);
        text[start..end].to_owned()
    };
    entry("worm", "W3-01")
        + &entry("worm", "W5-01")
        + &entry("dresser", "D120-3-200/3")
        + &entry("dresser", "D110-5-120/3")
}

/// Runs a command on a job text beside a catalogue text.
fn with_bodies(command: &str, job: &str, bodies: &str, extra: &[&str]) -> (Run, tempfile::TempDir) {
    let directory = tempfile::tempdir().unwrap();
    std::fs::write(directory.path().join("bodies.toml"), bodies).unwrap();
    let path = directory.path().join("job.toml");
    std::fs::write(&path, job).unwrap();
    let output = directory.path().join("out");
    let mut arguments = vec![command, path.to_str().unwrap(), "-o", output.to_str().unwrap()];
    arguments.extend(extra);
    (run(&arguments), directory)
}

fn beside() -> String {
    example("catalogue.toml")
        .replace("catalogue/bodies.toml", "bodies.toml")
        .replace("_points = 41", "_points = 9")
}

fn read(directory: &Path, name: &str) -> Value {
    serde_json::from_str(&std::fs::read_to_string(directory.join("out").join(name)).unwrap()).unwrap()
}

#[test]
fn explore_ranks_all_pairs() {
    let directory = tempfile::tempdir().unwrap();
    let output = directory.path().join("out");
    let run = run(&["explore", "examples/catalogue.toml", "-o", output.to_str().unwrap(), "--top", "4"]);
    assert_eq!((run.exit, run.stderr.as_str()), (Some(0), ""), "{run:?}");
    for words in [
        "of 120 pairs make the profile crowning",
        "W5-01 / D110-5-120/3 / makes it",
        "and 116 more in explore.csv",
    ] {
        assert!(run.stdout.contains(words), "{words}: {}", run.stdout);
    }
    let document = read(directory.path(), "explore.json");
    let pairs = document["pairs"].as_array().unwrap();
    assert_eq!(pairs.len(), 120);
    let ok = document["ok"].as_u64().unwrap() as usize;
    assert!(pairs[..ok].iter().all(|p| p["ok"] == true && p["refused"].is_null()));
    assert!(pairs[ok..].iter().all(|p| p["ok"] == false && p["refused"]["way_out"].is_string()));
    let code = |worm: &str, dresser: &str| {
        let pair = pairs.iter().find(|p| p["worm"] == worm && p["dresser"] == dresser).unwrap();
        pair["refused"]["code"].clone()
    };
    assert_eq!(code("W3-M40", "D120-3-200/0"), "not-mating");
    assert_eq!(code("W3-01", "D120-3-200/M40"), "not-mating");
    assert_eq!(code("W5-01", "D110-5-120/3s"), "dresser-flank-too-short");
    assert_eq!(code("W1-01", "D110-5-120/0"), "axis-limit");
    // The life of the best pairs goes from the diameter of now to the smallest.
    let life = &document["lives"][0]["points"];
    let diameters: Vec<f64> =
        life.as_array().unwrap().iter().map(|p| p["worm_pitch_diameter_mm"].as_f64().unwrap()).collect();
    assert!(diameters.len() > 5 && diameters.windows(2).all(|w| w[1] < w[0]));
    let csv = std::fs::read_to_string(output.join("explore.csv")).unwrap();
    assert_eq!(csv.lines().count(), 121);
    assert!(csv.starts_with("rank,worm,dresser,ok,largest_share_of_limit,"));
    let page = std::fs::read_to_string(output.join("explore.html")).unwrap();
    assert!(page.contains("<svg") && page.contains("D110-5-120/3s") && !page.contains("src=\"http"));
}

#[test]
fn tables_and_toml_are_the_same_catalogue() {
    let tables = "worms_csv = \"catalogue/worms.csv\"\ndressers_csv = \"catalogue/dressers.csv\"";
    let text = example("catalogue.toml").replace("file = \"catalogue/bodies.toml\"", tables);
    let directory = tempfile::tempdir().unwrap();
    let inside = directory.path().join("job.toml");
    std::fs::write(&inside, text.replace("catalogue/", "")).unwrap();
    for table in ["worms.csv", "dressers.csv"] {
        let from = repository().join("examples/catalogue").join(table);
        std::fs::copy(from, directory.path().join(table)).unwrap();
    }
    let output = directory.path().join("out");
    let arguments = ["explore", inside.to_str().unwrap(), "--json", "-o", output.to_str().unwrap()];
    let of_tables = run(&arguments);
    assert_eq!(of_tables.exit, Some(0), "{of_tables:?}");
    let of_toml = run(&["explore", "examples/catalogue.toml", "--json", "-o", output.to_str().unwrap()]);
    assert_eq!(of_tables.json(), of_toml.json());
}

#[test]
fn plan_takes_the_best_pair_and_simulate_runs_it() {
    // The ranking is for the ratio of least corrections.
    let auto = "diagonal_ratio = \"auto\"";
    let accurate = beside().replace(auto, &format!("{auto}\nprefer = \"accuracy\""));
    let (planned, directory) = with_bodies("plan", &accurate, &small(), &["--json"]);
    assert_eq!(planned.exit, Some(0), "{planned:?}");
    let result = planned.json();
    assert_eq!(result["status"], "met");
    let chosen = result["warnings"].as_array().unwrap().iter().find(|w| w["code"] == "chosen-from-catalogue");
    let text = chosen.unwrap()["text"].as_str().unwrap();
    assert!(text.contains("W5-01 and dresser D110-5-120/3 are number 1 of"), "{text}");
    let settings = read(directory.path(), "settings.json");
    assert!(settings["catalogue"].is_null());
    assert_eq!(settings["worm"]["threads"], 5);
    assert_eq!(settings["dresser"]["designed_for"]["pitch_diameter"], 120.0);
    assert_eq!(settings["dresser"]["modification"]["kind"], "profile_crowning");
    // The corrections are counted from the nominal kinematics of this worm: the ranking shows the same.
    let ranked = &read(directory.path(), "explore.json")["pairs"][0]["flanks"]["left"];
    let planned = &settings["settings"]["left"];
    for key in ["d_gamma_deg", "d_v_yA_mm"] {
        let (a, b) = (ranked[key].as_f64().unwrap(), planned[key][0].as_f64().unwrap());
        assert!((a - b).abs() < 0.25 * a.abs() + 0.02, "{key}: {a} {b}");
    }
    let job = directory.path().join("out/settings.json");
    let again = directory.path().join("again");
    let simulated = run(&["simulate", job.to_str().unwrap(), "--json", "-o", again.to_str().unwrap()]);
    assert_eq!(simulated.exit, Some(0), "{simulated:?}");
    let deviation = |result: &Value| result["flanks"]["left"]["max_deviation_um"].as_f64().unwrap();
    assert!((deviation(&simulated.json()) - deviation(&result)).abs() < 1e-6);
}

#[test]
fn different_crownings_on_both_flanks() {
    let bodies =
        small().replace("profile_crowning_um = 3.0", "profile_crowning_um = { left = 3.0, right = 1.0 }");
    let job = beside().replace(
        "{ kind = \"profile_crowning\", amount_um = 3.0, flank = \"both\" }",
        "{ kind = \"profile_crowning\", amount_um = 3.0, flank = \"left\" },\n  { kind = \"profile_crowning\", amount_um = 1.0, flank = \"right\" }",
    );
    let (planned, directory) = with_bodies("plan", &job, &bodies, &["--json"]);
    assert_eq!(planned.exit, Some(0), "{planned:?}");
    let result = planned.json();
    for (flank, um) in [("left", 3.0), ("right", 1.0)] {
        let made = &result["flanks"][flank]["simulated_characteristics"]["profile_crowning_um"];
        assert!((made.as_f64().unwrap() - um).abs() < 0.1, "{flank}: {made}");
    }
    let job = directory.path().join("out/settings.json");
    let again = run(&["check", job.to_str().unwrap()]);
    assert_eq!(again.exit, Some(0), "{again:?}");
}

#[test]
fn nothing_that_fits_is_no_success() {
    let bodies = small().replace(
        "normal_pressure_angle_deg = 17.5\nwidth",
        "normal_pressure_angle_deg = 17.5\nnormal_module = 4.5\nwidth",
    );
    assert!(bodies.matches("4.5").count() == 2);
    let (explored, directory) = with_bodies("explore", &beside(), &bodies, &["--quiet"]);
    assert_eq!(explored.exit, Some(4), "{explored:?}");
    assert!(explored.stderr.contains("no pair makes the profile"), "{explored:?}");
    assert_eq!(read(directory.path(), "explore.json")["ok"], 0);
    let (planned, directory) = with_bodies("plan", &beside(), &bodies, &["--json"]);
    assert_eq!(planned.exit, Some(4), "{planned:?}");
    assert_eq!(planned.json()["error"]["code"], "no-pair-fits");
    let result = read(directory.path(), "result.json");
    assert_eq!(
        (&result["status"], &result["reason"]["code"]),
        (&"not_producible".into(), &"no-pair-fits".into())
    );
    assert!(directory.path().join("out/explore.html").is_file());
}

#[test]
fn a_free_quantity_shows_what_the_dressers_would_serve() {
    let study =
        |free: &str| beside().replace("[grid]", &format!("[explore]\ncatalogue = {{ {free} }}\n\n[grid]"));
    let cases = [
        ("free = \"pitch-diameter\", from = 90.0, to = 240.0", "pitch-diameter"),
        ("free = \"pressure-angle\", from = 16.0, to = 19.0", "pressure-angle"),
        ("free = \"threads\", from = 1, to = 6", "threads"),
    ];
    for (free, name) in cases {
        let (run, directory) = with_bodies("explore", &study(free), &small(), &[]);
        assert_eq!(run.exit, Some(0), "{run:?}");
        assert!(run.stdout.contains(name) && run.stdout.contains("best"), "{run:?}");
        let document = read(directory.path(), "explore.json");
        let pairs = document["pairs"].as_array().unwrap();
        assert_eq!((pairs.len(), &document["free"]), (4, &Value::from(name)));
        for range in pairs.iter().flat_map(|p| p["ranges"].as_array().unwrap()) {
            let value = |key: &str| range[key].as_f64().unwrap();
            let best = range["best"]["value"].as_f64().unwrap();
            assert!(value("from") <= best && best <= value("to"), "{range}");
            assert!(range["best"]["refused"].is_null());
        }
        assert!(std::fs::read_to_string(directory.path().join("out/explore.html")).unwrap().contains("<svg"));
    }
    let (never, _) =
        with_bodies("explore", &study("free = \"pitch-diameter\", from = 15.0, to = 20.0"), &small(), &[]);
    assert_eq!(never.exit, Some(4), "{never:?}");
}

#[test]
fn check_counts_the_bodies() {
    let (text, json) = check("job.toml", job().as_bytes());
    assert_eq!((text.exit, json.exit), (Some(0), Some(0)), "{text:?}");
    let derived = &json.json()["derived"]["catalogue"];
    assert_eq!(
        (&derived["worms"], &derived["dressers"], &derived["pairs"]),
        (&10.into(), &12.into(), &120.into())
    );
    assert!((derived["profile_crowning_left_um"].as_f64().unwrap() - 3.0).abs() < 1e-9);
}

#[test]
fn the_schema_describes_the_example() {
    let printed = run(&["schema", "--catalogue"]);
    assert_eq!(printed.exit, Some(0));
    let validator = jsonschema::draft202012::new(&printed.json()).unwrap();
    let text = std::fs::read_to_string(repository().join("examples/catalogue/bodies.toml")).unwrap();
    let loaded = flankwright::exchange::catalogue::parse_catalogue(flankwright::exchange::Source::new(
        "a.toml", &text,
    ));
    let value = serde_json::to_value(loaded.unwrap().catalogue).unwrap();
    assert!(validator.is_valid(&value));
    let mut wrong = value.clone();
    wrong["worm"][0]["thread"] = 3.into();
    assert!(!validator.is_valid(&wrong));
    // The job's schema takes either a catalogue or fixed bodies.
    let of_job = jsonschema::draft202012::new(&run(&["schema"]).json()).unwrap();
    let job: Value = run(&["check", "--json", "examples/catalogue.toml"]).json()["job"].clone();
    assert!(of_job.is_valid(&job), "{job}");
    let fixed: Value = run(&["check", "--json", "examples/twist-free-crowning.toml"]).json()["job"].clone();
    let mut both = job.clone();
    both["worm"] = fixed["worm"].clone();
    let mut neither = job;
    neither.as_object_mut().unwrap().remove("catalogue");
    assert!(of_job.is_valid(&fixed) && !of_job.is_valid(&both) && !of_job.is_valid(&neither));
}

/// The finding on a broken catalogue: code, key and line.
/// Code, field and line of all findings, which name the file and a way out.
fn findings(run: &Run, file: &str) -> Vec<(String, String, u64)> {
    assert_eq!(run.exit, Some(2), "{run:?}");
    let told = run.json()["errors"].as_array().unwrap().clone();
    let told = told.into_iter().map(|error| {
        assert!(error["file"].as_str().unwrap().ends_with(file), "{error}");
        for key in ["message", "way_out"] {
            assert!(error[key].is_string(), "{key}: {error}");
        }
        assert!(error["allowed"].is_string() || error["field"].is_null(), "{error}");
        let text = |key: &str| error[key].as_str().unwrap_or_default().to_owned();
        (text("code"), text("field"), error["line"].as_u64().unwrap_or(0))
    });
    told.collect()
}

fn findings_of(bodies: &str) -> Vec<(String, String, u64)> {
    findings(&with_bodies("check", &beside(), bodies, &["--json"]).0, "bodies.toml")
}

#[test]
fn broken_catalogues_are_told_by_key_and_line() {
    let good = small();
    let line = |words: &str| 1 + good[..good.find(words).unwrap()].matches('\n').count() as u64;
    let cases = [
        ("threads = 3\n", "thread = 3\n", "unknown-key", "worm[0].thread", "threads = 3\n"),
        ("width = 100.0", "width = -1.0", "invalid-number", "worm[0].width", "width = 100.0"),
        ("width = 100.0", "width = nan", "invalid-number", "worm[0].width", "width = 100.0"),
        ("width = 100.0", "width = \"wide\"", "wrong-type", "worm[0].width", "width = 100.0"),
        ("hand = \"left\"", "hand = \"lefft\"", "unknown-value", "worm[0].hand", "hand = \"left\""),
        (
            "smallest_tip_diameter = 178.0",
            "smallest_tip_diameter = 278.0",
            "invalid-geometry",
            "worm[0].smallest_tip_diameter",
            "smallest_tip_diameter",
        ),
        (
            "smallest_tip_diameter = 178.0",
            "smallest_tip_diameter = 178.0\nsmallest_pitch_diameter = 170.0",
            "invalid-catalogue",
            "worm[0].smallest_tip_diameter",
            "smallest_tip_diameter",
        ),
        ("name = \"W5-01\"", "name = \"W3-01\"", "invalid-catalogue", "worm[1].name", "name = \"W5-01\""),
        (
            "pitch_diameter = 118.0",
            "pitch_diameter = 118.0\ntip_diameter = 110.0",
            "invalid-geometry",
            "worm[1].pitch_diameter",
            "pitch_diameter = 118.0",
        ),
        ("tip_land = 0.8", "tip_land = -0.8", "invalid-number", "dresser[0].tip_land", "tip_land = 0.8"),
        (
            "tip_land = 0.8",
            "tip_land = 0.8\nflank_diameters = { from = 119.0, to = 118.0 }",
            "invalid-geometry",
            "dresser[0].flank_diameters.from",
            "",
        ),
        (
            "tip_land = 0.8",
            "tip_land = 0.8\nflank_diameters = { from = 119.0, to = 121.0 }",
            "invalid-geometry",
            "dresser[0].flank_diameters.to",
            "",
        ),
        (
            "tip_land = 0.8",
            "tip_land = 0.8\npitch_diameter = 120.0",
            "invalid-geometry",
            "dresser[0].pitch_diameter",
            "",
        ),
        (
            "profile_crowning_um = 3.0",
            "profile_crowning_um = { left = 3.0 }",
            "missing-key",
            "dresser[0].profile_crowning_um.right",
            "",
        ),
        (
            "designed_for = { threads = 3, ",
            "designed_for = { thread = 3, ",
            "unknown-key",
            "dresser[0].designed_for.thread",
            "",
        ),
        (
            "designed_for = { threads = 3, pitch_diameter = 200.0, ",
            "designed_for = { threads = 3, ",
            "missing-key",
            "dresser[0].designed_for.pitch_diameter",
            "",
        ),
    ];
    for (old, new, code, field, place) in cases {
        assert!(good.contains(old), "{old}");
        let found = findings_of(&good.replacen(old, new, 1));
        let Some(found) = found.iter().find(|f| (f.0.as_str(), f.1.as_str()) == (code, field)) else {
            panic!("{new}: {found:?}");
        };
        if !place.is_empty() {
            assert_eq!(found.2, line(place), "{new}");
        }
    }
    // Whole lists.
    let without = |list: &str| {
        good.split("\n[[")
            .filter(|part| !part.trim_start_matches("[[").starts_with(list))
            .collect::<Vec<_>>()
            .join("\n[[")
    };
    let (code, field, _) = findings_of(&without("dresser"))[0].clone();
    assert_eq!((code.as_str(), field.as_str()), ("missing-key", "dresser"));
    assert_eq!(findings_of("[[worm]\n")[0].0, "invalid-toml");
    assert_eq!(findings_of("worm = []\ndresser = []\n")[0].0, "invalid-list");
    assert_eq!(findings_of("worm = 3\ndresser = 4\n")[0].0, "wrong-type");
}

#[test]
fn broken_tables_are_told_by_column_and_line() {
    let read =
        |name: &str| std::fs::read_to_string(repository().join("examples/catalogue").join(name)).unwrap();
    let (worms, dressers) = (read("worms.csv"), read("dressers.csv"));
    let cases = [
        ("worms.csv", "name,threads", "name,thread", "unknown-key", 3),
        ("worms.csv", "W1-01,1,", "W1-01,one,", "wrong-type", 3),
        ("worms.csv", "W1-01,1,", "W1-01,1.5,", "wrong-type", 3),
        ("worms.csv", "W1-01,1,left,262.0", "W1-01,1,left,nan", "invalid-number", 3),
        ("worms.csv", "W1-01,1,", "W2-01,1,", "invalid-catalogue", 4),
        ("worms.csv", "W1-01,1,", "W1-01,1,,", "invalid-table", 3),
        ("dressers.csv", "to,designed_for.threads", "to,designed_for.thread", "unknown-key", 3),
        ("dressers.csv", "D120-3-200/0,120.0", "D120-3-200/0,-120.0", "invalid-number", 3),
        ("dressers.csv", "name,", "names,", "unknown-key", 3),
    ];
    for (file, old, new, code, line) in cases {
        let directory = tempfile::tempdir().unwrap();
        for (name, text) in [("worms.csv", &worms), ("dressers.csv", &dressers)] {
            let text = if name == file { text.replacen(old, new, 1) } else { text.clone() };
            assert!(name != file || text != worms && text != dressers, "{old}");
            std::fs::write(directory.path().join(name), text).unwrap();
        }
        let job = example("catalogue.toml").replace(
            "file = \"catalogue/bodies.toml\"",
            "worms_csv = \"worms.csv\"\ndressers_csv = \"dressers.csv\"",
        );
        let path = directory.path().join("job.toml");
        std::fs::write(&path, job).unwrap();
        let run = run(&["explore", path.to_str().unwrap(), "--json"]);
        assert_eq!(run.exit, Some(2), "{new}");
        let found = findings(&run, file);
        assert!(found.iter().any(|f| (f.0.as_str(), f.2) == (code, line)), "{new}: {found:?}");
    }
}

#[test]
fn contradictions_of_a_job_with_catalogue_are_refused() {
    let job = job();
    let worm = "[worm]\nthreads = 3\ntip_diameter = 200.0\n\n[grid]";
    let cases = [
        (job.replace("[grid]", worm), "invalid-job", "worm"),
        (job.replace("[grid]", "[dresser]\ntip_diameter = 120.0\n\n[grid]"), "invalid-job", "dresser"),
        (
            job.replace("[catalogue]", "[catalogue]\nworms_csv = \"w.csv\""),
            "invalid-job",
            "catalogue.worms_csv",
        ),
        (job.replace("file = ", "worms_csv = "), "missing-key", "catalogue.dressers_csv"),
        (job.replace("file = ", "dressers_csv = "), "missing-key", "catalogue.worms_csv"),
        (
            job.replace("largest_stretch = 0.1", "largest_stretch = 0.0"),
            "invalid-number",
            "catalogue.largest_stretch",
        ),
        (job.replace("largest_stretch", "largest_strech"), "unknown-key", "catalogue.largest_strech"),
        (job.replace("[catalogue]", "[catalogue]\nplans = 4"), "invalid-job", "catalogue.plans"),
        (
            job.replace("[catalogue]", "[catalogue]\ncrowning_at = [0.0]"),
            "invalid-job",
            "catalogue.crowning_at",
        ),
        (
            job.replace("[catalogue]", "[catalogue]\nrank_by = \"whole-target\"\nplans = 0"),
            "invalid-number",
            "catalogue.plans",
        ),
        (
            job.replace("[catalogue]", "[catalogue]\nrank_by = \"whole-target\"\ncrowning_at = [0.0, 30.0]"),
            "invalid-number",
            "catalogue.crowning_at[1]",
        ),
        (
            job.replace("[catalogue]", "[catalogue]\nrank_by = \"whole-target\"\ncrowning_at = [5.0, 5.0]"),
            "invalid-number",
            "catalogue.crowning_at[1]",
        ),
        (
            job.replace("[catalogue]", "[catalogue]\nrank_by = \"whole-target\"").replace(
                "[grid]",
                "[explore]\ncatalogue = { free = \"threads\", from = 1, to = 3 }\n\n[grid]",
            ),
            "invalid-job",
            "catalogue.rank_by",
        ),
        (
            job.replace("[grid]", "[dressing]\nprofile_crowning_by = \"dresser\"\n\n[grid]"),
            "invalid-job",
            "dressing.profile_crowning_by",
        ),
        (job.replace("[grid]", "[dressing]\nflanks = \"two\"\n\n[grid]"), "invalid-job", "dressing.flanks"),
        (
            job.replace("[grid]", "[dressing]\nconditions = [\"three-point\", \"fix-gamma\"]\n\n[grid]"),
            "invalid-job",
            "dressing.conditions",
        ),
        (
            job.replace(
                "[grid]",
                "[explore]\ndiagonal_ratio = { from = -1.0, to = 1.0, count = 3 }\n\n[grid]",
            ),
            "invalid-job",
            "explore",
        ),
        (
            job.replace(
                "[grid]",
                "[explore]\ncatalogue = { free = \"threads\", from = 1.5, to = 3 }\n\n[grid]",
            ),
            "invalid-number",
            "explore.catalogue.from",
        ),
        (
            job.replace(
                "[grid]",
                "[explore]\ncatalogue = { free = \"pressure-angle\", from = 20.0, to = 50.0 }\n\n[grid]",
            ),
            "invalid-number",
            "explore.catalogue.to",
        ),
        (
            job.replace(
                "[grid]",
                "[explore]\ncatalogue = { free = \"pitch-diameter\", from = 90.0, to = 80.0 }\n\n[grid]",
            ),
            "invalid-job",
            "explore.catalogue.to",
        ),
        (
            example("twist-free-crowning.toml").replace(
                "[grid]",
                "[explore]\ncatalogue = { free = \"threads\", from = 1, to = 3 }\n\n[grid]",
            ),
            "invalid-job",
            "explore.catalogue",
        ),
        (job.replace("bodies.toml", "nobody.toml"), "unreadable-file", ""),
    ];
    for (text, code, field) in cases {
        let (_, run) = check("job.toml", text.as_bytes());
        assert_eq!(run.exit, Some(2), "{code} {field}: {run:?}");
        let error = &run.json()["error"];
        assert_eq!(
            (error["code"].as_str(), error["field"].as_str().unwrap_or("")),
            (Some(code), field),
            "{error}"
        );
        assert!(error["way_out"].is_string());
    }
    let start = job.find("[catalogue]").unwrap();
    let end = job.find("[grinding]").unwrap();
    let (_, neither) = check("job.toml", (job[..start].to_owned() + &job[end..]).as_bytes());
    assert_eq!((neither.exit, &neither.json()["error"]["field"]), (Some(2), &"worm".into()), "{neither:?}");
    let (simulated, _) = with_bodies("simulate", &beside(), &small(), &["--json"]);
    assert_eq!((simulated.exit, &simulated.json()["error"]["field"]), (Some(2), &"catalogue".into()));
}

#[test]
fn a_dresser_designed_for_another_worm_is_planned_with() {
    let base = example("twist-free-crowning.toml").replace("_points = 41", "_points = 9");
    let with = |dresser: &str, crowning: &str| {
        base.replace(
            "pitch_diameter = 115.65            # gives the dressing centre distance 153.45",
            dresser,
        )
        .replace("profile_crowning_by = \"dresser\"", &format!("profile_crowning_by = \"{crowning}\""))
    };
    let fits = "designed_for = { threads = 3, pitch_diameter = 205.0 }\nmodification = { kind = \"profile_crowning\", amount_um = 5.0 }";
    let (planned, directory) = with_bodies("plan", &with(fits, "auto"), "", &["--json"]);
    assert_eq!(planned.exit, Some(0), "{planned:?}");
    let result = planned.json();
    assert!(result["flanks"]["left"]["max_deviation_um"].as_f64().unwrap() < 0.2);
    assert!(result["flanks"]["left"]["model_difference_um"].as_f64().unwrap() < 1e-3);
    let page = std::fs::read_to_string(directory.path().join("out/report.html")).unwrap();
    assert!(page.contains("designed for pitch diameter") && page.contains("profile stretch"));
    let cases = [
        (
            "designed_for = { threads = 3 }\nmodification = \"none\"",
            "auto",
            "missing-key",
            "dresser.designed_for.pitch_diameter",
        ),
        (
            "designed_for = { threads = 3, pitch_diameter = 205.0 }",
            "auto",
            "invalid-job",
            "dresser.modification",
        ),
        (
            "designed_for = { threads = 3, pitch_diameter = 205.0, tip_diameter = 200.0 }\nmodification = \"none\"",
            "auto",
            "invalid-geometry",
            "dresser.designed_for.pitch_diameter",
        ),
        (
            "designed_for = { threads = 3, pitch_diameter = 205.0, normal_module = 4.0 }\nmodification = \"none\"",
            "auto",
            "not-mating",
            "dresser.designed_for.normal_module",
        ),
        (
            "designed_for = { threads = 3, pitch_diameter = 205.0, normal_pressure_angle_deg = { left = 17.5, right = 20.0 } }\nmodification = \"none\"",
            "auto",
            "not-mating",
            "dresser.designed_for.normal_pressure_angle_deg",
        ),
        (
            "designed_for = { threads = 3, pitch_diameter = 9.0 }\nmodification = \"none\"",
            "auto",
            "worm-too-small",
            "dresser.designed_for",
        ),
    ];
    for (dresser, crowning, code, field) in cases {
        let (_, run) = check("job.toml", with(dresser, crowning).as_bytes());
        assert_eq!(run.exit, Some(2), "{code}: {run:?}");
        let error = &run.json()["error"];
        assert_eq!((error["code"].as_str(), error["field"].as_str()), (Some(code), Some(field)), "{error}");
    }
}
