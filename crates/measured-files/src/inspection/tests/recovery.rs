//! Every recovery rule and every error of the grammar, and settings that are refused.

use super::super::*;
use super::made::Made;

fn read(text: &str) -> KlingelnbergFile {
    parse_klingelnberg(text.as_bytes()).unwrap()
}

fn warnings(file: &KlingelnbergFile) -> Vec<&'static str> {
    file.warnings.iter().map(|w| w.kind.code()).collect()
}

fn unknown(file: &KlingelnbergFile) -> Vec<&str> {
    file.unknown_lines.iter().map(|line| line.text.as_str()).collect()
}

const HEAD: &str = "HEADER KS.MK.FILE\n";

#[test]
fn a_trace_cut_short_is_dropped_and_the_line_is_told() {
    let file = read(&format!(
        "{HEAD}Profil:\nZahn-Nr.: 2 links / 6 Werte z= 3\n 1.0 2.0\n1,5 3\nZahn-Nr.: 3 links / 2 Werte z= 3\n 4 5\n"
    ));
    assert_eq!((warnings(&file), unknown(&file)), (vec!["trace-truncated"], vec!["1,5 3"]));
    assert_eq!((file.curves.len(), file.curves[0].tooth, file.unknown_lines[0].line), (1, 3, 5));
    let at_end = read(&format!("{HEAD}Zahn-Nr.: 2 links / 6 Werte z= 3\n 1.0 2.0"));
    assert_eq!((warnings(&at_end), at_end.curves.len()), (vec!["trace-truncated", "file-cut-short"], 0));
    let by_heading = read(&format!(
        "{HEAD}Zahn-Nr.: 2 links / 6 Werte z= 3\n 1.0 2.0\nZahn-Nr.: 3 links / 2 Werte z= 3\n 4 5\n"
    ));
    assert_eq!((warnings(&by_heading), by_heading.curves.len()), (vec!["trace-truncated"], 1));
}

#[test]
fn surplus_values_are_cut_and_empty_traces_dropped() {
    let file = read(&format!("{HEAD}Zahn-Nr.: 2 links / 3 Werte z= 3\n 1 2\n3 4 5\n6\n7\n"));
    assert_eq!((warnings(&file), &file.curves[0].values[..]), (vec!["trace-too-long"], &[1.0, 2.0, 3.0][..]));
    let later = read(&format!("{HEAD}Zahn-Nr.: 2 links / 2 Werte z= 3\n 1 2\n\n3\n"));
    assert_eq!((warnings(&later), later.warnings[0].line), (vec!["trace-too-long"], Some(5)));
    let one =
        read(&format!("{HEAD}Zahn-Nr.: 2 links / 1 Werte z= 3\n 1\nZahn-Nr.: 2 links / 0 Werte z= 3\n"));
    assert_eq!((warnings(&one), one.curves.len()), (vec!["trace-empty"; 2], 0));
}

#[test]
fn a_pitch_that_is_not_there_comes_back_undefined() {
    let file = read(&format!("{HEAD}linke Zahnflanke\nZahn-Nr.  fp  Fr\n 1 .5 2\n 2 -.5 -2147483.648\n"));
    let rows = &file.pitch.left;
    assert!(rows.len() == 2 && rows[0].cumulative.is_nan() && rows[1].run_out.is_nan(), "{rows:?}");
    let text = serde_json::to_string(&file).unwrap();
    let back: KlingelnbergFile = serde_json::from_str(&text).unwrap();
    assert!(back.pitch.left[1].run_out.is_nan() && back.pitch.left[0].fp == 0.5);
}

#[test]
fn the_last_of_two_values_holds() {
    let file = read("HEADER KS.MW.FILE\n21 :mn : 1\n21 :mn : 2\n10111 : a : 1\n10111 : b : 2\n");
    assert_eq!(warnings(&file), ["duplicate-code"; 2]);
    assert_eq!((file.results[&10111], file.header[&21].number()), (Some(2.0), Some(2.0)));
}

#[test]
fn header_lines_end_where_data_begin() {
    let file = read(&format!("{HEAD}21 :mn : 1\nProfil:\n22 :z : 5\n"));
    assert_eq!((file.header.len(), unknown(&file)), (1, vec!["22 :z : 5"]));
}

#[test]
fn another_value_for_undefined() {
    let file = read(&format!(
        "{HEAD}UNDEFINED -99.50 ! x\nZahn-Nr.: 2 links / 3 Werte z= 3\n-99.5 1 -2147483.648\n"
    ));
    let values = &file.curves[0].values;
    assert!(values[0].is_nan() && values[2] == -2_147_483.648);
    let wrong = read(&format!(
        "{HEAD}UNDEFINED x\nLANGUAGE 1 ENG\nZahn-Nr.: 2 links / 2 Werte z= 3\n-2147483.648 1\n"
    ));
    assert_eq!(warnings(&wrong), ["unusable", "language"]);
    assert!(wrong.curves[0].values[0].is_nan());
}

#[test]
fn unknown_lines_are_shortened_and_bounded() {
    let long = "ä".repeat(300);
    let mut text = format!("{HEAD}{long}\n");
    let file = read(&text);
    assert_eq!((file.unknown_lines[0].line, file.unknown_lines[0].text.chars().count()), (2, 80));
    text.push_str(&"?\n".repeat(MAXIMUM_UNKNOWN_LINES - 1));
    assert_eq!(read(&text).unknown_lines.len(), MAXIMUM_UNKNOWN_LINES);
    text.push_str("?\n");
    let error = parse_klingelnberg(text.as_bytes()).unwrap_err();
    assert!(matches!(error, InspectionError::TooManyUnknownLines { line: 2, .. }), "{error}");
}

#[test]
fn warnings_that_are_not_listed_are_counted() {
    let file = read(&format!("{HEAD}{}", "Zahn-Nr.: 2 links / 1 Werte z= 3\n1\n".repeat(2003)));
    let last = file.warnings.last().unwrap();
    assert_eq!((file.warnings.len(), last.kind, last.line), (2001, WarningKind::MoreWarnings, Some(4002)));
    assert!(last.message.starts_with("3 more warnings"), "{}", last.message);
}

#[test]
fn sizes_are_bounded() {
    let code = |bytes: &[u8]| parse_klingelnberg(bytes).unwrap_err().code();
    assert_eq!(code(&vec![b' '; MAXIMUM_FILE_BYTES + 1]), "file-too-large");
    let samples = format!("{HEAD}Zahn-Nr.: 2 links / {} Werte z= 3\n", MAXIMUM_SAMPLES + 1);
    assert_eq!(code(samples.as_bytes()), "file-too-large");
    let trace = "Zahn-Nr.: 2 links / 2 Werte z= 3\n1 2\n";
    let most = format!("{HEAD}{}", trace.repeat(MAXIMUM_TRACES));
    assert_eq!(read(&most).curves.len(), MAXIMUM_TRACES);
    assert_eq!(code(format!("{most}{trace}").as_bytes()), "file-too-large");
}

#[test]
fn a_file_of_one_gigabyte_is_refused_without_reading_it() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("huge.mka");
    let file = std::fs::File::create(&path).unwrap();
    file.set_len(1 << 30).unwrap();
    let start = std::time::Instant::now();
    assert_eq!(read_klingelnberg(&path).unwrap_err().code(), "file-too-large");
    assert!(start.elapsed().as_secs() < 5);
    let missing = read_klingelnberg(&directory.path().join("none.mka")).unwrap_err();
    assert_eq!(missing.code(), "unreadable-file");
}

#[test]
fn other_files_are_told_apart() {
    for text in ["", "\n\n", "HEADER SOMETHING ELSE\nx\n", "x\nHEADER KS.MK.FILE\n", "HEADER KS.MK.FILE x\n"]
    {
        let error = parse_klingelnberg(text.as_bytes()).unwrap_err();
        assert_eq!(error.code(), "not-klingelnberg", "{text:?}: {error}");
    }
    assert_eq!(read("\n \nHEADER   KS.MW.FILE \n").kind, FileKind::Values);
}

#[test]
fn missing_lines_matter_only_where_they_are_needed() {
    let made = || {
        let heading = "Zahn-Nr.: 1 links / 3 Werte z= 10";
        let made = Made::gear().curve("Profil:", heading, &[1.0, 2.0, 3.0]);
        made.curve("Flankenlinie:", "Zahn-Nr.: 1 links / 3 Werte x= 9", &[1.0, 2.0, 3.0])
    };
    let of = |made: Made| inspection_of(&[("x", &read(&made.text()))]);
    for code in [21, 22, 23, 24, 26, 41, 44, 61, 64] {
        let error = of(made().with(code, "")).unwrap_err();
        assert!(
            matches!(error, InspectionError::MissingCode { code: c, .. } if c == code),
            "{code}: {error}"
        );
    }
    let without = of(made().with(42, "").with(63, "")).unwrap();
    for (kind, code) in [(TraceKind::Profile, 42), (TraceKind::Helix, 63)] {
        let error = without.conditions.range(kind, foundation::geometry::Flank::Left).unwrap_err();
        assert!(matches!(error, InspectionError::MissingCode { code: c, .. } if c == code), "{error}");
    }
    // Without curves no end of a curve is needed.
    assert!(of(Made::gear().with(26, "").with(41, "").with(61, "")).is_ok());
}

#[test]
fn what_is_not_proven_is_refused_or_told() {
    let of = |made: Made| inspection_of(&[("x", &read(&made.text()))]);
    let refused = [
        (164, "Seitendefinition :ZSDEF: 1", "unverified-setting"),
        (183, "Schnitt :SCHNT: 2", "unverified-setting"),
        (22, "z : 0", "bad-input"),
        (22, "z : 12.5", "bad-input"),
        (21, "mn : 0", "bad-input"),
        (24, "alpha : 95", "bad-input"),
        (41, "da : 43", "below-base-circle"),
    ];
    for (code, line, expected) in refused {
        let error = of(Made::gear().with(code, line)).unwrap_err();
        assert_eq!(error.code(), expected, "{line}: {error}");
        assert!(!error.way_out().is_empty());
    }
    let told = [
        (178, "Vorzeichen :LVORZ: 0: VDI"),
        (163, "Lueckenmessung :ZZALU: 1"),
        (162, "Zahnverteilung :ZVERT: 1"),
        (165, "Reference :R_FHB: 0 : L: + : R: +"),
        (23, "beta : 5"),
    ];
    for (code, line) in told {
        let found = of(Made::gear().with(code, line)).unwrap();
        let kinds: Vec<_> = found.warnings.iter().map(|w| w.kind).collect();
        assert_eq!(kinds, [WarningKind::UnverifiedSetting], "{line}");
    }
    assert_eq!(of(Made::gear().with(183, "Schnitt :SCHNT: 1")).unwrap().conditions.section, Section::Normal);
    let inch = Made::gear().text().replace("UNITS     mm  ", "UNITS     inch");
    let error = inspection_of(&[("x", &read(&inch))]).unwrap_err();
    assert_eq!(error.code(), "unverified-setting");
    let other = Made::gear().with(7, "Teil : 4712");
    let files = [read(&Made::gear().text()), read(&other.text())];
    let error = inspection_of(&[("a", &files[0]), ("b", &files[1])]).unwrap_err();
    assert_eq!(error.code(), "different-parts");
    assert_eq!(inspection_of(&[]).unwrap_err().code(), "bad-input");
}
