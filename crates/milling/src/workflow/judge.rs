//! What a milling run is judged by: the flanks that it mills, whether plan and simulation agree, the drawn root, everything else of the
//! part that a cutter could enter, and the programs.

use super::part_rays::{PartSurface, THIN_BACKS, has_thin_backs};
use super::prepare::MillingBodies;
use super::result::FlankResult;
use super::root::RefereedRoot;
use super::whole_part::WholePart;
use crate::{MilledSide, RootPart};
use std::collections::BTreeMap;
use verdict::{Remark, Verdict, agree};

/// What was found.
pub(super) struct Judged<'a> {
    pub bodies: &'a MillingBodies,
    pub flanks: &'a BTreeMap<&'static str, FlankResult>,
    pub root: &'a [RefereedRoot],
    /// All surfaces under the paths of one space.
    pub part: &'a WholePart,
    /// Why the active flank does not reach as far as the tip of the mate.
    pub mate: Option<&'a Remark>,
    pub tolerance_um: f64,
}

/// The verdict on the plan; programs are judged by [`super::texts::MillingTexts::judge`].
pub(super) fn verdict(found: &Judged<'_>) -> Verdict {
    let mut verdict = Verdict::new();
    for (name, flank) in found.flanks {
        judge_flank(&mut verdict, name, flank, found.tolerance_um);
    }
    for flank in found.bodies.flanks() {
        let name = flank.side().name();
        if !found.flanks.contains_key(name) {
            verdict
                .leave(format!("{name} flank"), "the job does not mill it; that nothing enters it is judged");
        }
    }
    found.root.iter().for_each(|part| judge_root(&mut verdict, part));
    judge_part(&mut verdict, found);
    let (spaces, milled) = (found.bodies.spaces, found.bodies.milled);
    if milled < spaces {
        verdict.leave(format!("stock in spaces {} to {spaces}", milled + 1), "the job mills one space");
    }
    let unknown = &found.bodies.unknown;
    for remark in unknown {
        verdict.leave(item_of(remark), remark.text.as_str());
    }
    if has_thin_backs(found.bodies) {
        verdict.leave(THIN_BACKS, "the plan keeps clear of them; a ray would come out on the other side");
    }
    if let Some(remark) = found.mate {
        verdict.owe("flank that the mate needs", remark.clone());
    }
    verdict
}

/// The body that a remark on missing data is about.
fn item_of(remark: &Remark) -> &'static str {
    match remark.code {
        "blade-back-not-judged" => "backs of the blades",
        "holder-not-judged" => "shank, holder and spindle in the ring",
        code => code,
    }
}

fn judge_flank(verdict: &mut Verdict, name: &str, flank: &FlankResult, tolerance_um: f64) {
    let item = format!("{name} flank");
    let unmilled: usize = flank.unmilled.values().sum();
    let deviation = flank.max_deviation_um;
    let within = deviation <= tolerance_um;
    if flank.gouged > 0 {
        let gouged = flank.gouged;
        verdict.missed(
            item.clone(),
            format!("a cutter digs in at {gouged} rays, deeper than they begin"),
            Remark::new(
                "flank-gouged",
                format!(
                    "the cutter digs into the {name} flank at {gouged} places, deeper than the rays begin"
                ),
                "check tilt and contact heights, or take a thinner cutter",
            ),
        );
    } else if unmilled > 0 {
        verdict.missed(
            item.clone(),
            format!("{unmilled} rays are not met by a cutter"),
            Remark::new(
                "flank-not-milled",
                format!("{unmilled} places of the {name} flank are not reached by the cutter"),
                "lengthen the overrun, or check tilt and contact heights",
            ),
        );
    } else {
        verdict.judge(item.clone(), within, format!("{deviation:.4} of {tolerance_um} um"), || {
            Remark::new(
                "above-tolerance",
                format!("the {name} flank deviates by {deviation:.3} um, the tolerance is {tolerance_um} um"),
                "lay more rows and columns, or allow a larger tolerance",
            )
        });
    }
    if let Some(left) = flank.out_of_reach {
        let why =
            format!("up to {:.3} mm stay unmilled: the cutter meets the other half there", left.length_mm);
        verdict.leave(format!("{item} in the middle of the gear"), why);
    }
    let item = format!("{item}: plan against simulation");
    let difference = flank.model_difference_um;
    if flank.planned_um.iter().all(Option::is_none) {
        verdict.leave(item, "nothing is predicted between fewer than four columns");
    } else if agree(difference, tolerance_um) {
        verdict.met(item, format!("{difference:.4} um apart"));
    } else {
        let text = format!(
            "plan and simulation of the {name} flank differ by {difference:.3} um, more than a tenth of the tolerance of {tolerance_um} um"
        );
        let help = "lay more columns, another contact_height or a smaller tilt, or widen the tolerance";
        verdict.owe(item, Remark::new("models-disagree", text, help));
    }
}

/// The drawn root: every place reached, nothing dug into. How high stock may stand on it no key says.
fn judge_root(verdict: &mut Verdict, part: &RefereedRoot) {
    let name = match part.part {
        RootPart::Fillet(side) => format!("{side} fillet"),
        RootPart::Bottom => "bottom of the root".into(),
    };
    let result = part.result();
    let (gouged, left) = (result.gouged, result.not_reached);
    let detail = match [result.min_um, result.max_um] {
        [Some(least), Some(most)] => {
            format!("{:.3} um too deep at most, stock up to {most:.3} um", (-least).max(0.0))
        }
        _ => format!("none of its {} places was found", result.rays),
    };
    verdict.judge(name.clone(), gouged + left == 0, detail, || {
        if gouged > 0 {
            Remark::new(
                "root-gouged",
                format!("the cutters dig into the drawn {name} at {gouged} of its {} places", result.rays),
                "take smaller contact heights or a thinner cutter, or draw the root deeper",
            )
        } else {
            Remark::new(
                "root-not-milled",
                format!(
                    "{left} of {} places of the drawn {name} are not reached by the cutters",
                    result.rays
                ),
                "lengthen the overrun, or give another cutter for the bottom",
            )
        }
    });
}

/// Surfaces that the cutters of a space are not to enter: the body, tips, ends, and the flanks beside.
fn judge_part(verdict: &mut Verdict, found: &Judged<'_>) {
    for figures in &found.part.surfaces {
        let surface = figures.surface;
        let milled = |side: MilledSide| found.flanks.contains_key(side.name());
        let name = match surface {
            PartSurface::Flank(side) if !milled(side) => format!("{side} flank, which stays as it is"),
            PartSurface::Flank(side) => format!("{side} flank of the other spaces"),
            _ => surface.name(found.bodies),
        };
        let worst = found.part.on(surface).max_by(|a, b| a.amount.total_cmp(&b.amount));
        let detail = match worst {
            None => format!("no cutter enters it under {} rays", figures.rays),
            Some(fault) => format!("{:.4} mm too deep, space {}", fault.amount, fault.space + 1),
        };
        verdict.judge(name, worst.is_none(), detail, || {
            let text = worst.map_or_else(String::new, |fault| fault.words(found.bodies, "a cutter"));
            let code = worst.map_or("tooth-gouged", |fault| fault.code());
            Remark::new(
                code,
                text,
                "lower the contact heights, take a thinner or shorter cutter, or tilt it more",
            )
        });
    }
}
