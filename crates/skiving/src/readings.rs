//! Angles at which a light barrier switched, as a table: CSV with the columns flank, track, sense, revolution and angle_deg, one switch
//! a row. Reads and writes it; whether there are as many switches as teeth is left to the evaluation.

use job::decimal_comma::with_points;
use std::path::Path;

use crate::measuring::{Reading, Sense};
use job::degrees::{degrees_text, radians_of};
use job::table_rows::{Row, TableForm};
use job::{Cell, Column, CsvError, CsvTable, Diagnostic, JobError, Problem, Source};

const FORM: TableForm<5> = TableForm {
    columns: ["flank", "track", "sense", "revolution", "angle_deg"],
    optional: None,
    row: "each switch",
};
/// No reading lies beyond this: a thousand million degrees.
const MOST_RADIANS: f64 = 1.745_329_251_994_33e7;
/// Revolutions of one measurement; far above what the size of a file allows.
const MOST_REVOLUTIONS: usize = 1_000_000;

/// Reads the readings of a tool that is measured on `tracks` tracks of each flank; the first line names the columns in any order. Tracks
/// and revolutions count from 1 in the file. Lines that begin with `#` are comments.
///
/// # Errors
/// Those of [`Source::read`], among them `file-too-large` above [`job::MAXIMUM_BYTES`]; `invalid-table`, `unknown-value`,
/// `invalid-number` with line, column and value.
pub fn read_skiving_readings(path: &Path, tracks: usize) -> Result<Vec<Reading>, JobError> {
    let source = Source::read(path).map_err(|mut error| {
        for finding in error.diagnostics.iter_mut().filter(|_| !path.exists()) {
            finding.way_out = Some("check the path; `flankwright simulate` writes such a table".into());
        }
        error
    })?;
    parse_skiving_readings(source, tracks)
}

/// As [`read_skiving_readings`], from a text.
///
/// # Errors
/// As [`read_skiving_readings`].
pub fn parse_skiving_readings(source: Source, tracks: usize) -> Result<Vec<Reading>, JobError> {
    rows(source.text(), tracks).map_err(|finding| JobError::single(source, finding))
}

/// The table of readings, as [`read_skiving_readings`] reads it back bit for bit.
///
/// # Errors
/// [`CsvError`] for an angle that is not finite.
pub fn readings_table(readings: &[Reading]) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&FORM.columns.map(|name| Column::new(name, "")));
    for (row, reading) in readings.iter().enumerate() {
        if !reading.angle.is_finite() {
            return Err(CsvError::InvalidNumber {
                column: FORM.columns[4],
                row: row + 1,
                value: reading.angle,
            });
        }
        table.push_cells(&[
            Cell::Word(reading.flank.name()),
            Cell::Number(1.0 + reading.track as f64),
            Cell::Word(if reading.sense == Sense::Positive { "+1" } else { "-1" }),
            Cell::Number(1.0 + reading.revolution as f64),
            Cell::Word(&degrees_text(reading.angle)),
        ])?;
    }
    Ok(table)
}

fn rows(text: &str, tracks: usize) -> Result<Vec<Reading>, Diagnostic> {
    FORM.rows(&with_points(text))?.iter().map(|row| reading(row, tracks)).collect()
}

fn reading(row: &Row<'_, 5>, tracks: usize) -> Result<Reading, Diagnostic> {
    let senses = [
        ("+1", Sense::Positive),
        ("1", Sense::Positive),
        ("positive", Sense::Positive),
        ("-1", Sense::Negative),
        ("negative", Sense::Negative),
    ];
    let whole = |column, most: usize, way_out: &str| {
        let found =
            row.parsed(column, &format!("a whole number from 1 to {most}"), |n| (1..=most).contains(n));
        found.map(|number| number - 1).map_err(|finding| finding.way_out(way_out))
    };
    Ok(Reading {
        flank: row.flank(0)?,
        track: whole(1, tracks, "correct the number, or give the job as many tracks as were measured")?,
        sense: row.word(2, &senses, "+1 or positive, -1 or negative")?,
        revolution: whole(3, MOST_REVOLUTIONS, "count the revolutions of each track and sense from 1")?,
        angle: radians_of(row.text(4)).filter(|angle| angle.abs() <= MOST_RADIANS).ok_or_else(|| {
            row.wrong(
                Problem::InvalidNumber,
                4,
                "degrees with a decimal point, from -1000000000 to 1000000000",
            )
            .way_out("correct the value or measure the track again")
        })?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measuring::Noise;
    use foundation::geometry::Flank;

    const HEADER: &str = "flank,track,sense,revolution,angle_deg";

    fn read(text: &str) -> Result<Vec<Reading>, JobError> {
        parse_skiving_readings(Source::new("readings.csv", text), 5)
    }

    #[test]
    fn what_is_written_comes_back_bit_for_bit() {
        let mut noise = Noise::new(8);
        let mut readings = Vec::new();
        for flank in Flank::BOTH {
            for (track, sense, revolution) in
                [(0, Sense::Positive, 0), (4, Sense::Negative, 11), (2, Sense::Positive, 3)]
            {
                let angles = (0..200).map(|_| std::f64::consts::PI * (2.0 * noise.uniform() - 1.0));
                readings.extend(angles.map(|angle| Reading { flank, track, sense, revolution, angle }));
            }
        }
        let table = readings_table(&readings).unwrap();
        assert!(
            table.text().starts_with("flank,track,sense,revolution,angle_deg\nleft,1,+1,1,"),
            "{}",
            table.text()
        );
        assert_eq!(read(table.text()).unwrap(), readings);
        readings[7].angle = f64::INFINITY;
        let refused = readings_table(&readings).unwrap_err();
        assert!(matches!(refused, CsvError::InvalidNumber { column: "angle_deg", row: 8, .. }), "{refused}");
    }

    #[test]
    fn reads_columns_in_any_order_and_both_words_for_a_sense() {
        let text = "# measured\r\nangle_deg, sense,flank,revolution,track\r\n90,positive,left,1,5\r\n\r\n -1e1 , negative,right,2,1\r\n0,1,left,1,1\n0,-1,left,1,1\n";
        let found = read(text).unwrap();
        let first = Reading {
            flank: Flank::Left,
            track: 4,
            sense: Sense::Positive,
            revolution: 0,
            angle: 90f64.to_radians(),
        };
        let second = Reading {
            flank: Flank::Right,
            track: 0,
            sense: Sense::Negative,
            revolution: 1,
            angle: -(10f64.to_radians()),
        };
        assert_eq!(found[..2], [first, second]);
        assert_eq!(
            found[2..].iter().map(|r| r.sense).collect::<Vec<_>>(),
            [Sense::Positive, Sense::Negative]
        );
    }

    #[test]
    fn what_is_wrong_is_told_with_line_and_column() {
        let with = |row: &str| format!("{HEADER}\nleft,1,+1,1,0.5\n{row}\n");
        let cases = [
            (String::new(), "invalid-table", "readings.csv: "),
            (format!("{HEADER}\n# nothing\n"), "invalid-table", "readings.csv: "),
            ("flank,track,sense,angle_deg\n".into(), "invalid-table", "readings.csv:1:1: "),
            (format!("{HEADER},time\n"), "invalid-table", "readings.csv:1:1: "),
            (with("left,1,+1,1"), "invalid-table", "readings.csv:3:1: "),
            (with("left,1,+1,1,0.5,7"), "invalid-table", "readings.csv:3:1: "),
            (with("links,1,+1,1,0.5"), "unknown-value", "readings.csv:3:1: "),
            (with("Left,1,+1,1,0.5"), "unknown-value", "readings.csv:3:1: "),
            (with("left,0,+1,1,0.5"), "invalid-number", "readings.csv:3:6: "),
            (with("left,6,+1,1,0.5"), "invalid-number", "readings.csv:3:6: "),
            (with("left,1.5,+1,1,0.5"), "invalid-number", "readings.csv:3:6: "),
            (with("left,1,0,1,0.5"), "unknown-value", "readings.csv:3:8: "),
            (with("left,1,up,1,0.5"), "unknown-value", "readings.csv:3:8: "),
            (with("left,1,+1,0,0.5"), "invalid-number", "readings.csv:3:11: "),
            (with("left,1,+1,-3,0.5"), "invalid-number", "readings.csv:3:11: "),
            (with("left,1,+1,1,nan"), "invalid-number", "readings.csv:3:13: "),
            (with("left,1,+1,1,inf"), "invalid-number", "readings.csv:3:13: "),
            (with("left,1,+1,1,1.29e87"), "invalid-number", "readings.csv:3:13: "),
            (with("left,1,+1,1, 1e999"), "invalid-number", "readings.csv:3:14: "),
            (with("left,1,+1,1,"), "invalid-number", "readings.csv:3:13: "),
        ];
        for (text, code, place) in cases {
            let error = read(&text).unwrap_err();
            let finding = &error.diagnostics[0];
            assert_eq!(finding.code, code, "{text}: {error}");
            assert!(error.to_string().starts_with(place), "{text}: {error}");
            assert!(
                finding.value.is_some() && finding.allowed.is_some() && finding.way_out.is_some(),
                "{error}"
            );
        }
        let told = read(&with("left,6,+1,1,0.5")).unwrap_err().to_string();
        assert!(told.contains("allowed: a whole number from 1 to 5"), "{told}");
    }

    #[test]
    fn files_are_read_and_missing_ones_told() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("readings.csv");
        let missing = read_skiving_readings(&path, 5).unwrap_err();
        assert_eq!(missing.diagnostics[0].code, "unreadable-file");
        std::fs::write(&path, format!("{HEADER}\nright,3,-1,2,45\n")).unwrap();
        assert_eq!(read_skiving_readings(&path, 5).unwrap()[0].track, 2);
        assert!(read_skiving_readings(&path, 2).is_err());
    }
}
