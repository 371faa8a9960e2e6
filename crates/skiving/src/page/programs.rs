//! Programs of the measurement and what was proven of them.

use report::cells::fixed;
use report::charts::ChartError;
use report::data::{Block, Column, Quantity, Table};

/// Programs.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramsView {
    /// What was proven from the texts, paragraph by paragraph.
    pub proof: Vec<String>,
    /// The programs.
    pub programs: Vec<ProgramRow>,
    /// Figures of the proof.
    pub figures: Vec<Quantity>,
}

/// A program.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramRow {
    /// Path below the directory of the run.
    pub file: String,
    /// Control.
    pub control: String,
    /// Blocks.
    pub blocks: usize,
    /// Time of the whole program, s.
    pub duration_s: f64,
}

impl ProgramsView {
    pub(super) fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let row = |program: &ProgramRow| {
            Ok(vec![
                program.file.clone(),
                program.control.clone(),
                program.blocks.to_string(),
                fixed(&program.file, program.duration_s, 1)?,
            ])
        };
        let mut blocks: Vec<Block> = self.proof.iter().cloned().map(Block::Paragraph).collect();
        blocks.push(Block::Table(Table {
            caption: String::new(),
            columns: vec![
                Column::name("File"),
                Column::text("Control"),
                Column::number("Blocks", ""),
                Column::number("Duration", "s"),
            ],
            rows: self.programs.iter().map(row).collect::<Result<_, ChartError>>()?,
            note: String::new(),
        }));
        if !self.figures.is_empty() {
            blocks.push(Block::Table(Table::of_quantities("Figures of the proof", &self.figures)));
        }
        Ok(blocks)
    }
}
