//! `flankwright new`: an example job.

use clap::builder::PossibleValuesParser;
use clap::{Args, builder::TypedValueParser};
use flankwright::exchange::job::Process;
use flankwright::exchange::{AnyJob, Source, job_template, parse_any_job};

use crate::arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;

/// Arguments of `new`.
#[derive(Args, Debug)]
#[command(
    after_help = "Example:\n  flankwright new generating-grinding > job.toml\n  flankwright new five-axis-milling -o jobs\n\n\
    With --json the job is printed as JSON, which every command reads as well; with -o it is written to DIR."
)]
pub struct NewArguments {
    /// The process to plan
    #[arg(value_name = "PROCESS", value_parser = process_parser())]
    pub process: Process,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

fn process_parser() -> impl TypedValueParser<Value = Process> {
    PossibleValuesParser::new(Process::ALL.map(Process::name)).try_map(|name| {
        let found = Process::ALL.into_iter().find(|process| process.name() == name);
        found.ok_or_else(|| format!("no process is called {name}"))
    })
}

/// Prints the example job, or writes it to the given directory.
///
/// # Errors
/// The output cannot be written.
pub fn run(arguments: &NewArguments) -> Result<Exit, Failure> {
    let toml = job_template(arguments.process);
    let (text, ending) = if arguments.common.json {
        let text = match parse_any_job(Source::new("example.toml", toml))? {
            AnyJob::Grinding(loaded) => output::json_text(&loaded.job)?,
            AnyJob::Tangential(loaded) => output::json_text(&loaded.job)?,
            AnyJob::Gearbox(loaded) => output::json_text(&loaded.job)?,
            AnyJob::Milling(loaded) => output::json_text(&loaded.job)?,
            AnyJob::Skiving(loaded) => output::json_text(&loaded.job)?,
        };
        (text, "json")
    } else {
        (toml.to_owned(), "toml")
    };
    match &arguments.common.output {
        Some(directory) => {
            let path = directory.join(format!("{}.{ending}", arguments.process.name()));
            output::write_file(&path, text.as_bytes())?;
        }
        None => output::print(&text)?,
    }
    Ok(Exit::Done)
}
