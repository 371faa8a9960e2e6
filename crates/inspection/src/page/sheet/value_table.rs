//! The table under a field: a row per characteristic with the values of the teeth, mean, range and limit. What exceeds its limit is bold
//! with a star.

use super::book::{Book, GRID, TEXT, THIN, centred, from_left, from_right};
use super::flank_place::FlankPlace;
use super::laid_row::{FIELD, PlacedRow};
use super::limits::SheetLimits;
use super::text_fit::{fitting_size, number};
use super::traces_data::{JudgedBy, SheetCharacteristic, SheetTrace};
use foundation::geometry::Flank;
use report::charts::TextStyle;

/// Width of the names, then of mean, range and limit at the end.
const NAME: f64 = 12.5;
const ENDS: [f64; 3] = [9.5, 9.0, 13.0];
/// Widest column of a tooth.
const WIDEST: f64 = 11.0;
/// Heights of the heading and of a row.
const HEADING: f64 = 3.2;
const ROW: f64 = 3.05;
/// All rows together.
const ROWS: f64 = 18.5;

/// Draws the table of a flank below its field.
pub(super) fn draw_table(book: &mut Book, row: &PlacedRow, place: &FlankPlace, [left, top]: [f64; 2]) {
    let field = &row.laid.row.flanks[place.flank];
    // In the order in which the lanes stand above.
    let mut lanes: Vec<_> = row.lanes.iter().map(|lane| (lane.tooth, lane.traces[place.flank])).collect();
    if place.flank == Flank::Left {
        lanes.reverse();
    }
    let wide = ((FIELD - NAME - ENDS.iter().sum::<f64>()) / lanes.len().max(1) as f64).min(WIDEST);
    let pitch = ROW.min(ROWS / field.characteristics.len().max(1) as f64);
    let size = TEXT.min(0.82 * pitch);
    // Right ends of the columns.
    let of_tooth = |k: usize| left + NAME + wide * (k + 1) as f64;
    let mut end = of_tooth(lanes.len()) - wide;
    let ends = ENDS.map(|width| {
        end += width;
        end
    });
    let y = top + 2.5;
    book.text([left + 0.6, y], "tooth", from_left(size).muted());
    for (k, (tooth, _)) in lanes.iter().enumerate() {
        book.fitted([of_tooth(k) - 0.6, y], wide - 1.0, &tooth.to_string(), from_right(size).muted());
    }
    for (x, word) in ends.iter().zip(["mean", "range", "limit"]) {
        book.text([x - 0.6, y], word, from_right(size).muted());
    }
    book.page().line([left, top + HEADING], [left + FIELD, top + HEADING], THIN);
    for (n, of) in field.characteristics.iter().enumerate() {
        let y = top + HEADING + pitch * n as f64 + 0.78 * pitch;
        let name = format!("{} {}", of.symbol, of.unit);
        book.fitted([left + 0.6, y], NAME - 1.0, &name, from_left(size));
        for (k, (_, trace)) in lanes.iter().enumerate() {
            let Some(trace) = trace else { continue };
            let style = from_right(size);
            draw_value(
                book,
                [of_tooth(k) - 0.6, y],
                wide - 0.9,
                value_of(trace, n),
                of,
                JudgedBy::Each,
                style,
            );
        }
        draw_value(book, [ends[0] - 0.6, y], ENDS[0] - 0.9, of.mean, of, JudgedBy::Mean, from_right(size));
        let range = number(of.range, 1);
        book.fitted([ends[1] - 0.6, y], ENDS[1] - 0.9, &range, from_right(size));
        book.fitted([ends[2] - 0.6, y], ENDS[2] - 0.9, &limit_words(&of.limits, 1), from_right(size));
        if n > 0 {
            let y = top + HEADING + pitch * n as f64;
            book.page().line([left, y], [left + FIELD, y], GRID);
        }
    }
    let bottom = top + HEADING + pitch * field.characteristics.len() as f64;
    book.page().line([left, bottom], [left + FIELD, bottom], THIN);
    if field.characteristics.is_empty() {
        book.text([left + 0.5 * FIELD, top + 8.0], "not evaluated", centred(TEXT));
    }
}

fn value_of(trace: &SheetTrace, n: usize) -> Option<f64> {
    trace.values.get(n).copied().flatten()
}

/// A value that is judged if the characteristic is judged by such values.
fn draw_value(
    book: &mut Book,
    at: [f64; 2],
    width: f64,
    value: Option<f64>,
    of: &SheetCharacteristic,
    kind: JudgedBy,
    style: TextStyle,
) {
    let exceeded = of.judged == kind && value.is_some_and(|value| of.limits.exceeded_by(value));
    draw_judged(book, at, width, &number(value, 1), exceeded, style);
}

/// A number that ends at its point; bold with a star if it exceeds its limit. Stars stand behind the column of figures.
pub(super) fn draw_judged(
    book: &mut Book,
    at: [f64; 2],
    width: f64,
    text: &str,
    exceeded: bool,
    style: TextStyle,
) {
    if exceeded {
        let text = format!("{text}*");
        // Bold figures are wider than the estimate.
        let size = fitting_size(&text, style.size, 0.94 * width);
        book.text(at, &text, TextStyle { size, ..style }.bold());
    } else {
        book.fitted(at, width, text, style);
    }
}

/// Limits as they are printed: `±7.5`, `12.0`, `−3.0..5.0`; nothing without any.
pub(super) fn limit_words(limits: &SheetLimits, decimals: usize) -> String {
    match (limits.lower, limits.upper) {
        (None, None) => String::new(),
        (None, Some(upper)) => number(Some(upper), decimals),
        (Some(lower), None) => format!("≥ {}", number(Some(lower), decimals)),
        (Some(lower), Some(upper)) if lower == -upper => format!("±{}", number(Some(upper), decimals)),
        (Some(lower), Some(upper)) => {
            format!("{}..{}", number(Some(lower), decimals), number(Some(upper), decimals))
        }
    }
}
