//! Charts of a finished page: the reader of what [`html`](crate::html) writes at every figure.

use std::ops::Range;

/// A chart and where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlacedChart {
    /// Its id, unique on the page.
    pub id: String,
    /// What it shows.
    pub title: String,
    /// Heading of its section.
    pub section: String,
    /// Bytes of its `<svg>` element.
    pub place: Range<usize>,
}

/// What begins a figure; no text of a report can hold it, because `<` and `"` are escaped there.
pub(crate) const FIGURE: &str = "<figure data-chart=\"";

/// The charts of a page in their order. A page of another program has none.
pub fn charts_of_page(page: &str) -> Vec<PlacedChart> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(start) = page[at..].find(FIGURE).map(|next| at + next) {
        at = start + FIGURE.len();
        let Some((placed, end)) = chart(page, start) else { continue };
        found.push(placed);
        at = end;
    }
    found
}

fn chart(page: &str, start: usize) -> Option<(PlacedChart, usize)> {
    let tag = &page[start..start + page[start..].find('>')?];
    let attribute = |name: &str| {
        let (_, rest) = tag.split_once(&format!(" {name}=\""))?;
        rest.split_once('"').map(|(value, _)| plain(value))
    };
    let from = start + page[start..].find("<svg ")?;
    let end = from + page[from..].find("</svg>")? + "</svg>".len();
    let placed = PlacedChart {
        id: attribute("data-chart")?,
        title: attribute("data-title")?,
        section: attribute("data-section")?,
        place: from..end,
    };
    Some((placed, end))
}

/// The text of an attribute.
fn plain(text: &str) -> String {
    let mut plain = text.to_owned();
    for (entity, letter) in [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&#39;", "'"), ("&amp;", "&")] {
        plain = plain.replace(entity, letter);
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::charts::Canvas;
    use crate::data::{Banner, Block, Figure, PlanReport, Section};
    use crate::html;
    use crate::{FirstPage, Language, TitleBlock};
    use verdict::Status;

    #[test]
    fn charts_are_found_by_their_ids() {
        let svg = |title: &str| Canvas::new(1.0, 1.0, title).finish();
        let figure = |id: &str, title: &str| Figure::new(id, svg(title), "A caption.");
        let sections = vec![
            Section::new(
                "flanks",
                "Flanks",
                vec![Block::Figure(figure("map", "Target, \"contour\" & <map>"))],
            ),
            Section::new(
                "programs",
                "NC programs",
                vec![
                    Block::Heading("Dressing".into()),
                    Block::Figures(vec![figure("dressing-x1", "Axis X1"), figure("dressing-x1", "Axis X1")]),
                ],
            ),
        ];
        let banner = Banner { status: Status::Met.into(), headline: String::new(), figures: vec![] };
        let page = PlanReport {
            title: "A".into(),
            subtitle: None,
            language: Language::English,
            title_block: TitleBlock::default(),
            banner,
            first_page: FirstPage::default(),
            sections,
        };
        let text = html::render(&page);
        let found = charts_of_page(&text);
        let told: Vec<[&str; 3]> =
            found.iter().map(|c| [c.id.as_str(), c.title.as_str(), c.section.as_str()]).collect();
        assert_eq!(
            told,
            [
                ["map", "Target, \"contour\" & <map>", "Flanks"],
                ["dressing-x1", "Dressing: Axis X1", "NC programs"],
                ["dressing-x1-2", "Dressing: Axis X1", "NC programs"],
            ]
        );
        for chart in &found {
            let svg = &text[chart.place.clone()];
            assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>"), "{svg}");
        }
        assert!(text.contains("<section id=\"programs\">"));
    }

    #[test]
    fn a_page_that_is_cut_off_has_no_chart_there() {
        for broken in
            ["", "<svg ", FIGURE, "<figure data-chart=\"a\"><svg ", "<figure data-chart=\"ä\"><svg x></svg>"]
        {
            assert!(charts_of_page(broken).is_empty(), "{broken}");
        }
    }
}
