//! Words of a program's lines, and edits that change nothing that moves.

use super::{Tampered, below};
use rand_chacha::ChaCha8Rng;

/// The number behind a letter in a line.
pub fn word(line: &str, letter: char) -> Option<f64> {
    let found = line.split_whitespace().find(|word| word.starts_with(letter))?;
    found[1..].parse().ok()
}

/// The line with another value of a word, in so many digits.
pub fn with(line: &str, letter: char, digits: usize, change: impl Fn(f64) -> f64) -> String {
    let changed = |text: &str| match text.strip_prefix(letter).and_then(|number| number.parse::<f64>().ok()) {
        Some(value) => format!("{letter}{:.digits$}", change(value)),
        None => text.to_owned(),
    };
    line.split(' ').map(changed).collect::<Vec<_>>().join(" ")
}

/// A line that moves axes.
pub fn moves(line: &str) -> bool {
    line.starts_with("G0 ") || line.starts_with("G1 ")
}

/// An edit of the kind that the number says: a comment, block numbers, spacing, a word that says where an axis stands already, other
/// digits. `comment` is how the control writes one, `axes` are letters of axes that are not turned in full turns.
pub fn harmless(
    kind: usize,
    lines: &[String],
    (comment, axes): ([&str; 2], &[char]),
    random: &mut ChaCha8Rng,
) -> Tampered {
    let mut changed = lines.to_vec();
    let moving: Vec<usize> = (0..lines.len()).filter(|&k| moves(&lines[k])).collect();
    let at = moving[below(random, moving.len())];
    let what = match kind % 5 {
        0 => {
            let [begin, end] = comment;
            changed.insert(at, format!("{begin}LOOKED AT BY SHIFT {}{end}", below(random, 100)));
            "a comment"
        }
        1 => {
            let first = 1 + below(random, 1000);
            for (number, k) in moving.into_iter().enumerate() {
                changed[k] = format!("N{} {}", first + number, lines[k]);
            }
            "block numbers"
        }
        2 => {
            changed[at] = lines[at].replace(' ', "   ");
            "more spaces"
        }
        3 => {
            let letter = axes[below(random, axes.len())];
            let stands = lines[..at].iter().rev().find_map(|line| word(line, letter));
            if let (Some(stands), None) = (stands, word(&lines[at], letter)) {
                let (begin, rest) = lines[at].split_at(3);
                changed[at] = format!("{begin}{letter}{stands:.6} {rest}");
            }
            "an equal word"
        }
        _ => {
            let letter = axes[below(random, axes.len())];
            changed[at] = with(&lines[at], letter, 9, |value| value);
            "a number in more digits"
        }
    };
    Tampered { what: format!("{what} at line {}", at + 1), text: changed.join("\n") + "\n" }
}
