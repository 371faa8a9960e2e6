//! Block `chain`: the additional rotation behind the interpolator, with the multipliers of the source.

use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::{check_each, require_exact};
use super::fingerprint::Fingerprint;
use super::pulse_trains::events;
use super::refusal::Refusal;
use super::train::{ModeName, TrainInput};
use electronic_gearbox::Sign;
use electronic_gearbox::chain::{AdditionalRotation, RateRule};
use electronic_gearbox::pulse::Direction;
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    lcg_seed: u64,
    #[serde(rename = "P")]
    multiplier: u32,
    mode: ModeName,
    #[serde(rename = "B18")]
    word: u32,
    hand: i8,
}

/// Block `chain`.
pub(crate) fn chain(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each("chain", block, ["tolerance"], ledger, |input: &Input, [tolerance], expected, ledger| {
        let hand = match input.hand {
            1 => Sign::Plus,
            -1 => Sign::Minus,
            other => return Err(Refusal::of_case(format!("hand = {other}; allowed: 1 or -1"))),
        };
        let train = random_train(file.root, input)?;
        let mut rotation = AdditionalRotation::new(input.word, RateRule::Binary, hand, input.multiplier)?;
        let (mut passed, mut least, mut greatest) = (0, 0, 0);
        let mut fingerprint = Fingerprint::EMPTY;
        for timed in events(train.settings()?, &train.train()?)?.pulses {
            if let Some(turned) = rotation.pulse(timed.pulse.direction) {
                passed += 1;
                fingerprint.add(timed.tick, Direction::sign(turned));
                least = rotation.total().min(least);
                greatest = rotation.total().max(greatest);
            }
        }
        require_exact(expected.case(), tolerance, ledger);
        for (key, actual) in [
            ("out_pulses", passed),
            ("W", rotation.total()),
            ("coarse", rotation.position().coarse),
            ("fine", rotation.position().fine.into()),
            ("W_max", greatest),
            ("W_min", least),
        ] {
            expected.whole(key, actual, ledger);
        }
        expected.text("fnv1a64", &fingerprint.text(), ledger);
        Ok(())
    });
}

/// The random train that the file has under `pulse_trains` with this start of the sequence and this P, in the mode of the case.
fn random_train(root: &Value, input: &Input) -> Result<TrainInput, Refusal> {
    let cases = root["pulse_trains"].as_array().map(Vec::as_slice).unwrap_or_default();
    let trains = cases.iter().filter_map(|case| TrainInput::deserialize(&case["input"]).ok());
    let mut fitting = trains.filter(|train| {
        train.multiplier == input.multiplier
            && train.lcg.as_ref().is_some_and(|lcg| lcg.start == input.lcg_seed)
    });
    let named =
        format!("random train of pulse_trains with seed {} and P = {}", input.lcg_seed, input.multiplier);
    let Some(mut first) = fitting.next() else {
        return Err(Refusal::of_case(format!("there is no {named}")));
    };
    if !fitting.all(|other| other.is_same_train(&first)) {
        return Err(Refusal::of_case(format!("there is more than one {named}")));
    }
    first.mode = input.mode;
    Ok(first)
}
