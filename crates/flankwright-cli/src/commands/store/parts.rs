//! `flankwright store parts`: what was measured.

use clap::Args;
use flankwright::geometry::Flank;
use flankwright_store::{CharacteristicFilter, MeasuredCharacteristic, PartFilter, PartSummary};

use super::place::{PlaceArguments, failed};
use super::table::{or_dash, table};
use crate::exit::Exit;
use crate::failure::Failure;

/// Arguments of `store parts`.
#[derive(Args, Debug)]
#[command(
    after_help = "Example:\n  flankwright store parts --series Z-17 --characteristic fHa --statistic mean --flank left\n\n\
    In the order in which the parts were measured; without a date last. With --characteristic the values of that symbol, with their limits."
)]
pub struct PartsArguments {
    /// Parts of this series
    #[arg(long, value_name = "NAME")]
    pub series: Option<String>,
    /// The part of this number
    #[arg(long, value_name = "NUMBER")]
    pub part: Option<String>,
    /// Parts of this drawing
    #[arg(long, value_name = "NUMBER")]
    pub drawing: Option<String>,
    /// Measured on this machine
    #[arg(long, value_name = "NAME")]
    pub machine: Option<String>,
    /// Measured on this day or later: YYYY-MM-DD, also with THH:MM:SS
    #[arg(long, value_name = "DATE")]
    pub from: Option<String>,
    /// Measured on this day or earlier
    #[arg(long, value_name = "DATE")]
    pub to: Option<String>,
    /// Values of this symbol instead of parts, e.g. fHa, ffb, Fp, Fr
    #[arg(long, value_name = "SYMBOL")]
    pub characteristic: Option<String>,
    /// Values of this flank
    #[arg(long, requires = "characteristic", value_parser = ["left", "right"])]
    pub flank: Option<String>,
    /// single, mean, range or max
    #[arg(long, requires = "characteristic", value_name = "WORD")]
    pub statistic: Option<String>,
    /// Store, and arguments that every command has.
    #[command(flatten)]
    pub place: PlaceArguments,
}

impl PartsArguments {
    /// The parts that are asked for.
    pub fn filter(&self) -> PartFilter {
        PartFilter {
            series: self.series.clone(),
            part: self.part.clone(),
            drawing: self.drawing.clone(),
            machine: self.machine.clone(),
            from: self.from.clone(),
            to: self.to.clone(),
            newest: None,
        }
    }

    /// The values that are asked for, of any part.
    pub fn values(&self) -> CharacteristicFilter {
        let flank = Flank::BOTH.into_iter().find(|flank| self.flank.as_deref() == Some(flank.name()));
        let (name, statistic) = (self.characteristic.clone(), self.statistic.clone());
        CharacteristicFilter { parts: PartFilter::default(), name, flank, statistic }
    }
}

/// Lists parts or values.
pub fn run(arguments: &PartsArguments) -> Result<Exit, Failure> {
    let store = arguments.place.open_existing()?;
    let parts = arguments.filter();
    if arguments.characteristic.is_some() {
        let filter = CharacteristicFilter { parts, ..arguments.values() };
        let values = store.characteristics(&filter).map_err(failed)?;
        arguments.place.print(&values, || text_of_values(&values))?;
    } else {
        let parts = store.parts(&parts).map_err(failed)?;
        arguments.place.print(&parts, || text_of_parts(&parts))?;
    }
    Ok(Exit::Done)
}

fn text_of_parts(parts: &[PartSummary]) -> String {
    let row = |part: &PartSummary| {
        vec![
            or_dash(part.date.as_deref()),
            part.series.clone(),
            part.part.clone(),
            or_dash(part.machine.as_deref()),
            part.source.clone(),
            part.digest.chars().take(12).collect(),
        ]
    };
    let rows: Vec<Vec<String>> = parts.iter().map(row).collect();
    format!("{} parts\n", parts.len())
        + &table(&["date", "series", "part", "machine", "file", "digest"], &rows)
}

fn text_of_values(values: &[MeasuredCharacteristic]) -> String {
    let limit = |limit: Option<f64>| limit.map_or_else(|| "-".to_owned(), |limit| limit.to_string());
    let row = |one: &MeasuredCharacteristic| {
        vec![
            or_dash(one.date.as_deref()),
            one.part.clone(),
            one.characteristic.key(),
            format!("{:.3}", one.value),
            one.characteristic.unit.clone(),
            limit(one.lower_limit),
            limit(one.upper_limit),
        ]
    };
    let rows: Vec<Vec<String>> = values.iter().map(row).collect();
    format!("{} values\n", values.len())
        + &table(&["date", "part", "characteristic", "value", "unit", "lower", "upper"], &rows)
}
