//! The banner and the summary table: what was asked for, what comes out, how far apart they are.

use super::data::{Characteristics, FlankReport, GeneratingReport, TargetAmount};
use crate::charts::{format_fixed, format_significant};
use crate::data::{Banner, Block, Column, Fact, Stamp, Table};
use verdict::Status;

/// Largest of a figure over the flanks that have it.
fn worst(report: &GeneratingReport, figure: impl Fn(&FlankReport) -> Option<f64>) -> Option<f64> {
    report.flanks.iter().filter_map(|(_, flank)| flank.as_ref().and_then(&figure)).reduce(f64::max)
}

pub(super) fn banner(report: &GeneratingReport) -> Banner {
    let deviation = worst(report, |flank| flank.max_deviation_um);
    let tolerance = format_significant(report.tolerance_um, 4);
    let mut sentences = Vec::new();
    match (report.status, deviation) {
        (Stamp::NotProducible, _) if report.reason.is_none() => {
            sentences.push("These bodies can't make the target.".to_owned());
        }
        (Stamp::NotProducible | Stamp::Study, _) => {}
        (Stamp::Judged(_), Some(deviation)) => {
            let place = if deviation <= report.tolerance_um { "within" } else { "outside" };
            sentences.push(compared(deviation, place, &tolerance));
        }
        (Stamp::Judged(Status::Met), None) => {
            sentences.push("The target is met within its tolerance.".to_owned())
        }
        (Stamp::Judged(Status::NotJudged), None) => sentences.push("The target was not judged.".to_owned()),
        (Stamp::Judged(Status::Missed), None) => sentences.push("The target is missed.".to_owned()),
    }
    if let Some(reason) = &report.reason {
        let parts = [&reason.cause, &reason.way_out];
        sentences.extend(parts.into_iter().filter(|part| !part.is_empty()).cloned());
    }
    let headline = sentences.join(" ");
    let mut figures = Vec::new();
    let text = |value: f64| format!("{} µm", micrometres(value));
    for (label, value) in [
        ("Deviation, max", deviation.map(text)),
        ("Deviation, rms", worst(report, |flank| flank.rms_deviation_um).map(text)),
        ("Tolerance", Some(format!("{tolerance} µm"))),
        ("Analytic against referee", worst(report, |flank| flank.model_difference_um).map(text)),
    ] {
        figures.extend(value.map(|value| Fact::new(label, value)));
    }
    if let Some(chosen) = report.ratio.as_ref().and_then(|ratio| ratio.chosen) {
        figures.push(Fact::new("Diagonal ratio", format_significant(chosen, 5)));
    }
    if let Some(reason) = &report.reason {
        figures.push(Fact::new("Code", &reason.code));
    }
    Banner { status: report.status, headline, figures }
}

fn compared(deviation: f64, place: &str, tolerance: &str) -> String {
    format!("Largest deviation {} µm, {place} the tolerance of {tolerance} µm.", micrometres(deviation))
}

pub(super) fn summary(report: &GeneratingReport) -> Vec<Block> {
    let flanks: Vec<(String, &FlankReport)> = report
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
    blocks.push(Block::Table(deviations(&flanks, report.tolerance_um)));
    if flanks.iter().any(|(_, flank)| !flank.outside.is_empty()) {
        blocks.push(Block::Table(outside(&flanks)));
    }
    blocks
}

/// One row per modification; equal entries of both flanks share a row.
fn amounts(flanks: &[(String, &FlankReport)]) -> Table {
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

/// Name and symbol, the kind of modification that asks for it by its amount, and the value in [`Characteristics`].
type Row = (&'static str, &'static str, fn(&Characteristics) -> Option<f64>);

const ROWS: [Row; 8] = [
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
    Fitted(&'a Characteristics),
}

impl Source<'_> {
    fn is_fitted(&self) -> bool {
        matches!(self, Self::Fitted(_))
    }

    fn value(&self, (_, kind, of): &Row) -> Option<f64> {
        match self {
            Self::Fitted(values) => of(values),
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

fn characteristics(flanks: &[(String, &FlankReport)]) -> Table {
    let mut columns = vec![Column::symbols("Characteristic")];
    let mut sources: Vec<Source<'_>> = Vec::new();
    for (side, flank) in flanks {
        columns.push(Column::number(format!("{} asked", capitalised(side)), "µm"));
        sources.push(Source::Asked(&flank.amounts));
        let stages = [
            ("target field", Some(&flank.target_values)),
            ("planned", flank.planned_values.as_ref()),
            ("simulated", flank.simulated_values.as_ref()),
        ];
        for (stage, values) in stages {
            if let Some(values) = values {
                columns.push(Column::number(format!("{} {stage}", capitalised(side)), "µm"));
                sources.push(Source::Fitted(values));
            }
        }
    }
    let rows = ROWS
        .iter()
        .filter(|row| sources.iter().any(|source| source.is_fitted() && source.value(row).is_some()))
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

fn deviations(flanks: &[(String, &FlankReport)], tolerance_um: f64) -> Table {
    let mut columns = vec![Column::text("Deviation, normal")];
    columns.extend(flanks.iter().map(|(side, _)| Column::number(capitalised(side), "µm")));
    let row = |name: &str, figure: &dyn Fn(&FlankReport) -> Option<f64>| {
        let mut row = vec![name.to_owned()];
        row.extend(flanks.iter().map(|(_, flank)| figure(flank).map_or("–".to_owned(), micrometres)));
        row
    };
    let mut tolerance = vec!["Tolerance".to_owned()];
    tolerance.extend(flanks.iter().map(|_| format_significant(tolerance_um, 4)));
    Table {
        caption: "Deviation from the target".to_owned(),
        columns,
        rows: vec![
            row("Simulated against target, max", &|flank| flank.max_deviation_um),
            row("Simulated against target, rms", &|flank| flank.rms_deviation_um),
            row("Planned against simulated, max", &|flank| flank.model_difference_um),
            tolerance,
        ],
        note: String::new(),
    }
}

fn outside(flanks: &[(String, &FlankReport)]) -> Table {
    let rows = flanks
        .iter()
        .flat_map(|(side, flank)| flank.outside.iter().map(move |term| (side, term)))
        .map(|(side, term)| {
            let (wanted, residual) = (format_fixed(term.wanted_um, 3), format_fixed(term.residual_um, 3));
            vec![capitalised(side), term.name.clone(), wanted, residual]
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
