//! Charts of a result. They are those of its report, found there by their ids, so that report and screen show the same pictures.

use flankwright::report::charts_of_page;
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
    let placed = charts_of_page(page).into_iter().map(|found| Placed {
        chart: Chart { name: found.id, title: found.title, section: found.section },
        page: name.to_owned(),
        start: found.place.start,
        end: found.place.end,
    });
    placed.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn charts_have_the_names_of_their_ids() {
        let page = "<section id=\"flanks\"><h2>Flanks</h2>\
                    <figure data-chart=\"target-map\" data-title=\"Target &amp; map\" data-section=\"Flanks\">\
                    <svg aria-label=\"Target\"><g/></svg></figure><svg aria-label=\"no chart\"></svg>";
        let found = of_result(|name| (name == "explore.html").then_some(page.as_bytes()));
        let [Placed { chart, page: name, start, end }] = &found[..] else { panic!("{found:?}") };
        let (title, section) = ("Target & map".to_owned(), "Flanks".to_owned());
        assert_eq!(*chart, Chart { name: "target-map".into(), title, section });
        assert_eq!(&page[*start..*end], "<svg aria-label=\"Target\"><g/></svg>");
        assert_eq!(name, "explore.html");
        assert!(of_result(|_| None).is_empty() && of_result(|_| Some(b"\xff")).is_empty());
    }
}
