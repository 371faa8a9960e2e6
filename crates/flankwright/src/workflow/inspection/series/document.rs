//! Brings the parts of a series into groups and order, evaluates each group, names the sheets.

use super::figures::characteristic;
use super::read::ReadPart;
use super::result::{InspectionSeriesResult, SeriesGroupResult, SeriesPartResult};
use super::{InspectionSeries, RefusedFile};
use crate::metrology::inspection::{CharacteristicSeries, SeriesPart, SeriesValue, evaluate_parts, ordered};
use crate::workflow::result::Status;
use std::collections::{BTreeMap, HashSet};
use std::path::Path;

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
    let (mut results, mut evaluated, mut sheets) = (Vec::new(), Vec::new(), Vec::new());
    for (name, parts) in groups {
        let (result, characteristics) = group(name, parts, &mut taken, &mut sheets);
        results.push(result);
        evaluated.push(characteristics);
    }
    let exceeded = results.iter().flat_map(|group| &group.parts).any(|part| !part.exceeded.is_empty());
    InspectionSeries {
        result: InspectionSeriesResult {
            process: "inspection-series",
            version: env!("CARGO_PKG_VERSION"),
            status: if exceeded { Status::Missed } else { Status::Met },
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
) -> (SeriesGroupResult, Vec<CharacteristicSeries>) {
    let (mut parts, mut rest): (Vec<SeriesPart>, Vec<_>) =
        read.into_iter().map(|of| (of.part, Some((of.file, of.class, of.warnings, of.sheet)))).unzip();
    let timed = parts.iter().all(|part| part.time.is_some());
    let order = ordered(&parts);
    let mut rows = Vec::with_capacity(order.len());
    let mut in_order = Vec::with_capacity(order.len());
    for (k, place) in order.into_iter().enumerate() {
        let part = std::mem::take(&mut parts[place]);
        let Some((file, class, warnings, sheet)) = rest[place].take() else { continue };
        let sheet = sheet.map(|text| {
            let path = sheet_path(&file, taken);
            sheets.push((path.clone(), text));
            path
        });
        rows.push(SeriesPartResult {
            number: k + 1,
            part: part.label.clone(),
            file,
            time: part.time.clone(),
            sheet,
            class,
            exceeded: part.values.iter().filter(|v| exceeds(v)).map(|v| v.key.clone()).collect(),
            warnings,
        });
        in_order.push(part);
    }
    let series = evaluate_parts(&in_order);
    let characteristics = series.iter().map(characteristic).collect();
    let ordered_by = if timed { "time" } else { "name" };
    (SeriesGroupResult { series: name, ordered_by, parts: rows, characteristics }, series)
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
