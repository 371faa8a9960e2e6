//! Programs in C against the library: the test of the interface, and the step generator of the examples.

use crate::archive::{compiled, place};
use std::path::Path;
use std::process::Command;

/// What a program says; it has to end with status 0.
fn said(program: &Path) -> String {
    let run = Command::new(program).output().expect("it starts");
    let said = String::from_utf8_lossy(&run.stdout).into_owned();
    assert!(run.status.success(), "{}: {said}{}", run.status, String::from_utf8_lossy(&run.stderr));
    said
}

#[test]
fn the_interface_computes_and_refuses_what_it_says() {
    let directory = tempfile::tempdir().unwrap();
    let program = directory.path().join("gearbox");
    // Undefined behaviour in C ends the program.
    compiled(&[place("tests/c/gearbox.c")], &["-fsanitize=undefined", "-fno-sanitize-recover=all"], &program);
    assert_eq!(said(&program), "0 failures\n");
}

#[test]
fn nothing_of_the_library_can_panic_or_allocate() {
    let directory = tempfile::tempdir().unwrap();
    let program = directory.path().join("gearbox");
    compiled(&[place("tests/c/gearbox.c")], &[], &program);
    let listed = Command::new("nm").arg("--demangle").arg(&program).output().expect("nm runs");
    let names = String::from_utf8(listed.stdout).unwrap();
    assert!(names.contains(" T eg_engagement_update"), "{names}");
    for forbidden in ["panic", "malloc", "__rust_alloc", "core::fmt"] {
        assert!(!names.contains(forbidden), "{forbidden} in {names}");
    }
}

#[test]
fn the_step_generator_stays_a_step_from_the_exact_place() {
    let directory = tempfile::tempdir().unwrap();
    let program = directory.path().join("steps");
    let example = |name: &str| place("examples/step-generator").join(name);
    compiled(&[example("main.c"), example("step_generator.c")], &[], &program);
    let said = said(&program);
    // 300 1/min for 19 of 20 s, 2400 counts a revolution.
    assert!(said.starts_with("spindle 228000 counts, feed 7900 steps, gear -363699 steps;"), "{said}");
}
