//! Limits of dressing: clearances against brute sampling of the swept section, against the envelope of the counter flank, and
//! every refusal. The reference numbers are checked by `verify` (`tests/verify.rs`).

use flankwright::geometry::{Flank, Gear, GearData, InvoluteFlank, Sides};
use flankwright::kinematics::{
    Dresser, DressingChain, DressingCorrection, DressingMotion, Point, Pose, Worm,
};
use flankwright::process::dressing::{
    Clearance, DresserSection, DresserTool, DressingError, GeometricRange, SectionPart, WormFlank,
};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

const MODULE: f64 = 3.5;
/// Depth of the thread space below the reference cylinder, mm.
const ROOT: f64 = 1.25 * MODULE;

/// A worm with its nominal dresser: threads, reference diameter, profile angles (deg), hand, cone angle (deg), dresser diameter.
#[derive(Clone, Copy, Debug)]
struct Choice {
    threads: i32,
    diameter: f64,
    angles: [f64; 2],
    hand: f64,
    cone: f64,
    dresser: f64,
}

const CASE: Choice =
    Choice { threads: 5, diameter: 100.0, angles: [17.5, 17.5], hand: 1.0, cone: 0.0, dresser: 123.0 };

impl Choice {
    fn worm(&self) -> Gear {
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

    fn tip_radius(&self) -> f64 {
        0.5 * self.dresser
    }

    fn flank(&self, flank: Flank) -> WormFlank {
        let flank = *self.worm().flank(flank);
        let roll = |height: f64| flank.length_of_roll(0.5 * self.diameter + height * MODULE).unwrap();
        WormFlank { flank, range: GeometricRange { w_nf: roll(-0.9), w_na: roll(0.9) } }
    }

    fn tool(&self) -> DresserTool {
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
        DresserTool::conjugate(&worm, chains, Sides::from_fn(|flank| self.flank(flank).range)).unwrap()
    }
}

/// The section in steps: circles (r, z) of all parts.
fn circles(section: &DresserSection<'_>, land: f64, steps: usize) -> Vec<[f64; 2]> {
    let share = |k: usize| k as f64 / steps as f64;
    SectionPart::ALL
        .into_iter()
        .flat_map(|part| (0..=steps).map(move |k| section.point(part, share(k), land).unwrap()))
        .collect()
}

/// A worm flank to be looked at: left-out threads, and the plane z = b.
#[derive(Clone, Copy)]
struct View {
    worm: WormFlank,
    left_out: u32,
    b: f64,
}

impl View {
    /// f and w of a dresser point at `dk`, by the poses of the kinematics and the involute's definition.
    fn ray(&self, seat: &Seat, [r, z]: [f64; 2], psi: f64) -> (f64, f64) {
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
    fn brute(&self, seat: &Seat, circles: &[[f64; 2]], turns: usize) -> f64 {
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
struct Seat {
    pose: Pose<Worm, Dresser>,
    towards: f64,
    p: f64,
}

impl Seat {
    fn new(tool: &DresserTool, flank: Flank, dk: &DressingCorrection) -> Self {
        let chain = tool.flanks[flank].chain;
        let at = DressingMotion::constant(chain, *dk).position::<f64>(0.0);
        let towards = (at.offset * at.crossing_angle.cos().powi(2)).atan2(-at.centre_distance);
        Self { pose: at.pose(), towards, p: chain.screw_parameter }
    }
}

/// The place that was found lies on the section and on the flank and has that clearance; no sample has less.
fn is_the_least(
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

fn choices() -> impl Strategy<Value = Choice> {
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

/// Corrections up to some that let the dresser cut deep into the counter flank.
fn corrections() -> impl Strategy<Value = DressingCorrection> {
    (0.0..1.0f64, -0.01..0.01f64, -0.06..0.06f64, -0.6..0.6f64, -8.0..8.0f64)
        .prop_map(|(size, a, b, c, d)| [a, b, c, d].map(|x| x * size))
}

fn flanks() -> impl Strategy<Value = Flank> {
    any::<bool>().prop_map(|left| if left { Flank::Left } else { Flank::Right })
}

/// The section of the choice, if its profiles leave a land at the tip and reach so far.
fn section<'a>(tool: &'a DresserTool, flank: Flank, choice: &Choice) -> Option<DresserSection<'a>> {
    DresserSection::new(tool, flank, choice.tip_radius()).ok()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(std::env::var("CASES").map_or(24, |x| x.parse().unwrap())))]

    #[test]
    fn the_counter_flank_is_seen_as_sampling_sees_it(
        choice in choices(),
        flank in flanks(),
        dk in corrections(),
        share in 0.0..1.0f64,
        left_out in 0..3u32,
    ) {
        let left_out = left_out.min(choice.threads.unsigned_abs() - 1);
        let tool = choice.tool();
        let Some(section) = section(&tool, flank, &choice) else { return Err(TestCaseError::reject("no section")) };
        let land = share * section.full_land();
        let found = match section.counter_flank(&dk, land, left_out.into()) {
            Err(DressingError::NoContact { .. }) => return Err(TestCaseError::reject("no contact")),
            found => found.unwrap(),
        };
        let view = View { worm: choice.flank(flank.other()), left_out, b: 0.0 };
        is_the_least(&section, land, &view, &Seat::new(&tool, flank, &dk), found)?;
    }

    #[test]
    fn another_worm_is_seen_as_sampling_sees_it(
        choice in choices(),
        flank in flanks(),
        dk in corrections(),
        smaller in 0.7..1.05f64,
        b in -60.0..60.0f64,
    ) {
        let other = Choice { diameter: (smaller * choice.diameter).max(30.0), ..choice };
        let tool = choice.tool();
        let Some(section) = section(&tool, flank, &choice) else { return Err(TestCaseError::reject("no section")) };
        let land = 0.4 * section.full_land();
        let worms = Sides::from_fn(|f| other.flank(f));
        let found = match section.undermining(&dk, land, &worms, &[b]) {
            Err(DressingError::NoContact { .. }) => return Err(TestCaseError::reject("no contact")),
            found => found.unwrap(),
        };
        for (f, at) in found.iter() {
            let view = View { worm: worms[f], left_out: 0, b };
            is_the_least(&section, land, &view, &Seat::new(&tool, flank, &dk), at[0])?;
        }
    }
}
