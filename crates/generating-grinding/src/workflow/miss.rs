//! Why a ground flank misses its target, and what would help: the cause that the figures show, never a stock sentence where one is
//! known.

use super::line_dressing::LineDressingResult;
use super::prepare::Prepared;
use super::refusal::{exact_beyond_axis_limits, stated_ratio};
use super::result::{FlankResult, LeastDeviationResult};
use foundation::geometry::Flank;
use generating::{GrindingPlan, ProfilePlace, RatioReason, natural_twist};
use std::collections::BTreeMap;
use verdict::Remark;

/// A run whose target is missed.
pub struct Miss<'a> {
    /// Bodies and targets.
    pub prepared: &'a Prepared,
    /// The plan; `None` for a simulation of given settings.
    pub plan: Option<&'a GrindingPlan>,
    /// How near any flank could come, where that is known.
    pub least: Option<&'a LeastDeviationResult>,
    /// What came out.
    pub flanks: &'a BTreeMap<&'static str, FlankResult>,
    /// Diagonal ratio.
    pub ratio: f64,
}

/// Share of the tolerance below which a cause does not explain a miss.
const WORTH_NAMING: f64 = 0.1;

/// The first cause that explains the miss.
pub fn missed(miss: &Miss<'_>) -> Remark {
    exact_ratio_beyond_axes(miss)
        .or_else(|| best_fit_missed(miss).filter(|_| !miss.prepared.rules.radial))
        .or_else(|| twist_of_radial_feed(miss))
        .or_else(|| scallops(miss))
        .or_else(|| profile_without_ratio(miss))
        .or_else(|| third_degree_beside_a_given_dresser(miss))
        .or_else(|| best_fit_missed(miss))
        .or_else(|| outside_class(miss))
        .or_else(|| worm_not_dressed(miss))
        .unwrap_or_else(|| not_closer(miss))
}

impl Miss<'_> {
    fn tolerance_um(&self) -> f64 {
        self.prepared.tolerance.tightest() * 1e3
    }

    /// Largest of a figure over the ground flanks.
    fn largest(&self, figure: impl Fn(&FlankResult) -> f64) -> f64 {
        self.flanks.values().map(figure).fold(0.0, f64::max)
    }
}

/// A ratio would make the target; only the default limits of the correcting axes keep planning from it.
fn exact_ratio_beyond_axes(miss: &Miss<'_>) -> Option<Remark> {
    let choice = &miss.plan?.choice;
    if choice.reason != RatioReason::LeastError {
        return None;
    }
    let best = exact_beyond_axis_limits(&choice.candidates, miss.prepared.tolerance.tightest())?;
    let refusal = best.refusal.as_ref()?;
    Some(Remark::new(
        "axis-limit",
        format!(
            "Planning kept to diagonal_ratio = {:.4} because at the ratio that would make the target, {:.4}, {refusal}.",
            choice.ratio, best.ratio
        ),
        capitalised(&format!("{}.", stated_ratio(best))),
    ))
}

/// A best fit that is not within the tolerance: how near any could come, and which limit counts.
fn best_fit_missed(miss: &Miss<'_>) -> Option<Remark> {
    let least = miss.least?;
    let tolerance = miss.tolerance_um();
    let LeastDeviationResult {
        planned_um, bound_um, first_order_um, beyond_class_um, diagonal_ratio, ..
    } = least;
    let over = match miss.prepared.rules.given_ratio {
        Some(_) => "at the given diagonal ratio".to_owned(),
        None => format!(
            "at any diagonal ratio that the worm is wide enough for (the nearest at {diagonal_ratio:.4})"
        ),
    };
    let conclusion = if least.proven {
        "So the miss is proven."
    } else if *bound_um > tolerance {
        "So none is within the tolerance; that none comes nearer than this plan is unproven."
    } else {
        "So the miss is unproven: a nearer flank may exist."
    };
    let gains = |without: f64| first_order_um - without > WORTH_NAMING * tolerance;
    let (axes, envelope) = (least.without_axis_limits_um, least.without_envelope_limit_um);
    let (binds, help) = match (gains(axes), gains(envelope)) {
        (true, _) => (
            format!(" Without the limits of the axes {axes:.3} um would be left there."),
            "Widen grinding.axis_limits as far as the machine allows.",
        ),
        (_, true) => (
            format!(" Were the envelope not to stay unbroken, {envelope:.3} um would be left there."),
            "Make reliefs longer or round their edges (transition_mm), or take a worm with a smaller diameter.",
        ),
        _ if *first_order_um > tolerance => (
            " Neither the limits of the axes nor the envelope count: it is what functions of the worm's lines, the profile and the feed do not carry.".to_owned(),
            "Take a wider worm or one with more threads, smoother modifications, one flank at a time (grinding.flanks), or a wider tolerance.",
        ),
        _ => (
            String::new(),
            "Make reliefs longer or round their edges (transition_mm), give a ratio (grinding.diagonal_ratio) near that one, or widen the tolerance.",
        ),
    };
    Some(Remark::new(
        "best-fit-missed",
        format!(
            "This plan leaves {planned_um:.3} um. No flank of the class of best fits on these bodies comes nearer than {bound_um:.3} um {over}, within the limits of the axes and the least determinant ratio: {first_order_um:.3} um to first order, less {beyond_class_um:.3} um by which what is ground lies beyond the class. {conclusion}{binds}"
        ),
        help,
    ))
}

fn twist_of_radial_feed(miss: &Miss<'_>) -> Option<Remark> {
    let unwanted = |f: &FlankResult| {
        (f.simulated_characteristics.twist_corner_um - f.target_characteristics.twist_corner_um).abs()
    };
    if miss.ratio != 0.0 || miss.largest(unwanted) <= miss.tolerance_um() {
        return None;
    }
    let twist = |(name, f): (&&str, &FlankResult)| {
        let c = &f.simulated_characteristics;
        format!(
            "{name} flank {:.3} um from the corners ({:.3} um normal), {:.3} um by least squares",
            c.twist_corner_um, c.twist_corner_normal_um, c.twist_fit_um
        )
    };
    let twists: Vec<String> = miss.flanks.iter().map(twist).collect();
    let prepared = miss.prepared;
    let natural: Vec<String> = Flank::BOTH
        .into_iter()
        .filter_map(|flank| {
            let target = prepared.targets[flank].as_ref()?;
            let lines = &prepared.setup.lines[flank];
            let half = (lines.face[1] - lines.face[0]) / 2.0;
            let crowning = -target.polynomial.coefficient(0, 2) * half.powi(2);
            let profile = natural_twist(lines, crowning).profile_crowning * 1e3;
            let worth = profile.abs() > WORTH_NAMING * miss.tolerance_um();
            worth.then(|| format!("{flank} flank {profile:.2} um"))
        })
        .collect();
    let already = !prepared.rules.radial && prepared.rules.given_ratio.is_none();
    let method = if already {
        "The planner chose diagonal_ratio = 0; give a ratio other than 0 (`explore` lists their residuals)."
    } else {
        "Use method = \"diagonal\" with diagonal_ratio = \"auto\"."
    };
    Some(Remark::new(
        "natural-twist",
        format!("The radial feed brings a natural twist along: {}.", twists.join("; ")),
        if natural.is_empty() {
            method.to_owned()
        } else {
            format!(
                "{method} Reduce the dresser's profile crowning to compensate the natural profile crowning of the radial feed: by {}.",
                natural.join(", ")
            )
        },
    ))
}

fn scallops(miss: &Miss<'_>) -> Option<Remark> {
    let tolerance = miss.tolerance_um();
    let of_lines = |f: &FlankResult| f.line_dressing.as_ref().map_or(0.0, LineDressingResult::off_um);
    let within_without = |f: &FlankResult| {
        f.tolerance_share - of_lines(f) / tolerance <= 1.0 && f.outside_class_um <= tolerance
    };
    let off = miss.largest(of_lines);
    (off > 0.0 && miss.flanks.values().all(within_without)).then(|| {
        Remark::new(
            "scallops-above-tolerance",
            format!(
                "The dressing lines leave the worm up to {off:.3} um off the wanted one; with that the flank is outside the tolerance."
            ),
            "Reduce dressing.scallop_um: more lines leave less.",
        )
    })
}

/// Without a shift the planner gives the worm no profile but that of its dresser.
fn profile_without_ratio(miss: &Miss<'_>) -> Option<Remark> {
    let asked = miss.plan.is_some() && !miss.prepared.rules.free_dresser && miss.ratio == 0.0;
    let short = |f: &FlankResult| {
        let (target, made) = (&f.target_characteristics, &f.simulated_characteristics);
        let crowning = (target.profile_crowning_um - made.profile_crowning_um).abs();
        crowning.max((target.profile_slope_um - made.profile_slope_um).abs())
    };
    let um = miss.largest(short);
    (asked && um > miss.tolerance_um()).then(|| {
        let by_correction = miss.prepared.rules.places == [ProfilePlace::Correction];
        let (why, first) = if by_correction {
            ("corrections of the dressing motion do not reach so far with this worm", "Take a worm with more threads")
        } else {
            ("no plan with them meets the target", "Plan with dressing.profile_crowning_by = \"correction\" to see why")
        };
        Remark::new(
            "profile-needs-a-ratio",
            format!(
                "{um:.3} um of the profile are not made: without shift a dresser that is given makes a profile by dressing corrections alone, and {why}."
            ),
            format!(
                "{first}, give a small diagonal_ratio, for example -0.05, or let the dresser be made for the target (dresser.modification = \"target\")."
            ),
        )
    })
}

/// What a given dresser does not carry is planned as a polynomial of third degree.
fn third_degree_beside_a_given_dresser(miss: &Miss<'_>) -> Option<Remark> {
    let prepared = miss.prepared;
    if miss.plan.is_none() || prepared.rules.free_dresser {
        return None;
    }
    let left = |flank: Flank| {
        let target = prepared.targets[flank].as_ref()?;
        Some(target.outside * prepared.setup.lines[flank].cos_b2 * 1e3)
    };
    let um = Flank::BOTH.into_iter().filter_map(left).fold(0.0, f64::max);
    (um > WORTH_NAMING * miss.tolerance_um()).then(|| {
        Remark::new(
            "fitted-to-third-degree",
            format!(
                "The dresser is given: what its profile does not make of reliefs, waves or grids is planned as a polynomial of third degree, which leaves up to {um:.3} um. This is a limit of the planner, not of the process."
            ),
            "Let the dresser be made for the target (dresser.modification = \"target\"), round the reliefs (transition_mm), or widen the tolerance.",
        )
    })
}

/// Parts of the target that are only best-fitted. At K = 0 the planner fits helix modifications by polynomials of third degree.
fn outside_class(miss: &Miss<'_>) -> Option<Remark> {
    let outside = miss.largest(|f| f.outside_class_um);
    (outside > WORTH_NAMING * miss.tolerance_um()).then(|| {
        let (text, help) = if miss.ratio == 0.0 {
            (
                format!("With diagonal_ratio = 0 this planner makes of the target what a polynomial of third degree makes; best-fitted, {outside:.3} um are left."),
                "Use method = \"diagonal\" with diagonal_ratio = \"auto\", round the reliefs (transition_mm), or widen the tolerance.",
            )
        } else {
            (
                format!("Parts of the target do not lie on the tool's lines at diagonal_ratio = {:.4}; best-fitted, {outside:.3} um of them are left.", miss.ratio),
                "Let the modifications of both flanks ask for the same diagonal ratio, grind the flanks one by one (grinding.flanks), take smoother modifications, or widen the tolerance.",
            )
        };
        Remark::new("outside-class", text, help)
    })
}

/// A plan whose ideal worm is right and whose dressed worm is not.
fn worm_not_dressed(miss: &Miss<'_>) -> Option<Remark> {
    let plan = miss.plan?;
    let ideal = plan.ideal_error_by_round.iter().filter_map(|(_, rounds)| rounds.last()).copied();
    let ideal_um = ideal.fold(0.0, f64::max) * 1e3;
    let planned = |f: &FlankResult| {
        let rows = f.planned_um.iter().flatten().zip(f.target_um.iter().flatten());
        rows.map(|(planned, target)| (planned - target).abs()).fold(0.0, f64::max)
    };
    let dressed_um = miss.largest(planned);
    let tolerance = miss.tolerance_um();
    (ideal_um <= 0.5 * tolerance && dressed_um > tolerance).then(|| {
        Remark::new(
            "worm-not-dressed",
            format!(
                "The worm that this flank needs would make it within {ideal_um:.3} um; as dressed it leaves {dressed_um:.3} um. Part of the worm modification, for example a profile crowning that varies along the worm, is not made by the dressing motion."
            ),
            if miss.prepared.rules.radial {
                "Use method = \"diagonal\", or dress the worm in points (dresser.contact = \"point\")."
            } else {
                "Give another diagonal_ratio (the candidates are judged on the worm before it is dressed), or dress the worm in points (dresser.contact = \"point\")."
            },
        )
    })
}

fn not_closer(miss: &Miss<'_>) -> Remark {
    let rules = &miss.prepared.rules;
    let help = match (miss.plan, rules.given_ratio) {
        (None, _) => "Change the settings, or let `plan` find them.",
        (Some(_), _) if !rules.precompensation => {
            "Set precompensation = true, take smoother modifications, or widen the tolerance."
        }
        (Some(_), Some(_)) => {
            "Use diagonal_ratio = \"auto\", take smoother modifications, or widen the tolerance."
        }
        _ => {
            "Take a worm with more threads or another diameter, smoother modifications, or a wider tolerance."
        }
    };
    let worst = miss.largest(|f| f.max_deviation_um);
    Remark::new(
        "tolerance-missed",
        format!(
            "This plan leaves {worst:.3} um; the planner found no settings that leave less. That none exist is not shown."
        ),
        help,
    )
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map_or_else(String::new, |c| c.to_uppercase().collect());
    format!("{first}{}", letters.as_str())
}
