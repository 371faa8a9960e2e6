//! From the motions of a run to programs: the passes, laid out for every control, written and read back.

use super::grinding_stroke::{GrindingStroke, StrokeLaw};
use super::lines::LineWork;
use super::task::ProgramTask;
use super::technology::Technology;
use super::work::{DressingWork, GrindingWork};
use contact::StandOff;
use foundation::geometry::Flank;
use foundation::kinematics::{Dresser, MotionLaw, Workpiece};
use grinding_technology::Direction;
use job::Diagnostic;
use job::machine::{Control, ControlCoupling};
use machine::{Positions, Station};
use motion::{
    AxisWords, Coupling, Course, DressingCourse, GrindingCourse, Layout, LayoutOptions, MotionError, Pass,
    WorkGear, in_words, lay_out,
};
use nc::{
    Block, Checked, Dialect, FanucOptions, HalOptions, NcError, WriteOptions, Written, split_turns,
    write_checked,
};
use run::RunFailure;
use run::program_check::{control_of, decimals_of, dialect_of, ending_of, words_for};
use std::f64::consts::TAU;
use verdict::Remark;

/// One program.
#[derive(Clone, Debug)]
pub struct BuiltProgram {
    /// The control.
    pub dialect: Dialect,
    /// Dressing or grinding.
    pub station: Station,
    /// Finishing area of the worm that it grinds with, from 0; 0 for dressing, which serves all.
    pub area: usize,
    /// The flank that it dresses line by line; `None` for other programs.
    pub lines: Option<Flank>,
    /// Path below the directory of the run.
    pub file: String,
    /// The text, and what rounding did.
    pub written: Written,
    /// What it does.
    pub layout: Layout,
    /// Axes and words.
    pub words: AxisWords,
    /// What an independent reader found in the text.
    pub read: Vec<Block>,
    /// Where axes without a word stand.
    pub start: Positions,
}

/// All programs of a run.
#[derive(Clone, Debug)]
pub struct Built {
    /// The programs, dressing before grinding, in the order of the job's dialects.
    pub programs: Vec<BuiltProgram>,
    /// Remarks.
    pub warnings: Vec<Remark>,
}

/// What a program of a run is for.
#[derive(Clone, Copy, Debug)]
enum Part<'a> {
    /// All dressing strokes.
    Dressing,
    /// The lines of one flank, and their number among the programs of lines.
    Lines(&'a LineWork<'a>, usize),
    /// The grinding strokes of a finishing area.
    Grinding(usize),
}

impl Part<'_> {
    fn station(self) -> Station {
        match self {
            Self::Dressing | Self::Lines(..) => Station::Dresser,
            Self::Grinding(_) => Station::Work,
        }
    }
}

/// Chord tolerance where the control gives none, um (`docs/mathematics/programs.md#what-rounding-adds`).
const CHORD_TOLERANCE_UM: f64 = 0.05;
/// Following error at which the guard of a LinuxCNC gear opens, deg.
const FOLLOWING_ERROR_DEG: f64 = 0.5;

/// An error of the motion as a finding of the job: bad input if the machine or its controls lack something.
fn failure(error: &MotionError) -> RunFailure {
    let finding = Diagnostic::of(error).field("machine");
    match error {
        MotionError::Machine { .. } | MotionError::ToleranceNotReached { .. } => {
            RunFailure::not_producible(finding)
        }
        _ => RunFailure::bad_input(finding),
    }
}

/// An error of a writer as a finding of the job.
fn refused(error: &NcError, dialect: Dialect) -> RunFailure {
    let text = format!("program for {}: {error}", dialect.name());
    let finding = Diagnostic::with_code(error.code(), text).field("output.programs").way_out(error.way_out());
    RunFailure::bad_input(finding)
}

impl ProgramTask<'_> {
    /// Lays out, writes and reads back all programs.
    ///
    /// # Errors
    /// [`RunFailure`]: a machine that lacks an axis or cannot stand where it should, a control that is not described or cannot
    /// say it.
    pub fn build(&self) -> Result<Built, RunFailure> {
        let mut programs = Vec::new();
        let mut warnings = Vec::new();
        for &name in self.dialects {
            let control = control_of(self.machine, name)?;
            let dressing = (!self.dressing.is_empty()).then_some(Part::Dressing);
            let lines = self.lines.iter().enumerate().map(|(k, work)| Part::Lines(work, k));
            let areas = if self.grinding.is_empty() { 0 } else { self.areas.len() };
            for part in dressing.into_iter().chain(lines).chain((0..areas).map(Part::Grinding)) {
                let made = self.program(dialect_of(name), control, part)?;
                warnings.extend(warnings_of(&made));
                programs.push(made);
            }
        }
        Ok(Built { programs, warnings })
    }

    fn program(
        &self,
        dialect: Dialect,
        control: &Control,
        part: Part<'_>,
    ) -> Result<BuiltProgram, RunFailure> {
        let station = part.station();
        let area = if let Part::Grinding(area) = part { area } else { 0 };
        let machine = &self.machine.machine;
        let axes = machine.axes_at(station).map_err(|e| failure(&e.into()))?;
        let words = words_for(self.machine, Some(control), &axes).map_err(|e| failure(&e))?;
        let decimals = decimals_of(control).unwrap_or_default();
        let half = |digits: u8| 0.5 * 10f64.powi(-i32::from(digits));
        let several = station == Station::Work && self.areas.len() > 1;
        let gearbox = control.coupling == ControlCoupling::Gearbox && station == Station::Work;
        let options = LayoutOptions {
            name: program_name(self.job, part, several),
            comments: comments(self, part, several),
            tolerance: control.chord_tolerance_um.unwrap_or(CHORD_TOLERANCE_UM) * 1e-3,
            swivel: self.technology.swivel,
            coupling: if gearbox {
                let leaders = control.leaders.iter().filter_map(|name| machine.axis_named(name)).collect();
                Coupling::Gearbox(WorkGear { coupling: self.coupling, leaders })
            } else {
                Coupling::Blocks
            },
            dresser_speed: if station == Station::Dresser { self.technology.dresser_speed } else { 0.0 },
            half_unit: [half(decimals.mm), half(decimals.deg).to_radians()],
        };
        let laid_out = match part {
            Part::Dressing => lay_out(machine, &words, &self.dressing_passes(), &options),
            Part::Lines(work, _) => {
                work.lay_out(machine, &words, (&self.indexing, &self.technology), &options)
            }
            Part::Grinding(area) => {
                let passes = self.grinding_passes(self.areas.get(area).copied().unwrap_or(0.0));
                lay_out(machine, &words, &passes, &options)
            }
        };
        let mut layout = laid_out.map_err(|e| failure(&e))?;
        if control.modulo {
            layout.program = split_turns(&layout.program).map_err(|e| refused(&e, dialect))?;
        }
        let next = match part {
            Part::Dressing | Part::Lines(_, 0) => 0,
            Part::Grinding(area) => 1 + area,
            Part::Lines(_, k) => self.areas.len() + k,
        } as u32;
        let mut write_options =
            WriteOptions { decimals, incremental_rotary: control.modulo, ..WriteOptions::default() };
        write_options.fanuc = FanucOptions {
            program_number: control.program_number.unwrap_or(1) + next,
            contour_mode: control.contour_mode,
        };
        if gearbox && dialect == Dialect::LinuxCnc {
            let degrees = control.following_error_deg.unwrap_or(FOLLOWING_ERROR_DEG);
            write_options.linuxcnc.hal = Some(HalOptions { following_error: degrees.to_radians() });
        }
        let Checked { written, read } =
            write_checked(&layout.program, dialect, &write_options).map_err(|e| refused(&e, dialect))?;
        let read = match &written.hal {
            Some(netlist) => read
                .with_netlist(netlist, &words.words)
                .map_err(|e| refused(&NcError::NotReadBack(e.to_string().into()), dialect))?,
            None => read,
        };
        let mut start = Positions::default();
        for &(axis, value) in &layout.at_rest {
            start[axis] = value;
        }
        Ok(BuiltProgram {
            dialect,
            station,
            area,
            lines: if let Part::Lines(work, _) = part { Some(work.flank) } else { None },
            file: {
                let what = match part {
                    Part::Dressing => "dressing".to_owned(),
                    Part::Lines(work, _) => format!("dressing-{}", work.flank),
                    Part::Grinding(area) if several => format!("grinding-area-{}", area + 1),
                    Part::Grinding(_) => "grinding".to_owned(),
                };
                format!("programs/{what}-{}.{}", dialect.name(), ending_of(dialect))
            },
            written,
            read: read.blocks,
            words,
            start,
            layout,
        })
    }

    /// The dressing passes of all strokes, thread after thread.
    fn dressing_passes(&self) -> Vec<Pass> {
        let technology = &self.technology;
        let mut passes = Vec::new();
        for work in &self.dressing {
            for &thread in &self.indexing.active {
                let work = self.indexing.on_thread(work, thread);
                for stock in technology.dressing_stock.iter().copied().chain([0.0]) {
                    let name = if stock > 0.0 {
                        format!("{} STOCK {}", work.name, in_words(stock * 1e3, "um"))
                    } else {
                        work.name.clone()
                    };
                    passes.push(dressing_pass(&work, technology, name, stock));
                }
            }
        }
        passes
    }

    /// The grinding passes of all strokes in a finishing area, each with every index stroke.
    fn grinding_passes(&self, area: f64) -> Vec<Pass> {
        let technology = &self.technology;
        let mut passes = Vec::new();
        for work in &self.grinding {
            let mut work = work.clone();
            work.motion.shift = work.motion.shift.raised(area);
            let indexed: Vec<GrindingWork> = self
                .indexing
                .offsets
                .iter()
                .map(|&offset| self.indexing.with_offset(&work, offset))
                .collect();
            let (mut roughed, mut finished) = (0, false);
            for stroke in technology.strokes_of(&work) {
                let area = technology.roughing.get(roughed % technology.roughing.len().max(1));
                let (shift, share) = match &stroke.shift {
                    StrokeLaw::Own(law) => (Some(law), None),
                    StrokeLaw::Planned if stroke.finishes() => (None, None),
                    StrokeLaw::Planned => {
                        (area.map(|pass| &pass.shift), area.and_then(|pass| pass.area.share))
                    }
                };
                let name = stroke.name(finished);
                if stroke.finishes() {
                    finished = true;
                } else {
                    roughed += 1;
                }
                passes.extend(indexed.iter().map(|work| {
                    let work = share.map_or_else(|| work.clone(), |share| work.with_share(share));
                    grinding_pass(&work, technology, (stroke, shift), format!("{} {name}", work.name))
                }));
            }
        }
        passes
    }
}

/// One dressing pass that leaves some stock on the worm, mm.
fn dressing_pass(work: &DressingWork, technology: &Technology, name: String, stock: f64) -> Pass {
    let mut motion = work.motion.clone();
    if stock > 0.0 {
        // Turning the worm by d moves the dresser by -d z x p against it: towards one flank, away from the other.
        let rates: Vec<f64> = work.contacts.iter().map(|(p, n)| -(n.y * p.x - n.x * p.y)).collect();
        let same = rates.iter().all(|r| *r > 0.0) || rates.iter().all(|r| *r < 0.0);
        let least = rates.iter().copied().min_by(|a, b| a.abs().total_cmp(&b.abs()));
        match least.filter(|_| same) {
            Some(rate) => motion.correction[0] = motion.correction[0].raised(stock / rate),
            None => motion.correction[2] = motion.correction[2].raised(stock / work.per_distance),
        }
    }
    let room = |end: f64| technology.worm_end.map_or(0.0, |edge| (edge - end).max(0.0));
    let [from, to] = work.interval;
    let screw = motion.chain.screw_parameter.abs();
    let course = Course::Dressing(DressingCourse {
        motion,
        interval: work.interval,
        mounts: technology.dressing,
        contacts: work.contacts.clone(),
    });
    let clear = technology.dresser.map_or([0.0; 2], |cylinders| {
        [cylinders.run_out::<Dresser>(&course, from, -1.0), cylinders.run_out::<Dresser>(&course, to, 1.0)]
    });
    Pass {
        name,
        course,
        range: [from, to],
        room: [room(-from).max(clear[0]), room(to).max(clear[1])],
        speed: screw * technology.dressing_speed,
        clearance: technology.clearance,
        dwell: 0.0,
    }
}

/// One grinding pass; `shift`: z_V1 where it is not that of the plan.
fn grinding_pass(
    work: &GrindingWork,
    technology: &Technology,
    (stroke, shift): (&GrindingStroke, Option<&MotionLaw>),
    name: String,
) -> Pass {
    let mut motion = work.motion.clone();
    let infeed = StandOff::of_ground(work.levers, stroke.left);
    if infeed.delta_d != 0.0 {
        motion.delta_d = motion.delta_d.raised(infeed.delta_d);
    }
    if infeed.delta_phi_2 != 0.0 {
        motion.delta_phi_2 = motion.delta_phi_2.raised(infeed.delta_phi_2);
    }
    if let Some(shift) = shift {
        motion.shift = shift.clone();
    }
    // One revolution of the workpiece takes z_2/z_1 of the worm.
    let worm_per_turn = motion.teeth.abs() / motion.threads;
    let speed = stroke.feed_per_revolution * stroke.worm_speed / (TAU * worm_per_turn);
    let sigma = stroke.direction.sign();
    let course = Course::Grinding(GrindingCourse {
        motion,
        phase: work.phase,
        feeds: work.feeds,
        // The worm turns one way, whichever way the feed goes.
        turning: sigma * stroke.worm_speed / speed,
        mounts: technology.grinding,
        per_turn: work.per_turn(),
        per_distance: work.per_distance(),
    });
    let [low, high] = work.feeds;
    let range = match (stroke.contact, stroke.direction) {
        (Some(contact), _) => {
            let [first, last] = contact.feeds;
            [first - sigma * contact.overrun, last + sigma * contact.overrun]
        }
        (None, Direction::Up) => [low, high],
        (None, Direction::Down) => [high, low],
    };
    // Where the stock is known the worm comes in and goes out beside it, its threads in the spaces; else clear of the blank.
    let clear = technology.cylinders.filter(|_| stroke.contact.is_none());
    let room = clear.map_or([0.0; 2], |cylinders| {
        [
            cylinders.run_out::<Workpiece>(&course, range[0], -sigma),
            cylinders.run_out::<Workpiece>(&course, range[1], sigma),
        ]
    });
    let clearance = technology.clearance;
    Pass { name, course, range, room, speed, clearance, dwell: stroke.dwell }
}

/// [A-Z0-9_]{1,24} of the job's name and D or G, with the number of the area where there are several, or the letter of the flank of lines.
fn program_name(job: &str, part: Part<'_>, several: bool) -> String {
    let letter = if part.station() == Station::Dresser { "D" } else { "G" };
    let number = match part {
        Part::Grinding(area) if several => (area + 1).to_string(),
        Part::Lines(work, _) => work.flank.name().to_ascii_uppercase().chars().take(1).collect(),
        _ => String::new(),
    };
    let word: String = job
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' })
        .take(22 - number.len().min(21))
        .collect();
    format!("{word}_{letter}{number}")
}

/// What the head of a program says.
fn comments(task: &ProgramTask<'_>, part: Part<'_>, several: bool) -> Vec<String> {
    let plain = |text: &str| -> String {
        let kept = text.to_ascii_uppercase();
        let kept = kept
            .chars()
            .map(|c| if c.is_ascii_alphanumeric() { c } else { ' ' })
            .take(60)
            .collect::<String>();
        kept.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let what = match part {
        Part::Dressing => "DRESSING".to_owned(),
        Part::Lines(work, _) => work.name(),
        Part::Grinding(_) => "GRINDING".to_owned(),
    };
    let mut lines =
        vec![format!("{} {what}", plain(task.job)), format!("MACHINE {}", plain(&task.machine.file.name))];
    if let Part::Lines(work, _) = part {
        lines.push(format!("{} LINES ON EACH THREAD", work.count()));
    }
    if let Part::Grinding(area) = part
        && several
    {
        lines.push(format!("FINISHING AREA {} OF {} OF THE WORM", area + 1, task.areas.len()));
    }
    if part.station() == Station::Work {
        lines.push("DATUM FACE IS FACE II THE ONE AT UPPER Z OF THE JOB".into());
        let way = if task.technology.grinding.counterpart.reversed { "DOWN" } else { "UP" };
        lines.push(format!("WORKPIECE CLAMPED WITH ITS DATUM FACE {way}"));
    }
    lines
}

/// What a control will not keep, and what slows the machine down.
fn warnings_of(program: &BuiltProgram) -> Vec<Remark> {
    let mut warnings = Vec::new();
    for pass in &program.layout.passes {
        if program.dialect == Dialect::LinuxCnc && pass.short_blocks > 0 {
            warnings.push(Remark {
                code: "program-time-not-kept",
                text: format!(
                    "{}, {}: on LinuxCNC {} of {} blocks are too short to reach the programmed feed; the cycle time will be longer",
                    program.file, pass.name, pass.short_blocks, pass.blocks
                ),
                way_out: "raise chord_tolerance_um of the control for fewer blocks, or lower the speed".into(),
            });
        }
        if let Some(braked) = &pass.braked {
            warnings.push(Remark {
                code: "axis-limits-speed",
                text: format!(
                    "{}, {}: the {} of {} allows {:.1} % of the wanted speed; feed and rotations are slowed down together",
                    program.file,
                    pass.name,
                    braked.limit,
                    braked.axis,
                    100.0 * braked.share
                ),
                way_out: "lower machine.cutting_speed_m_per_s or machine.dressing_worm_speed_rpm, or take a faster machine".into(),
            });
        }
    }
    warnings
}
