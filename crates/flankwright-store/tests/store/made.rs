//! Parts as an import makes them of measured gears: figures of twelve traces, of the lines, of the pitches.

use flankwright::geometry::Flank;
use flankwright_store::{CharacteristicValue, PartRecord, digest_of};
use serde_json::json;

/// A part of a series; what is measured is the same on all, the values differ.
pub fn part(number: u32) -> PartRecord {
    let mut characteristics = Vec::new();
    let mut push = |name: &str, flank, tooth, statistic: &str, limits: [Option<f64>; 2]| {
        let seed = f64::from(number) * 0.37 + characteristics.len() as f64;
        characteristics.push(CharacteristicValue {
            name: name.into(),
            flank,
            tooth,
            statistic: statistic.into(),
            value: 5.0 * seed.sin(),
            unit: "um".into(),
            lower_limit: limits[0],
            upper_limit: limits[1],
        });
    };
    for flank in Flank::BOTH {
        for tooth in [1, 18, 35] {
            for name in ["fHa", "Fa", "ffa", "Ca", "fKo", "fHb", "Fb", "ffb", "Cb"] {
                push(name, Some(flank), Some(tooth), "single", [None, None]);
            }
        }
        for name in ["fHa", "Fa", "ffa", "Ca", "fKo", "fHb", "Fb", "ffb", "Cb"] {
            push(name, Some(flank), None, "mean", [Some(-6.5), Some(6.5)]);
            push(name, Some(flank), None, "range", [None, None]);
        }
        for name in ["Fa", "ffa", "Fb", "ffb"] {
            push(name, Some(flank), None, "max", [None, Some(9.0)]);
        }
        for name in ["fp", "fu", "Rp", "Fp", "Fpk"] {
            push(name, Some(flank), None, "single", [None, Some(25.0)]);
        }
    }
    push("Fr", None, None, "single", [None, Some(22.0)]);
    push("Rs", None, None, "single", [None, None]);
    let cumulative: Vec<f64> =
        (0..51).map(|tooth| 8.0 * (f64::from(tooth) * 0.123 + f64::from(number)).sin()).collect();
    let traces: Vec<_> =
        characteristics.chunks(5).map(|five| json!({ "kind": "profile", "values": five })).collect();
    PartRecord {
        series: "Z-17".into(),
        part: number.to_string(),
        drawing: Some("Z-17".into()),
        date: Some(format!(
            "2026-03-{:02}T{:02}:{:02}:00",
            1 + number / 1440 % 28,
            number / 60 % 24,
            number % 60
        )),
        machine: Some("P40".into()),
        source: format!("part-{number}.mka"),
        digest: digest_of(&number.to_le_bytes()),
        document: json!({ "job": number.to_string(), "pitch": { "left": cumulative, "right": cumulative }, "traces": traces }),
        characteristics,
    }
}

/// Parts of consecutive numbers.
#[allow(dead_code, reason = "the bench makes its own")]
pub fn parts(numbers: std::ops::Range<u32>) -> Vec<PartRecord> {
    numbers.map(part).collect()
}
