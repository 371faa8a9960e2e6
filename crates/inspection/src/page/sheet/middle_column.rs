//! The column between the fields: magnifications, the scale of both fields, the numbers of the teeth.

use super::book::{Book, GRID, LABEL, MARGIN, WIDTH, centred, from_left, from_right};
use super::flank_place::FlankPlace;
use super::laid_row::{FIELD, PLOT, PlacedRow};
use super::traces_data::ScaleLine;
use foundation::geometry::Flank;
use report::charts::format_fixed;
use report::charts::magnification::words;

/// Least distance of two labels.
const APART: f64 = 2.3;
/// Height of a figure over its line.
const FIGURE: f64 = 0.7;

/// Draws the column of a row.
pub(super) fn draw(book: &mut Book, row: &PlacedRow) {
    let data = row.laid.row;
    let (left, right) = (MARGIN + FIELD, MARGIN + WIDTH - FIELD);
    let middle = 0.5 * (left + right);
    let width = right - left;
    let scales = format!(
        "f {}, {} {}",
        words(row.laid.magnification),
        data.coordinate,
        words(row.ordinate.magnification())
    );
    book.fitted([middle, row.top + 2.2], width - 0.6, &scales, centred(LABEL).bold());
    let [from, to] = PLOT.map(|y| row.top + y);
    let y = row.top + 4.7;
    book.fitted([middle, y], 0.98 * width, &data.top, centred(LABEL).muted());
    let mut names: Vec<(f64, &str)> = Vec::new();
    for flank in Flank::BOTH {
        let lines = sorted(&data.flanks[flank].lines, row);
        let ends = [from + 1.2, to - 0.6];
        let places = spread(&lines.iter().map(|(y, _)| *y).collect::<Vec<f64>>(), ends);
        let place = FlankPlace::of(flank);
        let style = if flank == Flank::Left { from_left(LABEL) } else { from_right(LABEL) };
        for ((y, line), label) in lines.iter().zip(places) {
            let [at, bend] = [-0.1, -1.3].map(|d| place.outward(d));
            book.page().line([at, *y], [bend, label], GRID);
            // Room for five figures on either side of the names.
            let text = format_fixed(line.value, if line.value.abs() < 100.0 { 3 } else { 2 });
            book.fitted([place.outward(-1.5), label + FIGURE], 6.5, &text, style);
            // Both fields share a name where their labels do.
            let known = |(y, name): &(f64, &str)| *name == line.name && (y - label).abs() < APART;
            if !names.iter().any(known) {
                names.push((label, &line.name));
            }
        }
    }
    let mut free = f64::NEG_INFINITY;
    names.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (y, name) in names {
        let y = y.max(free + 0.8 * APART);
        free = y;
        book.fitted([middle, y + FIGURE], 3.8, name, centred(0.9 * LABEL).muted());
    }
    teeth(book, row, middle, width);
}

/// Below the scale: its unit, the lower end, the teeth from the middle outwards.
fn teeth(book: &mut Book, row: &PlacedRow, middle: f64, width: f64) {
    let data = row.laid.row;
    let text = format!("{} – {}", data.bottom, data.scale);
    book.fitted([middle, row.top + 50.9], width - 0.6, &text, centred(LABEL).muted());
    let teeth: Vec<String> = row.lanes.iter().map(|lane| lane.tooth.to_string()).collect();
    let word = if teeth.len() == 1 { "tooth" } else { "teeth outwards" };
    book.fitted([middle, row.top + 53.1], width - 0.6, word, centred(LABEL).muted());
    book.fitted([middle, row.top + 55.3], width - 0.6, &teeth.join("  "), centred(LABEL));
}

/// Lines from the top of the page downwards with their places.
fn sorted<'a>(lines: &'a [ScaleLine], row: &PlacedRow) -> Vec<(f64, &'a ScaleLine)> {
    let mut lines: Vec<(f64, &ScaleLine)> =
        lines.iter().map(|line| (row.ordinate.y(line.at_mm), line)).collect();
    lines.sort_by(|a, b| a.0.total_cmp(&b.0));
    lines
}

/// Places of labels near those wanted, ascending, apart, between the ends as far as they have room there.
fn spread(wanted: &[f64], [from, to]: [f64; 2]) -> Vec<f64> {
    let apart = if wanted.len() > 1 { APART.min((to - from) / (wanted.len() - 1) as f64) } else { APART };
    let mut places = wanted.to_vec();
    let mut least = from;
    for place in &mut places {
        *place = place.max(least);
        least = *place + apart;
    }
    let mut most = to;
    for place in places.iter_mut().rev() {
        *place = place.min(most);
        most = *place - apart;
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_keep_apart_and_stay_between_the_ends() {
        let close = [10.0, 10.1, 10.2, 47.9, 48.0];
        let places = spread(&close, [6.0, 48.0]);
        assert!(places.windows(2).all(|pair| pair[1] - pair[0] > APART - 1e-9), "{places:?}");
        assert!(places[0] >= 6.0 && places[4] <= 48.0, "{places:?}");
        assert_eq!(spread(&[10.0, 20.0], [6.0, 48.0]), [10.0, 20.0]);
        assert_eq!(spread(&vec![7.0; 100], [6.0, 48.0]).len(), 100);
        assert!(spread(&[], [6.0, 48.0]).is_empty());
    }
}
