//! Values with the classes that they reach, for first pages.

use crate::workflow::ClassResult;
use report::cells::NONE;
use report::charts::format_fixed;
use report::{Column, Table};

/// Values with their classes beside the one that is asked for.
pub(super) fn class_table<'a>(
    standard: &str,
    shown: impl IntoIterator<Item = &'a ClassResult>,
    asked: Option<i32>,
    note: &str,
) -> Table {
    let asked = asked.map_or_else(|| NONE.to_owned(), |class| class.to_string());
    let row = |one: &ClassResult| {
        vec![
            one.quantity.to_owned(),
            one.flank.unwrap_or("both").to_owned(),
            format_fixed(one.value_um, 2),
            one.class.map_or_else(|| "> 11".to_owned(), |class| class.to_string()),
            asked.clone(),
        ]
    };
    Table {
        caption: format!("Values and classes to {standard}"),
        columns: vec![
            Column::name("Characteristic"),
            Column::text("Flank"),
            Column::number("Measured", "µm"),
            Column::number("Class reached", ""),
            Column::number("Class asked for", ""),
        ],
        rows: shown.into_iter().map(row).collect(),
        note: note.to_owned(),
    }
}
