//! The language of pages, where the command says it.

use clap::{Args, ValueEnum};
use flankwright::exchange::job::Language;

/// The language of pages.
#[derive(Args, Clone, Copy, Debug)]
pub struct LanguageArguments {
    /// Language of report, sheets and series; without it that of the job (output.language), else English
    #[arg(long, value_name = "LANGUAGE")]
    language: Option<PageLanguage>,
}

#[derive(ValueEnum, Clone, Copy, Debug)]
enum PageLanguage {
    /// English
    En,
    /// German
    De,
}

impl LanguageArguments {
    /// What the command says.
    pub fn given(self) -> Option<Language> {
        self.language.map(|language| match language {
            PageLanguage::En => Language::En,
            PageLanguage::De => Language::De,
        })
    }
}
