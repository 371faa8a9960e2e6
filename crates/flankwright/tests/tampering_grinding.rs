//! Damaged programs of generating grinding and of tangential dressing: `program check` with the job notices every damage that changes
//! worm or gear, breaks a limit or lets bodies collide, and accepts harmless edits. What a damage does is known from its own size, never
//! from the check. `TAMPER_SEED` chooses other damages.

use flankwright::exchange::{AnyJob, Source, parse_any_job};
use flankwright::nc::Dialect;
use flankwright::numerics::Silent;
use flankwright::workflow::tangential::plan_tangential;
use flankwright::workflow::{CheckedProgram, ProgramChecker, RunFailure, RunPrograms, plan_job};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::collections::BTreeMap;
use std::path::Path;

/// Damages and harmless edits of each process.
const DAMAGES: usize = 50;
const HARMLESS: usize = 50;
/// Axial way of the worm's thread a turn, pitch of its threads in degrees, mm.
const LEAD: f64 = 33.037;
/// Speeds of the worm that the jobs give, deg/s: dressing at 60 1/min, grinding at 50 m/s on a diameter of 200 mm.
const DRESSING_SPEED: f64 = 360.0;
const GRINDING_SPEED: f64 = 28_648.0;

/// Gear and bodies of both jobs.
const BODIES: &str = r#"
[gear]
teeth = 19
normal_module = 3.5
normal_pressure_angle_deg = 17.5
helix_angle_deg = -35.0
profile_shift = 0.0
face_width = 40.0
tip_diameter = 88.5315
root_diameter = 72.4315
form_diameter = 76.2065
[worm]
threads = 3
tip_diameter = 200.0
width = 100.0
[dresser]
tip_diameter = 123.0
pitch_diameter = 115.65
[grid]
profile_points = 5
helix_points = 5
[output]
programs = ["fanuc"]
"#;

const GRINDING: &str = r#"
[job]
name = "tampered"
process = "generating-grinding"
[target]
tolerance_um = 1.0
modifications = [
  { kind = "helix_crowning", amount_um = 20.0 },
  { kind = "profile_crowning", amount_um = 5.0 },
]
[dressing]
profile_crowning_by = "dresser"
[grinding]
method = "diagonal"
feed_per_revolution = 0.3
"#;

const TANGENTIAL: &str = r#"
[job]
name = "tampered"
process = "tangential-dressing"
[target]
tolerance_um = 1.0
edge_amounts = { profile_crowning_um = 5.0, lead_crowning_um = 100.0 }
[grinding]
flanks = "right"
shift_width = 48.1042
shift_offset = 0.0
feed_per_revolution = 0.3
[dressing]
variables = "source"
weights = "source"
fit_points = 5
"#;

struct Dice(ChaCha8Rng);

impl Dice {
    fn new() -> Self {
        let seed = std::env::var("TAMPER_SEED").ok().and_then(|seed| seed.parse().ok()).unwrap_or(20_261);
        println!("TAMPER_SEED={seed}");
        Self(ChaCha8Rng::seed_from_u64(seed))
    }

    fn below(&mut self, n: usize) -> usize {
        (self.0.next_u64() % n as u64) as usize
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * (self.0.next_u32() as f64 / f64::from(u32::MAX))
    }

    /// An amount with either sign.
    fn signed(&mut self, from: f64, to: f64) -> f64 {
        let amount = self.between(from, to);
        if self.below(2) == 0 { amount } else { -amount }
    }
}

/// A word of a line.
fn word(line: &str, letter: char) -> Option<f64> {
    let found = line.split_whitespace().find(|word| word.starts_with(letter))?;
    found[1..].parse().ok()
}

/// The line with a word changed, if it has it.
fn with(line: &str, letter: char, change: impl Fn(f64) -> f64) -> String {
    let changed = |text: &str| match text.strip_prefix(letter).and_then(|number| number.parse::<f64>().ok()) {
        Some(value) => format!("{letter}{:.7}", change(value)),
        None => text.to_owned(),
    };
    line.split(' ').map(changed).collect::<Vec<_>>().join(" ")
}

/// A program by its lines, with the lines of every pass: its comment first.
#[derive(Clone)]
struct Text {
    lines: Vec<String>,
    passes: Vec<std::ops::Range<usize>>,
    dressing: bool,
}

impl Text {
    fn new(text: &str, dressing: bool) -> Self {
        let lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let named = if dressing { "(DRESSING " } else { "(GRINDING " };
        let begins = |k: &usize| {
            lines[*k].starts_with(named) && lines.get(*k + 1).is_some_and(|next| next.starts_with("G0"))
        };
        let mut ends: Vec<usize> = (0..lines.len()).filter(begins).collect();
        ends.push(lines.iter().rposition(|line| line.starts_with("G94")).expect("the end of inverse time"));
        let passes = ends.windows(2).map(|pair| pair[0]..pair[1]).collect();
        Self { lines, passes, dressing }
    }

    fn whole(&self) -> String {
        self.lines.join("\n") + "\n"
    }

    /// Changes a word in all lines of a pass.
    fn change(&mut self, pass: usize, letter: char, change: impl Fn(f64) -> f64 + Copy) {
        for k in self.passes[pass].clone() {
            if !self.lines[k].starts_with('(') {
                self.lines[k] = with(&self.lines[k], letter, change);
            }
        }
    }

    fn words(&self, pass: usize, letter: char) -> Vec<f64> {
        self.passes[pass].clone().filter_map(|k| word(&self.lines[k], letter)).collect()
    }

    /// X off the worm or the workpiece, and at depth.
    fn depths(&self, pass: usize) -> [f64; 2] {
        let all = self.words(pass, 'X');
        [all[0], all[1]]
    }

    fn is_roughing(&self, pass: usize) -> bool {
        self.lines[self.passes[pass].start].contains("ROUGHING")
    }

    /// Speed at which the line turns the worm from where it stood, deg/s.
    fn turning(&self, from: usize, line: usize) -> f64 {
        let before = self.lines[..=from].iter().rev().find_map(|line| word(line, 'B')).expect("a place");
        let to = word(&self.lines[line], 'B').unwrap_or(before);
        (to - before).abs() * word(&self.lines[line], 'F').expect("inverse time") / 60.0
    }
}

/// One damage: its name and the damaged text. `None` if the draw changes nothing that counts.
fn damage(text: &Text, dice: &mut Dice) -> Option<(String, String)> {
    let mut text = text.clone();
    let dressing = text.dressing;
    let pass = dice.below(text.passes.len());
    let roughing = text.is_roughing(pass);
    let lines = text.passes[pass].clone();
    let name = match dice.below(10) {
        0 => {
            let moves: Vec<usize> = lines.filter(|&k| text.lines[k].starts_with("G1")).collect();
            let at = 1 + dice.below(moves.len() - 3);
            let given = if dressing { DRESSING_SPEED } else { GRINDING_SPEED };
            // Without the block the next one has its way to do in its own time.
            if text.turning(moves[at - 1], moves[at + 1]) < 1.2 * given {
                return None;
            }
            text.lines.remove(moves[at]);
            format!("line {} dropped", moves[at] + 1)
        }
        1 => {
            // A roughing pass less leaves more to the finishing one, whose flank is the same.
            if roughing {
                return None;
            }
            text.lines.drain(lines);
            "pass left out".to_owned()
        }
        2 => {
            let (letter, by) = match (dressing, roughing) {
                (true, _) => ('B', dice.signed(0.2, 30.0)),
                (_, true) => ('C', dice.signed(0.5, 5.0)),
                _ => ('C', dice.signed(0.05, 5.0)),
            };
            text.change(pass, letter, |value| value + by);
            format!("{letter} turned by {by:.3} deg")
        }
        3 => {
            let [off, deep] = text.depths(pass);
            let middle = if dressing { "G0 Y0.000000" } else { "G0 Z0.000000 Y0.000000" };
            let rapid = [format!("G0 X{off:.6}"), middle.to_owned(), format!("G0 X{deep:.6}")];
            drop(text.lines.splice(lines.end..lines.end, rapid));
            "rapid through the part".to_owned()
        }
        4 => {
            let [off, deep] = text.depths(pass);
            // A roughing pass leaves 60 um on a flank, 0.2 mm of distance.
            let by = if roughing { 0.25 + dice.between(0.0, 0.2) } else { 0.05 };
            text.change(pass, 'X', |value| value + by * (deep - off).signum());
            format!("{by:.3} mm too deep")
        }
        5 => {
            // A dressing stroke moved along the worm stands off its thread; a grinding pass touches other lines of the worm.
            let by = if dressing { dice.signed(1.0, 5.0) } else { dice.signed(5.0, 9.0) };
            text.change(pass, 'Y', |value| value + by);
            let follow = !dressing && !roughing && dice.below(2) == 0;
            if follow {
                let turn = by / LEAD * 360.0 * 3.0 / 19.0 * dice.signed(1.0, 1.0);
                text.change(pass, 'C', |value| value + turn);
            }
            format!("moved along the worm by {by:.3} mm, workpiece with it: {follow}")
        }
        6 => {
            let factor = [25.4, 60.0][dice.below(2)];
            text.change(pass, 'F', |value| value * factor);
            format!("feed of another unit, {factor} times")
        }
        7 | 8 => {
            // One block in the middle of the stroke, where it touches; rays stand farther apart than it goes.
            if roughing {
                return None;
            }
            let moves: Vec<usize> = lines.filter(|&k| text.lines[k].starts_with("G1")).collect();
            let at = moves[moves.len() * 3 / 8 + dice.below(moves.len() / 4)];
            let [off, deep] = text.depths(pass);
            if dice.below(2) == 0 {
                let (letter, by) =
                    if dressing { ('B', dice.signed(0.1, 2.0)) } else { ('C', dice.signed(0.05, 0.5)) };
                text.lines[at] = with(&text.lines[at], letter, |value| value + by);
                format!("line {}: {letter} off by {by:.3} deg", at + 1)
            } else {
                let there = deep + 0.05 * (deep - off).signum();
                if text.lines[at].contains(" X") {
                    text.lines[at] = with(&text.lines[at], 'X', |value| value + there - deep);
                } else {
                    for (k, x) in [(at, there), (at + 1, deep)] {
                        text.lines[k] = text.lines[k].replacen("G1 ", &format!("G1 X{x:.6} "), 1);
                    }
                }
                format!("line {}: 0.05 mm too deep", at + 1)
            }
        }
        _ => {
            if dressing {
                let begin = text.words(pass, 'B')[0];
                let by = dice.signed(5e-4, 1e-2);
                text.change(pass, 'B', |value| begin + (value - begin) * (1.0 + by));
                format!("lead off by {by:.5}")
            } else {
                let by = if roughing { dice.signed(0.05, 0.2) } else { dice.signed(0.005, 0.1) };
                let mut feed = 0.0;
                for k in lines {
                    feed = word(&text.lines[k], 'Z').unwrap_or(feed);
                    text.lines[k] = with(&text.lines[k], 'C', |value| value + by * feed);
                }
                format!("lead off by {by:.5} deg/mm")
            }
        }
    };
    let of = if dressing { "dressing" } else { "grinding" };
    Some((format!("{of}, pass {pass}: {name}"), text.whole()))
}

/// An edit that changes nothing that moves.
fn harmless(text: &Text, dice: &mut Dice) -> (String, String) {
    let mut text = text.clone();
    let moves: Vec<usize> = (0..text.lines.len()).filter(|&k| text.lines[k].starts_with("G1")).collect();
    let at = moves[dice.below(moves.len())];
    let name = match dice.below(4) {
        0 => {
            text.lines.insert(at, "(LOOKED AT BY THE SECOND SHIFT)".to_owned());
            "comment"
        }
        1 => {
            for (number, k) in moves.into_iter().enumerate() {
                text.lines[k] = format!("N{} {}", 10 * (number + 1), text.lines[k]);
            }
            "block numbers"
        }
        2 => {
            text.lines[at] = text.lines[at].replace(' ', "   ");
            "spacing"
        }
        _ => {
            // A word that says where the axis stands already.
            let stands = text.lines[..at].iter().rev().find_map(|line| word(line, 'Y')).expect("a place");
            if word(&text.lines[at], 'Y').is_none() {
                text.lines[at] = text.lines[at].replacen(" F", &format!(" Y{stands:.6} F"), 1);
            }
            "equal word"
        }
    };
    (name.to_owned(), text.whole())
}

fn remarks(checked: &CheckedProgram) -> BTreeMap<&'static str, usize> {
    let mut codes = BTreeMap::new();
    for remark in &checked.remarks {
        *codes.entry(remark.code).or_insert(0) += 1;
    }
    codes
}

/// Damages the programs of a job, and edits them without harm.
fn tampered(job: &str, plan: impl Fn(&AnyJob) -> RunPrograms) {
    let machine = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../machines/no-swivel.toml");
    let machine = machine.display().to_string();
    let text = format!("{job}{BODIES}[machine]\nfile = {machine:?}\nroughing_stock_um = [60.0]\n");
    let any = parse_any_job(Source::new("tampered.toml".to_owned(), &text)).expect("a job");
    let programs = plan(&any);
    let texts: Vec<Text> = ["programs/dressing-fanuc.nc", "programs/grinding-fanuc.nc"]
        .into_iter()
        .map(|file| {
            let built = programs.built.programs.iter().find(|p| p.file == file).expect("a program");
            Text::new(&built.written.text, file.contains("dressing"))
        })
        .collect();
    let checker = ProgramChecker::new(&programs.machine, Some(&any), &Silent).expect("a run");
    let check = |text: &str| checker.check((text.as_bytes(), None), Dialect::Fanuc, &Silent);
    for text in &texts {
        let checked = check(&text.whole()).expect("the program itself");
        assert!(checked.remarks.is_empty(), "{:?}", checked.remarks);
    }
    let mut dice = Dice::new();
    let (mut drawn, mut unnoticed, mut unplaced) = (0, Vec::new(), Vec::new());
    while drawn < DAMAGES {
        let number = dice.below(texts.len());
        let Some((name, text)) = damage(&texts[number], &mut dice) else { continue };
        drawn += 1;
        match check(&text) {
            Ok(checked) if checked.remarks.is_empty() => unnoticed.push(name),
            Ok(checked) if checked.remarks.iter().any(|r| r.text.contains("block")) => {}
            Ok(checked) => unplaced.push(format!("{name}: {:?}", checked.remarks)),
            Err(RunFailure::BadInput(finding) | RunFailure::NotProducible(finding)) => {
                if !finding.message.contains("block") {
                    unplaced.push(format!("{name}: {}", finding.message));
                }
            }
        }
    }
    println!("{} of {DAMAGES} noticed", DAMAGES - unnoticed.len());
    assert!(unnoticed.is_empty(), "{unnoticed:#?}");
    assert!(unplaced.is_empty(), "without their block: {unplaced:#?}");
    for _ in 0..HARMLESS {
        let number = dice.below(texts.len());
        let (name, text) = harmless(&texts[number], &mut dice);
        let checked = check(&text).unwrap_or_else(|e| panic!("{name}: {e:?}"));
        assert!(remarks(&checked).is_empty(), "{name}: {:?}", checked.remarks);
    }
}

#[test]
fn damaged_programs_of_generating_grinding_are_noticed() {
    tampered(GRINDING, |job| {
        let loaded = job.of().expect("a grinding job");
        plan_job(loaded, &Silent).expect("a plan").programs.expect("programs")
    });
}

#[test]
fn damaged_programs_of_tangential_dressing_are_noticed() {
    tampered(TANGENTIAL, |job| {
        let loaded = job.of().expect("a job of tangential dressing");
        plan_tangential(loaded, &Silent).expect("a plan").programs.expect("programs")
    });
}

/// Each flank of worm and gear by strokes of its own.
#[test]
fn damaged_programs_of_both_flanks_by_tangential_dressing_are_noticed() {
    let job = TANGENTIAL.replace("flanks = \"right\"", "flanks = \"both\"");
    tampered(&job, |job| {
        let loaded = job.of().expect("a job of tangential dressing");
        let programs = plan_tangential(loaded, &Silent).expect("a plan").programs.expect("programs");
        assert_eq!(programs.built.programs.iter().map(|one| one.layout.passes.len()).sum::<usize>(), 10);
        programs
    });
}
