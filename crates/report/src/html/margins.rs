//! The margins of printed pages: name of the part on the left, number of the page on the right.

use crate::data::PlanReport;
use std::fmt::Write;

/// Rules for the margin boxes of a page.
pub(super) fn of(report: &PlanReport) -> String {
    let say = |text: &str| css_string(&report.language.say(text));
    let name = match report.title_block.part() {
        Some(part) => format!("{part} · {}", report.title),
        None => report.title.clone(),
    };
    let mut rules = String::from("@page {\n");
    let _ = writeln!(rules, "  @bottom-left {{ content: {}; }}", css_string(&name));
    let _ = writeln!(
        rules,
        "  @bottom-right {{ content: {} \" \" counter(page) \" \" {} \" \" counter(pages); }}",
        say("Page"),
        say("of")
    );
    rules += "}\n";
    rules
}

/// A text as a string of CSS inside of `<style>`: what could end the string, the rule or the element is written as a number.
fn css_string(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            c if c.is_alphanumeric() || " -_.,:;()+·–".contains(c) => out.push(c),
            c if c.is_control() => out.push(' '),
            c => {
                let _ = write!(out, "\\{:x} ", u32::from(c));
            }
        }
    }
    out.push('"');
    out
}

#[cfg(test)]
mod tests {
    use super::css_string;

    #[test]
    fn nothing_ends_a_string_of_css() {
        assert_eq!(css_string("A-12.5 (left)"), "\"A-12.5 (left)\"");
        assert_eq!(css_string("a\"b\\c</style>\nd{}"), "\"a\\22 b\\5c c\\3c \\2f style\\3e  d\\7b \\7d \"");
        assert_eq!(css_string("Zahnrad für Öl"), "\"Zahnrad für Öl\"");
    }
}
