//! Numbers that are none: in place of each number of a file.

use super::readers::all;

/// Words that a parser of numbers may take, and none of which is a finite number.
const WORDS: [&str; 7] = ["nan", "NaN", "inf", "-inf", "1e999", "-1e999", "infinity"];

/// Where the numbers of a row stand that is no comment.
fn numbers(line: &str) -> Vec<std::ops::Range<usize>> {
    let mut found = Vec::new();
    let mut offset = 0;
    for cell in line.split(',') {
        if cell.trim().parse::<f64>().is_ok_and(f64::is_finite) {
            found.push(offset..offset + cell.len());
        }
        offset += cell.len() + 1;
    }
    found
}

#[test]
fn no_row_of_a_table_holds_a_number_that_is_not_finite() {
    for reader in all().iter().filter(|reader| reader.of_rows()) {
        let text = String::from_utf8(reader.sample.clone()).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        let last = lines.iter().rposition(|line| !numbers(line).is_empty()).unwrap();
        for place in numbers(lines[last]) {
            for word in WORDS {
                let mut changed = lines[last].to_owned();
                changed.replace_range(place.clone(), word);
                let text = [&lines[..last], &[&changed]].concat().join("\n") + "\n";
                match reader.take(text.as_bytes()) {
                    Err(error) => {
                        assert!(
                            ["invalid-number", "wrong-type", "unknown-value"].contains(&error.code.as_str()),
                            "{}: {word}: {error:?}",
                            reader.name
                        );
                        // A catalogue shows the number that the word stands for.
                        let shown = error.message.contains(word) || error.message.contains("finite number");
                        assert!(shown, "{}: {word}: {error:?}", reader.name);
                    }
                    // Measured deviations may be undefined, and only as `nan`.
                    Ok(_) => {
                        let measured = reader.name.starts_with("measured");
                        assert!(measured && word.eq_ignore_ascii_case("nan"), "{}: {word}", reader.name);
                    }
                }
            }
        }
    }
}

#[test]
fn no_key_of_a_document_takes_a_number_that_is_not_finite() {
    for reader in all().iter().filter(|reader| reader.ending == "toml" && reader.name != "a catalogue") {
        let text = String::from_utf8(reader.sample.clone()).unwrap();
        let mut asked = 0;
        for (at, line) in text.lines().enumerate() {
            let Some((key, value)) = line.split_once(" = ") else { continue };
            let number = value.split('#').next().unwrap_or_default().trim();
            if line.starts_with('#') || number.parse::<f64>().is_err() {
                continue;
            }
            for word in ["nan", "inf", "-inf", "1e999"] {
                let changed: Vec<String> = text
                    .lines()
                    .enumerate()
                    .map(|(k, line)| if k == at { format!("{key} = {word}") } else { line.into() })
                    .collect();
                let found = reader.take(changed.join("\n").as_bytes());
                assert!(found.is_err(), "{}: {key} = {word}", reader.name);
                asked += 1;
            }
        }
        assert!(asked >= 20, "{}: {asked}", reader.name);
    }
}

#[test]
fn measured_values_that_are_no_numbers_are_told() {
    use flankwright::exchange::inspection::parse_klingelnberg;
    let head = "HEADER KS.MK.FILE\nProfil:\nZahn-Nr.: 2 links / 4 Werte z= 3\n";
    for word in WORDS {
        let file = parse_klingelnberg(format!("{head} 1 2\n{word} 4\n").as_bytes()).unwrap();
        assert!(file.curves.is_empty(), "{word}");
        assert_eq!(file.warnings[0].kind.code(), "trace-truncated");
        assert_eq!(file.unknown_lines[0].text, format!("{word} 4"));
    }
    let rexs = all().into_iter().find(|reader| reader.ending == "rexs").unwrap();
    let text = String::from_utf8(rexs.sample.clone()).unwrap();
    let places: Vec<(usize, &str)> = text.match_indices("</attribute>").collect();
    for (end, _) in places {
        let start = text[..end].rfind('>').unwrap() + 1;
        if text[start..end].parse::<f64>().is_err() {
            continue;
        }
        for word in WORDS {
            let mut changed = text.clone();
            changed.replace_range(start..end, word);
            let error = rexs.take(changed.as_bytes()).unwrap_err();
            assert_eq!(error.code, "bad-value", "{changed}");
        }
    }
}
