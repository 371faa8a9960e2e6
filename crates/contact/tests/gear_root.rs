//! The root that a worm with rounded tip leaves: against the flank beside it, the radii on the common perpendicular, and the ball
//! on the edge at all instants.

use contact::{ContactError, Pair, TipCorner};
use foundation::geometry::{Flank, Gear, GearData, Sides};
use foundation::kinematics::{GeneratingMotion, MotionLaw};

const Z: [f64; 3] = [-12.0, 0.0, 9.0];
const CORNER: f64 = 0.7;

/// A worm of `threads` with a gear of 31 teeth, module 2.5.
fn pair(threads: i32, hand: f64, angles: [f64; 2], helix: f64) -> Pair {
    let work = GearData {
        teeth: 31,
        normal_module: 2.5,
        pressure_angle: Sides { left: angles[0].to_radians(), right: angles[1].to_radians() },
        helix_angle: helix.to_radians(),
        profile_shift: 0.15,
        cone_angle: 0.0,
    };
    let helix_angle = hand * (f64::from(threads) * 2.5 / 160.0).acos();
    let worm = GearData { teeth: threads, helix_angle, profile_shift: 0.0, ..work };
    Pair::without_backlash(
        Gear::new(worm).unwrap(),
        Gear::new(work).unwrap(),
        -(helix_angle + work.helix_angle),
    )
    .unwrap()
}

fn tip_radius(pair: &Pair) -> f64 {
    pair.worm.pitch_radius() + 1.2 * 2.5
}

/// Shift proportional to the feed, with a crowning by the centre distance.
fn motion(pair: &Pair, bow: f64) -> GeneratingMotion {
    let mut motion = pair.motion(MotionLaw::polynomial(0.0, vec![1.5, -0.8]));
    motion.delta_d = MotionLaw::polynomial(0.0, vec![0.0, 0.0, -bow]);
    motion
}

#[test]
fn the_fillet_joins_the_flank_and_reaches_the_root() {
    for (threads, hand, angles, helix) in
        [(1, 1.0, [20.0, 20.0], 0.0), (3, -1.0, [20.0, 20.0], -25.0), (2, 1.0, [25.0, 18.0], 20.0)]
    {
        let pair = pair(threads, hand, angles, helix);
        let motion = motion(&pair, 0.0);
        for flank in Flank::BOTH {
            let corner = TipCorner::new(
                *pair.worm.flank(flank),
                CORNER,
                MotionLaw::polynomial(0.0, vec![tip_radius(&pair)]),
            )
            .unwrap();
            for z in Z {
                let fillet = corner.fillet(&motion, pair.work.flank(flank), z).unwrap();
                let root = pair.chain.centre_distance - tip_radius(&pair);
                assert!((fillet.root_radius() - root).abs() < 1e-9, "{} {root}", fillet.root_radius());
                let [x, y] = fillet.point(0.0);
                let beside = pair.work.flank(flank).deviation(&nalgebra::Vector3::new(x, y, z));
                assert!(beside.f_n.abs() < 1e-9, "{flank} {z}: {}", beside.f_n);
                // The last length of roll of the worm's flank grinds the first of the gear's.
                let joined = pair.flanks[flank].worm_roll(beside.w, 0.0, 0.0);
                assert!((joined - corner.end_of_flank(0.0)).abs() < 1e-9);
                assert!(
                    fillet.transition() < 1e-6 && fillet.rise() < 1e-9,
                    "{} {}",
                    fillet.transition(),
                    fillet.rise()
                );
                // A trochoid is nowhere sharper than the edge that traces it.
                assert!(
                    fillet.least_radius_of_curvature() > CORNER,
                    "{}",
                    fillet.least_radius_of_curvature()
                );
            }
        }
    }
}

/// No ball on the edge at any instant of the motion reaches beyond the fillet, and each point of it is reached.
#[test]
fn balls_on_the_edge_touch_the_fillet_and_nothing_beyond() {
    let pair = pair(2, 1.0, [25.0, 18.0], 20.0);
    let motion = motion(&pair, 3e-4);
    let tip = MotionLaw::polynomial(0.0, vec![tip_radius(&pair), 1e-3, -2e-4]);
    for flank in Flank::BOTH {
        let worm = pair.worm.flank(flank);
        let corner = TipCorner::new(*worm, CORNER, tip.clone()).unwrap();
        for z in Z {
            let fillet = corner.fillet(&motion, pair.work.flank(flank), z).unwrap();
            for point in fillet.points(5) {
                // The feeds at which this section is ground lie near -z.
                let mut least = f64::INFINITY;
                for i in -40..=40 {
                    let feed = -z + 0.1 * f64::from(i);
                    for k in -60..=60 {
                        let zeta = -motion.shift.value(feed) + 0.1 * f64::from(k);
                        let r = tip.value(zeta) - CORNER;
                        let w =
                            (r * r - worm.base_radius.powi(2)).sqrt() + CORNER * worm.base_helix_angle.cos();
                        let foot = zeta - worm.s() * CORNER * worm.base_helix_angle.sin();
                        let centre = worm.point(w, foot) - worm.normal(w, foot) * CORNER;
                        for j in -40..=40 {
                            let angle = centre.x.atan2(centre.y) + 0.005 * f64::from(j);
                            let state = motion.state(angle, feed, motion.phase[flank]);
                            let at = motion.chain.pose(&state).inverse();
                            let c = at.rotation() * centre + at.translation();
                            let turn = nalgebra::Rotation3::from_axis_angle(
                                &nalgebra::Vector3::z_axis(),
                                ((c.x.atan2(c.y) - point[0].atan2(point[1])) * 31.0 / std::f64::consts::TAU)
                                    .round()
                                    * std::f64::consts::TAU
                                    / 31.0,
                            );
                            let gap =
                                (turn * c - nalgebra::Vector3::new(point[0], point[1], z)).norm() - CORNER;
                            least = least.min(gap);
                        }
                    }
                }
                // The raster misses the very instant by hundredths of a millimetre at most: squared over the radii.
                assert!(least > -1e-6 && least < 2e-3, "{flank} {z}: {least}");
            }
        }
    }
}

#[test]
fn impossible_edges_are_refused() {
    let pair = pair(2, 1.0, [20.0, 20.0], 15.0);
    let tip = MotionLaw::polynomial(0.0, vec![tip_radius(&pair)]);
    let worm = *pair.worm.flank(Flank::Left);
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = TipCorner::new(worm, radius, tip.clone()).unwrap_err();
        assert!(matches!(error, ContactError::InvalidNumber { .. }), "{error}");
    }
    let error = TipCorner::new(worm, 1e3, tip).unwrap_err();
    assert_eq!(error.code(), "corner-radius-too-large");
    assert!(error.to_string().contains("1000"));
}
