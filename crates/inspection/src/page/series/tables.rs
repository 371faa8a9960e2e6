//! Tables of a group: statistics, capability, trends and special causes, parts.

use super::data::{CharacteristicFigures, CharacteristicRow, SeriesGroup};
use report::charts::{format_fixed, format_significant};
use report::data::{Column, ColumnKind, Table};

/// Digits of slopes.
const DIGITS: usize = 3;

impl SeriesGroup {
    fn known(&self) -> impl Iterator<Item = (&CharacteristicRow, &CharacteristicFigures)> {
        self.characteristics.iter().filter_map(|row| Some((row, row.figures.as_ref()?)))
    }

    /// n, mean, s, least, greatest.
    pub(super) fn statistics(&self) -> Table {
        let number = |title: &str| Column::number(title, "");
        let row = |of: &CharacteristicRow| {
            let fixed = |value: f64| format_fixed(value, of.decimals);
            let mut cells = vec![of.key.clone(), unit(of), of.values.len().to_string()];
            match &of.figures {
                Some(f) => {
                    cells.push(fixed(f.mean[0]));
                    cells.push(format!("± {}", fixed(0.5 * (f.mean[2] - f.mean[1]))));
                    cells.push(format_fixed(f.deviation, of.decimals + 1));
                    cells.extend([f.extremes[0], f.extremes[1], f.extremes[1] - f.extremes[0]].map(fixed));
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
            rows: self.characteristics.iter().map(row).collect(),
            note: "mean, max, range: of the teeth of a part; single: as it stands. 95 %: interval of the mean. a, b: profile (α), helix (β). \
                   A single part has a value and no statistics."
                .into(),
        }
    }

    /// Cp, Cpk; none without limits.
    pub(super) fn capability(&self) -> Option<Table> {
        let index = |value: Option<f64>| value.map_or_else(|| "–".into(), |value| format_fixed(value, 2));
        let rows: Vec<Vec<String>> = self
            .known()
            .filter(|(row, _)| row.limits.iter().any(Option::is_some))
            .map(|(row, figures)| {
                let of = figures.capability;
                let interval = of.and_then(|of| of.cpk_interval);
                let interval = interval.map_or_else(
                    || "–".into(),
                    |[low, high]| format!("{} to {}", format_fixed(low, 2), format_fixed(high, 2)),
                );
                let outside = of.and_then(|of| of.outside_ppm);
                vec![
                    row.key.clone(),
                    limits(row),
                    index(of.and_then(|of| of.cp)),
                    index(of.map(|of| of.cpk)),
                    interval,
                    index(of.and_then(|of| of.short_term[0])),
                    index(of.and_then(|of| of.short_term[1])),
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
                   distances of neighbouring parts, without drifts and jumps. One limit gives the index of its side and no Cp. outside: share \
                   beyond the limits if the values follow a normal law; largest values and ranges seldom do."
                .into(),
        })
    }

    /// Slopes and special causes.
    pub(super) fn trends(&self) -> Table {
        let row = |(row, figures): (&CharacteristicRow, &CharacteristicFigures)| {
            let trend = figures.trend;
            let interval = trend.map(|trend| trend.interval.map(|end| format_significant(end, DIGITS)));
            let found: Vec<String> = figures
                .marked
                .iter()
                .map(|found| match found.parts {
                    [first, last] if first == last => format!("{}: part {first}", found.mark),
                    [first, last] => format!("{}: parts {first} to {last}", found.mark),
                })
                .collect();
            vec![
                row.key.clone(),
                trend.map_or_else(|| "–".into(), |trend| format_significant(trend.slope, DIGITS)),
                interval.map_or_else(|| "–".into(), |[low, high]| format!("{low} to {high}")),
                trend.and_then(|trend| trend.probability).map_or_else(
                    || "–".into(),
                    |p| if p < 1e-4 { "< 0.0001".into() } else { format_fixed(p, 4) },
                ),
                shortened(&found),
            ]
        };
        let mut meanings: Vec<(&str, &str)> = self
            .known()
            .flat_map(|(_, figures)| &figures.marked)
            .map(|found| (found.mark, found.meaning))
            .collect();
        meanings.sort_unstable();
        meanings.dedup();
        let meanings: Vec<String> =
            meanings.into_iter().map(|(mark, meaning)| format!("{mark}: {meaning}.")).collect();
        Table {
            caption: "Trends and special causes".into(),
            columns: vec![
                Column::name("Characteristic"),
                Column::number("change", "per part"),
                Column::name("95 %"),
                Column::number("p", ""),
                Column::text("Special causes"),
            ],
            rows: self.known().map(row).collect(),
            note: format!(
                "Least squares over the number of the part; p: probability of such a slope by chance, below 0.01 a drift. {}",
                meanings.join(" ")
            ),
        }
    }

    /// The parts with their sheets.
    pub(super) fn part_table(&self) -> Table {
        let row = |part: &super::data::PartRow| {
            vec![
                part.number.to_string(),
                part.part.clone(),
                part.time.replace('T', " "),
                part.class.clone(),
                part.exceeded.clone(),
                if part.warnings == 0 { String::new() } else { part.warnings.to_string() },
                part.sheet.clone(),
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
            rows: self.parts.iter().map(row).collect(),
            note: String::new(),
        }
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

fn unit(row: &CharacteristicRow) -> String {
    if row.unit.is_empty() { "–".into() } else { row.unit.clone() }
}

fn limits(row: &CharacteristicRow) -> String {
    let fixed = |value: f64| format_significant(value, 5);
    let text = match row.limits {
        [Some(low), Some(high)] if low == -high => format!("±{}", fixed(high)),
        [Some(low), Some(high)] => format!("{} to {}", fixed(low), fixed(high)),
        [None, Some(high)] => format!("≤ {}", fixed(high)),
        [Some(low), None] => format!("≥ {}", fixed(low)),
        [None, None] => String::new(),
    };
    format!("{text} {}", row.unit).trim_end().into()
}
