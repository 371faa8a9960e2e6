//! What every page begins with: name, language, title block, what stands on the first sheet beside the answer.

use super::data::{Banner, PlanReport, Section};
use super::first_page::{FirstPage, TitleBlock};
use super::language::Language;

/// What a page begins with. A study, which judges no flank, leaves the first page empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PageHead {
    /// Heading of the page, usually the name of the job.
    pub title: String,
    /// One sentence below it, in the words of the job.
    pub description: Option<String>,
    /// Language of the page.
    pub language: Language,
    /// Part, drawing, customer, date, machine, author, process, version.
    pub title_block: TitleBlock,
    /// What stands on the first sheet beside title block and answer.
    pub first_page: FirstPage,
}

impl PageHead {
    /// The page with its answer and its sections; those without blocks are left out.
    pub fn page(self, banner: Banner, sections: Vec<Section>) -> PlanReport {
        PlanReport {
            title: self.title,
            subtitle: self.description,
            language: self.language,
            title_block: self.title_block,
            banner,
            first_page: self.first_page,
            sections: sections.into_iter().filter(|section| !section.blocks.is_empty()).collect(),
        }
    }
}
