//! Charts of a result. They are those of its report, found there by their titles, so that report and screen show the same pictures.

use std::ops::Range;
use std::sync::Arc;

use axum::extract::State;
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};

use super::error::{Answer, Refused};
use super::take::InPath;
use crate::app::App;
use crate::wire::{Chart, Failure};

/// Pages of results that carry charts.
const PAGES: [&str; 3] = ["report.html", "explore.html", "series.html"];

/// The page of a run with its charts.
pub(super) async fn page(app: &App, id: i64) -> Answer<Option<String>> {
    for name in PAGES {
        if let Some(file) = app.store.run_file(id, name).await? {
            return Ok(String::from_utf8(file.bytes).ok());
        }
    }
    Ok(None)
}

/// The charts of a page with their places in it.
pub(super) fn charts(page: &str) -> Vec<(Chart, Range<usize>)> {
    let mut found: Vec<(Chart, Range<usize>)> = Vec::new();
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
            let Some(end) = rest.find("</svg>").map(|end| end + "</svg>".len()) else { break };
            let label = rest.split_once("aria-label=\"").and_then(|(_, rest)| rest.split('"').next());
            let label = words(label.unwrap_or_default());
            let title = if part.is_empty() { label } else { format!("{part}: {label}") };
            let same = found.iter().filter(|(chart, _)| chart.title == title).count();
            let number = if same == 0 { String::new() } else { format!("-{}", same + 1) };
            let name = format!("{}{number}", slug(&title));
            found.push((Chart { name, title, section: section.clone() }, start..start + end));
            at = start + end;
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

/// A chart of the result as SVG.
#[utoipa::path(get, path = "/api/runs/{id}/charts/{name}", params(("id" = i64, Path, description = "number of the run"),
    ("name" = String, Path, description = "as the run lists it")),
    responses((status = 200, content_type = "image/svg+xml"), (status = 404, body = Failure)))]
pub async fn chart(
    State(app): State<Arc<App>>,
    InPath((id, name)): InPath<(i64, String)>,
) -> Answer<Response> {
    let page = page(&app, id).await?.ok_or_else(|| Refused::absent("chart"))?;
    let place = charts(&page).into_iter().find(|(chart, _)| chart.name == name).map(|(_, place)| place);
    let svg = page[place.ok_or_else(|| Refused::absent("chart"))?].to_owned();
    Ok(([(CONTENT_TYPE, "image/svg+xml")], svg).into_response())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn charts_have_the_names_of_their_titles() {
        let page = "<h2>Flanks</h2><figure><svg aria-label=\"Target, contour &amp; map\"><g/></svg></figure>\
                    <h2>Programs</h2><h3>Dressing</h3><svg aria-label=\"Axis X1\"></svg><svg aria-label=\"Axis X1\">2</svg>";
        let found = charts(page);
        let names: Vec<(&str, &str, &str)> = found
            .iter()
            .map(|(chart, _)| (chart.name.as_str(), chart.title.as_str(), chart.section.as_str()))
            .collect();
        assert_eq!(
            names,
            [
                ("target-contour-map", "Target, contour & map", "Flanks"),
                ("dressing-axis-x1", "Dressing: Axis X1", "Programs"),
                ("dressing-axis-x1-2", "Dressing: Axis X1", "Programs"),
            ]
        );
        assert_eq!(&page[found[2].1.clone()], "<svg aria-label=\"Axis X1\">2</svg>");
        assert!(charts("<svg ").is_empty() && charts("< <<h2").is_empty());
    }
}
