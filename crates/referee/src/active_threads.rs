//! Which threads of the worm cut, and which tooth spaces they meet (`docs/mathematics/planning.md#choice-of-the-ratio`). Counting only:
//! knows no shape.

use super::{RemovalError, error};

/// The threads that are left on the worm, and the strokes between which the workpiece is indexed.
///
/// Thread 0 is the one that meets tooth space 0 (centred on +y at z = 0, where the rays stand) when the rotations fulfil
/// z_1 phi_1 + z_2 phi_2 = k_0F + k_V1 z_V1 + k_V2 z_V2 without whole turns added; threads are numbered in the positive
/// sense of rotation about the worm's axis, so that tooth space j meets thread j in the same turn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ActiveThreads<'a> {
    /// Every thread, one stroke.
    #[default]
    All,
    /// Some of them.
    Only {
        /// Numbers of the threads that cut, 0 to z_1 - 1.
        threads: &'a [u32],
        /// Index offsets o of the strokes in pitches of the workpiece: in that stroke space j meets thread j - o.
        strokes: &'a [u32],
    },
}

/// For every thread that the coupling pairs with tooth space 0: whether it stands for a cut in some stroke.
pub(super) struct ThreadRule {
    serves: Vec<bool>,
    teeth: i64,
}

impl ThreadRule {
    /// The rule for z_1 threads and z_2 teeth; `None` where every thread cuts.
    pub fn new(active: ActiveThreads<'_>, threads: f64, teeth: f64) -> Result<Option<Self>, RemovalError> {
        let ActiveThreads::Only { threads: kept, strokes } = active else { return Ok(None) };
        error::positive("number of threads", threads)?;
        error::positive("number of teeth", teeth)?;
        let count = threads.round() as i64;
        if kept.is_empty() {
            return Err(RemovalError::NoActiveThread { threads: count });
        }
        if let Some(&beyond) = kept.iter().find(|&&a| i64::from(a) >= count) {
            return Err(RemovalError::InvalidNumber {
                field: "active thread",
                value: f64::from(beyond),
                allowed: "0 up to the number of threads less one",
            });
        }
        if strokes.is_empty() {
            return Err(RemovalError::InvalidNumber {
                field: "number of index strokes",
                value: 0.0,
                allowed: "at least one; offset 0 is the stroke without indexing",
            });
        }
        let mut serves = vec![false; count as usize];
        for &a in kept {
            for &o in strokes {
                serves[((i64::from(a) + i64::from(o)) % count) as usize] = true;
            }
        }
        Ok(Some(Self { serves, teeth: teeth.round() as i64 }))
    }

    /// Whether the pass `turn` whole turns of the workpiece after the one with thread `first` cuts.
    pub fn cuts(&self, first: i64, turn: f64) -> bool {
        let count = self.serves.len() as i64;
        // Turns are whole numbers far below 2^53.
        let passed = (turn as i64).rem_euclid(count) * self.teeth.rem_euclid(count);
        self.serves[(first + passed).rem_euclid(count) as usize]
    }

    /// Turns after which the same threads come back: z_1/gcd(z_1, z_2) divides this.
    pub fn period(&self) -> usize {
        self.serves.len()
    }

    /// Whether any turn cuts.
    pub fn ever_cuts(&self, first: i64) -> bool {
        (0..self.period()).any(|turn| self.cuts(first, turn as f64))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn only<'a>(threads: &'a [u32], strokes: &'a [u32]) -> ActiveThreads<'a> {
        ActiveThreads::Only { threads, strokes }
    }

    #[test]
    fn odd_teeth_meet_both_threads_in_turn() {
        let rule = ThreadRule::new(only(&[0], &[0]), 2.0, 19.0).unwrap().unwrap();
        let cuts: Vec<bool> = (-2..4).map(|k| rule.cuts(0, f64::from(k))).collect();
        assert_eq!(cuts, [true, false, true, false, true, false]);
        assert!(rule.ever_cuts(0) && rule.ever_cuts(1));
    }

    #[test]
    fn even_teeth_need_a_second_stroke() {
        let once = ThreadRule::new(only(&[0], &[0]), 2.0, 20.0).unwrap().unwrap();
        assert!(once.ever_cuts(0) && !once.ever_cuts(1) && once.cuts(0, 7.0));
        let twice = ThreadRule::new(only(&[0], &[0, 1]), 2.0, 20.0).unwrap().unwrap();
        assert!(twice.ever_cuts(0) && twice.ever_cuts(1));
    }

    #[test]
    fn common_divisors_decide() {
        // gcd(6, 20) = 2: a space meets every second thread.
        let rule = ThreadRule::new(only(&[1, 4], &[0]), 6.0, 20.0).unwrap().unwrap();
        assert!(rule.ever_cuts(0) && rule.ever_cuts(3));
        let rule = ThreadRule::new(only(&[1], &[0]), 6.0, 20.0).unwrap().unwrap();
        assert!(!rule.ever_cuts(0) && rule.ever_cuts(3) && rule.ever_cuts(-1));
    }
}
