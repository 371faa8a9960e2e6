//! Why a job of generating grinding is refused, worded for this job: the place on the gear as a diameter, and remedies that name keys
//! which the job has.

use super::super::prepare::Prepared;
use crate::workflow::generating_finding;
use contact::ContactError;
use dressing::DressingError;
use foundation::geometry::Flank;
use foundation::modification::ModificationSpec;
use generating::{Candidate, GeneratingError, LEAST_DETERMINANT, NoPlan};
use referee::{RemovalError, Stage, Uncut};
use run::RunFailure;

/// Rays that end nearer than this to the worm's tip are short of its addendum, mm of roll on the worm: a modification moves the
/// contact by no more.
const NEAR_TIP: f64 = 1.0;
/// What a worm should reach beyond the contact that it has without modification, mm of roll on the worm.
const ROOM_AT_TIP: f64 = 0.5;

/// Why there is no plan.
pub fn of_planning(refused: &NoPlan, prepared: &Prepared) -> RunFailure {
    let failure = generating_finding::failure(&refused.error);
    match &refused.error {
        GeneratingError::AxisLimit { .. } => {
            let failure = failure.amended(|finding| finding.field("grinding.diagonal_ratio"));
            let tolerance = prepared.tolerance.tightest();
            match exact_beyond_axis_limits(&refused.candidates, tolerance) {
                Some(best) => failure.amended(|finding| finding.way_out(stated_ratio(best))),
                None => failure,
            }
        }
        GeneratingError::Contact(error) => of_contact(error, failure, prepared),
        GeneratingError::Dressing(DressingError::NoZero { .. }) => {
            failure.amended(|finding| finding.way_out(without_correction(prepared)))
        }
        GeneratingError::WormTooShort { .. } if prepared.rules.radial => failure
            .amended(|finding| finding.way_out("take a wider worm, or evaluate less of the face width")),
        GeneratingError::EnvelopeBroken { .. } | GeneratingError::ModelError { .. }
            if prepared.rules.radial =>
        {
            failure.amended(|finding| {
                finding.way_out("reduce the amount, use method = \"diagonal\", or widen the tolerance")
            })
        }
        _ => failure,
    }
}

/// The candidate that is exact enough and refused for its dressing or grinding axes alone.
pub fn exact_beyond_axis_limits(candidates: &[Candidate], tolerance: f64) -> Option<&Candidate> {
    let only_axes = |c: &&Candidate| {
        matches!(c.refusal, Some(GeneratingError::AxisLimit { .. }))
            && c.error <= tolerance / 2.0
            && c.determinant >= LEAST_DETERMINANT
    };
    candidates.iter().filter(only_axes).min_by(|a, b| a.score().total_cmp(&b.score()))
}

/// The remedy where only the default limits of planning are in the way.
pub fn stated_ratio(best: &Candidate) -> String {
    format!(
        "set diagonal_ratio = {:.4} ({:.3} um are left on an ideal worm, {:.1} mm of the worm are used) if the machine has that travel: the limit is one of planning (grinding.axis_limits), and a stated ratio is not bound by it; or reduce the amount, or take a worm with more threads",
        best.ratio,
        best.error * 1e3,
        best.occupation
    )
}

fn of_contact(error: &ContactError, failure: RunFailure, prepared: &Prepared) -> RunFailure {
    let place = match *error {
        ContactError::Undercut { flank, w, z, .. } | ContactError::NotSettled { flank, w, z, .. } => {
            format!(" (diameter {:.3} mm of the gear, z = {z:.3} mm)", diameter(prepared, flank, w))
        }
        ContactError::WormSurfaceMissing { .. } | ContactError::NotSmooth { .. } => String::new(),
        _ => return failure,
    };
    failure.amended(|mut finding| {
        finding.message = format!("{}{place}", finding.message).into();
        finding.way_out(smoother(prepared))
    })
}

/// Diameter of the gear at a length of roll, mm.
fn diameter(prepared: &Prepared, flank: Flank, w: f64) -> f64 {
    2.0 * prepared.setup.pair.work.flank(flank).radius(w)
}

/// Remedies for a target that bends the worm too sharply: rounding first, where a relief has a kink.
fn smoother(prepared: &Prepared) -> String {
    let mut ways = unrounded_reliefs(&prepared.drawn);
    if prepared.rules.radial {
        ways.push("use method = \"diagonal\"".into());
    } else {
        ways.push("choose another diagonal_ratio".into());
    }
    ways.push("take smaller amounts".into());
    ways.join(", or ")
}

/// The reliefs of the target that begin with a kink, as remedies.
fn unrounded_reliefs(drawn: &[ModificationSpec]) -> Vec<String> {
    let entries = drawn.iter().enumerate();
    let kinked: Vec<(usize, f64)> = entries
        .filter_map(|(k, entry)| {
            let keys = serde_json::to_value(entry).ok()?;
            let number = |key: &str| keys.get(key).and_then(serde_json::Value::as_f64);
            let length = number("length_mm")?;
            let straight = number("exponent").is_none_or(|exponent| exponent <= 1.0);
            let sharp = number("transition_mm").is_none_or(|transition| transition <= 0.0);
            (straight && sharp && entry.kind().contains("relief")).then_some((k, length))
        })
        .collect();
    if kinked.is_empty() {
        return Vec::new();
    }
    let places: Vec<String> = kinked
        .iter()
        .map(|(k, length)| format!("target.modifications[{k}].transition_mm = {:.1}", length / 3.0))
        .collect();
    vec![format!(
        "round the relief where it begins with a kink ({}) or give it exponent = 2",
        places.join(", ")
    )]
}

/// Remedies where no dressing motion meets the conditions.
fn without_correction(prepared: &Prepared) -> String {
    let mut ways =
        vec!["reduce the amounts".to_owned(), "take a worm with more threads or of smaller diameter".into()];
    if !prepared.rules.free_dresser {
        ways.push("let the dresser be made for the target (dresser.modification = \"target\")".into());
    }
    if !prepared.rules.radial {
        ways.push("choose another diagonal_ratio".into());
    }
    ways.join(", or ")
}

/// Why the simulation of a run found rays that nothing cuts.
pub fn of_simulation(error: &RemovalError, prepared: &Prepared, planned: bool) -> RunFailure {
    let failure = RunFailure::of_removal(error, "grinding");
    let RemovalError::RayUncut { stage, w, z, reason, count } = *error else { return failure };
    match (stage, reason) {
        (Stage::Grinding, Uncut::ToolMissing) => match short_tip(prepared, w) {
            Some(reach) => failure.amended(|mut finding| {
                finding.code = "worm-tip-short";
                finding.message = reach.message(count).into();
                finding.field("worm.tip_diameter").way_out(reach.way_out())
            }),
            None => failure.amended(|mut finding| {
                finding.message = format!(
                    "the contact leaves the part of the worm that this plan dresses: in the simulation {count} rays of the gear are not finished, first at length of roll {w:.4} mm, z = {z:.4} mm"
                )
                .into();
                finding.way_out(smoother(prepared))
            }),
        },
        (Stage::Grinding, Uncut::StrokeTooShort | Uncut::NotReached) if planned => {
            failure.amended(|finding| finding.way_out(smoother(prepared)))
        }
        (Stage::Dressing, Uncut::ToolMissing) => failure.amended(|mut finding| {
            finding.message = format!(
                "the dresser's profile ends before the contact: in the simulation {count} rays of the worm are not finished, first at length of roll {w:.4} mm and z = {z:.4} mm of the worm"
            )
            .into();
            finding.field("dressing").way_out(without_correction(prepared))
        }),
        _ => failure,
    }
}

/// A worm whose tip ends before, or hardly beyond, the point that grinds the start of the profile.
struct ShortTip {
    /// Diameter from which the tip generates the involute, mm.
    generated_from: f64,
    /// Diameter from which it is asked for, mm.
    asked_from: f64,
    /// Tip diameter of the worm that would reach it with some room, mm.
    enough: f64,
    /// Tip diameter of the worm, mm.
    tip_diameter: f64,
}

/// The worm's reach, if rays at this length of roll on the gear end at its tip. Cylinders only: the reach of a cone changes along it.
fn short_tip(prepared: &Prepared, w: f64) -> Option<ShortTip> {
    let setup = &prepared.setup;
    if !(setup.pair.worm.is_cylindrical() && setup.pair.work.is_cylindrical()) {
        return None;
    }
    let tip_diameter = 2.0 * setup.worm_tip_radius;
    let [asked_from, ..] = setup.input.evaluation;
    prepared.ground_flanks().into_iter().find_map(|flank| {
        let pair = &setup.pair.flanks[flank];
        let at_tip = pair.worm.length_of_roll(setup.worm_tip_radius).ok()?;
        if pair.worm_roll(w, 0.0, 0.0) < at_tip - NEAR_TIP {
            return None;
        }
        let start = pair.work.length_of_roll(asked_from / 2.0).ok()?;
        let needed = pair.worm_roll(start, 0.0, 0.0) + ROOM_AT_TIP;
        Some(ShortTip {
            generated_from: setup.generated_from(flank)?,
            asked_from,
            enough: 2.0 * pair.worm.radius(needed),
            tip_diameter,
        })
    })
}

impl ShortTip {
    fn message(&self, count: usize) -> String {
        let Self { generated_from, asked_from, .. } = self;
        let moved = if generated_from > asked_from {
            ""
        } else {
            "; the modification moves the contact further out than that"
        };
        format!(
            "the worm's tip generates the involute from d {generated_from:.3} mm, asked from {asked_from:.3} mm{moved} ({count} rays of the simulation are not finished)"
        )
    }

    fn way_out(&self) -> String {
        format!(
            "give the worm more addendum (worm.tip_diameter = {:.2} in place of {:.2}), or raise gear.form_diameter or gear.evaluation.start_diameter",
            self.enough.max(self.tip_diameter + 0.2),
            self.tip_diameter
        )
    }
}
