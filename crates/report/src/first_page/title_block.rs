//! The title block: of which part, drawing and customer a page is, by whom, when, for which machine and by which process.

use crate::data::Fact;
use serde::Serialize;

/// The title block. What a job does not give has no line.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct TitleBlock {
    /// Number of the part.
    pub part_number: Option<String>,
    /// Number of the drawing.
    pub drawing_number: Option<String>,
    /// Customer.
    pub customer: Option<String>,
    /// Machine: the name in its description.
    pub machine: Option<String>,
    /// Date as the job gives it, `YYYY-MM-DD`.
    pub date: Option<String>,
    /// Author.
    pub author: Option<String>,
    /// Process in words.
    pub process: String,
    /// Version of the program.
    pub version: String,
}

impl TitleBlock {
    /// Of a page that has no job: process and version.
    pub fn of_process(process: impl Into<String>, version: impl Into<String>) -> Self {
        Self { process: process.into(), version: version.into(), ..Self::default() }
    }

    /// Its lines, labels in English.
    pub fn facts(&self) -> Vec<Fact> {
        let given = [
            ("Part number", &self.part_number),
            ("Drawing number", &self.drawing_number),
            ("Customer", &self.customer),
            ("Machine", &self.machine),
            ("Date", &self.date),
            ("Author", &self.author),
        ];
        let given = given.into_iter().filter_map(|(label, text)| Some((label, text.clone()?)));
        let always =
            [("Process", self.process.clone()), ("Version", format!("flankwright {}", self.version))];
        given.chain(always).map(|(label, text)| Fact::new(label, text)).collect()
    }

    /// What names the part on every printed page: its number, else nothing.
    pub fn part(&self) -> Option<&str> {
        self.part_number.as_deref()
    }
}
