//! Strokes on stock: infeed, engagement, feeds of first and last contact, what each takes.

use super::sampled::{Sampled, area_weights};
use super::stroke::check;
use super::volumes::volumes;
use super::{Bodies, Direction, STATIONS, StockField, Stroke, TechnologyError};
use contact::StandOff;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::MotionLaw;
use foundation::numerics::{equidistant, extremes};

/// Points of the contact area's integral.
const AREA_POINTS: usize = 2001;

/// Climb or conventional grinding, for a worm that turns with rising phi_1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// The worm cuts with the feed.
    Climb,
    /// Against it.
    Conventional,
}

/// One flank under one stroke.
#[derive(Clone, Debug)]
pub struct FlankStroke {
    /// Stock left, and the least that strokes before left (infinite before the first), mm: the stroke takes what lies between.
    pub between: [f64; 2],
    /// Largest depth of cut, mm.
    pub deepest: f64,
    /// C_c1, C_c2, E at this infeed, mm.
    pub raised: [f64; 3],
    /// D_e at the stations for the largest depth of cut, mm.
    pub distance: [f64; STATIONS],
    /// Length of the contact on the tooth at the stations, mm.
    pub contact_length: [f64; STATIONS],
    /// Area of the contact, mm^2.
    pub contact_area: f64,
    /// What one thread takes at the stations, mm.
    pub passage: [f64; STATIONS],
    /// Height of the feed marks at the stations, mm.
    pub feed_mark: [f64; STATIONS],
    /// Largest Q'_w at the stations, mm^3/(mm s).
    pub rate_bound: [f64; STATIONS],
    /// Equivalent chip thickness, mm.
    pub chip_thickness: f64,
}

/// One stroke with its figures.
#[derive(Clone, Debug)]
pub struct StrokeFigures {
    /// As it was asked for.
    pub stroke: Stroke,
    /// Standing off the finished flank.
    pub infeed: StandOff,
    /// Revolutions per second of worm and workpiece.
    pub speeds: [f64; 2],
    /// Feed, mm/s.
    pub feed: f64,
    /// z_V2 of the first and of the last contact, mm.
    pub contact: [f64; 2],
    /// Way before the contact lines in which stock is ground already, mm.
    pub approach: f64,
    /// Way with the overrun at both ends, mm.
    pub travel: f64,
    /// Climb or conventional.
    pub sense: Sense,
    /// What it takes of all spaces, mm^3.
    pub volume: f64,
    /// Least and greatest place on the worm for the first part, mm.
    pub occupation: [f64; 2],
    /// Each flank.
    pub flanks: Sides<FlankStroke>,
}

impl StrokeFigures {
    /// sigma.
    pub fn sign(&self) -> f64 {
        self.stroke.direction.sign()
    }
}

/// Strokes on the stock of given bodies.
#[derive(Clone, Debug)]
pub struct Cycle {
    /// Worm and workpiece.
    pub bodies: Bodies,
    /// Before the first stroke.
    pub stock: StockField,
    /// Least and largest stock of each flank at the stations, mm.
    pub extent: Sides<[f64; 2]>,
    /// In driving order.
    pub strokes: Vec<StrokeFigures>,
    /// Volumes of each space: of the stock, then of each stroke; mm^3.
    volumes: Sides<Vec<Vec<f64>>>,
    pub(crate) whole: Sides<Sampled>,
    pub(crate) stations: Sides<Sampled>,
}

impl Cycle {
    /// Works the strokes out.
    ///
    /// # Errors
    /// `OutOfRange`, `StrokeOrder`.
    pub fn new(bodies: Bodies, stock: StockField, strokes: Vec<Stroke>) -> Result<Self, TechnologyError> {
        check(&strokes)?;
        let whole = Sides::from_fn(|flank| Sampled::whole(&stock, &bodies, flank));
        let stations = Sides::from_fn(|flank| {
            Sampled::at(&stock, &bodies, flank, bodies.flanks[flank].stations().to_vec())
        });
        let extent = Sides::from_fn(|flank| stock.extent(&bodies, flank));
        let mut before = Sides::both(f64::INFINITY);
        let figures = strokes.into_iter().map(|stroke| {
            let between = Sides::from_fn(|flank| {
                if stroke.ground.has(flank) {
                    [stroke.left[flank], std::mem::replace(&mut before[flank], stroke.left[flank])]
                } else {
                    // Nothing lies between.
                    [before[flank].min(extent[flank][1]); 2]
                }
            });
            figures(&bodies, stroke, between, &extent)
        });
        let mut strokes: Vec<StrokeFigures> = figures.collect();
        let volumes = Sides::from_fn(|flank| {
            let mut bands = vec![[0.0, f64::INFINITY]];
            bands.extend(strokes.iter().map(|figures| figures.flanks[flank].between));
            volumes(&stock, &bodies, flank, &bands)
        });
        for (k, figures) in strokes.iter_mut().enumerate() {
            figures.volume = whole_part(&stock, &volumes, k + 1);
        }
        Ok(Self { bodies, stock, extent, strokes, volumes, whole, stations })
    }

    /// Volume of the stock of all spaces, mm^3.
    pub fn stock_volume(&self) -> f64 {
        whole_part(&self.stock, &self.volumes, 0)
    }

    /// Volume of the stock on one flank of a space, mm^3.
    pub fn stock_of_space(&self, flank: Flank, space: usize) -> f64 {
        self.of_space(0, flank, space)
    }

    /// What a stroke takes from one flank of a space, mm^3.
    pub fn volume_of_space(&self, stroke: usize, flank: Flank, space: usize) -> f64 {
        self.of_space(stroke + 1, flank, space)
    }

    fn of_space(&self, band: usize, flank: Flank, space: usize) -> f64 {
        let spaces = &self.volumes[flank][band];
        spaces[space.min(spaces.len() - 1)]
    }
}

/// A band's volume over both flanks of all spaces.
fn whole_part(stock: &StockField, volumes: &Sides<Vec<Vec<f64>>>, band: usize) -> f64 {
    let of_flank = |flank: Flank| {
        let spaces = &volumes[flank][band];
        spaces.iter().sum::<f64>() * (stock.spaces() as f64 / spaces.len() as f64)
    };
    of_flank(Flank::Left) + of_flank(Flank::Right)
}

fn figures(
    bodies: &Bodies,
    stroke: Stroke,
    between: Sides<[f64; 2]>,
    extent: &Sides<[f64; 2]>,
) -> StrokeFigures {
    let infeed = bodies.stand_off(stroke.ground, stroke.left);
    let speeds = bodies.speeds(stroke.cutting_speed);
    let flanks = Sides::from_fn(|flank| {
        flank_figures(bodies, flank, &stroke, between[flank], extent[flank][1], infeed)
    });
    let sigma = stroke.direction.sign();
    let reaches =
        stroke.ground.flanks().map(|flank| (flank, flanks[flank].raised[1], flanks[flank].distance));
    let contact = contact_feeds(bodies, stroke.direction, reaches);
    let approach = flanks.iter().flat_map(|(_, f)| f.distance).fold(0.0, f64::max);
    let gamma = bodies.pair.chain.crossed_axes_angle;
    let sense = if -gamma.sin() * sigma > 0.0 { Sense::Climb } else { Sense::Conventional };
    let mut figures = StrokeFigures {
        infeed,
        speeds,
        feed: stroke.feed_per_revolution * speeds[1],
        contact,
        approach,
        travel: (contact[1] - contact[0]).abs() + 2.0 * stroke.overrun,
        sense,
        volume: 0.0,
        occupation: [0.0; 2],
        flanks,
        stroke,
    };
    figures.occupation = occupation(bodies, &figures);
    figures
}

/// z_V2 of the first and of the last contact, with C_c2 and D_e at the stations of each flank that is ground.
pub(crate) fn contact_feeds(
    bodies: &Bodies,
    direction: Direction,
    flanks: impl Iterator<Item = (Flank, f64, [f64; STATIONS])>,
) -> [f64; 2] {
    let (sigma, half) = (direction.sign(), 0.5 * bodies.face_width);
    let (mut first, mut last) = (f64::INFINITY, f64::NEG_INFINITY);
    for (flank, c_c2, distance) in flanks {
        let engagement = &bodies.flanks[flank];
        for (w, distance) in engagement.stations().into_iter().zip(distance) {
            let line = sigma * (c_c2 - engagement.line_slope() * w);
            first = first.min(line - half - distance);
            last = last.max(line + half);
        }
    }
    [sigma * first, sigma * last]
}

fn flank_figures(
    bodies: &Bodies,
    flank: Flank,
    stroke: &Stroke,
    between: [f64; 2],
    most: f64,
    infeed: StandOff,
) -> FlankStroke {
    let engagement = &bodies.flanks[flank];
    let stations = engagement.stations();
    let deepest = (most.min(between[1]) - between[0]).max(0.0);
    let curvature = stations.map(|w| engagement.gap_curvature(w));
    let reach = |curvature: f64| (2.0 * deepest / curvature).sqrt();
    let distance = curvature.map(reach);
    let feed = stroke.feed_per_revolution;
    let rolls = equidistant(engagement.roll, AREA_POINTS);
    let strip = |(&w, weight): (&f64, f64)| weight * reach(engagement.gap_curvature(w));
    let contact_area = rolls.iter().zip(area_weights(engagement, &rolls)).map(strip).sum();
    let threads_per_second = bodies.threads() * bodies.speeds(stroke.cutting_speed)[0];
    let rate_bound = stations.map(|w| {
        threads_per_second * feed * engagement.area_density(w) / engagement.profile_width(w) * deepest
    });
    let largest = rate_bound.into_iter().fold(0.0, f64::max);
    FlankStroke {
        between,
        deepest,
        raised: engagement.raised(infeed.delta_d),
        distance,
        contact_length: std::array::from_fn(|i| engagement.along_tooth(stations[i], distance[i])),
        contact_area,
        passage: std::array::from_fn(|i| {
            deepest - 0.5 * curvature[i] * (distance[i] - feed).max(0.0).powi(2)
        }),
        feed_mark: curvature.map(|h| h * feed * feed / 8.0),
        rate_bound,
        // mm^3/(mm s) over m/s is um.
        chip_thickness: 1e-3 * largest / stroke.cutting_speed,
    }
}

/// Least and greatest place on the worm for the first part.
fn occupation(bodies: &Bodies, figures: &StrokeFigures) -> [f64; 2] {
    let half = 0.5 * bodies.face_width;
    let mut places = Vec::new();
    let z = equidistant([-half, half], if figures.stroke.shift.law.is_affine() { 2 } else { BENT_CELLS + 1 });
    for flank in figures.stroke.ground.flanks() {
        for (i, w) in bodies.flanks[flank].stations().into_iter().enumerate() {
            let on_worm = OnWorm::new(bodies, flank, figures, w);
            let distance = figures.flanks[flank].distance[i];
            places.extend(z.iter().flat_map(|&z| [0.0, distance].map(|distance| on_worm.place(z, distance))));
        }
    }
    extremes(places)
}

/// Cells along the face width in which a shift that is not straight counts as straight.
pub(crate) const BENT_CELLS: usize = 64;

/// Where on the worm a length of roll is ground, for the first part: z_1 = path - F(feed - z - sigma D) + ahead D, F the shift.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OnWorm<'a> {
    law: &'a MotionLaw,
    path: f64,
    feed: f64,
    sign: f64,
    ahead: f64,
}

impl<'a> OnWorm<'a> {
    pub fn new(bodies: &Bodies, flank: Flank, figures: &'a StrokeFigures, w: f64) -> Self {
        let engagement = &bodies.flanks[flank];
        let [c_c1, c_c2, e] = figures.flanks[flank].raised;
        let (worm, work) = (&engagement.pair.worm, engagement.work());
        let w_1 = worm.base_helix_angle.cos() * (e - w / work.base_helix_angle.cos());
        let sign = figures.sign();
        Self {
            law: &figures.stroke.shift.law,
            path: c_c1 - engagement.s() * worm.base_helix_angle.tan() * w_1,
            feed: c_c2 - engagement.line_slope() * w,
            sign,
            ahead: sign * engagement.ahead(w),
        }
    }

    pub fn place(&self, z: f64, distance: f64) -> f64 {
        self.path - self.law.value(self.feed - z - self.sign * distance) + self.ahead * distance
    }
}
