//! A job that is written into another directory than the one it was read from: the files that it names stay where they are, so their
//! paths become absolute.

use job::Loaded;
use serde::Serialize;
use serde_json::Value;

/// Keys whose text is the path of a file.
const PATHS: [&str; 4] = ["file", "worms_csv", "dressers_csv", "tolerance_map"];

/// `job` as it can be written anywhere; `loaded` tells where it came from.
///
/// # Errors
/// A job that JSON cannot hold.
pub fn standing_elsewhere<J: Serialize>(loaded: &Loaded<J>, job: &J) -> Result<Value, serde_json::Error> {
    let mut document = serde_json::to_value(job)?;
    if loaded.document.source().shelf().is_some() {
        // Names on a shelf mean the same wherever the job goes, and tell nothing of this machine.
        return Ok(document);
    }
    place(&mut document, &|file| {
        let path = loaded.beside(file);
        std::path::absolute(&path).unwrap_or(path).display().to_string()
    });
    Ok(document)
}

fn place(value: &mut Value, absolute: &dyn Fn(&str) -> String) {
    match value {
        Value::Object(keys) => {
            for (key, value) in keys {
                match value {
                    Value::String(file) if PATHS.contains(&key.as_str()) => *file = absolute(file),
                    other => place(other, absolute),
                }
            }
        }
        Value::Array(items) => items.iter_mut().for_each(|item| place(item, absolute)),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_path_becomes_absolute_and_nothing_else_changes() {
        let mut job = serde_json::json!({
            "job": { "name": "file" },
            "machine": { "file": "machine.toml" },
            "catalogue": { "worms_csv": "w.csv", "dressers_csv": "d.csv" },
            "target": { "tolerance_map": "t.csv", "modifications": [{ "kind": "sum", "children": [{ "file": "g.csv" }] }] },
        });
        place(&mut job, &|file| format!("/there/{file}"));
        assert_eq!(job["job"]["name"], "file");
        assert_eq!(job["machine"]["file"], "/there/machine.toml");
        assert_eq!(job["catalogue"]["dressers_csv"], "/there/d.csv");
        assert_eq!(job["target"]["tolerance_map"], "/there/t.csv");
        assert_eq!(job["target"]["modifications"][0]["children"][0]["file"], "/there/g.csv");
    }
}
