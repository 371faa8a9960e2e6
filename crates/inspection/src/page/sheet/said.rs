//! Texts of the sheet itself that stand beside words of files, or are broken into lines, in the language of the sheet. All others get their
//! language where they are drawn.

use super::data::SheetData;
use report::data::Fact;

/// What stands where a file says nothing.
const NOT_STATED: &str = "not stated";

impl SheetData {
    /// The same in its language.
    pub(super) fn said(&self) -> Self {
        let mut sheet = self.clone();
        let say = |text: &mut String| *text = self.language.say(text).into_owned();
        let texts = |facts: &mut [Fact]| facts.iter_mut().for_each(|fact| say(&mut fact.text));
        // Part, drawing and date are words of the file.
        sheet
            .head
            .part
            .iter_mut()
            .filter(|fact| fact.text == NOT_STATED)
            .for_each(|fact| say(&mut fact.text));
        texts(&mut sheet.head.gear);
        texts(&mut sheet.head.conditions);
        for row in [&mut sheet.profiles, &mut sheet.helices].into_iter().chain(&mut sheet.further) {
            say(&mut row.slope_words);
        }
        say(&mut sheet.pitch.words);
        sheet.foot.warnings.iter_mut().for_each(say);
        for field in &mut sheet.topographies {
            say(&mut field.face_name);
            say(&mut field.note);
        }
        sheet
    }
}
