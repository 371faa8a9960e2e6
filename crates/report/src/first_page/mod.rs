//! The first page: what a process engineer hands on, on one sheet of A4. Title block and verdict stand in every report; picture,
//! values of the drawing, settings, times, tools and tooth thickness where a process gives them.

mod sheet;
mod title_block;

pub use sheet::Sheet;
pub use title_block::TitleBlock;

use crate::data::{Block, Figure, Section, Table};
use serde::Serialize;

/// What stands on the first page beside title block and verdict.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct FirstPage {
    /// What the verdict covers, in one or two sentences; empty for none.
    pub scope: String,
    /// The picture that decides: both flanks where there are flanks.
    pub picture: Option<Figure>,
    /// Values that the drawing asks for, with tolerances and as made.
    pub values: Option<Table>,
    /// Settings, times, tools, tooth thickness: small lists, which stand beside each other.
    pub sheets: Vec<Sheet>,
}

impl FirstPage {
    /// The first picture of the section of this id, as the one that decides; without its caption, which stands in the details.
    pub fn picture_of(sections: &[Section], id: &str) -> Option<Figure> {
        let blocks = &sections.iter().find(|section| section.id == id)?.blocks;
        let figure = blocks.iter().find_map(|block| match block {
            Block::Figure(figure) => Some(figure),
            Block::Figures(figures) => figures.first(),
            _ => None,
        })?;
        Some(Figure::new(format!("first-page-{}", figure.id), figure.svg.clone(), ""))
    }

    /// Whether there is nothing but title block and verdict, so that the details begin below them.
    pub fn is_empty(&self) -> bool {
        self.picture.is_none() && self.values.is_none() && self.sheets.is_empty()
    }
}
