//! All texts of a page, by what they are: what a table of texts must know, and what it may leave as it is.

use super::charts::Svg;
use super::data::{Block, ColumnKind, Figure, PlanReport, Section, Table};
use super::first_page::Sheet;

/// What a text of a page is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum TextKind {
    /// Heading of a section, a part, a table, a list.
    Heading,
    /// Heading of a column.
    Column,
    /// Label of a fact, name of a quantity.
    Name,
    /// Symbol, unit or code.
    Unit,
    /// Title of a chart, text in it.
    Chart,
    /// Caption of a figure, note of a table.
    Caption,
    /// Words of the banner.
    Banner,
    /// Running text, warnings, cells of tables: sentences with figures, and what a job says.
    Running,
}

/// The texts of a page in their order, without those of the job: title and description.
pub fn texts(page: &PlanReport) -> Vec<(TextKind, &str)> {
    let mut found = Found(vec![
        (TextKind::Banner, page.banner.status.words()),
        (TextKind::Running, page.banner.headline.as_str()),
        (TextKind::Running, page.first_page.scope.as_str()),
        (TextKind::Name, page.title_block.process.as_str()),
    ]);
    for fact in &page.banner.figures {
        found.add(TextKind::Name, &fact.label);
        // A code and a key are the same in every language.
        let kind =
            if matches!(fact.label.as_str(), "Code" | "Key") { TextKind::Unit } else { TextKind::Running };
        found.add(kind, &fact.text);
    }
    page.first_page.picture.iter().for_each(|figure| found.figure(figure));
    page.first_page.values.iter().for_each(|table| found.table(table));
    page.first_page.sheets.iter().for_each(|sheet| found.sheet(sheet));
    page.sections.iter().for_each(|section| found.section(section));
    found.0.retain(|(_, text)| !text.is_empty());
    found.0
}

struct Found<'a>(Vec<(TextKind, &'a str)>);

impl<'a> Found<'a> {
    fn add(&mut self, kind: TextKind, text: &'a str) {
        self.0.push((kind, text));
    }

    fn sheet(&mut self, sheet: &'a Sheet) {
        self.add(TextKind::Heading, &sheet.title);
        for quantity in &sheet.quantities {
            self.add(TextKind::Name, &quantity.name);
            self.add(TextKind::Unit, &quantity.unit);
        }
        sheet.remarks.iter().for_each(|remark| self.add(TextKind::Caption, remark));
    }

    fn section(&mut self, section: &'a Section) {
        self.add(TextKind::Heading, &section.title);
        for block in &section.blocks {
            match block {
                Block::Heading(text) => self.add(TextKind::Heading, text),
                Block::Paragraph(text) => self.add(TextKind::Running, text),
                Block::Table(table) => self.table(table),
                Block::Tables(tables) => tables.iter().for_each(|table| self.table(table)),
                Block::Figure(figure) => self.figure(figure),
                Block::Figures(figures) => figures.iter().for_each(|figure| self.figure(figure)),
                Block::Warnings(warnings) => {
                    for warning in warnings {
                        self.add(TextKind::Running, &warning.text);
                        self.add(TextKind::Running, &warning.way_out);
                    }
                }
            }
        }
    }

    fn table(&mut self, table: &'a Table) {
        self.add(TextKind::Heading, &table.caption);
        for column in &table.columns {
            self.add(TextKind::Column, &column.title);
            self.add(TextKind::Unit, &column.unit);
        }
        for row in &table.rows {
            for (k, cell) in row.iter().enumerate() {
                let column = table.columns.get(k);
                let kind = match column.map(|column| column.kind) {
                    Some(ColumnKind::Link) => continue,
                    _ if column.is_some_and(|column| column.title == Table::QUANTITY) => TextKind::Name,
                    _ => TextKind::Running,
                };
                self.add(kind, cell);
            }
        }
        self.add(TextKind::Caption, &table.note);
    }

    fn figure(&mut self, figure: &'a Figure) {
        let svg: &Svg = &figure.svg;
        self.add(TextKind::Chart, svg.title());
        svg.texts().for_each(|text| self.add(TextKind::Chart, text));
        self.add(TextKind::Caption, &figure.caption);
    }
}
