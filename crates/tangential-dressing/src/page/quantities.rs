//! Amounts of the drawing, data of worm and dresser, settings and lengths as the page lists them.

use crate::ProfileKind;
use crate::job::EdgeAmounts;
use crate::workflow::prepare::Drawn;
use crate::workflow::{TangentialFlankResult, TangentialOutcome, TangentialPrepared};
use foundation::geometry::Flank;
use generating_grinding::page::{TargetAmount, target_amounts};
use report::Quantity;

pub(super) fn amounts(drawn: &Drawn, flank: Flank, f: &TangentialFlankResult) -> Vec<TargetAmount> {
    let edge = match drawn {
        Drawn::Modifications(specs) => return target_amounts(specs, flank, &f.flank.target_characteristics),
        Drawn::Edge(amounts) => amounts[flank],
    };
    let EdgeAmounts { pressure_angle_um, profile_crowning_um, lead_conical_um, lead_crowning_um } = edge;
    [
        ("pressure angle over the radius", pressure_angle_um),
        ("profile crowning over the radius", profile_crowning_um),
        ("lead conical", lead_conical_um),
        ("helix crowning", lead_crowning_um),
    ]
    .into_iter()
    .filter(|(_, um)| *um != 0.0)
    .map(|(name, um)| TargetAmount {
        name: name.into(),
        amount_um: Some(um),
        detail: "normal, at the edge of the evaluated range".into(),
    })
    .collect()
}

pub(super) fn worm_quantities(prepared: &TangentialPrepared) -> Vec<Quantity> {
    let worm = &prepared.model.pair.worm;
    let data = worm.data();
    let mut list = vec![
        Quantity::count("number of threads", "z_1", i64::from(data.teeth)),
        Quantity::text("hand", if data.helix_angle > 0.0 { "right" } else { "left" }),
        Quantity::number("pitch diameter", "d_1", 2.0 * worm.pitch_radius(), "mm"),
        Quantity::number("tip diameter", "d_a1", 2.0 * prepared.worm_tip_radius, "mm"),
        Quantity::number("lead angle", "λ", 90.0 - data.helix_angle.to_degrees().abs(), "deg"),
    ];
    list.extend(prepared.worm_width.map(|w| Quantity::number("worm width", "", w, "mm")));
    list
}

pub(super) fn dresser_quantities(outcome: &TangentialOutcome) -> Vec<Quantity> {
    let (s, prepared) = (&outcome.result.settings, &outcome.prepared);
    vec![
        Quantity::number("tip diameter", "d_aA", prepared.dresser_tip_diameter, "mm"),
        Quantity::number("pitch diameter", "d_A", s.dresser_pitch_diameter_mm, "mm"),
        Quantity::number("nominal centre distance", "d_A0", s.dressing_centre_distance_mm, "mm"),
        Quantity::number("nominal crossing angle", "γ_A0", s.dressing_crossing_angle_deg, "deg"),
        Quantity::text(
            "nominal profile",
            match prepared.model.input().profile {
                ProfileKind::Conjugate => "conjugate to the involute worm",
                ProfileKind::Straight => "straight line",
            },
        ),
    ]
}

pub(super) fn settings_quantities(outcome: &TangentialOutcome) -> Vec<Quantity> {
    let s = &outcome.result.settings;
    let mut list = vec![
        Quantity::number("centre distance", "d_0", s.centre_distance_mm, "mm"),
        Quantity::number("crossed-axes angle", "γ_0", s.crossed_axes_angle_deg, "deg"),
        Quantity::number("tool shift per feed", "κ", s.shift_ratio, ""),
        Quantity::number("scale along the worm", "b_w", s.shift_width_mm, "mm"),
    ];
    list.extend(s.neutral_shift_ratio.map(|k| Quantity::number("neutral shift ratio", "κ_0", k, "")));
    for (flank, k) in &s.neutral_shift_ratio_by_flank {
        list.push(Quantity::number(&format!("neutral shift ratio, {flank} flank"), "κ_0", *k, ""));
    }
    for (flank, offset) in &s.contact_shift_offset_mm {
        list.push(Quantity::number(&format!("shift that centres the {flank} flank"), "F_T0*", *offset, "mm"));
    }
    list
}

/// What is needed of the worm's length.
pub(super) fn worm_lengths(outcome: &TangentialOutcome) -> Vec<Quantity> {
    let result = &outcome.result;
    let s = &result.settings;
    let mut worm_length = Vec::new();
    for (flank, f) in &result.flanks {
        let [from, to] = f.dresser_position_mm;
        worm_length.push(Quantity::number(&format!("dresser position from, {flank}"), "x_D", from, "mm"));
        worm_length.push(Quantity::number(&format!("dresser position to, {flank}"), "x_D", to, "mm"));
        let [from, to] = f.worm_occupation_mm;
        worm_length.push(Quantity::number(&format!("worm used, {flank}"), "", to - from, "mm"));
    }
    let together = s.worm_length_one_after_the_other_mm;
    worm_length.push(Quantity::number("worm length, dressed again before every pass", "", together, "mm"));
    if s.worm_length_side_by_side_mm > together {
        let both = s.worm_length_side_by_side_mm;
        worm_length.push(Quantity::number("worm length, a zone for every pass", "", both, "mm"));
    }
    worm_length
}
