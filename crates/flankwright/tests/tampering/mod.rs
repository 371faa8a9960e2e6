//! Tampering: random damages of written programs must be noticed with block and place, harmless edits must not. What counts as a damage is
//! decided by numbers of the text itself, never by the check that is under test. `TAMPER_SEED` chooses other damages.

mod edits;
mod milling;
mod skiving;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// Damages and edits of one process.
pub const COUNT: usize = 50;
/// The seed where the environment gives none.
const SEED: u64 = 25;

/// A text that was changed.
pub struct Tampered {
    /// What was done to it.
    pub what: String,
    pub text: String,
}

/// What a check says of a text.
pub enum Answer {
    /// It is accepted.
    Accepted,
    /// It is no program for this job.
    Refused(String),
    /// What is wrong with it; every finding names block and place, or it does not count.
    Noticed { findings: Vec<String>, placed: bool },
}

/// The random numbers of a process; the seed is printed.
pub fn random(process: &str) -> ChaCha8Rng {
    let seed = std::env::var("TAMPER_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(SEED);
    println!("tampering with {process}: TAMPER_SEED={seed}");
    ChaCha8Rng::seed_from_u64(seed)
}

/// A number below `count`.
pub fn below(random: &mut ChaCha8Rng, count: usize) -> usize {
    (random.next_u64() % count as u64) as usize
}

/// A number in a range.
pub fn between(random: &mut ChaCha8Rng, [from, to]: [f64; 2]) -> f64 {
    from + (to - from) * (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64
}

/// Either sign.
pub fn sign(random: &mut ChaCha8Rng) -> f64 {
    if random.next_u64() & 1 == 0 { 1.0 } else { -1.0 }
}

/// Checks that all but one in a hundred of the damages are noticed with block and place.
pub fn all_noticed(damages: &[Tampered], check: impl Fn(&str) -> Answer) {
    let mut missed = Vec::new();
    for damage in damages {
        match check(&damage.text) {
            Answer::Noticed { placed: true, .. } | Answer::Refused(_) => {}
            Answer::Noticed { findings, .. } => {
                missed.push(format!("{}: without block and place: {findings:?}", damage.what));
            }
            Answer::Accepted => missed.push(format!("{}: not noticed", damage.what)),
        }
    }
    assert!(100 * missed.len() <= damages.len(), "{} of {}: {missed:#?}", missed.len(), damages.len());
}

/// Checks that every edit is accepted.
pub fn all_accepted(edits: &[Tampered], check: impl Fn(&str) -> Answer) {
    for edit in edits {
        match check(&edit.text) {
            Answer::Accepted => {}
            Answer::Refused(why) => panic!("{}: refused: {why}", edit.what),
            Answer::Noticed { findings, .. } => panic!("{}: {findings:#?}", edit.what),
        }
    }
}
