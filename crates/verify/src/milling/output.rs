//! Block `output`: the first lines of the row of block `feed` as cutter locations, under tip control and without.

use super::super::given::{Checked, check_block, compare_texts, requires};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::row::{RowInput, course};
use motion::milling::{AxisCourse, BlockTime, block_times};
use nc::{
    AxisMotion, AxisWord, Block, Decimals, Dialect, FeedWords, Header, Orientation, Pace, Program, Targets,
    TipControl, TipMotion, WriteOptions, write, write_cl,
};
use serde_json::Value;

/// Three slides, then C before A, as the chain has them.
fn header() -> Header {
    let axes = [("X1", 'X'), ("Y1", 'Y'), ("Z1", 'Z'), ("C1", 'C'), ("A1", 'A')];
    let axes = axes.into_iter().map(|(name, letter)| {
        let rotary = matches!(letter, 'C' | 'A');
        AxisWord::letter(name, if rotary { AxisMotion::Rotary } else { AxisMotion::Linear }, letter)
    });
    Header { name: "ROW".into(), axes: axes.collect(), chord_tolerance: 1e-3 }
}

/// The blocks that a row begins with: a tool in a turning spindle.
fn begin(length_offset: Option<u32>) -> Vec<Block> {
    vec![Block::Tool { number: 1, length_offset }, Block::Spindle { spindle: 0, speed: 100.0 }]
}

/// The row under tip control, the first place at the feed of the contact.
fn row_of_tips(course: &AxisCourse, times: &[BlockTime], feed: f64) -> Checked<Program> {
    let mut blocks = begin(Some(1));
    blocks.extend([Block::TipControlOn(TipControl::Directions), Block::TipSpeed(feed / 60.0)]);
    for (k, place) in course.places.iter().enumerate() {
        let pace = k.checked_sub(1).map_or(Pace::Kept, |before| Pace::Speed(times[before].tip_feed / 60.0));
        let orientation = Orientation::Direction(place.axis.xyz.into());
        blocks.push(Block::Tip(TipMotion { tip: place.tip.xyz.into(), orientation, pace }));
    }
    blocks.extend([Block::TipControlOff, Block::End]);
    Ok(Program::new(header(), blocks)?)
}

/// The row as values of the axes with a time for each block.
fn row_of_axes(course: &AxisCourse, times: &[BlockTime]) -> Checked<Program> {
    let mut blocks = begin(None);
    for (k, node) in course.nodes.iter().enumerate() {
        let target = Targets::of_first(&std::array::from_fn::<f64, 5, _>(|axis| node[axis]));
        blocks.push(match k.checked_sub(1) {
            None => Block::Rapid(target),
            Some(before) => Block::Linear { target, duration: times[before].seconds },
        });
    }
    blocks.push(Block::End);
    Ok(Program::new(header(), blocks)?)
}

/// As many of the lines that begin like that as the file has.
fn first_lines<'t>(text: &'t str, begin: &str, expected: Option<&Value>) -> Vec<&'t str> {
    let count = expected.and_then(Value::as_array).map_or(0, Vec::len).max(1);
    text.lines().filter(|line| line.starts_with(begin)).take(count).collect()
}

/// Block `output`.
pub(crate) fn output(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("output", block, ledger, |expected, ledger| {
        requires(expected, "of", &["feed"], ledger)?;
        let row = RowInput::of(reference)?;
        let machine = row.machine()?;
        let (setup, course) = course(&machine, &row.places(reference, 1)?)?;
        let feed = row.contact_feed_mm_per_min;
        let times = block_times(&setup, &course.places, &course.nodes, feed)?;
        let options = WriteOptions {
            decimals: Decimals::MILLING,
            feed_words: FeedWords::AxisBlocks,
            line_numbers: Some(10),
            ..WriteOptions::default()
        };
        let tips = row_of_tips(&course, &times, feed)?;
        let texts = [
            ("cl", "GOTO", write_cl(&tips, None)?),
            ("nc_traori", "N", write(&tips, Dialect::Siemens, &options)?.text),
            ("nc_rtcp_off", "N", write(&row_of_axes(&course, &times)?, Dialect::Siemens, &options)?.text),
        ];
        for (key, begin, text) in &texts {
            let lines = first_lines(text, begin, expected.peek(key));
            compare_texts(expected, key, &lines, ledger);
        }
        Ok(())
    });
}
