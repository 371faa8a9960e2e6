//! Text inside XML files, in which a reader finds every character again. Pages have an escape of their own (`report`), which leaves line breaks
//! as they are; the two crates share the mathematics only.

/// Text for content and quoted attributes; a reader finds the same text. Characters that XML forbids become blanks.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            // A reader turns them into blanks or drops them unless they are written as numbers.
            '\t' => out.push_str("&#9;"),
            '\n' => out.push_str("&#10;"),
            '\r' => out.push_str("&#13;"),
            c if !is_allowed(c) => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// Whether XML 1.0 may hold the character.
pub fn is_allowed(c: char) -> bool {
    c >= ' ' && c != '\u{fffe}' && c != '\u{ffff}' || ['\t', '\n', '\r'].contains(&c)
}

#[cfg(test)]
mod tests {
    use super::escape;

    #[test]
    fn a_reader_finds_the_same_text() {
        let text = "a\tb\nc\r\nd\u{7f}e\u{85}<&>\"' \u{2028}µ";
        let document = format!("<a b=\"{0}\">{0}</a>", escape(text));
        let tree = roxmltree::Document::parse(&document).unwrap();
        assert_eq!(tree.root_element().attribute("b"), Some(text));
        assert_eq!(tree.root_element().text(), Some(text));
        assert_eq!(escape("a\0b\u{1f}c\u{ffff}"), "a b c ");
    }
}
