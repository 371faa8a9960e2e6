//! A report page as data: a banner and an ordered list of sections. Every process fills the same structure, so this
//! file must not know any process.

use serde::Serialize;

use super::charts::{Svg, format_fixed, format_significant};
use super::first_page::{FirstPage, TitleBlock};
use super::language::Language;
use super::typeset::unit;
use verdict::Status;

/// A whole report.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanReport {
    /// Heading of the page, usually the name of the job.
    pub title: String,
    /// One sentence below it, usually the job's description.
    pub subtitle: Option<String>,
    /// Language of the page; all texts are composed in English.
    pub language: Language,
    /// Part, drawing, customer, date, machine, author, process, version.
    pub title_block: TitleBlock,
    /// The answer in one line.
    pub banner: Banner,
    /// What stands with them on the first sheet.
    pub first_page: FirstPage,
    /// Everything else, in reading order, those of the appendix behind the others. A section without blocks is not printed.
    pub sections: Vec<Section>,
}

impl PlanReport {
    /// Puts sections before the one with this id; at the end if there is none.
    pub fn insert_before(&mut self, id: &str, sections: Vec<Section>) {
        let end = self.sections.len();
        let at = self.sections.iter().position(|section| section.id == id).unwrap_or(end);
        self.sections.splice(at..at, sections);
    }
}

/// A label and its text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Fact {
    /// What it is.
    pub label: String,
    /// What it says.
    pub text: String,
}

impl Fact {
    /// Pairs a label with its text.
    pub fn new(label: impl Into<String>, text: impl Into<String>) -> Self {
        Self { label: label.into(), text: text.into() }
    }
}

/// The stamp of a page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Stamp {
    /// The status of a verdict.
    Judged(Status),
    /// A comparison that judges no target.
    Study,
    /// These bodies can't make it.
    NotProducible,
}

impl From<Status> for Stamp {
    fn from(status: Status) -> Self {
        Self::Judged(status)
    }
}

impl Stamp {
    /// The word on the banner.
    pub fn words(self) -> &'static str {
        match self {
            Self::Judged(status) => status.words(),
            Self::Study => "study",
            Self::NotProducible => "not producible",
        }
    }
}

/// The answer to the job.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Banner {
    /// How it ended.
    pub status: Stamp,
    /// Why, in one sentence.
    pub headline: String,
    /// The figures that decide.
    pub figures: Vec<Fact>,
}

/// A part of the page with its own heading.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Section {
    /// By which programs find it.
    pub id: String,
    /// Heading.
    pub title: String,
    /// Content in reading order.
    pub blocks: Vec<Block>,
    /// Whether it stands in the appendix: how values were found, not what they are.
    pub appendix: bool,
}

impl Section {
    /// A section of the given blocks.
    pub fn new(id: impl Into<String>, title: impl Into<String>, blocks: Vec<Block>) -> Self {
        Self { id: id.into(), title: title.into(), blocks, appendix: false }
    }

    /// The same in the appendix.
    pub fn in_appendix(self) -> Self {
        Self { appendix: true, ..self }
    }
}

/// A piece of a section.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Block {
    /// Heading of a part of the section.
    Heading(String),
    /// Running text.
    Paragraph(String),
    /// A table.
    Table(Table),
    /// Small tables that may stand beside each other.
    Tables(Vec<Table>),
    /// A chart with its caption.
    Figure(Figure),
    /// Small charts, two beside each other.
    Figures(Vec<Figure>),
    /// Things to know before the job runs on a machine.
    Warnings(Vec<Warning>),
}

/// A chart and its caption.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Figure {
    /// By which programs find it; a second one of the same id on a page gets a number.
    pub id: String,
    /// The chart.
    pub svg: Svg,
    /// What to see in it; empty for none.
    pub caption: String,
}

impl Figure {
    /// A chart with its caption ("" for none).
    pub fn new(id: impl Into<String>, svg: Svg, caption: impl Into<String>) -> Self {
        Self { id: id.into(), svg, caption: caption.into() }
    }
}

/// A table of text cells, numbers already formatted.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Table {
    /// Heading; empty for none.
    pub caption: String,
    /// Columns from left to right.
    pub columns: Vec<Column>,
    /// Rows; missing cells stay empty, surplus cells are printed without a heading.
    pub rows: Vec<Vec<String>>,
    /// Remark below; empty for none.
    pub note: String,
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Column {
    /// Heading.
    pub title: String,
    /// Unit below the heading; empty for none.
    pub unit: String,
    /// What its cells hold.
    pub kind: ColumnKind,
}

impl Column {
    /// A column of words, aligned left.
    pub fn text(title: impl Into<String>) -> Self {
        Self { title: title.into(), unit: String::new(), kind: ColumnKind::Text }
    }

    /// A column of names that stay on one line.
    pub fn name(title: impl Into<String>) -> Self {
        Self { title: title.into(), unit: String::new(), kind: ColumnKind::Name }
    }

    /// A column of words with symbols: `C_β` is set with an index.
    pub fn symbols(title: impl Into<String>) -> Self {
        Self { title: title.into(), unit: String::new(), kind: ColumnKind::Symbols }
    }

    /// A column of numbers, aligned right.
    pub fn number(title: impl Into<String>, unit: impl Into<String>) -> Self {
        Self { title: title.into(), unit: unit.into(), kind: ColumnKind::Number }
    }
}

/// What the cells of a column hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ColumnKind {
    /// Words, aligned left.
    Text,
    /// Names, aligned left and never broken.
    Name,
    /// Words with symbols whose `_` sets an index, aligned left.
    Symbols,
    /// Numbers, aligned right.
    Number,
    /// Paths of files beside the page, as links; empty cells stay empty.
    Link,
}

/// Something to know, and what helps.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Warning {
    /// What is the matter, with its numbers.
    pub text: String,
    /// What would help; empty if there is nothing to do.
    pub way_out: String,
}

/// A named value with its symbol and unit, for data sheets.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Quantity {
    /// Name in words.
    pub name: String,
    /// Symbol; empty for none.
    pub symbol: String,
    /// The value.
    pub value: QuantityValue,
    /// Unit; empty for none.
    pub unit: String,
}

/// The value of a [`Quantity`].
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum QuantityValue {
    /// A number, printed with up to six significant digits.
    Number(f64),
    /// A count.
    Count(i64),
    /// Words.
    Text(String),
    /// One number per flank.
    PerFlank {
        /// Left flank.
        left: f64,
        /// Right flank.
        right: f64,
    },
}

impl Quantity {
    /// A number with symbol and unit ("" for none).
    pub fn number(name: &str, symbol: &str, value: f64, unit: &str) -> Self {
        Self::new(name, symbol, QuantityValue::Number(value), unit)
    }

    /// A number with fixed decimals, for lists that are read in passing.
    pub fn rounded(name: &str, symbol: &str, value: f64, decimals: usize, unit: &str) -> Self {
        Self::shown(name, symbol, format_fixed(value, decimals), unit)
    }

    /// A value that is already formatted, with symbol and unit.
    pub fn shown(name: &str, symbol: &str, value: impl Into<String>, unit: &str) -> Self {
        Self::new(name, symbol, QuantityValue::Text(value.into()), unit)
    }

    /// A count with its symbol ("" for none).
    pub fn count(name: &str, symbol: &str, value: i64) -> Self {
        Self::new(name, symbol, QuantityValue::Count(value), "")
    }

    /// Words.
    pub fn text(name: &str, value: impl Into<String>) -> Self {
        Self::new(name, "", QuantityValue::Text(value.into()), "")
    }

    /// One number per flank; equal numbers are printed once.
    pub fn per_flank(name: &str, symbol: &str, left: f64, right: f64, unit: &str) -> Self {
        Self::new(name, symbol, QuantityValue::PerFlank { left, right }, unit)
    }

    fn new(name: &str, symbol: &str, value: QuantityValue, unit: &str) -> Self {
        Self { name: name.to_owned(), symbol: symbol.to_owned(), value, unit: unit.to_owned() }
    }

    /// The value as text, without its unit.
    pub fn value_text(&self) -> String {
        const DIGITS: usize = 6;
        match &self.value {
            QuantityValue::Number(value) => format_significant(*value, DIGITS),
            QuantityValue::Count(value) => value.to_string().replace('-', "−"),
            QuantityValue::Text(text) => text.clone(),
            QuantityValue::PerFlank { left, right } if left == right => format_significant(*left, DIGITS),
            QuantityValue::PerFlank { left, right } => {
                format!("{} / {}", format_significant(*left, DIGITS), format_significant(*right, DIGITS))
            }
        }
    }
}

impl Table {
    /// Heading of the column with the names of quantities.
    pub const QUANTITY: &'static str = "Quantity";

    /// A data sheet: name, symbol, value, unit.
    pub fn of_quantities(caption: impl Into<String>, quantities: &[Quantity]) -> Self {
        let per_flank = quantities
            .iter()
            .any(|q| matches!(q.value, QuantityValue::PerFlank { left, right } if left != right));
        Self {
            caption: caption.into(),
            columns: vec![
                Column::text(Self::QUANTITY),
                Column::symbols("Symbol"),
                Column::number("Value", ""),
                Column::text("Unit"),
            ],
            rows: quantities
                .iter()
                .map(|q| vec![q.name.clone(), q.symbol.clone(), q.value_text(), unit(&q.unit).into_owned()])
                .collect(),
            note: if per_flank { "Two values: left / right flank.".to_owned() } else { String::new() },
        }
    }
}
