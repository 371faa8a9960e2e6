//! A REXS model as its file has it: components with attributes, relations between them. Independent of XML and JSON.

use serde::{Deserialize, Serialize};
use std::collections::HashSet;

use super::error::RexsError;

/// The forms of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum RexsFormat {
    /// `.rexs`
    Xml,
    /// `.rexsj`
    Json,
}

impl RexsFormat {
    /// The ending of files.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Xml => "rexs",
            Self::Json => "rexsj",
        }
    }
}

/// A piece of a file that is kept as it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Opaque {
    /// The form in which the text stands.
    pub format: RexsFormat,
    /// One XML element with all it holds, or one JSON value.
    pub text: String,
}

/// The value of an attribute.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Value {
    /// A number.
    Number(f64),
    /// A whole number.
    Integer(i64),
    /// Yes or no.
    Boolean(bool),
    /// One word of a list.
    Word(String),
    /// A list of numbers.
    Numbers(Vec<f64>),
    /// An attribute that is not read here: the whole of it as it stands in the file.
    Opaque(Opaque),
}

/// An attribute of a component.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Attribute {
    /// Its identifier in the schema.
    pub id: String,
    /// Its unit; absent as `none`.
    pub unit: Option<String>,
    /// Its value.
    pub value: Value,
}

/// What a component holds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Content {
    /// Attributes of a type that is read here.
    Attributes(Vec<Attribute>),
    /// A component of another type: the whole of it as it stands in the file.
    Opaque(Opaque),
}

/// A component.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Component {
    /// Its number in the file.
    pub id: i32,
    /// Its type in the schema.
    pub kind: String,
    /// Its name.
    pub name: Option<String>,
    /// What a positive amount means, in words of this program; other programs write none.
    pub sign: Option<String>,
    /// What it holds.
    pub content: Content,
}

impl Component {
    /// The attribute of that identifier.
    pub fn attribute(&self, id: &str) -> Option<&Attribute> {
        match &self.content {
            Content::Attributes(list) => list.iter().find(|attribute| attribute.id == id),
            Content::Opaque(_) => None,
        }
    }
}

/// One end of a relation.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ComponentRef {
    /// Number of the component.
    pub id: i32,
    /// What it is in the relation.
    pub role: String,
    /// A remark, usually its type.
    pub hint: Option<String>,
}

/// A relation between components.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Relation {
    /// Its number in the file.
    pub id: i32,
    /// Its type in the schema.
    pub kind: String,
    /// Its place among those of its type.
    pub order: Option<i32>,
    /// The components.
    pub refs: Vec<ComponentRef>,
}

impl Relation {
    /// The component in a role.
    pub fn role(&self, role: &str) -> Option<i32> {
        self.refs.iter().find(|end| end.role == role).map(|end| end.id)
    }
}

/// A whole model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RexsDocument {
    /// Version of REXS.
    pub version: String,
    /// The program that wrote it.
    pub application_id: String,
    /// Its version.
    pub application_version: String,
    /// When it was written, ISO 8601.
    pub date: String,
    /// Language of names.
    pub language: Option<String>,
    /// Relations in the order of the file.
    pub relations: Vec<Relation>,
    /// Components in the order of the file.
    pub components: Vec<Component>,
    /// Load spectra, kept as they are.
    pub load_spectra: Vec<Opaque>,
}

impl RexsDocument {
    /// The component of that number.
    pub fn component(&self, id: i32) -> Option<&Component> {
        self.components.iter().find(|component| component.id == id)
    }
}

impl RexsDocument {
    /// Identifiers must be unique, and relations must name components that are there.
    pub(super) fn check(&self) -> Result<(), RexsError> {
        let refuse = |place: String, what: String| Err(RexsError::Structure { place, what });
        let mut components = HashSet::new();
        for component in &self.components {
            if !components.insert(component.id) {
                return refuse(format!("component {}", component.id), "its number stands twice".into());
            }
        }
        let mut relations = HashSet::new();
        for relation in &self.relations {
            let place = || format!("relation {}", relation.id);
            if !relations.insert(relation.id) {
                return refuse(place(), "its number stands twice".into());
            }
            if let Some(end) = relation.refs.iter().find(|end| !components.contains(&end.id)) {
                return refuse(place(), format!("it names component {}, which is not there", end.id));
            }
        }
        Ok(())
    }
}
