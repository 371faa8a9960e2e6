//! The page of a series of measured parts, composed from its document: statistics, capability and trends of every characteristic with
//! their charts, parts with links to their sheets.

mod characteristic;
mod chart;
mod head;
mod tables;

use crate::workflow::series::{InspectionSeries, SeriesCharacteristic, SeriesGroupResult};
use characteristic::{name, unit};
use report::charts::ChartError;
use report::{Block, Figure, PlanReport, Section, Warning, kebab};

/// The page.
///
/// # Errors
/// [`ChartError`] for numbers that cannot be drawn.
pub fn series_page(series: &InspectionSeries) -> Result<PlanReport, ChartError> {
    let sections = series.result.groups.iter().map(section).collect::<Result<Vec<Section>, _>>()?;
    Ok(head::head(series).page(sections))
}

fn section(group: &SeriesGroupResult) -> Result<Section, ChartError> {
    let title = match group.parts.len() {
        1 => format!("{}: 1 part", group.series),
        n => format!("{}: {n} parts in the order of their {}", group.series, group.ordered_by),
    };
    let mut blocks = vec![Block::Table(tables::statistics(group))];
    blocks.extend(tables::capability(group).map(Block::Table));
    if group.characteristics.iter().any(|of| of.figures.is_some()) {
        blocks.push(Block::Table(tables::trends(group)));
    }
    let remarks = remarks(&group.characteristics);
    if !remarks.is_empty() {
        blocks.push(Block::Warnings(remarks));
    }
    blocks.push(Block::Table(tables::parts(group)));
    for of in &group.characteristics {
        if let Some(svg) = chart::chart(of)? {
            // The id was there before the index stood below the line.
            let id = kebab(&format!("{} {}", name(of).replace('_', ""), unit(of)));
            blocks.push(Block::Figure(Figure::new(id, svg, caption(of))));
        }
    }
    Ok(Section::new(kebab(&group.series), title, blocks))
}

/// Remarks, each once with the characteristics that it concerns.
fn remarks(characteristics: &[SeriesCharacteristic]) -> Vec<Warning> {
    let mut found: Vec<(&str, Vec<String>)> = Vec::new();
    for of in characteristics {
        for remark in &of.remarks {
            match found.iter_mut().find(|(text, _)| text == remark) {
                Some((_, names)) => names.push(name(of)),
                None => found.push((remark, vec![name(of)])),
            }
        }
    }
    let warning = |(text, names): (&str, Vec<String>)| Warning {
        text: if names.len() == characteristics.len() {
            format!("All characteristics: {text}")
        } else {
            format!("{}: {text}", names.join(", "))
        },
        way_out: String::new(),
    };
    found.into_iter().map(warning).collect()
}

fn caption(of: &SeriesCharacteristic) -> &'static str {
    match &of.figures {
        Some(figures) if !figures.special_causes.is_empty() => {
            "Ringed: where a rule for special causes ends; see the table."
        }
        _ => "",
    }
}
