//! Lines, pitch and motions with which a narrow disc writes a worm flank (`docs/mathematics/dressing.md#conditions`).

use super::clearance::{Room, ThreadSpace, room};
use super::lines::{self, DressingLine};
use super::{RelativeForm, TipDisc, Touch};
use crate::DressingError;
use contact::{DiagonalLine, ModifiedThread, SurfaceJet, ThreadFunction, ToolSurface};
use foundation::geometry::{Flank, InvoluteFlank};
use foundation::kinematics::{DressingPath, DressingPosition, MotionLaw};
use foundation::numerics::equidistant;
use rayon::prelude::*;

/// A worm flank to be written line by line. mm, rad.
#[derive(Clone, Copy, Debug)]
pub struct LineDressing<'a, F: ThreadFunction> {
    /// The flank with its wanted modification f_n1(w_1, z_1).
    pub worm: ModifiedThread<'a, F>,
    /// The other flank of the thread space.
    pub counter: InvoluteFlank,
    /// Tip radius of the worm.
    pub worm_tip_radius: f64,
    /// The disc.
    pub disc: TipDisc,
    /// Crossing angle gamma_A, kept; nominally the disc lies along the thread.
    pub crossing_angle: f64,
    /// Offset v_yA, kept; nominally 0.
    pub offset: f64,
    /// Lengths of roll and positions to be written, `[[w_0, w_1], [z_0, z_1]]`; f_n1 must exist a little beyond.
    pub area: [[f64; 2]; 2],
    /// Direction rho_1 of the lines, free.
    pub direction: DiagonalLine,
    /// Height that the scallops between the lines may have.
    pub scallop: f64,
}

/// The lines that write a worm flank, and what they cost.
#[derive(Clone, Debug, PartialEq)]
pub struct LinePlan {
    /// Pitch p_X of the lines.
    pub pitch: f64,
    /// The lines in the order in which they are driven, every other one backwards.
    pub lines: Vec<DressingLine>,
    /// Greatest height of the scallops between them.
    pub scallop: f64,
    /// Length of the contact path on the worm flank, all lines of one thread together.
    pub length: f64,
    /// Least distance of the disc to the opposite flank.
    pub clearance: f64,
    /// Smallest radius of the worm that the rim reaches.
    pub deepest: f64,
    /// Nodes of a line's motion at which its spline holds [`LineDressing::MOTION_TOLERANCE`].
    pub nodes: usize,
}

/// The disc at a point of the worm flank.
struct Contact {
    jet: SurfaceJet,
    touch: Touch,
    form: RelativeForm,
}

/// Spacing of the points at which curvature is looked at, mm, and most of them a side.
const CURVATURE_SPACING: [f64; 2] = [0.5, 1.0];
const MOST_POINTS: [usize; 2] = [41, 257];
/// Positions at which the room in the thread space is looked at; along the worm only the modification changes.
const ROOM_POINTS: [usize; 2] = [13, 5];
/// The tip may stand in the dressed flank by this much beside its contact, mm: rounding of the closed distance to a flank that
/// is modified by some 0.05 mm.
const GOUGE: f64 = 2e-5;
/// More lines take days; the scallop height is then a mistake in the unit.
const MOST_LINES: f64 = 2e5;
/// Nodes of a line's motion that are tried.
const NODES: [usize; 6] = [9, 17, 33, 65, 129, 257];
/// Lines of the plan whose motions are measured.
const SAMPLED_LINES: usize = 7;
/// Intervals of Simpson's rule for the length of a line.
const LENGTH_INTERVALS: usize = 8;

impl<F: ThreadFunction> LineDressing<'_, F> {
    /// The spline through a line's positions leaves the worm flank by no more than this, mm.
    pub const MOTION_TOLERANCE: f64 = 1e-6;

    fn flank(&self) -> Flank {
        self.worm.flank.flank
    }

    fn contact(&self, w: f64, z: f64, near: f64) -> Result<Contact, DressingError> {
        let flank = self.flank();
        let jet = self.worm.jet(w, z).ok_or(DressingError::SurfaceUndefined { flank, w, z })?;
        let normal = jet.n / jet.n.norm();
        let touch = self.disc.touch(&jet.p, &normal, self.crossing_angle, self.offset, near);
        let touch = touch.ok_or(DressingError::DiscTouchesNot { flank, w, z })?;
        let form = RelativeForm::new(&jet, &self.disc, &touch);
        Ok(Contact { jet, touch, form })
    }

    /// Position of the disc that writes the point (w, z), phi_S in the turn nearest to `near`.
    ///
    /// # Errors
    /// [`DressingError::SurfaceUndefined`], [`DressingError::DiscTouchesNot`].
    pub fn touch(&self, w: f64, z: f64, near: f64) -> Result<Touch, DressingError> {
        self.contact(w, z, near).map(|contact| contact.touch)
    }

    /// Relative form of disc and worm at the point (w, z).
    ///
    /// # Errors
    /// As [`LineDressing::touch`].
    pub fn form(&self, w: f64, z: f64) -> Result<RelativeForm, DressingError> {
        self.contact(w, z, 0.0).map(|contact| contact.form)
    }

    /// Lines, their pitch and what limits them.
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`]; [`DressingError::TipRadiusTooLarge`] where the worm is hollower than the tip is
    /// round; [`DressingError::DiscCollides`] with the opposite flank, or with the dressed flank away from the contact; those
    /// of [`LineDressing::touch`].
    pub fn plan(&self) -> Result<LinePlan, DressingError> {
        self.check()?;
        let (across, overrun) = self.curvatures()?;
        let pitch = (8.0 * self.scallop / across).sqrt();
        let [from, to] = lines::coordinates(self.direction, self.area);
        if (to - from) / pitch > MOST_LINES {
            return Err(DressingError::InvalidNumber {
                field: "scallop height",
                value: self.scallop,
                allowed: "one that some 200 000 lines suffice for",
            });
        }
        let (pitch, lines) = lines::cover(self.direction, self.area, pitch, 0.5 * pitch * overrun);
        let rooms = self.rooms()?;
        let length = lines.par_iter().map(|line| self.length(line)).collect::<Result<Vec<f64>, _>>()?;
        let nodes = self.nodes(&lines)?;
        Ok(LinePlan {
            pitch,
            scallop: across * pitch * pitch / 8.0,
            length: length.iter().sum(),
            clearance: rooms.iter().map(|room| room.counter).fold(f64::INFINITY, f64::min),
            deepest: rooms.iter().map(|room| room.deepest).fold(f64::INFINITY, f64::min),
            nodes,
            lines,
        })
    }

    fn check(&self) -> Result<(), DressingError> {
        let invalid = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
        if !(self.scallop.is_finite() && self.scallop > 0.0) {
            return invalid("scallop height", self.scallop, "> 0 and finite");
        }
        for (field, value) in [
            ("crossing angle of the dresser", self.crossing_angle),
            ("offset of the dresser", self.offset),
            ("direction of the dressing lines", self.direction.rho),
            ("tip radius of the worm", self.worm_tip_radius),
        ] {
            if !value.is_finite() {
                return invalid(field, value, "a finite number");
            }
        }
        let [w, z] = self.area;
        for (field, [from, to], allowed) in [
            ("end of the lengths of roll to be dressed", w, "0 < start < end"),
            ("end of the worm to be dressed", z, "start < end"),
        ] {
            if !(from.is_finite() && to.is_finite() && to > from && w[0] > 0.0) {
                return invalid(field, to, allowed);
            }
        }
        Ok(())
    }

    /// Points of the area on a grid.
    fn grid(&self, counts: [usize; 2]) -> Vec<(f64, f64)> {
        let z = equidistant(self.area[1], counts[1]);
        let w = equidistant(self.area[0], counts[0]);
        w.into_iter().flat_map(|w| z.iter().map(move |&z| (w, z))).collect()
    }

    /// Greatest curvature across the lines, and by how much the contact moves along a line for a unit beside it.
    fn curvatures(&self) -> Result<(f64, f64), DressingError> {
        let counts = std::array::from_fn(|k| {
            let [from, to] = self.area[k];
            (((to - from) / CURVATURE_SPACING[k]).ceil() as usize + 1).clamp(5, MOST_POINTS[k])
        });
        let found = self
            .grid(counts)
            .into_par_iter()
            .map(|(w, z)| {
                let form = self.contact(w, z, 0.0)?.form;
                if !form.is_point_contact() {
                    let (flank, tip_radius) = (self.flank(), self.disc.tip_radius());
                    let largest = form.largest_tip_radius();
                    return Err(DressingError::TipRadiusTooLarge { flank, w, z, tip_radius, largest });
                }
                let [tt, tx, _] = form.along_lines(self.direction.rho);
                Ok((form.curvature_across(self.direction.rho), (tx / tt).abs()))
            })
            .collect::<Result<Vec<_>, _>>()?;
        Ok(found.into_iter().fold((0.0, 0.0), |(a, b), (c, d)| (f64::max(a, c), f64::max(b, d))))
    }

    fn rooms(&self) -> Result<Vec<Room>, DressingError> {
        let flank = self.flank();
        let space =
            ThreadSpace { own: self.worm.flank, counter: self.counter, tip_radius: self.worm_tip_radius };
        let modification = |w: f64, z: f64| self.worm.function.jet(w, z).map_or(0.0, |jet| jet.f);
        self.grid(ROOM_POINTS)
            .into_par_iter()
            .map(|(w, z)| {
                let contact = self.contact(w, z, 0.0)?;
                let found = room(&self.disc, &contact.touch, &contact.jet.p, &space, &modification);
                for (with, distance, allowed) in
                    [(self.counter.flank, found.counter, 0.0), (flank, found.own, -GOUGE)]
                {
                    if distance < allowed {
                        return Err(DressingError::DiscCollides { flank, w, z, with, depth: -distance });
                    }
                }
                Ok(found)
            })
            .collect()
    }

    /// Length of the contact path on the flank along a line (Simpson).
    fn length(&self, line: &DressingLine) -> Result<f64, DressingError> {
        let (sin, cos) = line.direction.rho.sin_cos();
        let step = (line.range[1] - line.range[0]) / LENGTH_INTERVALS as f64;
        let mut sum = 0.0;
        for (k, t) in equidistant(line.range, LENGTH_INTERVALS + 1).into_iter().enumerate() {
            let (w, z) = line.point(t);
            let flank = self.flank();
            let jet = self.worm.jet(w, z).ok_or(DressingError::SurfaceUndefined { flank, w, z })?;
            let weight = match k {
                0 | LENGTH_INTERVALS => 1.0,
                k if k % 2 == 1 => 4.0,
                _ => 2.0,
            };
            sum += weight * (jet.p_p * cos - jet.p_q * sin).norm();
        }
        Ok(sum * step / 3.0)
    }

    /// Positions of the disc at `nodes` equidistant places of a line, phi_S without jumps.
    ///
    /// # Errors
    /// As [`LineDressing::touch`].
    pub fn positions(
        &self,
        line: &DressingLine,
        nodes: usize,
    ) -> Result<Vec<(f64, DressingPosition)>, DressingError> {
        let mut near = 0.0;
        equidistant(line.range, nodes)
            .into_iter()
            .map(|t| {
                let (w, z) = line.point(t);
                let position = self.touch(w, z, near)?.position;
                near = position.worm_angle;
                Ok((t, position))
            })
            .collect()
    }

    /// The motion that writes a line: splines through the positions at `nodes` places.
    ///
    /// # Errors
    /// As [`LineDressing::touch`]; [`DressingError::InvalidNumber`] for fewer than four nodes.
    pub fn path(&self, line: &DressingLine, nodes: usize) -> Result<DressingPath, DressingError> {
        let invalid = |_| DressingError::InvalidNumber {
            field: "nodes of a dressing line",
            value: nodes as f64,
            allowed: "at least 4, over a line that has a length",
        };
        let positions = self.positions(line, nodes.max(2))?;
        let t: Vec<f64> = positions.iter().map(|(t, _)| *t).collect();
        let law = |of: fn(&DressingPosition) -> f64| {
            let values: Vec<f64> = positions.iter().map(|(_, at)| of(at)).collect();
            MotionLaw::spline(&t, &values).map_err(invalid)
        };
        Ok(DressingPath {
            domain: line.range,
            worm_angle: law(|at| at.worm_angle)?,
            worm_shift: law(|at| at.worm_shift)?,
            centre_distance: law(|at| at.centre_distance)?,
            crossing_angle: self.crossing_angle,
            offset: self.offset,
        })
    }

    /// Nodes with which the motions of a sample of lines keep to the flank.
    fn nodes(&self, lines: &[DressingLine]) -> Result<usize, DressingError> {
        let last = lines.len().saturating_sub(1);
        let sample: Vec<&DressingLine> =
            (0..SAMPLED_LINES.min(lines.len())).map(|k| &lines[k * last / (SAMPLED_LINES - 1)]).collect();
        for nodes in NODES {
            let missed = sample
                .par_iter()
                .map(|line| self.miss(line, nodes))
                .collect::<Result<Vec<f64>, _>>()?
                .into_iter()
                .fold(0.0, f64::max);
            if missed <= Self::MOTION_TOLERANCE {
                return Ok(nodes);
            }
        }
        let line =
            sample.first().map_or((0.0, 0.0), |line| line.point(0.5 * (line.range[0] + line.range[1])));
        Err(DressingError::LineTooRough { flank: self.flank(), w: line.0, z: line.1 })
    }

    /// By how much the torus leaves the flank midway between the nodes of a line's motion, mm.
    fn miss(&self, line: &DressingLine, nodes: usize) -> Result<f64, DressingError> {
        let path = self.path(line, nodes)?;
        let t = equidistant(line.range, nodes);
        let mut missed: f64 = 0.0;
        for pair in t.windows(2) {
            let t = 0.5 * (pair[0] + pair[1]);
            let (w, z) = line.point(t);
            let contact = self.contact(w, z, 0.0)?;
            let pose = path.position(t).pose().inverse();
            let x = pose.point(&foundation::kinematics::Point::from_vector(contact.jet.p)).xyz;
            let gap = (x.x.hypot(x.y) - self.disc.centre_radius()).hypot(x.z) - self.disc.tip_radius();
            missed = missed.max(gap.abs());
        }
        Ok(missed)
    }
}
