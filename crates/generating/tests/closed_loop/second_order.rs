//! Columns and local envelope against the exact contact.

use super::grinding::{Ground, RATIO, UM, amounts, many_errors, rms_um};
use contact::ThreadFunction;
use foundation::geometry::{Flank, Sides};
use generating::correction::{
    Setting, SettingInfluence, SettingsFlank, SettingsWorm, offset_of_gearing, worm_column,
};

fn largest(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn columns_are_the_first_order_of_grinding_one_setting_at_a_time() {
    for ground in [Ground::helical(), Ground::asymmetric()] {
        let influence = SettingInfluence::new(&ground.lines, RATIO, ground.width).unwrap();
        let motion = ground.motion();
        let flank = SettingsFlank::new(&ground.pair, &influence, &motion);
        let points = ground.points([5, 7]);
        // (amount in um or arc seconds, second order that is allowed, um)
        let cases = [
            (Setting::RadialFeed(0), 10.0, 1e-9),
            (Setting::WorkAngle(0), 15.0, 1e-9),
            (Setting::RadialFeed(1), 10.0, 0.02),
            (Setting::RadialFeed(2), 10.0, 0.1),
            (Setting::WorkAngle(1), 25.0, 0.04),
            (Setting::ProfileSlope(Flank::Left), 5.0, 0.1),
            (Setting::ProfileCrown(Flank::Right), 3.0, 0.2),
            (Setting::Twist(Flank::Left), 8.0, 0.7),
        ];
        for (setting, amount, allowed) in cases {
            let settings = amounts(&[(setting, amount)]);
            let exact = flank.exact(&settings, 0.0, &points).unwrap();
            let columns = influence.columns(&[setting], &points).unwrap();
            let first: Vec<f64> = columns[0].values.iter().map(|e| e * settings[0].1).collect();
            let apart = largest(&exact, &first) / UM;
            assert!(apart < allowed, "{setting:?}: {apart}");
            // Half the amount has a quarter of the error: it is second order and no wrong column.
            let half: Vec<(Setting, f64)> = settings.iter().map(|(s, x)| (*s, 0.5 * x)).collect();
            let exact = flank.exact(&half, 0.0, &points).unwrap();
            let first: Vec<f64> = first.iter().map(|e| 0.5 * e).collect();
            let of_half = largest(&exact, &first) / UM;
            assert!(of_half < 0.3 * apart + 1e-9, "{setting:?}: {of_half} of {apart}");
        }
    }
}

#[test]
fn a_free_form_over_the_feed_is_the_sum_of_its_powers() {
    let ground = Ground::asymmetric();
    let influence = SettingInfluence::new(&ground.lines, RATIO, ground.width).unwrap();
    let points = ground.points([5, 7]);
    let carried = |of: fn(u8) -> Setting| {
        let powers = influence.columns(&[of(0), of(1), of(2)], &points).unwrap();
        let form = influence.free_form("form", of(0), &points, |q| 1.0 - 2.0 * q + 0.5 * q * q).unwrap();
        let sum = |i: usize| powers[0].values[i] - 2.0 * powers[1].values[i] + 0.5 * powers[2].values[i];
        largest(&form.values, &(0..points.len()).map(sum).collect::<Vec<_>>())
    };
    assert!(carried(Setting::RadialFeed) < 1e-14 && carried(Setting::WorkAngle) < 1e-12);
    let of_worm = influence.free_form("form", Setting::ProfileSlope(Flank::Left), &points, |q| q);
    assert_eq!(of_worm.unwrap_err().code(), "setting-without-effect");
}

#[test]
fn the_local_envelope_is_near_the_exact_flank_of_many_errors() {
    for ground in [Ground::helical(), Ground::asymmetric()] {
        let influence = SettingInfluence::new(&ground.lines, RATIO, ground.width).unwrap();
        let motion = ground.motion();
        let flank = SettingsFlank::new(&ground.pair, &influence, &motion);
        let points = ground.points([7, 9]);
        let mut errors = many_errors();
        errors.extend(amounts(&[(Setting::Twist(Flank::Left), 2.0)]));
        let (local, exact) =
            (flank.local(&errors, &points).unwrap(), flank.exact(&errors, 0.0, &points).unwrap());
        let apart: Vec<f64> = local.iter().zip(&exact).map(|(a, b)| a - b).collect();
        assert!(largest(&local, &exact) < 0.13 * UM && rms_um(&apart) < 0.02, "{}", rms_um(&apart));
        assert!(rms_um(&exact) > 3.0);
    }
}

#[test]
fn worm_shift_and_ratio_move_a_topological_pattern() {
    let ground = Ground::helical();
    let plain = SettingInfluence::new(&ground.lines, RATIO, ground.width).unwrap();
    let motion = ground.motion();
    let twist = amounts(&[(Setting::Twist(Flank::Left), 4.0), (Setting::Twist(Flank::Right), 4.0)]);
    let worms = Sides::from_fn(|flank| SettingsWorm::new(&plain, &motion.shift, flank, &twist));
    let functions: Sides<&dyn ThreadFunction> = Sides { left: &worms.left, right: &worms.right };
    let influence = plain.with_worm(functions);
    let flank = SettingsFlank::new(&ground.pair, &influence, &motion).with_worm(functions);
    let points = ground.points([5, 7]);
    let before = flank.exact(&[], 0.0, &points).unwrap();
    for (setting, amount, effect) in [(Setting::WormShift, 0.5, 0.17), (Setting::DiagonalRatio, 0.02, 0.13)] {
        let after = flank.exact(&[(setting, amount)], 0.0, &points).unwrap();
        let columns = influence.columns(&[setting], &points).unwrap();
        let predicted: Vec<f64> =
            columns[0].values.iter().zip(&before).map(|(e, b)| b + amount * e).collect();
        let size = largest(&after, &before) / UM;
        assert!((size - effect).abs() < 0.25 * effect, "{setting:?}: {size}");
        let apart = largest(&after, &predicted) / UM;
        assert!(apart < 0.01, "{setting:?}: {apart}");
    }
    // The same worm as a column of its own: what an amount of twist adds to it.
    let unit = SettingsWorm::new(&plain, &motion.shift, Flank::Left, &[(Setting::Twist(Flank::Left), 1.0)]);
    let of_worm = worm_column("twist", &ground.lines, &motion.shift, &points, |flank, w, z| match flank {
        Flank::Left => unit.jet(w, z).unwrap().f,
        Flank::Right => 0.0,
    });
    let column = plain.columns(&[Setting::Twist(Flank::Left)], &points).unwrap();
    assert!(largest(&of_worm.unwrap().values, &column[0].values) < 1e-11);
}

#[test]
fn crossing_angle_and_centre_distance_change_nothing_but_an_offset() {
    let ground = Ground::helical();
    let influence = SettingInfluence::new(&ground.lines, RATIO, ground.width).unwrap();
    let motion = ground.motion();
    let points = ground.points([5, 7]);
    let flank = SettingsFlank::new(&ground.pair, &influence, &motion);
    for (gamma, d) in [(1e-3, 0.0), (-2e-3, 0.0), (0.0, 0.05)] {
        let offset = offset_of_gearing(&ground.pair, d, gamma).unwrap();
        let ground = flank.exact(&[(Setting::RadialFeed(0), d)], gamma, &points).unwrap();
        for (point, found) in points.iter().zip(&ground) {
            assert!((found - offset[point.flank]).abs() < 1e-9 * UM, "{found} {}", offset[point.flank]);
        }
    }
    let known = offset_of_gearing(&ground.pair, 0.0, 1e-3).unwrap();
    assert!((known.left / UM + 0.15806728).abs() < 1e-8, "{}", known.left / UM);
}
