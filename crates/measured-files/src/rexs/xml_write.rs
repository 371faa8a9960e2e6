//! A model as XML.

use std::fmt::Write;

use super::document::{Attribute, Content, Opaque, RexsDocument, RexsFormat, Value};
use super::warning::{RexsWarning, RexsWarningKind};
use job::xml::escape;

/// The text of a model. What stands in another form of file is left out and reported.
pub(super) fn xml(document: &RexsDocument, warnings: &mut Vec<RexsWarning>) -> String {
    let mut text = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let mut root = String::new();
    for (name, value) in [
        ("version", Some(&document.version)),
        ("applicationId", Some(&document.application_id)),
        ("applicationVersion", Some(&document.application_version)),
        ("date", Some(&document.date)),
        ("applicationLanguage", document.language.as_ref()),
    ] {
        attribute(&mut root, name, value);
    }
    // Writing to a text cannot fail.
    let _ = writeln!(text, "<model{root}>\n  <relations>");
    for relation in &document.relations {
        let mut head = String::new();
        attribute(&mut head, "id", Some(&relation.id.to_string()));
        attribute(&mut head, "type", Some(&relation.kind));
        attribute(&mut head, "order", relation.order.map(|order| order.to_string()).as_ref());
        let _ = writeln!(text, "    <relation{head}>");
        for end in &relation.refs {
            let mut head = String::new();
            attribute(&mut head, "id", Some(&end.id.to_string()));
            attribute(&mut head, "role", Some(&end.role));
            attribute(&mut head, "hint", end.hint.as_ref());
            let _ = writeln!(text, "      <ref{head}/>");
        }
        let _ = writeln!(text, "    </relation>");
    }
    let _ = writeln!(text, "  </relations>\n  <components>");
    for component in &document.components {
        let mut head = String::new();
        attribute(&mut head, "id", Some(&component.id.to_string()));
        attribute(&mut head, "type", Some(&component.kind));
        attribute(&mut head, "name", component.name.as_ref());
        attribute(&mut head, "sign", component.sign.as_ref());
        match &component.content {
            Content::Attributes(list) => {
                let _ = writeln!(text, "    <component{head}>");
                for item in list {
                    write_attribute(&mut text, item, component.id, warnings);
                }
                let _ = writeln!(text, "    </component>");
            }
            Content::Opaque(opaque) => {
                let what = format!("component {} ({})", component.id, component.kind);
                if !keep(&mut text, opaque, &what, warnings) {
                    // The component itself stays, so that relations keep their ends.
                    let _ = writeln!(text, "    <component{head}></component>");
                }
            }
        }
    }
    let _ = writeln!(text, "  </components>");
    for spectrum in &document.load_spectra {
        keep(&mut text, spectrum, "a load spectrum", warnings);
    }
    text.push_str("</model>\n");
    text
}

fn attribute(head: &mut String, name: &str, value: Option<&String>) {
    if let Some(value) = value {
        let _ = write!(head, " {name}=\"{}\"", escape(value));
    }
}

fn keep(text: &mut String, opaque: &Opaque, what: &str, warnings: &mut Vec<RexsWarning>) -> bool {
    if opaque.format == RexsFormat::Xml {
        text.push_str("    ");
        text.push_str(&opaque.text);
        text.push('\n');
        return true;
    }
    let message = format!("the content of {what} stands as JSON in its file and is not in the XML");
    warnings.push(RexsWarning::new(RexsWarningKind::Lost, message));
    false
}

fn write_attribute(text: &mut String, item: &Attribute, component: i32, warnings: &mut Vec<RexsWarning>) {
    let value = match &item.value {
        Value::Number(value) => value.to_string(),
        Value::Integer(value) => value.to_string(),
        Value::Boolean(value) => value.to_string(),
        Value::Word(word) => escape(word),
        Value::Numbers(list) => {
            let mut array = String::from("<array>");
            for value in list {
                let _ = write!(array, "<c>{value}</c>");
            }
            array + "</array>"
        }
        Value::Opaque(opaque) => {
            keep(text, opaque, &format!("the attribute {} of component {component}", item.id), warnings);
            return;
        }
    };
    let unit = item.unit.as_deref().unwrap_or("none");
    let (id, unit) = (escape(&item.id), escape(unit));
    let _ = writeln!(text, "      <attribute id=\"{id}\" unit=\"{unit}\">{value}</attribute>");
}
