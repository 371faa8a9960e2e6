//! Writes a [`PlanReport`] as one HTML file: style and charts inline, no script, no network. Knows no process.

mod figure;
mod first_page;
mod margins;
mod table;

use std::fmt::Write;

use super::charts::escape;
use super::data::{Banner, Block, Fact, PlanReport, Section, Stamp, Warning};
use super::ids::Given;
use super::typeset::Setter;
use verdict::Status;

const STYLE: &str = include_str!("style.css");

/// The page. All texts of the report are escaped; the same report gives the same bytes.
pub fn render(report: &PlanReport) -> String {
    let mut writer = Writer {
        page: String::with_capacity(1 << 20),
        set: Setter(report.language),
        charts: Given::default(),
    };
    writer.head(report);
    writer.first_page(report);
    let mut ids = Given::default();
    let (details, appendix): (Vec<&Section>, Vec<&Section>) = report
        .sections
        .iter()
        .filter(|section| !section.blocks.is_empty())
        .partition(|section| !section.appendix);
    for section in details {
        writer.section(&ids.once(&section.id), section);
    }
    if !appendix.is_empty() {
        let title = writer.set.label("Appendix");
        let _ = writeln!(writer.page, "<p class=\"appendix\" id=\"{}\">{title}</p>", ids.once("appendix"));
    }
    for section in appendix {
        writer.section(&ids.once(&section.id), section);
    }
    writer.page.push_str("</main>\n</body>\n</html>\n");
    writer.page
}

/// A page in the making.
struct Writer {
    page: String,
    set: Setter,
    /// Ids of its charts.
    charts: Given,
}

impl Writer {
    fn head(&mut self, report: &PlanReport) {
        let title = escape(&report.title);
        let margins = margins::of(report);
        let _ = write!(
            self.page,
            "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>{title} – flankwright</title>\n<style>\n{STYLE}{margins}</style>\n</head>\n<body>\n<main>\n",
            report.language.code(),
        );
    }

    fn banner(&mut self, banner: &Banner, scope: &str) {
        let (class, sign) = match banner.status {
            Stamp::Judged(Status::Met) => ("met", "✓"),
            Stamp::Judged(Status::Missed) => ("missed", "≠"),
            Stamp::Judged(Status::NotJudged) => ("not-judged", "?"),
            Stamp::Study => ("not-judged", "–"),
            Stamp::NotProducible => ("not-producible", "✕"),
        };
        let _ = writeln!(
            self.page,
            "<section class=\"banner {class}\">\n<div class=\"word\"><span aria-hidden=\"true\">{sign}</span>{}</div>\n\
             <div class=\"what\">\n<p>{}</p>",
            self.set.label(banner.status.words()),
            self.set.running(&banner.headline)
        );
        self.facts("figures", &banner.figures);
        if !scope.is_empty() {
            let _ = writeln!(self.page, "<p class=\"scope\">{}</p>", self.set.running(scope));
        }
        self.page.push_str("</div>\n</section>\n");
    }

    fn facts(&mut self, class: &str, facts: &[Fact]) {
        if facts.is_empty() {
            return;
        }
        let _ = writeln!(self.page, "<dl class=\"{class}\">");
        for Fact { label, text } in facts {
            let (label, text) = (self.set.running(label), self.set.running(text));
            let _ = writeln!(self.page, "<div><dt>{label}</dt><dd>{text}</dd></div>");
        }
        self.page.push_str("</dl>\n");
    }

    fn section(&mut self, id: &str, section: &Section) {
        let _ = writeln!(
            self.page,
            "<section id=\"{}\">\n<h2>{}</h2>",
            escape(id),
            self.set.label(&section.title)
        );
        let mut part = "";
        for block in &section.blocks {
            match block {
                Block::Heading(text) => {
                    part = text;
                    let _ = writeln!(self.page, "<h3>{}</h3>", self.set.running(text));
                }
                Block::Paragraph(text) => {
                    let _ = writeln!(self.page, "<p>{}</p>", self.set.running(text));
                }
                Block::Table(table) => self.table(table),
                Block::Tables(tables) => {
                    self.page.push_str("<div class=\"beside\">\n");
                    tables.iter().for_each(|table| self.table(table));
                    self.page.push_str("</div>\n");
                }
                Block::Figure(one) => self.figure(one, part, &section.title),
                Block::Figures(figures) => {
                    self.page.push_str("<div class=\"charts\">\n");
                    figures.iter().for_each(|one| self.figure(one, part, &section.title));
                    self.page.push_str("</div>\n");
                }
                Block::Warnings(warnings) => self.warnings(warnings),
            }
        }
        self.page.push_str("</section>\n");
    }

    fn warnings(&mut self, warnings: &[Warning]) {
        self.page.push_str("<ul class=\"warnings\">\n");
        for Warning { text, way_out } in warnings {
            let _ = write!(self.page, "<li><p>{}</p>", self.set.running(text));
            if !way_out.is_empty() {
                let (remedy, text) = (self.set.label("Remedy"), self.set.running(way_out));
                let _ = write!(self.page, "<p class=\"way-out\">{remedy}: {text}</p>");
            }
            self.page.push_str("</li>\n");
        }
        self.page.push_str("</ul>\n");
    }
}
