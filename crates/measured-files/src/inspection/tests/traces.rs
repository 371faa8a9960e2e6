//! Tables of traces: what is written comes back, what is wrong is reported.

use super::super::*;
use foundation::geometry::Flank;
use job::Source;

fn read(text: &str) -> Result<Vec<Trace>, job::JobError> {
    parse_measured_table(Source::new("traces.csv", text)).map(|found| match found {
        MeasuredTable::Traces(traces) => traces,
        MeasuredTable::Fields(fields) => panic!("{fields:?}"),
    })
}

fn trace(kind: TraceKind, tooth: u32, flank: Flank) -> Trace {
    let abscissa_mm: Vec<f64> = (0..20).map(|i| 0.1 + f64::from(i) / 3.0).collect();
    let f_um = abscissa_mm.iter().enumerate().map(|(i, a)| if i == 4 { f64::NAN } else { (7.0 * a).sin() });
    let f_um = f_um.collect();
    let (tag, zero) = (String::new(), Zero::Free);
    // Lengths of roll are not below 0.
    let position_mm = if kind == TraceKind::Profile { -1.0 / 3.0 } else { 1.0 / 3.0 };
    Trace { kind, tooth, flank, tag, position_mm, abscissa_mm, f_um, zero }
}

#[test]
fn what_is_written_comes_back() {
    let traces = [
        trace(TraceKind::Profile, 1, Flank::Left),
        trace(TraceKind::Helix, 1, Flank::Left),
        trace(TraceKind::Helix, 2, Flank::Right),
    ];
    let table = trace_table(&traces).unwrap();
    assert!(table.text().starts_with("kind,tooth,flank,position,abscissa,f_um\nprofile,1,left,-0.333"));
    let back = read(table.text()).unwrap();
    assert_eq!(serde_json::to_string(&back).unwrap(), serde_json::to_string(&traces).unwrap());
}

#[test]
fn rows_may_stand_anywhere() {
    let text = "# a\nf_um,abscissa,kind,tooth,flank,position\n1,2,helix,3,right,0\n\n5,7,profile,3,right,-0\r\n-1,-2,helix,3,right,-0\nnan,0,helix,3,right,0\n";
    let found = read(text).unwrap();
    assert_eq!(found.len(), 2);
    assert_eq!(found[0].abscissa_mm, [-2.0, 0.0, 2.0]);
    assert_eq!((found[0].f_um[0], found[0].f_um[2]), (-1.0, 1.0));
    assert!(found[0].f_um[1].is_nan());
}

#[test]
fn what_is_wrong_is_told_with_its_line() {
    let with = |row: &str| format!("kind,tooth,flank,position,abscissa,f_um\nhelix,1,left,0,1,2\n{row}\n");
    let cases = [
        (String::new(), "invalid-table", None),
        ("kind,tooth\n".into(), "invalid-table", Some(1)),
        ("kind,tooth,flank,position,abscissa,f_um,x\n".into(), "invalid-table", Some(1)),
        (with("helix,1,left,0,1"), "invalid-table", Some(3)),
        (with("lead,1,left,0,1,2"), "unknown-value", Some(3)),
        (with("helix,1.5,left,0,1,2"), "invalid-number", Some(3)),
        (with("helix,1,links,0,1,2"), "unknown-value", Some(3)),
        (with("helix,1,left,nan,1,2"), "invalid-number", Some(3)),
        (with("helix,1,left,-1,1,2"), "invalid-number", Some(3)),
        (with("profile,1,left,0,-1,2"), "invalid-number", Some(3)),
        (with("helix,1,left,0,3,1e9"), "invalid-number", Some(3)),
        (with("helix,1,left,0,,2"), "invalid-number", Some(3)),
        (with("helix,1,left,0,3,inf"), "invalid-number", Some(3)),
        (with("helix,1,left,0,1,9"), "invalid-table", None),
    ];
    for (text, code, line) in cases {
        let error = read(&text).unwrap_err();
        assert_eq!(error.diagnostics[0].code, code, "{text}: {error}");
        let span = error.diagnostics[0].span.as_ref().map(|span| error.source.line_column(span.start).0);
        assert_eq!(span, line, "{error}");
    }
}
