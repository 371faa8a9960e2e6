//! The report of a refused job: the reason, the picture of what limits, the candidates, the bodies.

use crate::derived::DerivedGeometry;
use crate::evidence::Evidence;
use crate::job_title::JobTitle;
use job::Diagnostic;
use report::charts::{ChartError, format_significant};
use report::{Banner, Block, Column, Fact, Section, Stamp, Table, html, unit};
use serde_json::Value;

/// What the page shows.
pub struct Refused<'a> {
    pub job: JobTitle<'a>,
    pub tolerance_um: Option<f64>,
    pub finding: &'a Diagnostic,
    pub bodies: Option<&'a DerivedGeometry>,
    pub evidence: Option<&'a dyn Evidence>,
}

/// The report as a self-contained HTML page.
///
/// # Errors
/// A number that is not finite.
pub fn html_page(refused: &Refused<'_>, files: &[(String, &'static str)]) -> Result<String, ChartError> {
    let finding = refused.finding;
    let mut sections = Vec::new();
    if let Some(evidence) = refused.evidence {
        let figures = evidence.figures(finding)?;
        sections.push(Section::new(
            "what-limits",
            "What limits",
            figures.into_iter().map(Block::Figure).collect(),
        ));
        sections.push(Section::new("candidates-tried", "Candidates tried", evidence.tried()));
    }
    if let Some(bodies) = refused.bodies {
        sections.push(Section::new("bodies", "Bodies", vec![Block::Tables(body_tables(bodies))]));
    }
    sections.push(Section::new(
        "files",
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
    let head = refused.job.head(&refused.job.info.process.name().replace('-', " "));
    let banner = Banner { status: Stamp::NotProducible, headline, figures };
    Ok(html::render(&head.page(banner, sections)))
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

fn body_tables(bodies: &DerivedGeometry) -> Vec<Table> {
    let text = |value: &Value| match value {
        Value::String(word) => word.clone(),
        Value::Number(number) if number.is_f64() => {
            number.as_f64().map_or_else(String::new, |x| format_significant(x, 6))
        }
        other => other.to_string(),
    };
    bodies
        .sections()
        .iter()
        .map(|section| Table {
            caption: sentence(section.title).trim_end_matches('.').to_owned(),
            columns: vec![Column::text(Table::QUANTITY), Column::number("Value", ""), Column::text("Unit")],
            rows: section
                .quantities
                .iter()
                .map(|q| vec![q.label.to_string(), text(&q.value), unit(q.unit).into_owned()])
                .collect(),
            note: String::new(),
        })
        .collect()
}
