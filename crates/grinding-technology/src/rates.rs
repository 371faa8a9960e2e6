//! How fast a stroke takes material: over all, and per millimetre of the worm's profile.

use super::column::{in_slices, section};
use super::sampled::{Sampled, area_weights};
use super::{Cycle, STATIONS};
use foundation::geometry::Flank;
use rayon::prelude::*;

impl Cycle {
    /// Q_w of a stroke at the feed z_V2 = `v`, mm^3/s.
    pub fn rate(&self, stroke: usize, v: f64) -> f64 {
        self.rates(stroke, &[v])[0]
    }

    /// The same at several feeds.
    pub fn rates(&self, stroke: usize, feeds: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; feeds.len()];
        for flank in self.strokes[stroke].stroke.ground.flanks() {
            let sampled = &self.whole[flank];
            let of_roll = |i: usize| {
                if sampled.spaces > 1 {
                    return self.sections_of_all(stroke, flank, i, feeds);
                }
                let mut at = vec![0.0; feeds.len()];
                self.sections(stroke, flank, (sampled, i, 0), feeds, |k, section| at[k] = section);
                at
            };
            let rolls: Vec<Vec<f64>> = (0..sampled.w.len()).into_par_iter().map(of_roll).collect();
            let engagement = &self.bodies.flanks[flank];
            let by = self.strokes[stroke].feed * sampled.alike;
            for (weight, sections) in area_weights(engagement, &sampled.w).into_iter().zip(&rolls) {
                let by = by * weight;
                sums.iter_mut().zip(sections).for_each(|(sum, section)| *sum += by * section);
            }
        }
        sums
    }

    /// Q'_w of a stroke at the stations, as if every space were like `space`, at the feed z_V2 = `v`, mm^3/(mm s).
    pub fn specific_rate(&self, stroke: usize, flank: Flank, space: usize, v: f64) -> [f64; STATIONS] {
        let mut rates = [0.0; STATIONS];
        for (i, rate) in rates.iter_mut().enumerate() {
            let by = self.per_section(stroke, flank, i);
            self.sections(stroke, flank, (&self.stations[flank], i, space), &[v], |_, section| {
                *rate = by * section;
            });
        }
        rates
    }

    /// The largest Q'_w over the tooth spaces at each station and several feeds, `[station][feed]`, mm^3/(mm s).
    pub fn largest_specific_rates(&self, stroke: usize, flank: Flank, feeds: &[f64]) -> Vec<Vec<f64>> {
        let sampled = &self.stations[flank];
        let at_station = |i: usize| {
            let by = self.per_section(stroke, flank, i);
            let mut most = vec![0.0_f64; feeds.len()];
            for space in 0..sampled.spaces {
                self.sections(stroke, flank, (sampled, i, space), feeds, |k, section| {
                    most[k] = most[k].max(by * section);
                });
            }
            most
        };
        (0..STATIONS).into_par_iter().map(at_station).collect()
    }

    /// Q'_w for a section that goes per feed, at a station.
    fn per_section(&self, stroke: usize, flank: Flank, station: usize) -> f64 {
        let (engagement, figures) = (&self.bodies.flanks[flank], &self.strokes[stroke]);
        let w = self.stations[flank].w[station];
        let advance = self.bodies.threads() * figures.speeds[0] * figures.stroke.feed_per_revolution;
        advance * engagement.area_density(w) / engagement.profile_width(w)
    }

    /// q: section that a stroke takes per feed at length of roll `w` of a space, at the feed z_V2 = `v`, mm.
    pub fn section_at(&self, stroke: usize, flank: Flank, (w, space): (f64, usize), v: f64) -> f64 {
        let sampled = Sampled::at(&self.stock, &self.bodies, flank, vec![w]);
        let mut at = 0.0;
        self.sections(stroke, flank, (&sampled, 0, space), &[v], |_, section| at = section);
        at
    }

    /// Sections of all spaces together at feeds: stock that goes at the distance D from its place goes at the feed v = C_c2 - zeta - sigma D,
    /// the same for every space. On slices of D as long as the cells along the face width all that go at the same feed lie on a diagonal.
    fn sections_of_all(&self, stroke: usize, flank: Flank, i: usize, feeds: &[f64]) -> Vec<f64> {
        let figures = &self.strokes[stroke];
        let of_flank = &figures.flanks[flank];
        let sampled = &self.whole[flank];
        let (w, curvature) = (sampled.w[i], sampled.curvature[i]);
        let cells = sampled.z.len() - 1;
        let length = self.bodies.face_width / cells as f64;
        let reaches = sampled.reaches(i, of_flank.between);
        let farthest = reaches.iter().copied().fold(0.0, f64::max);
        if farthest <= 0.0 {
            return vec![0.0; feeds.len()];
        }
        let slices = (farthest / length).ceil() as usize;
        let mut diagonals = vec![0.0; cells + slices];
        for cell in 0..cells {
            // Against the feed: a stroke with rising feed begins at the upper end.
            let first = if figures.sign() > 0.0 { cells - 1 - cell } else { cell };
            let amounts = in_slices(reaches.iter().skip(cell).step_by(cells).map(|far| far / length), slices);
            // Far stock goes first.
            diagonals[first..].iter_mut().zip(amounts.iter().rev()).for_each(|(sum, amount)| *sum += amount);
        }
        // Per length of feed; a cell and a slice together are spread over two lengths, most in the middle.
        let by = 0.5 * curvature * length * length;
        let line = of_flank.raised[1] - self.bodies.flanks[flank].line_slope() * w;
        let begun = figures.sign() * line - 0.5 * self.bodies.face_width - slices as f64 * length;
        let at = |v: &f64| {
            let place = (figures.sign() * v - begun) / length - 1.0;
            let below = place.floor();
            let of = |k: f64| if k < 0.0 { 0.0 } else { diagonals.get(k as usize).copied().unwrap_or(0.0) };
            by * (of(below) * (1.0 - (place - below)) + of(below + 1.0) * (place - below))
        };
        feeds.iter().map(at).collect()
    }

    /// Gives the section at each feed with the number of the feed.
    fn sections(
        &self,
        stroke: usize,
        flank: Flank,
        (sampled, i, space): (&Sampled, usize, usize),
        feeds: &[f64],
        mut give: impl FnMut(usize, f64),
    ) {
        let figures = &self.strokes[stroke];
        let of_flank = &figures.flanks[flank];
        let [low, high] = of_flank.between;
        let (w, curvature) = (sampled.w[i], sampled.curvature[i]);
        let reach: Vec<f64> = sampled
            .column(i, space)
            .iter()
            .map(|a| (2.0 * (a.clamp(low, high) - low) / curvature).sqrt())
            .collect();
        let line = of_flank.raised[1] - self.bodies.flanks[flank].line_slope() * w;
        let half = 0.5 * figures.sign() * self.bodies.face_width;
        for (k, v) in feeds.iter().enumerate() {
            let middle = figures.sign() * (line - v);
            give(k, section(&reach, [middle + half, middle - half], curvature));
        }
    }
}
