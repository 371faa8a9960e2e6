//! The verdict of a run: what was judged, what was not, and whether the target is met. A status is made here and nowhere else,
//! so that command, report, web application, Python and NC programs say the same.
//!
//! A run lists its items one by one; [`Verdict::status`] follows from the list:
//!
//! ```
//! use verdict::{Remark, Status, Verdict};
//! let mut verdict = Verdict::new();
//! assert_eq!((verdict.status(), verdict.is_accepted()), (Status::NotJudged, true)); // nothing was asked
//! verdict.met("left flank", "0.31 of 1 um");
//! verdict.leave("right flank", "the job does not grind it");
//! assert_eq!(verdict.status(), Status::Met);
//! verdict.owe("root", Remark::new("root-not-judged", "the root was not simulated", "give simulation.rays_length"));
//! assert_eq!((verdict.status(), verdict.is_accepted()), (Status::NotJudged, false)); // asked for, not judged
//! verdict.missed("hub", "0.18 mm too deep", Remark::new("hub-gouged", "the cutter enters the hub", "raise active_height"));
//! assert_eq!(verdict.status(), Status::Missed);
//! assert_eq!(verdict.reason().unwrap().code, "hub-gouged");
//! ```

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Serialize, Serializer};
use std::borrow::Cow;

/// Whether a target is met.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// Everything that was asked for was judged and is within its tolerance.
    Met,
    /// At least one item is outside its tolerance.
    Missed,
    /// Nothing was asked for, or not everything that was asked for was judged.
    NotJudged,
}

impl Status {
    /// The status in words, the same for every reader.
    pub fn words(self) -> &'static str {
        match self {
            Self::Met => "met",
            Self::Missed => "missed",
            Self::NotJudged => "not judged",
        }
    }
}

/// Plan and simulation may differ by this share of the tolerance; beyond it one of them is wrong, and nothing says which.
const AGREEMENT: f64 = 0.1;

/// Whether plan and simulation that differ by so much agree, both in the unit of the tolerance.
pub fn agree(difference: f64, tolerance: f64) -> bool {
    difference <= AGREEMENT * tolerance
}

/// A statement beside the numbers of a run: a warning, or the reason of a verdict.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Remark {
    /// Stable code.
    pub code: &'static str,
    /// What, with its numbers.
    pub text: String,
    /// What can be done about it.
    pub way_out: String,
}

impl Remark {
    /// A remark with its code, its statement and what helps.
    pub fn new(code: &'static str, text: impl Into<String>, way_out: impl Into<String>) -> Self {
        Self { code, text: text.into(), way_out: way_out.into() }
    }
}

/// An item that was judged.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct JudgedItem {
    /// What was judged: a flank, the threads of the worm, the root, the rapids of a program.
    pub item: String,
    /// [`Status::Met`] or [`Status::Missed`].
    pub status: Status,
    /// The figure that decided, or how it was judged.
    pub detail: String,
}

/// An item that was not judged.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct UnjudgedItem {
    /// What was not judged.
    pub item: String,
    /// Whether the job asks for it: then the target is not met.
    pub asked: bool,
    /// Why it was not judged.
    pub why: String,
}

/// What was judged and what was not. In documents it is the keys `status`, `accepted`, `reason` and `scope`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Verdict {
    judged: Vec<JudgedItem>,
    not_judged: Vec<UnjudgedItem>,
    missed: Vec<Remark>,
    owed: Vec<Remark>,
}

impl Verdict {
    /// A verdict on nothing yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Notes an item within its tolerance.
    pub fn met(&mut self, item: impl Into<String>, detail: impl Into<String>) {
        self.judged.push(JudgedItem { item: item.into(), status: Status::Met, detail: detail.into() });
    }

    /// Notes an item outside its tolerance, with the reason to tell if it is the first.
    pub fn missed(&mut self, item: impl Into<String>, detail: impl Into<String>, reason: Remark) {
        self.judged.push(JudgedItem { item: item.into(), status: Status::Missed, detail: detail.into() });
        self.missed.push(reason);
    }

    /// Notes an item that was judged: within its tolerance, or outside it with the reason that `reason` makes.
    pub fn judge(
        &mut self,
        item: impl Into<String>,
        met: bool,
        detail: impl Into<String>,
        reason: impl FnOnce() -> Remark,
    ) {
        if met { self.met(item, detail) } else { self.missed(item, detail, reason()) }
    }

    /// Notes an item that the job asks for and that was not judged. The target is not met then.
    pub fn owe(&mut self, item: impl Into<String>, reason: Remark) {
        self.not_judged.push(UnjudgedItem { item: item.into(), asked: true, why: reason.text.clone() });
        self.owed.push(reason);
    }

    /// Notes an item that the job does not ask for and that was not judged: a limit of the claim, not of the target.
    pub fn leave(&mut self, item: impl Into<String>, why: impl Into<String>) {
        self.not_judged.push(UnjudgedItem { item: item.into(), asked: false, why: why.into() });
    }

    /// Takes over the items of another verdict, behind its own.
    pub fn extend(&mut self, other: Verdict) {
        self.judged.extend(other.judged);
        self.not_judged.extend(other.not_judged);
        self.missed.extend(other.missed);
        self.owed.extend(other.owed);
    }

    /// Another way out for what is missed first, once more is known of it.
    pub fn advise(&mut self, way_out: impl Into<String>) {
        if let Some(reason) = self.missed.first_mut() {
            reason.way_out = way_out.into();
        }
    }

    /// Missed before not judged before met. Nothing judged is not judged.
    pub fn status(&self) -> Status {
        if !self.missed.is_empty() {
            Status::Missed
        } else if !self.owed.is_empty() || self.judged.is_empty() {
            Status::NotJudged
        } else {
            Status::Met
        }
    }

    /// Whether a command ends with exit status 0: the target is met, or nothing was asked for.
    pub fn is_accepted(&self) -> bool {
        self.missed.is_empty() && self.owed.is_empty()
    }

    /// Why the target is missed or was not judged; `None` where it is met or nothing was asked for.
    pub fn reason(&self) -> Option<&Remark> {
        self.missed.first().or(self.owed.first())
    }

    /// The items that were judged.
    pub fn judged(&self) -> &[JudgedItem] {
        &self.judged
    }

    /// The items that were not judged, asked for or not.
    pub fn not_judged(&self) -> &[UnjudgedItem] {
        &self.not_judged
    }

    /// The scope in one sentence: what was judged, then what was not.
    pub fn scope_in_words(&self) -> String {
        let judged = self.judged.iter().map(|one| one.item.as_str()).collect();
        let not = self.not_judged.iter().map(|one| one.item.as_str()).collect();
        scope(judged, not, |names| names.join(", "))
    }

    /// The same in short: the first few items, of those that were judged each group once.
    pub fn scope_in_short(&self) -> String {
        let judged = groups(self.judged.iter().map(|one| one.item.as_str()));
        let not = self.not_judged.iter().map(|one| one.item.as_str()).collect();
        scope(judged, not, |names| match names.get(..FEW) {
            Some(few) if names.len() > FEW => format!("{}; {} more", few.join(", "), names.len() - FEW),
            _ => names.join(", "),
        })
    }
}

/// Items that a short scope names.
const FEW: usize = 3;

/// What stands before the colon of items, each once.
fn groups<'a>(items: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut found = Vec::new();
    for item in items {
        let group = item.split_once(": ").map_or(item, |(group, _)| group);
        if !found.contains(&group) {
            found.push(group);
        }
    }
    found
}

fn scope(judged: Vec<&str>, not: Vec<&str>, list: impl Fn(&[&str]) -> String) -> String {
    let (judged, not) = (list(&judged), list(&not));
    match (judged.is_empty(), not.is_empty()) {
        (true, true) => "Nothing was judged.".to_owned(),
        (true, false) => format!("Not judged: {not}."),
        (false, true) => format!("Judged: {judged}."),
        (false, false) => format!("Judged: {judged}. Not judged: {not}."),
    }
}

/// What was judged and what was not.
#[derive(Serialize, JsonSchema)]
struct Scope<'a> {
    /// Items that were judged.
    judged: &'a [JudgedItem],
    /// Items that were not.
    not_judged: &'a [UnjudgedItem],
}

/// A verdict as documents have it.
#[derive(Serialize, JsonSchema)]
struct Document<'a> {
    /// Whether the target is met.
    status: Status,
    /// Whether the run may be used: met, or nothing was asked for.
    accepted: bool,
    /// Why it is not met.
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<&'a Remark>,
    /// What the status covers.
    scope: Scope<'a>,
}

impl Serialize for Verdict {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let document = Document {
            status: self.status(),
            accepted: self.is_accepted(),
            reason: self.reason(),
            scope: Scope { judged: &self.judged, not_judged: &self.not_judged },
        };
        document.serialize(serializer)
    }
}

impl JsonSchema for Verdict {
    fn schema_name() -> Cow<'static, str> {
        "Verdict".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        Document::json_schema(generator)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn remark(code: &'static str) -> Remark {
        Remark::new(code, "what", "help")
    }

    /// Every order of the same items gives the same status, by the precedence missed, not judged, met.
    #[test]
    fn precedence_does_not_depend_on_the_order() {
        let add: [fn(&mut Verdict); 4] = [
            |v| v.met("a", ""),
            |v| v.missed("b", "", remark("missed")),
            |v| v.owe("c", remark("owed")),
            |v| v.leave("d", "not asked for"),
        ];
        for mask in 0..16_usize {
            let chosen: Vec<_> = (0..4).filter(|k| mask >> k & 1 == 1).map(|k| add[k]).collect();
            let mut forwards = Verdict::new();
            chosen.iter().for_each(|f| f(&mut forwards));
            let mut backwards = Verdict::new();
            chosen.iter().rev().for_each(|f| f(&mut backwards));
            let wanted = match (mask & 1 > 0, mask & 2 > 0, mask & 4 > 0) {
                (_, true, _) => Status::Missed,
                (_, false, true) | (false, false, false) => Status::NotJudged,
                (true, false, false) => Status::Met,
            };
            assert_eq!((forwards.status(), backwards.status()), (wanted, wanted), "{mask}");
            assert_eq!(forwards.is_accepted(), mask & 6 == 0, "{mask}");
            assert_eq!(forwards.reason().is_some(), mask & 6 != 0, "{mask}");
        }
    }

    #[test]
    fn the_document_names_status_reason_and_scope() {
        let mut verdict = Verdict::new();
        verdict.met("left flank", "0.2 of 1 um");
        verdict.owe("root", remark("root-not-judged"));
        let document = serde_json::to_value(&verdict).unwrap();
        assert_eq!(document["status"], "not_judged");
        assert_eq!(document["accepted"], false);
        assert_eq!(document["reason"]["code"], "root-not-judged");
        assert_eq!(document["scope"]["judged"][0]["item"], "left flank");
        assert_eq!(document["scope"]["not_judged"][0]["asked"], true);
        assert_eq!(verdict.scope_in_words(), "Judged: left flank. Not judged: root.");
        assert_eq!(verdict.scope_in_short(), verdict.scope_in_words());
        let many = groups(["a: b", "a: c", "d", "e", "f", "g", "h"].into_iter());
        assert_eq!(many, ["a", "d", "e", "f", "g", "h"]);
    }
}
