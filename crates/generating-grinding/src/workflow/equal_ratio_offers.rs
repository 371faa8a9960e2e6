//! Worms with which both flanks of a job ask for the same diagonal ratio
//! (`docs/mathematics/generating-contact.md#contact-path-lines-and-the-diagonal-ratio`), offered where directed parts of the target ask for
//! different ones. Knows no plan: an offer says where one ratio is enough, not whether it is allowed.

use contact::{DiagonalLine, FlankPair};
use foundation::geometry::{Flank, Sides};
use generating::{
    EqualRatioSearch, FlankTarget, GeneratingError, GrindingSetup, Lever, RatioRoot, Tool, equal_ratio_lines,
    generatrix,
};
use schemars::JsonSchema;
use serde::Serialize;
use verdict::Remark;

/// A number of the worm with which one diagonal ratio serves the directed parts of both flanks.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EqualRatioOffer {
    /// What is changed: `cone_angle`, `profile_angle` (left flank) or `crossing_angle`.
    pub lever: &'static str,
    /// Its value, degrees.
    pub value_deg: f64,
    /// The common diagonal ratio.
    pub diagonal_ratio: f64,
    /// Keys of the job with the values that give this worm.
    pub keys: Vec<(&'static str, f64)>,
}

impl EqualRatioOffer {
    /// What is changed and its value, as a page says it.
    pub fn in_words(&self) -> String {
        let value = |k: usize| self.keys.get(k).map_or(f64::NAN, |(_, value)| *value);
        match self.lever {
            "cone_angle" => format!("cone angle {:.4} deg", value(0)),
            "profile_angle" => {
                format!("pressure angles {:.4} deg left and {:.4} deg right", value(0), value(1))
            }
            _ => format!("pitch diameter {:.4} mm", value(0)),
        }
    }
}

/// Ratios that differ by a smaller share are the same: over a flank of 40 mm their lines part by some 4 um in place, a relief
/// of 3 um/mm by 0.01 um in amount.
const SAME: f64 = 1e-4;
/// Cone angles searched, degrees either way: 15 deg make up for a difference of 20 percent
/// (`docs/mathematics/generating-contact.md#contact-path-lines-and-the-diagonal-ratio`).
const CONE_DEG: f64 = 20.0;
/// Profile angles searched either way of the worm's own, degrees.
const PROFILE_DEG: f64 = 5.0;
/// Crossing angles searched: those of worms with this share of the pitch diameter.
const DIAMETERS: [f64; 2] = [0.5, 2.0];
/// A worm whose pitch diameter is less than this multiple of threads times module has hardly a helix left.
const LEAST_DIAMETER: f64 = 1.02;

/// One ratio per flank that the directed parts of the target ask for, with the direction tan(rho_2) on the gear. `None`
/// unless both flanks ask for exactly one and the two differ: more than one ratio on a flank no worm can make equal.
fn different_demands(
    setup: &GrindingSetup,
    targets: &Sides<Option<FlankTarget>>,
) -> Option<(Sides<f64>, Sides<f64>)> {
    let one = |flank: Flank| {
        let lines = &setup.lines[flank];
        let mut found: Option<(f64, f64)> = None;
        for term in targets[flank].iter().flat_map(|t| &t.rest) {
            let Some(direction) = term.line_direction() else { continue };
            let ratio = lines.ratio_of_direction(direction);
            match found {
                Some((known, _)) if !alike(known, ratio) => return None,
                _ => found = Some((ratio, direction)),
            }
        }
        found.filter(|(ratio, _)| ratio.is_finite())
    };
    let (left, right) = (one(Flank::Left)?, one(Flank::Right)?);
    (!alike(left.0, right.0))
        .then_some((Sides { left: left.0, right: right.0 }, Sides { left: left.1, right: right.1 }))
}

/// Lines with which both flanks of a job share a ratio.
pub struct SharedRatio {
    /// tan(rho_1) on each flank.
    pub direction: Sides<f64>,
    /// The common ratio.
    pub ratio: f64,
    /// The ratios that the flanks ask for without them.
    pub demanded: Sides<f64>,
}

/// Where the direction of the tool's lines is free: the lines nearest to the present ones with which both flanks ask for the same
/// ratio (`docs/mathematics/dressing.md#conditions`). `None` where the directed parts of the target do not ask for different ratios, or
/// where no lines make them equal.
pub fn free_lines(setup: &GrindingSetup, targets: &Sides<Option<FlankTarget>>) -> Option<SharedRatio> {
    let (demanded, directions) = different_demands(setup, targets)?;
    let lines = |t: &Sides<f64>| t.map(|_, t| DiagonalLine { rho: t.atan() });
    let free = equal_ratio_lines(&setup.pair, lines(&directions), lines(&setup.tool_direction)).ok()?;
    Some(SharedRatio { direction: free.lines.map(|_, line| line.rho.tan()), ratio: free.ratio, demanded })
}

fn alike(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME * a.abs().max(b.abs())
}

/// Worms with equal ratios on both flanks, the cone angles first, each lever's smallest change first; empty where the target
/// asks for nothing that differs, or where no worm of the searched ranges has equal ratios.
///
/// The tool's lines are those given in the job, else those along the generatrix. Dressed lines differ from these a little, so
/// that for a dressed tool the values are near ones.
pub fn equal_ratio_offers(
    setup: &GrindingSetup,
    targets: &Sides<Option<FlankTarget>>,
) -> Vec<EqualRatioOffer> {
    let Some((_, directions)) = different_demands(setup, targets) else { return Vec::new() };
    let given = setup.input.tool_direction;
    let of_job = move |flank: &FlankPair| match given {
        Some(t) => Ok::<_, GeneratingError>(DiagonalLine { rho: t[flank.flank()].atan() }),
        None => generatrix(flank),
    };
    let search = EqualRatioSearch {
        work: &setup.input.gear,
        worm: setup.input.worm,
        work_lines: directions.map(|_, t| DiagonalLine { rho: t.atan() }),
        worm_line: &of_job,
    };
    let mut offers = Vec::new();
    for lever in [Lever::ConeAngle, Lever::ProfileAngle, Lever::CrossingAngle] {
        // A lever that this gear does not have, or that gives no worm, offers nothing.
        let Ok(found) = search.search(lever, range(setup, lever)) else { continue };
        offers.extend(found.roots.iter().map(|root| offer(lever, root)));
    }
    offers
}

/// Values of the lever that are searched, rad.
fn range(setup: &GrindingSetup, lever: Lever) -> [f64; 2] {
    match lever {
        Lever::ConeAngle => [-CONE_DEG, CONE_DEG].map(f64::to_radians),
        Lever::ProfileAngle => {
            let own = setup.pair.worm.data().pressure_angle.left;
            [-PROFILE_DEG, PROFILE_DEG].map(|d| (own + d.to_radians()).max(1f64.to_radians()))
        }
        Lever::CrossingAngle => {
            let worm = setup.pair.worm.data();
            let least = f64::from(worm.teeth) * worm.normal_module;
            let own = worm.helix_angle;
            let ends = DIAMETERS.map(|share| {
                let pitch = (2.0 * setup.worm_pitch_radius * share).max(LEAST_DIAMETER * least);
                let helix = own.signum() * (least / pitch).acos();
                setup.pair.chain.crossed_axes_angle - (helix - own)
            });
            [ends[0].min(ends[1]), ends[0].max(ends[1])]
        }
    }
}

fn offer(lever: Lever, root: &RatioRoot) -> EqualRatioOffer {
    let worm = root.design.worm.data();
    let (name, keys) = match lever {
        Lever::ConeAngle => ("cone_angle", vec![("worm.cone_angle_deg", root.value.to_degrees())]),
        Lever::ProfileAngle => (
            "profile_angle",
            vec![
                ("worm.normal_pressure_angle_deg.left", worm.pressure_angle.left.to_degrees()),
                ("worm.normal_pressure_angle_deg.right", worm.pressure_angle.right.to_degrees()),
            ],
        ),
        Lever::CrossingAngle => {
            ("crossing_angle", vec![("worm.pitch_diameter", 2.0 * root.design.worm.pitch_radius())])
        }
    };
    EqualRatioOffer { lever: name, value_deg: root.value.to_degrees(), diagonal_ratio: root.ratio, keys }
}

/// The offer of a plan; `None` if there is nothing to offer.
pub fn equal_ratio_remark(setup: &GrindingSetup, targets: &Sides<Option<FlankTarget>>) -> Option<Remark> {
    let (demanded, _) = different_demands(setup, targets)?;
    let offers = equal_ratio_offers(setup, targets);
    let first = offers.first()?;
    let set = |offer: &EqualRatioOffer| {
        let keys: Vec<String> = offer.keys.iter().map(|(key, value)| format!("{key} = {value:.6}")).collect();
        keys.join(", ")
    };
    let others: Vec<String> =
        offers[1..].iter().map(|o| format!("{} (ratio {:.6})", o.in_words(), o.diagonal_ratio)).collect();
    let also = if others.is_empty() { String::new() } else { format!("; or {}", others.join("; or ")) };
    let not_dressed = match (&setup.tool, first.lever) {
        (Tool::Dressed(_), "cone_angle") => {
            "; dressed lines shift the values slightly, and the worm is not checked: `explore` with worm.cone_angle_deg shows whether it can be made"
        }
        (_, "cone_angle") => {
            "; the worm is not checked: `explore` with worm.cone_angle_deg shows whether it can be made"
        }
        (Tool::Dressed(_), _) => "; dressed lines shift the values slightly",
        _ => "",
    };
    Some(Remark {
        code: "equal-ratio-offered",
        text: format!(
            "directed parts of the target ask for diagonal ratio {:.6} on the left flank and {:.6} on the right one; a worm with \
             {} lays its lines onto both at {:.6}{also}",
            demanded.left,
            demanded.right,
            first.in_words(),
            first.diagonal_ratio
        ),
        way_out: format!("set {}{not_dressed}", set(first)),
    })
}
