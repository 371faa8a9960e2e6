//! `flankwright store remove`: takes measured parts out, for example to import them with another class.

use std::fmt::Write;

use clap::Args;
use flankwright::exchange::{Diagnostic, Problem};
use flankwright_store::{PartFilter, PartSummary, SHORTEST_DIGEST};

use super::place::{PlaceArguments, failed};
use crate::exit::Exit;
use crate::failure::Failure;

/// Arguments of `store remove`.
#[derive(Args, Debug)]
#[command(
    after_help = "Example:\n  flankwright store parts --series Z-17\n  flankwright store remove 3f9a12c07b44\n\n\
    Parts are named by the digest of their files or its beginning, as `store parts` lists it. All of them are found before any is taken out."
)]
pub struct RemoveArguments {
    /// Digest of a part, or its beginning of eight digits or more
    #[arg(value_name = "DIGEST", required = true)]
    pub digests: Vec<String>,
    /// Store, and arguments that every command has.
    #[command(flatten)]
    pub place: PlaceArguments,
}

/// Takes the parts out.
pub fn run(arguments: &RemoveArguments) -> Result<Exit, Failure> {
    let store = arguments.place.open_existing()?;
    let all = store.parts(&PartFilter::default()).map_err(failed)?;
    let found = arguments.digests.iter().map(|digest| named(&all, digest)).collect::<Result<Vec<_>, _>>()?;
    for part in &found {
        store.remove_part(&part.digest).map_err(failed)?;
    }
    arguments.place.print(&found, || {
        found.iter().fold(String::new(), |mut text, part| {
            // Writing to a text cannot fail.
            let _ = writeln!(text, "removed {} of {} ({})", part.part, part.series, part.source);
            text
        })
    })?;
    Ok(Exit::Done)
}

fn named<'a>(all: &'a [PartSummary], digest: &str) -> Result<&'a PartSummary, Failure> {
    let wrong = |message: String| {
        let finding = Diagnostic::new(Problem::UnknownValue, message).field("DIGEST").value(digest);
        let finding =
            finding.allowed(format!("the beginning of one digest, {SHORTEST_DIGEST} digits or more"));
        Failure::new(Exit::BadInput, finding.way_out("list the parts: `flankwright store parts`"))
    };
    if digest.len() < SHORTEST_DIGEST {
        return Err(wrong("too short to name a part".into()));
    }
    let mut found = all.iter().filter(|part| part.digest.starts_with(digest));
    match (found.next(), found.next()) {
        (Some(part), None) => Ok(part),
        (None, _) => Err(wrong("the store has no such part".into())),
        _ => Err(wrong("more than one part has a digest that begins so".into())),
    }
}
