//! The modules of the library are layers: each imports only from those below it, and the referee (`removal`)
//! shares no formula with what it judges. This test reads the sources and names every import that breaks it.

use std::fs;
use std::path::Path;

/// The layers from the ground up; those that do not exist yet keep their place.
const LAYERS: [&str; 17] = [
    "numerics",
    "geometry",
    "modification",
    "kinematics",
    "inverse",
    "machine",
    "contact",
    "removal",
    "metrology",
    "control",
    "process",
    "nc",
    "motion",
    "exchange",
    "verdict",
    "report",
    "workflow",
];

/// Forbidden although below: the referee must not know how contact is computed.
const FORBIDDEN: [(&str, &str); 3] = [("removal", "contact"), ("removal", "process"), ("process", "removal")];

#[test]
fn no_module_imports_upwards() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = Vec::new();
    let mut files = 0;
    visit(&root, &mut |path, text| {
        files += 1;
        let relative = path.strip_prefix(&root).expect("a file below src");
        let modules = module_path(relative);
        found.extend(violations(&modules, text).into_iter().map(|v| format!("{}: {v}", relative.display())));
    });
    assert!(files > LAYERS.len() / 2, "only {files} sources found below {}", root.display());
    assert!(found.is_empty(), "imports against the layers:\n{}", found.join("\n"));
}

#[test]
fn every_module_of_the_library_is_a_layer() {
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lib.rs")).expect("lib.rs");
    let code = code_only(&text);
    let modules: Vec<&str> = code
        .lines()
        .filter_map(|line| line.trim().trim_start_matches("pub ").strip_prefix("mod ")?.strip_suffix(';'))
        .collect();
    assert!(modules.len() > 5, "{modules:?}");
    let places: Vec<Option<usize>> = modules.iter().map(|m| LAYERS.iter().position(|l| l == m)).collect();
    assert!(
        places.iter().all(Option::is_some),
        "lib.rs has a module without a place among the layers: {modules:?}"
    );
    assert!(places.is_sorted(), "lib.rs lists its modules in another order than the layers: {modules:?}");
}

#[test]
fn the_check_finds_violations() {
    let cases: [(&[&str], &str, &[&str]); 15] = [
        (&["geometry", "gear"], "use crate::process::Plan;", &["process"]),
        (&["geometry"], "use crate::{numerics::Scalar, workflow::{Plan, Progress}};", &["workflow"]),
        (&["geometry"], "use crate :: {\n  contact,\n  report as r,\n};", &["contact", "report"]),
        (&["removal"], "fn f() { crate::contact::solve(); }", &["contact"]),
        (&["removal", "rays"], "use super::super::process::grind;", &["process"]),
        (&["removal"], "use super::{geometry, contact};", &["contact"]),
        (&["removal", "rays"], "use super::super::{numerics, process::x};", &["process"]),
        (&["removal", "rays"], "mod tests { use super::super::super::contact; }", &["contact"]),
        (&["exchange", "job", "gear"], "use flankwright::report::Chart;", &["report"]),
        (&["kinematics"], "pub use self::super::inverse::Newton;", &["inverse"]),
        (&["process", "dressing"], "use crate::contact::solve; use crate::removal::rays;", &["removal"]),
        (
            &["process"],
            "// use crate::workflow::Plan;\n/* crate::report::x /* nested */ crate::report::y */",
            &[],
        ),
        (&["process"], "const TEXT: &str = \"crate::workflow\"; // quote\"\n", &[]),
        (&["process", "dressing"], "use super::generating::grind;", &[]),
        (&["contact"], "/// See [`crate::workflow`].\nuse crate::contact::closed;", &[]),
    ];
    for (modules, text, expected) in cases {
        let found = violations(&modules.iter().map(|m| (*m).to_owned()).collect::<Vec<_>>(), text);
        assert_eq!(found.len(), expected.len(), "{modules:?} {text}: {found:?}");
        for (violation, layer) in found.iter().zip(expected) {
            assert!(violation.contains(&format!("`{layer}`")), "{violation}");
        }
    }
}

fn visit(directory: &Path, act: &mut impl FnMut(&Path, &str)) {
    for entry in fs::read_dir(directory).expect("a readable directory") {
        let path = entry.expect("a readable entry").path();
        if path.is_dir() {
            visit(&path, act);
        } else if path.extension().is_some_and(|e| e == "rs") {
            act(&path, &fs::read_to_string(&path).expect("a readable source"));
        }
    }
}

/// `geometry/gear.rs` -> [geometry, gear]; `geometry/mod.rs` -> [geometry].
fn module_path(relative: &Path) -> Vec<String> {
    let mut modules: Vec<String> = relative
        .with_extension("")
        .components()
        .map(|c| c.as_os_str().to_string_lossy().into_owned())
        .collect();
    if modules.last().is_some_and(|last| last == "mod" || last == "lib") {
        modules.pop();
    }
    modules
}

/// Every layer that the source of a module uses although it must not.
fn violations(modules: &[String], text: &str) -> Vec<String> {
    let Some(place) = modules.first().and_then(|m| LAYERS.iter().position(|l| l == m)) else {
        return Vec::new();
    };
    let layer = LAYERS[place];
    let mut found = Vec::new();
    for used in used_layers(modules.len(), &code_only(text)) {
        let upwards = LAYERS.iter().position(|l| *l == used).is_some_and(|p| p > place);
        let forbidden = FORBIDDEN.contains(&(layer, used.as_str()));
        if (upwards || forbidden) && !found.contains(&used) {
            found.push(used);
        }
    }
    found.into_iter().map(|used| format!("`{layer}` imports `{used}`")).collect()
}

/// First names of all paths that start at the root of the crate. `depth` is the number of modules from the root
/// to this file: as many `super` lead there. A module inside the file needs one more, so more count as well.
fn used_layers(depth: usize, code: &str) -> Vec<String> {
    let tokens = tokens(code);
    let is = |at: usize, wanted: &str| tokens.get(at).is_some_and(|t| t == wanted);
    let mut found = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        let begins = at == 0 || tokens[at - 1] != "::";
        let mut next = at;
        let mut to_root = false;
        if begins && (is(at, "crate") || is(at, "flankwright")) && is(at + 1, "::") {
            next = at + 2;
            to_root = true;
        } else if begins {
            let mut supers = 0;
            while (is(next, "super") || is(next, "self")) && is(next + 1, "::") {
                supers += usize::from(is(next, "super"));
                next += 2;
            }
            to_root = supers > 0 && supers >= depth;
        }
        if to_root && next < tokens.len() {
            first_names(&tokens[next..], &mut found);
        }
        at = next.max(at + 1);
    }
    found.retain(|name| LAYERS.contains(&name.as_str()));
    found
}

/// The name, or the first name of each branch of a group `{a::x, b::{c}, d as e}`.
fn first_names(tokens: &[String], found: &mut Vec<String>) {
    if tokens[0] != "{" {
        found.push(tokens[0].clone());
        return;
    }
    let mut depth = 0;
    let mut expects_name = false;
    for token in tokens {
        match token.as_str() {
            "{" => {
                depth += 1;
                expects_name = depth == 1;
            }
            "}" if depth == 1 => return,
            "}" => depth -= 1,
            "," => expects_name = depth == 1,
            name if expects_name => {
                found.push(name.to_owned());
                expects_name = false;
            }
            _ => {}
        }
    }
}

/// Names, `::` and single characters; white space falls away.
fn tokens(code: &str) -> Vec<String> {
    let mut tokens = Vec::new();
    let mut rest = code;
    while let Some(first) = rest.chars().next() {
        let word = rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(rest.len());
        let length = match word {
            0 if rest.starts_with("::") => 2,
            0 => first.len_utf8(),
            word => word,
        };
        if !first.is_whitespace() {
            tokens.push(rest[..length].to_owned());
        }
        rest = &rest[length..];
    }
    tokens
}

/// The source without comments and without what stands in texts.
fn code_only(text: &str) -> String {
    let mut code = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let skip = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            comment_length(rest)
        } else if first == '"' {
            text_length(rest)
        } else if let Some(length) = raw_text_length(rest, code.chars().next_back()) {
            length
        } else if rest.starts_with("'\"'") || rest.starts_with("'\\\"'") {
            rest[1..].find('\'').map_or(1, |i| i + 2)
        } else {
            code.push(first);
            rest = &rest[first.len_utf8()..];
            continue;
        };
        // What falls away separates like a blank.
        code.push(' ');
        rest = &rest[skip..];
    }
    code
}

/// Length of a comment that may hold others.
fn comment_length(text: &str) -> usize {
    let mut depth = 0;
    let mut at = 0;
    while at < text.len() {
        let rest = &text[at..];
        if rest.starts_with("/*") {
            depth += 1;
            at += 2;
        } else if rest.starts_with("*/") {
            depth -= 1;
            at += 2;
            if depth == 0 {
                return at;
            }
        } else {
            at += rest.chars().next().map_or(1, char::len_utf8);
        }
    }
    text.len()
}

/// Length of a text literal from its opening quote.
fn text_length(text: &str) -> usize {
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            '"' => return at + 1,
            _ => {}
        }
    }
    text.len()
}

/// Length of a raw text literal `r#"..."#`, if one begins here.
fn raw_text_length(text: &str, before: Option<char>) -> Option<usize> {
    if before.is_some_and(|c| c.is_alphanumeric() && c != 'b' || c == '_') {
        return None;
    }
    let body = text.strip_prefix('r')?;
    let hashes = body.len() - body.trim_start_matches('#').len();
    let inside = body[hashes..].strip_prefix('"')?;
    let end = format!("\"{}", "#".repeat(hashes));
    Some(inside.find(&end).map_or(text.len(), |i| 1 + hashes + 1 + i + end.len()))
}
