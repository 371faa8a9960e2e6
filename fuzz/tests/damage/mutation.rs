//! Damage to files: each copy follows from the seed number and from the copies before it.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use crate::seeds;

/// As long as an input may become, bytes; the same limit as in `scripts/fuzz`.
const LONGEST: usize = 16_384;

/// Makes damaged copies of seeds.
pub struct Mutation<'a> {
    seeds: &'a [Vec<u8>],
    dictionary: Vec<Vec<u8>>,
    dice: ChaCha8Rng,
}

impl<'a> Mutation<'a> {
    /// The sequence of `target`, as `FUZZ_SEED` wants it.
    pub fn of_target(target: &str, seeds: &'a [Vec<u8>]) -> Self {
        let number =
            std::env::var("FUZZ_SEED").map_or(1, |text| text.parse().expect("FUZZ_SEED is a whole number"));
        let name = target.bytes().fold(0, |sum: u64, byte| sum.wrapping_mul(31).wrapping_add(byte.into()));
        let dice = ChaCha8Rng::seed_from_u64(name ^ number);
        Self { seeds, dictionary: dictionary(), dice }
    }

    /// A seed with one to four damages.
    pub fn damaged(&mut self) -> Vec<u8> {
        let mut copy = self.seed().to_vec();
        for _ in 0..1 + self.below(4) {
            self.damage(&mut copy);
        }
        copy.truncate(LONGEST);
        copy
    }

    fn damage(&mut self, copy: &mut Vec<u8>) {
        let (from, to) = self.span(copy.len());
        match self.below(7) {
            0 => copy[from..to].iter_mut().for_each(|byte| *byte ^= 1 << (self.dice.next_u32() % 8)),
            1 => drop(copy.drain(from..to)),
            2 => {
                let again = copy[from..to].to_vec();
                drop(copy.splice(to..to, again));
            }
            3 => copy.truncate(from),
            4 => {
                let word = self.word().to_vec();
                drop(copy.splice(from..from, word));
            }
            5 => {
                let word = self.word().to_vec();
                drop(copy.splice(from..to, word));
            }
            _ => {
                let other = self.seed();
                let (first, last) = self.span(other.len());
                drop(copy.splice(from..to, other[first..last].iter().copied()));
            }
        }
    }

    fn seed(&mut self) -> &'a [u8] {
        let seeds = self.seeds;
        &seeds[self.below(seeds.len())]
    }

    fn word(&mut self) -> &[u8] {
        let index = self.below(self.dictionary.len());
        &self.dictionary[index]
    }

    /// A piece of `length` bytes: mostly short, seldom up to the end.
    fn span(&mut self, length: usize) -> (usize, usize) {
        let from = self.below(length + 1);
        let longest = [1, 4, 16, 64, length][self.below(5)];
        (from, (from + self.below(longest + 1)).min(length))
    }

    fn below(&mut self, end: usize) -> usize {
        (self.dice.next_u64() % end as u64) as usize
    }
}

/// The words of `fuzz/dictionary`: one a line, in quotes, bytes as `\xNN`.
fn dictionary() -> Vec<Vec<u8>> {
    let path = seeds::package().join("dictionary");
    let text = std::fs::read_to_string(&path).expect("the dictionary");
    let quoted = text.lines().filter_map(|line| line.strip_prefix('"')?.strip_suffix('"'));
    let words: Vec<_> = quoted.map(unescaped).collect();
    assert!(words.len() > 10, "{} words in {}", words.len(), path.display());
    words
}

fn unescaped(quoted: &str) -> Vec<u8> {
    let mut word = Vec::new();
    let mut rest = quoted.bytes();
    while let Some(byte) = rest.next() {
        match (byte, rest.clone().next()) {
            (b'\\', Some(b'x')) => {
                let digits: String = rest.by_ref().skip(1).take(2).map(char::from).collect();
                word.push(u8::from_str_radix(&digits, 16).expect("two hexadecimal digits"));
            }
            (b'\\', Some(escaped)) => {
                rest.next();
                word.push(escaped);
            }
            _ => word.push(byte),
        }
    }
    word
}
