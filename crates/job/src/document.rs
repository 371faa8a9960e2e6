//! A parsed job document: the tree of its values and the place of each in the text. Knows no key of a job.

use std::ops::Range;
use std::path::Path;

use serde_json::Value;

use super::diagnostic::Diagnostic;
use super::job_error::JobError;
use super::node::Node;
use super::source::Source;
use super::{json_tree, toml_tree};

/// A TOML or JSON document with spans.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    source: Source,
    root: Node,
}

impl Document {
    /// Reads and parses a file.
    ///
    /// # Errors
    /// Those of [`Source::read`] and [`Document::parse`].
    pub fn read(path: &Path) -> Result<Self, JobError> {
        Self::parse(Source::read(path)?)
    }

    /// Parses a text. The ending of the name decides between TOML and JSON; with any other ending a text that
    /// begins with `{` is JSON.
    ///
    /// # Errors
    /// `invalid-toml`, `invalid-json`, `duplicate-key`, `nested-too-deeply`, each with its place.
    pub fn parse(source: Source) -> Result<Self, JobError> {
        let ending = Path::new(source.name()).extension().map(|e| e.to_ascii_lowercase());
        let json = match ending.as_ref().and_then(|e| e.to_str()) {
            Some("json") => true,
            Some("toml") => false,
            _ => source.text().trim_start().starts_with('{'),
        };
        Self::parse_with(source, if json { json_tree::parse } else { toml_tree::parse })
    }

    /// Parses a text of another format.
    /// # Errors
    /// Those of `parse`.
    pub fn parse_with(
        source: Source,
        parse: impl FnOnce(&str) -> Result<Node, Diagnostic>,
    ) -> Result<Self, JobError> {
        match parse(source.text()) {
            Ok(root) => Ok(Self { source, root }),
            Err(finding) => Err(JobError::single(source, finding)),
        }
    }

    /// Name and text.
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// The whole document as a JSON value.
    pub fn to_value(&self) -> Value {
        self.root.to_value()
    }

    /// Place of the value of a path such as `gear.normal_module` or `target.modifications[1].amount_um`.
    pub fn span_of(&self, path: &str) -> Option<Range<usize>> {
        self.root.follow(path).map(|(node, _)| node.span.clone())
    }

    /// Place of the key of a path; none for entries of a list.
    pub fn key_span_of(&self, path: &str) -> Option<Range<usize>> {
        self.root.follow(path).and_then(|(_, key)| key)
    }

    /// Place of the value or, where it is absent, of the nearest table around it that stands in the text. Inline
    /// values are marked whole, tables by their key.
    pub fn nearest_span(&self, path: &str) -> Option<Range<usize>> {
        let mut path = path;
        loop {
            if let Some((node, key)) = self.root.follow(path)
                && !path.is_empty()
            {
                let long = self.source.text().get(node.span.clone()).is_none_or(|text| text.contains('\n'));
                return if long { key.or(Some(node.span.clone())) } else { Some(node.span.clone()) };
            }
            path = &path[..path.rfind(['.', '['])?];
        }
    }

    /// The tree of the values.
    pub fn root(&self) -> &Node {
        &self.root
    }

    /// A finding with the place of its key in this document, where it has none yet.
    pub fn placed(&self, finding: Diagnostic) -> Diagnostic {
        if finding.span.is_some() {
            return finding;
        }
        let span = finding.field.as_ref().and_then(|field| self.nearest_span(field));
        finding.span(span)
    }

    /// An error about this document; the key of the finding decides its place.
    pub fn error(&self, finding: Diagnostic) -> JobError {
        JobError::single(self.source.clone(), self.placed(finding))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text_at(document: &Document, span: Option<Range<usize>>) -> &str {
        &document.source().text()[span.unwrap()]
    }

    #[test]
    fn spans_of_toml_and_json() {
        let toml = "[gear]\nnormal_module = 3.5\n[target]\nmodifications = [ {a = 1}, {amount_um = -2.5} ]\n";
        let json = r#"{"gear": {"normal_module": 3.5}, "target": {"modifications": [{"a": 1}, {"amount_um": -2.5}]}}"#;
        for (name, text) in [("a.toml", toml), ("a.json", json), ("-", json)] {
            let document = Document::parse(Source::new(name, text)).unwrap();
            assert_eq!(text_at(&document, document.span_of("gear.normal_module")), "3.5");
            assert_eq!(text_at(&document, document.span_of("target.modifications[1].amount_um")), "-2.5");
            let key = text_at(&document, document.key_span_of("target.modifications[1].amount_um"));
            assert_eq!(key.trim_matches('"'), "amount_um");
            assert_eq!(document.span_of("gear.teeth"), None);
            assert_eq!(document.span_of("target.modifications[2]"), None);
            assert!(document.nearest_span("gear.teeth").is_some());
            assert_eq!(document.nearest_span("worm.threads"), None);
        }
    }

    #[test]
    fn both_formats_give_the_same_value() {
        let toml =
            Document::parse(Source::new("a.toml", "[a]\nb = [1, 2.5, \"c\", true]\nd = {e = -1e3}")).unwrap();
        let json = r#"{"a": {"b": [1, 2.5, "c", true], "d": {"e": -1e3}}}"#;
        let json = Document::parse(Source::new("a.json", json)).unwrap();
        assert_eq!(toml.to_value(), json.to_value());
    }

    #[test]
    fn malformed_texts_name_their_place() {
        let cases = [
            ("a.toml", "[gear]\nteeth = = 3\n", "invalid-toml", 2),
            ("a.toml", "[gear]\nteeth = 3\nteeth = 4\n", "duplicate-key", 3),
            ("a.toml", "[gear\n", "invalid-toml", 1),
            ("a.json", "{\"gear\": {\n\"teeth\": 3,}}", "invalid-json", 2),
            ("a.json", "{\"gear\": {\n\"teeth\": 3, \"teeth\": 4}}", "duplicate-key", 2),
            ("a.json", "{\"gear\": \n NaN}", "invalid-json", 2),
            ("a.json", "", "invalid-json", 1),
        ];
        for (name, text, code, line) in cases {
            let error = Document::parse(Source::new(name, text)).unwrap_err();
            assert_eq!(error.diagnostics[0].code, code, "{text}");
            let span = error.diagnostics[0].span.clone().unwrap();
            assert_eq!(error.source.line_column(span.start).0, line, "{text}: {error}");
        }
    }

    #[test]
    fn deep_nesting_is_refused() {
        for (name, open) in [("a.toml", "a = "), ("a.json", "")] {
            for depth in [70, 100_000] {
                let text = format!("{open}{}{}", "[".repeat(depth), "]".repeat(depth));
                let error = Document::parse(Source::new(name, &text)).unwrap_err();
                assert_eq!(error.diagnostics[0].code, "nested-too-deeply", "{name} {depth}: {error}");
            }
        }
        // Dotted keys and headers nest as well.
        let keys = vec!["a"; 5000].join(".");
        for text in [format!("{keys} = 1"), format!("[{keys}]")] {
            assert!(Document::parse(Source::new("a.toml", &text)).is_err());
        }
    }
}
