//! Which traces stand at the same place of both fields: one lane per tooth, outwards from the middle in the order of the teeth.

use super::traces_data::{SheetTrace, TraceRow};
use foundation::geometry::{Flank, Sides};
use std::collections::BTreeMap;

/// Lanes of a row of the page; more teeth take further rows.
pub(super) const MOST: usize = 6;

/// A place beside the middle, on both flanks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lane<'a> {
    /// Tooth.
    pub tooth: u32,
    /// Its traces.
    pub traces: Sides<Option<&'a SheetTrace>>,
}

/// All lanes of a row. Traces of a tooth that was measured more than once stand beside each other.
pub(super) fn lanes(row: &TraceRow) -> Vec<Lane<'_>> {
    let mut places: BTreeMap<(u32, usize), Sides<Option<&SheetTrace>>> = BTreeMap::new();
    for flank in Flank::BOTH {
        let mut seen: BTreeMap<u32, usize> = BTreeMap::new();
        for trace in &row.flanks[flank].traces {
            let turn = seen.entry(trace.tooth).or_default();
            places.entry((trace.tooth, *turn)).or_default()[flank] = Some(trace);
            *turn += 1;
        }
    }
    places.into_iter().map(|((tooth, _), traces)| Lane { tooth, traces }).collect()
}
