//! Arranges the page of a measured gear.

use super::data::{FlankView, MeasuredGearReport, RoundView};
use super::difference::FEATURES;
use super::{pictures, tests_table};
use foundation::geometry::Flank;
use report::cells::{fixed, fixed_or_none, flank_title, yes_no};
use report::charts::ChartError;
use report::data::{Block, Column, PlanReport, Section, Table};
use report::head::scope_blocks;

const INTRODUCTION: &str = "All values are normal to the flank, positive where material is left standing, about their mean: thickness is \
     judged by span or balls. w is the length of roll, z counts from the middle of the face width.";

impl MeasuredGearReport {
    /// The page; sections without data are left out.
    ///
    /// # Errors
    /// A number that is not finite, or lists of different length.
    pub fn to_page(&self) -> Result<PlanReport, ChartError> {
        let mut sections = Vec::new();
        let mut add = |id: String, title: String, blocks: Vec<Block>| {
            if !blocks.is_empty() {
                sections.push(Section::new(id, title, blocks));
            }
        };
        add("scope-of-the-verdict".into(), "Scope of the verdict".into(), scope_blocks(&self.verdict));
        if self.rounds.iter().any(|round| round.flanks.iter().any(|(_, flank)| flank.is_some())) {
            let mut blocks = vec![
                Block::Paragraph(INTRODUCTION.to_owned()),
                Block::Table(self.course()?),
                Block::Table(self.against_process()?),
            ];
            blocks.extend(pictures::deviations(&self.rounds)?);
            add("measured-against-the-target".into(), "Measured against the target".into(), blocks);
        }
        for round in &self.rounds {
            let title = match self.rounds.len() {
                1 => "What is systematic, and what removes it".to_owned(),
                _ => format!("Round {}: what is systematic, and what removes it", round.number),
            };
            add(format!("round-{}", round.number), title, round.blocks()?);
        }
        if let Some(first) = self.rounds.first() {
            let title = if self.rounds.len() > 1 {
                "Target, process and part of the first round"
            } else {
                "Target, process and part"
            };
            add("stages".into(), title.into(), pictures::stages(first)?);
        }
        add("evaluation".into(), "Evaluation to ISO 1328-1".into(), self.evaluation.blocks()?);
        if !self.not_understood.is_empty() {
            add("not-understood".into(), "Not understood".into(), vec![Block::Table(self.lines_table())]);
        }
        Ok(self.head.page(sections))
    }

    /// Deviation of every round and flank from what the process should have made.
    fn against_process(&self) -> Result<Table, ChartError> {
        let mut rows = Vec::new();
        for (number, flank, view) in self.views() {
            rows.push(vec![
                number.to_string(),
                flank_title(flank).to_owned(),
                fixed("rms", view.model.rms_um, 3)?,
                fixed("largest", view.model.largest_um, 3)?,
                fixed_or_none("correlation", view.correlation, 2)?,
                yes_no(view.explained),
            ]);
        }
        Ok(Table {
            caption: "Measured less simulated".into(),
            columns: vec![
                Column::number("Round", ""),
                Column::name("Flank"),
                Column::number("rms", "µm"),
                Column::number("largest", "µm"),
                Column::number("correlation", ""),
                Column::text("The plan explains the part"),
            ],
            rows,
            note: "The simulated flank is that of a machine without deviations. Correlation is that of both deviations from the target. \
                   A compensation leaves the target by what the machine was measured to do wrong."
                .into(),
        })
    }

    fn views(&self) -> impl Iterator<Item = (usize, Flank, &FlankView)> {
        self.rounds.iter().flat_map(|round| {
            let views = round.flanks.iter().filter_map(|(flank, view)| Some((flank, view.as_ref()?)));
            views.map(|(flank, view)| (round.number, flank, view))
        })
    }

    /// Deviation of every round and flank from the target.
    fn course(&self) -> Result<Table, ChartError> {
        let mut columns = vec![
            Column::number("Round", ""),
            Column::name("Flank"),
            Column::number("rms", "µm"),
            Column::number("largest", "µm"),
            Column::number("within tolerance", "%"),
        ];
        columns.extend(FEATURES.map(|symbol| Column::number(symbol, "µm")));
        let mut rows = Vec::new();
        for (number, flank, view) in self.views() {
            let mut row = vec![number.to_string(), flank_title(flank).to_owned()];
            row.extend(figures(view)?);
            rows.push(row);
        }
        let surfaces: Vec<String> = self.rounds.first().map_or_else(Vec::new, |round| {
            let views = round.flanks.iter().filter_map(|(flank, view)| Some((flank, view.as_ref()?)));
            views.map(|(flank, view)| format!("{}: {}", flank_title(flank), view.surface)).collect()
        });
        Ok(Table {
            caption: "Measured less target".into(),
            columns,
            rows,
            note: format!(
                "{}. The five characteristics are those of the areal fit; slopes of material.",
                surfaces.join("; ")
            ),
        })
    }

    fn lines_table(&self) -> Table {
        let row =
            |(file, line, text): &(String, usize, String)| vec![file.clone(), line.to_string(), text.clone()];
        Table {
            caption: String::new(),
            columns: vec![Column::name("File"), Column::number("Line", ""), Column::text("Beginning")],
            rows: self.not_understood.iter().map(row).collect(),
            note: "Nothing of these lines was used.".into(),
        }
    }
}

fn figures(view: &FlankView) -> Result<Vec<String>, ChartError> {
    let of = &view.deviation;
    let mut cells = vec![
        fixed("rms", of.rms_um, 3)?,
        fixed("largest", of.largest_um, 3)?,
        fixed("within tolerance", 100.0 * of.within_tolerance, 0)?,
    ];
    for value in of.features_um {
        cells.push(fixed("characteristic", value, 3)?);
    }
    Ok(cells)
}

impl RoundView {
    fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let mut blocks = Vec::new();
        if !self.tests.is_empty() {
            blocks.push(Block::Table(tests_table::table(&self.tests)?));
        }
        if let Some(correction) = &self.correction {
            blocks.extend(correction.blocks()?);
        }
        if let Some(why) = &self.no_correction {
            blocks.push(Block::Paragraph(format!("No correction: {why}.")));
        }
        Ok(blocks)
    }
}
