//! A model as JSON.

use serde_json::{Map, Value as Json, json};

use super::document::{Attribute, Component, Content, Opaque, RexsDocument, RexsFormat, Value};
use super::warning::{RexsWarning, RexsWarningKind};

/// The text of a model. What stands in another form of file is left out and reported.
pub(super) fn json(document: &RexsDocument, warnings: &mut Vec<RexsWarning>) -> String {
    let mut model = Map::new();
    let mut put = |key: &str, value: Json| {
        model.insert(key.into(), value);
    };
    put("version", document.version.as_str().into());
    put("applicationId", document.application_id.as_str().into());
    put("applicationVersion", document.application_version.as_str().into());
    put("date", document.date.as_str().into());
    if let Some(language) = &document.language {
        put("applicationLanguage", language.as_str().into());
    }
    let relations = document.relations.iter().map(|relation| {
        let refs = relation.refs.iter().map(|end| {
            let mut one = Map::from_iter([
                ("id".to_owned(), Json::from(end.id)),
                ("role".to_owned(), Json::from(end.role.as_str())),
            ]);
            one.extend(end.hint.iter().map(|hint| ("hint".to_owned(), Json::from(hint.as_str()))));
            Json::Object(one)
        });
        let mut one = json!({ "id": relation.id, "type": relation.kind, "refs": refs.collect::<Vec<_>>() });
        if let (Some(order), Some(map)) = (relation.order, one.as_object_mut()) {
            map.insert("order".into(), order.into());
        }
        one
    });
    put("relations", relations.collect());
    let components: Vec<Json> = document.components.iter().map(|c| component(c, warnings)).collect();
    put("components", components.into());
    let spectra: Vec<Json> =
        document.load_spectra.iter().filter_map(|s| keep(s, "a load spectrum", warnings)).collect();
    // One spectrum stands by itself, several in a list.
    match spectra.len() {
        0 => {}
        1 => put("loadSpectrum", spectra.into_iter().next().unwrap_or_default()),
        _ => put("loadSpectrum", spectra.into()),
    }
    format!("{:#}\n", json!({ "model": model }))
}

fn component(of: &Component, warnings: &mut Vec<RexsWarning>) -> Json {
    let mut one = Map::from_iter([
        ("id".to_owned(), Json::from(of.id)),
        ("type".to_owned(), Json::from(of.kind.as_str())),
    ]);
    for (key, value) in [("name", &of.name), ("sign", &of.sign)] {
        one.extend(value.iter().map(|value| (key.to_owned(), Json::from(value.as_str()))));
    }
    let attributes = match &of.content {
        Content::Attributes(list) => {
            list.iter().filter_map(|item| attribute(item, of.id, warnings)).collect()
        }
        Content::Opaque(opaque) => {
            match keep(opaque, &format!("component {} ({})", of.id, of.kind), warnings) {
                Some(whole) => return whole,
                // The component itself stays, so that relations keep their ends.
                None => Vec::new(),
            }
        }
    };
    one.insert("attributes".into(), attributes.into());
    Json::Object(one)
}

fn keep(opaque: &Opaque, what: &str, warnings: &mut Vec<RexsWarning>) -> Option<Json> {
    if opaque.format == RexsFormat::Json
        && let Ok(value) = serde_json::from_str(&opaque.text)
    {
        return Some(value);
    }
    let message = format!("the content of {what} stands as XML in its file and is not in the JSON");
    warnings.push(RexsWarning::new(RexsWarningKind::Lost, message));
    None
}

fn attribute(item: &Attribute, component: i32, warnings: &mut Vec<RexsWarning>) -> Option<Json> {
    let (key, value) = match &item.value {
        Value::Number(value) => ("floating_point", Json::from(*value)),
        Value::Integer(value) => ("integer", Json::from(*value)),
        Value::Boolean(value) => ("boolean", Json::from(*value)),
        Value::Word(word) => ("enum", Json::from(word.as_str())),
        Value::Numbers(list) => ("floating_point_array", Json::from(list.as_slice())),
        Value::Opaque(opaque) => {
            return keep(opaque, &format!("the attribute {} of component {component}", item.id), warnings);
        }
    };
    Some(json!({ "id": item.id, "unit": item.unit.as_deref().unwrap_or("none"), key: value }))
}
