//! Modifications as a job or a REXS file states them, and formulas.

use flankwright::modification::{EvaluationField, Modification, ModificationError, ModificationSpec};
use serde_json::json;

use crate::complaints::told_in_full;

/// A modification as JSON; what does not begin as one is a formula.
pub fn modification(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    let value = match text.starts_with('{') {
        true => serde_json::from_str(text),
        false => Ok(json!({ "kind": "formula", "f_um": text })),
    };
    let Ok(value) = value else { return };
    let spec = match ModificationSpec::from_json(&value) {
        Ok(spec) => spec,
        Err(error) => return refused(&error),
    };
    let written = serde_json::to_value(&spec).expect("a modification as JSON");
    assert_eq!(ModificationSpec::from_json(&written).as_ref(), Ok(&spec), "{written}");
    let field = EvaluationField::new([10.0, 30.0], [-20.0, 20.0], 38.0, 0.5).expect("a field");
    match Modification::build(&spec, &field) {
        Ok(modification) => on_the_field(&modification),
        Err(error) => refused(&error),
    }
}

fn refused(error: &ModificationError) {
    told_in_full(error.code(), &error.to_string(), &error.way_out());
}

/// What was built has a value at every place of the field, or says where it has none.
fn on_the_field(modification: &Modification) {
    for w in [10.0, 10.5, 20.0, 29.0, 30.0] {
        for z in [-20.0, -3.0, 0.0, 19.5, 20.0] {
            match (modification.value(w, z), modification.jet(w, z)) {
                (Ok(value), Ok(jet)) => {
                    let scale = 1.0 + value.abs();
                    assert!((jet.f - value).abs() <= 1e-9 * scale, "{value} and {} at {w}, {z}", jet.f);
                }
                (Err(error), _) | (_, Err(error)) => {
                    told_in_full(error.code(), &error.to_string(), &error.way_out());
                }
            }
        }
    }
}
