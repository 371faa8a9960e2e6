//! The coefficients of the contact relations, read off a simulation (`docs/mathematics/planning.md#the-referee`): bodies turn past each
//! other at fixed feeds, rays of the workpiece are shortened by the worm, and where a row of rays is shortest the contact path
//! crosses it. Linear least squares through those places; no relation of the contact's is known here.
//!
//! Kept for planning with contact relations of a simulation: no command reaches it yet.

use super::descent::descend_along;
use super::engagement::{Engagement, Length, Ray};
use super::{ActiveThreads, Grinding, GrindingMode, RemovalError, Unmodified, WormArea, error};
use foundation::geometry::InvoluteFlank;
use foundation::inverse::weighted_least_squares;
use foundation::kinematics::{GeneratingMotion, MotionLaw};
use nalgebra::{DMatrix, DVector, Vector2};
use rayon::prelude::*;

/// What is simulated. mm.
#[derive(Clone, Copy)]
pub struct ContactSweep<'a> {
    /// The worm flank.
    pub worm: &'a InvoluteFlank,
    /// The part of it that exists.
    pub area: WormArea,
    /// The workpiece flank.
    pub work: &'a InvoluteFlank,
    /// Chain and coupling; its laws of shift and corrections are not used.
    pub motion: &'a GeneratingMotion,
    /// Lengths of roll w_2 of the rows of rays, at least two.
    pub rolls: &'a [f64],
    /// First and last axial position between which the contact path is looked for on every row.
    pub face: [f64; 2],
}

/// One place of the contact path, as the rays show it. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeenContact {
    /// Tool shift z_V1.
    pub shift: f64,
    /// Feed z_V2.
    pub feed: f64,
    /// Length of roll on the workpiece.
    pub w_2: f64,
    /// Axial position on the workpiece.
    pub z_2: f64,
    /// Length of roll on the worm.
    pub w_1: f64,
    /// Axial position on the worm.
    pub z_1: f64,
    /// Length that the shortest ray keeps; zero but for the error of the fit and the search.
    pub rest: f64,
}

/// A linear relation y = roll w + shift z_V1 + feed z_V2 + constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearRelation {
    /// Factor of the length of roll.
    pub roll: f64,
    /// Factor of the tool shift z_V1.
    pub shift: f64,
    /// Factor of the feed z_V2.
    pub feed: f64,
    /// Constant, mm.
    pub constant: f64,
    /// Largest residual, mm.
    pub residual: f64,
}

impl LinearRelation {
    /// The value at a length of roll and feeds, mm.
    pub fn value(&self, roll: f64, shift: f64, feed: f64) -> f64 {
        self.roll * roll + self.shift * shift + self.feed * feed + self.constant
    }
}

/// Relations of `docs/mathematics/generating-contact.md#affine-relations` as the simulation shows them.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedRelations {
    /// z_2 of w_2: C_w2, C_zV12, C_zV22, C_c2.
    pub work_z: LinearRelation,
    /// z_1 of w_1: C_w1, C_zV11, C_zV21, C_c1. C_w1 and C_c1 are strongly correlated; predicted z_1 are not.
    pub worm_z: LinearRelation,
    /// w_1 of w_2: -Chat_w2/Chat_w1 and so on.
    pub worm_roll: LinearRelation,
    /// The places they were fitted to.
    pub contacts: Vec<SeenContact>,
}

/// Half the length of a row of fine rays, mm (`docs/mathematics/planning.md#the-referee`).
const HALF: f64 = 2.0;
/// Fine rays in a row (`docs/mathematics/planning.md#the-referee`).
const FINE: usize = 41;
/// Distance of the coarse rays, mm: within it of the contact path, at lengths of roll above 1 mm, the rays keep less than
/// the largest gap that counts.
const COARSE: f64 = 1.0;
/// Scan step of the workpiece angle as a share of the length of roll, as in the grinding stage.
const STEP_SHARE: f64 = 0.1;
/// Way over which the first curvature of a ray's length is taken, as a share of the length of roll.
const PROBE: f64 = 0.005;
/// The minimum must lie within this share of the row's half length; else the row moves there.
const CENTRED: f64 = 0.1;
/// Times a row may move before the search gives up.
const MOVES: usize = 12;
/// Singular values below this share of the largest are no information: rows and feeds are then too few.
const RANK: f64 = 1e-10;

/// A shortened ray at fixed feeds.
#[derive(Clone, Copy)]
struct Kept {
    z: f64,
    length: Length,
    angle: f64,
}

/// Feed pairs (z_V1, z_V2) that tell everything of a chain: one for two cylinders, two values of z_V1 more for a conical
/// worm, two of z_V2 more for a conical workpiece, four pairs for both (`docs/mathematics/planning.md#the-referee`). `at` is the middle,
/// `step` the distance from it, mm.
pub fn feeds_to_fit(motion: &GeneratingMotion, at: [f64; 2], step: f64) -> Vec<[f64; 2]> {
    let [shift, feed] = at;
    match (motion.chain.worm_cone != 0.0, motion.chain.work_cone != 0.0) {
        (false, false) => vec![at],
        (true, false) => [0.0, -step, step].map(|by| [shift + by, feed]).to_vec(),
        (false, true) => [0.0, -step, step].map(|by| [shift, feed + by]).to_vec(),
        (true, true) => [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)]
            .map(|(i, j)| [shift + i * step, feed + j * step])
            .to_vec(),
    }
}

/// Sweeps the rotation at every pair of feeds and fits the relations. Along its own axis a cylindrical body looks the same
/// from everywhere, so that its own feed moves its contact by -1 mm per mm and nothing else; feeds of conical bodies are
/// fitted.
///
/// # Errors
/// [`RemovalError::InvalidNumber`] for rolls, face and feeds, those of [`super::grind`] for the bodies,
/// [`RemovalError::ContactNotSeen`] where a row does not show the contact path, [`RemovalError::TooFewContacts`] when rows and
/// feeds do not determine the relations.
pub fn fit_relations(sweep: &ContactSweep<'_>, feeds: &[[f64; 2]]) -> Result<FittedRelations, RemovalError> {
    error::range("face of the workpiece", sweep.face)?;
    for &w in sweep.rolls {
        error::positive("length of roll of a row", w)?;
    }
    let mut rows = Vec::with_capacity(feeds.len() * sweep.rolls.len());
    for &pair in feeds {
        for value in pair {
            if !value.is_finite() {
                return Err(RemovalError::InvalidNumber { field: "feed", value, allowed: "finite" });
            }
        }
        rows.extend(sweep.rolls.iter().map(|&w| (pair, w)));
    }
    let contacts =
        rows.par_iter().map(|&(pair, w)| sweep.contact(pair, w)).collect::<Result<Vec<_>, RemovalError>>()?;
    let cones = [sweep.motion.chain.worm_cone != 0.0, sweep.motion.chain.work_cone != 0.0];
    // What a cylinder's own feed does is known: of body 1 the shift, of body 2 the feed.
    let relation = |of: &dyn Fn(&SeenContact) -> [f64; 2], own: [f64; 2]| {
        fit(&contacts, of, [(!cones[0]).then_some(own[0]), (!cones[1]).then_some(own[1])])
    };
    Ok(FittedRelations {
        work_z: relation(&|c| [c.w_2, c.z_2], [0.0, -1.0])?,
        worm_z: relation(&|c| [c.w_1, c.z_1], [-1.0, 0.0])?,
        worm_roll: relation(&|c| [c.w_2, c.w_1], [0.0, 0.0])?,
        contacts,
    })
}

/// Linear least squares of one relation; `known` factors of shift and feed are not fitted.
fn fit(
    contacts: &[SeenContact],
    of: &dyn Fn(&SeenContact) -> [f64; 2],
    known: [Option<f64>; 2],
) -> Result<LinearRelation, RemovalError> {
    let too_few = || RemovalError::TooFewContacts { contacts: contacts.len() };
    let count = contacts.len() as f64;
    let mean = |value: &dyn Fn(&SeenContact) -> f64| contacts.iter().map(value).sum::<f64>() / count;
    let middles = [mean(&|c| of(c)[0]), mean(&|c| c.shift), mean(&|c| c.feed)];
    let free: Vec<usize> = (0..2).filter(|&k| known[k].is_none()).collect();
    let parameters = |c: &SeenContact| [of(c)[0] - middles[0], c.shift - middles[1], c.feed - middles[2]];
    let known = known.map(|value| value.unwrap_or(0.0));
    // Columns: length of roll, the free feeds, 1; measured from the middles so that they hardly lean on one another.
    let columns: Vec<usize> = std::iter::once(0).chain(free.iter().map(|k| k + 1)).collect();
    let a = DMatrix::from_fn(contacts.len(), columns.len() + 1, |i, j| {
        columns.get(j).map_or(1.0, |&k| parameters(&contacts[i])[k])
    });
    let b = DVector::from_iterator(
        contacts.len(),
        contacts.iter().map(|c| {
            let p = parameters(c);
            of(c)[1] - known[0] * p[1] - known[1] * p[2]
        }),
    );
    if contacts.len() < a.ncols() {
        return Err(too_few());
    }
    let solved = weighted_least_squares(&a, &b, None, RANK).ok_or_else(too_few)?;
    if solved.rank.rank < a.ncols() {
        return Err(too_few());
    }
    let mut factors = [0.0, known[0], known[1]];
    for (j, &k) in columns.iter().enumerate() {
        factors[k] = solved.x[j];
    }
    let constant = solved.x[columns.len()]
        - factors.iter().zip(&middles).map(|(factor, middle)| factor * middle).sum::<f64>();
    Ok(LinearRelation {
        roll: factors[0],
        shift: factors[1],
        feed: factors[2],
        constant,
        residual: solved.residual.amax(),
    })
}

impl ContactSweep<'_> {
    /// Where the contact path of one pair of feeds crosses the row at w.
    fn contact(&self, [shift, feed]: [f64; 2], w: f64) -> Result<SeenContact, RemovalError> {
        let motion =
            GeneratingMotion { shift: MotionLaw::polynomial(0.0, vec![shift]), ..self.motion.uncorrected() };
        let base_pitch = {
            let work = self.work;
            2.0 * std::f64::consts::PI * work.base_radius * work.base_helix_angle.cos() / work.teeth
        };
        let setup = Grinding {
            worm: self.worm,
            area: self.area,
            modification: &Unmodified,
            work: self.work,
            motion: &motion,
            // The feed stands still; the range only has to hold it.
            feed_range: [feed - 1.0, feed + 1.0],
            stock: 0.2 * base_pitch,
            threads: ActiveThreads::All,
            mode: GrindingMode::Continuous,
        };
        let row = Row { engagement: Engagement::new(&setup)?, work: self.work, feed, w };
        let lost = |reason| RemovalError::ContactNotSeen { w, shift, feed, reason };
        let [from, to] = self.face;
        let intervals = ((to - from) / COARSE).ceil().max(2.0);
        // A kilometre of face is a mistake in the units.
        if intervals > 1e6 {
            return Err(RemovalError::InvalidNumber {
                field: "face of the workpiece",
                value: to - from,
                allowed: "a length of the order of the face width",
            });
        }
        let start = (0..=intervals as usize)
            .filter_map(|k| row.searched(from + (to - from) * k as f64 / intervals))
            .min_by(|a, b| a.length.lam.total_cmp(&b.length.lam))
            .ok_or_else(|| lost("no ray of the row meets the worm"))?;
        let mut centre = start;
        for _ in 0..MOVES {
            let rays = row.fine(&centre).ok_or_else(|| lost("the worm ends beside the contact path"))?;
            let at = lowest(&rays).ok_or_else(|| lost("the lengths have no minimum"))?;
            if at.abs() <= CENTRED * HALF {
                let seen = |value: &dyn Fn(&Kept) -> f64| interpolated(&rays, at, value);
                let z_2 = centre.z + at;
                if z_2 < from || z_2 > to {
                    return Err(lost("the contact path crosses the row beyond the face"));
                }
                return Ok(SeenContact {
                    shift,
                    feed,
                    w_2: w,
                    z_2,
                    w_1: seen(&|kept| kept.length.foot[0]),
                    z_1: seen(&|kept| kept.length.foot[1]),
                    rest: seen(&|kept| kept.length.lam),
                });
            }
            let by = at.clamp(-HALF, HALF);
            let nearest = rays
                .iter()
                .min_by(|a, b| (a.z - centre.z - by).abs().total_cmp(&(b.z - centre.z - by).abs()))
                .ok_or_else(|| lost("the lengths have no minimum"))?;
            centre = row
                .settled(centre.z + by, nearest)
                .ok_or_else(|| lost("the worm ends beside the contact path"))?;
        }
        Err(lost("the row of rays found no rest"))
    }
}

/// Rays of one length of roll at fixed feeds.
struct Row<'a> {
    engagement: Engagement<'a>,
    work: &'a InvoluteFlank,
    feed: f64,
    w: f64,
}

impl Row<'_> {
    fn ray(&self, z: f64) -> Ray {
        let frame = self.work.frame(self.w, z);
        Ray { point: self.work.point_in(&frame, self.w, z), normal: frame.n, w: self.w }
    }

    /// The least length of a ray over one turn, from a scan.
    fn searched(&self, z: f64) -> Option<Kept> {
        let ray = self.ray(z);
        let turn = 2.0 * std::f64::consts::PI;
        let count = (turn * self.work.base_radius / (STEP_SHARE * self.w)).ceil().max(64.0) as usize;
        let step = turn / count as f64;
        let gaps: Vec<f64> = (0..count)
            .map(|k| {
                let pose = self.engagement.pose(step * k as f64, self.feed);
                let foot = pose.rotation() * ray.point + pose.translation();
                self.engagement.gap(&foot).filter(|gap| gap.abs() <= self.engagement.setup.stock)
            })
            .map(|gap| gap.unwrap_or(f64::INFINITY))
            .collect();
        (0..count)
            .filter(|&k| {
                let beside = [gaps[(k + count - 1) % count], gaps[(k + 1) % count]];
                gaps[k].is_finite() && beside.iter().all(|&other| gaps[k] <= other)
            })
            .filter_map(|k| self.descended(z, step * k as f64, gaps[k]))
            .min_by(|a, b| a.length.lam.total_cmp(&b.length.lam))
    }

    /// The least length over the angle from a place close by.
    fn descended(&self, z: f64, angle: f64, guess: f64) -> Option<Kept> {
        let ray = self.ray(z);
        // Angles as arcs on the base circle, mm.
        let direction = Vector2::new(1.0 / self.work.base_radius, 0.0);
        let length = |x: Vector2<f64>, guess: f64| self.engagement.length(&ray, x, guess);
        let start = Vector2::new(angle, self.feed);
        // How the exact slope changes over a little way is the first curvature of the search; it learns a better one.
        let probe = PROBE * self.w;
        let here = length(start, guess)?;
        let there = length(start + direction * probe, here.lam)?;
        let curvature = ((there.rates - here.rates).dot(&direction) / probe).abs();
        let (x, length, _) = descend_along(start, direction, curvature, here.lam, length)?;
        let inside = self.engagement.area.covers(length.foot[0], length.foot[1]);
        let reached = length.lam.abs() <= self.engagement.setup.stock;
        (inside && reached).then_some(Kept { z, length, angle: x[0] })
    }

    /// The ray at z from a neighbour's minimum: the tooth turns with z along its helix, and the cut with it.
    fn settled(&self, z: f64, neighbour: &Kept) -> Option<Kept> {
        let angle = neighbour.angle - (z - neighbour.z) * self.work.twist_per_length();
        self.descended(z, angle, neighbour.length.lam)
    }

    /// The fine row round a ray, outwards from the middle on both sides.
    fn fine(&self, centre: &Kept) -> Option<Vec<Kept>> {
        let half = FINE / 2;
        let step = HALF / half as f64;
        let side = |sign: f64| {
            let mut last = *centre;
            (1..=half)
                .map(|k| {
                    last = self.settled(centre.z + sign * step * k as f64, &last)?;
                    Some(last)
                })
                .collect::<Option<Vec<Kept>>>()
        };
        let mut rays = side(-1.0)?;
        rays.reverse();
        rays.push(*centre);
        rays.extend(side(1.0)?);
        Some(rays)
    }
}

/// Where a quartic through the lengths is least, as distance from the middle of the row.
fn lowest(rays: &[Kept]) -> Option<f64> {
    let middle = rays[rays.len() / 2].z;
    let u = |kept: &Kept| (kept.z - middle) / HALF;
    let a = DMatrix::from_fn(rays.len(), 5, |i, j| u(&rays[i]).powi(j as i32));
    let b = DVector::from_iterator(rays.len(), rays.iter().map(|kept| kept.length.lam));
    let c = weighted_least_squares(&a, &b, None, RANK)?.x;
    let jet = |x: f64| {
        let slope = c[1] + x * (2.0 * c[2] + x * (3.0 * c[3] + x * 4.0 * c[4]));
        (slope, 2.0 * c[2] + x * (6.0 * c[3] + x * 12.0 * c[4]))
    };
    // Newton from the middle; the row moves on anyway where the minimum lies outside.
    let mut x: f64 = 0.0;
    for _ in 0..40 {
        let (slope, bend) = jet(x);
        let step = -slope / bend.abs();
        if !step.is_finite() {
            return None;
        }
        x += step.clamp(-0.5, 0.5);
        if step.abs() < 1e-13 {
            return Some(x * HALF);
        }
        if x.abs() > 1.0 {
            return Some(x.signum() * HALF);
        }
    }
    None
}

/// A quantity of the rays at a distance from the middle of the row: parabola through the three nearest rays.
fn interpolated(rays: &[Kept], at: f64, value: &dyn Fn(&Kept) -> f64) -> f64 {
    let middle = rays.len() / 2;
    let step = HALF / middle as f64;
    let offset = (at / step).round().clamp(1.0 - middle as f64, middle as f64 - 1.0);
    let k = (middle as f64 + offset) as usize;
    let t = at / step - offset;
    let [a, b, c] = [k - 1, k, k + 1].map(|k| value(&rays[k]));
    b + t * (0.5 * (c - a) + t * 0.5 * (a - 2.0 * b + c))
}
