//! Verdicts of milling: what of the part was judged, what a cutter enters, and which programs are written for it.

use crate::milling_example::example;
use foundation::numerics::Silent;
use job::machine::{LoadedMachine, read_machine};
use milling::job::LoadedMillingJob;
use milling::workflow::{MillingCheck, MillingOutcome, run_milling, write_milling};
use nc::Dialect;
use std::path::Path;
use verdict::Status;

fn ac_table() -> LoadedMachine {
    read_machine(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../machines/five-axis-ac-table.toml"))
        .unwrap()
}

fn run(name: &str, changes: &[(&str, &str)]) -> (LoadedMillingJob, MillingOutcome) {
    let loaded = example(name, changes);
    let outcome = run_milling(&loaded, &Silent).unwrap();
    (loaded, outcome)
}

/// A narrow gear, so that the tests are quick.
const NARROW: [(&str, &str); 2] =
    [("face_width = 60.0", "face_width = 12.0"), ("rays_length = 11", "rays_length = 5")];

#[test]
fn the_verdict_names_every_surface_and_the_programs_carry_it() {
    let (_, outcome) = run("spur-on-ac-table", &NARROW);
    let verdict = &outcome.result.verdict;
    assert_eq!(verdict.status(), Status::Met, "{:?}", verdict.reason());
    let judged: Vec<&str> = verdict.judged().iter().map(|one| one.item.as_str()).collect();
    for item in [
        "left flank",
        "right flank: plan against simulation",
        "left fillet",
        "bottom of the root",
        "root body",
        "left flank of the other spaces",
        "tips of teeth",
        "ends of teeth",
        "program for siemens: whole part and rapid moves",
    ] {
        assert!(judged.contains(&item), "{item}: {judged:?}");
    }
    let left: Vec<&str> = verdict.not_judged().iter().map(|one| one.item.as_str()).collect();
    assert!(left.iter().any(|item| item.contains("first positioning")), "{left:?}");
    let document = serde_json::to_value(&outcome.result).unwrap();
    assert_eq!((&document["status"], &document["accepted"]), (&"met".into(), &true.into()));
    let part = &document["programs"][0]["part"];
    assert_eq!(part["spaces"], serde_json::json!([20, 20]), "{part}");
    assert!(part["depth_resolution_mm"].as_f64().unwrap() <= 0.02);
    let folder = tempfile::tempdir().unwrap();
    write_milling(&outcome, folder.path()).unwrap();
    let text = std::fs::read_to_string(folder.path().join("programs/milling-siemens.mpf")).unwrap();
    assert!(text.contains("; TARGET MET"), "{}", &text[..400]);
}

#[test]
fn programs_of_a_missed_target_are_written_on_request_only() {
    let missed = [NARROW[0], NARROW[1], ("tolerance_um = 40.0", "tolerance_um = 5.0")];
    for asked in [false, true] {
        let mut changes = missed.to_vec();
        if asked {
            changes.push(("[output]", "[output]\nprograms_of_missed = true"));
        }
        let (_, outcome) = run("spur-on-ac-table", &changes);
        let result = &outcome.result;
        assert_eq!(result.verdict.status(), Status::Missed);
        assert_eq!(result.warnings.iter().any(|warning| warning.code == "programs-not-written"), !asked);
        let folder = tempfile::tempdir().unwrap();
        write_milling(&outcome, folder.path()).unwrap();
        let program = folder.path().join("programs/milling-siemens.mpf");
        assert_eq!(program.exists(), asked);
        if asked {
            let text = std::fs::read_to_string(program).unwrap();
            assert!(text.contains("; MISSED"), "{}", &text[..400]);
        }
    }
}

/// The program of a gear with a deeper root, held against a gear with a root 1.5 mm higher: the flanks are the same.
#[test]
fn cutters_in_the_root_body_are_noticed() {
    let (_, outcome) = run("spur-on-ac-table", &NARROW);
    let text = &outcome.texts.programs.as_ref().unwrap().programs[0];
    let higher = example(
        "spur-on-ac-table",
        &[NARROW[0], NARROW[1], ("root_diameter = 140.0", "root_diameter = 143.0")],
    );
    let machine = ac_table();
    let check = MillingCheck::new(&higher, &machine, &Silent).unwrap();
    let checked = check.check(text.written.text.as_bytes(), text.dialect, &Silent).unwrap();
    let faults = checked.part.unwrap().faults;
    for space in 1..=20 {
        let in_space =
            |code: &str| faults.iter().any(|fault| fault.space == Some(space) && fault.code == code);
        assert!(in_space("root-gouged") && in_space("root-body-gouged"), "{space}: {faults:#?}");
    }
}

/// A line with a word that is greater by so much.
fn moved(line: &str, letter: char, by: f64) -> String {
    let word = |word: &str| match word.strip_prefix(letter).and_then(|text| text.parse::<f64>().ok()) {
        Some(value) => format!("{letter}{:.4}", value + by),
        None => word.to_owned(),
    };
    line.split(' ').map(word).collect::<Vec<_>>().join(" ")
}

/// Backs of blades are judged where the job says how thick the blades are: the plan keeps off them, a row that is shifted through the
/// blade does not.
#[test]
fn backs_of_blades_are_judged() {
    let (loaded, outcome) = run("blade-on-head-head", &[("rows = 20", "rows = 6")]);
    let verdict = &outcome.result.verdict;
    assert!(verdict.judged().iter().any(|one| one.item == "backs of the blades"), "{verdict:?}");
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../machines/five-axis-head-head.toml");
    let machine = read_machine(&file).unwrap();
    let check = MillingCheck::new(&loaded, &machine, &Silent).unwrap();
    let programs = &outcome.texts.programs.as_ref().unwrap().programs;
    let text = &programs.iter().find(|program| program.dialect == Dialect::LinuxCnc).unwrap().written.text;
    let lines: Vec<&str> = text.lines().collect();
    let cuts: Vec<usize> = (0..lines.len()).filter(|&k| lines[k].contains(" G1 ")).collect();
    let row = &cuts[cuts.len() / 2..cuts.len() / 2 + 12];
    let shifted = |[x, y]: [f64; 2]| {
        let line = |k: usize| match row.contains(&k) {
            true => moved(&moved(lines[k], 'X', x), 'Y', y),
            false => lines[k].to_owned(),
        };
        (0..lines.len()).map(line).collect::<Vec<_>>().join("\n") + "\n"
    };
    let gouged = [[-7.0, 0.0], [7.0, 0.0], [0.0, -7.0], [0.0, 7.0]].map(|by| {
        let checked = check.check(shifted(by).as_bytes(), Dialect::LinuxCnc, &Silent).unwrap();
        checked.part.unwrap().faults.iter().any(|fault| fault.code == "back-gouged")
    });
    assert!(gouged.contains(&true), "{gouged:?}");
}

/// Damages of a program that a look at the first space's flanks does not show.
#[test]
fn program_check_sees_all_spaces_root_and_rapid_moves() {
    let loaded = example("spur-on-ac-table", &NARROW);
    let machine = ac_table();
    let outcome = run_milling(&loaded, &Silent).unwrap();
    let programs = &outcome.texts.programs.as_ref().unwrap().programs;
    let text = &programs.iter().find(|program| program.dialect == Dialect::LinuxCnc).unwrap().written.text;
    let check = MillingCheck::new(&loaded, &machine, &Silent).unwrap();
    let faults = |text: &str| {
        let checked = check.check(text.as_bytes(), Dialect::LinuxCnc, &Silent).unwrap();
        assert!(checked.remarks.len() >= checked.part.as_ref().unwrap().faults.len());
        checked.part.unwrap().faults
    };
    let own = faults(text);
    assert!(own.is_empty(), "{:#?}", &own[..own.len().min(5)]);
    let lines: Vec<&str> = text.lines().collect();
    let cuts: Vec<usize> = (1..lines.len() - 1)
        .filter(|&k| {
            lines[k].contains(" G1 ") && lines[k - 1].contains(" G1 ") && lines[k + 1].contains(" G1 ")
        })
        .collect();
    let changed = |which: &[usize], change: &dyn Fn(&str) -> String| -> String {
        let line = |k: usize| if which.contains(&k) { change(lines[k]) } else { lines[k].to_owned() };
        (0..lines.len()).map(line).collect::<Vec<_>>().join("\n") + "\n"
    };
    // Rows of a later space by 3 mm in X: the second half of the cuts with the first tool.
    let later = &cuts[cuts.len() / 2..cuts.len() / 2 + 8];
    let found = faults(&changed(later, &|line| moved(line, 'X', 3.0)));
    assert!(
        found
            .iter()
            .any(|fault| fault.code.ends_with("-gouged") && fault.space.is_some_and(|space| space > 1)),
        "{found:#?}"
    );
    // The pass of the bottom 5 mm too deep in the last space.
    let found = faults(&changed(&cuts[cuts.len() - 2..], &|line| moved(line, 'Z', -5.0)));
    assert!(found.iter().any(|fault| fault.amount_mm.is_some_and(|mm| mm > 0.9)), "{found:#?}");
    // A rapid move into the body: the cut of a row made rapid and 20 mm deeper.
    let rapid = |line: &str| -> String {
        let line = moved(line, 'Z', -20.0).replace("G93 G1", "G94 G0");
        line.split(' ').filter(|word| !word.starts_with('F')).collect::<Vec<_>>().join(" ")
    };
    // One that goes through the space, not one that comes down beside the gear.
    let y = |k: usize| lines[k].split(' ').find(|word| word.starts_with('Y'));
    let through = cuts[cuts.len() / 3..].iter().find(|&&k| y(k) != y(k - 1)).unwrap();
    let found = faults(&changed(&[*through], &rapid));
    assert!(found.iter().any(|fault| fault.code == "rapid-collision"), "{found:#?}");
}
