//! TOML text to the neutral tree. Knows no key of a job.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::diagnostic::{Diagnostic, Problem};
use super::node::{Entry, Kind, MAXIMUM_DEPTH, Node};

/// Parses a TOML document.
pub(super) fn parse(text: &str) -> Result<Node, Diagnostic> {
    let table = DeTable::parse(text).map_err(|error| {
        let message = error.message();
        let problem = if message.contains("duplicate key") {
            Problem::DuplicateKey
        } else if message.contains("max recursion depth") {
            Problem::NestedTooDeeply
        } else {
            Problem::InvalidToml
        };
        // An error without a place is one about the end of the text.
        let span = error.span().unwrap_or(text.len()..text.len());
        match problem {
            Problem::DuplicateKey => Diagnostic::new(problem, "this key stands twice in its table")
                .value(text.get(span.clone()).unwrap_or_default())
                .way_out("delete one of the two"),
            Problem::NestedTooDeeply => too_deep(),
            _ if decimal_comma(text, span.start) => {
                Diagnostic::new(problem, "a comma inside a number: the decimal sign is a point")
                    .allowed("a number with a decimal point, e.g. 2.5")
                    .way_out("write a point in place of the comma")
            }
            _ => Diagnostic::new(problem, format!("this is not TOML: {message}")).way_out(
                "correct the text at this place; texts stand in quotes, lists in [ ], inline tables in { }",
            ),
        }
        .span(Some(span))
    })?;
    let span = table.span();
    Ok(Node { kind: table_kind(table.into_inner(), 0)?, span })
}

/// Whether the fault at a place follows `key = 2,5`, on whatever side of the comma the parser noticed it.
fn decimal_comma(text: &str, at: usize) -> bool {
    let from = text.get(..at).and_then(|before| before.rfind('\n')).map_or(0, |end| end + 1);
    let line = text.get(from..).unwrap_or_default().lines().next().unwrap_or_default();
    let Some((_, value)) = line.split_once('=') else { return false };
    let value = value.split('#').next().unwrap_or_default().trim().trim_start_matches(['+', '-']);
    let Some((whole, rest)) = value.split_once(',') else { return false };
    let digits = |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
    digits(whole) && digits(rest)
}

fn too_deep() -> Diagnostic {
    Diagnostic::new(Problem::NestedTooDeeply, "lists or tables are nested too deeply")
        .allowed(format!("at most {MAXIMUM_DEPTH} levels"))
        .way_out("flatten this value; no key of a job needs such nesting")
}

fn table_kind(table: DeTable<'_>, depth: usize) -> Result<Kind, Diagnostic> {
    let mut entries = table
        .into_iter()
        .map(|(key, value)| {
            let key_span = key.span();
            Ok(Entry { key: key.into_inner().into_owned(), key_span, value: node(value, depth + 1)? })
        })
        .collect::<Result<Vec<_>, Diagnostic>>()?;
    entries.sort_by_key(|e| e.key_span.start);
    Ok(Kind::Table(entries))
}

fn node(value: Spanned<DeValue<'_>>, depth: usize) -> Result<Node, Diagnostic> {
    let span = value.span();
    if depth > MAXIMUM_DEPTH {
        return Err(too_deep().span(Some(span)));
    }
    let kind = match value.into_inner() {
        DeValue::String(text) => Kind::Text(text.into_owned()),
        DeValue::Integer(number) => match i64::from_str_radix(number.as_str(), number.radix()) {
            Ok(value) => Kind::Integer(value),
            // Beyond 64 bits: kept as a number, so that it is refused by the range of its key.
            Err(_) => Kind::Float(number.as_str().parse().unwrap_or(f64::INFINITY)),
        },
        DeValue::Float(number) => Kind::Float(number.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(value) => Kind::Bool(value),
        DeValue::Datetime(date) => Kind::Date(date.to_string()),
        DeValue::Array(items) => {
            Kind::List(items.into_iter().map(|item| node(item, depth + 1)).collect::<Result<_, _>>()?)
        }
        DeValue::Table(table) => table_kind(table, depth)?,
    };
    Ok(Node { kind, span })
}
