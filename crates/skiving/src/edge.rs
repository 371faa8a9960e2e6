//! The virtual edge: the rounding whose points make the finished flank, found so that its centres lie where the rake face wants them
//! (`docs/mathematics/skiving.md#the-virtual-edge`).

use super::pieces::pieces;
use super::{
    Conjugate, ContactPlace, EdgeSection, Kinematics, ProfilePlace, SkivedFlank, SkivingError, SkivingPair,
    conjugate, parallel_conjugate, parallel_turns,
};
use foundation::geometry::Flank;
use foundation::numerics::{Chebyshev, brent, wrapped_angle};
use nalgebra::Vector3;

/// Turns to both sides of the flank's rest position that are looked through, rad, and their number
/// (`docs/mathematics/skiving.md#the-virtual-edge`).
const REACH: f64 = 0.6;
const STEPS: usize = 600;
/// A root's distance from the rake face above which it is a pole, mm.
const ROOT: f64 = 1e-8;
/// Nodes of the centre curve: its coefficients have ended by then.
const NODES: usize = 25;
/// How often a piece is halved that its nodes do not resolve.
const HALVED: usize = 5;
/// What the identities may miss, and where an unresolved curve shows (`docs/mathematics/skiving.md#the-virtual-edge`: measured 1e-10 at
/// most).
const IDENTITY: f64 = 1e-8;
/// Way of the continuation from node to node, rad: first reach, and the largest before everything is looked through again.
const NEAR: f64 = 2e-3;
const FAR: f64 = 0.1;
/// First and last reach of the search for the height at which a shaping cutter's rake face stands, from its datum face, mm.
const FIRST_HEIGHT: f64 = 0.5;
const LAST_HEIGHT: f64 = 64.0;
/// Cutting speed along the rake normal below which the direction is ambiguous, mm/rad.
const SLOW: f64 = 1e-6;
/// The smallest lever that measures, mm/rad.
const LEVER: f64 = 0.1;

/// The rounded edge of tooth 0 that cuts one flank, with all that measuring asks of it.
#[derive(Clone, Debug)]
pub struct VirtualEdge {
    flank: SkivedFlank,
    pair: SkivingPair,
    nodes: Vec<ContactPlace>,
    pieces: Vec<EdgePiece>,
    cutting: f64,
}

/// A stretch of an edge on which everything is smooth: series over the length of roll.
#[derive(Clone, Debug)]
pub struct EdgePiece {
    range: [f64; 2],
    /// The centre curve c.
    pub centre: [Chebyshev; 3],
    /// The contact normal n_m.
    pub normal: [Chebyshev; 3],
    /// v of [`EdgeSection::growth`].
    pub growth: [Chebyshev; 3],
}

impl VirtualEdge {
    /// The edge that makes a flank. Where slope or bend of its modification jump, the edge ends and goes on in another piece.
    ///
    /// # Errors
    /// [`SkivingError::NoContact`], [`SkivingError::ContactOffRounding`], [`SkivingError::RoundingTooLarge`],
    /// [`SkivingError::CuttingDirectionAmbiguous`], [`SkivingError::LeverTooSmall`].
    pub fn new(pair: &SkivingPair, flank: SkivedFlank) -> Result<Self, SkivingError> {
        let mut edge =
            Self { pair: pair.clone(), nodes: Vec::new(), pieces: Vec::new(), cutting: 0.0, flank };
        for range in pieces(&edge.flank) {
            edge.append(range, 0)?;
        }
        edge.cutting = edge.cutting_sense()?;
        Ok(edge)
    }

    /// Goes on by a piece; one that its nodes do not resolve in two.
    fn append(&mut self, [from, to]: [f64; 2], halved: usize) -> Result<(), SkivingError> {
        let first = self.nodes.len();
        for w in Chebyshev::nodes(from, to, NODES) {
            let near = self.nodes.last().map(|place: &ContactPlace| {
                let (here, there) = (self.flank.at(w), self.flank.at(place.w));
                place.turn + rest_turn(&self.pair, &here) - rest_turn(&self.pair, &there)
            });
            let place = contact_place(&self.pair, &self.flank, w, near)?;
            self.nodes.push(place);
        }
        let nodes = &self.nodes[first..];
        let series = |of: &dyn Fn(&ContactPlace) -> Vector3<f64>| -> [Chebyshev; 3] {
            std::array::from_fn(|k| {
                let values: Vec<f64> = nodes.iter().map(|place| of(place)[k]).collect();
                Chebyshev::interpolate(from, to, &values)
            })
        };
        let (centre, normal) = (series(&|place| place.centre), series(&|place| place.normal));
        let mut piece = EdgePiece { range: [from, to], growth: centre.clone(), centre, normal };
        let sections: Result<Vec<_>, _> = nodes.iter().map(|at| self.checked_section(&piece, at)).collect();
        let sections = match sections {
            Err(SkivingError::NoContact { .. }) if halved < HALVED && self.flank.is_modified() => {
                self.nodes.truncate(first);
                let middle = 0.5 * (from + to);
                self.append([from, middle], halved + 1)?;
                return self.append([middle, to], halved + 1);
            }
            other => other?,
        };
        let growths: Vec<Vector3<f64>> = sections.iter().map(EdgeSection::growth).collect();
        piece.growth = std::array::from_fn(|k| {
            let values: Vec<f64> = growths.iter().map(|v| v[k]).collect();
            Chebyshev::interpolate(from, to, &values)
        });
        self.pieces.push(piece);
        Ok(())
    }

    /// Which flank of the workpiece it makes.
    pub fn side(&self) -> Flank {
        self.flank.helicoid().flank().flank
    }

    /// The flank that it makes.
    pub fn flank(&self) -> &SkivedFlank {
        &self.flank
    }

    /// Tool, workpiece and motion.
    pub fn pair(&self) -> &SkivingPair {
        &self.pair
    }

    /// Sense of the tool's rotation in which this edge cuts: +1 or -1.
    pub fn cutting_direction(&self) -> f64 {
        self.cutting
    }

    /// The smooth pieces of the edge, ascending.
    pub fn pieces(&self) -> &[EdgePiece] {
        &self.pieces
    }

    /// The piece at a length of roll; beyond the ends the nearest.
    pub fn piece(&self, w: f64) -> &EdgePiece {
        let after = self.pieces.partition_point(|piece| piece.range[1] < w);
        &self.pieces[after.min(self.pieces.len() - 1)]
    }

    /// The contact at a length of roll, solved anew.
    ///
    /// # Errors
    /// [`SkivingError::NoContact`].
    pub fn contact(&self, w: f64) -> Result<ContactPlace, SkivingError> {
        let nearest = self.nodes.iter().min_by(|a, b| (a.w - w).abs().total_cmp(&(b.w - w).abs()));
        let near = nearest.map(|place| {
            place.turn + rest_turn(&self.pair, &self.flank.at(w))
                - rest_turn(&self.pair, &self.flank.at(place.w))
        });
        contact_place(&self.pair, &self.flank, w, near)
    }

    /// The section of the edge at a length of roll, from the series.
    pub fn section(&self, w: f64) -> EdgeSection {
        self.section_in(self.piece(w), w)
    }

    fn section_in(&self, piece: &EdgePiece, w: f64) -> EdgeSection {
        let jets = piece.centre.each_ref().map(|series| series.jet(w));
        let at = |k: usize| Vector3::new(jets[0][k], jets[1][k], jets[2][k]);
        let normal = Vector3::from_fn(|k, _| piece.normal[k].value(w));
        self.section_at(at(0), at(1), &normal.normalize())
    }

    /// Speed of cutting along the rake normal at a contact, mm per radian of the tool; of a shaping cutter per mm of its stroke along +z.
    pub fn cutting_speed(&self, place: &ContactPlace) -> f64 {
        if self.pair.kinematics() == Kinematics::Shaping {
            let twist = self.pair.tool().twist();
            let stroke = Vector3::new(-twist * place.centre.y, twist * place.centre.x, 1.0);
            return stroke.dot(&self.pair.tool().rake().normal(&place.centre));
        }
        let velocity = self.pair.motion().velocity(&place.engagement);
        let in_tool = self.pair.motion().direction_to_tool(place.tool_angle, &velocity);
        in_tool.dot(&self.pair.tool().rake().normal(&place.centre))
    }

    fn section_at(&self, centre: Vector3<f64>, slope: Vector3<f64>, normal: &Vector3<f64>) -> EdgeSection {
        let tool = self.pair.tool();
        let rounding = tool.rounding();
        let tangent = slope.normalize();
        let rake_normal = tool.rake().normal(&centre);
        let across = tangent.cross(&rake_normal).normalize();
        let outward = if across.dot(normal) < 0.0 { -across } else { across };
        let twist = tool.twist();
        let helix = -Vector3::new(-twist * centre.y, twist * centre.x, 1.0).normalize();
        let along = (helix - normal * helix.dot(normal)).normalize();
        let (sin, cos) = rounding.clearance_angle.sin_cos();
        let ruling = along * cos - normal * sin;
        let clearance = tangent.cross(&ruling).normalize();
        let clearance_normal = if clearance.dot(normal) < 0.0 { -clearance } else { clearance };
        let clearance_angle = clearance_normal.dot(&outward).atan2(clearance_normal.dot(&rake_normal));
        EdgeSection {
            centre,
            tangent,
            rake_normal,
            outward,
            clearance_normal,
            ruling,
            contact_angle: normal.dot(&outward).atan2(normal.dot(&rake_normal)),
            clearance_angle,
            range: [rounding.rake_chamfer_angle, clearance_angle - rounding.clearance_chamfer_angle],
        }
    }

    /// The section at a node, if it stands up to everything that is known of it.
    fn checked_section(&self, piece: &EdgePiece, place: &ContactPlace) -> Result<EdgeSection, SkivingError> {
        let w = place.w;
        let section = self.section_in(piece, w);
        let radius = self.pair.tool().rounding().radius;
        let jets = piece.centre.each_ref().map(|series| series.jet(w));
        let [first, second] = [1, 2].map(|k| Vector3::new(jets[0][k], jets[1][k], jets[2][k]));
        let curvature = first.cross(&second).norm() / first.norm().powi(3);
        if radius * curvature >= 1.0 {
            return Err(SkivingError::RoundingTooLarge { w, radius, curvature_radius: 1.0 / curvature });
        }
        let off =
            section.tangent.dot(&place.normal).abs().max(section.tangent.dot(&section.rake_normal).abs());
        if off.is_nan() || off > IDENTITY {
            return Err(SkivingError::NoContact { w });
        }
        let (angle, [least, greatest]) = (section.contact_angle, section.range);
        // A sharp edge has no rounding to be on.
        if radius > 0.0 && !(least <= angle && angle <= greatest) {
            return Err(SkivingError::ContactOffRounding { w, angle, least, greatest });
        }
        if place.lever.abs() < LEVER {
            return Err(SkivingError::LeverTooSmall { w, lever: place.lever });
        }
        Ok(section)
    }

    fn cutting_sense(&self) -> Result<f64, SkivingError> {
        let mut sense = 0.0;
        for place in &self.nodes {
            let speed = self.cutting_speed(place);
            if speed.is_nan() || speed.abs() < SLOW || speed * sense < 0.0 {
                return Err(SkivingError::CuttingDirectionAmbiguous { w: place.w, speed });
            }
            sense = speed.signum();
        }
        Ok(sense)
    }
}

impl EdgePiece {
    /// From which length of roll to which it reaches, mm.
    pub fn range(&self) -> [f64; 2] {
        self.range
    }
}

/// Turn that brings a place of the profile to the centre line.
fn rest_turn(pair: &SkivingPair, place: &ProfilePlace) -> f64 {
    pair.motion().work_angle + place.point.x.atan2(place.point.y)
}

/// The contact at a length of roll: near a turn if it is there, otherwise the one among all with the least turn of the tool.
fn contact_place(
    pair: &SkivingPair,
    flank: &SkivedFlank,
    w: f64,
    near: Option<f64>,
) -> Result<ContactPlace, SkivingError> {
    let place = flank.at(w);
    let centre_of = |found: &Conjugate| {
        let q = found.point + found.normal * pair.tool().rounding().radius;
        pair.motion().to_tool(found.tool_angle, &q)
    };
    let depth = pair.tool().rounding().depth();
    let off = |found: &Conjugate| pair.tool().rake().distance(&centre_of(found)) + depth;
    let (turn, found) = match pair.kinematics() {
        Kinematics::Skiving => {
            let off = |turn: f64| off(&conjugate(pair.motion(), &place, turn));
            let turn = near
                .and_then(|turn| near_root(turn, &off))
                .or_else(|| root_of_all(pair, &place, &off))
                .ok_or(SkivingError::NoContact { w })?;
            (turn, conjugate(pair.motion(), &place, turn))
        }
        Kinematics::Shaping => shaped(pair, &place, near, &off).ok_or(SkivingError::NoContact { w })?,
    };
    let motion = pair.motion();
    let to_tool = |v: &Vector3<f64>| motion.direction_to_tool(found.tool_angle, v);
    let point = motion.to_tool(found.tool_angle, &found.point);
    let normal = -to_tool(&found.normal);
    let helix = Vector3::new(-motion.twist * found.point.y, motion.twist * found.point.x, 1.0).normalize();
    Ok(ContactPlace {
        w,
        modification: place.modification,
        turn,
        tool_angle: found.tool_angle,
        engagement: found.point,
        work_normal: found.normal,
        point,
        normal,
        flank_direction: to_tool(&helix),
        centre: centre_of(&found),
        lever: point.x * normal.y - point.y * normal.x,
    })
}

/// The contact of a shaping cutter: the turn by the rolling, the height by the rake face.
fn shaped(
    pair: &SkivingPair,
    place: &ProfilePlace,
    near: Option<f64>,
    off: &impl Fn(&Conjugate) -> f64,
) -> Option<(f64, Conjugate)> {
    let motion = pair.motion();
    let turns = parallel_turns(motion, place)?.map(|turn| {
        // In the turn of the rest position.
        let rest = rest_turn(pair, place);
        rest + wrapped_angle(turn - rest)
    });
    let away = |turn: &f64| match near {
        Some(near) => (turn - near).abs(),
        None => (motion.tool_angle_at(*turn) - motion.tool_angle).abs(),
    };
    let turn = turns.into_iter().min_by(|a, b| away(a).total_cmp(&away(b)))?;
    let at = |height: f64| parallel_conjugate(motion, place, turn, height);
    let off = |height: f64| off(&at(height));
    let mut reach = FIRST_HEIGHT;
    while reach <= LAST_HEIGHT {
        let ends = [motion.tool_shift - reach, motion.tool_shift + reach];
        let values = ends.map(off);
        if values[0] * values[1] <= 0.0 {
            return Some((turn, at(root_between(ends, values, &off)?)));
        }
        reach *= 2.0;
    }
    None
}

/// A root in the neighbourhood of a turn, in which nothing else changes its sign.
fn near_root(turn: f64, off: &impl Fn(f64) -> f64) -> Option<f64> {
    let mut reach = NEAR;
    while reach <= FAR {
        let (a, b) = (turn - reach, turn + reach);
        let (at_a, at_b) = (off(a), off(b));
        if at_a * at_b <= 0.0 {
            return root_between([a, b], [at_a, at_b], off);
        }
        reach *= 4.0;
    }
    None
}

fn root_between(ends: [f64; 2], values: [f64; 2], off: &impl Fn(f64) -> f64) -> Option<f64> {
    let root = brent(ends, values, 0.0, |turn| Some(off(turn)))?;
    (off(root).abs() < ROOT).then_some(root)
}

/// Of all roots the one with the least turn of the tool away from its middle position.
fn root_of_all(pair: &SkivingPair, place: &ProfilePlace, off: &impl Fn(f64) -> f64) -> Option<f64> {
    let base = rest_turn(pair, place);
    let at = |k: usize| base - REACH + 2.0 * REACH * k as f64 / STEPS as f64;
    let away = |turn: f64| {
        let found = conjugate(pair.motion(), place, turn);
        (found.tool_angle - pair.motion().tool_angle).abs()
    };
    let mut best: Option<f64> = None;
    let mut before = off(at(0));
    for k in 1..=STEPS {
        let value = off(at(k));
        if before * value <= 0.0
            && let Some(root) = root_between([at(k - 1), at(k)], [before, value], off)
            && best.is_none_or(|known| away(root) < away(known))
        {
            best = Some(root);
        }
        before = value;
    }
    best
}
