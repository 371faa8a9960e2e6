//! Conditions of dressing with what the planned motion leaves of them, where some are met as nearly as their weights ask.

use crate::workflow::ConditionResult;
use report::cells::{NONE, fixed, flank_title, significant};
use report::charts::{ChartError, format_significant};
use report::{Block, Column, Table};

/// The table; nothing where all conditions are met exactly.
///
/// # Errors
/// [`ChartError`] for values that are not finite.
pub(super) fn conditions(of: &[ConditionResult]) -> Result<Vec<Block>, ChartError> {
    if of.is_empty() {
        return Ok(Vec::new());
    }
    let row = |condition: &ConditionResult| -> Result<Vec<String>, ChartError> {
        let (kind, decimals) = words(condition.kind);
        Ok(vec![
            condition.flank.map_or(NONE, flank_title).to_owned(),
            kind.to_owned(),
            over_width(&condition.at),
            match condition.weight {
                None => "exact".to_owned(),
                Some(weight) => significant(kind, weight, 3)?,
            },
            fixed(kind, condition.largest_miss, decimals)?,
            fixed(kind, condition.rms_miss, decimals)?,
            unit(condition.unit).to_owned(),
        ])
    };
    Ok(vec![Block::Table(Table {
        caption: "Conditions of dressing and what the motion leaves of them".to_owned(),
        columns: vec![
            Column::text("Worm flank"),
            Column::text("Condition"),
            Column::number("Value over the width", ""),
            Column::number("Weight", ""),
            Column::number("Largest miss", ""),
            Column::number("Root mean square", ""),
            Column::text("Unit"),
        ],
        rows: of.iter().map(row).collect::<Result<_, _>>()?,
        note: "The sum of the squares of weight times miss is the least, where 1 µm of a point or of the head, 1 % of the profile of a map or of the stretch, 0.01° or 0.01 mm of a correction is a miss of 1. Points and maps are named by their share of the profile, which runs from 0 where the worm grinds the tip of the gear to 1; q runs from −1 to 1 over the worm in use.".to_owned(),
    })])
}

/// A condition in words, and the decimals of its miss.
fn words(kind: &str) -> (&'static str, usize) {
    match kind {
        "point" => ("point of the profile", 3),
        "map" => ("radius map", 3),
        "stretch" => ("stretch of the profile", 3),
        "head" => ("height of the head", 3),
        "phi_S" => ("angle of the worm", 5),
        "gamma" => ("crossing angle", 5),
        "d" => ("centre distance", 5),
        _ => ("offset of the dresser", 5),
    }
}

fn unit(name: &str) -> &str {
    match name {
        "um" => "µm",
        "percent" => "%",
        "deg" => "°",
        other => other,
    }
}

/// A number, or a polynomial in q.
fn over_width(coefficients: &[f64]) -> String {
    let mut text = String::new();
    for (k, c) in coefficients.iter().enumerate().filter(|(k, c)| *k == 0 || **c != 0.0) {
        let power = match k {
            0 => String::new(),
            1 => " q".to_owned(),
            k => format!(" q^{k}"),
        };
        let (sign, c) = match (k, *c < 0.0) {
            (0, _) => ("", *c),
            (_, true) => (" − ", -c),
            (_, false) => (" + ", *c),
        };
        text += &format!("{sign}{}{power}", format_significant(c, 4));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::over_width;

    #[test]
    fn a_law_over_the_width_is_written_as_a_polynomial() {
        assert_eq!(over_width(&[0.5]), "0.5");
        assert_eq!(over_width(&[-0.5, 0.25, 0.0, -2.0]), "−0.5 + 0.25 q − 2 q^3");
    }
}
