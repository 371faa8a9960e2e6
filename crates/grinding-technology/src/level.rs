//! Parts that a worm grinds between two dressings: by the load of its zones, by its width, by the map of its load.

use super::{Bodies, Cycle, WearTask};
use foundation::geometry::{Flank, Sides};

/// Name of the zone that roughing strokes use where there are two.
pub const ROUGHING: &str = "roughing";
/// The most parts that are tried on the map.
const MOST_PARTS: usize = 200;

/// Width of the worm and what its zones may remove.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ZoneLimits {
    /// Width to be shared, mm.
    pub zone_width: f64,
    /// Between the zones, mm.
    pub zone_gap: f64,
    /// Largest V'_w of roughing, mm^3/mm.
    pub allowed_roughing: f64,
    /// Largest V'_w of finishing, or of the only zone, mm^3/mm.
    pub allowed_finishing: f64,
}

impl ZoneLimits {
    /// Parts (not whole) for what roughing and finishing take, mm^3; `None` for roughing where there is one zone only.
    pub fn parts(&self, roughing: Option<f64>, finishing: f64) -> f64 {
        match roughing {
            None => self.zone_width * self.allowed_finishing / finishing,
            Some(roughing) => {
                let each = roughing / self.allowed_roughing + finishing / self.allowed_finishing;
                (self.zone_width - self.zone_gap) / each
            }
        }
    }
}

/// Upper bound of the parts for any strategy.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// What one part takes of each zone, in the order of the strokes, mm^3.
    pub wear_per_part: Vec<(String, f64)>,
    /// Parts between two dressings, not whole.
    pub parts: f64,
    /// Width of the roughing zone, mm; `None` where there is one zone.
    pub roughing_zone: Option<f64>,
}

/// How the width bounds the parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WidthUse {
    /// No stroke steps from part to part.
    Unbounded,
    /// So many parts; 0 where the first does not fit.
    Parts(usize),
}

impl Cycle {
    /// What each zone loses for one part and how many parts that allows.
    pub fn level(&self, limits: &ZoneLimits) -> Level {
        let mut zones: Vec<(String, Sides<Vec<f64>>)> = Vec::new();
        for (k, figures) in self.strokes.iter().enumerate() {
            let section = Sides::from_fn(|flank| self.mean_sections(k, flank));
            match zones.iter_mut().find(|(name, _)| *name == figures.stroke.zone) {
                Some((_, sum)) => {
                    for flank in Flank::BOTH {
                        sum[flank].iter_mut().zip(&section[flank]).for_each(|(sum, by)| *sum += by);
                    }
                }
                None => zones.push((figures.stroke.zone.clone(), section)),
            }
        }
        let wear_per_part: Vec<(String, f64)> =
            zones.into_iter().map(|(name, sections)| (name, heaviest(&self.bodies, &sections))).collect();
        let of = |wanted: bool| -> f64 {
            wear_per_part.iter().filter(|(name, _)| (name == ROUGHING) == wanted).map(|(_, wear)| wear).sum()
        };
        let two = wear_per_part.len() > 1;
        let roughing = two.then(|| of(true));
        let finishing = if two { of(false) } else { wear_per_part.iter().map(|(_, wear)| wear).sum() };
        let parts = limits.parts(roughing, finishing);
        let roughing_zone = roughing.map(|roughing| parts * roughing / limits.allowed_roughing);
        Level { wear_per_part, parts, roughing_zone }
    }

    /// b times the mean depth of cut at the stations, mm^2.
    fn mean_sections(&self, stroke: usize, flank: Flank) -> Vec<f64> {
        let sampled = &self.stations[flank];
        let between = self.strokes[stroke].flanks[flank].between;
        let of_station = |i: usize| {
            let of_space = |k: usize| super::column::mean_between(sampled.column(i, k), between);
            self.bodies.face_width * (0..sampled.spaces).map(of_space).sum::<f64>() / sampled.spaces as f64
        };
        (0..sampled.w.len()).map(of_station).collect()
    }

    /// Parts until a stroke's place on the worm leaves a worm of this width, centred on z_1 = 0.
    pub fn parts_by_width(&self, worm_width: f64) -> WidthUse {
        let half = 0.5 * worm_width;
        if self.strokes.iter().any(|f| f.occupation[0] < -half || f.occupation[1] > half) {
            return WidthUse::Parts(0);
        }
        let of_stroke = |figures: &super::StrokeFigures| {
            let step = figures.stroke.shift.step_per_part;
            // A step moves the place on the worm back.
            let room = if step > 0.0 { figures.occupation[0] + half } else { half - figures.occupation[1] };
            (step != 0.0).then(|| 1 + (room / step.abs()).floor() as usize)
        };
        match self.strokes.iter().filter_map(of_stroke).min() {
            Some(parts) => WidthUse::Parts(parts),
            None => WidthUse::Unbounded,
        }
    }
}

impl WearTask<'_> {
    /// The most parts for which no place of the worm removes more than `allowed`, mm^3/mm.
    pub fn parts_by_map(&self, by_width: WidthUse, allowed: f64) -> usize {
        let most = match by_width {
            WidthUse::Unbounded => MOST_PARTS,
            WidthUse::Parts(parts) => parts.min(MOST_PARTS),
        };
        // The load never falls with the parts: bisection for the last number that is allowed.
        let (mut good, mut bad) = (0, most + 1);
        while bad - good > 1 {
            let parts = usize::midpoint(good, bad);
            if self.largest_after(parts) <= allowed {
                good = parts;
            } else {
                bad = parts;
            }
        }
        good
    }
}

/// Largest of M times the sections at the stations of both flanks.
fn heaviest(bodies: &Bodies, sections: &Sides<Vec<f64>>) -> f64 {
    let of_flank = |flank: Flank| {
        let engagement = &bodies.flanks[flank];
        let at = engagement.stations().into_iter().zip(&sections[flank]);
        at.map(|(w, section)| engagement.wear_factor(w) * section).fold(0.0, f64::max)
    };
    f64::max(of_flank(Flank::Left), of_flank(Flank::Right))
}
