//! A model from JSON, with the same demands on its structure as XML.

use serde_json::{Map, Value as Json};

use super::attributes::{self, Form};
use super::coded;
use super::document::{
    Attribute, Component, ComponentRef, Content, Opaque, Relation, RexsDocument, RexsFormat, Value,
};
use super::error::RexsError;
use super::xml_read::allowed;
use job::xml::is_allowed;

/// Reads a model.
pub(super) fn document(text: &str) -> Result<RexsDocument, RexsError> {
    let json: Json = serde_json::from_str(text)
        .map_err(|error| RexsError::NotRexs { what: format!("JSON that is not well-formed: {error}") })?;
    let Some(model) = json.get("model").and_then(Json::as_object) else {
        return Err(RexsError::NotRexs { what: "JSON without an object `model`".into() });
    };
    let model = Object { place: "model".into(), map: model };
    let document = RexsDocument {
        version: model.text("version")?,
        application_id: model.text("applicationId")?,
        application_version: model.text("applicationVersion")?,
        date: model.text("date")?,
        language: model.optional_text("applicationLanguage")?,
        relations: model.list("relations", "relation")?.iter().map(relation).collect::<Result<_, _>>()?,
        components: model.list("components", "component")?.iter().map(component).collect::<Result<_, _>>()?,
        load_spectra: match model.map.get("loadSpectrum") {
            None => Vec::new(),
            Some(Json::Array(list)) => list.iter().map(opaque).collect(),
            Some(one) => vec![opaque(one)],
        },
    };
    document.check()?;
    Ok(document)
}

fn opaque(value: &Json) -> Opaque {
    Opaque { format: RexsFormat::Json, text: value.to_string() }
}

fn relation(object: &Object<'_>) -> Result<Relation, RexsError> {
    let end = |end: &Object<'_>| {
        Ok(ComponentRef { id: end.int("id")?, role: end.text("role")?, hint: end.optional_text("hint")? })
    };
    let refs: Vec<ComponentRef> = object.list("refs", "ref")?.iter().map(end).collect::<Result<_, _>>()?;
    if refs.is_empty() {
        return Err(object.wrong("a relation needs at least one of `refs`"));
    }
    let order = object.map.get("order").map(|_| object.int("order")).transpose()?;
    Ok(Relation { id: object.int("id")?, kind: object.text("type")?, order, refs })
}

fn component(object: &Object<'_>) -> Result<Component, RexsError> {
    let (id, kind) = (object.int("id")?, object.text("type")?);
    let items = object.list("attributes", "attribute")?;
    let attributes: Vec<Attribute> =
        items.iter().map(|item| attribute(item, id, &kind)).collect::<Result<_, _>>()?;
    let content = if attributes::is_known(&kind) {
        Content::Attributes(attributes)
    } else {
        Content::Opaque(opaque(&Json::Object(object.map.clone())))
    };
    Ok(Component {
        id,
        name: object.optional_text("name")?,
        sign: object.optional_text("sign")?,
        content,
        kind,
    })
}

fn attribute(object: &Object<'_>, component: i32, kind: &str) -> Result<Attribute, RexsError> {
    let id = object.text("id")?;
    let unit = object.optional_text("unit")?;
    let Some(form) = attributes::form(kind, &id) else {
        let value = Value::Opaque(opaque(&Json::Object(object.map.clone())));
        return Ok(Attribute { id, unit, value });
    };
    let value = value(form, object.map).ok_or_else(|| {
        let given = object.map.iter().find(|(key, _)| !["id", "unit"].contains(&key.as_str()));
        let given = given.map_or_else(String::new, |(_, value)| value.to_string());
        RexsError::BadValue {
            component: format!("component {component} ({kind})"),
            attribute: id.clone(),
            value: given.chars().take(60).collect(),
            allowed: allowed(Some(form)),
        }
    })?;
    Ok(Attribute { id, unit, value })
}

fn value(form: Form, map: &Map<String, Json>) -> Option<Value> {
    let number = || map.get("floating_point").or_else(|| map.get("integer"))?.as_f64();
    match form {
        Form::Length | Form::Micrometres | Form::Angle | Form::Plain => number().map(Value::Number),
        Form::Integer => map.get("integer")?.as_i64().map(Value::Integer),
        Form::Boolean => map.get("boolean")?.as_bool().map(Value::Boolean),
        Form::Word => {
            let word = map.get("enum").or_else(|| map.get("string"))?.as_str()?.trim();
            (!word.is_empty() && is_word(word)).then(|| Value::Word(word.to_owned()))
        }
        Form::Lengths => {
            if let Some(list) = map.get("floating_point_array").or_else(|| map.get("integer_array")) {
                let numbers: Option<Vec<f64>> = list.as_array()?.iter().map(Json::as_f64).collect();
                return numbers.map(Value::Numbers);
            }
            let packed = map.get("floating_point_array_coded")?;
            coded::decode(packed.get("code")?.as_str()?, packed.get("value")?.as_str()?).map(Value::Numbers)
        }
    }
}

/// Whether a file in XML could hold the text as well.
fn is_word(text: &str) -> bool {
    text.chars().all(is_allowed)
}

/// An object of the file with its place in words.
struct Object<'a> {
    place: String,
    map: &'a Map<String, Json>,
}

impl<'a> Object<'a> {
    fn wrong(&self, what: impl Into<String>) -> RexsError {
        RexsError::Structure { place: self.place.clone(), what: what.into() }
    }

    fn optional_text(&self, key: &str) -> Result<Option<String>, RexsError> {
        match self.map.get(key) {
            None | Some(Json::Null) => Ok(None),
            Some(Json::String(text)) if is_word(text) => Ok(Some(text.clone())),
            Some(Json::String(_)) => Err(self.wrong(format!("`{key}` holds a control character"))),
            Some(_) => Err(self.wrong(format!("`{key}` must be a text"))),
        }
    }

    fn text(&self, key: &str) -> Result<String, RexsError> {
        self.optional_text(key)?.ok_or_else(|| self.wrong(format!("the key `{key}` is needed")))
    }

    fn int(&self, key: &str) -> Result<i32, RexsError> {
        let found = self.map.get(key).and_then(Json::as_i64).and_then(|value| i32::try_from(value).ok());
        found.ok_or_else(|| self.wrong(format!("`{key}` must be a whole number")))
    }

    /// The objects of a list; an absent list is empty.
    fn list(&self, key: &str, what: &str) -> Result<Vec<Object<'a>>, RexsError> {
        let list = match self.map.get(key) {
            None | Some(Json::Null) => return Ok(Vec::new()),
            Some(Json::Array(list)) => list,
            Some(_) => return Err(self.wrong(format!("`{key}` must be a list"))),
        };
        let one = |(k, value): (usize, &'a Json)| {
            let place = format!("{}, {what} {}", self.place, k + 1);
            let map = value.as_object();
            let map = map.ok_or_else(|| self.wrong(format!("`{key}` must be a list of objects")))?;
            Ok(Object { place, map })
        };
        list.iter().enumerate().map(one).collect()
    }
}
