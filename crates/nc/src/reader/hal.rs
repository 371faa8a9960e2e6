//! The numbers of a gear's HAL netlist, read from its lines `setp` and `net` alone. Knows nothing of how the netlist is made.

use super::{ReadError, ReadProblem, ReadProgram};
use crate::{AxisMotion, AxisWord, Block, Coupling, Gear, GearLeader, GearSynchronisation, Word};
use std::collections::{BTreeMap, BTreeSet};

/// What a netlist makes of its leaders.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct HalGear {
    /// Units of the follower per unit of each leader's signal, in the order of the signals.
    pub gains: Vec<f64>,
    /// Follower with all leaders at 0.
    pub offset: f64,
    /// Whether every leader reaches the wanted place through the pins, and the guard takes a distance of both signs.
    pub connected: bool,
    /// Half width of the guard.
    pub guard: f64,
}

/// The gear of `name`, e.g. `gear-c`; none if a number is absent or not readable.
pub(crate) fn read_hal(text: &str, name: &str, leaders: usize) -> Option<HalGear> {
    let mut values = BTreeMap::new();
    // From every pin to the signal that it is on.
    let mut signals = BTreeMap::new();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let mut words = line.split_ascii_whitespace();
        match words.next() {
            Some("setp") => {
                let (pin, value) = (words.next()?, words.next()?.parse::<f64>().ok()?);
                values.insert(pin, value);
            }
            Some("net") => {
                let signal = words.next()?;
                for pin in words.filter(|word| *word != "=>") {
                    signals.insert(pin, signal);
                }
            }
            _ => {}
        }
    }
    let joined = |from: String, to: String| {
        let signal = signals.get(from.as_str());
        signal.is_some() && signal == signals.get(to.as_str())
    };
    let last = leaders.max(2) - 2;
    let gains = (0..leaders).map(|k| values.get(format!("{name}-scale-{k}.gain").as_str()).copied());
    let guard = values.get(format!("{name}-guard.max").as_str()).copied()?;
    let mut connected = values.get(format!("{name}-guard.min").as_str()) == Some(&-guard)
        && values.get(format!("{name}-error.gain1").as_str()) == Some(&-1.0)
        && joined(format!("{name}-sum-{last}.out"), format!("{name}-switch.in1"))
        && joined(format!("{name}-error.out"), format!("{name}-guard.in"));
    for k in 0..leaders {
        let (sum, input) = if k == 0 { (0, 0) } else { (k - 1, 1) };
        connected &= joined(format!("{name}-scale-{k}.out"), format!("{name}-sum-{sum}.in{input}"))
            && signals.contains_key(format!("{name}-scale-{k}.in").as_str())
            && (k < 2 || joined(format!("{name}-sum-{}.out", k - 2), format!("{name}-sum-{}.in0", k - 1)));
    }
    let offset = values.get(format!("{name}-sum-{last}.offset").as_str()).copied()?;
    Some(HalGear { gains: gains.collect::<Option<_>>()?, offset, connected, guard })
}

impl ReadProgram {
    /// Puts the gears that a netlist defines before the blocks that switch them on, and their positions into these.
    ///
    /// # Errors
    /// `Missing` for a gear that the netlist does not hold, or that a spindle leads whose number it does not tell.
    pub fn with_netlist(self, netlist: &str, axes: &[AxisWord]) -> Result<Self, ReadError> {
        let mut blocks = Vec::with_capacity(self.blocks.len() + 1);
        let mut defined = BTreeSet::new();
        for block in self.blocks {
            match block {
                Block::GearOn { follower, synchronisation: None } if !defined.contains(&follower) => {
                    let (gear, at) = gear_of(netlist, follower, axes).ok_or_else(|| ReadError {
                        line: 1,
                        column: 1,
                        problem: ReadProblem::Missing,
                        word: axes.get(follower).map_or("", |axis| axis.name.as_str()).into(),
                        allowed: "a netlist with the gear of this axis, led by axes with letters",
                    })?;
                    blocks.push(Block::GearDefine(Box::new(gear)));
                    blocks.push(Block::GearOn { follower, synchronisation: Some(Box::new(at)) });
                }
                Block::GearDefine(gear) => {
                    defined.insert(gear.follower);
                    blocks.push(Block::GearDefine(gear));
                }
                other => blocks.push(other),
            }
        }
        Ok(Self { blocks, ..self })
    }
}

/// The gear of an axis with the follower's place where all leaders are at 0.
fn gear_of(netlist: &str, follower: usize, axes: &[AxisWord]) -> Option<(Gear, GearSynchronisation)> {
    let letter = |word: &Word| match word {
        Word::Letter(letter) => Some(letter.to_ascii_lowercase()),
        _ => None,
    };
    // Units of the text per unit of the program.
    let scale = |axis: &AxisWord| match axis.motion {
        AxisMotion::Linear => 1.0,
        AxisMotion::Rotary => 180.0 / std::f64::consts::PI,
    };
    let own = axes.get(follower)?;
    let name = format!("gear-{}", letter(&own.word)?);
    let mut leaders = Vec::new();
    for k in 0.. {
        let head = format!("net {name}-leader-{k} ");
        let Some(line) = netlist.lines().find(|line| line.starts_with(&head)) else { break };
        let signal = line[head.len()..].split_ascii_whitespace().next()?;
        let of = signal.strip_prefix("axis.")?.strip_suffix(".pos-cmd")?;
        leaders.push(axes.iter().position(|axis| letter(&axis.word).is_some_and(|l| of == l.to_string()))?);
    }
    let found =
        read_hal(netlist, &name, leaders.len()).filter(|found| found.connected && !leaders.is_empty())?;
    let ratio = |(&axis, gain): (&usize, f64)| GearLeader {
        axis,
        coupling: Coupling::Ratio { num: gain * scale(&axes[axis]) / scale(own), den: 1.0 },
    };
    let at = GearSynchronisation { follower: found.offset / scale(own), leaders: vec![0.0; leaders.len()] };
    let leaders = leaders.iter().zip(found.gains).map(ratio).collect();
    Some((Gear { follower, leaders, teeth: None }, at))
}
