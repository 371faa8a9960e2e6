//! Every refusal with its code and what it says.

use super::setup::Choice;
use dressing::{DresserSection, DressingError, SectionPart, ShownWorm, ThreadSpace, WormFlank};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::DressingCorrection;

const STILL: DressingCorrection = [0.0; 4];

fn refused<T: std::fmt::Debug>(found: Result<T, DressingError>, code: &str, parts: &[&str]) {
    let error = found.unwrap_err();
    let text = error.to_string();
    assert_eq!(error.code(), code, "{text}");
    assert!(parts.iter().all(|part| text.contains(part)), "{text}");
    assert!(error.way_out().len() > 10);
}

#[test]
fn sections_that_do_not_exist_are_refused() {
    let choice = Choice::EXAMPLE;
    let tool = choice.tool();
    let of = |radius: f64| DresserSection::new(&tool, Flank::Left, radius);
    for radius in [f64::NAN, f64::INFINITY] {
        refused(of(radius), "invalid-number", &["dresser tip radius"]);
    }
    for radius in [90.0, 40.0, 0.0, -61.5] {
        refused(of(radius), "tip-outside-profile", &["left profile", "reaches from"]);
    }
    // Far beyond its tip a dresser for a narrow space is pointed.
    let long = choice.tool_beyond(2.0);
    refused(DresserSection::new(&long, Flank::Right, 66.5), "pointed-tip", &["cross below", "66.5"]);
}

#[test]
fn lands_limits_and_threads_that_do_not_exist_are_refused() {
    let choice = Choice::EXAMPLE;
    let tool = choice.tool();
    let section = DresserSection::new(&tool, Flank::Left, choice.tip_radius()).unwrap();
    let full = section.full_land();
    // The land runs between both flanks on the outside cylinder.
    for share in [0.0, 1.0] {
        let [r, _] = section.point(SectionPart::TipLand, share, full).unwrap();
        assert_eq!((r, section.tip_radius()), (61.5, 61.5));
    }
    for land in [-1e-6, full + 1e-6, f64::NAN, f64::INFINITY] {
        let found = section.counter_flank_clearance(&STILL, land, 0.into());
        refused(found, "tip-land", &[&format!("0 to {full:.4}")]);
    }
    for land in [0.0, full] {
        assert!(section.counter_flank_clearance(&STILL, land, 0.into()).is_ok());
    }
    for limit in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        refused(section.largest_tip_land(&STILL, limit, 0.into()), "invalid-number", &["least clearance"]);
    }
    for left_out in [5, u32::MAX] {
        let found = section.largest_tip_land(&STILL, 0.0, left_out.into());
        refused(found, "invalid-number", &["inactive threads", "fewer than"]);
    }
    for width in [[1.0, 0.0], [f64::NAN, 1.0], [0.0, f64::INFINITY]] {
        let space = ThreadSpace { left_out: 0, width: Some(width) };
        refused(section.counter_flank(&STILL, 1.0, space), "invalid-number", &["worm width"]);
    }
    for j in 0..4 {
        let mut dk = STILL;
        dk[j] = f64::NAN;
        refused(section.counter_flank(&dk, 1.0, 0.into()), "invalid-number", &["d_"]);
    }
    // A disc that stands across the thread touches it with no circle of its flank.
    refused(section.counter_flank(&[0.0, 0.9, 0.0, 0.0], 1.0, 0.into()), "no-contact", &["left flank"]);
    refused(section.point(SectionPart::TipLand, 1.1, 1.0), "invalid-number", &["0 .. 1"]);
}

#[test]
fn a_conical_worm_needs_its_width() {
    let choice = Choice { cone: 2.0, ..Choice::EXAMPLE };
    let tool = choice.tool();
    let section = DresserSection::new(&tool, Flank::Left, choice.tip_radius()).unwrap();
    let found = section.largest_tip_land(&STILL, 0.0, 0.into());
    refused(found, "invalid-number", &["screw parameter", "width"]);
}

#[test]
fn other_worms_that_cannot_stand_there_are_refused() {
    let choice = Choice::EXAMPLE;
    let tool = choice.tool();
    let section = DresserSection::new(&tool, Flank::Left, choice.tip_radius()).unwrap();
    let flanks = |choice: &Choice| Sides::from_fn(|flank| choice.flank(flank));
    let of = |worm: Sides<WormFlank>, b: f64| section.undermining(&STILL, 1.0, &worm, &[0.0, b]);
    refused(of(flanks(&Choice { threads: 3, ..choice }), 0.0), "invalid-number", &["threads of the other"]);
    refused(of(flanks(&Choice { hand: -1.0, ..choice }), 0.0), "invalid-number", &["twist of the other"]);
    let good = flanks(&choice);
    let swapped = Sides { left: good.right, right: good.left };
    refused(of(swapped, 0.0), "invalid-number", &["left flank as left"]);
    let mut empty = good;
    empty.right.range.w_nf = empty.right.range.w_na;
    refused(of(empty, 0.0), "invalid-number", &["w_NfS of the other worm"]);
    refused(of(good, f64::NAN), "invalid-number", &["worm position b"]);
    for radii in [[50.0, 50.0], [f64::NAN, 53.0], [10.0, 53.0], [46.0, f64::INFINITY]] {
        let shown = ShownWorm { flanks: good, left_out: 0, radii, b: 0.0 };
        refused(section.outline(&STILL, 1.0, &shown), "invalid-number", &["root radius"]);
    }
    let shown = ShownWorm { flanks: good, left_out: 7, radii: [46.0, 53.0], b: 0.0 };
    refused(section.outline(&STILL, 1.0, &shown), "invalid-number", &["inactive threads"]);
}

/// A worm that the dresser does not reach is not undermined.
#[test]
fn what_is_out_of_reach_is_clear() {
    let choice = Choice { diameter: 200.0, ..Choice::EXAMPLE };
    let other = Choice { diameter: 60.0, ..choice };
    let tool = choice.tool();
    let section = DresserSection::new(&tool, Flank::Left, choice.tip_radius()).unwrap();
    let worm = Sides::from_fn(|flank| other.flank(flank));
    let found = section.undermining(&STILL, 1.0, &worm, &[0.0]).unwrap();
    for (flank, at) in found.iter() {
        assert!(at[0].is_none_or(|at| at.f > 5.0), "{flank} {at:?}");
    }
}
