//! How fast a stroke takes material: over all, and per millimetre of the worm's profile.

use super::column::section;
use super::sampled::{Sampled, weights};
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
                let mut at = vec![0.0; feeds.len()];
                for space in 0..sampled.spaces {
                    self.sections(stroke, flank, (sampled, i, space), feeds, |k, section| at[k] += section);
                }
                at
            };
            let rolls: Vec<Vec<f64>> = (0..sampled.w.len()).into_par_iter().map(of_roll).collect();
            let engagement = &self.bodies.flanks[flank];
            let by = self.strokes[stroke].feed * sampled.alike;
            for ((weight, w), sections) in weights(&sampled.w).iter().zip(&sampled.w).zip(&rolls) {
                let by = by * weight * engagement.area_density(*w);
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
