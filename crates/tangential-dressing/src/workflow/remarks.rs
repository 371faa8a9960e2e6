//! What a run of tangential dressing says beside its numbers: warnings, the reason of a miss, a worm that is too short.

use super::flank::TangentialRun;
use super::plan::PassPlan;
use super::prepare::TangentialPrepared;
use super::result::TangentialFlankResult;
use super::settings::SettledPass;
use crate::{Channel, Judged, Shape, Variable};
use foundation::geometry::Sides;
use job::Diagnostic;
use run::RunFailure;
use std::collections::BTreeMap;
use verdict::Remark;

/// Ratio of the determinants below which the envelope is about to fold: the far branch cuts deeper than it
/// (`docs/mathematics/tangential-dressing.md#the-dressed-worm`).
const NEAR_FOLD: f64 = 0.2;

pub(super) fn flank_warnings(judged: &Judged) -> Option<Remark> {
    let ratio = judged.least_ratio();
    (ratio < NEAR_FOLD).then(|| Remark {
        code: "near-undercut",
        text: format!(
            "the {} flank is near its undercut: the determinant falls to {ratio:.3} of the unmodified one, and what lies beyond the fold may cut deeper",
            judged.flank
        ),
        way_out: "reduce the amount of the modification, or raise the form diameter".into(),
    })
}

/// A fit that crawls within the tolerance is no matter.
pub(super) fn pass_warning(plan: &PassPlan, tolerance: f64) -> Option<Remark> {
    let error = plan.fit.clone().require_convergence().err().filter(|_| plan.fit.largest > tolerance)?;
    Some(Remark { code: error.code(), text: error.to_string(), way_out: error.way_out().into() })
}

/// What one pass for both flanks means (`docs/mathematics/tangential-dressing.md#sensitivities`).
pub(super) fn shared_pass_warning(passes: &[SettledPass]) -> Option<Remark> {
    let shared = passes.iter().find(|p| p.flanks.len() > 1)?;
    let against: Vec<String> = shared
        .settings
        .values()
        .iter()
        .filter(|(v, value)| *value != 0.0 && is_antisymmetric(v))
        .map(|(v, _)| v.to_string())
        .collect();
    (!against.is_empty()).then(|| Remark {
        code: "antisymmetric-variables",
        text: format!(
            "in one pass the even powers of {} crown one flank and hollow the other",
            against.join(", ")
        ),
        way_out: "crown both flanks by dA and dist, or give every flank a pass of its own".into(),
    })
}

/// Whether equal crownings of both flanks cannot come from it in one pass.
fn is_antisymmetric(variable: &Variable) -> bool {
    let even = matches!(variable.shape, Shape::Power(k) if k > 0 && k % 2 == 0);
    let across = matches!(
        variable.channel,
        Channel::TangentialShift | Channel::AxialOffset | Channel::WorkTurn | Channel::ToolShift
    );
    even && across
}

/// Worm length needed with a zone for every pass, and with the worm dressed again before every pass. mm.
pub(super) fn worm_lengths(passes: &[SettledPass], runs: &Sides<Option<TangentialRun>>) -> [f64; 2] {
    let each = passes.iter().map(|pass| {
        let used = pass.flanks.iter().filter_map(|&f| runs[f].as_ref()).map(|run| run.strokes.worm_faces);
        let [from, to] =
            used.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], [from, to]| [a.min(from), b.max(to)]);
        to - from
    });
    each.fold([0.0, 0.0], |[sum, most], length| [sum + length, f64::max(most, length)])
}

pub(super) fn check_worm_width(
    ready: &TangentialPrepared,
    runs: &Sides<Option<TangentialRun>>,
    passes: &[SettledPass],
    [_, longest]: [f64; 2],
) -> Result<(), RunFailure> {
    let Some(width) = ready.worm_width.filter(|&width| width < longest) else { return Ok(()) };
    let used: Vec<String> = runs
        .iter()
        .filter_map(|(flank, run)| {
            let [from, to] = run.as_ref()?.strokes.worm_faces;
            Some(format!("{flank} flank z_1 from {from:.2} to {to:.2} mm"))
        })
        .collect();
    let text = format!("the worm is too short: a pass needs {longest:.2} mm ({})", used.join(", "));
    let way_out = if passes.iter().any(|p| p.flanks.len() > 1) {
        "grind flank by flank (dressing.passes = \"each\"), or reduce grinding.shift_ratio"
    } else {
        "take a longer worm, or reduce grinding.shift_ratio"
    };
    let finding = Diagnostic::with_code("worm-too-short", text)
        .field("worm.width")
        .value(width)
        .allowed(format!("from {longest:.2} mm"))
        .way_out(way_out);
    Err(RunFailure::not_producible(finding))
}

pub(super) fn missed(
    ready: &TangentialPrepared,
    flanks: &BTreeMap<&'static str, TangentialFlankResult>,
    passes: &[SettledPass],
) -> Remark {
    let worst =
        flanks.iter().max_by(|a, b| a.1.flank.max_deviation_um.total_cmp(&b.1.flank.max_deviation_um));
    let text = worst.map_or("no flank is ground".to_string(), |(flank, f)| {
        format!(
            "the {flank} flank differs from the target by up to {:.4} um, {:.4} um are allowed",
            f.flank.max_deviation_um, ready.tolerance_um
        )
    });
    let chosen = passes.iter().any(|p| p.plan.as_ref().is_some_and(|plan| plan.selection.is_some()));
    let way_out = if passes.iter().any(|p| p.flanks.len() > 1) {
        "grind flank by flank (dressing.passes = \"each\"), or try grinding.shift_ratio = \"neutral\""
    } else if chosen {
        "allow more variables (dressing.most_variables) or splines, or exclude fewer channels"
    } else {
        "let the plan choose the variables (dressing.variables = \"auto\"), or add powers and channels"
    };
    Remark { code: "target-missed", text, way_out: way_out.into() }
}
