//! The eight-axis machine while it dresses: axis positions -> pose of the dresser at the worm, and back in closed form with
//! all solutions (`docs/mathematics/dressing.md#axes-and-their-deviations`, `docs/mathematics/programs.md#from-bodies-to-axes`). Knows no
//! flank: which solution is good is decided elsewhere.
//!
//! Chain: H = Rz(-B1) Tz(-V1) Rx(-A1) Tx(-X1) Ty(Z1) Ry(C5) Rz(B3). The dresser is a body of revolution, so six axes meet
//! five demands: one rule closes the system.
//!
//! Kept for planning of the swivel while dressing: no command reaches it yet. Programs are written for a `machine::Machine` with a fixed
//! swivel.

use super::{Dresser, DressingPosition, MachineError, Pose, Worm};
use crate::numerics::{Scalar, brent, equidistant, value_of};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The seven axes of the chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DressingAxis {
    /// B1: rotation of the worm.
    Worm,
    /// V1: shift of the worm along its axis.
    Shift,
    /// A1: tilt of the head.
    Tilt,
    /// X1: radial slide.
    Radial,
    /// Z1: axial slide.
    Axial,
    /// C5: swivel of the dresser.
    Swivel,
    /// B3: rotation of the dresser.
    Dresser,
}

impl DressingAxis {
    /// All axes in the order of [`DressingAxes::values`].
    pub const ALL: [Self; 7] =
        [Self::Worm, Self::Shift, Self::Tilt, Self::Radial, Self::Axial, Self::Swivel, Self::Dresser];

    /// Letter and number on the machine.
    pub fn name(self) -> &'static str {
        ["B1", "V1", "A1", "X1", "Z1", "C5", "B3"][self as usize]
    }

    /// Whether it turns (rad) or slides (mm).
    pub fn is_rotary(self) -> bool {
        !matches!(self, Self::Shift | Self::Radial | Self::Axial)
    }

    /// A value or a difference of values in the unit that messages and files use: deg or mm.
    pub fn shown(self, value: f64) -> f64 {
        if self.is_rotary() { value.to_degrees() } else { value }
    }

    /// "deg" or "mm".
    pub fn unit(self) -> &'static str {
        if self.is_rotary() { "deg" } else { "mm" }
    }
}

/// Positions of the axes, rad and mm; with dual numbers also their rates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DressingAxes<T: Scalar = f64> {
    /// B1, rad. Carries full turns: it follows phi_S of the pose.
    pub worm: T,
    /// V1, mm.
    pub shift: T,
    /// A1, rad.
    pub tilt: T,
    /// X1, mm.
    pub radial: T,
    /// Z1, mm.
    pub axial: T,
    /// C5, rad.
    pub swivel: T,
    /// B3, rad, of a dresser that stands still in its chart (phi_A = 0); its own rotation is added.
    pub dresser: T,
}

impl<T: Scalar> DressingAxes<T> {
    /// From values in the order of [`DressingAxis::ALL`].
    pub fn from_values([worm, shift, tilt, radial, axial, swivel, dresser]: [T; 7]) -> Self {
        Self { worm, shift, tilt, radial, axial, swivel, dresser }
    }

    /// Values in the order of [`DressingAxis::ALL`].
    pub fn values(&self) -> [T; 7] {
        [self.worm, self.shift, self.tilt, self.radial, self.axial, self.swivel, self.dresser]
    }

    /// Position of one axis.
    pub fn get(&self, axis: DressingAxis) -> T {
        self.values()[axis as usize]
    }

    /// X_SA = H (dresser coordinates into worm coordinates) by forward kinematics.
    pub fn pose(&self) -> Pose<Worm, Dresser, T> {
        Pose::<Worm, Worm, T>::rz(-self.worm)
            .then(&Pose::<Worm, Worm, T>::tz(-self.shift))
            .then(&Pose::<Worm, Worm, T>::rx(-self.tilt))
            .then(&Pose::<Worm, Worm, T>::tx(-self.radial))
            .then(&Pose::<Worm, Worm, T>::ty(self.axial))
            .then(&Pose::<Worm, Worm, T>::ry(self.swivel))
            .then(&Pose::rz(self.dresser))
    }

    /// The parameters (phi_S, v_zS, gamma, d, v_y) of this pose; of the two sets that describe it the one whose worm angle
    /// is within a quarter turn of B1, or beyond it for [`DressingBranch::Turned`]. At gamma = 0, phi_S = B1.
    ///
    /// # Errors
    /// [`MachineError::Singular`] where the dresser axis stands across the worm axis: v_y is then no length along the
    /// tangent.
    pub fn position(&self, branch: DressingBranch) -> Result<DressingPosition<T>, MachineError> {
        let (sin_a, cos_a) = self.tilt.sin_cos();
        let (sin_c, cos_c) = self.swivel.sin_cos();
        // The dresser axis in the room: (sin C5, cos C5 sin A1, cos C5 cos A1) = (-sin delta sin g, cos delta sin g, cos g).
        let (across, along) = (cos_c * sin_a, cos_c * cos_a);
        if value_of(along).abs() < PARALLEL_SLIDES {
            return Err(MachineError::Singular { tilt_deg: value_of(self.tilt).to_degrees() });
        }
        let sign = branch.sign() * if value_of(across) < 0.0 { -1.0 } else { 1.0 };
        let at_pole = value_of(across) == 0.0 && value_of(sin_c) == 0.0;
        let (gamma, turn) = if at_pole {
            (along.acos(), T::from(0.0))
        } else {
            let sin_g = (across * across + sin_c * sin_c).sqrt() * sign;
            (sin_g.atan2(along), (-sin_c * sign).atan2(across * sign))
        };
        let (sin_d, cos_d) = turn.sin_cos();
        let (sin_g, cos_g) = gamma.sin_cos();
        let (g_x, g_y) = (-self.radial, self.axial * cos_a);
        let offset = (g_x * sin_d - g_y * cos_d) / cos_g;
        Ok(DressingPosition {
            worm_angle: self.worm - turn,
            worm_shift: self.shift + offset * sin_g + self.axial * sin_a,
            crossing_angle: gamma,
            centre_distance: g_x * cos_d + g_y * sin_d,
            offset,
        })
    }
}

/// The two ways in which the machine takes up a pose, br of `docs/mathematics/dressing.md#axes-and-their-deviations`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DressingBranch {
    /// br = +1: A1 has the sign of gamma; at C5 = 0 the axes are the parameters of the pose.
    Direct,
    /// br = -1: the worm turned by about half a turn, head tilted the other way, dresser on the other side.
    Turned,
}

impl DressingBranch {
    /// Both branches.
    pub const BOTH: [Self; 2] = [Self::Direct, Self::Turned];

    /// br.
    pub fn sign(self) -> f64 {
        match self {
            Self::Direct => 1.0,
            Self::Turned => -1.0,
        }
    }
}

/// What closes the system of six axes and five demands (`docs/mathematics/programs.md#from-bodies-to-axes`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DressingRule<T: Scalar = f64> {
    /// C5 is given, rad: two solutions, one where they coincide.
    Swivel(T),
    /// B1 is given, rad: one solution.
    WormAngle(T),
    /// Z1 is given, mm: for 0 the tilt chart of `docs/mathematics/dressing.md#limits-of-a-correction`, smooth through gamma = 0.
    AxialSlide(T),
}

/// One way to take up a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DressingSolution<T: Scalar = f64> {
    /// Positions of the axes.
    pub axes: DressingAxes<T>,
    /// Which of the two ways it is.
    pub branch: DressingBranch,
}

/// What the machine has: whether its dresser swivels, and the travel of every axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DressingMachine {
    /// Whether there is a swivel C5.
    pub swivel: bool,
    /// Travel of each axis in the order of [`DressingAxis::ALL`], rad or mm; `None` is without end.
    pub travel: [Option<[f64; 2]>; 7],
}

/// At |sin gamma| below this the worm angle is free.
const PARALLEL_AXES: f64 = 1e-12;
/// At |cos A1| below this V1 and Z1 are parallel.
const PARALLEL_SLIDES: f64 = 1e-9;
/// Worm angles of one turn at which Z1 is looked at.
const SCAN: usize = 181;
/// How far beyond its travel an axis may stand by rounding, rad or mm.
const TRAVEL_TOLERANCE: f64 = 1e-9;

impl DressingMachine {
    /// The eight-axis machine without ends of travel.
    pub const UNLIMITED: Self = Self { swivel: true, travel: [None; 7] };

    /// The same without the swivel C5.
    pub const WITHOUT_SWIVEL: Self = Self { swivel: false, travel: [None; 7] };

    /// All axis positions that give the pose under the rule, the direct branch first, then by the turn of the worm.
    /// `worm_wanted` (rad) settles the worm angle where the rule leaves it free, at gamma = 0. Travel is not looked at.
    ///
    /// # Errors
    /// [`MachineError::InvalidNumber`]; [`MachineError::MissingAxis`] for any rule but C5 = 0 on a machine without swivel;
    /// [`MachineError::Unreachable`] for a swivel beyond gamma or a slide beyond its reach; [`MachineError::PoleOfChart`] at
    /// gamma = 0 under the swivel rule without a wanted worm angle; [`MachineError::Singular`] at gamma = 90 degrees.
    pub fn axes<T: Scalar>(
        &self,
        position: &DressingPosition<T>,
        rule: DressingRule<T>,
        worm_wanted: Option<T>,
    ) -> Result<Vec<DressingSolution<T>>, MachineError> {
        let given = match rule {
            DressingRule::Swivel(x) | DressingRule::WormAngle(x) | DressingRule::AxialSlide(x) => value_of(x),
        };
        for (field, value) in [
            ("phi_S", value_of(position.worm_angle)),
            ("v_zS", value_of(position.worm_shift)),
            ("gamma_A", value_of(position.crossing_angle)),
            ("d_A", value_of(position.centre_distance)),
            ("v_yA", value_of(position.offset)),
            ("value of the rule", given),
            ("worm angle wanted", worm_wanted.map_or(0.0, value_of)),
        ] {
            if !value.is_finite() {
                return Err(MachineError::InvalidNumber { field, value });
            }
        }
        let gamma = value_of(position.crossing_angle);
        if gamma.cos().abs() < PARALLEL_SLIDES {
            return Err(MachineError::Singular { tilt_deg: gamma.to_degrees() });
        }
        if !self.swivel && !matches!(rule, DressingRule::Swivel(x) if value_of(x) == 0.0) {
            return Err(MachineError::MissingAxis { role: "swivel" });
        }
        match rule {
            DressingRule::Swivel(c) => by_swivel(position, c, worm_wanted),
            DressingRule::WormAngle(b) => Ok(vec![by_turn(position, b - position.worm_angle)]),
            DressingRule::AxialSlide(z) => by_slide(position, z),
        }
    }

    /// How far an axis stands inside its travel, rad or mm; negative beyond it, infinite where there is no end.
    pub fn margin(&self, axis: DressingAxis, value: f64) -> f64 {
        match self.travel[axis as usize] {
            Some([from, to]) => (value - from).min(to - value),
            None => f64::INFINITY,
        }
    }

    /// Whether all axes stand within their travel.
    ///
    /// # Errors
    /// [`MachineError::AxisLimit`] of the axis that stands furthest beyond.
    pub fn within_travel(&self, axes: &DressingAxes) -> Result<(), MachineError> {
        let beyond = DressingAxis::ALL.into_iter().map(|axis| (axis, self.margin(axis, axes.get(axis))));
        let worst = beyond.min_by(|a, b| a.1.total_cmp(&b.1));
        match worst {
            Some((axis, margin)) if margin < -TRAVEL_TOLERANCE => Err(self.limit(axis, -margin)),
            _ => Ok(()),
        }
    }

    /// The error of an axis that stands `excess` beyond its travel.
    pub fn limit(&self, axis: DressingAxis, excess: f64) -> MachineError {
        let [from, to] = self.travel[axis as usize].unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        MachineError::AxisLimit {
            axis: axis.name(),
            excess: axis.shown(excess),
            unit: axis.unit(),
            from: axis.shown(from),
            to: axis.shown(to),
        }
    }
}

/// The solution in which the worm stands turned by delta = B1 - phi_S: every rule ends here.
fn by_turn<T: Scalar>(at: &DressingPosition<T>, turn: T) -> DressingSolution<T> {
    let (sin_d, cos_d) = turn.sin_cos();
    let (sin_g, cos_g) = at.crossing_angle.sin_cos();
    let sin_c = -sin_d * sin_g;
    let swivel = sin_c.atan2((cos_d * cos_d * sin_g * sin_g + cos_g * cos_g).sqrt());
    solution(at, turn, swivel)
}

/// The solution at a turn of the worm with the swivel that belongs to it.
fn solution<T: Scalar>(at: &DressingPosition<T>, turn: T, swivel: T) -> DressingSolution<T> {
    let (sin_d, cos_d) = turn.sin_cos();
    let (sin_g, cos_g) = at.crossing_angle.sin_cos();
    let tilt = (cos_d * sin_g).atan2(cos_g);
    let (sin_a, cos_a) = tilt.sin_cos();
    let across = at.offset * cos_g;
    let axial = (at.centre_distance * sin_d - across * cos_d) / cos_a;
    let (sin_c, cos_c) = swivel.sin_cos();
    // First column of Ry(-C5) Rx(A1) Rz(delta) Rx(-g) = Rz(B3).
    let dresser = (cos_a * sin_d).atan2(cos_c * cos_d - sin_c * sin_a * sin_d);
    DressingSolution {
        axes: DressingAxes {
            worm: at.worm_angle + turn,
            shift: at.worm_shift - at.offset * sin_g - axial * sin_a,
            tilt,
            radial: -(at.centre_distance * cos_d + across * sin_d),
            axial,
            swivel,
            dresser,
        },
        branch: if value_of(cos_d) >= 0.0 { DressingBranch::Direct } else { DressingBranch::Turned },
    }
}

fn by_swivel<T: Scalar>(
    at: &DressingPosition<T>,
    swivel: T,
    worm_wanted: Option<T>,
) -> Result<Vec<DressingSolution<T>>, MachineError> {
    let (sin_g, sin_c) = (at.crossing_angle.sin(), swivel.sin());
    let sign = if value_of(sin_g) < 0.0 { -1.0 } else { 1.0 };
    let reach = value_of(sin_g).abs();
    let unreachable = || {
        let limit = reach.asin().to_degrees();
        let value = value_of(swivel).to_degrees();
        MachineError::Unreachable { axis: "C5 (deg)", value, least: -limit, greatest: limit }
    };
    if value_of(swivel).abs() >= FRAC_PI_2 {
        return Err(unreachable());
    }
    if reach < PARALLEL_AXES {
        if value_of(sin_c).abs() > PARALLEL_AXES {
            return Err(unreachable());
        }
        let worm = worm_wanted.ok_or(MachineError::PoleOfChart)?;
        return Ok(vec![solution(at, worm - at.worm_angle, swivel)]);
    }
    // cos C5 |sin A1| without the cancellation of 1 - cos^2.
    let rest = (sin_g - sin_c) * (sin_g + sin_c);
    if value_of(rest) < 0.0 {
        return Err(unreachable());
    }
    if value_of(rest) == 0.0 {
        // Both branches meet a quarter turn away; only the values exist there, no rates.
        let turn = T::from(-sign * FRAC_PI_2.copysign(value_of(sin_c)));
        return Ok(vec![solution(at, turn, swivel)]);
    }
    let root = rest.sqrt();
    // Adding 0 takes the sign from a zero.
    let sine = -sin_c * sign + 0.0;
    Ok(DressingBranch::BOTH
        .map(|branch| {
            let turn = sine.atan2(root * branch.sign());
            // Half a turn is written as -180 degrees, as in the reference numbers.
            let turn = if value_of(turn) == PI { turn - TAU } else { turn };
            DressingSolution { branch, ..solution(at, turn, swivel) }
        })
        .to_vec())
}

fn by_slide<T: Scalar>(at: &DressingPosition<T>, slide: T) -> Result<Vec<DressingSolution<T>>, MachineError> {
    if value_of(slide) == 0.0 {
        // d sin(delta) = v_y cos(g) cos(delta), whatever the tilt.
        let across = at.offset * at.crossing_angle.cos();
        if value_of(across) == 0.0 && value_of(at.centre_distance) == 0.0 {
            // The dresser's centre stands on the worm axis: every worm angle will do.
            return Ok(vec![by_turn(at, T::from(0.0))]);
        }
        let turns = [across.atan2(at.centre_distance), (-across).atan2(-at.centre_distance)];
        return Ok(sorted(turns.map(|turn| settled(at, slide, value_of(turn))).to_vec()));
    }
    let plain = values_of(at);
    let excess = |turn: f64| by_turn(&plain, turn).axes.axial - value_of(slide);
    let turns = equidistant([-PI, PI], SCAN);
    let values: Vec<f64> = turns.iter().map(|&turn| excess(turn)).collect();
    let mut found = Vec::new();
    for k in 0..SCAN - 1 {
        // A zero at a node belongs to the interval that begins there.
        if values[k + 1] == 0.0 {
            continue;
        }
        if let Some(root) =
            brent([turns[k], turns[k + 1]], [values[k], values[k + 1]], 0.0, |x| Some(excess(x)))
        {
            found.push(settled(at, slide, root));
        }
    }
    if found.is_empty() {
        let reach = crate::numerics::extremes(values.iter().map(|x| x + value_of(slide)));
        return Err(MachineError::Unreachable {
            axis: "Z1 (mm)",
            value: value_of(slide),
            least: reach[0],
            greatest: reach[1],
        });
    }
    Ok(sorted(found))
}

/// The solution at a turn that fulfils Z1 = slide in value: one Newton step gives the turn its rate, exactly.
fn settled<T: Scalar>(at: &DressingPosition<T>, slide: T, turn: f64) -> DressingSolution<T> {
    let plain = lifted(&values_of(at));
    let slope = by_turn(&plain, num_dual::Dual64::from_re(turn).derivative()).axes.axial.eps;
    let turn = T::from(turn);
    let miss = by_turn(at, turn).axes.axial - slide;
    by_turn(at, turn - miss / slope)
}

fn values_of<T: Scalar>(at: &DressingPosition<T>) -> DressingPosition {
    DressingPosition {
        worm_angle: value_of(at.worm_angle),
        worm_shift: value_of(at.worm_shift),
        crossing_angle: value_of(at.crossing_angle),
        centre_distance: value_of(at.centre_distance),
        offset: value_of(at.offset),
    }
}

fn lifted(at: &DressingPosition) -> DressingPosition<num_dual::Dual64> {
    let constant = num_dual::Dual64::from_re;
    DressingPosition {
        worm_angle: constant(at.worm_angle),
        worm_shift: constant(at.worm_shift),
        crossing_angle: constant(at.crossing_angle),
        centre_distance: constant(at.centre_distance),
        offset: constant(at.offset),
    }
}

fn sorted<T: Scalar>(mut solutions: Vec<DressingSolution<T>>) -> Vec<DressingSolution<T>> {
    let key = |s: &DressingSolution<T>| (s.branch == DressingBranch::Turned, value_of(s.axes.worm));
    solutions.sort_by(|a, b| {
        let ((turned_a, worm_a), (turned_b, worm_b)) = (key(a), key(b));
        turned_a.cmp(&turned_b).then(worm_a.total_cmp(&worm_b))
    });
    solutions
}
