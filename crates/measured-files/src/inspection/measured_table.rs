//! Tables of measurements, of traces or of fields: the columns of the first line decide which.

use job::decimal_comma::with_points;
use std::path::Path;

use super::{Topography, Trace, field_table, trace_table};
use job::{JobError, Source};

/// What a table of measurements holds.
#[derive(Clone, Debug, PartialEq)]
pub enum MeasuredTable {
    /// Profiles and helix traces, with the columns kind, tooth, flank, position, abscissa, f_um.
    Traces(Vec<Trace>),
    /// Fields, with the columns tooth, flank, w_mm, z_mm, f_um.
    Fields(Vec<Topography>),
}

/// Reads a table of traces or of fields. The first line names the columns in any order; lines that begin with `#` are comments. z counts
/// from the middle of the face width; `f_um` is the deviation, positive = material, empty or `nan` where it is undefined. Rows of one tooth
/// and flank are one field; rows of one kind, tooth, flank and position are one trace, wherever they stand. Where something was measured more
/// than once, a column `reading` numbers it.
///
/// # Errors
/// Those of [`Source::read`]; `invalid-table`, `unknown-value`, `invalid-number` with line, column and value.
pub fn read_measured_table(path: &Path) -> Result<MeasuredTable, JobError> {
    parse_measured_table(Source::read(path)?)
}

/// As [`read_measured_table`], from a text.
///
/// # Errors
/// As [`read_measured_table`], without those of the file system.
pub fn parse_measured_table(source: Source) -> Result<MeasuredTable, JobError> {
    let text = with_points(source.text());
    let head = text.lines().find(|line| !line.trim().is_empty() && !line.starts_with('#'));
    let titles: Vec<&str> = head.unwrap_or_default().split(',').map(str::trim).collect();
    // What only fields have decides: everything else is taken, and complained of, as traces.
    let of_fields = ["w_mm", "z_mm"].iter().any(|title| titles.contains(title));
    let found = if of_fields {
        field_table::fields(&text).map(MeasuredTable::Fields)
    } else {
        trace_table::traces(&text).map(MeasuredTable::Traces)
    };
    drop(text);
    found.map_err(|finding| JobError::single(source, finding))
}

#[cfg(test)]
mod tests {
    use super::super::{topography_table, trace_table};
    use super::*;
    use foundation::geometry::Flank;

    fn read(text: &str) -> Result<MeasuredTable, String> {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("measured.csv");
        std::fs::write(&path, text).unwrap();
        read_measured_table(&path).map_err(|error| error.to_string())
    }

    #[test]
    fn the_columns_tell_fields_from_traces_and_both_come_back() {
        let text = "z_mm,w_mm,f_um,flank,tooth\n-3,5,1.5,right,4\n-3,6,,right,4\n3,5,-2,left,4\n";
        let Ok(MeasuredTable::Fields(fields)) = read(text) else { panic!("no fields") };
        assert_eq!(fields.len(), 2);
        assert_eq!((fields[0].tooth, fields[0].flank), (4, Flank::Right));
        assert_eq!(fields[0].points_mm, vec![[5.0, -3.0], [6.0, -3.0]]);
        assert!(fields[0].f_um[0] == 1.5 && fields[0].f_um[1].is_nan());
        let written = topography_table(&fields).unwrap();
        let Ok(MeasuredTable::Fields(again)) = read(written.text()) else { panic!("no fields") };
        assert_eq!(again[1], fields[1]);

        let text = "kind,tooth,flank,position,abscissa,f_um\nprofile,1,left,0,5,1\nprofile,1,left,0,6,2\n";
        let Ok(MeasuredTable::Traces(traces)) = read(text) else { panic!("no traces") };
        let Ok(MeasuredTable::Traces(again)) = read(trace_table(&traces).unwrap().text()) else {
            panic!("no traces")
        };
        assert_eq!(again, traces);
    }

    #[test]
    fn readings_are_told_apart_and_come_back() {
        let text = "kind,tooth,flank,position,abscissa,f_um,reading\nprofile,1,left,0,5,1,1\nprofile,1,left,0,6,2,1\n\
                    profile,1,left,0,5,3,2\nprofile,1,left,-0,6,4,2\n";
        let Ok(MeasuredTable::Traces(traces)) = read(text) else { panic!("no traces") };
        assert_eq!((traces.len(), &traces[1].f_um), (2, &vec![3.0, 4.0]));
        let Ok(MeasuredTable::Traces(again)) = read(trace_table(&traces).unwrap().text()) else {
            panic!("no traces")
        };
        assert_eq!(again, traces);
        let text = "tooth,flank,w_mm,z_mm,f_um,reading\n1,left,2,3,4,1\n1,left,2,3,5,2\n";
        let Ok(MeasuredTable::Fields(fields)) = read(text) else { panic!("no fields") };
        assert_eq!(fields.len(), 2);
        let written = topography_table(&fields).unwrap();
        let Ok(MeasuredTable::Fields(again)) = read(written.text()) else { panic!("no fields") };
        assert_eq!(again, fields);
    }

    #[test]
    fn what_is_wrong_is_named() {
        for (text, told) in [
            ("", "the table has no rows"),
            ("tooth,flank,w_mm,z_mm\n1,left,2,3\n", "no column `f_um`"),
            ("tooth,flank,w_mm,z_mm,f_um\n1,up,2,3,4\n", "`flank` cannot be `up`"),
            ("tooth,flank,w_mm,z_mm,f_um\n1,left,inf,3,4\n", "`w_mm` cannot be `inf`"),
            ("tooth,flank,w_mm,z_mm,f_um\n1,left,2,3\n", "a row of 4 values"),
            ("tooth,flank,w_mm,z_mm,f_um,reading\n1,left,2,3,4\n", "a row of 5 values"),
            ("tooth,flank,w_mm,z_mm,f_um,reading\n1,left,2,3,4,0\n", "`reading` cannot be `0`"),
            ("tooth,flank,w_mm,z_mm,f_um,day\n1,left,2,3,4,0\n", "has 6 columns"),
        ] {
            let error = read(text).unwrap_err();
            assert!(error.contains(told), "{text:?}: {error}");
        }
    }
}
