//! The structure of load spectra as the schema of REXS 2.0 has it. Their content is kept as it stands; nothing here knows loads.

use std::collections::HashSet;

use super::attribute_structure::attribute_structure;
use super::error::RexsError;
use super::xml_place::Place;

/// Checks a spectrum: its number, load cases each with a number of its own, at most one accumulation behind them, components that the model
/// has.
pub(super) fn check(spectrum: Place<'_, '_>, components: &HashSet<i32>) -> Result<i32, RexsError> {
    let number = spectrum.int("id")?;
    let parts = spectrum.children()?;
    let mut cases = HashSet::new();
    for (k, part) in parts.iter().enumerate() {
        match part.name() {
            "load_case" => {
                if !cases.insert(part.int("id")?) {
                    return Err(part.wrong("the number of a load case stands twice"));
                }
            }
            "accumulation" if k > 0 && k + 1 == parts.len() => {
                if part.children()?.is_empty() {
                    return Err(part.wrong("an accumulation needs at least one `component`"));
                }
            }
            _ => return Err(part.wrong("load cases and behind them at most one accumulation stand here")),
        }
        part.each("component", |component| {
            component.needed("type")?;
            component.each("attribute", attribute_structure)?;
            let id = component.int("id")?;
            if components.contains(&id) {
                Ok(())
            } else {
                Err(component.wrong(format!("it names component {id}, which is not there")))
            }
        })?;
    }
    if cases.is_empty() {
        return Err(spectrum.wrong("a load spectrum needs at least one `load_case`"));
    }
    Ok(number)
}
