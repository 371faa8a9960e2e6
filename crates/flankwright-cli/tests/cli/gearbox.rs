//! Jobs of the electronic gearbox at the command line: what `check` derives, the table of reference pulses, what `gearbox` makes of
//! them, and the commands that do not take them.

use crate::command::{Run, example, repository, run, run_with};
use serde_json::Value;
use std::path::Path;

/// The template with a table of reference pulses in place of its motion.
fn job_with_table(directory: &Path, table: &str) -> String {
    let template = run(&["new", "electronic-gearbox"]).stdout;
    let (begin, end) = (template.find("motion = [").unwrap(), template.find("# start").unwrap());
    let text = format!("{}references = \"train.csv\"\n{}", &template[..begin], &template[end..]);
    std::fs::write(directory.join("train.csv"), table).unwrap();
    let path = directory.join("job.toml");
    std::fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn check_derives_pitch_speed_and_lead() {
    let job = run(&["new", "electronic-gearbox"]).stdout;
    let derived = run_with(&["check", "-", "--json"], job.as_bytes()).json()["derived"].take();
    assert_eq!(derived["feed"]["pitch_mm"], 0.01);
    // 1 MHz, 10 um, 16 pulses: 625 mm/s.
    assert_eq!(derived["feed"]["greatest_speed_mm_per_min"], 37500.0);
    // pi 2.5 40/sin(20 deg)
    let lead = derived["gear"]["lead_mm"].as_f64().unwrap();
    assert!((lead - 918.540_242_4).abs() < 1e-6, "{lead}");
    let human = run_with(&["check", "-"], job.as_bytes());
    assert!(human.stdout.contains("greatest speed v_max"), "{human:?}");
    let spur = job.replace("helix_angle_deg = 20.0", "helix_angle_deg = 0.0");
    let answer = run_with(&["check", "-", "--json"], spur.as_bytes());
    assert_eq!(answer.exit, Some(0));
    assert!(answer.json()["derived"]["gear"].is_null());
}

#[test]
fn check_reads_the_table_of_reference_pulses() {
    let directory = tempfile::tempdir().unwrap();
    let path = job_with_table(directory.path(), "tick,sign\n100,1\n260,1\n420,-1\n");
    let sound = run(&["check", "--json", &path]);
    assert_eq!(sound.exit, Some(0), "{sound:?}");
    assert_eq!(sound.json()["derived"]["stimulus"]["reference_pulses"], 3);

    let path = job_with_table(directory.path(), "tick,sign\n100,1\n260,up\n");
    let (human, machine) = (run(&["check", &path]), run(&["check", "--json", &path]));
    assert_eq!((human.exit, machine.exit), (Some(2), Some(2)));
    let error = machine.json()["error"].take();
    assert_eq!((&error["line"], &error["column"]), (&3.into(), &5.into()), "{error}");
    assert_eq!((&error["code"], &error["field"]), (&"invalid-number".into(), &"sign".into()));
    assert!(error["file"].as_str().unwrap().ends_with("train.csv"));
    assert!(human.message().contains("train.csv:3:5"), "{}", human.stderr);

    std::fs::remove_file(directory.path().join("train.csv")).unwrap();
    assert_eq!(run(&["check", "--json", &path]).json()["error"]["code"], "unreadable-file");
}

#[test]
fn other_commands_name_the_one_that_takes_the_job() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("job.toml");
    std::fs::write(&path, run(&["new", "electronic-gearbox"]).stdout).unwrap();
    let path = path.to_str().unwrap();
    let program = directory.path().join("program.ngc");
    std::fs::write(&program, "G21 G90\nG1 Z1 F100\nM2\n").unwrap();
    let machine = repository().join("machines/no-swivel.toml");
    let checked = [
        "program",
        "check",
        program.to_str().unwrap(),
        "--machine",
        machine.to_str().unwrap(),
        "--dialect",
        "linuxcnc",
        "--job",
        path,
    ];
    for arguments in [&["plan", path][..], &["simulate", path], &["explore", path], &checked] {
        let (human, answer) = (run(arguments), run(&[arguments, &["--json"]].concat()));
        assert_eq!((human.exit, answer.exit), (Some(2), Some(2)), "{human:?}");
        let error = answer.json()["error"].take();
        assert_eq!(
            (&error["code"], &error["field"]),
            (&"process-not-available".into(), &"job.process".into()),
            "{error}"
        );
        assert!(error["line"].is_u64(), "{error}");
        assert!(human.message().contains("flankwright gearbox FILE"), "{}", human.stderr);
    }
    assert_eq!(std::fs::read_dir(directory.path()).unwrap().count(), 2);
}

/// Runs a job text; its answer with `--json`.
fn gearbox(text: &str, directory: &Path) -> Run {
    run_with(&["gearbox", "-", "--json", "-o", directory.to_str().unwrap()], text.as_bytes())
}

/// Least and greatest of a range in um.
fn ends(range: &Value) -> [f64; 2] {
    [range["least_um"].as_f64().unwrap(), range["greatest_um"].as_f64().unwrap()]
}

#[test]
fn a_known_train_has_its_counters_and_every_pulse_traced() {
    // "constant speed" of tests/reference/70-gearbox.json.
    let directory = tempfile::tempdir().unwrap();
    let out = directory.path().to_str().unwrap();
    let human = run(&["gearbox", "examples/gearbox/reference-train.toml", "-o", out]);
    assert_eq!(human.exit, Some(0), "{human:?}");
    assert!(human.stdout.contains("5 reference pulses, 59 intermediate, 16 corrections: 80 pulses, net 80"));
    let text = std::fs::read_to_string(directory.path().join("result.json")).unwrap();
    let result: Value = serde_json::from_str(&text).unwrap();
    let pulses = &result["pulses"];
    let keys = ["pulses", "references", "intermediates", "corrections", "net_pulses", "overruns", "too_fast"];
    assert_eq!(keys.map(|key| pulses[key].as_i64().unwrap()), [80, 5, 59, 16, 80, 0, 0]);
    let table = std::fs::read_to_string(directory.path().join("pulses.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().skip(1).map(|line| line.split(',').collect()).collect();
    let kinds: String = rows.iter().map(|row| row[3]).collect();
    assert_eq!(kinds, "RRKKKKKKKKKKKKKKKZZZZZZZZZZZZZZRKZZZZZZZZZZZZZZZRZZZZZZZZZZZZZZZRZZZZZZZZZZZZZZZ");
    assert_eq!((rows[1][0], rows[2][0], rows[79][0]), ("260", "261", "890"));
    let turned: i64 = rows.iter().map(|row| row[4].parse::<i64>().unwrap()).sum();
    let (whole, rest) = (&pulses["rotation_workpiece_pulses"], &pulses["rotation_rest_parts"]);
    assert_eq!(16 * whole.as_i64().unwrap() + rest.as_i64().unwrap(), turned);
    // floor(80 B/2^18) parts.
    let word = result["coupling"]["coefficient_word"].as_i64().unwrap();
    assert_eq!(turned, (80 * word) >> 18);
}

#[test]
fn errors_keep_to_their_limits_and_both_senses_agree() {
    let directory = tempfile::tempdir().unwrap();
    let no_backlash = example("gearbox/feed-to-and-fro.toml");
    let one_way = no_backlash.replace("\"no-backlash\"", "\"one-way\"");
    for (text, offset) in [(&no_backlash, -0.1..0.1), (&one_way, 9.0..9.6)] {
        let answer = gearbox(text, directory.path());
        assert_eq!(answer.exit, Some(0), "{answer:?}");
        let result = answer.json();
        let along = &result["along_feed"];
        assert_eq!(along["within_bound"], true, "{along}");
        assert_eq!(result["angle"]["within_bound"], true, "{}", result["angle"]);
        let ([least, greatest], [lower, upper]) = (ends(&along["steady"]), ends(&along["steady_bound"]));
        // The limits are near: nearly all of them is used.
        assert!(lower < least && greatest < upper && greatest - least > 0.9 * (upper - lower), "{along}");
        let found = along["direction_offset_um"].as_f64().unwrap();
        assert!(offset.contains(&found), "{found}");
        let share = result["coupling"]["flank_um_per_feed_um"].as_f64().unwrap();
        let flank = along["direction_offset_flank_um"].as_f64().unwrap();
        assert!((flank - share * found).abs() < 1e-12 && (share - 0.321_393_8).abs() < 1e-6);
        // There and back.
        assert_eq!(result["pulses"]["net_references"], 0);
    }
}

#[test]
fn document_and_summary_agree_and_repeat() {
    let text = example("gearbox/following-with-disturbances.toml");
    let directories = [tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap()];
    let [first, second] = directories.each_ref().map(|directory| {
        let out = directory.path().to_str().unwrap();
        run_with(&["gearbox", "-", "-o", out], text.as_bytes())
    });
    assert_eq!((first.exit, second.exit), (Some(0), Some(0)), "{first:?}");
    let read = |k: usize, name: &str| std::fs::read(directories[k].path().join(name)).unwrap();
    for name in ["report.html", "errors.csv", "servo.csv"] {
        assert!(read(0, name) == read(1, name), "{name}");
    }
    let [mut a, mut b] = [0, 1].map(|k| serde_json::from_slice::<Value>(&read(k, "result.json")).unwrap());
    assert!(a["timing_s"].take() != Value::Null && b["timing_s"].take() != Value::Null);
    assert_eq!(a, b);
    let servo = &a["servo"];
    let number = |key: &str| servo["workpiece"][key].as_f64().unwrap();
    let line = format!("workpiece rms {:.4} um, peak {:.4} um", number("rms_um"), number("peak_um"));
    assert!(first.stdout.contains(&line), "{line}: {}", first.stdout);
    assert!(number("rms_um") > 0.0 && number("rms_um") < number("peak_um"));
    let quiet =
        run_with(&["gearbox", "-", "-q", "-o", directories[0].path().to_str().unwrap()], text.as_bytes());
    assert_eq!((quiet.stdout.as_str(), quiet.stderr.as_str()), ("", ""));
}

#[test]
fn the_cheapest_set_up_is_accurate_enough_or_the_largest_part_is_named() {
    let directory = tempfile::tempdir().unwrap();
    let text = example("gearbox/cheapest-set-up.toml");
    let result = gearbox(&text, directory.path()).json();
    let explored = &result["explore"];
    let all = explored["set_ups"].as_array().unwrap();
    assert_eq!((all.len(), &result["status"]), (36, &"met".into()));
    let best = &explored["best"];
    let um = |set_up: &Value| set_up["flank_um"].as_f64().unwrap();
    let cost = |set_up: &Value| set_up["cost"].as_f64().unwrap();
    assert_eq!((&best["rank"], &best["feasible"]), (&1.into(), &true.into()));
    for set_up in all {
        let accurate = um(set_up) <= 0.3;
        assert_eq!(set_up["feasible"], accurate, "{set_up}");
        assert!(!accurate || cost(set_up) >= cost(best), "{set_up}");
        let parts = [
            "quantisation_um",
            "clock_um",
            "acceleration_um",
            "resolution_um",
            "rounding_um",
            "measuring_um",
        ];
        let sum: f64 = parts.map(|key| set_up[key].as_f64().unwrap()).iter().sum();
        assert!((sum - um(set_up)).abs() < 1e-12, "{set_up}");
    }
    assert!(best["measured_steady_um"].as_f64().unwrap() <= um(best), "{best}");

    let missed = text.replace("wanted_um = 0.3", "wanted_um = 0.001");
    let answer = gearbox(&missed, directory.path());
    assert_eq!((answer.exit, &answer.json()["status"]), (Some(3), &"missed".into()));
    assert_eq!(answer.json()["reason"]["code"], "no-set-up-accurate-enough");
    let quiet =
        run_with(&["gearbox", "-", "-q", "-o", directory.path().to_str().unwrap()], missed.as_bytes());
    assert!(quiet.stderr.contains("no set-up reaches 0.001 um"), "{quiet:?}");
    // A rate multiplier of 18 bits cannot make b >= 1: those set-ups say so.
    let coarse =
        text.replace("pulses_per_revolution = 36000\n", "pulses_per_revolution = 9000\nrate = \"binary\"\n");
    let coarse = coarse.replace("pulses_per_metre = 50000,", "pulses_per_metre = 20000,");
    let result = gearbox(&coarse, directory.path()).json();
    let refused = result["explore"]["set_ups"].as_array().unwrap().iter();
    let refused = refused.filter(|s| s["refused"] == "coefficient-too-large");
    assert_eq!(
        refused.filter(|s| s["pulses_per_metre"] == 20000.0 && s["pulses_per_revolution"] == 36000).count(),
        6
    );
}

#[test]
fn a_feed_too_fast_is_an_alarm_and_no_error() {
    let directory = tempfile::tempdir().unwrap();
    // 300 mm/min pass a line of 10 um in 2 ms: 14 ticks for 16 pulses.
    let text = example("gearbox/feed-to-and-fro.toml").replace("clock_hz = 1e6", "clock_hz = 7e3");
    let answer = gearbox(&text, directory.path());
    let result = answer.json();
    assert_eq!(answer.exit, Some(0));
    assert!(result["pulses"]["too_fast"].as_u64().unwrap() > 0, "{}", result["pulses"]);
    assert_eq!(result["warnings"][0]["code"], "interpolator-too-fast");
    assert!(result["along_feed"]["bound"].is_null());
}

/// Motions of 300 mm/min (v_max is 37500 mm/min) that turn on a line of the scale: to and fro, 40 strokes, a vibration about a line.
#[test]
fn a_slide_that_turns_on_a_line_alarms_nothing() {
    let directory = tempfile::tempdir().unwrap();
    let travel =
        |to: f64| format!("{{ to = {to}, speed_mm_per_min = 300.0, acceleration_mm_per_s2 = 200.0 }},");
    let strokes = |count: usize, ends: [f64; 2]| (0..count).map(|k| travel(ends[k % 2])).collect::<String>();
    let text = example("gearbox/feed-to-and-fro.toml");
    let (begin, end) = (text.find("motion = [").unwrap() + 10, text.rfind(']').unwrap());
    for mode in ["no-backlash", "one-way"] {
        for motion in [strokes(2, [6.0, 0.003]), strokes(40, [1.0, 0.5]), strokes(40, [1.0, 0.9993])] {
            let text = format!("{}{motion}{}", &text[..begin], &text[end..]).replace("no-backlash", mode);
            let result = gearbox(&text, directory.path()).json();
            assert_eq!(result["pulses"]["too_fast"], 0, "{mode} {motion}: {}", result["pulses"]);
            assert_eq!(result["pulses"]["overruns"], 0, "{mode} {motion}: {}", result["pulses"]);
        }
    }
}

/// What a tolerance is worth: the same jobs without one are told and not judged.
#[test]
fn a_tolerance_judges_rotation_pulses_and_servo() {
    let directory = tempfile::tempdir().unwrap();
    let target = |text: &str, um: f64| format!("{text}\n[target]\ntolerance_um = {um}\n");
    let reasons = |text: &str, exit: i32, status: &str| {
        let answer = gearbox(text, directory.path());
        let result = answer.json();
        assert_eq!((answer.exit, &result["status"]), (Some(exit), &status.into()), "{result}");
        assert_eq!(result["accepted"], exit == 0);
        result
    };
    let feed = example("gearbox/feed-to-and-fro.toml");
    let untold = reasons(&feed, 0, "not_judged");
    assert_eq!(untold["scope"]["judged"].as_array().unwrap().len(), 0);
    assert_eq!(untold["scope"]["not_judged"][0]["asked"], false);
    let met = reasons(&target(&feed, 5.0), 0, "met");
    assert_eq!((met["tolerance_um"].as_f64(), met["reason"].is_null()), (Some(5.0), true));
    assert_eq!(reasons(&target(&feed, 0.1), 3, "missed")["reason"]["code"], "rotation-misses-lead");

    // 45 m/min where the interpolator follows 37.5: alarms, and 2 mm at the flank.
    let fast = feed.replace(
        "to = 6.0, speed_mm_per_min = 300.0, acceleration_mm_per_s2 = 200.0",
        "to = 60.0, speed_mm_per_min = 45000.0, acceleration_mm_per_s2 = 20000.0",
    );
    reasons(&fast, 0, "not_judged");
    let missed = reasons(&target(&fast, 5.0), 3, "missed");
    assert_eq!(missed["reason"]["code"], "interpolator-too-fast");
    let items = missed["scope"]["judged"].as_array().unwrap();
    assert!(
        items
            .iter()
            .any(|i| i["item"] == "rotation at the flank over the whole motion" && i["status"] == "missed")
    );

    // A motor of 0.1 N m that is always at its limit.
    let servo = example("gearbox/following-with-disturbances.toml");
    let weak = servo.replace("torque_limit_n_m = 60.0", "torque_limit_n_m = 0.1");
    reasons(&weak, 0, "not_judged");
    let missed = reasons(&target(&weak, 50.0), 3, "missed");
    for item in ["workpiece behind its servo", "torque of the servo"] {
        let items = missed["scope"]["judged"].as_array().unwrap();
        assert!(items.iter().any(|i| i["item"] == item && i["status"] == "missed"), "{item}: {missed}");
    }
    reasons(&target(&servo, 50.0), 0, "met");

    // A train has no slide to compare with, but its pace counts.
    let from = feed.find("start = ").unwrap();
    let train = |ticks: &str| {
        let text = format!("{}reference_ticks = {ticks}\nreference_signs = [1, 1, 1]\n", &feed[..from]);
        target(&text, 5.0)
    };
    assert_eq!(reasons(&train("[100, 260, 420]"), 3, "not_judged")["reason"]["code"], "slide-not-known");
    assert_eq!(reasons(&train("[100, 108, 420]"), 3, "missed")["reason"]["code"], "interpolator-too-fast");

    // Set-ups are judged by what is wanted of them, with or without a tolerance for the set-up that runs now.
    let cheapest = example("gearbox/cheapest-set-up.toml");
    reasons(&cheapest, 0, "met");
    reasons(&target(&cheapest, 0.1), 3, "missed");
}

/// Whole pulses and voltage from the trace alone: pulses of both lines add up to the position, the voltage is that of the part.
#[test]
fn whole_pulses_and_voltage_are_the_rotation() {
    let directory = tempfile::tempdir().unwrap();
    let result = gearbox(&example("gearbox/whole-pulses-and-voltage.toml"), directory.path()).json();
    let (split, pulses) = (&result["split"], &result["pulses"]);
    let whole = |key: &str| split[key].as_i64().unwrap();
    assert_eq!(whole("whole_pulses"), pulses["rotation_workpiece_pulses"].as_i64().unwrap());
    assert_eq!(whole("part"), pulses["rotation_rest_parts"].as_i64().unwrap());
    assert_eq!(whole("forward_pulses") - whole("backward_pulses"), whole("whole_pulses"));
    let table = std::fs::read_to_string(directory.path().join("split.csv")).unwrap();
    let (mut coarse, mut parts, mut seen) = (0.0, 0.0, 0);
    let [mut least, mut greatest] = [0.02_f64 / 10.0; 2];
    for line in table.lines().skip(1) {
        let row: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        coarse += row[2];
        assert_eq!(coarse, row[3], "{line}");
        // One part a pulse, b is below 1.
        let now = 16.0 * row[3] + row[4];
        assert_eq!((now - parts).abs(), 1.0, "{line}");
        parts = now;
        // Six bits: sixteenths are whole steps; half a percent steeper, 20 mV up.
        assert!((row[5] - (10.0 * row[4] / 16.0 * 1.005 + 0.02)).abs() < 1e-9, "{line}");
        let off = row[5] / 10.0 - row[4] / 16.0;
        (least, greatest) = (least.min(off), greatest.max(off));
        seen += 1;
    }
    assert_eq!(seen, pulses["parts_turned"].as_i64().unwrap());
    let um = result["coupling"]["flank_um_per_workpiece_pulse"].as_f64().unwrap();
    let [found_least, found_greatest] = ends(&split["error"]);
    assert!(
        (found_least - least * um).abs() < 1e-9 && (found_greatest - greatest * um).abs() < 1e-9,
        "{split}"
    );
}

/// The screw's errors come back in the run, and a scale keeps the target that the screw misses.
#[test]
fn errors_of_scale_screw_and_encoder_reach_the_flank() {
    let directory = tempfile::tempdir().unwrap();
    let screw = gearbox(&example("gearbox/ball-screw-and-encoder.toml"), directory.path());
    let scale = gearbox(&example("gearbox/scale-and-encoder.toml"), directory.path());
    assert_eq!((screw.exit, scale.exit), (Some(3), Some(0)), "{} {}", screw.stderr, scale.stderr);
    let result = screw.json();
    assert_eq!(result["reason"]["code"], "rotation-misses-lead");
    let along = &result["along_feed"];
    assert_eq!(along["within_bound"], true, "{along}");
    // Going down the lines are passed 4 um later: pulses stay ahead by the backlash.
    let offset = along["direction_offset_um"].as_f64().unwrap();
    assert!((offset - 4.0).abs() < 0.2, "{offset}");
    // 12 um over 300 mm make 1.2 over 30; the wobble 3 either way; 4 of backlash.
    let [least, greatest] = ends(&along["steady"]);
    assert!(
        (-1.2 - 3.0 - 0.8..-3.0).contains(&least) && (4.0..4.0 + 3.0 + 0.2).contains(&greatest),
        "{along}"
    );
    // An eccentric disc: 2 um on a radius of 50 mm, at the flank with s_rot, twice from end to end.
    let encoder = &result["errors"]["encoder"];
    let eccentric = 2e-3 / 50.0 * result["coupling"]["flank_um_per_rad"].as_f64().unwrap();
    let cumulative = encoder["cumulative_pitch_um"].as_f64().unwrap();
    assert!((cumulative / (2.0 * eccentric) - 1.0).abs() < 0.02, "{cumulative} for {eccentric}");
    let parts = result["errors"]["parts"].as_array().unwrap();
    let sum: f64 = parts.iter().map(|part| part["flank_um"].as_f64().unwrap()).sum();
    assert!((sum - result["errors"]["sum_flank_um"].as_f64().unwrap()).abs() < 1e-12);
    assert_eq!(scale.json()["along_feed"]["within_bound"], true);
    let tight = example("gearbox/scale-and-encoder.toml").replace("tolerance_um = 2.0", "tolerance_um = 1.8");
    let tight = gearbox(&tight, directory.path());
    assert_eq!((tight.exit, &tight.json()["reason"]["code"]), (Some(3), &"encoder-misses".into()));
}

/// The added parabola and wave have the amounts that the job asks for, and the servo follows them.
#[test]
fn added_rotation_has_its_amounts() {
    let directory = tempfile::tempdir().unwrap();
    let text = example("gearbox/added-rotation.toml");
    let answer = gearbox(&text, directory.path());
    assert_eq!(answer.exit, Some(0), "{}", answer.stderr);
    let result = answer.json();
    let [parabola, wave] = [0, 1].map(|i| ends(&result["corrections"][i]["flank"]));
    assert!(parabola[0].abs() < 3e-3 && (parabola[1] - 8.0).abs() < 1e-3, "{parabola:?}");
    assert!((wave[0] + 1.5).abs() < 2e-3 && (wave[1] - 1.5).abs() < 2e-3, "{wave:?}");
    // A wave of 1.5 um once a turn of the worm, 600 1/min: 1.5 * 2 pi * 10 um/s over s_rot.
    let speed = result["corrections"][1]["greatest_speed_deg_per_s"].as_f64().unwrap();
    let wanted = (1.5 * std::f64::consts::TAU * 10.0
        / result["coupling"]["flank_um_per_rad"].as_f64().unwrap())
    .to_degrees();
    assert!((speed / wanted - 1.0).abs() < 0.01, "{speed} for {wanted}");
    let peak = result["servo"]["workpiece"]["peak_um"].as_f64().unwrap();
    assert!(peak < 1.5, "{peak}");
    // A table that ends with a slope inside the travel makes the speed jump.
    let from = text.find("[[correction.curves]]").unwrap();
    let to = text.find("[servo]").unwrap();
    let steep = "[correction]\ncurves = [{ kind = \"table\", axis = \"feed\", spacing = 10.0, values_um = [0.0, 10.0, 20.0] }]\n";
    let steep = gearbox(&format!("{}{steep}{}", &text[..from], &text[to..]), directory.path()).json();
    let jump = steep["corrections"][0]["speed_jump_deg_per_s"].as_f64().unwrap();
    // 1 um/mm at 15 mm/s.
    let wanted = (15.0 / steep["coupling"]["flank_um_per_rad"].as_f64().unwrap()).to_degrees();
    assert!((jump / wanted - 1.0).abs() < 1e-6, "{jump} for {wanted}");
    assert!(steep["warnings"].as_array().unwrap().iter().any(|w| w["code"] == "correction-ends-steeply"));
}

/// Times by the rules of the specification, the counter by arithmetic.
#[test]
fn the_workpiece_comes_into_the_gap() {
    let directory = tempfile::tempdir().unwrap();
    let text = example("gearbox/into-the-gap.toml");
    let answer = gearbox(&text, directory.path());
    assert_eq!(answer.exit, Some(0), "{}", answer.stderr);
    let e = answer.json()["engagement"].take();
    let number = |key: &str| e[key].as_f64().unwrap();
    let turns = 2990.0 / 60.0;
    let ramp = 1.875 * (3.0 / 40.0 * 360.0 * turns) / 3600.0;
    assert!((number("ramp_s") - ramp).abs() <= 1e-3, "{e}");
    let way = number("phase_move_deg").abs();
    let phase = (1.875 * way / 90.0).max((10.0 / 3f64.sqrt() * way / 3600.0).sqrt());
    assert!((number("coupled_after_s") - number("ramp_s") - phase).abs() <= 2e-3, "{e}");
    // 65536 counts a turn, a cycle of 1 ms.
    let counts = turns * 65_536.0 * 1e-3;
    assert_eq!(e["counts_a_cycle"].as_f64(), Some(counts.ceil()));
    let cycles = (number("coupled_after_s") / 1e-3).round() + 1000.0 - 1.0;
    assert!((number("counter_wraps") - (cycles * counts / 65_536.0).floor()).abs() <= 1.0, "{e}");
    let [least, greatest] = ends(&e["miss"]);
    // A count of the worm and a part of the workpiece, either way, twice.
    let count = 3.0 / 40.0 * std::f64::consts::TAU / 65_536.0 + std::f64::consts::TAU / 576_000.0;
    let most = 2.0 * count * 46_984.7;
    assert!(least.abs().max(greatest) <= most && greatest - least > 0.1 * most, "{e}");
    let narrow = gearbox(&text.replace("counter_bits = 16", "counter_bits = 12"), directory.path());
    assert_eq!((narrow.exit, &narrow.json()["error"]["field"]), (Some(2), &"engagement.counter_bits".into()));
}

/// The interpolator keeps to its limits where the others do not; sine and cosine repeat their error at any speed.
#[test]
fn older_multipliers_stand_beside() {
    let directory = tempfile::tempdir().unwrap();
    let result = gearbox(&example("gearbox/older-multipliers.toml"), directory.path()).json();
    let lines = result["compare"].as_array().unwrap();
    assert_eq!(lines.len(), 3);
    let um = |line: usize, key: &str| lines[line][key].as_f64().unwrap();
    assert_eq!(ends(&lines[0]["whole"]), ends(&result["along_feed"]["whole"]));
    // The loop of 20 Hz needs time at each change of speed; the lag a/w^2 at 50 mm/s^2 is 3.2 um.
    let lag = 50.0 / (std::f64::consts::TAU * 20.0f64).powi(2) * 1e3;
    let [least, greatest] = ends(&lines[1]["whole"]);
    assert!(least < -lag && greatest > lag, "{least} {greatest} for {lag}");
    assert!(um(1, "flank_um") > um(0, "flank_um") || um(1, "steady_flank_um") > um(0, "steady_flank_um"));
    // Offsets of 1 %, amplitudes 2 % and a phase of 1 degree: up to sqrt(2) 0.01 + 0.01 + 0.0175 rad of a line of 10 um.
    let [least, greatest] = ends(&lines[2]["steady"]);
    let most = (2f64.sqrt() * 0.01 + 0.01 + 1f64.to_radians()) / std::f64::consts::TAU * 10.0;
    assert!(
        greatest - least < 2.0 * most + 0.625 + 0.01 && greatest - least > 0.625 + 0.5 * most,
        "{least} {greatest} {most}"
    );
}

#[test]
fn bad_input_names_the_key() {
    let motion = example("gearbox/feed-to-and-fro.toml");
    let servo = example("gearbox/following-with-disturbances.toml");
    let from = motion.find("start = ").unwrap();
    let train = |ticks: &str, signs: &str| {
        format!("{}reference_ticks = {ticks}\nreference_signs = {signs}\n", &motion[..from])
    };
    let coarse =
        motion.replace("pulses_per_revolution = 36000", "pulses_per_revolution = 36000\nrate = \"binary\"");
    let coarse = coarse.replace("pulses_per_metre = 100000", "pulses_per_metre = 1000");
    let gains = "gains = { proportional_n_m_per_rad = 1.0, integral_n_m_per_rad_s = 1e9, derivative_n_m_s_per_rad = 0.0 }";
    let number = "invalid-number";
    let cases = [
        (motion.replace("interval = 16", "interval = 1"), number, "feed.pulses_per_interval"),
        (motion.replace("interval = 16", "interval = 257"), number, "feed.pulses_per_interval"),
        (motion.replace("interval = 16", "interval = 16\ncounter_limit = 0"), number, "feed.counter_limit"),
        (motion.replace("clock_hz = 1e6", "clock_hz = 0.0"), number, "feed.clock_hz"),
        (motion.replace("clock_hz = 1e6", "clock_hz = nan"), number, "feed.clock_hz"),
        (motion.replace("metre = 100000", "metre = 0"), number, "feed.pulses_per_metre"),
        (train("[100, 100]", "[1, 1]"), "bad-reference-train", "stimulus.reference_ticks[1]"),
        (train("[0, 100]", "[1, 1]"), "bad-reference-train", "stimulus.reference_ticks[0]"),
        (train("[100, 200]", "[1, 2]"), "bad-reference-train", "stimulus.reference_signs[1]"),
        (coarse, "coefficient-too-large", "workpiece.pulses_per_revolution"),
        (motion.clone() + "[target]\ntolerance_um = 0.0\n", number, "target.tolerance_um"),
        (
            motion.clone()
                + "[errors]\nscale = { periodic = [{ amplitude_um = 1000.0, period_mm = 1.0 }] }\n",
            "bad-parameter",
            "errors.scale",
        ),
        (
            motion.clone() + "[engagement]\nphase_speed_deg_per_s = 90.0\nacceleration_deg_per_s2 = 3600.0\n",
            "invalid-job",
            "engagement",
        ),
        (
            motion.clone()
                + "[correction]\ncurves = [{ kind = \"table\", axis = \"worm\", spacing = 180.0, values_um = [0.0, 1.0, 0.0], ends = \"periodic\" }]\n",
            "invalid-job",
            "correction.curves[0].axis",
        ),
        (
            servo.clone() + "[engagement]\nphase_speed_deg_per_s = 90.0\nacceleration_deg_per_s2 = 1e-6\n",
            "invalid-job",
            "engagement.acceleration_deg_per_s2",
        ),
        (
            motion.replace("to = 6.0", "to = 9000.0")
                + "[split]\nvolts_per_pulse = 1.0\n[output]\nsplit_trace = true\n",
            "trace-too-long",
            "output.split_trace",
        ),
        (motion.replace("teeth = 40", "teeth = 0"), number, "gear.teeth"),
        (motion.replace("normal_module = 2.5", "normal_module = 0.0"), number, "gear.normal_module"),
        (motion.replace("helix_angle_deg = 20.0", "helix_angle_deg = 90.0"), number, "gear.helix_angle_deg"),
        (
            servo.replace("bandwidth_hz = 60.0", "bandwidth_hz = 2000.0"),
            "unstable-loop",
            "servo.bandwidth_hz",
        ),
        (servo.replace("bandwidth_hz = 60.0", gains), "unstable-loop", "servo.gains"),
        (servo.replace("inertia_kg_m2 = 0.12", "inertia_kg_m2 = 0.0"), number, "servo.inertia_kg_m2"),
        (
            servo.replace("torque_limit_n_m = 60.0", "torque_limit_n_m = 0.0"),
            number,
            "servo.torque_limit_n_m",
        ),
        (
            motion.replace("to = 6.0", "to = 9000.0") + "[output]\npulse_trace = true\n",
            "trace-too-long",
            "output.pulse_trace",
        ),
    ];
    let directory = tempfile::tempdir().unwrap();
    for (text, code, field) in cases {
        let answer = gearbox(&text, directory.path());
        let error = answer.json()["error"].take();
        assert_eq!(answer.exit, Some(2), "{code} {field}: {error}");
        assert_eq!((&error["code"], &error["field"]), (&code.into(), &field.into()), "{error}");
        assert!(error["way_out"].is_string() && error["line"].is_u64(), "{error}");
    }
    // A spur gear needs no additional rotation.
    let spur = gearbox(&motion.replace("helix_angle_deg = 20.0", "helix_angle_deg = 0.0"), directory.path());
    assert_eq!((spur.exit, &spur.json()["pulses"]["parts_turned"]), (Some(0), &0.into()), "{spur:?}");
    let grinding = run(&["gearbox", "--json", "examples/twist-free-crowning.toml"]);
    assert_eq!((grinding.exit, &grinding.json()["error"]["field"]), (Some(2), &"job.process".into()));
}

#[test]
fn a_fault_in_the_table_of_pulses_has_its_row() {
    let directory = tempfile::tempdir().unwrap();
    let path = job_with_table(directory.path(), "tick,sign\n100,1\n90,1\n");
    let error = run(&["gearbox", "--json", &path]).json()["error"].take();
    assert_eq!((&error["code"], &error["field"]), (&"bad-reference-train".into(), &"tick".into()), "{error}");
    assert_eq!(error["line"], 3);
    assert!(error["file"].as_str().unwrap().ends_with("train.csv"));
}
