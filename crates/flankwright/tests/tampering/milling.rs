//! Tampering with the program of a milled spur gear of 20 teeth on a table A-C, in positions of the axes.

use super::{Answer, COUNT, Tampered, all_accepted, all_noticed, below, between, random, sign};
use crate::milling_example::example;
use flankwright::exchange::LoadedMillingJob;
use flankwright::exchange::machine::{LoadedMachine, read_machine};
use flankwright::nc::Dialect;
use flankwright::numerics::Silent;
use flankwright::workflow::milling::{MillingCheck, run_milling};
use rand_chacha::ChaCha8Rng;
use std::path::Path;

/// The gear, narrow so that the test is quick.
fn job() -> LoadedMillingJob {
    example(
        "spur-on-ac-table",
        &[("face_width = 60.0", "face_width = 12.0"), ("rays_length = 11", "rays_length = 5")],
    )
}

fn machine() -> LoadedMachine {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../machines/five-axis-ac-table.toml");
    read_machine(&file).unwrap()
}

fn program(loaded: &LoadedMillingJob) -> String {
    let outcome = run_milling(loaded, &Silent).unwrap();
    let verdict = &outcome.result.verdict;
    assert!(verdict.is_accepted(), "{:?}", verdict.reason());
    let programs = outcome.texts.programs.unwrap().programs;
    programs.into_iter().find(|program| program.dialect == Dialect::LinuxCnc).unwrap().written.text
}

fn answer(check: &MillingCheck<'_>, tolerance_um: f64, text: &str) -> Answer {
    let checked = match check.check(text.as_bytes(), Dialect::LinuxCnc, &Silent) {
        Ok(checked) => checked,
        Err(failure) => return Answer::Refused(format!("{failure:?}")),
    };
    let within = checked.flanks.iter().flatten().all(|(_, flank)| flank.max_deviation_um <= tolerance_um);
    if checked.remarks.is_empty() && within {
        return Answer::Accepted;
    }
    let findings: Vec<String> = checked.remarks.iter().map(|remark| remark.text.clone()).collect();
    let placed = checked.part.is_some_and(|part| {
        part.faults.iter().any(|fault| fault.block > 0 && fault.place_mm.iter().all(|mm| mm.is_finite()))
    }) || findings.iter().any(|text| text.starts_with("block "));
    Answer::Noticed { findings, placed }
}

/// A line that moves axes.
#[derive(Clone, Copy, PartialEq)]
enum Pace {
    Rapid,
    Cut,
}

fn pace(line: &str) -> Option<Pace> {
    let words = || line.split_whitespace();
    let moves = words().any(|word| word.starts_with(['X', 'Y', 'Z', 'A', 'C']));
    let rapid = words().any(|word| word == "G0");
    let cut = words().any(|word| word == "G1");
    match (moves, rapid, cut) {
        (true, true, _) => Some(Pace::Rapid),
        (true, _, true) => Some(Pace::Cut),
        _ => None,
    }
}

fn value(line: &str, letter: char) -> f64 {
    let word =
        line.split_whitespace().find(|word| word.starts_with(letter)).unwrap_or_else(|| panic!("{line}"));
    word[1..].parse().unwrap()
}

/// The line with another value of a word.
fn with(line: &str, letter: char, change: impl Fn(f64) -> f64) -> String {
    let changed = |word: &str| match word.strip_prefix(letter).and_then(|text| text.parse().ok()) {
        Some(value) => format!("{letter}{:.4}", change(value)),
        None => word.to_owned(),
    };
    line.split_whitespace().map(changed).collect::<Vec<_>>().join(" ")
}

/// A path in the text: rapid moves to it, then approach, plunge, cut and retraction.
#[derive(Clone, Debug)]
struct PathLines {
    /// All of its lines.
    from: usize,
    to: usize,
    /// The line of its cut: the last but one.
    cut: usize,
    /// Whether the cutter of the bottom follows it.
    bottom: bool,
}

/// The paths of all spaces in their order.
fn paths(lines: &[String]) -> Vec<PathLines> {
    let mut paths: Vec<PathLines> = Vec::new();
    let (mut from, mut cuts, mut bottom) = (None, Vec::new(), false);
    for (k, line) in lines.iter().enumerate() {
        if line.contains("T2 M6") || line.contains("M6 T2") {
            bottom = true;
        }
        let next_is_cut = lines.get(k + 1).is_some_and(|next| pace(next) == Some(Pace::Cut));
        match pace(line) {
            Some(Pace::Rapid) => {
                from.get_or_insert(k);
            }
            Some(Pace::Cut) => {
                cuts.push(k);
                if !next_is_cut && cuts.len() >= 3 {
                    let cut = cuts[cuts.len() - 2];
                    paths.push(PathLines { from: from.unwrap_or(cuts[0]), to: k + 1, cut, bottom });
                }
                if !next_is_cut {
                    (from, cuts) = (None, Vec::new());
                }
            }
            None => {}
        }
    }
    paths
}

const SPACES: usize = 20;

/// A damage of the kind that the number says; each changes the part by more than the tolerance of 0.04 mm, breaks a limit or collides.
fn damage(kind: usize, lines: &[String], paths: &[PathLines], random: &mut ChaCha8Rng) -> Tampered {
    let flanks: Vec<&PathLines> = paths.iter().filter(|path| !path.bottom).collect();
    let bottoms: Vec<&PathLines> = paths.iter().filter(|path| path.bottom).collect();
    let mut changed: Vec<String> = lines.to_vec();
    let any = paths[below(random, paths.len())].clone();
    let row = flanks[below(random, flanks.len())].clone();
    let what = match kind % 7 {
        0 => {
            // Without its cut a path goes from its begin to where it is drawn back: the row stays.
            changed[any.cut].clear();
            format!("line {} dropped: {}", any.cut + 1, lines[any.cut])
        }
        1 => {
            changed[any.cut] = with(&lines[any.cut], 'Z', |z| z - 20.0).replace("G93 G1", "G94 G0");
            let kept: Vec<&str> =
                changed[any.cut].split_whitespace().filter(|word| !word.starts_with('F')).collect();
            changed[any.cut] = kept.join(" ");
            format!("line {} rapid through the part: {}", any.cut + 1, changed[any.cut])
        }
        2 => {
            // 0.3 degrees are 0.4 mm on a radius of 76 mm.
            let by = sign(random) * between(random, [0.3, 6.0]);
            for line in &mut changed[row.from..row.to] {
                if pace(line).is_some() {
                    *line = with(line, 'C', |c| c + by);
                }
            }
            format!("lines {} to {} turned by {by:.3} deg", row.from + 1, row.to)
        }
        3 => {
            // The bottom is cut to its drawn depth.
            let deep = bottoms[below(random, bottoms.len())];
            for k in [deep.cut - 1, deep.cut] {
                changed[k] = with(&lines[k], 'Z', |z| z - 0.05);
            }
            format!("lines {} and {} 0.05 mm too deep", deep.cut, deep.cut + 1)
        }
        4 => {
            let by = if sign(random) > 0.0 { 60.0 } else { 1.0 / 60.0 };
            changed[any.cut] = with(&lines[any.cut], 'F', |feed| feed * by);
            format!("line {} with another feed: {}", any.cut + 1, changed[any.cut])
        }
        5 => {
            // Across the row, so that it does not slide along itself.
            let [x, y] = ['X', 'Y']
                .map(|letter| (value(&lines[row.cut], letter) - value(&lines[row.cut - 1], letter)).abs());
            let letter = if x < y { 'X' } else { 'Y' };
            let by = sign(random) * between(random, [0.3, 3.0]);
            for line in &mut changed[row.cut - 1..=row.cut] {
                *line = with(line, letter, |at| at + by);
            }
            format!("lines {} and {} moved by {letter} {by:.3} mm", row.cut, row.cut + 1)
        }
        _ => {
            let space = below(random, SPACES);
            for all in [&flanks, &bottoms] {
                let each = all.len() / SPACES;
                for path in &all[space * each..(space + 1) * each] {
                    changed[path.from..path.to].iter_mut().for_each(String::clear);
                }
            }
            format!("space {} left out", space + 1)
        }
    };
    changed.retain(|line| !line.is_empty());
    Tampered { what, text: changed.join("\n") + "\n" }
}

/// An edit that changes nothing.
fn edit(kind: usize, lines: &[String], random: &mut ChaCha8Rng) -> Tampered {
    let mut changed = lines.to_vec();
    let moving: Vec<usize> = (0..lines.len()).filter(|&k| pace(&lines[k]).is_some()).collect();
    let at = moving[below(random, moving.len())];
    let what = match kind % 5 {
        0 => {
            changed.insert(at, format!("(CHECKED BY SHIFT {})", below(random, 100)));
            "a comment"
        }
        1 => {
            let first = 1 + below(random, 1000);
            for (number, line) in changed.iter_mut().enumerate() {
                if line.starts_with('N') {
                    let rest: Vec<&str> = line.split_whitespace().skip(1).collect();
                    *line = format!("N{} {}", first + number, rest.join(" "));
                }
            }
            "other block numbers"
        }
        2 => {
            changed[at] = lines[at].replace(' ', "   ");
            "more spaces"
        }
        3 => {
            changed[at] = with(&lines[at], 'X', |x| x).replace(".0000 ", ".0 ");
            "a number in other digits"
        }
        _ => {
            // The same place once more.
            let rapid =
                moving.iter().copied().filter(|&k| pace(&lines[k]) == Some(Pace::Rapid)).collect::<Vec<_>>();
            let k = rapid[below(random, rapid.len())];
            changed.insert(k + 1, lines[k].clone());
            "a rapid move said twice"
        }
    };
    Tampered { what: format!("{what} at line {}", at + 1), text: changed.join("\n") + "\n" }
}

#[test]
fn damaged_programs_are_noticed_and_edited_ones_accepted() {
    let (loaded, machine) = (job(), machine());
    let text = program(&loaded);
    let lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let paths = paths(&lines);
    assert_eq!(paths.len() % SPACES, 0, "{}", paths.len());
    assert!(paths.iter().any(|path| path.bottom));
    let check = MillingCheck::new(&loaded, &machine, &Silent).unwrap();
    let tolerance = loaded.job.target.tolerance_um;
    let mut random = random("milling");
    let damages: Vec<Tampered> = (0..COUNT).map(|k| damage(k, &lines, &paths, &mut random)).collect();
    let edits: Vec<Tampered> = (0..COUNT).map(|k| edit(k, &lines, &mut random)).collect();
    all_accepted(&edits, |text| answer(&check, tolerance, text));
    all_noticed(&damages, |text| answer(&check, tolerance, text));
}
