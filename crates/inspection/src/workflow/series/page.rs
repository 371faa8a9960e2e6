//! Fills the page of a series from its document.

use super::super::characteristics::characteristic_in_words;
use super::super::files::LeftOutFile;
use super::InspectionSeries;
use super::result::{
    SeriesCharacteristic, SeriesFigures, SeriesFinding, SeriesGroupResult, SeriesPartResult,
};
use crate::page::series::{
    CapabilityFigures, CharacteristicFigures, CharacteristicRow, MarkedStretch, PartRow, SeriesGroup,
    SeriesReport, TrendFigures,
};
use report::charts::ChartError;
use report::{PlanReport, ReportHead, Warning};
use verdict::Status;

/// The page.
///
/// # Errors
/// [`ChartError`] for numbers that cannot be drawn.
pub(super) fn series_page(series: &InspectionSeries) -> Result<PlanReport, ChartError> {
    SeriesReport { head: head(series), groups: series.result.groups.iter().map(group).collect() }.to_page()
}

/// Whether anything has limits.
fn judged_parts(series: &InspectionSeries) -> bool {
    series.groups.iter().flatten().any(|of| of.has_limits())
}

fn head(series: &InspectionSeries) -> ReportHead {
    let result = &series.result;
    let parts: usize = result.groups.iter().map(|group| group.parts.len()).sum();
    let beyond =
        result.groups.iter().flat_map(|group| &group.parts).filter(|p| !p.exceeded.is_empty()).count();
    let judged = match result.tolerance_class {
        Some(class) if beyond == 0 && result.verdict.status() != Status::Met => {
            format!("None was found beyond the limits of ISO 1328-1:2013 class {class}.")
        }
        None if judged_parts(series) && beyond == 0 => {
            "All keep the limits that they were imported with.".to_owned()
        }
        None if judged_parts(series) => {
            format!("Parts beyond the limits that they were imported with: {beyond}.")
        }
        None => "Nothing is judged: no class of ISO 1328-1:2013 is given.".to_owned(),
        Some(class) if beyond == 0 => format!("All keep the limits of ISO 1328-1:2013 class {class}."),
        Some(class) => format!("Parts beyond the limits of ISO 1328-1:2013 class {class}: {beyond}."),
    };
    let unjudged =
        result.groups.iter().flat_map(|group| &group.parts).filter(|p| !p.not_judged.is_empty()).count();
    let judged = match unjudged {
        0 => judged,
        _ => format!("{judged} Parts that lack something the class needs: {unjudged}."),
    };
    let mut files = vec![
        ("series.json".to_owned(), "all figures".to_owned()),
        ("series.csv".into(), "every value of every part".into()),
        ("series.html".into(), "this page".into()),
    ];
    if !series.sheets.is_empty() {
        files.push(("sheets/".into(), "the inspection sheet of every part".into()));
    }
    let refused = |file: &super::RefusedFile| Warning {
        text: format!("{}: not evaluated: {} [{}]", file.file, file.message, file.code),
        way_out: file.way_out.clone(),
    };
    let left_out = |file: &LeftOutFile| Warning {
        text: format!("{}: left out: {}", file.file, file.reason),
        way_out: String::new(),
    };
    ReportHead {
        job_name: "Series of measured parts".into(),
        description: (!result.stated.is_empty())
            .then(|| format!("Stated about the measurements: {}.", result.stated.join("; "))),
        process: "inspection of a series",
        version: result.version.into(),
        status: result.verdict.status().into(),
        headline: match parts {
            1 => format!("1 part evaluated. {judged}"),
            _ => format!("{parts} parts evaluated. {judged}"),
        },
        way_out: String::new(),
        figures: vec![
            ("parts".into(), parts.to_string()),
            ("series".into(), result.groups.len().to_string()),
            ("files refused".into(), result.refused.len().to_string()),
        ],
        warnings: result.refused.iter().map(refused).chain(result.left_out.iter().map(left_out)).collect(),
        files,
    }
}

fn group(of: &SeriesGroupResult) -> SeriesGroup {
    SeriesGroup {
        name: of.series.clone(),
        title: match of.parts.len() {
            1 => format!("{}: 1 part", of.series),
            n => format!("{}: {n} parts in the order of their {}", of.series, of.ordered_by),
        },
        parts: of.parts.iter().map(part).collect(),
        characteristics: of.characteristics.iter().map(characteristic).collect(),
    }
}

fn part(of: &SeriesPartResult) -> PartRow {
    PartRow {
        number: of.number,
        part: of.part.clone(),
        time: of.time.clone().unwrap_or_default(),
        sheet: of.sheet.clone().unwrap_or_default(),
        class: of.class.map_or_else(String::new, |class| class.to_string()),
        exceeded: of
            .exceeded
            .iter()
            .map(|key| characteristic_in_words(key))
            .chain(of.not_judged.iter().map(|item| format!("{item}: not judged")))
            .collect::<Vec<_>>()
            .join(", "),
        warnings: of.warnings.len(),
    }
}

fn characteristic(of: &SeriesCharacteristic) -> CharacteristicRow {
    let micrometres = of.unit == "um";
    CharacteristicRow {
        key: characteristic_in_words(&of.key),
        unit: if micrometres { "µm".into() } else { String::new() },
        decimals: if micrometres { 2 } else { 4 },
        limits: [of.lower_limit, of.upper_limit],
        parts: of.parts.clone(),
        values: of.values.clone(),
        figures: of.figures.as_ref().map(figures),
        remarks: of.remarks.clone(),
    }
}

fn figures(of: &SeriesFigures) -> CharacteristicFigures {
    CharacteristicFigures {
        mean: [of.mean, of.mean_interval_95[0], of.mean_interval_95[1]],
        deviation: of.s,
        extremes: [of.min, of.max],
        control: of.control_limits,
        moving_range: of.moving_range,
        capability: of.capability.as_ref().map(|capability| CapabilityFigures {
            cp: capability.cp,
            cpk: capability.cpk,
            cpk_interval: capability.cpk_interval_95,
            short_term: [capability.cp_mr, capability.cpk_mr],
            outside_ppm: capability.outside_ppm,
        }),
        trend: of.trend.map(|trend| TrendFigures {
            start: trend.start,
            slope: trend.per_part,
            interval: trend.interval_95,
            probability: trend.p,
        }),
        marked: of.special_causes.iter().map(marked).collect(),
    }
}

fn marked(of: &SeriesFinding) -> MarkedStretch {
    let mark = match of.rule {
        "beyond-three-sigma" => "3σ",
        "two-of-three-beyond-two-sigma" => "2 of 3",
        "one-side" => "run of 9",
        _ => "steady 6",
    };
    MarkedStretch { parts: [of.first, of.last], mark, meaning: of.meaning }
}
