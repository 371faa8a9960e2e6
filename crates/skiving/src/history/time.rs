//! Date and time as RFC 3339 writes them, e.g. `2026-03-14T09:30:00.5+01:00`. The libraries at hand read no offsets (`humantime`) or also
//! what is no moment (`toml_datetime`).

/// A moment: seconds from 1970 and nanoseconds. A leap second counts as the one after it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Moment {
    seconds: i64,
    nanoseconds: u32,
}

/// What a time has to look like, in words.
pub(crate) const FORM: &str = "date and time with zone (RFC 3339), e.g. 2026-03-14T09:30:00Z";

impl Moment {
    /// The moment of a text; `None` if it is none, or finer than nanoseconds.
    pub fn parse(text: &str) -> Option<Self> {
        let bytes = text.as_bytes();
        let number = |from: usize, to: usize| -> Option<i64> {
            let digits = text.get(from..to).filter(|digits| digits.bytes().all(|b| b.is_ascii_digit()))?;
            digits.parse().ok()
        };
        let mark = |at: usize, marks: &[u8]| bytes.get(at).is_some_and(|b| marks.contains(b)).then_some(());
        let (year, month, day) = (number(0, 4)?, number(5, 7)?, number(8, 10)?);
        let (hour, minute, second) = (number(11, 13)?, number(14, 16)?, number(17, 19)?);
        for (at, marks) in [(4, "-"), (7, "-"), (10, "Tt"), (13, ":"), (16, ":")] {
            mark(at, marks.as_bytes())?;
        }
        let mut at = 19;
        let mut nanoseconds = 0;
        if mark(at, b".").is_some() {
            let digits = bytes[at + 1..].iter().take_while(|b| b.is_ascii_digit()).count();
            if !(1..=9).contains(&digits) {
                return None;
            }
            nanoseconds =
                u32::try_from(number(at + 1, at + 1 + digits)?).ok()? * 10u32.pow(9 - digits as u32);
            at += 1 + digits;
        }
        let offset = if mark(at, b"Zz").is_some() {
            at += 1;
            0
        } else {
            mark(at, b"+-")?;
            mark(at + 3, b":")?;
            let (hours, minutes) = (number(at + 1, at + 3)?, number(at + 4, at + 6)?);
            let sense = if bytes[at] == b'-' { -1 } else { 1 };
            at += 6;
            (hours < 24 && minutes < 60).then_some(sense * 60 * (60 * hours + minutes))?
        };
        let valid = at == bytes.len()
            && (1..=12).contains(&month)
            && (1..=days_of(year, month)).contains(&day)
            && hour < 24
            && minute < 60
            && second <= 60;
        let seconds = 86_400 * days(year, month, day) + 3600 * hour + 60 * minute + second - offset;
        valid.then_some(Self { seconds, nanoseconds })
    }
}

fn leap(year: i64) -> bool {
    year % 4 == 0 && (year % 100 != 0 || year % 400 == 0)
}

fn days_of(year: i64, month: i64) -> i64 {
    match month {
        2 => 28 + i64::from(leap(year)),
        4 | 6 | 9 | 11 => 30,
        _ => 31,
    }
}

/// Days from 1970-01-01.
fn days(year: i64, month: i64, day: i64) -> i64 {
    let years = |year: i64| 365 * year + year.div_euclid(4) - year.div_euclid(100) + year.div_euclid(400);
    let before: i64 = (1..month).map(|month| days_of(year, month)).sum();
    years(year - 1) - years(1969) + before + day - 1
}

/// Whether a text is a date and time with its zone.
pub(crate) fn is_moment(text: &str) -> bool {
    Moment::parse(text).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seconds(text: &str) -> i64 {
        Moment::parse(text).unwrap_or_else(|| panic!("{text}")).seconds
    }

    #[test]
    fn moments_are_those_of_the_calendar() {
        // As `date -d ... +%s` gives them.
        assert_eq!(seconds("1970-01-01T00:00:00Z"), 0);
        assert_eq!(seconds("2000-02-29T12:34:56Z"), 951_827_696);
        assert_eq!(seconds("2026-03-14T09:30:00Z"), 1_773_480_600);
        assert_eq!(seconds("1969-12-31T23:59:59Z"), -1);
        assert_eq!(seconds("2026-03-14t10:30:00+01:00"), 1_773_480_600);
        assert_eq!(seconds("2026-03-14T05:00:00.25-04:30"), 1_773_480_600);
        assert_eq!(seconds("2016-12-31T23:59:60Z"), seconds("2017-01-01T00:00:00Z"));
    }

    #[test]
    fn moments_are_in_order() {
        let texts = [
            "2026-03-14T09:30:00Z",
            "2026-03-14T09:30:00.000000001Z",
            "2026-03-14T09:30:00.5Z",
            "2026-03-14T09:29:59-00:01",
        ];
        assert!(texts.map(|text| Moment::parse(text).unwrap()).is_sorted());
        assert_eq!(Moment::parse("2026-03-14T09:30:00.50Z"), Moment::parse("2026-03-14T09:30:00.5z"));
    }

    #[test]
    fn what_is_no_moment_is_none() {
        for text in [
            "",
            "2026-03-14",
            "2026-03-14T09:30:00",
            "2026-03-14 09:30:00Z",
            "2026-3-14T09:30:00Z",
            "2026-02-29T09:30:00Z",
            "2100-02-29T09:30:00Z",
            "2026-04-31T09:30:00Z",
            "2026-13-01T09:30:00Z",
            "2026-00-01T09:30:00Z",
            "2026-03-00T09:30:00Z",
            "2026-03-14T24:00:00Z",
            "2026-03-14T09:60:00Z",
            "2026-03-14T09:30:61Z",
            "2026-03-14T09:30:00.Z",
            "2026-03-14T09:30:00.1234567890Z",
            "2026-03-14T09:30:00Zz",
            "2026-03-14T09:30:00+24:00",
            "2026-03-14T09:30:00+01",
            "2026-03-14T09:30:00+0100",
            "+026-03-14T09:30:00Z",
            "2026-03-14T09:30:00µ",
            "２026-03-14T09:30Z",
        ] {
            assert_eq!(Moment::parse(text), None, "{text}");
        }
    }
}
