//! Programs of whole runs in LinuxCNC itself: `rs274` and the module `gcode` find in them what the neutral programs say. Without
//! `scripts/linuxcnc-client` these tests say so and check nothing.

use crate::line_programs::{job, planned};
use crate::peer::client::Client;
use crate::peer::{Found, PRINTED, canonical, client, compare, wanted};
use flankwright::exchange::{MillingJob, read_job_of};
use flankwright::nc::{Dialect, read};
use flankwright::workflow::Outcome;
use flankwright::workflow::milling::{run_milling, write_milling};
use std::path::PathBuf;

/// Every LinuxCNC program of a run of generating grinding; the number of motions.
fn add_run(found: &mut Found, client: &Client, directory: &tempfile::TempDir, outcome: &Outcome) -> usize {
    let before = found.motions;
    let programs = &outcome.programs.as_ref().expect("programs").built.programs;
    for made in programs.iter().filter(|made| made.dialect == Dialect::LinuxCnc) {
        found.add(client, directory, &made.layout.program, &made.written.text);
    }
    found.motions - before
}

/// Every LinuxCNC program that the examples with a machine give.
#[test]
fn the_programs_of_the_examples_mean_the_same_in_linuxcnc() {
    let Some((client, directory)) = client("programs of the examples") else { return };
    let mut found = Found::default();
    for example in ["twist-free-crowning", "automotive-bias", "radial-feed-crowning"] {
        let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("../../examples/{example}.toml"));
        let loaded = flankwright::exchange::read_job(&path).expect("an example");
        let outcome = flankwright::workflow::plan_job(&loaded, &flankwright::numerics::Silent);
        assert!(add_run(&mut found, &client, &directory, &outcome.expect("a plan")) > 10, "{example}");
    }
    found.tell();
}

/// Line dressing goes from line to line with many short motions, and stops between two threads.
#[test]
fn programs_of_line_dressing_mean_the_same_in_linuxcnc() {
    let Some((client, directory)) = client("programs of line dressing") else { return };
    let mut found = Found::default();
    let outcome = planned(&job(&[("\"siemens\"", "\"linuxcnc\"")], ""));
    assert!(add_run(&mut found, &client, &directory, &outcome) > 100);
    found.tell();
}

/// The LinuxCNC program that `plan` writes for each milling example with a machine: every motion goes where the axes were planned
/// to be, and the feeds are those of the text.
#[test]
fn the_programs_of_milling_examples_mean_the_same_in_linuxcnc() {
    let Some((client, directory)) = client("programs of the milling examples") else { return };
    let examples =
        ["spur-on-ac-table", "helical-on-bc-table", "spiral-bevel-on-head-table", "blade-on-head-head"];
    for example in examples {
        let path =
            PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("../../examples/milling/{example}.toml"));
        let Ok(loaded) = read_job_of::<MillingJob>(&path) else { panic!("{example} is no milling job") };
        let outcome = run_milling(&loaded, &flankwright::numerics::Silent).expect("a plan");
        let written = directory.path().join(example);
        write_milling(&outcome, &written).expect("files");
        let programs = outcome.texts.programs.expect("programs");
        let made =
            programs.programs.iter().find(|made| made.dialect == Dialect::LinuxCnc).expect("a program");
        let text = std::fs::read_to_string(written.join(&made.file)).expect("a text");
        let tools = "T1 P1 Z0\nT2 P2 Z0\n";
        let output = client.interpret_with_tools(&written.join(&made.file), directory.path(), tools);
        assert!(output.status.success(), "{example}: {}", String::from_utf8_lossy(&output.stderr));
        let found = canonical(&String::from_utf8_lossy(&output.stdout));
        let axes = made.program.axes();
        let planned = wanted(axes, made.program.blocks());
        assert!(planned.len() > 50, "{example}");
        assert_eq!(planned.len(), found.len(), "{example}");
        let mut worst = [0.0f64; 2];
        for (planned, found) in planned.iter().zip(&found) {
            for axis in 0..9 {
                let off = (planned.place[axis] - found.place[axis]).abs();
                let kind = usize::from((3..6).contains(&axis));
                worst[kind] = worst[kind].max(off);
            }
        }
        // What the text rounds, 4 decimals of mm and 5 of degrees, and what is printed.
        assert!(worst[0] <= PRINTED + 5.001e-5 && worst[1] <= PRINTED + 5.001e-6, "{example}: {worst:?}");
        println!("{example}: {} motions, {worst:?} mm and deg off", found.len());
        // What the text says is at hand, so that only the printing is left, of the feeds as well.
        let read = read(text.as_bytes(), Dialect::LinuxCnc, axes).expect("a program").blocks;
        compare(&wanted(axes, &read), &found, PRINTED, PRINTED, 1e-4);
    }
}
