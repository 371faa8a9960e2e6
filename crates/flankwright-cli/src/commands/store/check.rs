//! `flankwright store check`: whether the store is sound.

use std::fmt::Write;

use clap::Args;

use super::place::{PlaceArguments, failed};
use crate::exit::Exit;
use crate::failure::Failure;

/// Arguments of `store check`.
#[derive(Args, Debug)]
#[command(after_help = "Exit status 3: the store has faults.")]
pub struct CheckArguments {
    /// Store, and arguments that every command has.
    #[command(flatten)]
    pub place: PlaceArguments,
}

/// Looks through the store.
pub fn run(arguments: &CheckArguments) -> Result<Exit, Failure> {
    let health = arguments.place.open_existing()?.health().map_err(failed)?;
    arguments.place.print(&health, || {
        let mut text = format!(
            "{} ({}, tables of version {})\n  {} parts with {} values, {} of them with their files ({:.1} MB packed), {} bodies, {} plans, {} measurements of tools\n",
            health.store,
            health.kind,
            health.tables,
            health.parts,
            health.values,
            health.parts_with_files,
            health.file_bytes as f64 * 1e-6,
            health.bodies,
            health.plans,
            health.tool_measurements
        );
        for fault in &health.faults {
            // Writing to a text cannot fail.
            let _ = writeln!(text, "  fault: {fault}");
        }
        text += if health.faults.is_empty() {
            "  sound\n"
        } else {
            "  remedy: bring back a copy of the store, or import the files into a new one\n"
        };
        text
    })?;
    Ok(if health.faults.is_empty() { Exit::Done } else { Exit::TargetMissed })
}
