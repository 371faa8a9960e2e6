//! Chamfering of the tips of teeth, as a process: which tip land a chamfer of both flanks leaves. Small on purpose.

use erased_serde::Serialize as AnySerialize;
use flankwright::exchange::job::{Gear, JobInfo, Language};
use flankwright::exchange::{Diagnostic, Loaded, ProcessJob, checks};
use flankwright::geometry::Flank;
use flankwright::numerics::Progress;
use flankwright::report::{Block, FirstPage, Section, html};
use flankwright::verdict::{Remark, Verdict};
use flankwright::workflow::{
    Answer, DerivedGeometry, DocumentFormat, JobFailure, JobTitle, Process, RunFailure, Task, TaskOutcome,
    WriteError, gear_of_job, json, report_head, summary, write_with_report,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

/// A job of chamfering.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ChamferJob {
    /// Name and process.
    pub job: JobInfo,
    /// The workpiece.
    pub gear: Gear,
    /// The chamfer of both flanks.
    pub chamfer: Chamfer,
}

/// What is taken off the tip.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Chamfer {
    /// Width from the flank along the tip, mm.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10, "x-way-out" = "give the width in mm"))]
    pub width: f64,
    /// What must be left of the tip land, mm.
    #[schemars(extend("minimum" = 0, "maximum" = 100, "x-way-out" = "give the land in mm"))]
    pub least_land: f64,
}

impl ProcessJob for ChamferJob {
    const NAME: &'static str = "tip-chamfering";
    const ABOUT: &'static str = "Chamfering of the tips of teeth.";
    const TEMPLATE: &'static str = include_str!("template.toml");

    fn info(&self) -> &JobInfo {
        &self.job
    }

    fn contradictions(&self) -> Vec<Diagnostic> {
        let mut findings = Vec::new();
        checks::name(&self.job, &mut findings);
        checks::drawing(&self.gear, &mut findings);
        findings
    }
}

/// What stands in `result.json`.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ChamferResult {
    /// Name of the job.
    job: String,
    /// The process.
    process: &'static str,
    /// Tip land before chamfering.
    tip_land_mm: f64,
    /// Tip land that is left.
    land_left_mm: f64,
    #[serde(flatten)]
    verdict: Verdict,
}

/// What a run comes to.
struct ChamferOutcome {
    head: JobInfo,
    result: ChamferResult,
}

impl TaskOutcome for ChamferOutcome {
    fn job(&self) -> &str {
        &self.head.name
    }

    fn verdict(&self) -> Option<&Verdict> {
        Some(&self.result.verdict)
    }

    fn result(&self) -> &dyn AnySerialize {
        &self.result
    }

    fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
        let result = &self.result;
        let files = vec![("result.json".to_owned(), "tip land and verdict", json(result)?)];
        write_with_report(files, directory, |named| {
            let answer = Answer {
                process: "Tip chamfering",
                status: result.verdict.status(),
                reason: result.verdict.reason(),
                warnings: &[],
                headline: format!("The chamfers leave a tip land of {:.3} mm.", result.land_left_mm),
                figures: Vec::new(),
                first_page: FirstPage::default(),
            };
            let title = JobTitle::new(&self.head, Language::default());
            let text = format!("The tip land is {:.3} mm wide before chamfering.", result.tip_land_mm);
            let sections = vec![Section::new("tip-land", "Tip land", vec![Block::Paragraph(text)])];
            Ok(html::render(&report_head(title, answer, named).page(sections)))
        })
    }

    fn summary(&self, written: &[PathBuf], _: usize) -> String {
        let result = &self.result;
        let status = result.verdict.status().words();
        let mut text = format!("{}: tip land {:.3} mm, target {status}\n", result.job, result.land_left_mm);
        summary::closing(&mut text, &result.verdict, &[], &Default::default(), written);
        text
    }
}

/// The process.
pub struct TipChamfering;

/// Width of the tip land in the transverse section, mm: what both flanks of a space leave of a pitch.
fn tip_land(job: &ChamferJob) -> Result<f64, RunFailure> {
    let gear = gear_of_job(&job.gear).map_err(RunFailure::bad_input)?;
    let radius = 0.5 * job.gear.tip_diameter;
    let mut angle = TAU / f64::from(job.gear.teeth.abs());
    for flank in Flank::BOTH {
        let flank = gear.flank(flank);
        let roll = flank
            .length_of_roll(radius)
            .map_err(|error| RunFailure::bad_input(Diagnostic::of(&error).field("gear.tip_diameter")))?;
        let point = flank.point(roll, 0.0);
        angle -= (point.x / point.y).atan().abs();
    }
    Ok(radius * angle)
}

impl Process for TipChamfering {
    type Job = ChamferJob;

    fn title(&self) -> &'static str {
        "Tip chamfering"
    }

    fn tasks(&self) -> &'static [Task] {
        &[Task::Plan]
    }

    fn documents(&self) -> Vec<DocumentFormat> {
        vec![DocumentFormat::of::<ChamferResult>(ChamferJob::NAME, "result.json")]
    }

    fn carry_out(
        &self,
        _: Task,
        loaded: &Loaded<ChamferJob>,
        _: &dyn Progress,
    ) -> Result<Box<dyn TaskOutcome>, JobFailure> {
        let (job, land) = (&loaded.job, tip_land(&loaded.job)?);
        let left = land - 2.0 * job.chamfer.width;
        let least = job.chamfer.least_land;
        let mut verdict = Verdict::new();
        verdict.judge("tip land", left >= least, format!("{left:.3} of at least {least} mm"), || {
            let way_out = format!("take a chamfer of at most {:.3} mm", 0.5 * (land - least));
            Remark::new("land-too-narrow", format!("the chamfers leave a tip land of {left:.3} mm"), way_out)
        });
        verdict.leave("flanks", "chamfering does not touch them");
        let result = ChamferResult {
            job: job.job.name.clone(),
            process: ChamferJob::NAME,
            tip_land_mm: land,
            land_left_mm: left,
            verdict,
        };
        Ok(Box::new(ChamferOutcome { head: job.job.clone(), result }))
    }

    fn derived(&self, loaded: &Loaded<ChamferJob>) -> Result<(DerivedGeometry, Vec<Remark>), JobFailure> {
        let mut derived = DerivedGeometry::default();
        derived.section("tip");
        derived.quantity("tip_land_mm", "width of the tip land", tip_land(&loaded.job)?, "mm");
        Ok((derived, Vec::new()))
    }
}
