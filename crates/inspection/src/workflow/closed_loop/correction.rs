//! The correction that answers a measurement: which settings are worth turning, by how much, and what stays
//! (`docs/mathematics/inspection.md#correction`).

use super::characteristics::{Characteristic, TestedCharacteristic};
use super::lines::{MeanLine, uncertainties};
use foundation::geometry::Flank;
use foundation::modification::{ModificationSpec, PolynomialSpec};
use generating::correction::{
    CorrectedSetting, Correction, CorrectionError, CorrectionTask, FlankPoint, Setting, SettingInfluence,
    SettingUnit, Weighting,
};
use generating_grinding::job::{
    Compensation, CorrectionLimits, CorrectionSetting, Inspection as InspectionTable,
};
use metrology::systematic::Decision;
use std::collections::BTreeMap;

/// A correction with the settings that it turns.
#[derive(Clone, Debug)]
pub struct FoundCorrection {
    /// Settings in the order of the correction.
    pub settings: Vec<Setting>,
    /// What they are to be changed by.
    pub correction: Correction,
    /// Sum of this and all earlier corrections, mm or rad.
    pub total: BTreeMap<String, (Setting, f64)>,
}

/// Smallest step that is worth a correction: mm, rad.
const RESOLUTION: [f64; 2] = [5e-5, 5e-7];

/// Modifications below this are rounding, um.
const ROUNDING_UM: f64 = 1e-9;

/// The unit of a setting in files, in that of the library, with its ending.
pub(super) fn unit(setting: Setting) -> (f64, &'static str) {
    match setting.unit() {
        SettingUnit::Length => (1e-3, "_um"),
        SettingUnit::Angle => ((1.0_f64 / 3600.0).to_radians(), "_arcsec"),
        SettingUnit::Ratio => (1.0, ""),
    }
}

/// Settings that may be turned and that cure something which all teeth share. Lines without common zeros say nothing of size and index;
/// twist needs a shift.
pub(super) fn worth_turning(
    table: &InspectionTable,
    tested: &[TestedCharacteristic],
    influence: &SettingInfluence<'_>,
) -> Vec<Setting> {
    let systematic = |characteristic: Characteristic, flank: Option<Flank>| {
        tested.iter().any(|t| {
            t.characteristic == characteristic
                && flank.is_none_or(|flank| flank == t.flank)
                && t.test.as_ref().is_ok_and(|test| test.decision == Decision::Correct)
        })
    };
    let measured = |flank: Flank| tested.iter().any(|t| t.flank == flank);
    let sees_twist =
        |flank: Flank| tested.iter().any(|t| t.flank == flank && t.characteristic == Characteristic::Twist);
    let twist = influence.ratio() != 0.0;
    Setting::USUAL
        .into_iter()
        .filter(|setting| {
            let (allowed, cured) = match setting {
                Setting::RadialFeed(1) => (CorrectionSetting::Taper, Characteristic::HelixSlope),
                Setting::WorkAngle(1) => (CorrectionSetting::HelixAngle, Characteristic::HelixSlope),
                Setting::RadialFeed(2) => (CorrectionSetting::Crowning, Characteristic::HelixCrowning),
                Setting::WorkAngle(2) => (CorrectionSetting::OppositeCrowning, Characteristic::HelixCrowning),
                Setting::ProfileSlope(_) => (CorrectionSetting::ProfileSlope, Characteristic::ProfileSlope),
                Setting::ProfileCrown(_) => {
                    (CorrectionSetting::ProfileCrowning, Characteristic::ProfileCrowning)
                }
                Setting::Twist(_) => (CorrectionSetting::Twist, Characteristic::Twist),
                _ => return false,
            };
            // What acts along the contact path brings slope, crowning and twist together: the worm takes out what is not wanted.
            let partner = match setting {
                Setting::ProfileSlope(flank) => {
                    measured(*flank) && systematic(Characteristic::HelixSlope, None)
                }
                Setting::Twist(flank) | Setting::ProfileCrown(flank) => {
                    measured(*flank) && systematic(Characteristic::HelixCrowning, None)
                        || systematic(Characteristic::Twist, Some(*flank))
                }
                _ => false,
            };
            table.settings.contains(&allowed)
                && (systematic(cured, setting.flank()) || partner)
                && setting.flank().is_none_or(measured)
                && !matches!(setting, Setting::Twist(flank) if !twist || !sees_twist(*flank))
        })
        .collect()
}

/// The correction of what was measured. Settings that the traces do not determine are not changed; `None` if that leaves none.
///
/// # Errors
/// Those of [`CorrectionTask::solve`].
pub(super) fn correct(
    table: &InspectionTable,
    mut settings: Vec<Setting>,
    lines: &[MeanLine],
    influence: &SettingInfluence<'_>,
    earlier: Option<&Compensation>,
) -> Result<Option<FoundCorrection>, CorrectionError> {
    let applied = applied(earlier);
    let measured = MeasuredPoints::of(lines);
    let (mut alone, mut not_told_apart) = (Vec::new(), Vec::new());
    let mut correction = loop {
        if settings.is_empty() {
            return Ok(None);
        }
        let found = solved(table, &settings, &measured, influence, &applied)?;
        match unseen(&settings, &found, &table.limits) {
            Some(place) => {
                alone.push(settings.remove(place));
                not_told_apart.extend(found.unseen);
            }
            None => break found,
        }
    };
    let mut total = applied;
    for (setting, found) in settings.iter().zip(&correction.settings) {
        total.entry(setting.name()).or_insert((*setting, 0.0)).1 += found.value;
    }
    correction.unseen.extend(not_told_apart);
    for setting in alone {
        let name = setting.name();
        let left = CorrectedSetting { name, value: 0.0, at_bound: false, deviation: None, dropped: true };
        correction.settings.push(left);
        settings.push(setting);
    }
    Ok(Some(FoundCorrection { settings, correction, total }))
}

/// A setting of a direction that nothing sees, or that is known worse than its bounds: first those that are chosen last
/// (`docs/mathematics/inspection.md#correction`).
fn unseen(settings: &[Setting], found: &Correction, limits: &CorrectionLimits) -> Option<usize> {
    /// A setting with a smaller share of the largest in a direction hardly takes part in it.
    const PART: f64 = 0.1;
    let in_direction = |setting: &Setting| {
        let name = setting.name();
        found.unseen.iter().flatten().any(|(part, share)| *part == name && share.abs() > PART)
    };
    let unknown = |k: usize| {
        let of = &found.settings[k];
        let [_, limit] = bound(limits, settings[k]);
        !of.dropped && of.deviation.is_some_and(|deviation| deviation.is_nan() || deviation > 0.5 * limit)
    };
    let candidates = (0..settings.len()).filter(|&k| in_direction(&settings[k]) || unknown(k));
    candidates.max_by_key(|&k| settings[k].stage())
}

/// How far a setting may go to either side, mm or rad.
fn bound(limits: &CorrectionLimits, setting: Setting) -> [f64; 2] {
    let limit = match setting {
        Setting::WorkAngle(_) => limits.work_angle_arcsec,
        Setting::ProfileSlope(_) | Setting::ProfileCrown(_) => limits.profile_um,
        Setting::Twist(_) => limits.twist_um,
        _ => limits.radial_feed_um,
    };
    let limit = limit * unit(setting).0;
    [-limit, limit]
}

/// Points of all lines: their deviations, the line whose zero each has, and how well it is known.
#[derive(Default)]
struct MeasuredPoints {
    points: Vec<FlankPoint>,
    deviations: Vec<f64>,
    zeros: Vec<usize>,
    known: Vec<f64>,
}

impl MeasuredPoints {
    fn of(lines: &[MeanLine]) -> Self {
        let mut of = Self::default();
        for (number, (line, spread)) in lines.iter().zip(uncertainties(lines)).enumerate() {
            for (point, deviation) in line.points() {
                of.points.push(point);
                of.deviations.push(deviation);
                of.zeros.push(number);
                of.known.push(spread);
            }
        }
        of
    }
}

fn solved(
    table: &InspectionTable,
    settings: &[Setting],
    measured: &MeasuredPoints,
    influence: &SettingInfluence<'_>,
    applied: &BTreeMap<String, (Setting, f64)>,
) -> Result<Correction, CorrectionError> {
    let columns = influence.columns(settings, &measured.points)?;
    let so_far = |setting: &Setting| applied.get(&setting.name()).map_or(0.0, |(_, value)| *value);
    let resolution = |setting: &Setting| RESOLUTION[usize::from(setting.unit() == SettingUnit::Angle)];
    let task = CorrectionTask {
        traces: Some(measured.zeros.clone()),
        weighting: Weighting::Uncertainties(measured.known.clone()),
        bounds: settings.iter().map(|setting| bound(&table.limits, *setting)).collect(),
        applied: settings.iter().map(so_far).collect(),
        resolutions: Some(settings.iter().map(resolution).collect()),
        allow_underdetermined: true,
        ..CorrectionTask::new(measured.deviations.clone(), columns)
    };
    task.solve()
}

/// Earlier corrections by the name of their setting, mm or rad.
fn applied(earlier: Option<&Compensation>) -> BTreeMap<String, (Setting, f64)> {
    let of = |key: &str, value: f64| {
        let setting = Setting::USUAL.into_iter().find(|s| s.name() + unit(*s).1 == key)?;
        Some((setting.name(), (setting, value * unit(setting).0)))
    };
    earlier.iter().flat_map(|c| &c.settings).filter_map(|(key, value)| of(key, *value)).collect()
}

/// The compensation of a job that makes a correction: what the settings do to the flanks, as polynomials.
pub(super) fn compensation(
    found: &FoundCorrection,
    influence: &SettingInfluence<'_>,
    ground: impl Fn(Flank) -> bool,
    rounds: u32,
) -> Compensation {
    let modifications = Flank::BOTH
        .into_iter()
        .filter(|flank| ground(*flank))
        .map(|flank| polynomial(found, influence, flank))
        .filter(|polynomial| !polynomial.terms.is_empty())
        .map(ModificationSpec::Polynomial)
        .collect();
    let settings = found
        .total
        .values()
        .filter(|(_, value)| *value != 0.0)
        .map(|(setting, value)| {
            let (size, ending) = unit(*setting);
            (setting.name() + ending, value / size)
        })
        .collect();
    Compensation { modifications, settings, rounds }
}

/// Sum of the effects on a flank, transverse, > 0 material, um: all are polynomials of second degree, which six values tell. Their constant
/// is left out, so that thickness and index stay what they are.
fn polynomial(found: &FoundCorrection, influence: &SettingInfluence<'_>, flank: Flank) -> PolynomialSpec {
    let lines = &influence.lines()[flank];
    let at = |w: f64, z: f64| {
        let point = FlankPoint { flank, w: lines.w_m + w, z: lines.z_m + z };
        let each = found.total.values().map(|(setting, value)| match value {
            0.0 => 0.0,
            value => value * influence.effect(*setting, &point),
        });
        1e3 * each.sum::<f64>() / lines.cos_b2
    };
    // Differences over the whole field are exact for these polynomials.
    let [a, b] = [0.5 * (lines.roll[1] - lines.roll[0]), 0.5 * (lines.face[1] - lines.face[0])];
    let middle = at(0.0, 0.0);
    let (w_plus, w_minus, z_plus, z_minus) = (at(a, 0.0), at(-a, 0.0), at(0.0, b), at(0.0, -b));
    let mixed = at(a, b) - w_plus - z_plus + middle;
    // What rounding leaves of effects that cancel is no modification: terms that move no point of the field by as much, um.
    let moves = |(i, k, value): &(u32, u32, f64)| {
        (value * a.powi(i32::try_from(*i).unwrap_or(0)) * b.powi(i32::try_from(*k).unwrap_or(0))).abs()
            > ROUNDING_UM
    };
    let terms = vec![
        (1, 0, 0.5 * (w_plus - w_minus) / a),
        (0, 1, 0.5 * (z_plus - z_minus) / b),
        (2, 0, 0.5 * (w_plus + w_minus - 2.0 * middle) / (a * a)),
        (0, 2, 0.5 * (z_plus + z_minus - 2.0 * middle) / (b * b)),
        (1, 1, mixed / (a * b)),
    ];
    PolynomialSpec {
        w0_mm: lines.w_m,
        z0_mm: lines.z_m,
        terms: terms.into_iter().filter(moves).collect(),
        flank: flank.into(),
        reference: foundation::modification::Reference::default(),
    }
}

/// What a correction changes on the places of a grid, first order, normal, mm.
pub(super) fn first_order(
    found: &FoundCorrection,
    influence: &SettingInfluence<'_>,
    flank: Flank,
    [w, z]: [&[f64]; 2],
) -> Vec<f64> {
    let places = w.iter().flat_map(|&w| z.iter().map(move |&z| (w, z)));
    let change = |(w, z): (f64, f64)| {
        let point = FlankPoint { flank, w, z };
        let each = found.settings.iter().zip(&found.correction.settings);
        each.filter(|(_, found)| found.value != 0.0)
            .map(|(setting, found)| found.value * influence.effect(*setting, &point))
            .sum::<f64>()
    };
    places.map(change).collect()
}
