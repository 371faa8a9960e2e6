//! Both gears in one frame, and how far the second one turns until it touches a place of the first.

use crate::ContactError;
use foundation::geometry::{Flank, Surface, SurfaceJet};
use nalgebra::Vector3;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// A gear by one flank of a tooth space, in its own frame: z from the apex to the heel, the space about +y.
#[derive(Clone, Debug)]
pub struct RolledGear {
    /// The flank.
    pub surface: Arc<dyn Surface>,
    /// Heights of the active flank at root and tip.
    pub heights: [f64; 2],
    /// Lengths at toe and heel.
    pub lengths: [f64; 2],
    /// Number of teeth.
    pub teeth: u32,
}

/// Two gears that touch with one pair of flanks. rad, mm.
#[derive(Clone, Debug)]
pub struct RolledPair {
    gears: [RolledGear; 2],
    flank: Flank,
    sin_shaft: f64,
    cos_shaft: f64,
    /// Turns of the second gear for one of the first, without sign.
    ratio: f64,
}

/// The second gear over a place of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairGap {
    /// How far the second gear turns until it touches the place, rad; < 0 inside.
    pub angle: f64,
    /// Way of the second flank along the first one's normal for each radian of that turn, mm.
    pub arm: f64,
    /// Height and length on the second flank.
    pub partner: [f64; 2],
}

/// Steps of the search for the partner; from the middle of a flank it takes five.
const STEPS: usize = 30;
/// Where it ends, as a share of the distance from the apex: what the last step leaves is of second order, 1e-14 of it, and is not
/// looked at again.
const ENOUGH: f64 = 1e-7;
/// By how much of its size a partner may lie beside the flank: ease-offs move places along the tooth by micrometres, and so the ends
/// of both faces would miss each other.
const BESIDE: f64 = 1e-3;

impl RolledGear {
    fn holds(&self, [height, length]: [f64; 2]) -> bool {
        within(self.heights, height) && within(self.lengths, length)
    }
}

/// Whether a parameter lies in a range, or so little beside that it counts.
pub(super) fn within([from, to]: [f64; 2], x: f64) -> bool {
    let beside = BESIDE * (to - from).abs();
    x >= from.min(to) - beside && x <= from.max(to) + beside
}

impl RolledPair {
    /// Two gears whose axes cross at `shaft_angle` (rad); `flank` is that of the spaces of both.
    ///
    /// # Errors
    /// [`ContactError::InvalidNumber`] for a shaft angle that is not between 0 and 180 degrees, gears without teeth, and ranges that
    /// are not finite.
    pub fn new(gears: [RolledGear; 2], shaft_angle: f64, flank: Flank) -> Result<Self, ContactError> {
        let number = |field, value: f64, good: bool, allowed| {
            if good { Ok(()) } else { Err(ContactError::InvalidNumber { field, value, allowed }) }
        };
        let angle = shaft_angle.to_degrees();
        number("shaft_angle_deg", angle, angle > 0.0 && angle < 180.0, "between 0 and 180 deg")?;
        for gear in &gears {
            number("teeth", f64::from(gear.teeth), gear.teeth > 0, "at least 1")?;
            for end in [gear.heights, gear.lengths].as_flattened() {
                number("end of a flank", *end, end.is_finite(), "a finite number")?;
            }
        }
        let ratio = f64::from(gears[0].teeth) / f64::from(gears[1].teeth);
        let (sin_shaft, cos_shaft) = shaft_angle.sin_cos();
        Ok(Self { gears, flank, sin_shaft, cos_shaft, ratio })
    }

    /// The first gear, on whose flank contact is looked at.
    pub fn first(&self) -> &RolledGear {
        &self.gears[0]
    }

    /// Which flanks of the spaces touch.
    pub fn flank(&self) -> Flank {
        self.flank
    }

    /// One pitch of the first gear, rad.
    pub fn pitch(&self) -> f64 {
        TAU / f64::from(self.gears[0].teeth)
    }

    /// Turn of the second gear at a roll of the first, if both roll without error; a tooth of the second stands in the space of the
    /// first.
    fn turned(&self, roll: f64) -> f64 {
        self.flank.sign() * PI / f64::from(self.gears[1].teeth) - self.ratio * roll
    }

    /// A vector of the first gear at a roll, in the frame of the second gear's bed: x against x, y towards the pitch line, z its axis.
    fn seen_by_second(&self, vector: &Vector3<f64>, roll: f64) -> Vector3<f64> {
        let (sin, cos) = roll.sin_cos();
        let (x, y) = (cos * vector.x - sin * vector.y, sin * vector.x + cos * vector.y);
        let (s, c) = (self.sin_shaft, self.cos_shaft);
        Vector3::new(-x, s * vector.z - c * y, s * y + c * vector.z)
    }

    /// Over the place (height, length) of the first flank at a roll of its gear (rad, mathematically positive about z, 0 with the space
    /// on the pitch line): the place of the second flank that comes there when the second gear turns, whatever turn it needs. `None`
    /// where no place of the second active flank comes there.
    pub fn gap(&self, place: [f64; 2], roll: f64, start: Option<[f64; 2]>) -> Option<PairGap> {
        let at = self.gears[0].surface.jet(place[0], place[1]);
        self.gap_at(&at, roll, start)
    }

    /// As [`Self::gap`], of a place whose jet is known.
    pub(super) fn gap_at(&self, at: &SurfaceJet, roll: f64, start: Option<[f64; 2]>) -> Option<PairGap> {
        let point = self.seen_by_second(&at.point, roll);
        let normal = self.seen_by_second(&at.normal, roll);
        let (partner, other) = self.partner(&point, start)?;
        let azimuth = |p: &Vector3<f64>| p.y.atan2(p.x);
        let angle = azimuth(&point) - azimuth(&other) - self.turned(roll);
        Some(PairGap {
            angle: self.flank.sign() * (angle - TAU * (angle / TAU).round()),
            arm: (normal.y * point.x - normal.x * point.y).abs(),
            partner,
        })
    }

    /// The place of the second flank on the circle of a point about the second axis: Newton's method on distance from the apex and
    /// polar angle, of which each belongs to one parameter nearly alone.
    fn partner(&self, point: &Vector3<f64>, start: Option<[f64; 2]>) -> Option<([f64; 2], Vector3<f64>)> {
        let gear = &self.gears[1];
        let wanted = [point.norm(), point.xy().norm().atan2(point.z)];
        let middle = || [gear.heights, gear.lengths].map(|[from, to]| 0.5 * (from + to));
        let mut at = start.unwrap_or_else(middle);
        let domain = gear.surface.domain();
        for _ in 0..STEPS {
            let jet = gear.surface.jet(at[0], at[1]);
            let (p, radius) = (&jet.point, jet.point.xy().norm());
            let distance = p.norm();
            let miss = [wanted[0] - distance, wanted[1] - radius.atan2(p.z)];
            let rates = |v: &Vector3<f64>| {
                let outwards = (p.x * v.x + p.y * v.y) / radius;
                [p.dot(v) / distance, (p.z * outwards - radius * v.z) / (distance * distance)]
            };
            let (a, b) = (rates(&jet.by_height), rates(&jet.by_length));
            let determinant = a[0] * b[1] - a[1] * b[0];
            let step = [
                (miss[0] * b[1] - miss[1] * b[0]) / determinant,
                (a[0] * miss[1] - a[1] * miss[0]) / determinant,
            ];
            if !step.iter().all(|x| x.is_finite()) {
                return None;
            }
            if miss[0].abs().max(distance * miss[1].abs()) <= ENOUGH * distance {
                let at = [at[0] + step[0], at[1] + step[1]];
                let point = p + jet.by_height * step[0] + jet.by_length * step[1];
                return gear.holds(at).then_some((at, point));
            }
            // A first step from the middle of a flank overshoots where the polar angle stands still, at the base cone.
            let [least, most] = domain[0];
            at = [(at[0] + step[0]).max(0.5 * (at[0] + least)).min(most), at[1] + step[1]];
            if at[1] < domain[1][0] || at[1] > domain[1][1] {
                return None;
            }
        }
        None
    }

    /// Roll at which a place of the first flank would touch a flank that is conjugate to it: the normal meets the pitch line's plane of
    /// relative motion, w . (P x n) = 0 with w the relative turn. `None` where it never does.
    pub(super) fn roll_of(&self, place: [f64; 2]) -> Option<f64> {
        let at = self.gears[0].surface.jet(place[0], place[1]);
        let moment = at.point.cross(&at.normal);
        let along = self.ratio * self.sin_shaft * moment.xy().norm();
        let cosine = -(1.0 + self.ratio * self.cos_shaft) * moment.z / along;
        if !(-1.0..=1.0).contains(&cosine) {
            return None;
        }
        let middle = moment.x.atan2(moment.y);
        let of_pitch_line = |roll: f64| {
            let azimuth = at.point.x.atan2(at.point.y) - roll;
            (azimuth - TAU * (azimuth / TAU).round()).abs()
        };
        let rolls = [middle - cosine.acos(), middle + cosine.acos()];
        let nearest = if of_pitch_line(rolls[0]) < of_pitch_line(rolls[1]) { rolls[0] } else { rolls[1] };
        Some(nearest - TAU * (nearest / TAU).round())
    }
}
