//! All lines of a flank on all threads, laid out for a machine.

use super::work::LineWork;
use crate::workflow::programs::indexing::Indexing;
use crate::workflow::programs::technology::Technology;
use machine::Machine;
use motion::{AxisWords, Layout, LayoutOptions, LineCourse, LinePass, MotionError, in_words, lay_out_lines};

/// A line by its number.
type LineOf<'a> = Box<dyn Fn(usize) -> Result<LineCourse, MotionError> + Sync + 'a>;

impl LineWork<'_> {
    /// Every line on every active thread: thread after thread, on each the passes that leave stock and then the finishing one.
    ///
    /// # Errors
    /// [`MotionError`].
    pub fn lay_out(
        &self,
        machine: &Machine,
        words: &AxisWords,
        (indexing, technology): (&Indexing, &Technology),
        options: &LayoutOptions,
    ) -> Result<Layout, MotionError> {
        let mut lines: Vec<(String, LineOf<'_>)> = Vec::new();
        for &thread in &indexing.active {
            for stock in technology.dressing_stock.iter().copied().chain([0.0]) {
                let mut name = self.on_thread(thread, indexing);
                if stock > 0.0 {
                    name = format!("{name} STOCK {}", in_words(stock * 1e3, "um"));
                }
                let of = (thread, indexing.threads);
                lines.push((name, Box::new(move |line| self.course(line, of, stock, technology))));
            }
        }
        let passes: Vec<LinePass<'_>> = lines
            .iter()
            .map(|(name, line)| LinePass {
                name: name.clone(),
                count: self.count(),
                line: line.as_ref(),
                screw: self.written.bodies.screw,
                speed: self.speed(technology),
                hop: self.hop(technology),
                clearance: self.lift(technology),
            })
            .collect();
        lay_out_lines(machine, words, &passes, options)
    }
}
