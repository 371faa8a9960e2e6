//! The head of the page of a series: how many parts keep their limits, and which files were not evaluated.

use crate::workflow::LeftOutFile;
use crate::workflow::series::{InspectionSeries, RefusedFile};
use report::{PageHead, ReportHead, TitleBlock, Warning};
use run::page_language;
use verdict::Status;

/// Whether anything has limits.
fn judged_parts(series: &InspectionSeries) -> bool {
    series.groups.iter().flatten().any(|of| of.has_limits())
}

pub(super) fn head(series: &InspectionSeries) -> ReportHead {
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
    let language = page_language(series.language);
    let stated = format!("Stated about the measurements: {}.", result.stated.join("; "));
    let mut files = vec![
        ("series.json".to_owned(), "all figures".to_owned()),
        ("series.csv".into(), "every value of every part".into()),
        ("series.html".into(), "this page".into()),
    ];
    if !series.sheets.is_empty() {
        files.push(("sheets/".into(), "the inspection sheet of every part".into()));
    }
    let refused = |file: &RefusedFile| Warning {
        text: format!("{}: not evaluated: {}", file.file, file.message),
        way_out: file.way_out.clone(),
    };
    let left_out = |file: &LeftOutFile| Warning {
        text: format!("{}: left out: {}", file.file, file.reason),
        way_out: String::new(),
    };
    ReportHead {
        head: PageHead {
            title: language.say("Series of measured parts").into_owned(),
            description: (!result.stated.is_empty()).then(|| language.say(&stated).into_owned()),
            language,
            title_block: TitleBlock::of_process("Inspection of a series", result.version),
            ..PageHead::default()
        },
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
