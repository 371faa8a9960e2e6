//! The best fit of one flank at one diagonal ratio: the flank that is planned, the command that makes it, and its correction where the tool
//! touches.

use super::super::carried::RestFit;
use super::super::least_squares::{
    DiagonalCoordinates, FitQuality, FitReport, FlankCoordinates, FunctionClass, SplineGauge, WormFunctions,
};
use super::super::{GeneratingError, GrindingSetup};
use super::bases::{Bases, Place, Ranges};
use super::envelope::{Envelope, Section};
use super::smoother::{Rows, Smoother};
use contact::ContactSolution;
use foundation::geometry::Flank;
use foundation::kinematics::MotionLaw;
use foundation::numerics::extremes;
use std::sync::Arc;

/// Intervals of every function over the flank.
const INTERVALS: usize = 24;
/// Length over which the functions of the lines and of the feed go on beyond the flank, mm: the contact runs ahead by a few.
const BEYOND: f64 = 8.0;
/// Smoothness tried, from smooth to rough.
const SMOOTHNESS: [f64; 9] = [1e2, 1e1, 1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6];
/// Smoothness of a command, whose values are smooth already.
const COMMAND_SMOOTHNESS: f64 = 1e-5;
/// Rounds in which weights grow where a fit stands out.
const MINIMAX_ROUNDS: usize = 6;
/// Curvature of the planned flank over that of the gap: hollows stay well below 1, where the envelope breaks; crests keep a determinant ratio
/// of 0.3.
const CURVATURE: [f64; 2] = [-2.33, 0.7];
/// Share of the tolerance below which smoothness counts more than nearness.
const NEAR: f64 = 0.2;

/// What is to be fitted on one flank.
pub struct FlankFit<'a> {
    envelope: Envelope<'a>,
    bases: Bases,
    sections: Vec<Section>,
    w: &'a [f64],
    z: &'a [f64],
    wanted: &'a [f64],
    rows: Rows,
    tolerance: f64,
}

/// A flank that can be made.
#[derive(Clone, Debug)]
pub struct PlannedFlank {
    /// Its functions, mm, transverse.
    pub functions: WormFunctions,
    /// Its values on the grid.
    pub values: Vec<f64>,
    /// Largest distance to what is wanted, mm, transverse.
    pub off: f64,
    /// What it costs: 1 is the tolerance or a limit of the envelope.
    pub cost: f64,
}

impl<'a> FlankFit<'a> {
    /// `wanted` (transverse, mm) on the grid `w` x `z`, row-major, by the functions of `class` under the ratio of `shift`. `tolerance` is
    /// transverse, mm.
    ///
    /// # Errors
    /// `DirectionAlongPath`, `InvalidSpline`, `DegenerateDirection` where bodies have no contact of second order.
    pub fn new(
        setup: &'a GrindingSetup,
        flank: Flank,
        (class, ratio, shift): (FunctionClass, f64, &MotionLaw),
        (w, z): (&'a [f64], &'a [f64]),
        wanted: &'a [f64],
        tolerance: f64,
    ) -> Result<Self, GeneratingError> {
        let lines = &setup.lines[flank];
        let coordinates = if class.uses_lines() {
            DiagonalCoordinates::new(lines.work_direction(ratio), lines.t_k, 0.0)?
        } else {
            DiagonalCoordinates::radial(lines.t_k, 0.0)?
        };
        let corners = lines.corners().map(|(w, z)| coordinates.arguments(w, z));
        let ranges = Ranges {
            x: extremes(corners.iter().map(|a| a.x)),
            w: lines.roll,
            path: extremes(corners.iter().map(|a| a.path)),
            beyond: BEYOND,
        };
        let bases = Bases::new(class, &ranges, INTERVALS)?;
        let envelope = Envelope::new(setup, flank, coordinates, shift.clone(), ratio);
        let sections: Option<Vec<Section>> = w.iter().map(|&w| envelope.section(w)).collect();
        let sections = sections.ok_or(GeneratingError::DegenerateDirection { flank, ratio })?;
        let places: Vec<Place> = w
            .iter()
            .flat_map(|&w| z.iter().map(move |&z| (w, z)))
            .map(|(w, z)| envelope.unmoved(w, z))
            .collect();
        let rows = Rows::new(&bases, &places);
        Ok(Self { envelope, bases, sections, w, z, wanted, rows, tolerance })
    }

    fn points(&self) -> impl Iterator<Item = (&Section, f64, f64)> {
        self.w.iter().zip(&self.sections).flat_map(|(&w, s)| self.z.iter().map(move |&z| (s, w, z)))
    }

    /// The smoothest flank near what is wanted that the envelope allows, with `rounds` rounds in which weights grow where the fit stands out.
    /// `None` where nothing is finite.
    fn best(&self, rounds: usize) -> Option<PlannedFlank> {
        let mut best: Option<PlannedFlank> = None;
        for smoothness in SMOOTHNESS {
            let Some(planned) = self.planned(smoothness, rounds) else { continue };
            if best.as_ref().is_none_or(|known| planned.cost < known.cost) {
                best = Some(planned);
            }
            if best.as_ref().is_some_and(|known| known.cost <= NEAR) {
                break;
            }
        }
        best
    }

    /// The flank that is planned.
    pub fn plan(&self) -> Option<PlannedFlank> {
        self.best(MINIMAX_ROUNDS)
    }

    /// What a plan is about to cost: least squares alone.
    pub fn estimate(&self) -> f64 {
        self.best(0).map_or(f64::INFINITY, |planned| planned.cost)
    }

    fn planned(&self, smoothness: f64, rounds: usize) -> Option<PlannedFlank> {
        let smoother = Smoother { bases: &self.bases, rows: &self.rows };
        let x = smoother.fit_largest(self.wanted, smoothness, rounds)?;
        let functions = self.bases.functions(&x).ok()?;
        let values = self.rows.values(&x);
        let off = values.iter().zip(self.wanted).map(|(f, wanted)| (f - wanted).abs()).fold(0.0, f64::max);
        let curvature = extremes(
            self.points().flat_map(|(section, w, z)| self.envelope.foot(section, &functions, w, z).curvature),
        );
        let broken = f64::max(curvature[0] / CURVATURE[0], curvature[1] / CURVATURE[1]) - 1.0;
        let cost = (off / self.tolerance).max(NEAR) + 2.0 * broken.max(0.0);
        Some(PlannedFlank { functions, values, off, cost })
    }

    /// The coefficients of the command that makes a planned flank, from the predicted feet.
    pub fn command(&self, planned: &PlannedFlank) -> Option<Vec<f64>> {
        let (places, values): (Vec<Place>, Vec<f64>) = self
            .points()
            .map(|(section, w, z)| {
                let foot = self.envelope.foot(section, &planned.functions, w, z);
                (foot.place, foot.command)
            })
            .unzip();
        self.fitted(&places, &values)
    }

    fn fitted(&self, places: &[Place], values: &[f64]) -> Option<Vec<f64>> {
        let rows = Rows::new(&self.bases, places);
        let smoother = Smoother { bases: &self.bases, rows: &rows };
        smoother.fit(values, &vec![1.0; values.len()], COMMAND_SMOOTHNESS)
    }

    /// The command corrected where the tool touched: `at` are the contacts on the grid with their points (w_1, z_1) on the unmodified
    /// worm.
    pub fn corrected(
        &self,
        command: &[f64],
        planned: &PlannedFlank,
        at: &[(ContactSolution, (f64, f64))],
        cos_b2: f64,
    ) -> Option<Vec<f64>> {
        let places: Vec<Place> =
            at.iter().map(|(contact, foot)| self.envelope.place_of_contact(*foot, contact.feed)).collect();
        let rows = Rows::new(&self.bases, &places);
        let commanded = rows.values(command);
        let values: Vec<f64> = commanded
            .iter()
            .zip(&planned.values)
            .zip(at)
            .map(|((command, wanted), (contact, _))| command + wanted - contact.f_n / cos_b2)
            .collect();
        let smoother = Smoother { bases: &self.bases, rows: &rows };
        smoother.fit(&values, &vec![1.0; values.len()], COMMAND_SMOOTHNESS)
    }

    /// The functions of a command with their coordinates.
    ///
    /// # Errors
    /// `InvalidSpline`.
    pub fn decomposition(
        &self,
        command: &[f64],
        planned: &PlannedFlank,
    ) -> Result<Arc<RestFit>, GeneratingError> {
        let quality = FitQuality {
            largest: planned.off,
            tolerance_ratio: planned.off / self.tolerance,
            ..FitQuality::default()
        };
        let columns = self.bases.columns();
        Ok(Arc::new(RestFit {
            functions: self.bases.functions(command)?,
            coordinates: self.envelope.coordinates(),
            report: FitReport {
                points: self.wanted.len(),
                coefficients: columns,
                rank: columns,
                ambiguity: 0,
                least_squares: quality,
                minimax: None,
            },
            gauge: SplineGauge::MinimumNorm,
        }))
    }
}
