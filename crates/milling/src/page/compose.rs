//! Arranges the page of five-axis milling.

use super::{MillingReport, Titled, deviations, orientation, rows, tables};
use report::charts::{ChartError, drawing};
use report::data::{Block, Figure, PlanReport, Section, Table};
use report::head::scope_blocks;

impl MillingReport {
    /// The page.
    ///
    /// # Errors
    /// A number that is not finite.
    pub fn to_page(&self) -> Result<PlanReport, ChartError> {
        let mut sections = vec![
            Section::new("flanks", "Flanks", vec![Block::Table(tables::deviations(self))]),
            Section::new("scope-of-the-verdict", "Scope of the verdict", scope_blocks(&self.verdict)),
            Section::new("workpiece-cutter-and-paths", "Workpiece, cutter and paths", self.view_blocks()?),
            Section::new("deviations", "Deviations", deviations::blocks(&self.flanks)?),
            Section::new("rows", "Rows", rows::blocks(&self.flanks)?),
            Section::new("wear-of-the-edge", "Wear of the edge", rows::wear(&self.flanks)?),
        ];
        if self.flanks.iter().any(|flank| !flank.density.is_empty()) {
            sections.push(Section::new(
                "density",
                "Density",
                vec![Block::Table(tables::density(&self.flanks))],
            ));
        }
        if let Some(root) = &self.root {
            sections.push(Section::new("root", "Root", root.blocks()?));
        }
        if let Some(mate) = &self.mate {
            sections.push(Section::new("contact-with-the-mate", "Contact with the mate", mate.blocks()?));
        }
        let operations = Block::Table(tables::operations(&self.operations));
        sections.push(Section::new("operations", "Operations", vec![operations]));
        if !self.orientations.is_empty() {
            sections.push(Section::new(
                "orientation-of-the-cutter",
                "Orientation of the cutter",
                orientation::blocks(&self.orientations)?,
            ));
        }
        if let Some(programs) = &self.programs {
            sections.push(Section::new("programs", "Programs", programs.blocks()?));
        }
        Ok(self.head.page(sections))
    }

    fn view_blocks(&self) -> Result<Vec<Block>, ChartError> {
        let mut blocks = Vec::new();
        for view in &self.views {
            blocks.push(Block::Figure(Figure::new(view.id, drawing(&view.drawing)?, "")));
        }
        blocks.push(Block::Table(Table::of_quantities("", &self.bodies)));
        Ok(blocks)
    }
}

impl Titled {
    fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let figure = Figure::new(
            "root-in-the-column-plane-in-the-middle-of-the-tooth",
            drawing(&self.drawing)?,
            self.caption.clone(),
        );
        Ok(vec![Block::Figure(figure), Block::Table(Table::of_quantities("", &self.quantities))])
    }
}
