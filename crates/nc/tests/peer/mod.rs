//! LinuxCNC as peer: what its interpreter `rs274` and its Python module `gcode` make of a program, compared with what the program means.

pub mod client;

use client::{ABSENT, Client};
use nc::{AxisMotion, AxisWord, Block, Program};
use std::io::Write as _;
use std::path::PathBuf;

/// Half of the fourth decimal that `rs274` prints.
pub const PRINTED: f64 = 5.001e-5;

/// Not by `println!`, which is only shown when a test fails: what was not tested has to be seen.
pub fn say_absent(what: &str) {
    drop(writeln!(std::io::stderr(), "{ABSENT}: {what}"));
}

pub fn client(test: &str) -> Option<(Client, tempfile::TempDir)> {
    let client = Client::find();
    if client.is_none() {
        say_absent(&format!("{test} skipped; scripts/linuxcnc-client gets it"));
    }
    Some((client?, tempfile::tempdir().expect("a directory")))
}

/// A motion in mm and degrees: the nine places, and the feed of the control or none for a rapid.
#[derive(Clone, Debug)]
pub struct Motion {
    pub place: [f64; 9],
    pub feed: Option<f64>,
}

/// What a control is to make of a program: every motion with the feed that G93 means.
pub fn wanted(axes: &[AxisWord], blocks: &[Block]) -> Vec<Motion> {
    let order = |axis: usize| match axes[axis].word {
        nc::Word::Letter(letter) => "XYZABCUVW".find(letter).expect("a letter of an axis"),
        _ => panic!("an axis without letter moves"),
    };
    let mut place = [0.0; 9];
    let mut motions = Vec::new();
    for block in blocks {
        let (target, duration) = match block {
            Block::Rapid(target) => (target, None),
            Block::Linear { target, duration } => (target, Some(*duration)),
            _ => continue,
        };
        let from = place;
        for (axis, value) in target.iter() {
            let rotary = axes[axis].motion == AxisMotion::Rotary;
            place[order(axis)] = if rotary { value.to_degrees() } else { value };
        }
        let way =
            |axes: [usize; 3]| axes.map(|axis| (place[axis] - from[axis]).powi(2)).iter().sum::<f64>().sqrt();
        let groups = [way([0, 1, 2]), way([6, 7, 8]), way([3, 4, 5])];
        let way = groups.into_iter().find(|way| *way > 1e-6).unwrap_or(0.0);
        motions.push(Motion { place, feed: duration.map(|duration| 60.0 / duration * way) });
    }
    motions
}

/// Compares; `linear` and `rotary` are the tolerances of places, `printed` that of feeds.
pub fn compare(wanted: &[Motion], found: &[Motion], linear: f64, rotary: f64, printed: f64) -> f64 {
    assert_eq!(wanted.len(), found.len());
    let mut worst = 0.0f64;
    for (k, (a, b)) in wanted.iter().zip(found).enumerate() {
        for axis in 0..9 {
            let tolerance = if (3..6).contains(&axis) { rotary } else { linear };
            let delta = (a.place[axis] - b.place[axis]).abs();
            assert!(delta <= tolerance + 4e-16 * a.place[axis].abs(), "motion {k} axis {axis}: {a:?} {b:?}");
            worst = worst.max(delta / tolerance);
        }
        assert_eq!(a.feed.is_some(), b.feed.is_some(), "motion {k}");
        let (Some(p), Some(q)) = (a.feed, b.feed) else { continue };
        // The way is that of rounded places; below 0.1 the interpreter takes 0.1.
        let way = p.max(0.1);
        let rounding = 1e-6 * way + if p > 0.0 { way * 4e-6 / way_of(wanted, k) } else { f64::INFINITY };
        assert!((q - way).abs() <= printed + rounding, "motion {k}: feed {q}, wanted {p}");
    }
    worst
}

/// Length of a motion that its feed counts for.
fn way_of(motions: &[Motion], k: usize) -> f64 {
    let from = if k == 0 { [0.0; 9] } else { motions[k - 1].place };
    let ways: Vec<f64> = motions[k].place.iter().zip(from).map(|(a, b)| (a - b).abs()).collect();
    let group = |axes: std::ops::Range<usize>| ways[axes].iter().fold(0.0f64, |a, b| a.max(*b));
    [group(0..3), group(6..9), group(3..6)].into_iter().find(|way| *way > 1e-6).unwrap_or(1.0)
}

/// The motions in the canonical text of `rs274`.
pub fn canonical(text: &str) -> Vec<Motion> {
    let (mut motions, mut rate) = (Vec::new(), 0.0);
    for line in text.lines() {
        let Some((head, arguments)) = line.trim_end().trim_end_matches(')').split_once('(') else { continue };
        let numbers = || arguments.split(',').map(|number| number.trim().parse().expect("a number"));
        let place = || {
            let mut place = [0.0; 9];
            for (axis, value) in numbers().enumerate() {
                place[axis] = value;
            }
            place
        };
        match head.split_whitespace().last() {
            Some("SET_FEED_RATE") => rate = numbers().next().expect("a rate"),
            Some("STRAIGHT_FEED") => motions.push(Motion { place: place(), feed: Some(rate) }),
            Some("STRAIGHT_TRAVERSE") => motions.push(Motion { place: place(), feed: None }),
            _ => {}
        }
    }
    motions
}

/// The motions and the other events of the module `gcode`.
pub fn events(text: &str) -> (Vec<Motion>, Vec<String>) {
    let (mut motions, mut others, mut rate) = (Vec::new(), Vec::new(), 0.0);
    for line in text.lines() {
        let (name, rest) = line.split_once(' ').unwrap_or((line, ""));
        let numbers = || rest.split(' ').map(|number| number.parse::<f64>().expect("a number"));
        let place = || {
            let values: Vec<f64> = numbers().collect();
            std::array::from_fn(|axis| values[axis])
        };
        match name {
            "rate" => rate = numbers().next().expect("a rate"),
            "feed" => motions.push(Motion { place: place(), feed: Some(rate) }),
            "rapid" => motions.push(Motion { place: place(), feed: None }),
            _ => others.push(line.to_owned()),
        }
    }
    (motions, others)
}

pub fn file(directory: &tempfile::TempDir, text: &str) -> PathBuf {
    let path = directory.path().join("program.ngc");
    std::fs::write(&path, text).expect("a file");
    path
}

/// What the client made of programs.
#[derive(Default)]
pub struct Found {
    pub motions: usize,
    worst: [f64; 2],
}

impl Found {
    /// Has the client interpret a text and compares with the program that it is of.
    pub fn add(&mut self, client: &Client, directory: &tempfile::TempDir, program: &Program, text: &str) {
        let path = file(directory, text);
        let wanted = wanted(program.axes(), program.blocks());
        self.motions += wanted.len();

        let output = client.interpret(&path, directory.path());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let found = canonical(&String::from_utf8_lossy(&output.stdout));
        let half = PRINTED + 5e-7;
        self.worst[0] = self.worst[0].max(half * compare(&wanted, &found, half, half, 1e-4));

        let Some(parsed) = client.parse(&path, directory.path()) else {
            return say_absent("its module gcode finds no Python of its version; that part skipped");
        };
        let (found, others) = events(&parsed.expect("the module takes the program"));
        self.worst[1] = self.worst[1].max(compare(&wanted, &found, 5.1e-7, 5.1e-8, 1e-6));
        let expected: Vec<f64> = program
            .blocks()
            .iter()
            .filter_map(|block| if let Block::Dwell(seconds) = block { Some(*seconds) } else { None })
            .collect();
        let dwells: Vec<f64> =
            others.iter().filter_map(|line| line.strip_prefix("dwell ")?.parse().ok()).collect();
        assert_eq!(dwells.len(), expected.len());
        assert!(dwells.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 5.1e-7));
        let comments = others.iter().filter(|line| line.starts_with("comment")).count();
        let written = program.blocks().iter().filter(|block| matches!(block, Block::Comment(_))).count();
        assert_eq!(comments, written + 1, "the name is a comment as well");
    }

    pub fn tell(&self) {
        println!(
            "{} motions: rs274 within {:.3e}, gcode within {:.4} of half a digit",
            self.motions, self.worst[0], self.worst[1]
        );
    }
}
