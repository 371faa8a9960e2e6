//! A table of chips: a third of the teeth, by every size, on either flank or both, evenly spread, side by side or anywhere, under a
//! barrier with noise. `CHIPS_SEED` chooses other tools, places and noise.

use super::broken::{OPTIONS, close, tool};
use super::samples::{RING, STEPPED, Sample};
use foundation::geometry::{Flank, Sides};
use skiving::MeasuringTrack;
use skiving::evaluation::{Evaluation, evaluate_measured, measured_tool};
use skiving::measuring::{BarrierData, FlankTracks, Noise, RealTool, Sense, readings, switches};
use skiving::wear::{
    EdgeState, GrowthOptions, RegrindCause, ToothPositions, chip_depth, edge_growths, recession,
    regrind_edges,
};
use std::f64::consts::TAU;

const SEED: u64 = 25;
const CHIPS: [f64; 5] = [25e-3, 50e-3, 100e-3, 200e-3, 400e-3];
const PATTERNS: [&str; 3] = ["evenly spread", "side by side", "anywhere"];

fn seed() -> u64 {
    let seed = std::env::var("CHIPS_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(SEED);
    println!("CHIPS_SEED={seed}");
    seed
}

fn below(count: usize, noise: &mut Noise) -> usize {
    ((noise.uniform() * count as f64) as usize).min(count - 1)
}

/// A third of the teeth, ascending.
fn third(teeth: usize, pattern: &str, noise: &mut Noise) -> Vec<usize> {
    let first = below(teeth, noise);
    let mut list: Vec<usize> = match pattern {
        "evenly spread" => (0..teeth / 3).map(|k| (first + 3 * k) % teeth).collect(),
        _ => (0..teeth).map(|k| (first + k) % teeth).collect(),
    };
    if pattern == "anywhere" {
        for k in (1..teeth).rev() {
            list.swap(k, below(k + 1, noise));
        }
    }
    list.truncate(teeth / 3);
    list.sort_unstable();
    list
}

/// 8 readings of each edge at 120 1/min.
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

/// With the same noise every time.
fn measured(sample: &Sample, flanks: &Sides<FlankTracks>, tool: &RealTool, noise: u64) -> Evaluation {
    let data = shop_floor();
    let switched = switches(flanks, &sample.beam(), &data, tool).unwrap();
    let seen = readings(flanks, &switched, &data, &Sense::BOTH, 4, &mut Noise::new(noise));
    evaluate_measured(flanks, &measured_tool(flanks, &seen, 0.0).unwrap(), &OPTIONS).unwrap()
}

fn edges(flanks: &[Flank], teeth: &[usize]) -> Vec<(Flank, usize)> {
    flanks.iter().flat_map(|flank| teeth.iter().map(move |tooth| (*flank, *tooth))).collect()
}

#[test]
fn a_third_of_the_teeth_chipped_by_any_amount_changes_no_result() {
    let seed = seed();
    for sample in [RING, STEPPED] {
        let flanks = sample.flanks();
        let teeth = sample.teeth[0] as usize;
        let mut noise = Noise::new(seed);
        let good = tool(teeth, &mut noise);
        let whole = measured(&sample, &flanks, &good, seed);
        assert!(whole.mounting.left_out.is_empty(), "seed {seed}: {:?}", whole.mounting.left_out);
        for pattern in PATTERNS {
            for chip in CHIPS {
                let broken = third(teeth, pattern, &mut noise);
                for on in [&[Flank::Left][..], &[Flank::Right], &Flank::BOTH] {
                    let mut chipped = good.clone();
                    for (flank, tooth) in edges(on, &broken) {
                        chipped.edges[flank][tooth].profile[0] -= chip;
                    }
                    let name = format!("seed {seed}, {teeth} teeth, {chip} mm on {on:?}, {pattern}");
                    let found = measured(&sample, &flanks, &chipped, seed);
                    assert_eq!(found.mounting.left_out, broken, "{name}");
                    assert_eq!(found.count(), teeth - broken.len(), "{name}");
                    assert_eq!(found.standing_out, edges(on, &broken), "{name}");
                    close(&flanks, &whole, &found, &name);
                }
            }
        }
    }
}

/// A chip towards one end of the edge only, on a part of the tracks.
#[test]
fn a_chip_at_one_end_of_the_edge_is_found() {
    let seed = seed();
    let flanks = RING.flanks();
    let mut noise = Noise::new(seed);
    let good = tool(41, &mut noise);
    let whole = measured(&RING, &flanks, &good, seed);
    for end in [-1.0, 1.0] {
        let broken = third(41, "side by side", &mut noise);
        let mut chipped = good.clone();
        for &tooth in &broken {
            // chip (1 + end x)/2.
            chipped.edges.left[tooth].profile[0] -= 20e-3;
            chipped.edges.left[tooth].profile[1] -= end * 20e-3;
        }
        let found = measured(&RING, &flanks, &chipped, seed);
        assert_eq!(found.mounting.left_out, broken, "seed {seed}");
        close(&flanks, &whole, &found, &format!("seed {seed}, end {end}"));
    }
}

/// A chip as deep moves the touch of a track near its end past the end of the edge, which then switches; it refused the measurement.
#[test]
fn an_edge_that_is_chipped_at_its_end_switches_there() {
    let flanks = STEPPED.flanks_at(&[-0.9, -0.4, 0.0, 0.4, 0.9]);
    let good = tool(75, &mut Noise::new(4));
    let chip = 400e-3;
    let mut chipped = good.clone();
    for tooth in (0..75).step_by(3) {
        chipped.edges.left[tooth].profile[0] -= chip;
    }
    let [whole, found] = [&good, &chipped].map(|tool| measured(&STEPPED, &flanks, tool, 2));
    assert_eq!(found.mounting.left_out, (0..75).step_by(3).collect::<Vec<_>>());
    close(&flanks, &whole, &found, "chips beyond the end of the edge");
    for row in &found.remaining.of.left {
        assert!((row[3] + chip).abs() < 5e-3 && row[4].abs() < 5e-3, "{} {}", row[3], row[4]);
    }
    // A whole edge whose touch lies beyond its end is refused: there the track is wrong, not the tooth.
    let codes = [-0.05, 0.05].map(|slope| {
        let mut steep = good.clone();
        steep.edges.left[5].profile = vec![0.0, slope, 0.0];
        let flanks = STEPPED.flanks_at(&[-0.9999, 0.0, 0.9]);
        switches(&flanks, &STEPPED.beam(), &shop_floor(), &steep).err().map(|error| error.code())
    });
    assert!(codes.contains(&Some("edge-end-touched")), "{codes:?}");
}

/// Of an edge with a chip nothing is left above its ground: the lower edge stands back by the chip, and the whole edges ask for less.
#[test]
fn a_chip_is_ground_away_as_deep_as_it_is() {
    for sample in [RING, STEPPED] {
        let flanks = sample.flanks();
        let teeth = sample.teeth[0] as usize;
        let good = tool(teeth, &mut Noise::new(3));
        let chip = 60e-3;
        let mut chipped = good.clone();
        chipped.edges.right[7].profile[0] -= chip;
        let found = measured(&sample, &flanks, &chipped, 1);
        assert_eq!(found.standing_out, [(Flank::Right, 7)]);
        let options = GrowthOptions { positions: ToothPositions::Pitch, sigma: 1e-4, resolution: 2e-3 };
        let growths = edge_growths(&flanks, &found.remaining, &options).unwrap().growth;
        let missing = |flank: Flank, tooth: usize| -> Vec<f64> {
            found.remaining.of[flank].iter().map(|row| -row[tooth]).collect()
        };
        let states = growths.map(|flank, of| -> Vec<EdgeState> {
            let state = |(tooth, growth): (usize, &f64)| match (flank, tooth) {
                (Flank::Right, 7) => EdgeState::Chipped(missing(flank, tooth)),
                (Flank::Left, 7) => EdgeState::Unknown,
                _ => EdgeState::Worn(*growth),
            };
            of.iter().enumerate().map(state).collect()
        });
        let ground = regrind_edges(&flanks, &states).unwrap();
        let place = ground.decides.unwrap();
        assert_eq!((place.flank, place.tooth), (Flank::Right, 7));
        let section = &flanks.right.tracks[place.track].0.section;
        let RegrindCause::Chip(deep) = place.cause else { panic!("{place:?}") };
        assert!((deep - chip).abs() < 3e-3, "{deep}");
        assert_eq!(ground.depth, chip_depth(section, deep));
        // The lower fresh edge stands where the chip ends.
        assert!((recession(section, section.contact_angle, ground.depth) + deep).abs() < 1e-12);
        let all_back = |(track, f): (&(MeasuringTrack, _), f64)| {
            let axial = ground.axial_depth * track.0.section.rake_normal.z;
            recession(&track.0.section, track.0.section.contact_angle, axial) <= -f + 1e-9
        };
        assert!(flanks.right.tracks.iter().zip(missing(Flank::Right, 7)).all(all_back));
        assert_eq!(ground.each.left[7], None);
        assert_eq!(ground.each.right[7], Some(ground.depth));
        // The whole edges alone ask for much less, and a tool without chips for as much as them.
        let whole = ground.whole;
        assert!(whole.depth < 0.2 * ground.depth, "{} {}", whole.depth, ground.depth);
        let without = states.map(|_, of| {
            of.iter()
                .map(|state| match state {
                    EdgeState::Chipped(_) => EdgeState::Unknown,
                    other => other.clone(),
                })
                .collect()
        });
        let rest = regrind_edges(&flanks, &without).unwrap();
        assert_eq!((rest.depth, rest.axial_depth), (whole.depth, whole.axial_depth));
    }
}
