//! The result of a task: verdict, document, files. Each process supplies its own.

use crate::exchange::{LoadedGearboxJob, LoadedJob, LoadedMillingJob, LoadedSkivingJob, LoadedTangentialJob};
use crate::workflow::gearbox::{GearboxOutcome, write_gearbox};
use crate::workflow::inspection::{GearInspection, SheetOptions, write_gear_inspection};
use crate::workflow::milling::{MillingOutcome, write_milling};
use crate::workflow::scene::{
    Scene, scene_of_grinding, scene_of_milling, scene_of_skiving, scene_of_tangential,
};
use crate::workflow::skiving::{SkivingOutcome, write_skiving};
use crate::workflow::tangential::{TangentialOutcome, write_tangential};
use crate::workflow::{
    CatalogueOutcome, DressingStudyOutcome, ExploreOutcome, FreeOutcome, Outcome, RunFailure, Status,
    WriteError, write_catalogue, write_dressing_study, write_exploration, write_free_study, write_outcome,
};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// A task that was carried out, with the job that it was carried out for.
#[expect(clippy::large_enum_variant, reason = "a caller holds one")]
pub enum Completed {
    /// Plan or simulation of generating grinding; the ranking, where the bodies come from a catalogue.
    Grinding(LoadedJob, Box<Outcome>, Option<Box<CatalogueOutcome>>),
    /// Plan or simulation of tangential dressing.
    Tangential(LoadedTangentialJob, Box<TangentialOutcome>),
    /// A plan of five-axis milling.
    Milling(LoadedMillingJob, Box<MillingOutcome>),
    /// A measured skiving tool.
    Skiving(LoadedSkivingJob, Box<SkivingOutcome>),
    /// A run of the electronic gearbox.
    Gearbox(LoadedGearboxJob, Box<GearboxOutcome>),
    /// Diagonal ratios and worms side by side.
    Exploration(Box<ExploreOutcome>),
    /// Pairs of a catalogue, ranked.
    Catalogue(Box<CatalogueOutcome>),
    /// A free quantity of the worms of a catalogue.
    FreeWorm(Box<FreeOutcome>),
    /// A study of dressing.
    DressingStudy(Box<DressingStudyOutcome>),
    /// The simulated machine of a job, measured and corrected.
    Inspection(Box<GearInspection>),
}

impl Completed {
    /// The verdict; studies have none.
    pub fn status(&self) -> Option<Status> {
        match self {
            Self::Grinding(_, outcome, _) => Some(outcome.result.verdict.status()),
            Self::Tangential(_, outcome) => Some(outcome.result.verdict.status()),
            Self::Milling(_, outcome) => Some(outcome.result.verdict.status()),
            Self::Skiving(_, outcome) => Some(outcome.result.verdict.status()),
            Self::Gearbox(_, outcome) => Some(outcome.result.verdict.status()),
            Self::Inspection(found) => Some(found.result.verdict.status()),
            Self::Exploration(_) | Self::Catalogue(_) | Self::FreeWorm(_) | Self::DressingStudy(_) => None,
        }
    }

    /// The document of `result.json` or `explore.json`.
    ///
    /// # Errors
    /// A value that JSON cannot hold.
    pub fn document(&self) -> Result<Value, serde_json::Error> {
        match self {
            Self::Grinding(_, outcome, _) => serde_json::to_value(&outcome.result),
            Self::Tangential(_, outcome) => serde_json::to_value(&outcome.result),
            Self::Milling(_, outcome) => serde_json::to_value(&outcome.result),
            Self::Skiving(_, outcome) => serde_json::to_value(&outcome.result),
            Self::Gearbox(_, outcome) => serde_json::to_value(&outcome.result),
            Self::Exploration(outcome) => serde_json::to_value(outcome),
            Self::Catalogue(outcome) => serde_json::to_value(outcome),
            Self::FreeWorm(outcome) => serde_json::to_value(outcome),
            Self::DressingStudy(outcome) => serde_json::to_value(outcome),
            Self::Inspection(found) => serde_json::to_value(&found.result),
        }
    }

    /// Bodies and motions for a view in space; `None` where nothing moves that could be seen.
    ///
    /// # Errors
    /// Bodies that cannot be drawn, with a finding as for a job.
    pub fn scene(&self) -> Option<Result<Scene, RunFailure>> {
        match self {
            Self::Grinding(loaded, outcome, _) => Some(scene_of_grinding(loaded, outcome)),
            Self::Tangential(loaded, outcome) => Some(scene_of_tangential(loaded, outcome)),
            Self::Milling(loaded, outcome) => Some(scene_of_milling(loaded, outcome)),
            Self::Skiving(loaded, outcome) => Some(scene_of_skiving(loaded, outcome)),
            Self::Gearbox(..)
            | Self::Exploration(_)
            | Self::Catalogue(_)
            | Self::FreeWorm(_)
            | Self::DressingStudy(_)
            | Self::Inspection(_) => None,
        }
    }

    /// Writes all files into `directory` (made if missing); returns their paths, the page last.
    ///
    /// # Errors
    /// [`WriteError`]; files written before the error stay.
    pub fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
        match self {
            Self::Grinding(loaded, outcome, ranking) => {
                let mut written = match ranking {
                    Some(ranking) => write_catalogue(ranking, directory)?,
                    None => Vec::new(),
                };
                written.extend(write_outcome(loaded, outcome, directory)?);
                Ok(written)
            }
            Self::Tangential(loaded, outcome) => write_tangential(loaded, outcome, directory),
            Self::Milling(loaded, outcome) => write_milling(&loaded.job, outcome, directory),
            Self::Skiving(loaded, outcome) => write_skiving(&loaded.job, outcome, directory),
            Self::Gearbox(loaded, outcome) => write_gearbox(&loaded.job, outcome, directory),
            Self::Exploration(outcome) => write_exploration(outcome, directory),
            Self::Catalogue(outcome) => write_catalogue(outcome, directory),
            Self::FreeWorm(outcome) => write_free_study(outcome, directory),
            Self::DressingStudy(outcome) => write_dressing_study(outcome, directory),
            Self::Inspection(found) => write_gear_inspection(found, &SheetOptions::default(), directory),
        }
    }
}
