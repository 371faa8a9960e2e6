//! Studies of dressing: corrections and stretch over the profile crowning, the dressed profile, a dresser on other worms, strokes
//! and deviations of the axes (`docs/mathematics/dressing.md`). Knows no user interface.

mod axis_files;
mod bodies;
pub mod crowning;
pub mod deviations;
pub mod files;
pub mod profile;
pub mod strokes;
mod worm_files;
pub mod worms;

pub use crowning::{CrowningCurve, CrowningPoint, CurveEnd};
pub use deviations::{AxisInfluence, DeviationCurve, DeviationQuantile};
pub use files::write_dressing_study;
pub use profile::ProfileCurve;
pub use strokes::{StrokeCurve, StrokeFigures};
pub use worms::{BothFlanks, WormCurve, WormOfLeastStretch, WormPoint};

use crate::job::{DressingStudy, LoadedJob, Steps, StudyOver};
use bodies::Bodies;
use foundation::numerics::Progress;
use job::{Diagnostic, Problem};
use rayon::prelude::*;
use report::PageHead;
use run::{Conclusion, JobTitle, RunFailure, TaskOutcome, WriteError};
use schemars::JsonSchema;
use serde::Serialize;
use std::path::{Path, PathBuf};
use verdict::Verdict;
use worms::Along;

/// What a study found: the document of `explore.json`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DressingStudyOutcome {
    /// Head of its page.
    #[serde(skip)]
    pub head: PageHead,
    /// Name of the job.
    pub job: String,
    /// Process.
    pub process: String,
    /// Version of flankwright.
    pub version: &'static str,
    /// What runs along the abscissa.
    pub over: &'static str,
    /// Flank of the worm.
    pub flank: &'static str,
    /// The curves.
    #[serde(flatten)]
    pub curves: StudyCurves,
}

/// The curves of a study.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum StudyCurves {
    /// Over the crowning.
    Crowning(Vec<CrowningCurve>),
    /// Over the length of roll.
    Profile(Vec<ProfileCurve>),
    /// Over the diameter or the pressure angle of the worm.
    Worms(Vec<WormCurve>),
    /// In several strokes.
    Strokes(Vec<StrokeCurve>),
    /// Changes by deviations of the axes.
    Deviations(Vec<DeviationCurve>),
}

impl DressingStudyOutcome {
    /// Whether at least one curve has points.
    pub fn is_producible(&self) -> bool {
        match &self.curves {
            StudyCurves::Crowning(curves) => curves.iter().any(|c| !c.points.is_empty()),
            StudyCurves::Profile(curves) => curves.iter().any(|c| c.refused.is_none()),
            StudyCurves::Worms(curves) => curves.iter().any(|c| !c.points.is_empty()),
            StudyCurves::Strokes(curves) => curves.iter().any(|c| c.refused.is_none()),
            StudyCurves::Deviations(curves) => curves.iter().any(|c| c.refused.is_none()),
        }
    }

    /// The study in a few lines of text.
    pub fn summary(&self) -> String {
        let mut text = format!("{}: dressing of the {} flank over {}\n", self.job, self.flank, self.over);
        for (name, says) in self.lines() {
            let name = if name.is_empty() { "worm and dresser of the job" } else { name };
            text += &format!("  {name:<24} {says}\n");
        }
        text
    }

    fn lines(&self) -> Vec<(&str, String)> {
        match &self.curves {
            StudyCurves::Crowning(curves) => {
                curves.iter().map(|c| (c.bodies.as_str(), c.summary())).collect()
            }
            StudyCurves::Profile(curves) => curves.iter().map(|c| (c.name.as_str(), c.summary())).collect(),
            StudyCurves::Worms(curves) => curves.iter().map(|c| (c.bodies.as_str(), c.summary())).collect(),
            StudyCurves::Strokes(curves) => curves.iter().map(|c| (c.bodies.as_str(), c.summary())).collect(),
            StudyCurves::Deviations(curves) => {
                curves.iter().map(|c| (c.bodies.as_str(), c.summary())).collect()
            }
        }
    }
}

/// Carries out the dressing study of a job.
///
/// # Errors
/// A finding where the job has no such study; bodies that are impossible are curves that say why.
pub fn study_dressing(
    loaded: &LoadedJob,
    progress: &dyn Progress,
) -> Result<DressingStudyOutcome, RunFailure> {
    let study =
        loaded.job.explore.as_ref().and_then(|explore| explore.dressing.as_ref()).ok_or_else(|| {
            let finding = Diagnostic::new(Problem::MissingKey, "the job has no study of dressing")
                .field("explore.dressing")
                .way_out("add a table [explore.dressing] with `over`");
            RunFailure::bad_input(finding)
        })?;
    let flank = study.flank;
    let compare = study.compare.as_ref();
    let worms = |along: Along, steps: Option<Steps>| -> Result<StudyCurves, RunFailure> {
        let steps = steps.ok_or_else(|| missing(study))?;
        let study = worms::Study { loaded, flank, along, steps, diameter: study.at_worm_pitch_diameter };
        let all = worms::Study::curves(compare);
        Ok(StudyCurves::Worms(of_each(&all, progress, |changes| study.curve(changes))))
    };
    let curves = match study.over {
        StudyOver::Crowning => {
            let all = Bodies::compared(loaded, compare);
            let land = loaded.job.dresser.as_ref().and_then(|d| d.tip_land);
            let curve = |bodies: &Bodies| crowning::curve(bodies, flank, study.crowning_um.as_ref(), land);
            StudyCurves::Crowning(of_each(&all, progress, curve))
        }
        StudyOver::Profile => {
            let steps = study.crowning_um.ok_or_else(|| missing(study))?;
            let all = Bodies::compared(loaded, compare);
            let curves = of_each(&all, progress, |bodies| profile::curves(bodies, flank, &steps));
            StudyCurves::Profile(curves.into_iter().flatten().collect())
        }
        StudyOver::WormDiameter => worms(Along::Diameter, study.worm_pitch_diameter)?,
        StudyOver::PressureAngle => worms(Along::PressureAngle, study.normal_pressure_angle_deg)?,
        StudyOver::Strokes => {
            let given = study.strokes.as_ref().ok_or_else(|| missing(study))?;
            let all = Bodies::compared(loaded, compare);
            StudyCurves::Strokes(of_each(&all, progress, |bodies| strokes::curve(bodies, flank, given)))
        }
        StudyOver::Deviations => {
            let given = study.deviations.as_ref().ok_or_else(|| missing(study))?;
            let all = Bodies::compared(loaded, compare);
            StudyCurves::Deviations(of_each(&all, progress, |bodies| deviations::curve(bodies, flank, given)))
        }
    };
    let title = JobTitle::new(&loaded.job.job, loaded.job.output.language);
    Ok(DressingStudyOutcome {
        head: title.head(&format!("Generating grinding, study of dressing: {}", study.over.words())),
        job: loaded.job.job.name.clone(),
        process: loaded.job.job.process.name().to_string(),
        version: env!("CARGO_PKG_VERSION"),
        over: study.over.name(),
        flank: flank.name(),
        curves,
    })
}

/// The finding on a study without the key of its abscissa; a job that was read has it.
fn missing(study: &DressingStudy) -> RunFailure {
    let text = format!("a study over \"{}\" needs the key that belongs to it", study.over.name());
    let finding = Diagnostic::new(Problem::MissingKey, text).field("explore.dressing");
    RunFailure::bad_input(finding.way_out("add it; examples/dressing shows how"))
}

/// What `study` finds for each entry, in their order.
fn of_each<B: Sync, T: Send>(all: &[B], progress: &dyn Progress, study: impl Fn(&B) -> T + Sync) -> Vec<T> {
    progress.start("curves", all.len() as u64);
    let found = all
        .par_iter()
        .map(|bodies| {
            let found = study(bodies);
            progress.advance(1);
            found
        })
        .collect();
    progress.finish();
    found
}

impl TaskOutcome for DressingStudyOutcome {
    fn job(&self) -> &str {
        &self.job
    }

    fn verdict(&self) -> Option<&Verdict> {
        None
    }

    fn result(&self) -> &dyn erased_serde::Serialize {
        self
    }

    fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
        write_dressing_study(self, directory)
    }

    fn summary(&self, written: &[PathBuf], _: usize) -> String {
        let mut text = DressingStudyOutcome::summary(self);
        if let Some(page) = written.last() {
            text += &format!("  report: {}\n", page.display());
        }
        text
    }

    fn conclusion(&self) -> Conclusion {
        if self.is_producible() { Conclusion::Done } else { Conclusion::NotProducible }
    }
}
