//! A small list of the first page: names with their values.

use crate::data::Quantity;
use serde::Serialize;

/// A small list of the first page.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Sheet {
    /// Heading.
    pub title: String,
    /// Names with their values.
    pub quantities: Vec<Quantity>,
    /// What is not given, with the reason, and other remarks.
    pub remarks: Vec<String>,
}

impl Sheet {
    /// A list without remarks.
    pub fn new(title: impl Into<String>, quantities: Vec<Quantity>) -> Self {
        Self { title: title.into(), quantities, remarks: Vec::new() }
    }

    /// The same with a remark.
    pub fn remark(mut self, text: impl Into<String>) -> Self {
        self.remarks.push(text.into());
        self
    }

    /// Whether it says nothing.
    pub fn is_empty(&self) -> bool {
        self.quantities.is_empty() && self.remarks.is_empty()
    }
}
