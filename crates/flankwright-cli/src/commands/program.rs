//! `flankwright program check`: what an NC program does on a machine, and with a job the flank that it leaves.

use std::fmt::Write;
use std::io::{BufReader, Read};
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use flankwright::exchange::machine::read_machine;
use flankwright::exchange::{Diagnostic, Problem, Source, open_regular};
use flankwright::nc::{Dialect, MAXIMUM_BYTES, detect_dialect};
use flankwright::processes;
use flankwright::workflow::{CheckedProgram, RunFailure, check_program};

use crate::common_arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::{Failure, unreadable};
use crate::output;
use crate::progress::Bars;

/// What to do with a program.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum ProgramAction {
    /// Read it and tell what it does: axes, travel, time, limits, flank
    Check,
}

/// Control dialects on the command line.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum DialectArgument {
    /// LinuxCNC
    Linuxcnc,
    /// Siemens 840D
    Siemens,
    /// Fanuc 30i
    Fanuc,
}

/// Arguments of `program`.
#[derive(Args, Debug)]
#[command(
    after_help = "Example:\n  flankwright program check out/programs/grinding-siemens.mpf --machine machines/no-swivel.toml --job job.toml\n\n\
    Without --job the flank is not asked for. Exit status 3: the program leaves the travel or the speed of an axis,\n    or the flank its tolerance, or a skiving tool is not measured as the job asks."
)]
pub struct ProgramArguments {
    /// What to do with the program
    #[arg(value_enum, value_name = "ACTION")]
    pub action: ProgramAction,
    /// The program
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// The machine description
    #[arg(long, value_name = "FILE")]
    pub machine: PathBuf,
    /// The job whose bodies the program moves
    #[arg(long, value_name = "JOB")]
    pub job: Option<PathBuf>,
    /// Its dialect; default by its content
    #[arg(long, value_enum)]
    pub dialect: Option<DialectArgument>,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

/// How much of a text decides its dialect.
const HEAD: u64 = 64 << 10;

/// Runs a command on programs.
///
/// # Errors
/// A program, machine or job that cannot be read.
pub fn run(arguments: &ProgramArguments) -> Result<Exit, Failure> {
    match arguments.action {
        ProgramAction::Check => check(arguments),
    }
}

fn check(arguments: &ProgramArguments) -> Result<Exit, Failure> {
    let machine = read_machine(&arguments.machine)?;
    let name = arguments.file.display().to_string();
    let failed = |error: std::io::Error| Failure::new(Exit::BadInput, unreadable(&name, &error));
    let dialect = match arguments.dialect {
        Some(DialectArgument::Linuxcnc) => Dialect::LinuxCnc,
        Some(DialectArgument::Siemens) => Dialect::Siemens,
        Some(DialectArgument::Fanuc) => Dialect::Fanuc,
        None => {
            let mut head = Vec::new();
            open_regular(&arguments.file)
                .map_err(failed)?
                .take(HEAD)
                .read_to_end(&mut head)
                .map_err(failed)?;
            detect_dialect(&head).ok_or_else(|| {
                let finding = Diagnostic::with_code(
                    "unknown-dialect",
                    format!("{name} is no program of a known dialect"),
                )
                .allowed("linuxcnc, siemens, fanuc")
                .way_out("say it with --dialect");
                Failure::new(Exit::BadInput, finding)
            })?
        }
    };
    let job = arguments.job.as_ref().map(|path| output::load_any_job(path)).transpose()?;
    if let Some(job) =
        job.as_ref().filter(|job| !processes().of(job).is_ok_and(|p| p.commands().contains(&"program check")))
    {
        return Err(output::refused(job, "program check"));
    }
    let file = open_regular(&arguments.file).map_err(failed)?;
    let size = file.metadata().map_err(failed)?.len();
    if size > MAXIMUM_BYTES as u64 {
        let finding = Diagnostic::new(Problem::FileTooLarge, format!("{name} is too large for a program"))
            .value(format!("{size} bytes"))
            .allowed(format!("at most {MAXIMUM_BYTES} bytes (256 MiB)"))
            .way_out("check that this is the right file, or divide the program");
        return Err(Failure::new(Exit::BadInput, finding));
    }
    let text = BufReader::new(file);
    // The gears of a LinuxCNC program stand in a netlist beside it.
    let netlist = arguments.file.with_extension("hal");
    let netlist =
        (dialect == Dialect::LinuxCnc && netlist.exists()).then(|| Source::read(&netlist)).transpose()?;
    let bars = Bars::new(arguments.common.quiet);
    let checked =
        check_program((text, netlist.as_ref().map(Source::text)), dialect, &machine, job.as_ref(), &bars);
    bars.finish();
    let checked = checked.map_err(|failure| match (failure, &job) {
        // What names a key is about the job.
        (failure, Some(job)) if names_key(&failure) => Failure::of_run(job.document(), failure),
        (RunFailure::BadInput(finding), _) => Failure::new(Exit::BadInput, in_file(&name, *finding)),
        (RunFailure::NotProducible(finding), _) => {
            Failure::new(Exit::NotProducible, in_file(&name, *finding))
        }
    })?;
    if arguments.common.json {
        output::print_json(&checked)?;
    } else if !arguments.common.quiet {
        output::print(&summary(&checked))?;
    }
    let tolerance =
        job.as_ref().and_then(|job| processes().of(job).ok()?.tolerance_um(job)).unwrap_or(f64::INFINITY);
    let flanks = checked.flanks.iter().flatten();
    let met = flanks.map(|(_, f)| f.max_deviation_um).all(|um| um <= tolerance);
    Ok(if met && checked.remarks.is_empty() { Exit::Done } else { Exit::TargetMissed })
}

fn names_key(failure: &RunFailure) -> bool {
    let (RunFailure::BadInput(finding) | RunFailure::NotProducible(finding)) = failure;
    finding.field.is_some()
}

/// The finding with the file in front.
fn in_file(name: &str, finding: Diagnostic) -> Diagnostic {
    Diagnostic { message: format!("{name}: {}", finding.message).into(), ..finding }
}

fn summary(program: &CheckedProgram) -> String {
    let mut text = String::new();
    let name = program.name.as_deref().unwrap_or("program");
    let kind = program.kind.map_or_else(String::new, |kind| format!(" {kind}"));
    let _ = writeln!(
        text,
        "{name}: {}{kind} on {}, {} blocks, {:.2} s",
        program.control, program.machine, program.blocks, program.duration_s
    );
    for axis in &program.axes {
        let travel = match (axis.min, axis.max) {
            (Some(min), Some(max)) => format!(" (travel {min:.3} .. {max:.3})"),
            _ => String::new(),
        };
        let limit = axis.max_velocity.map_or_else(String::new, |most| format!(" of {most:.3}"));
        let _ = writeln!(
            text,
            "  {:<3} {:<9} {:.6} .. {:.6} {}{travel}, way {:.3}, up to {:.3}{limit} {}/s",
            axis.axis, axis.word, axis.from, axis.to, axis.unit, axis.way, axis.velocity, axis.unit
        );
    }
    for stroke in &program.strokes {
        let serves = stroke.serves.as_ref().map_or_else(String::new, |name| format!(", finishes {name}"));
        let _ = writeln!(
            text,
            "  stroke {:.3} .. {:.3} mm, blocks {} .. {}, {:.2} s{serves}",
            stroke.range_mm[0], stroke.range_mm[1], stroke.blocks[0], stroke.blocks[1], stroke.duration_s
        );
    }
    for (flank, left) in program.flanks.iter().flatten() {
        let _ = writeln!(
            text,
            "  {flank} flank from the program text: max deviation {:.4} um, {:.4} um from the job's own motions",
            left.max_deviation_um, left.difference_um
        );
    }
    for thread in &program.threads {
        for (flank, um) in &thread.difference_um {
            let _ = writeln!(
                text,
                "  thread {} of the worm, {flank} flank: {um:.4} um from the job's own motions",
                thread.thread
            );
        }
    }
    for body in &program.bodies {
        let _ = writeln!(
            text,
            "  {} and {}: {:.3} mm apart or more, over all blocks (block {})",
            body.of, body.body, body.least_mm, body.block
        );
    }
    if let Some(part) = &program.part {
        let _ = writeln!(text, "  whole part: {}", part.statement);
    }
    if let Some(measuring) = &program.measuring {
        let _ = writeln!(text, "  measurement: {}", measuring.statement);
    }
    for remark in &program.remarks {
        let _ = writeln!(text, "  warning: {} ({})", remark.text, remark.way_out);
    }
    text
}
