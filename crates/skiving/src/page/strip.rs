//! The signal of the light barrier over one turn of the tool in one pose.

use foundation::geometry::Flank;
use report::charts::{ChartError, SignalStrip, StripCell, signal_strip};
use report::data::{Block, Figure};

/// Light and dark of all teeth in one pose.
#[derive(Clone, Debug, PartialEq)]
pub struct StripView {
    /// Flank whose edge is measured in the pose.
    pub flank: Flank,
    /// Its track, from 1.
    pub track: usize,
    /// Teeth in the order in which they pass.
    pub teeth: Vec<ToothSignal>,
}

/// The signal of a tooth.
#[derive(Clone, Debug, PartialEq)]
pub struct ToothSignal {
    /// Its number.
    pub tooth: usize,
    /// Where the ideal tooth's dark stretch has its middle, on the way of the spindle, ascending from tooth to tooth, deg.
    pub middle_deg: f64,
    /// Its dark stretch, ascending, deg; none of a broken tooth.
    pub dark_deg: Option<[f64; 2]>,
    /// What is the matter with it.
    pub mark: Option<ToothMark>,
}

/// What is the matter with a tooth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToothMark {
    /// It leaves the tolerance band.
    OutOfBand,
    /// It does not darken the beam.
    Broken,
}

impl StripView {
    pub(super) fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let cell = |signal: &ToothSignal| StripCell {
            name: signal.tooth.to_string(),
            middle_deg: signal.middle_deg,
            dark_deg: signal.dark_deg,
            sign: signal.mark.map(|mark| match mark {
                ToothMark::OutOfBand => 0,
                ToothMark::Broken => 1,
            }),
        };
        let strip = SignalStrip {
            title: "Light and dark over one turn of the tool".into(),
            subtitle: format!(
                "pose of the {} flank, track {}; angle of the spindle [deg]",
                self.flank, self.track
            ),
            cells: self.teeth.iter().map(cell).collect(),
            signs: vec!["out of the band (dark stretch hatched)".into(), "broken: stays light".into()],
        };
        let caption = "Numbers are those of the teeth, at the middle of each ideal dark stretch. Only the edge of the pose touches at its contact point; the \
                       other end of a dark stretch is met elsewhere on the opposite edge.";
        Ok(vec![Block::Figure(Figure::new(
            "light-and-dark-over-one-turn-of-the-tool",
            signal_strip(&strip)?,
            caption,
        ))])
    }
}
