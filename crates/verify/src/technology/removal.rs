//! Strokes with their rates, the worm's load, parts between two dressings.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::compare::{Shares, count, largest_of, number, numbers, share, tables};
use super::input::Input;
use foundation::geometry::Flank;
use grinding_technology::{Cycle, STATIONS, Sense, WearMap, WidthUse};
use serde_json::Value;

const UM: f64 = 1e3;
/// Feeds over a stroke at which rates are given.
const FEEDS: usize = 9;

pub(super) fn check(
    cycle: &Cycle,
    input: &Input,
    expected: &mut Expected<'_>,
    to: &Shares,
    ledger: &mut Ledger,
) {
    let items = expected.objects("strokes", ledger);
    ledger.equal(expected.case(), "number of strokes", items.len().into(), cycle.strokes.len().into());
    for (k, item) in items.into_iter().enumerate().take(cycle.strokes.len()) {
        stroke(cycle, k, input, item, to, ledger);
    }
    let wear = cycle.wear();
    if let Some(mut item) = expected.object("wear", ledger) {
        let maps = wear.after(input.parts);
        for flank in Flank::BOTH {
            if let Some(side) = item.object(flank.name(), ledger) {
                map(&maps[flank], side, to, ledger);
            }
        }
        if let Some(mut by_parts) = item.object("largest_by_parts", ledger) {
            for parts in 1..=200 {
                let key = parts.to_string();
                if by_parts.peek(&key).is_some() {
                    number(&mut by_parts, &key, wear.largest_after(parts), to.wear, ledger);
                }
            }
            by_parts.finish(ledger);
        }
        item.finish(ledger);
    }
    if let Some(mut item) = expected.object("level", ledger) {
        let level = cycle.level(&input.zones());
        // One file writes mm^2 for the same figure.
        for key in ["wear_per_part_mm3", "wear_per_part_mm2"] {
            let Some(mut zones) = item.object(key, ledger) else { continue };
            for (zone, wear) in &level.wear_per_part {
                number(&mut zones, zone, *wear, to.volume, ledger);
            }
            zones.finish(ledger);
        }
        number(&mut item, "parts_real", level.parts, to.parts, ledger);
        item.optional(
            "roughing_zone_mm",
            level.roughing_zone,
            level.roughing_zone.map_or(0.0, |zone| to.parts * zone),
            ledger,
        );
        let by_width = cycle.parts_by_width(input.dressing().worm_width);
        match by_width {
            WidthUse::Parts(parts) => count(&mut item, "parts_by_width", parts as f64, to.parts, ledger),
            WidthUse::Unbounded => item.optional("parts_by_width", None, 0.0, ledger),
        }
        let by_map = wear.parts_by_map(by_width, input.allowed_Vw_map);
        count(&mut item, "parts_by_map", by_map as f64, to.parts, ledger);
        item.finish(ledger);
    }
}

fn stroke(cycle: &Cycle, k: usize, input: &Input, mut item: Expected<'_>, to: &Shares, ledger: &mut Ledger) {
    let figures = &cycle.strokes[k];
    let [n_1, n_2] = figures.speeds.map(|speed| 60.0 * speed);
    let [first, last] = figures.contact;
    let plain = [
        ("Delta_d_mm", figures.infeed.delta_d),
        ("Delta_phi_2_urad", 1e6 * figures.infeed.delta_phi_2),
        ("n_1_rpm", n_1),
        ("n_2_rpm", n_2),
        ("feed_mm_per_s", figures.feed),
        ("first_mm", first),
        ("last_mm", last),
        ("approach_mm", figures.approach),
        ("travel_mm", figures.travel),
    ];
    numbers(&mut item, &plain, to.relative, ledger);
    let sense = match figures.sense {
        Sense::Climb => "climb",
        Sense::Conventional => "conventional",
    };
    item.text("sense", sense, ledger);
    number(&mut item, "volume_mm3", figures.volume, to.volume, ledger);
    let feeds: [f64; FEEDS] = std::array::from_fn(|i| first + (last - first) * i as f64 / (FEEDS - 1) as f64);
    item.list_to("v_mm", &feeds, share(to.relative), ledger);
    rates(cycle, k, &feeds, &mut item, to, ledger);
    item.list_to("occupation_mm", &figures.occupation, share(to.relative), ledger);
    for flank in Flank::BOTH {
        let Some(mut side) = item.object(flank.name(), ledger) else { continue };
        let of_flank = &figures.flanks[flank];
        let plain = [
            ("a_max_um", UM * of_flank.deepest),
            ("contact_area_mm2", of_flank.contact_area),
            ("h_eq_um", UM * of_flank.chip_thickness),
        ];
        numbers(&mut side, &plain, to.relative, ledger);
        let lists = [
            ("D_e_mm", of_flank.distance),
            ("contact_length_mm", of_flank.contact_length),
            ("passage_um", of_flank.passage.map(|h| UM * h)),
            ("feed_mark_um", of_flank.feed_mark.map(|h| UM * h)),
            ("Q_w_prime_bound", of_flank.rate_bound),
        ];
        for (key, list) in lists {
            side.list_to(key, &list, share(to.relative), ledger);
        }
        let of_space = |&space: &usize| -> Vec<Vec<f64>> {
            let at = feeds.map(|v| cycle.specific_rate(k, flank, space, v));
            (0..STATIONS).map(|i| at.iter().map(|rates| rates[i]).collect()).collect()
        };
        let rates: Vec<_> = input.spaces.iter().map(of_space).collect();
        tables(&mut side, "Q_w_prime", &rates, (to.specific_rate, true), ledger);
        let volumes: Vec<f64> =
            input.spaces.iter().map(|&space| cycle.volume_of_space(k, flank, space)).collect();
        side.list_to("volume_of_space_mm3", &volumes, share(to.volume), ledger);
        side.finish(ledger);
    }
    item.finish(ledger);
}

/// Nodes of the rule by which the file integrates over the profile where the stock is the same everywhere: it has 4e-4 of the largest where
/// the section has kinks. The integrand is compared by that rule to the narrow tolerance of such stock, the rate itself to the wide one.
const NODES: usize = 24;

fn rates(
    cycle: &Cycle,
    k: usize,
    feeds: &[f64; FEEDS],
    item: &mut Expected<'_>,
    to: &Shares,
    ledger: &mut Ledger,
) {
    if let (true, Some(expected)) = (cycle.stock.is_constant(), item.peek("Q_w")) {
        let tolerance = to.constant_rate * largest_of(expected);
        let by_rule = feeds.map(|v| {
            let of_flank = |flank: Flank| {
                let engagement = &cycle.bodies.flanks[flank];
                let [from, to] = engagement.roll;
                let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
                let at = |(x, weight): (f64, f64)| {
                    let w = middle + half * x;
                    half * weight * engagement.area_density(w) * cycle.section_at(k, flank, (w, 0), v)
                };
                gauss_legendre(NODES).into_iter().map(at).sum::<f64>()
            };
            cycle.strokes[k].feed * cycle.bodies.teeth() * (of_flank(Flank::Left) + of_flank(Flank::Right))
        });
        let name = item.name("Q_w by the file's rule");
        for (expected, found) in super::super::expected::numbers(expected).into_iter().flatten().zip(by_rule)
        {
            ledger.number(item.case(), &name, expected, found, tolerance);
        }
    }
    item.list_relative_to_largest("Q_w", &feeds.map(|v| cycle.rate(k, v)), to.rate, ledger);
}

/// Nodes on [-1, 1] with their weights.
fn gauss_legendre(n: usize) -> Vec<(f64, f64)> {
    // P_n and its derivative.
    let legendre = |x: f64| {
        let (mut before, mut now) = (1.0, x);
        for k in 2..=n {
            let k = k as f64;
            (before, now) = (now, ((2.0 * k - 1.0) * x * now - (k - 1.0) * before) / k);
        }
        (now, n as f64 * (before - x * now) / (1.0 - x * x))
    };
    let node = |i: usize| {
        let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
        for _ in 0..20 {
            let (value, slope) = legendre(x);
            x -= value / slope;
        }
        let (_, slope) = legendre(x);
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..n).map(node).collect()
}

/// Bins that one of both leaves out count as 0.
fn map(actual: &WearMap, mut item: Expected<'_>, to: &Shares, ledger: &mut Ledger) {
    let first = item.peek("first_bin").and_then(Value::as_i64).unwrap_or(actual.first_bin);
    item.number("first_bin", actual.first_bin as f64, 1.0, ledger);
    number(&mut item, "largest", actual.largest(), to.wear, ledger);
    if let Some(value) = item.take("V_w_prime") {
        let tolerance = to.wear * largest_of(value);
        let rows = value.as_array().map_or(&[] as &[Value], Vec::as_slice);
        ledger.equal(
            item.case(),
            &item.name("V_w_prime stations"),
            rows.len().into(),
            actual.removed.len().into(),
        );
        for (i, expected) in rows.iter().enumerate() {
            let name = item.name(&format!("V_w_prime[{i}]"));
            let Some(expected) = super::super::expected::numbers(expected) else {
                ledger.fail(item.case(), &name, expected.clone(), "a list of numbers is needed here".into());
                continue;
            };
            let given = [first, first + expected.len() as i64];
            let [low, high] = actual.ends();
            for bin in given[0].min(low)..given[1].max(high) {
                let there = usize::try_from(bin - first).ok().and_then(|k| expected.get(k));
                let (expected, found) = (there.copied().unwrap_or(0.0), actual.value(i, bin));
                ledger.number(item.case(), &format!("{name} bin {bin}"), expected, found, tolerance);
            }
        }
    }
    item.finish(ledger);
}
