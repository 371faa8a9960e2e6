//! Every example job through the built command, with the exit status that it is there to show.

use crate::command::{repository, run};

/// Commands that the examples go through; `check` ends with 0 for all of them.
const COMMANDS: &[&str] = &["check", "plan"];

/// Exit status of the other commands.
const EXPECTED: [(&str, i32); 13] = [
    ("asymmetric-conical-worm.toml", 0),
    ("automotive-bias.toml", 0),
    ("beveloid-conical-worm.toml", 0),
    ("beveloid-cylindrical-worm.toml", 0),
    ("hob.toml", 0),
    ("left-out-thread.toml", 0),
    ("plated-worm.toml", 0),
    ("radial-feed-crowning.toml", 3),
    ("triangular-end-relief.toml", 0),
    ("twist-free-crowning.toml", 0),
    ("two-end-reliefs.toml", 0),
    ("variable-ratio.toml", 0),
    ("waviness.toml", 0),
];

#[test]
fn examples_end_as_they_say() {
    let results = tempfile::tempdir().unwrap();
    for command in COMMANDS {
        for (name, exit) in EXPECTED {
            let output = results.path().join(command).join(name);
            let run = run(&[command, &format!("examples/{name}"), "-o", output.to_str().unwrap()]);
            let expected = if *command == "check" { 0 } else { exit };
            assert_eq!(run.exit, Some(expected), "{command} {name}: {run:?}");
        }
    }
}

#[test]
fn every_example_has_its_expectation() {
    let mut names: Vec<String> = std::fs::read_dir(repository().join("examples"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.ends_with(".toml"))
        .collect();
    names.sort();
    assert_eq!(names, EXPECTED.map(|(name, _)| name));
}
