//! Profiles of a workpiece as a probe found them, as a table: CSV with the columns flank, gap, roll_mm and deviation_um, one value a row:
//! deviations normal to the flank against the involute, positive where material stands.

use foundation::geometry::Flank;
use job::decimal_comma::with_points;
use job::table_rows::{Row, TableForm};
use job::{Cell, Column, CsvError, CsvTable, Diagnostic, JobError, Problem, Source};
use std::path::Path;

/// One value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProbeValue {
    /// Flank of the tooth space.
    pub flank: Flank,
    /// Tooth space, from 0.
    pub gap: usize,
    /// Length of roll, mm.
    pub w: f64,
    /// f_n against the involute, mm.
    pub deviation: f64,
}

const FORM: TableForm<4> =
    TableForm { columns: ["flank", "gap", "roll_mm", "deviation_um"], optional: None, row: "each value" };
/// Tooth spaces of any gear.
const MOST_GAPS: usize = 10_000;

/// Reads the values of a probe; the first line names the columns in any order. Lines that begin with `#` are comments.
///
/// # Errors
/// Those of [`Source::read`]; `invalid-table`, `unknown-value`, `invalid-number` with line, column and value.
pub fn read_probe_values(path: &Path) -> Result<Vec<ProbeValue>, JobError> {
    parse_probe_values(Source::read(path)?)
}

/// As [`read_probe_values`], from a text.
///
/// # Errors
/// As [`read_probe_values`].
pub fn parse_probe_values(source: Source) -> Result<Vec<ProbeValue>, JobError> {
    rows(source.text()).map_err(|finding| JobError::single(source, finding))
}

/// The table of values.
///
/// # Errors
/// [`CsvError`] for a value that is not finite.
pub fn probe_table(values: &[ProbeValue]) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&FORM.columns.map(|name| Column::new(name, "")));
    for value in values {
        table.push_cells(&[
            Cell::Word(value.flank.name()),
            Cell::Number(value.gap as f64),
            Cell::Number(value.w),
            Cell::Number(1e3 * value.deviation),
        ])?;
    }
    Ok(table)
}

fn rows(text: &str) -> Result<Vec<ProbeValue>, Diagnostic> {
    let rows = FORM.rows(&with_points(text))?.iter().map(value).collect::<Result<Vec<_>, _>>()?;
    Ok(rows)
}

fn value(row: &Row<'_, 4>) -> Result<ProbeValue, Diagnostic> {
    let gap = row.parsed(1, &format!("a whole number from 0 to {MOST_GAPS}"), |n: &usize| *n <= MOST_GAPS);
    let number = |column: usize, most: f64| {
        let found = row.number(column)?;
        // Written so that NaN is refused.
        if found.abs() <= most {
            Ok(found)
        } else {
            Err(row
                .wrong(Problem::InvalidNumber, column, format!("from -{most} to {most}"))
                .way_out("correct the value or measure the profile again"))
        }
    };
    Ok(ProbeValue {
        flank: row.flank(0)?,
        gap: gap.map_err(|finding| finding.way_out("count the tooth spaces from 0"))?,
        w: number(2, 10_000.0)?,
        deviation: 1e-3 * number(3, 10_000.0)?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_comes_back() {
        let values: Vec<ProbeValue> = (0..6)
            .map(|k| ProbeValue {
                flank: if k % 2 == 0 { Flank::Left } else { Flank::Right },
                gap: 7 * k,
                w: 10.0 + 0.125 * k as f64,
                deviation: 0.25e-3 * k as f64 - 0.5e-3,
            })
            .collect();
        let text = probe_table(&values).unwrap().text().to_owned();
        assert_eq!(parse_probe_values(Source::new("w.csv", &text)).unwrap(), values);
    }

    #[test]
    fn what_is_wrong_is_told_with_line_and_column() {
        for (row, code) in [
            ("middle,0,10.0,1.0", "unknown-value"),
            ("left,-1,10.0,1.0", "invalid-number"),
            ("left,0,nan,1.0", "invalid-number"),
            ("left,0,10.0,1e9", "invalid-number"),
            ("left,0,10.0", "invalid-table"),
        ] {
            let text = format!("flank,gap,roll_mm,deviation_um\n{row}\n");
            let error = parse_probe_values(Source::new("w.csv", &text)).unwrap_err();
            let finding = &error.diagnostics[0];
            assert_eq!(finding.code, code, "{row}: {finding:?}");
            assert!(finding.span.is_some() && finding.way_out.is_some(), "{finding:?}");
        }
    }
}
