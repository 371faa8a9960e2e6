//! Measured gears as a user meets them: a part evaluated, judged against its job, corrected; and a loop with a simulated machine.

use crate::command::{Run, example, replaced, repository, run};
use serde_json::Value;
use std::path::Path;

fn inspected(arguments: &[&str], out: &Path) -> Run {
    let out = out.display().to_string();
    run(&[&["inspect"], arguments, &["-o", &out, "--json", "--quiet"]].concat())
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// The example of the loop with other things in it, in a directory of its own.
fn loop_job(directory: &Path, changes: &[(&str, &str)]) -> String {
    let path = directory.join("loop.toml");
    std::fs::write(&path, replaced(example("inspection/closed-loop.toml"), changes)).expect("a written job");
    path.display().to_string()
}

#[test]
fn a_loop_ends_below_the_noise() {
    let directory = tempfile::tempdir().unwrap();
    let job = loop_job(directory.path(), &[]);
    let out = directory.path().join("out");
    let run = inspected(&["--job", &job], &out);
    assert_eq!(run.exit, Some(0), "{}", run.stderr);
    let result = run.json();
    let rounds = result["rounds"].as_array().unwrap();
    let rms = |round: &Value, flank: &str| number(&round["flanks"][flank]["measured"]["rms_um"]);
    let (first, last) = (&rounds[0], rounds.last().unwrap());
    assert!(rms(first, "right") > 1.5 && number(&first["flanks"]["right"]["measured"]["largest_um"]) > 4.0);
    for flank in ["left", "right"] {
        // A reading scatters by 0.3 um.
        assert!(rms(last, flank) < 0.3, "{flank}: {}", rms(last, flank));
        // What the referee said before the second part was ground is what was then measured, within the scatter of nine teeth: means of
        // readings scatter by 0.1 um, and slopes of the teeth by as much.
        let told = number(&first["correction"]["proof"][flank]["after"]["rms_um"]);
        assert!((rms(last, flank) - told).abs() < 0.15, "{flank}: {told} {}", rms(last, flank));
    }
    // What was injected comes out with the other sign, within four standard deviations.
    let settings = first["correction"]["settings"].as_array().unwrap();
    for (name, injected) in [("d1_um", 6.0), ("d2_um", 4.0), ("phi1_arcsec", 8.0)] {
        let found = settings.iter().find(|s| s["name"] == name).unwrap_or_else(|| panic!("{name}"));
        let (change, deviation) = (number(&found["change"]), number(&found["deviation"]));
        assert!((change + injected).abs() < 4.0 * deviation, "{name}: {change} of {injected}, {deviation}");
    }
    assert!(last["correction"].is_null() && last["no_correction"].is_string(), "{last}");
    for file in
        ["result.json", "traces.csv", "corrected-job.json", "measured-1.csv", "measured-2.csv", "report.html"]
    {
        assert!(out.join(file).is_file(), "{file}");
    }
    let sheet = std::fs::read_to_string(out.join("sheet.html")).unwrap();
    assert!(sheet.contains("target of the job closed-loop") && sheet.contains("simulated, round 2"));
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    for words in
        ["Measured against the target", "What all teeth share", "What the corrected job leaves", "Round 2"]
    {
        assert!(page.contains(words), "{words}");
    }
}

#[test]
fn report_and_sheet_of_a_file_have_the_language_that_the_command_says() {
    let directory = tempfile::tempdir().unwrap();
    let curves = repository().join("fuzz/seeds/klingelnberg/curves.mka").display().to_string();
    for (arguments, code, sheet_title) in [
        (&[curves.as_str()][..], "en", "Inspection sheet"),
        (&[curves.as_str(), "--language", "de"], "de", "Messblatt"),
    ] {
        let out = directory.path().join(code);
        let run = inspected(arguments, &out);
        assert!(out.join("report.html").is_file(), "{}", run.stderr);
        for (file, words) in [("report.html", "<h1>"), ("sheet.html", sheet_title)] {
            let page = std::fs::read_to_string(out.join(file)).unwrap();
            assert!(
                page.contains(&format!("<html lang=\"{code}\">")) && page.contains(words),
                "{file} {code}"
            );
        }
    }
    let run = inspected(&[&curves, "--language", "fr"], &directory.path().join("fr"));
    assert_eq!(run.exit, Some(2), "{}", run.stderr);
}

#[test]
fn a_measured_file_says_what_the_simulated_machine_said() {
    let directory = tempfile::tempdir().unwrap();
    let job = loop_job(directory.path(), &[("rounds = 2", "rounds = 1")]);
    let [simulated, read, next] = ["simulated", "read", "next"].map(|name| directory.path().join(name));
    let first = inspected(&["--job", &job], &simulated);
    assert_eq!(first.exit, Some(0), "{}", first.stderr);
    let table = simulated.join("measured-1.csv").display().to_string();
    let second = inspected(&[&table, "--job", &job], &read);
    // The first part misses its tolerance.
    assert_eq!(second.exit, Some(3), "{}", second.stderr);
    let (a, b) = (first.json(), second.json());
    assert_eq!(b["reason"]["code"], "tolerance-exceeded");
    assert_eq!(a["rounds"][0], b["rounds"][0]);
    // The corrected job stands by itself: it is planned anywhere, and the machine of the first job measures it to be good.
    let corrected = read.join("corrected-job.json").display().to_string();
    let planned = run(&["plan", &corrected, "--json", "--quiet", "-o", &next.display().to_string()]);
    assert_eq!(planned.exit, Some(0), "{}", planned.stderr);
    let warnings = planned.json()["warnings"].to_string();
    assert!(warnings.contains("compensated"), "{warnings}");
    let again = inspected(&["--job", &corrected], &next);
    assert_eq!(again.exit, Some(0), "{}", again.stderr);
    let round = &again.json()["rounds"][0];
    assert!(round["correction"].is_null(), "{round}");
    assert_eq!(
        serde_json::from_str::<Value>(&std::fs::read_to_string(&corrected).unwrap()).unwrap()["compensation"]
            ["rounds"],
        1
    );
}

#[test]
fn files_of_measuring_machines_are_evaluated_by_themselves() {
    let directory = tempfile::tempdir().unwrap();
    let file = repository().join("examples/inspection/measured.csv").display().to_string();
    let refused = inspected(&[&file], directory.path());
    assert_eq!(refused.exit, Some(2));
    let error = &refused.json()["error"];
    assert!(error["way_out"].as_str().unwrap().contains("--job"), "{error}");
    assert!(!directory.path().join("result.json").exists());
}

#[test]
fn what_does_not_go_together_is_refused() {
    let directory = tempfile::tempdir().unwrap();
    let out = directory.path();
    let measured = "examples/inspection/measured.csv";
    for (arguments, code, told) in [
        (&["--job", "examples/inspection/measured.toml"][..], "missing-key", "inspection.simulated"),
        (&["--job", "examples/skiving/internal-ring.toml"], "missing-key", "switching angles"),
        (&["--job", "examples/inspection/milled.toml"], "missing-key", "name the file"),
        (&[measured, "--job", "examples/milling/spiral-bevel-15.toml"], "invalid-table", "row"),
        (
            &[measured, "--job", "examples/gearbox/feed-to-and-fro.toml"],
            "process-not-available",
            "five-axis-milling",
        ),
        (&["none.mka"], "unreadable-file", "none.mka"),
        (&["README.md"], "unknown-value", ".mka"),
    ] {
        let run = inspected(arguments, out);
        assert_eq!(run.exit, Some(2), "{arguments:?}: {run:?}");
        let error = &run.json()["error"];
        assert_eq!(error["code"], code, "{arguments:?}: {error}");
        assert!(error.to_string().contains(told), "{arguments:?}: {error}");
    }
    let run = run(&["inspect"]);
    assert_eq!(run.exit, Some(2));
    assert!(run.message().contains("<FILE>"), "{}", run.message());
    assert_eq!(std::fs::read_dir(out).unwrap().count(), 0);
}

#[test]
fn a_milled_gear_is_judged_and_answered() {
    let directory = tempfile::tempdir().unwrap();
    let arguments = ["examples/inspection/milled.csv", "--job", "examples/inspection/milled.toml"];
    let judged = inspected(&arguments, directory.path());
    assert_eq!(judged.exit, Some(3), "{judged:?}");
    let text = std::fs::read_to_string(directory.path().join("result.json")).unwrap();
    let result: Value = serde_json::from_str(&text).unwrap();
    let proof = &result["rounds"][0]["correction"]["proof"]["left"];
    let rms = |state: &str| proof[state]["rms_um"].as_f64().unwrap();
    assert!(rms("after") < 0.4 * rms("before"), "{proof}");
    assert_eq!(result["tolerance_class"], 8);
    let corrected = directory.path().join("corrected-job.json").display().to_string();
    let checked = run(&["check", &corrected]);
    assert_eq!(checked.exit, Some(0), "{checked:?}");
}

#[test]
fn a_measurement_of_another_gear_is_refused() {
    let directory = tempfile::tempdir().unwrap();
    let out = directory.path().display().to_string();
    let converted =
        run(&["convert", "examples/automotive-bias.toml", "--date", "2026-03-14T09:30:00Z", "-o", &out]);
    assert_eq!(converted.exit, Some(0), "{}", converted.stderr);
    let model = directory.path().join("automotive-bias.rexs").display().to_string();
    let job = "examples/inspection/measured.toml";
    let refused = inspected(&[&model, "--job", job], &directory.path().join("out"));
    assert_eq!((refused.exit, &refused.json()["error"]["code"]), (Some(2), &Value::from("other-gear")));
    assert_eq!(refused.json()["error"]["field"], "gear.teeth");
}

/// The example's table with other lines.
fn table(directory: &Path, keep: impl Fn(&str) -> Option<String>) -> String {
    let text = std::fs::read_to_string(repository().join("examples/inspection/measured.csv")).unwrap();
    let path = directory.join("table.csv");
    std::fs::write(&path, text.lines().filter_map(keep).map(|line| line + "\n").collect::<String>()).unwrap();
    path.display().to_string()
}

#[test]
fn what_was_not_measured_is_not_judged() {
    let directory = tempfile::tempdir().unwrap();
    let out = directory.path().join("out");
    let job = directory.path().join("job.toml");
    let wide =
        replaced(example("inspection/measured.toml"), &[("tolerance_um = 1.0", "tolerance_um = 50.0")]);
    std::fs::write(&job, &wide).unwrap();
    let job = job.display().to_string();
    let judged = |keep: &dyn Fn(&str) -> bool| {
        let table = table(directory.path(), |line| keep(line).then(|| line.to_owned()));
        let run = inspected(&[&table, "--job", &job], &out);
        let result = run.json();
        assert_ne!(result["status"], "met", "{}", run.stderr);
        (run.exit, result["reason"]["code"].as_str().unwrap().to_owned(), result)
    };
    // The whole table keeps a wide tolerance.
    let whole = table(directory.path(), |line| Some(line.to_owned()));
    let met = inspected(&[&whole, "--job", &job], &out);
    assert_eq!((met.exit, &met.json()["status"]), (Some(0), &Value::from("met")));
    // Profiles alone are no surface; nothing is corrected that could not be proven.
    let (exit, code, result) = judged(&|line| !line.starts_with("helix"));
    assert_eq!((exit, code.as_str()), (Some(3), "not-judged"));
    assert!(result["rounds"][0]["correction"].is_null());
    assert!(!out.join("corrected-job.json").exists());
    let (exit, code, _) = judged(&|line| !line.contains(",right,"));
    assert_eq!((exit, code.as_str()), (Some(3), "not-judged"));
    // With the tolerance of the example the lines alone miss it.
    let strict = "examples/inspection/measured.toml";
    let profiles = table(directory.path(), |line| (!line.starts_with("helix")).then(|| line.to_owned()));
    let run = inspected(&[&profiles, "--job", strict], &out);
    assert_eq!((run.exit, &run.json()["status"]), (Some(3), &Value::from("missed")), "{}", run.stdout);
    // One trace that is none keeps nothing else out.
    let lone = table(directory.path(), |line| {
        let first = line.starts_with("profile,1,left,-16");
        (!first || line.contains(",4.1050,")).then(|| line.to_owned())
    });
    let run = inspected(&[&lone, "--job", strict], &out);
    assert_eq!(run.exit, Some(3), "{}", run.stdout);
    let result = run.json();
    assert!(result["rounds"][0]["correction"].is_object(), "{}", result["rounds"][0]["no_correction"]);
    assert!(result["warnings"].to_string().contains("tooth 1"), "{}", result["warnings"]);
    // Teeth that the gear does not have.
    let many = table(directory.path(), |line| Some(line.replace(",1,left,", ",99,left,")));
    let run = inspected(&[&many, "--job", strict], &out);
    assert_eq!((run.exit, &run.json()["error"]["field"]), (Some(2), &Value::from("tooth")));
}

#[test]
fn bands_judge_or_say_why_not() {
    let directory = tempfile::tempdir().unwrap();
    let out = directory.path().join("out");
    let run = |band: &str| {
        let job = directory.path().join("job.toml");
        let wide = [("tolerance_um = 1.0", "tolerance_um = 50.0")];
        let text = replaced(example("inspection/measured.toml"), &wide) + band;
        std::fs::write(&job, text).unwrap();
        let job = job.display().to_string();
        inspected(&["examples/inspection/measured.csv", "--job", &job], &out)
    };
    let far =
        run("helix_band = { at_mm = [100.0, 200.0], lower_um = [-5.0, -5.0], upper_um = [5.0, 5.0] }\n");
    assert_eq!((far.exit, &far.json()["reason"]["code"]), (Some(3), &Value::from("not-judged")));
    let narrow =
        run("helix_band = { at_mm = [-20.0, 20.0], lower_um = [-0.1, -0.1], upper_um = [0.1, 0.1] }\n");
    assert_eq!((narrow.exit, &narrow.json()["reason"]["code"]), (Some(3), &Value::from("outside-the-band")));
    let sheet = std::fs::read_to_string(out.join("sheet.html")).unwrap();
    assert!(sheet.contains("≥ 0.0"), "no band on the sheet");
    let wide =
        run("helix_band = { at_mm = [-20.0, 20.0], lower_um = [-50.0, -50.0], upper_um = [50.0, 50.0] }\n");
    assert_eq!(wide.exit, Some(0), "{}", wide.stdout);
    let held = run(
        "helix_band = { at_mm = [-20.0, 20.0], lower_um = [-5.0, -5.0], upper_um = [5.0, 5.0], held_at_mm = 30.0 }\n",
    );
    let error = &held.json()["error"];
    assert_eq!((held.exit, &error["field"]), (Some(2), &Value::from("inspection.helix_band.held_at_mm")));
}

#[test]
fn a_line_that_is_measured_twice_is_two_readings_of_a_tooth() {
    let directory = tempfile::tempdir().unwrap();
    let once = inspected(
        &["examples/inspection/measured.csv", "--job", "examples/inspection/measured.toml"],
        &directory.path().join("once"),
    );
    let text = std::fs::read_to_string(repository().join("examples/inspection/measured.csv")).unwrap();
    let twice = directory.path().join("twice.csv");
    // A machine that goes round once more, with another zero.
    let mut lines = String::new();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        match line.rsplit_once(',').map(|(place, f)| (place, f.parse::<f64>())) {
            Some((place, Ok(f))) => lines += &format!("{line},1\n{place},{},2\n", f + 3.0),
            _ => lines += &format!("{line},reading\n"),
        }
    }
    std::fs::write(&twice, lines).unwrap();
    let run = inspected(
        &[&twice.display().to_string(), "--job", "examples/inspection/measured.toml"],
        &directory.path().join("twice"),
    );
    assert_eq!(run.exit, Some(3), "{}", run.stderr);
    let (a, b) = (once.json(), run.json());
    let (first, second) = (&a["rounds"][0], &b["rounds"][0]);
    let pairs = first["characteristics"].as_array().unwrap().iter();
    for (one, two) in pairs.zip(second["characteristics"].as_array().unwrap()) {
        assert_eq!((&one["repeats"], &two["repeats"]), (&Value::from(1), &Value::from(2)));
        for (x, y) in one["values_um"].as_array().unwrap().iter().zip(two["values_um"].as_array().unwrap()) {
            assert!((number(x) - number(y)).abs() < 1e-9, "{one} {two}");
        }
    }
    // Teeth count once, however often each is measured: what is known of the correction stays as uncertain.
    let settings = |round: &Value| {
        let all = round["correction"]["settings"].as_array().unwrap().clone();
        all.into_iter().filter(|setting| setting["dropped"] == false).collect::<Vec<Value>>()
    };
    let (of_one, of_two) = (settings(first), settings(second));
    assert!(!of_one.is_empty() && of_one.len() == of_two.len());
    for (one, two) in of_one.iter().zip(&of_two) {
        for key in ["change", "deviation"] {
            assert!((number(&one[key]) - number(&two[key])).abs() < 1e-6, "{key}: {one} {two}");
        }
    }
    let measured = |round: &Value| number(&round["flanks"]["left"]["measured"]["rms_um"]);
    assert!((measured(first) - measured(second)).abs() < 1e-9);
    for (one, two) in a["summary"].as_array().unwrap().iter().zip(b["summary"].as_array().unwrap()) {
        assert_eq!(one["teeth"], two["teeth"]);
        assert!((number(&one["mean_um"]) - number(&two["mean_um"])).abs() < 1e-9, "{one} {two}");
    }
    assert_eq!(a["class"], b["class"]);
}

#[test]
fn twist_is_told_by_profiles_by_leads_or_not_at_all() {
    let directory = tempfile::tempdir().unwrap();
    let out = directory.path().join("out");
    let job = "examples/inspection/measured.toml";
    let whole = inspected(&["examples/inspection/measured.csv", "--job", job], &out).json();
    let rows = whole["twist"].as_array().unwrap();
    assert_eq!(rows.len(), 16);
    for row in rows {
        let [a, b] = ["S_by_profiles_um", "S_by_leads_um"].map(|key| number(&row[key]));
        assert!((number(&row["difference_um"]) - (a - b)).abs() < 1e-12, "{row}");
        // The same twist, up to the scatter of single traces and to what is no bilinear twist.
        assert!((a - b).abs() < 3.0, "{row}");
    }
    let warned = |of: &Value| of["warnings"].to_string().contains("twist-not-measured");
    assert!(!warned(&whole));
    // One profile and one helix trace tell nothing of it.
    let middle = table(directory.path(), |line| {
        let outer = ["-16.0000", "16.0000", "5.9846", "21.0213"];
        let place = line.split(',').nth(3).unwrap_or_default().to_owned();
        (!outer.contains(&place.as_str())).then(|| line.to_owned())
    });
    let run = inspected(&[&middle, "--job", job], &out);
    let result = run.json();
    assert!(warned(&result) && result["twist"].is_null(), "{}", result["warnings"]);
    let tested = result["rounds"][0]["characteristics"].as_array().unwrap();
    assert!(!tested.is_empty() && tested.iter().all(|of| of["characteristic"] != "S"));
    // What the lines do not see is not turned, and nothing is proposed that the referee does not confirm.
    let correction = &result["rounds"][0]["correction"];
    for setting in correction["settings"].as_array().unwrap_or(&Vec::new()) {
        let twist = setting["name"].as_str().unwrap().starts_with("twist");
        assert!(!twist || setting["dropped"] == true, "{setting}");
    }
    for (flank, proof) in correction["proof"].as_object().unwrap_or(&serde_json::Map::new()) {
        assert!(
            number(&proof["after"]["rms_um"]) < number(&proof["before"]["rms_um"]) + 0.05,
            "{flank}: {proof}"
        );
    }
}

/// Common part and decision of a characteristic in the first round.
fn tested(result: &Value, flank: &str, characteristic: &str) -> (f64, String) {
    let all = result["rounds"][0]["characteristics"].as_array().unwrap();
    let found = all.iter().find(|of| of["flank"] == flank && of["characteristic"] == characteristic);
    let found = found.unwrap_or_else(|| panic!("{characteristic} of the {flank} flank"));
    (number(&found["common_um"]), found["decision"].as_str().unwrap().to_owned())
}

#[test]
fn the_middle_of_a_flank_is_found_wherever_the_lines_lie() {
    let directory = tempfile::tempdir().unwrap();
    let out = directory.path().join("out");
    let job = "examples/inspection/measured.toml";
    let whole = inspected(&["examples/inspection/measured.csv", "--job", job], &out).json();
    let moved = |text: &str, by: f64| {
        let cells: Vec<&str> = text.split(',').collect();
        let ["profile" | "helix", tooth, flank, position, abscissa, f] = cells[..] else {
            return text.to_owned();
        };
        // No two teeth are probed at quite the same place.
        let away = by * (1.7 * tooth.parse::<f64>().unwrap() + position.len() as f64).sin();
        let position = position.parse::<f64>().unwrap() + away;
        format!("{},{tooth},{flank},{position},{abscissa},{f}", cells[0])
    };
    for by in [1e-9, 4e-4, 0.02] {
        let file = table(directory.path(), |line| Some(moved(line, by)));
        let result = inspected(&[&file, "--job", job], &out).json();
        assert_eq!(result["class"], whole["class"], "{by}");
        for flank in ["left", "right"] {
            for characteristic in ["fHa", "Ca", "fHb", "Cb", "S"] {
                let (a, b) = (tested(&whole, flank, characteristic), tested(&result, flank, characteristic));
                assert!(
                    (a.0 - b.0).abs() < 0.02 && a.1 == b.1,
                    "{by}, {flank} {characteristic}: {a:?} {b:?}"
                );
            }
        }
    }
    // Two profiles towards the ends: the middle lies between them, not at one of them.
    let outer = table(directory.path(), |line| {
        let other = ["0.0000", "5.9846", "21.0213"].map(Some);
        (!other.contains(&line.split(',').nth(3))).then(|| line.to_owned())
    });
    let profiles = std::fs::read_to_string(&outer).unwrap();
    assert!(profiles.contains("profile,1,left,-16") && !profiles.contains("profile,1,left,0"));
    let result = inspected(&[&outer, "--job", job], &out).json();
    for flank in ["left", "right"] {
        let (a, b) = (tested(&whole, flank, "fHa"), tested(&result, flank, "fHa"));
        // What is no bilinear twist and the scatter of two lines: the lower profile alone lies 1.8 um off.
        assert!((a.0 - b.0).abs() < 0.4, "{flank}: {a:?} {b:?}");
    }
}

#[test]
fn one_bad_tooth_is_not_lost_in_the_mean() {
    let directory = tempfile::tempdir().unwrap();
    let job = loop_job(directory.path(), &[]);
    let simulated = directory.path().join("simulated");
    assert_eq!(inspected(&["--job", &job], &simulated).exit, Some(0));
    let text = std::fs::read_to_string(simulated.join("measured-2.csv")).unwrap();
    let judged = |change: &dyn Fn(&[&str]) -> String| {
        let lines: Vec<String> =
            text.lines().map(|line| change(&line.split(',').collect::<Vec<&str>>())).collect();
        let file = directory.path().join("part.csv");
        std::fs::write(&file, lines.join("\n") + "\n").unwrap();
        let run = inspected(&[&file.display().to_string(), "--job", &job], &directory.path().join("read"));
        (run.exit, run.json())
    };
    let (exit, result) = judged(&|cells| cells.join(","));
    assert_eq!(exit, Some(0), "{}", result["reason"]);
    // Places that were rounded are short of the field by less than a step.
    let (exit, result) = judged(&|cells| {
        let rounded = |cell: &&str| match cell.parse::<f64>() {
            Ok(number) if cell.len() > 7 => format!("{number:.4}"),
            _ => (*cell).to_owned(),
        };
        cells.iter().map(rounded).collect::<Vec<String>>().join(",")
    });
    assert_eq!(exit, Some(0), "{}", result["reason"]);
    // A slope of 8 um on one tooth moves the mean of nine by less than one.
    let (exit, result) = judged(&|cells| match cells {
        ["helix", tooth, "left", position, abscissa, f] if *tooth == "1" => {
            let f: f64 = f.parse::<f64>().unwrap() + 0.2 * abscissa.parse::<f64>().unwrap();
            format!("helix,1,left,{position},{abscissa},{f}")
        }
        _ => cells.join(","),
    });
    assert_eq!(exit, Some(3));
    let told = result["warnings"].to_string() + &result["reason"].to_string();
    assert!(told.contains("tooth-stands-out") && told.contains("tooth 1 of the left flank"), "{told}");
}

#[test]
fn a_job_that_varies_its_ratio_has_a_verdict_without_correction() {
    let directory = tempfile::tempdir().unwrap();
    let planned = directory.path().join("planned");
    let job = "examples/variable-ratio.toml";
    let plan = run(&["plan", job, "--json", "--quiet", "-o", &planned.display().to_string()]);
    assert_eq!(plan.exit, Some(0), "{}", plan.stderr);
    // What the referee saw, as a measured field.
    let result = plan.json();
    let flank = &result["flanks"]["right"];
    let list = |key: &str| flank[key].as_array().unwrap_or_else(|| panic!("{key} of {flank}")).clone();
    let mut text = String::from("tooth,flank,w_mm,z_mm,f_um\n");
    for (w, row) in list("w_mm").iter().zip(list("simulated_um")) {
        for (z, f) in list("z_mm").iter().zip(row.as_array().unwrap()) {
            text += &format!("1,right,{},{},{}\n", number(w), number(z), number(f));
        }
    }
    let file = directory.path().join("field.csv");
    std::fs::write(&file, text).unwrap();
    let run = inspected(&[&file.display().to_string(), "--job", job], &directory.path().join("out"));
    let result = run.json();
    assert_eq!(run.exit, Some(0), "{}: {}", run.stderr, result["reason"]);
    let told = result["rounds"][0]["no_correction"].as_str().unwrap();
    assert!(told.contains("constant diagonal ratio"), "{told}");
}

#[test]
fn statements_are_read_and_belong_to_measured_gears() {
    let directory = tempfile::tempdir().unwrap();
    let out = directory.path().join("out");
    let measured = "examples/inspection/measured.csv";
    let job = "examples/inspection/measured.toml";
    let run = inspected(&[measured, "--job", job, "--from-other-end", "--slope-signs", "-+"], &out);
    let stated = run.json()["stated"].to_string();
    assert!(stated.contains("other end") && stated.contains("-1 left, +1 right"), "{stated}");
    for (arguments, told) in [
        (&["--job", "examples/inspection/closed-loop.toml", "--from-other-end"][..], "leave them out"),
        (&[measured, "--job", job, "--slope-signs", "+"], "din"),
        (&[measured, "--job", job, "--datum-face", "top"], "+z"),
    ] {
        let run = inspected(arguments, &out);
        assert_eq!(run.exit, Some(2), "{arguments:?}");
        assert!((run.stderr.clone() + &run.stdout).contains(told), "{arguments:?}: {run:?}");
    }
    let name = directory.path().display().to_string();
    let converted = crate::command::run(&["convert", "examples/automotive-bias.toml", "-o", &name]);
    assert_eq!(converted.exit, Some(0), "{}", converted.stderr);
    let model = directory.path().join("automotive-bias.rexs").display().to_string();
    let run = inspected(&[&model, "--from-other-end"], &out);
    assert_eq!((run.exit, &run.json()["error"]["field"]), (Some(2), &Value::from("from_other_end")));
}

#[test]
fn gears_pass_to_rexs_and_back() {
    let directory = tempfile::tempdir().unwrap();
    let out = directory.path().display().to_string();
    let job = "examples/twist-free-crowning.toml";
    for (form, ending) in [("rexs", "rexs"), ("rexsj", "rexsj"), ("rexsz", "rexsz")] {
        let to =
            |out: &str| run(&["convert", job, "--form", form, "--date", "2026-03-14T09:30:00Z", "-o", out]);
        assert_eq!(to(&out).exit, Some(0));
        let model = directory.path().join(format!("twist-free-crowning.{ending}"));
        let first = std::fs::read(&model).unwrap();
        let name = model.display().to_string();
        let back = run(&["convert", &name, "--job", job]);
        assert_eq!(back.exit, Some(0), "{}", back.stderr);
        let original = run(&["check", job, "--json"]).json();
        let path = directory.path().join("back.json");
        std::fs::write(&path, &back.stdout).unwrap();
        // The whole job is checked as before, and what goes out again is the same file but for the name of the job.
        let checked = run(&["check", &path.display().to_string(), "--json"]);
        assert_eq!(checked.exit, Some(0), "{}", checked.stderr);
        let gear = |of: &Value| of["gear"].clone();
        assert_eq!(gear(&original), gear(&checked.json()), "{form}");
        std::fs::rename(&path, directory.path().join("twist-free-crowning.json")).unwrap();
        let again = directory.path().join("twist-free-crowning.json").display().to_string();
        let second = run(&["convert", &again, "--form", form, "--date", "2026-03-14T09:30:00Z", "-o", &out]);
        assert_eq!(second.exit, Some(0), "{}", second.stderr);
        assert!(first == std::fs::read(&model).unwrap(), "{form}");
    }
    let refused = run(&["convert", job, "--gear", "3", "--json"]);
    assert_eq!((refused.exit, &refused.json()["error"]["field"]), (Some(2), &Value::from("--gear")));
    let refused = run(&["convert", job, "--form", "rexsz", "--json"]);
    assert_eq!((refused.exit, &refused.json()["error"]["field"]), (Some(2), &Value::from("-o")));
    let refused = run(&["convert", job, "--date", "yesterday"]);
    assert!(refused.exit == Some(2) && refused.message().contains("2026-03-14T09:30:00Z"), "{refused:?}");
}

#[test]
fn settings_of_a_job_with_tables_are_run_elsewhere() {
    let directory = tempfile::tempdir().unwrap();
    let [planned, simulated] =
        ["planned", "simulated"].map(|name| directory.path().join(name).display().to_string());
    let plan = run(&["plan", "examples/variable-ratio.toml", "--json", "--quiet", "-o", &planned]);
    assert_eq!(plan.exit, Some(0), "{}", plan.stderr);
    let settings = format!("{planned}/settings.json");
    let again = run(&["simulate", &settings, "--json", "--quiet", "-o", &simulated]);
    assert_eq!(again.exit, Some(0), "{}", again.stdout);
    let worst = |run: &Run| number(&run.json()["flanks"]["right"]["max_deviation_um"]);
    assert!((worst(&plan) - worst(&again)).abs() < 1e-6);
}
