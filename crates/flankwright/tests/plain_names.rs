//! Plain names in reports: what a reader sees of the pages of all examples has no raw keys, no symbols in the spelling of files, no units in
//! plain letters and no numbers with digits that say nothing.
//!
//! What may stand there although it looks like a key: a key of the job in a way out (a paragraph of class `way-out`, or what follows
//! `Remedy:`) or between backquotes, where a text names it as such; names of files; what the job itself says (its strings, its name and its
//! description). A number may have six significant digits, or three decimals.

use crate::example_pages::pages;
use report::html;

/// A text of a page between two tags.
struct Shown {
    /// The tag in front of it.
    tag: String,
    text: String,
}

/// What a reader sees, in order. An index is written `F_{α}`.
fn shown(page: &str) -> Vec<Shown> {
    let body = page.split_once("<body>").map_or(page, |(_, body)| body);
    let mut all: Vec<Shown> = Vec::new();
    let (mut tag, mut text) = (String::new(), String::new());
    let mut rest = body;
    while let Some((before, after)) = rest.split_once('<') {
        text += before;
        let Some((inside, behind)) = after.split_once('>') else { break };
        rest = behind;
        match inside.split([' ', '/']).find(|part| !part.is_empty()).unwrap_or_default() {
            "sub" | "tspan" if inside.starts_with('/') => text.push('}'),
            "sub" | "tspan" => text += "_{",
            "i" | "b" => {}
            _ => {
                let found = unescaped(&std::mem::take(&mut text));
                if !found.trim().is_empty() {
                    all.push(Shown { tag: std::mem::take(&mut tag), text: found.trim().to_owned() });
                }
                tag = inside.to_owned();
            }
        }
    }
    all
}

fn unescaped(text: &str) -> String {
    let mut text = text.to_owned();
    for (escaped, letter) in [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&#39;", "'"), ("&amp;", "&")]
    {
        text = text.replace(escaped, letter);
    }
    text
}

/// Symbols of ISO 1328 as files spell them.
const PLAIN_SYMBOLS: [&str; 16] =
    ["fHa", "fHb", "ffa", "ffb", "Fa", "Fb", "Ca", "Cb", "fKo", "fKu", "fp", "Fp", "Fpk", "Fr", "fu", "Rp"];

/// Endings of the files that runs write and read.
const ENDINGS: [&str; 12] =
    ["json", "csv", "html", "toml", "nc", "ngc", "mpf", "mka", "mew", "rexs", "stl", "vtk"];

fn is_file(word: &str) -> bool {
    word.contains('/') || word.rsplit_once('.').is_some_and(|(_, end)| ENDINGS.contains(&end))
}

/// The part of a text in which keys are not named as such.
fn without_named_keys(shown: &Shown) -> String {
    if shown.tag.contains("way-out") {
        return String::new();
    }
    let text = shown.text.split("Remedy:").next().unwrap_or_default();
    text.split('`').step_by(2).collect::<Vec<_>>().join(" ")
}

/// Strings of a job, as a report shows them.
fn strings(job: &str) -> Vec<String> {
    let quoted = job.split('"').skip(1).step_by(2);
    quoted.map(|text| text.replace('_', " ")).filter(|text| !text.trim().is_empty()).collect()
}

/// Whether a word is a symbol with its index. The title of a picture, which has no markup, writes it with an underscore.
fn is_symbol(word: &str) -> bool {
    let Some((symbol, index)) = word.split_once('_') else { return false };
    (1..=2).contains(&symbol.chars().count()) && (1..=4).contains(&index.chars().count())
}

/// What is wrong with a text of a page, if anything.
fn fault(shown: &Shown, said: &[String]) -> Option<&'static str> {
    // The name of the job, its description and its title block.
    let job_says = ["h1", "p class=\"subtitle\"", "dd"].contains(&shown.tag.as_str());
    if job_says || said.iter().any(|text| *text == shown.text.replace('_', " ")) {
        return None;
    }
    let is_edge = |c: char| " ,;:()[]|±≤≥\"'\u{202f}".contains(c);
    let words = |text: &str| -> Vec<String> {
        let found = text.split(is_edge).map(|word| word.trim_end_matches('.').to_owned());
        found.filter(|word| !word.is_empty()).collect()
    };
    let keys = without_named_keys(shown);
    for word in words(&keys) {
        let bare = word.replace("_{", "");
        if is_file(&bare) || said.iter().any(|text| text.contains(&bare.replace('_', " "))) {
            continue;
        }
        let in_title = shown.tag == "title" && is_symbol(&bare);
        if bare.contains('_') && !in_title {
            return Some("a key with an underscore");
        }
        let dotted = bare.split_once('.').is_some_and(|(before, after)| {
            before.starts_with(|c: char| c.is_alphabetic())
                && after.starts_with(|c: char| c.is_ascii_lowercase())
        });
        if dotted {
            return Some("a key with a dot");
        }
    }
    let assigned = keys.split(" = ").collect::<Vec<_>>();
    for pair in assigned.windows(2) {
        let name = pair[0].rsplit(' ').next().unwrap_or_default();
        let is_word = name.len() >= 4 && name.bytes().all(|b| b.is_ascii_lowercase());
        let value =
            pair[1].split(|c: char| !(c.is_ascii_digit() || ".-".contains(c))).next().unwrap_or_default();
        if is_word && value.contains('.') {
            return Some("a key with its value");
        }
    }
    for word in words(&shown.text) {
        if PLAIN_SYMBOLS.contains(&word.as_str()) {
            return Some("a symbol in the spelling of files");
        }
        if ["um", "deg", "urad"].contains(&word.as_str()) {
            return Some("a unit in plain letters");
        }
        if let Some(fault) = fault_of_number(&word) {
            return Some(fault);
        }
    }
    None
}

/// What is wrong with a number.
fn fault_of_number(word: &str) -> Option<&'static str> {
    let number: String = word.chars().skip_while(|c| "−-+".contains(*c)).collect();
    let end = number.find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(number.len());
    let (digits, rest) = number.split_at(end);
    if digits.is_empty() {
        return None;
    }
    let exponent = rest.strip_prefix(['e', 'E']).map(|rest| rest.trim_start_matches(['-', '+']));
    if exponent.is_some_and(|rest| !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit())) {
        return Some("a number as computers write it");
    }
    let decimals = digits.split_once('.')?.1.len();
    let significant = digits.replace('.', "").trim_start_matches('0').len();
    (significant > 6 && decimals > 3).then_some("a number with needless digits")
}

#[test]
fn reports_name_things_plainly() {
    let mut faults = Vec::new();
    for of in pages() {
        let said = strings(&of.job);
        for shown in shown(&html::render(&of.page)) {
            if let Some(fault) = fault(&shown, &said) {
                faults.push(format!("{}: {fault}: <{}> {}", of.name, shown.tag, shown.text));
            }
        }
    }
    assert!(faults.is_empty(), "{} texts:\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn what_is_not_plain_is_found() {
    let found = |text: &str| {
        let shown = shown(&format!("<body><td>{text}</td></body>"));
        shown.iter().find_map(|shown| fault(shown, &["my_dresser 3".replace('_', " ")]))
    };
    for (text, wanted) in [
        ("exponent = 1.0, length_mm = 6.0", "a key with an underscore"),
        ("exponent = 1.0", "a key with its value"),
        ("fHa.left.mean", "a key with a dot"),
        ("fHa is 5 µm", "a symbol in the spelling of files"),
        ("5 of 8 um", "a unit in plain letters"),
        ("3.0000000000000004°", "a number with needless digits"),
        ("8.9e-11 µm", "a number as computers write it"),
        ("machine eight_axis", "a key with an underscore"),
    ] {
        assert_eq!(found(text), Some(wanted), "{text}");
    }
    for text in [
        "f<sub>Hα</sub> is 5 µm",
        "raise it (`grinding.prefer`). Remedy: raise worm.tip_diameter",
        "programs/grinding-linuxcnc.ngc",
        "K = 1.5, z = 3 mm, 20743.685 mm, 0.00123456",
        "my_dresser 3",
    ] {
        assert_eq!(found(text), None, "{text}");
    }
}
