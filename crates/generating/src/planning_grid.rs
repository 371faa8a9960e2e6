//! The points on which a plan is judged, and how far what is ground there is from the target.

use super::class_fit::ClassFit;
use super::{FlankTarget, GeneratingError, GrindingSetup};
use contact::{ContactSolution, ExactContact, ToolSurface};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::{GeneratingMotion, MotionLaw};
use foundation::modification::ToleranceMap;
use foundation::numerics::{Polynomial2, equidistant, root_mean_square};

/// Points on the flanks on which a plan is judged, row-major `[w][z]`.
#[derive(Clone, Debug)]
pub struct PlanningGrid {
    /// Lengths of roll per flank, mm.
    pub w: Sides<Vec<f64>>,
    /// Axial positions, mm.
    pub z: Vec<f64>,
    fits: Sides<ClassFit>,
    pure_fits: Sides<ClassFit>,
}

/// Into how many the cells at the ends of the face are divided by [`PlanningGrid::closer_at_ends`].
const PARTS_AT_ENDS: usize = 4;

impl PlanningGrid {
    /// `nw` x `nz` equidistant points over the evaluation fields.
    pub fn new(setup: &GrindingSetup, nw: usize, nz: usize) -> Self {
        let w = setup.fields.map(|_, f| equidistant(f.roll(), nw));
        let z = equidistant(setup.fields.left.face(), nz);
        let points = w.map(|flank, w| {
            let field = &setup.fields[flank];
            w.iter()
                .flat_map(|&w| z.iter().map(move |&z| (w - field.roll_middle(), z - field.face_middle())))
                .collect::<Vec<_>>()
        });
        let fits = points.map(|_, p| ClassFit::new(p));
        let pure_fits = points.map(|_, p| ClassFit::without_mixed_terms(p));
        Self { w, z, fits, pure_fits }
    }

    /// With points closer together at the ends of the face, where contacts run out of the flank and reliefs are deepest.
    pub(super) fn closer_at_ends(mut self) -> Self {
        let cells = self.z.len().saturating_sub(1);
        let closer = |(k, cell): (usize, &[f64])| {
            let parts = if k == 0 || k + 1 == cells { PARTS_AT_ENDS } else { 1 };
            let step = (cell[1] - cell[0]) / parts as f64;
            (0..parts).map(|part| cell[0] + part as f64 * step).collect::<Vec<_>>()
        };
        let last = self.z.last().copied();
        self.z = self.z.windows(2).enumerate().flat_map(closer).chain(last).collect();
        self
    }

    /// Points inside the cells of this grid, off their middles: what waves between the points, whatever its length, shows there.
    pub(super) fn between(&self) -> Self {
        const PLACE: f64 = 0.382;
        let inside = |x: &[f64]| x.windows(2).map(|cell| cell[0] + PLACE * (cell[1] - cell[0])).collect();
        Self { w: self.w.map(|_, w| inside(w)), z: inside(&self.z), ..self.clone() }
    }

    /// Points close together along a few helix traces off those of this grid: an edge across the face shows there, however sharp.
    pub(super) fn along_traces(&self) -> Self {
        const TRACES: usize = 7;
        const PER_CELL: u8 = 4;
        let place = |cell: &[f64], share: f64| cell[0] + share * (cell[1] - cell[0]);
        let w = self.w.map(|_, w| {
            let every = (w.len() / TRACES).max(1);
            w.windows(2).step_by(every).map(|cell| place(cell, 0.5)).collect()
        });
        let inside =
            |cell| (0..PER_CELL).map(move |k| place(cell, (f64::from(k) + 0.5) / f64::from(PER_CELL)));
        Self { w, z: self.z.windows(2).flat_map(inside).collect(), ..self.clone() }
    }

    /// The tightest tolerance over that of each place of a map, by flank and grid point; 1 everywhere without a map.
    pub fn weights(&self, map: Option<&ToleranceMap>) -> Sides<Vec<f64>> {
        let tightest = map.map_or(1.0, ToleranceMap::tightest);
        let weight = |w: f64, z: f64| map.map_or(1.0, |map| tightest / map.value(w, z));
        self.w.map(|_, w| w.iter().flat_map(|&w| self.z.iter().map(move |&z| weight(w, z))).collect())
    }

    /// Target values on one flank, normal, mm.
    ///
    /// # Errors
    /// Evaluation errors of the target.
    pub fn target(
        &self,
        flank: Flank,
        target: &FlankTarget,
        cos_b2: f64,
    ) -> Result<Vec<f64>, GeneratingError> {
        let mut values = Vec::with_capacity(self.w[flank].len() * self.z.len());
        for &w in &self.w[flank] {
            for &z in &self.z {
                values.push(target.value(w, z)? * cos_b2);
            }
        }
        Ok(values)
    }

    /// The exact flank left by a tool surface, by grid point.
    ///
    /// # Errors
    /// Those of the exact contact.
    pub fn ground<S: ToolSurface>(
        &self,
        setup: &GrindingSetup,
        flank: Flank,
        motion: &GeneratingMotion,
        surface: &S,
    ) -> Result<Vec<ContactSolution>, GeneratingError> {
        let contact = ExactContact::new(&setup.pair, flank, motion, surface);
        Ok(contact.solve_grid(&self.w[flank], &self.z)?)
    }

    /// The same where the tool leaves no contact somewhere: those that are found easily, each with its grid point.
    pub(super) fn ground_where_easy<S: ToolSurface>(
        &self,
        setup: &GrindingSetup,
        flank: Flank,
        motion: &GeneratingMotion,
        surface: &S,
    ) -> Vec<(usize, ContactSolution)> {
        let contact = ExactContact::new(&setup.pair, flank, motion, surface);
        contact.solve_grid_where_easy(&self.w[flank], &self.z)
    }

    /// Correction of the command that the normal errors `e` (target - ground, mm) ask for, transverse; with or without
    /// mixed terms.
    pub fn correction(&self, flank: Flank, e: &[f64], cos_b2: f64, mixed: bool) -> Polynomial2 {
        let transverse: Vec<f64> = e.iter().map(|e| e / cos_b2).collect();
        let fit = if mixed { &self.fits[flank] } else { &self.pure_fits[flank] };
        fit.fit(&transverse)
    }
}

/// Error of an ideal plan on the planning grid.
#[derive(Clone, Debug)]
pub struct GroundError {
    /// target - ground per grid point and flank, normal, mm.
    pub error: Sides<Option<Vec<f64>>>,
    /// The workpiece points (w_2, z_2) that the tool points in contact would grind unmodified, per grid point and flank: a
    /// correction of the tool acts where the contact stands, and that moves with the modification. mm.
    pub(super) feet: Sides<Option<Vec<(f64, f64)>>>,
    /// Least determinant ratio of both flanks.
    pub determinant: f64,
}

impl GroundError {
    /// Compares what `ground` leaves on each flank (`None`: not ground) with its target.
    ///
    /// # Errors
    /// Those of `ground`; evaluation errors of the target.
    pub(super) fn of(
        setup: &GrindingSetup,
        targets: &Sides<Option<FlankTarget>>,
        grid: &PlanningGrid,
        shift: &MotionLaw,
        ground: impl Fn(Flank) -> Option<Result<Vec<ContactSolution>, GeneratingError>>,
        foot: impl Fn(Flank, &ContactSolution) -> Option<(f64, f64)>,
    ) -> Result<Self, GeneratingError> {
        let mut determinant = f64::INFINITY;
        let mut feet = Sides { left: None, right: None };
        let error = Sides::try_from_fn(|flank| -> Result<_, GeneratingError> {
            let (Some(ground), Some(target)) = (ground(flank), &targets[flank]) else { return Ok(None) };
            let ground = ground?;
            let lines = &setup.lines[flank];
            let wanted = grid.target(flank, target, lines.cos_b2)?;
            determinant = ground.iter().map(|g| g.determinant_ratio).fold(determinant, f64::min);
            if !shift.is_constant() {
                let on_work = |g| {
                    let (w_1, z_1) = foot(flank, g)?;
                    let [w, z] = lines.work_point(w_1, z_1, shift);
                    Some((w.f, z.f))
                };
                feet[flank] = ground.iter().map(on_work).collect();
            }
            Ok(Some(wanted.iter().zip(&ground).map(|(t, g)| t - g.f_n).collect()))
        })?;
        Ok(Self { error, feet, determinant })
    }

    /// Largest |error| of one flank, mm.
    pub fn largest(&self, flank: Flank) -> Option<f64> {
        self.error[flank].as_ref().map(|e| e.iter().fold(0.0, |m: f64, x| m.max(x.abs())))
    }

    /// Root mean square of the error of one flank, mm.
    pub fn rms(&self, flank: Flank) -> Option<f64> {
        let errors = self.error[flank].as_ref()?;
        Some(root_mean_square(errors))
    }

    /// Largest |error| of all flanks, mm, each weighed by what [`PlanningGrid::weights`] gives for its place.
    pub fn weighed_max(&self, weights: &Sides<Vec<f64>>) -> f64 {
        let of_flank = |flank: Flank| {
            let weighed =
                self.error[flank].as_ref()?.iter().zip(&weights[flank]).map(|(e, weight)| e.abs() * weight);
            Some(weighed.fold(0.0, f64::max))
        };
        Flank::BOTH.into_iter().filter_map(of_flank).fold(0.0, f64::max)
    }

    /// Largest |error| of all flanks, mm.
    pub fn max(&self) -> f64 {
        Flank::BOTH.into_iter().filter_map(|f| self.largest(f)).fold(0.0, f64::max)
    }
}
