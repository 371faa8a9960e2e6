//! Puts the sections of a page on ground flanks in their order. Whatever is absent leaves no trace on the page.

use super::changes::changes;
use super::content::GrindingPage;
use super::drawn_values::drawn_values;
use super::{first_page, motions, ratio, strokes, summary};
use report::charts::{ChartError, DressingSectionChart, dressing_section_chart, worm_occupation_chart};
use report::head::scope_blocks;
use report::{
    Block, Column, DrawnFlanks, Figure, FirstPage, PageHead, PlanReport, Section, Table, Warning,
    first_picture, flank_diagram, flank_figures, kebab,
};
use verdict::Remark;

/// Id of the section with the pictures of the flanks.
pub const TOPOGRAPHIES: &str = "topographies";
/// Id of the section on the referee.
pub const VERIFICATION: &str = "verification";

impl GrindingPage<'_> {
    /// Arranges the figures as a page.
    ///
    /// # Errors
    /// [`ChartError`] if a motion or trace holds values that are not finite or lists of different length.
    pub fn to_page(&self) -> Result<PlanReport, ChartError> {
        let mut dressing = motions::dressing(&self.dressing)?;
        dressing.extend(self.conditions.iter().cloned());
        dressing.extend(strokes::figures(&self.strokes)?);
        let drawn: DrawnFlanks = self.flanks.map(|_, flank| flank.as_ref().map(|flank| flank.stages.clone()));
        let sections = vec![
            Section::new("result-per-flank", "Result per flank", summary::summary(self)),
            Section::new("values-of-the-drawing", "Values of the drawing", drawn_values(self)),
            Section::new("scope-of-the-verdict", "Scope of the verdict", scope_blocks(self.verdict)),
            Section::new("what-would-meet-it", "What would meet the target", changes(self.changes)),
            Section::new("warnings", "Warnings", self.warnings()),
            Section::new("gear-and-tools", "Gear and tools", self.data_sheets()),
            Section::new("settings", "Settings", self.settings()?),
            Section::new(TOPOGRAPHIES, "Topographies", flank_figures(&drawn)?),
            Section::new("profile-and-helix", "Profile and helix", flank_diagram(&drawn)?),
            Section::new("grinding-motion", "Grinding motion", motions::grinding(&self.grinding_motions)?),
            Section::new("dressing-corrections", "Dressing corrections", dressing),
            Section::new("room-for-the-dresser", "Room for the dresser", self.room()?),
            Section::new("axes-that-are-off", "Axes that are off", self.deviated.clone()),
            Section::new("measured-worm", "Measured worm", self.measured_worm.clone()),
            Section::new("gearbox-and-servo", "Gearbox and servo", self.control.clone()),
            Section::new("stock-strokes-and-cost", "Stock, strokes and cost", self.removal.clone()),
            Section::new("nc-programs", "NC programs", self.programs.clone()),
            Section::new("files", "Files", self.files()),
            Section::new(
                "choice-of-the-diagonal-ratio",
                "Choice of the diagonal ratio",
                self.ratio.map_or(Ok(Vec::new()), ratio::choice)?,
            )
            .in_appendix(),
            Section::new(VERIFICATION, "How it was verified", self.verification.clone()).in_appendix(),
            Section::new(
                "convergence-of-the-precompensation",
                "Convergence of the precompensation",
                self.convergence.map_or(Ok(Vec::new()), motions::convergence)?,
            )
            .in_appendix(),
        ];
        let head = PageHead { first_page: self.first_page(&drawn)?, ..self.title.head(self.process) };
        Ok(head.page(summary::banner(self), sections))
    }

    fn first_page(&self, drawn: &DrawnFlanks) -> Result<FirstPage, ChartError> {
        Ok(FirstPage {
            scope: self.verdict.scope_in_short(),
            picture: first_picture(drawn)?,
            values: first_page::values(self),
            sheets: self.sheets.clone(),
        })
    }

    fn warnings(&self) -> Vec<Block> {
        if self.warnings.is_empty() {
            return Vec::new();
        }
        let warning = |w: &Remark| Warning { text: w.text.clone(), way_out: w.way_out.clone() };
        vec![Block::Warnings(self.warnings.iter().map(warning).collect())]
    }

    fn data_sheets(&self) -> Vec<Block> {
        let sheets = [("Gear", &self.gear), ("Worm", &self.worm), ("Dresser", &self.dresser)];
        let tables: Vec<Table> = sheets
            .into_iter()
            .filter(|(_, quantities)| !quantities.is_empty())
            .map(|(caption, quantities)| Table::of_quantities(caption, quantities))
            .collect();
        if tables.is_empty() { Vec::new() } else { vec![Block::Tables(tables)] }
    }

    fn settings(&self) -> Result<Vec<Block>, ChartError> {
        let mut blocks = Vec::new();
        if !self.settings.is_empty() {
            blocks.push(Block::Table(Table::of_quantities("", &self.settings)));
        }
        if let Some(chart) = self.occupation {
            let caption = "Which part of the tool's width each area takes; areas a pitch apart share no line of the tool.";
            let svg = worm_occupation_chart(chart)?;
            blocks.push(Block::Figure(Figure::new("areas-over-the-width-of-the-tool", svg, caption)));
        }
        Ok(blocks)
    }

    /// The dresser in the thread space.
    fn room(&self) -> Result<Vec<Block>, ChartError> {
        let caption = "What the dresser sweeps in a plane through the worm axis, at the worm position with the least clearance of the \
            flank that is not dressed.";
        let figure = |chart: &DressingSectionChart| {
            Ok(Block::Figure(Figure::new(kebab(&chart.title), dressing_section_chart(chart)?, caption)))
        };
        self.sections.iter().map(figure).collect()
    }

    fn files(&self) -> Vec<Block> {
        if self.files.is_empty() {
            return Vec::new();
        }
        vec![Block::Tables(vec![Table {
            caption: "Files written".to_owned(),
            columns: vec![Column::text("File"), Column::text("Content")],
            rows: self
                .files
                .iter()
                .map(|(path, content)| vec![path.clone(), (*content).to_owned()])
                .collect(),
            note: String::new(),
        }])]
    }
}
