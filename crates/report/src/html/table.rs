//! Writes tables.

use super::Writer;
use crate::charts::escape;
use crate::data::{ColumnKind, Table};
use std::fmt::Write;

/// A table of so many rows stays on one printed page.
const SHORT: usize = 14;

/// A table of so many columns is set smaller on paper.
const WIDE: usize = 8;

impl Writer {
    pub(super) fn table(&mut self, table: &Table) {
        let short = if table.rows.len() <= SHORT { " short" } else { "" };
        let wide = if table.columns.len() >= WIDE { " wide" } else { "" };
        let _ = writeln!(self.page, "<div class=\"table{short}{wide}\">\n<table>");
        if !table.caption.is_empty() {
            let _ = writeln!(self.page, "<caption>{}</caption>", self.set.running(&table.caption));
        }
        self.page.push_str("<thead><tr>");
        for column in &table.columns {
            let unit = if column.unit.is_empty() {
                String::new()
            } else {
                format!("<span class=\"unit\">{}</span>", self.set.unit(&column.unit))
            };
            let title = self.set.symbols(&column.title);
            let _ = write!(self.page, "<th scope=\"col\"{}>{title}{unit}</th>", class(column.kind));
        }
        self.page.push_str("</tr></thead>\n<tbody>\n");
        for row in &table.rows {
            self.page.push_str("<tr>");
            for k in 0..row.len().max(table.columns.len()) {
                let kind = table.columns.get(k).map_or(ColumnKind::Text, |column| column.kind);
                let text = row.get(k).map_or("", String::as_str);
                let text = match kind {
                    ColumnKind::Symbols => self.set.symbols(text),
                    ColumnKind::Link if !text.is_empty() => {
                        format!("<a href=\"{}\">{}</a>", reference(text), escape(text))
                    }
                    _ => self.set.running(text),
                };
                let _ = write!(self.page, "<td{}>{text}</td>", class(kind));
            }
            self.page.push_str("</tr>\n");
        }
        self.page.push_str("</tbody>\n</table>\n");
        if !table.note.is_empty() {
            let _ = writeln!(self.page, "<p class=\"note\">{}</p>", self.set.running(&table.note));
        }
        self.page.push_str("</div>\n");
    }
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
