//! Which programs of a run are written, and what their first lines say of its verdict.

use nc::{Dialect, cl_with_notes, netlist_with_notes, with_notes};
use verdict::{Remark, Status, Verdict};

/// Sentences that every written program carries; none where the run's programs stay unwritten.
pub struct Release(Option<Vec<String>>);

impl Release {
    /// Programs of an accepted run are written, those of another one only where the job asks for them by `output.programs_of_missed`.
    pub fn of(verdict: &Verdict, programs_of_missed: bool) -> Self {
        if !verdict.is_accepted() && !programs_of_missed {
            return Self(None);
        }
        let mut notes = vec![match (verdict.status(), verdict.reason()) {
            (Status::Met, _) => "target met".to_owned(),
            (status, Some(reason)) => format!("{}: {}", status.words(), reason.text),
            (status, None) => status.words().to_owned(),
        }];
        let named = |names: Vec<&str>| names.join(", ");
        let judged = named(verdict.judged().iter().map(|one| one.item.as_str()).collect());
        if !judged.is_empty() {
            notes.push(format!("judged: {judged}"));
        }
        let left = named(verdict.not_judged().iter().map(|one| one.item.as_str()).collect());
        if !left.is_empty() {
            notes.push(format!("outside the verdict: {left}"));
        }
        Self(Some(notes))
    }

    /// A program as it is written.
    pub fn program(&self, text: &str, dialect: Dialect) -> Option<Vec<u8>> {
        self.0.as_ref().map(|notes| with_notes(text, dialect, notes).into_bytes())
    }

    /// A HAL netlist as it is written.
    pub fn netlist(&self, text: &str) -> Option<Vec<u8>> {
        self.0.as_ref().map(|notes| netlist_with_notes(text, notes).into_bytes())
    }

    /// Cutter locations as they are written.
    pub fn cutter_locations(&self, text: &str) -> Option<Vec<u8>> {
        self.0.as_ref().map(|notes| cl_with_notes(text, notes).into_bytes())
    }

    /// Says that the programs of a run stay unwritten, and why.
    pub fn remark(&self, verdict: &Verdict) -> Option<Remark> {
        if self.0.is_some() {
            return None;
        }
        Some(Remark::new(
            "programs-not-written",
            format!("no NC programs are written: the target is {}", verdict.status().words()),
            "mend what the verdict names, or set output.programs_of_missed = true: their first lines say it then",
        ))
    }
}
