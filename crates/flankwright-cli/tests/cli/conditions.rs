//! Conditions of dressing with numbers of their own, as a user runs them: planned, refereed, refused.

use crate::command::{example, largest, plan_in, run_with};

const CONDITIONS: &str = "conditions = [\"three-point\", \"radius-map\"]";

/// A small job of both flanks with the given conditions.
fn job(conditions: &str) -> String {
    format!(
        r#"
[job]
name = "conditions"
process = "generating-grinding"

[gear]
teeth = 19
normal_module = 3.5
normal_pressure_angle_deg = 17.5
helix_angle_deg = 35.0
profile_shift = 0.0
face_width = 40.0
tip_diameter = 88.0
root_diameter = 72.4
form_diameter = 76.6

[target]
tolerance_um = 1.0
modifications = [{{ kind = "helix_crowning", amount_um = 6.0 }}, {{ kind = "profile_crowning", amount_um = 3.0 }}]

[worm]
threads = 5
hand = "right"
pitch_diameter = 100.0

[dresser]
tip_diameter = 123.0

[dressing]
{conditions}

[grinding]
method = "diagonal"
diagonal_ratio = -1.2

[grid]
profile_points = 9
helix_points = 5
"#
    )
}

/// Each set asks the dressing axes for other corrections, and the flank that the referee finds is the one that is planned.
#[test]
fn sets_of_conditions_are_met_in_their_own_ways() {
    let sets = [
        CONDITIONS,
        r#"conditions = [{ kind = "point", at = 0.05 }, { kind = "point", at = [0.5, 0.1] }, { kind = "point", at = 0.95 }, "radius-map"]"#,
        r#"conditions = ["three-point", { kind = "stretch", percent = [0.6, 0.3] }]"#,
        r#"conditions = ["three-point", { kind = "head", position = 0.5, thread = 1, above_um = [3.0, 1.0] }]"#,
        r#"conditions = [{ kind = "point", at = 0.1 }, { kind = "point", at = 0.9 }, "fix-gamma", "fix-v_y"]"#,
    ];
    let mut corrections = Vec::new();
    for conditions in sets {
        let directory = tempfile::tempdir().unwrap();
        let planned = plan_in(directory.path(), job(conditions), &[]);
        let result = planned.json();
        assert!(matches!(planned.exit, Some(0 | 3)), "{conditions}\n{planned:?}");
        assert!(largest(&result, "model_difference_um") < 0.05, "{conditions}: {result}");
        let series = result["settings"]["left"]["d_gamma_deg"].as_array().unwrap();
        corrections.push(series.iter().map(|c| c.as_f64().unwrap()).collect::<Vec<_>>());
    }
    for (k, one) in corrections.iter().enumerate() {
        assert!(corrections[..k].iter().all(|other| other != one), "{corrections:?}");
    }
    // Two axes that stay where they are: nothing but phase and distance moves.
    assert!(corrections[4].iter().all(|c| c.abs() < 1e-12), "{corrections:?}");
}

/// What a job says is left of a condition by its kind and place.
fn missed(result: &serde_json::Value, flank: &str, kind: &str, at: f64) -> f64 {
    let of = |condition: &&serde_json::Value| {
        condition["flank"] == flank && condition["kind"] == kind && condition["at"][0] == at
    };
    let all = result["settings"]["dressing_conditions"].as_array().unwrap();
    all.iter().find(of).unwrap_or_else(|| panic!("{kind} {at}: {all:?}"))["largest_miss"].as_f64().unwrap()
}

/// More points than motions on a plain dresser: the exact one is met, a heavier one nearer than a lighter, which costs travel of the offset, and the
/// flank that the referee finds is the one that is planned.
#[test]
fn weighed_conditions_are_met_as_nearly_as_their_weights_ask() {
    let of = |weight: f64| {
        let weighed = format!("at = 0.0, weight = {weight:.1}");
        let text = example("dressing/weighed-points.toml").replace("at = 0.0, weight = 1.0", &weighed)
            + "\n[grid]\nprofile_points = 9\nhelix_points = 9\n";
        let directory = tempfile::tempdir().unwrap();
        let planned = plan_in(directory.path(), text, &[]);
        assert!(matches!(planned.exit, Some(0 | 3)), "{planned:?}");
        let result = planned.json();
        assert!(largest(&result, "model_difference_um") < 0.05, "{result}");
        result
    };
    let (light, heavy) = (of(1.0), of(20.0));
    for result in [&light, &heavy] {
        assert!(missed(result, "left", "point", 0.5) < 1e-4, "{result}");
    }
    let (before, after) = (missed(&light, "left", "point", 0.0), missed(&heavy, "left", "point", 0.0));
    assert!(before > 0.02 && after < 0.5 * before, "{before} {after}");
    let other = |result| missed(result, "left", "v_y", 0.0);
    assert!(other(&heavy) > other(&light), "{} {}", other(&heavy), other(&light));
}

/// A radius map that moves over the width lays the tip relief of a dresser that exists elsewhere on each transverse section.
#[test]
fn a_relief_that_a_map_moves_is_planned_as_the_referee_finds_it() {
    let directory = tempfile::tempdir().unwrap();
    let text = example("dressing/moved-relief.toml") + "\n[grid]\nprofile_points = 21\nhelix_points = 5\n";
    let planned = plan_in(directory.path(), text, &[]);
    assert_eq!(planned.exit, Some(0), "{planned:?}");
    let result = planned.json();
    assert!(largest(&result, "model_difference_um") < 0.05, "{result}");
}

/// What is changed, where the finding stands, and words of it.
type Case = (&'static str, &'static str, &'static [&'static str]);

#[test]
fn contradictions_in_conditions_are_told_in_full() {
    let cases: &[Case] = &[
        (r#"conditions = ["three-point"]"#, "dressing.conditions", &["3 equations", "4"]),
        (
            r#"conditions = ["three-point", "radius-map", { kind = "stretch", percent = 1.0 }]"#,
            "dressing.conditions",
            &["5 equations"],
        ),
        (
            r#"conditions = ["radius-map", "head", "fix-d", "fix-v_y"]"#,
            "dressing.conditions",
            &["no profile", "point"],
        ),
        (r#"conditions = ["three-point", { kind = "map", at = 1.0 }]"#, "dressing.conditions", &["dresser"]),
        (
            r#"conditions = ["three-point", { kind = "map", dresser = 1.0, at = 3.0 }]"#,
            "dressing.conditions",
            &["3", "1.5"],
        ),
        (
            r#"conditions = ["three-point", { kind = "map", dresser = 1.0, at = [1.0, 0.4, 0.4] }]"#,
            "dressing.conditions[1].at",
            &["1.8", "-0.5 to 1.5", "smaller coefficients"],
        ),
        (
            r#"conditions = ["three-point", { kind = "stretch", percent = [40.0, 20.0] }]"#,
            "dressing.conditions[1].percent",
            &["60", "-50 to 50"],
        ),
        (
            r#"conditions = ["three-point", { kind = "fixed", axis = "gamma", mm = 0.1 }]"#,
            "dressing.conditions[1].mm",
            &["given in deg", "give `deg` instead"],
        ),
        (
            r#"conditions = ["three-point", { kind = "fixed", axis = "v_y" }]"#,
            "dressing.conditions[1].mm",
            &["missing", "add `mm`"],
        ),
        (
            r#"conditions = [{ kind = "point", at = 0.5 }, { kind = "point", at = 0.9 }, "fix-d", { kind = "fixed", axis = "d", mm = 0.1 }]"#,
            "dressing.conditions[3].axis",
            &["held twice", "name it once"],
        ),
        (
            r#"conditions = ["three-point", { kind = "map", dresser = 1.0, at = 1.0, flank = "left" }]"#,
            "dressing.conditions[1].flank",
            &["motion of its own", "leave `flank` out"],
        ),
        (
            r#"conditions = ["three-point", { kind = "map", dresser = 1.0, at = 1.0, weight = 0.0 }]"#,
            "dressing.conditions",
            &["0", "1000", "met exactly"],
        ),
        (
            r#"conditions = ["four-point", { kind = "map", dresser = 1.0, at = 1.0, weight = 1.0 }]"#,
            "dressing.conditions",
            &["4 conditions without weight", "at most 3", "give one more of them a weight"],
        ),
        (
            r#"conditions = [{ kind = "point", at = 0.5, weight = 1.0 }, "radius-map", "fix-d"]"#,
            "dressing.conditions",
            &["3 equations", "4 to 12", "add points"],
        ),
        (
            r#"conditions = ["three-point", { kind = "head", position = 500.0 }]"#,
            "dressing.conditions",
            &["500", "200"],
        ),
        (
            "flanks = \"two\"\nconditions = [\"three-point\", { kind = \"point\", at = 0.5, flank = \"right\" }]",
            "dressing.conditions[0]",
            &["say which flank"],
        ),
        (
            "flanks = \"two\"\nconditions = [{ kind = \"point\", at = 0.1, flank = \"left\" }, { kind = \"point\", at = 0.5, flank = \"left\" }, { kind = \"point\", at = 0.9, flank = \"left\" }, { kind = \"point\", at = 0.5 }]",
            "dressing.conditions[3].flank",
            &["names none", "\"left\" or \"right\""],
        ),
        (
            "flanks = \"two\"\nconditions = [{ kind = \"point\", at = 0.1, flank = \"left\" }, { kind = \"point\", at = 0.5, flank = \"left\" }, { kind = \"point\", at = 0.9, flank = \"left\" }, { kind = \"point\", at = 0.7, flank = \"left\" }]",
            "dressing.conditions",
            &["no point on the right flank", "a point on each flank"],
        ),
    ];
    for (conditions, field, says) in cases {
        let answer = run_with(&["check", "-", "--json"], job(conditions).as_bytes());
        let about = format!("{conditions}\n{}", answer.stdout);
        assert_eq!(answer.exit, Some(2), "{about}");
        let answer = answer.json();
        let errors = answer["errors"].as_array().cloned().unwrap_or_else(|| vec![answer["error"].clone()]);
        let found = errors.iter().find(|error| error["field"].as_str().unwrap_or("").starts_with(field));
        let found = found.unwrap_or_else(|| panic!("no finding on {field}: {about}"));
        let text = found.to_string();
        assert!(
            says.iter().all(|part| text.contains(part) || text.contains(&part.replace('"', "\\\""))),
            "{about}"
        );
        assert!(!found["way_out"].as_str().unwrap_or("").is_empty(), "{about}");
    }
}

#[test]
fn a_map_that_moves_a_dresser_needs_a_ratio_that_is_known() {
    let directory = tempfile::tempdir().unwrap();
    let text =
        example("dressing/moved-relief.toml").replace("diagonal_ratio = -1.2", "diagonal_ratio = \"auto\"");
    let refused = plan_in(directory.path(), text, &[]);
    assert_eq!(refused.exit, Some(2), "{refused:?}");
    let error = &refused.json()["error"];
    assert_eq!(error["field"], "dressing.conditions", "{error}");
    assert!(error["way_out"].as_str().unwrap().contains("diagonal ratio"), "{error}");
}
