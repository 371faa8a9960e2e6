//! How far the count of a binary rate multiplier is off the straight line n B/2^18, at most, over all B and n.

use electronic_gearbox::Error;
use electronic_gearbox::chain::{Multiplier, RateRule, passed_pulses};

const BITS: u32 = 18;

/// A count of pulses and the word whose deviation there is the extreme one, in pulses/2^18.
#[derive(Clone, Copy, Default)]
struct Place {
    deviation: i64,
    word: u32,
    pulses: u64,
}

/// Least and greatest deviation in pulses, exactly: multiples of 2^-18 that a floating number holds.
///
/// Each pulse belongs to one bit of B, so that the deviation is the sum over the bits that are set: after n pulses the greatest is that of
/// the word with all bits of positive deviation, the least that of the word with the others. After 2^18 pulses everything repeats.
pub(super) fn extremes() -> Result<[f64; 2], Error> {
    let words: Vec<u32> = (0..BITS).map(|bit| 1 << bit).collect();
    let mut lines: Vec<Multiplier> =
        words.iter().map(|word| Multiplier::new(*word, RateRule::Binary)).collect::<Result<_, _>>()?;
    let mut deviations = vec![0; lines.len()];
    let (mut least, mut greatest) = (Place::default(), Place::default());
    for pulses in 1..=1u64 << BITS {
        let [mut below, mut above] = [Place { pulses, ..Place::default() }; 2];
        for ((word, line), deviation) in words.iter().zip(&mut lines).zip(&mut deviations) {
            *deviation += (i64::from(line.pulse()) << BITS) - i64::from(*word);
            let side = if *deviation < 0 { &mut below } else { &mut above };
            side.deviation += *deviation;
            side.word |= word;
        }
        if below.deviation < least.deviation {
            least = below;
        }
        if above.deviation > greatest.deviation {
            greatest = above;
        }
    }
    Ok([deviation_at(least)?, deviation_at(greatest)?])
}

/// The deviation of the word as a whole.
fn deviation_at(place: Place) -> Result<f64, Error> {
    let passed = passed_pulses(place.word, RateRule::Binary, place.pulses)?;
    // Below 2^37: exact.
    Ok(passed as f64 - place.pulses as f64 * f64::from(place.word) / f64::from(1u32 << BITS))
}
