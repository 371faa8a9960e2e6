//! The verdict on the lines of a text: whether every line is on every thread, how far each is off, and what the referee's rays find.

use super::find::{FoundLines, TextLine};
use super::work::LineWork;
use crate::workflow::line_dressing::LineSample;
use crate::workflow::programs::indexing::Indexing;
use foundation::kinematics::DressingPath;
use foundation::numerics::{Silent, extremes};
use verdict::Remark;

/// One thread as a text writes it. mm, s.
#[derive(Clone, Debug)]
pub struct WrittenThread {
    /// Its number, from 0.
    pub thread: u32,
    /// First and last block of its finishing lines.
    pub blocks: [usize; 2],
    /// Lines that are there.
    pub lines: usize,
    /// Time of these lines.
    pub duration: f64,
    /// Worm positions v_zS from where to where.
    pub shifts: [f64; 2],
    /// Least and largest height of a line over that of the job, each with its line and blocks.
    pub height: [Off; 2],
    /// Largest distance across the lines.
    pub across: f64,
    /// Least and largest height over the wanted flank on the referee's rays; `None` where a line is missing that they need.
    pub over: Option<[f64; 2]>,
    /// Largest difference of a ray from that of the run.
    pub difference: f64,
}

/// How far a line is off, and which one.
#[derive(Clone, Copy, Debug)]
pub struct Off {
    pub by: f64,
    /// Line, from 0.
    pub line: usize,
    pub blocks: [usize; 2],
}

/// What a text makes of a flank.
#[derive(Clone, Debug)]
pub struct JudgedLines {
    /// Threads with at least one line, in ascending order.
    pub threads: Vec<WrittenThread>,
    /// What is missing, too much, too short or in the way.
    pub faults: Vec<Remark>,
}

/// A stroke before the finishing one may go below it by this, mm: above what blocks and digits explain.
const TOO_DEEP: f64 = 5e-4;
/// A line may end short of the job's by this, mm: far less than it runs over the ends of the area.
const SHORT: f64 = 5e-3;
/// A line may lie beside its place by this share of the pitch; the scallop beside it grows by twice that share.
const ASIDE: f64 = 0.1;

/// Counts the lines of every active thread, tells those that are off their place, and puts the referee's rays on what they leave.
pub fn judge(work: &LineWork<'_>, indexing: &Indexing, found: &FoundLines) -> JudgedLines {
    let count = work.count();
    let mut judged = JudgedLines { threads: Vec::new(), faults: found.faults.clone() };
    let mut by_thread: Vec<(u32, Vec<Vec<&TextLine>>)> =
        indexing.active.iter().map(|&thread| (thread, vec![Vec::new(); count])).collect();
    let mut left_out: Vec<&TextLine> = Vec::new();
    for line in &found.lines {
        match by_thread.iter_mut().find(|(thread, _)| *thread == line.thread) {
            Some((_, lines)) => lines[line.line].push(line),
            None => left_out.push(line),
        }
    }
    if let (Some(first), Some(last)) = (left_out.first(), left_out.last()) {
        judged.faults.push(Remark::new(
            "line-astray",
            format!(
                "blocks {} to {}: {} lines on threads of the worm that the job leaves out, the first on thread {}",
                first.blocks[0],
                last.blocks[1],
                left_out.len(),
                first.thread + 1
            ),
            "correct the index angle",
        ));
    }
    let times = by_thread.iter().flat_map(|(_, lines)| lines.iter().map(Vec::len));
    let usual = usual(&times.filter(|&times| times > 0).collect::<Vec<_>>());
    for (thread, lines) in &by_thread {
        let named =
            format!("thread {} of {} of the worm, {} flank", thread + 1, indexing.threads, work.flank);
        let missing: Vec<usize> = (0..count).filter(|&k| lines[k].is_empty()).collect();
        if !missing.is_empty() {
            judged.faults.push(Remark::new(
                "line-missing",
                format!("{named}: {} of {count} lines are not written: {}", missing.len(), numbers(&missing)),
                "write these lines, or correct the index angle and the depth of those that were meant",
            ));
        }
        let uneven: Vec<usize> =
            (0..count).filter(|&k| !lines[k].is_empty() && lines[k].len() != usual).collect();
        if let Some(&one) = uneven.first() {
            judged.faults.push(Remark::new(
                "line-count",
                format!(
                    "{named}: {} lines are driven more or less often than the others ({usual} times): {} (blocks {})",
                    uneven.len(),
                    numbers(&uneven),
                    blocks(lines[one].iter().map(|line| line.blocks))
                ),
                "drive all lines alike",
            ));
        }
        let mut finishing: Vec<&TextLine> = Vec::with_capacity(count);
        for of_line in lines {
            let off = |line: &&&TextLine| line.height[0].abs().max(line.height[1].abs());
            let Some(&best) = of_line.iter().min_by(|a, b| off(a).total_cmp(&off(b))) else { continue };
            for deep in of_line.iter().filter(|line| line.blocks != best.blocks && line.height[0] < -TOO_DEEP)
            {
                judged.faults.push(Remark::new(
                    "line-too-deep",
                    format!(
                        "{named}: a stroke on line {} (blocks {}) goes {:.4} mm deeper than the finished flank",
                        deep.line + 1,
                        blocks([deep.blocks]),
                        -deep.height[0]
                    ),
                    "correct its infeed",
                ));
            }
            finishing.push(best);
        }
        let short = finishing.iter().filter(|line| line.short > SHORT);
        if let Some(line) = short.max_by(|a, b| a.short.total_cmp(&b.short)) {
            judged.faults.push(Remark::new(
                "line-short",
                format!(
                    "{named}: line {} (blocks {}) ends {:.3} mm short",
                    line.line + 1,
                    blocks([line.blocks]),
                    line.short
                ),
                "drive the line to its end",
            ));
        }
        let aside = finishing.iter().filter(|line| line.across > ASIDE * work.written.plan.pitch);
        if let Some(line) = aside.max_by(|a, b| a.across.total_cmp(&b.across)) {
            judged.faults.push(Remark::new(
                "line-astray",
                format!(
                    "{named}: line {} (blocks {}) lies {:.4} mm beside its place; the lines are {:.4} mm apart",
                    line.line + 1,
                    blocks([line.blocks]),
                    line.across,
                    work.written.plan.pitch
                ),
                "correct its position, or give the control more decimals",
            ));
        }
        judged.threads.extend(written_thread(work, *thread, &finishing));
    }
    judged
}

fn written_thread(work: &LineWork<'_>, thread: u32, lines: &[&TextLine]) -> Option<WrittenThread> {
    let off =
        |line: &&TextLine, which: usize| Off { by: line.height[which], line: line.line, blocks: line.blocks };
    let lowest = lines.iter().map(|line| off(line, 0)).min_by(|a, b| a.by.total_cmp(&b.by))?;
    let highest = lines.iter().map(|line| off(line, 1)).max_by(|a, b| a.by.total_cmp(&b.by))?;
    let paths: Vec<DressingPath> = lines.iter().map(|line| line.path.clone()).collect();
    let sample = &work.written.sample;
    let rays = LineSample::over(&sample.grid, &work.written.bodies, &paths, &Silent).ok();
    let difference = rays.as_ref().map_or(f64::INFINITY, |(over, _)| {
        let apart = over.iter().zip(&sample.over).map(|(a, b)| (a - b).abs());
        apart.fold(0.0, |most: f64, x| if x.is_nan() { f64::INFINITY } else { most.max(x) })
    });
    Some(WrittenThread {
        thread,
        blocks: [
            lines.iter().map(|line| line.blocks[0]).min()?,
            lines.iter().map(|line| line.blocks[1]).max()?,
        ],
        lines: lines.len(),
        duration: lines.iter().map(|line| line.duration).sum(),
        shifts: extremes(lines.iter().flat_map(|line| line.shifts)),
        height: [lowest, highest],
        across: lines.iter().map(|line| line.across).fold(0.0, f64::max),
        over: rays.map(|(over, _)| extremes(over)),
        difference,
    })
}

/// Ranges of lines, counted from 1: "3, 7 to 12, .."
fn numbers(lines: &[usize]) -> String {
    const MOST: usize = 6;
    let mut ranges: Vec<[usize; 2]> = Vec::new();
    for &line in lines {
        match ranges.last_mut() {
            Some(range) if range[1] + 1 == line => range[1] = line,
            _ => ranges.push([line, line]),
        }
    }
    let shown = |[from, to]: &[usize; 2]| {
        if from == to { format!("{}", from + 1) } else { format!("{} to {}", from + 1, to + 1) }
    };
    let mut texts: Vec<String> = ranges.iter().take(MOST).map(shown).collect();
    if ranges.len() > MOST {
        texts.push(format!("and {} more places", ranges.len() - MOST));
    }
    texts.join(", ")
}

/// Blocks in words.
pub fn blocks(all: impl IntoIterator<Item = [usize; 2]>) -> String {
    let all: Vec<String> = all.into_iter().map(|[from, to]| format!("{from} to {to}")).collect();
    all.join(", ")
}

/// The count that most lines have, the lower of two.
fn usual(times: &[usize]) -> usize {
    let most = times.iter().copied().max().unwrap_or(0);
    let often = |n: usize| times.iter().filter(|&&x| x == n).count();
    (1..=most).fold(0, |best, n| if best == 0 || often(n) > often(best) { n } else { best })
}
