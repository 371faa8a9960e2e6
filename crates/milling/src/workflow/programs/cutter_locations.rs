//! Cutter locations of a job in the words of APT: no machine, coordinates of the workpiece, the feed as it is wanted
//! (`docs/mathematics/programs.md#cutters`).

use super::blocks::{coolant_blocks, coolant_off};
use super::failure::{in_pass, of_writer};
use super::held::length_number;
use super::links::{straight_is_outside, ways};
use super::passes::{BEFORE, CutterPass, ToolPasses, all_passes, name_of};
use super::task::MillingWork;
use foundation::geometry::CutterShape;
use job::Diagnostic;
use motion::milling::CutterPlace as Place;
use nc::{
    AxisMotion, AxisWord, Block, ClCutter, Dialect, Header, NcError, Orientation, Pace, Program, TipControl,
    TipMotion, write_cl_checked,
};
use run::RunFailure;

/// The text.
#[derive(Clone, Debug, PartialEq)]
pub struct CutterLocationText {
    /// Path below the directory of the run.
    pub file: String,
    /// The text, which was read back.
    pub text: String,
    /// Locations in it.
    pub locations: usize,
}

/// Ways shorter than this (mm) with an axis turned by less than this (rad) are none.
const NOWHERE: f64 = 1e-9;
/// A program has to have a tolerance; a text of cutter locations does not say it. mm.
const NO_TOLERANCE: f64 = 1e-3;
/// Speeds that the text may have, mm/s.
const SPEEDS: [f64; 2] = [0.1 / 60.0, 1e6 / 60.0];

impl MillingWork<'_> {
    /// The cutter locations of all spaces.
    ///
    /// # Errors
    /// [`RunFailure`] for numbers that are not usable and places from which the cutter cannot be drawn back.
    pub fn cutter_locations(&self) -> Result<CutterLocationText, RunFailure> {
        let mut text = Locations { work: self, blocks: Vec::new(), last: None, count: 0 };
        text.blocks.extend(
            super::build::comments(self.name, None).into_iter().map(|line| Block::Comment(line.into())),
        );
        let tools = all_passes(self)?;
        for tool in &tools {
            text.tool(tool)?;
        }
        text.blocks.push(Block::End);
        let axes = ["X", "Y", "Z"].iter().zip("XYZ".chars());
        let header = Header {
            name: super::build::program_name(self.name),
            axes: axes.map(|(name, letter)| AxisWord::letter(name, AxisMotion::Linear, letter)).collect(),
            chord_tolerance: NO_TOLERANCE,
        };
        let refused = |error: NcError| of_writer(&error, None);
        let program = Program::new(header, text.blocks).map_err(refused)?;
        let written = write_cl_checked(&program, self.only_cutter().as_ref()).map_err(refused)?;
        Ok(CutterLocationText {
            file: "programs/cutter-locations.cl".into(),
            text: written,
            locations: text.count,
        })
    }

    /// The cutter, if one tool with a cylindrical side does everything.
    fn only_cutter(&self) -> Option<ClCutter> {
        let first = self.tools.first()?;
        let CutterShape::Conical { radius, half_angle: 0.0, corner_radius } = *first.cutter.shape() else {
            return None;
        };
        let same = self.tools.iter().all(|tool| tool.tool.number == first.tool.number);
        let cutting_length = first.cutter.cutting_length();
        same.then_some(ClCutter { diameter: 2.0 * radius, corner_radius, cutting_length })
    }
}

struct Locations<'a> {
    work: &'a MillingWork<'a>,
    blocks: Vec<Block>,
    last: Option<Place>,
    count: usize,
}

impl Locations<'_> {
    fn tool(&mut self, tool: &ToolPasses) -> Result<(), RunFailure> {
        let ToolPasses { tool: data, .. } = tool;
        let offset = length_number(data, Dialect::Fanuc);
        self.blocks.push(Block::Tool { number: data.number, length_offset: Some(offset) });
        let speed = data.spindle_rpm * std::f64::consts::PI / 30.0;
        self.blocks.push(Block::Spindle { spindle: 0, speed });
        self.blocks.extend(coolant_blocks(data.coolant));
        self.blocks.push(Block::TipControlOn(TipControl::Directions));
        self.last = None;
        for pass in &tool.passes {
            self.link(tool, pass)?;
            let Some(work) = self.work.tools.get(pass.operation) else { continue };
            for (k, place) in pass.places.iter().enumerate().skip(1) {
                let feed = match k {
                    1 => None,
                    BEFORE => Some(work.tool.plunge_feed),
                    _ if k < pass.cut().end => Some(work.tool.feed),
                    _ => None,
                };
                self.go(place, feed);
            }
        }
        self.blocks.push(Block::TipControlOff);
        self.blocks.extend(coolant_off(data.coolant));
        self.blocks.push(Block::Spindle { spindle: 0, speed: 0.0 });
        Ok(())
    }

    fn link(&mut self, tool: &ToolPasses, pass: &CutterPass) -> Result<(), RunFailure> {
        let to = pass.places[0];
        let Some(from) = self.last else {
            self.go(&to, None);
            return Ok(());
        };
        let is_outside = |places: &[Place]| {
            places.windows(2).all(|pair| straight_is_outside(&tool.room, &pair[0], &pair[1]))
        };
        let way = ways(&from, &to).find(|way| {
            let edge = usize::from(way.lifted);
            is_outside(&way.places[edge..way.places.len() - edge])
        });
        let Some(way) = way else {
            let name =
                self.work.tools.get(pass.operation).map_or_else(String::new, |tool| name_of(tool.kind));
            let what = in_pass(&name, pass.space, pass.path);
            let text = format!("{what}: no rapid way from the path before stays out of the workpiece");
            let finding = Diagnostic::with_code("link-blocked", text).field("milling");
            return Err(RunFailure::not_producible(finding.way_out("tilt the cutter's axis less")));
        };
        way.places.iter().skip(1).for_each(|place| self.go(place, None));
        Ok(())
    }

    /// A location; `feed` in mm/min along the contact, none for rapid.
    fn go(&mut self, to: &Place, feed: Option<f64>) {
        let from = self.last.unwrap_or(*to);
        let tip = (to.tip.xyz - from.tip.xyz).norm();
        if self.last.is_some() && tip <= NOWHERE && (to.axis.xyz - from.axis.xyz).norm() <= NOWHERE {
            return;
        }
        self.last = Some(*to);
        self.count += 1;
        let contact = (to.contact.xyz - from.contact.xyz).norm();
        let pace = match feed {
            None => Pace::Rapid,
            Some(feed) => {
                let seconds = 60.0 * if contact > NOWHERE { contact } else { tip.max(NOWHERE) } / feed;
                let speed = tip / seconds;
                if (SPEEDS[0]..=SPEEDS[1]).contains(&speed) {
                    Pace::Speed(speed)
                } else {
                    Pace::Duration(seconds)
                }
            }
        };
        let orientation = Orientation::Direction(to.axis.xyz.into());
        self.blocks.push(Block::Tip(TipMotion { tip: to.tip.xyz.into(), orientation, pace }));
    }
}
