//! What follows from a measured tool on the machine: strokes with a law over the turn of the tool, and the workpiece under a probe. Whole
//! jobs are run; the referee and the readers of texts share nothing with what made them.

use foundation::numerics::Silent;
use job::machine::read_machine;
use job::{Source, parse_job_of};

use nc::Dialect;
use skiving::job::{LoadedSkivingJob, SkivingJob};
use skiving::workflow::{SkivingCheck, SkivingOutcome, run_skiving};
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn text(name: &str) -> String {
    std::fs::read_to_string(root().join(format!("examples/skiving/{name}.toml"))).expect("an example")
}

fn loaded(text: &str) -> LoadedSkivingJob {
    // Beside the examples, so that the machine is found.
    let path = root().join("examples/skiving/job.toml").display().to_string();
    parse_job_of::<SkivingJob>(Source::new(path.as_str(), text)).unwrap_or_else(|e| panic!("{e}"))
}

fn run(text: &str) -> SkivingOutcome {
    run_skiving(&loaded(text), &Silent).unwrap_or_else(|e| panic!("{e:?}"))
}

/// What is wrong with a text.
fn faults(job: &LoadedSkivingJob, dialect: Dialect, text: &str) -> Vec<String> {
    let machine = read_machine(&root().join("machines/skiving-light-barrier.toml")).expect("a machine");
    let check = SkivingCheck::new(job, &machine).unwrap_or_else(|e| panic!("{e:?}"));
    match check.check(text.as_bytes(), dialect) {
        Ok(found) => found.remarks.iter().map(|remark| remark.text.clone()).collect(),
        Err(refused) => vec![format!("{refused:?}")],
    }
}

#[test]
fn a_law_over_the_turn_answers_an_eccentric_tool() {
    let plain = text("run-out");
    // Without errors of single teeth nothing is left but what the contact points do not share.
    let (before, after) = plain.split_once("random = ").expect("random errors");
    let (_, after) = after.split_once('\n').expect("a line");
    let only_eccentric = format!("{before}{after}");
    let mut spreads = Vec::new();
    for law in ["both", "centre-distance", "coupling"] {
        let text = only_eccentric.replace("law = \"both\"", &format!("law = \"{law}\""));
        let text = text.replace("programs = [\"linuxcnc\", \"siemens\", \"fanuc\"]", "");
        let outcome = run(&text);
        let found = outcome.result.runout.expect("a law");
        // Plan against referee within a tenth of the tolerance, tooth by tooth.
        assert!(found.model_difference_um < 0.1 * outcome.result.tolerance_um, "{found:?}");
        for k in 0..2 {
            let [a, b] = [found.spread_um[k], found.simulated_spread_um[k]];
            // The prediction has the noise of the readings, over 75 teeth.
            assert!((a - b).abs() < 1.5, "{law}: {found:?}");
        }
        assert_eq!(found.centre_distance_um.is_empty(), law == "coupling");
        assert_eq!(found.work_angle_deg.is_empty(), law == "centre-distance");
        spreads.push(found.simulated_spread_um);
    }
    let [both, distance, coupling] = spreads[..] else { unreachable!() };
    assert!(both[0] > 20.0 && both[1] < 1.5, "{both:?}");
    // Each part alone leaves the other one.
    assert!(distance[1] > 3.0 * both[1] && coupling[1] > 3.0 * both[1], "{distance:?} {coupling:?}");
}

#[test]
fn strokes_are_proven_from_their_texts() {
    let job = loaded(&text("run-out"));
    let outcome = run(&text("run-out"));
    let strokes: Vec<_> = outcome.programs.iter().filter(|p| p.file.contains("/skiving-")).collect();
    assert_eq!(strokes.len(), 3);
    for program in strokes {
        let (proof, text) = (program.proof, &program.written.text);
        let flank = proof.flank.expect("a flank under the referee");
        assert!(flank < 0.1e-3 * outcome.result.tolerance_um && flank > 0.0, "{proof:?}");
        // 24 blocks a turn leave (2 pi/24)^2/8 of an amplitude of 11.6 um.
        assert!((proof.between_places.expect("blocks") * 1e3 - 11.57 / 8.0 * 0.2618f64.powi(2)).abs() < 2e-2);
        assert_eq!(faults(&job, program.dialect, text), Vec::<String>::new());
        let lines: Vec<&str> = text.lines().collect();
        let middle =
            (lines.len() / 2..).find(|&k| lines[k].contains('C') && lines[k].contains('F')).expect("a block");
        for (letter, by) in [('X', 0.002), ('C', 0.002), ('B', 0.01), ('Z', 0.01), ('F', 20.0)] {
            let word = lines[middle].split_whitespace().find_map(|word| word.strip_prefix(letter));
            let Some(word) = word else { continue };
            let Ok(value) = word.parse::<f64>() else { continue };
            let mut changed = lines.clone();
            let line =
                lines[middle].replace(&format!("{letter}{word}"), &format!("{letter}{:.7}", value + by));
            changed[middle] = &line;
            let found = faults(&job, program.dialect, &(changed.join("\n") + "\n"));
            assert!(
                !found.is_empty() && found.iter().any(|text| text.contains("block ")),
                "{letter}: {found:?}"
            );
        }
    }
}

#[test]
fn a_probe_tells_the_setting_that_the_machine_really_has() {
    let plain = text("probed-workpiece");
    let outcome = run(&plain);
    let found = outcome.result.probe.clone().expect("a probe");
    assert!(found.simulated);
    // The errors of the setting are taken away, but for what noise and first order leave.
    assert!((found.correction.centre_distance_um + 6.0).abs() < 0.2, "{:?}", found.correction);
    assert!((found.correction.tool_angle_deg + 0.002).abs() < 1e-4, "{:?}", found.correction);
    let tolerance = outcome.result.tolerance_um;
    let before = found.flanks.values().map(|of| of.largest_um).fold(0.0, f64::max);
    assert!(before > 2.0, "{before}");
    for (flank, of) in &found.flanks {
        assert_eq!(of.gaps.len(), 4);
        assert!(of.corrected_simulated_um.expect("simulated") < 1.5, "{flank}: {of:?}");
    }
    // Noise of the probe included: its values are what the prediction begins with.
    assert!(
        found.model_difference_um.expect("simulated") < 0.1 * tolerance,
        "{:?}",
        found.model_difference_um
    );
    // The same values read from a table tell the same.
    let directory = tempfile::tempdir().expect("a directory");
    let table =
        skiving::probe_readings::probe_table(&outcome.probed.as_ref().expect("values").values).unwrap();
    let file = directory.path().join("w.csv");
    std::fs::write(&file, table.text()).expect("a file");
    let (before, after) = plain.split_once("setting_errors").expect("errors");
    let (_, after) = after.split_once('\n').expect("a line");
    let read = format!("{before}readings = {:?}\n{after}", file.display().to_string());
    let again = run(&read.replace("programs = [\"linuxcnc\", \"siemens\", \"fanuc\"]", ""));
    let again = again.result.probe.expect("a probe");
    assert!(!again.simulated && again.model_difference_um.is_none());
    assert!((again.correction.centre_distance_um - found.correction.centre_distance_um).abs() < 1e-6);
    // A table of other tooth spaces, and one beside the profile, are refused.
    let refuse = |table: &str| {
        std::fs::write(&file, table).expect("a file");
        format!("{:?}", run_skiving(&loaded(&read), &Silent).expect_err("refused"))
    };
    let other = refuse("flank,gap,roll_mm,deviation_um\nleft,5,9.0,1.0\n");
    assert!(other.contains("tooth space 5") && other.contains("workpiece_probe.readings"), "{other}");
    let rest = table.text().replacen("left,0,", "left,0,9", 1);
    let beside = refuse(&rest);
    assert!(beside.contains("beside the evaluated profile"), "{beside}");
}

#[test]
fn probe_programs_are_proven_from_their_texts() {
    let plain = text("probed-workpiece");
    let job = loaded(&plain);
    let outcome = run(&plain);
    let programs: Vec<_> = outcome.programs.iter().filter(|p| p.file.contains("/workpiece-")).collect();
    assert_eq!(programs.len(), 3);
    for program in programs {
        let (proof, text) = (program.proof, &program.written.text);
        assert_eq!(program.probed.len(), 8);
        assert!(proof.difference <= proof.allowed && proof.allowed < 1e-5, "{proof:?}");
        // Along the base circle straight blocks leave nothing.
        assert!(proof.between_places.expect("blocks") < 1e-5, "{proof:?}");
        assert_eq!(faults(&job, program.dialect, text), Vec::<String>::new());
        let lines: Vec<&str> = text.lines().collect();
        let scanned: Vec<usize> = (0..lines.len())
            .filter(|&k| lines[k].contains('C') && lines[k].contains('F') && lines[k].starts_with("G1"))
            .collect();
        for k in [scanned[6], scanned[scanned.len() / 2]] {
            for (letter, by) in [('X', 0.001), ('Y', 0.001), ('C', 0.001)] {
                let word = lines[k].split_whitespace().find_map(|word| word.strip_prefix(letter));
                let Some(value) = word.and_then(|word| word.parse::<f64>().ok()) else { continue };
                let line = lines[k]
                    .replace(&format!("{letter}{}", word.unwrap()), &format!("{letter}{:.7}", value + by));
                let mut changed = lines.clone();
                changed[k] = &line;
                let found = faults(&job, program.dialect, &(changed.join("\n") + "\n"));
                assert!(
                    !found.is_empty() && found.iter().all(|text| text.contains("block ")),
                    "{letter} {line}: {found:?}"
                );
            }
        }
    }
    // A ball too large for the tooth space.
    let large = loaded(&plain.replace("ball_radius = 0.5", "ball_radius = 1.6"));
    let refused = format!("{:?}", run_skiving(&large, &Silent).expect_err("refused"));
    assert!(refused.contains("workpiece_probe.ball_radius"), "{refused}");
}
