//! The crate in a program without std: it links without operating system, allocator and C library, and holds no way to panic. For bare-metal
//! targets whose core library is installed the same holds of the program for them (`scripts/embedded-target` gets one).

use std::path::{Path, PathBuf};
use std::process::Command;

fn bare(target: Option<&str>, directory: &Path) -> PathBuf {
    let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/bare/Cargo.toml");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["rustc", "--release", "--quiet", "--manifest-path", manifest, "--target-dir"]).arg(directory);
    match target {
        Some(target) => {
            cargo.args(["--target", target]);
        }
        None => {
            cargo.args([
                "--",
                "-C",
                "link-arg=-nostartfiles",
                "-C",
                "link-arg=-nostdlib",
                "-C",
                "link-arg=-static",
            ]);
        }
    }
    let built = cargo.env_remove("RUSTFLAGS").output().expect("cargo runs");
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    directory.join(target.unwrap_or_default()).join("release/bare")
}

fn symbols(program: &Path) -> String {
    let listed = Command::new("nm")
        .arg("--demangle")
        .arg(program)
        .output()
        .expect("nm runs: it comes with the linker");
    assert!(listed.status.success(), "{}", String::from_utf8_lossy(&listed.stderr));
    String::from_utf8(listed.stdout).expect("names")
}

#[test]
fn nothing_but_core_and_no_way_to_panic() {
    let directory = tempfile::tempdir().unwrap();
    let names = symbols(&bare(None, directory.path()));
    assert!(names.contains(" T _start"), "the program was linked: {names}");
    for forbidden in ["panic", "alloc", "malloc", "unwind", "std::"] {
        assert!(!names.contains(forbidden), "{forbidden} in {names}");
    }
    // What is undefined would have to come from an operating system.
    assert!(!names.lines().any(|line| line.trim_start().starts_with("U ")), "{names}");
}

#[test]
fn installed_bare_metal_targets_have_no_way_to_panic() {
    let root = Command::new("rustc").args(["--print", "sysroot"]).output().expect("rustc runs");
    let libraries = Path::new(String::from_utf8_lossy(&root.stdout).trim()).join("lib/rustlib");
    let installed = std::fs::read_dir(libraries).into_iter().flatten().flatten();
    // Beside each folder of a target lies the list of its files.
    let targets = installed
        .filter(|entry| entry.path().is_dir())
        .filter_map(|entry| entry.file_name().into_string().ok());
    for target in targets.filter(|target| target.contains("-none-")) {
        let directory = tempfile::tempdir().unwrap();
        let names = symbols(&bare(Some(&target), directory.path()));
        for forbidden in ["panic", "alloc", "unwind", "std::"] {
            assert!(!names.contains(forbidden), "{target}: {forbidden} in {names}");
        }
    }
}
