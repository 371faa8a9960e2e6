//! Entries of a job's text set or taken out. In TOML, comments and order stay as they are; JSON is written anew. Knows no key of a job.

use serde_json::Value as Json;
use toml_edit::{Array, DocumentMut, InlineTable, Item, Table, TableLike, Value};

use crate::wire::{Edit, Step};

/// Steps of a path: jobs have a few, and each is a level of the stack.
pub const MOST_STEPS: usize = 64;
/// Changes at once.
pub const MOST_EDITS: usize = 256;

/// Bytes of a value: as text it is small, as entries of a job it is many times as large.
pub const MOST_VALUE: usize = 256 << 10;

/// Why an entry cannot be set.
#[derive(Debug, PartialEq)]
pub struct Unedited {
    /// Which.
    pub path: String,
    /// Why.
    pub why: String,
}

fn written(path: &[Step]) -> String {
    let mut text = String::new();
    for step in path {
        match step {
            Step::Key(key) if text.is_empty() => text += key,
            Step::Key(key) => text += &format!(".{key}"),
            Step::Place(place) => text += &format!("[{place}]"),
        }
    }
    text
}

/// The text with all changes.
///
/// # Errors
/// The first path that leads nowhere, a value that the format does not have, or a text that cannot be parsed.
pub fn edited(text: &str, edits: &[Edit]) -> Result<String, Unedited> {
    let whole = |why: String| Unedited { path: String::new(), why };
    if edits.len() > MOST_EDITS {
        return Err(whole(format!(
            "there are {} changes; at most {MOST_EDITS} are made at once",
            edits.len()
        )));
    }
    if let Some(edit) = edits.iter().find(|edit| edit.path.len() > MOST_STEPS) {
        let why = format!("the path has {} steps; at most {MOST_STEPS} are followed", edit.path.len());
        return Err(Unedited { path: written(&edit.path[..4]) + "...", why });
    }
    let values =
        edits.iter().map(|edit| value(edit).map_err(|why| Unedited { path: written(&edit.path), why }));
    let values: Vec<Json> = values.collect::<Result<_, _>>()?;
    if text.trim_start().starts_with('{') {
        let mut tree: Json =
            serde_json::from_str(text).map_err(|error| whole(format!("the text is no JSON: {error}")))?;
        for (edit, value) in edits.iter().zip(&values) {
            let failed = |why: &str| Unedited { path: written(&edit.path), why: why.to_owned() };
            in_json(&mut tree, &edit.path, value).map_err(failed)?;
        }
        return serde_json::to_string_pretty(&tree)
            .map(|text| text + "\n")
            .map_err(|error| whole(error.to_string()));
    }
    let mut document: DocumentMut =
        text.parse().map_err(|error| whole(format!("the text is no TOML: {error}")))?;
    for (edit, value) in edits.iter().zip(&values) {
        let failed = |why: &str| Unedited { path: written(&edit.path), why: why.to_owned() };
        in_item(document.as_item_mut(), &edit.path, value, 0).map_err(failed)?;
    }
    Ok(document.to_string())
}

fn value(edit: &Edit) -> Result<Json, String> {
    let text = edit.value.get();
    if text.len() > MOST_VALUE {
        return Err(format!("the value has {} bytes; an entry has at most {MOST_VALUE}", text.len()));
    }
    serde_json::from_str(text).map_err(|error| format!("the value cannot be read: {error}"))
}

const NO_PATH: &str = "a path is a list of keys and places, and not empty";
const NO_TABLE: &str = "there is no table at this place";
const NO_LIST: &str = "there is no list at this place";
const BEYOND: &str = "the list is shorter";
const NO_VALUE: &str = "TOML has no such value: null, or a number beyond 64 bits";

fn in_json(tree: &mut Json, steps: &[Step], value: &Json) -> Result<(), &'static str> {
    let (first, rest) = steps.split_first().ok_or(NO_PATH)?;
    match (first, tree) {
        (Step::Key(key), Json::Object(keys)) if rest.is_empty() => {
            if value.is_null() {
                keys.remove(key);
            } else {
                keys.insert(key.clone(), value.clone());
            }
            Ok(())
        }
        (Step::Key(key), Json::Object(keys)) => {
            in_json(keys.entry(key).or_insert_with(|| Json::Object(Default::default())), rest, value)
        }
        (Step::Key(_), _) => Err(NO_TABLE),
        (Step::Place(place), Json::Array(items)) if rest.is_empty() => match place.cmp(&items.len()) {
            std::cmp::Ordering::Less if value.is_null() => {
                items.remove(*place);
                Ok(())
            }
            std::cmp::Ordering::Less => {
                items[*place] = value.clone();
                Ok(())
            }
            std::cmp::Ordering::Equal if !value.is_null() => {
                items.push(value.clone());
                Ok(())
            }
            _ => Err(BEYOND),
        },
        (Step::Place(place), Json::Array(items)) => {
            in_json(items.get_mut(*place).ok_or(BEYOND)?, rest, value)
        }
        (Step::Place(_), _) => Err(NO_LIST),
    }
}

/// `depth`: how many keys lead to `item`; below the first level new tables stand in a line.
fn in_item(item: &mut Item, steps: &[Step], value: &Json, depth: usize) -> Result<(), &'static str> {
    let (first, rest) = steps.split_first().ok_or(NO_PATH)?;
    match first {
        Step::Key(key) => {
            let table = item.as_table_like_mut().ok_or(NO_TABLE)?;
            if rest.is_empty() && depth == 0 && value.is_object() {
                // A table of the job stands under its heading.
                let Some(Value::InlineTable(given)) = toml(value) else { return Err(NO_VALUE) };
                table.insert(key, Item::Table(given.into_table()));
                return Ok(());
            }
            if rest.is_empty() {
                return in_table(table, key, value);
            }
            if table.get(key).is_none_or(Item::is_none) {
                if value.is_null() {
                    return Ok(());
                }
                let new = if depth == 0 {
                    Item::Table(Table::new())
                } else {
                    Item::Value(InlineTable::new().into())
                };
                table.insert(key, new);
            }
            in_item(table.get_mut(key).ok_or(NO_TABLE)?, rest, value, depth + 1)
        }
        Step::Place(place) => match item {
            Item::ArrayOfTables(tables) if rest.is_empty() && value.is_null() => {
                if *place >= tables.len() {
                    return Err(BEYOND);
                }
                tables.remove(*place);
                Ok(())
            }
            Item::ArrayOfTables(tables) if rest.is_empty() => {
                let Some(Value::InlineTable(given)) = toml(value) else { return Err(NO_VALUE) };
                match place.cmp(&tables.len()) {
                    std::cmp::Ordering::Less => {
                        if let Some(table) = tables.get_mut(*place) {
                            *table = given.into_table();
                        }
                        Ok(())
                    }
                    std::cmp::Ordering::Equal => {
                        tables.push(given.into_table());
                        Ok(())
                    }
                    std::cmp::Ordering::Greater => Err(BEYOND),
                }
            }
            Item::ArrayOfTables(tables) => {
                let table = tables.get_mut(*place).ok_or(BEYOND)?;
                in_like(table, rest, value)
            }
            Item::Value(Value::Array(items)) => in_list(items, *place, rest, value),
            _ => Err(NO_LIST),
        },
    }
}

/// Inside of a table that is no item by itself.
fn in_like(table: &mut dyn TableLike, steps: &[Step], value: &Json) -> Result<(), &'static str> {
    let (Some(Step::Key(key)), rest) = (steps.first(), steps.get(1..).unwrap_or_default()) else {
        return Err(NO_TABLE);
    };
    if rest.is_empty() {
        return in_table(table, key, value);
    }
    if table.get(key).is_none() {
        table.insert(key, Item::Value(InlineTable::new().into()));
    }
    in_item(table.get_mut(key).ok_or(NO_TABLE)?, rest, value, 1)
}

fn in_table(table: &mut dyn TableLike, key: &str, value: &Json) -> Result<(), &'static str> {
    if value.is_null() {
        table.remove(key);
        return Ok(());
    }
    let mut new = toml(value).ok_or(NO_VALUE)?;
    match table.get_mut(key) {
        Some(Item::Value(old)) => {
            *new.decor_mut() = old.decor().clone();
            *old = new;
        }
        Some(other) => *other = Item::Value(new),
        None => {
            table.insert(key, Item::Value(new));
        }
    }
    Ok(())
}

fn in_list(items: &mut Array, place: usize, rest: &[Step], value: &Json) -> Result<(), &'static str> {
    if !rest.is_empty() {
        let Some(inner) = items.get_mut(place) else { return Err(BEYOND) };
        return match inner {
            Value::InlineTable(table) => in_like(table, rest, value),
            Value::Array(inner) => match rest.split_first() {
                Some((Step::Place(place), rest)) => in_list(inner, *place, rest, value),
                _ => Err(NO_TABLE),
            },
            _ => Err(NO_TABLE),
        };
    }
    match place.cmp(&items.len()) {
        std::cmp::Ordering::Less if value.is_null() => {
            items.remove(place);
            Ok(())
        }
        std::cmp::Ordering::Less => {
            let mut new = toml(value).ok_or(NO_VALUE)?;
            if let Some(old) = items.get(place) {
                *new.decor_mut() = old.decor().clone();
            }
            items.replace_formatted(place, new);
            Ok(())
        }
        std::cmp::Ordering::Equal if !value.is_null() => {
            push(items, toml(value).ok_or(NO_VALUE)?);
            Ok(())
        }
        _ => Err(BEYOND),
    }
}

/// Adds a value as its neighbour stands: in a line of its own, or in the same. A comment behind the neighbour stays there.
fn push(items: &mut Array, mut new: Value) {
    fn text(raw: Option<&toml_edit::RawString>) -> String {
        raw.and_then(toml_edit::RawString::as_str).unwrap_or_default().to_owned()
    }
    let before = items.iter().last().map(|last| text(last.decor().prefix()));
    let Some(line) = before.filter(|before| before.contains('\n')) else {
        items.push(new);
        return;
    };
    let indent = &line[line.rfind('\n').unwrap_or_default()..];
    // What stood between the neighbour and the end of the list.
    let mut behind = text(items.iter().last().and_then(|last| last.decor().suffix()));
    behind += items.trailing().as_str().unwrap_or_default();
    let comment = behind.trim_end();
    let comment = if comment.contains('#') { comment } else { "" };
    new.decor_mut().set_prefix(format!("{comment}{indent}"));
    new.decor_mut().set_suffix("");
    let place = items.len();
    if let Some(last) = place.checked_sub(1).and_then(|last| items.get_mut(last)) {
        last.decor_mut().set_suffix("");
    }
    items.push_formatted(new);
    items.set_trailing_comma(true);
    items.set_trailing("\n");
}

/// A value of TOML.
fn toml(value: &Json) -> Option<Value> {
    Some(match value {
        Json::Null => return None,
        Json::Bool(value) => (*value).into(),
        Json::String(text) => text.as_str().into(),
        Json::Number(number) => match number.as_i64() {
            Some(whole) => whole.into(),
            None => number.as_f64().filter(|number| number.is_finite())?.into(),
        },
        Json::Array(items) => items.iter().map(toml).collect::<Option<Array>>()?.into(),
        Json::Object(keys) => {
            let mut table = InlineTable::new();
            for (key, value) in keys {
                table.insert(key, toml(value)?);
            }
            table.into()
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;
    use serde_json::value::to_raw_value;

    fn with(text: &str, path: Json, value: Json) -> Result<String, Unedited> {
        edited(
            text,
            &[Edit { path: serde_json::from_value(path).unwrap(), value: to_raw_value(&value).unwrap() }],
        )
    }

    const JOB: &str = "# a job\n[gear]\nteeth = 31 # prime\nhelix_angle_deg = 20\n\n[target]\nmodifications = [\n  { kind = \"helix_crowning\", amount_um = 20 }, # wanted\n]\n";

    #[test]
    fn comments_and_order_stay() {
        let changed = with(JOB, json!(["gear", "teeth"]), json!(37)).unwrap();
        assert_eq!(changed, JOB.replace("31", "37"));
        let changed = with(JOB, json!(["target", "modifications", 0, "amount_um"]), json!(12.5)).unwrap();
        assert_eq!(changed, JOB.replace("amount_um = 20", "amount_um = 12.5"));
    }

    #[test]
    fn what_is_absent_is_made_and_null_takes_out() {
        let changed = with(JOB, json!(["worm", "threads"]), json!(3)).unwrap();
        assert_eq!(changed, format!("{JOB}\n[worm]\nthreads = 3\n"));
        let changed = with(JOB, json!(["worm"]), json!({ "threads": 3 })).unwrap();
        assert_eq!(changed, format!("{JOB}\n[worm]\nthreads = 3\n"));
        let changed = with(JOB, json!(["gear", "evaluation", "z_start"]), json!(-14.0)).unwrap();
        assert!(changed.contains("evaluation = { z_start = -14.0 }"), "{changed}");
        let changed = with(JOB, json!(["gear", "helix_angle_deg"]), json!(null)).unwrap();
        assert!(!changed.contains("helix_angle_deg") && changed.contains("# prime"), "{changed}");
        assert_eq!(with(JOB, json!(["worm", "threads"]), json!(null)).unwrap(), JOB);
    }

    #[test]
    fn lists_grow_and_shrink() {
        let new = || json!({ "kind": "profile_crowning", "amount_um": 5 });
        let added = "  { amount_um = 5, kind = \"profile_crowning\" },\n";
        let grown = with(JOB, json!(["target", "modifications", 1]), new()).unwrap();
        assert_eq!(grown, JOB.replace("# wanted\n", &format!("# wanted\n{added}")));
        let shrunk = with(&grown, json!(["target", "modifications", 0]), json!(null)).unwrap();
        assert!(!shrunk.contains("helix_crowning") && shrunk.parse::<DocumentMut>().is_ok(), "{shrunk}");
        // Without a comma behind the last one, and all in one line.
        let bare = JOB.replace("}, # wanted", "} # wanted");
        let grown = with(&bare, json!(["target", "modifications", 1]), new()).unwrap();
        assert_eq!(grown, JOB.replace("# wanted\n", &format!("# wanted\n{added}")));
        let line = "a = [1, 2] # two\n";
        assert_eq!(with(line, json!(["a", 2]), json!(3)).unwrap(), "a = [1, 2, 3] # two\n");
        assert_eq!(with("a = []\n", json!(["a", 0]), json!(3)).unwrap(), "a = [3]\n");
    }

    #[test]
    fn json_stays_json() {
        let changed = with("{\"gear\": {\"teeth\": 31}}", json!(["gear", "teeth"]), json!(37)).unwrap();
        assert_eq!(serde_json::from_str::<Json>(&changed).unwrap(), json!({ "gear": { "teeth": 37 } }));
    }

    #[test]
    fn paths_that_lead_nowhere_are_told() {
        let failed = with(JOB, json!(["gear", "teeth", "x"]), json!(1)).unwrap_err();
        assert_eq!((failed.path.as_str(), failed.why.as_str()), ("gear.teeth.x", NO_TABLE));
        let failed = with(JOB, json!(["target", "modifications", 4]), json!({})).unwrap_err();
        assert_eq!((failed.path.as_str(), failed.why.as_str()), ("target.modifications[4]", BEYOND));
        assert_eq!(with(JOB, json!([]), json!(1)).unwrap_err().why, NO_PATH);
        let deep = with(JOB, json!(vec!["a"; MOST_STEPS + 1]), json!(1)).unwrap_err();
        assert_eq!((deep.path.as_str(), deep.why.contains("65 steps")), ("a.a.a.a...", true));
        assert!(with(JOB, json!(vec!["a"; MOST_STEPS]), json!(1)).is_ok());
        let many: Vec<Edit> = (0..=MOST_EDITS)
            .map(|_| Edit { path: vec![Step::Key("a".into())], value: to_raw_value(&1).unwrap() })
            .collect();
        assert!(edited(JOB, &many).unwrap_err().why.contains("257 changes"));
        let large = with(JOB, json!(["a"]), json!(vec![0; MOST_VALUE])).unwrap_err();
        assert!(large.why.contains("at most 262144"), "{}", large.why);
        assert!(with("= 1", json!(["a"]), json!(1)).unwrap_err().why.contains("no TOML"));
    }
}
