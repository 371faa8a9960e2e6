//! Words of the tables for values of the library.

use flankwright::geometry::Flank;

/// The word of a flank.
pub(crate) fn flank_word(flank: Flank) -> &'static str {
    match flank {
        Flank::Left => "left",
        Flank::Right => "right",
    }
}

/// The flank of a word; the tables admit no other than the two.
pub(crate) fn flank_of(word: &str) -> Flank {
    if word == "left" { Flank::Left } else { Flank::Right }
}
