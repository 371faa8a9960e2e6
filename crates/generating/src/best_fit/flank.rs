//! The best fit of one flank at one diagonal ratio: a flank that can be made, the command that makes it, and the next command where the tool
//! touches.

use super::super::carried::{FittedFlank, RestFit};
use super::super::least_squares::{
    DiagonalCoordinates, FitQuality, FitReport, FlankCoordinates, FunctionClass, SplineGauge, WormFunctions,
};
use super::super::{GeneratingError, GrindingSetup};
use super::bases::{Bases, Place, Ranges};
use super::envelope::{Envelope, Section};
use super::programme::{AxisShares, Curvature, FlankProgramme, Held, Limits, Reach};
use super::smoother::{Rows, Smoother};
use super::within::{NEAR, Within};
use contact::ContactSolution;
use foundation::geometry::Flank;
use foundation::kinematics::{MotionLaw, PiecewisePolynomial};
use foundation::numerics::extremes;
use std::sync::Arc;

/// Length over which the functions of the lines and of the feed go on beyond the flank, mm: the contact runs ahead by a few.
const BEYOND: f64 = 8.0;
/// Where the envelope is looked at beyond the ends of the flank, mm.
const BESIDE: [f64; 3] = [1.5, 3.5, 6.0];
/// Smoothness tried for a planned flank, from smooth to rough.
const SMOOTHNESS: [f64; 9] = [1e2, 1e1, 1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6];
/// Smoothness of the flank of the class next to another.
const ROUGHEST: f64 = 1e-6;
/// Weight of the second differences beyond the flank over that of the smoothness, where least squares tell what a programme costs.
const BEYOND_BY_SMOOTHNESS: f64 = 10.0;
/// Curvature of a planned flank over that of the gap: hollows stay well below 1, where the envelope breaks; crests keep a determinant ratio of
/// 0.3.
const CURVATURE: [f64; 2] = [-2.33, 0.7];

/// Determinant ratio below which a place is remembered; how far apart such places are at least, in knots, and how many there are at most.
const NEARLY_FOLDED: f64 = 0.25;
const APART: f64 = 0.5;
const MOST_FOLDS: usize = 400;

/// A contact with its point on the unmodified worm.
pub type Contact = (ContactSolution, (f64, f64));

/// Contacts at some points of the grid.
pub type SomeContacts = Vec<(usize, Contact)>;

/// What is to be fitted on one flank.
pub struct FlankFit<'a> {
    envelope: Envelope<'a>,
    bases: Bases,
    sections: Vec<Section>,
    w: &'a [f64],
    z: &'a [f64],
    wanted: &'a [f64],
    weights: &'a [f64],
    rows: Rows,
    within: Within,
    axes: &'a AxisShares,
    reach: Option<Reach>,
    beside: Vec<(Place, Section)>,
}

/// A flank near what is wanted that can be made, in second order.
struct PlannedFlank {
    functions: WormFunctions,
    /// What it costs: 1 is the tolerance or a limit of the envelope.
    cost: f64,
}

/// How the next command follows one.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// Share of what is wanted.
    pub share: f64,
    /// Price of touching elsewhere.
    pub hold: f64,
    /// Share of the tolerance below which smoothness counts more than nearness.
    pub near: f64,
}

/// Where commands that were tried nearly folded.
#[derive(Clone, Debug, Default)]
pub struct Folds(Vec<(Place, Section)>);

/// A command on its way to the flank that is wanted.
#[derive(Clone, Debug)]
pub struct FlankCommand {
    /// Coefficients, mm, transverse.
    pub coefficients: Vec<f64>,
    /// What it is expected to cost: 1 is the tolerance or a limit.
    pub cost: f64,
}

impl FlankCommand {
    /// The solution of a programme.
    fn of(programme: &FlankProgramme<'_>) -> Option<Self> {
        let (coefficients, cost) = programme.solve()?;
        Some(Self { coefficients, cost })
    }

    /// The command in the middle between two.
    pub fn halfway(&self, to: &Self) -> Self {
        let middle = |(a, b): (&f64, &f64)| 0.5 * (a + b);
        let coefficients = self.coefficients.iter().zip(&to.coefficients).map(middle).collect();
        Self { coefficients, cost: to.cost }
    }
}

impl<'a> FlankFit<'a> {
    /// `wanted` (transverse, mm) on the grid `w` x `z`, row-major, by the functions of `class` under the ratio of `shift`, with `intervals`
    /// over the flank. `weights` are the tightest tolerance over that of each place. `within` has the
    /// tolerance transverse, mm; `limits` are the lengths of roll between which contacts are kept on the worm.
    ///
    /// # Errors
    /// `DirectionAlongPath`, `InvalidSpline`, `DegenerateDirection` where bodies have no contact of second order.
    pub fn new(
        setup: &'a GrindingSetup,
        flank: Flank,
        (class, ratio, shift): (FunctionClass, f64, &MotionLaw),
        (w, z): (&'a [f64], &'a [f64]),
        (wanted, weights): (&'a [f64], &'a [f64]),
        (within, axes, limits): (Within, &'a AxisShares, Option<[f64; 2]>),
        intervals: usize,
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
        let bases = Bases::new(class, &ranges, intervals)?;
        let envelope = Envelope::new(setup, flank, coordinates, shift.clone(), ratio);
        let sections: Option<Vec<Section>> = w.iter().map(|&w| envelope.section(w)).collect();
        let sections = sections.ok_or(GeneratingError::DegenerateDirection { flank, ratio })?;
        let places: Vec<Place> = w
            .iter()
            .flat_map(|&w| z.iter().map(move |&z| (w, z)))
            .map(|(w, z)| envelope.unmoved(w, z))
            .collect();
        let rows = Rows::new(&bases, &places);
        let ends = extremes(z.iter().copied());
        let out = |by: f64| [ends[0] - by, ends[1] + by];
        let beside = w.iter().zip(&sections).step_by(2).flat_map(|(&w, section)| {
            BESIDE.into_iter().flat_map(out).map(|z| (envelope.unmoved(w, z), *section)).collect::<Vec<_>>()
        });
        let beside = beside.collect();
        let reach = limits
            .map(|limits| Reach { limits, unmodified: w.iter().map(|&w| envelope.worm_roll(w)).collect() });
        Ok(Self { envelope, bases, sections, w, z, wanted, weights, rows, within, axes, reach, beside })
    }

    fn points(&self) -> impl Iterator<Item = (&Section, f64, f64)> {
        self.w.iter().zip(&self.sections).flat_map(|(&w, s)| self.z.iter().map(move |&z| (s, w, z)))
    }

    /// The flank of least squares of least cost, from smooth to rough until curvature alone costs more; `None` where nothing is finite.
    fn planned(&self, share: f64, near: f64) -> Option<PlannedFlank> {
        let smoother = self.smoother();
        let mut best: Option<PlannedFlank> = None;
        for smoothness in SMOOTHNESS {
            let Some(x) = smoother.fit(smoothness, 0.0) else { continue };
            let Some((planned, bent)) = self.planned_by(x, share, near) else { continue };
            if best.as_ref().is_some_and(|known| known.cost <= bent) {
                break;
            }
            if best.as_ref().is_none_or(|known| planned.cost < known.cost) {
                best = Some(planned);
            }
        }
        best
    }

    fn smoother(&self) -> Smoother<'_> {
        Smoother::new(&self.bases, &self.rows, self.wanted)
    }

    /// A share of the flank with these coefficients, and what its curvature costs.
    fn planned_by(&self, mut x: Vec<f64>, share: f64, near: f64) -> Option<(PlannedFlank, f64)> {
        x.iter_mut().for_each(|x| *x *= share);
        let functions = self.bases.functions(&x).ok()?;
        let curvature = extremes(
            self.points().flat_map(|(section, w, z)| self.envelope.foot(section, &functions, w, z).curvature),
        );
        let bent = f64::max(curvature[0] / CURVATURE[0], curvature[1] / CURVATURE[1]);
        let cost = (NEAR / near * self.missed_by(&x, share)).max(bent);
        Some((PlannedFlank { functions, cost }, bent))
    }

    /// What a flank with these coefficients leaves of a share of what is wanted, in tolerances.
    fn missed_by(&self, x: &[f64], share: f64) -> f64 {
        let values = self.rows.values(x);
        let off = values.iter().zip(self.wanted).map(|(f, wanted)| f - share * wanted);
        self.largest(off) / self.within.tolerance
    }

    /// The places of the unmodified contact.
    fn unmoved(&self) -> Vec<(Place, Section)> {
        self.points().map(|(section, w, z)| (self.envelope.unmoved(w, z), *section)).collect()
    }

    /// What a plan is about to cost: the programme for the flank, to first order.
    pub fn estimate(&self) -> f64 {
        let programmed = self.programmed(&self.unmoved(), self.wanted, (Curvature::FLANK, NEAR, None));
        programmed.map_or(f64::INFINITY, |programmed| programmed.cost)
    }

    /// A lower bound of what is left of the target, in tolerances, to first order: any flank of the class within the limits.
    pub fn least(&self, least_determinant: f64, limits: Limits) -> Option<f64> {
        let places = self.unmoved();
        let rules = (Curvature::possible(least_determinant), NEAR, None);
        // What lies beside the face is bounded for the sake of the contact, not of the flank.
        FlankProgramme { beside: &[], ..self.programme(&places, self.wanted, rules) }.least_excess(limits)
    }

    /// How far a flank lies from the class, transverse, mm: `flank` are its values on the grid, transverse, mm.
    pub fn beyond_class(&self, flank: &[f64]) -> Option<f64> {
        let x = Smoother::new(&self.bases, &self.rows, flank).fit(ROUGHEST, 0.0)?;
        Some(self.largest(self.rows.values(&x).iter().zip(flank).map(|(of_class, f)| f - of_class)))
    }

    /// No less than that, by least squares, in a fraction of the time.
    pub fn quick_estimate(&self) -> f64 {
        let places = self.unmoved();
        let programme = self.programme(&places, self.wanted, (Curvature::FLANK, NEAR, None));
        let smoother = self.smoother();
        let cost = |smoothness: f64| {
            let x = smoother.fit(smoothness, BEYOND_BY_SMOOTHNESS * smoothness)?;
            programme.cost_of(&x, self.missed_by(&x, 1.0))
        };
        SMOOTHNESS.into_iter().filter_map(cost).fold(f64::INFINITY, f64::min)
    }

    /// The command that makes a share of what is wanted, smooth within `near` tolerances, from the predicted feet of a planned flank.
    pub fn command(&self, share: f64, near: f64) -> Option<FlankCommand> {
        let planned = self.planned(share, near)?;
        let (places, values): (Vec<_>, Vec<f64>) = self
            .points()
            .zip(self.wanted)
            .map(|((section, w, z), wanted)| {
                let foot = self.envelope.foot(section, &planned.functions, w, z);
                let there = self.envelope.section(foot.w).unwrap_or(*section);
                ((foot.place, there), share * wanted - foot.lift)
            })
            .unzip();
        self.programmed(&places, &values, (Curvature::COMMAND, near, None))
    }

    fn programmed(
        &self,
        places: &[(Place, Section)],
        wanted: &[f64],
        rules: (Curvature, f64, Option<Held<'_>>),
    ) -> Option<FlankCommand> {
        FlankCommand::of(&self.programme(places, wanted, rules))
    }

    fn programme<'p>(
        &'p self,
        places: &'p [(Place, Section)],
        wanted: &'p [f64],
        (curvature, near, held): (Curvature, f64, Option<Held<'p>>),
    ) -> FlankProgramme<'p> {
        FlankProgramme {
            envelope: &self.envelope,
            bases: &self.bases,
            places,
            beside: &self.beside,
            row: self.z.len(),
            wanted,
            weights: self.weights,
            within: &self.within,
            near,
            curvature,
            axes: self.axes,
            reach: self.reach.as_ref(),
            held,
            folded: &[],
        }
    }

    /// The places at which the tool touched, by the contacts on the grid.
    fn touched(&self, at: &[Contact]) -> Vec<(Place, Section)> {
        at.iter().enumerate().map(|(point, contact)| self.touched_at(point, contact)).collect()
    }

    /// The place at which the tool touched one point of the grid.
    fn touched_at(&self, point: usize, (contact, foot): &Contact) -> (Place, Section) {
        let (row, column) = (point / self.z.len(), point % self.z.len());
        let section = &self.sections[row];
        let at = (self.w[row], self.z[column]);
        let there = self.envelope.section(self.envelope.roll_of_contact(section, at, *foot));
        (self.envelope.place_of_contact(*foot, contact.feed), there.unwrap_or(*section))
    }

    /// Determinant ratios of a command where the tool touched and between, in second order.
    fn determinants(&self, command: &FlankCommand, at: &[Contact]) -> Option<Vec<((Place, Section), f64)>> {
        let places = self.touched(at);
        let rules = (Curvature::COMMAND, NEAR, None);
        self.programme(&places, self.wanted, rules).determinants(&command.coefficients)
    }

    /// The least of them; `None` where the gap is not open.
    pub fn least_between(&self, command: &FlankCommand, at: &[Contact]) -> Option<f64> {
        let least = |least: f64, (_, one): ((Place, Section), f64)| f64::min(least, one);
        Some(self.determinants(command, at)?.into_iter().fold(f64::INFINITY, least))
    }

    /// Notes where a command nearly folds: at the contacts of a tool, known at some points of the grid, and between them where all are.
    pub fn note_folds(&self, command: &FlankCommand, at: &SomeContacts, folds: &mut Folds) {
        let few = at.iter().filter(|(_, (contact, _))| contact.determinant_ratio < NEARLY_FOLDED);
        let touched =
            few.map(|(point, contact)| (self.touched_at(*point, contact), contact.0.determinant_ratio));
        let mut places: Vec<((Place, Section), f64)> = touched.collect();
        if at.len() == self.wanted.len() {
            let all: Vec<Contact> = at.iter().map(|(_, contact)| *contact).collect();
            let between = self.determinants(command, &all).into_iter().flatten();
            places.extend(between.filter(|(_, ratio)| *ratio < NEARLY_FOLDED));
        }
        places.sort_by(|a, b| a.1.total_cmp(&b.1));
        for (place, _) in places {
            if folds.0.len() == MOST_FOLDS {
                break;
            }
            if folds.0.iter().all(|(other, _)| self.bases.apart(&place.0, other) > APART) {
                folds.0.push(place);
            }
        }
    }

    /// The next command, for a share of what is wanted, from where the tool touched: `at` are the contacts on the grid with their points
    /// (w_1, z_1) on the unmodified worm. The flank follows the command one to one at a foot that is held; `step` says how. It is no more
    /// curved than the limits where others nearly folded.
    pub fn next(
        &self,
        command: &FlankCommand,
        at: &[Contact],
        (Step { share, hold, near }, folds): (Step, &Folds),
        cos_b2: f64,
    ) -> Option<FlankCommand> {
        let places = self.touched(at);
        let own: Vec<Place> = places.iter().map(|(place, _)| *place).collect();
        let commanded = Rows::new(&self.bases, &own).values(&command.coefficients);
        let values: Vec<f64> = commanded
            .iter()
            .zip(self.wanted)
            .zip(at)
            .map(|((command, wanted), (contact, _))| command + share * wanted - contact.f_n / cos_b2)
            .collect();
        let held = Held { coefficients: &command.coefficients, price: hold };
        let rules = (Curvature::COMMAND, near, Some(held));
        FlankCommand::of(&FlankProgramme { folded: &folds.0, ..self.programme(&places, &values, rules) })
    }

    /// Largest distance of contacts to what is wanted, by weight, transverse, mm.
    pub fn off(&self, at: &[Contact], cos_b2: f64) -> f64 {
        self.largest(self.wanted.iter().zip(at).map(|(wanted, (contact, _))| wanted - contact.f_n / cos_b2))
    }

    /// The largest of some distances on the grid, each by its weight.
    fn largest(&self, distances: impl Iterator<Item = f64>) -> f64 {
        distances.zip(self.weights).map(|(off, weight)| off.abs() * weight).fold(0.0, f64::max)
    }

    /// The functions of a command with their coordinates; `off` is what it leaves, transverse, mm.
    ///
    /// # Errors
    /// `InvalidSpline`, `Law`.
    pub fn decomposition(&self, command: &FlankCommand, off: f64) -> Result<FittedFlank, GeneratingError> {
        let quality = FitQuality {
            largest: off,
            tolerance_ratio: off / self.within.tolerance,
            ..FitQuality::default()
        };
        let columns = self.bases.columns();
        let mut functions = self.bases.functions(&command.coefficients)?;
        let profile = functions.profile.take().and_then(|profile| profile.cubic_pieces());
        let profile = profile.map(|(ends, pieces)| PiecewisePolynomial::new(ends, pieces)).transpose();
        let fit = Arc::new(RestFit {
            functions,
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
        });
        Ok(FittedFlank { fit, profile: profile.map_err(GeneratingError::Law)? })
    }
}
