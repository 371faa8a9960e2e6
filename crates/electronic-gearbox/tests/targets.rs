//! The firmware of `examples/cortex-m` on a microcontroller: it is linked for a Cortex-M4, and runs there in Debian's emulator, where
//! every setpoint has to be the exact one. Without `scripts/embedded-target` these tests say what they left out.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

const TARGET: &str = "thumbv7em-none-eabihf";

/// Ticks of the processor's clock for a thousand cycles of the loop: 20, 800 instructions each as the emulator counts, and some room.
const MOST_TICKS: u32 = 30_000;

fn skipped(missing: &str, why: &str) {
    // Not by `eprintln!`, which is only shown when a test fails: what was not tested has to be seen.
    drop(writeln!(std::io::stderr(), "{missing}: {why}; scripts/embedded-target gets it"));
}

fn has_core_library() -> bool {
    let root = Command::new("rustc").args(["--print", "sysroot"]).output().expect("rustc runs");
    let root = PathBuf::from(String::from_utf8_lossy(&root.stdout).trim());
    root.join("lib/rustlib").join(TARGET).is_dir()
}

/// The firmware for the microcontroller; none, and that said, without its core library.
fn firmware() -> Option<PathBuf> {
    if !has_core_library() {
        skipped(
            "embedded target absent",
            &format!("no core library of {TARGET}, the firmware was not linked"),
        );
        return None;
    }
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/cortex-m");
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join("cortex-m");
    // In its folder: its .cargo/config.toml has the target and the linker's script.
    let built = Command::new(env!("CARGO"))
        .current_dir(&example)
        .args(["build", "--release", "--quiet", "--locked", "--target-dir"])
        .arg(&directory)
        .env_remove("RUSTFLAGS")
        .output()
        .expect("cargo runs");
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    Some(directory.join(TARGET).join("release/gearbox-on-cortex-m"))
}

#[test]
fn a_cortex_m_runs_the_loop_and_every_setpoint_is_exact() {
    let Some(firmware) = firmware() else { return };
    let run = Command::new(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scripts/emulated"))
        .arg(&firmware)
        .output()
        .expect("the script starts");
    if run.status.code() == Some(76) {
        return skipped("emulator absent", "no qemu-system-arm, the firmware was linked and not run");
    }
    let said = String::from_utf8_lossy(&run.stdout).into_owned();
    assert!(run.status.success(), "{}: {said}{}", run.status, String::from_utf8_lossy(&run.stderr));
    let lines: Vec<&str> = said.lines().collect();
    let [measured, reached] = lines[..] else { panic!("{said}") };
    let ticks: u32 = measured.split(' ').next().unwrap().parse().expect("a number of ticks");
    assert!((1000..MOST_TICKS).contains(&ticks), "{measured}");
    // 20000 cycles of 20.48 counts are 100 turns of the worm, 7.5 of a gear with 36000 counts; the slide is back where it began.
    assert_eq!(reached, "after 20000 cycles: -270000 counts and 0/16");
}
