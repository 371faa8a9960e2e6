//! Writes the first page: title block, verdict, picture, values of the drawing, lists.

use super::Writer;
use crate::charts::escape;
use crate::data::PlanReport;
use crate::first_page::Sheet;
use crate::typeset::unit;
use std::fmt::Write;

/// A description of so many letters stands on the first page; of a longer one its beginning.
const LONGEST_DESCRIPTION: usize = 220;

impl Writer {
    pub(super) fn first_page(&mut self, report: &PlanReport) {
        let first = &report.first_page;
        let class = if first.is_empty() { "first" } else { "first sheet" };
        let _ = writeln!(
            self.page,
            "<div class=\"{class}\">\n<header>\n<p class=\"product\">{}</p>\n<h1>{}</h1>",
            self.set.label("flankwright report"),
            escape(&report.title)
        );
        if let Some(description) = &report.subtitle {
            let _ = writeln!(self.page, "<p class=\"subtitle\">{}</p>", escape(&beginning(description)));
        }
        self.page.push_str("<dl class=\"title-block\">\n");
        for fact in report.title_block.facts() {
            let text = if fact.label == "Process" { self.set.label(&fact.text) } else { escape(&fact.text) };
            let _ = writeln!(self.page, "<div><dt>{}</dt><dd>{text}</dd></div>", self.set.label(&fact.label));
        }
        self.page.push_str("</dl>\n</header>\n");
        self.banner(&report.banner, &first.scope);
        if let Some(picture) = &first.picture {
            self.figure(picture, "", "First page");
        }
        if let Some(values) = &first.values {
            self.table(values);
        }
        if !first.sheets.is_empty() {
            self.page.push_str("<div class=\"lists\">\n");
            first.sheets.iter().filter(|sheet| !sheet.is_empty()).for_each(|sheet| self.list(sheet));
            self.page.push_str("</div>\n");
        }
        self.page.push_str("</div>\n");
    }

    fn list(&mut self, sheet: &Sheet) {
        let _ = writeln!(self.page, "<section class=\"list\">\n<h3>{}</h3>", self.set.label(&sheet.title));
        if !sheet.quantities.is_empty() {
            self.page.push_str("<table>\n");
            for quantity in &sheet.quantities {
                let symbol = match quantity.symbol.as_str() {
                    "" => String::new(),
                    symbol => format!(" <i>{}</i>", self.set.symbols(symbol)),
                };
                let value = quantity.value_text();
                let unit = unit(&quantity.unit);
                let value = match &*unit {
                    "" => value,
                    "°" => format!("{value}°"),
                    unit => format!("{value} {unit}"),
                };
                let _ = writeln!(
                    self.page,
                    "<tr><th scope=\"row\">{}{symbol}</th><td>{}</td></tr>",
                    self.set.running(&quantity.name),
                    self.set.running(&value)
                );
            }
            self.page.push_str("</table>\n");
        }
        for remark in &sheet.remarks {
            let _ = writeln!(self.page, "<p class=\"note\">{}</p>", self.set.running(remark));
        }
        self.page.push_str("</section>\n");
    }
}

/// What fits on the page of a description.
fn beginning(text: &str) -> String {
    if text.chars().count() <= LONGEST_DESCRIPTION {
        return text.to_owned();
    }
    let cut: String = text.chars().take(LONGEST_DESCRIPTION).collect();
    let words = cut.rsplit_once(' ').map_or(cut.as_str(), |(words, _)| words);
    format!("{words} …")
}
