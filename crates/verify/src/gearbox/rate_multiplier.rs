//! Block `rate_multiplier`: how many pulses the multiplier of the source passes, which, and how uneven it is.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::require_exact;
use super::refusal::Refusal;
use super::unevenness::extremes;
use electronic_gearbox::Error;
use electronic_gearbox::chain::{Multiplier, RateRule, passed_pulses};
use serde::Deserialize;
use serde_json::Value;

/// More pulses are more than a check should take.
const MOST_PULSES: u64 = 10_000_000;

/// Block `rate_multiplier`.
pub(crate) fn rate_multiplier(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let name = "rate_multiplier";
    let mut outer = Expected::new(name, "", block, ledger);
    outer.informative(&["note"]);
    let tolerance = outer.given("tolerance", ledger).unwrap_or(f64::NAN);
    require_exact(name, tolerance, ledger);
    // The word of the multiplier has as many bits as the first power of two that it refuses.
    let bits = (0..32).find(|bits| Multiplier::new(1 << bits, RateRule::Binary).is_err()).unwrap_or(32);
    outer.whole("bits", bits, ledger);
    for case in outer.objects("cases", ledger) {
        counts(case, ledger);
    }
    for key in block.as_object().into_iter().flatten().map(|(key, _)| key) {
        if let Some((pulses, word)) = first_pulses(key) {
            match passing(word, pulses) {
                Ok(text) => outer.text(key, &text, ledger),
                Err(refusal) => refusal.compare(&mut outer, ledger),
            }
        }
    }
    if outer.peek("deviation_min").is_some() || outer.peek("deviation_max").is_some() {
        match extremes() {
            Ok([least, greatest]) => {
                // The library's numbers are exact; one read from a file may be off by its last digit.
                let read = |x: f64| x.abs() * f64::EPSILON;
                outer.number("deviation_min", least, read(least), ledger);
                outer.number("deviation_max", greatest, read(greatest), ledger);
            }
            Err(error) => Refusal::from(error).compare(&mut outer, ledger),
        }
    }
    outer.finish(ledger);
}

/// Pulses that pass, by formula and by running the multiplier.
fn counts(mut case: Expected<'_>, ledger: &mut Ledger) {
    let word = case.take("B18").and_then(|word| u32::deserialize(word).ok());
    let pulses = case.take("n").and_then(|list| Vec::<u64>::deserialize(list).ok());
    let usable = |pulses: &Vec<u64>| pulses.iter().all(|n| *n <= MOST_PULSES);
    match (word, pulses.filter(usable)) {
        (Some(word), Some(pulses)) => {
            match by_formula(word, &pulses).and_then(|a| Ok((a, by_run(word, &pulses)?))) {
                Ok((formula, run)) => {
                    for (way, counts) in [("by formula", formula), ("run", run)] {
                        case.rename(&format!("rate_multiplier B = {word}, {way}"));
                        case.wholes("count", &counts, ledger);
                    }
                }
                Err(error) => Refusal::from(error).compare(&mut case, ledger),
            }
        }
        _ => {
            let told = format!("B18 and a list n of whole numbers up to {MOST_PULSES} are needed");
            Refusal::of_case(told).compare(&mut case, ledger);
        }
    }
    case.finish(ledger);
}

fn by_formula(word: u32, pulses: &[u64]) -> Result<Vec<i64>, Error> {
    // No more pass than arrive.
    pulses.iter().map(|&n| Ok(passed_pulses(word, RateRule::Binary, n)? as i64)).collect()
}

fn by_run(word: u32, pulses: &[u64]) -> Result<Vec<i64>, Error> {
    let mut multiplier = Multiplier::new(word, RateRule::Binary)?;
    let last = pulses.iter().copied().max().unwrap_or(0);
    let mut passed = vec![0];
    let mut sum = 0;
    for _ in 0..last {
        sum += i64::from(multiplier.pulse());
        passed.push(sum);
    }
    Ok(pulses.iter().map(|&n| passed[n as usize]).collect())
}

/// Number of pulses and word of a key like `first_64_of_B_123456`.
fn first_pulses(key: &str) -> Option<(u64, u32)> {
    let (pulses, word) = key.strip_prefix("first_")?.split_once("_of_B_")?;
    Some((pulses.parse().ok()?, word.parse().ok()?))
}

/// The first pulses as text: 1 for one that passes, 0 for one that does not.
fn passing(word: u32, pulses: u64) -> Result<String, Refusal> {
    if pulses > MOST_PULSES {
        return Err(Refusal::of_case(format!("{pulses} pulses; allowed: up to {MOST_PULSES}")));
    }
    let mut multiplier = Multiplier::new(word, RateRule::Binary)?;
    Ok((0..pulses).map(|_| if multiplier.pulse() { '1' } else { '0' }).collect())
}
