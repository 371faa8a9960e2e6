//! Machines by the names that the file has for them.

use super::super::given::Checked;
use machine::Machine;
pub(super) use machine::five_axis::Places;
use machine::five_axis::{self, Chain};

/// The machine of that name.
pub(super) fn chain(name: &str, places: &Places) -> Checked<Machine> {
    let kind = match name {
        "AC_table_table" => Chain::AcTable,
        "BC_table_table" => Chain::BcTable,
        "CB_nutating45_table_table" => Chain::NutatingTable,
        "B_head_C_table" => Chain::HeadTable,
        "CA_head_head" => Chain::HeadHead,
        _ => return Err(format!("the chain {name:?} is unknown").into()),
    };
    Ok(five_axis::chain(kind, places)?)
}
