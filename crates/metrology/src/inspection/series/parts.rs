//! Parts with their values as plain data from any source: brought into order, and every characteristic of theirs
//! evaluated.

use super::{SeriesEvaluation, SpecificationLimits, evaluate_numbered};
use crate::inspection::InspectionError;
use std::cmp::Ordering;
use std::collections::HashMap;

/// A part of a series.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SeriesPart {
    /// Its number or name.
    pub label: String,
    /// When it was measured, in a form that sorts as text: `2026-03-14T09:30:00`.
    pub time: Option<String>,
    /// What was found on it, each characteristic once.
    pub values: Vec<SeriesValue>,
}

/// A characteristic of a part.
#[derive(Clone, Debug, PartialEq)]
pub struct SeriesValue {
    /// What it is, the same word on all parts: `fHa.left.mean`.
    pub key: String,
    /// Unit of value and limits.
    pub unit: String,
    /// Value.
    pub value: f64,
    /// Limits for it.
    pub limits: SpecificationLimits,
}

/// A characteristic over all parts that have it.
#[derive(Clone, Debug, PartialEq)]
pub struct CharacteristicSeries {
    /// What it is.
    pub key: String,
    /// Unit of all figures.
    pub unit: String,
    /// Limits; none where the parts do not have the same ones.
    pub limits: SpecificationLimits,
    /// Places of the parts among all, ascending.
    pub parts: Vec<usize>,
    /// Their values.
    pub values: Vec<f64>,
    /// Figures; why there are none.
    pub evaluation: Result<SeriesEvaluation, InspectionError>,
    /// Values that were left out, and limits that differ, in words.
    pub notes: Vec<String>,
}

impl CharacteristicSeries {
    /// Whether any side is limited.
    pub fn has_limits(&self) -> bool {
        self.limits.lower().or(self.limits.upper()).is_some()
    }
}

/// Places of the parts in the order of their making: by time where every part has one, else by label; numbers in labels count as
/// numbers. Parts that are equal in that keep their order.
pub fn ordered(parts: &[SeriesPart]) -> Vec<usize> {
    let timed = parts.iter().all(|part| part.time.is_some());
    let by_label = |a: usize, b: usize| natural(&parts[a].label, &parts[b].label);
    let mut places: Vec<usize> = (0..parts.len()).collect();
    places.sort_by(|&a, &b| match timed {
        true => parts[a].time.cmp(&parts[b].time).then_with(|| by_label(a, b)),
        false => by_label(a, b),
    });
    places
}

/// Evaluates every characteristic of parts that stand in the order of their making. The number of a part, from 1, is what trends run
/// over. Characteristics stand in the order in which they come up.
pub fn evaluate_parts(parts: &[SeriesPart]) -> Vec<CharacteristicSeries> {
    let mut known: HashMap<&str, usize> = HashMap::new();
    let mut gathered: Vec<Gathered> = Vec::new();
    for (place, part) in parts.iter().enumerate() {
        for value in &part.values {
            let at = *known.entry(&value.key).or_insert_with(|| {
                gathered.push(Gathered::begin(value));
                gathered.len() - 1
            });
            gathered[at].add(place, part, value);
        }
    }
    gathered.into_iter().map(Gathered::evaluated).collect()
}

/// A characteristic while its values come together.
struct Gathered<'a> {
    first: &'a SeriesValue,
    same_limits: bool,
    parts: Vec<usize>,
    values: Vec<f64>,
    notes: Vec<String>,
}

impl<'a> Gathered<'a> {
    fn begin(first: &'a SeriesValue) -> Self {
        Self { first, same_limits: true, parts: Vec::new(), values: Vec::new(), notes: Vec::new() }
    }

    fn add(&mut self, place: usize, part: &SeriesPart, value: &SeriesValue) {
        let (label, unit) = (&part.label, &self.first.unit);
        if !value.value.is_finite() {
            self.notes.push(format!("part {label}: left out, its value is no finite number"));
        } else if value.unit != *unit {
            self.notes.push(format!("part {label}: left out, its unit is {}, not {unit}", value.unit));
        } else if self.parts.last() == Some(&place) {
            self.notes.push(format!("part {label}: given more than once, the first value counts"));
        } else {
            if value.limits != self.first.limits {
                self.same_limits = false;
                self.notes.push(format!("part {label}: its limits are not those of the first part"));
            }
            self.parts.push(place);
            self.values.push(value.value);
        }
    }

    fn evaluated(self) -> CharacteristicSeries {
        let limits = if self.same_limits { self.first.limits } else { SpecificationLimits::default() };
        let numbers: Vec<f64> = self.parts.iter().map(|place| (place + 1) as f64).collect();
        CharacteristicSeries {
            key: self.first.key.clone(),
            unit: self.first.unit.clone(),
            limits,
            evaluation: evaluate_numbered(&numbers, &self.values, &limits),
            parts: self.parts,
            values: self.values,
            notes: self.notes,
        }
    }
}

/// Texts in the order in which people put them: digits in them compare as numbers.
fn natural(a: &str, b: &str) -> Ordering {
    let (mut a_rest, mut b_rest) = (a, b);
    loop {
        let (a_piece, a_next, a_digits) = piece(a_rest);
        let (b_piece, b_next, b_digits) = piece(b_rest);
        let order = if a_digits && b_digits {
            let [x, y] = [a_piece, b_piece].map(|digits| digits.trim_start_matches('0'));
            x.len().cmp(&y.len()).then_with(|| x.cmp(y))
        } else {
            a_piece.cmp(b_piece)
        };
        if order != Ordering::Equal {
            return order;
        }
        if a_next.is_empty() || b_next.is_empty() {
            // What differs in leading zeros only still has an order.
            return a_next.len().cmp(&b_next.len()).then_with(|| a.cmp(b));
        }
        (a_rest, b_rest) = (a_next, b_next);
    }
}

/// The digits or the other letters that a text begins with, the rest, and whether they are digits.
fn piece(text: &str) -> (&str, &str, bool) {
    let digits = text.starts_with(|c: char| c.is_ascii_digit());
    let end = text.find(|c: char| c.is_ascii_digit() != digits).unwrap_or(text.len());
    (&text[..end], &text[end..], digits)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(label: &str, time: Option<&str>, values: &[(&str, f64)]) -> SeriesPart {
        let limits = SpecificationLimits::new(None, Some(9.0)).unwrap();
        let value = |(key, value): &(&str, f64)| SeriesValue {
            key: (*key).into(),
            unit: "um".into(),
            value: *value,
            limits,
        };
        SeriesPart {
            label: label.into(),
            time: time.map(str::to_owned),
            values: values.iter().map(value).collect(),
        }
    }

    #[test]
    fn time_goes_before_names_and_numbers_count() {
        let days = ["2026-02-01", "2026-01-31T08:00:00", "2026-01-31"];
        let parts: Vec<SeriesPart> =
            days.iter().zip(["a", "b", "c"]).map(|(day, label)| part(label, Some(day), &[])).collect();
        assert_eq!(ordered(&parts), [2, 1, 0]);
        let names = ["part 10", "part 9", "part 010", "part", "Part 11", "part 9b"];
        let mut parts: Vec<SeriesPart> =
            names.iter().map(|name| part(name, Some("2026-01-01"), &[])).collect();
        parts[0].time = None;
        assert_eq!(ordered(&parts), [4, 3, 1, 5, 2, 0]);
        assert!(ordered(&[]).is_empty());
    }

    #[test]
    fn a_part_without_a_characteristic_keeps_its_number() {
        let parts = [
            part("1", None, &[("Fp", 1.0), ("Fr", 5.0)]),
            part("2", None, &[("Fr", 6.0)]),
            part("3", None, &[("Fp", 3.0)]),
            part("4", None, &[("Fp", 4.0)]),
        ];
        let series = evaluate_parts(&parts);
        assert_eq!(series.iter().map(|s| s.key.as_str()).collect::<Vec<_>>(), ["Fp", "Fr"]);
        assert_eq!(
            (series[0].parts.as_slice(), series[0].values.as_slice()),
            (&[0, 2, 3][..], &[1.0, 3.0, 4.0][..])
        );
        let found = series[0].evaluation.as_ref().unwrap();
        assert!(
            (found.trend.unwrap().slope - 1.0).abs() < 1e-14 && found.trend.unwrap().standard_error < 1e-14
        );
        assert_eq!(series[1].evaluation.as_ref().unwrap().parts, 2);
    }

    #[test]
    fn doubtful_values_are_told() {
        let mut parts = [
            part("1", None, &[("Fp", 1.0), ("Fp", 2.0)]),
            part("2", None, &[("Fp", f64::NAN)]),
            part("3", None, &[("Fp", 2.0)]),
        ];
        let series = evaluate_parts(&parts);
        assert_eq!((series[0].notes.len(), series[0].values.as_slice()), (2, &[1.0, 2.0][..]));
        assert!(series[0].evaluation.as_ref().unwrap().capability.cpk.is_some());
        parts[2].values[0].limits = SpecificationLimits::default();
        parts[1].values[0].unit = "mm".into();
        let series = evaluate_parts(&parts);
        assert_eq!((series[0].notes.len(), series[0].limits), (3, SpecificationLimits::default()));
        assert_eq!(series[0].evaluation.as_ref().unwrap().capability.cpk, None);
        let alone = evaluate_parts(&parts[..1]);
        assert_eq!(alone[0].evaluation.as_ref().unwrap_err().code(), "too-few-parts");
        assert!(evaluate_parts(&[]).is_empty());
    }
}
