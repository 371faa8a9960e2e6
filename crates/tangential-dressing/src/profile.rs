//! The dresser's nominal profile: half thickness S over the height s above its pitch circle
//! (`docs/mathematics/tangential-dressing.md#profile-of-the-dresser`), and where on it, and where along the worm, a length of roll of the
//! unmodified worm is dressed. Knows no motion.

use super::TangentialError;
use dressing::{NominalContact, nominal_contact};
use foundation::geometry::{InvoluteFlank, Revolution};
use foundation::kinematics::DressingChain;
use foundation::numerics::{Chebyshev, brent};

/// What the dresser's flanks are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ProfileKind {
    /// The exact conjugate of the involute worm.
    #[default]
    Conjugate,
    /// The straight line of the rack, as the source has it: it leaves some tenths of a micrometre.
    Straight,
}

/// Height of the dresser in normal modules: from the worm's tip to its root.
const HEIGHTS: [f64; 2] = [-1.75, 1.55];
/// Height down to which the profile is known all the same, in normal modules: an iteration may pass there, and the involute of the worm
/// goes on.
const KNOWN_FROM: f64 = -2.75;
/// Nodes; the series ends below 4e-15 mm (`docs/mathematics/tangential-dressing.md#profile-of-the-dresser`).
const NODES: usize = 28;
/// Nodes of the profile with its function, first try and most: splines need many.
const SERIES_NODES: [usize; 2] = [48, 768];
/// Its accuracy, mm.
const SERIES_ACCURACY: f64 = 1e-13;
/// Trailing coefficients below this share of the largest are the rounding of the nodes: half a dozen are left, and derivatives gain.
const NOISE: f64 = 5e-15;
/// Accuracy of a length of roll, mm; heights follow it with a slope of some tenths.
const ROLL_ACCURACY: f64 = 1e-14;

/// The nominal profile of one side.
#[derive(Clone, Debug)]
pub(super) struct Profile {
    /// Pitch radius r_pd, mm.
    pub pitch_radius: f64,
    /// Range of s, mm.
    pub heights: [f64; 2],
    /// S over s.
    half_thickness: Chebyshev,
    /// s of a length of roll w_1 of the worm.
    height: Chebyshev,
    /// z_c: where along the worm w_1 is dressed while x_D = 0.
    line: Chebyshev,
}

impl Profile {
    /// The side that dresses a flank of a worm, on pitch radii of dresser and worm; of a symmetric worm both are mirror images. A conical gear
    /// uses `beyond` more of it at both ends, mm.
    pub fn new(
        worm: &InvoluteFlank,
        chain: &DressingChain,
        [pitch_radius, worm_pitch_radius]: [f64; 2],
        [normal_module, normal_pressure_angle]: [f64; 2],
        (kind, beyond): (ProfileKind, f64),
    ) -> Result<Self, TangentialError> {
        let [lowest, highest] = HEIGHTS.map(|x| x * normal_module);
        let heights = [lowest - beyond, highest + beyond];
        let r_b = worm.base_radius;
        if worm_pitch_radius + heights[0] <= r_b {
            return Err(TangentialError::InvalidNumber {
                field: "pitch radius of the worm",
                value: worm_pitch_radius,
                allowed: "above its base radius by more than 1.75 normal modules: a larger worm or fewer threads",
            });
        }
        let at = |w: f64| nominal_contact(worm, chain, w);
        let roll_near = |radius: f64| (radius * radius - r_b * r_b).max(0.0).sqrt();
        // The dresser's s is the worm's p - r but for some micrometres; a tenth of a module on both sides brackets it.
        let roll_of = |s: f64| -> Result<(f64, NominalContact), TangentialError> {
            let margin = 0.1 * normal_module;
            let low = roll_near(worm_pitch_radius - s - margin).max(1e-6);
            let high = roll_near(worm_pitch_radius - s + margin);
            let off = |w: f64| Ok::<f64, TangentialError>(at(w)?.r - pitch_radius - s);
            let ends = [off(low)?, off(high)?];
            let w = brent([low, high], ends, ROLL_ACCURACY, |w| off(w).ok());
            let w = w.ok_or(TangentialError::InvalidNumber {
                field: "pitch radius of the dresser",
                value: pitch_radius,
                allowed: "such that every height of the worm has its circle on the dresser",
            })?;
            Ok((w, at(w)?))
        };
        let side = worm.s() * if worm.base_helix_angle > 0.0 { 1.0 } else { -1.0 };
        let [from, to] = [KNOWN_FROM * normal_module - beyond, heights[1]];
        let thickness = match kind {
            ProfileKind::Conjugate => {
                Chebyshev::fit(from, to, NODES, |s| Ok::<f64, TangentialError>(side * roll_of(s)?.1.z))?
            }
            ProfileKind::Straight => {
                let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
                let slope = -normal_pressure_angle.tan();
                let start = 0.25 * std::f64::consts::PI * normal_module;
                Chebyshev::from_coefficients(from, to, vec![start + slope * middle, slope * half])
            }
        }
        .truncated(NOISE);
        let (first, last) = (roll_of(to)?.0, roll_of(from)?.0);
        let contacts = Chebyshev::nodes(first, last, NODES)
            .into_iter()
            .map(|w| at(w).map_err(TangentialError::from))
            .collect::<Result<Vec<_>, _>>()?;
        let over_roll = |value: &dyn Fn(&NominalContact) -> f64| {
            let values: Vec<f64> = contacts.iter().map(value).collect();
            Chebyshev::interpolate(first, last, &values).truncated(NOISE)
        };
        Ok(Self {
            pitch_radius,
            heights,
            height: over_roll(&|c| c.r - pitch_radius),
            line: over_roll(&|c| c.b),
            half_thickness: thickness,
        })
    }

    /// Heights over which the half thickness is known, mm.
    pub fn known(&self) -> [f64; 2] {
        let (from, to) = self.half_thickness.interval();
        [from, to]
    }

    /// S, S', S'' at the height s, mm. Beyond what is known it continues with the curvature of its end: a way for iterations, not a
    /// dresser.
    pub fn half_thickness(&self, s: f64) -> [f64; 3] {
        let (from, to) = self.half_thickness.interval();
        let end = s.clamp(from, to);
        let [thickness, slope, bend] = self.half_thickness.jet(end);
        let beyond = s - end;
        [thickness + beyond * (slope + 0.5 * beyond * bend), slope + beyond * bend, bend]
    }

    /// Height s that dresses the length of roll w_1 nominally, mm; beyond the profile that of its end.
    pub fn height(&self, w_1: f64) -> f64 {
        let (from, to) = self.height.interval();
        self.height.value(w_1.clamp(from, to)).clamp(self.heights[0], self.heights[1])
    }

    /// Lengths of roll of the worm between which the dresser exists, mm.
    pub fn rolls(&self) -> [f64; 2] {
        let (from, to) = self.height.interval();
        [from, to]
    }

    /// The length of roll that the height s dresses nominally, mm; beyond the profile that of its end.
    pub fn roll(&self, s: f64) -> f64 {
        let (first, last) = self.height.interval();
        let off = |w: f64| self.height.value(w) - s;
        let ends = [off(first), off(last)];
        if ends[0] * ends[1] >= 0.0 {
            // Large rolls of the worm lie low on the dresser.
            return if ends[0].abs() < ends[1].abs() { first } else { last };
        }
        brent([first, last], ends, ROLL_ACCURACY, |w| Some(off(w))).unwrap_or(first)
    }

    /// z_c, mm.
    pub fn line(&self, w_1: f64) -> f64 {
        let (from, to) = self.line.interval();
        self.line.value(w_1.clamp(from, to))
    }

    /// dz_c/dw_1.
    pub fn line_slope(&self, w_1: f64) -> f64 {
        let (from, to) = self.line.interval();
        self.line.jet(w_1.clamp(from, to))[1]
    }

    /// A side of the dresser as a surface of revolution over s, with the profile function F_p taken off, between `heights` as far as it
    /// goes.
    pub fn revolution(&self, sigma: f64, heights: [f64; 2], removed: impl Fn(f64) -> f64) -> Revolution {
        let (from, to) = (heights[0].max(self.heights[0]), heights[1].min(self.heights[1]));
        let [mut count, most] = SERIES_NODES;
        let axial = loop {
            let nodes = Chebyshev::nodes(from, to, count).into_iter();
            let values: Vec<f64> =
                nodes.map(|s| sigma * (self.half_thickness.value(s) - removed(s))).collect();
            let series = Chebyshev::interpolate(from, to, &values);
            if series.tail() < SERIES_ACCURACY || count >= most {
                break series.truncated(1e-17);
            }
            count *= 2;
        };
        let middle = self.pitch_radius + 0.5 * (from + to);
        let radius = Chebyshev::from_coefficients(from, to, vec![middle, 0.5 * (to - from)]);
        // Out of the dresser's material: away from its middle plane.
        Revolution::new(radius, axial, -sigma)
    }
}
