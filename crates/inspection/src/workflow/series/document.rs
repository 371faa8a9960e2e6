//! Brings the parts of a series into groups and order, evaluates each group, names the sheets.

use super::super::characteristic_in_words;
use super::figures::characteristic;
use super::read::ReadPart;
use super::result::{InspectionSeriesResult, SeriesGroupResult, SeriesPartResult};
use super::{InspectionSeries, RefusedFile};
use job::tables::Language;
use metrology::inspection::{CharacteristicSeries, SeriesPart, SeriesValue, evaluate_parts, ordered};
use std::collections::{BTreeMap, HashSet};
use std::path::Path;
use verdict::{Remark, Status, Verdict};

/// The folder of the sheets.
const SHEETS: &str = "sheets";
/// How much a value may exceed its limit and still count as equal to it.
const SAME: f64 = 1e-9;

/// The series of what was read.
pub(super) fn series_of(read: Vec<Result<ReadPart, RefusedFile>>, class: Option<i32>) -> InspectionSeries {
    let mut refused = Vec::new();
    let mut groups: BTreeMap<String, Vec<ReadPart>> = BTreeMap::new();
    for part in read {
        match part {
            Ok(part) => groups.entry(part.group.clone()).or_default().push(part),
            Err(file) => refused.push(file),
        }
    }
    let mut taken = HashSet::new();
    let mut verdict = Verdict::new();
    let (mut results, mut evaluated, mut sheets) = (Vec::new(), Vec::new(), Vec::new());
    for (name, parts) in groups {
        let (result, characteristics) = group(name, parts, &mut taken, &mut sheets, &mut verdict);
        results.push(result);
        evaluated.push(characteristics);
    }
    for file in &refused {
        let text = format!("{} was not evaluated: {}", file.file, file.message);
        verdict.owe(file.file.clone(), Remark::new("file-refused", text, file.way_out.clone()));
    }
    InspectionSeries {
        language: Language::default(),
        result: InspectionSeriesResult {
            process: "inspection-series",
            version: env!("CARGO_PKG_VERSION"),
            verdict,
            tolerance_class: class,
            groups: results,
            refused,
            left_out: Vec::new(),
            stated: Vec::new(),
        },
        groups: evaluated,
        sheets,
    }
}

fn group(
    name: String,
    read: Vec<ReadPart>,
    taken: &mut HashSet<String>,
    sheets: &mut Vec<(String, String)>,
    verdict: &mut Verdict,
) -> (SeriesGroupResult, Vec<CharacteristicSeries>) {
    let (mut parts, mut rest): (Vec<SeriesPart>, Vec<_>) = read
        .into_iter()
        .map(|of| (of.part, Some((of.file, of.class, of.warnings, of.verdict, of.sheet))))
        .unzip();
    let timed = parts.iter().all(|part| part.time.is_some());
    let order = ordered(&parts);
    let mut rows = Vec::with_capacity(order.len());
    let mut in_order = Vec::with_capacity(order.len());
    for (k, place) in order.into_iter().enumerate() {
        let part = std::mem::take(&mut parts[place]);
        let Some((file, class, warnings, own, sheet)) = rest[place].take() else { continue };
        let sheet = sheet.map(|text| {
            let path = sheet_path(&file, taken);
            sheets.push((path.clone(), text));
            path
        });
        let exceeded: Vec<String> =
            part.values.iter().filter(|v| exceeds(v)).map(|v| v.key.clone()).collect();
        judge_part(verdict, &format!("{}, {file}", part.label), &part, &exceeded, &own);
        rows.push(SeriesPartResult {
            number: k + 1,
            part: part.label.clone(),
            file,
            time: part.time.clone(),
            sheet,
            class,
            exceeded,
            not_judged: own.not_judged().iter().filter(|of| of.asked).map(|of| of.item.clone()).collect(),
            warnings,
        });
        in_order.push(part);
    }
    let series = evaluate_parts(&in_order);
    let characteristics = series.iter().map(characteristic).collect();
    let ordered_by = if timed { "time" } else { "name" };
    (SeriesGroupResult { series: name, ordered_by, parts: rows, characteristics }, series)
}

/// Brings a part under the verdict of its series: by its class, else by the limits that its values have.
fn judge_part(verdict: &mut Verdict, item: &str, part: &SeriesPart, exceeded: &[String], own: &Verdict) {
    let named = |reason: &Remark| Remark { text: format!("{item}: {}", reason.text), ..reason.clone() };
    match (own.reason(), own.status()) {
        (Some(reason), Status::Missed) => verdict.missed(item, reason.text.clone(), named(reason)),
        _ if !exceeded.is_empty() => {
            let beyond = format!(
                "beyond their limits: {}",
                exceeded.iter().map(|key| characteristic_in_words(key)).collect::<Vec<_>>().join(", ")
            );
            let way_out = "see the sheet of the part, and the trends of these characteristics";
            verdict.missed(
                item,
                beyond.clone(),
                Remark::new("limits-exceeded", format!("{item}: {beyond}"), way_out),
            );
        }
        (Some(reason), _) => verdict.owe(item, named(reason)),
        (None, Status::Met) => verdict.met(item, "reaches the class"),
        _ if part.values.iter().any(|of| of.limits.upper().or(of.limits.lower()).is_some()) => {
            verdict.met(item, "keeps its limits");
        }
        _ => verdict.leave(item, "no class of ISO 1328-1 was given"),
    }
}

fn exceeds(value: &SeriesValue) -> bool {
    value.limits.upper().is_some_and(|upper| value.value > upper + SAME)
        || value.limits.lower().is_some_and(|lower| value.value < lower - SAME)
}

/// A path of its own for the sheet of a file, also where the file system takes upper and lower case for the same.
fn sheet_path(file: &str, taken: &mut HashSet<String>) -> String {
    let stem = Path::new(file).file_stem().map_or_else(|| file.into(), |stem| stem.to_string_lossy());
    let numbered = |k: usize| if k == 1 { format!("{stem}.html") } else { format!("{stem}-{k}.html") };
    let free = (1..).map(numbered).find(|name| taken.insert(name.to_lowercase()));
    format!("{SHEETS}/{}", free.unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sheets_have_names_of_their_own() {
        let mut taken = HashSet::new();
        let mut of = |file: &str| sheet_path(file, &mut taken);
        assert_eq!(of("a.mka"), "sheets/a.html");
        assert_eq!(of("A.rexs"), "sheets/A-2.html");
        assert_eq!(of("a.b.mka"), "sheets/a.b.html");
        assert_eq!(of("a-2.mka"), "sheets/a-2-2.html");
    }
}
