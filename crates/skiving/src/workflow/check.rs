//! `program check` of a job that measures a skiving tool: a text of any origin is read and followed on the machine; its recordings at the
//! light barrier or its scans are found by where the tool stands, and judged with the ways between them.

use super::prepare::{PreparedSkiving, ToolMounting, prepare_skiving};
use super::probe;
use super::program_work::{calibration_work, machining, measuring_work, probe_work, scan_work};
use super::programs::{
    TextBlocks, TextJudgement, ToolProgram, calibration_programs, check_calibration, check_measuring,
    check_probe, check_scan, check_skiving, looks_like_calibration, looks_like_probe, looks_like_scan,
    measuring_programs, probe_programs, scan_programs,
};
use super::run::measured_of_job;
use super::runout;
use crate::job::LoadedSkivingJob;
use foundation::numerics::Progress;
use job::machine::LoadedMachine;
use job::{Diagnostic, Problem};
use nc::Dialect;
use run::program_check::{CheckedMeasuring, CheckedProgram, ProgramCheck, checked_axes};
use run::{JobFailure, RunFailure};
use std::io::BufRead;

/// A job made ready, so that texts can be held against it one after the other.
pub struct SkivingCheck<'a> {
    prepared: PreparedSkiving,
    mounting: ToolMounting,
    machine: &'a LoadedMachine,
}

impl<'a> SkivingCheck<'a> {
    /// Prepares the job's tool and tracks.
    ///
    /// # Errors
    /// [`RunFailure`]: a job without a machine table or whose bodies cannot be.
    pub fn new(loaded: &LoadedSkivingJob, machine: &'a LoadedMachine) -> Result<Self, RunFailure> {
        let Some(given) = &loaded.job.machine else {
            let text = "a program can only be followed with the tool length and the retreat of the job";
            let finding = Diagnostic::new(Problem::MissingKey, text).field("machine");
            return Err(RunFailure::bad_input(finding.way_out("give the table [machine] in the job")));
        };
        Ok(Self { prepared: prepare_skiving(loaded)?, mounting: ToolMounting::of_job(given), machine })
    }

    /// The job's own programs but for a stroke, without the lines that tell its verdict.
    ///
    /// # Errors
    /// [`RunFailure`]: a machine that does not reach a pose, a text that is not proven.
    pub fn programs(&self) -> Result<Vec<ToolProgram>, RunFailure> {
        let prepared = &self.prepared;
        let machining = machining(prepared, &self.mounting, self.machine)?;
        let mut programs = measuring_programs(&measuring_work(prepared), &machining)?;
        if let Some(calibration) = &prepared.bodies.calibration {
            programs.extend(calibration_programs(
                &calibration_work(prepared, calibration, &self.mounting),
                &machining,
            )?);
        }
        if let Some(given) = &prepared.probe {
            let lengths = probe::lengths(&prepared.bodies, given.places);
            programs.extend(probe_programs(&probe_work(prepared, given, &lengths), &machining)?);
        }
        if let Some(given) = &prepared.stylus {
            let scan = super::scan::scan(&prepared.bodies, given, None)?;
            programs.extend(scan_programs(&scan_work(prepared, given, &scan), &machining)?);
        }
        Ok(programs)
    }

    /// What a text does to axes and measurement.
    ///
    /// # Errors
    /// [`RunFailure`]: a text that is no program for this machine, a job that the machine cannot carry out.
    pub fn check(&self, text: impl BufRead, dialect: Dialect) -> Result<CheckedProgram, RunFailure> {
        let prepared = &self.prepared;
        let (mut checked, words, blocks) = checked_axes(text, dialect, self.machine)?;
        let machining = machining(prepared, &self.mounting, self.machine)?;
        let text = TextBlocks { dialect, words: &words, blocks: &blocks };
        let scanned = prepared.stylus.as_ref().filter(|_| looks_like_scan(&machining, &text));
        let own_stroke = prepared.runout.is_some_and(|given| given.stroke.is_some());
        let measurement = if own_stroke { measured_of_job(prepared).map_err(of_readings)? } else { None };
        let law = runout::fitted(prepared, measurement.as_ref())?;
        let records = blocks.iter().any(|block| matches!(block, nc::Block::Output { .. }));
        let stroke = runout::stroke(prepared, measurement.as_ref(), law.as_ref(), None).filter(|_| !records);
        let probed = prepared.probe.as_ref().filter(|_| looks_like_probe(&machining, &text));
        let calibrated =
            prepared.bodies.calibration.as_ref().filter(|_| looks_like_calibration(&machining, &text));
        let (kind, judged) = match (&stroke, probed, calibrated, scanned) {
            (Some(stroke), ..) => ("skiving", check_skiving(stroke, &machining, &text)?),
            (None, Some(given), ..) => {
                let lengths = probe::lengths(&prepared.bodies, given.places);
                ("workpiece", check_probe(&probe_work(prepared, given, &lengths), &machining, &text)?)
            }
            (None, None, Some(calibration), _) => {
                let work = calibration_work(prepared, calibration, &self.mounting);
                ("calibration", check_calibration(&work, &machining, &text)?)
            }
            (None, None, None, Some(given)) => {
                let scan = super::scan::scan(&prepared.bodies, given, None)?;
                let work = scan_work(prepared, given, &scan);
                ("scan", check_scan(&work, &machining, &text)?)
            }
            (None, None, None, None) => {
                ("measuring", check_measuring(&measuring_work(prepared), &machining, &text)?)
            }
        };
        let TextJudgement { sound: [sound, wanted], difference, axis_distance, allowed, faults } = judged;
        checked.kind = Some(kind);
        // Limits of the axes are told with their blocks instead.
        checked.remarks = faults;
        let [difference_um, axis_distance_um, allowed_um] =
            [difference, axis_distance, allowed].map(|x| x * 1e3);
        let what = match kind {
            "scan" => "edges scanned",
            "calibration" => "ways of the mandrel driven",
            "skiving" => "strokes driven",
            "workpiece" => "profiles scanned",
            _ => "recordings made",
        };
        let touches = match kind {
            "calibration" => "the beam switches",
            "workpiece" => "the ball touches the flank",
            "skiving" => "the axes keep coupling, setting and law",
            _ => "the ideal tool touches",
        };
        checked.measuring = Some(CheckedMeasuring {
            wanted,
            sound,
            difference_um,
            axis_distance_um,
            allowed_um,
            statement: format!(
                "{sound} of {wanted} {what} as the job wants them; {touches} within {difference_um:.6} um of its nominal places, digits explain {allowed_um:.6} um"
            ),
            not_covered: [
                "bodies of the machine, of the light barrier's housing and of the workpiece",
                "what the tool's own errors do to the places of its switches",
                "ways on which axes do not keep to a straight line in rapid motion",
            ]
            .map(str::to_owned)
            .to_vec(),
        });
        Ok(checked)
    }
}

impl ProgramCheck for SkivingCheck<'_> {
    fn check(
        &self,
        text: &mut dyn BufRead,
        _: Option<&str>,
        dialect: Dialect,
        _: &dyn Progress,
    ) -> Result<CheckedProgram, RunFailure> {
        SkivingCheck::check(self, text, dialect)
    }
}

/// Readings that cannot be read, as a finding on the key that names them.
fn of_readings(failure: JobFailure) -> RunFailure {
    match failure {
        JobFailure::Job(failure) => failure,
        JobFailure::File(error) => {
            let finding = Diagnostic::new(Problem::InvalidTable, error.to_string()).field("readings.file");
            RunFailure::bad_input(finding.way_out("correct the table; the law of the stroke follows from it"))
        }
    }
}
