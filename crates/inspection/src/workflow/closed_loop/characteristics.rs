//! Which part of every characteristic all teeth share: slopes, crownings and twist of each flank against the target, tooth by tooth, and the
//! test of their means (`docs/mathematics/inspection.md#what-all-teeth-share`). Normal to the flank, mm; slopes of material towards tip and
//! upper face.

use super::super::evaluate::EvaluatedGear;
use super::super::middle::at_middle;
use super::super::readings::readings;
use super::super::twist::{Line, twist_of};
use foundation::geometry::{Flank, Sides};
use generating_grinding::job::Inspection as InspectionTable;
use measured_files::inspection::{Inspection, Trace, TraceKind};
use metrology::areal::{ArealDegree, ArealField, ArealFit, ArealPoint};
use metrology::inspection::TraceEvaluation;
use metrology::systematic::{SystematicError, SystematicOptions, SystematicTest, systematic_test};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A characteristic of a flank.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Characteristic {
    /// f_Ha over the evaluated profile.
    ProfileSlope,
    /// C_alpha.
    ProfileCrowning,
    /// f_Hb over the evaluated face.
    HelixSlope,
    /// C_beta.
    HelixCrowning,
    /// S, bilinear.
    Twist,
}

impl Characteristic {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::ProfileSlope, Self::ProfileCrowning, Self::HelixSlope, Self::HelixCrowning, Self::Twist];

    /// Stable name.
    pub fn name(self) -> &'static str {
        match self {
            Self::ProfileSlope => "fHa",
            Self::ProfileCrowning => "Ca",
            Self::HelixSlope => "fHb",
            Self::HelixCrowning => "Cb",
            Self::Twist => "S",
        }
    }
}

/// One characteristic of one flank over the teeth.
#[derive(Clone, Debug)]
pub struct TestedCharacteristic {
    /// Flank.
    pub flank: Flank,
    /// Which.
    pub characteristic: Characteristic,
    /// Teeth.
    pub teeth: Vec<u32>,
    /// Readings of each tooth.
    pub repeats: usize,
    /// Mean of each tooth's readings, mm.
    pub values: Vec<f64>,
    /// What the test says.
    pub test: Result<SystematicTest, SystematicError>,
}

/// Values of one tooth flank.
pub(super) type OfTooth = BTreeMap<Characteristic, f64>;

/// Tests all characteristics that were measured.
pub(super) fn tested(
    inspection: &Inspection,
    gear: &EvaluatedGear,
    fields: &Sides<[[f64; 2]; 2]>,
    table: &InspectionTable,
    tolerance: f64,
    field_points: impl Fn(&measured_files::inspection::Topography) -> Vec<(f64, f64, f64)>,
) -> Vec<TestedCharacteristic> {
    let mut found = Vec::new();
    for flank in Flank::BOTH {
        let mut teeth: BTreeMap<u32, Vec<OfTooth>> = BTreeMap::new();
        for trace in inspection.traces.iter().filter(|t| t.flank == flank) {
            teeth
                .entry(trace.tooth)
                .or_insert_with(|| of_tooth(inspection, gear, flank, trace.tooth, fields[flank]));
        }
        for field in inspection.topographies.iter().filter(|t| t.flank == flank) {
            teeth.entry(field.tooth).or_default().push(of_field(&field_points(field), fields[flank]));
        }
        let pitch = TAU / f64::from(inspection.gear.teeth.unsigned_abs());
        found.extend(tested_teeth(flank, &teeth, pitch, table, tolerance));
    }
    found
}

/// Tests all characteristics of a flank, by its teeth with their readings. `pitch`: angle from a tooth to the next, rad.
pub(super) fn tested_teeth(
    flank: Flank,
    teeth: &BTreeMap<u32, Vec<OfTooth>>,
    pitch: f64,
    table: &InspectionTable,
    tolerance: f64,
) -> Vec<TestedCharacteristic> {
    let mut found = Vec::new();
    for characteristic in Characteristic::ALL {
        let of = |readings: &Vec<OfTooth>| -> Vec<f64> {
            readings.iter().filter_map(|one| one.get(&characteristic).copied()).collect()
        };
        let mut values: Vec<(u32, Vec<f64>)> = teeth
            .iter()
            .map(|(tooth, readings)| (*tooth, of(readings)))
            .filter(|(_, v)| !v.is_empty())
            .collect();
        // As many readings of every tooth: what was measured more often than the others counts as often as they do.
        let Some(repeats) = values.iter().map(|(_, readings)| readings.len()).min() else { continue };
        values.iter_mut().for_each(|(_, readings)| readings.truncate(repeats));
        let readings: Vec<Vec<f64>> = values.iter().map(|(_, readings)| readings.clone()).collect();
        let angles: Vec<f64> = values.iter().map(|(tooth, _)| f64::from(*tooth) * pitch).collect();
        let mean = |readings: Vec<f64>| readings.iter().sum::<f64>() / readings.len() as f64;
        let options = SystematicOptions {
            tolerance,
            calibration: 1e-3 * table.calibration_um,
            dead_band: table.dead_band,
            level: table.level,
        };
        found.push(TestedCharacteristic {
            flank,
            characteristic,
            test: systematic_test(&readings, Some(&angles), &options),
            teeth: values.iter().map(|(tooth, _)| *tooth).collect(),
            repeats,
            values: values.into_iter().map(|(_, readings)| mean(readings)).collect(),
        });
    }
    found
}

/// From the lines of a tooth, once for every time that they were measured: slopes and crownings of the middle ones, twist of the outer ones.
fn of_tooth(
    inspection: &Inspection,
    gear: &EvaluatedGear,
    flank: Flank,
    tooth: u32,
    [roll, face]: [[f64; 2]; 2],
) -> Vec<OfTooth> {
    let own = |trace: &Trace| (trace.flank, trace.tooth) == (flank, tooth);
    let lines = gear.traces.iter().map(|one| (&inspection.traces[one.trace], &one.evaluation));
    let readings = readings(lines.filter(|(trace, _)| own(trace)), |(trace, _)| trace);
    let cos = gear.gear.flank(flank).base_helix_angle.cos();
    readings.iter().map(|lines| of_lines(lines, cos, [roll, face])).collect()
}

/// From lines of which none stands where another does.
fn of_lines(lines: &[Line<'_>], cos: f64, [roll, face]: [[f64; 2]; 2]) -> OfTooth {
    let lengths = [roll[1] - roll[0], face[1] - face[0]];
    let mut found = OfTooth::new();
    for (kind, slope_of, crowning_of) in [
        (TraceKind::Profile, Characteristic::ProfileSlope, Characteristic::ProfileCrowning),
        (TraceKind::Helix, Characteristic::HelixSlope, Characteristic::HelixCrowning),
    ] {
        let (along, across) = match kind {
            TraceKind::Profile => (lengths[0], face),
            TraceKind::Helix => (lengths[1], roll),
        };
        let of_kind = |value: fn(&TraceEvaluation, f64) -> f64| {
            let lines = lines.iter().filter(|(trace, _)| trace.kind == kind);
            let placed: Vec<(f64, f64)> =
                lines.map(|(trace, of)| (trace.position_mm, value(of, along))).collect();
            at_middle(&placed, across)
        };
        if let Some(slope) = of_kind(|of, along| of.crowning.slope.over(along)) {
            found.insert(slope_of, cos * slope);
        }
        if let Some(height) = of_kind(|of, _| of.crowning.height) {
            found.insert(crowning_of, cos * height);
        }
    }
    let twists: Vec<f64> = twist_of(lines, lengths).into_iter().flatten().collect();
    if !twists.is_empty() {
        found.insert(Characteristic::Twist, cos * twists.iter().sum::<f64>() / twists.len() as f64);
    }
    found
}

/// From the points of a field.
pub(super) fn of_field(points: &[(f64, f64, f64)], [roll, face]: [[f64; 2]; 2]) -> OfTooth {
    let points: Vec<ArealPoint> =
        points.iter().map(|&(w, z, f)| ArealPoint { w, z, f, weight: 1.0 }).collect();
    let fit = ArealField::new(roll, face)
        .and_then(|field| ArealFit::of_points(&points, &field, ArealDegree::Second));
    let Ok(fit) = fit else { return OfTooth::new() };
    let f = fit.features();
    OfTooth::from([
        (Characteristic::ProfileSlope, f.profile_slope),
        (Characteristic::ProfileCrowning, f.profile_crowning),
        (Characteristic::HelixSlope, f.helix_slope),
        (Characteristic::HelixCrowning, f.helix_crowning),
        (Characteristic::Twist, f.twist),
    ])
}
