//! Corrections: hidden errors removed within bounds, what stays, what is not determined, refusals.

use super::grinding::{Ground, RATIO, UM, amounts, many_errors, rms_um};
use foundation::geometry::Flank;
use foundation::numerics::equidistant;
use generating::correction::{
    ClosedLoop, Column, CorrectionError, CorrectionTask, FlankPoint, LoopEnd, Setting, SettingInfluence,
    SettingsFlank, Stage, Weighting, gain_is_stable,
};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

const OPEN: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// Settings without twist.
fn ten() -> Vec<Setting> {
    Setting::USUAL[..10].to_vec()
}

/// Rounds of measuring (exact contact) and correcting; rms before each round and at the end, um, with the corrections.
fn rounds(
    ground: &Ground,
    hidden: &[(Setting, f64)],
    used: &[Setting],
    mut closed: ClosedLoop,
    count: usize,
) -> (Vec<f64>, Vec<f64>) {
    let influence = SettingInfluence::new(&ground.lines, RATIO, ground.width).unwrap();
    let motion = ground.motion();
    let flank = SettingsFlank::new(&ground.pair, &influence, &motion);
    let points = ground.points([7, 9]);
    let columns = influence.columns(used, &points).unwrap();
    let (mut seen, mut unremovable) = (Vec::new(), Vec::new());
    for round in 0..=count {
        let settings: Vec<(Setting, f64)> =
            used.iter().copied().zip(closed.applied().to_vec()).chain(hidden.to_vec()).collect();
        let measured = flank.exact(&settings, 0.0, &points).unwrap();
        seen.push(rms_um(&measured));
        if round < count {
            let correction = closed.task(measured, columns.clone()).solve().unwrap();
            unremovable.push(correction.rms_unremovable / UM);
            closed.apply(&correction).unwrap();
        }
    }
    (seen, unremovable)
}

fn close(found: f64, wanted: f64, tolerance: f64) {
    assert!((found - wanted).abs() < tolerance, "{found} {wanted}");
}

#[test]
fn bounds_hold_the_sum_of_all_rounds_and_tell_what_they_cost() {
    let ground = Ground::helical();
    let mut bounds = vec![OPEN; 10];
    bounds[2] = [-UM, UM];
    bounds[6] = [-1.5 * UM, 1.5 * UM];
    let (rms, unremovable) = rounds(&ground, &many_errors(), &ten(), ClosedLoop::new(bounds, true), 2);
    // `docs/mathematics/inspection.md#how-it-is-verified`.
    close(rms[0], 4.435627, 1e-5);
    close(rms[1], 0.807695, 1e-5);
    close(rms[2], 0.805556, 1e-5);
    close(unremovable[0], 0.003708, 1e-5);
    let (free, _) = rounds(&ground, &many_errors(), &ten(), ClosedLoop::new(vec![OPEN; 10], true), 2);
    assert!(free[2] < 1e-3, "{free:?}");
}

#[test]
fn twist_needs_the_worm() {
    let ground = Ground::helical();
    let hidden = amounts(&[(Setting::Twist(Flank::Left), 3.0), (Setting::Twist(Flank::Right), -3.0)]);
    let kinematics: Vec<Setting> = Setting::USUAL[..6].to_vec();
    let (rms, left) = rounds(&ground, &hidden, &kinematics, ClosedLoop::new(vec![OPEN; 6], true), 1);
    close(rms[0], 1.931730, 1e-5);
    close(rms[1], 1.528833, 1e-5);
    close(left[0], 1.520948, 1e-5);
    let (rms, _) = rounds(&ground, &hidden, &Setting::USUAL, ClosedLoop::new(vec![OPEN; 12], true), 2);
    close(rms[1], 0.023075, 1e-5);
    assert!(rms[2] < 1e-4, "{rms:?}");
}

#[test]
fn a_wrong_model_gain_is_healed_by_rounds_or_by_caution() {
    // True effects are 1/0.8 of the model's.
    let ground = Ground::helical();
    let influence = SettingInfluence::new(&ground.lines, RATIO, ground.width).unwrap();
    let columns = influence.columns(&ten(), &ground.points([7, 9])).unwrap();
    let hidden: Vec<f64> = many_errors().iter().map(|(_, x)| *x).collect();
    let flank = |applied: &[f64]| -> Vec<f64> {
        let amount = |j: usize| (hidden[j] + applied[j]) / 0.8;
        (0..columns[0].values.len())
            .map(|i| (0..10).map(|j| columns[j].values[i] * amount(j)).sum())
            .collect()
    };
    for (verified, shares) in [(true, [0.25, 0.0625, 0.015625]), (false, [0.0, 0.0, 0.0])] {
        let mut closed = ClosedLoop::new(vec![OPEN; 10], verified);
        let first = rms_um(&flank(closed.applied()));
        for share in shares {
            let correction = closed.task(flank(closed.applied()), columns.clone()).solve().unwrap();
            closed.apply(&correction).unwrap();
            close(rms_um(&flank(closed.applied())) / first, share, 1e-9);
        }
        assert_eq!(closed.rounds, 3);
    }
    assert!(gain_is_stable(1.0, 0.8) && gain_is_stable(0.8, 0.8));
    assert!(!gain_is_stable(1.0, 0.5) && !gain_is_stable(1.0, -1.0) && !gain_is_stable(0.0, 1.0));
}

#[test]
fn settings_lost_in_the_noise_are_dropped_and_the_loop_ends() {
    let ground = Ground::helical();
    let influence = SettingInfluence::new(&ground.lines, RATIO, ground.width).unwrap();
    let points = ground.points([7, 9]);
    let columns = influence.columns(&Setting::USUAL, &points).unwrap();
    let mut random = ChaCha8Rng::seed_from_u64(7);
    let mut measured = |hidden: &[(usize, f64)]| -> Vec<f64> {
        (0..points.len())
            .map(|i| {
                let x: f64 = StandardNormal.sample(&mut random);
                0.1 * UM * x + hidden.iter().map(|&(j, e)| columns[j].values[i] * e).sum::<f64>()
            })
            .collect()
    };
    let task = |deviations: Vec<f64>| {
        let mut task = CorrectionTask::new(deviations, columns.clone());
        task.weighting = Weighting::Uncertainties(vec![0.1 * UM; points.len()]);
        task.resolutions = Some(vec![0.0; 12]);
        task
    };
    let found = task(measured(&[(1, 6.0 * UM), (6, 3.0 * UM)])).solve().unwrap();
    close(found.value("d1").unwrap() / UM, -6.0, 0.2);
    close(found.value("profile_slope_left").unwrap() / UM, -3.0, 0.1);
    assert!(found.value("unknown").is_none());
    let kept = found.settings.iter().filter(|s| !s.dropped).count();
    assert!((2..=4).contains(&kept), "{:?}", found.settings);
    assert!(found.settings.iter().filter(|s| s.dropped).all(|s| s.value == 0.0));
    assert!(found.rms_after < 0.11 * UM && ClosedLoop::end(&found).is_none());
    let found = task(measured(&[])).solve().unwrap();
    assert_eq!(ClosedLoop::end(&found), Some(LoopEnd::NothingRemovable));
    // A resolution coarser than the correction leaves nothing to turn but the last setting, which is told as it is.
    let mut coarse = task(measured(&[(1, 6.0 * UM)]));
    coarse.columns.truncate(2);
    coarse.bounds = vec![OPEN, [0.0, 0.0]];
    coarse.applied = vec![0.0; 2];
    coarse.resolutions = Some(vec![1.0; 2]);
    let found = coarse.solve().unwrap();
    assert_eq!(ClosedLoop::end(&found), Some(LoopEnd::NothingToTurn));
    assert!(found.settings[0].dropped && found.settings[1].at_bound);
}

#[test]
fn standard_deviations_are_those_of_repeated_noise() {
    let ground = Ground::asymmetric();
    let influence = SettingInfluence::new(&ground.lines, RATIO, ground.width).unwrap();
    let points = ground.points([7, 9]);
    let columns = influence.columns(&Setting::USUAL, &points).unwrap();
    let mut random = ChaCha8Rng::seed_from_u64(11);
    let (draws, mut squares, mut stated) = (600, [0.0; 12], [0.0; 12]);
    for _ in 0..draws {
        let noise = (0..points.len()).map(|_| {
            let x: f64 = StandardNormal.sample(&mut random);
            0.1 * UM * x
        });
        let mut task = CorrectionTask::new(noise.collect(), columns.clone());
        task.weighting = Weighting::Uncertainties(vec![0.1 * UM; points.len()]);
        let found = task.solve().unwrap();
        for (j, setting) in found.settings.iter().enumerate() {
            squares[j] += setting.value.powi(2) / f64::from(draws);
            stated[j] = setting.deviation.unwrap();
        }
    }
    for j in 0..12 {
        let ratio = squares[j].sqrt() / stated[j];
        assert!((0.9..1.1).contains(&ratio), "{j}: {ratio}");
    }
}

#[test]
fn one_flank_does_not_tell_radial_feed_from_work_angle() {
    let ground = Ground::helical();
    let influence = SettingInfluence::new(&ground.lines, RATIO, ground.width).unwrap();
    let points: Vec<FlankPoint> =
        ground.points([7, 9]).into_iter().filter(|p| p.flank == Flank::Left).collect();
    let settings = &Setting::USUAL[..6];
    let columns = influence.columns(settings, &points).unwrap();
    let deviations = columns[1].values.iter().map(|e| 5.0 * UM * e).collect();
    let mut task = CorrectionTask::new(deviations, columns);
    let error = task.solve().unwrap_err();
    assert_eq!(error.code(), "underdetermined");
    let CorrectionError::Underdetermined { unseen } = &error else { panic!("{error}") };
    assert_eq!(unseen.len(), 3);
    let mut names: Vec<&String> = unseen.iter().flatten().collect();
    names.sort();
    names.dedup();
    assert_eq!(names, ["d0", "d1", "d2", "phi0", "phi1", "phi2"]);
    // The shortest correction is allowed on demand: it removes the error, shared between both ways of doing so.
    task.allow_underdetermined = true;
    task.weighting = Weighting::Uncertainties(vec![0.1 * UM; points.len()]);
    let found = task.solve().unwrap();
    assert_eq!((found.rank, found.unknowns), (3, 6));
    assert!(found.rms_after < 1e-9 * UM && found.value("d1").unwrap() > -3.0 * UM);
    assert!(found.settings.iter().all(|s| s.deviation.unwrap().is_infinite()));
    close(found.found_deviations()[1], -found.value("d1").unwrap(), 1e-18);
    // A profile setting of the other flank changes nothing here.
    let other = influence.columns(&[Setting::ProfileSlope(Flank::Right)], &points).unwrap_err();
    assert_eq!(other.code(), "setting-without-effect");
}

#[test]
fn traces_with_zeros_of_their_own_leave_size_and_index_open() {
    let ground = Ground::helical();
    let influence = SettingInfluence::new(&ground.lines, RATIO, ground.width).unwrap();
    let (mut points, mut traces) = (Vec::new(), Vec::new());
    for flank in Flank::BOTH {
        let field = &ground.fields[flank];
        let at = |[a, b]: [f64; 2], share: f64| a + share * (b - a);
        for share in [0.1, 0.9] {
            let trace = traces.last().map_or(0, |t| t + 1);
            let z = at(field.face(), share);
            points.extend(equidistant(field.roll(), 41).into_iter().map(|w| FlankPoint { flank, w, z }));
            traces.extend([trace; 41]);
        }
        let trace = traces.last().map_or(0, |t| t + 1);
        let w = field.roll_middle();
        points.extend(equidistant(field.face(), 41).into_iter().map(|z| FlankPoint { flank, w, z }));
        traces.extend([trace; 41]);
    }
    let open: Vec<Setting> = Setting::USUAL.into_iter().filter(|s| !s.needs_absolute_zeros()).collect();
    assert_eq!(open.len(), 10);
    let columns = influence.columns(&open, &points).unwrap();
    let zero = |trace: usize| 20.0 * UM * (trace as f64).sin();
    let deviations: Vec<f64> = (0..points.len())
        .map(|i| zero(traces[i]) + 6.0 * UM * columns[0].values[i] + 3.0 * UM * columns[8].values[i])
        .collect();
    let mut task = CorrectionTask::new(deviations.clone(), columns);
    task.traces = Some(traces.clone());
    let found = task.solve().unwrap();
    assert_eq!((found.rank, found.unknowns, found.zeros.len()), (16, 16, 6));
    close(found.value("d1").unwrap(), -6.0 * UM, 1e-12);
    close(found.value("twist_left").unwrap(), -3.0 * UM, 1e-12);
    (0..6).for_each(|k| close(found.zeros[k], -zero(k), 1e-12));
    assert!(found.rms_after < 1e-12 && found.rms_before < 10.0 * UM);
    let all = influence.columns(&Setting::USUAL, &points).unwrap();
    let mut task = CorrectionTask::new(deviations, all);
    task.traces = Some(traces);
    let CorrectionError::Underdetermined { unseen } = task.solve().unwrap_err() else { panic!() };
    let mut names: Vec<String> = unseen.into_iter().flatten().collect();
    names.sort();
    names.dedup();
    assert_eq!(names, ["d0", "phi0"]);
}

#[test]
fn tasks_without_a_meaning_are_refused() {
    let column = |values: Vec<f64>| Column { name: "x".into(), setting: None, values };
    let good = CorrectionTask::new(vec![1.0, 2.0, 4.0], vec![column(vec![1.0, 0.5, 2.0])]);
    assert!(good.solve().is_ok());
    let code = |change: &dyn Fn(&mut CorrectionTask)| {
        let mut task = good.clone();
        change(&mut task);
        let error = task.solve().unwrap_err();
        assert!(!error.way_out().is_empty() && !error.to_string().is_empty());
        error.code()
    };
    assert_eq!(code(&|t| t.deviations.clear()), "too-few-points");
    assert_eq!(code(&|t| t.columns[0].values = vec![0.0; 3]), "setting-without-effect");
    assert_eq!(code(&|t| t.bounds[0] = [1.0, -1.0]), "invalid-bounds");
    assert_eq!(code(&|t| t.bounds[0] = [f64::NAN, 1.0]), "invalid-bounds");
    assert_eq!(code(&|t| t.bounds.clear()), "other-shape");
    assert_eq!(code(&|t| t.columns.clear()), "other-shape");
    assert_eq!(code(&|t| t.columns[0].values.truncate(2)), "other-shape");
    assert_eq!(code(&|t| t.deviations[1] = f64::NAN), "invalid-number");
    assert_eq!(code(&|t| t.columns[0].values[1] = f64::INFINITY), "invalid-number");
    assert_eq!(code(&|t| t.weighting = Weighting::Tolerances(vec![1.0, 0.0, 1.0])), "invalid-number");
    assert_eq!(code(&|t| t.traces = Some(vec![0, 0])), "other-shape");
    assert_eq!(code(&|t| t.traces = Some(vec![0, 2, 2])), "other-shape");
    assert_eq!(code(&|t| t.traces = Some(vec![0, usize::MAX - 1, 0])), "other-shape");
    let ground = Ground::helical();
    assert_eq!(SettingInfluence::new(&ground.lines, RATIO, 0.0).err().unwrap().code(), "invalid-number");
    // A worm without diagonal motion has no twist, an unmodified one nothing to move.
    let radial = SettingInfluence::new(&ground.lines, 0.0, ground.width).unwrap();
    let points = ground.points([3, 3]);
    assert!(radial.columns(&[Setting::Twist(Flank::Left)], &points).is_err());
    let error = radial.columns(&[Setting::WormShift], &points).unwrap_err();
    assert_eq!(error.code(), "setting-without-effect");
    let mut closed = ClosedLoop::new(vec![OPEN; 2], true);
    assert_eq!(closed.apply(&good.solve().unwrap()).unwrap_err().code(), "other-shape");
}

#[test]
fn size_comes_before_lead_before_profile_before_topology() {
    let mut stages: Vec<Stage> = Setting::USUAL.iter().map(|s| s.stage()).collect();
    stages.sort();
    stages.dedup();
    let order = [Stage::Size, Stage::Lead, Stage::Profile, Stage::Topology, Stage::NaturalTwist];
    assert_eq!(stages, order);
    assert_eq!(Setting::RadialFeed(2).stage(), Stage::NaturalTwist);
}
