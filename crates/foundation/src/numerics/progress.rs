//! How a long computation tells that it is alive, without knowing who listens.

/// Receives the advance of a computation; called from several threads at once.
pub trait Progress: Sync {
    /// A stage of `total` units begins.
    fn start(&self, stage: &str, total: u64);

    /// `n` further units of the stage are done.
    fn advance(&self, n: u64);

    /// The stage is done.
    fn finish(&self);
}

/// Reports nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Silent;

impl Progress for Silent {
    fn start(&self, _: &str, _: u64) {}

    fn advance(&self, _: u64) {}

    fn finish(&self) {}
}
