//! Programs of a worm that a disc writes line by line: every line on every thread, proven from their texts; damaged texts are noticed.

use flankwright::exchange::{AnyJob, LoadedJob, Source, parse_any_job, parse_job};
use flankwright::nc::Dialect;
use flankwright::numerics::Silent;
use flankwright::workflow::{BuiltProgram, CheckedProgram, Outcome, ProgramChecker, plan_job};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Few lines: a narrow gear, high scallops, a worm of two threads.
const JOB: &str = r#"
[job]
name = "line-programs"
process = "generating-grinding"
[gear]
teeth = 19
normal_module = 3.5
normal_pressure_angle_deg = 17.5
helix_angle_deg = 35.0
profile_shift = 0.0
face_width = 4.0
tip_diameter = 88.0
root_diameter = 72.4
form_diameter = 76.6
[target]
tolerance_um = 10.0
modifications = [{ kind = "profile_crowning", amount_um = 3.0 }]
[worm]
threads = 2
hand = "right"
pitch_diameter = 160.0
width = 60.0
[dresser]
tip_diameter = 123.0
contact = "point"
tip_radius = 0.6
[dressing]
scallop_um = 8.0
line_direction_deg = 80.0
[grinding]
method = "diagonal"
flanks = "both"
diagonal_ratio = 0.5
[grid]
profile_points = 3
helix_points = 3
[output]
programs = ["siemens"]
"#;

fn machine() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../machines/eight-axis.toml")
}

/// The job with changes, and lines for `[machine]`.
fn text(changes: &[(&str, &str)], more: &str) -> String {
    let mut text = JOB.to_owned();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    format!("{text}\n[machine]\nfile = {:?}\n{more}\n", machine().display().to_string())
}

/// That job.
pub fn job(changes: &[(&str, &str)], more: &str) -> LoadedJob {
    parse_job(Source::new("line-programs.toml", &text(changes, more))).unwrap_or_else(|e| panic!("{e}"))
}

/// Its plan.
pub fn planned(loaded: &LoadedJob) -> Outcome {
    plan_job(loaded, &Silent).unwrap_or_else(|e| panic!("{e:?}"))
}

fn program<'a>(outcome: &'a Outcome, file: &str) -> &'a BuiltProgram {
    let built = &outcome.programs.as_ref().expect("programs").built.programs;
    built.iter().find(|p| p.file == file).unwrap_or_else(|| panic!("no {file}"))
}

#[test]
fn every_line_on_every_thread_of_both_flanks_is_proven() {
    let outcome = planned(&job(&[], ""));
    let result = &outcome.result;
    assert!(result.verdict.is_accepted(), "{:?}", result.verdict);
    let programs = result.programs.as_ref().expect("programs");
    let files: Vec<&str> = programs.programs.iter().map(|p| p.file.as_str()).collect();
    let expected = ["dressing-left", "dressing-right", "grinding"];
    assert_eq!(files, expected.map(|name| format!("programs/{name}-siemens.mpf")));
    assert!(result.warnings.iter().all(|w| w.code != "dressing-without-program"), "{:?}", result.warnings);
    let [proof] = programs.proofs.as_slice() else { panic!("{:?}", programs.proofs) };
    assert_eq!((proof.threads.len(), proof.threads_of_worm, proof.lines.len()), (2, 2, 2));
    assert_eq!(proof.flanks.len(), 2);
    for lines in &proof.lines {
        let run = result.flanks[lines.flank].line_dressing.as_ref().expect("lines of the run");
        assert_eq!((lines.lines, lines.threads), (run.lines, 2));
        assert!(lines.line_difference_um <= lines.allowed_difference_um, "{lines:?}");
        assert!(lines.allowed_difference_um < 0.2, "{lines:?}");
        // The rays find on the text's lines what they found on the plan's.
        let apart = (lines.scallop_um - run.simulated_scallop_um).abs();
        assert!(apart < 0.2 && lines.undercut_um < 0.2, "{lines:?} {run:?}");
        assert!(lines.inside_mm.expect("hops inside the thread space") > 0.5, "{lines:?}");
        assert!(lines.outside_mm.expect("approach") > 0.0, "{lines:?}");
        let said = format!("{} flank of the worm: {} lines on each of 2 threads", lines.flank, lines.lines);
        assert!(proof.statement.contains(&said), "{}", proof.statement);
        let text = &program(&outcome, &lines.file).written.text;
        for thread in [1, 2] {
            let head = format!("DRESSING {} FLANK BY LINES THREAD {thread} OF 2", lines.flank.to_uppercase());
            assert_eq!(text.matches(&head).count(), 1, "{head}");
        }
    }
    for thread in &proof.threads {
        assert_eq!((thread.blocks.len(), thread.difference_um.len()), (2, 2), "{thread:?}");
    }
}

/// Strokes that leave stock are found beside the finishing ones, which are told by their height.
#[test]
fn stock_is_left_before_the_finishing_lines() {
    let one = [("flanks = \"both\"", "flanks = \"left\""), ("threads = 2", "threads = 1")];
    let plain = planned(&job(&one, ""));
    let outcome = planned(&job(&one, "dressing_stock_um = [30.0]"));
    assert!(outcome.result.verdict.is_accepted(), "{:?}", outcome.result.verdict);
    let file = "programs/dressing-left-siemens.mpf";
    let passes = |outcome: &Outcome| program(outcome, file).layout.passes.len();
    assert_eq!((passes(&plain), passes(&outcome)), (1, 2));
    assert!(program(&outcome, file).written.text.contains("STOCK 30 UM"));
    let proof = &outcome.result.programs.as_ref().expect("programs").proofs[0];
    assert_eq!((proof.lines[0].threads, proof.threads.len()), (1, 1));
}

/// Several areas need lines that the plan has not: no program is written for the dressing, and the verdict says so.
#[test]
fn lines_on_several_areas_are_owed() {
    let changes = [
        ("method = \"diagonal\"", "method = \"diagonal\"\nareas = 2"),
        ("width = 60.0", "width = 200.0"),
        ("flanks = \"both\"", "flanks = \"left\""),
    ];
    let own = Path::new(env!("CARGO_TARGET_TMPDIR")).join("line-programs-long-shift.toml");
    let long = std::fs::read_to_string(machine()).expect("a machine");
    let long = long.replace("min_mm = -140", "min_mm = -250").replace("max_mm = 140", "max_mm = 250");
    std::fs::write(&own, long).expect("a machine with more travel");
    let shipped = machine().display().to_string();
    let text = text(&changes, "").replace(&shipped, &own.display().to_string());
    let loaded = parse_job(Source::new("areas.toml", &text)).unwrap_or_else(|e| panic!("{e}"));
    let outcome = planned(&loaded);
    let verdict = &outcome.result.verdict;
    assert!(!verdict.is_accepted(), "{verdict:?}");
    assert_eq!(verdict.reason().map(|reason| reason.code), Some("dressing-without-program"));
    let programs = outcome.result.programs.as_ref().expect("programs");
    assert!(programs.programs.iter().all(|p| p.job == "grinding"));
}

/// The blocks of each line, thread after thread: the disc comes to the flank by a block of the radial axis alone, and leaves it so.
fn strokes(lines: &[&str]) -> Vec<Range<usize>> {
    let radial = |line: &str| -> Option<f64> {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words.as_slice() {
            ["G1", x, f] if f.starts_with('F') => x.strip_prefix('X')?.parse().ok(),
            _ => None,
        }
    };
    let any =
        |line: &str| line.split_whitespace().find_map(|word| word.strip_prefix('X')?.parse::<f64>().ok());
    let mut found = Vec::new();
    let mut at = f64::NEG_INFINITY;
    for (k, line) in lines.iter().enumerate() {
        // On this machine the worm comes nearer to the dresser with growing X.
        let nearer = radial(line).is_some_and(|x| x > at);
        if nearer && lines.get(k + 1).is_some_and(|next| next.contains("B1=") && next.starts_with("G1")) {
            let end = (k + 1..lines.len()).find(|&j| radial(lines[j]).is_some()).expect("a retraction");
            found.push(k + 1..end);
        }
        at = any(line).unwrap_or(at);
    }
    found
}

/// The line with a number behind a word changed, if it has the word.
fn with(line: &str, word: &str, change: f64) -> String {
    let changed = |text: &str| match text.strip_prefix(word).and_then(|number| number.parse::<f64>().ok()) {
        Some(value) => format!("{word}{:.7}", value + change),
        None => text.to_owned(),
    };
    line.split(' ').map(changed).collect::<Vec<_>>().join(" ")
}

fn codes(checked: &CheckedProgram) -> Vec<&str> {
    checked.remarks.iter().map(|remark| remark.code).collect()
}

#[test]
fn damaged_texts_are_noticed() {
    let changes = [("flanks = \"both\"", "flanks = \"left\"")];
    let loaded = job(&changes, "");
    let outcome = planned(&loaded);
    let count = outcome.result.flanks["left"].line_dressing.as_ref().expect("lines").lines;
    let text_of_run = program(&outcome, "programs/dressing-left-siemens.mpf").written.text.clone();
    let file = loaded.job.machine.as_ref().expect("a machine").file.clone();
    let machine =
        flankwright::exchange::machine::read_machine(&loaded.beside(&file)).unwrap_or_else(|e| panic!("{e}"));
    let any: AnyJob = parse_any_job(Source::new("line-programs.toml", &text(&changes, "")))
        .unwrap_or_else(|e| panic!("{e}"));
    let checker = ProgramChecker::new(&machine, Some(&any), &Silent).unwrap_or_else(|e| panic!("{e:?}"));
    let check = |text: &str| {
        checker.check((text.as_bytes(), None), Dialect::Siemens, &Silent).unwrap_or_else(|e| panic!("{e:?}"))
    };
    let lines: Vec<&str> = text_of_run.lines().collect();
    let strokes = strokes(&lines);
    assert_eq!(strokes.len(), 2 * count);
    let rebuilt = |change: &dyn Fn(usize, &str) -> Option<String>| -> String {
        let changed: Vec<String> = lines.iter().enumerate().filter_map(|(k, line)| change(k, line)).collect();
        changed.join("\n") + "\n"
    };

    let whole = check(&text_of_run);
    assert_eq!(codes(&whole), Vec::<&str>::new(), "{:?}", whole.remarks);
    assert_eq!((whole.kind, whole.threads.len(), whole.strokes.len()), (Some("dressing"), 2, 2));
    let serves = format!("DRESSING LEFT FLANK BY LINES THREAD 2 OF 2, {count} OF {count} LINES");
    assert_eq!(whole.strokes[1].serves.as_deref(), Some(serves.as_str()));
    let flank = whole.flanks.as_ref().expect("flanks")["left"];
    let run = &outcome.result.flanks["left"];
    let expected = run.max_deviation_um + run.line_dressing.as_ref().expect("lines").off_um();
    assert!((flank.max_deviation_um - expected).abs() < 0.2 && flank.difference_um < 0.2, "{flank:?}");

    // Comments and spacing change nothing.
    let spaced =
        rebuilt(&|k, line| Some(if k % 7 == 3 { format!("{line} ; NOTE {k}") } else { line.to_owned() }));
    assert_eq!(codes(&check(&spaced)), Vec::<&str>::new());

    // A line in the middle of the second thread left out, with its infeed and its retraction.
    let middle = &strokes[count + count / 2];
    let gone = middle.start - 1..middle.end + 1;
    let checked = check(&rebuilt(&|k, line| (!gone.contains(&k)).then(|| line.to_owned())));
    let missing = checked.remarks.iter().find(|r| r.code == "line-missing").expect("a missing line");
    let said = format!(
        "thread 2 of 2 of the worm, left flank: 1 of {count} lines are not written: {}",
        count / 2 + 1
    );
    assert!(missing.text.contains(&said), "{}", missing.text);

    // A line with 0.05 mm too much infeed, which counts by the sine of the pressure angle at least.
    let one = &strokes[count / 3];
    let deep = one.start - 1..one.end;
    let checked = check(&rebuilt(&|k, line| {
        Some(if deep.contains(&k) { with(line, "X", 0.05) } else { line.to_owned() })
    }));
    let off = checked
        .remarks
        .iter()
        .find(|r| r.code == "line-off")
        .unwrap_or_else(|| panic!("{:?}", checked.remarks));
    assert!(
        off.text.contains("thread 1 of 2") && off.text.contains(&format!("line {} ", count / 3 + 1)),
        "{}",
        off.text
    );
    assert!(checked.flanks.as_ref().expect("flanks")["left"].max_deviation_um > 14.0);

    // One block of a line deeper: at one place it cuts into the flank.
    let dent = strokes[count + 2].start;
    let checked =
        check(&rebuilt(&|k, line| Some(if k == dent { with(line, "X", 0.3) } else { line.to_owned() })));
    assert!(!checked.remarks.is_empty());

    // The second thread indexed wrongly by one degree.
    let second = lines.iter().position(|line| line.contains("THREAD 2 OF 2")).expect("the second thread");
    let checked =
        check(&rebuilt(&|k, line| Some(if k > second { with(line, "B1=", 1.0) } else { line.to_owned() })));
    let found = codes(&checked);
    assert!(found.iter().any(|code| ["line-off", "line-missing"].contains(code)), "{:?}", checked.remarks);
    assert!(checked.remarks.iter().any(|r| r.text.contains("thread 2 of 2")), "{:?}", checked.remarks);

    // The last block of a line is missing.
    let long = strokes.iter().find(|stroke| stroke.len() > 2).expect("a line of several blocks");
    let last = long.end - 1;
    let checked = check(&rebuilt(&|k, line| (k != last).then(|| line.to_owned())));
    assert!(
        codes(&checked).iter().any(|code| ["line-short", "line-missing"].contains(code)),
        "{:?}",
        checked.remarks
    );
}
