//! The electronic gearbox against LinuxCNC's HAL component `encoder_ratio` on the same quadrature stream
//! (`docs/mathematics/programs.md#how-it-is-verified`). Without `scripts/linuxcnc-client`, or where `scripts/hal-peer` cannot mount, these tests say so and check nothing.
//!
//! Facts of the component as LinuxCNC 2.9.0~pre1 has it, all of which the tests rest on:
//! - its error is (t_s M s - t_m S m)/(M S t_s) revolutions of the slave, with counts m and s, counts of a revolution M and S,
//!   teeth t_m and t_s; with the ratio n/d = t_m S/(t_s M) in lowest terms that is (d s - n m)/(d S);
//! - what it adds for a transition is 0 until its `update` has run once, so that transitions in the first period are lost and
//!   counting is relative to the first line of the stream; with a first line 00 nothing is lost;
//! - it counts all four transitions of a period, also where the direction turns between any two of them;
//! - `halsampler` prints six decimals, so that the integer d s - n m can be told if d S < 10^6, and cannot otherwise;
//! - the sum t_s M s - t_m S m is kept in 32 bits with sign and wraps; the divisor M S t_s in 32 bits without sign, it wraps too.

#[path = "encoder_ratio/ours.rs"]
mod ours;
#[path = "encoder_ratio/pair.rs"]
mod pair;
#[path = "encoder_ratio/peer.rs"]
mod peer;
#[path = "encoder_ratio/stream.rs"]
mod stream;

use pair::{Pair, Slave};

const LINES: usize = 6000;

/// Ratios of 7/30, 1/40, 3/40 and 101/37, by equal and by different counts of a revolution, in both directions.
const PAIRS: [Pair; peer::CHANNELS] = [
    Pair::new(1000, 1000, (7, 30), Slave::Wanders),
    Pair::new(1024, 360, (7, 30), Slave::Follows),
    Pair::new(2000, 2000, (1, 40), Slave::Follows),
    Pair::new(360, 4096, (1, 40), Slave::Wanders).crossed(),
    Pair::new(4000, 4000, (3, 40), Slave::Wanders),
    Pair::new(7200, 500, (3, 40), Slave::Follows).crossed(),
    Pair::new(1000, 1000, (101, 37), Slave::Wanders).crossed(),
    Pair::new(1200, 400, (101, 37), Slave::Follows),
];

/// The multiple of 1/`steps` that is printed as `millionths`.
fn nearest(millionths: i64, steps: i64) -> i64 {
    (2 * millionths * steps + 1_000_000).div_euclid(2_000_000)
}

/// Compares every sample; gives how many there were.
fn compare(motions: &[stream::Counts], samples: &peer::Samples) -> usize {
    assert_eq!(samples.len(), motions.len());
    let first = &motions[0];
    let mut compared = 0;
    for (line, (counts, sample)) in motions.iter().zip(samples).enumerate() {
        assert_eq!(sample.len(), PAIRS.len());
        for (channel, (pair, printed)) in PAIRS.iter().zip(sample).enumerate() {
            let [master, slave] = [0, channel + 1].map(|axis| counts[axis] - first[axis]);
            let ours = pair.error_steps(master, slave);
            assert_eq!(
                nearest(*printed, pair.steps()),
                ours,
                "line {line}, {pair:?}, counts {master} {slave}"
            );
            compared += 1;
        }
    }
    compared
}

/// The stream has to show what the comparison is for.
fn assert_varied(motions: &[stream::Counts]) {
    for axis in 0..=PAIRS.len() {
        let ways: Vec<i64> = motions.windows(2).map(|two| two[1][axis] - two[0][axis]).collect();
        assert!(ways.iter().all(|way| way.abs() <= 1), "axis {axis} is too fast for quadrature");
        let moves: Vec<i64> = ways.into_iter().filter(|way| *way != 0).collect();
        let turns = moves.windows(2).filter(|two| two[0] != two[1]).count();
        assert!(turns >= 5, "axis {axis} turns {turns} times");
    }
    let reach = motions.iter().map(|counts| counts[0]);
    assert!(reach.clone().max() > Some(100) && reach.min() < Some(-100));
}

#[test]
fn every_error_of_the_peer_is_ours() {
    assert!(PAIRS.iter().all(|pair| pair.steps() < 1_000_000), "six decimals do not tell the steps apart");
    let mut compared = 0;
    // A start at 0 loses nothing; from another count its own transition is lost, and that only.
    for start in [0, 1, -1] {
        let motions = stream::motions(&PAIRS, LINES, start);
        assert_varied(&motions);
        let Some(samples) = peer::errors(&PAIRS, &motions, "encoder_ratio on a stream") else { return };
        compared += compare(&motions, &samples);
    }
    println!("{compared} samples of encoder_ratio are equal to ours");
}

/// A slave that our gearbox leads is behind by the part of a count that the gearbox has left, never by a whole one.
#[test]
fn the_peer_finds_no_error_in_a_slave_that_our_gearbox_leads() {
    let motions = stream::motions(&PAIRS, LINES, 0);
    let Some(samples) = peer::errors(&PAIRS, &motions, "encoder_ratio on our follower") else { return };
    for (channel, pair) in PAIRS.iter().enumerate().filter(|(_, pair)| pair.slave == Slave::Follows) {
        let sign = if pair.crossed { -1 } else { 1 };
        let errors: Vec<i64> =
            samples.iter().map(|sample| sign * nearest(sample[channel], pair.steps())).collect();
        let count = pair.ours().denominator;
        assert!(errors.iter().all(|error| (1 - count..=0).contains(error)), "{pair:?}");
        let least = errors.iter().min().copied();
        assert!(least < Some(-count * 9 / 10), "{pair:?}: the least error is {least:?} of {count}");
    }
}

/// The sum of the first pair leaves 32 bits where the slave is two thirds of a revolution off; of the second the divisor does.
/// The third has the motions and the ratio of the first by fewer counts, so that the peer itself tells what is right.
#[test]
fn the_peer_wraps_where_our_gearbox_stays_exact() {
    let runs = Slave::Runs { lines: 5500 };
    let pairs = [
        Pair::new(4000, 4000, (3, 200), runs),
        Pair::new(10_000, 10_000, (1, 43), runs),
        Pair::new(400, 400, (3, 200), runs),
    ];
    let motions = stream::motions(&pairs, 10_000, 0);
    let Some(samples) = peer::errors(&pairs, &motions, "overflow of encoder_ratio") else { return };
    assert_eq!(samples.len(), motions.len());
    let mut wrapped = [0; 3];
    let mut last = [0; 3];
    for (line, (counts, sample)) in motions.iter().zip(&samples).enumerate() {
        for (channel, pair) in pairs.iter().enumerate() {
            let ours = pair.error_steps(counts[0], counts[channel + 1]);
            let sum = ours * (pair.peer_steps() / pair.steps());
            let kept = i64::from(sum as i32);
            let divisor = i64::from(pair.peer_steps() as u32);
            // The last printed digit is rounded.
            let missing = (sample[channel] * divisor - kept * 1_000_000).abs();
            assert!(2 * missing <= divisor, "line {line}, {pair:?}: {} printed, sum {sum}", sample[channel]);
            wrapped[channel] += usize::from(kept != sum);

            let ratio = pair.ours();
            let step = (ours - last[channel]).abs();
            assert!(
                step <= ratio.numerator + ratio.denominator,
                "line {line}, {pair:?}: ours jumps by {step}"
            );
            last[channel] = ours;
        }
        assert_eq!(last[0], last[2], "line {line}");
    }
    assert!(wrapped[0] > 1000 && wrapped[1] > 500, "wrapped in {wrapped:?} lines");
    assert_eq!(wrapped[2], 0);
    println!("the peer's sum wrapped in {wrapped:?} of {} lines", motions.len());
}
