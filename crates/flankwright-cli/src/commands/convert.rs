//! `flankwright convert`: a gear and its modifications from a REXS model into a job, or from a job into a REXS model.

use std::path::PathBuf;
use std::time::SystemTime;

use clap::{Args, ValueEnum};
use flankwright::exchange::rexs::{Author, RexsFormat};
use flankwright::exchange::{Diagnostic, Problem};
use flankwright::workflow::{Remark, gear_of_rexs, rexs_of_job};

use crate::common_arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;

/// Arguments of `convert`.
#[derive(Args, Debug)]
#[command(after_help = "Example:\n  flankwright convert examples/twist-free-crowning.toml > gear.rexs\n  \
    flankwright convert gear.rexs --job examples/twist-free-crowning.toml > job.json\n\n\
    A job (.toml, .json) becomes a REXS 2.0 model. A model (.rexs, .rexsj, .rexsz) becomes the tables gear and modifications, or with \
    --job a whole job: the one named, with the gear and the modifications of the model. What cannot be transferred is listed on standard error.")]
pub struct ConvertArguments {
    /// A job or a REXS model
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// The job whose gear and modifications are replaced
    #[arg(long, value_name = "JOB")]
    pub job: Option<PathBuf>,
    /// The gear of the model, by its number; needed where it has several
    #[arg(long, value_name = "NUMBER")]
    pub gear: Option<i32>,
    /// The form of the model
    #[arg(long, value_enum, default_value_t = Form::Rexs)]
    pub form: Form,
    /// The date that the model states, instead of the present (RFC 3339): the same date gives the same bytes
    #[arg(long, value_name = "DATE", value_parser = date)]
    pub date: Option<String>,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

/// Forms of a REXS model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Form {
    /// XML
    Rexs,
    /// JSON
    Rexsj,
    /// XML in a ZIP package; with -o only
    Rexsz,
}

fn date(text: &str) -> Result<String, String> {
    humantime::parse_rfc3339(text)
        .map(|_| text.to_owned())
        .map_err(|error| format!("{error}; give it as 2026-03-14T09:30:00Z"))
}

/// Converts; prints the result, or writes it to the given directory.
///
/// # Errors
/// Everything that is wrong with the file; a gear or modification that the other side has no place for.
pub fn run(arguments: &ConvertArguments) -> Result<Exit, Failure> {
    let ending = arguments.file.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    if ["rexs", "rexsj", "rexsz"].contains(&ending.as_str()) {
        to_job(arguments)
    } else {
        to_model(arguments)
    }
}

fn to_job(arguments: &ConvertArguments) -> Result<Exit, Failure> {
    let (found, remarks) = gear_of_rexs(&arguments.file, arguments.gear).map_err(Failure::of_no_job)?;
    let text = match &arguments.job {
        Some(job) => {
            let template = output::load_grinding_job(job, "convert")?;
            let job = found.into_job(&template).map_err(|error| Failure::internal(error.to_string()))?;
            output::json_text(&job)?
        }
        None => output::json_text(&found)?,
    };
    tell(&remarks, &arguments.common);
    deliver(arguments, "json", text.as_bytes())
}

fn to_model(arguments: &ConvertArguments) -> Result<Exit, Failure> {
    if let Some((option, value)) = [
        arguments.job.as_ref().map(|job| ("--job", job.display().to_string())),
        arguments.gear.map(|gear| ("--gear", gear.to_string())),
    ]
    .into_iter()
    .flatten()
    .next()
    {
        let message = format!("`{option}` belongs to the conversion of a REXS model, and this file is a job");
        let finding = Diagnostic::new(Problem::UnknownKey, message).field(option).value(value);
        return Err(Failure::new(
            Exit::BadInput,
            finding.way_out("leave the option out, or name a file .rexs, .rexsj or .rexsz"),
        ));
    }
    let loaded = output::load_grinding_job(&arguments.file, "convert")?;
    let now = || humantime::format_rfc3339_seconds(SystemTime::now()).to_string();
    let author = Author::flankwright(arguments.date.clone().unwrap_or_else(now));
    let (format, packed, ending) = match arguments.form {
        Form::Rexs => (RexsFormat::Xml, false, "rexs"),
        Form::Rexsj => (RexsFormat::Json, false, "rexsj"),
        Form::Rexsz => (RexsFormat::Xml, true, "rexsz"),
    };
    let (bytes, remarks) = rexs_of_job(&loaded, format, packed, &author)
        .map_err(|failure| Failure::of_job_or_file(&loaded.document, failure))?;
    tell(&remarks, &arguments.common);
    deliver(arguments, ending, &bytes)
}

/// Standard output holds the result.
fn tell(remarks: &[Remark], common: &CommonArguments) {
    for remark in remarks.iter().filter(|_| !common.quiet) {
        eprintln!("warning: {} ({})", remark.text, remark.way_out);
    }
}

fn deliver(arguments: &ConvertArguments, ending: &str, bytes: &[u8]) -> Result<Exit, Failure> {
    if let Some(directory) = &arguments.common.output {
        let stem = arguments.file.file_stem().filter(|stem| *stem != "-").unwrap_or("job".as_ref());
        let path = directory.join(format!("{}.{ending}", stem.display()));
        output::write_file(&path, bytes)?;
        return Ok(Exit::Done);
    }
    match std::str::from_utf8(bytes) {
        Ok(text) => output::print(text)?,
        Err(_) => {
            let finding = Diagnostic::new(Problem::MissingKey, "a package is no text to be printed")
                .field("-o")
                .way_out("name a directory with `-o DIR`");
            return Err(Failure::new(Exit::BadInput, finding));
        }
    }
    Ok(Exit::Done)
}
