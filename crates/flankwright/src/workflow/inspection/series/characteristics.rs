//! What a part gives to statistics: each characteristic of its flanks and of the gear once, under a word that is the same on all parts.
//! `fHa.left.mean`: symbol, flank, what was made of the teeth.

use super::super::result::GearInspectionResult;
use super::super::run::GearInspection;
use crate::metrology::inspection::{SeriesValue, SpecificationLimits, ToleranceQuantity};
use std::collections::BTreeMap;

const UM: &str = "um";
const NONE: &str = "1";

/// Characteristics with the limits of a class of ISO 1328-1: slopes by their mean over the teeth, total and form deviations by the
/// largest of them. Limits are missing where the standard has none for the gear.
pub fn series_values(found: &GearInspection, class: Option<i32>) -> Vec<SeriesValue> {
    let mut list = List { limits: limits(found, class), values: Vec::new() };
    let result = &found.result;
    lines(&mut list, result);
    for (flank, pitch) in &result.pitch {
        let values = [
            ("fp", pitch.single_um),
            ("fu", pitch.neighbours_um),
            ("Rp", pitch.range_um),
            ("Fp", pitch.total_um),
            ("Fpk", pitch.sector_um),
        ];
        for (symbol, value) in values {
            list.push(symbol, Some(flank), "single", UM, value);
        }
    }
    let of_gear = [
        ("Rs", result.thickness_variation_um, UM),
        ("Fr", result.run_out_um, UM),
        ("fe", result.eccentricity.map(|[amount, _]| amount), UM),
        ("x-span", result.thickness.x_from_span, NONE),
        ("x-balls", result.thickness.x_from_balls, NONE),
    ];
    for (symbol, value, unit) in of_gear {
        if let Some(value) = value {
            list.push(symbol, None, "single", unit, value);
        }
    }
    list.values
}

/// Means and ranges of the lines, profiles first, and the largest of what is judged tooth by tooth.
fn lines(list: &mut List, result: &GearInspectionResult) {
    let mut largest: BTreeMap<(&str, &str, &str, &str), f64> = BTreeMap::new();
    for trace in &result.traces {
        for (figure, value) in [("F", trace.total_um), ("ff", trace.form_um)] {
            let place = (trace.kind, trace.flank, trace.tag.as_str(), figure);
            let most = largest.entry(place).or_insert(value);
            *most = most.max(value);
        }
    }
    for kind in ["profile", "helix"] {
        for row in result.summary.iter().filter(|row| row.kind == kind) {
            let symbol = symbol(kind, row.characteristic, &row.tag);
            let most = largest.get(&(kind, row.flank, row.tag.as_str(), row.characteristic));
            match most {
                Some(most) => list.push(&symbol, Some(row.flank), "max", UM, *most),
                None => list.push(&symbol, Some(row.flank), "mean", UM, row.mean_um),
            }
            if row.characteristic == "fH" {
                list.push(&symbol, Some(row.flank), "range", UM, row.range_um);
            }
        }
    }
}

/// `fHa` from profile and fH; of a marked line with its mark, `fHa.o`.
fn symbol(kind: &str, figure: &str, tag: &str) -> String {
    let index = match (kind, figure) {
        (_, "fKo") => "",
        ("profile", _) => "a",
        _ => "b",
    };
    let mark = if tag.is_empty() { "" } else { "." };
    format!("{figure}{index}{mark}{tag}")
}

/// Limits of the symbols of the standard, um.
fn limits(found: &GearInspection, class: Option<i32>) -> Vec<(&'static str, SpecificationLimits)> {
    let Some((tolerances, class)) = found.gear.tolerances.as_ref().zip(class) else { return Vec::new() };
    let of = |quantity: ToleranceQuantity| {
        // Whole nm, so that the limit in um is the number of the tables.
        let upper = (1e6 * tolerances.rounded(quantity, class).ok()?).round() / 1e3;
        // Slopes have a sign; everything else is a range or a largest amount.
        let slope = matches!(quantity, ToleranceQuantity::ProfileSlope | ToleranceQuantity::HelixSlope);
        let limits = SpecificationLimits::new(slope.then_some(-upper), Some(upper)).ok()?;
        Some((quantity.symbol(), limits))
    };
    let verified = ToleranceQuantity::ALL.into_iter().filter(|quantity| !quantity.is_informative());
    verified.filter_map(of).collect()
}

struct List {
    limits: Vec<(&'static str, SpecificationLimits)>,
    values: Vec<SeriesValue>,
}

impl List {
    fn push(&mut self, symbol: &str, flank: Option<&str>, statistic: &str, unit: &str, value: f64) {
        let words = [Some(symbol), flank, Some(statistic)];
        let known = self.limits.iter().find(|(of, _)| *of == symbol && statistic != "range");
        self.values.push(SeriesValue {
            key: words.into_iter().flatten().collect::<Vec<_>>().join("."),
            unit: unit.into(),
            value,
            limits: known.map_or_else(SpecificationLimits::default, |(_, limits)| *limits),
        });
    }
}
