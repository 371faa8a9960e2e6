//! Texts and numbers in rooms of a given width.

use report::charts::{format_fixed, format_significant, text_width};

/// Fonts differ from the estimate of widths by about this factor.
const SAFETY: f64 = 1.04;

/// Sizes beyond this are printed as powers of ten.
const LONGEST: f64 = 1e6;

/// A number of a table; a dash where there is none.
pub(super) fn number(value: Option<f64>, decimals: usize) -> String {
    match value {
        Some(value) if value.abs() >= LONGEST => format_significant(value, 6),
        Some(value) => format_fixed(value, decimals),
        None => "–".into(),
    }
}

/// The size at which a text fits a width, at most the wanted one.
pub(super) fn fitting_size(text: &str, size: f64, width: f64) -> f64 {
    let natural = SAFETY * text_width(text, size);
    if natural <= width { size } else { size * (width / natural) }
}

/// Lines of at most a width. Words that are longer than a line are broken.
pub(super) fn wrapped(text: &str, size: f64, width: f64) -> Vec<String> {
    let room = width / SAFETY;
    let mut lines: Vec<String> = Vec::new();
    let mut line = String::new();
    let mut used = 0.0;
    let blank = text_width(" ", size);
    for word in text.split_whitespace() {
        let wide = text_width(word, size);
        if !line.is_empty() && used + blank + wide > room {
            lines.push(std::mem::take(&mut line));
            used = 0.0;
        }
        if !line.is_empty() {
            line.push(' ');
            used += blank;
        }
        if wide <= room {
            line.push_str(word);
            used += wide;
            continue;
        }
        for letter in word.chars() {
            let wide = text_width(letter.encode_utf8(&mut [0; 4]), size);
            if !line.is_empty() && used + wide > room {
                lines.push(std::mem::take(&mut line));
                used = 0.0;
            }
            line.push(letter);
            used += wide;
        }
    }
    if !line.is_empty() {
        lines.push(line);
    }
    lines
}

/// The beginning of a text that leaves room for what follows it, with a mark that something does.
pub(super) fn beginning(text: &str, size: f64, width: f64) -> String {
    let room = width / SAFETY - text_width("…", size);
    let mut used = 0.0;
    let mut short = String::new();
    for letter in text.chars() {
        used += text_width(letter.encode_utf8(&mut [0; 4]), size);
        if used > room {
            break;
        }
        short.push(letter);
    }
    short.truncate(short.trim_end().len());
    short.push('…');
    short
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_hold_every_letter_and_keep_to_their_width() {
        let text = "The thickness by span and by balls differs averyveryverylongwordwithoutanyblankatallinit 車車車車車車車車車車車車 end";
        for width in [8.0, 20.0, 61.0] {
            let lines = wrapped(text, 2.0, width);
            let letters = |text: &str| text.chars().filter(|c| !c.is_whitespace()).collect::<String>();
            assert_eq!(letters(&lines.concat()), letters(text), "{width}");
            assert!(lines.iter().all(|line| text_width(line, 2.0) <= width), "{lines:?}");
        }
        assert!(wrapped(" \n ", 2.0, 10.0).is_empty());
    }

    #[test]
    fn numbers_are_never_endless() {
        assert_eq!(number(Some(-0.04), 1), "0.0");
        assert_eq!(number(Some(-12.34), 1), "−12.3");
        assert_eq!(number(None, 1), "–");
        assert_eq!(number(Some(f64::NAN), 1), "–");
        assert_eq!(number(Some(1.5e300), 1), "1.5·10³⁰⁰");
        assert!(number(Some(-f64::MAX), 1).chars().count() <= 14);
    }

    #[test]
    fn a_beginning_says_that_more_follows() {
        let short = beginning("a long designation of a part", 2.0, 20.0);
        assert!(short.ends_with('…') && short.starts_with("a long"), "{short}");
        assert!(text_width(&short, 2.0) <= 20.0);
    }
}
