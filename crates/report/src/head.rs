//! What the pages of all jobs begin and end with: the answer in one sentence, its figures, warnings, files.

use verdict::Verdict;

use super::data::{Banner, Block, Column, Fact, PlanReport, Section, Stamp, Table, Warning};
use super::page_head::PageHead;

/// The job and its answer.
#[derive(Clone, Debug, PartialEq)]
pub struct ReportHead {
    /// Name, language, title block, first page.
    pub head: PageHead,
    /// How it ended.
    pub status: Stamp,
    /// The answer in one sentence.
    pub headline: String,
    /// What to do if it is missed; empty for nothing.
    pub way_out: String,
    /// Figures of the banner: label and text.
    pub figures: Vec<(String, String)>,
    /// Warnings.
    pub warnings: Vec<Warning>,
    /// Files: path and content.
    pub files: Vec<(String, String)>,
}

impl ReportHead {
    /// The page: warnings, the sections of the process, files.
    pub fn page(&self, sections: Vec<Section>) -> PlanReport {
        let headline = if self.way_out.is_empty() {
            self.headline.clone()
        } else {
            format!("{} Remedy: {}.", self.headline, self.way_out)
        };
        let warnings = (!self.warnings.is_empty())
            .then(|| Section::new("warnings", "Warnings", vec![Block::Warnings(self.warnings.clone())]));
        let files = Section::new("files", "Files", vec![Block::Table(self.files_table())]);
        let banner = Banner {
            status: self.status,
            headline,
            figures: self.figures.iter().map(|(label, text)| Fact::new(label, text)).collect(),
        };
        self.head.clone().page(banner, warnings.into_iter().chain(sections).chain([files]).collect())
    }

    fn files_table(&self) -> Table {
        Table {
            caption: String::new(),
            columns: vec![Column::text("File"), Column::text("Content")],
            rows: self.files.iter().map(|(path, content)| vec![path.clone(), content.clone()]).collect(),
            note: String::new(),
        }
    }
}

/// What a verdict judged and what it did not, as a table; empty for a verdict without items.
pub fn scope_blocks(verdict: &Verdict) -> Vec<Block> {
    let judged = verdict.judged().iter().map(|one| (&one.item, one.status.words(), &one.detail));
    let not_judged = verdict.not_judged().iter().map(|one| {
        let how = if one.asked { "not judged, asked for" } else { "not judged" };
        (&one.item, how, &one.why)
    });
    let row = |(item, status, detail): (&String, &str, &String)| {
        vec![item.clone(), status.to_owned(), detail.replace(" um", " µm")]
    };
    let rows: Vec<Vec<String>> = judged.chain(not_judged).map(row).collect();
    if rows.is_empty() {
        return Vec::new();
    }
    let columns = vec![Column::text("Item"), Column::name("Verdict"), Column::text("Figure or reason")];
    vec![Block::Table(Table { caption: String::new(), columns, rows, note: String::new() })]
}
