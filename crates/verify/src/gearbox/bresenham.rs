//! Block `bresenham`: a ratio over many random steps, by division and pulse by pulse.

use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::{check_each, require_exact};
use super::random::Draw;
use super::refusal::Refusal;
use electronic_gearbox::coupling::{Bresenham, Gearbox, IncrementalGearbox, LinearTerm, Ratio};
use electronic_gearbox::pulse::Direction;
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    n: i64,
    d: i64,
    lcg_seed: u64,
    steps: u32,
    dx: String,
}

/// More pulses are more than a check should take.
const MOST_PULSES: u64 = 1_000_000_000;

/// Block `bresenham`.
pub(crate) fn bresenham(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each("bresenham", block, ["tolerance"], ledger, |input: &Input, [tolerance], expected, ledger| {
        let end = run(input)?;
        require_exact(expected.case(), tolerance, ledger);
        expected.whole("x", end.leading, ledger);
        expected.whole("remainder", end.remainder, ledger);
        let name = expected.case().to_owned();
        for (way, y) in [("by division", end.by_division), ("pulse by pulse", end.by_pulses)] {
            expected.rename(&format!("{name} {way}"));
            expected.whole("y", y, ledger);
        }
        Ok(())
    });
}

/// Where the axes are after the last step.
struct End {
    leading: i64,
    by_division: i64,
    by_pulses: i64,
    remainder: i64,
}

fn run(input: &Input) -> Result<End, Refusal> {
    let (bound, back) = step_rule(&input.dx).ok_or_else(|| {
        Refusal::of_case(format!("dx = `{}` is not known; known is `((s>>33) mod 131) - 50`", input.dx))
    })?;
    if u64::from(input.steps).saturating_mul(u64::from(bound.max(back))) > MOST_PULSES {
        return Err(Refusal::of_case(format!("{} steps of `{}` are too many", input.steps, input.dx)));
    }
    let ratio = Ratio::new(input.n, input.d)?;
    let mut line = Bresenham::new(ratio)?;
    let mut divided = IncrementalGearbox::new(Gearbox::new(0, [LinearTerm::new(ratio, 0)]), &[0])?;
    let mut draw = Draw::new(input.lcg_seed);
    let (mut leading, mut by_pulses) = (0, 0);
    for _ in 0..input.steps {
        // Below 2^31.
        let step = draw.below(bound.into()) as i64 - i64::from(back);
        leading += step;
        divided.advance(&[step])?;
        let direction = if step < 0 { Direction::Backward } else { Direction::Forward };
        for _ in 0..step.abs() {
            by_pulses += line.pulse(direction).map_or(0, Direction::sign);
        }
    }
    Ok(End { leading, by_division: divided.position()?.counts, by_pulses, remainder: line.remainder() })
}

/// The two numbers of a text like `((s>>33) mod 131) - 50`: steps are drawn below the first, less the second.
fn step_rule(text: &str) -> Option<(u32, u32)> {
    let (bound, back) = text.strip_prefix("((s>>33) mod ")?.split_once(") - ")?;
    Some((bound.parse().ok().filter(|bound| *bound > 0)?, back.parse().ok()?))
}
