//! The numbers of a gear's HAL netlist, read from its lines `setp` and `net` alone. Knows nothing of how the netlist is made.

use std::collections::BTreeMap;

/// What a netlist makes of its leaders.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::nc) struct HalGear {
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
pub(in crate::nc) fn read_hal(text: &str, name: &str, leaders: usize) -> Option<HalGear> {
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
