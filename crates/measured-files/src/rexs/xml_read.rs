//! A model from XML, with the structure that the schema of REXS 2.0 demands: elements in their places, attributes that must be there, whole
//! numbers as identifiers, lists of the known codes. Document types and entities are refused.
//!
//! `roxmltree` (MIT or Apache-2.0) reads without recursion, bounds the number of nodes, resolves namespaces and keeps the place of each
//! element; it never opens anything else.

use std::collections::HashSet;

use roxmltree::{Document, Error, Node, ParsingOptions};

use super::attributes::{self, Form};
use super::document::{
    Attribute, Component, ComponentRef, Content, Opaque, Relation, RexsDocument, RexsFormat, Value,
};
use super::error::RexsError;
use super::{coded, load_spectrum};
use job::xml::escape;

/// Most elements, texts and comments of a file; each takes some ten times its text in memory.
const MOST_NODES: u32 = 4_000_000;
/// Deepest nesting of what is kept as it is; the schema itself has eight levels.
const DEEPEST: usize = 16;

/// Reads a model.
pub(super) fn document(text: &str) -> Result<RexsDocument, RexsError> {
    let options = ParsingOptions { nodes_limit: MOST_NODES, ..ParsingOptions::default() };
    let tree = Document::parse_with_options(text, options).map_err(|error| match error {
        Error::DtdDetected | Error::EntityReferenceLoop(_) => RexsError::EntitiesRefused,
        Error::NodesLimitReached => {
            let most = MOST_NODES as usize;
            RexsError::FileTooLarge { what: "elements and texts of the file", found: most + 1, most }
        }
        other => RexsError::NotRexs { what: format!("XML that is not well-formed: {other}") },
    })?;
    let root = Place(tree.root_element());
    if root.name() != "model" {
        return Err(RexsError::NotRexs {
            what: format!("the root is `{}`, not `model`", short(root.name())),
        });
    }
    let mut document = RexsDocument {
        version: root.needed("version")?.into(),
        application_id: root.needed("applicationId")?.into(),
        application_version: root.needed("applicationVersion")?.into(),
        date: root.needed("date")?.into(),
        language: root.get("applicationLanguage").map(str::to_owned),
        relations: Vec::new(),
        components: Vec::new(),
        load_spectra: Vec::new(),
    };
    let mut last = 0;
    let mut spectra = HashSet::new();
    for part in root.children()? {
        let order = ["relations", "components", "load_spectrum"];
        let rank = order.iter().position(|name| *name == part.name()).map_or(0, |k| k + 1);
        // Relations and components once each, in this order; any number of spectra behind them.
        if rank == 0 || rank < last || (rank == last && rank < order.len()) {
            return Err(part.wrong("relations, components and load_spectrum stand once each in this order"));
        }
        last = rank;
        match rank {
            1 => document.relations = part.each("relation", relation)?,
            2 => document.components = part.each("component", component)?,
            _ => {
                let components = document.components.iter().map(|component| component.id).collect();
                if !spectra.insert(load_spectrum::check(part, &components)?) {
                    return Err(part.wrong("the number of a load spectrum stands twice"));
                }
                document.load_spectra.push(part.opaque()?);
            }
        }
    }
    document.check()?;
    Ok(document)
}

fn relation(node: Place<'_, '_>) -> Result<Relation, RexsError> {
    let refs = node.each("ref", |end| {
        let hint = end.get("hint").map(str::to_owned);
        Ok(ComponentRef { id: end.int("id")?, role: end.needed("role")?.into(), hint })
    })?;
    if refs.is_empty() {
        return Err(node.wrong("a relation needs at least one `ref`"));
    }
    let order = node.get("order").map(|_| node.int("order")).transpose()?;
    Ok(Relation { id: node.int("id")?, kind: node.needed("type")?.into(), order, refs })
}

fn component(node: Place<'_, '_>) -> Result<Component, RexsError> {
    let (id, kind) = (node.int("id")?, node.needed("type")?.to_owned());
    let attributes = node.each("attribute", |item| attribute(item, id, &kind))?;
    let known = attributes::is_known(&kind);
    Ok(Component {
        id,
        name: node.get("name").map(str::to_owned),
        sign: node.get("sign").map(str::to_owned),
        content: if known { Content::Attributes(attributes) } else { Content::Opaque(node.opaque()?) },
        kind,
    })
}

fn attribute(node: Place<'_, '_>, component: i32, kind: &str) -> Result<Attribute, RexsError> {
    let id = node.needed("id")?;
    let form = attributes::form(kind, id);
    attribute_structure(node)?;
    let lists: Vec<Place<'_, '_>> = node.elements().collect();
    let value = match (form, lists.first()) {
        (None, _) => Some(Value::Opaque(node.opaque()?)),
        (Some(Form::Lengths), Some(list)) if list.name() == "array" => list.numbers().map(Value::Numbers),
        (Some(Form::Lengths), _) | (Some(_), Some(_)) => None,
        (Some(form), None) => scalar(form, node.text().trim()),
    };
    let value = value.ok_or_else(|| RexsError::BadValue {
        component: format!("component {component} ({kind})"),
        attribute: id.into(),
        value: short(node.text().trim()),
        allowed: allowed(form),
    })?;
    Ok(Attribute { id: id.into(), unit: node.get("unit").map(str::to_owned), value })
}

/// An attribute has a name, and at most one list.
pub(super) fn attribute_structure(node: Place<'_, '_>) -> Result<(), RexsError> {
    node.needed("id")?;
    let lists: Vec<Place<'_, '_>> = node.elements().collect();
    for list in &lists {
        list_structure(*list)?;
    }
    if lists.len() > 1 { Err(node.wrong("an attribute has at most one list")) } else { Ok(()) }
}

fn scalar(form: Form, text: &str) -> Option<Value> {
    let number = || text.parse().ok().filter(|v: &f64| v.is_finite());
    match form {
        Form::Length | Form::Angle | Form::Plain => number().map(Value::Number),
        Form::Integer => text.parse().ok().map(Value::Integer),
        Form::Boolean => match text {
            "true" | "1" => Some(Value::Boolean(true)),
            "false" | "0" => Some(Value::Boolean(false)),
            _ => None,
        },
        Form::Word => (!text.is_empty()).then(|| Value::Word(text.to_owned())),
        Form::Lengths => None,
    }
}

/// What messages say about the value of a form.
pub(super) fn allowed(form: Option<Form>) -> &'static str {
    match form {
        Some(Form::Length | Form::Angle | Form::Plain) => "a finite number",
        Some(Form::Integer) => "a whole number",
        Some(Form::Boolean) => "true or false",
        Some(Form::Word) => "a word",
        Some(Form::Lengths) => "a list of finite numbers, plain or coded",
        None => "anything",
    }
}

/// `array`, `matrix` and `array_of_arrays` with the codes of the schema.
fn list_structure(list: Place<'_, '_>) -> Result<(), RexsError> {
    if let Some(code) = list.get("code")
        && !["float64", "float32", "int32"].contains(&code)
    {
        return Err(list.wrong("a code is float64, float32 or int32"));
    }
    let inner = match list.name() {
        "array" => "c",
        "matrix" => "r",
        "array_of_arrays" => "array",
        "r" => "c",
        "c" => {
            return if list.elements().next().is_some() {
                Err(list.wrong("a cell holds text"))
            } else {
                Ok(())
            };
        }
        _ => return Err(list.wrong("an attribute holds text, array, matrix or array_of_arrays")),
    };
    if ["r", "array_of_arrays"].contains(&list.name()) && list.elements().next().is_none() {
        return Err(list.wrong(format!("at least one `{inner}` is needed here")));
    }
    for child in list.elements() {
        if child.name() != inner {
            return Err(child.wrong("another element than the schema has here"));
        }
        list_structure(child)?;
    }
    Ok(())
}

fn short(text: &str) -> String {
    text.chars().take(60).collect()
}

/// An element of the file; namespaces are looked through.
#[derive(Clone, Copy)]
pub(super) struct Place<'a, 'input>(Node<'a, 'input>);

impl<'a, 'input> Place<'a, 'input> {
    pub(super) fn name(self) -> &'a str {
        self.0.tag_name().name()
    }

    pub(super) fn wrong(self, what: impl Into<String>) -> RexsError {
        let at = self.0.document().text_pos_at(self.0.range().start);
        let place = format!("line {}, element `{}`", at.row, short(self.name()));
        RexsError::Structure { place, what: what.into() }
    }

    fn get(self, name: &str) -> Option<&'a str> {
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

    fn elements(self) -> impl Iterator<Item = Self> {
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
    fn text(self) -> String {
        self.0.children().filter(Node::is_text).filter_map(|node| node.text()).collect()
    }

    /// The numbers of a plain or coded list.
    fn numbers(self) -> Option<Vec<f64>> {
        if let Some(code) = self.get("code") {
            return coded::decode(code, &self.text());
        }
        self.elements().map(|cell| cell.text().trim().parse().ok().filter(|v: &f64| v.is_finite())).collect()
    }

    /// The element as text, without namespaces.
    fn opaque(self) -> Result<Opaque, RexsError> {
        let mut text = String::new();
        self.outer(&mut text, 0)?;
        Ok(Opaque { format: RexsFormat::Xml, text })
    }

    fn outer(self, text: &mut String, depth: usize) -> Result<(), RexsError> {
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
