//! Tables of a group: statistics, capability, trends and special causes, parts.

use super::characteristic::{decimals, fixed, limits, mark, name, unit};
use crate::workflow::characteristic_in_words;
use crate::workflow::series::{SeriesCharacteristic, SeriesFigures, SeriesGroupResult, SeriesPartResult};
use report::charts::{format_fixed, format_significant};
use report::{Column, ColumnKind, Table};

/// Digits of slopes.
const DIGITS: usize = 3;

/// Characteristics that have figures.
fn known(group: &SeriesGroupResult) -> impl Iterator<Item = (&SeriesCharacteristic, &SeriesFigures)> {
    group.characteristics.iter().filter_map(|row| Some((row, row.figures.as_ref()?)))
}

/// n, mean, s, least, greatest.
pub(super) fn statistics(group: &SeriesGroupResult) -> Table {
    let number = |title: &str| Column::number(title, "");
    let row = |of: &SeriesCharacteristic| {
        let fixed = |value: f64| fixed(of, value);
        let mut cells = vec![name(of), unit_or_dash(of), of.values.len().to_string()];
        match &of.figures {
            Some(f) => {
                let [low, high] = f.mean_interval_95;
                cells.push(fixed(f.mean));
                cells.push(format!("± {}", fixed(0.5 * (high - low))));
                cells.push(format_fixed(f.s, decimals(of) + 1));
                cells.extend([f.min, f.max, f.max - f.min].map(fixed));
            }
            None => {
                cells.push(of.values.first().map_or_else(String::new, |value| fixed(*value)));
                cells.extend(std::iter::repeat_n("–".into(), 5));
            }
        }
        cells
    };
    Table {
        caption: "Statistics".into(),
        columns: vec![
            Column::name("Characteristic"),
            Column::text("Unit"),
            number("n"),
            number("mean"),
            number("95 %"),
            number("s"),
            number("min"),
            number("max"),
            number("range"),
        ],
        rows: group.characteristics.iter().map(row).collect(),
        note: "mean, max, range: of the teeth of a part; single: as it stands. 95 %: interval of the mean. a, b: profile (α), helix (β). \
               A single part has a value and no statistics."
            .into(),
    }
}

/// Cp, Cpk; none without limits.
pub(super) fn capability(group: &SeriesGroupResult) -> Option<Table> {
    let index = |value: Option<f64>| value.map_or_else(|| "–".into(), |value| format_fixed(value, 2));
    let rows: Vec<Vec<String>> = known(group)
        .filter(|(row, _)| limits(row).iter().any(Option::is_some))
        .map(|(row, figures)| {
            let of = figures.capability.as_ref();
            let interval = of.and_then(|of| of.cpk_interval_95);
            let interval = interval.map_or_else(
                || "–".into(),
                |[low, high]| format!("{} to {}", format_fixed(low, 2), format_fixed(high, 2)),
            );
            let outside = of.and_then(|of| of.outside_ppm);
            vec![
                name(row),
                limits_in_words(row),
                index(of.and_then(|of| of.cp)),
                index(of.map(|of| of.cpk)),
                interval,
                index(of.and_then(|of| of.cp_mr)),
                index(of.and_then(|of| of.cpk_mr)),
                outside.map_or_else(|| "–".into(), share),
            ]
        })
        .collect();
    let number = |title: &str| Column::number(title, "");
    (!rows.is_empty()).then(|| Table {
        caption: "Capability".into(),
        columns: vec![
            Column::name("Characteristic"),
            Column::name("Limits"),
            number("Cp"),
            number("Cpk"),
            Column::name("Cpk, 95 %"),
            number("Cp, MR"),
            number("Cpk, MR"),
            Column::number("outside", "ppm"),
        ],
        rows,
        note: "Cp and Cpk by the standard deviation of all parts (where the process is not in control they are called Pp and Ppk); MR: by the \
               distances of neighbouring parts, without drifts and jumps. One limit gives the index of its side and no Cp. Outside: share \
               beyond the limits if the values follow a normal law; largest values and ranges seldom do."
            .into(),
    })
}

/// Slopes and special causes.
pub(super) fn trends(group: &SeriesGroupResult) -> Table {
    let row = |(row, figures): (&SeriesCharacteristic, &SeriesFigures)| {
        let trend = figures.trend;
        let interval = trend.map(|trend| trend.interval_95.map(|end| format_significant(end, DIGITS)));
        let found: Vec<String> = figures
            .special_causes
            .iter()
            .map(|found| match (found.first, found.last) {
                (first, last) if first == last => format!("{}: part {first}", mark(found)),
                (first, last) => format!("{}: parts {first} to {last}", mark(found)),
            })
            .collect();
        vec![
            name(row),
            trend.map_or_else(|| "–".into(), |trend| format_significant(trend.per_part, DIGITS)),
            interval.map_or_else(|| "–".into(), |[low, high]| format!("{low} to {high}")),
            trend.and_then(|trend| trend.p).map_or_else(
                || "–".into(),
                |p| if p < 1e-4 { "< 0.0001".into() } else { format_fixed(p, 4) },
            ),
            shortened(&found),
        ]
    };
    let mut meanings: Vec<(&str, &str)> = known(group)
        .flat_map(|(_, figures)| &figures.special_causes)
        .map(|found| (mark(found), found.meaning))
        .collect();
    meanings.sort_unstable();
    meanings.dedup();
    let meanings: Vec<String> =
        meanings.into_iter().map(|(mark, meaning)| format!("{}: {meaning}.", capital(mark))).collect();
    Table {
        caption: "Trends and special causes".into(),
        columns: vec![
            Column::name("Characteristic"),
            Column::number("change", "per part"),
            Column::name("95 %"),
            Column::number("p", ""),
            Column::text("Special causes"),
        ],
        rows: known(group).map(row).collect(),
        note: format!(
            "Least squares over the number of the part; p: probability of such a slope by chance, below 0.01 a drift. {}",
            meanings.join(" ")
        ),
    }
}

/// With a capital at its beginning.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
    first + letters.as_str()
}

/// The parts with their sheets.
pub(super) fn parts(group: &SeriesGroupResult) -> Table {
    let row = |part: &SeriesPartResult| {
        let exceeded = part.exceeded.iter().map(|key| characteristic_in_words(key));
        let not_judged = part.not_judged.iter().map(|item| format!("{item}: not judged"));
        let doubts = part.warnings.len();
        vec![
            part.number.to_string(),
            part.part.clone(),
            part.time.as_ref().map_or_else(String::new, |time| time.replace('T', " ")),
            part.class.map_or_else(String::new, |class| class.to_string()),
            exceeded.chain(not_judged).collect::<Vec<_>>().join(", "),
            if doubts == 0 { String::new() } else { doubts.to_string() },
            part.sheet.clone().unwrap_or_default(),
        ]
    };
    Table {
        caption: "Parts".into(),
        columns: vec![
            Column::number("No.", ""),
            Column::text("Part"),
            Column::name("Measured"),
            Column::number("Class", ""),
            Column::text("Beyond the limits"),
            Column::number("Doubts", ""),
            Column { kind: ColumnKind::Link, ..Column::text("Sheet") },
        ],
        rows: group.parts.iter().map(row).collect(),
        note: String::new(),
    }
}

/// The first few of a list and how many there are beyond.
fn shortened(list: &[String]) -> String {
    const MOST: usize = 6;
    match list.len() {
        0 => "none".into(),
        n if n <= MOST => list.join("; "),
        n => format!("{}; and {} more", list[..MOST].join("; "), n - MOST),
    }
}

/// A share in ppm; what no number of parts would show is only said to be small.
fn share(ppm: f64) -> String {
    if ppm < 0.01 { "< 0.01".into() } else { format_significant(ppm, 2) }
}

fn unit_or_dash(of: &SeriesCharacteristic) -> String {
    if unit(of).is_empty() { "–".into() } else { unit(of).into() }
}

fn limits_in_words(of: &SeriesCharacteristic) -> String {
    let fixed = |value: f64| format_significant(value, 5);
    let text = match limits(of) {
        [Some(low), Some(high)] if low == -high => format!("±{}", fixed(high)),
        [Some(low), Some(high)] => format!("{} to {}", fixed(low), fixed(high)),
        [None, Some(high)] => format!("≤ {}", fixed(high)),
        [Some(low), None] => format!("≥ {}", fixed(low)),
        [None, None] => String::new(),
    };
    format!("{text} {}", unit(of)).trim_end().into()
}
