//! Worn edges measured: their growth found again, what has to be ground off, and the trend over several measurements.

use super::samples::{CROWNED, RING, STEPPED, Sample};
use foundation::geometry::Sides;
use skiving::VirtualEdge;
use skiving::evaluation::{Deviations, Evaluation, ProfileOptions, evaluate, measured_tool};
use skiving::measuring::{BarrierData, EdgeErrors, FlankTracks, Noise, RealTool, Sense, readings, switches};
use skiving::wear::{
    Attribution, GrowthOptions, Growths, ToothPositions, WearError, WearPoint, WearTrend, edge_growths,
    recession, regrind, renewing_depth, worn_since,
};
use std::f64::consts::TAU;

const OPTIONS: ProfileOptions = ProfileOptions { degree: 2, band: 0.02, wear_limit: 0.01 };
const SINGLE: GrowthOptions =
    GrowthOptions { positions: ToothPositions::Pitch, sigma: 1e-4, resolution: 1e-3 };
const SINCE: GrowthOptions = GrowthOptions { positions: ToothPositions::Wear, ..SINGLE };

fn wave(k: usize, teeth: usize, n: f64) -> f64 {
    (TAU * n * k as f64 / teeth as f64).sin()
}

/// Growth of each tooth's roundings, mm.
fn growth(k: usize, teeth: usize) -> Sides<f64> {
    let left = 8e-3 + 2e-3 * wave(k, teeth, 3.0);
    Sides { left, right: left + 1e-3 * wave(k, teeth, 4.0) }
}

/// A tool as it came from grinding, off its axis, and the same with worn edges.
fn tool(teeth: usize, worn: f64, mounted: f64) -> RealTool {
    RealTool {
        pitch: (0..teeth).map(|k| 2e-5 * wave(k, teeth, 5.0)).collect(),
        edges: Sides::from_fn(|flank| {
            let edge = |k| EdgeErrors {
                profile: vec![5e-4 * wave(k, teeth, 7.0), 5e-4, -5e-4],
                growth: vec![worn * growth(k, teeth)[flank]],
            };
            (0..teeth).map(edge).collect()
        }),
        eccentricity: [6e-3 * mounted, -4e-3],
        ..RealTool::ideal(teeth)
    }
}

fn measured(
    sample: &Sample,
    flanks: &Sides<FlankTracks>,
    tool: &RealTool,
    data: &BarrierData,
    noise: &mut Noise,
) -> Evaluation {
    let switched = switches(flanks, &sample.beam(), data, tool).unwrap();
    let seen = readings(flanks, &switched, data, &Sense::BOTH, 4, noise);
    evaluate(flanks, &measured_tool(flanks, &seen, 0.0).unwrap().deviations, &OPTIONS).unwrap()
}

fn calm(sample: &Sample, flanks: &Sides<FlankTracks>, tool: &RealTool) -> Evaluation {
    measured(sample, flanks, tool, &BarrierData::ideal(), &mut Noise::new(0))
}

fn shop_floor() -> BarrierData {
    BarrierData {
        speed: 120.0 * TAU / 60.0,
        latency: 20e-6,
        jitter: 1e-6,
        beam_noise: 0.2e-3,
        hysteresis: 1e-3,
        encoder_step: 1e-4f64.to_radians(),
    }
}

fn worst(found: &Growths, wanted: impl Fn(usize) -> Sides<f64>) -> f64 {
    let off = |(flank, of): (_, &Vec<f64>)| {
        of.iter().enumerate().map(|(k, g)| (g - wanted(k)[flank]).abs()).fold(0.0, f64::max)
    };
    found.growth.iter().map(off).fold(0.0, f64::max)
}

/// Two measurements of one tool, mounted anew between them: the growth of every edge to a tenth of a micrometre, although
/// profile and pitch are off by as much as the wear does.
#[test]
fn growth_since_the_fresh_tool_is_found_again() {
    for sample in [RING, STEPPED, CROWNED] {
        let flanks = sample.flanks();
        let teeth = sample.teeth[0] as usize;
        let (fresh, now) =
            (calm(&sample, &flanks, &tool(teeth, 0.0, 1.0)), calm(&sample, &flanks, &tool(teeth, 1.0, -0.5)));
        let since = worn_since(&fresh.remaining, &now.remaining).unwrap();
        let found = edge_growths(&flanks, &since, &SINCE).unwrap();
        let off = worst(&found, |k| growth(k, teeth));
        assert!(off < 0.1e-3, "{off}");
        let Attribution::GrowthAlone { deviation_with_shift } = found.attribution else {
            panic!("{found:?}")
        };
        assert!(deviation_with_shift > 50.0 * found.deviation.left.max(found.deviation.right), "{found:?}");
        // A single measurement takes the errors of grinding for growth, but not those of pitch.
        let single = edge_growths(&flanks, &now.remaining, &SINGLE).unwrap();
        let pitch_as_wear = edge_growths(&flanks, &now.remaining, &SINCE).unwrap();
        let (a, b) = (worst(&single, |k| growth(k, teeth)), worst(&pitch_as_wear, |k| growth(k, teeth)));
        assert!(off < a && a < b && a < 6e-3, "{off} {a} {b}");
    }
}

/// What is stated of the growth's scatter is what repeated measurements show.
#[test]
fn growth_scatters_as_it_is_told() {
    let flanks = STEPPED.flanks();
    let data = shop_floor();
    let worn = tool(75, 1.0, 1.0);
    let lever = flanks.left.tracks[0].0.contact.lever;
    let sigma = data.single_deviation(lever) / 8f64.sqrt();
    for options in [SINGLE, SINCE] {
        let options = GrowthOptions { sigma, ..options };
        let still = edge_growths(&flanks, &calm(&STEPPED, &flanks, &worn).remaining, &options).unwrap();
        let (mut squares, mut count) = (0.0, 0.0);
        for start in 0..20 {
            let noisy = measured(&STEPPED, &flanks, &worn, &data, &mut Noise::new(start));
            let found = edge_growths(&flanks, &noisy.remaining, &options).unwrap();
            for (flank, of) in found.growth.iter() {
                for (a, b) in of.iter().zip(&still.growth[flank]) {
                    squares += ((a - b) / found.deviation[flank]).powi(2);
                    count += 1.0;
                }
            }
        }
        let scatter: f64 = f64::sqrt(squares / count);
        // Three thousand numbers; clocking and mounting take a few of them.
        assert!((scatter - 1.0).abs() < 0.06, "{scatter}");
    }
}

/// Where the noise is small enough the shift is told from the growth, and a profile that stands back does not count as wear.
#[test]
fn a_shift_is_told_where_the_measurement_can() {
    let flanks = RING.flanks();
    // To the first order, because the second one is as large as what tells them apart.
    let like = calm(&RING, &flanks, &RealTool::ideal(41)).remaining;
    let made = like.map(|flank, track, tooth, _| {
        let section = &flanks[flank].tracks[track].0.section;
        -4e-3 + growth(tooth, 41)[flank] * section.growth_at(section.contact_angle)
    });
    let sharp = GrowthOptions { sigma: 1e-6, ..SINGLE };
    let found = edge_growths(&flanks, &made, &sharp).unwrap();
    assert_eq!(found.attribution, Attribution::ShiftAndGrowth);
    assert!(worst(&found, |k| growth(k, 41)) < 1e-11);
    assert!(found.residual.left.iter().all(|r| *r < 1e-15));
    let blunt = edge_growths(&flanks, &made, &SINGLE).unwrap();
    assert!(blunt.growth.left.iter().all(|g| *g > 25e-3), "{blunt:?}");
    assert!(blunt.residual.left.iter().all(|r| *r > 1e-6));
}

#[test]
fn the_most_worn_edge_decides_how_much_is_ground_off() {
    for sample in [RING, STEPPED, CROWNED] {
        let flanks = sample.flanks();
        let teeth = sample.teeth[0] as usize;
        let growths =
            Sides::from_fn(|flank| (0..teeth).map(|k| growth(k, teeth)[flank]).collect::<Vec<f64>>());
        let found = regrind(&flanks, &growths).unwrap();
        let place = found.decides.unwrap();
        let section = &flanks[place.flank].tracks[place.track].0.section;
        assert_eq!(found.depth, renewing_depth(section, growths[place.flank][place.tooth]));
        let tilt = section.rake_normal.z;
        assert_eq!(found.axial_depth, found.depth / tilt);
        for (flank, of) in found.each.iter() {
            let asked = |depth: &f64| *depth > 0.0 && *depth <= found.depth * (1.0 + 1e-12);
            assert!(of.iter().all(|depth| depth.as_ref().is_some_and(asked)));
            assert!(found.recession[flank].iter().all(|f| *f < 0.0 && *f > -found.depth));
        }
        // Edges that have not grown ask for nothing.
        let fresh = regrind(&flanks, &growths.map(|_, of| vec![0.0; of.len()])).unwrap();
        assert_eq!((fresh.depth, fresh.axial_depth, fresh.decides), (0.0, 0.0, None));
    }
}

/// Moved along the ruling of its clearance face until it is lower by a depth, the edge is where the recession says.
#[test]
fn a_lower_edge_stands_where_the_recession_says() {
    let flanks = STEPPED.flanks();
    let edge: &VirtualEdge = &flanks.left.edge;
    let (track, _) = flanks.left.tracks[2];
    let depth = 0.02;
    let section = edge.section(track.contact.w);
    let way = -depth / section.ruling.dot(&section.rake_normal);
    let moved = (section.ruling * way).dot(&track.contact.normal);
    let told = recession(&section, section.contact_angle, depth);
    assert!((moved - told).abs() < 1e-9, "{moved} {told}");
}

/// A tool followed over its life: the trend of the measured wear says when its limit is reached.
#[test]
fn the_limit_is_reached_when_the_trend_says() {
    let flanks = RING.flanks();
    let data = shop_floor();
    let mut noise = Noise::new(5);
    let limit = 2e-3;
    let per_part = 1.0 / 2000.0;
    // The mean over 41 teeth of 8 readings.
    let sigma = data.single_deviation(flanks.left.tracks[0].0.contact.lever) / (8.0 * 41f64).sqrt();
    let points: Vec<WearPoint> = [200.0, 600.0, 1000.0, 1400.0]
        .into_iter()
        .map(|parts: f64| {
            let seen = measured(&RING, &flanks, &tool(41, parts * per_part, 1.0), &data, &mut noise);
            WearPoint::of_track_means(parts, &seen.profile.track_means.left, sigma)
        })
        .collect();
    let trend = WearTrend::fit(&points, limit).unwrap();
    let forecast = trend.forecast.unwrap();
    let truth = {
        let wear = |parts: f64| {
            let seen = calm(&RING, &flanks, &tool(41, parts * per_part, 1.0));
            WearPoint::of_track_means(parts, &seen.profile.track_means.left, sigma).wear
        };
        let (a, b) = (wear(1400.0), wear(2800.0));
        1400.0 + 1400.0 * (limit - a) / (b - a)
    };
    assert!(forecast.interval[0] < truth && truth < forecast.interval[1], "{truth} {trend:?}");
    assert!(forecast.deviation < 0.1 * truth && !trend.is_bent(), "{trend:?}");
}

#[test]
fn what_does_not_go_together_is_refused() {
    let flanks = RING.flanks();
    let like: Deviations = calm(&RING, &flanks, &RealTool::ideal(41)).remaining;
    let mut short = like.clone();
    short.of.left.pop();
    let mut thin = like.clone();
    thin.of.right[1].pop();
    let mut wrong = like.clone();
    wrong.of.left[0][3] = f64::NAN;
    let code = |error: WearError| {
        assert!(!error.way_out().is_empty() && !error.to_string().is_empty());
        error.code()
    };
    for other in [&short, &thin] {
        assert_eq!(code(worn_since(&like, other).unwrap_err()), "other-shape");
        assert_eq!(code(edge_growths(&flanks, other, &SINGLE).unwrap_err()), "other-shape");
    }
    assert_eq!(code(edge_growths(&flanks, &wrong, &SINGLE).unwrap_err()), "invalid-number");
    for options in [GrowthOptions { sigma: 0.0, ..SINGLE }, GrowthOptions { resolution: f64::NAN, ..SINGLE }]
    {
        assert_eq!(code(edge_growths(&flanks, &like, &options).unwrap_err()), "invalid-number");
    }
    let growths = |left: Vec<f64>, right: Vec<f64>| regrind(&flanks, &Sides { left, right });
    assert_eq!(code(growths(vec![0.0; 3], vec![0.0; 2]).unwrap_err()), "other-shape");
    assert_eq!(code(growths(vec![f64::NAN], vec![0.0]).unwrap_err()), "invalid-number");
}
