//! Couplings as data (`docs/mathematics/gearbox.md#couplings`): an axis that follows others by ratios and tables. Knows no dialect.

use super::CubicSpan;

/// How one leading axis enters the follower.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Coupling {
    /// num/den units of the follower per unit of the leader, e.g. rad per mm. Two numbers, because a ratio of tooth numbers is
    /// exact as two integers only.
    Ratio {
        /// Numerator: 0, or 1e-12 to 1e13 of both signs.
        num: f64,
        /// Denominator: 1e-12 to 1e13 of both signs, within 1e15 times the numerator and back.
        den: f64,
    },
    /// By a table of this number, which must stand before.
    Table(u32),
}

/// One leading axis of a gear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GearLeader {
    /// Axis index.
    pub axis: usize,
    /// How the follower depends on it.
    pub coupling: Coupling,
}

/// The bodies behind a gear of one worm and one lead term, for controls that want those instead of ratios.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToothData {
    /// z_2, teeth of the workpiece.
    pub teeth: u32,
    /// Threads of the worm, negative if the workpiece turns the other way.
    pub threads: i32,
    /// m_n, mm; NaN in a program that was read and does not tell it.
    pub normal_module: f64,
    /// beta_2, rad; NaN in a program that was read and does not tell it.
    pub helix_angle: f64,
}

/// What a follower does once its gear is on: the sum over the leaders.
#[derive(Clone, Debug, PartialEq)]
pub struct Gear {
    /// Axis index.
    pub follower: usize,
    /// At least one, no axis twice, none the follower.
    pub leaders: Vec<GearLeader>,
    /// The bodies, if the ratios follow from them.
    pub teeth: Option<ToothData>,
}

/// Positions that belong to each other, mm or rad.
#[derive(Clone, Debug, PartialEq)]
pub struct GearSynchronisation {
    /// Of the follower.
    pub follower: f64,
    /// Of the leaders in the order of their gear.
    pub leaders: Vec<f64>,
}

/// What a table gives outside its range of the leader.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Repetition {
    /// The value at the border is held.
    Held,
    /// The leader repeats: the table starts again at the same follower.
    Leader,
    /// Both repeat: the follower goes on by its rise over one period.
    Both,
}

/// One piece of a table. The leader runs straight over u in 0..1, so that the follower is a cubic of the leader.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TablePiece {
    /// Leader at the end of the piece, mm or rad.
    pub leader: f64,
    /// Follower over the piece, mm or rad.
    pub follower: CubicSpan,
}

/// A follower as a function of one leader, piece by piece.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveTable {
    /// Number under which a gear names it.
    pub id: u32,
    /// Axis index.
    pub follower: usize,
    /// Axis index.
    pub leader: usize,
    /// Leader and follower at the start, mm or rad.
    pub start: [f64; 2],
    /// Pieces in the order of the leader, which rises or falls strictly.
    pub pieces: Vec<TablePiece>,
    /// What holds outside.
    pub repetition: Repetition,
}

impl CurveTable {
    /// Follower at a place of the leader; the start's follower if there is no piece.
    pub fn value(&self, leader: f64) -> f64 {
        let [from, base] = self.start;
        let Some(last) = self.pieces.last() else { return base };
        let period = last.leader - from;
        let turns = match self.repetition {
            Repetition::Held => 0.0,
            Repetition::Leader | Repetition::Both => ((leader - from) / period).floor(),
        };
        let rise = if self.repetition == Repetition::Both { turns * (last.follower.end - base) } else { 0.0 };
        let inside = leader - turns * period;
        let sign = period.signum();
        let index = self.pieces.partition_point(|piece| sign * piece.leader < sign * inside);
        let index = index.min(self.pieces.len() - 1);
        let [start, value] = match index.checked_sub(1) {
            Some(before) => [self.pieces[before].leader, self.pieces[before].follower.end],
            None => self.start,
        };
        let piece = &self.pieces[index];
        let u = ((inside - start) / (piece.leader - start)).clamp(0.0, 1.0);
        rise + piece.follower.value(value, u)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(repetition: Repetition, end: f64) -> CurveTable {
        let piece = |leader, end, start_slope, end_slope| TablePiece {
            leader,
            follower: CubicSpan { end, start_slope, end_slope },
        };
        let pieces = vec![piece(2.0, 1.0, 0.0, 0.0), piece(4.0, end, 0.0, 0.0)];
        CurveTable { id: 1, follower: 0, leader: 1, start: [0.0, 0.5], pieces, repetition }
    }

    #[test]
    fn outside_its_range_a_table_holds_repeats_or_goes_on() {
        let held = table(Repetition::Held, 2.0);
        assert_eq!((held.value(-1.0), held.value(9.0), held.value(2.0)), (0.5, 2.0, 1.0));
        assert!((held.value(1.0) - 0.75).abs() < 1e-15);
        let leader = table(Repetition::Leader, 0.5);
        assert!((leader.value(-3.0) - leader.value(1.0)).abs() < 1e-15);
        let both = table(Repetition::Both, 2.0);
        assert!((both.value(9.0) - both.value(1.0) - 3.0).abs() < 1e-14);
    }

    #[test]
    fn a_table_may_run_downwards() {
        let mut falling = table(Repetition::Held, 2.0);
        falling.pieces[0].leader = -2.0;
        falling.pieces[1].leader = -4.0;
        assert_eq!((falling.value(-2.0), falling.value(-9.0), falling.value(3.0)), (1.0, 2.0, 0.5));
        assert!((falling.value(-3.0) - 1.5).abs() < 1e-15);
    }
}
