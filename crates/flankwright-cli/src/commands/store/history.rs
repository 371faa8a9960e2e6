//! `flankwright store history`: measurements of skiving tools.

use std::path::PathBuf;

use clap::{Args, Subcommand};
use flankwright::exchange::skiving_history::{HistoryRecord, read_history};

use super::place::{PlaceArguments, failed};
use super::table::table;
use crate::exit::Exit;
use crate::failure::Failure;

/// Arguments of `store history`.
#[derive(Args, Debug)]
#[command(arg_required_else_help = true)]
pub struct HistoryArguments {
    /// What to do with it.
    #[command(subcommand)]
    pub action: HistoryAction,
}

/// What to do with histories.
#[derive(Debug, Subcommand)]
pub enum HistoryAction {
    /// Add the measurements of a history file, all or none; each once
    Add {
        /// The history (JSON lines)
        #[arg(value_name = "FILE")]
        file: PathBuf,
        /// Store, and arguments that every command has.
        #[command(flatten)]
        place: PlaceArguments,
    },
    /// List the measurements; with --json the lines of a history file as one list
    List {
        /// Those of this tool
        #[arg(long, value_name = "NAME")]
        tool: Option<String>,
        /// Store, and arguments that every command has.
        #[command(flatten)]
        place: PlaceArguments,
    },
}

impl HistoryArguments {
    /// Store, and arguments that every command has.
    pub fn place(&self) -> &PlaceArguments {
        match &self.action {
            HistoryAction::Add { place, .. } | HistoryAction::List { place, .. } => place,
        }
    }
}

/// Does it.
pub fn run(arguments: &HistoryArguments) -> Result<Exit, Failure> {
    let place = arguments.place();
    match &arguments.action {
        HistoryAction::Add { file, .. } => {
            let history = read_history(file)?;
            let report = place.open()?.import_history(&history).map_err(failed)?;
            place.print(&report, || {
                format!("{} measurements added, {} known\n", report.added, report.known)
            })?;
        }
        HistoryAction::List { tool, .. } => {
            let records = place.open_existing()?.history(tool.as_deref()).map_err(failed)?;
            place.print(&records, || text(&records))?;
        }
    }
    Ok(Exit::Done)
}

fn text(records: &[HistoryRecord]) -> String {
    let row = |record: &HistoryRecord| {
        vec![
            record.tool.clone(),
            record.time.clone(),
            record.parts.to_string(),
            record.resharpened.to_string(),
            format!("{:.2}", record.pitch.total_um),
            record.out_of_band.len().to_string(),
        ]
    };
    let rows: Vec<Vec<String>> = records.iter().map(row).collect();
    let heading = ["tool", "time", "workpieces", "resharpened", "Fp um", "edges out of band"];
    format!("{} measurements\n", records.len()) + &table(&heading, &rows)
}
