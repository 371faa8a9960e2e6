//! Curves of a Siemens program that take several lines: B-splines and curve tables.

use super::{OpenTable, Siemens, Spline};
use crate::reader::error::ReadProblem;
use crate::reader::machine::{Fault, Motion, inverse_time, span};
use crate::reader::scan::Decimal;
use crate::{BSplineMotion, Block, TablePiece};

impl Siemens<'_> {
    /// Closes the spline whose lines have been read.
    pub(super) fn end_spline(&mut self) {
        let Some(spline) = self.spline.take() else { return };
        let degree = spline.degree;
        let mut knots = vec![0.0; degree + 1];
        let mut knot = 0.0;
        for interval in &spline.intervals {
            knot += interval;
            knots.push(knot);
        }
        knots.push(knot);
        let motion = BSplineMotion { degree, points: spline.points, knots, duration: spline.duration };
        self.machine.blocks.push(Block::BSpline(Box::new(motion)));
    }

    pub(super) fn spline_line(&mut self) -> Result<(), Fault> {
        let degree = self.line.degree.and_then(Decimal::count).unwrap_or(3) as usize;
        if !(2..=3).contains(&degree) {
            return Err((ReadProblem::DegreeNotSupported, "SD=2 or SD=3"));
        }
        let interval = self.line.interval.map_or(1.0, Decimal::value);
        if !(0.0..=1e9).contains(&interval) {
            return Err((ReadProblem::OutOfRange, "PL from 0"));
        }
        let duration = inverse_time(self.line.feed.map(Decimal::value))?;
        let words = self.line.axes;
        let point = self.machine.go(&words)?;
        let spline = self.spline.get_or_insert(Spline {
            degree,
            points: Vec::new(),
            intervals: Vec::new(),
            duration: 0.0,
        });
        if spline.degree != degree {
            return Err((ReadProblem::Conflict, "the same SD in all lines of a spline"));
        }
        spline.points.push(point);
        spline.intervals.push(interval);
        spline.duration += duration;
        self.machine.motion = Motion::None;
        Ok(())
    }

    /// A motion line between CTABDEF and CTABEND.
    pub(super) fn table_line(&mut self) -> Result<(), Fault> {
        let Some(OpenTable { table, started, .. }) = &mut self.table else { return Ok(()) };
        let both = self.line.axes.has(table.leader) && self.line.axes.has(table.follower);
        if self.line.spline || !both {
            return Err((ReadProblem::Missing, "leader and follower in every line of a table"));
        }
        let bent = |axis: usize| self.line.coefficients.iter().find(|(of, ..)| *of == axis);
        if bent(table.leader).is_some_and(|&(_, a2, a3)| a2 != 0.0 || a3 != 0.0) {
            return Err((ReadProblem::DegreeNotSupported, "a leader that goes straight"));
        }
        let (a2, a3) = bent(table.follower).map_or((0.0, 0.0), |&(_, a2, a3)| (a2, a3));
        let (leader, follower) = (table.leader, table.follower);
        let words = self.line.axes;
        let target = self.machine.go(&words)?;
        let place = |axis| target.get(axis).unwrap_or_default();
        let end = place(follower);
        if *started {
            let before = table.pieces.last().map_or(table.start[1], |piece| piece.follower.end);
            let (a2, a3) = (self.machine.neutral(follower, a2), self.machine.neutral(follower, a3));
            let piece = TablePiece { leader: place(leader), follower: span(before, end, a2, a3) };
            table.pieces.push(piece);
        } else {
            if self.line.poly {
                return Err((ReadProblem::Missing, "a line G1 to the start of the table"));
            }
            table.start = [place(leader), end];
            *started = true;
        }
        Ok(())
    }
}
