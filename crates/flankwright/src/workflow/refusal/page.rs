//! The report of a refused job: the reason, the picture of what limits, the candidates, the bodies.

use super::evidence::Evidence;
use crate::exchange::Diagnostic;
use crate::exchange::job::JobInfo;
use crate::report::charts::{ChartError, format_significant};
use crate::report::{Banner, Block, Column, Fact, PlanReport, Section, Stamp, Table, html};
use crate::workflow::DerivedGeometry;
use serde_json::Value;

/// What the page shows.
pub(super) struct Refused<'a> {
    pub job: &'a JobInfo,
    pub tolerance_um: Option<f64>,
    pub finding: &'a Diagnostic,
    pub bodies: Option<&'a DerivedGeometry>,
    pub evidence: Option<&'a Evidence>,
}

/// The report as a self-contained HTML page.
///
/// # Errors
/// A number that is not finite.
pub(super) fn html_page(
    refused: &Refused<'_>,
    files: &[(String, &'static str)],
) -> Result<String, ChartError> {
    let finding = refused.finding;
    let mut sections = Vec::new();
    if let Some(evidence) = refused.evidence {
        let figures = evidence.figures(finding)?;
        sections.push(Section::new("What limits", figures.into_iter().map(Block::Figure).collect()));
        sections.push(Section::new("Candidates tried", candidates(evidence)));
    }
    if let Some(bodies) = refused.bodies {
        sections.push(Section::new("Bodies", vec![Block::Tables(body_tables(bodies))]));
    }
    sections.push(Section::new(
        "Files",
        vec![Block::Table(Table {
            caption: String::new(),
            columns: vec![Column::text("File"), Column::text("Content")],
            rows: files.iter().map(|(path, content)| vec![path.clone(), (*content).to_owned()]).collect(),
            note: String::new(),
        })],
    ));
    let mut headline = sentence(&finding.message);
    if let Some(remedy) = &finding.way_out {
        headline += &format!(" Remedy: {}", sentence_as_is(remedy));
    }
    let mut figures = vec![Fact::new("Code", finding.code)];
    figures.extend(finding.field.as_ref().map(|field| Fact::new("Key", field.to_string())));
    let tolerance = refused.tolerance_um.map(|um| format!("{} µm", format_significant(um, 4)));
    figures.extend(tolerance.map(|text| Fact::new("Tolerance", text)));
    Ok(html::render(&PlanReport {
        title: refused.job.name.clone(),
        subtitle: refused.job.description.clone(),
        facts: vec![
            Fact::new("Process", refused.job.process.name()),
            Fact::new("Version", env!("CARGO_PKG_VERSION")),
        ],
        banner: Banner { status: Stamp::NotProducible, headline, figures },
        sections,
    }))
}

/// With a capital and a full stop.
fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map_or_else(String::new, |c| c.to_uppercase().collect());
    sentence_as_is(&format!("{first}{}", letters.as_str()))
}

fn sentence_as_is(text: &str) -> String {
    if text.ends_with('.') { text.to_owned() } else { format!("{text}.") }
}

fn candidates(evidence: &Evidence) -> Vec<Block> {
    let judged = evidence.candidates();
    let failed = evidence.failed();
    let mut rows: Vec<Vec<String>> = judged
        .iter()
        .map(|c| {
            vec![
                format_significant(c.diagonal_ratio, 6),
                c.profile_crowning_by.to_owned(),
                format_significant(c.score, 3),
                format_significant(c.worm_occupation_mm, 5),
                format_significant(c.ideal_error_um, 4),
                c.refused.clone().unwrap_or_else(|| "allowed".to_owned()),
            ]
        })
        .collect();
    rows.extend(failed.iter().map(|f| {
        let none = || "–".to_owned();
        vec![format_significant(f.diagonal_ratio, 6), none(), none(), none(), none(), f.text.clone()]
    }));
    if rows.is_empty() {
        return Vec::new();
    }
    vec![Block::Table(Table {
        caption: String::new(),
        columns: vec![
            Column::number("K", ""),
            Column::text("Profile crowning by"),
            Column::number("Share of the axis limits", ""),
            Column::number("Worm used", "mm"),
            Column::number("Residual", "µm"),
            Column::text("Verdict"),
        ],
        rows,
        note: "Residual: largest deviation that an ideal worm leaves on the planning grid.".to_owned(),
    })]
}

fn body_tables(bodies: &DerivedGeometry) -> Vec<Table> {
    let text = |value: &Value| match value {
        Value::String(word) => word.clone(),
        Value::Number(number) if number.is_f64() => {
            number.as_f64().map_or_else(String::new, |x| format_significant(x, 7))
        }
        other => other.to_string(),
    };
    bodies
        .sections()
        .iter()
        .map(|section| Table {
            caption: sentence(section.title).trim_end_matches('.').to_owned(),
            columns: vec![Column::text("Quantity"), Column::number("Value", ""), Column::text("Unit")],
            rows: section
                .quantities
                .iter()
                .map(|q| vec![q.label.to_owned(), text(&q.value), q.unit.to_owned()])
                .collect(),
            note: String::new(),
        })
        .collect()
}
