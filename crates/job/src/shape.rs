//! Checks the tree of a document against the schema: unknown and missing keys, types, words, ranges; all
//! findings at once, each with its place. Knows no key.

use std::collections::HashSet;

use serde_json::Value;

use super::calendar::is_date;
use super::diagnostic::{Diagnostic, Problem};
use super::form::{Form, listed};
use super::node::{Entry, Kind, Node};

/// What messages call a document, and where an example of it is.
#[derive(Clone, Copy)]
pub struct Subject<'a> {
    /// E.g. `the job`.
    pub document: &'a str,
    /// A half sentence.
    pub example: &'a str,
}

/// All findings about a document. `form` is what the document has to meet: `schema` itself or a part of it; references
/// lead into `schema`.
pub fn check(root: &Node, schema: &Value, form: &Value, subject: Subject<'_>) -> Vec<Diagnostic> {
    let mut walk = Walk { schema, subject, findings: Vec::new() };
    walk.node(root, form, "", None);
    walk.findings
}

/// Similarity (Jaro-Winkler) from which a known name is offered instead of an unknown one.
const SIMILAR: f64 = 0.75;

/// The known name nearest to the given one, if any is near.
pub fn nearest<'a>(given: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let given = given.to_lowercase();
    known
        .into_iter()
        .map(|name| (strsim::jaro_winkler(&given, &name.to_lowercase()), name))
        .filter(|(score, _)| *score >= SIMILAR)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, name)| name)
}

struct Walk<'s> {
    schema: &'s Value,
    subject: Subject<'s>,
    findings: Vec<Diagnostic>,
}

impl<'s> Walk<'s> {
    fn node(&mut self, node: &Node, schema: &'s Value, path: &str, key: Option<&Entry>) {
        let forms = Form::alternatives(self.schema, schema);
        let name = if path.is_empty() { self.subject.document.to_owned() } else { format!("`{path}`") };
        let at =
            |diagnostic: Diagnostic| diagnostic.field(path).value(node.shown()).span(Some(node.span.clone()));
        // A schema that says nothing about type takes anything.
        if forms.iter().any(|f| f.types.is_empty() && f.words.is_empty()) {
            return self.anything(node, path);
        }
        let fitting: Vec<&Form<'s>> = forms.iter().filter(|f| f.takes(&node.kind)).collect();
        if fitting.is_empty() {
            let expected: Vec<String> = forms.iter().map(Form::expected).collect();
            let expected = expected.join(" or ");
            let given = node.type_name();
            let mut finding =
                Diagnostic::new(Problem::WrongType, format!("{name} is {given}; it takes {expected}"))
                    .allowed(expected)
                    .way_out(format!("write another value for {name}"));
            if let (Kind::Text(text), true) = (&node.kind, forms.iter().any(|f| f.takes(&Kind::Integer(0)))) {
                let number = text.trim().parse::<f64>().is_ok();
                finding = finding.way_out(if number {
                    "remove the quotes"
                } else {
                    "write a number without quotes"
                });
            }
            if node.kind == Kind::Null {
                finding = finding.way_out("leave the key out instead of writing null");
            }
            return self.findings.push(match key {
                Some(entry) if path.is_empty() => at(finding).span(Some(entry.key_span.clone())),
                _ => at(finding),
            });
        }
        match &node.kind {
            Kind::Integer(value) => self.number(node, &fitting, *value as f64, path),
            Kind::Float(value) => self.number(node, &fitting, *value, path),
            Kind::Text(text) | Kind::Date(text) => self.text(node, &forms, text, path),
            Kind::List(items) => self.list(node, fitting[0], items, path),
            Kind::Table(entries) => self.table(node, &fitting, entries, path),
            Kind::Null | Kind::Bool(_) => {}
        }
    }

    /// Where the schema leaves a value open, its numbers must still be finite.
    fn anything(&mut self, node: &Node, path: &str) {
        match &node.kind {
            Kind::Float(value) => self.number(node, &[&Form::any_number()], *value, path),
            Kind::List(items) => {
                for (i, item) in items.iter().enumerate() {
                    self.anything(item, &format!("{path}[{i}]"));
                }
            }
            Kind::Table(entries) => {
                for entry in entries {
                    self.anything(&entry.value, &joined(path, &entry.key));
                }
            }
            _ => {}
        }
    }

    fn number(&mut self, node: &Node, forms: &[&Form<'s>], value: f64, path: &str) {
        let form = forms[0];
        let whole = form.types.contains(&"integer") && !form.types.contains(&"number");
        let finding = if !value.is_finite() {
            Diagnostic::new(
                Problem::InvalidNumber,
                format!("`{path}` = {} is not a finite number", node.shown()),
            )
        } else if !form.contains(value) {
            Diagnostic::new(
                Problem::InvalidNumber,
                format!("`{path}` = {} is outside its range", node.shown()),
            )
        } else if whole && !matches!(node.kind, Kind::Integer(_)) {
            Diagnostic::new(
                Problem::WrongType,
                format!("`{path}` takes a whole number, written without decimal point"),
            )
        } else {
            return;
        };
        let kind = if whole { "a whole number" } else { "a finite number" };
        let allowed = form.range().map_or_else(|| kind.to_owned(), |range| format!("{kind} {range}"));
        let way_out = form.way_out().unwrap_or_else(|| "give a number in the allowed range".to_owned());
        self.findings.push(
            finding
                .field(path)
                .value(node.shown())
                .allowed(allowed)
                .way_out(way_out)
                .span(Some(node.span.clone())),
        );
    }

    fn text(&mut self, node: &Node, forms: &[Form<'s>], text: &str, path: &str) {
        if let Some(free) = forms.iter().find(|f| f.words.is_empty() && f.takes(&Kind::Text(String::new()))) {
            if free.is_date() && !is_date(text) {
                self.findings.push(
                    Diagnostic::new(Problem::UnknownValue, format!("`{path}` is no date of the calendar"))
                        .field(path)
                        .value(node.shown())
                        .allowed(free.expected())
                        .way_out(free.way_out().unwrap_or_else(|| "give year, month and day".to_owned()))
                        .span(Some(node.span.clone())),
                );
            }
            let length = text.chars().count() as f64;
            let (least, most) = (free.number("minLength"), free.number("maxLength"));
            if least.is_some_and(|l| length < l) || most.is_some_and(|l| length > l) {
                let most = most.map_or_else(String::new, |m| format!(" to {m}"));
                self.findings.push(
                    Diagnostic::new(
                        Problem::UnknownValue,
                        format!("the text of `{path}` has {length} characters"),
                    )
                    .field(path)
                    .value(node.shown())
                    .allowed(format!("{}{most} characters", least.unwrap_or(0.0)))
                    .way_out("give a text of this length")
                    .span(Some(node.span.clone())),
                );
            }
            return;
        }
        let words: Vec<&str> = forms.iter().flat_map(|f| f.words.iter().copied()).collect();
        if !words.contains(&text) {
            let others = forms
                .iter()
                .filter(|f| f.words.is_empty())
                .map(|f| format!(" or {}", f.expected()))
                .collect();
            self.unknown_word(node, text, &words, others, path);
        }
    }

    fn unknown_word(&mut self, node: &Node, text: &str, words: &[&str], others: String, path: &str) {
        let way_out = match nearest(text, words.iter().copied()) {
            Some(word) => format!("did you mean \"{word}\"?"),
            None => "use one of the allowed words".to_owned(),
        };
        self.findings.push(
            Diagnostic::new(
                Problem::UnknownValue,
                format!("`{path}` does not know the word {}", node.shown()),
            )
            .field(path)
            .value(node.shown())
            .allowed(listed(words) + &others)
            .way_out(way_out)
            .span(Some(node.span.clone())),
        );
    }

    fn list(&mut self, node: &Node, form: &Form<'s>, items: &[Node], path: &str) {
        let count = items.len() as f64;
        let (least, most) = (form.number("minItems"), form.number("maxItems"));
        if least.is_some_and(|l| count < l) || most.is_some_and(|l| count > l) {
            let most = most.map_or_else(|| " or more".to_owned(), |m| format!(" to {m}"));
            self.findings.push(
                Diagnostic::new(Problem::InvalidList, format!("the list `{path}` has {count} entries"))
                    .field(path)
                    .value(node.shown())
                    .allowed(format!("{}{most} entries", least.unwrap_or(0.0)))
                    .way_out("add or remove entries, or leave the key out where it has a default")
                    .span(Some(node.span.clone())),
            );
        }
        if form.keyword("uniqueItems") == Some(&Value::Bool(true)) {
            // Such lists hold words; anything else in them is told by its type.
            let mut seen = HashSet::new();
            for (i, item) in items.iter().enumerate() {
                if matches!(&item.kind, Kind::Text(word) if !seen.insert(word.as_str())) {
                    let message = format!("{} stands twice in `{path}`", item.shown());
                    self.findings.push(
                        Diagnostic::new(Problem::InvalidList, message)
                            .field(format!("{path}[{i}]"))
                            .value(item.shown())
                            .allowed("each entry once")
                            .way_out("delete one of the two")
                            .span(Some(item.span.clone())),
                    );
                }
            }
        }
        let fixed = form.keyword("prefixItems").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
        for (i, item) in items.iter().enumerate() {
            let path = format!("{path}[{i}]");
            match fixed.get(i).or_else(|| form.keyword("items")) {
                Some(schema) => self.node(item, schema, &path, None),
                None => self.anything(item, &path),
            }
        }
    }

    fn table(&mut self, node: &Node, forms: &[&Form<'s>], entries: &[Entry], path: &str) {
        let Some(form) = self.chosen(node, forms, path) else { return };
        for entry in entries {
            let path = joined(path, &entry.key);
            let value = form.properties.get(entry.key.as_str()).copied().or_else(|| form.other_values());
            match value {
                Some(schema) => self.node(&entry.value, schema, &path, Some(entry)),
                None if form.closed => self.unknown_key(entry, &form, &path),
                None => self.anything(&entry.value, &path),
            }
        }
        for key in form.required.iter().filter(|key| !entries.iter().any(|e| e.key == **key)) {
            self.missing_key(node, &form, path, key);
        }
    }

    /// Of several forms of a table the one that its tag names (the key whose word differs from form to form); without a
    /// tag the first that knows most of its keys.
    fn chosen(&mut self, node: &Node, forms: &[&Form<'s>], path: &str) -> Option<Form<'s>> {
        if let [only] = forms {
            return Some((*only).clone());
        }
        let word_of = |form: &Form<'s>, key: &str| {
            form.properties.get(key).and_then(|p| p.get("const")).and_then(Value::as_str)
        };
        let tag =
            forms[0].properties.keys().copied().find(|key| forms.iter().all(|f| word_of(f, key).is_some()));
        let Some(tag) = tag else {
            let known = |form: &Form<'s>| form.properties.keys().filter(|k| node.entry(k).is_some()).count();
            return forms.iter().rev().max_by_key(|form| known(form)).map(|form| (*form).clone());
        };
        let words: Vec<&str> = forms.iter().filter_map(|f| word_of(f, tag)).collect();
        let tag_path = joined(path, tag);
        match node.entry(tag).map(|entry| (&entry.value, &entry.value.kind)) {
            Some((value, Kind::Text(word))) => {
                let found = forms.iter().find(|f| word_of(f, tag) == Some(word));
                if found.is_none() {
                    self.unknown_word(value, word, &words, String::new(), &tag_path);
                }
                found.map(|form| (*form).clone())
            }
            Some((value, _)) => {
                self.findings.push(
                    Diagnostic::new(Problem::WrongType, format!("`{tag_path}` is {}", value.type_name()))
                        .field(tag_path.as_str())
                        .value(value.shown())
                        .allowed(listed(&words))
                        .way_out("write one of the allowed words, in quotes")
                        .span(Some(value.span.clone())),
                );
                None
            }
            None => {
                self.findings.push(
                    Diagnostic::new(Problem::MissingKey, format!("`{path}` has no key `{tag}`"))
                        .field(tag_path.as_str())
                        .allowed(listed(&words))
                        .way_out(format!("add `{tag} = \"{}\"` or another of the allowed words", words[0]))
                        .span(Some(node.span.clone())),
                );
                None
            }
        }
    }

    fn unknown_key(&mut self, entry: &Entry, form: &Form<'s>, path: &str) {
        let known: Vec<&str> = form.properties.keys().copied().collect();
        let way_out = match nearest(&entry.key, known.iter().copied()) {
            Some(key) => format!("did you mean `{key}`?"),
            None => "remove the key or move it to the table it belongs to".to_owned(),
        };
        self.findings.push(
            Diagnostic::new(
                Problem::UnknownKey,
                format!("the key `{}` is not known here", shortened(&entry.key)),
            )
            .field(shortened(path))
            .value(entry.value.shown())
            .allowed(known.join(", "))
            .way_out(way_out)
            .span(Some(entry.key_span.clone())),
        );
    }

    fn missing_key(&mut self, node: &Node, form: &Form<'s>, path: &str, key: &str) {
        let wanted =
            form.properties.get(key).map_or_else(Vec::new, |schema| Form::alternatives(self.schema, schema));
        let expected = wanted.iter().map(Form::expected).collect::<Vec<_>>().join(" or ");
        let table = wanted.iter().any(|f| f.types.contains(&"object")) && wanted.len() == 1;
        let (message, way_out) = match (path.is_empty(), table) {
            (true, true) => (
                format!("the table `[{key}]` is missing"),
                format!("add `[{key}]`; {}", self.subject.example),
            ),
            _ => {
                let advice = wanted.iter().find_map(Form::way_out);
                let way_out = advice.unwrap_or_else(|| format!("add `{key} = ...`"));
                let name = if path.is_empty() { self.subject.document } else { path };
                (format!("`{name}` has no key `{key}`"), way_out)
            }
        };
        let mut finding = Diagnostic::new(Problem::MissingKey, message)
            .field(joined(path, key))
            .allowed(expected)
            .way_out(way_out);
        if !path.is_empty() {
            finding = finding.span(Some(node.span.clone()));
        }
        self.findings.push(finding);
    }
}

fn joined(path: &str, key: &str) -> String {
    if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") }
}

/// Keys come from the file and may be of any length.
pub fn shortened(text: &str) -> String {
    const LONGEST: usize = 120;
    if text.chars().count() <= LONGEST {
        text.to_owned()
    } else {
        text.chars().take(LONGEST).chain("...".chars()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_names() {
        let keys = ["normal_module", "helix_angle_deg", "teeth"];
        assert_eq!(nearest("normal_modul", keys), Some("normal_module"));
        assert_eq!(nearest("Teeth", keys), Some("teeth"));
        assert_eq!(nearest("helixangle", keys), Some("helix_angle_deg"));
        assert_eq!(nearest("qqq", keys), None);
    }
}
