//! An element of a model with its place in the text.

use super::coded;
use super::document::{Opaque, RexsFormat};
use super::error::RexsError;
use job::xml::escape;
use roxmltree::Node;

/// Deepest nesting of what is kept as it is; the schema itself has eight levels.
const DEEPEST: usize = 16;

/// An element of the file; namespaces are looked through.
#[derive(Clone, Copy)]
pub(super) struct Place<'a, 'input>(pub(super) Node<'a, 'input>);

impl<'a, 'input> Place<'a, 'input> {
    pub(super) fn name(self) -> &'a str {
        self.0.tag_name().name()
    }

    pub(super) fn wrong(self, what: impl Into<String>) -> RexsError {
        let at = self.0.document().text_pos_at(self.0.range().start);
        let place = format!("line {}, element `{}`", at.row, short(self.name()));
        RexsError::Structure { place, what: what.into() }
    }

    pub(super) fn get(self, name: &str) -> Option<&'a str> {
        self.0.attributes().find(|a| a.name() == name && a.namespace().is_none()).map(|a| a.value())
    }

    pub(super) fn needed(self, name: &str) -> Result<&'a str, RexsError> {
        self.get(name).ok_or_else(|| self.wrong(format!("the attribute `{name}` is needed")))
    }

    pub(super) fn int(self, name: &str) -> Result<i32, RexsError> {
        let text = self.needed(name)?.trim();
        let found = text.parse();
        found.map_err(|_| self.wrong(format!("`{name}` must be a whole number, not `{}`", short(text))))
    }

    pub(super) fn elements(self) -> impl Iterator<Item = Self> {
        self.0.children().filter(Node::is_element).map(Place)
    }

    /// Elements of an element that holds no text.
    pub(super) fn children(self) -> Result<Vec<Self>, RexsError> {
        let texts = self.0.children().filter(Node::is_text);
        if texts.filter_map(|node| node.text()).any(|text| !text.trim().is_empty()) {
            return Err(self.wrong("text where the schema has elements only"));
        }
        Ok(self.elements().collect())
    }

    /// Elements that all have one name.
    pub(super) fn each<T>(
        self,
        name: &str,
        mut read: impl FnMut(Self) -> Result<T, RexsError>,
    ) -> Result<Vec<T>, RexsError> {
        let one = |child: Self| {
            if child.name() == name {
                read(child)
            } else {
                Err(child.wrong(format!("`{name}` is needed here")))
            }
        };
        self.children()?.into_iter().map(one).collect()
    }

    /// All its own text.
    pub(super) fn text(self) -> String {
        self.0.children().filter(Node::is_text).filter_map(|node| node.text()).collect()
    }

    /// The numbers of a plain or coded list.
    pub(super) fn numbers(self) -> Option<Vec<f64>> {
        if let Some(code) = self.get("code") {
            return coded::decode(code, &self.text());
        }
        self.elements().map(|cell| cell.text().trim().parse().ok().filter(|v: &f64| v.is_finite())).collect()
    }

    /// The element as text, without namespaces.
    pub(super) fn opaque(self) -> Result<Opaque, RexsError> {
        let mut text = String::new();
        self.outer(&mut text, 0)?;
        Ok(Opaque { format: RexsFormat::Xml, text })
    }

    pub(super) fn outer(self, text: &mut String, depth: usize) -> Result<(), RexsError> {
        if depth > DEEPEST {
            return Err(self.wrong("nested deeper than any REXS file is"));
        }
        text.push('<');
        text.push_str(self.name());
        for attribute in self.0.attributes().filter(|a| a.namespace().is_none()) {
            text.push_str(&format!(" {}=\"{}\"", attribute.name(), escape(attribute.value())));
        }
        text.push('>');
        for child in self.0.children() {
            if child.is_element() {
                Place(child).outer(text, depth + 1)?;
            } else if child.is_text() {
                text.push_str(&escape(child.text().unwrap_or("")));
            }
        }
        text.push_str(&format!("</{}>", self.name()));
        Ok(())
    }
}

pub(super) fn short(text: &str) -> String {
    text.chars().take(60).collect()
}
