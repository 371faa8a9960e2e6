//! Block `random`: the sequence of random numbers.

use super::super::expected::Expected;
use super::super::given::{Checked, check_block};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use serde_json::Value;
use skiving::measuring::Noise;

/// Correctly rounded logarithms and sines differ by a unit in the last place at most between libraries.
const LAST_PLACE: f64 = 1e-14;

/// Block `random`.
pub(crate) fn random(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("random", block, ledger, |expected, ledger| {
        let start =
            expected.take("seed").and_then(Value::as_u64).ok_or("seed: a whole number is needed here")?;
        let count = |expected: &Expected<'_>, key: &str| -> Checked<usize> {
            let list = expected.peek(key).and_then(Value::as_array);
            Ok(list.ok_or_else(|| format!("{key}: a list is needed here"))?.len())
        };
        let mut noise = Noise::new(start);
        let bits: Vec<Value> =
            (0..count(expected, "first_u64_hex")?).map(|_| format!("{:016x}", noise.bits()).into()).collect();
        if let Some(value) = expected.take("first_u64_hex") {
            ledger.equal("random", "first_u64_hex", value.clone(), bits.into());
        }
        let mut noise = Noise::new(start);
        let uniform: Vec<f64> = (0..count(expected, "first_uniform")?).map(|_| noise.uniform()).collect();
        expected.list("first_uniform", &uniform, 0.0, ledger);
        let mut noise = Noise::new(start);
        let normal: Vec<f64> = (0..count(expected, "first_normal")?).map(|_| noise.normal()).collect();
        expected.list("first_normal", &normal, LAST_PLACE, ledger);
        Ok(())
    });
}
