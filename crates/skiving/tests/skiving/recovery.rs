//! Errors put into a tool and found again by its measurement, without noise and with it.

use super::samples::{CROWNED, RING, STEPPED, Sample};
use foundation::geometry::Sides;
use skiving::evaluation::{Deviations, Evaluation, MeasuredTool, ProfileOptions, evaluate, measured_tool};
use skiving::measuring::{
    BarrierData, EdgeErrors, FlankTracks, Noise, RealTool, Sense, first_order_deviation, readings, switches,
};

const OPTIONS: ProfileOptions = ProfileOptions { degree: 2, band: 0.02, wear_limit: 0.01 };

/// A tool with errors of some micrometres everywhere.
fn worn(teeth: usize) -> RealTool {
    let wave = |k: usize, n: f64| (std::f64::consts::TAU * n * k as f64 / teeth as f64).sin();
    RealTool {
        pitch: (0..teeth).map(|k| 4e-5 * wave(k, 1.0) + 2e-5 * wave(k, 5.0)).collect(),
        edges: Sides::from_fn(|_| {
            let edge = |k| EdgeErrors {
                profile: vec![1e-3 * wave(k, 3.0), 1e-3, -1e-3],
                growth: vec![6e-3 + 1e-3 * wave(k, 2.0), 1e-3],
            };
            (0..teeth).map(edge).collect()
        }),
        broken: vec![false; teeth],
        eccentricity: [6e-3, -4e-3],
        wobble: [8e-5, -5e-5],
    }
}

fn injected(flanks: &Sides<FlankTracks>, tool: &RealTool, like: &Deviations) -> Deviations {
    like.map(|flank, track, tooth, _| {
        first_order_deviation(&flanks[flank].edge, tool, &flanks[flank].tracks[track].0, tooth)
    })
}

fn measure(
    sample: &Sample,
    flanks: &Sides<FlankTracks>,
    tool: &RealTool,
    data: &BarrierData,
    (senses, revolutions, start): (&[Sense], usize, u64),
) -> MeasuredTool {
    let switched = switches(flanks, &sample.beam(), data, tool).unwrap();
    let seen = readings(flanks, &switched, data, senses, revolutions, &mut Noise::new(start));
    measured_tool(flanks, &seen, 0.0).unwrap()
}

fn largest(a: &Deviations, b: &Deviations) -> f64 {
    a.iter().zip(b.iter()).map(|(a, b)| (a.3 - b.3).abs()).fold(0.0, f64::max)
}

#[test]
fn injected_errors_are_found_again() {
    for sample in [RING, STEPPED, CROWNED] {
        let flanks = sample.flanks();
        let tool = worn(sample.teeth[0] as usize);
        let found = measure(&sample, &flanks, &tool, &BarrierData::ideal(), (&[Sense::Positive], 1, 0));
        let wanted = injected(&flanks, &tool, &found.deviations);
        assert!(largest(&found.deviations, &wanted) < 0.15e-3, "{}", largest(&found.deviations, &wanted));
        assert!(wanted.iter().any(|(.., f)| f.abs() > 5e-3));
    }
}

fn shop_floor() -> BarrierData {
    BarrierData {
        speed: 120.0 * std::f64::consts::TAU / 60.0,
        latency: 20e-6,
        jitter: 1e-6,
        beam_noise: 0.2e-3,
        hysteresis: 1e-3,
        encoder_step: 1e-4f64.to_radians(),
    }
}

/// Over many measurements errors scatter as is told, latency and hysteresis drop out, and eccentricity lies within three of its
/// standard deviations.
#[test]
fn noise_scatters_as_it_is_told() {
    for sample in [RING, STEPPED] {
        let flanks = sample.flanks();
        let tool = worn(sample.teeth[0] as usize);
        let data = shop_floor();
        let still = measure(&sample, &flanks, &tool, &BarrierData::ideal(), (&[Sense::Positive], 1, 0));
        let calm: Evaluation = evaluate(&flanks, &still.deviations, &OPTIONS).unwrap();
        let (mut squares, mut count, mut off) = (0.0, 0.0, 0.0f64);
        let mut sigma = 0.0;
        for start in 0..40 {
            let found = measure(&sample, &flanks, &tool, &data, (&Sense::BOTH, 4, start));
            assert_eq!(found.readings_each, 8);
            for ((flank, track, _, f), (.., true_f)) in found.deviations.iter().zip(still.deviations.iter()) {
                let lever = flanks[flank].tracks[track].0.contact.lever;
                sigma = data.single_deviation(lever) / 8f64.sqrt();
                squares += (f - true_f).powi(2) / (sigma * sigma);
                count += 1.0;
            }
            let noisy = evaluate(&flanks, &found.deviations, &OPTIONS).unwrap();
            let e = noisy.mounting.eccentricity[0] - calm.mounting.eccentricity[0];
            off = off.max(e.abs() / (noisy.mounting.deviation_per_noise[0] * sigma));
        }
        let scatter: f64 = (squares / count).sqrt();
        // Some ten thousand numbers tell a standard deviation to a per cent.
        assert!((scatter - 1.0).abs() < 0.03, "{scatter}");
        assert!(off < 3.0, "{off}");
    }
}

#[test]
fn a_damaged_tooth_does_not_bend_the_mounting() {
    let flanks = STEPPED.flanks();
    let mut tool = worn(75);
    tool.edges.left[17].profile = vec![-0.02];
    let found = measure(&STEPPED, &flanks, &tool, &BarrierData::ideal(), (&[Sense::Positive], 1, 0));
    let all = evaluate(&flanks, &found.deviations, &OPTIONS).unwrap();
    assert_eq!(all.mounting.left_out, [17]);
    assert!((all.mounting.eccentricity[0] - 6e-3).abs() < 0.2e-3, "{:?}", all.mounting);
    assert!(all.profile.out_of_band.iter().any(|(_, tooth)| *tooth == 17));
}

/// Teeth differ more than readings scatter: what a fit of the mounting states is how far it lies off for such teeth.
#[test]
fn the_mounting_states_what_teeth_that_differ_do_to_it() {
    for sample in [RING, STEPPED] {
        let flanks = sample.flanks();
        let teeth = sample.teeth[0] as usize;
        let (mut squares, runs) = ([0.0; 4], 80);
        for start in 0..runs {
            let mut noise = Noise::new(start);
            let mut tool = RealTool::ideal(teeth);
            tool.eccentricity = [6e-3, -4e-3];
            tool.wobble = [8e-5, -5e-5];
            for tooth in 0..teeth {
                tool.pitch[tooth] = 2e-5 * noise.normal();
                tool.edges.left[tooth].profile = vec![4e-4 * noise.normal()];
                tool.edges.right[tooth].profile = vec![4e-4 * noise.normal()];
            }
            let found = measure(&sample, &flanks, &tool, &BarrierData::ideal(), (&[Sense::Positive], 1, 0));
            let mounting = evaluate(&flanks, &found.deviations, &OPTIONS).unwrap().mounting;
            let off = [
                mounting.eccentricity[0] - 6e-3,
                mounting.eccentricity[1] + 4e-3,
                mounting.wobble[0] - 8e-5,
                mounting.wobble[1] + 5e-5,
            ];
            for k in 0..4 {
                squares[k] += (off[k] / mounting.deviation[k]).powi(2);
            }
        }
        for square in squares {
            // 80 tools tell a standard deviation to 8 per cent, and every tool states it from its own teeth.
            let ratio: f64 = (square / runs as f64).sqrt();
            assert!((0.75..1.3).contains(&ratio), "{ratio}");
        }
    }
}
