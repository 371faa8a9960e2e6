//! Notes below the name of a program: what its text says of the verdict on the part. They are put into a text that is written and
//! proven already, and readers leave them out of the blocks, so that block numbers stay what they are.

use super::super::Dialect;

/// Longest note, characters; longer ones are broken between words.
const LENGTH: usize = 72;

/// A sentence as notes: capital letters, digits and single spaces, which every control takes as a comment, in lines of 72 characters
/// at most.
fn lines(sentence: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let plain = sentence.replace('°', " deg").replace('µ', "u").to_ascii_uppercase();
    // A point between digits would leave another number behind.
    let plain = plain.replace('.', " POINT ").replace(" POINT  ", " ");
    for word in plain.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty()) {
        match lines.last_mut() {
            Some(line) if line.len() + 1 + word.len() <= LENGTH => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// The text of a program with `sentences` as comments directly below its name.
pub fn with_notes(text: &str, dialect: Dialect, sentences: &[String]) -> String {
    // A Fanuc program opens with a percent sign, its name stands beside its number.
    let opening = if dialect == Dialect::Fanuc { 2 } else { 1 };
    below(text, opening, sentences, |line| match dialect {
        Dialect::Siemens => format!("; {line}"),
        Dialect::LinuxCnc | Dialect::Fanuc => format!("({line})"),
    })
}

/// A HAL netlist with `sentences` as comments at its top.
pub fn netlist_with_notes(netlist: &str, sentences: &[String]) -> String {
    below(netlist, 0, sentences, |line| format!("# {line}"))
}

/// Cutter locations with `sentences` as comments below the name of the part.
pub fn cl_with_notes(text: &str, sentences: &[String]) -> String {
    below(text, 1, sentences, |line| format!("$$ {line}"))
}

fn below(text: &str, opening: usize, sentences: &[String], comment: impl Fn(&str) -> String) -> String {
    let at = text.match_indices('\n').nth(opening.wrapping_sub(1)).map_or(0, |(at, _)| at + 1);
    let mut noted = String::with_capacity(text.len() + 512);
    noted.push_str(&text[..at]);
    for line in sentences.iter().flat_map(|sentence| lines(sentence)) {
        noted.push_str(&comment(&line));
        noted.push('\n');
    }
    noted.push_str(&text[at..]);
    noted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn notes_stand_below_the_name_in_every_dialect() {
        let notes = ["VERDICT MISSED".to_owned()];
        let noted = |text: &str, dialect| with_notes(text, dialect, &notes);
        assert_eq!(noted("; A\nG71\n", Dialect::Siemens), "; A\n; VERDICT MISSED\nG71\n");
        assert_eq!(noted("(A)\nG21\n", Dialect::LinuxCnc), "(A)\n(VERDICT MISSED)\nG21\n");
        assert_eq!(noted("%\nO0001 (A)\nG21\n", Dialect::Fanuc), "%\nO0001 (A)\n(VERDICT MISSED)\nG21\n");
        assert_eq!(netlist_with_notes("# Gear\nloadrt\n", &notes), "# VERDICT MISSED\n# Gear\nloadrt\n");
        assert_eq!(cl_with_notes("PARTNO/A\nFINI\n", &notes), "PARTNO/A\n$$ VERDICT MISSED\nFINI\n");
    }

    #[test]
    fn long_sentences_are_broken_and_hold_no_other_characters() {
        let sentence = "left flank (0.31 of 1 um), ".repeat(20);
        let lines = lines(&sentence);
        assert!(lines.len() > 5 && lines.iter().all(|line| line.len() <= LENGTH), "{lines:?}");
        assert!(lines.concat().bytes().all(|b| b.is_ascii_uppercase() || b.is_ascii_digit() || b == b' '));
        assert!(lines[0].starts_with("LEFT FLANK 0 POINT 31 OF 1 UM LEFT"), "{lines:?}");
    }
}
