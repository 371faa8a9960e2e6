//! Dates of measurements: what a measuring machine writes, made sortable. Knows no zone: it is the clock of the measuring room.

/// When a measurement began, by its date and the beginning of its time of day; the date alone where the time is none.
///
/// ```
/// use measured_files::inspection::measured_at;
/// let at = measured_at("13.10.25", Some("08:21:31   /   08:34:28"));
/// assert_eq!(at.as_deref(), Some("2025-10-13T08:21:31"));
/// ```
pub fn measured_at(date: &str, time: Option<&str>) -> Option<String> {
    let begun = time.and_then(|time| time.split('/').next()).unwrap_or_default();
    sortable_date(&format!("{date} {}", begun.trim())).or_else(|| sortable_date(date))
}

/// A date, perhaps with a time, as `YYYY-MM-DD` or `YYYY-MM-DDTHH:MM:SS`, which sort as texts. Takes day, month and year with points (`13.10.25` is 2025,
/// years from 80 on are of the 1900s), the form itself, and a time after a blank or `T`. `None` for anything else: a date that could
/// be read in two ways is not guessed at.
///
/// ```
/// use measured_files::inspection::sortable_date;
/// assert_eq!(sortable_date("13.10.25").as_deref(), Some("2025-10-13"));
/// assert_eq!(sortable_date("3.4.2024 08:21").as_deref(), Some("2024-04-03T08:21:00"));
/// assert_eq!(sortable_date("04/05/2024"), None);
/// ```
pub fn sortable_date(text: &str) -> Option<String> {
    let (day, time) = match text.trim().split_once([' ', 'T']) {
        Some((day, time)) => (day, Some(time.trim())),
        None => (text.trim(), None),
    };
    let day = if day.contains('.') {
        let mut parts = day.split('.');
        let (d, m, y) = (parts.next()?, parts.next()?, parts.next()?);
        if parts.next().is_some() || y.len() != 2 && y.len() != 4 {
            return None;
        }
        let year = match (number(y)?, y.len()) {
            (year, 4) => year,
            (year @ 80.., _) => 1900 + year,
            (year, _) => 2000 + year,
        };
        format!("{year:04}-{:02}-{:02}", number(m)?, number(d)?)
    } else {
        day.to_owned()
    };
    let whole = match time {
        None => day,
        Some(time) if time.len() == 5 => format!("{day}T{time}:00"),
        Some(time) => format!("{day}T{time}"),
    };
    is_sortable_date(&whole).then_some(whole)
}

/// Digits and nothing else, at most four.
fn number(text: &str) -> Option<u32> {
    ((1..=4).contains(&text.len()) && text.bytes().all(|b| b.is_ascii_digit())).then(|| text.parse().ok())?
}

/// What a sortable date has to look like, in words.
pub const SORTABLE_DATE: &str = "YYYY-MM-DD or YYYY-MM-DDTHH:MM:SS, e.g. 2026-03-14T09:30:00";

/// Whether a text has the form of [`SORTABLE_DATE`] and names a day of the calendar.
pub fn is_sortable_date(text: &str) -> bool {
    let (day, time) = match text.split_once('T') {
        Some((day, time)) => (day, Some(time)),
        None => (text, None),
    };
    let fields = |text: &str, mark: u8, lengths: [usize; 3]| -> Option<[u32; 3]> {
        let total: usize = lengths.iter().sum::<usize>() + 2;
        let bytes = text.as_bytes();
        if bytes.len() != total || bytes[lengths[0]] != mark || bytes[lengths[0] + lengths[1] + 1] != mark {
            return None;
        }
        let second = lengths[0] + 1;
        let third = second + lengths[1] + 1;
        Some([
            number(text.get(..lengths[0])?)?,
            number(text.get(second..third - 1)?)?,
            number(text.get(third..)?)?,
        ])
    };
    let Some([year, month, day]) = fields(day, b'-', [4, 2, 2]) else { return false };
    let leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    let days = match month {
        2 => 28 + u32::from(leap),
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => return false,
    };
    (1..=days).contains(&day)
        && time.is_none_or(|time| {
            fields(time, b':', [2, 2, 2])
                .is_some_and(|[hour, minute, second]| hour < 24 && minute < 60 && second < 60)
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_of_machines_become_sortable() {
        for (text, date) in [
            ("13.10.25", Some("2025-10-13")),
            (" 01.02.1999 ", Some("1999-02-01")),
            ("1.2.99", Some("1999-02-01")),
            ("29.02.24", Some("2024-02-29")),
            ("13.10.25 08:21:31", Some("2025-10-13T08:21:31")),
            ("2025-10-13T08:21", Some("2025-10-13T08:21:00")),
            ("2025-10-13", Some("2025-10-13")),
            ("29.02.25", None),
            ("31.04.2025", None),
            ("13.10.025", None),
            ("13.10", None),
            ("13.10.25.1", None),
            ("10/13/25", None),
            ("2025-13-10", None),
            ("2025-10-13T24:00:00", None),
            ("2025-10-13T08:21:31Z", None),
            ("+2.3.2024", None),
            ("", None),
            ("µ.µ.2024", None),
        ] {
            assert_eq!(sortable_date(text).as_deref(), date, "{text}");
        }
    }

    #[test]
    fn the_time_is_that_of_the_beginning() {
        assert_eq!(
            measured_at("13.10.25", Some("08:21:31 / 08:34:28")).as_deref(),
            Some("2025-10-13T08:21:31")
        );
        assert_eq!(measured_at("13.10.25", Some("morning")).as_deref(), Some("2025-10-13"));
        assert_eq!(measured_at("13.10.25", None).as_deref(), Some("2025-10-13"));
        assert_eq!(measured_at("13/10/25", Some("08:21:31")), None);
    }

    #[test]
    fn the_form_is_exact() {
        for text in ["2025-10-13", "0000-01-01", "2000-02-29", "2025-10-13T00:00:59"] {
            assert!(is_sortable_date(text), "{text}");
        }
        for text in [
            "2025-10-13 08:21:31",
            "2025-1-13",
            "2025-10-1300",
            "1900-02-29",
            "2025-10-13T",
            "2025-00-10",
            "2025_10_13",
            "20µ-10-13",
        ] {
            assert!(!is_sortable_date(text), "{text}");
        }
    }
}
