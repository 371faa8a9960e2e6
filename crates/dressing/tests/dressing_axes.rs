//! Dressing motions in machine axes: influences against the forward calculation, reversals against brute force, and choices
//! against every other way.

use contact::ToolSurface;
use dressing::{
    AxisCriterion, AxisUncertainty, DressedProfile, DressedWorm, DresserTool, GeometricRange, MachineTask,
    MachineWay, SwivelChoice, SwivelLaw, WormContact, dressing_motion,
};
use foundation::geometry::{Flank, Gear, GearData, Sides};
use foundation::kinematics::{
    DressingAxes, DressingAxis, DressingBranch, DressingChain, DressingMachine, DressingMotion, DressingRule,
    MotionLaw,
};
use foundation::numerics::{Chebyshev, equidistant};
use std::f64::consts::FRAC_PI_2;

const MODULE: f64 = 3.5;
const DIAMETER: f64 = 100.0;

/// Case A of `docs/mathematics/dressing.md`: 5 threads, d_S 100, dresser 123.
fn tool() -> DresserTool {
    let worm = Gear::new(GearData {
        teeth: 5,
        normal_module: MODULE,
        pressure_angle: Sides::both(17.5f64.to_radians()),
        helix_angle: (5.0 * MODULE / DIAMETER).acos(),
        profile_shift: 0.0,
        cone_angle: 0.0,
    })
    .unwrap();
    let p = worm.screw_parameter(Flank::Left);
    let chain = DressingChain {
        worm_angle: -FRAC_PI_2,
        crossing_angle: -(2.0 * p / DIAMETER).atan(),
        centre_distance: 0.5 * (123.0 + DIAMETER) - 1.25 * MODULE,
        offset: 0.0,
        screw_parameter: p,
    };
    let flank = *worm.flank(Flank::Left);
    let roll = |height: f64| flank.length_of_roll(0.5 * DIAMETER + height * MODULE).unwrap();
    let range = GeometricRange { w_nf: roll(-0.9), w_na: roll(0.9) };
    DresserTool::conjugate(&worm, Sides::both(chain), Sides::both(range)).unwrap()
}

/// DK = lin v + quad v^2 over +-40 mm.
fn series(lin: [f64; 4], quad: [f64; 4]) -> [Chebyshev; 4] {
    let nodes = Chebyshev::nodes(-40.0, 40.0, 5);
    std::array::from_fn(|j| {
        let values: Vec<f64> = nodes.iter().map(|v| (lin[j] + quad[j] * v) * v).collect();
        Chebyshev::interpolate(-40.0, 40.0, &values)
    })
}

/// A motion that crowns along the worm: every correction has its extremum in the middle.
fn crowning() -> [Chebyshev; 4] {
    series([0.0; 4], [2e-6, 1.2e-5, 2e-6, -4e-5])
}

#[test]
fn influences_are_those_of_the_forward_calculation() {
    let tool = tool();
    let mut worst: f64 = 0.0;
    for flank in Flank::BOTH {
        let dresser = &tool.flanks[flank];
        let (chain, p) = (dresser.chain, dresser.chain.screw_parameter);
        for dk in [[0.0; 4], [0.002, -0.014, -0.05, 1.5]] {
            let constant = dk.map(|x| Chebyshev::constant(-40.0, 40.0, x));
            let worm = DressedWorm::new(&tool, flank, &constant);
            let motion = DressingMotion::constant(chain, dk);
            let v = 3.0;
            let position = motion.position(v);
            for swivel in [0.0, 0.08, -0.06] {
                for found in
                    DressingMachine::UNLIMITED.axes(&position, DressingRule::Swivel(swivel), None).unwrap()
                {
                    let twists = found.axes.twists();
                    for t in [dresser.range.w_nf, dresser.range.middle(), dresser.range.w_na] {
                        let jet = worm.jet(t, v).unwrap();
                        let foot = worm.flank().deviation(&jet.p);
                        let nominal = worm.flank().normal(foot.w, foot.z);
                        let contact = WormContact { point: jet.p, normal: jet.n, nominal };
                        let influence = contact.influence(&twists);
                        // The same deviation of the axis at every v: a constant correction once more.
                        let f = |axis: DressingAxis, step: f64| {
                            let mut values = found.axes.values();
                            values[axis as usize] += step;
                            let at = DressingAxes::from_values(values).position(found.branch).unwrap();
                            let dk = [
                                at.worm_angle - at.worm_shift / p - chain.worm_angle,
                                at.crossing_angle - chain.crossing_angle,
                                at.centre_distance - chain.centre_distance,
                                at.offset - chain.offset,
                            ];
                            DressedProfile::new(&tool, flank, dk).at_roll(foot.w).unwrap().f
                        };
                        for axis in DressingAxis::ALL {
                            let step = if axis.is_rotary() { 2e-6 } else { 2e-4 };
                            let difference = (f(axis, step) - f(axis, -step)) / (2.0 * step);
                            let scale = if axis.is_rotary() { DIAMETER } else { 1.0 };
                            let apart = (influence[axis as usize] - difference).abs() / scale;
                            worst = worst.max(apart);
                            assert!(
                                apart < 5e-7,
                                "{flank} {} {swivel}: {} {difference}",
                                axis.name(),
                                influence[axis as usize]
                            );
                        }
                        // Magnitudes of `docs/mathematics/generating-contact.md#machine-chains` for the worm's own axes, exact for the
                        // unmodified flank.
                        if dk == [0.0; 4] {
                            let f = worm.flank();
                            assert!(
                                (influence[0].abs() - f.base_radius * f.base_helix_angle.cos()).abs() < 1e-9
                            );
                            assert!((influence[1].abs() - f.base_helix_angle.sin().abs()).abs() < 1e-11);
                        }
                        assert!(influence[6].abs() < 1e-10);
                    }
                }
            }
        }
    }
    println!("worst influence difference {worst:.1e}");
}

struct Case {
    motion: DressingMotion,
    worms: [DressedWorm; 2],
}

fn case() -> Case {
    let (tool, series) = (tool(), crowning());
    let worms = Flank::BOTH.map(|flank| DressedWorm::new(&tool, flank, &series));
    Case { motion: dressing_motion(tool.flanks.left.chain, &series), worms }
}

impl Case {
    fn with<R>(&self, machine: &DressingMachine, run: impl FnOnce(&MachineTask<'_>) -> R) -> R {
        let worms: Vec<&DressedWorm> = self.worms.iter().collect();
        run(&MachineTask {
            machine,
            motion: &self.motion,
            interval: [-35.0, 35.0],
            worms: &worms,
            uncertainty: AxisUncertainty::default(),
            tolerance: None,
        })
    }
}

fn swivelled(branch: DressingBranch, middle: f64, slope: f64) -> MachineWay {
    MachineWay { branch, law: SwivelLaw::Swivel(MotionLaw::polynomial(0.0, vec![middle, slope])) }
}

#[test]
fn tables_carry_the_pose_and_their_own_rates() {
    let case = case();
    let machine = DressingMachine::UNLIMITED;
    let laws = [
        swivelled(DressingBranch::Direct, 0.05, 5e-4),
        swivelled(DressingBranch::Turned, -0.05, 5e-4),
        MachineWay {
            branch: DressingBranch::Direct,
            law: SwivelLaw::AxialSlide(MotionLaw::polynomial(0.0, vec![4.0, 0.1])),
        },
        MachineWay { branch: DressingBranch::Turned, law: SwivelLaw::AxialSlide(MotionLaw::zero()) },
    ];
    for way in laws {
        let driven = case.with(&machine, |task| task.drive(&way)).unwrap();
        for row in &driven.rows {
            let (h, k) = (row.axes.pose(), case.motion.position(row.v).pose());
            let apart = (h.rotation() - k.rotation()).abs().max();
            assert!(apart.max((h.translation() - k.translation()).abs().max()) < 1e-11);
        }
        for three in driven.rows.windows(3) {
            let step = three[2].v - three[0].v;
            for axis in DressingAxis::ALL {
                let [before, after] = [three[0], three[2]].map(|row| row.axes.get(axis));
                let rate = three[1].rates.get(axis);
                // No jump by a turn anywhere; central differences over 2 mm.
                assert!(
                    ((after - before) / step - rate).abs() < 2e-3 * (1.0 + rate.abs()),
                    "{}",
                    axis.name()
                );
            }
        }
        // The law through the table is the axis between its rows.
        let law = driven.law(DressingAxis::Axial).unwrap();
        let between =
            case.with(&machine, |task| MachineTask { interval: [-34.0, 34.3], ..*task }.drive(&way)).unwrap();
        for row in &between.rows {
            assert!((law.value(row.v) - row.axes.axial).abs() < 1e-6);
        }
    }
}

#[test]
fn reversals_are_found_where_the_axes_turn_round() {
    let case = case();
    let machine = DressingMachine::UNLIMITED;
    let way = swivelled(DressingBranch::Direct, 0.03, 0.0);
    let driven = case.with(&machine, |task| task.drive(&way)).unwrap();
    // Brute force: signs of differences of axes solved one by one.
    let v = equidistant([-35.0, 35.0], 4001);
    for axis in [DressingAxis::Tilt, DressingAxis::Radial, DressingAxis::Axial, DressingAxis::Shift] {
        let q: Vec<f64> = v
            .iter()
            .map(|&v| {
                let at = case.motion.position(v);
                DressingMachine::UNLIMITED.axes(&at, DressingRule::Swivel(0.03), None).unwrap()[0]
                    .axes
                    .get(axis)
            })
            .collect();
        let brute: Vec<f64> =
            (1..v.len() - 1).filter(|&k| (q[k] - q[k - 1]) * (q[k + 1] - q[k]) < 0.0).map(|k| v[k]).collect();
        let found: Vec<f64> = driven.reversals.iter().filter(|r| r.axis == axis).map(|r| r.v).collect();
        assert_eq!(found.len(), brute.len(), "{}: {found:?} {brute:?}", axis.name());
        for (a, b) in found.iter().zip(&brute) {
            assert!((a - b).abs() < 0.04, "{}: {a} {b}", axis.name());
        }
    }
    assert!(driven.reversals.iter().any(|r| r.axis == DressingAxis::Tilt));
    // Greatest influence at the reversal times the uncertainty.
    let tilt = driven.reversals.iter().find(|r| r.axis == DressingAxis::Tilt).unwrap();
    let at = case.motion.position(tilt.v);
    let axes = DressingMachine::UNLIMITED.axes(&at, DressingRule::Swivel(0.03), None).unwrap()[0].axes;
    let mut trace: f64 = 0.0;
    for worm in &case.worms {
        for t in equidistant([worm.range().w_nf, worm.range().w_na], 5) {
            let jet = worm.jet(t, tilt.v).unwrap();
            let foot = worm.flank().deviation(&jet.p);
            let nominal = worm.flank().normal(foot.w, foot.z);
            let contact = WormContact { point: jet.p, normal: jet.n, nominal };
            trace = trace.max(contact.influence(&axes.twists())[2].abs() * (1.0 / 3600.0f64).to_radians());
        }
    }
    assert!(
        (trace - tilt.trace).abs() < 1e-9 && (tilt.share - trace / 1e-3).abs() < 1e-6,
        "{trace} {tilt:?}"
    );
}

#[test]
fn a_sloped_swivel_takes_the_reversals_away() {
    let case = case();
    let machine = DressingMachine::UNLIMITED;
    let choose =
        |criterion| case.with(&machine, |task| task.choose(criterion, &SwivelChoice::Free, None)).unwrap();
    let plain = case.with(&machine, |task| task.drive(&swivelled(DressingBranch::Direct, 0.0, 0.0))).unwrap();
    assert!(plain.reversals.len() >= 3, "{:?}", plain.reversals);
    let without = choose(AxisCriterion::NoReversal);
    assert!(without.motion.worst_reversal() < 0.5 * plain.worst_reversal(), "{}", without.reason);
    let least = choose(AxisCriterion::SmallestDeviation);
    assert!(least.motion.deviation <= plain.deviation + 1e-12, "{}", least.reason);
    assert!(least.motion.deviation <= without.motion.deviation + 1e-12);
    assert!(without.motion.worst_reversal() <= least.motion.worst_reversal() + 1e-12);
    // Nothing that was looked at beside them is better.
    for branch in DressingBranch::BOTH {
        for middle in equidistant([-0.12, 0.12], 9) {
            for slope in equidistant([-1e-3, 1e-3], 5) {
                let Ok(other) = case.with(&machine, |task| task.drive(&swivelled(branch, middle, slope)))
                else {
                    continue;
                };
                assert!(least.motion.deviation <= other.deviation * (1.0 + 1e-3), "{middle} {slope}");
            }
        }
    }
    for part in ["deviation", "C5", "ways looked at", "um"] {
        assert!(least.reason.contains(part) && without.reason.contains(part), "{}", least.reason);
    }
    println!("{}\n{}", least.reason, without.reason);
}

#[test]
fn travel_decides_the_side_and_refuses_what_it_must() {
    let case = case();
    let mut machine = DressingMachine::UNLIMITED;
    machine.travel[DressingAxis::Radial as usize] = Some([50.0, 300.0]);
    let choose = |machine: &DressingMachine, swivel: &SwivelChoice, branch| {
        case.with(machine, |task| task.choose(AxisCriterion::SmallestDeviation, swivel, branch))
    };
    let free = SwivelChoice::Free;
    let turned = choose(&machine, &free, None).unwrap();
    assert_eq!(turned.motion.way.branch, DressingBranch::Turned);
    assert!(turned.motion.margins[DressingAxis::Radial as usize] > 0.0 && turned.reason.contains("X1"));
    assert!(turned.ways[1] < turned.ways[0]);
    let error = choose(&machine, &free, Some(DressingBranch::Direct)).unwrap_err();
    assert_eq!(error.code(), "axis-limit");
    assert!(error.to_string().contains("X1") && !error.way_out().is_empty(), "{error}");
    let widest = case.with(&machine, |task| task.choose(AxisCriterion::WidestTravel, &free, None)).unwrap();
    assert!(widest.motion.tightest().1 >= turned.motion.tightest().1 - 1e-9);
    // A given law is kept; a machine without swivel stands still.
    let law = SwivelLaw::Swivel(MotionLaw::polynomial(0.0, vec![0.02]));
    let given = choose(&DressingMachine::UNLIMITED, &SwivelChoice::Given(law.clone()), None).unwrap();
    assert_eq!(given.motion.way.law, law);
    let fixed = choose(&DressingMachine::WITHOUT_SWIVEL, &free, None).unwrap();
    assert_eq!(fixed.motion.travel(DressingAxis::Swivel), [0.0, 0.0]);
    let error = choose(&DressingMachine::WITHOUT_SWIVEL, &SwivelChoice::Given(law), None).unwrap_err();
    assert_eq!(error.code(), "missing-axis");
    let beyond = SwivelLaw::Swivel(MotionLaw::polynomial(0.0, vec![0.5]));
    let error = choose(&DressingMachine::UNLIMITED, &SwivelChoice::Given(beyond), None).unwrap_err();
    assert_eq!(error.code(), "unreachable");
}

#[test]
fn a_tolerance_map_moves_the_weight() {
    let case = case();
    let machine = DressingMachine::UNLIMITED;
    let way = swivelled(DressingBranch::Direct, 0.03, 0.0);
    let even = case.with(&machine, |task| task.drive(&way)).unwrap();
    let wide = |_: Flank, _: f64, _: f64| 4e-3;
    let weighed =
        case.with(&machine, |task| MachineTask { tolerance: Some(&wide), ..*task }.drive(&way)).unwrap();
    assert!((weighed.worst_reversal() - even.worst_reversal() / 4.0).abs() < 1e-12);
    assert_eq!(weighed.deviation, even.deviation);
    let none = |_: Flank, _: f64, _: f64| 0.0;
    let refused =
        case.with(&machine, |task| MachineTask { tolerance: Some(&none), ..*task }.drive(&way)).unwrap_err();
    assert_eq!(refused.code(), "invalid-number");
    let empty =
        case.with(&machine, |task| MachineTask { interval: [3.0, 3.0], ..*task }.drive(&way)).unwrap_err();
    assert_eq!(empty.code(), "invalid-number");
}
