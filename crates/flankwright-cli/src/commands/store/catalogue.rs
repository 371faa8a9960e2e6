//! `flankwright store catalogue`: worms and dressers.

use std::path::PathBuf;

use clap::{Args, Subcommand};
use flankwright::exchange::catalogue::{Catalogue, read_catalogue};

use super::place::{PlaceArguments, failed};
use super::table::table;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;

/// Arguments of `store catalogue`.
#[derive(Args, Debug)]
#[command(arg_required_else_help = true)]
pub struct CatalogueArguments {
    /// What to do with it.
    #[command(subcommand)]
    pub action: CatalogueAction,
}

/// What to do with the catalogue.
#[derive(Debug, Subcommand)]
pub enum CatalogueAction {
    /// Add the bodies of a catalogue file; of a name that is there the new data hold
    Add {
        /// The catalogue (TOML or JSON)
        #[arg(value_name = "FILE")]
        file: PathBuf,
        /// Take out bodies that the file does not name
        #[arg(long)]
        replace: bool,
        /// Store, and arguments that every command has.
        #[command(flatten)]
        place: PlaceArguments,
    },
    /// List the bodies
    List {
        /// Store, and arguments that every command has.
        #[command(flatten)]
        place: PlaceArguments,
    },
    /// Write the catalogue as a file that jobs can name (JSON)
    Export {
        /// The file; default standard output
        #[arg(value_name = "FILE")]
        file: Option<PathBuf>,
        /// Store, and arguments that every command has.
        #[command(flatten)]
        place: PlaceArguments,
    },
}

impl CatalogueArguments {
    /// Store, and arguments that every command has.
    pub fn place(&self) -> &PlaceArguments {
        match &self.action {
            CatalogueAction::Add { place, .. }
            | CatalogueAction::List { place }
            | CatalogueAction::Export { place, .. } => place,
        }
    }
}

/// Does it.
pub fn run(arguments: &CatalogueArguments) -> Result<Exit, Failure> {
    let place = arguments.place();
    match &arguments.action {
        CatalogueAction::Add { file, replace, .. } => {
            let catalogue = read_catalogue(file)?.catalogue;
            let report = place.open()?.import_catalogue(&catalogue, *replace).map_err(failed)?;
            place.print(&report, || {
                format!(
                    "{} bodies added, {} changed, {} unchanged, {} taken out\n",
                    report.added, report.changed, report.unchanged, report.removed
                )
            })?;
        }
        CatalogueAction::List { .. } => {
            let catalogue = place.open_existing()?.catalogue().map_err(failed)?;
            place.print(&catalogue, || text(&catalogue))?;
        }
        CatalogueAction::Export { file, .. } => {
            let catalogue = place.open_existing()?.catalogue().map_err(failed)?;
            match file {
                None => output::print_json(&catalogue)?,
                Some(file) => {
                    output::write_file(file, output::json_text(&catalogue)?.as_bytes())?;
                    let written = serde_json::json!({ "written": [file] });
                    place.print(&written, || format!("written: {}\n", file.display()))?;
                }
            }
        }
    }
    Ok(Exit::Done)
}

fn text(catalogue: &Catalogue) -> String {
    let worms = catalogue.worm.iter().map(|worm| {
        vec![
            "worm".to_owned(),
            worm.name.clone(),
            format!("{} threads, {} mm wide", worm.threads, worm.width),
        ]
    });
    let dressers = catalogue.dresser.iter().map(|dresser| {
        vec!["dresser".to_owned(), dresser.name.clone(), format!("tip diameter {} mm", dresser.tip_diameter)]
    });
    let rows: Vec<Vec<String>> = worms.chain(dressers).collect();
    let count = format!("{} worms, {} dressers\n", catalogue.worm.len(), catalogue.dresser.len());
    count + &table(&["kind", "name", "data"], &rows)
}
