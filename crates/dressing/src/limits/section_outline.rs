//! Thread space and swept dresser in a plane through the worm axis, as a picture shows them
//! (`docs/mathematics/dressing.md#limits-of-a-correction`).
//!
//! Every point of the dresser is screwed into that plane along the worm's lead, so that distances in it are those that the
//! clearances are made of: f is the axial distance at equal radius times sin(beta_b). Knows no drawing.

use crate::limits::dresser_pose::DresserPose;
use crate::limits::dresser_section::SectionCircle;
use crate::limits::swept_circle::FlankSweep;
use crate::{Clearance, DresserSection, DressingError, SectionPart, WormFlank};
use foundation::geometry::Sides;
use foundation::kinematics::DressingCorrection;
use foundation::numerics::{equidistant, extremes};
use std::f64::consts::PI;

/// What is shown of a worm: flanks, their used part, and the radii between which they are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShownWorm {
    /// Both flanks.
    pub flanks: Sides<WormFlank>,
    /// Threads removed between the flank that is dressed and the one across the space.
    pub left_out: u32,
    /// Root and outside radius of the worm, mm.
    pub radii: [f64; 2],
    /// Plane z = b whose thread space is shown, mm; immaterial on the worm that the dresser works on unless it is conical.
    pub b: f64,
}

/// Points [axial position, radius] in a plane through the worm axis, mm; the thread space lies around axial position 0.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionOutline {
    /// Flanks of the thread space from the root to the outside radius.
    pub space: Sides<Vec<[f64; 2]>>,
    /// Radii between which each flank is used.
    pub used_radii: Sides<[f64; 2]>,
    /// What the dresser sweeps, around its tip, as stretches that one part of its section leaves.
    pub dresser: Vec<(SectionPart, Vec<[f64; 2]>)>,
    /// Where the dresser comes closest to the used part of each flank, and both ends of that ray: on the dresser and on the
    /// flank.
    pub closest: Sides<Option<(Clearance, [[f64; 2]; 2])>>,
}

/// Radii, circles a part and angles; lines between them are straight to some micrometres.
const RADII: usize = 161;
const CIRCLES: usize = 61;
const ANGLES: usize = 121;
/// Places that differ by less belong to the same circle, mm.
const ROUNDING: f64 = 1e-9;
/// How far the dresser is shown above the worm, as a share of the depth of the space.
const ABOVE: f64 = 0.12;

/// A line [axial position, radius] in the plane that a part of the section leaves.
type PartLine = (SectionPart, Vec<[f64; 2]>);

impl DresserSection<'_> {
    /// The section at `dk` with a tip land, mm, against a worm: its own, or another one in the same place.
    ///
    /// # Errors
    /// As [`DresserSection::undermining`]; [`DressingError::InvalidNumber`] for radii that are not ascending or below the base
    /// cylinder.
    pub fn outline(
        &self,
        dk: &DressingCorrection,
        tip_land: f64,
        worm: &ShownWorm,
    ) -> Result<SectionOutline, DressingError> {
        self.check_land(tip_land)?;
        self.check_other(&worm.flanks, &[worm.b])?;
        let [root, outside] = worm.radii;
        let base = worm.flanks.left.flank.base_radius.max(worm.flanks.right.flank.base_radius);
        if !(root >= base && outside > root && outside.is_finite()) {
            return Err(DressingError::InvalidNumber {
                field: "root radius of the shown worm",
                value: root,
                allowed: "from the base cylinder to below the outside radius",
            });
        }
        self.check_left_out(worm.left_out)?;
        let (pose, number) = self.seat(dk)?;
        let sweeps = worm.flanks.map(|flank, shown| {
            let left_out = if flank == self.flank() { 0 } else { worm.left_out };
            let beyond = 2.0 * PI / shown.flank.teeth * f64::from(left_out);
            FlankSweep::new(pose, &shown.flank, shown.range, number, beyond, worm.b)
        });
        let middle = 0.5 * (root + outside);
        let centre = 0.5 * (sweeps.left.axial_position(middle) + sweeps.right.axial_position(middle));
        let placed = |[axial, radius]: [f64; 2]| [axial - centre, radius];
        let radii = equidistant([root, outside], RADII);
        let space =
            sweeps.map(|_, sweep| radii.iter().map(|&r| placed([sweep.axial_position(r), r])).collect());
        let closest = sweeps.map(|flank, sweep| {
            self.nearest_to(sweep, tip_land).map(|at| {
                let q = pose.point(&at.section_circle(), at.psi).0;
                let r = q[0].hypot(q[1]);
                let foot = worm.flanks[flank].flank.radius(at.w);
                (at, [[pose.axial_position(q), r], [sweep.axial_position(foot), foot]].map(placed))
            })
        });
        let ends = closest.iter().filter_map(|(_, at)| at.map(|(_, [dresser, _])| dresser[1]));
        let above = ends.fold(outside, f64::max) + ABOVE * (outside - root);
        let mut dresser = boundary(&self.lines(&pose, tip_land, above), above);
        for (_, line) in &mut dresser {
            line.iter_mut().for_each(|point| *point = placed(*point));
        }
        let used_radii = worm.flanks.map(|_, f| [f.range.w_nf, f.range.w_na].map(|w| f.flank.radius(w)));
        Ok(SectionOutline { space, used_radii, dresser, closest })
    }

    /// Lines on what the section sweeps up to an outside radius: circles, and the section at equal angles. The circles of each
    /// part come first.
    fn lines(&self, pose: &DresserPose, tip_land: f64, outside: f64) -> Vec<PartLine> {
        let shares = equidistant([0.0, 1.0], CIRCLES);
        let parts = SectionPart::ALL.map(|part| {
            let circle = |&share: &f64| self.circle_at(part, share, tip_land);
            (part, shares.iter().map(circle).collect::<Vec<_>>())
        });
        let arcs = parts.iter().flat_map(|(_, circles)| circles).filter_map(|c| pose.arc(c, outside));
        let [from, to] = extremes(arcs.flatten());
        if from >= to {
            return Vec::new();
        }
        // The same angles everywhere: neighbouring parts then have the circle between them in common.
        let angles = equidistant([from, to], ANGLES);
        let place = |circle: &SectionCircle, psi: f64| {
            let q = pose.point(circle, psi).0;
            [pose.axial_position(q), q[0].hypot(q[1])]
        };
        let mut lines: Vec<PartLine> = Vec::new();
        for (part, circles) in &parts {
            lines.extend(circles.iter().map(|c| (*part, angles.iter().map(|&psi| place(c, psi)).collect())));
            lines.extend(angles.iter().map(|&psi| (*part, circles.iter().map(|c| place(c, psi)).collect())));
        }
        lines
    }
}

/// Outermost place of one side at a radius, and what leaves it.
type Outermost = Option<(f64, SectionPart)>;

/// Boundary of all lines up to an outside radius: down the side of small axial positions, along the tip, up the other side.
fn boundary(lines: &[PartLine], outside: f64) -> Vec<PartLine> {
    let lowest = |line: &[[f64; 2]]| line.iter().copied().min_by(|a, b| a[1].total_cmp(&b[1]));
    let tip = lines.iter().filter(|(part, _)| *part == SectionPart::TipLand).take(CIRCLES);
    let mut tip: Vec<[f64; 2]> = tip.filter_map(|(_, line)| lowest(line)).collect();
    tip.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let (Some(&first), Some(&last)) = (tip.first(), tip.last()) else { return Vec::new() };
    let [deepest, _] = extremes(tip.iter().map(|p| p[1]));
    let radii = equidistant([deepest, outside], RADII);
    let step = radii[1] - radii[0];
    let mut sides: [Vec<Outermost>; 2] = [vec![None; RADII], vec![None; RADII]];
    for (part, line) in lines {
        for pair in line.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            let [low, high] = extremes([a[1], b[1]]);
            let from = ((low - deepest) / step).ceil().max(0.0) as usize;
            for (k, &r) in radii.iter().enumerate().skip(from).take_while(|(_, r)| **r <= high) {
                let share = if a[1] == b[1] { 0.0 } else { (r - a[1]) / (b[1] - a[1]) };
                let axial = a[0] + share * (b[0] - a[0]);
                for (side, sign) in sides.iter_mut().zip([-1.0, 1.0]) {
                    if side[k].is_none_or(|(outermost, _)| sign * axial > sign * outermost + ROUNDING) {
                        side[k] = Some((axial, *part));
                    }
                }
            }
        }
    }
    let above = |side: &[Outermost], end: f64| -> Vec<(SectionPart, [f64; 2])> {
        let places = side.iter().zip(&radii).filter(|(_, r)| **r > end);
        places.filter_map(|(at, &r)| at.map(|(axial, part)| (part, [axial, r]))).collect()
    };
    let down = above(&sides[0], first[1]).into_iter().rev();
    let along = tip.into_iter().map(|point| (SectionPart::TipLand, point));
    joined(down.chain(along).chain(above(&sides[1], last[1])))
}

/// Stretches of the same part; neighbours share a point.
fn joined(points: impl Iterator<Item = (SectionPart, [f64; 2])>) -> Vec<PartLine> {
    let mut lines: Vec<PartLine> = Vec::new();
    for (part, point) in points {
        match lines.last_mut() {
            Some((same, line)) if *same == part => line.push(point),
            Some((_, line)) => {
                line.push(point);
                lines.push((part, vec![point]));
            }
            None => lines.push((part, vec![point])),
        }
    }
    lines
}
