//! A model from XML, with the structure that the schema of REXS 2.0 demands: elements in their places, attributes that must be there, whole
//! numbers as identifiers, lists of the known codes. Document types and entities are refused.
//!
//! `roxmltree` (MIT or Apache-2.0) reads without recursion, bounds the number of nodes, resolves namespaces and keeps the place of each
//! element; it never opens anything else.

use std::collections::HashSet;

use roxmltree::{Document, Error, ParsingOptions};

use super::attribute_structure::attribute_structure;
use super::attributes::{self, Form};
use super::document::{Attribute, Component, ComponentRef, Content, Relation, RexsDocument, Value};
use super::error::RexsError;
use super::load_spectrum;
use super::xml_place::{Place, short};

/// Most elements, texts and comments of a file; each takes some ten times its text in memory.
const MOST_NODES: u32 = 4_000_000;

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

fn scalar(form: Form, text: &str) -> Option<Value> {
    let number = || text.parse().ok().filter(|v: &f64| v.is_finite());
    match form {
        Form::Length | Form::Micrometres | Form::Angle | Form::Plain => number().map(Value::Number),
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
        Some(Form::Length | Form::Micrometres | Form::Angle | Form::Plain) => "a finite number",
        Some(Form::Integer) => "a whole number",
        Some(Form::Boolean) => "true or false",
        Some(Form::Word) => "a word",
        Some(Form::Lengths) => "a list of finite numbers, plain or coded",
        None => "anything",
    }
}
