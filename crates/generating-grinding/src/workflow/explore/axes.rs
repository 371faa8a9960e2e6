//! What the chart of a study shows: an abscissa, and a line for each combination of what else varies. Knows no process.

use report::charts::format_significant;

/// What may vary in a study: its key, title as an axis, name in those of lines, and value of a candidate, if it has one.
pub type Varied<C> = (&'static str, &'static str, &'static str, fn(&C) -> Option<f64>);

/// Axis and lines of a chart.
pub struct Axes<C> {
    /// Title of the abscissa.
    pub title: &'static str,
    x: fn(&C) -> Option<f64>,
    others: Vec<Varied<C>>,
}

/// A line of the chart: its name and its points.
pub type Line<P> = (String, Vec<P>);

impl<C> Axes<C> {
    /// The first one of all that varies is the abscissa, or the first one where none does.
    pub fn of(all: &[Varied<C>], varied: &[&str]) -> Option<Self> {
        let mut varying = all.iter().filter(|(key, ..)| varied.contains(key));
        let &(_, title, _, x) = varying.next().or(all.first())?;
        Some(Self { title, x, others: varying.copied().collect() })
    }

    /// The name of a candidate's line: the values of what else varies, in `unit`; `alone` where nothing does.
    fn name(&self, c: &C, (unit, alone): (&str, &str)) -> String {
        let parts = self.others.iter().map(|(_, _, name, value)| {
            format!("{name} {}{unit}", value(c).map_or("–".into(), |v| format_significant(v, 5)))
        });
        let parts: Vec<String> = parts.collect();
        if parts.is_empty() { alone.to_owned() } else { parts.join(", ") }
    }

    /// At most `most` lines, those of the first candidates, by their names, and whether others are left out. `point` is a candidate's point at
    /// its abscissa; `None` where it has none.
    pub fn lines<P>(
        &self,
        candidates: &[C],
        most: usize,
        names: (&str, &str),
        point: impl Fn(&C, f64) -> Option<P>,
    ) -> (Vec<Line<P>>, bool) {
        let mut lines: Vec<Line<P>> = Vec::new();
        let mut left_out = false;
        for c in candidates {
            let Some(point) = (self.x)(c).and_then(|x| point(c, x)) else { continue };
            let name = self.name(c, names);
            match lines.iter().position(|(known, _)| *known == name) {
                Some(line) => lines[line].1.push(point),
                None if lines.len() < most => lines.push((name, vec![point])),
                None => left_out = true,
            }
        }
        (lines, left_out)
    }
}
