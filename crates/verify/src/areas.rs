//! 25-modifications: areas of different diagonal ratio on flank and worm, inactive threads, equal swivel of the dresser.

use super::expected::Expected;
use super::gear_sets::{Set, entries};
use super::ledger::Ledger;
use super::reference::{Reference, Tolerances};
use foundation::geometry::{Flank, Sides};
use foundation::modification::{CornerFace, CornerProfile, FlankChoice, TriangularSpec};
use generating::areas::{
    AreaPlan, AreaTask, FeedInterval, FeedSegment, Region, SharedLines, conflicts, feed_intervals,
};
use generating::{EqualSwivel, FlankLines, GeneratingError, Strokes, SwivelSide};
use serde::Deserialize;
use serde_json::{Value, json};

const UM: f64 = 1e-3;

/// The gear that an entry names under `gear`.
fn gear(file: &Reference<'_>, item: &mut Expected<'_>, ledger: &mut Ledger) -> Option<Set> {
    let name = item.given_text("gear", ledger)?;
    Set::read(name, &file.root["gears"][name], ledger)
}

fn axial_lines(set: &Set, flank: Flank) -> Result<FlankLines, GeneratingError> {
    set.lines(flank, set.worm_line(flank)?.rho.tan())
}

/// Compares two texts, one of them in the file.
fn text(item: &mut Expected<'_>, key: &str, actual: &str, ledger: &mut Ledger) {
    if let Some(expected) = item.take(key) {
        ledger.equal(item.case(), key, expected.clone(), actual.into());
    }
}

/// Block `equal_swivel`.
pub(super) fn equal_swivel(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let list = Value::Array(vec![block.clone()]);
    entries("equal_swivel", &list, ledger, |item, ledger| {
        let relative = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null)).get("relative");
        let Some(set) = gear(file, item, ledger) else { return Ok(()) };
        let mut pair = |key| {
            let mut sides = item.object(key, ledger)?;
            let values = Flank::BOTH.map(|flank| sides.given(flank.name(), ledger));
            sides.finish(ledger);
            let [Some(left), Some(right)] = values else { return None };
            Some(Sides { left, right })
        };
        let amounts = ["C_beta_um", "C_alpha_um", "twist_um", "gain"].map(&mut pair);
        let [Some(helix), Some(profile), Some(twist), Some(gain)] = amounts else { return Ok(()) };
        let sides = Sides::try_from_fn(|flank| {
            let lines = axial_lines(&set, flank)?;
            let [w_f, w_a] = lines.roll;
            let [z_1, z_2] = lines.face;
            let (l_a, l_b) = (w_a - w_f, z_2 - z_1);
            let crowning = |amount: f64, length: f64| -4.0 * amount * UM / (length * length);
            let second_degree = [
                crowning(profile[flank], l_a),
                -twist[flank] * UM / (l_a * l_b),
                crowning(helix[flank], l_b),
            ];
            Ok::<_, GeneratingError>(SwivelSide { lines, second_degree, gain: gain[flank] })
        })?;
        match generating::equal_swivel(&sides)? {
            EqualSwivel::Ratio(ratio) => {
                item.number("K_ZV1", ratio, relative * ratio.abs(), ledger);
                let rates = sides.map(|_, side| side.rate(ratio));
                item.number("rate_left", rates.left, relative * rates.left.abs(), ledger);
                item.number("rate_right", rates.right, relative * rates.right.abs(), ledger);
            }
            EqualSwivel::Every => item.refused(&"every ratio gives equal swivel", ledger),
        }
        Ok(())
    });
}

/// One entry of `triangles`: flank, profile end, face, length in w, length in z.
#[derive(Deserialize)]
struct Triangle(Flank, CornerProfile, CornerFace, f64, f64);

/// Block `areas`.
pub(super) fn areas(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    entries("areas", block, ledger, |item, ledger| {
        if let Some(name) = item.given_text("name", ledger) {
            item.rename(name);
        }
        let tolerance = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null)).get("mm");
        let Some(set) = gear(file, item, ledger) else { return Ok(()) };
        let numbers = ["K_free", "usable_worm_length_mm"].map(|key| item.given(key, ledger));
        let flanks = item.take("flanks").and_then(|v| Vec::<Flank>::deserialize(v).ok());
        let triangles = item.take("triangles").and_then(|v| Vec::<Triangle>::deserialize(v).ok());
        let ([Some(free_ratio), Some(usable)], Some(flanks), Some(triangles)) = (numbers, flanks, triangles)
        else {
            item.refused(&"flanks, triangles, K_free and usable_worm_length_mm are needed", ledger);
            return Ok(());
        };
        let lines = Sides::try_from_fn(|flank| {
            flanks.contains(&flank).then(|| axial_lines(&set, flank)).transpose()
        })?;
        let mut regions = Vec::new();
        for Triangle(flank, corner_profile, corner_face, length_w_mm, length_z_mm) in triangles {
            let relief = TriangularSpec {
                amount_um: 1.0,
                corner_profile,
                corner_face,
                length_w_mm,
                length_z_mm,
                exponent: 1.0,
                transition: 0.0,
                flank: FlankChoice::Both,
                reference: Default::default(),
            };
            regions.push(Region::of_triangular_relief(&relief, &axial_lines(&set, flank)?)?);
        }
        let task = AreaTask { lines, regions, free_ratio };
        let Some(mut expected) = item.object("expected", ledger) else { return Ok(()) };
        compare(&task, usable, tolerance, &mut expected, ledger);
        expected.finish(ledger);
        Ok(())
    });
}

fn compare(task: &AreaTask, usable: f64, tolerance: f64, expected: &mut Expected<'_>, ledger: &mut Ledger) {
    let intervals = match feed_intervals(task) {
        Ok(intervals) => intervals,
        Err(error) => return expected.refused(&error, ledger),
    };
    compare_intervals(&intervals, tolerance, expected, ledger);
    if let Some(pairs) = expected.take("conflict") {
        ledger.equal(expected.case(), "conflict", pairs.clone(), json!(conflicts(&intervals)));
    }
    let fields = task.lines.iter().filter_map(|(_, lines)| lines.as_ref());
    let feeds = fields.flat_map(|lines| lines.corners().map(|(w, z)| lines.path_feed(w, z)));
    let range = feeds.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [v.min(a), v.max(b)]);
    expected.list("z_V2_range_mm", &range, tolerance, ledger);
    let plan = task.plan();
    let error = match &plan {
        Ok(plan) => {
            compare_plan(plan, usable, tolerance, expected, ledger);
            plan.check_exclusive().err()
        }
        Err(error) => Some(error.clone()),
    };
    // Only refusals that the file knows by name; anything else leaves its expected quantities unknown.
    let name = match error {
        None => None,
        Some(GeneratingError::AreasOverlap { .. }) => Some("AreasOverlap"),
        Some(GeneratingError::WormLinesShared { .. }) => Some("WormLinesShared"),
        Some(error) => return expected.refused(&error, ledger),
    };
    match name {
        Some(name) => text(expected, "error", name, ledger),
        None => {
            if expected.peek("error").is_some() {
                text(expected, "error", "none", ledger);
            }
        }
    }
    if name.is_some() && expected.peek("error").is_none() {
        ledger.fail(expected.case(), "error", Value::Null, name.into());
    }
}

fn compare_intervals(
    intervals: &[FeedInterval],
    tolerance: f64,
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) {
    let mut entries = expected.objects("intervals", ledger);
    count(expected, "intervals", entries.len(), intervals.len(), ledger);
    for (entry, actual) in entries.iter_mut().zip(intervals) {
        text(entry, "flank", actual.flank.name(), ledger);
        entry.numbers(
            &[
                ("z_V2_from_mm", actual.feed[0]),
                ("z_V2_to_mm", actual.feed[1]),
                ("K_ZV1", actual.ratio),
                ("tan_rho_F2", actual.direction),
            ],
            tolerance,
            ledger,
        );
    }
    entries.into_iter().for_each(|entry| entry.finish(ledger));
}

/// Lists of the file and of the library must have equal length.
fn count(item: &Expected<'_>, key: &str, expected: usize, actual: usize, ledger: &mut Ledger) {
    ledger.equal(item.case(), &format!("number of {key}"), expected.into(), actual.into());
}

fn compare_plan(
    plan: &AreaPlan,
    usable: f64,
    tolerance: f64,
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) {
    compare_segments(&plan.segments, tolerance, expected, ledger);
    let (feeds, shifts) = plan.nodes();
    expected.list("z_V2_nodes_mm", &feeds, tolerance, ledger);
    expected.list("z_V1_nodes_mm", &shifts, tolerance, ledger);
    if let Some(mut ranges) = expected.object("worm_z1_range_mm", ledger) {
        for (flank, extent) in plan.extents.iter() {
            match extent {
                Some(extent) => ranges.list(flank.name(), &extent.z_1, tolerance, ledger),
                None if ranges.peek(flank.name()).is_some() => {
                    ranges.refused(&format!("the {flank} flank is not ground"), ledger);
                }
                None => {}
            }
        }
        ranges.finish(ledger);
    }
    expected.number("worm_length_mm", plan.length(), tolerance, ledger);
    expected.number("pitch_of_areas_mm", plan.pitch(), tolerance, ledger);
    compare_shared(&plan.shared, tolerance, expected, ledger);
    let areas = plan.areas_on(usable).map_or(0.0, |n| n as f64);
    expected.number("number_of_areas", areas, 0.0, ledger);
}

fn compare_segments(
    segments: &[FeedSegment],
    tolerance: f64,
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) {
    let mut entries = expected.objects("segments", ledger);
    count(expected, "segments", entries.len(), segments.len(), ledger);
    for (entry, actual) in entries.iter_mut().zip(segments) {
        text(entry, "kind", if actual.modified { "modified" } else { "free" }, ledger);
        let [from, to] = actual.feed;
        let numbers = [("z_V2_from_mm", from), ("z_V2_to_mm", to), ("K_ZV1", actual.ratio)];
        entry.numbers(&numbers, tolerance, ledger);
    }
    entries.into_iter().for_each(|entry| entry.finish(ledger));
}

fn compare_shared(shared: &[SharedLines], tolerance: f64, expected: &mut Expected<'_>, ledger: &mut Ledger) {
    let mut entries = expected.objects("exclusivity_violations", ledger);
    count(expected, "exclusivity_violations", entries.len(), shared.len(), ledger);
    for (entry, actual) in entries.iter_mut().zip(shared) {
        text(entry, "flank", actual.flank.name(), ledger);
        entry.numbers(
            &[
                ("region_z_V2_from_mm", actual.feed[0]),
                ("segment_z_V2_from_mm", actual.segment[0]),
                ("overlap_mm", actual.overlap),
            ],
            tolerance,
            ledger,
        );
    }
    entries.into_iter().for_each(|entry| entry.finish(ledger));
}

/// Block `left_out_threads`.
pub(super) fn left_out_threads(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let count = |value: &Value| value.as_u64().and_then(|n| usize::try_from(n).ok());
    entries("left_out_threads", block, ledger, |item, ledger| {
        let [threads, teeth] = ["threads", "teeth"].map(|key| item.take(key).and_then(count));
        let active = item.take("active").and_then(|v| Vec::<usize>::deserialize(v).ok());
        let (Some(threads), Some(teeth), Some(active)) = (threads, teeth, active) else {
            item.refused(&"threads, teeth and active threads are needed", ledger);
            return Ok(());
        };
        let strokes = Strokes::new(threads, teeth, &active)?;
        let Some(mut expected) = item.object("expected", ledger) else { return Ok(()) };
        expected.number("gcd", strokes.common_divisor as f64, 0.0, ledger);
        expected.number("strokes_per_pass", strokes.per_pass() as f64, 0.0, ledger);
        let offsets: Vec<f64> = strokes.index_pitches.iter().map(|&o| o as f64).collect();
        expected.list("index_pitches", &offsets, 0.0, ledger);
        // A share of two small whole numbers, rounded once in each program.
        expected.number("feed_factor", strokes.feed_factor, 1e-15, ledger);
        expected.finish(ledger);
        Ok(())
    });
}
