//! Broken teeth found first, readings that are missing, tools clamped at any angle, and how sure a mounting is.

use super::samples::{RING, STEPPED, Sample};
use foundation::geometry::{Flank, Sides};
use skiving::evaluation::{
    Deviations, Evaluation, MissingSwitch, ProfileOptions, correction, evaluate, evaluate_measured,
    measured_tool, measured_tool_near,
};
use skiving::measuring::{
    BarrierData, EdgeErrors, FlankTracks, Noise, Reading, RealTool, Sense, first_order_deviation, readings,
    switches,
};
use skiving::{Setting, SettingLimits};
use std::f64::consts::TAU;

/// The crossed-axes angle hardly acts on a ring.
pub(super) const SETTINGS: [Setting; 2] = [Setting::CentreDistance, Setting::ToolAngle];
pub(super) const OPTIONS: ProfileOptions = ProfileOptions { degree: 2, band: 10e-3, wear_limit: 10e-3 };

/// A tool with small errors of its own, mounted off its axis.
pub(super) fn tool(teeth: usize, noise: &mut Noise) -> RealTool {
    let mut tool = RealTool::ideal(teeth);
    tool.eccentricity = [12e-3, -7e-3];
    tool.wobble = [5e-5, -3e-5];
    for tooth in 0..teeth {
        tool.pitch[tooth] = 3e-6 * noise.normal();
        for flank in Flank::BOTH {
            tool.edges[flank][tooth] = EdgeErrors {
                profile: (0..3).map(|k| if k == 0 { 1e-3 } else { 0.0 } + 1e-4 * noise.normal()).collect(),
                growth: Vec::new(),
            };
        }
    }
    tool
}

fn read(sample: &Sample, flanks: &Sides<FlankTracks>, tool: &RealTool, data: &BarrierData) -> Vec<Reading> {
    let switched = switches(flanks, &sample.beam(), data, tool).unwrap();
    readings(flanks, &switched, data, &[Sense::Positive], 1, &mut Noise::new(7))
}

fn found(sample: &Sample, flanks: &Sides<FlankTracks>, tool: &RealTool) -> Evaluation {
    let seen = read(sample, flanks, tool, &BarrierData::ideal());
    evaluate_measured(flanks, &measured_tool(flanks, &seen, 0.0).unwrap(), &OPTIONS).unwrap()
}

/// A third of the teeth, side by side or anywhere.
fn third(teeth: usize, side_by_side: bool, noise: &mut Noise) -> Vec<usize> {
    let first = (noise.uniform() * teeth as f64) as usize;
    let mut list: Vec<usize> = (0..teeth).map(|k| (first + k) % teeth).collect();
    if !side_by_side {
        for k in (1..teeth).rev() {
            list.swap(k, (noise.uniform() * (k + 1) as f64) as usize);
        }
    }
    list.truncate(teeth / 3);
    list.sort_unstable();
    list
}

/// What a fit makes of every tooth and track, and the change of the setting, mm.
pub(super) fn close(flanks: &Sides<FlankTracks>, whole: &Evaluation, other: &Evaluation, name: &str) {
    let teeth = whole.clocked.teeth();
    for k in 0..2 {
        let off = other.mounting.eccentricity[k] - whole.mounting.eccentricity[k];
        assert!(off.abs() < 0.3e-3, "{name}: eccentricity {off}");
    }
    for (flank, of) in flanks.iter() {
        for (number, (track, _)) in of.tracks.iter().enumerate() {
            for tooth in 0..teeth {
                let rigid = |found: &Evaluation| found.mounting.rigid_part(track, tooth, teeth);
                let off = rigid(other) - rigid(whole);
                assert!(off.abs() < 0.3e-3, "{name}: mounting {off}");
            }
            let off = other.profile.track_means[flank][number] - whole.profile.track_means[flank][number];
            assert!(off.abs() < 0.3e-3, "{name}: track mean {off}");
        }
    }
    let change = |found: &Evaluation| {
        correction(flanks, found, (&SETTINGS, &SettingLimits::default())).unwrap().change
    };
    let (a, b) = (change(whole), change(other));
    assert!((a[0] - b[0]).abs() < 0.3e-3, "{name}: centre distance {} {}", a[0], b[0]);
    let radius = flanks.left.edge.pair().tool().pitch_radius();
    assert!((a[3] - b[3]).abs() * radius < 0.3e-3, "{name}: tool angle {} {}", a[3], b[3]);
}

/// The acceptance: mounting and correction of a tool of which a third is chipped by 25 to 400 um are those of the whole one.
#[test]
fn a_third_of_the_teeth_broken_bends_nothing() {
    for sample in [RING, STEPPED] {
        let flanks = sample.flanks();
        let teeth = sample.teeth[0] as usize;
        for seed in 0..8 {
            let mut noise = Noise::new(100 + seed);
            let good = tool(teeth, &mut noise);
            let broken = third(teeth, seed % 2 == 0, &mut noise);
            let mut chipped = good.clone();
            for &tooth in &broken {
                for flank in Flank::BOTH {
                    let both = [Flank::Left, Flank::Right][seed as usize % 2];
                    if seed % 3 == 0 || flank == both {
                        let chip = 25e-3 + 375e-3 * noise.uniform();
                        chipped.edges[flank][tooth].profile[0] -= chip;
                    }
                }
            }
            let name = format!("{teeth} teeth, seed {seed}");
            let whole = found(&sample, &flanks, &good);
            assert!(whole.mounting.left_out.is_empty(), "{name}: {:?}", whole.mounting.left_out);
            let other = found(&sample, &flanks, &chipped);
            assert_eq!(other.mounting.left_out, broken, "{name}");
            assert_eq!(other.count(), teeth - broken.len());
            close(&flanks, &whole, &other, &name);
        }
    }
}

/// One tooth chipped by as much as left ten to fourteen good ones out before, or as much as hid itself.
#[test]
fn one_broken_tooth_is_the_only_one_left_out() {
    let flanks = STEPPED.flanks();
    let good = tool(75, &mut Noise::new(3));
    let whole = found(&STEPPED, &flanks, &good);
    for chip in [25e-3, 30e-3, 35e-3, 60e-3, 100e-3, 200e-3, 400e-3] {
        let mut chipped = good.clone();
        chipped.edges.left[3].profile[0] -= chip;
        let other = found(&STEPPED, &flanks, &chipped);
        assert_eq!(other.mounting.left_out, [3], "{chip}");
        close(&flanks, &whole, &other, &format!("chip {chip}"));
    }
}

/// Chance alone makes no tooth stand out, over a hundred tools; noise of the barrier beside.
#[test]
fn whole_tools_are_whole() {
    for sample in [RING, STEPPED] {
        let flanks = sample.flanks();
        let teeth = sample.teeth[0] as usize;
        let mut alarms = 0;
        for seed in 0..100 {
            let mut noise = Noise::new(1000 + seed);
            let tool = tool(teeth, &mut noise);
            let zero = flanks.map(|_, of| vec![vec![0.0; teeth]; of.tracks.len()]);
            let scatter = [0.1e-3, 2.4e-3][seed as usize % 2];
            let numbers = Deviations { of: zero }.map(|flank, track, tooth, _| {
                first_order_deviation(&flanks[flank].edge, &tool, &flanks[flank].tracks[track].0, tooth)
            });
            let draws: Vec<f64> = numbers.iter().map(|_| scatter * noise.normal()).collect();
            let place = |flank: Flank, track: usize, tooth: usize| {
                let tracks = flanks.left.tracks.len();
                (usize::from(flank == Flank::Right) * tracks + track) * teeth + tooth
            };
            let noisy = numbers.map(|flank, track, tooth, f| f + draws[place(flank, track, tooth)]);
            alarms += usize::from(!evaluate(&flanks, &noisy, &OPTIONS).unwrap().mounting.left_out.is_empty());
        }
        assert!(alarms <= 1, "{alarms}");
    }
}

/// A reading that is gone costs the tooth that it belongs to, and nothing of the others.
#[test]
fn what_is_missing_is_named_and_the_others_are_evaluated() {
    let flanks = RING.flanks();
    let good = tool(41, &mut Noise::new(5));
    let seen = read(&RING, &flanks, &good, &BarrierData::ideal());
    let all = measured_tool(&flanks, &seen, 0.0).unwrap();
    assert!(all.missing.is_empty());
    let whole = evaluate_measured(&flanks, &all, &OPTIONS).unwrap();
    // Tooth 9 on track 2 of the left flank, tooth 11 on the first of the right one.
    let gone = [2 * 41 + 9, 5 * 41 + 11];
    let rest: Vec<Reading> =
        seen.iter().enumerate().filter(|(k, _)| !gone.contains(k)).map(|(_, reading)| *reading).collect();
    let lacking = measured_tool(&flanks, &rest, 0.0).unwrap();
    let missing = |flank, track, tooth| MissingSwitch { flank, track, tooth };
    assert_eq!(lacking.missing, [missing(Flank::Left, 2, 9), missing(Flank::Right, 0, 11)]);
    assert_eq!(lacking.incomplete(), [9, 11]);
    for ((flank, track, tooth, a), (.., b)) in all.deviations.iter().zip(lacking.deviations.iter()) {
        if !lacking.missing.contains(&missing(flank, track, tooth)) {
            assert!((a - b).abs() < 1e-12, "{flank} {track} {tooth}");
        }
    }
    let found = evaluate_measured(&flanks, &lacking, &OPTIONS).unwrap();
    assert_eq!((found.count(), found.counting[9], found.counting[11]), (39, false, false));
    close(&flanks, &whole, &found, "two readings gone");
}

/// The light of all tracks tells how a tool is clamped up to whole pitches; a key tells the rest.
#[test]
fn a_tool_is_clamped_at_any_angle() {
    let flanks = STEPPED.flanks();
    let good = tool(75, &mut Noise::new(6));
    let seen = read(&STEPPED, &flanks, &good, &BarrierData::ideal());
    let straight = measured_tool(&flanks, &seen, 0.0).unwrap();
    let whole = evaluate_measured(&flanks, &straight, &OPTIONS).unwrap();
    let pitch = TAU / 75.0;
    for turn in [0.1, 0.3, 0.45, -0.4, 3.2, -20.75] {
        let turned: Vec<Reading> =
            seen.iter().map(|r| Reading { angle: r.angle + turn * pitch, ..*r }).collect();
        // By its key the teeth keep their numbers, without it tooth 0 is the nearest.
        for (key, passed) in [(-turn * pitch, 0i32), (0.0, f64::round(turn) as i32)] {
            let measured = measured_tool_near(&flanks, &turned, 0.0, key).unwrap();
            let found = evaluate_measured(&flanks, &measured, &OPTIONS).unwrap();
            let part = turn - f64::from(passed);
            assert!((found.clocking + part * pitch - whole.clocking).abs() < 1e-12, "{turn} {key}");
            for (flank, track, tooth, f) in found.clocked.iter() {
                // A tool that is turned by whole pitches shows its tooth k + passed where tooth k belongs.
                let same = (tooth as i32 + passed).rem_euclid(75) as usize;
                assert!((f - whole.clocked.of[flank][track][same]).abs() < 1e-9, "{turn} {key} {tooth}");
            }
            // The mounting is told as tooth 0 stands.
            let [a, b] = [&found, &whole].map(|x| x.mounting.eccentricity);
            let (sin, cos) = (-f64::from(passed) * pitch).sin_cos();
            let back = [cos * b[0] - sin * b[1], sin * b[0] + cos * b[1]];
            assert!((a[0] - back[0]).hypot(a[1] - back[1]) < 1e-7, "{turn} {key} {a:?} {back:?}");
        }
    }
}

/// What is stated of a mounting covers what is found, also where nothing scatters: a linear evaluation misses what no scatter shows.
#[test]
fn a_mounting_is_within_what_is_stated_of_it() {
    let injected = [
        ([12e-3, -7e-3], [0.0, 0.0], 0.0),
        ([3e-3, 5e-3], [0.0, 0.0], 1e-3),
        ([6e-3, -4e-3], [8e-5, -5e-5], 1e-3),
        ([0.0, 20e-3], [0.0, 0.0], -5e-3),
        ([25e-3, 0.0], [1.5e-4, 0.0], 10e-3),
    ];
    for sample in [RING, STEPPED] {
        let flanks = sample.flanks();
        for (eccentricity, wobble, thick) in injected {
            let mut tool = RealTool::ideal(sample.teeth[0] as usize);
            (tool.eccentricity, tool.wobble) = (eccentricity, wobble);
            for flank in Flank::BOTH {
                tool.edges[flank].iter_mut().for_each(|edge| edge.profile = vec![thick]);
            }
            let mounting = found(&sample, &flanks, &tool).mounting;
            let off = [
                mounting.eccentricity[0] - eccentricity[0],
                mounting.eccentricity[1] - eccentricity[1],
                mounting.wobble[0] - wobble[0],
                mounting.wobble[1] - wobble[1],
            ];
            for k in 0..4 {
                assert!(
                    off[k].abs() < 3.0 * mounting.deviation[k],
                    "{} {eccentricity:?} {k}: {} {}",
                    sample.teeth[0],
                    off[k],
                    mounting.deviation[k]
                );
            }
        }
    }
}
