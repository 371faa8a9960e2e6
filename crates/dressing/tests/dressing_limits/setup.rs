//! Worms with their dressers, and the sweep of a section by brute sampling with the poses of the kinematics.

use dressing::{Clearance, DresserSection, DresserTool, GeometricRange, SectionPart, WormFlank};
use foundation::geometry::{Flank, Gear, GearData, InvoluteFlank, Sides};
use foundation::kinematics::{Dresser, DressingChain, DressingCorrection, DressingMotion, Point, Pose, Worm};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

const MODULE: f64 = 3.5;
/// Depth of the thread space below the reference cylinder, mm.
const ROOT: f64 = 1.25 * MODULE;

/// A worm with its nominal dresser: threads, reference diameter, profile angles (deg), hand, cone angle (deg), dresser diameter.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    pub threads: i32,
    pub diameter: f64,
    pub angles: [f64; 2],
    pub hand: f64,
    pub cone: f64,
    pub dresser: f64,
}

impl Choice {
    pub const EXAMPLE: Self =
        Self { threads: 5, diameter: 100.0, angles: [17.5, 17.5], hand: 1.0, cone: 0.0, dresser: 123.0 };

    /// Below it the used flank of that many threads would reach the base cylinder.
    pub fn least_diameter(&self) -> f64 {
        2.4 * f64::from(self.threads) * MODULE
    }

    pub fn worm(&self) -> Gear {
        let [left, right] = self.angles.map(f64::to_radians);
        Gear::new(GearData {
            teeth: self.threads,
            normal_module: MODULE,
            pressure_angle: Sides { left, right },
            helix_angle: self.hand * (f64::from(self.threads) * MODULE / self.diameter).acos(),
            profile_shift: 0.0,
            cone_angle: self.cone.to_radians(),
        })
        .unwrap()
    }

    pub fn tip_radius(&self) -> f64 {
        0.5 * self.dresser
    }

    pub fn flank(&self, flank: Flank) -> WormFlank {
        let flank = *self.worm().flank(flank);
        let roll = |height: f64| flank.length_of_roll(0.5 * self.diameter + height * MODULE).unwrap();
        WormFlank { flank, range: GeometricRange { w_nf: roll(-0.9), w_na: roll(0.9) } }
    }

    pub fn tool(&self) -> DresserTool {
        self.tool_beyond(0.6)
    }

    /// The dresser with profiles that reach beyond the used range by this share of it.
    pub fn tool_beyond(&self, margin: f64) -> DresserTool {
        let worm = self.worm();
        let chains = Sides::from_fn(|flank| {
            let p = worm.screw_parameter(flank);
            DressingChain {
                worm_angle: -FRAC_PI_2,
                crossing_angle: -(2.0 * p / self.diameter).atan(),
                centre_distance: self.tip_radius() + 0.5 * self.diameter - ROOT,
                offset: 0.0,
                screw_parameter: p,
            }
        });
        let ranges = Sides::from_fn(|flank| self.flank(flank).range);
        DresserTool::conjugate_beyond(&worm, chains, ranges, margin).unwrap()
    }
}

/// The section in steps: circles (r, z) of all parts.
pub fn circles(section: &DresserSection<'_>, land: f64, steps: usize) -> Vec<[f64; 2]> {
    let share = |k: usize| k as f64 / steps as f64;
    SectionPart::ALL
        .into_iter()
        .flat_map(|part| (0..=steps).map(move |k| section.point(part, share(k), land).unwrap()))
        .collect()
}

/// A worm flank to be looked at: inactive threads, and the plane z = b.
#[derive(Clone, Copy)]
pub struct View {
    pub worm: WormFlank,
    pub left_out: u32,
    pub b: f64,
}

impl View {
    /// f and w of a dresser point at `dk`, by the poses of the kinematics and the involute's definition.
    pub fn ray(&self, seat: &Seat, [r, z]: [f64; 2], psi: f64) -> (f64, f64) {
        let (sin, cos) = (seat.towards + psi).sin_cos();
        let q = seat.pose.point(&Point::new(r * cos, r * sin, z)).xyz;
        let InvoluteFlank { base_radius, base_helix_angle, base_space_half_angle, teeth, .. } =
            self.worm.flank;
        let s = self.worm.flank.s();
        let w_1 = (q.x * q.x + q.y * q.y - base_radius * base_radius).sqrt();
        // Angle from +y towards +x; the screw to z = b turns the point in the positive sense.
        let phi = q.x.atan2(q.y) - (self.b - q.z) / seat.p;
        let wider = 2.0 * PI * f64::from(self.left_out) / teeth;
        let tangent = phi + s * (w_1 / base_radius).atan();
        let delta = w_1 / base_radius + base_space_half_angle + wider
            - s * (tangent + self.b * base_helix_angle.tan() / base_radius);
        let f = base_radius * base_helix_angle.cos() * delta;
        (f, w_1 - f * base_helix_angle.cos())
    }

    fn used(&self, w: f64) -> bool {
        let margin = 1e-9;
        w >= self.worm.range.w_nf - margin && w <= self.worm.range.w_na + margin
    }

    /// Least f over circles and angles within 1.2 rad of the direction to the worm axis.
    pub fn brute(&self, seat: &Seat, circles: &[[f64; 2]], turns: usize) -> f64 {
        let mut least = f64::INFINITY;
        for &circle in circles {
            for k in 0..=turns {
                let (f, w) = self.ray(seat, circle, -1.2 + 2.4 * k as f64 / turns as f64);
                if f < least && self.used(w) {
                    least = f;
                }
            }
        }
        least
    }
}

/// Where the dresser stands, the direction from its centre to the worm axis, and the lead it works along.
pub struct Seat {
    pub pose: Pose<Worm, Dresser>,
    pub towards: f64,
    pub p: f64,
}

impl Seat {
    pub fn new(tool: &DresserTool, flank: Flank, dk: &DressingCorrection) -> Self {
        let chain = tool.flanks[flank].chain;
        let at = DressingMotion::constant(chain, *dk).position::<f64>(0.0);
        let towards = (at.offset * at.crossing_angle.cos().powi(2)).atan2(-at.centre_distance);
        Self { pose: at.pose(), towards, p: chain.screw_parameter }
    }
}

/// The place that was found lies on the section and on the flank and has that clearance; no sample has less.
pub fn is_the_least(
    section: &DresserSection<'_>,
    land: f64,
    view: &View,
    seat: &Seat,
    found: Option<Clearance>,
) -> Result<(), TestCaseError> {
    let sampled = view.brute(seat, &circles(section, land, 40), 600);
    let Some(at) = found else {
        prop_assert!(sampled.is_infinite(), "nothing found, sampled {sampled}");
        return Ok(());
    };
    prop_assert!(at.f <= sampled + 1e-9, "{at:?}, sampled {sampled}");
    let fine = circles(section, land, 4000);
    let apart =
        fine.iter().map(|c| (c[0] - at.circle[0]).hypot(c[1] - at.circle[1])).fold(f64::INFINITY, f64::min);
    prop_assert!(apart < 0.01, "{at:?} is {apart} off the section");
    let (f, w) = view.ray(seat, at.circle, at.psi);
    prop_assert!((f - at.f).abs() < 1e-9 && (w - at.w).abs() < 1e-8 && view.used(w), "{at:?}: {f}, {w}");
    Ok(())
}

pub fn choices() -> impl Strategy<Value = Choice> {
    let angles = (14.0..24.0f64, 14.0..24.0f64, any::<bool>());
    (1..8i32, 60.0..300.0f64, angles, any::<bool>(), 60.0..200.0f64).prop_map(
        |(threads, diameter, (left, right, symmetric), right_handed, dresser)| Choice {
            threads,
            diameter,
            angles: [left, if symmetric { left } else { right }],
            hand: if right_handed { 1.0 } else { -1.0 },
            cone: 0.0,
            dresser,
        },
    )
}

/// Corrections up to some that let the dresser cut deep into the opposite flank.
pub fn corrections() -> impl Strategy<Value = DressingCorrection> {
    (0.0..1.0f64, -0.01..0.01f64, -0.06..0.06f64, -0.6..0.6f64, -8.0..8.0f64)
        .prop_map(|(size, a, b, c, d)| [a, b, c, d].map(|x| x * size))
}

pub fn flanks() -> impl Strategy<Value = Flank> {
    any::<bool>().prop_map(|left| if left { Flank::Left } else { Flank::Right })
}

/// The section of the choice, if its profiles leave a land at the tip and reach so far.
pub fn section<'a>(
    tool: &'a DresserTool,
    flank: Flank,
    choice: &Choice,
) -> Result<DresserSection<'a>, TestCaseError> {
    DresserSection::new(tool, flank, choice.tip_radius()).map_err(|e| TestCaseError::reject(e.to_string()))
}
