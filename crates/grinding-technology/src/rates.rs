//! How fast a stroke takes material: over all, and per millimetre of the worm's profile.

use super::column::section;
use super::sampled::Sampled;
use super::{Cycle, STATIONS};
use foundation::geometry::Flank;

impl Cycle {
    /// Q_w of a stroke at the feed z_V2 = `v`, mm^3/s.
    pub fn rate(&self, stroke: usize, v: f64) -> f64 {
        let of_flank = |flank: Flank| {
            let sampled = &self.whole[flank];
            let engagement = &self.bodies.flanks[flank];
            sampled.alike
                * sampled.over_profile(|i| {
                    let sections =
                        (0..sampled.spaces).map(|k| self.section(stroke, flank, (sampled, i, k), v));
                    engagement.area_density(sampled.w[i]) * sections.sum::<f64>()
                })
        };
        self.strokes[stroke].feed * (of_flank(Flank::Left) + of_flank(Flank::Right))
    }

    /// Q'_w of a stroke at the stations, as if every space were like `space`, at the feed z_V2 = `v`, mm^3/(mm s).
    pub fn specific_rate(&self, stroke: usize, flank: Flank, space: usize, v: f64) -> [f64; STATIONS] {
        let sampled = &self.stations[flank];
        let engagement = &self.bodies.flanks[flank];
        let figures = &self.strokes[stroke];
        let advance = self.bodies.threads() * figures.speeds[0] * figures.stroke.feed_per_revolution;
        std::array::from_fn(|i| {
            let w = sampled.w[i];
            let density = engagement.area_density(w) / engagement.profile_width(w);
            advance * density * self.section(stroke, flank, (sampled, i, space), v)
        })
    }

    /// q: section that a stroke takes per feed at length of roll `w` of a space, at the feed z_V2 = `v`, mm.
    pub fn section_at(&self, stroke: usize, flank: Flank, (w, space): (f64, usize), v: f64) -> f64 {
        let sampled = Sampled::at(&self.stock, &self.bodies, flank, vec![w]);
        self.section(stroke, flank, (&sampled, 0, space), v)
    }

    fn section(
        &self,
        stroke: usize,
        flank: Flank,
        (sampled, i, space): (&Sampled, usize, usize),
        v: f64,
    ) -> f64 {
        let figures = &self.strokes[stroke];
        let engagement = &self.bodies.flanks[flank];
        let of_flank = &figures.flanks[flank];
        let [low, high] = of_flank.between;
        let w = sampled.w[i];
        let curvature = sampled.curvature[i];
        let middle = figures.sign() * (of_flank.raised[1] - v - engagement.line_slope() * w);
        let half = 0.5 * figures.sign() * self.bodies.face_width;
        let column = sampled.column(i, space);
        let reach = column.iter().map(|a| (2.0 * (a.clamp(low, high) - low) / curvature).sqrt());
        section(reach, column.len() - 1, [middle + half, middle - half], curvature)
    }
}
