//! What a page takes of a job beside its results: name, title block, language.

use job::machine::LoadedMachine;
use job::tables::{JobInfo, Language};
use report::{FirstPage, PageHead, TitleBlock};

/// The job of a page.
#[derive(Clone, Copy, Debug)]
pub struct JobTitle<'a> {
    /// Its table `[job]`.
    pub info: &'a JobInfo,
    machine: Option<&'a str>,
    language: Language,
}

impl<'a> JobTitle<'a> {
    /// Of a job with its language.
    pub fn new(info: &'a JobInfo, language: Language) -> Self {
        Self { info, machine: None, language }
    }

    /// On the machine that the job names by its description.
    pub fn on(self, machine: Option<&'a LoadedMachine>) -> Self {
        Self { machine: machine.map(|machine| machine.file.name.as_str()), ..self }
    }

    /// The title block for a process in words.
    pub fn title_block(&self, process: &str) -> TitleBlock {
        let JobInfo { part_number, drawing_number, customer, machine_name, date, author, .. } = self.info;
        let described = self.machine.map(|name| name.replace('_', " "));
        TitleBlock {
            part_number: part_number.clone(),
            drawing_number: drawing_number.clone(),
            customer: customer.clone(),
            machine: described.or_else(|| machine_name.clone()),
            date: date.clone(),
            author: author.clone(),
            process: process.to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
        }
    }

    /// The head of a page of this job; the process, or the kind of study, in words.
    pub fn head(&self, process: &str) -> PageHead {
        PageHead {
            title: self.info.name.clone(),
            description: self.info.description.clone(),
            language: self.language(),
            title_block: self.title_block(process),
            first_page: FirstPage::default(),
        }
    }

    /// Language of the page.
    pub fn language(&self) -> report::Language {
        page_language(self.language)
    }
}

/// The language of a page, for what a job or a command says.
pub fn page_language(language: Language) -> report::Language {
    match language {
        Language::En => report::Language::English,
        Language::De => report::Language::German,
    }
}
