//! `flankwright store`: what outlives one run, in a file of SQLite or on a PostgreSQL server.

mod catalogue;
mod check;
mod history;
mod import;
mod parts;
pub mod place;
mod plans;
mod remove;
mod series;
mod table;

use clap::{Args, Subcommand};

use crate::common_arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;

/// Arguments of `store`.
#[derive(Args, Debug)]
#[command(
    arg_required_else_help = true,
    after_help = "Example:\n  flankwright store import measured/\n  flankwright store parts --from 2026-03-01 --characteristic fHa --json\n  \
    flankwright store catalogue add examples/catalogue/bodies.toml\n\n\
    Which store: --store, else the environment variable FLANKWRIGHT_STORE, else flankwright/store.sqlite in XDG_DATA_HOME or \
    ~/.local/share. An address is a path, sqlite:PATH, or postgres://USER:PASSWORD@HOST:PORT/DATABASE; a password is better kept in \
    FLANKWRIGHT_STORE than in a command line.\n\n\
    Every action takes --json and --quiet; those that write files take -o DIR."
)]
pub struct StoreArguments {
    /// What to do.
    #[command(subcommand)]
    pub action: StoreAction,
}

/// What to do with the store.
#[derive(Debug, Subcommand)]
pub enum StoreAction {
    /// Evaluate measurements and keep them: each content once
    Import(import::ImportArguments),
    /// List measured parts, or the values of a characteristic over them
    Parts(parts::PartsArguments),
    /// Take measured parts out
    Remove(remove::RemoveArguments),
    /// Statistics, trends and capability of measured parts
    Series(series::SeriesArguments),
    /// The catalogue of worms and dressers
    Catalogue(catalogue::CatalogueArguments),
    /// Plans: results of jobs
    Plans(plans::PlansArguments),
    /// Measurements of skiving tools
    History(history::HistoryArguments),
    /// Look through the whole store for damage
    Check(check::CheckArguments),
}

impl StoreArguments {
    /// The arguments that every command has.
    pub fn common(&self) -> &CommonArguments {
        let place = match &self.action {
            StoreAction::Import(arguments) => &arguments.place,
            StoreAction::Parts(arguments) => &arguments.place,
            StoreAction::Remove(arguments) => &arguments.place,
            StoreAction::Series(arguments) => &arguments.parts.place,
            StoreAction::Catalogue(arguments) => arguments.place(),
            StoreAction::Plans(arguments) => arguments.place(),
            StoreAction::History(arguments) => arguments.place(),
            StoreAction::Check(arguments) => &arguments.place,
        };
        &place.common
    }
}

/// Does it.
///
/// # Errors
/// A store that cannot be reached, files that cannot be read, entries that are refused.
pub fn run(arguments: &StoreArguments) -> Result<Exit, Failure> {
    match &arguments.action {
        StoreAction::Import(arguments) => import::run(arguments),
        StoreAction::Parts(arguments) => parts::run(arguments),
        StoreAction::Remove(arguments) => remove::run(arguments),
        StoreAction::Series(arguments) => series::run(arguments),
        StoreAction::Catalogue(arguments) => catalogue::run(arguments),
        StoreAction::Plans(arguments) => plans::run(arguments),
        StoreAction::History(arguments) => history::run(arguments),
        StoreAction::Check(arguments) => check::run(arguments),
    }
}
