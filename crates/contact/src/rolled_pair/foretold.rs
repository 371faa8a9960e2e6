//! What an ease-off says of the contact of a conjugate pair, in closed form.
//!
//! The nominal flanks touch along a line at every roll. What both ease-offs leave there, f_1 + f_2 along the common normal, brings the
//! second gear by -(f_1 + f_2)/arm nearer to that place or farther from it, arm being that of the normal about its axis. The least of
//! this turn over the line, and over the lines of all pairs, holds the gears apart; every other place of the line stays open by the
//! difference. The arm of a bevel gear grows with the distance from the apex, so that it is the turn that counts, not the ease-off alone.

use super::arrangement::Arrangement;
use super::pair::within;
use super::{FlankPlaces, GapField, RollCourse};
use crate::ContactError;
use foundation::geometry::{
    BevelGear, Flank, FlankLine, Helicoid, NormalOffset, Octoid, SphericalInvolute, Surface,
};
use foundation::numerics::{equidistant, extremes};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// A gear and its conjugate mate: nominal flanks, places that touch, and when.
#[derive(Clone, Debug)]
pub struct ConjugateFlanks {
    flank: Flank,
    nominal: Arc<dyn Surface>,
    /// Heights of both active flanks at root and tip.
    heights: [[f64; 2]; 2],
    /// Ends of both faces.
    lengths: [[f64; 2]; 2],
    teeth: [u32; 2],
    /// Height of the second flank over that of the first: at 0, and its rate.
    partner: [f64; 2],
    /// Turn of the first gear's transverse section over the height of the place that touches, without the sign of the flank: at 0, and its
    /// rate.
    turn: [f64; 2],
    line: Line,
}

/// How sections of the first gear are turned along the tooth.
#[derive(Clone, Debug)]
enum Line {
    Bevel(FlankLine),
    /// k, rad/mm.
    Helix(f64),
}

/// Places of a contact line.
const PLACES: usize = 81;
/// Steps between two roll positions: a line ends with the flank, not with a position, and up to there it holds the gears apart.
const BETWEEN: usize = 16;

impl ConjugateFlanks {
    /// Flanks on the spherical involute: both cones roll off one plane of action.
    pub fn involute(gears: [BevelGear; 2], flank: Flank) -> Self {
        let [first, second] = &gears;
        let sines = [first, second].map(|gear| gear.base_angle().sin());
        // Arcs on the plane of action from both base cones: xi_1 + xi_2 is what it is at the pitch point.
        let together = first.pitch_roll() + second.pitch_roll();
        let half_space = FRAC_PI_2 / f64::from(first.data().teeth);
        let surface = SphericalInvolute::new(first, flank);
        Self {
            flank,
            heights: [first.heights(), second.heights()],
            lengths: [first.face(), second.face()],
            teeth: [first.data().teeth, second.data().teeth],
            partner: [together / sines[1], -sines[0] / sines[1]],
            turn: [half_space - first.pitch_roll() / sines[0], 1.0],
            line: Line::Bevel(surface.line().clone()),
            nominal: Arc::new(surface),
        }
    }

    /// Octoid flanks: one crown gear's plane cuts both.
    ///
    /// # Errors
    /// Those of [`Octoid::height_of`].
    pub fn octoid(gears: [BevelGear; 2], flank: Flank) -> Result<Self, ContactError> {
        let heights = |gear: &BevelGear| {
            let octoid = Octoid::new(gear, flank);
            Ok::<_, ContactError>([octoid.height_of(gear.form_angle())?, octoid.height_of(gear.tip_angle())?])
        };
        let [first, second] = &gears;
        let sines = [first, second].map(|gear| gear.data().pitch_angle.sin());
        Ok(Self {
            flank,
            nominal: Arc::new(Octoid::new(first, flank)),
            heights: [heights(first)?, heights(second)?],
            lengths: [first.face(), second.face()],
            teeth: [first.data().teeth, second.data().teeth],
            partner: [0.0, -sines[0] / sines[1]],
            turn: [FRAC_PI_2 / f64::from(first.data().teeth), 1.0],
            line: Line::Bevel(FlankLine::Straight),
        })
    }

    /// Involute helicoids on parallel axes, with the heights of both active flanks at root and tip and the ends of both faces.
    ///
    /// # Errors
    /// [`ContactError::InvalidNumber`] for a centre distance at which the base circles have no common tangent, and for axes that cross.
    pub fn cylindrical(
        gears: [&Helicoid; 2],
        arrangement: Arrangement,
        heights: [[f64; 2]; 2],
        lengths: [[f64; 2]; 2],
    ) -> Result<Self, ContactError> {
        let [first, second] = gears;
        let radii = gears.map(Helicoid::base_radius);
        let against = arrangement.against();
        let distance = arrangement.centre().abs();
        let cosine = (radii[0] + against * radii[1]).abs() / distance;
        if !(cosine > 0.0 && cosine < 1.0) {
            return Err(ContactError::InvalidNumber {
                field: "centre_distance",
                value: distance,
                allowed: "greater than sum or difference of both base radii",
            });
        }
        let angle = cosine.acos();
        let path = distance * angle.sin();
        // Along the common tangent: w_1 + w_2 outside, w_ring - w_pinion inside.
        let sign = first.external_sign();
        let partner = if against > 0.0 { [path, -1.0] } else { [sign * path, 1.0] };
        let turn = [first.base_space_half_angle() - sign * angle, sign / radii[0]];
        Ok(Self {
            flank: first.flank().flank,
            nominal: Arc::new(*first),
            heights,
            lengths,
            teeth: [first.flank().teeth.round() as u32, second.flank().teeth.round() as u32],
            partner,
            turn,
            line: Line::Helix(first.twist()),
        })
    }

    /// Which flanks of the first gear's spaces touch.
    pub fn flank(&self) -> Flank {
        self.flank
    }

    /// Heights of both active flanks at root and tip.
    pub fn heights(&self) -> [[f64; 2]; 2] {
        self.heights
    }

    /// Height on the second flank that touches a height of the first one; the length is that of the first.
    pub fn partner(&self, height: f64) -> f64 {
        self.partner[0] + self.partner[1] * height
    }

    /// Height on the first flank that touches a height of the second one.
    pub fn touching(&self, partner: f64) -> f64 {
        (partner - self.partner[0]) / self.partner[1]
    }

    /// Turn of the section at a length, rad.
    fn section(&self, length: f64) -> f64 {
        match &self.line {
            Line::Bevel(line) => line.angle(length),
            Line::Helix(twist) => twist * length,
        }
    }

    /// Roll of the first gear at which a place of it touches, rad; 0 with the space on the pitch line.
    pub fn roll(&self, [height, length]: [f64; 2]) -> f64 {
        self.flank.sign() * (self.turn[0] + self.turn[1] * height) - self.section(length)
    }

    /// Height that touches at a roll and a length.
    fn height(&self, roll: f64, length: f64) -> f64 {
        (self.flank.sign() * (roll + self.section(length)) - self.turn[0]) / self.turn[1]
    }

    /// Whether a place of the first flank touches one of the second.
    pub fn touches(&self, place: [f64; 2]) -> bool {
        within(self.heights[0], place[0])
            && within(self.heights[1], self.partner(place[0]))
            && within(self.lengths[1], place[1])
    }

    /// Turn of the second gear that the ease-offs of both gears ask for at a place, rad, and the arm, mm; `None` where the partner
    /// is none of the active flank.
    fn turn(&self, place: [f64; 2], ease: [&dyn NormalOffset; 2]) -> Option<[f64; 2]> {
        if !self.touches(place) {
            return None;
        }
        let jet = self.nominal.jet(place[0], place[1]);
        // Normal speeds of both gears are equal on the contact line.
        let own = (jet.point.x * jet.normal.y - jet.point.y * jet.normal.x).abs();
        let arm = own * f64::from(self.teeth[1]) / f64::from(self.teeth[0]);
        let left = ease[0].jet(place[0], place[1]).f + ease[1].jet(self.partner(place[0]), place[1]).f;
        Some([-left / arm, arm])
    }

    /// The least turn over the contact lines of all rolls, `positions` and what lies between them for each pitch of the first gear.
    pub fn course(&self, ease: [&dyn NormalOffset; 2], positions: usize) -> RollCourse {
        let lengths = equidistant(self.lengths[0], PLACES);
        let ends = lengths.iter().flat_map(|b| self.heights[0].map(|a| self.roll([a, *b])));
        let [from, to] = extremes(ends);
        let positions = BETWEEN * positions.max(1);
        let step = std::f64::consts::TAU / f64::from(self.teeth[0]) / positions as f64;
        let count = ((to - from) / step).ceil() as usize + 1;
        let least = |position: usize| {
            let roll = from + position as f64 * step;
            let on_line = lengths.iter().filter_map(|length| {
                self.turn([self.height(roll, *length), *length], ease).map(|[turn, _]| turn)
            });
            on_line.fold(f64::INFINITY, f64::min)
        };
        RollCourse::new(from, step, positions, (0..count).map(least).collect())
    }

    /// The gap left at every place when its contact line comes by, mm.
    pub fn field(&self, places: &FlankPlaces, ease: [&dyn NormalOffset; 2], course: &RollCourse) -> GapField {
        let gap = |place: [f64; 2]| {
            let left = self.turn(place, ease).map(|[turn, arm]| (turn - course.at(self.roll(place))) * arm);
            left.unwrap_or(f64::INFINITY)
        };
        GapField { gaps: places.iter().map(gap).collect() }
    }
}
