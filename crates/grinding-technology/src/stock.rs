//! What stands on the workpiece before the first stroke, over each flank of each space.

use super::error::{in_range, positive};
use super::stock_map::{Around, StockMap};
use super::{Bodies, TechnologyError};
use foundation::geometry::{Flank, InvoluteFlank, Sides};
use foundation::numerics::{equidistant, extremes};
use std::f64::consts::TAU;

/// Axial places at which the least and the largest stock are looked for.
const FACE_PLACES: usize = 41;

/// um u^i y^j, u and y from -1 to 1 over profile and face width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StockTerm {
    /// Power of u.
    pub i: u32,
    /// Power of y.
    pub j: u32,
    /// mm.
    pub amount: f64,
    /// One flank, or both.
    pub flank: Option<Flank>,
}

/// The blank is moved by e (cos psi, sin psi, 0).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunOut {
    /// mm.
    pub eccentricity: f64,
    /// rad.
    pub angle: f64,
}

/// Feed marks of a hob.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HobMarks {
    /// Axial feed per workpiece revolution, mm.
    pub feed: f64,
    /// Height of the marks, mm.
    pub height: f64,
    /// Place of one mark's bottom, mm.
    pub origin: f64,
}

/// The stock as it is asked for. Amounts normal to the flank, mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Stock {
    /// Over the finished flank.
    pub allowance: Sides<f64>,
    /// (diameter, amount), linear in the length of roll between, constant outside: protuberance and root step.
    pub profile: Vec<(f64, f64)>,
    /// Polynomial terms.
    pub terms: Vec<StockTerm>,
    /// One value for each space.
    pub pitch: Option<Sides<Vec<f64>>>,
    /// How the blank is off centre.
    pub run_out: Option<RunOut>,
    /// Marks of the hob.
    pub hob: Option<HobMarks>,
    /// Tables, added to the rest.
    pub map: Sides<Option<StockMap>>,
}

impl Stock {
    /// The same amount everywhere.
    pub fn constant(allowance: Sides<f64>) -> Self {
        Self {
            allowance,
            profile: Vec::new(),
            terms: Vec::new(),
            pitch: None,
            run_out: None,
            hob: None,
            map: Sides::both(None),
        }
    }
}

/// Stock on given bodies.
#[derive(Clone, Debug)]
pub struct StockField {
    stock: Stock,
    flanks: Sides<OnFlank>,
    face_width: f64,
    spaces: usize,
}

#[derive(Clone, Debug)]
struct OnFlank {
    work: InvoluteFlank,
    roll: [f64; 2],
    line_slope: f64,
    /// (length of roll, amount), rising.
    profile: Vec<(f64, f64)>,
}

impl StockField {
    /// `stock` on `bodies`.
    ///
    /// # Errors
    /// `OutOfRange` for numbers that are not finite, lists that do not hold a value for each space, diameters below the base circle.
    pub fn new(stock: Stock, bodies: &Bodies) -> Result<Self, TechnologyError> {
        // The count of teeth is whole.
        let spaces = bodies.teeth() as usize;
        let finite = |field: &str, value: f64| in_range(field, value, true, "a finite number");
        for (_, &amount) in stock.allowance.iter() {
            finite("stock.allowance_um", 1e3 * amount)?;
        }
        for term in &stock.terms {
            finite("stock.terms.um", 1e3 * term.amount)?;
        }
        if let Some(pitch) = &stock.pitch {
            for (flank, values) in pitch.iter() {
                let field = format!("stock.pitch_um.{flank}");
                let allowed = format!("{spaces} values, one for each space");
                in_range(&field, values.len() as f64, values.len() == spaces, &allowed)?;
                for &value in values {
                    finite(&field, 1e3 * value)?;
                }
            }
        }
        if let Some(run_out) = stock.run_out {
            let e = run_out.eccentricity;
            in_range("stock.run_out.eccentricity_um", 1e3 * e, e >= 0.0, ">= 0 um")?;
            finite("stock.run_out.angle_deg", run_out.angle.to_degrees())?;
        }
        if let Some(hob) = stock.hob {
            positive("stock.hob.feed", hob.feed)?;
            in_range("stock.hob.height_um", 1e3 * hob.height, hob.height >= 0.0, ">= 0 um")?;
            finite("stock.hob.origin", hob.origin)?;
        }
        for (_, map) in stock.map.iter() {
            let count = map.as_ref().map_or(1, StockMap::spaces);
            let allowed = format!("1 for all alike, or {spaces}, each of the gear");
            in_range("stock.map.space", count as f64, count == 1 || count == spaces, &allowed)?;
        }
        let flanks = Sides::try_from_fn(|flank| {
            let engagement = &bodies.flanks[flank];
            let work = *engagement.work();
            let place = |&(diameter, amount): &(f64, f64)| {
                let least = 2.0 * work.base_radius;
                let allowed = format!(">= {least:.4} mm, the base circle of the {flank} flank");
                in_range("stock.profile.diameter", diameter, diameter >= least, &allowed)?;
                finite("stock.profile.um", 1e3 * amount)?;
                Ok((work.length_of_roll(0.5 * diameter)?, amount))
            };
            let mut profile = stock.profile.iter().map(place).collect::<Result<Vec<_>, TechnologyError>>()?;
            profile.sort_by(|a, b| a.0.total_cmp(&b.0));
            Ok::<_, TechnologyError>(OnFlank {
                work,
                roll: engagement.roll,
                line_slope: engagement.line_slope(),
                profile,
            })
        })?;
        Ok(Self { stock, flanks, face_width: bodies.face_width, spaces })
    }

    /// Spaces of the workpiece.
    pub fn spaces(&self) -> usize {
        self.spaces
    }

    /// Whether it is the same everywhere on a flank.
    pub fn is_constant(&self) -> bool {
        let Stock { allowance: _, profile, terms, pitch, run_out, hob, map } = &self.stock;
        let plain = profile.is_empty() && terms.is_empty() && hob.is_none();
        plain && pitch.is_none() && run_out.is_none() && map.iter().all(|(_, map)| map.is_none())
    }

    /// Whether every space has the same.
    pub fn is_alike(&self) -> bool {
        let alike = |map: &Option<StockMap>| map.as_ref().is_none_or(|map| map.spaces() == 1);
        self.stock.pitch.is_none()
            && self.stock.run_out.is_none()
            && self.stock.map.iter().all(|(_, map)| alike(map))
    }

    /// Spaces with stock of their own: 1 where all are alike.
    pub fn different_spaces(&self) -> usize {
        if self.is_alike() { 1 } else { self.spaces }
    }

    /// Lengths of roll inside the profile where the slope of the stock jumps, rising, mm.
    pub(crate) fn breaks(&self, flank: Flank) -> Vec<f64> {
        let on = &self.flanks[flank];
        let inside = |w: &f64| *w > on.roll[0] && *w < on.roll[1];
        let mapped = self.stock.map[flank].iter().flat_map(|map| map.rolls().iter().copied());
        let mut breaks: Vec<f64> = on.profile.iter().map(|(w, _)| *w).chain(mapped).filter(inside).collect();
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        breaks
    }

    /// Axial places inside the face width where the slope of the stock jumps, rising, mm.
    pub(crate) fn face_breaks(&self, flank: Flank) -> Vec<f64> {
        let half = 0.5 * self.face_width;
        let inside = |z: &f64| z.abs() < half;
        self.stock.map[flank].iter().flat_map(|map| map.faces().iter().copied()).filter(inside).collect()
    }

    /// What bends the stock between its breaks.
    pub(crate) fn bends(&self) -> Bends {
        Bends {
            run_out: self.stock.run_out.is_some(),
            terms: self.stock.terms.iter().any(|term| term.i + term.j > 1),
            marks: self.stock.hob.is_some(),
        }
    }

    /// Least and largest stock of a flank at the stations, mm.
    pub fn extent(&self, bodies: &Bodies, flank: Flank) -> [f64; 2] {
        let half = 0.5 * bodies.face_width;
        let places = equidistant([-half, half], FACE_PLACES);
        let spaces = self.different_spaces();
        let own: Vec<_> = (0..spaces).map(|k| self.of_space(flank, k)).collect();
        let of_place = |(w, z): (f64, f64)| {
            let place = self.of_place(flank, w, z);
            own.iter().map(move |own| own.on(place))
        };
        let at_station = |w: f64| places.iter().map(move |&z| (w, z));
        extremes(bodies.flanks[flank].stations().into_iter().flat_map(at_station).flat_map(of_place))
    }

    /// a_0 at length of roll `w` and `z` of space `k`, mm; below 0 where material is missing.
    pub fn at(&self, flank: Flank, w: f64, z: f64, k: usize) -> f64 {
        self.of_space(flank, k).on(self.of_place(flank, w, z))
    }

    /// What all spaces share at a place.
    pub(crate) fn of_place(&self, flank: Flank, w: f64, z: f64) -> OfPlace {
        let on = &self.flanks[flank];
        let mut sum = self.stock.allowance[flank] + along(&on.profile, w);
        if !self.stock.terms.is_empty() {
            let [from, to] = on.roll;
            let u = (2.0 * w - from - to) / (to - from);
            let y = 2.0 * z / self.face_width;
            let of_flank = |term: &&StockTerm| term.flank.is_none_or(|only| only == flank);
            let value = |term: &StockTerm| term.amount * u.powi(term.i as i32) * y.powi(term.j as i32);
            sum += self.stock.terms.iter().filter(of_flank).map(value).sum::<f64>();
        }
        if let Some(hob) = self.stock.hob {
            let t = (z + on.line_slope * w - hob.origin) / hob.feed;
            sum += 4.0 * hob.height * (t - t.round()).powi(2);
        }
        let normal = self.stock.run_out.map_or([0.0; 2], |_| {
            let normal = on.work.normal(w, z);
            [normal.x, normal.y]
        });
        let around = self.stock.map[flank].as_ref().map(|map| map.around(w, z));
        OfPlace { amount: sum, normal, around }
    }

    /// What is a space's own.
    pub(crate) fn of_space(&self, flank: Flank, k: usize) -> OfSpace<'_> {
        let amount = self.stock.pitch.as_ref().map_or(0.0, |pitch| pitch[flank][k]);
        let moved = self.stock.run_out.map_or([0.0; 2], |run_out| {
            // The blank's way in the frame of the space.
            let (sin, cos) = (run_out.angle - TAU * k as f64 / self.spaces as f64).sin_cos();
            [run_out.eccentricity * cos, run_out.eccentricity * sin]
        });
        let map = self.stock.map[flank].as_ref().map(|map| map.of_space(k));
        OfSpace { amount, moved, map }
    }
}

/// What bends the stock between the places where its slope jumps; without any it is linear along the profile and along the face width.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bends {
    /// The normal turns a little along the face, as run-out shows.
    pub run_out: bool,
    /// Polynomial terms.
    pub terms: bool,
    /// Marks of a hob.
    pub marks: bool,
}

/// Stock of a place in every space, and the flank's normal there in the transverse section.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OfPlace {
    amount: f64,
    normal: [f64; 2],
    around: Option<Around>,
}

/// Stock of a space at every place, and how the blank is moved as it sees it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OfSpace<'a> {
    amount: f64,
    moved: [f64; 2],
    map: Option<&'a [f64]>,
}

impl OfSpace<'_> {
    pub fn on(self, place: OfPlace) -> f64 {
        let across = place.normal[0] * self.moved[0] + place.normal[1] * self.moved[1];
        let mapped = self.map.zip(place.around).map_or(0.0, |(map, around)| around.of(map));
        place.amount + self.amount + across + mapped
    }
}

/// Linear between the places, constant outside; 0 without any.
fn along(profile: &[(f64, f64)], w: f64) -> f64 {
    let above = profile.partition_point(|(place, _)| *place <= w);
    match (above.checked_sub(1).map(|below| profile[below]), profile.get(above)) {
        (Some((from, a)), Some(&(to, b))) => a + (b - a) * (w - from) / (to - from),
        (Some((_, a)), None) | (None, Some(&(_, a))) => a,
        (None, None) => 0.0,
    }
}
