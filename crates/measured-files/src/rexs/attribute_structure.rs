//! The structure of attributes and their lists as the schema of REXS 2.0 has it.

use super::error::RexsError;
use super::xml_place::Place;

/// An attribute has a name, and at most one list.
pub(super) fn attribute_structure(node: Place<'_, '_>) -> Result<(), RexsError> {
    node.needed("id")?;
    let lists: Vec<Place<'_, '_>> = node.elements().collect();
    for list in &lists {
        list_structure(*list)?;
    }
    if lists.len() > 1 { Err(node.wrong("an attribute has at most one list")) } else { Ok(()) }
}

/// `array`, `matrix` and `array_of_arrays` with the codes of the schema.
fn list_structure(list: Place<'_, '_>) -> Result<(), RexsError> {
    if let Some(code) = list.get("code")
        && !["float64", "float32", "int32"].contains(&code)
    {
        return Err(list.wrong("a code is float64, float32 or int32"));
    }
    let inner = match list.name() {
        "array" => "c",
        "matrix" => "r",
        "array_of_arrays" => "array",
        "r" => "c",
        "c" => {
            return if list.elements().next().is_some() {
                Err(list.wrong("a cell holds text"))
            } else {
                Ok(())
            };
        }
        _ => return Err(list.wrong("an attribute holds text, array, matrix or array_of_arrays")),
    };
    if ["r", "array_of_arrays"].contains(&list.name()) && list.elements().next().is_none() {
        return Err(list.wrong(format!("at least one `{inner}` is needed here")));
    }
    for child in list.elements() {
        if child.name() != inner {
            return Err(child.wrong("another element than the schema has here"));
        }
        list_structure(child)?;
    }
    Ok(())
}
