//! What a series is evaluated from: every figure of a measured gear under its symbol, with flank, tooth, statistic, unit and limits.

use std::collections::{BTreeMap, HashMap};

use flankwright::geometry::Flank;
use flankwright::workflow::inspection::{GearInspectionResult, TraceInspectionResult};

use super::limits::ClassLimits;
use crate::records::CharacteristicValue;

/// The value as it stands: of one tooth, or of the whole gear.
const SINGLE: &str = "single";
/// Units.
const UM: &str = "um";
const NONE: &str = "1";

/// All characteristics of a result. Single teeth first, then what was made of them, then pitch, run-out, thickness, class.
pub(super) fn characteristics(
    result: &GearInspectionResult,
    limits: &ClassLimits,
) -> Vec<CharacteristicValue> {
    let mut list = List { limits, values: Vec::new(), repeated: HashMap::new() };
    for trace in &result.traces {
        for (figure, value) in figures(trace) {
            list.push(
                &name(trace.kind, figure, &trace.tag),
                flank(trace.flank),
                Some(trace.tooth),
                SINGLE,
                value,
            );
        }
    }
    for row in &result.summary {
        let name = name(row.kind, row.characteristic, &row.tag);
        list.push(&name, flank(row.flank), None, "mean", row.mean_um);
        list.push(&name, flank(row.flank), None, "range", row.range_um);
    }
    for ((kind, side, tag, figure), value) in largest(result) {
        list.push(&name(kind, figure, tag), flank(side), None, "max", value);
    }
    for (side, pitch) in &result.pitch {
        let values = [
            ("fp", pitch.single_um),
            ("fu", pitch.neighbours_um),
            ("Rp", pitch.range_um),
            ("Fp", pitch.total_um),
            ("Fpk", pitch.sector_um),
        ];
        for (symbol, value) in values {
            list.push(symbol, flank(side), None, SINGLE, value);
        }
    }
    let of_gear = [
        ("Rs", result.thickness_variation_um, UM),
        ("Fr", result.run_out_um, UM),
        ("fe", result.eccentricity.map(|[amount, _]| amount), UM),
        ("x-span", result.thickness.x_from_span, NONE),
        ("x-balls", result.thickness.x_from_balls, NONE),
        ("class", result.class.map(f64::from), NONE),
    ];
    for (symbol, value, unit) in of_gear {
        if let Some(value) = value {
            list.push(symbol, None, None, SINGLE, value);
            if let Some(last) = list.values.last_mut() {
                last.unit = unit.to_owned();
            }
        }
    }
    list.values
}

/// Figures of a trace by the words of summaries.
fn figures(trace: &TraceInspectionResult) -> impl Iterator<Item = (&'static str, f64)> {
    let always =
        [("fH", trace.slope_um), ("F", trace.total_um), ("ff", trace.form_um), ("C", trace.crowning_um)];
    always.into_iter().chain(trace.tip_relief_um.map(|value| ("fKo", value)))
}

/// The largest of what the standard judges tooth by tooth: total and form deviation of every line.
fn largest(result: &GearInspectionResult) -> BTreeMap<(&'static str, &'static str, &str, &'static str), f64> {
    let mut found = BTreeMap::new();
    for trace in &result.traces {
        for (figure, value) in [("F", trace.total_um), ("ff", trace.form_um)] {
            let of = found.entry((trace.kind, trace.flank, trace.tag.as_str(), figure)).or_insert(value);
            *of = f64::max(*of, value);
        }
    }
    found
}

/// Whether the standard judges it: slopes by their mean over the teeth, everything else value by value.
fn is_judged(name: &str, statistic: &str) -> bool {
    if name.starts_with("fH") { statistic == "mean" } else { matches!(statistic, SINGLE | "max") }
}

/// `fHa` from profile and fH; of a marked line with the mark, `fHa.o`.
fn name(kind: &str, figure: &str, tag: &str) -> String {
    let index = match (kind, figure) {
        (_, "fKo") => "",
        ("profile", _) => "a",
        _ => "b",
    };
    let mark = if tag.is_empty() { "" } else { "." };
    format!("{figure}{index}{mark}{tag}")
}

fn flank(word: &str) -> Option<Flank> {
    Flank::BOTH.into_iter().find(|flank| flank.name() == word)
}

struct List<'a> {
    limits: &'a ClassLimits,
    values: Vec<CharacteristicValue>,
    /// How often a line of a tooth was measured.
    repeated: HashMap<(String, Option<Flank>, Option<u32>, &'static str), u32>,
}

impl List<'_> {
    fn push(
        &mut self,
        name: &str,
        flank: Option<Flank>,
        tooth: Option<u32>,
        statistic: &'static str,
        value: f64,
    ) {
        let times = self.repeated.entry((name.to_owned(), flank, tooth, statistic)).or_insert(0);
        *times += 1;
        // A line that was measured again is a value of its own.
        let word = if *times > 1 { format!("{statistic}-{times}") } else { statistic.to_owned() };
        let [lower_limit, upper_limit] =
            if is_judged(name, statistic) { self.limits.of(name) } else { [None; 2] };
        let name = name.to_owned();
        let unit = UM.to_owned();
        self.values.push(CharacteristicValue {
            name,
            flank,
            tooth,
            statistic: word,
            value,
            unit,
            lower_limit,
            upper_limit,
        });
    }
}
