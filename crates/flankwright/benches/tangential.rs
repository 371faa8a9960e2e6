//! Speed of tangential dressing, one thread: the forward model on 25 and 1681 points, its nine sensitivities, the loop of singular
//! values and the choice of a set of variables, all for the source's gear with a helix crowning of 100 um.

use criterion::{Criterion, criterion_group, criterion_main};
use flankwright::contact::Measure;
use flankwright::geometry::{Flank, Gear, GearData, Sides};
use flankwright::process::tangential_dressing::{
    EdgeAmounts, FitGrid, FitLimits, FitMethod, FitTask, ProfileKind, SelectionTask, ShiftOffset, ShiftRatio,
    TangentialFlank, TangentialInput, TangentialModel, TangentialSettings, Variable, Weights,
};
use std::f64::consts::FRAC_PI_2;
use std::hint::black_box;

const FLANK: Flank = Flank::Right;
/// Nine variables that leave 0.6 um of the target, mm.
const FITTED: [(&str, f64); 9] = [
    ("Fp1", 0.000888),
    ("Fp2", 0.000804),
    ("Fp3", 0.003954),
    ("Fz2", 1.070649),
    ("Fz3", -0.010094),
    ("gam0", -0.122129),
    ("dist0", 0.004306),
    ("FC2", 0.040980),
    ("FC3", -0.000684),
];

fn variable(name: &str) -> Variable {
    name.parse().expect("name of a variable")
}

fn model() -> TangentialModel {
    let work = GearData {
        teeth: 19,
        normal_module: 3.5,
        pressure_angle: Sides::both(17.5f64.to_radians()),
        helix_angle: -(35f64.to_radians()),
        profile_shift: 0.0,
        cone_angle: 0.0,
    };
    let pitch_radius = 95.625;
    let lead_angle = (3.0 * work.normal_module / (2.0 * pitch_radius)).asin();
    let worm = GearData { teeth: 3, helix_angle: lead_angle - FRAC_PI_2, ..work };
    TangentialModel::new(TangentialInput {
        gear: Gear::new(work).expect("gear"),
        worm: Gear::new(worm).expect("worm"),
        worm_tip_radius: None,
        dresser_pitch_radius: 57.825,
        dresser_tip_radius: None,
        dresser_depth: None,
        profile: ProfileKind::Conjugate,
        radii: [38.10325, 44.26575],
        faces: [-20.0, 20.0],
        face_width: 40.0,
        shift_width: 48.1042,
        shift_ratio: ShiftRatio::Width,
        shift_offset: ShiftOffset::Given(0.0),
    })
    .expect("bodies")
}

fn settings() -> TangentialSettings {
    let mut settings = TangentialSettings::default();
    for (name, value) in FITTED {
        settings.set(&variable(name), value);
    }
    settings
}

fn forward(c: &mut Criterion) {
    let (model, settings) = (model(), settings());
    let nine = FITTED.map(|(name, _)| variable(name));
    let flank = TangentialFlank::new(&model, FLANK, &[FLANK], &settings, Measure::Ray);
    let [few, many] = [5, 41].map(|n| FitGrid::Radii(n).of(&model, FLANK));
    c.bench_function("tangential: bodies and nominal dresser", |b| b.iter(self::model));
    c.bench_function("tangential: 25 points", |b| {
        b.iter(|| flank.deviations(black_box(&few)).expect("flank"));
    });
    c.bench_function("tangential: 1681 points", |b| {
        b.iter(|| flank.deviations(black_box(&many)).expect("flank"));
    });
    c.bench_function("tangential: 25 points with nine sensitivities", |b| {
        b.iter(|| flank.linearised(black_box(&few), &nine).expect("flank"));
    });
}

fn inverse(c: &mut Criterion) {
    let model = model();
    let amounts = EdgeAmounts { profile_crowning: 0.005, lead_crowning: 0.1, ..EdgeAmounts::default() };
    let wanted = |flank: Flank, w: f64, z: f64| amounts.value(&model, flank, w, z);
    let task = FitTask {
        model: &model,
        pass: &[FLANK],
        wanted: &wanted,
        fixed: TangentialSettings::default(),
        measure: Measure::Arc,
        grid: FitGrid::Radii(5),
        weights: Weights::Source,
        limits: FitLimits::SOURCE,
    };
    let nine = FITTED.map(|(name, _)| variable(name));
    c.bench_function("tangential: loop of nine variables", |b| {
        b.iter(|| task.fit(black_box(&nine), &[0.0; 9], FitMethod::Plain).expect("fit"));
    });
    let mut fixed = TangentialSettings::default();
    fixed.set(&variable("FT0"), model.lines[FLANK].offset);
    let task = FitTask {
        fixed,
        grid: FitGrid::Graded(9),
        weights: Weights::Uniform,
        limits: FitLimits::STEADY,
        ..task
    };
    let selection = SelectionTask {
        candidates: SelectionTask::standard_candidates(false, &[]),
        tolerance: 0.03e-3,
        most: 24,
        judged_on: FitGrid::Radii(41),
    };
    let mut slow = c.benchmark_group("tangential");
    slow.sample_size(10);
    slow.bench_function("choice of the variables", |b| {
        b.iter(|| task.select(black_box(&selection)).expect("set"));
    });
    slow.finish();
}

criterion_group!(benches, forward, inverse);
criterion_main!(benches);
