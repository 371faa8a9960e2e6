//! Writes a figure with what [`charts_of_page`](crate::charts_of_page) reads: id, title and section.

use super::Writer;
use crate::charts::escape;
use crate::data::Figure;
use crate::language::Language;
use crate::placed::FIGURE;
use std::fmt::Write;

impl Writer {
    /// A figure below the heading `part` ("" for none) of a section.
    pub(super) fn figure(&mut self, figure: &Figure, part: &str, section: &str) {
        let id = escape(&self.charts.once(&figure.id));
        let mut title = self.set.label(figure.svg.title());
        if !part.is_empty() {
            title = format!("{}: {title}", self.set.label(part));
        }
        let section = self.set.label(section);
        let language = self.set.0;
        let said;
        let svg = match language {
            Language::English => &figure.svg,
            Language::German => {
                said = figure.svg.said(|text| language.say(text).into_owned());
                &said
            }
        };
        let _ =
            writeln!(self.page, "{FIGURE}{id}\" data-title=\"{title}\" data-section=\"{section}\">\n{svg}");
        if !figure.caption.is_empty() {
            let _ = writeln!(self.page, "<figcaption>{}</figcaption>", self.set.running(&figure.caption));
        }
        self.page.push_str("</figure>\n");
    }
}
