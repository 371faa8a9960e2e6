//! Documents of results and their schemas: each document meets the schema of one kind, and of no other.

use crate::command::run;
use jsonschema::Validator;
use serde_json::{Value, json};
use std::path::Path;

/// The schemas that the program prints.
pub struct Documents(Vec<(String, String, Validator)>);

impl Documents {
    /// Of all kinds that it lists.
    pub fn of_the_program() -> Self {
        let listed = run(&["schema", "result", "--json"]).json();
        let one = |listed: &Value| {
            let [kind, file] = ["kind", "file"].map(|key| listed[key].as_str().expect("a name").to_owned());
            let schema = run(&["schema", "result", &kind]).json();
            let validator =
                jsonschema::draft202012::new(&schema).unwrap_or_else(|error| panic!("{kind}: {error}"));
            (kind, file, validator)
        };
        Self(listed.as_array().expect("a list").iter().map(one).collect())
    }

    /// The kinds whose schema a document of this file meets.
    fn kinds(&self, file: &str, document: &Value) -> Vec<&str> {
        let of_file = self.0.iter().filter(|(_, of, _)| of == file);
        of_file.filter(|(_, _, schema)| schema.is_valid(document)).map(|(kind, ..)| kind.as_str()).collect()
    }

    /// Looks at the documents of a folder, where there are any.
    pub fn meets_one_schema(&self, folder: &Path) {
        for file in ["result.json", "explore.json", "series.json"] {
            let Ok(text) = std::fs::read(folder.join(file)) else { continue };
            let document: Value = serde_json::from_slice(&text).expect("JSON");
            let kinds = self.kinds(file, &document);
            if kinds.len() != 1 {
                let told: Vec<String> = self
                    .0
                    .iter()
                    .filter(|(_, of, _)| of == file)
                    .map(|(kind, _, schema)| {
                        let first = schema.iter_errors(&document).next();
                        format!(
                            "{kind}: {}",
                            first.map_or_else(|| "met".into(), |e| format!("{} {e}", e.instance_path()))
                        )
                    })
                    .collect();
                panic!("{}/{file}: {kinds:?}\n{}", folder.display(), told.join("\n"));
            }
        }
    }
}

#[test]
fn every_key_of_a_result_is_described() {
    for listed in run(&["schema", "result", "--json"]).json().as_array().expect("a list") {
        let kind = listed["kind"].as_str().expect("a kind");
        let schema = run(&["schema", "result", kind]).json();
        let mut tables: Vec<(&str, &Value)> = vec![(kind, &schema)];
        tables.extend(
            schema["$defs"].as_object().into_iter().flatten().map(|(name, table)| (name.as_str(), table)),
        );
        for (name, table) in tables {
            for (key, value) in table["properties"].as_object().into_iter().flatten() {
                assert!(value["description"].is_string(), "{kind}: {name}.{key}");
            }
        }
    }
}

#[test]
fn a_document_that_lacks_something_meets_no_schema() {
    let documents = Documents::of_the_program();
    assert!(
        documents.kinds("result.json", &json!({ "job": "a", "process": "five-axis-milling" })).is_empty()
    );
}

#[test]
fn an_unknown_kind_lists_those_there_are() {
    let refused = run(&["schema", "result", "milling", "--json"]);
    assert_eq!(refused.exit, Some(2));
    assert!(
        refused.json()["error"]["allowed"].as_str().is_some_and(|kinds| kinds.contains("five-axis-milling"))
    );
}
