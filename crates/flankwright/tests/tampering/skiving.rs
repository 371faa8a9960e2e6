//! Tampering with programs that measure a skiving tool: recordings at the light barrier and scans with a stylus. A damage counts if a
//! place would be measured elsewhere, a recording is missing, the spindle turns at another speed, or the tool gets where it must not.

use super::edits::{harmless, moves, with, word};
use super::{Answer, COUNT, Tampered, all_accepted, all_noticed, below, between, random, sign};
use flankwright::exchange::machine::{LoadedMachine, read_machine};
use flankwright::exchange::{LoadedSkivingJob, SkivingJob, Source, parse_job_of};
use flankwright::nc::Dialect;
use flankwright::workflow::skiving::SkivingCheck;
use rand_chacha::ChaCha8Rng;
use std::ops::Range;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn job(name: &str) -> LoadedSkivingJob {
    let text = std::fs::read_to_string(root().join(format!("examples/skiving/{name}.toml"))).unwrap();
    match parse_job_of::<SkivingJob>(Source::new("job.toml", &text)) {
        Ok(loaded) => loaded,
        other => panic!("{other:?}"),
    }
}

fn machine() -> LoadedMachine {
    read_machine(&root().join("machines/skiving-light-barrier.toml")).unwrap()
}

fn answer(check: &SkivingCheck<'_>, dialect: Dialect, text: &str) -> Answer {
    let checked = match check.check(text.as_bytes(), dialect) {
        Ok(checked) => checked,
        Err(failure) => return Answer::Refused(format!("{failure:?}")),
    };
    let measuring = checked.measuring.expect("what it measures");
    if checked.remarks.is_empty() {
        assert_eq!(measuring.sound, measuring.wanted, "{}", measuring.statement);
        return Answer::Accepted;
    }
    let findings: Vec<String> = checked.remarks.iter().map(|remark| remark.text.clone()).collect();
    let placed = findings.iter().all(|text| text.starts_with("block "));
    Answer::Noticed { findings, placed }
}

/// Lines of a track or an edge: from its comment to that of the next.
struct Sections {
    lines: Vec<String>,
    ranges: Vec<Range<usize>>,
}

impl Sections {
    fn new(text: &str, begin: &str) -> Self {
        let lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let is_begin = |k: &usize| {
            let name = lines[*k].strip_prefix(['(', ';']).map(str::trim_start);
            moves(&lines[*k + 1]) && name.is_some_and(|name| name.starts_with(begin))
        };
        let mut ends: Vec<usize> = (0..lines.len() - 1).filter(is_begin).collect();
        ends.push(lines.iter().rposition(|line| moves(line)).unwrap() + 1);
        let ranges = ends.windows(2).map(|pair| pair[0]..pair[1]).collect();
        Self { lines, ranges }
    }

    /// Lines of a section that move axes.
    fn moving(&self, section: usize) -> Vec<usize> {
        self.ranges[section].clone().filter(|&k| moves(&self.lines[k])).collect()
    }

    /// Lines of a section that turn the spindle. A control that stands still to switch its output runs up and brakes with the output on;
    /// what it turns beside that is no part of a measurement.
    fn turning(&self, section: usize) -> Vec<usize> {
        let outputs = self.outputs(section);
        let stands = self.lines.iter().any(|line| line.starts_with("G53"));
        let recorded = |k: usize| outputs.iter().filter(|&&at| at < k).count() % 2 == 1;
        let turns = |k: &usize| word(&self.lines[*k], 'B').is_some() && (!stands || recorded(*k));
        self.moving(section).into_iter().skip(1).filter(turns).collect()
    }

    /// Lines of a section in which the output is switched.
    fn outputs(&self, section: usize) -> Vec<usize> {
        let is_output =
            |line: &str| line.starts_with("M6") || line.contains("$A_OUT") || line.starts_with('#');
        self.ranges[section].clone().filter(|&k| is_output(&self.lines[k])).collect()
    }

    fn text(&self, lines: &[String]) -> String {
        lines.iter().filter(|line| !line.is_empty()).map(|line| format!("{line}\n")).collect()
    }
}

/// Damages of both kinds of programs; `None` for those of one of them.
fn of_any(kind: usize, of: &Sections, section: usize, random: &mut ChaCha8Rng) -> Option<Tampered> {
    let mut lines = of.lines.clone();
    let (range, moving) = (of.ranges[section].clone(), of.moving(section));
    let (rapid, into, out) = (moving[0], moving[1], *moving.last().unwrap());
    let what = match kind {
        0 => {
            // Into the pose or out of it.
            let at = [into, out][below(random, 2)];
            lines[at].clear();
            format!("line {} dropped: {}", at + 1, of.lines[at])
        }
        1 => {
            let outputs = of.outputs(section);
            let at = outputs[below(random, outputs.len())];
            lines[at].clear();
            format!("line {} dropped: {}", at + 1, of.lines[at])
        }
        2 => {
            lines[range.clone()].iter_mut().for_each(String::clear);
            format!("lines {} to {} left out", range.start + 1, range.end)
        }
        3 => {
            // Across the beam, which stands along Z.
            let letter = ['X', 'Y'][below(random, 2)];
            let by = sign(random) * between(random, [0.05, 2.0]);
            for k in moving {
                lines[k] = with(&lines[k], letter, 6, |value| value + by);
            }
            format!("lines {} to {} moved by {letter} {by:.3} mm", range.start + 1, range.end)
        }
        4 => {
            let by = sign(random) * between(random, [0.01, 1.0]);
            for k in moving {
                lines[k] = with(&lines[k], 'A', 7, |value| value + by);
            }
            format!("lines {} to {} swivelled by {by:.3} deg", range.start + 1, range.end)
        }
        5 => {
            // Through the beam at X = 300 and back.
            let outside = word(&lines[rapid], 'X').unwrap();
            let beyond = 600.0 - outside;
            lines[out] += &format!("\nG0 X{beyond:.6}\nG0 X{outside:.6}");
            format!("rapid to X{beyond:.6} behind line {}", out + 1)
        }
        6 => {
            let deep = word(&lines[into], 'X').unwrap();
            let by = 0.05 * (deep - word(&lines[rapid], 'X').unwrap()).signum();
            lines[into] = with(&lines[into], 'X', 6, |x| x + by);
            format!("line {} 0.05 mm too deep", into + 1)
        }
        7 => {
            let factor = [25.4, 60.0][below(random, 2)];
            let at = [into, out][below(random, 2)];
            lines[at] = with(&lines[at], 'F', 6, |feed| feed * factor);
            format!("line {} with {factor} times its feed", at + 1)
        }
        8 => {
            // The places of one are taken for those of the other.
            let other = (section + 1 + below(random, of.ranges.len() - 1)) % of.ranges.len();
            let [first, second] = [section.min(other), section.max(other)].map(|k| of.ranges[k].clone());
            let mut order: Vec<usize> = (0..first.start).collect();
            order.extend(second.clone());
            order.extend(first.end..second.start);
            order.extend(first.clone());
            order.extend(second.end..lines.len());
            lines = order.into_iter().map(|k| of.lines[k].clone()).collect();
            format!(
                "lines {} to {} exchanged with {} to {}",
                first.start, first.end, second.start, second.end
            )
        }
        _ => return None,
    };
    Some(Tampered { what, text: of.text(&lines) })
}

/// Damages of what is recorded at the light barrier.
fn of_recording(kind: usize, of: &Sections, section: usize, random: &mut ChaCha8Rng) -> Tampered {
    let mut lines = of.lines.clone();
    let turning = of.turning(section);
    let at = turning[below(random, turning.len())];
    let what = match kind {
        0 => {
            let factor = [25.4, 60.0, 1.0 / 60.0, 1.01][below(random, 4)];
            lines[at] = with(&lines[at], 'F', 6, |feed| feed * factor);
            format!("line {} with {factor:.3} times its feed", at + 1)
        }
        1 => {
            lines[at].clear();
            format!("line {} dropped: {}", at + 1, of.lines[at])
        }
        2 => {
            let by = sign(random) * between(random, [0.5, 400.0]);
            lines[at] = with(&lines[at], 'B', 7, |angle| angle + by);
            format!("line {}: B off by {by:.3} deg", at + 1)
        }
        _ => {
            let by = sign(random) * between(random, [0.5, 180.0]);
            for &k in &turning {
                lines[k] = with(&lines[k], 'B', 7, |angle| angle + by);
            }
            format!("line {} and all beside it turned by {by:.3} deg", at + 1)
        }
    };
    Tampered { what, text: of.text(&lines) }
}

/// Damages of what is scanned with a stylus.
fn of_scanning(kind: usize, of: &Sections, section: usize, random: &mut ChaCha8Rng) -> Tampered {
    let mut lines = of.lines.clone();
    let moving = of.moving(section);
    let places = &moving[2..moving.len() - 1];
    let at = places[below(random, places.len())];
    let what = match kind {
        0 => {
            let factor = [25.4, 60.0, 1.0 / 60.0, 1.01][below(random, 4)];
            lines[at] = with(&lines[at], 'F', 6, |feed| feed * factor);
            format!("line {} with {factor:.3} times its feed", at + 1)
        }
        1 => {
            lines[at].clear();
            format!("line {} dropped: {}", at + 1, of.lines[at])
        }
        2 => {
            let letter = ['X', 'Y'][below(random, 2)];
            let by = sign(random) * between(random, [0.01, 1.0]);
            lines[at] = with(&lines[at], letter, 6, |value| value + by);
            format!("line {}: {letter} off by {by:.3} mm", at + 1)
        }
        _ => {
            // All of an edge as if it were that of another tooth.
            let by = 360.0 / 75.0 * (1 + below(random, 10)) as f64 * sign(random);
            for &k in &moving {
                lines[k] = with(&lines[k], 'B', 7, |angle| angle + by);
            }
            format!("line {} and all beside it turned by {by:.3} deg", at + 1)
        }
    };
    Tampered { what, text: of.text(&lines) }
}

/// Damages and edits of a program of a job.
fn tampered(name: &str, file: &str, dialect: Dialect, begin: &str, comment: [&str; 2]) {
    let (loaded, machine) = (job(name), machine());
    let check = SkivingCheck::new(&loaded, &machine).unwrap();
    let programs = check.programs().unwrap();
    let program = programs.iter().find(|program| program.file == file).unwrap();
    let of = Sections::new(&program.written.text, begin);
    assert!(matches!(answer(&check, dialect, &program.written.text), Answer::Accepted));
    let own = if begin == "SCAN" { of_scanning } else { of_recording };
    let mut random = random(file);
    let damages: Vec<Tampered> = (0..COUNT)
        .map(|k| {
            let section = below(&mut random, of.ranges.len());
            let kind = k % 13;
            let any = of_any(kind, &of, section, &mut random);
            any.unwrap_or_else(|| own(kind - 9, &of, section, &mut random))
        })
        .collect();
    let style = (comment, &['X', 'Y', 'Z'][..]);
    let edits: Vec<Tampered> = (0..COUNT).map(|k| harmless(k, &of.lines, style, &mut random)).collect();
    all_accepted(&edits, |text| answer(&check, dialect, text));
    all_noticed(&damages, |text| answer(&check, dialect, text));
}

#[test]
fn damaged_recordings_at_the_light_barrier_are_noticed() {
    let file = "programs/measuring-linuxcnc.ngc";
    tampered("internal-ring", file, Dialect::LinuxCnc, "", ["(", ")"]);
}

/// A control that stands still to switch its output.
#[test]
fn damaged_recordings_of_a_control_that_stands_to_switch_are_noticed() {
    let file = "programs/measuring-fanuc.nc";
    tampered("internal-ring", file, Dialect::Fanuc, "", ["(", ")"]);
}

#[test]
fn damaged_scans_with_a_stylus_are_noticed() {
    let file = "programs/scan-siemens.mpf";
    tampered("external-stepped", file, Dialect::Siemens, "SCAN", ["; ", ""]);
}

/// Damages of a program that drives a mandrel: each way elsewhere, at another speed, unrecorded, or through the beam by rapid.
#[test]
fn damaged_calibrations_are_noticed() {
    let (loaded, machine) = (job("external-stepped"), machine());
    let check = SkivingCheck::new(&loaded, &machine).unwrap();
    let programs = check.programs().unwrap();
    let file = "programs/calibration-siemens.mpf";
    let program = programs.iter().find(|program| program.file == file).unwrap();
    let of = Sections::new(&program.written.text, "MANDREL");
    assert!(matches!(answer(&check, Dialect::Siemens, &program.written.text), Answer::Accepted));
    let mut random = random(file);
    let damage = |k: usize, random: &mut ChaCha8Rng| {
        let mut lines = of.lines.clone();
        let section = below(random, of.ranges.len());
        let (moving, outputs) = (of.moving(section), of.outputs(section));
        // What moves between the outputs is recorded.
        let recorded = *moving.iter().find(|&&k| k > outputs[0] && k < outputs[1]).unwrap();
        let what = match k % 4 {
            0 => {
                let factor = [25.4, 60.0, 1.0 / 60.0, 1.01][below(random, 4)];
                lines[recorded] = with(&lines[recorded], 'F', 6, |feed| feed * factor);
                format!("line {} with {factor:.3} times its feed", recorded + 1)
            }
            1 => {
                lines[recorded].clear();
                format!("line {} dropped", recorded + 1)
            }
            2 => {
                let at = outputs[below(random, outputs.len())];
                lines[at].clear();
                format!("line {} dropped", at + 1)
            }
            _ => {
                // What the mandrel is beside its way shows in the switches.
                let letter = ['X', 'Y'][below(random, 2)];
                let by = sign(random) * between(random, [0.02, 2.0]);
                for k in 0..lines.len() {
                    lines[k] = with(&lines[k], letter, 6, |value| value + by);
                }
                format!("everything moved by {letter} {by:.3} mm")
            }
        };
        Tampered { what, text: of.text(&lines) }
    };
    let damages: Vec<Tampered> = (0..COUNT).map(|k| damage(k, &mut random)).collect();
    let style = (["; ", ""], &['X', 'Y', 'Z'][..]);
    let edits: Vec<Tampered> = (0..COUNT).map(|k| harmless(k, &of.lines, style, &mut random)).collect();
    all_accepted(&edits, |text| answer(&check, Dialect::Siemens, text));
    all_noticed(&damages, |text| answer(&check, Dialect::Siemens, text));
}
