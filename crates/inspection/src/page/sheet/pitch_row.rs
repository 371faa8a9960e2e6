//! Pitch and run-out: strips for the left flank, the right flank and the run-out over the teeth, values beside them.

use super::book::{Book, GRID, LABEL, MARGIN, TEXT, THIN, WIDTH, centred, from_left, from_right};
use super::data::{SheetPitch, SheetPitchFlank, SheetValue};
use super::foot::draw_value;
use super::pitch_strip::{Strip, draw_bars, draw_line, draw_sector, tooth_steps};
use foundation::geometry::Flank;
use foundation::numerics::extremes;
use report::charts::format_significant;
use report::charts::magnification::{bar, drawn, from_500, words};

/// Height of the row.
pub(super) const HEIGHT: f64 = 45.0;
/// Tops and heights of the strips, from the top of the row.
const STRIPS: [[f64; 2]; 3] = [[3.6, 13.2], [16.8, 13.2], [30.0, 12.0]];
/// Left end of the strips and their width, from the left border.
const LEFT: f64 = 15.5;
const LONG: f64 = 112.0;
/// Left end of the values.
const VALUES: f64 = LEFT + LONG + 2.0;
/// Room between a line and the border of its strip.
const CLEAR: f64 = 0.4;

/// Draws the row with its top at y.
pub(super) fn draw(book: &mut Book, pitch: &SheetPitch, top: f64) {
    book.text([MARGIN, top + 2.6], "Pitch and run-out", from_left(TEXT).bold());
    book.words([MARGIN + 32.0, top + 2.6], VALUES - 34.0, ["Pitch", &pitch.words], from_left(LABEL));
    let fp = pitch.flanks.iter().flat_map(|(_, of)| of.iter().flat_map(|of| &of.single_um));
    let cumulative = pitch.flanks.iter().flat_map(|(_, of)| of.iter());
    let cumulative = cumulative.flat_map(|of| of.cumulative_um.iter().chain(&of.eccentric_um));
    let room = 0.5 * STRIPS[0][1] - CLEAR;
    let scales = [from_500(largest(fp), room), from_500(largest(cumulative), room)];
    for (flank, [from, high]) in Flank::BOTH.into_iter().zip(STRIPS) {
        let strip = Strip { left: MARGIN + LEFT, top: top + from, width: LONG, height: high, teeth: 0 };
        strip.frame(book);
        let names = [
            format!("{flank} flank"),
            format!("bars fp {}", words(scales[0])),
            format!("line Fp {}", words(scales[1])),
        ];
        let known = pitch.flanks[flank].as_ref().filter(|of| !of.single_um.is_empty());
        match known {
            Some(of) => {
                label(book, &strip, &names);
                draw_flank(book, &Strip { teeth: of.single_um.len(), ..strip }, of, scales);
            }
            None => not_measured(book, &strip, &names[0]),
        }
        let values = pitch.flanks[flank].as_ref().map_or(&[][..], |of| &of.values);
        draw_values(book, values, [top + from, high]);
    }
    draw_run_out(book, pitch, top);
    draw_axis(book, pitch, top + STRIPS[2][0] + STRIPS[2][1]);
}

fn largest<'a>(values: impl Iterator<Item = &'a f64>) -> f64 {
    values.filter(|v| v.is_finite()).fold(0.0, |most: f64, v| most.max(v.abs()))
}

/// What a strip shows, in lines left of it; the first is its name.
fn label(book: &mut Book, strip: &Strip, lines: &[String]) {
    for (k, line) in lines.iter().enumerate() {
        let at = [MARGIN, strip.top + 3.2 + 3.0 * k as f64];
        let style = if k == 0 { from_left(LABEL).bold() } else { from_left(LABEL) };
        book.fitted(at, LEFT - 1.0, line, style);
    }
}

fn not_measured(book: &mut Book, strip: &Strip, name: &str) {
    label(book, strip, &[name.to_owned()]);
    let at = [strip.left + 0.5 * strip.width, strip.middle() + 0.9];
    book.text(at, "not measured", centred(TEXT));
}

fn draw_flank(book: &mut Book, strip: &Strip, of: &SheetPitchFlank, [fp, cumulative]: [f64; 2]) {
    strip.zero(book);
    if let Some(sector) = of.sector {
        draw_sector(book, strip, sector);
    }
    draw_bars(book, strip, &of.single_um, fp);
    draw_line(book, strip, &of.eccentric_um, cumulative, super::book::DASHED);
    draw_line(book, strip, &of.cumulative_um, cumulative, super::book::TRACE);
    scale_bar(book, strip, cumulative);
}

fn draw_run_out(book: &mut Book, pitch: &SheetPitch, top: f64) {
    let of = &pitch.run_out;
    let [from, height] = STRIPS[2];
    let teeth = of.of_space_um.len();
    let strip = Strip { left: MARGIN + LEFT, top: top + from, width: LONG, height, teeth };
    strip.frame(book);
    if teeth == 0 {
        not_measured(book, &strip, "run-out");
    } else {
        let all = || of.of_space_um.iter().chain(&of.eccentric_um).copied().filter(|v| v.is_finite());
        // A file may count run-out from its least value: the strip shows its middle.
        let [lo, hi] = extremes(all());
        let middle = if lo < hi && (lo >= 0.0 || hi <= 0.0) { 0.5 * (lo + hi) } else { 0.0 };
        let far = all().map(|v| (v - middle).abs()).fold(0.0, f64::max);
        let scale = from_500(far, 0.5 * height - CLEAR);
        label(book, &strip, &["run-out".into(), format!("line Fr {}", words(scale))]);
        if middle == 0.0 {
            strip.zero(book);
        }
        let about = |list: &[f64]| list.iter().map(|v| v - middle).collect::<Vec<f64>>();
        draw_line(book, &strip, &about(&of.eccentric_um), scale, super::book::DASHED);
        draw_line(book, &strip, &about(&of.of_space_um), scale, super::book::TRACE);
        scale_bar(book, &strip, scale);
    }
    draw_values(book, &of.values, [top + from, height]);
}

/// A bar of a round length beside the strip.
fn scale_bar(book: &mut Book, strip: &Strip, scale: f64) {
    let (um, along) = bar(10.0, drawn(1.0, scale), 0.9);
    let (x, low) = (strip.left - 1.0, strip.top + strip.height - 0.6);
    let high = low - along;
    let ends = [low, high].map(|y| vec![[x - 0.5, y], [x + 0.5, y]]);
    let [foot, head] = ends;
    book.page().polylines(&[vec![[x, low], [x, high]], foot, head], THIN);
    book.text([x - 1.0, low], &format!("{} µm", format_significant(um, 2)), from_right(LABEL));
}

fn draw_values(book: &mut Book, values: &[SheetValue], [top, height]: [f64; 2]) {
    let pitch = (height / values.len().max(1) as f64).min(2.8);
    let size = (0.85 * pitch).min(0.9 * TEXT);
    for (k, value) in values.iter().enumerate() {
        let at = [MARGIN + VALUES, top + pitch * (k as f64 + 0.8)];
        draw_value(book, at, WIDTH - VALUES, value, size);
    }
}

/// Numbers of the teeth below the strips.
fn draw_axis(book: &mut Book, pitch: &SheetPitch, top: f64) {
    let flanks = pitch.flanks.iter().filter_map(|(_, of)| of.as_ref()).map(|of| of.single_um.len());
    let Some(teeth) = flanks.chain([pitch.run_out.of_space_um.len()]).max().filter(|z| *z > 0) else {
        return;
    };
    let strip = Strip { left: MARGIN + LEFT, top, width: LONG, height: 0.0, teeth };
    for tooth in tooth_steps(teeth) {
        let x = strip.x(tooth as f64);
        book.page().line([x, top], [x, top + 0.6], GRID);
        book.text([x, top + 2.6], &tooth.to_string(), centred(LABEL));
    }
    book.text([MARGIN, top + 2.6], "tooth", from_left(LABEL).muted());
}
