//! Writes a [`PlanReport`] as one HTML file: style and charts inline, no script, no network. Knows no process.

use std::fmt::Write;

use super::charts::{escape, indices};
use super::data::{Banner, Block, ColumnKind, Fact, Figure, PlanReport, Section, Stamp, Table, Warning};
use super::ids::Given;
use super::placed::FIGURE;
use super::typeset::typeset;
use verdict::Status;

const STYLE: &str = include_str!("style.css");

/// The page. All texts of the report are escaped; the same report gives the same bytes.
pub fn render(report: &PlanReport) -> String {
    let mut page = String::with_capacity(1 << 20);
    let title = escape(&report.title);
    let _ = write!(
        page,
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title} – flankwright</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n\
         <header>\n<p class=\"product\">flankwright report</p>\n<h1>{title}</h1>\n"
    );
    if let Some(subtitle) = &report.subtitle {
        let _ = writeln!(page, "<p class=\"subtitle\">{}</p>", escape(subtitle));
    }
    facts(&mut page, "facts", &report.facts);
    page.push_str("</header>\n");
    banner(&mut page, &report.banner);
    let (mut sections, mut charts) = (Given::default(), Given::default());
    for section in report.sections.iter().filter(|section| !section.blocks.is_empty()) {
        let id = sections.once(&section.id);
        write_section(&mut page, &id, section, &mut charts);
    }
    page.push_str("</main>\n</body>\n</html>\n");
    page
}

fn facts(page: &mut String, class: &str, facts: &[Fact]) {
    if facts.is_empty() {
        return;
    }
    let _ = writeln!(page, "<dl class=\"{class}\">");
    for Fact { label, text } in facts {
        let _ = writeln!(page, "<div><dt>{}</dt><dd>{}</dd></div>", typeset(label), typeset(text));
    }
    page.push_str("</dl>\n");
}

fn banner(page: &mut String, banner: &Banner) {
    let (class, sign) = match banner.status {
        Stamp::Judged(Status::Met) => ("met", "✓"),
        Stamp::Judged(Status::Missed) => ("missed", "≠"),
        Stamp::Judged(Status::NotJudged) => ("not-judged", "?"),
        Stamp::Study => ("not-judged", "–"),
        Stamp::NotProducible => ("not-producible", "✕"),
    };
    let _ = writeln!(
        page,
        "<section class=\"banner {class}\">\n<div class=\"word\"><span aria-hidden=\"true\">{sign}</span>{}</div>\n\
         <div class=\"what\">\n<p>{}</p>",
        banner.status.words(),
        typeset(&banner.headline)
    );
    facts(page, "figures", &banner.figures);
    page.push_str("</div>\n</section>\n");
}

fn write_section(page: &mut String, id: &str, section: &Section, charts: &mut Given) {
    let _ = writeln!(page, "<section id=\"{}\">\n<h2>{}</h2>", escape(id), escape(&section.title));
    let mut part = "";
    for block in &section.blocks {
        let figure = |page: &mut String, charts: &mut Given, figure: &Figure| {
            let title = figure.svg.title();
            let title = if part.is_empty() { title.to_owned() } else { format!("{part}: {title}") };
            let id = charts.once(&figure.id);
            write_figure(page, figure, [&id, &title, &section.title]);
        };
        match block {
            Block::Heading(text) => {
                part = text;
                let _ = writeln!(page, "<h3>{}</h3>", typeset(text));
            }
            Block::Paragraph(text) => {
                let _ = writeln!(page, "<p>{}</p>", typeset(text));
            }
            Block::Table(table) => write_table(page, table),
            Block::Tables(tables) => {
                page.push_str("<div class=\"beside\">\n");
                tables.iter().for_each(|table| write_table(page, table));
                page.push_str("</div>\n");
            }
            Block::Figure(one) => figure(page, charts, one),
            Block::Figures(figures) => {
                page.push_str("<div class=\"charts\">\n");
                figures.iter().for_each(|one| figure(page, charts, one));
                page.push_str("</div>\n");
            }
            Block::Warnings(warnings) => write_warnings(page, warnings),
        }
    }
    page.push_str("</section>\n");
}

fn write_table(page: &mut String, table: &Table) {
    page.push_str("<div class=\"table\">\n<table>\n");
    if !table.caption.is_empty() {
        let _ = writeln!(page, "<caption>{}</caption>", typeset(&table.caption));
    }
    page.push_str("<thead><tr>");
    for column in &table.columns {
        let unit = if column.unit.is_empty() {
            String::new()
        } else {
            format!("<span class=\"unit\">{}</span>", escape(&column.unit))
        };
        let _ = write!(
            page,
            "<th scope=\"col\"{}>{}{unit}</th>",
            class(column.kind),
            with_indices(&column.title)
        );
    }
    page.push_str("</tr></thead>\n<tbody>\n");
    for row in &table.rows {
        page.push_str("<tr>");
        for k in 0..row.len().max(table.columns.len()) {
            let kind = table.columns.get(k).map_or(ColumnKind::Text, |column| column.kind);
            let text = row.get(k).map_or("", String::as_str);
            let text = match kind {
                ColumnKind::Symbols => with_indices(text),
                ColumnKind::Link if !text.is_empty() => {
                    format!("<a href=\"{}\">{}</a>", reference(text), escape(text))
                }
                _ => typeset(text),
            };
            let _ = write!(page, "<td{}>{text}</td>", class(kind));
        }
        page.push_str("</tr>\n");
    }
    page.push_str("</tbody>\n</table>\n");
    if !table.note.is_empty() {
        let _ = writeln!(page, "<p class=\"note\">{}</p>", typeset(&table.note));
    }
    page.push_str("</div>\n");
}

fn class(kind: ColumnKind) -> &'static str {
    match kind {
        ColumnKind::Text | ColumnKind::Symbols | ColumnKind::Link => "",
        ColumnKind::Name => " class=\"name\"",
        ColumnKind::Number => " class=\"right\"",
    }
}

/// A relative path as a reference: everything but plain letters, digits and a few marks as bytes of its UTF-8.
fn reference(path: &str) -> String {
    let mut text = String::with_capacity(path.len());
    for byte in path.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte) {
            text.push(char::from(byte));
        } else {
            let _ = write!(text, "%{byte:02X}");
        }
    }
    // A colon before the first slash would be a scheme; it is escaped above.
    text
}

/// Escaped text, indices of symbols as `<sub>`.
fn with_indices(text: &str) -> String {
    indices(text)
        .into_iter()
        .map(|(piece, below)| if below { format!("<sub>{}</sub>", escape(&piece)) } else { escape(&piece) })
        .collect()
}

/// A figure with what [`charts_of_page`](crate::charts_of_page) reads: id, title and section.
fn write_figure(page: &mut String, figure: &Figure, names: [&str; 3]) {
    let [id, title, section] = names.map(escape);
    let _ =
        writeln!(page, "{FIGURE}{id}\" data-title=\"{title}\" data-section=\"{section}\">\n{}", figure.svg);
    if !figure.caption.is_empty() {
        let _ = writeln!(page, "<figcaption>{}</figcaption>", typeset(&figure.caption));
    }
    page.push_str("</figure>\n");
}

fn write_warnings(page: &mut String, warnings: &[Warning]) {
    page.push_str("<ul class=\"warnings\">\n");
    for Warning { text, way_out } in warnings {
        let _ = write!(page, "<li><p>{}</p>", typeset(text));
        if !way_out.is_empty() {
            let _ = write!(page, "<p class=\"way-out\">Remedy: {}</p>", typeset(way_out));
        }
        page.push_str("</li>\n");
    }
    page.push_str("</ul>\n");
}
