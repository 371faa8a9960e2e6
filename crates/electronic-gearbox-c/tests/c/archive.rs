//! The static library, made once for all tests here, and programs in C that are linked with it.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// A folder of this crate.
pub fn place(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// `libelectronic_gearbox.a` for this machine.
pub fn archive() -> &'static Path {
    static MADE: OnceLock<PathBuf> = OnceLock::new();
    MADE.get_or_init(|| made(None))
}

/// The library for a target of Rust, for this machine without one.
pub fn made(target: Option<&str>) -> PathBuf {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join("archive");
    let built = Command::new(env!("CARGO"))
        .args(["build", "--release", "--quiet", "--locked", "--manifest-path"])
        .arg(place("archive/Cargo.toml"))
        .arg("--target-dir")
        .arg(&directory)
        .args(target.into_iter().flat_map(|target| ["--target", target]))
        .env_remove("RUSTFLAGS")
        .output()
        .expect("cargo runs");
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    directory.join(target.unwrap_or_default()).join("release/libelectronic_gearbox.a")
}

/// Functions that the library offers to a linker.
pub fn functions(library: &Path) -> BTreeSet<String> {
    let listed = Command::new("nm").arg("--defined-only").arg(library).output().expect("nm runs");
    let names = String::from_utf8_lossy(&listed.stdout).into_owned();
    let lines = names.lines().filter_map(|line| line.split(" T ").nth(1));
    lines.filter(|name| name.starts_with("eg_")).map(str::to_owned).collect()
}

/// Compiles C with all warnings as errors, and links it with the library.
pub fn compiled(sources: &[PathBuf], options: &[&str], to: &Path) {
    let made = Command::new("cc")
        .args(["-std=c11", "-Wall", "-Wextra", "-Werror", "-O2"])
        .args(options)
        .arg("-I")
        .arg(place("include"))
        .args(sources)
        .arg(archive())
        .args(["-lm", "-o"])
        .arg(to)
        .output()
        .expect("cc runs: Rust links with it");
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
}
