//! The component of `examples/linuxcnc` in LinuxCNC's own HAL: counters of worm and feed line by line, and where it sends the spindle.
//! Without `scripts/linuxcnc-client`, or where `scripts/hal-peer` cannot mount, this test says so and checks nothing.

use crate::archive::{compiled, place};
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::PathBuf;
use std::process::Command;

const LINES: usize = 6000;
/// Lines between which the coupling is asked for.
const ENABLED: std::ops::Range<usize> = 100..5000;
const GAP: f64 = 2.5;
const PITCH: f64 = 360.0 / 40.0;

/// Counts of worm (4096 a revolution, 300 1/min at 1 kHz) and feed (1 um each, to and fro) at a line.
fn counts(line: usize) -> [i64; 2] {
    let place = line as i64 % 4000;
    [line as i64 * 2048 / 100, 2 * if place < 2000 { place } else { 4000 - place }]
}

/// Degrees that both have turned a gear of 40 teeth, module 2.5, 20 degrees by: one turn of the gear for 40/3 of the worm, and for a lead.
fn turned(line: usize) -> f64 {
    let [worm, feed] = counts(line);
    let lead = std::f64::consts::PI * 2.5 * 40.0 / 20f64.to_radians().sin();
    -3.0 / 40.0 * 360.0 * worm as f64 / 4096.0 + 360.0 * feed as f64 / 1000.0 / lead
}

fn skipped(missing: &str, why: &str) {
    // Not by `eprintln!`, which is only shown when a test fails: what was not tested has to be seen.
    drop(writeln!(
        std::io::stderr(),
        "{missing}: the component electronic_gearbox skipped; {}",
        why.trim().replace('\n', "; ")
    ));
}

#[test]
fn the_spindle_is_led_in_phase() {
    let target = std::env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into());
    let client: PathBuf = place("../..").join(target).join("linuxcnc/usr");
    let headers = client.join("include/linuxcnc");
    if !headers.join("hal.h").is_file() {
        return skipped(
            "LinuxCNC client absent",
            "no headers of LinuxCNC; scripts/linuxcnc-client gets them",
        );
    }
    let include = format!("-I{}", headers.display());
    let module = client.join("lib/linuxcnc/modules/electronic_gearbox.so");
    // LinuxCNC's headers are not written for all warnings.
    let options = [
        "-shared",
        "-fPIC",
        "-DRTAPI",
        "-DUSPACE",
        "-D__MODULE__",
        "-D_GNU_SOURCE",
        "-Wno-error",
        "-Wno-unused-parameter",
        &include,
    ];
    compiled(&[place("examples/linuxcnc/electronic_gearbox.c")], &options, &module);

    let directory = tempfile::tempdir().unwrap();
    let mut stream = String::new();
    for line in 0..LINES {
        let [worm, feed] = counts(line);
        writeln!(stream, "{} {worm} {feed}", u8::from(ENABLED.contains(&line))).unwrap();
    }
    std::fs::write(directory.path().join("stream.txt"), stream).unwrap();
    let netlist = directory.path().join("gearbox.hal");
    std::fs::write(&netlist, NETLIST).unwrap();
    let output = Command::new(place("../../scripts/hal-peer"))
        .arg(&netlist)
        .arg(directory.path())
        .output()
        .expect("the script starts");
    let message = String::from_utf8_lossy(&output.stderr);
    match output.status.code() {
        Some(76) => return skipped("LinuxCNC client absent", &message),
        Some(77) => return skipped("LinuxCNC HAL not runnable", &message),
        _ => assert!(output.status.success(), "{}: {message}", output.status),
    }
    let text = std::fs::read_to_string(directory.path().join("samples.txt")).unwrap();
    let samples: Vec<Vec<f64>> = text
        .lines()
        .map(|line| line.split_whitespace().map(|word| word.parse().expect("a number")).collect())
        .collect();
    assert_eq!(samples.len(), LINES);
    judged(&samples);
}

/// Off, up to speed, into the gap, coupled, leaving, off; in phase to a part of 1/10000 degree while coupled.
fn judged(samples: &[Vec<f64>]) {
    let mut states: Vec<u32> = samples.iter().map(|sample| sample[1] as u32).collect();
    states.dedup();
    assert_eq!(states, [0, 1, 2, 3, 4, 0]);
    let mut coupled = 0;
    let mut before = samples[0][0];
    for (line, sample) in samples.iter().enumerate() {
        let (place, state) = (sample[0], sample[1] as u32);
        assert_eq!((sample[2] == 1.0, sample[3]), (state == 3, 0.0), "line {line}: coupled and fault");
        // No jump: the coupling turns by 0.14 degrees a line, the phase move adds 90 degrees a second.
        assert!((place - before).abs() < 0.14 + 0.09 + 0.001, "line {line}: {before} to {place}");
        before = place;
        if state == 3 {
            let off = (place - GAP - turned(line)) / PITCH;
            let degrees = (off - off.round()) * PITCH;
            // The sum is rounded down to parts, once at the start and once here; printed are six decimals.
            assert!(degrees.abs() < 2e-4, "line {line}: {degrees} degrees from the gap");
            coupled += 1;
        }
    }
    assert!(coupled > 4500, "{coupled} lines coupled");
}

const NETLIST: &str = "loadrt threads name1=t period1=1000000
loadrt streamer depth=6100 cfg=bss
loadrt sampler depth=6100 cfg=fubb
loadrt electronic_gearbox threads=3 teeth=40 worm_counts=4096 feed_counts=1000000 module_um=2500 helix_mdeg=20000
addf streamer.0 t
addf electronic-gearbox.update t
addf sampler.0 t
net enable streamer.0.pin.0 => electronic-gearbox.enable
net worm streamer.0.pin.1 => electronic-gearbox.worm-counts
net feed streamer.0.pin.2 => electronic-gearbox.feed-counts
setp electronic-gearbox.gap 2.5
net place electronic-gearbox.position-cmd => electronic-gearbox.position-fb sampler.0.pin.0
net state electronic-gearbox.state => sampler.0.pin.1
net coupled electronic-gearbox.coupled => sampler.0.pin.2
net fault electronic-gearbox.fault => sampler.0.pin.3
loadusr -w halstreamer -c 0 stream.txt
start
loadusr -w halsampler -c 0 -n 6000 samples.txt
";
