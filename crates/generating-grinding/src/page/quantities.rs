//! Data of gear, tools and settings as the page lists them.

use crate::workflow::prepare::PointDresser;
use crate::workflow::run::Outcome;
use dressing::stretch as profile_stretch;
use foundation::geometry::{Blank, Flank, Gear, Sides};
use report::Quantity;

/// Data of the gear as the page shows them.
pub fn gear_quantities(gear: &Gear, blank: &Blank, evaluation: [f64; 4]) -> Vec<Quantity> {
    let d = gear.data();
    let (l, r) = (gear.flank(Flank::Left), gear.flank(Flank::Right));
    vec![
        Quantity::count("number of teeth", "z", i64::from(d.teeth)),
        Quantity::number("normal module", "m_n", d.normal_module, "mm"),
        Quantity::per_flank(
            "normal pressure angle",
            "α_n",
            d.pressure_angle.left.to_degrees(),
            d.pressure_angle.right.to_degrees(),
            "deg",
        ),
        Quantity::number("helix angle", "β", d.helix_angle.to_degrees(), "deg"),
        Quantity::number("profile shift coefficient", "x", d.profile_shift, ""),
        Quantity::number("face width", "b", blank.face_width, "mm"),
        Quantity::number("tip diameter", "d_a", blank.tip_diameter, "mm"),
        Quantity::number("root form diameter", "d_Ff", blank.form_diameter, "mm"),
        Quantity::number("root diameter", "d_f", blank.root_diameter, "mm"),
        Quantity::number("evaluation from diameter", "", evaluation[0], "mm"),
        Quantity::number("evaluation to diameter", "", evaluation[1], "mm"),
        Quantity::number("evaluation from face position", "z", evaluation[2], "mm"),
        Quantity::number("evaluation to face position", "z", evaluation[3], "mm"),
        Quantity::per_flank("base diameter", "d_b", 2.0 * l.base_radius, 2.0 * r.base_radius, "mm"),
        Quantity::per_flank(
            "base helix angle",
            "β_b",
            l.base_helix_angle.to_degrees(),
            r.base_helix_angle.to_degrees(),
            "deg",
        ),
    ]
}

pub(super) fn tool_quantities(outcome: &Outcome) -> (Vec<Quantity>, Vec<Quantity>) {
    let setup = &outcome.prepared.setup;
    let worm = &setup.pair.worm;
    let mut of_worm = vec![
        Quantity::count("number of threads", "z_S", i64::from(worm.data().teeth)),
        Quantity::text("hand", if worm.data().helix_angle > 0.0 { "right" } else { "left" }),
        Quantity::number("normal module", "m_nS", worm.data().normal_module, "mm"),
        Quantity::per_flank(
            "normal pressure angle",
            "α_nS",
            worm.data().pressure_angle.left.to_degrees(),
            worm.data().pressure_angle.right.to_degrees(),
            "deg",
        ),
        Quantity::number("pitch diameter", "d_S", 2.0 * setup.worm_pitch_radius, "mm"),
        Quantity::number("tip diameter", "d_aS", 2.0 * setup.worm_tip_radius, "mm"),
        Quantity::number("root diameter", "d_fS", 2.0 * setup.worm_root_radius, "mm"),
        Quantity::number("lead angle", "γ", 90.0 - worm.data().helix_angle.to_degrees().abs(), "deg"),
        Quantity::number("worm length used", "", outcome.result.settings.worm_length_mm, "mm"),
    ];
    of_worm.extend(setup.input.worm_width.map(|w| Quantity::number("worm width", "", w, "mm")));
    of_worm.extend(outcome.result.spared_worms.as_ref().map(|spared| {
        let down_to = spared.spared_down_to_mm;
        Quantity::number(
            "smaller worms left whole by this dressing, down to tip diameter",
            "d_aS",
            down_to,
            "mm",
        )
    }));
    let dressing = &outcome.prepared.dressing;
    if let Some(point) = &dressing.point {
        return (of_worm, point_dresser_quantities(outcome, point));
    }
    let (Some(dresser), Some(choice)) = (&outcome.execution.dresser, &setup.input.dresser) else {
        return (of_worm, vec![Quantity::text("tool", "not dressed: its flanks are given as tables")]);
    };
    let chain = &dresser.flanks.left.chain;
    let modified = dresser.flanks.iter().any(|(_, flank)| flank.profile.offset().is_some());
    let mut of_dresser = vec![
        Quantity::number("tip diameter", "d_aA", choice.tip_diameter, "mm"),
        Quantity::number("nominal centre distance", "d_A0", chain.centre_distance, "mm"),
        Quantity::number("nominal crossing angle", "γ_A0", chain.crossing_angle.to_degrees(), "deg"),
        Quantity::text(
            "profile",
            match (&choice.designed_for, modified) {
                (None, true) if setup.strokes.is_some() => "conjugate to the worm, with its own modification",
                (None, true) => "conjugate to the worm, with the profile modifications of the target",
                (None, false) => "conjugate to the unmodified worm",
                (Some(_), true) => "conjugate to the worm it was designed for, with its own modification",
                (Some(_), false) => "conjugate to the unmodified worm it was designed for",
            },
        ),
    ];
    for (k, &tip_diameter) in dressing.other_tip_diameters.iter().enumerate() {
        let name = format!("tip diameter of dresser {}", k + 2);
        of_dresser.push(Quantity::number(&name, "d_aA", tip_diameter, "mm"));
    }
    if let (Some(designed), Ok(settled)) = (&choice.designed_for, setup.dresser()) {
        of_dresser.push(Quantity::count("designed for threads", "z_S", i64::from(designed.threads)));
        of_dresser.extend(
            designed.pitch_diameter.map(|d| Quantity::number("designed for pitch diameter", "d_S", d, "mm")),
        );
        of_dresser.extend(
            designed.tip_diameter.map(|d| Quantity::number("designed for tip diameter", "d_aS", d, "mm")),
        );
        let stretch = settled.flanks.map(|flank, _| profile_stretch(settled, flank, [0.0; 4]).ok());
        if let Sides { left: Some(left), right: Some(right) } = stretch {
            of_dresser.push(Quantity::per_flank("profile stretch", "P", 100.0 * left, 100.0 * right, "%"));
        }
    }
    let lands = outcome.result.settings.largest_tip_land_mm;
    let least = lands.iter().flat_map(|lands| [lands.left, lands.right]).flatten().reduce(f64::min);
    of_dresser
        .extend(least.map(|land| Quantity::number("largest tip land without collision", "b_A", land, "mm")));
    of_dresser.extend(dressing.tip_land.map(|land| Quantity::number("tip land", "b_A", land, "mm")));
    (of_worm, of_dresser)
}

/// The disc in point contact and what its lines come to.
fn point_dresser_quantities(outcome: &Outcome, point: &PointDresser) -> Vec<Quantity> {
    let mut list = vec![
        Quantity::text("contact", "in a point, line by line"),
        Quantity::number("tip diameter", "d_aA", point.tip_diameter, "mm"),
        Quantity::number("tip radius", "r_T", point.tip_radius, "mm"),
    ];
    for (flank, written) in outcome.written.iter() {
        let Some(r) = written.as_ref().map(|w| &w.result) else { continue };
        let named = |what: &str| format!("{flank} flank: {what}");
        let count = i64::try_from(r.lines).unwrap_or(i64::MAX);
        list.extend([
            Quantity::number(&named("direction of the lines"), "ρ_1", r.line_direction_deg, "deg"),
            Quantity::count(&named("lines a thread"), "", count),
            Quantity::number(&named("pitch of the lines"), "p_X", r.pitch_mm, "mm"),
            Quantity::number(&named("contact path a thread"), "", r.path_length_m, "m"),
            Quantity::number(&named("scallops by curvature"), "", r.scallop_um, "µm"),
            Quantity::number(&named("scallops by rays"), "", r.simulated_scallop_um, "µm"),
            Quantity::number(&named("room at the opposite flank"), "", r.clearance_mm, "mm"),
        ]);
    }
    list
}

pub(super) fn settings_quantities(outcome: &Outcome) -> Vec<Quantity> {
    let s = &outcome.result.settings;
    let mut list = vec![
        Quantity::number("centre distance", "d", s.centre_distance_mm, "mm"),
        Quantity::number("crossed-axes angle", "γ", s.crossed_axes_angle_deg, "deg"),
        Quantity::number("diagonal ratio", "K", s.settings.diagonal_ratio, ""),
        Quantity::number("tool shift at z_V2 = 0", "z_V01", s.settings.shift_origin_mm, "mm"),
        Quantity::number("feed stroke from", "z_V2", s.feed_stroke_mm[0], "mm"),
        Quantity::number("feed stroke to", "z_V2", s.feed_stroke_mm[1], "mm"),
    ];
    if let Some(Sides { left: Some(l), right: Some(r) }) = s.lead_correction_ratio {
        list.push(Quantity::per_flank("lead-correction ratio", "K*", l, r, ""));
    }
    if let Some(place) = s.profile_crowning_by {
        list.push(Quantity::text("profile crowning made by", place));
    }
    if let Some(partition) = &s.partition {
        list.push(Quantity::number("length of an area on the tool", "", partition.area_length_mm, "mm"));
        list.push(Quantity::number("pitch of areas", "P", partition.area_pitch_mm, "mm"));
        let count = |n: usize| i64::try_from(n).unwrap_or(i64::MAX);
        list.extend(
            partition.areas_that_fit.map(|n| Quantity::count("finishing areas that fit", "n", count(n))),
        );
        if partition.roughing_areas > 0 {
            list.push(Quantity::count("roughing areas", "", count(partition.roughing_areas)));
        }
    }
    if let Some(strokes) = &s.index_strokes {
        let joined = |n: &[u32]| n.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
        list.push(Quantity::text("threads that grind", joined(&strokes.active_threads)));
        list.push(Quantity::text("index offsets of the strokes (pitches)", joined(&strokes.index_pitches)));
        list.push(Quantity::number("share of the full feed", "", strokes.feed_factor, ""));
    }
    if let Some(root) = &outcome.result.gear_root {
        list.push(Quantity::number("ground root diameter from", "d_fE", root.root_diameter_mm[0], "mm"));
        list.push(Quantity::number("ground root diameter to", "d_fE", root.root_diameter_mm[1], "mm"));
        list.push(Quantity::number(
            "tip diameter of the worm from",
            "d_aS",
            root.worm_tip_diameter_mm[0],
            "mm",
        ));
        list.push(Quantity::number(
            "tip diameter of the worm to",
            "d_aS",
            root.worm_tip_diameter_mm[1],
            "mm",
        ));
        for (flank, fillet) in root.flanks.iter() {
            let Some(fillet) = fillet else { continue };
            let of = |what: &str| format!("{what}, {flank}");
            list.push(Quantity::number(
                &of("fillet begins at diameter"),
                "d_Ff",
                fillet.form_diameter_mm,
                "mm",
            ));
            list.push(Quantity::number(
                &of("least radius of the fillet"),
                "ρ_F",
                fillet.least_radius_mm,
                "mm",
            ));
            list.push(Quantity::number(
                &of("fillet, plan against referee"),
                "",
                fillet.model_difference_um,
                "um",
            ));
        }
    }
    if let Some(feed) = outcome.prepared.cycle.feed_per_revolution {
        list.push(Quantity::number("feed per revolution of the gear", "", feed, "mm"));
    }
    list
}
