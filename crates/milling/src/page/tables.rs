//! Tables of the page: figures of the flanks, density, operations.

use super::{FlankView, MillingReport, OperationRow};
use report::charts::{format_fixed, format_significant};
use report::data::{Column, Table};

/// Deviations below this are printed as such: nothing in metrology is as small, um.
const ROUNDING_UM: f64 = 1e-4;

/// Figures of all flanks beside each other.
pub(super) fn deviations(report: &MillingReport) -> Table {
    let um = |x: f64| match x {
        x if x == 0.0 || x.abs() >= ROUNDING_UM => format_significant(x, 4),
        x if x > 0.0 => format!("< {ROUNDING_UM}"),
        _ => format!("> −{ROUNDING_UM}"),
    };
    let row = |flank: &FlankView| {
        let f = &flank.figures;
        let unmilled: Vec<String> =
            flank.unmilled.iter().map(|(reason, count)| format!("{count} ({reason})")).collect();
        vec![
            flank.name.clone(),
            um(f.max_um),
            um(f.rms_um),
            um(f.greatest_um),
            um(f.least_um),
            um(f.model_difference_um),
            um(f.referee_error_um),
            if unmilled.is_empty() { "none".into() } else { unmilled.join(", ") },
        ]
    };
    Table {
        caption: String::new(),
        columns: vec![
            Column::name("Flank"),
            Column::number("Largest", "µm"),
            Column::number("Rms", "µm"),
            Column::number("Highest stock", "µm"),
            Column::number("Deepest gouge", "µm"),
            Column::number("Prediction off by", "µm"),
            Column::number("Rays' own error", "µm"),
            Column::text("Rays not milled"),
        ],
        rows: report.flanks.iter().map(row).collect(),
        note: format!(
            "Deviations that the rays found, normal to the flank, > 0 stock; a gouge is < 0. Tolerance {} µm.",
            um(report.tolerance_um)
        ),
    }
}

/// The eight figures of every flank.
pub(super) fn density(flanks: &[FlankView]) -> Table {
    let mut columns = vec![Column::text("Distance of neighbours"), Column::number("Limit", "mm")];
    for flank in flanks {
        columns.push(Column::number(flank.name.clone(), "mm"));
        columns.push(Column::text("Kept"));
    }
    let count = flanks.iter().map(|flank| flank.density.len()).max().unwrap_or(0);
    let row = |k: usize| {
        let first = flanks.iter().find_map(|flank| flank.density.get(k));
        let limit = first.and_then(|row| row.limit_mm);
        let mut cells = vec![
            first.map_or_else(String::new, |row| row.name.clone()),
            limit.map_or_else(|| "–".into(), |mm| format_significant(mm, 4)),
        ];
        for flank in flanks {
            let here = flank.density.get(k);
            cells.push(here.map_or_else(String::new, |row| format_fixed(row.measured_mm, 4)));
            let kept = match here {
                Some(row) if row.violated => "NO",
                Some(row) if row.limit_mm.is_some() => "yes",
                _ => "",
            };
            cells.push(kept.into());
        }
        cells
    };
    Table {
        caption: String::new(),
        columns,
        rows: (0..count).map(row).collect(),
        note: "Along rows: from column to column; along columns: from row to row. A mean is that of one line. Overrun not counted."
            .into(),
    }
}

/// Operations in their order.
pub(super) fn operations(rows: &[OperationRow]) -> Table {
    let row = |operation: &OperationRow| {
        vec![
            operation.name.clone(),
            operation.cutter.clone(),
            operation.paths.to_string(),
            operation.places.to_string(),
            format_fixed(operation.way_mm, 1),
        ]
    };
    Table {
        caption: String::new(),
        columns: vec![
            Column::text("Operation"),
            Column::text("Cutter"),
            Column::number("Paths", ""),
            Column::number("Places", ""),
            Column::number("Way", "mm"),
        ],
        rows: rows.iter().map(row).collect(),
        note: "In one space; the way is that of the cutter's tip along the paths, without coming and going."
            .into(),
    }
}
