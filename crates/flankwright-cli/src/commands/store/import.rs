//! `flankwright store import`: measurements into the store.

use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;
use flankwright_store::{ImportSettings, MeasurementReport};

use super::place::{PlaceArguments, failed};
use crate::commands::statements::StatementArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::progress::Bars;

/// Arguments of `store import`.
#[derive(Args, Debug)]
#[command(after_help = "Example:\n  flankwright store import measured/ --class 6\n\n\
    Files: .mka or .mew (each finds the other beside it), .rexs, .rexsj, .rexsz; of a folder those that lie in it. The same content is \
    imported once, so that an import may be repeated; with --again it is evaluated anew. Exit status 3: some files were refused, the others are in the store; \
    2: all were refused.")]
pub struct ImportArguments {
    /// Measurements, or folders with measurements
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// Series of the parts; default the drawing, else the name of the gear
    #[arg(long, value_name = "NAME")]
    pub series: Option<String>,
    /// Class of ISO 1328-1:2013 whose tolerances become the limits
    #[arg(long, value_name = "CLASS", value_parser = clap::value_parser!(i32).range(1..=11))]
    pub class: Option<i32>,
    /// Evaluates what is in the store already once more, and replaces it: after a change of series, class or statements
    #[arg(long)]
    pub again: bool,
    /// What the files do not tell.
    #[command(flatten)]
    pub statements: StatementArguments,
    /// Store, and arguments that every command has.
    #[command(flatten)]
    pub place: PlaceArguments,
}

/// Imports, and tells what became of each file.
pub fn run(arguments: &ImportArguments) -> Result<Exit, Failure> {
    let store = arguments.place.open()?;
    let settings = ImportSettings {
        series: arguments.series.clone(),
        class: arguments.class,
        statements: arguments.statements.statements(),
        again: arguments.again,
    };
    let bars = Bars::new(arguments.place.common.quiet);
    let report = store.import_measurements(&arguments.files, &settings, &bars);
    bars.finish();
    let report = report.map_err(failed)?;
    arguments.place.print(&report, || text(&report))?;
    Ok(match (report.refused.len(), report.imported.len() + report.known.len()) {
        (0, _) => Exit::Done,
        (_, 0) => Exit::BadInput,
        _ => Exit::TargetMissed,
    })
}

fn text(report: &MeasurementReport) -> String {
    let again = match report.replaced {
        0 => String::new(),
        count => format!(" ({count} of them again)"),
    };
    let completed = match report.completed {
        0 => String::new(),
        count => format!(" ({count} of them have got their files now)"),
    };
    let mut text = format!(
        "{} parts imported{again}, {} known{completed}, {} files refused\n",
        report.imported.len(),
        report.known.len(),
        report.refused.len()
    );
    for refused in &report.refused {
        // Writing to a text cannot fail.
        let _ = writeln!(text, "  {}: {}: {}", refused.file, refused.finding.code, refused.finding.message);
        if let Some(way_out) = &refused.finding.way_out {
            let _ = writeln!(text, "    remedy: {way_out}");
        }
    }
    for file in &report.left_out {
        let _ = writeln!(text, "  left out: {}: {}", file.file, file.reason);
    }
    text
}
