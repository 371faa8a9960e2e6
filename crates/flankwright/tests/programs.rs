//! From a job to programs that are proven: the examples on the shipped machines, and what a machine cannot do.

use flankwright::exchange::{LoadedJob, Source, parse_job};
use flankwright::nc::Dialect;
use flankwright::numerics::Silent;
use flankwright::workflow::{Outcome, RunFailure, Status, plan_job};
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
        "helix_points = 41",
        "helix_points = 41\n[output]\nprograms = [\"linuxcnc\", \"siemens\", \"fanuc\"]",
    )];
    for machine in ["eight-axis", "tangential-slide"] {
        let outcome = planned("radial-feed-crowning", machine, &programs);
        assert_eq!(outcome.result.status, Status::Missed);
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
        assert_eq!(count(dialect, "STOCK 15 UM"), 2, "{dialect:?}");
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
                ("helix_points = 41".to_owned(), format!("helix_points = 41\n[output]\n{only}"))
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
