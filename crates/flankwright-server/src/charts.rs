//! Charts of a result. They are those of its report, found there by their titles, so that report and screen show the same pictures.

use serde::{Deserialize, Serialize};

use crate::wire::Chart;

/// Pages of results that carry charts.
const PAGES: [&str; 3] = ["report.html", "explore.html", "series.html"];

/// A chart and where it stands.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Placed {
    /// The chart.
    pub chart: Chart,
    /// The page.
    pub page: String,
    /// Where it begins there, in bytes.
    pub start: usize,
    /// Where it ends.
    pub end: usize,
}

/// The charts of a result, whose files are asked for by name.
pub fn of_result<'a>(file: impl Fn(&str) -> Option<&'a [u8]>) -> Vec<Placed> {
    let page = PAGES.into_iter().find_map(|name| Some((name, std::str::from_utf8(file(name)?).ok()?)));
    page.map(|(name, text)| on_page(name, text)).unwrap_or_default()
}

fn on_page(name: &str, page: &str) -> Vec<Placed> {
    let mut found: Vec<Placed> = Vec::new();
    let (mut section, mut part) = (String::new(), String::new());
    let mut at = 0;
    while let Some(start) = page[at..].find('<').map(|next| at + next) {
        let rest = &page[start..];
        at = start + 1;
        if let Some(heading) = element(rest, "h2") {
            (section, part) = (words(heading), String::new());
        } else if let Some(heading) = element(rest, "h3") {
            part = words(heading);
        } else if rest.starts_with("<svg ") {
            let Some(end) = rest.find("</svg>").map(|end| start + end + "</svg>".len()) else { break };
            let label = rest.split_once("aria-label=\"").and_then(|(_, rest)| rest.split('"').next());
            let label = words(label.unwrap_or_default());
            let title = if part.is_empty() { label } else { format!("{part}: {label}") };
            let same = found.iter().filter(|placed| placed.chart.title == title).count();
            let number = if same == 0 { String::new() } else { format!("-{}", same + 1) };
            let chart = Chart { name: format!("{}{number}", slug(&title)), title, section: section.clone() };
            found.push(Placed { chart, page: name.to_owned(), start, end });
            at = end;
        }
    }
    found
}

/// What is in an element that begins the text.
fn element<'a>(text: &'a str, name: &str) -> Option<&'a str> {
    let inner = text.strip_prefix('<')?.strip_prefix(name)?;
    let inner = inner
        .strip_prefix('>')
        .or_else(|| inner.strip_prefix(' ').and_then(|i| i.split_once('>')).map(|i| i.1))?;
    inner.split_once("</").map(|(inner, _)| inner)
}

/// Text of a page in plain letters.
fn words(text: &str) -> String {
    let mut plain = text.to_owned();
    for (entity, letter) in [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&#39;", "'"), ("&amp;", "&")] {
        plain = plain.replace(entity, letter);
    }
    plain
}

fn slug(title: &str) -> String {
    let mut slug = String::new();
    for letter in title.chars() {
        if letter.is_alphanumeric() {
            slug.extend(letter.to_lowercase());
        } else if !slug.ends_with('-') && !slug.is_empty() {
            slug.push('-');
        }
    }
    slug.trim_end_matches('-').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn charts_have_the_names_of_their_titles() {
        let page = "<h2>Flanks</h2><figure><svg aria-label=\"Target, contour &amp; map\"><g/></svg></figure>\
                    <h2>Programs</h2><h3>Dressing</h3><svg aria-label=\"Axis X1\"></svg><svg aria-label=\"Axis X1\">2</svg>";
        let found = of_result(|name| (name == "explore.html").then_some(page.as_bytes()));
        let names: Vec<(&str, &str, &str)> = found
            .iter()
            .map(|Placed { chart, .. }| (chart.name.as_str(), chart.title.as_str(), chart.section.as_str()))
            .collect();
        assert_eq!(
            names,
            [
                ("target-contour-map", "Target, contour & map", "Flanks"),
                ("dressing-axis-x1", "Dressing: Axis X1", "Programs"),
                ("dressing-axis-x1-2", "Dressing: Axis X1", "Programs"),
            ]
        );
        assert_eq!(&page[found[2].start..found[2].end], "<svg aria-label=\"Axis X1\">2</svg>");
        assert_eq!(found[2].page, "explore.html");
        for broken in ["<svg ", "< <<h2", ""] {
            assert!(of_result(|_| Some(broken.as_bytes())).is_empty());
        }
        assert!(of_result(|_| None).is_empty() && of_result(|_| Some(b"\xff")).is_empty());
    }
}
