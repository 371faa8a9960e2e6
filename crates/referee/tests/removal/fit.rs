//! The closed forms of the contact relations against coefficients read off a simulation, for cylinder and cone on both
//! sides (`docs/mathematics/generating-contact.md#how-it-is-verified`); and rows that show nothing.

use super::setups::{meshing, pair, reference};
use contact::{FlankPair, Pair};
use foundation::geometry::Flank;
use foundation::kinematics::{GeneratingMotion, MotionLaw};
use referee::{ContactSweep, LinearRelation, WormArea, feeds_to_fit, fit_relations};

const FACE: [f64; 2] = [-60.0, 60.0];

/// Rows over the working depth, away from the base circle.
fn rolls(pair: &Pair, flank: Flank) -> Vec<f64> {
    let work = pair.work.flank(flank);
    let (m, r) = (pair.work.data().normal_module, pair.work.pitch_radius());
    let low = work.length_of_roll((r - 0.5 * m).max(1.03 * work.base_radius)).unwrap();
    let high = work.length_of_roll(r + 0.9 * m).unwrap();
    (0..7).map(|k| low + (high - low) * f64::from(k) / 6.0).collect()
}

/// The worm from beyond the contact at the gear's tip to before the one at its base circle, for all feeds of a fit.
fn area(f: &FlankPair, rolls: &[f64], feeds: &[[f64; 2]]) -> WormArea {
    let tip = 0.4 * rolls[0] * f.hat_w2 / f.hat_w1;
    let needed =
        feeds.iter().flat_map(|&[shift, feed]| rolls.iter().map(move |&w_2| f.worm_roll(w_2, shift, feed)));
    let (low, high) = needed.fold((f64::INFINITY, 0.0), |(low, high), w: f64| (low.min(w), w.max(high)));
    WormArea { w: [(low - tip).max(0.1), high + tip], z: [-200.0, 200.0] }
}

fn sweep<'a>(
    pair: &'a Pair,
    flank: Flank,
    motion: &'a GeneratingMotion,
    rolls: &'a [f64],
    feeds: &[[f64; 2]],
) -> ContactSweep<'a> {
    ContactSweep {
        worm: pair.worm.flank(flank),
        area: area(&pair.flanks[flank], rolls, feeds),
        work: pair.work.flank(flank),
        motion,
        rolls,
        face: FACE,
    }
}

#[test]
fn fitted_coefficients_are_those_of_the_closed_forms() {
    let file = reference("20-generating-contact.json");
    let mut seen = [[0; 2]; 2];
    let mut worst = [0.0_f64; 9];
    for case in file["cases"].as_array().unwrap() {
        let pair = pair(&case["input"]);
        seen[usize::from(pair.chain.worm_cone != 0.0)][usize::from(pair.chain.work_cone != 0.0)] += 1;
        let motion = pair.motion(MotionLaw::zero());
        for flank in Flank::BOTH {
            let f = &pair.flanks[flank];
            let rolls = rolls(&pair, flank);
            let feeds = feeds_to_fit(&motion, [1.0, -2.0], 10.0);
            let found = fit_relations(&sweep(&pair, flank, &motion, &rolls, &feeds), &feeds).unwrap();
            assert_eq!(found.contacts.len(), 7 * feeds.len());
            let exact = [
                LinearRelation {
                    roll: f.c_w2,
                    shift: f.c_zv12,
                    feed: f.c_zv22,
                    constant: f.c_c2,
                    residual: 0.0,
                },
                LinearRelation {
                    roll: f.c_w1,
                    shift: f.c_zv11,
                    feed: f.c_zv21,
                    constant: f.c_c1,
                    residual: 0.0,
                },
                LinearRelation {
                    roll: -f.hat_w2 / f.hat_w1,
                    shift: -f.hat_zv1 / f.hat_w1,
                    feed: -f.hat_zv2 / f.hat_w1,
                    constant: -f.hat_c / f.hat_w1,
                    residual: 0.0,
                },
            ];
            let (z_2, z_1, w_1) = (&found.work_z, &found.worm_z, &found.worm_roll);
            let feeds_off = |a: &LinearRelation, b: &LinearRelation| {
                (a.shift - b.shift).abs().max((a.feed - b.feed).abs())
            };
            let mut predicted: f64 = 0.0;
            let mut rest: f64 = 0.0;
            for c in &found.contacts {
                predicted = predicted
                    .max((z_1.value(c.w_1, c.shift, c.feed) - exact[1].value(c.w_1, c.shift, c.feed)).abs());
                rest = rest.max(c.rest.abs());
            }
            let off = [
                (z_2.roll - exact[0].roll).abs(),
                (z_2.constant - exact[0].constant).abs(),
                feeds_off(z_2, &exact[0]),
                (z_1.roll - exact[1].roll).abs(),
                feeds_off(z_1, &exact[1]),
                predicted,
                (w_1.roll - exact[2].roll).abs(),
                feeds_off(w_1, &exact[2]),
                rest,
            ];
            for (worst, off) in worst.iter_mut().zip(off) {
                *worst = worst.max(off);
            }
        }
    }
    // `docs/mathematics/generating-contact.md#how-it-is-verified` allows 2e-6, 3e-5 mm, 1e-7 (body 2), 6e-4, 4e-5 (body 1), 7e-5 (Chat_w2);
    // its rays end on steps of the rotation. These rays end on minima, and what is left is the quartic's: some ten times the values seen
    // here.
    let allowed = [1e-7, 3e-6, 1e-8, 1e-5, 1e-6, 3e-5, 3e-7, 1e-7, 1e-8];
    for (k, (worst, allowed)) in worst.iter().zip(allowed).enumerate() {
        assert!(worst <= &allowed, "{k}: {worst:e}, allowed {allowed:e}");
    }
    assert!(seen.iter().flatten().all(|&count| count > 0), "{seen:?}");
}

#[test]
fn what_shows_no_contact_is_told() {
    let pair = meshing(25, 2.0, 20.0, 20.0, 2, 120.0);
    let motion = pair.motion(MotionLaw::zero());
    let flank = Flank::Right;
    let rolls = rolls(&pair, flank);
    let at = [[0.0, 0.0]];
    let good = sweep(&pair, flank, &motion, &rolls, &at);
    assert!(fit_relations(&good, &at).unwrap().work_z.residual < 1e-5);
    let code = |sweep: ContactSweep<'_>, feeds: &[[f64; 2]]| {
        let error = fit_relations(&sweep, feeds).unwrap_err();
        assert!(!error.way_out().is_empty() && !error.to_string().is_empty());
        error.code()
    };
    let elsewhere = WormArea { z: [150.0, 200.0], ..good.area };
    assert_eq!(code(ContactSweep { area: elsewhere, ..good }, &at), "contact-not-seen");
    assert_eq!(code(ContactSweep { face: [40.0, 60.0], ..good }, &at), "contact-not-seen");
    assert_eq!(code(ContactSweep { rolls: &rolls[..1], ..good }, &at), "too-few-contacts");
    assert_eq!(code(good, &[]), "too-few-contacts");
    assert_eq!(code(ContactSweep { rolls: &[-1.0, 3.0], ..good }, &at), "invalid-number");
    assert_eq!(code(ContactSweep { face: [1.0, -1.0], ..good }, &at), "invalid-number");
    assert_eq!(code(ContactSweep { face: [-1e9, 1e9], ..good }, &at), "invalid-number");
    assert_eq!(code(good, &[[f64::NAN, 0.0]]), "invalid-number");
    // A conical worm with one pair of feeds leaves what its shift does open.
    let file = reference("20-generating-contact.json");
    let cases = file["cases"].as_array().unwrap();
    let conical = super::setups::pair(
        &cases.iter().find(|c| c["name"].as_str().unwrap().starts_with("con_cyl")).unwrap()["input"],
    );
    let motion = conical.motion(MotionLaw::zero());
    let rolls = self::rolls(&conical, flank);
    assert_eq!(code(sweep(&conical, flank, &motion, &rolls, &at), &at), "too-few-contacts");
}
