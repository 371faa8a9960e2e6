//! The twist that the outer ones of several lines of a tooth flank tell: once by the profiles, once by the helix traces.

use super::evaluate::EvaluatedGear;
use super::readings::readings;
use super::result::TwistResult;
use foundation::geometry::Flank;
use measured_files::inspection::{Inspection, Trace, TraceKind};
use metrology::inspection::{PlacedSlope, TraceEvaluation, twist_by_leads, twist_by_profiles};
use std::collections::BTreeMap;

/// A line and its evaluation.
pub(super) type Line<'a> = (&'a Trace, &'a TraceEvaluation);

/// Twist S by the profiles and by the helix traces of one reading, over a field of the lengths L_a and L_b; in the section and the
/// unit of the slopes. `None` where there are no two lines of a kind.
pub(super) fn twist_of(lines: &[Line<'_>], lengths: [f64; 2]) -> [Option<f64>; 2] {
    [TraceKind::Profile, TraceKind::Helix].map(|kind| {
        let of_kind = || lines.iter().filter(|(trace, _)| trace.kind == kind);
        let nearer = |a: &&Line<'_>, b: &&Line<'_>| a.0.position_mm.total_cmp(&b.0.position_mm);
        let (first, last) = (of_kind().min_by(nearer)?, of_kind().max_by(nearer)?);
        let pair = [first, last]
            .map(|(trace, of)| PlacedSlope { position: trace.position_mm, slope: of.crowning.slope });
        match kind {
            TraceKind::Profile => twist_by_profiles(pair, lengths).ok(),
            TraceKind::Helix => twist_by_leads(pair, lengths).ok(),
        }
    })
}

/// The twist of every tooth flank of which there are lines enough, transverse, um; mean of its readings.
pub(super) fn twists(inspection: &Inspection, gear: &EvaluatedGear) -> Vec<TwistResult> {
    let mut teeth: BTreeMap<(&'static str, u32), Vec<Line<'_>>> = BTreeMap::new();
    for one in &gear.traces {
        let trace = &inspection.traces[one.trace];
        teeth.entry((trace.flank.name(), trace.tooth)).or_default().push((trace, &one.evaluation));
    }
    let length = |kind, flank| inspection.conditions.range(kind, flank).ok().map(|[from, to]| to - from);
    let found = teeth.into_iter().filter_map(|((name, tooth), lines)| {
        let flank: Flank = lines.first()?.0.flank;
        let lengths = [length(TraceKind::Profile, flank)?, length(TraceKind::Helix, flank)?];
        let each: Vec<[Option<f64>; 2]> =
            readings(lines, |(trace, _)| trace).iter().map(|lines| twist_of(lines, lengths)).collect();
        let mean = |which: usize| {
            let values: Vec<f64> = each.iter().filter_map(|of| of[which]).collect();
            (!values.is_empty()).then(|| 1e3 * values.iter().sum::<f64>() / values.len() as f64)
        };
        let (by_profiles_um, by_leads_um) = (mean(0), mean(1));
        by_profiles_um.or(by_leads_um)?;
        let difference_um = by_profiles_um.zip(by_leads_um).map(|(a, b)| a - b);
        Some(TwistResult { flank: name, tooth, by_profiles_um, by_leads_um, difference_um })
    });
    found.collect()
}
