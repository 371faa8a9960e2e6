//! `flankwright schema`: the schema of the job file, of a catalogue, or of a machine description.

use clap::Args;
use flankwright::exchange::catalogue::catalogue_schema;
use flankwright::exchange::job_schema;
use flankwright::exchange::machine::machine_schema;

use crate::arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;

/// Arguments of `schema`.
#[derive(Args, Debug)]
#[command(after_help = "Example:\n  flankwright schema > job.schema.json\n\n\
    Editors use it to complete and check job files. With -o it is written to DIR/job.schema.json (catalogue.schema.json, machine.schema.json).")]
pub struct SchemaArguments {
    /// The schema of a catalogue of worms and dressers instead
    #[arg(long)]
    pub catalogue: bool,
    /// The schema of a machine description instead
    #[arg(long, conflicts_with = "catalogue")]
    pub machine: bool,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

/// Prints the schema, or writes it to the given directory.
///
/// # Errors
/// The output cannot be written.
pub fn run(arguments: &SchemaArguments) -> Result<Exit, Failure> {
    let (schema, name) = if arguments.catalogue {
        (catalogue_schema(), "catalogue.schema.json")
    } else if arguments.machine {
        (machine_schema(), "machine.schema.json")
    } else {
        (job_schema(), "job.schema.json")
    };
    let text = output::json_text(&schema)?;
    match &arguments.common.output {
        Some(directory) => output::write_file(&directory.join(name), text.as_bytes())?,
        None => output::print(&text)?,
    }
    Ok(Exit::Done)
}
