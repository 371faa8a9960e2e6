//! The exact contact solver: what a tool surface really leaves on the workpiece flank
//! (`docs/mathematics/generating-contact.md#exact-contact`).

use super::error::FOLD_BEGINS;
pub use super::kernel::Measure;
use super::kernel::{Evaluation, Kernel, Target, about_z, turned_z};
use super::{ContactError, FlankPair, Pair, ToolSurface};
use foundation::geometry::Flank;
use foundation::kinematics::GeneratingMotion;
use nalgebra::{Matrix4, Vector3, Vector4};
use std::f64::consts::PI;

const MAX_ITERATIONS: usize = 40;
const CONVERGED: f64 = 1e-12;
const STALLED: f64 = 1e-9;
/// Steps whose square is below the rounding of a deviation.
const SHORT: f64 = 1e-8;

/// The ground flank at one workpiece point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactSolution {
    /// f_n2, mm; > 0 material left.
    pub f_n: f64,
    /// Surface parameters of the tool point that grinds it.
    pub tool: (f64, f64),
    /// Worm angle phi_1, rad.
    pub worm_angle: f64,
    /// Feed z_V2, mm.
    pub feed: f64,
    /// det J / det J_0; 1 without modification, <= 0 beyond the fold.
    pub determinant_ratio: f64,
    /// Newton steps taken.
    pub iterations: usize,
}

/// Exact derivatives of f_n2 at a solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivities {
    /// By the centre distance, mm/mm.
    pub centre_distance: f64,
    /// By an extra workpiece angle, mm/rad.
    pub work_angle: f64,
    /// By the crossed-axes angle, mm/rad.
    pub crossed_axes_angle: f64,
    /// By the tool shift, mm/mm.
    pub shift: f64,
    /// By the tool's own normal modification at its point, mm/mm.
    pub tool_modification: f64,
}

/// A pair, a motion and a tool surface: the forward model of generating grinding for one flank.
pub struct ExactContact<'a, S: ToolSurface> {
    pair: &'a FlankPair,
    kernel: Kernel<'a>,
    plain: GeneratingMotion,
    surface: &'a S,
    /// The surface without its modification: what the determinant ratio refers to.
    unmodified: Box<dyn ToolSurface + 'a>,
    measure: Measure,
    /// Rotation of the coupling by whole pitches that brings the start onto the workpiece flank.
    pitch: f64,
    /// The unmodified contacts of one w differ by screws of both bodies only: cylinders at a constant ratio.
    along_the_screw: bool,
}

/// Where the search for the contact of a workpiece point begins.
struct Start<'a> {
    target: Target,
    kernel: Kernel<'a>,
    /// The unmodified contact.
    y_0: State,
    /// Its determinant.
    reference: f64,
}

impl Start<'_> {
    /// Whether an iteration ended on the near branch.
    fn accepts(&self, found: &Found) -> bool {
        found.determinant / self.reference > 0.0
    }

    /// A contact with its difference to the unmodified one.
    fn solution(&self, Found { y, q_2, determinant, iterations }: Found) -> (ContactSolution, State) {
        let solution = ContactSolution {
            f_n: (q_2 - self.target.point).dot(&self.target.n),
            tool: (y[0], y[1]),
            worm_angle: y[2],
            feed: y[3],
            determinant_ratio: determinant / self.reference,
            iterations,
        };
        (solution, y - self.y_0)
    }
}

/// Why an iteration ended without a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Lost {
    /// It left the tool surface at these parameters.
    Surface { p: f64, q: f64 },
    /// The tool surface has no finite derivatives at these parameters.
    Kink { p: f64, q: f64 },
    /// It does not settle.
    Diverged,
}

type State = Vector4<f64>;

/// Where an iteration ended.
#[derive(Clone, Copy, Debug)]
struct Found {
    y: State,
    /// Tool point in workpiece coordinates at y.
    q_2: Vector3<f64>,
    /// Of the Jacobian, at most a short step before y.
    determinant: f64,
    iterations: usize,
}

impl<'a, S: ToolSurface> ExactContact<'a, S> {
    /// Prepares the flank `flank` of `pair` moved by `motion`, ground by `surface` (given in worm coordinates).
    pub fn new(pair: &'a Pair, flank: Flank, motion: &'a GeneratingMotion, surface: &'a S) -> Self {
        let kernel = Kernel::new(motion, motion.phase[flank]);
        Self {
            pair: &pair.flanks[flank],
            along_the_screw: kernel.straight && motion.shift.is_affine(),
            kernel,
            plain: motion.uncorrected(),
            surface,
            unmodified: surface.with_share(0.0),
            measure: Measure::Ray,
            pitch: 2.0 * PI / motion.teeth,
        }
    }

    /// The same with another measure.
    pub fn with_measure(mut self, measure: Measure) -> Self {
        self.measure = measure;
        self
    }

    /// The unmodified contact of (w_2, z_2): feed, worm point and worm angle.
    fn nominal(&self, w_2: f64, z_2: f64) -> Result<(State, f64), ContactError> {
        let missing = ContactError::NoStart { w: w_2, z: z_2 };
        let pair = self.pair;
        let motion = self.kernel.motion;
        // R6 in the feed alone; linear for a constant ratio, a few Newton steps otherwise.
        let mut v = 0.0;
        for round in 0.. {
            let [shift, slope, _] = motion.shift.jet(v);
            let residual = pair.work_z(w_2, shift, v) - z_2;
            let derivative = pair.c_zv12 * slope + pair.c_zv22;
            let step = residual / derivative;
            if !step.is_finite() || round > 60 {
                return Err(missing);
            }
            v -= step;
            if step.abs() <= 1e-13 * (1.0 + v.abs()) {
                break;
            }
        }
        let shift = motion.shift.value(v);
        let w_1 = pair.worm_roll(w_2, shift, v);
        if w_1.is_nan() || w_1 <= 0.0 || w_2 < 0.0 {
            return Err(ContactError::ContactBelowBase { w_2, w_1 });
        }
        let z_1 = pair.worm_z(w_1, shift, v);
        let phi_1 = pair.worm_angle(w_1, z_1);
        let (p, q) = self.surface.start(w_1, z_1);
        // Whole pitches are settled here once and never wrapped later.
        let wanted = pair.work_angle(w_2, z_2);
        let coupled = self.plain.state(phi_1, v, self.kernel.phase).work_angle;
        let pitches = ((wanted - coupled) / self.pitch).round() * self.pitch;
        Ok((State::new(p, q, phi_1, v), pitches))
    }

    fn evaluate(
        kernel: &Kernel<'_>,
        surface: &dyn ToolSurface,
        y: &State,
        target: &Target,
        measure: Measure,
    ) -> Result<Evaluation, Lost> {
        let [p, q] = [y[0], y[1]];
        let jet = surface.jet(p, q).ok_or(Lost::Surface { p, q })?;
        let finite = |vectors: &[Vector3<f64>]| vectors.iter().flatten().all(|x| x.is_finite());
        // Point and normal are there, their derivatives are not: an edge or a kink runs through this place.
        if finite(&[jet.p, jet.n]) && !finite(&[jet.p_p, jet.p_q, jet.n_p, jet.n_q]) {
            return Err(Lost::Kink { p, q });
        }
        let e = kernel.evaluate(&jet, y[2], y[3], target, measure);
        let good = e.residual.iter().chain(e.jacobian.iter()).all(|x| x.is_finite());
        if good { Ok(e) } else { Err(Lost::Surface { p, q }) }
    }

    /// Newton from y.
    fn newton(
        &self,
        kernel: &Kernel<'_>,
        surface: &dyn ToolSurface,
        mut y: State,
        target: &Target,
    ) -> Result<Found, Lost> {
        let (limit_p, limit_q) = surface.step_limits();
        let limits = [limit_p, limit_q, 0.3, 4.0];
        let mut previous = f64::INFINITY;
        for iterations in 1..=MAX_ITERATIONS {
            let e = Self::evaluate(kernel, surface, &y, target, self.measure)?;
            let (mut step, determinant) = solve4(&e.jacobian, &e.residual).ok_or(Lost::Diverged)?;
            let excess = (0..4).map(|k| step[k].abs() / limits[k]).fold(1.0, f64::max);
            step /= excess;
            let size = step.norm() / (1.0 + y.norm());
            if size < CONVERGED {
                // The step is the error of y, and f_n changes along it only by the angle between the normals.
                return Ok(Found { y, q_2: e.q_2, determinant, iterations });
            }
            y -= step;
            // Steps shrink at least as fast as they did so far: the next one is known to be nothing. The point follows this one to
            // first order; what is left out is the square of a step so short.
            if size < SHORT && size * (size / previous) < CONVERGED && previous.is_finite() {
                let moved: Vector3<f64> = (0..4).map(|k| e.q_x[k] * step[k]).sum();
                return Ok(Found { y, q_2: e.q_2 - moved, determinant, iterations });
            }
            if size < STALLED && size >= previous {
                let e = Self::evaluate(kernel, surface, &y, target, self.measure)?;
                return Ok(Found { y, q_2: e.q_2, determinant: e.jacobian.determinant(), iterations });
            }
            previous = size;
        }
        Err(Lost::Diverged)
    }

    /// Solves at (w_2, z_2) from the unmodified contact.
    ///
    /// # Errors
    /// `NoStart`, `ContactBelowBase`, `WormSurfaceMissing`, `NotSmooth`, `Undercut`, `NotSettled`.
    pub fn solve(&self, w_2: f64, z_2: f64) -> Result<ContactSolution, ContactError> {
        self.solve_from(w_2, z_2, None, &mut None).map(|(solution, _)| solution)
    }

    /// Solves a grid point, starting from the correction found at a neighbour (difference to its unmodified contact), else from the
    /// unmodified contact, else in steps.
    fn solve_from(
        &self,
        w_2: f64,
        z_2: f64,
        neighbour: Option<&State>,
        unmodified: &mut Option<f64>,
    ) -> Result<(ContactSolution, State), ContactError> {
        let start = self.start(w_2, z_2, unmodified)?;
        let found = match self.found_easily(&start, neighbour) {
            Some(found) => found,
            None => self.step_up(&start, w_2, z_2)?,
        };
        Ok(start.solution(found))
    }

    /// The start at a workpiece point. `unmodified` holds the determinant of the unmodified contact where points of the same w share it.
    fn start(&self, w_2: f64, z_2: f64, unmodified: &mut Option<f64>) -> Result<Start<'a>, ContactError> {
        let target = Target::new(&self.pair.work, w_2, z_2);
        let (y_0, pitches) = self.nominal(w_2, z_2)?;
        let mut kernel = self.kernel.clone();
        kernel.phase += pitches * kernel.motion.teeth;
        let reference = match *unmodified {
            Some(known) => known,
            None => {
                let plain = Kernel::new(&self.plain, kernel.phase);
                let e = Self::evaluate(&plain, self.unmodified.as_ref(), &y_0, &target, self.measure)
                    .map_err(|_| ContactError::WormSurfaceMissing { p: y_0[0], q: y_0[1] })?;
                e.jacobian.determinant()
            }
        };
        *unmodified = self.along_the_screw.then_some(reference);
        Ok(Start { target, kernel, y_0, reference })
    }

    /// The contact as it is found from that of a neighbour or from the unmodified one.
    fn found_easily(&self, start: &Start<'_>, neighbour: Option<&State>) -> Option<Found> {
        let from = |y: State| {
            self.newton(&start.kernel, self.surface, y, &start.target)
                .ok()
                .filter(|found| start.accepts(found))
        };
        neighbour.and_then(|delta| from(start.y_0 + delta)).or_else(|| from(start.y_0))
    }

    /// Raises modification and corrections from zero in steps, keeping to the near branch.
    fn step_up(&self, start: &Start<'_>, w: f64, z: f64) -> Result<Found, ContactError> {
        let Start { target, kernel, y_0, reference } = start;
        let (mut share, mut step, mut y, mut last) = (0.0, 0.25, *y_0, 1.0);
        let mut lost = Lost::Diverged;
        while step > 1e-3 {
            let next: f64 = f64::min(share + step, 1.0);
            let motion = kernel.motion.with_share(next);
            let scaled = Kernel::new(&motion, kernel.phase);
            let surface = self.surface.with_share(next);
            match self.newton(&scaled, surface.as_ref(), y, target) {
                Ok(found) if start.accepts(&found) => {
                    last = found.determinant / reference;
                    (share, y) = (next, found.y);
                    if share >= 1.0 {
                        return Ok(found);
                    }
                }
                outcome => {
                    lost = outcome.err().unwrap_or(Lost::Diverged);
                    step *= 0.5;
                }
            }
        }
        Err(match lost {
            Lost::Surface { p, q } => ContactError::WormSurfaceMissing { p, q },
            Lost::Kink { p, q } => ContactError::NotSmooth { p, q },
            Lost::Diverged if last < FOLD_BEGINS => {
                ContactError::Undercut { flank: self.pair.flank(), w, z, ratio: last }
            }
            Lost::Diverged => ContactError::NotSettled { flank: self.pair.flank(), w, z, ratio: last },
        })
    }

    /// Solves on the grid `w` x `z`, row-major `[w][z]`, from its middle outwards: modifications are large at the ends. Each point starts from
    /// the correction that its neighbours on the way from the middle of its row (of a middle: of the column) let expect.
    ///
    /// # Errors
    /// Those of [`ExactContact::solve`], at a point that fails.
    pub fn solve_grid(&self, w: &[f64], z: &[f64]) -> Result<Vec<ContactSolution>, ContactError> {
        let (rows, _) = from_the_middle(w, None, |w_2, start| {
            let mut unmodified = None;
            from_the_middle(z, start, |z_2, start| {
                let (solution, delta) = self.solve_from(w_2, z_2, start.as_ref(), &mut unmodified)?;
                Ok((solution, Some(delta)))
            })
        })?;
        Ok(rows.into_iter().flatten().collect())
    }

    /// The solutions on the grid that are found from their neighbours or from the unmodified contact, each with its place in the row-major
    /// order: for a surface that leaves no contact somewhere.
    pub fn solve_grid_where_easy(&self, w: &[f64], z: &[f64]) -> Vec<(usize, ContactSolution)> {
        let rows = from_the_middle(w, None, |w_2, start| {
            let mut unmodified = None;
            from_the_middle(z, start, |z_2, neighbour| {
                let start = self.start(w_2, z_2, &mut unmodified).ok();
                let found = start
                    .and_then(|start| Some(start.solution(self.found_easily(&start, neighbour.as_ref())?)));
                Ok(found.unzip())
            })
        });
        let solved = rows.into_iter().flat_map(|(rows, _)| rows.into_iter().flatten());
        solved.enumerate().filter_map(|(k, found)| Some((k, found?))).collect()
    }

    /// Derivatives of f_n2 at a solution, exact at finite modification.
    ///
    /// # Errors
    /// `WormSurfaceMissing` if the solution does not belong to this surface.
    pub fn sensitivities(
        &self,
        w_2: f64,
        z_2: f64,
        at: &ContactSolution,
    ) -> Result<Sensitivities, ContactError> {
        let target = Target::new(&self.pair.work, w_2, z_2);
        let (_, pitches) = self.nominal(w_2, z_2)?;
        let mut kernel = self.kernel.clone();
        kernel.phase += pitches * kernel.motion.teeth;
        let y = State::new(at.tool.0, at.tool.1, at.worm_angle, at.feed);
        let jet =
            self.surface.jet(y[0], y[1]).ok_or(ContactError::WormSurfaceMissing { p: y[0], q: y[1] })?;
        let e = kernel.evaluate(&jet, y[2], y[3], &target, self.measure);
        let n_q = e.n_q / e.n_q.norm();
        let along = match self.measure {
            Measure::Ray => 1.0 / n_q.dot(&target.n),
            Measure::Arc => {
                let around = about_z(&e.q_2) / e.q_2.x.hypot(e.q_2.y);
                target.n.dot(&around) / n_q.dot(&around)
            }
        };
        let by = |dq: &Vector3<f64>| n_q.dot(dq) * along;
        let room = |v: Vector3<f64>| kernel.room_to_work(e.gamma, e.work_angle, &v);
        let around = about_z(&e.q_2);
        let lever = turned_z((-e.work_angle).sin_cos(), &e.gamma_lever);
        let swing = kernel.swing_axis(e.work_angle).cross(&lever);
        let z_2 = kernel.motion.teeth;
        // The image of the thread's own normal has n_q . image = |N| with N = n - a e_r - c g, i.e. 1 over its length here.
        let image = 1.0 / jet.n.norm();
        Ok(Sensitivities {
            centre_distance: by(&room(-Vector3::y())),
            work_angle: by(&-around),
            crossed_axes_angle: by(&-swing),
            shift: by(&(room(Vector3::z()) - around * (kernel.motion.shift_coupling / z_2))),
            tool_modification: image * along,
        })
    }
}

/// The last corrections along a grid line and where the next is expected.
#[derive(Default)]
struct Trail(Vec<(f64, State)>);

impl Trail {
    fn push(&mut self, at: f64, delta: State) {
        if self.0.len() == 3 {
            self.0.remove(0);
        }
        self.0.push((at, delta));
    }

    /// Polynomial through the last (up to three) corrections.
    fn expected(&self, at: f64) -> Option<State> {
        if self.0.is_empty() {
            return None;
        }
        let weight = |k: usize| -> f64 {
            let others = (0..self.0.len()).filter(|&i| i != k);
            others.map(|i| (at - self.0[i].0) / (self.0[k].0 - self.0[i].0)).product()
        };
        let sum = (0..self.0.len()).map(|k| self.0[k].1 * weight(k)).sum::<State>();
        sum.iter().all(|x| x.is_finite()).then_some(sum)
    }
}

/// Solves at ascending places from the middle one outwards, each from the correction that those on the way there let expect, the middle one from
/// `first`; with the correction of the middle.
fn from_the_middle<T>(
    places: &[f64],
    first: Option<State>,
    mut solve: impl FnMut(f64, Option<State>) -> Result<(T, Option<State>), ContactError>,
) -> Result<(Vec<T>, Option<State>), ContactError> {
    let (before, after) = places.split_at(places.len() / 2);
    let [mut solved, mut below] = [before, after].map(|side| Vec::with_capacity(side.len()));
    let mut along = |trail: &mut Trail, at: f64, solved: &mut Vec<T>| {
        let start = if trail.0.is_empty() { first } else { trail.expected(at) };
        let (found, delta) = solve(at, start)?;
        solved.push(found);
        if let Some(delta) = delta {
            trail.push(at, delta);
        }
        Ok::<_, ContactError>(delta)
    };
    let (mut trail, mut middle) = (Trail::default(), None);
    for &at in after {
        let delta = along(&mut trail, at, &mut solved)?;
        middle = middle.or(delta.map(|delta| (at, delta)));
    }
    let mut trail = Trail(middle.into_iter().collect());
    for &at in before.iter().rev() {
        along(&mut trail, at, &mut below)?;
    }
    Ok((below.into_iter().rev().chain(solved).collect(), middle.map(|(_, delta)| delta)))
}

/// Solution and determinant by elimination with pivots, on the stack: the inner step of every flank.
fn solve4(matrix: &Matrix4<f64>, rhs: &Vector4<f64>) -> Option<(Vector4<f64>, f64)> {
    let mut a: [[f64; 5]; 4] =
        std::array::from_fn(|i| std::array::from_fn(|j| if j < 4 { matrix[(i, j)] } else { rhs[i] }));
    let mut inverse = [0.0; 4];
    let mut determinant = 1.0;
    for k in 0..4 {
        let mut pivot = k;
        for i in k + 1..4 {
            if a[i][k].abs() > a[pivot][k].abs() {
                pivot = i;
            }
        }
        if pivot != k {
            a.swap(k, pivot);
            determinant = -determinant;
        }
        if a[k][k] == 0.0 {
            return None;
        }
        determinant *= a[k][k];
        inverse[k] = 1.0 / a[k][k];
        for i in k + 1..4 {
            let share = a[i][k] * inverse[k];
            for j in k + 1..5 {
                a[i][j] -= share * a[k][j];
            }
        }
    }
    let mut x = Vector4::zeros();
    for k in (0..4).rev() {
        let known: f64 = (k + 1..4).map(|j| a[k][j] * x[j]).sum();
        x[k] = (a[k][4] - known) * inverse[k];
    }
    Some((x, determinant))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elimination_solves_and_knows_the_determinant() {
        let matrix =
            Matrix4::new(0.0, 2.0, -1.0, 0.5, 3.0, 0.0, 1.0, 4.0, -2.0, 5.0, 7.0, 0.0, 1.0, 1.0, 0.0, -3.0);
        let x = Vector4::new(1.0, -2.0, 3.0, 0.25);
        let (found, determinant) = solve4(&matrix, &(matrix * x)).unwrap();
        assert!((found - x).norm() < 1e-14);
        assert!((determinant - matrix.determinant()).abs() < 1e-12 * determinant.abs());
        assert_eq!(solve4(&Matrix4::zeros(), &x), None);
    }
}
