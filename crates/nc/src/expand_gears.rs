//! Gears as straight blocks, for controls that cannot couple axes (`docs/mathematics/programs.md#the-independent-reader`): the follower
//! gets the targets that its gear would give it. A coupling that is linear needs no more blocks than before; a table is met within
//! tolerances by chords.

use super::expand::{Chords, check_tolerances};
use super::{Block, Coupling, CurveTable, Gear, MAXIMUM_AXES, NcError, Program, Repetition, Targets, Word};
use std::collections::BTreeMap;

/// A gear that is on: the follower is `offset` plus the terms of its leaders.
struct Coupled<'a> {
    gear: &'a Gear,
    offset: f64,
}

struct Expansion<'a> {
    program: &'a Program,
    tolerances: &'a [f64],
    tables: BTreeMap<u32, &'a CurveTable>,
    defined: [Option<&'a Gear>; MAXIMUM_AXES],
    coupled: Vec<Coupled<'a>>,
    places: Targets,
    block: usize,
    blocks: Vec<Block>,
}

/// The program without gears and tables. Under a gear only straight blocks with a time can be expanded: [`super::subdivide`]
/// comes first where there are curves.
///
/// # Errors
/// `BadHeader` as in [`super::subdivide`]; `UnsupportedCoupling` for a gear that a spindle or another follower leads, and for rapid
/// blocks, curves and targets of the follower under a gear; `UnknownStart` if an axis of a gear stands nowhere;
/// `ToleranceNotReached`; those of [`Program::new`].
pub fn expand_gears(program: &Program, tolerances: &[f64]) -> Result<Program, NcError> {
    check_tolerances(program, tolerances)?;
    let mut expansion = Expansion {
        program,
        tolerances,
        tables: BTreeMap::new(),
        defined: [None; MAXIMUM_AXES],
        coupled: Vec::new(),
        places: Targets::NONE,
        block: 0,
        blocks: Vec::with_capacity(program.blocks().len()),
    };
    for (k, block) in program.blocks().iter().enumerate() {
        expansion.block = k + 1;
        expansion.block(block)?;
    }
    Program::new(program.header().clone(), expansion.blocks)
}

impl<'a> Expansion<'a> {
    fn refused(&self, reason: &'static str) -> NcError {
        NcError::UnsupportedCoupling { block: self.block, reason }
    }

    fn block(&mut self, block: &'a Block) -> Result<(), NcError> {
        match block {
            Block::Table(table) => {
                self.tables.insert(table.id, table);
            }
            Block::GearDefine(gear) => self.defined[gear.follower] = Some(gear),
            Block::GearOn { follower, synchronisation } => {
                let Some(gear) = self.defined[*follower] else { return Ok(()) };
                let stand = match synchronisation {
                    None => self.places,
                    Some(at) => {
                        let leaders = gear.leaders.iter().zip(&at.leaders);
                        let leaders =
                            leaders.fold(Targets::NONE, |all, (leader, &value)| all.with(leader.axis, value));
                        leaders.with(*follower, at.follower)
                    }
                };
                let offset = self.known(&stand, *follower)? - self.terms(gear, &stand)?;
                self.coupled.push(Coupled { gear, offset });
                if synchronisation.is_some() {
                    // The control goes to the synchronous position on its own.
                    let place = offset + self.terms(gear, &self.places)?;
                    self.places.set(*follower, place);
                    self.blocks.push(Block::Rapid(Targets::NONE.with(*follower, place)));
                }
            }
            Block::GearOff { follower } => self.coupled.retain(|coupled| coupled.gear.follower != *follower),
            Block::Linear { target, duration } => self.linear(target, *duration)?,
            Block::Rapid(_) | Block::Cubic(_) | Block::BSpline(_) if !self.coupled.is_empty() => {
                return Err(self.refused("under a gear only straight blocks with a time can be expanded"));
            }
            other => {
                match other {
                    Block::Rapid(target) => self.places.update(target),
                    Block::Cubic(motion) => {
                        for (axis, span) in &motion.spans {
                            self.places.set(*axis, span.end);
                        }
                    }
                    Block::BSpline(motion) => {
                        motion.points.iter().for_each(|point| self.places.update(point))
                    }
                    _ => {}
                }
                self.blocks.push(other.clone());
            }
        }
        Ok(())
    }

    fn known(&self, places: &Targets, axis: usize) -> Result<f64, NcError> {
        let name = self.program.axes()[axis].name.as_str();
        places.get(axis).ok_or(NcError::UnknownStart { block: self.block, axis: name.into() })
    }

    /// What the leaders add up to.
    fn terms(&self, gear: &Gear, places: &Targets) -> Result<f64, NcError> {
        let mut sum = 0.0;
        for leader in &gear.leaders {
            if let Word::Spindle(_) = self.program.axes()[leader.axis].word {
                return Err(self.refused("where a spindle leads, no target says where the follower is"));
            }
            if self.coupled.iter().any(|coupled| coupled.gear.follower == leader.axis) {
                return Err(self.refused("a follower that leads another gear is not expanded"));
            }
            let place = self.known(places, leader.axis)?;
            sum += match leader.coupling {
                Coupling::Ratio { num, den } => num / den * place,
                Coupling::Table(id) => self.tables.get(&id).map_or(0.0, |table| table.value(place)),
            };
        }
        Ok(sum)
    }

    fn linear(&mut self, target: &Targets, duration: f64) -> Result<(), NcError> {
        let from = self.places;
        let mut bent = false;
        for Coupled { gear, .. } in &self.coupled {
            if target.get(gear.follower).is_some() {
                return Err(self.refused("a target of the follower under its gear"));
            }
            let table = |coupling| matches!(coupling, Coupling::Table(_));
            bent |=
                gear.leaders.iter().any(|leader| table(leader.coupling) && target.get(leader.axis).is_some());
        }
        // Only couplings were coupled whose terms are known, so that they stay known.
        let at = |share: f64| {
            let between = target.iter().map(|(axis, to)| {
                let start = from.get(axis).unwrap_or(to);
                (axis, if share == 1.0 { to } else { start + share * (to - start) })
            });
            let mut moved = between.fold(Targets::NONE, |all, (axis, value)| all.with(axis, value));
            let mut places = from;
            places.update(&moved);
            for Coupled { gear, offset } in &self.coupled {
                let leads = gear.leaders.iter().any(|leader| target.get(leader.axis).is_some());
                if let (true, Ok(terms)) = (leads, self.terms(gear, &places)) {
                    moved.set(gear.follower, offset + terms);
                }
            }
            moved
        };
        let end = at(1.0);
        if bent {
            let borders = self.borders(target, &from);
            let chords = Chords { program: self.program, tolerances: self.tolerances, block: self.block, at };
            let mut blocks = Vec::new();
            chords.between(&borders, duration, &mut blocks)?;
            self.blocks.append(&mut blocks);
        } else {
            self.blocks.push(Block::Linear { target: end, duration });
        }
        self.places.update(&end);
        Ok(())
    }

    /// Shares of a block at which a table goes from one piece to the next, 0 and 1 among them.
    fn borders(&self, target: &Targets, from: &Targets) -> Vec<f64> {
        let mut borders = vec![0.0, 1.0];
        for leader in self.coupled.iter().flat_map(|coupled| &coupled.gear.leaders) {
            let Coupling::Table(id) = leader.coupling else { continue };
            let (Some(table), Some(start), Some(end)) =
                (self.tables.get(&id), from.get(leader.axis), target.get(leader.axis))
            else {
                continue;
            };
            let Some(last) = table.pieces.last().filter(|_| start != end) else { continue };
            let period = (last.leader - table.start[0]).abs();
            let (low, high) = (start.min(end), start.max(end));
            for knot in table.pieces.iter().map(|piece| piece.leader).chain([table.start[0]]) {
                // A table that is held has each border once; finer ones than a block can have are left to the halving.
                let turns = match table.repetition {
                    Repetition::Held => 0..=0,
                    _ => ((low - knot) / period).ceil() as i64..=((high - knot) / period).floor() as i64,
                };
                borders.extend(
                    turns.take(1 << 16).map(|turn| (knot + turn as f64 * period - start) / (end - start)),
                );
            }
        }
        borders.retain(|share| (0.0..=1.0).contains(share));
        borders.sort_by(f64::total_cmp);
        // Closer than this is the same border by rounding.
        borders.dedup_by(|next, before| *next - *before < 1e-9 && *next < 1.0);
        if borders.len() > 2 && 1.0 - borders[borders.len() - 2] < 1e-9 {
            borders.remove(borders.len() - 2);
        }
        borders
    }
}
