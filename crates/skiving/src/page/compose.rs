//! Arranges the page of a skiving tool's measurement.

use super::{SkivingReport, conventional, poses};
use report::charts::ChartError;
use report::data::{Block, PlanReport, Section, Table};
use report::head::scope_blocks;

impl SkivingReport {
    /// The page; sections without data are left out.
    ///
    /// # Errors
    /// A number that is not finite, or lists of different length.
    pub fn to_page(&self) -> Result<PlanReport, ChartError> {
        let mut sections = Vec::new();
        let mut add = |id: &str, title: &str, blocks: Vec<Block>| {
            if !blocks.is_empty() {
                sections.push(Section::new(id, title, blocks));
            }
        };
        add("scope-of-the-verdict", "Scope of the verdict", scope_blocks(&self.verdict));
        if let Some(measured) = &self.measured {
            add("measured-deviations", "Measured deviations", measured.blocks()?);
        }
        let mut angles = Vec::new();
        for view in &self.angles {
            angles.extend(view.blocks()?);
        }
        add("angles-of-the-edges", "Angles of the edges", angles);
        if let Some(strip) = &self.strip {
            add("signal-over-one-turn", "Signal over one turn", strip.blocks()?);
        }
        if let Some(pitch) = &self.pitch {
            add("concentricity", "Concentricity", pitch.concentricity()?);
            add("pitch", "Pitch", pitch.pitch()?);
        }
        add("tooth-and-contact-points", "Tooth and contact points", self.tooth_blocks()?);
        if !self.poses.is_empty() {
            add("measuring-poses", "Measuring poses", poses::blocks(&self.poses)?);
        }
        if let Some(profile) = &self.profile {
            add("profile-of-the-workpiece", "Profile of the workpiece", profile.blocks()?);
        }
        if let Some(corrections) = &self.corrections {
            add("corrections", "Corrections", corrections.blocks()?);
        }
        if !self.conventional.is_empty() {
            add(
                "comparison-with-the-conventional-method",
                "Comparison with the conventional method",
                conventional::blocks(&self.conventional)?,
            );
        }
        if let Some(history) = &self.history {
            add("history", "History", history.blocks()?);
        }
        if let Some(monte_carlo) = &self.monte_carlo {
            add("monte-carlo", "Monte Carlo", monte_carlo.blocks()?);
        }
        if !self.sheets.is_empty() {
            let sheet =
                |sheet: &super::DataSheet| Table::of_quantities(sheet.caption.clone(), &sheet.quantities);
            let tables = self.sheets.iter().map(sheet).collect();
            add(
                "tool-workpiece-and-measurement",
                "Tool, workpiece and measurement",
                vec![Block::Tables(tables)],
            );
        }
        if let Some(programs) = &self.programs {
            add("programs", "Programs", programs.blocks()?);
        }
        Ok(self.head.page(sections))
    }

    fn tooth_blocks(&self) -> Result<Vec<Block>, ChartError> {
        let mut blocks = self.tooth.as_ref().map_or_else(|| Ok(Vec::new()), |tooth| tooth.blocks())?;
        for section in &self.edge_sections {
            blocks.push(section.block()?);
        }
        Ok(blocks)
    }
}
