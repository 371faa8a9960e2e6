//! Every example job through the built command, with the exit status that it is there to show.

use crate::command::{repository, run};
use crate::documents::Documents;

/// Exit status of `plan`; `check` ends with 0 for all of them.
const PLANS: &[(&str, i32)] = &[
    ("asymmetric-conical-worm.toml", 0),
    ("automotive-bias.toml", 0),
    ("beveloid-conical-worm.toml", 0),
    ("beveloid-cylindrical-worm.toml", 0),
    ("catalogue.toml", 0),
    ("clamping.toml", 0),
    ("control/with-real-control.toml", 0),
    ("cycles/ev-gear.toml", 0),
    ("cycles/measured-blank.toml", 0),
    ("cycles/planet-gear.toml", 0),
    ("cycles/roughing-areas.toml", 0),
    ("cycles/spur-gear.toml", 0),
    ("cycles/truck-gear.toml", 0),
    ("dressing/conical-worm.toml", 0),
    ("dressing/strokes.toml", 0),
    ("dressing/gear-root.toml", 0),
    ("dressing/moving-strokes.toml", 0),
    ("dressing/moved-relief.toml", 0),
    ("dressing/free-points.toml", 0),
    ("dressing/measured-worm.toml", 0),
    ("dressing/weighed-points.toml", 0),
    ("axes-off.toml", 0),
    ("dressing/measured-dresser.toml", 0),
    ("dressing/wanted-worm.toml", 0),
    ("dressing/two-flanks.toml", 0),
    ("hob.toml", 0),
    ("left-out-thread.toml", 0),
    ("line-dressing.toml", 0),
    ("milling/automotive-gear.toml", 0),
    ("milling/bevel-epicycloid.toml", 0),
    ("milling/bevel-palloid.toml", 0),
    ("milling/bevel-skew.toml", 0),
    ("milling/bevel-tip-relief.toml", 0),
    ("milling/bevel-two-parts.toml", 0),
    ("milling/beveloid.toml", 0),
    ("milling/blade-on-head-head.toml", 0),
    ("milling/blade-wear.toml", 0),
    ("milling/blisk-blade.toml", 0),
    ("milling/crown-gear.toml", 0),
    ("milling/cylindrical-pair.toml", 0),
    ("milling/double-helical.toml", 0),
    ("milling/double-helical-bevel.toml", 0),
    ("milling/helical-module-6.toml", 0),
    ("milling/helical-on-bc-table.toml", 0),
    ("milling/hypoid-wheel.toml", 0),
    ("milling/internal-ring.toml", 0),
    ("milling/naca-blade.toml", 0),
    ("milling/pre-cut-gear.toml", 0),
    ("milling/spiral-bevel-15.toml", 0),
    ("milling/spiral-bevel-35.toml", 0),
    ("milling/spiral-bevel-on-head-table.toml", 0),
    ("milling/spur-module-8.toml", 0),
    ("milling/spur-on-ac-table.toml", 0),
    ("milling/straight-bevel-16.toml", 0),
    ("milling/straight-bevel-24.toml", 0),
    ("plated-worm.toml", 0),
    ("radial-feed-crowning.toml", 3),
    ("skiving/carried-barrier.toml", 0),
    ("skiving/damaged-tooth.toml", 3),
    ("skiving/external-stepped.toml", 0),
    ("skiving/internal-ring.toml", 0),
    ("skiving/lying-beam.toml", 0),
    ("skiving/measured-ring.toml", 0),
    ("skiving/probed-workpiece.toml", 0),
    ("skiving/run-out.toml", 0),
    ("skiving/shaping-cutter.toml", 0),
    ("skiving/tilted-beam.toml", 0),
    ("skiving/variable-rake.toml", 0),
    ("skiving/worn-tool.toml", 3),
    ("tangential/asymmetric.toml", 0),
    ("tangential/automotive.toml", 0),
    ("tangential/beveloid.toml", 0),
    ("tangential/both-flanks-at-once.toml", 0),
    ("tangential/example-1.toml", 0),
    ("tangential/example-1-chosen.toml", 0),
    ("tangential/example-1-small.toml", 0),
    ("tangential/example-2-names.toml", 0),
    ("tangential/example-2-source.toml", 0),
    ("tangential/example-2-symbols.toml", 0),
    ("tangential/example-3.toml", 0),
    ("tangential/existing-dresser.toml", 0),
    ("tangential/with-control.toml", 0),
    ("triangular-end-relief.toml", 0),
    ("twist-free-crowning.toml", 0),
    ("two-end-reliefs.toml", 0),
    ("variable-ratio.toml", 0),
    ("waviness.toml", 0),
    ("za-worm.toml", 0),
];

/// Exit status of `explore` for the jobs that are studies.
const STUDIES: &[(&str, i32)] = &[
    ("dressing/axis-deviations.toml", 0),
    ("catalogue-free-diameter.toml", 0),
    ("catalogue.toml", 0),
    ("catalogue-whole-target.toml", 0),
    ("dressing/figure-06.toml", 0),
    ("dressing/figure-07.toml", 0),
    ("dressing/figure-08-13b.toml", 0),
    ("dressing/figure-09-13a.toml", 0),
    ("dressing/figure-10-13c.toml", 0),
    ("dressing/figure-11-13d.toml", 0),
    ("dressing/figure-12.toml", 0),
    ("dressing/figure-19a-c.toml", 0),
    ("dressing/figure-19b.toml", 0),
    ("dressing/asymmetric-worm-life.toml", 0),
    ("dressing/figure-20a.toml", 0),
    ("dressing/figure-20b.toml", 0),
    ("tangential/explore.toml", 0),
    ("worm-life.toml", 0),
];

/// Exit status of `gearbox`.
const GEARBOXES: &[(&str, i32)] = &[
    ("gearbox/added-rotation.toml", 0),
    ("gearbox/ball-screw-and-encoder.toml", 3),
    ("gearbox/cheapest-set-up.toml", 0),
    ("gearbox/feed-to-and-fro.toml", 0),
    ("gearbox/following-with-disturbances.toml", 0),
    ("gearbox/into-the-gap.toml", 0),
    ("gearbox/older-multipliers.toml", 0),
    ("gearbox/reference-train.toml", 0),
    ("gearbox/scale-and-encoder.toml", 0),
    ("gearbox/whole-pulses-and-voltage.toml", 0),
];

/// Exit status of `inspect`, by the file of measurements; none where the job simulates them.
const INSPECTIONS: &[(&str, Option<&str>, i32)] = &[
    ("inspection/bevel.toml", Some("inspection/bevel.csv"), 3),
    ("inspection/closed-loop.toml", None, 0),
    ("inspection/measured.toml", Some("inspection/measured.csv"), 3),
    ("inspection/milled.toml", Some("inspection/milled.csv"), 3),
];

/// Files that jobs name.
const NO_JOBS: [&str; 1] = ["catalogue/bodies.toml"];

#[test]
fn examples_end_as_they_say() {
    let results = tempfile::tempdir().unwrap();
    let documents = Documents::of_the_program();
    let inspected = INSPECTIONS.iter().map(|&(name, _, _)| ("check", name, 0));
    let checks =
        PLANS.iter().chain(STUDIES).chain(GEARBOXES).map(|&(name, _)| ("check", name, 0)).chain(inspected);
    let plans = PLANS.iter().map(|&(name, exit)| ("plan", name, exit));
    let studies = STUDIES.iter().map(|&(name, exit)| ("explore", name, exit));
    let gearboxes = GEARBOXES.iter().map(|&(name, exit)| ("gearbox", name, exit));
    for (command, name, exit) in checks.chain(plans).chain(studies).chain(gearboxes) {
        let output = results.path().join(command).join(name);
        let run = run(&[command, &format!("examples/{name}"), "-o", output.to_str().unwrap()]);
        assert_eq!(run.exit, Some(exit), "{command} {name}: {run:?}");
        documents.meets_one_schema(&output);
    }
    for (name, measured, exit) in INSPECTIONS {
        let output = results.path().join("inspect").join(name);
        let job = format!("examples/{name}");
        let file = measured.map(|file| format!("examples/{file}"));
        let mut arguments = vec!["inspect", "--job", &job, "-o", output.to_str().unwrap()];
        arguments.extend(file.as_deref());
        let run = run(&arguments);
        assert_eq!(run.exit, Some(*exit), "inspect {name}: {run:?}");
        documents.meets_one_schema(&output);
    }
}

/// Job files below a directory of examples, as the lists above name them.
fn jobs(directory: &str) -> Vec<String> {
    let entries = std::fs::read_dir(repository().join("examples").join(directory)).unwrap();
    let mut found = Vec::new();
    for entry in entries.map(Result::unwrap) {
        let name = entry.file_name().into_string().unwrap();
        // Other tests put their directories beside the files that their jobs name.
        if name.starts_with('.') {
            continue;
        }
        let name = format!("{directory}{name}");
        if entry.file_type().unwrap().is_dir() {
            found.extend(jobs(&format!("{name}/")));
        } else if name.ends_with(".toml") {
            found.push(name);
        }
    }
    found
}

#[test]
fn every_example_has_its_expectation() {
    let mut found = jobs("");
    found.sort();
    let mut expected: Vec<&str> =
        PLANS.iter().chain(STUDIES).chain(GEARBOXES).map(|(name, _)| *name).collect();
    expected.extend(NO_JOBS);
    expected.extend(INSPECTIONS.iter().map(|(name, ..)| *name));
    expected.sort_unstable();
    // A job may be planned and studied.
    expected.dedup();
    assert_eq!(found, expected);
}
