//! Other encodings, half a file, lines in another order.

use super::readers::{Reader, all};

/// The sample with a letter outside ASCII in a comment or a name.
fn with_umlaut(reader: &Reader) -> Option<String> {
    let text = String::from_utf8(reader.sample.clone()).ok()?;
    Some(match reader.ending {
        "toml" | "csv" => format!("# Zähne\n{text}"),
        _ => text.replacen("flankwright", "flänkwright", 1).replacen("ring-41", "Zähne-41", 1),
    })
}

#[test]
fn a_mark_of_utf_8_changes_nothing() {
    for reader in all().iter().filter(|reader| reader.ending != "rexsz") {
        let marked = [b"\xef\xbb\xbf", &reader.sample[..]].concat();
        assert_eq!(reader.take(&marked), reader.take(&reader.sample), "{}", reader.name);
    }
}

#[test]
fn utf_16_is_refused_with_and_without_a_mark() {
    for reader in all().iter().filter(|reader| reader.ending != "rexsz") {
        let text = String::from_utf8(reader.sample.clone()).unwrap();
        let little = |unit: u16| unit.to_le_bytes();
        let big = |unit: u16| unit.to_be_bytes();
        for order in [little as fn(u16) -> [u8; 2], big] {
            for mark in ["", "\u{feff}"] {
                let bytes: Vec<u8> = format!("{mark}{text}").encode_utf16().flat_map(order).collect();
                let error = reader.take(&bytes).unwrap_err();
                let expected = ["invalid-text", "unsupported-encoding", "not-rexs", "not-json"];
                assert!(expected.contains(&error.code.as_str()), "{}: {error:?}", reader.name);
            }
        }
    }
}

#[test]
fn latin_1_is_read_where_the_format_has_it_and_refused_elsewhere() {
    let mut refused = 0;
    for reader in all().iter().filter(|reader| !["mka", "mew", "rexsz"].contains(&reader.ending)) {
        let text = with_umlaut(reader).unwrap();
        if !text.contains('ä') {
            continue;
        }
        assert_eq!(reader.take(text.as_bytes()), reader.take(&reader.sample), "{}", reader.name);
        let latin: Vec<u8> = text.chars().map(|c| u8::try_from(u32::from(c)).unwrap_or(b'?')).collect();
        let error = reader.take(&latin).unwrap_err();
        assert!(["invalid-text", "not-rexs", "not-json"].contains(&error.code.as_str()), "{error:?}");
        refused += 1;
    }
    assert!(refused >= 12, "{refused}");
    let curves = all().into_iter().find(|reader| reader.ending == "mka").unwrap();
    let text = String::from_utf8(curves.sample.clone()).unwrap();
    let latin: Vec<u8> = text.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect();
    assert_eq!(curves.take(&latin), curves.take(&curves.sample));
}

#[test]
fn binary_files_are_refused() {
    let program = b"\x7fELF\x02\x01\x01\0\0\0\0\0\0\0\0\0\x03\0>\0\x01\0\0\0";
    let picture = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x04\0\0\0\x03\0\x08\x02";
    let package = b"PK\x03\x04\x14\0\0\0\x08\0";
    let document = b"%PDF-1.7\n%\xe2\xe3\xcf\xd3\n1 0 obj\n";
    for reader in all() {
        for bytes in [&program[..], picture, package, document, b"", b"\n", &[0xff; 512]] {
            let found = reader.take(bytes);
            // The first measurement of a tool makes its history.
            let none_yet = reader.name == "a history" && bytes.trim_ascii().is_empty();
            assert_eq!(found.is_err(), !none_yet, "{}: {found:?} for {}", reader.name, bytes.escape_ascii());
        }
    }
}

/// Whatever is left is read or refused, and nothing is in it that the whole file has not.
#[test]
fn a_file_cut_anywhere_gives_an_answer() {
    for reader in all().iter().filter(|reader| reader.sample.len() < 8000) {
        let whole = reader.take(&reader.sample).unwrap();
        let mut refused = 0;
        for end in 0..reader.sample.len() {
            match reader.take(&reader.sample[..end]) {
                // A warning may take the place of the samples that are missing.
                Ok(found) => assert!(found <= whole + 2, "{}: {found} of {whole}", reader.name),
                Err(_) => refused += 1,
            }
        }
        assert!(refused > 0, "{}", reader.name);
    }
}

/// Rows may stand in any order, the titles may not.
#[test]
fn shuffled_rows_hold_the_same_and_shuffled_titles_are_refused() {
    for reader in all().iter().filter(|reader| reader.of_rows()) {
        let text = String::from_utf8(reader.sample.clone()).unwrap();
        let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with('#')).collect();
        let (titles, rows) = lines.split_first().unwrap();
        let mut backwards = rows.to_vec();
        backwards.reverse();
        let of = |lines: &[&str]| reader.take((lines.join("\n") + "\n").as_bytes());
        assert_eq!(of(&[&[*titles], &backwards[..]].concat()), of(&lines), "{}", reader.name);
        let error = of(&[&backwards[..], &[*titles]].concat()).unwrap_err();
        assert!(
            ["invalid-table", "invalid-toml"].contains(&error.code.as_str()),
            "{}: {error:?}",
            reader.name
        );
    }
}

/// Lines of curves in another order: every line is either in the content or told.
#[test]
fn shuffled_lines_of_a_measurement_are_read_or_told() {
    use flankwright::exchange::inspection::parse_klingelnberg;
    let reader = all().into_iter().find(|reader| reader.ending == "mka").unwrap();
    let text = String::from_utf8(reader.sample.clone()).unwrap();
    let (head, rest) = text.split_once('\n').unwrap();
    let lines: Vec<&str> = rest.lines().collect();
    let whole = parse_klingelnberg(&reader.sample).unwrap();
    assert_eq!(whole.curves.len(), 4);
    let (mut told, mut kept) = (0, 0);
    for step in [3, 5, 7, 11, 13] {
        // A step without common factor with the number of lines visits each once.
        let count = if lines.len().is_multiple_of(step) { lines.len() - 1 } else { lines.len() };
        let mixed: Vec<&str> = (0..count).map(|k| lines[k * step % count]).collect();
        let file = parse_klingelnberg(format!("{head}\n{}\n", mixed.join("\n")).as_bytes()).unwrap();
        let headings = |code| file.warnings.iter().filter(|warning| warning.kind.code() == code).count();
        let traces = file.curves.len() + headings("trace-truncated") + headings("trace-empty");
        assert_eq!(traces, whole.curves.len(), "{:?}", file.warnings);
        kept += file.curves.len();
        told += file.unknown_lines.len() + file.warnings.len();
    }
    assert!(told > 10 && kept < 5 * whole.curves.len(), "{told} {kept}");
}
