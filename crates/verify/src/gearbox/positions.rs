//! Block `gearbox`: positions of the follower of up to eight leading axes.

use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::{check_each, require_exact};
use super::numbers::Whole;
use super::refusal::Refusal;
use electronic_gearbox::coupling::{Gearbox, GearboxPosition, IncrementalGearbox, LinearTerm, Ratio};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    y0: Whole,
    terms_n_d_x0: Vec<[Whole; 3]>,
    x: Vec<Vec<Whole>>,
}

/// Block `gearbox`.
pub(crate) fn gearbox(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each("gearbox", block, ["tolerance"], ledger, |input: &Input, [tolerance], expected, ledger| {
        let [direct, by_increments] = positions(input)?;
        require_exact(expected.case(), tolerance, ledger);
        let name = expected.case().to_owned();
        for (way, positions) in [("from positions", direct), ("from increments", by_increments)] {
            expected.rename(&format!("{name} {way}"));
            let counts: Vec<i64> = positions.iter().map(|position| position.counts).collect();
            let fractions: Vec<i64> = positions.iter().map(|position| position.fraction.into()).collect();
            expected.wholes("y", &counts, ledger);
            expected.wholes("frac32", &fractions, ledger);
        }
        Ok(())
    });
}

/// Both forms at every place of the case.
type BothForms = [Vec<GearboxPosition>; 2];

fn positions(input: &Input) -> Result<BothForms, Refusal> {
    match input.terms_n_d_x0.len() {
        1 => positions_of::<1>(input),
        2 => positions_of::<2>(input),
        3 => positions_of::<3>(input),
        4 => positions_of::<4>(input),
        5 => positions_of::<5>(input),
        6 => positions_of::<6>(input),
        7 => positions_of::<7>(input),
        8 => positions_of::<8>(input),
        other => Err(Refusal::of_case(format!("{other} terms; allowed: 1 to 8"))),
    }
}

fn positions_of<const K: usize>(input: &Input) -> Result<BothForms, Refusal> {
    let term = |[n, d, x0]: &[Whole; 3]| Ok::<_, Refusal>(LinearTerm::new(Ratio::new(n.0, d.0)?, x0.0));
    let terms = input.terms_n_d_x0.iter().map(term).collect::<Result<Vec<_>, _>>()?;
    let terms: [LinearTerm; K] = exactly(&terms)?;
    let gearbox = Gearbox::new(input.y0.0, terms);
    let zeros = terms.map(|term| term.zero());
    let (mut direct, mut by_increments) = (Vec::new(), Vec::new());
    for x in &input.x {
        let x: [i64; K] = exactly(&x.iter().map(|x| x.0).collect::<Vec<_>>())?;
        direct.push(gearbox.position(&x)?);
        let mut incremental = IncrementalGearbox::new(gearbox, &zeros)?;
        // From x_0 in two steps, a third and the rest. The position above is within range, so is the way.
        let ways: [i64; K] = std::array::from_fn(|axis| x[axis] - zeros[axis]);
        incremental.advance(&ways.map(|way| way / 3))?;
        incremental.advance(&ways.map(|way| way - way / 3))?;
        by_increments.push(incremental.position()?);
    }
    Ok([direct, by_increments])
}

/// One value for each of K axes.
fn exactly<T: Copy, const K: usize>(list: &[T]) -> Result<[T; K], Refusal> {
    list.try_into().map_err(|_| Refusal::of_case(format!("{} values for {K} leading axes", list.len())))
}
