//! Figures of the contact patterns beside each other.

use super::shown::ShownContact;
use crate::workflow::PatternResult;
use report::charts::{format_fixed, format_significant};
use report::{Column, Table};

/// The patterns of every flank, those that were rolled with their transmission errors.
pub(super) fn patterns(flanks: &[ShownContact<'_>]) -> Table {
    let mut rows = Vec::new();
    for flank in flanks {
        let result = flank.result;
        let error = [result.transmission_error_arcsec, result.transmission_error_um];
        let error = error.map(|x| format_significant(x, 3));
        rows.push(row(flank, "rolled", result.rolled.as_ref(), error));
        let none = [String::new(), String::new()];
        for (k, part) in result.parts.iter().enumerate().filter(|_| result.parts.len() > 1) {
            rows.push(row(flank, &format!("part {}", k + 1), Some(part), [String::new(), String::new()]));
        }
        if let (Some(arcsec), Some(um)) =
            (result.transmission_error_milled_arcsec, result.transmission_error_milled_um)
        {
            let error = [arcsec, um].map(|x| format_significant(x, 3));
            rows.push(row(flank, "as milled", result.milled.as_ref(), error));
        }
        rows.push(row(flank, "by the ease-offs", result.ease_off.as_ref(), none));
    }
    Table {
        caption: String::new(),
        columns: vec![
            Column::name("Flank"),
            Column::text("Pattern"),
            Column::number("Area", "%"),
            Column::number("Centre along", "%"),
            Column::number("Along", "%"),
            Column::number("Centre up", "%"),
            Column::number("Up", "%"),
            Column::number("Transmission error", "arcsec"),
            Column::number("at the pitch circle", "µm"),
        ],
        rows,
        note: "Percent of the active flank: 0 at toe (or lower face) and root, 100 at heel (or upper face) and tip. The transmission error \
               is peak to peak."
            .into(),
    }
}

fn row(
    flank: &ShownContact<'_>,
    source: &str,
    pattern: Option<&PatternResult>,
    error: [String; 2],
) -> Vec<String> {
    let percent = |x: f64| format_fixed(x, 1);
    let range = |[from, to]: [f64; 2]| format!("{} to {}", percent(from), percent(to));
    let mut cells = vec![flank.name(), source.into()];
    cells.extend(match pattern {
        Some(p) => [
            percent(p.area_percent),
            percent(p.centre_length_percent),
            range(p.length_percent),
            percent(p.centre_height_percent),
            range(p.height_percent),
        ],
        None => ["0".into(), "none".into(), "none".into(), "none".into(), "none".into()],
    });
    cells.extend(error);
    cells
}
