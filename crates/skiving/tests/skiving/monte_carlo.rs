//! Repeated measurements: what scatters as told, the same on any number of threads, and results that lie within their own uncertainty.

use super::samples::STEPPED;
use foundation::geometry::{Flank, Sides};
use foundation::numerics::Silent;
use skiving::evaluation::{ProfileOptions, Quantity, Repeated, Scatter, evaluate, measured_tool, repeat};
use skiving::measuring::{BarrierData, EdgeErrors, Noise, RealTool, Sense, Switches, readings, switches};
use skiving::{Setting, SettingLimits};

const OPTIONS: ProfileOptions = ProfileOptions { degree: 2, band: 0.02, wear_limit: 0.01 };

fn shop_floor() -> BarrierData {
    BarrierData {
        speed: 120.0 * std::f64::consts::TAU / 60.0,
        latency: 20e-6,
        jitter: 1e-6,
        beam_noise: 0.2e-3,
        hysteresis: 0.0,
        encoder_step: 1e-4f64.to_radians(),
    }
}

fn tool() -> RealTool {
    let mut tool = RealTool::ideal(75);
    tool.eccentricity = [6e-3, -4e-3];
    let growth = EdgeErrors { profile: vec![1e-3], growth: vec![4e-3] };
    tool.edges = Sides::both(vec![growth; 75]);
    tool
}

fn scattered(threads: usize, seed: u64, count: usize) -> (Vec<Scatter>, Switches) {
    let flanks = STEPPED.flanks();
    let data = shop_floor();
    let switched = switches(&flanks, &STEPPED.beam(), &data, &tool()).unwrap();
    let limits = SettingLimits::default();
    let repeated = Repeated {
        flanks: &flanks,
        switches: &switched,
        data: &data,
        senses: &Sense::BOTH,
        revolutions: 2,
        radius_offset: 0.0,
        clocking: 0.0,
        options: &OPTIONS,
        settings: (&Setting::USUAL, &limits),
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    (pool.install(|| repeat(&repeated, count, seed, &Silent)).unwrap(), switched)
}

#[test]
fn results_scatter_as_told_and_hold_the_truth() {
    let (found, switched) = scattered(2, 1, 400);
    let flanks = STEPPED.flanks();
    let still =
        readings(&flanks, &switched, &BarrierData::ideal(), &[Sense::Positive], 1, &mut Noise::new(0));
    let still = measured_tool(&flanks, &still, 0.0).unwrap();
    let truth = evaluate(&flanks, &still.deviations, &OPTIONS).unwrap();
    let sigma = |flank: Flank, track: usize| {
        shop_floor().single_deviation(flanks[flank].tracks[track].0.contact.lever) / 2.0
    };
    let mut compared = [0; 4];
    for scatter in &found {
        let (told, true_value) = match scatter.quantity {
            Quantity::Deviation(flank, track, tooth) => {
                compared[0] += 1;
                (sigma(flank, track), truth.clocked.of[flank][track][tooth])
            }
            Quantity::TrackMean(flank, track) => {
                compared[1] += 1;
                (sigma(flank, track) / 75f64.sqrt(), truth.profile.track_means[flank][track])
            }
            Quantity::Eccentricity(k) => {
                compared[2] += 1;
                let noise = sigma(Flank::Left, 2);
                (noise * truth.mounting.deviation_per_noise[k], truth.mounting.eccentricity[k])
            }
            Quantity::SinglePitch(tooth) => {
                compared[3] += 1;
                // Two centres, each the mean of two flanks, by the radius over the lever.
                let (left, right) = (&flanks.left.tracks[2].0, &flanks.right.tracks[2].0);
                let radius = 0.5 * (left.radius() + right.radius());
                (sigma(Flank::Left, 2) * radius / left.contact.lever.abs(), truth.pitch.single[tooth])
            }
            _ => continue,
        };
        // 400 repetitions tell a standard deviation to 3.5 per cent; the worst of 750 lies four of these off.
        assert!((scatter.deviation / told - 1.0).abs() < 0.18, "{scatter:?} {told}");
        assert!((scatter.mean - true_value).abs() < 5.0 * told / 20.0, "{scatter:?} {true_value} {told}");
        let [from, to] = scatter.interval;
        assert!(from < scatter.mean && scatter.mean < to);
        assert!((to - from - 2.0 * 1.96 * told).abs() < 1.2 * told, "{scatter:?} {told}");
    }
    assert_eq!(compared, [750, 10, 2, 75]);
}

#[test]
fn threads_do_not_matter() {
    let (one, two) = (scattered(1, 7, 20).0, scattered(2, 7, 20).0);
    assert_eq!(one, two);
    assert_ne!(one, scattered(2, 8, 20).0);
}
