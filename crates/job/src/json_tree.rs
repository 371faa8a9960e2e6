//! JSON text to the neutral tree. Knows no key of a job.

use std::collections::HashSet;

use jsonc_parser::ast::Value;
use jsonc_parser::common::Ranged;
use jsonc_parser::errors::ParseErrorKind;
use jsonc_parser::{CollectOptions, ParseOptions, parse_to_ast};

use super::diagnostic::{Diagnostic, Problem};
use super::node::{Entry, Kind, MAXIMUM_DEPTH, Node};

/// Parses a JSON document, strictly: no comments, no trailing commas, no loose words.
pub fn parse(text: &str) -> Result<Node, Diagnostic> {
    let strict = ParseOptions {
        allow_comments: false,
        allow_loose_object_property_names: false,
        allow_trailing_commas: false,
        allow_missing_commas: false,
        allow_single_quoted_strings: false,
        allow_hexadecimal_numbers: false,
        allow_unary_plus_numbers: false,
        allow_bare_decimal_point_numbers: false,
        allow_extended_string_escapes: false,
        allow_non_finite_numbers: false,
    };
    let parsed = parse_to_ast(text, &CollectOptions::default(), &strict).map_err(|error| {
        let span = error.range().start..error.range().end.min(text.len());
        if matches!(error.kind(), ParseErrorKind::NestingDepthExceeded) {
            return too_deep().span(Some(span));
        }
        Diagnostic::new(Problem::InvalidJson, format!("this is not JSON: {}", error.kind()))
            .way_out("correct the text at this place, or write the job as TOML, which allows comments")
            .span(Some(span))
    })?;
    let Some(value) = parsed.value else {
        return Err(Diagnostic::new(Problem::InvalidJson, "this is not JSON: the file is empty")
            .way_out("`flankwright new generating-grinding` prints an example job")
            .span(Some(text.len()..text.len())));
    };
    node(value, 0)
}

fn too_deep() -> Diagnostic {
    Diagnostic::new(Problem::NestedTooDeeply, "lists or objects are nested too deeply")
        .allowed(format!("at most {MAXIMUM_DEPTH} levels"))
        .way_out("flatten this value; no key of a job needs such nesting")
}

fn node(value: Value<'_>, depth: usize) -> Result<Node, Diagnostic> {
    let range = value.range();
    let span = range.start..range.end;
    if depth > MAXIMUM_DEPTH {
        return Err(too_deep().span(Some(span)));
    }
    let kind = match value {
        Value::NullKeyword(_) => Kind::Null,
        Value::BooleanLit(literal) => Kind::Bool(literal.value),
        Value::StringLit(literal) => Kind::Text(literal.value.into_owned()),
        Value::NumberLit(literal) => match literal.value.parse::<i64>() {
            Ok(value) => Kind::Integer(value),
            // Beyond the largest f64 this is infinite, and refused as such by name.
            Err(_) => Kind::Float(literal.value.parse().unwrap_or(f64::NAN)),
        },
        Value::Array(array) => {
            Kind::List(array.elements.into_iter().map(|e| node(e, depth + 1)).collect::<Result<_, _>>()?)
        }
        Value::Object(object) => {
            let mut seen = HashSet::new();
            let mut entries = Vec::with_capacity(object.properties.len());
            for property in object.properties {
                let range = property.name.range();
                let key_span = range.start..range.end;
                let key = property.name.into_string();
                if !seen.insert(key.clone()) {
                    return Err(Diagnostic::new(
                        Problem::DuplicateKey,
                        "this key stands twice in its object",
                    )
                    .value(key)
                    .way_out("delete one of the two")
                    .span(Some(key_span)));
                }
                entries.push(Entry { key, key_span, value: node(property.value, depth + 1)? });
            }
            Kind::Table(entries)
        }
    };
    Ok(Node { kind, span })
}
