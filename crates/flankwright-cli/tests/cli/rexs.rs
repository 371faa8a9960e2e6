//! What a drawing says beside the flanks, through a REXS model and back.

use crate::command::run;
use serde_json::json;
use std::fs;

#[test]
fn the_drawing_of_a_job_goes_to_rexs_and_back() {
    let directory = tempfile::tempdir().unwrap();
    let model = directory.path().join("measured-blank.rexs");
    let (job, model) = ("examples/cycles/measured-blank.toml", model.to_str().unwrap());
    let converted = run(&["convert", job, "-o", directory.path().to_str().unwrap()]);
    assert_eq!(converted.exit, Some(0), "{converted:?}");
    let told = converted.message() + &converted.stdout;
    assert!(told.contains("gear.measured_over is not exported") && !told.contains("allowances"), "{told}");
    let text = fs::read_to_string(model).unwrap();
    for attribute in [
        "lower_backlash_allowance_referenced_to_span\" unit=\"mum\">-60<",
        "upper_backlash_allowance_referenced_to_span\" unit=\"mum\">-20<",
        "global_tolerance_class_iso_1328_2013\" unit=\"none\">5<",
        "root_form_diameter\" unit=\"mm\">100.6<",
    ] {
        assert!(text.contains(attribute), "{attribute}\n{text}");
    }
    let back = run(&["convert", model, "--job", job]).json();
    let gear = &back["gear"];
    assert_eq!(gear["allowances_um"], json!({ "lower": -60.0, "upper": -20.0 }), "{gear}");
    assert_eq!(gear["span"], json!({ "teeth": 4, "length": 32.462 }), "{gear}");
    assert_eq!((&gear["tolerance_class"], &gear["form_diameter"]), (&json!(5), &json!(100.6)), "{gear}");
    // What the model has no place for is that of the same body.
    assert_eq!(gear["measured_over"]["ball_diameter"], 5.25, "{gear}");
    assert!(gear.get("profile_shift").is_none(), "{gear}");
}
