//! The banner and the summary table: what was asked for, what comes out, how far apart they are.

use super::content::{GrindingPage, ShownFlank};
use super::target_amounts::TargetAmount;
use report::charts::{format_fixed, format_significant};
use report::{Banner, Block, Column, Fact, Table};
use run::{CharacteristicsUm, sentence};
use verdict::Status;

/// Largest of a figure over the flanks.
fn worst(page: &GrindingPage<'_>, figure: impl Fn(&ShownFlank<'_>) -> f64) -> Option<f64> {
    page.flanks.iter().filter_map(|(_, flank)| flank.as_ref().map(&figure)).reduce(f64::max)
}

pub(super) fn banner(page: &GrindingPage<'_>) -> Banner {
    let deviation = worst(page, |flank| flank.result.max_deviation_um);
    let tolerance = format_significant(page.tolerance_um, 4);
    let mut sentences = vec![match (page.verdict.status(), deviation) {
        (_, Some(deviation)) => {
            let place = if deviation <= page.tolerance_um { "within" } else { "outside" };
            compared(deviation, place, &tolerance)
        }
        (Status::Met, None) => "The target is met within its tolerance.".to_owned(),
        (Status::NotJudged, None) => "The target was not judged.".to_owned(),
        (Status::Missed, None) => "The target is missed.".to_owned(),
    }];
    let reason = page.verdict.reason();
    if let Some(reason) = reason {
        sentences.push(sentence(reason));
        let way_out = reason.way_out.trim_end_matches('.');
        sentences.extend((!way_out.is_empty()).then(|| format!("Remedy: {way_out}.")));
    }
    let headline = sentences.join(" ");
    let mut figures = Vec::new();
    let text = |value: f64| format!("{} µm", micrometres(value));
    for (label, value) in [
        ("Deviation, max", deviation.map(text)),
        ("Deviation, rms", worst(page, |flank| flank.result.rms_deviation_um).map(text)),
        ("Tolerance", Some(format!("{tolerance} µm"))),
        ("Analytic against referee", worst(page, |flank| flank.result.model_difference_um).map(text)),
    ] {
        figures.extend(value.map(|value| Fact::new(label, value)));
    }
    if let Some(settings) = page.ratio {
        figures.push(Fact::new("Diagonal ratio", format_significant(settings.settings.diagonal_ratio, 5)));
    }
    if let Some(reason) = reason {
        figures.push(Fact::new("Code", reason.code));
    }
    Banner { status: page.verdict.status().into(), headline, figures }
}

fn compared(deviation: f64, place: &str, tolerance: &str) -> String {
    format!("Largest deviation {} µm, {place} the tolerance of {tolerance} µm.", micrometres(deviation))
}

/// A flank with its name.
type Named<'a> = (String, &'a ShownFlank<'a>);

pub(super) fn summary(page: &GrindingPage<'_>) -> Vec<Block> {
    let flanks: Vec<Named<'_>> = page
        .flanks
        .iter()
        .filter_map(|(side, flank)| flank.as_ref().map(|flank| (side.to_string(), flank)))
        .collect();
    if flanks.is_empty() {
        return Vec::new();
    }
    let mut blocks = Vec::new();
    if flanks.iter().any(|(_, flank)| !flank.amounts.is_empty()) {
        blocks.push(Block::Table(amounts(&flanks)));
    }
    blocks.push(Block::Table(characteristics(&flanks)));
    blocks.push(Block::Table(deviations(&flanks, page.tolerance_um)));
    if flanks.iter().any(|(_, flank)| flank.result.outside_class_um > LEAST_OUTSIDE_UM) {
        blocks.push(Block::Table(outside(&flanks)));
    }
    blocks
}

/// Parts outside the producible class below this are rounding, um.
const LEAST_OUTSIDE_UM: f64 = 5e-4;

/// One row per modification; equal entries of both flanks share a row.
fn amounts(flanks: &[Named<'_>]) -> Table {
    let mut columns = vec![Column::text("Modification")];
    columns.extend(flanks.iter().map(|(side, _)| Column::number(capitalised(side), "µm")));
    columns.push(Column::text("Remark"));
    let mut kinds: Vec<(&str, &str)> = Vec::new();
    for amount in flanks.iter().flat_map(|(_, flank)| &flank.amounts) {
        let kind = (amount.name.as_str(), amount.detail.as_str());
        if !kinds.contains(&kind) {
            kinds.push(kind);
        }
    }
    let rows = kinds
        .into_iter()
        .map(|(name, detail)| {
            let mut row = vec![capitalised(name)];
            row.extend(flanks.iter().map(|(_, flank)| {
                let same: Vec<String> = flank
                    .amounts
                    .iter()
                    .filter(|a| a.name == name && a.detail == detail)
                    .map(|a| {
                        a.amount_um.map_or_else(|| "see remark".to_owned(), |um| format_significant(um, 6))
                    })
                    .collect();
                if same.is_empty() { "–".to_owned() } else { same.join(" + ") }
            }));
            row.push(detail.to_owned());
            row
        })
        .collect();
    Table { caption: "Target".to_owned(), columns, rows, note: "Positive: material removed.".to_owned() }
}

/// Name and symbol, the kind of modification that asks for it by its amount, and the value in [`CharacteristicsUm`].
pub(super) type Row = (&'static str, &'static str, fn(&CharacteristicsUm) -> f64);

pub(super) const ROWS: [Row; 8] = [
    ("Helix crowning C_β", "helix crowning", |c| c.helix_crowning_um),
    ("Profile crowning C_α", "profile crowning", |c| c.profile_crowning_um),
    ("Helix slope C_Hβ", "helix slope", |c| c.helix_slope_um),
    ("Profile slope C_Hα", "profile slope", |c| c.profile_slope_um),
    ("Twist, corners, transverse", "twist", |c| c.twist_corner_um),
    ("Twist, corners, normal", "", |c| c.twist_corner_normal_um),
    ("Twist, least squares, transverse", "", |c| c.twist_fit_um),
    ("Twist, least squares, normal", "", |c| c.twist_fit_normal_um),
];

/// Where the values of a column come from.
enum Source<'a> {
    /// The amounts of the job.
    Asked(&'a [TargetAmount]),
    /// A fit over the whole field.
    Fitted(&'a CharacteristicsUm),
}

impl Source<'_> {
    fn value(&self, (_, kind, of): &Row) -> Option<f64> {
        match self {
            Self::Fitted(values) => Some(of(values)),
            Self::Asked(amounts) => {
                let asked: Vec<f64> = amounts
                    .iter()
                    .filter(|amount| amount.name == *kind)
                    .filter_map(|a| a.amount_um)
                    .collect();
                (!asked.is_empty()).then(|| asked.iter().sum())
            }
        }
    }
}

fn characteristics(flanks: &[Named<'_>]) -> Table {
    let mut columns = vec![Column::symbols("Characteristic")];
    let mut sources: Vec<Source<'_>> = Vec::new();
    for (side, flank) in flanks {
        columns.push(Column::number(format!("{} asked", capitalised(side)), "µm"));
        sources.push(Source::Asked(&flank.amounts));
        let stages = [
            ("target field", &flank.result.target_characteristics),
            ("planned", &flank.planned),
            ("simulated", &flank.result.simulated_characteristics),
        ];
        for (stage, values) in stages {
            columns.push(Column::number(format!("{} {stage}", capitalised(side)), "µm"));
            sources.push(Source::Fitted(values));
        }
    }
    let rows = ROWS
        .iter()
        .map(|row| {
            let cell =
                |source: &Source<'_>| source.value(row).map_or("–".to_owned(), |v| format_fixed(v, 3));
            std::iter::once(row.0.to_owned()).chain(sources.iter().map(cell)).collect()
        })
        .collect();
    let note = "Least squares over the whole evaluated field, reliefs included: a relief shows here as crowning and slope as well. What the job asks for stands under Asked and in the table above. Crownings and slopes are transverse. Planned: analytic model; simulated: material removal (referee).";
    let caption = "Characteristic values, fitted over the whole field".to_owned();
    Table { caption, columns, rows, note: note.to_owned() }
}

fn deviations(flanks: &[Named<'_>], tolerance_um: f64) -> Table {
    let mut columns = vec![Column::text("Deviation, normal")];
    columns.extend(flanks.iter().map(|(side, _)| Column::number(capitalised(side), "µm")));
    let row = |name: &str, figure: &dyn Fn(&ShownFlank<'_>) -> f64| {
        let mut row = vec![name.to_owned()];
        row.extend(flanks.iter().map(|(_, flank)| micrometres(figure(flank))));
        row
    };
    let mut tolerance = vec!["Tolerance".to_owned()];
    tolerance.extend(flanks.iter().map(|_| format_significant(tolerance_um, 4)));
    Table {
        caption: "Deviation from the target".to_owned(),
        columns,
        rows: vec![
            row("Simulated against target, max", &|flank| flank.result.max_deviation_um),
            row("Simulated against target, rms", &|flank| flank.result.rms_deviation_um),
            row("Planned against simulated, max", &|flank| flank.result.model_difference_um),
            tolerance,
        ],
        note: String::new(),
    }
}

fn outside(flanks: &[Named<'_>]) -> Table {
    let rows = flanks
        .iter()
        .map(|(side, flank)| (side, flank.result.outside_class_um))
        .filter(|(_, um)| *um > LEAST_OUTSIDE_UM)
        .map(|(side, um)| {
            let term = "parts of the target that are best-fitted only (normal)".to_owned();
            vec![capitalised(side), term, format_fixed(um, 3), format_fixed(um, 3)]
        })
        .collect();
    Table {
        caption: "Terms that this plan does not carry".to_owned(),
        columns: vec![
            Column::text("Flank"),
            Column::text("Term"),
            Column::number("Wanted", "µm"),
            Column::number("Residual", "µm"),
        ],
        rows,
        note: "Best fit in the least-squares sense.".to_owned(),
    }
}

/// Three decimals, or significant digits for what would round to nothing.
fn micrometres(value: f64) -> String {
    if value != 0.0 && value.abs() < 0.01 { format_significant(value, 2) } else { format_fixed(value, 3) }
}

fn capitalised(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map(|c| c.to_uppercase().chain(chars).collect()).unwrap_or_default()
}
