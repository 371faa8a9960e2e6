//! Contradictions in `dressing.conditions`: four rows on the right flanks, with numbers that stay in range over the width of the worm.

use crate::job::{
    Condition, ConditionOf, ConditionWord, DegreeOfFreedom, Dressing, DressingFlanks, FixedCondition,
    OverWidth, SHARES, STRETCHES,
};
use dressing::MOST_ROWS;
use foundation::geometry::Flank;
use job::checks::contradiction;
use job::{Diagnostic, Problem, shown_number};

const CONDITIONS: &str = "dressing.conditions";

pub(super) fn check(dressing: &Dressing, findings: &mut Vec<Diagnostic>) {
    let (rows, weighed) = (dressing.rows(), dressing.weighed_rows());
    let counted = if weighed > 0 { of_weights(rows, weighed, findings) } else { rows == 4 };
    if weighed == 0 && rows != 4 {
        findings.push(
            Diagnostic::new(Problem::InvalidJob, format!("the dressing conditions give {rows} equations for 4 motions"))
                .field(CONDITIONS)
                .value(rows)
                .allowed("4: `three-point` counts 3, `four-point` 4, every other condition and every motion left out of \
                     `degrees_of_freedom` 1; or more, some of them with a weight")
                .way_out("use [\"three-point\", \"radius-map\"], the default"),
        );
    }
    let asks_profile = |condition: &Condition| {
        matches!(
            condition,
            Condition::Word(ConditionWord::ThreePoint | ConditionWord::FourPoint)
                | Condition::Of(ConditionOf::Point(_))
        )
    };
    if counted && !dressing.conditions.iter().any(asks_profile) {
        let names: Vec<String> = dressing.conditions.iter().map(name).collect();
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "the dressing conditions ask for no profile")
                .field(CONDITIONS)
                .value(names.join(", "))
                .allowed("among them \"three-point\", \"four-point\" or { kind = \"point\", .. }")
                .way_out("use [\"three-point\", \"radius-map\"], the default"),
        );
    }
    if dressing.flanks == DressingFlanks::Two {
        if !dressing.has_usual_conditions() {
            of_two_flanks(dressing, findings);
        }
    } else {
        for (at, _) in named_flanks(dressing).filter(|(_, flank)| flank.is_some()) {
            findings.push(contradiction(
                "each flank is dressed with a motion of its own, which the condition serves on both",
                format!("{at}.flank"),
                "given".into(),
                "no key, or dressing.flanks = \"two\"",
                "leave `flank` out",
            ));
        }
    }
    for (k, condition) in dressing.conditions.iter().enumerate() {
        if let Condition::Of(condition) = condition {
            numbers(&format!("{CONDITIONS}[{k}]"), condition, dressing, findings);
        }
    }
}

/// Conditions with weights: those without leave a motion free, and all together determine the four.
fn of_weights(rows: usize, weighed: usize, findings: &mut Vec<Diagnostic>) -> bool {
    let exact = rows - weighed;
    let (message, value, allowed, way_out) = if exact > 3 {
        let held = format!("{exact} conditions without weight");
        let message = "the conditions without weight hold all motions, and leave nothing to those with one";
        (
            message,
            held,
            "at most 3 without weight".to_owned(),
            "give one more of them a weight, e.g. weight = 1",
        )
    } else if !(4..=MOST_ROWS).contains(&rows) {
        let allowed = format!(
            "4 to {MOST_ROWS}: `three-point` counts 3, `four-point` 4, every other condition and every motion left out of \
             `degrees_of_freedom` 1"
        );
        let message = "conditions with weights have another number of equations";
        (
            message,
            format!("{rows} equations"),
            allowed,
            "add points of the profile with a weight, or take some away",
        )
    } else {
        return true;
    };
    let finding = Diagnostic::new(Problem::InvalidJob, message).field(CONDITIONS).value(value);
    findings.push(finding.allowed(allowed).way_out(way_out));
    false
}

fn name(condition: &Condition) -> String {
    match condition {
        Condition::Word(word) => format!("{word:?}"),
        Condition::Of(ConditionOf::Point(_)) => "point".into(),
        Condition::Of(ConditionOf::Map(_)) => "map".into(),
        Condition::Of(ConditionOf::Stretch(_)) => "stretch".into(),
        Condition::Of(ConditionOf::Head(_)) => "head".into(),
        Condition::Of(ConditionOf::Fixed(_)) => "fixed".into(),
    }
}

/// Place and flank of the conditions that stand on one.
fn named_flanks(dressing: &Dressing) -> impl Iterator<Item = (String, Option<Flank>)> {
    dressing.conditions.iter().enumerate().filter_map(|(k, condition)| {
        let flank = match condition {
            Condition::Of(ConditionOf::Point(point)) => point.flank,
            Condition::Of(ConditionOf::Map(map)) => map.flank,
            Condition::Of(ConditionOf::Stretch(stretch)) => stretch.flank,
            _ => return None,
        };
        Some((format!("{CONDITIONS}[{k}]"), flank))
    })
}

/// One motion for both flanks takes conditions that say which flank they mean.
fn of_two_flanks(dressing: &Dressing, findings: &mut Vec<Diagnostic>) {
    let of_one = |condition: &Condition| {
        matches!(
            condition,
            Condition::Word(ConditionWord::ThreePoint | ConditionWord::FourPoint | ConditionWord::RadiusMap)
        )
    };
    for (k, word) in dressing.conditions.iter().enumerate().filter(|(_, condition)| of_one(condition)) {
        findings.push(contradiction(
            "one motion for both flanks has conditions that say which flank they mean",
            format!("{CONDITIONS}[{k}]"),
            name(word),
            "tables { kind = \"point\", at = .., flank = .. }; no conditions and no degrees_of_freedom: two points on each flank",
            "leave `conditions` out, or name the flank of each point",
        ));
    }
    for (at, flank) in named_flanks(dressing) {
        if flank.is_none() {
            findings.push(
                Diagnostic::new(
                    Problem::MissingKey,
                    "one motion serves both flanks; the condition names none",
                )
                .field(format!("{at}.flank"))
                .allowed("\"left\" or \"right\"")
                .way_out("say on which flank the condition stands"),
            );
        }
    }
    let points_on = |flank: Flank| {
        let on = |condition: &&Condition| matches!(condition, Condition::Of(ConditionOf::Point(p)) if p.flank == Some(flank));
        dressing.conditions.iter().filter(on).count()
    };
    for flank in Flank::BOTH.into_iter().filter(|&flank| points_on(flank) == 0) {
        findings.push(contradiction(
            "both flanks are dressed, and no point is met on one of them",
            CONDITIONS,
            format!("no point on the {flank} flank"),
            "a point on each flank, or dressing.flanks = \"one\"",
            "add { kind = \"point\", at = 0.5, flank = .. } for it",
        ));
    }
}

/// Numbers that leave their range somewhere over the width, and those of an axis in the unit of another.
fn numbers(at: &str, condition: &ConditionOf, dressing: &Dressing, findings: &mut Vec<Diagnostic>) {
    let mut within = |key: &str, law: &OverWidth, range: [f64; 2]| {
        if let Some(value) = law.beyond(range) {
            findings.push(contradiction(
                "the number leaves its range over the width of the worm",
                format!("{at}.{key}"),
                shown_number(value),
                &format!("{} to {} for all q from -1 to 1", shown_number(range[0]), shown_number(range[1])),
                "give smaller coefficients",
            ));
        }
    };
    match condition {
        ConditionOf::Point(point) => within("at", &point.at, SHARES),
        ConditionOf::Map(map) => {
            within("at", &map.at, SHARES);
            within("dresser", &map.dresser, SHARES);
        }
        ConditionOf::Stretch(stretch) => within("percent", &stretch.percent, STRETCHES),
        ConditionOf::Head(_) => {}
        ConditionOf::Fixed(fixed) => of_axis(at, fixed, dressing, findings),
    }
}

fn of_axis(at: &str, fixed: &FixedCondition, dressing: &Dressing, findings: &mut Vec<Diagnostic>) {
    let turns = matches!(fixed.axis, DegreeOfFreedom::PhiS | DegreeOfFreedom::Gamma);
    let (right, wrong, given, missing) = if turns {
        ("deg", "mm", fixed.mm.is_some(), fixed.deg.is_none())
    } else {
        ("mm", "deg", fixed.deg.is_some(), fixed.mm.is_none())
    };
    if given {
        findings.push(contradiction(
            &format!("the correction of this axis is given in {right}"),
            format!("{at}.{wrong}"),
            "given".into(),
            &format!("no key: give {right}"),
            &format!("give `{right}` instead"),
        ));
    } else if missing {
        findings.push(
            Diagnostic::new(Problem::MissingKey, "the value of the correction is missing")
                .field(format!("{at}.{right}"))
                .allowed("a number, or a list of coefficients over the width")
                .way_out(format!("add `{right}`, e.g. 0")),
        );
    }
    if dressing.fixed().contains(&fixed.axis) {
        findings.push(contradiction(
            "the same axis is held twice",
            format!("{at}.axis"),
            format!("{:?}", fixed.axis.name()),
            "an axis that no other condition holds and `degrees_of_freedom` does not leave out",
            "name it once",
        ));
    }
}
