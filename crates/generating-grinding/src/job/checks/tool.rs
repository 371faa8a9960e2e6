//! Contradictions between `[worm]`, `[dresser]` and `[dressing]`: who profiles the tool, and with what.

use super::conditions;
use crate::job::{
    DesignedFor, Dresser, DresserContact, DresserModification, Dressing, DressingFlanks, FlankForm, Job,
    ProfileCrowningBy, Tool,
};
use job::checks::{contradiction, dresser_diameters, inside_tip, not_yet, root_clearance, worm_diameters};
use job::tables::{Flanks, Modification};
use job::{Diagnostic, Problem, shown_number};

/// Kinds that make sense on a tool: they name their own coordinates and refer to no evaluation field of the gear.
const TOOL_KINDS: [&str; 4] = ["polynomial", "grid", "points", "formula"];

pub(super) fn check(job: &Job, findings: &mut Vec<Diagnostic>) {
    worm_diameters(job.worm.pitch_diameter, job.worm.tip_diameter, findings);
    let tool = job.worm.tool;
    match (&job.dresser, tool) {
        (Some(given), Tool::Dressed) => {
            dresser(given, findings);
            // A dresser of another worm is placed by both.
            if given.designed_for.is_none() {
                root_clearance(given.pitch_diameter, given.root_clearance, findings);
            }
            contact(given, &job.dressing, findings);
            if given.contact == DresserContact::Point && job.worm.cone_angle_deg != 0.0 {
                findings.push(
                    not_yet("worm.cone_angle_deg", "line dressing of a conical worm")
                        .value(shown_number(job.worm.cone_angle_deg))
                        .allowed("0")
                        .way_out("leave the cone angle out: lines of a free direction serve both flanks with one ratio"),
                );
            }
        }
        (None, Tool::Dressed) => findings.push(
            Diagnostic::new(
                Problem::MissingKey,
                "the table `[dresser]` is missing: worm.tool is \"dressed\"",
            )
            .field("dresser")
            .allowed("a table [dresser], or worm.tool = \"given\" or \"made\"")
            .way_out("add `[dresser]`; `flankwright new generating-grinding` prints a complete example"),
        ),
        (Some(_), Tool::Given | Tool::Made) => findings.push(
            Diagnostic::new(
                Problem::InvalidJob,
                format!("a tool that is not dressed (worm.tool = \"{}\") has no [dresser]", tool.name()),
            )
            .field("dresser")
            .value("a table")
            .allowed("no table [dresser], or worm.tool = \"dressed\"")
            .way_out("remove `[dresser]`, or leave `worm.tool` out"),
        ),
        (None, Tool::Given | Tool::Made) => {}
    }
    if tool == Tool::Dressed {
        conditions::check(&job.dressing, findings);
        if job.dresser.as_ref().is_some_and(|d| d.designed_for.is_some())
            && !job.dressing.has_usual_conditions()
        {
            findings.push(
                Diagnostic::new(
                    Problem::InvalidJob,
                    "a dresser designed for another worm is settled by three points and the radius map",
                )
                .field("dressing.conditions")
                .value(format!("{} conditions", job.dressing.rows()))
                .allowed("no conditions and no degrees_of_freedom beside dresser.designed_for")
                .way_out("leave `conditions` and `degrees_of_freedom` out"),
            );
        }
        if job.dressing.flanks == DressingFlanks::Two {
            two_flanks(job, findings);
        }
    } else if job.dressing != Dressing::default() {
        findings.push(
            Diagnostic::new(
                Problem::InvalidJob,
                format!("a tool that is not dressed (worm.tool = \"{}\") has no [dressing]", tool.name()),
            )
            .field("dressing")
            .value("a table")
            .allowed("no table [dressing], or worm.tool = \"dressed\"")
            .way_out("remove `[dressing]`, or leave `worm.tool` out"),
        );
    }
    flanks(job, findings);
}

/// What asks for the motion of one dressing stroke in line contact is refused for every other tool.
pub(super) fn dressed_in_one_stroke(job: &Job, field: &str, findings: &mut Vec<Diagnostic>) {
    let other = if job.worm.tool != Tool::Dressed {
        "a tool that is not dressed"
    } else if job.point_dresser().is_some() {
        "a disc in point contact"
    } else if job.dressing.strokes.is_some() {
        "dressing in several strokes"
    } else {
        return;
    };
    findings.push(contradiction(
        "this is found for worms that a disc dresses in line contact with one stroke",
        field,
        other.into(),
        "no table, or a worm that is dressed in one stroke",
        "leave the table out",
    ));
}

/// Flanks that are no involutes: of a cylindrical tool that exists.
fn form(job: &Job, findings: &mut Vec<Diagnostic>) {
    let (worm, form) = (&job.worm, job.worm.flank_form);
    if form != FlankForm::Zi && worm.tool != Tool::Given {
        findings.push(contradiction(
            "a tool that is dressed or made has the flanks that its plan gives it",
            "worm.flank_form",
            format!("\"{}\"", form.name()),
            "no key, or worm.tool = \"given\"",
            "use tool = \"given\", or leave the form out",
        ));
    }
    if form != FlankForm::Zi && worm.cone_angle_deg != 0.0 {
        findings.push(contradiction(
            "the flank forms ZA, ZN and ZK are those of cylindrical worms",
            "worm.cone_angle_deg",
            shown_number(worm.cone_angle_deg),
            "0 beside worm.flank_form",
            "leave the cone angle or the form out",
        ));
    }
    match (form == FlankForm::Zk, worm.form_disc_diameter) {
        (true, None) => findings.push(
            Diagnostic::new(Problem::MissingKey, "the flanks of a ZK worm depend on the disc that made them")
                .field("worm.form_disc_diameter")
                .allowed("the diameter of the disc in mm")
                .way_out("give the diameter of the disc where it touches the worm's pitch cylinder"),
        ),
        (false, Some(diameter)) => findings.push(contradiction(
            "only a ZK worm is made by a disc with straight sides",
            "worm.form_disc_diameter",
            shown_number(diameter),
            "no key, or worm.flank_form = \"ZK\"",
            "leave the diameter out, or give the form ZK",
        )),
        _ => {}
    }
}

/// Modifications and line direction of a tool that is not dressed.
fn flanks(job: &Job, findings: &mut Vec<Diagnostic>) {
    let tool = job.worm.tool;
    form(job, findings);
    if let Some(given) = &job.worm.modifications {
        if tool == Tool::Made {
            findings.push(
                Diagnostic::new(
                    Problem::InvalidJob,
                    "a tool that is made for the target has the flanks that the plan computes",
                )
                .field("worm.modifications")
                .value(format!("{} entries", given.len()))
                .allowed("no key, or worm.tool = \"given\" or \"dressed\"")
                .way_out("use tool = \"given\" for a tool that exists, or \"dressed\" for a worm that is to be dressed so"),
            );
        }
        for (i, entry) in given.iter().enumerate().filter(|(_, entry)| !TOOL_KINDS.contains(&entry.kind())) {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, "this kind refers to the evaluated field of a gear")
                    .field(format!("worm.modifications[{i}].kind"))
                    .value(format!("{:?}", entry.kind()))
                    .allowed(TOOL_KINDS.map(|kind| format!("\"{kind}\"")).join(", "))
                    .way_out(
                        "describe the tool's flank over w_1 and z_1, e.g. as \"grid\" or \"polynomial\"",
                    ),
            );
        }
    }
    if job.worm.direction_deg.is_some() && tool == Tool::Dressed {
        findings.push(
            Diagnostic::new(
                Problem::InvalidJob,
                "the direction of the lines of a dressed worm follows from its dresser",
            )
            .field("worm.direction_deg")
            .value("given beside worm.tool = \"dressed\"")
            .allowed("no key, or worm.tool = \"given\" or \"made\"")
            .way_out("leave `direction_deg` out"),
        );
    }
}

/// Keys that belong to one kind of contact only.
fn contact(dresser: &Dresser, dressing: &Dressing, findings: &mut Vec<Diagnostic>) {
    let point = dresser.contact == DresserContact::Point;
    let word = if point { "point" } else { "line" };
    if point && dresser.tip_radius.is_none() {
        findings.push(
            Diagnostic::new(Problem::MissingKey, "a disc in point contact has a tip radius")
                .field("dresser.tip_radius")
                .allowed("the radius of the rounded tip in mm")
                .way_out("give dresser.tip_radius, e.g. 0.5"),
        );
    }
    if let Some(tip) = dresser.tip_radius
        && tip > 0.25 * dresser.tip_diameter
    {
        findings.push(
            Diagnostic::new(
                Problem::InvalidGeometry,
                format!("the tip radius {tip} is no rounding of a disc of {} mm", dresser.tip_diameter),
            )
            .field("dresser.tip_radius")
            .value(shown_number(tip))
            .allowed(format!(
                "up to {} (a quarter of the tip diameter)",
                shown_number(0.25 * dresser.tip_diameter)
            ))
            .way_out("give the radius of the rounding at the rim, e.g. 0.5"),
        );
    }
    let made_for_target = dresser.modification == DresserModification::default();
    let plain = Dressing::default();
    let foreign = [
        ("dresser.tip_radius", !point && dresser.tip_radius.is_some()),
        ("dressing.line_direction_deg", !point && dressing.line_direction_deg.is_some()),
        ("dressing.scallop_um", !point && dressing.scallop_um.is_some()),
        ("dresser.pitch_diameter", point && dresser.pitch_diameter.is_some()),
        ("dresser.tip_land", point && dresser.tip_land.is_some()),
        ("dresser.modification", point && !made_for_target),
        ("dresser.designed_for", point && dresser.designed_for.is_some()),
        ("dressing.degrees_of_freedom", point && dressing.degrees_of_freedom.is_some()),
        ("dressing.conditions", point && dressing.conditions != plain.conditions),
        ("dressing.flanks", point && dressing.flanks != plain.flanks),
        ("dressing.profile_crowning_by", point && dressing.profile_crowning_by != plain.profile_crowning_by),
    ];
    for (field, _) in foreign.into_iter().filter(|(_, given)| *given) {
        let other = if point { "line" } else { "point" };
        findings.push(
            Diagnostic::new(
                Problem::InvalidJob,
                format!("this key means nothing for a disc with contact = \"{word}\""),
            )
            .field(field)
            .value("given")
            .allowed(format!("no key, or dresser.contact = \"{other}\""))
            .way_out(format!("leave it out, or use dresser.contact = \"{other}\"")),
        );
    }
}

fn dresser(dresser: &Dresser, findings: &mut Vec<Diagnostic>) {
    dresser_diameters("dresser", dresser.pitch_diameter, dresser.tip_diameter, findings);
    existing_dresser(&dresser.modification, dresser.designed_for.as_ref(), findings);
}

/// A dresser that exists: it carries a profile only, and one that was designed for another worm is not made for the target.
pub fn existing_dresser(
    modification: &DresserModification,
    made_for: Option<&DesignedFor>,
    findings: &mut Vec<Diagnostic>,
) {
    if let Some(there) = made_for {
        designed_for(there, findings);
        if modification.given().is_none() {
            findings.push(
                Diagnostic::new(
                    Problem::InvalidJob,
                    "a dresser that was designed for another worm is there and is not made for the target",
                )
                .field("dresser.modification")
                .value("\"target\"")
                .allowed("\"none\", or a table { kind = .. } of the modification that it carries")
                .way_out("say what profile the dresser has: modification = \"none\" for a plain one"),
            );
        }
    }
    for (i, entry) in modification.given().unwrap_or_default().iter().enumerate() {
        if !of_profile(entry) {
            let place = match modification {
                DresserModification::Sum(_) => format!("dresser.modification[{i}].kind"),
                _ => "dresser.modification.kind".into(),
            };
            findings.push(
                Diagnostic::new(Problem::InvalidJob, "a dresser carries a profile only, the same all round")
                    .field(place)
                    .value(format!("{:?}", entry.kind()))
                    .allowed(OF_PROFILE)
                    .way_out("use a profile kind, e.g. \"profile_crowning\""),
            );
        }
    }
}

/// What a dresser may carry.
pub(super) const OF_PROFILE: &str = "a kind of profile modification, a relief at tip or root, a polynomial or formula of the profile alone, or a sum of such";

/// Whether a modification may depend on the profile only, by its kind; of polynomials and formulas their terms tell it.
pub(super) fn of_profile(entry: &Modification) -> bool {
    match entry {
        Modification::Sum(sum) => !sum.children.is_empty() && sum.children.iter().all(of_profile),
        Modification::Polynomial(_) | Modification::Formula(_) => true,
        other => ["profile_", "tip_", "root_"].iter().any(|start| other.kind().starts_with(start)),
    }
}

/// At least one diameter, the pitch circle inside the tip circle.
fn designed_for(there: &DesignedFor, findings: &mut Vec<Diagnostic>) {
    if there.pitch_diameter.is_none() && there.tip_diameter.is_none() {
        findings.push(
            Diagnostic::new(Problem::MissingKey, "`dresser.designed_for` has no diameter")
                .field("dresser.designed_for.pitch_diameter")
                .allowed("pitch_diameter or tip_diameter, or both")
                .way_out("add the pitch diameter of the worm that the dresser was designed for"),
        );
    }
    inside_tip(
        "dresser.designed_for",
        there.pitch_diameter,
        there.tip_diameter,
        "leave one of the two out: it follows from the other",
        findings,
    );
}

/// One motion for both flanks makes value and slope of each; it needs both, and one lead.
fn two_flanks(job: &Job, findings: &mut Vec<Diagnostic>) {
    let mut refuse = |message: &str, field: &str, value: String, allowed: &str, way_out: &str| {
        findings.push(contradiction(message, field, value, allowed, way_out));
    };
    const ONE: &str = "dress one flank after the other: dressing.flanks = \"one\"";
    if job.grinding.flanks != Flanks::Both {
        let which = if job.grinding.flanks == Flanks::Left { "left" } else { "right" };
        refuse(
            "dressing both flanks with one motion takes a target on both",
            "grinding.flanks",
            format!("{which:?}"),
            "\"both\", or dressing.flanks = \"one\"",
            ONE,
        );
    }
    if job.worm.cone_angle_deg != 0.0 {
        refuse(
            "the flanks of a conical worm have different leads and are not dressed by one motion",
            "worm.cone_angle_deg",
            shown_number(job.worm.cone_angle_deg),
            "0, or dressing.flanks = \"one\"",
            ONE,
        );
    }
    if let Some(land) = job.dresser.as_ref().and_then(|d| d.tip_land) {
        refuse(
            "a dresser that touches both flanks at once has the tip land that they leave between them",
            "dresser.tip_land",
            shown_number(land),
            "no key, or dressing.flanks = \"one\"",
            "leave `tip_land` out",
        );
    }
    if job.dresser.as_ref().is_some_and(|d| d.designed_for.is_some()) {
        refuse(
            "a dresser designed for another worm takes another correction on each flank",
            "dresser.designed_for",
            "a table".into(),
            "no key, or dressing.flanks = \"one\"",
            ONE,
        );
    }
    if job.dressing.profile_crowning_by == ProfileCrowningBy::Correction {
        refuse(
            "one correction for both flanks makes value and slope of each, no profile crowning",
            "dressing.profile_crowning_by",
            "\"correction\"".into(),
            "\"auto\", \"dresser\" or \"diagonal\"",
            "let the dresser carry the profile crowning",
        );
    }
}
