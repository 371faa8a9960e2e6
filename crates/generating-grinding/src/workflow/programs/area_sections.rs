//! Laws of dressing over a worm with several areas: what they are in each of them, and how the dresser goes from one to the next.

use foundation::kinematics::{LawError, MotionLaw};
use foundation::numerics::{Chebyshev, equidistant};

/// Points of a law over an area, and over the passage to another.
const POINTS: [usize; 2] = [513, 65];
/// Least way from one area to the next, mm.
const LEAST_PASSAGE: f64 = 1.0;
/// Distance of the points where the dresser stands still, mm.
const APART: f64 = 2.0;

/// How the worm positions of a roughing area lie against those of the plan, v' = planned + slope (v - own), mm, and the share of what the
/// plan changes along the worm that it has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Middle of the area.
    pub own: f64,
    /// Middle of what the plan uses.
    pub planned: f64,
    /// How much faster the plan's positions run.
    pub slope: f64,
    /// Share.
    pub share: f64,
}

/// Least nodes of a correction over an area, and nodes for each of the plan's own: beyond the plan's interval laws go on along their tangent.
const NODES: [usize; 2] = [64, 2];

impl Stretch {
    /// Corrections of the plan as this area has them over worm positions from and to, mm.
    pub fn corrections(&self, planned: &[Chebyshev; 4], [from, to]: [f64; 2]) -> [Chebyshev; 4] {
        let (first, last) = planned[0].interval();
        let section = Section { needed: [from, to], range: [from, to], place: Place::Roughing(*self) };
        planned.each_ref().map(|series| {
            let (law, constant) = (MotionLaw::series(series.clone()), series.value(0.5 * (first + last)));
            let nodes = Chebyshev::nodes(from, to, NODES[0].max(NODES[1] * series.coefficients().len()));
            let values: Vec<f64> =
                nodes.into_iter().map(|v| section.value(&law, [first, last], constant, v)).collect();
            Chebyshev::interpolate(from, to, &values)
        })
    }
}

/// What a stretch of the worm is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Place {
    /// As the plan has it, moved along by so much, mm.
    Finishing(f64),
    /// A roughing area.
    Roughing(Stretch),
}

/// A stretch of v_zS that is dressed as one area.
#[derive(Clone, Copy, Debug)]
pub(super) struct Section {
    /// What its strokes use.
    pub needed: [f64; 2],
    /// Over which it is dressed so.
    pub range: [f64; 2],
    /// What it is.
    pub place: Place,
}

impl Section {
    /// A law of the plan in it; beyond the range `driven` of the plan it goes on along its tangent. `constant`: where the dresser stands in the
    /// middle of the plan.
    fn value(&self, law: &MotionLaw, driven: [f64; 2], constant: f64, v: f64) -> f64 {
        let planned = |at: f64| {
            let inside = at.clamp(driven[0], driven[1]);
            let [value, slope, _] = law.jet(inside);
            value + slope * (at - inside)
        };
        match self.place {
            Place::Finishing(by) => planned(v - by),
            Place::Roughing(stretch) => {
                let at = stretch.planned + stretch.slope * (v - stretch.own);
                constant + stretch.share * (planned(at) - constant)
            }
        }
    }
}

/// The stretches of all areas by v_zS, each with the margin that is driven, and between two of them a passage; `None` where a passage has no
/// room.
pub(super) fn sections(mut sections: Vec<Section>, passage: f64) -> Option<Vec<Section>> {
    sections.sort_by(|a, b| a.needed[0].total_cmp(&b.needed[0]));
    for k in 1..sections.len() {
        let (end, begin) = (sections[k - 1].needed[1], sections[k].needed[0]);
        let room = begin - end;
        if room <= LEAST_PASSAGE {
            return None;
        }
        let (middle, half) = (0.5 * (end + begin), 0.5 * room.min(passage));
        sections[k - 1].range[1] = sections[k - 1].range[1].min(middle - half);
        sections[k].range[0] = sections[k].range[0].max(middle + half);
    }
    Some(sections)
}

/// From 1 to 0 over 0 .. 1, with two continuous derivatives.
fn falling(u: f64) -> f64 {
    1.0 - u * u * u * (10.0 + u * (6.0 * u - 15.0))
}

/// A law of the range `driven` in every section, from one to the next over a passage, and on over `whole`: over a passage to a constant
/// value. Two derivatives are continuous.
pub(super) fn extended(
    law: &MotionLaw,
    driven: [f64; 2],
    sections: &[Section],
    whole: [f64; 2],
    (constant, passage): (f64, f64),
) -> Result<MotionLaw, LawError> {
    let (Some(first), Some(last)) = (sections.first(), sections.last()) else { return Ok(law.clone()) };
    let own = [first.range[0], last.range[1]];
    let tangent = |section: &Section, v: f64| section.value(law, driven, constant, v);
    let value = |v: f64| {
        let next = sections.partition_point(|section| section.range[1] < v);
        let Some(section) = sections.get(next) else {
            let share = falling(((v - own[1]) / passage).min(1.0));
            return constant + share * (tangent(last, v) - constant);
        };
        if v >= section.range[0] {
            return tangent(section, v);
        }
        let Some(before) = next.checked_sub(1).map(|k| &sections[k]) else {
            let share = falling(((own[0] - v) / passage).min(1.0));
            return constant + share * (tangent(first, v) - constant);
        };
        let share = falling((v - before.range[1]) / (section.range[0] - before.range[1]));
        share * tangent(before, v) + (1.0 - share) * tangent(section, v)
    };
    let mut x: Vec<f64> = Vec::new();
    for (k, section) in sections.iter().enumerate() {
        if k > 0 {
            let between = equidistant([sections[k - 1].range[1], section.range[0]], POINTS[1]);
            x.extend(&between[1..between.len() - 1]);
        }
        x.extend(equidistant(section.range, POINTS[0]));
    }
    for (end, sense) in [(0, -1.0), (1, 1.0)] {
        let length = sense * (whole[end] - own[end]);
        if length <= 0.0 {
            continue;
        }
        let near = length.min(passage);
        x.extend(equidistant([0.0, near], POINTS[1]).into_iter().skip(1).map(|d| own[end] + sense * d));
        if length > near {
            let far = ((length - near) / APART).ceil() as usize;
            x.extend((1..=far).map(|k| own[end] + sense * (near + (length - near) * k as f64 / far as f64)));
        }
    }
    x.sort_by(f64::total_cmp);
    let y: Vec<f64> = x.iter().map(|&v| value(v)).collect();
    MotionLaw::spline(&x, &y)
}
