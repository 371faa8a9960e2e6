//! A table of bodies as comma-separated text: one row a body, the keys of the TOML form as titles, `designed_for.threads` for a
//! key inside a table. Becomes the same tree as TOML, so that the same checks speak about it with line and column.

use std::ops::Range;

use job::{Diagnostic, Entry, Kind, Node, Problem};

/// Titles whose cells are words even if they look like numbers.
const WORDS: [&str; 2] = ["name", "hand"];

/// Parses a table into a list of bodies under the key `list`.
pub(super) fn parse(text: &str, list: &str) -> Result<Node, Diagnostic> {
    let mut titles: Option<Vec<(String, Range<usize>)>> = None;
    let mut bodies = Vec::new();
    let mut offset = 0;
    for line in text.split_inclusive('\n') {
        let start = offset;
        offset += line.len();
        let line = line.trim_end_matches(['\n', '\r']);
        if line.trim().is_empty() || line.starts_with('#') {
            continue;
        }
        let cells = cells(line, start)?;
        match &titles {
            None => titles = Some(headings(cells, start..start + line.len())?),
            Some(titles) => bodies.push(body(titles, &cells, start..start + line.len())?),
        }
    }
    if titles.is_none() {
        return Err(Diagnostic::new(Problem::InvalidTable, "the table is empty")
            .allowed("a line of titles and one line for each body")
            .way_out("begin with a line such as `name,threads,pitch_diameter,width`"));
    }
    let whole = 0..text.len();
    let value = Node { kind: Kind::List(bodies), span: whole.clone() };
    let entry = Entry { key: list.to_owned(), key_span: whole.clone(), value };
    Ok(Node { kind: Kind::Table(vec![entry]), span: whole })
}

/// A cell without its quotes, and its place.
type Cell = (String, Range<usize>);

/// Splits a line at its commas; a cell in quotes may contain commas, and quotes as `""`.
fn cells(line: &str, start: usize) -> Result<Vec<Cell>, Diagnostic> {
    let mut cells = Vec::new();
    let mut rest = 0;
    loop {
        let tail = &line[rest..];
        let lead = tail.len() - tail.trim_start().len();
        if tail[lead..].starts_with('"') {
            let from = rest + lead;
            let mut text = String::new();
            let mut at = from + 1;
            loop {
                let Some(quote) = line[at..].find('"') else {
                    return Err(Diagnostic::new(Problem::InvalidTable, "a quote is not closed on its line")
                        .value(line[from..].chars().take(60).collect::<String>())
                        .allowed("words in quotes end on their line; a quote inside is written twice")
                        .way_out("close the quote")
                        .span(Some(start + from..start + line.len())));
                };
                text += &line[at..at + quote];
                at += quote + 1;
                if !line[at..].starts_with('"') {
                    break;
                }
                text.push('"');
                at += 1;
            }
            cells.push((text, start + from..start + at));
            let after = line[at..].trim_start();
            if !after.is_empty() && !after.starts_with(',') {
                return Err(Diagnostic::new(Problem::InvalidTable, "something follows a word in quotes")
                    .value(after.chars().take(60).collect::<String>())
                    .allowed("a comma or the end of the line")
                    .way_out("put the whole cell in quotes")
                    .span(Some(start + from..start + line.len())));
            }
            rest = line.len() - after.len();
        } else {
            let length = tail.find(',').unwrap_or(tail.len());
            let cell = tail[..length].trim();
            let from = rest + tail[..length].find(cell).unwrap_or(0);
            cells.push((cell.to_owned(), start + from..start + from + cell.len()));
            rest += length;
        }
        if rest >= line.len() {
            return Ok(cells);
        }
        rest += 1; // the comma
        if rest == line.len() {
            cells.push((String::new(), start + rest..start + rest));
            return Ok(cells);
        }
    }
}

fn headings(cells: Vec<Cell>, line: Range<usize>) -> Result<Vec<Cell>, Diagnostic> {
    for (i, (title, span)) in cells.iter().enumerate() {
        let twice = cells[..i].iter().any(|(other, _)| other == title);
        let clash = cells.iter().any(|(other, _)| other.starts_with(&format!("{title}.")));
        let problem = match (title.is_empty(), twice, clash) {
            (true, ..) => "a column has no title",
            (_, true, _) => "a column stands twice",
            (_, _, true) => "a column stands beside columns of the same key",
            _ => continue,
        };
        return Err(Diagnostic::new(Problem::InvalidTable, problem)
            .field(title.as_str())
            .value(format!("{title:?}"))
            .allowed("each key of a body once, e.g. `designed_for.threads` for a key inside a table")
            .way_out("remove the column or correct its title")
            .span(Some(if span.is_empty() { line } else { span.clone() })));
    }
    Ok(cells)
}

fn body(titles: &[Cell], cells: &[Cell], line: Range<usize>) -> Result<Node, Diagnostic> {
    if cells.len() != titles.len() {
        return Err(Diagnostic::new(
            Problem::InvalidTable,
            format!("a row of {} cells in a table of {} columns", cells.len(), titles.len()),
        )
        .value(cells.len())
        .allowed(format!("{} cells; a key that is left out is an empty cell", titles.len()))
        .way_out("add or remove commas; a comma inside a word needs quotes around the word")
        .span(Some(line)));
    }
    let mut entries: Vec<Entry> = Vec::new();
    for ((title, _), (text, span)) in titles.iter().zip(cells) {
        if text.is_empty() {
            continue;
        }
        // The place of a key is its cell: that is where a person has to look.
        let leaf = Node { kind: kind(title, text), span: span.clone() };
        insert(&mut entries, title, leaf, &line);
    }
    Ok(Node { kind: Kind::Table(entries), span: line })
}

/// Puts a value at a path such as `designed_for.threads`.
fn insert(entries: &mut Vec<Entry>, path: &str, leaf: Node, line: &Range<usize>) {
    let span = leaf.span.clone();
    let Some((key, rest)) = path.split_once('.') else {
        entries.push(Entry { key: path.to_owned(), key_span: span, value: leaf });
        return;
    };
    let place = entries.iter().position(|e| e.key == key).unwrap_or_else(|| {
        let value = Node { kind: Kind::Table(Vec::new()), span: line.clone() };
        entries.push(Entry { key: key.to_owned(), key_span: span, value });
        entries.len() - 1
    });
    if let Kind::Table(inner) = &mut entries[place].value.kind {
        insert(inner, rest, leaf, line);
    }
}

fn kind(title: &str, text: &str) -> Kind {
    if WORDS.contains(&title) {
        return Kind::Text(text.to_owned());
    }
    match (text.parse::<i64>(), text.parse::<f64>()) {
        (Ok(whole), _) => Kind::Integer(whole),
        (_, Ok(number)) => Kind::Float(number),
        _ => Kind::Text(text.to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_become_tables() {
        let text = "# worms\nname, threads ,designed_for.threads,designed_for.tip_diameter\r\n\
                    \"a, \"\"b\"\"\",3,5,\n100,2.5,,nan\n";
        let tree = parse(text, "worm").unwrap();
        let at = |path: &str| tree.follow(path).map(|(node, _)| node);
        assert_eq!(at("worm[0].name").unwrap().kind, Kind::Text("a, \"b\"".into()));
        assert_eq!(at("worm[0].threads").unwrap().kind, Kind::Integer(3));
        assert_eq!(at("worm[0].designed_for.threads").unwrap().kind, Kind::Integer(5));
        assert_eq!(at("worm[0].designed_for.tip_diameter"), None);
        assert_eq!(at("worm[1].name").unwrap().kind, Kind::Text("100".into()));
        assert_eq!(at("worm[1].threads").unwrap().kind, Kind::Float(2.5));
        let Kind::Float(nan) = at("worm[1].designed_for.tip_diameter").unwrap().kind else { panic!() };
        assert!(nan.is_nan());
        assert_eq!(&text[at("worm[1].threads").unwrap().span.clone()], "2.5");
        assert_eq!(&text[at("worm[0].name").unwrap().span.clone()], "\"a, \"\"b\"\"\"");
    }

    #[test]
    fn malformed_tables_are_refused_at_their_place() {
        for (text, line) in [
            ("", None),
            ("# only a remark\n", None),
            ("name,threads\na,3,4\n", Some(2)),
            ("name,threads\na\n", Some(2)),
            ("name,,threads\n", Some(1)),
            ("name,name\n", Some(1)),
            ("designed_for,designed_for.threads\n", Some(1)),
            ("name,threads\n\"a,3\n", Some(2)),
            ("name,threads\n\"a\"b,3\n", Some(2)),
        ] {
            let finding = parse(text, "worm").unwrap_err();
            assert_eq!(finding.code, "invalid-table", "{text}");
            let at = finding.span.as_ref().map(|s| 1 + text[..s.start].matches('\n').count());
            assert_eq!(at, line, "{text}: {finding}");
            assert!(finding.way_out.is_some() && finding.allowed.is_some());
        }
    }
}
