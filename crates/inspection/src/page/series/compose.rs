//! Arranges the page of a series.

use super::data::{CharacteristicRow, SeriesGroup, SeriesReport};
use report::charts::ChartError;
use report::data::{Block, Figure, PlanReport, Section, Warning};
use report::kebab;

impl SeriesReport {
    /// The page.
    ///
    /// # Errors
    /// [`ChartError`] for numbers that cannot be drawn.
    pub fn to_page(&self) -> Result<PlanReport, ChartError> {
        let sections = self.groups.iter().map(SeriesGroup::section).collect::<Result<Vec<Section>, _>>()?;
        Ok(self.head.page(sections))
    }
}

impl SeriesGroup {
    fn section(&self) -> Result<Section, ChartError> {
        let mut blocks = vec![Block::Table(self.statistics())];
        blocks.extend(self.capability().map(Block::Table));
        if self.characteristics.iter().any(|row| row.figures.is_some()) {
            blocks.push(Block::Table(self.trends()));
        }
        let remarks = self.remarks();
        if !remarks.is_empty() {
            blocks.push(Block::Warnings(remarks));
        }
        blocks.push(Block::Table(self.part_table()));
        for row in &self.characteristics {
            if let Some(svg) = row.chart()? {
                blocks.push(Block::Figure(Figure::new(row.id(), svg, caption(row))));
            }
        }
        Ok(Section::new(kebab(&self.name), self.title.clone(), blocks))
    }

    /// Remarks, each once with the characteristics that it concerns.
    fn remarks(&self) -> Vec<Warning> {
        let mut found: Vec<(&str, Vec<&str>)> = Vec::new();
        for row in &self.characteristics {
            for remark in &row.remarks {
                match found.iter_mut().find(|(text, _)| text == remark) {
                    Some((_, keys)) => keys.push(&row.key),
                    None => found.push((remark, vec![&row.key])),
                }
            }
        }
        let warning = |(text, keys): (&str, Vec<&str>)| Warning {
            text: if keys.len() == self.characteristics.len() {
                format!("All characteristics: {text}")
            } else {
                format!("{}: {text}", keys.join(", "))
            },
            way_out: String::new(),
        };
        found.into_iter().map(warning).collect()
    }
}

impl CharacteristicRow {
    fn id(&self) -> String {
        kebab(&format!("{} {}", self.key, self.unit))
    }
}

fn caption(row: &CharacteristicRow) -> String {
    let marked = row.figures.as_ref().map_or(0, |figures| figures.marked.len());
    if marked == 0 {
        String::new()
    } else {
        "Ringed: where a rule for special causes ends; see the table.".into()
    }
}
