//! Rules that find a special cause in the course of the parts: Western Electric (Statistical Quality Control Handbook, 1956) and Nelson
//! (The Shewhart control chart: tests for special causes, Journal of Quality Technology 16, 1984).

use super::ControlLimits;

/// Parts on one side of the mean that are no chance (Nelson, test 2).
const ONE_SIDE: usize = 9;
/// Parts in a row that rise or fall steadily (Nelson, test 3).
const STEADY: usize = 6;

/// A rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum RunRule {
    /// A part beyond 3 sigma_MR.
    BeyondThreeSigma,
    /// Two of three parts in a row beyond 2 sigma_MR on the same side.
    TwoOfThreeBeyondTwoSigma,
    /// Nine or more parts in a row on one side of the mean: the level has shifted.
    OneSide,
    /// Six or more parts in a row that rise or fall steadily.
    SteadyRun,
}

impl RunRule {
    /// Stable word.
    pub fn code(self) -> &'static str {
        match self {
            Self::BeyondThreeSigma => "beyond-three-sigma",
            Self::TwoOfThreeBeyondTwoSigma => "two-of-three-beyond-two-sigma",
            Self::OneSide => "one-side",
            Self::SteadyRun => "steady-run",
        }
    }

    /// What it says, with its source.
    pub fn words(self) -> &'static str {
        match self {
            Self::BeyondThreeSigma => {
                "beyond 3 sigma of the moving range: something was different with this part (Shewhart; Western Electric rule 1)"
            }
            Self::TwoOfThreeBeyondTwoSigma => {
                "two of three parts in a row beyond 2 sigma on one side: the level has probably shifted (Western Electric rule 2)"
            }
            Self::OneSide => {
                "nine or more parts in a row on one side of the mean: the level has shifted (Nelson test 2)"
            }
            Self::SteadyRun => "six or more parts in a row rise or fall steadily: a drift (Nelson test 3)",
        }
    }
}

/// A stretch of parts that a rule has found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RuleFinding {
    /// The rule.
    pub rule: RunRule,
    /// Numbers, from 0, of the first and the last part of the stretch.
    pub parts: [usize; 2],
}

/// Everything that the rules find, by rule, then by part. Nothing where all parts are equal.
pub(super) fn findings(values: &[f64], limits: &ControlLimits) -> Vec<RuleFinding> {
    if limits.sigma == 0.0 {
        return Vec::new();
    }
    let mut found = Vec::new();
    // Stretches of one rule that overlap are one.
    let mut add = |rule, from, to| match found.last_mut() {
        Some(RuleFinding { rule: known, parts }) if *known == rule && parts[1] >= from => parts[1] = to,
        _ => found.push(RuleFinding { rule, parts: [from, to] }),
    };
    let distance: Vec<f64> = values.iter().map(|value| (value - limits.centre) / limits.sigma).collect();
    for (part, d) in distance.iter().enumerate() {
        if d.abs() > 3.0 {
            add(RunRule::BeyondThreeSigma, part, part);
        }
    }
    for (from, three) in distance.windows(3).enumerate() {
        let beyond = |sign: f64| three.iter().filter(|d| sign * **d > 2.0).count();
        // The third part closes the pair: a stretch ends with a part beyond.
        if three[2].abs() > 2.0 && beyond(three[2].signum()) >= 2 {
            add(RunRule::TwoOfThreeBeyondTwoSigma, from, from + 2);
        }
    }
    for [from, to] in stretches(&distance.iter().map(|d| sign(*d)).collect::<Vec<i8>>()) {
        if to - from + 1 >= ONE_SIDE {
            add(RunRule::OneSide, from, to);
        }
    }
    let steps: Vec<i8> = values.windows(2).map(|pair| sign(pair[1] - pair[0])).collect();
    for [from, to] in stretches(&steps) {
        // A stretch of steps has one part more than steps.
        if to - from + 2 >= STEADY {
            add(RunRule::SteadyRun, from, to + 1);
        }
    }
    found
}

fn sign(x: f64) -> i8 {
    i8::from(x > 0.0) - i8::from(x < 0.0)
}

/// First and last place of every stretch of equal signs other than 0.
fn stretches(signs: &[i8]) -> Vec<[usize; 2]> {
    let mut found: Vec<[usize; 2]> = Vec::new();
    for (place, sign) in signs.iter().enumerate().filter(|(_, sign)| **sign != 0) {
        match found.last_mut() {
            Some([_, to]) if *to + 1 == place && signs[*to] == *sign => *to = place,
            _ => found.push([place, place]),
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(values: &[f64]) -> Vec<(RunRule, [usize; 2])> {
        let limits =
            ControlLimits { centre: 0.0, sigma: 1.0, mean_moving_range: 1.1, moving_range_upper: 3.7 };
        findings(values, &limits).into_iter().map(|found| (found.rule, found.parts)).collect()
    }

    #[test]
    fn each_rule_begins_where_its_source_says() {
        assert_eq!(of(&[0.1, 3.1, -0.1, -3.01, 3.0, 0.0]).len(), 2);
        assert_eq!(of(&[0.1, 3.1, -0.1])[0], (RunRule::BeyondThreeSigma, [1, 1]));
        let side = |n: usize| of(&(0..n).map(|k| 0.5 + 0.1 * (k % 2) as f64).collect::<Vec<f64>>());
        assert_eq!(side(8), []);
        assert_eq!(side(9), [(RunRule::OneSide, [0, 8])]);
        assert_eq!(side(14), [(RunRule::OneSide, [0, 13])]);
        let rise = |n: usize| of(&(0..n).map(|k| 0.3 * k as f64 - 0.6).collect::<Vec<f64>>());
        assert_eq!(rise(5), []);
        assert_eq!(rise(6), [(RunRule::SteadyRun, [0, 5])]);
        assert_eq!(of(&[2.1, 0.0, 2.2]), [(RunRule::TwoOfThreeBeyondTwoSigma, [0, 2])]);
        assert_eq!(of(&[2.1, 0.0, 2.2, 2.3, 0.0]), [(RunRule::TwoOfThreeBeyondTwoSigma, [0, 3])]);
        assert_eq!(of(&[2.1, 0.0, -2.2]), []);
        assert_eq!(of(&[2.1, 0.0, 0.0, 2.2]), []);
    }

    #[test]
    fn equal_parts_show_nothing() {
        let limits =
            ControlLimits { centre: 1.0, sigma: 0.0, mean_moving_range: 0.0, moving_range_upper: 0.0 };
        assert_eq!(findings(&[1.0; 40], &limits), []);
    }
}
