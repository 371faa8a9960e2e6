//! Pages in one HTML file that prints one page a sheet: no script, no network.

use super::pages::SheetPage;
use report::Language;
use report::charts::escape;
use std::fmt::Write;

const STYLE: &str = "\
@page { size: A4 portrait; margin: 0; }
html, body { margin: 0; padding: 0; }
body { background: #d9dcdf; }
.sheet { width: 210mm; height: 297mm; margin: 6mm auto; background: #fff; overflow: hidden; break-inside: avoid; }
.sheet svg { display: block; }
@media print {
  body { background: #fff; }
  .sheet { margin: 0; break-after: page; }
  .sheet:last-child { break-after: auto; }
}
";

/// Pages of one or of many sheets as a file of its own, one page of paper each; their margins are in the pages.
pub fn sheet_html<'a>(
    title: &str,
    language: Language,
    pages: impl IntoIterator<Item = &'a SheetPage>,
) -> String {
    let mut html = String::with_capacity(1 << 18);
    let _ = write!(
        html,
        "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n<title>{} – flankwright</title>\n\
         <style>\n{STYLE}</style>\n</head>\n<body>\n",
        language.code(),
        escape(title)
    );
    for page in pages {
        html.push_str("<div class=\"sheet\">\n");
        html.push_str(page.svg.as_str());
        html.push_str("\n</div>\n");
    }
    html.push_str("</body>\n</html>\n");
    html
}
