//! How the page of a job begins and ends, from its result.

use super::job_title::JobTitle;
use report::{FirstPage, PageHead, ReportHead, Warning};
use verdict::{Remark, Status};

/// What a job came to.
pub struct Answer<'a> {
    /// The process in words.
    pub process: &'static str,
    /// Whether the target is met.
    pub status: Status,
    /// Why it is not.
    pub reason: Option<&'a Remark>,
    /// What else is to be known.
    pub warnings: &'a [Remark],
    /// The answer in one sentence.
    pub headline: String,
    /// Figures of the banner: label and text.
    pub figures: Vec<(String, String)>,
    /// What else stands on the first page; its scope is the verdict's.
    pub first_page: FirstPage,
}

/// The head of a job's page.
pub fn report_head(job: JobTitle<'_>, answer: Answer<'_>, files: &[(String, &'static str)]) -> ReportHead {
    let warning = |w: &Remark| Warning { text: w.text.clone(), way_out: w.way_out.clone() };
    ReportHead {
        head: PageHead { first_page: answer.first_page, ..job.head(answer.process) },
        status: answer.status.into(),
        headline: answer.headline,
        way_out: answer.reason.map_or_else(String::new, |reason| reason.way_out.clone()),
        figures: answer.figures,
        warnings: answer.warnings.iter().map(warning).collect(),
        files: files.iter().map(|(path, content)| (path.clone(), (*content).into())).collect(),
    }
}

/// A remark as the sentence of a headline.
pub fn sentence(remark: &Remark) -> String {
    let mut letters = remark.text.chars();
    let first = letters.next().map(|letter| letter.to_uppercase().to_string()).unwrap_or_default();
    format!("{first}{}.", letters.as_str().trim_end_matches('.').replace(" um", " µm"))
}
