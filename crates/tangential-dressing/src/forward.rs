//! The forward model: which flank a set of design variables grinds (`docs/mathematics/tangential-dressing.md#the-dressed-worm`), by the one
//! exact contact solver.

use super::TangentialError;
use super::channel::{Abscissa, Channel, Variable};
use super::model::TangentialModel;
use super::settings::TangentialSettings;
use super::worm_surface::{DresserLaws, WormSurface};
use contact::{ContactError, ContactSolution, ExactContact, Measure, ToolSurface};
use foundation::geometry::{Flank, InvoluteFlank};
use foundation::kinematics::{GeneratingMotion, MotionLaw};
use nalgebra::{DMatrix, Vector3};

/// The flank at one point of the gear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlankPoint {
    /// m: material left, mm.
    pub deviation: f64,
    /// Height s on the dresser, mm.
    pub height: f64,
    /// theta: angle on the dresser, rad.
    pub dresser_angle: f64,
    /// x_D: axial position of the dresser on the worm, mm.
    pub position: f64,
    /// phi_1, rad.
    pub worm_angle: f64,
    /// z: feed of the tool, mm.
    pub feed: f64,
    /// det J over that of the unmodified flank: 1 there, 0 where the envelope folds.
    pub determinant_ratio: f64,
}

/// Lengths of roll and axial positions of a grid; values over it are row-major `[w][z]`.
#[derive(Clone, Debug, PartialEq)]
pub struct RollGrid {
    /// Lengths of roll, ascending, mm.
    pub w: Vec<f64>,
    /// Axial positions, ascending, mm.
    pub z: Vec<f64>,
}

impl RollGrid {
    /// Number of points.
    pub fn count(&self) -> usize {
        self.w.len() * self.z.len()
    }

    /// All points in their order.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.w.iter().flat_map(|&w| self.z.iter().map(move |&z| (w, z)))
    }
}

/// One flank with the motions that given settings mean.
pub struct TangentialFlank<'a> {
    model: &'a TangentialModel,
    flank: Flank,
    measure: Measure,
    surface: WormSurface<'a>,
    motion: GeneratingMotion,
}

impl<'a> TangentialFlank<'a> {
    /// The motions of `settings` for a flank that is ground in a pass with the flanks `pass`.
    pub fn new(
        model: &'a TangentialModel,
        flank: Flank,
        pass: &[Flank],
        settings: &TangentialSettings,
        measure: Measure,
    ) -> Self {
        let law = |channel| settings.law(channel, &model.scales, 1.0);
        let parts = [
            Some(law(Channel::Profile(None))),
            Some(law(Channel::Profile(Some(flank)))),
            model.existing[flank].clone(),
        ];
        let mut parts: Vec<MotionLaw> = parts.into_iter().flatten().filter(|law| !law.is_zero()).collect();
        let profile = match (parts.pop(), parts.is_empty()) {
            (None, _) => MotionLaw::zero(),
            (Some(only), true) => only,
            (Some(last), false) => {
                parts.push(last);
                MotionLaw::Sum(parts)
            }
        };
        let surface = WormSurface {
            profile: &model.profiles[flank],
            chain: model.chain,
            laws: DresserLaws {
                profile,
                tangential: law(Channel::TangentialShift),
                axial: law(Channel::AxialOffset),
                distance: law(Channel::DressingDistance),
                angle: law(Channel::DressingAngle),
            },
            sigma: model.pair.worm.flank(flank).s() * model.chain.screw_parameter.signum(),
        };
        Self { model, flank, measure, surface, motion: grinding_motion(model, pass, settings) }
    }

    /// The flank concerned.
    pub fn flank(&self) -> Flank {
        self.flank
    }

    /// Motion of grinding, over v = z_V2 = -z.
    pub fn motion(&self) -> &GeneratingMotion {
        &self.motion
    }

    /// The unmodified worm flank.
    pub fn worm(&self) -> &InvoluteFlank {
        self.model.pair.worm.flank(self.flank)
    }

    /// The unmodified flank of the gear.
    pub fn work(&self) -> &InvoluteFlank {
        self.model.pair.work.flank(self.flank)
    }

    /// The side of the dresser that dresses this flank, at a height above its pitch circle: half thickness, and what that lacks of the
    /// nominal profile, mm.
    pub fn half_thickness(&self, height: f64) -> [f64; 2] {
        let nominal = self.surface.profile.half_thickness(height)[0];
        let lacking = self.surface.laws.profile.value(height);
        [nominal - lacking, lacking]
    }

    pub(super) fn surface(&self) -> &WormSurface<'a> {
        &self.surface
    }

    fn contact(&self) -> ExactContact<'_, WormSurface<'a>> {
        ExactContact::new(&self.model.pair, self.flank, &self.motion, &self.surface)
            .with_measure(self.measure)
    }

    /// The flank on a grid.
    ///
    /// # Errors
    /// [`TangentialError::Undercut`] at the first point concerned, [`TangentialError::OutsideTool`] at the one farthest beyond.
    pub fn solve(&self, grid: &RollGrid) -> Result<Vec<FlankPoint>, TangentialError> {
        let points = self.solve_beyond_tool(grid)?;
        self.check_tool(grid, points.iter().map(|p| p.height))?;
        Ok(points)
    }

    /// The same as if worm and dresser went on beyond their tips: what a fit may pass through, but no machine makes.
    ///
    /// # Errors
    /// [`TangentialError::Undercut`] at the first point concerned.
    pub fn solve_beyond_tool(&self, grid: &RollGrid) -> Result<Vec<FlankPoint>, TangentialError> {
        let solutions = self.solutions(&self.contact(), grid)?;
        let plain = self.surface.unmodified();
        Ok(grid.points().zip(&solutions).map(|((w, _), at)| self.point(w, at, &plain)).collect())
    }

    /// Which moment of grinding and which place of the worm make the flank at one place (w, z) of the gear, mm; `None` where no contact is
    /// found. Tips are no limit.
    pub fn contact_at(&self, w: f64, z: f64) -> Option<ContactSolution> {
        self.contact().solve(w, z).ok()
    }

    /// The point that the circle of the dresser at height s dresses while it stands at x_D (mm), in coordinates of the worm; `None` where
    /// it touches nothing.
    pub fn worm_point(&self, s: f64, x_d: f64) -> Option<Vector3<f64>> {
        self.surface.jet(s, x_d).map(|jet| jet.p)
    }

    /// Material left on a grid, mm.
    ///
    /// # Errors
    /// As [`TangentialFlank::solve`].
    pub fn deviations(&self, grid: &RollGrid) -> Result<Vec<f64>, TangentialError> {
        let solutions = self.solutions(&self.contact(), grid)?;
        self.check_tool(grid, solutions.iter().map(|s| s.tool.0))?;
        Ok(solutions.iter().map(|s| s.f_n).collect())
    }

    /// Material left on a grid, mm, and its exact derivatives by some variables: one row a point. As in
    /// [`TangentialFlank::solve_beyond_tool`], tips are no limit.
    ///
    /// # Errors
    /// As [`TangentialFlank::solve_beyond_tool`].
    pub fn linearised(
        &self,
        grid: &RollGrid,
        variables: &[Variable],
    ) -> Result<(Vec<f64>, DMatrix<f64>), TangentialError> {
        let contact = self.contact();
        let solutions = self.solutions(&contact, grid)?;
        let mut by = DMatrix::zeros(solutions.len(), variables.len());
        for (i, ((w, z), at)) in grid.points().zip(&solutions).enumerate() {
            self.sensitivities(&contact, (w, z), at, variables, |j, value| by[(i, j)] = value)?;
        }
        Ok((solutions.iter().map(|s| s.f_n).collect(), by))
    }

    fn solutions(
        &self,
        contact: &ExactContact<'_, WormSurface<'a>>,
        grid: &RollGrid,
    ) -> Result<Vec<ContactSolution>, TangentialError> {
        contact.solve_grid(&grid.w, &grid.z).map_err(|failed| self.failure(grid, failed))
    }

    fn check_tool(&self, grid: &RollGrid, heights: impl Iterator<Item = f64>) -> Result<(), TangentialError> {
        let [from, to] = self.model.heights;
        let beyond = |s: f64| (from - s).max(s - to);
        let farthest = grid.points().zip(heights).max_by(|(_, a), (_, b)| beyond(*a).total_cmp(&beyond(*b)));
        match farthest.filter(|(_, s)| beyond(*s) > 1e-9) {
            None => Ok(()),
            Some(((w, z), s)) => {
                let radius = self.model.radius(self.flank, w);
                Err(TangentialError::OutsideTool { flank: self.flank, radius, z, s, from, to })
            }
        }
    }

    /// What a failure of the contact means here.
    fn failure(&self, grid: &RollGrid, failed: ContactError) -> TangentialError {
        let flank = self.flank;
        match failed {
            ContactError::Undercut { w, z, ratio, .. } => {
                TangentialError::Undercut { flank, radius: self.model.radius(flank, w), z, ratio }
            }
            ContactError::NotSettled { w, z, ratio, .. } => {
                TangentialError::NotSettled { flank, radius: self.model.radius(flank, w), z, ratio }
            }
            // The dresser leaves no envelope where the contact would be. The solver says where on the tool; the first point of the
            // grid that fails says where on the gear.
            ContactError::WormSurfaceMissing { .. } => {
                let contact = self.contact();
                let failing = grid.points().find(|&(w, z)| contact.solve(w, z).is_err());
                let (w, z) = failing.unwrap_or((grid.w[0], grid.z[0]));
                TangentialError::Undercut { flank, radius: self.model.radius(flank, w), z, ratio: 0.0 }
            }
            other => other.into(),
        }
    }

    fn point(&self, w: f64, at: &ContactSolution, plain: &WormSurface<'_>) -> FlankPoint {
        let (s, x_d) = at.tool;
        let dresser_angle = self.surface.touch(s, x_d).map_or(f64::NAN, |dressed| {
            let radial = dressed.contact.q - dressed.axes.centre;
            (-radial.dot(&dressed.axes.e2)).atan2(-radial.dot(&dressed.axes.e1))
        });
        // The solver has eliminated the angle on the dresser; the determinant with it has the circle's rate as a factor.
        let w_1 = self.model.pair.flanks[self.flank].worm_roll(w, 0.0, at.feed);
        let nominal = self.model.profiles[self.flank].height(w_1);
        let rates = [self.surface.circle_rate(s, x_d), plain.circle_rate(nominal, 0.0)];
        let folding = match rates {
            [Some(now), Some(before)] => now / before,
            _ => f64::NAN,
        };
        FlankPoint {
            deviation: at.f_n,
            height: s,
            dresser_angle,
            position: x_d,
            worm_angle: at.worm_angle,
            feed: -at.feed,
            determinant_ratio: at.determinant_ratio * folding,
        }
    }

    /// Only the explicit derivative counts (`docs/mathematics/tangential-dressing.md#the-dressed-worm`): what moves the tool's point along
    /// the normal.
    fn sensitivities(
        &self,
        contact: &ExactContact<'_, WormSurface<'a>>,
        (w, z): (f64, f64),
        at: &ContactSolution,
        variables: &[Variable],
        mut give: impl FnMut(usize, f64),
    ) -> Result<(), TangentialError> {
        let missing = || ContactError::WormSurfaceMissing { p: at.tool.0, q: at.tool.1 };
        let by = contact.sensitivities(w, z, at)?;
        let (s, x_d) = at.tool;
        let feed = -at.feed;
        let dressed = self.surface.touch(s, x_d).ok_or_else(missing)?;
        let DressedDirections { normal, axis, swing } = DressedDirections::of(&dressed);
        let scales = &self.model.scales;
        for (j, variable) in variables.iter().enumerate() {
            let channel = variable.channel;
            let tool = |direction: &Vector3<f64>| -by.tool_modification * normal.dot(direction);
            let effect = match channel {
                Channel::Profile(_) if !channel.concerns(self.flank) => 0.0,
                Channel::Profile(_) => tool(&(axis * -self.surface.sigma)),
                Channel::TangentialShift => tool(&-Vector3::y()),
                Channel::AxialOffset => tool(&Vector3::z()),
                Channel::DressingDistance => tool(&Vector3::x()),
                Channel::DressingAngle => tool(&swing),
                Channel::CrossedAxesAngle => by.crossed_axes_angle,
                Channel::CentreDistance => by.centre_distance,
                Channel::WorkTurn => -by.work_angle,
                Channel::ToolShift => by.shift,
                Channel::ShiftRatio => by.shift,
            };
            let length = match channel.abscissa() {
                Abscissa::Profile => s,
                Abscissa::Worm => x_d,
                Abscissa::Gear => feed,
            };
            let base = match channel {
                Channel::ShiftRatio => feed,
                _ => variable.shape.value(length * scales.per_length(channel.abscissa())),
            };
            give(j, effect * scales.effect(channel) * base);
        }
        Ok(())
    }
}

/// Directions in the room at a dressed point.
struct DressedDirections {
    /// Out of the dresser.
    normal: Vector3<f64>,
    /// Axis of the dresser.
    axis: Vector3<f64>,
    /// Velocity of the point when the crossing angle grows.
    swing: Vector3<f64>,
}

impl DressedDirections {
    fn of(dressed: &super::worm_surface::DressedPoint<f64>) -> Self {
        let arm = dressed.contact.q - dressed.axes.centre;
        Self { normal: dressed.contact.n, axis: dressed.axes.axis, swing: -Vector3::x().cross(&arm) }
    }
}

/// F_T, d, F_C and gamma over v = -z.
fn grinding_motion(
    model: &TangentialModel,
    pass: &[Flank],
    settings: &TangentialSettings,
) -> GeneratingMotion {
    let law = |channel| settings.law(channel, &model.scales, -1.0);
    let ratio = model.shift_ratio + settings.value(&Variable::shift_ratio());
    let line = MotionLaw::polynomial(0.0, vec![model.shift_offset(pass), -ratio]);
    let own = law(Channel::ToolShift);
    let shift = if own.is_zero() { line } else { MotionLaw::Sum(vec![line, own]) };
    GeneratingMotion {
        delta_d: law(Channel::CentreDistance),
        delta_phi_2: law(Channel::WorkTurn).scaled(-1.0),
        delta_gamma: law(Channel::CrossedAxesAngle),
        ..model.pair.motion(shift)
    }
}
