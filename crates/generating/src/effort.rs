//! How long planning looks for a better plan.

/// What planning spends on a target that is hard to meet.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Effort {
    /// Whatever may help: further ratios, narrower limits, the nearest miss, and how near any flank could come.
    #[default]
    Full,
    /// One good way, for a plan that is tried beside others: where it misses, another plan may do better.
    Trial,
    /// The nearest plan whose command stays within so many tolerances, for a target whose nearer plans the simulation does not carry out.
    Further(f64),
}

impl Effort {
    /// Tolerances within which a command stays where none within one can be carried out, one after the other.
    pub const FURTHER: [f64; 4] = [3.0, 10.0, 30.0, 100.0];

    /// Rounds of a best fit after which no further ratio or limit is tried: where a plan keeps to the tolerance on the grid though it may fold
    /// beside it, and where there is none.
    pub(super) fn rounds(self) -> [usize; 2] {
        match self {
            Self::Full | Self::Further(_) => [60, 400],
            Self::Trial => [30, 30],
        }
    }
}
