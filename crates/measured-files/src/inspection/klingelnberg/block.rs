//! The heading of a curve: `Zahn-Nr.: 1k /Flankenlinie:3 rechts / 480  Werte  x= 10.263`, in both dialects.

use super::number::number;
use crate::inspection::TraceKind;
use foundation::geometry::Flank;

/// A section of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Heading {
    /// Helix traces.
    Helix,
    /// Profiles.
    Profile,
    /// Both, for the twist.
    Twist,
}

/// What a heading states about its curve.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct BlockHead {
    pub tooth: u32,
    pub tag: String,
    /// The word behind the slash.
    pub stated: Option<TraceKind>,
    pub flank: Flank,
    pub samples: usize,
    /// `x=` of a helix, `z=` of a profile.
    pub axis: TraceKind,
    pub position: f64,
}

impl BlockHead {
    /// Profile or helix: the word behind the slash, else the tag, else the section, else the letter of the axis.
    pub fn kind(&self, section: Option<Heading>) -> TraceKind {
        let of_tag = match self.tag.as_str() {
            "k" | "f" => Some(TraceKind::Helix),
            "u" | "o" => Some(TraceKind::Profile),
            _ => None,
        };
        let of_section = match section {
            Some(Heading::Helix) => Some(TraceKind::Helix),
            Some(Heading::Profile) => Some(TraceKind::Profile),
            Some(Heading::Twist) | None => None,
        };
        self.stated.or(of_tag).or(of_section).unwrap_or(self.axis)
    }
}

/// A line that begins a section, and what stands behind its colon.
pub(super) fn section(line: &str) -> Option<(Heading, &str)> {
    let (word, rest) = line.trim().split_once(':')?;
    let heading = match word.trim_end() {
        "Flankenlinie" => Heading::Helix,
        "Profil" => Heading::Profile,
        // Whatever became of the umlaut.
        word => {
            let middle = word.strip_prefix("Verschr")?.strip_suffix("nkung")?;
            (middle.chars().count() <= 2).then_some(Heading::Twist)?
        }
    };
    Some((heading, rest.trim()))
}

/// The heading of a curve.
pub(super) fn block_head(line: &str) -> Option<BlockHead> {
    let rest = line.trim().strip_prefix("Zahn-Nr.:")?.trim_start();
    let (tooth, rest) = take_count(rest)?;
    let letters = rest.chars().take_while(|c| c.is_ascii_lowercase()).count();
    // `links` may follow the number without a blank: then the letters are no tag.
    let tag = if ["links", "rechts"].contains(&&rest[..letters]) { "" } else { &rest[..letters] };
    let mut rest = rest[tag.len()..].trim_start();
    let mut stated = None;
    if let Some(behind) = rest.strip_prefix('/') {
        let (word, behind) = behind.split_once(':')?;
        stated = Some(match word.trim() {
            "Flankenlinie" => TraceKind::Helix,
            "Profil" => TraceKind::Profile,
            _ => return None,
        });
        rest = take_count(behind.trim_start())?.1.trim_start();
    }
    let (flank, rest) = match (rest.strip_prefix("links"), rest.strip_prefix("rechts")) {
        (Some(rest), _) => (Flank::Left, rest),
        (_, Some(rest)) => (Flank::Right, rest),
        _ => return None,
    };
    let (samples, rest) = take_count(rest.trim_start().strip_prefix('/')?.trim_start())?;
    let rest = rest.trim_start().strip_prefix("Werte")?.trim_start();
    let rest = rest.strip_prefix('/').unwrap_or(rest).trim_start();
    let (letter, position) = rest.split_once('=')?;
    let axis = match letter.trim_end() {
        "x" => TraceKind::Helix,
        "z" => TraceKind::Profile,
        _ => return None,
    };
    Some(BlockHead {
        tooth,
        tag: tag.to_owned(),
        stated,
        flank,
        samples: samples as usize,
        axis,
        position: number(position.trim())?,
    })
}

/// A whole number at the beginning and what follows it.
fn take_count(text: &str) -> Option<(u32, &str)> {
    let digits = text.bytes().take_while(u8::is_ascii_digit).count();
    Some((text[..digits].parse().ok()?, &text[digits..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_of_both_dialects() {
        let head = block_head("Zahn-Nr.: 18 links / 480  Werte  x= 8.953").unwrap();
        assert_eq!((head.tooth, head.tag.as_str(), head.flank, head.samples), (18, "", Flank::Left, 480));
        assert_eq!((head.axis, head.position), (TraceKind::Helix, 8.953));
        let older = block_head("Zahn-Nr.: 1a links / 915 Werte  / z= 21").unwrap();
        assert_eq!((older.tag.as_str(), older.samples, older.position), ("a", 915, 21.0));
        let twist = block_head("Zahn-Nr.: 1k /Flankenlinie:3 rechts / 3  Werte  x= 10.263").unwrap();
        assert_eq!(twist.kind(Some(Heading::Twist)), TraceKind::Helix);
        assert_eq!(block_head("Zahn-Nr.: 5links/2Werte z=.5").unwrap().position, 0.5);
        let tagged = |tag| block_head(&format!("Zahn-Nr.: 1{tag} links / 3 Werte z= 2")).unwrap();
        assert_eq!(tagged("u").kind(Some(Heading::Twist)), TraceKind::Profile);
        assert_eq!(tagged("f").kind(Some(Heading::Twist)), TraceKind::Helix);
        assert_eq!(tagged("").kind(None), TraceKind::Profile);
    }

    #[test]
    fn other_lines_are_no_headings() {
        for line in [
            "Zahn-Nr.          fp           Fp           Fr",
            "Zahn-Nr.: links / 480 Werte x= 1",
            "Zahn-Nr.: 1 oben / 480 Werte x= 1",
            "Zahn-Nr.: 1 links / 480 Werte y= 1",
            "Zahn-Nr.: 1 links / 480 Werte x= 1,5",
            "Zahn-Nr.: 1 links / -4 Werte x= 1",
            "Zahn-Nr.: 99999999999 links / 4 Werte x= 1",
            "Zahn-Nr.: 1ä links / 4 Werte x= 1",
        ] {
            assert_eq!(block_head(line), None, "{line}");
        }
    }

    #[test]
    fn sections_survive_a_lost_umlaut() {
        for line in ["Verschränkung: x", "Verschr?nkung: x", "Verschr\u{fffd}nkung: x", "Verschraenkung: x"]
        {
            assert_eq!(section(line), Some((Heading::Twist, "x")), "{line}");
        }
        assert_eq!(section("Profil:"), Some((Heading::Profile, "")));
        assert_eq!(section("Flankenlinie:  "), Some((Heading::Helix, "")));
        assert_eq!(section("Profilverschiebung: 1"), None);
    }
}
