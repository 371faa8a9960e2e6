//! `flankwright new`: an example job.

use clap::builder::PossibleValuesParser;
use clap::{Args, builder::TypedValueParser};
use flankwright::exchange::{JobFormat, Source, parse_any_job};
use flankwright::processes;

use crate::common_arguments::CommonArguments;
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
    pub process: JobFormat,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

fn process_parser() -> impl TypedValueParser<Value = JobFormat> {
    let formats = processes().formats();
    PossibleValuesParser::new(formats.formats().iter().map(|format| format.name))
        .try_map(|name| formats.format(&name).copied().ok_or_else(|| format!("no process is called {name}")))
}

/// Prints the example job, or writes it to the given directory.
///
/// # Errors
/// The output cannot be written.
pub fn run(arguments: &NewArguments) -> Result<Exit, Failure> {
    let format = &arguments.process;
    let (text, ending) = if arguments.common.json {
        let job = parse_any_job(Source::new("example.toml", format.template))?;
        let text = job.to_json().map_err(|error| Failure::internal(error.to_string()))?;
        (text + "\n", "json")
    } else {
        (format.template.to_owned(), "toml")
    };
    match &arguments.common.output {
        Some(directory) => {
            let path = directory.join(format!("{}.{ending}", format.name));
            output::write_file(&path, text.as_bytes())?;
        }
        None => output::print(&text)?,
    }
    Ok(Exit::Done)
}
