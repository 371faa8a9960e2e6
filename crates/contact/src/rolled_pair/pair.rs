//! Both gears in one frame, and how far the second one turns until it touches a place of the first.

use super::arrangement::Arrangement;
use super::deviation::FlankDeviation;
use crate::ContactError;
use foundation::geometry::{Flank, Surface, SurfaceJet};
use nalgebra::Vector3;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// A gear by one flank of a tooth space, in its own frame: z its axis, of a bevel gear from the apex to the heel, the space about +y.
#[derive(Clone, Debug)]
pub struct RolledGear {
    /// The flank.
    pub surface: Arc<dyn Surface>,
    /// Heights of the active flank at root and tip.
    pub heights: [f64; 2],
    /// Lengths at both ends of the face, ascending.
    pub lengths: [f64; 2],
    /// Number of teeth.
    pub teeth: u32,
}

/// Two gears that touch with one pair of flanks. rad, mm.
#[derive(Clone, Debug)]
pub struct RolledPair {
    gears: [RolledGear; 2],
    arrangement: Arrangement,
    flank: Flank,
    /// Turns of the second gear for one of the first, > 0 against it.
    ratio: f64,
    /// Turn of the second gear that nominal flanks need to touch, which counts as none.
    play: f64,
    deviation: Option<FlankDeviation>,
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

/// A place of the first flank.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub jet: SurfaceJet,
    /// Material beyond it, mm.
    pub beyond: f64,
}

/// Steps of the search for the partner; from the middle of a flank it takes five.
const STEPS: usize = 30;
/// Where it ends, as a share of the distance from the apex or of the radius: what the last step leaves is of second order, 1e-14 of it,
/// and is not looked at again.
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
    /// Two gears; `flank` is that of the spaces of the first. Like meets like but for a gear inside of the other, whose left flanks
    /// meet right ones.
    ///
    /// # Errors
    /// [`ContactError::InvalidNumber`] for a shaft angle that is not between 0 and 180 degrees, a centre distance that is not above 0,
    /// gears without teeth, and ranges that are not finite.
    pub fn new(gears: [RolledGear; 2], arrangement: Arrangement, flank: Flank) -> Result<Self, ContactError> {
        arrangement.check()?;
        let number = |field, value: f64, good: bool, allowed| {
            if good { Ok(()) } else { Err(ContactError::InvalidNumber { field, value, allowed }) }
        };
        for gear in &gears {
            number("teeth", f64::from(gear.teeth), gear.teeth > 0, "at least 1")?;
            for end in [gear.heights, gear.lengths].as_flattened() {
                number("end of a flank", *end, end.is_finite(), "a finite number")?;
            }
        }
        let ratio = arrangement.against() * f64::from(gears[0].teeth) / f64::from(gears[1].teeth);
        Ok(Self { gears, arrangement, flank, ratio, play: 0.0, deviation: None })
    }

    /// The pair with a turn of the second gear that counts as none: what a nominal place needs to touch at the roll at which it does
    /// (backlash and the number of the space that it meets). `None` where nothing of the second flank comes there.
    pub fn without_play(mut self, place: [f64; 2], roll: f64) -> Option<Self> {
        self.play = 0.0;
        self.play = self.gap(place, roll, None)?.angle;
        Some(self)
    }

    /// The pair with what counts as no turn in another one.
    pub fn with_play_of(mut self, nominal: &Self) -> Self {
        self.play = nominal.play;
        self
    }

    /// Turn of the second gear that counts as none, rad.
    pub fn play(&self) -> f64 {
        self.play
    }

    /// The pair whose first flank has this material beside what its surface says; without it, the surface alone.
    pub fn deviating(mut self, deviation: Option<FlankDeviation>) -> Self {
        self.deviation = deviation;
        self
    }

    /// What the first flank has beside its surface.
    pub(super) fn deviation(&self) -> Option<&FlankDeviation> {
        self.deviation.as_ref()
    }

    /// The first gear, on whose flank contact is looked at.
    pub fn first(&self) -> &RolledGear {
        &self.gears[0]
    }

    /// Which flanks of the first gear's spaces touch.
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

    /// Over the place (height, length) of the first flank at a roll of its gear (rad, mathematically positive about z, 0 with the space
    /// on the pitch line): the place of the second flank that comes there when the second gear turns, whatever turn it needs. `None`
    /// where no place of the second active flank comes there, or it is not known how much the first one deviates.
    pub fn gap(&self, place: [f64; 2], roll: f64, start: Option<[f64; 2]>) -> Option<PairGap> {
        self.gap_at(&self.place(place)?, roll, start)
    }

    /// A place with what it deviates by; `None` where that is not known.
    pub(super) fn place(&self, place: [f64; 2]) -> Option<Place> {
        let beyond = match &self.deviation {
            Some(deviation) => deviation.at(place)?,
            None => 0.0,
        };
        Some(Place { jet: self.gears[0].surface.jet(place[0], place[1]), beyond })
    }

    /// As [`Self::gap`], of the surface alone.
    pub(super) fn surface_gap(&self, place: [f64; 2], roll: f64, start: Option<[f64; 2]>) -> Option<PairGap> {
        let jet = self.gears[0].surface.jet(place[0], place[1]);
        self.gap_at(&Place { jet, beyond: 0.0 }, roll, start)
    }

    /// As [`Self::gap`], of a place that is known.
    pub(super) fn gap_at(&self, at: &Place, roll: f64, start: Option<[f64; 2]>) -> Option<PairGap> {
        let (sin, cos) = roll.sin_cos();
        let rolled = |v: &Vector3<f64>| Vector3::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y, v.z);
        let point = self.arrangement.seen(&rolled(&at.jet.point));
        let normal = self.arrangement.turned(&rolled(&at.jet.normal));
        let (partner, other) = self.partner(&point, start)?;
        let azimuth = |p: &Vector3<f64>| p.y.atan2(p.x);
        let sense = self.flank.sign() * self.arrangement.against();
        let angle = azimuth(&point) - azimuth(&other) - self.turned(roll);
        let arm = (normal.y * point.x - normal.x * point.y).abs();
        let free = sense * (angle - TAU * (angle / TAU).round()) - self.play;
        Some(PairGap { angle: free - at.beyond / arm, arm, partner })
    }

    /// The place of the second flank on the circle of a point about the second axis: Newton's method on the two coordinates of that
    /// circle, of which each belongs to one parameter nearly alone.
    fn partner(&self, point: &Vector3<f64>, start: Option<[f64; 2]>) -> Option<([f64; 2], Vector3<f64>)> {
        let gear = &self.gears[1];
        let none = Vector3::zeros();
        let wanted = self.arrangement.circle(point, [&none, &none]).place;
        let middle = || [gear.heights, gear.lengths].map(|[from, to]| 0.5 * (from + to));
        let mut at = start.unwrap_or_else(middle);
        let domain = gear.surface.domain();
        let enough = ENOUGH * point.norm();
        for _ in 0..STEPS {
            let jet = gear.surface.jet(at[0], at[1]);
            let circle = self.arrangement.circle(&jet.point, [&jet.by_height, &jet.by_length]);
            let miss = [wanted[0] - circle.place[0], wanted[1] - circle.place[1]];
            let [a, b] = circle.rates;
            let determinant = a[0] * b[1] - a[1] * b[0];
            let step = [
                (miss[0] * b[1] - miss[1] * b[0]) / determinant,
                (a[0] * miss[1] - a[1] * miss[0]) / determinant,
            ];
            if !step.iter().all(|x| x.is_finite()) {
                return None;
            }
            if (0..2).all(|k| (circle.scales[k] * miss[k]).abs() <= enough) {
                let at = [at[0] + step[0], at[1] + step[1]];
                let point = jet.point + jet.by_height * step[0] + jet.by_length * step[1];
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

    /// Roll at which a place of the first flank would touch a flank that is conjugate to it: where its normal crosses the axis of
    /// relative motion, n . (w_1 x P - w_2 x (P - C)) = 0 with the turns w of both gears and C on the second axis. `None` where it
    /// never does.
    pub fn roll_of(&self, place: [f64; 2]) -> Option<f64> {
        let jet = self.gears[0].surface.jet(place[0], place[1]);
        let (moment, n) = (jet.point.cross(&jet.normal), jet.normal);
        let ([sin_shaft, cos_shaft], centre) = (self.arrangement.shaft(), self.arrangement.centre());
        let with_cos = self.ratio * (sin_shaft * moment.y + centre * n.x);
        let with_sin = self.ratio * (sin_shaft * moment.x - centre * n.y);
        let cosine = -(1.0 + self.ratio * cos_shaft) * moment.z / with_cos.hypot(with_sin);
        if !(-1.0..=1.0).contains(&cosine) {
            return None;
        }
        let middle = with_sin.atan2(with_cos);
        let of_pitch_line = |roll: f64| {
            let azimuth = jet.point.x.atan2(jet.point.y) - roll;
            (azimuth - TAU * (azimuth / TAU).round()).abs()
        };
        let rolls = [middle - cosine.acos(), middle + cosine.acos()];
        let nearest = if of_pitch_line(rolls[0]) < of_pitch_line(rolls[1]) { rolls[0] } else { rolls[1] };
        Some(nearest - TAU * (nearest / TAU).round())
    }
}
