//! `flankwright store series`: statistics, trends and capability of what the store holds.

use std::collections::HashMap;
use std::path::Path;

use clap::Args;
use flankwright::exchange::{Diagnostic, Problem};
use flankwright::metrology::inspection::{SeriesPart, SeriesValue, SpecificationLimits};
use flankwright::workflow::inspection::series::{StoredPart, is_followed, series_of_stored};
use flankwright_store::{CharacteristicFilter, MeasuredCharacteristic};

use super::parts::PartsArguments;
use super::place::failed;
use crate::commands::measured_gear::deliver_series;
use crate::commands::page_language::LanguageArguments;
use crate::exit::Exit;
use crate::failure::Failure;

/// Arguments of `store series`.
#[derive(Args, Debug)]
#[command(after_help = "Example:\n  flankwright store series --series Z-17 --from 2026-03-01 -o trends\n\n\
    Writes series.json, series.csv and series.html as `inspect FOLDER` does, from the parts that are stored; sheets are drawn from files. \
    Limits are those that the parts were imported with. Exit status 3: a value is beyond its limit.")]
pub struct SeriesArguments {
    /// Which parts.
    #[command(flatten)]
    pub parts: PartsArguments,
    /// Language of the page.
    #[command(flatten)]
    pub language: LanguageArguments,
}

/// Evaluates the parts that the filter lets through.
pub fn run(arguments: &SeriesArguments) -> Result<Exit, Failure> {
    let store = arguments.parts.place.open_existing()?;
    let filter = arguments.parts.filter();
    let parts = store.parts(&filter).map_err(failed)?;
    if parts.is_empty() {
        let finding = Diagnostic::new(Problem::InvalidList, "the store has no such parts")
            .field("store series")
            .way_out("list what there is: `flankwright store parts`");
        return Err(Failure::new(Exit::BadInput, finding));
    }
    let values = CharacteristicFilter { parts: filter, ..arguments.parts.values() };
    let mut of_parts: HashMap<String, Vec<SeriesValue>> = HashMap::new();
    for value in store.characteristics(&values).map_err(failed)? {
        let of = &value.characteristic;
        if of.tooth.is_none() && is_followed(&of.name, &of.statistic) {
            of_parts.entry(value.digest.clone()).or_default().push(series_value(&value));
        }
    }
    let stored = parts.into_iter().map(|part| StoredPart {
        series: part.series,
        file: part.source,
        part: SeriesPart {
            label: part.part,
            time: part.date,
            values: of_parts.remove(&part.digest).unwrap_or_default(),
        },
    });
    let mut series = series_of_stored(stored.collect());
    series.language = arguments.language.given().unwrap_or_default();
    deliver_series(&series, Path::new("series.inspected"), &arguments.parts.place.common)
}

fn series_value(of: &MeasuredCharacteristic) -> SeriesValue {
    SeriesValue {
        key: of.characteristic.key(),
        unit: of.characteristic.unit.clone(),
        value: of.value,
        limits: SpecificationLimits::new(of.lower_limit, of.upper_limit).unwrap_or_default(),
    }
}
