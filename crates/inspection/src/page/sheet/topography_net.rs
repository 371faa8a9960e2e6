//! A measured field as a net: the nominal flank grey, deviations drawn from it at 45 degrees, hatched in between.

use super::book::{Book, GRID, LABEL, THIN, TRACE, centred, from_left, from_right};
use super::data::SheetTopography;
use super::text_fit::number;
use foundation::geometry::Flank;
use report::charts::magnification::drawn;
use report::charts::{FAINT, MUTED, Stroke};

/// Largest cell of the net, mm on paper.
const CELL: f64 = 8.0;
/// Distance of the hatching lines.
const HATCH: f64 = 1.4;

/// Where a net lies on the page.
pub(super) struct Net<'a> {
    /// The field.
    pub field: &'a SheetTopography,
    /// Lower left corner of the nominal flank, page.
    pub corner: [f64; 2],
    /// Its width and height.
    pub size: [f64; 2],
    /// Magnification of the deviations along their direction.
    pub magnification: f64,
}

impl Net<'_> {
    /// Outwards on the page: the left flank's tip is at the right, the right flank is its mirror image.
    fn side(&self) -> f64 {
        self.field.flank.sign()
    }

    /// A place on the nominal flank.
    fn base(&self, w: f64, face: f64) -> [f64; 2] {
        let share = |places: &[f64], x: f64| (x - places[0]) / (places[places.len() - 1] - places[0]);
        let u = share(&self.field.roll_mm, w);
        // From root to tip, the right flank mirrored.
        let from_left = self.field.tip_last == (self.field.flank == Flank::Left);
        let u = if from_left { u } else { 1.0 - u };
        [self.corner[0] + self.size[0] * u, self.corner[1] - self.size[1] * share(&self.field.face_mm, face)]
    }

    /// The same place moved by its deviation at 45 degrees: material towards the tip's side and upwards.
    fn moved(&self, [x, y]: [f64; 2], um: f64) -> [f64; 2] {
        let d = drawn(um, self.magnification) / std::f64::consts::SQRT_2;
        [x + self.side() * d, y - d]
    }

    /// Draws everything: hatching, nominal net, net, values of the corners.
    pub fn draw(&self, book: &mut Book) {
        let rolls = net_places(&self.field.roll_mm, self.size[0]);
        let faces = net_places(&self.field.face_mm, self.size[1]);
        let first_last = |places: &[f64]| [places[0], places[places.len() - 1]];
        let [w0, w1] = first_last(&rolls);
        let [z0, z1] = first_last(&faces);
        let mut plain: Vec<Vec<[f64; 2]>> = Vec::new();
        plain.extend(rolls.iter().map(|w| vec![self.base(*w, z0), self.base(*w, z1)]));
        plain.extend(faces.iter().map(|z| vec![self.base(w0, *z), self.base(w1, *z)]));
        let hatch: Vec<Vec<[f64; 2]>> = faces.iter().flat_map(|z| self.hatch(*z)).collect();
        book.page().polylines(&hatch, Stroke::solid(MUTED, 0.1));
        book.page().polylines(&plain, Stroke::solid(FAINT, 0.2));
        let along_roll: Vec<Vec<[f64; 2]>> =
            faces.iter().flat_map(|z| self.curve(self.field.roll_mm.iter().map(|w| [*w, *z]))).collect();
        let along_face: Vec<Vec<[f64; 2]>> =
            rolls.iter().flat_map(|w| self.curve(self.field.face_mm.iter().map(|z| [*w, *z]))).collect();
        book.page().polylines(&along_roll, TRACE);
        book.page().polylines(&along_face, THIN);
        self.corners(book);
        self.axes(book);
    }

    /// A line of the net, in pieces between its gaps.
    fn curve(&self, places: impl Iterator<Item = [f64; 2]>) -> Vec<Vec<[f64; 2]>> {
        let mut lines: Vec<Vec<[f64; 2]>> = vec![Vec::new()];
        for [w, z] in places {
            match (self.value(w, z), lines.last_mut()) {
                (Some(um), Some(line)) => line.push(self.moved(self.base(w, z), um)),
                _ => lines.push(Vec::new()),
            }
        }
        lines
    }

    /// Lines at 45 degrees between the nominal flank and the measured one, along a line of the net.
    fn hatch(&self, z: f64) -> Vec<Vec<[f64; 2]>> {
        let places = &self.field.roll_mm;
        let (from, to) = (places[0], places[places.len() - 1]);
        let count = (self.size[0] / HATCH).round().max(1.0) as usize;
        let at = |k: usize| from + (to - from) * k as f64 / count as f64;
        let line = |w: f64| {
            let base = self.base(w, z);
            self.value(w, z).map(|um| vec![base, self.moved(base, um)])
        };
        (0..=count).filter_map(|k| line(at(k))).collect()
    }

    /// Bilinear between the places of the grid; none beside a gap.
    fn value(&self, w: f64, z: f64) -> Option<f64> {
        let ([i, p], [j, q]) = (cell(&self.field.roll_mm, w), cell(&self.field.face_mm, z));
        let (i, j) = (i as usize, j as usize);
        let mut sum = 0.0;
        for (k, share) in [(i, 1.0 - p), (i + 1, p)] {
            for (l, other) in [(j, 1.0 - q), (j + 1, q)] {
                // What has no weight may be a gap.
                if share * other > 0.0 {
                    sum += share * other * self.field.f_um[k][l];
                }
            }
        }
        sum.is_finite().then_some(sum)
    }

    fn corners(&self, book: &mut Book) {
        let (rolls, faces) = (&self.field.roll_mm, &self.field.face_mm);
        for (i, w) in [(0, rolls[0]), (rolls.len() - 1, rolls[rolls.len() - 1])] {
            for (j, z) in [(0, faces[0]), (faces.len() - 1, faces[faces.len() - 1])] {
                let [x, y] = self.base(w, z);
                let at_left = x < self.corner[0] + 0.5 * self.size[0];
                let below = j == 0;
                let value = self.field.f_um[i][j];
                let text = format!("{} µm", number(Some(value), 1));
                let text = if value.is_finite() { text } else { "–".into() };
                // Beyond the reach of the lines, at the height of the corner.
                let reach = 1.5 + drawn(value.abs(), self.magnification) / std::f64::consts::SQRT_2;
                let reach = if value.is_finite() { reach } else { 1.5 };
                let y = if below { y + 1.2 } else { y - 0.2 };
                if at_left {
                    book.text([x - reach, y], &text, from_right(LABEL).bold());
                } else {
                    book.text([x + reach, y], &text, from_left(LABEL).bold());
                }
            }
        }
    }

    /// What lies where, below the net and at its ends.
    fn axes(&self, book: &mut Book) {
        let (rolls, faces) = (&self.field.roll_mm, &self.field.face_mm);
        let y = self.corner[1] + 13.5;
        let ends = if self.field.tip_last { ["root", "tip"] } else { ["tip", "root"] };
        for (w, word) in [rolls[0], rolls[rolls.len() - 1]].into_iter().zip(ends) {
            let x = self.base(w, faces[0])[0];
            book.page().line([x, self.corner[1]], [x, y - 2.6], GRID);
            let text = format!("{word}, w {} mm", number(Some(w), 3));
            book.fitted([x, y], 0.48 * self.size[0], &text, centred(LABEL));
        }
        let [from, to] = [faces[0], faces[faces.len() - 1]].map(|z| number(Some(z), 2));
        let text = format!("upwards: {} {from} to {to} mm", self.field.face_name);
        book.fitted(
            [self.corner[0] + 0.5 * self.size[0], y + 3.0],
            1.2 * self.size[0],
            &text,
            centred(LABEL),
        );
    }
}

/// The cell [its number, share within it] of a place among ascending ones.
fn cell(places: &[f64], x: f64) -> [f64; 2] {
    let after = places.partition_point(|p| *p < x).clamp(1, places.len() - 1);
    let share = ((x - places[after - 1]) / (places[after] - places[after - 1])).clamp(0.0, 1.0);
    [(after - 1) as f64, share]
}

/// Lines of the net: places of the grid as far apart as the largest cell allows, with some between them where the grid is coarser.
fn net_places(grid: &[f64], length: f64) -> Vec<f64> {
    let last = grid[grid.len() - 1];
    let largest = CELL / length * (last - grid[0]);
    let mut lines = vec![grid[0]];
    let mut here = grid[0];
    for pair in grid.windows(2) {
        if pair[1] - here <= largest && pair[1] < last {
            continue;
        }
        // The last place within reach, then what is still missing.
        if pair[0] > here && pair[1] - here > largest {
            here = pair[0];
            lines.push(here);
        }
        let missing = ((pair[1] - here) / largest - 1e-9).ceil().max(1.0) as usize;
        if missing > 1 || pair[1] == last {
            lines.extend((1..=missing).map(|k| here + (pair[1] - here) * k as f64 / missing as f64));
            here = pair[1];
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use foundation::numerics::equidistant;

    #[test]
    fn no_cell_is_larger_than_allowed() {
        for n in [2, 3, 5, 9, 10, 31, 200] {
            let grid = equidistant([3.0, 7.0], n);
            for length in [20.0, 62.0, 90.0] {
                let lines = net_places(&grid, length);
                assert!(lines[0] == 3.0 && (lines[lines.len() - 1] - 7.0).abs() < 1e-12, "{lines:?}");
                let gaps: Vec<f64> = lines.windows(2).map(|p| (p[1] - p[0]) * length / 4.0).collect();
                assert!(gaps.iter().all(|gap| *gap > 0.0 && *gap <= CELL + 1e-6), "{n} {length}: {gaps:?}");
            }
        }
    }
}
