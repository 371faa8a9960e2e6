//! What an ease-off says of the contact of a conjugate pair, in closed form.
//!
//! The nominal flanks touch along a line at every roll. What both ease-offs leave there, f_1 + f_2 along the common normal, brings the
//! second gear by -(f_1 + f_2)/arm nearer to that place or farther from it, arm being that of the normal about its axis. The least of
//! this turn over the line, and over the lines of all pairs, holds the gears apart; every other place of the line stays open by the
//! difference. The arm grows with the distance from the apex, so that it is the turn that counts, not the ease-off alone.

use super::pair::within;
use super::{FlankPlaces, GapField, RollCourse};
use crate::ContactError;
use foundation::geometry::{BevelGear, Flank, FlankLine, NormalOffset, Octoid, SphericalInvolute, Surface};
use foundation::numerics::{equidistant, extremes};

/// A bevel gear and its conjugate mate: nominal flanks, places that touch, and when.
#[derive(Clone, Debug)]
pub struct ConjugateFlanks {
    gears: [BevelGear; 2],
    flank: Flank,
    nominal: Nominal,
    /// Heights of both active flanks at root and tip.
    heights: [[f64; 2]; 2],
}

#[derive(Clone, Debug)]
enum Nominal {
    Involute(Box<SphericalInvolute>),
    Octoid(Octoid),
}

/// Places of a contact line.
const PLACES: usize = 81;
/// Steps between two roll positions: a line ends with the flank, not with a position, and up to there it holds the gears apart.
const BETWEEN: usize = 16;

impl ConjugateFlanks {
    /// Flanks on the spherical involute: both cones roll off one plane of action.
    pub fn involute(gears: [BevelGear; 2], flank: Flank) -> Self {
        let nominal = Nominal::Involute(Box::new(SphericalInvolute::new(&gears[0], flank)));
        let heights = [gears[0].heights(), gears[1].heights()];
        Self { gears, flank, nominal, heights }
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
        let heights = [heights(&gears[0])?, heights(&gears[1])?];
        let nominal = Nominal::Octoid(Octoid::new(&gears[0], flank));
        Ok(Self { gears, flank, nominal, heights })
    }

    /// Which flanks of the spaces touch.
    pub fn flank(&self) -> Flank {
        self.flank
    }

    /// Heights of both active flanks at root and tip.
    pub fn heights(&self) -> [[f64; 2]; 2] {
        self.heights
    }

    fn surface(&self) -> &dyn Surface {
        match &self.nominal {
            Nominal::Involute(surface) => &**surface,
            Nominal::Octoid(surface) => surface,
        }
    }

    /// Height on the second flank that touches a height of the first one; the distance from the apex is that of the first.
    pub fn partner(&self, height: f64) -> f64 {
        let [first, second] = &self.gears;
        match self.nominal {
            // Arcs on the plane of action from both base cones: xi_1 + xi_2 is what it is at the pitch point.
            Nominal::Involute(_) => {
                let together = first.pitch_roll() + second.pitch_roll();
                (together - height * first.base_angle().sin()) / second.base_angle().sin()
            }
            Nominal::Octoid(_) => -height * first.data().pitch_angle.sin() / second.data().pitch_angle.sin(),
        }
    }

    /// Height less roll of a straight flank that stands on the pitch line with its space.
    fn offset(&self) -> f64 {
        let gear = &self.gears[0];
        let half_space = std::f64::consts::FRAC_PI_2 / f64::from(gear.data().teeth);
        match self.nominal {
            Nominal::Involute(_) => half_space - gear.pitch_roll() / gear.base_angle().sin(),
            Nominal::Octoid(_) => half_space,
        }
    }

    fn line(&self) -> &FlankLine {
        match &self.nominal {
            Nominal::Involute(surface) => surface.line(),
            Nominal::Octoid(_) => &FlankLine::Straight,
        }
    }

    /// Roll of the first gear at which a place of it touches, rad; 0 with the space on the pitch line.
    pub fn roll(&self, [height, length]: [f64; 2]) -> f64 {
        self.flank.sign() * (height + self.offset()) - self.line().angle(length)
    }

    /// Turn of the second gear that the ease-offs of both gears ask for at a place, rad, and the arm, mm; `None` where the partner
    /// is none of the active flank.
    fn turn(&self, place: [f64; 2], ease: [&dyn NormalOffset; 2]) -> Option<[f64; 2]> {
        let partner = self.partner(place[0]);
        if !within(self.heights[0], place[0])
            || !within(self.heights[1], partner)
            || !within(self.gears[1].face(), place[1])
        {
            return None;
        }
        let jet = self.surface().jet(place[0], place[1]);
        // Normal speeds of both gears are equal on the contact line.
        let own = (jet.point.x * jet.normal.y - jet.point.y * jet.normal.x).abs();
        let arm = own * f64::from(self.gears[1].data().teeth) / f64::from(self.gears[0].data().teeth);
        let left = ease[0].jet(place[0], place[1]).f + ease[1].jet(partner, place[1]).f;
        Some([-left / arm, arm])
    }

    /// The least turn over the contact lines of all rolls, `positions` and what lies between them for each pitch of the first gear.
    pub fn course(&self, ease: [&dyn NormalOffset; 2], positions: usize) -> RollCourse {
        let sign = self.flank.sign();
        let lengths = equidistant(self.gears[0].face(), PLACES);
        let ends = lengths.iter().flat_map(|b| self.heights[0].map(|a| self.roll([a, *b])));
        let [from, to] = extremes(ends);
        let positions = BETWEEN * positions.max(1);
        let step = std::f64::consts::TAU / f64::from(self.gears[0].data().teeth) / positions as f64;
        let count = ((to - from) / step).ceil() as usize + 1;
        let least = |position: usize| {
            let roll = from + position as f64 * step;
            let on_line = lengths.iter().filter_map(|length| {
                let height = sign * (roll + self.line().angle(*length)) - self.offset();
                self.turn([height, *length], ease).map(|[turn, _]| turn)
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
