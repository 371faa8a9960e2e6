//! Threads of the worm and index strokes of the workpiece: which of them a run needs, and which strokes of a text serve them. A stroke is
//! identified by where it stands (its phase modulo 360 deg / z_1, its pitch on the workpiece), never by its place in the program.

use super::work::{DressingWork, GrindingWork};
use crate::workflow::stroke_plan::StrokePlan;
use foundation::kinematics::{DressingMotion, GeneratingMotion, Pose, Worm};
use foundation::numerics::equidistant;
use motion::ReadStroke;
use nalgebra::Vector3;
use std::collections::BTreeSet;
use std::f64::consts::TAU;
use verdict::Remark;

/// Threads and index strokes of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Indexing {
    /// Threads of the worm, those left out included.
    pub threads: u32,
    /// Teeth of the workpiece, negative for an internal gear.
    pub teeth: i32,
    /// Threads that are there, counted from 0 in the positive sense about the worm's axis.
    pub active: Vec<u32>,
    /// Offsets of the workpiece between the strokes of a pass, in pitches.
    pub offsets: Vec<u32>,
}

/// Places along a stroke at which it is compared with one of the job.
const PLACES: usize = 9;
/// Places a block, and most of them.
const PLACES_A_BLOCK: usize = 2;
const MOST_PLACES: usize = 10_000;
/// Two strokes of the job nearer to each other than this cannot be distinguished in a text, mm.
const SAME: f64 = 1e-4;
/// A stroke may leave a flank this far below the finished one before it is a fault of its own, mm: above what blocks and digits explain.
const TOO_DEEP: f64 = 5e-4;

impl Indexing {
    /// Every thread, one stroke; or those of a plan with threads left out.
    pub fn new(threads: u32, teeth: i32, plan: Option<&StrokePlan>) -> Self {
        match plan {
            Some(plan) => Self {
                threads,
                teeth,
                active: plan.active_threads.clone(),
                offsets: plan.index_pitches.clone(),
            },
            None => Self { threads, teeth, active: (0..threads).collect(), offsets: vec![0] },
        }
    }

    /// Angle between neighbouring threads, rad.
    fn pitch(&self) -> f64 {
        TAU / f64::from(self.threads)
    }

    /// A stroke in the space of a thread: the worm stands back by the angle at which the thread lies.
    pub fn on_thread(&self, work: &DressingWork, thread: u32) -> DressingWork {
        let angle = self.pitch() * f64::from(thread);
        let turn = Pose::<Worm, Worm>::rz(angle);
        let mut turned = work.clone();
        turned.motion.chain.worm_angle -= angle;
        for (point, normal) in &mut turned.contacts {
            *point = turn.rotation() * *point;
            *normal = turn.rotation() * *normal;
        }
        if self.active.len() > 1 {
            turned.name = format!("{} THREAD {} OF {}", work.name, thread + 1, self.threads);
        }
        turned
    }

    /// A stroke with the workpiece further by an offset.
    pub fn with_offset(&self, work: &GrindingWork, offset: u32) -> GrindingWork {
        let mut turned = work.clone();
        turned.phase += TAU * f64::from(offset);
        if self.offsets.len() > 1 {
            turned.name = format!("{} INDEX {offset}", work.name);
        }
        turned
    }

    /// Greatest common divisor of threads and teeth: offsets that differ by it are one.
    fn common_divisor(&self) -> i64 {
        let (mut a, mut b) = (i64::from(self.threads), i64::from(self.teeth.unsigned_abs()));
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a.max(1)
    }

    /// Tooth spaces that strokes with these offsets grind.
    fn spaces(&self, offsets: &BTreeSet<i64>) -> u32 {
        let g = self.common_divisor();
        let met: BTreeSet<i64> = self
            .active
            .iter()
            .flat_map(|&a| offsets.iter().map(move |o| (i64::from(a) + o).rem_euclid(g)))
            .collect();
        self.teeth.unsigned_abs() / g as u32 * met.len() as u32
    }

    /// Tooth spaces that finishing strokes grind.
    pub fn spaces_of(&self, ground: &[Served<GeneratingMotion>]) -> u32 {
        let offsets: BTreeSet<i64> = ground.iter().map(|served| i64::from(served.place)).collect();
        self.spaces(&offsets)
    }
}

/// A stroke of a text beside one of the job.
struct Beside<M> {
    stroke: ReadStroke<M>,
    /// Thread, or offset modulo the common divisor.
    place: i64,
    /// Least and largest stock that it leaves over the stroke of the job, mm.
    stock: [f64; 2],
}

impl<M> Beside<M> {
    fn apart(&self) -> f64 {
        let far = self.stock[0].abs().max(self.stock[1].abs());
        if far.is_nan() { f64::INFINITY } else { far }
    }
}

/// A finishing stroke of each stroke of the job at one place: a thread of the worm, an offset of the workpiece.
#[derive(Clone, Debug)]
pub struct Served<M> {
    /// Thread from 0, or offset in pitches.
    pub place: u32,
    /// One for each stroke of the job, brought back to thread 0.
    pub strokes: Vec<ReadStroke<M>>,
    /// How far they stand off those of the job at most, mm.
    pub apart: f64,
}

/// What was found in a text for all strokes of the job.
#[derive(Clone, Debug)]
pub struct Found<M> {
    /// Places at which every stroke of the job is there.
    pub served: Vec<Served<M>>,
    /// First and last block of a finishing stroke with the number of the job's stroke and its place.
    pub finishing: Vec<([usize; 2], usize, u32)>,
    /// What is missing, too much, or too deep.
    pub faults: Vec<Remark>,
}

/// Ranges of blocks as people read them.
pub fn shown_blocks(blocks: impl Iterator<Item = [usize; 2]>) -> String {
    let all: Vec<String> = blocks.map(|[from, to]| format!("{from} to {to}")).collect();
    if all.is_empty() { "none".into() } else { all.join(", ") }
}

/// Dressing strokes of a text by thread; `there` are its strokes on the chain of each stroke of the job.
pub fn dressed_threads(
    indexing: &Indexing,
    works: &[&DressingWork],
    there: Vec<Vec<ReadStroke<DressingMotion>>>,
) -> Found<DressingMotion> {
    let beside = works.iter().zip(there).map(|(work, there)| {
        there.into_iter().map(|stroke| beside_dressing(indexing, work, stroke)).collect()
    });
    let names: Vec<&str> = works.iter().map(|work| work.name.as_str()).collect();
    let named = |place: u32| format!("thread {} of {} of the worm", place + 1, indexing.threads);
    sorted(&names, beside.collect(), &indexing.active, named, "dressed")
}

/// Grinding strokes of a text by offset of the workpiece.
pub fn ground_offsets(
    indexing: &Indexing,
    works: &[&GrindingWork],
    there: Vec<Vec<ReadStroke<GeneratingMotion>>>,
) -> Found<GeneratingMotion> {
    let g = indexing.common_divisor();
    let all = indexing.active.len() == indexing.threads as usize;
    let beside = works.iter().zip(there).map(|(work, there)| {
        let of_stroke = |stroke: ReadStroke<GeneratingMotion>| {
            // Where every thread grinds, every offset grinds every space.
            let place = if all { 0 } else { stroke.index.rem_euclid(g) };
            Beside { place, stock: grinding_stock(work, &stroke), stroke }
        };
        there.into_iter().map(of_stroke).collect()
    });
    let names: Vec<&str> = works.iter().map(|work| work.name.as_str()).collect();
    let offsets: Vec<u32> = indexing.offsets.iter().map(|o| (i64::from(*o) % g) as u32).collect();
    let teeth = indexing.teeth.unsigned_abs();
    let named = |place: u32| {
        if all {
            format!("all {teeth} tooth spaces")
        } else {
            format!("the tooth spaces of index offset {place}")
        }
    };
    sorted(&names, beside.collect(), &offsets, named, "ground")
}

/// Places at which a stroke is compared with the job's: every block has some, so that none goes too deep unseen.
fn places_along<M>(stroke: &ReadStroke<M>) -> usize {
    let blocks = stroke.blocks[1].saturating_sub(stroke.blocks[0]) + 1;
    (PLACES_A_BLOCK * blocks).clamp(PLACES, MOST_PLACES)
}

fn beside_dressing(
    indexing: &Indexing,
    work: &DressingWork,
    mut stroke: ReadStroke<DressingMotion>,
) -> Beside<DressingMotion> {
    let from = stroke.range[0].max(work.interval[0]);
    let to = stroke.range[1].min(work.interval[1]);
    if from.partial_cmp(&to) != Some(std::cmp::Ordering::Less) {
        return Beside { stroke, place: 0, stock: [f64::INFINITY; 2] };
    }
    let middle = 0.5 * (from + to);
    let turned = stroke.motion.correction[0].value(middle) - work.motion.correction[0].value(middle);
    let threads = (-turned / indexing.pitch()).round();
    stroke.motion.correction[0] = stroke.motion.correction[0].raised(threads * indexing.pitch());
    let places = equidistant([from, to], places_along(&stroke));
    let stock =
        foundation::numerics::extremes(places.into_iter().flat_map(|v| dressing_stock(work, &stroke, v)));
    Beside { stroke, place: (threads as i64).rem_euclid(i64::from(indexing.threads)), stock }
}

/// What a stroke leaves at the contacts of the job's, mm: how far it stands off along the worm's normals.
pub fn dressing_stock(work: &DressingWork, stroke: &ReadStroke<DressingMotion>, v: f64) -> Vec<f64> {
    let moved = stroke.motion.position(v).pose().then(&work.motion.position(v).pose().inverse());
    let along =
        Pose::<Worm, Worm>::rz(-v / work.motion.chain.screw_parameter).then(&Pose::<Worm, Worm>::tz(-v));
    let left = |(point, normal): &(Vector3<f64>, Vector3<f64>)| {
        let p = along.rotation() * point + along.translation();
        let n = along.rotation() * normal;
        n.dot(&(moved.rotation() * p + moved.translation() - p))
    };
    work.contacts.iter().map(left).collect()
}

/// Least and largest stock that a stroke leaves over that of the job, mm.
fn grinding_stock(work: &GrindingWork, stroke: &ReadStroke<GeneratingMotion>) -> [f64; 2] {
    let from = stroke.range[0].max(work.feeds[0]);
    let to = stroke.range[1].min(work.feeds[1]);
    if from.partial_cmp(&to) != Some(std::cmp::Ordering::Less) {
        return [f64::INFINITY; 2];
    }
    foundation::numerics::extremes(equidistant([from, to], places_along(stroke)).into_iter().flat_map(|v| {
        let (is, wanted) = (&stroke.motion, &work.motion);
        let lifted = work.per_distance() * (is.delta_d.value(v) - wanted.delta_d.value(v));
        let turned = work.per_turn() * (is.delta_phi_2.value(v) - wanted.delta_phi_2.value(v)).abs();
        [lifted - turned, lifted + turned]
    }))
}

/// Sorts the strokes of a text to strokes of the job and places, and tells what is wrong with their number and depth.
fn sorted<M: Clone>(
    names: &[&str],
    beside: Vec<Vec<Beside<M>>>,
    places: &[u32],
    named: impl Fn(u32) -> String,
    done: &str,
) -> Found<M> {
    let mut found = Found { served: Vec::new(), finishing: Vec::new(), faults: Vec::new() };
    // How near the nearest stroke of the job is to each stroke of the text, by its blocks.
    let nearest = |blocks: [usize; 2]| {
        let all = beside.iter().flatten().filter(|b| b.stroke.blocks == blocks);
        all.map(Beside::apart).fold(f64::INFINITY, f64::min)
    };
    let mut chosen: Vec<Vec<Option<&Beside<M>>>> = vec![Vec::new(); names.len()];
    for (work, of_work) in beside.iter().enumerate() {
        let own: Vec<&Beside<M>> = of_work
            .iter()
            .filter(|b| b.apart().is_finite() && b.apart() <= nearest(b.stroke.blocks) + SAME)
            .collect();
        let at = |place: u32| own.iter().copied().filter(move |b| b.place == i64::from(place));
        let counts: Vec<usize> = places.iter().map(|&place| at(place).count()).collect();
        let usual = usual(&counts);
        for (&place, &count) in places.iter().zip(&counts) {
            let best = at(place).min_by(|a, b| a.apart().total_cmp(&b.apart()));
            chosen[work].push(best);
            if let Some(best) = best {
                found.finishing.push((best.stroke.blocks, work, place));
            }
            let blocks = shown_blocks(at(place).map(|b| b.stroke.blocks));
            if count == 0 {
                let others = shown_blocks(own.iter().map(|b| b.stroke.blocks));
                found.faults.push(Remark::new(
                    "stroke-missing",
                    format!("{}: {} not {done}; strokes are at blocks {others}", names[work], named(place)),
                    "add the stroke, or correct the index angle of the one that was meant",
                ));
            } else if count != usual {
                found.faults.push(Remark::new(
                    "stroke-count",
                    format!(
                        "{}: {} {done} by {count} strokes (blocks {blocks}), others by {usual}",
                        names[work],
                        named(place)
                    ),
                    "give every one the same strokes",
                ));
            }
            let deep = |b: &&Beside<M>| {
                best.is_some_and(|x| x.stroke.blocks != b.stroke.blocks) && b.stock[0] < -TOO_DEEP
            };
            for b in at(place).filter(deep) {
                found.faults.push(Remark::new(
                    "stroke-too-deep",
                    format!(
                        "{}: {}, the stroke at blocks {} goes {:.4} mm deeper than the finished flank",
                        names[work],
                        named(place),
                        shown_blocks(std::iter::once(b.stroke.blocks)),
                        -b.stock[0]
                    ),
                    "correct its infeed",
                ));
            }
        }
        let strays =
            own.iter().filter(|b| b.stock[0] < -TOO_DEEP && !places.iter().any(|&p| i64::from(p) == b.place));
        for b in strays {
            found.faults.push(Remark::new(
                "stroke-astray",
                format!(
                    "{}: the stroke at blocks {} stands at no place that the job has",
                    names[work],
                    shown_blocks(std::iter::once(b.stroke.blocks))
                ),
                "correct its index angle, or delete it",
            ));
        }
    }
    for (k, &place) in places.iter().enumerate() {
        let of_place: Option<Vec<&Beside<M>>> = chosen.iter().map(|of_work| of_work[k]).collect();
        if let Some(of_place) = of_place.filter(|all| !all.is_empty()) {
            found.served.push(Served {
                place,
                apart: of_place.iter().map(|b| b.apart()).fold(0.0, f64::max),
                strokes: of_place.into_iter().map(|b| b.stroke.clone()).collect(),
            });
        }
    }
    found
}

/// The count that most places have, the lower of two.
fn usual(counts: &[usize]) -> usize {
    let there: BTreeSet<usize> = counts.iter().copied().filter(|&n| n > 0).collect();
    let often = |n: usize| counts.iter().filter(|&&c| c == n).count();
    there.into_iter().fold(0, |best, n| if best == 0 || often(n) > often(best) { n } else { best })
}
