//! From a job to programs that are proven: the examples on the shipped machines, and what a machine cannot do.

use flankwright::exchange::{AnyJob, LoadedJob, Source, TangentialJob, parse_any_job, parse_job};
use flankwright::nc::Dialect;
use flankwright::numerics::Silent;
use flankwright::workflow::tangential::plan_tangential;
use flankwright::workflow::{CheckedProgram, Outcome, RunFailure, Status, check_program, plan_job};
use std::path::Path;

/// An example with a machine and whatever else changes.
fn job(example: &str, machine: &str, changes: &[(&str, &str)]) -> LoadedJob {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let path = root.join("examples").join(format!("{example}.toml"));
    let mut text = std::fs::read_to_string(&path).expect("an example");
    let from = text.find("[machine]").map(|at| (at, at + text[at..].find("\n\n").expect("the table's end")));
    if let Some((from, to)) = from {
        text.replace_range(from..to, "");
    }
    for (from, to) in changes.iter().filter(|(from, _)| !from.is_empty()) {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    let more: String =
        changes.iter().filter(|(from, _)| from.is_empty()).map(|(_, line)| format!("{line}\n")).collect();
    let file = root.join("machines").join(format!("{machine}.toml"));
    text.push_str(&format!("\n[machine]\nfile = {:?}\n{more}", file.display().to_string()));
    parse_job(Source::new(path.display().to_string(), &text)).unwrap_or_else(|e| panic!("{example}: {e}"))
}

fn planned(example: &str, machine: &str, changes: &[(&str, &str)]) -> Outcome {
    plan_job(&job(example, machine, changes), &Silent)
        .unwrap_or_else(|e| panic!("{example} on {machine}: {e:?}"))
}

/// The proof says of every flank what the run itself says, to 0.01 um (issue: rounding included), for all three controls.
fn proven(outcome: &Outcome) {
    let programs = outcome.result.programs.as_ref().expect("programs");
    let mut controls: Vec<&str> = programs.proofs.iter().flat_map(|p| p.controls.iter().copied()).collect();
    controls.sort_unstable();
    assert_eq!(controls, ["fanuc", "linuxcnc", "siemens"]);
    for proof in &programs.proofs {
        assert_eq!(proof.flanks.len(), outcome.result.flanks.len());
        for (flank, proof) in &proof.flanks {
            let planned = outcome.result.flanks[flank].max_deviation_um;
            let apart = (proof.max_deviation_um - planned).abs();
            assert!(apart < 0.01, "{flank}: {} um proven, {planned} um planned", proof.max_deviation_um);
            assert!(proof.difference_um < 0.02, "{flank}: {} um", proof.difference_um);
        }
        assert!(proof.statement.starts_with("proven from the program text: max deviation"));
    }
    for program in &programs.programs {
        for axis in &program.axes {
            let [v, a] = [(axis.velocity, axis.max_velocity), (axis.acceleration, axis.max_acceleration)]
                .map(|(is, most)| is / most.expect("a limit"));
            // Between the middles of blocks the program's own bends are what they are: 1e-6 for rounding.
            assert!(v < 1.0 + 1e-6 && a < 1.0 + 1e-6, "{} {}: {v} {a}", program.file, axis.axis);
        }
    }
}

#[test]
fn the_twist_free_crowning_is_proven_on_two_machines() {
    for machine in ["eight-axis", "xyzabc"] {
        proven(&planned("twist-free-crowning", machine, &[]));
    }
}

#[test]
fn the_automotive_gear_is_proven_on_two_machines() {
    for machine in ["no-swivel", "tangential-slide"] {
        proven(&planned("automotive-bias", machine, &[]));
    }
}

#[test]
fn the_radial_crowning_is_proven_on_two_machines() {
    let programs = [(
        "programs_of_missed = true",
        "programs_of_missed = true\nprograms = [\"linuxcnc\", \"siemens\", \"fanuc\"]",
    )];
    for machine in ["eight-axis", "tangential-slide"] {
        let outcome = planned("radial-feed-crowning", machine, &programs);
        assert_eq!(outcome.result.verdict.status(), Status::Missed);
        proven(&outcome);
    }
}

/// Roughing leaves its stock, spark-out adds nothing, dressing in two steps ends on the same worm.
#[test]
fn passes_before_and_after_finishing_leave_the_flank_as_it_is() {
    let more = [
        ("", "roughing_stock_um = [80, 30]"),
        ("", "spark_out = 2"),
        ("", "dressing_stock_um = [15]"),
        ("", "worm = { axial = 12.5, angle_deg = 33 }"),
        ("", "work = { axial = -40, angle_deg = -75 }"),
        ("", "dresser = { axial = 3 }"),
    ];
    let outcome = planned("twist-free-crowning", "no-swivel", &more);
    proven(&outcome);
    let programs = outcome.programs.as_ref().expect("programs");
    let count = |dialect: Dialect, text: &str| {
        let of = programs.built.programs.iter().filter(|p| p.dialect == dialect);
        of.map(|p| p.written.text.matches(text).count()).sum::<usize>()
    };
    for dialect in Dialect::ALL {
        assert_eq!(count(dialect, "ROUGHING STOCK"), 2, "{dialect:?}");
        assert_eq!(count(dialect, "SPARK OUT"), 2, "{dialect:?}");
        // Two flanks of three threads.
        assert_eq!(count(dialect, "STOCK 15 UM"), 6, "{dialect:?}");
    }
}

/// The same job gives the same bytes.
#[test]
fn programs_are_the_same_bytes_again() {
    let text = || -> Vec<String> {
        let outcome = planned("twist-free-crowning", "eight-axis", &[]);
        outcome.programs.expect("programs").built.programs.into_iter().map(|p| p.written.text).collect()
    };
    assert_eq!(text(), text());
}

fn refused(example: &str, machine: &str, changes: &[(&str, &str)]) -> (bool, String, String) {
    match plan_job(&job(example, machine, changes), &Silent) {
        Err(RunFailure::BadInput(d)) => (true, d.code.into(), d.message.to_string()),
        Err(RunFailure::NotProducible(d)) => (false, d.code.into(), d.message.to_string()),
        Ok(_) => panic!("{example} on {machine} must be refused"),
    }
}

#[test]
fn what_a_machine_cannot_do_is_told() {
    // A shift clamped far off the middle leaves no travel: the axis, the place, the excess.
    let (_, code, message) = refused("twist-free-crowning", "eight-axis", &[("", "worm = { axial = 150 }")]);
    assert_eq!(code, "axis-limit");
    assert!(message.contains("V1") && message.contains("beyond its travel"), "{message}");
    // A swivel that the pose does not admit, or that the machine has not.
    let (_, code, _) = refused("twist-free-crowning", "eight-axis", &[("", "swivel_deg = 20")]);
    assert_eq!(code, "unreachable");
    let (_, code, _) = refused("twist-free-crowning", "no-swivel", &[("", "swivel_deg = 2")]);
    assert_eq!(code, "missing-axis");
    // A mill has no worm.
    let (_, code, message) = refused("twist-free-crowning", "five-axis-ac-table", &[]);
    assert_eq!(code, "missing-axis", "{message}");
    // A swivel at an angle has no letter on LinuxCNC, but stands where it is said.
    let swivelled = planned("twist-free-crowning", "eight-axis", &[("", "swivel_deg = 1")]);
    let text = &swivelled.programs.as_ref().expect("programs").built.programs[0].written.text;
    assert!(text.contains("C5 STANDS AT 1 DEG"), "{text}");
    proven(&swivelled);
}

/// A machine with another control, in a file of its own.
fn changed_machine(name: &str, changes: &[(&str, &str)]) -> (tempfile::TempDir, String) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../machines");
    let mut text = std::fs::read_to_string(root.join(format!("{name}.toml"))).expect("a machine");
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    let directory = tempfile::tempdir().expect("a directory");
    std::fs::write(directory.path().join("machine.toml"), text).expect("a file");
    let path = directory.path().join("machine").display().to_string();
    (directory, path)
}

/// What controls offer beside plain blocks: steps below one turn, a HAL netlist, G81 of gears without shift.
#[test]
fn other_ways_of_a_control_are_proven_as_well() {
    let one = |dialect: &str| format!("programs = [\"{dialect}\"]");
    let all = "programs = [\"linuxcnc\", \"siemens\", \"fanuc\"]";
    let of = |machine: &str, example: &str, dialect: &str| {
        let only = one(dialect);
        let change = match example {
            "radial-feed-crowning" => {
                let key = "programs_of_missed = true";
                (key.to_owned(), format!("{key}\n{only}"))
            }
            _ => (all.to_owned(), only),
        };
        let outcome = planned(example, machine, &[(&change.0, &change.1)]);
        let programs = outcome.programs.expect("programs");
        for proof in &programs.result.proofs {
            assert!(proof.flanks.values().all(|f| f.difference_um < 0.02), "{proof:?}");
        }
        programs.built.programs
    };
    let modulo = (
        "[controls.linuxcnc]\ncoupling = \"blocks\"",
        "[controls.linuxcnc]\nmodulo = true\ncoupling = \"blocks\"",
    );
    let (_keep, machine) = changed_machine("no-swivel", &[modulo]);
    let programs = of(&machine, "twist-free-crowning", "linuxcnc");
    assert!(programs[1].written.text.lines().count() > 1000, "every turn of the worm is a step");

    let hal = ("[controls.linuxcnc]\ncoupling = \"blocks\"", "[controls.linuxcnc]\ncoupling = \"gearbox\"");
    let (_keep, machine) = changed_machine("no-swivel", &[hal]);
    // The netlist of a gear holds ratios only: the radial job has nothing else.
    let programs = of(&machine, "radial-feed-crowning", "linuxcnc");
    assert!(programs[1].written.hal.as_ref().is_some_and(|netlist| netlist.contains("sum2")));

    // G81 couples to a spindle, whose angle no text tells.
    let gearbox = (
        "[controls.fanuc]\ncoupling = \"blocks\"",
        "[controls.fanuc]\nprogram_number = 4711\ncoupling = \"gearbox\"",
    );
    let (_keep, machine) = changed_machine("no-swivel", &[gearbox]);
    let (_, code, message) = refused("twist-free-crowning", &machine, &[(all, &one("fanuc"))]);
    assert_eq!(code, "nc-unsupported-coupling", "{message}");
    let (_keep, machine) = changed_machine(
        "no-swivel",
        &[gearbox, ("words = { B1 = \"B\" }", "words = { B1 = \"spindle 0\" }")],
    );
    let (_, code, message) = refused("twist-free-crowning", &machine, &[(all, &one("fanuc"))]);
    assert!(code == "unsupported-coupling" || code == "axis-not-available", "{code} {message}");
    let number = ("[controls.fanuc]\n", "[controls.fanuc]\nprogram_number = 4711\n");
    let (_keep, machine) = changed_machine("no-swivel", &[number]);
    let programs = of(&machine, "radial-feed-crowning", "fanuc");
    assert!(programs[0].written.text.contains("O4711") && programs[1].written.text.contains("O4712"));
    // A gearbox that cannot take the shift as a leading axis.
    let siemens = ("[controls.siemens]\n", "[controls.siemens]\nleaders = [\"B1\", \"Z1\"]\n");
    let (_keep, machine) = changed_machine("no-swivel", &[siemens]);
    let (_, code, message) = refused("twist-free-crowning", &machine, &[(all, &one("siemens"))]);
    assert_eq!(code, "unsupported-coupling");
    assert!(message.contains("V1"), "{message}");
}

/// Passes of a dressing text: each from its name to the next name.
fn dressing_passes(text: &str) -> Vec<std::ops::Range<usize>> {
    let begins: Vec<usize> = text
        .match_indices("DRESSING ")
        .filter(|(at, _)| text[*at..].lines().next().is_some_and(|line| line.contains("THREAD")))
        .map(|(at, _)| text[..at].rfind('\n').map_or(0, |k| k + 1))
        .collect();
    begins.iter().enumerate().map(|(k, &at)| at..begins.get(k + 1).copied().unwrap_or(text.len())).collect()
}

const FEW_POINTS: [(&str, &str); 2] =
    [("profile_points = 41", "profile_points = 7"), ("helix_points = 41", "helix_points = 7")];

/// Every thread is dressed, proven from the text; a thread that is missing, done twice or stands at another angle is named.
#[test]
fn every_thread_of_the_worm_is_dressed_and_proven() {
    let loaded = job("twist-free-crowning", "no-swivel", &FEW_POINTS);
    let outcome = plan_job(&loaded, &Silent).expect("a plan");
    let programs = outcome.programs.as_ref().expect("programs");
    for proof in &programs.result.proofs {
        assert_eq!((proof.threads_of_worm, proof.tooth_spaces, proof.index_strokes), (3, 19, 1));
        assert_eq!(proof.threads.iter().map(|t| t.thread).collect::<Vec<_>>(), [1, 2, 3]);
        for thread in &proof.threads {
            assert_eq!(thread.blocks.len(), 2, "a stroke for either flank");
            assert_eq!(thread.difference_um.len(), 2);
            assert!(thread.difference_um.values().all(|um| *um < 0.15), "{thread:?}");
        }
        assert!(proof.statement.contains("3 of 3 threads of the worm"), "{}", proof.statement);
        assert!(proof.statement.contains("19 of 19 tooth spaces"), "{}", proof.statement);
    }
    let text = programs
        .built
        .programs
        .iter()
        .find(|p| p.dialect == Dialect::Siemens && p.file.contains("dressing"))
        .map(|p| p.written.text.clone())
        .expect("a dressing program");
    let machine = &programs.machine;
    let any = AnyJob::from(loaded);
    let checked = |text: &str| -> CheckedProgram {
        check_program((text.as_bytes(), None), Dialect::Siemens, machine, Some(&any), &Silent)
            .expect("a program")
    };
    let faults = |checked: &CheckedProgram| -> Vec<(&'static str, String)> {
        checked.remarks.iter().map(|r| (r.code, r.text.clone())).collect()
    };
    let whole = checked(&text);
    assert!(whole.remarks.is_empty(), "{:?}", whole.remarks);
    assert_eq!(whole.threads.len(), 3);
    assert!(whole.strokes.iter().all(|s| s.serves.as_ref().is_some_and(|name| name.contains("THREAD"))));
    let passes = dressing_passes(&text);
    assert_eq!(passes.len(), 6);
    let end = text[passes[5].clone()].rfind("SPINDLE").map_or(text.len(), |at| passes[5].start + at);
    assert!(end > passes[5].start);

    // Left out.
    let without = format!("{}{}", &text[..passes[1].start], &text[passes[1].end..]);
    let found = faults(&checked(&without));
    assert!(
        found.iter().any(|(code, text)| *code == "stroke-missing" && text.contains("thread 2 of 3")),
        "{found:?}"
    );
    // Another thread in its place.
    let twice = format!("{}{}{}", &text[..passes[1].start], &text[passes[0].clone()], &text[passes[1].end..]);
    let found = faults(&checked(&twice));
    assert!(
        found.iter().any(|(code, text)| *code == "stroke-missing" && text.contains("thread 2 of 3")),
        "{found:?}"
    );
    // Once too often.
    let thrice =
        format!("{}{}{}", &text[..passes[1].start], &text[passes[0].clone()], &text[passes[1].start..]);
    let found = faults(&checked(&thrice));
    assert!(
        found.iter().any(|(code, text)| *code == "stroke-count" && text.contains("thread 1 of 3")),
        "{found:?}"
    );
    // At another angle: every place of the worm within the pass is 0.05 deg further.
    let turned: String =
        text[passes[1].clone()].split_inclusive(' ').map(|word| turned_word(word, 0.05)).collect();
    let changed = format!("{}{turned}{}", &text[..passes[1].start], &text[passes[1].end..]);
    assert_ne!(changed, text);
    let found = faults(&checked(&changed));
    let named = |text: &str| text.contains("thread 2 of 3") && text.contains("blocks");
    assert!(
        found
            .iter()
            .any(|(code, text)| (*code == "thread-off" || *code == "thread-not-finished") && named(text)),
        "{found:?}"
    );
}

/// A word of the worm's axis further by some degrees, any other word as it is.
fn turned_word(word: &str, by: f64) -> String {
    let trimmed = word.trim_end();
    let (name, number) = match trimmed.strip_prefix("B1=") {
        Some(number) => ("B1=", number),
        None => ("B", trimmed.strip_prefix('B').unwrap_or("")),
    };
    match number.parse::<f64>() {
        Ok(value) => format!("{name}{:.6}{}", value + by, &word[trimmed.len()..]),
        Err(_) => word.to_owned(),
    }
}

/// One of two threads and an even number of teeth: two index strokes, and every space counted from the text.
#[test]
fn index_strokes_of_left_out_threads_grind_every_space() {
    let even = [
        ("teeth = 31", "teeth = 32"),
        ("tip_diameter = 87.5", "tip_diameter = 90.25"),
        ("root_diameter = 75.2", "root_diameter = 77.8"),
        ("form_diameter = 77.6", "form_diameter = 80.3"),
        ("evaluation = { start_diameter = 78.0, end_diameter = 87.4, z_start = -15.0, z_end = 15.0 }", ""),
        ("profile_points = 21", "profile_points = 5"),
        ("helix_points = 21", "helix_points = 5"),
    ];
    let loaded = job("left-out-thread", "no-swivel", &even);
    let outcome = plan_job(&loaded, &Silent).expect("a plan");
    let programs = outcome.programs.as_ref().expect("programs");
    for proof in &programs.result.proofs {
        assert_eq!((proof.tooth_spaces, proof.index_strokes, proof.threads.len()), (32, 2, 1));
        assert!(proof.statement.contains("1 of 2 threads of the worm"), "{}", proof.statement);
    }
    let ground =
        programs.built.programs.iter().find(|p| p.dialect == Dialect::Siemens && p.file.contains("grinding"));
    let text = &ground.expect("a grinding program").written.text;
    let second = text.find("INDEX 1").expect("the second index stroke");
    let cut = text[..second].rfind('\n').map_or(0, |k| k + 1);
    let half = format!("{}M30\n", &text[..cut]);
    let any = AnyJob::from(loaded);
    let check = |text: &str| {
        check_program((text.as_bytes(), None), Dialect::Siemens, &programs.machine, Some(&any), &Silent)
            .expect("a program")
            .remarks
    };
    assert!(check(text).is_empty());
    let found = check(&half);
    assert!(found.iter().any(|r| r.code == "spaces-not-ground" && r.text.contains("16 of 32")), "{found:?}");
}

/// A path too short to reach its speed is all ramps: its instants never run backwards, and the report draws it.
#[test]
fn time_of_axes_never_runs_backwards() {
    let outcome = planned("dressing/strokes", "no-swivel", &[]);
    for program in &outcome.programs.expect("programs").built.programs {
        let rows = &program.layout.trace.rows;
        assert!(rows.windows(2).all(|pair| pair[0].t <= pair[1].t), "{}", program.file);
    }
}

/// The lead of a spur gear is rounding; no control is asked for a ratio of 1e-15.
#[test]
fn spur_gears_run_by_radial_feed_on_every_machine_and_control() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for machine in ["no-swivel", "eight-axis", "tangential-slide", "xyzabc"] {
        let file = root.join("machines").join(format!("{machine}.toml")).display().to_string();
        for teeth in [23, 24, 25, 30, 40] {
            let pitch = 3.0 * f64::from(teeth);
            let gear = SPUR
                .replace("teeth = 24", &format!("teeth = {teeth}"))
                .replace("tip_diameter = 78.0", &format!("tip_diameter = {:?}", pitch + 6.0))
                .replace("root_diameter = 64.5", &format!("root_diameter = {:?}", pitch - 7.5))
                .replace("form_diameter = 68.2", &format!("form_diameter = {:?}", pitch - 3.8));
            let text = format!("{gear}\n[machine]\nfile = {file:?}\n");
            let loaded = parse_job(Source::new("spur.toml".to_owned(), &text)).expect("a job");
            let outcome = plan_job(&loaded, &Silent).unwrap_or_else(|e| panic!("{machine}, {teeth}: {e:?}"));
            assert!(outcome.result.verdict.is_accepted(), "{machine}, {teeth}: {:?}", outcome.result.verdict);
            let programs = outcome.result.programs.expect("programs");
            let proven: usize = programs.proofs.iter().map(|proof| proof.controls.len()).sum();
            assert_eq!(proven, 3, "{machine}, {teeth}");
        }
    }
}

const SPUR: &str = r#"
[job]
name = "spur"
process = "generating-grinding"
[gear]
teeth = 24
normal_module = 3.0
normal_pressure_angle_deg = 20.0
helix_angle_deg = 0.0
profile_shift = 0.0
face_width = 25.0
tip_diameter = 78.0
root_diameter = 64.5
form_diameter = 68.2
[target]
tolerance_um = 2.0
modifications = [{ kind = "helix_crowning", amount_um = 8.0 }]
[worm]
threads = 2
tip_diameter = 250.0
width = 125.0
[dresser]
tip_diameter = 123.0
[grinding]
method = "radial"
feed_per_revolution = 0.3
[grid]
profile_points = 5
helix_points = 5
"#;

/// A job that measures on the arc is proven on the arc.
#[test]
fn the_proof_judges_in_the_measure_of_the_job() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let file = root.join("machines/no-swivel.toml").display().to_string();
    let text = format!("{ARC}\n[machine]\nfile = {file:?}\n[output]\nprograms = [\"siemens\"]\n");
    let Some(loaded) = parse_any_job(Source::new("arc.toml".to_owned(), &text))
        .expect("a job")
        .of::<TangentialJob>()
        .cloned()
    else {
        panic!("a job of tangential dressing")
    };
    let result = plan_tangential(&loaded, &Silent).expect("a plan").result;
    for proof in &result.programs.expect("programs").proofs {
        assert_eq!(proof.threads.len(), 3);
        for (flank, proof) in &proof.flanks {
            let planned = result.flanks[flank].flank.max_deviation_um;
            assert!(
                (proof.max_deviation_um - planned).abs() < 0.05,
                "{flank}: {} {planned}",
                proof.max_deviation_um
            );
        }
    }
}

const ARC: &str = r#"
[job]
name = "arc"
process = "tangential-dressing"
[gear]
teeth = 19
normal_module = 3.5
normal_pressure_angle_deg = 17.5
helix_angle_deg = -35.0
profile_shift = 0.0
face_width = 40.0
tip_diameter = 88.5315
root_diameter = 72.4315
form_diameter = 76.2065
[target]
tolerance_um = 1.0
edge_amounts = { profile_crowning_um = 5.0, lead_crowning_um = 100.0 }
[worm]
threads = 3
tip_diameter = 200.0
[dresser]
tip_diameter = 123.0
pitch_diameter = 115.65
[grinding]
flanks = "right"
shift_width = 48.1042
shift_offset = 0.0
feed_per_revolution = 0.3
[dressing]
variables = "source"
weights = "source"
fit_points = 5
measure = "arc"
"#;

/// The proof of three threads takes at most 1.5 times that of one: further threads stand under a coarser grid.
#[test]
fn three_threads_are_proven_in_little_more_time_than_one() {
    let seconds = |changes: &[(&str, &str)]| {
        let once =
            || planned("twist-free-crowning", "no-swivel", changes).programs.expect("programs").seconds[1];
        (0..2).map(|_| once()).fold(f64::INFINITY, f64::min)
    };
    let (one, three) = (seconds(&[("threads = 3", "threads = 1")]), seconds(&[]));
    println!("proof of one thread {one:.3} s, of three threads {three:.3} s, ratio {:.2}", three / one);
    assert!(three < 1.5 * one, "{three} s against {one} s");
}
