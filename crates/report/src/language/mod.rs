//! The language of a page. Pages are composed in English; fixed texts, and sentences with holes for their numbers, are set in the
//! language where the page is written, by one table of texts.

mod decimal;
mod german;
mod sentences;

use std::borrow::Cow;

/// The language of a page.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// English: texts as they are composed.
    #[default]
    English,
    /// German.
    German,
}

impl Language {
    /// Its code in HTML (BCP 47).
    pub fn code(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::German => "de",
        }
    }

    /// A text in this language. What no table knows stays English; numbers get the decimal sign of the language.
    pub fn say(self, text: &str) -> Cow<'_, str> {
        match self {
            Self::English => Cow::Borrowed(text),
            Self::German => Cow::Owned(decimal::with_commas(
                &sentences::german(text).map_or_else(|| text.to_owned(), |said| said.text),
            )),
        }
    }

    /// What stays English of a text, for the test that finds missing lines of the tables: all of it, or what stands in the holes of its
    /// sentence, where that has words.
    pub fn leaves(self, text: &str) -> Vec<String> {
        match self {
            Self::English => Vec::new(),
            Self::German if !sentences::has_words(text) => Vec::new(),
            Self::German => sentences::german(text).map_or_else(|| vec![text.to_owned()], |said| said.left),
        }
    }
}
