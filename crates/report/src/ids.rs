//! Ids of sections and charts: what programs find them by, whatever their titles say.

use std::collections::BTreeSet;

/// A name in small letters and digits with hyphens between, for ids that follow a name in the data: of an axis, a flank, a characteristic.
pub fn kebab(name: &str) -> String {
    let mut id = String::new();
    for letter in name.chars() {
        if letter.is_alphanumeric() {
            id.extend(letter.to_lowercase());
        } else if !id.ends_with('-') && !id.is_empty() {
            id.push('-');
        }
    }
    id.truncate(id.trim_end_matches('-').len());
    id
}

/// Ids given so far on a page.
#[derive(Default)]
pub(super) struct Given(BTreeSet<String>);

impl Given {
    /// The id, with a number from the second on.
    pub(super) fn once(&mut self, id: &str) -> String {
        let numbered = (2..).map(|k| format!("{id}-{k}"));
        let free = std::iter::once(id.to_owned()).chain(numbered).find(|id| !self.0.contains(id));
        let free = free.unwrap_or_default();
        self.0.insert(free.clone());
        free
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_ids() {
        assert_eq!(kebab("Grinding: Axis X1, word X"), "grinding-axis-x1-word-x");
        assert_eq!(kebab(" (F_p) [µm]"), "f-p-µm");
        assert_eq!(kebab("..."), "");
    }

    #[test]
    fn an_id_is_given_once() {
        let mut given = Given::default();
        let ids = ["strokes", "strokes", "strokes-2", "strokes"].map(|id| given.once(id));
        assert_eq!(ids, ["strokes", "strokes-2", "strokes-2-2", "strokes-3"]);
    }
}
