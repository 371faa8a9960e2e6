//! A made-up but realistic generating-grinding report: the twist-free crowning of a 19-tooth gear. Shared by the tests of
//! the report and the example that writes it for looking.

pub mod programs;

use foundation::geometry::{Flank, Sides};
use report::charts::{SectionTrace, Topography};
use report::generating::{
    Characteristics, ConvergenceRound, DressingMotion, FlankReport, GeneratingReport, GrindingMotion,
    RatioCandidate, RatioChoice, Reason, RefereeStage, TargetAmount, Timing, Verification, WrittenFile,
};
use report::{Quantity, Stamp, Warning};
use verdict::{Remark, Status, Verdict};

const COS_BETA_B: f64 = 0.837;

/// `count` equidistant values with both ends.
pub fn spread(lo: f64, hi: f64, count: usize) -> Vec<f64> {
    (0..count).map(|k| lo + (hi - lo) * k as f64 / (count - 1) as f64).collect()
}

/// A topography on 41 x 41 points over w 4.1 .. 22.9 mm, z -20 .. 20 mm.
pub fn field(f: impl Fn(f64, f64) -> f64) -> Topography {
    let (w, z) = (spread(4.1, 22.9, 41), spread(-20.0, 20.0, 41));
    let values = w.iter().map(|&w| z.iter().map(|&z| f(w, z)).collect()).collect();
    Topography::new(w, z, values).unwrap()
}

/// Crowning 20 um and profile crowning 5 um, normal.
pub fn crowned(w: f64, z: f64) -> f64 {
    -(20.0 * (z / 20.0).powi(2) + 5.0 * ((w - 13.5) / 9.4).powi(2)) * COS_BETA_B
}

/// A smooth error of 0.003 um.
pub fn ripple(w: f64, z: f64, side: Flank) -> f64 {
    0.003 * (0.31 * z + side.sign()).sin() * (0.55 * w - 0.04 * z).cos() + 0.0004 * side.sign()
}

fn flank(side: Flank, twist_um: f64) -> FlankReport {
    let twist = |w: f64, z: f64| twist_um * (z / 40.0) * ((w - 13.5) / 18.8) * COS_BETA_B;
    let target = field(crowned);
    let planned = field(|w, z| crowned(w, z) + twist(w, z) + 0.6 * ripple(w, z, side));
    let simulated = field(|w, z| crowned(w, z) + twist(w, z) + ripple(w, z, side));
    let deviations: Vec<f64> =
        simulated.minus(&target).unwrap().f_um().iter().flatten().map(|f| f.abs()).collect();
    let max = deviations.iter().copied().fold(0.0, f64::max);
    let rms = (deviations.iter().map(|d| d * d).sum::<f64>() / deviations.len() as f64).sqrt();
    let wanted = Characteristics {
        helix_crowning_um: Some(20.0),
        profile_crowning_um: Some(5.0),
        helix_slope_um: Some(0.0),
        profile_slope_um: Some(0.0),
        twist_corner_um: Some(0.0),
        twist_corner_normal_um: Some(0.0),
        twist_fit_um: Some(0.0),
        twist_fit_normal_um: Some(0.0),
    };
    let made = Characteristics {
        helix_crowning_um: Some(19.9998),
        profile_crowning_um: Some(4.998),
        helix_slope_um: Some(0.0004),
        profile_slope_um: Some(-0.0012),
        twist_corner_um: Some(twist_um + 0.0004),
        twist_corner_normal_um: Some(twist_um * COS_BETA_B + 0.0003),
        twist_fit_um: Some(twist_um - 0.0002),
        twist_fit_normal_um: Some(twist_um * COS_BETA_B - 0.0002),
    };
    let trace = |mut trace: SectionTrace, crowning: (&str, f64), slope: (&str, f64)| {
        trace.values_um = vec![(crowning.0.to_owned(), crowning.1), (slope.0.to_owned(), slope.1)];
        trace
    };
    let profiles = [4, 20, 36].map(|j| {
        trace(SectionTrace::profile(&simulated, Some(&target), j), ("C_α", 4.998), ("C_Hα", -0.001))
    });
    let helices = [4, 20, 36]
        .map(|i| trace(SectionTrace::helix(&simulated, Some(&target), i), ("C_β", 20.0), ("C_Hβ", 0.0004)));
    let amount = |name: &str, amount: f64| TargetAmount {
        name: name.to_owned(),
        amount_um: Some(amount),
        detail: "transverse".to_owned(),
    };
    FlankReport {
        amounts: vec![amount("helix crowning", 20.0), amount("profile crowning", 5.0)],
        target,
        planned: Some(planned),
        simulated: Some(simulated),
        target_values: wanted,
        planned_values: None,
        simulated_values: Some(made),
        max_deviation_um: Some(max),
        rms_deviation_um: Some(rms),
        model_difference_um: Some(0.0013),
        outside: vec![],
        profiles: profiles.into(),
        helices: helices.into(),
    }
}

fn candidate(ratio: f64, place: &str, figures: Option<(f64, f64, f64)>, note: &str) -> RatioCandidate {
    RatioCandidate {
        ratio,
        place: place.to_owned(),
        score: figures.map(|f| f.0),
        occupation_mm: figures.map(|f| f.1),
        error_um: figures.map(|f| f.2),
        note: note.to_owned(),
    }
}

fn dressing(side: Flank) -> DressingMotion {
    let v = spread(-42.5, 42.5, 17);
    let s = side.sign();
    DressingMotion {
        d_phi_s_deg: v.iter().map(|v| s * 0.22 * (v / 42.5).powi(2)).collect(),
        d_gamma_deg: v.iter().map(|v| 0.0004 * (v / 42.5) * s).collect(),
        d_d_mm: v.iter().map(|v| 0.006 * (v / 42.5).powi(2) - 0.001).collect(),
        d_v_ya_mm: v.iter().map(|v| 0.01 * (v / 42.5) + 0.002 * s).collect(),
        v_zs_mm: v,
    }
}

/// Both flanks judged; programs left out.
fn verdict(missed: bool) -> Verdict {
    let mut verdict = Verdict::new();
    for name in ["left flank", "right flank"] {
        verdict.judge(name, !missed, "0.0036 of 1 um", || {
            Remark::new("natural-twist", "twist", "grind diagonally")
        });
    }
    verdict.leave("programs", "the job names no machine");
    verdict
}

/// The report of a job that met its tolerance.
pub fn met() -> GeneratingReport {
    let feed = spread(-21.0, 21.0, 85);
    let written =
        |path: &str, content: &str| WrittenFile { path: path.to_owned(), content: content.to_owned() };
    let timing = |stage: &str, seconds: f64| Timing { stage: stage.to_owned(), seconds };
    GeneratingReport {
        job_name: "twist-free-crowning".to_owned(),
        description: Some("helix crowning 20 um, twist-free, profile crowning 5 um, both flanks".to_owned()),
        process: "diagonal generating grinding, worm dressed topologically".to_owned(),
        version: "0.1.0".to_owned(),
        status: Status::Met.into(),
        verdict: verdict(false),
        reason: None,
        tolerance_um: 1.0,
        flanks: Sides::from_fn(|side| Some(flank(side, 0.0))),
        gear: vec![
            Quantity::count("Number of teeth", "z", 19),
            Quantity::number("Normal module", "m_n", 3.5, "mm"),
            Quantity::number("Normal pressure angle", "α_n", 17.5, "°"),
            Quantity::number("Helix angle (left-hand)", "β", -35.0, "°"),
            Quantity::number("Profile shift coefficient", "x", 0.0, ""),
            Quantity::number("Face width", "b", 40.0, "mm"),
            Quantity::number("Tip diameter", "d_a", 88.5315, "mm"),
            Quantity::number("Root diameter", "d_f", 72.4315, "mm"),
            Quantity::number("Base diameter", "d_b", 75.789_421, "mm"),
            Quantity::per_flank("Base helix angle", "β_b", -33.163_2, -33.163_2, "°"),
        ],
        worm: vec![
            Quantity::count("Threads", "z_0", 3),
            Quantity::text("Hand", "left"),
            Quantity::number("Tip diameter", "d_a0", 200.0, "mm"),
            Quantity::number("Pitch diameter", "d_0", 191.25, "mm"),
            Quantity::number("Lead angle", "γ_0", 3.1468, "°"),
            Quantity::number("Width", "b_0", 100.0, "mm"),
        ],
        dresser: vec![
            Quantity::number("Tip diameter", "d_aA", 123.0, "mm"),
            Quantity::number("Pitch diameter", "d_A", 115.65, "mm"),
            Quantity::text("Profile", "profile crowning of the target"),
        ],
        settings: vec![
            Quantity::number("Centre distance", "d", 136.221_4, "mm"),
            Quantity::number("Crossed-axes angle", "γ", 58.146_8, "°"),
            Quantity::number("Worm occupation", "", 79.0, "mm"),
            Quantity::number("Feed per workpiece revolution", "", 0.3, "mm"),
            Quantity::per_flank("Direction of the dressing contact line", "ρ_1", 0.0213, -0.0213, ""),
        ],
        ratio: Some(RatioChoice {
            chosen: Some(-1.916_05),
            reason: "At this ratio the worm needs no part linear in the length of roll (lead-correction ratio K*), \
                     so dressing is a pure change of the worm rotation. Both flanks want the same ratio."
                .to_owned(),
            candidates: vec![
                candidate(-1.916_05, "dresser", Some((0.020, 79.0, 0.0013)), "chosen"),
                candidate(-1.2, "dresser", Some((0.37, 55.4, 0.0015)), ""),
                candidate(-2.5, "dresser", Some((0.28, 110.4, 0.0015)), "dropped: worm too short, 119.4 mm needed"),
                candidate(-0.524_74, "diagonal", Some((0.071, 37.6, 0.0029)), ""),
                candidate(-1.916_05, "correction", Some((2.4, 79.0, 0.0065)), "dropped: score above 1"),
                candidate(1.916_05, "dresser", None, "dropped: no-zero at v = 31.2 mm, right flank"),
            ],
        }),
        occupation: None,
        sections: Vec::new(),
        grinding_motions: vec![GrindingMotion {
            flanks: "both flanks".into(),
            z_v1_mm: feed.iter().map(|z| -1.916_05 * z).collect(),
            delta_d_um: feed.iter().map(|z| 0.04 * (z / 21.0).powi(2)).collect(),
            delta_phi_2_urad: feed.iter().map(|z| 0.9 * (z / 21.0) + 0.3 * (z / 21.0).powi(3)).collect(),
            z_v2_mm: feed,
            delta_gamma_deg: Vec::new(),
        }],
        dressing: Sides::from_fn(|side| Some(dressing(side))),
        strokes: Sides::from_fn(|_| Vec::new()),
        control: None,
        programs: Some(programs::programs()),
        warnings: vec![Warning {
            text: "The worm cuts 0.12 mm below the given root diameter.".to_owned(),
            way_out: "Reduce the tip diameter of the worm or give the root diameter of the finished gear.".to_owned(),
        }],
        verification: Some(Verification {
            paragraphs: vec![
                "Normal rays of the worm were shortened by the dresser under the motion above; normal rays of the \
                 gear were then shortened by the worm as these rays left it. No formula of the planning takes part."
                    .to_owned(),
            ],
            stages: vec![
                RefereeStage {
                    name: "dresser against worm".to_owned(),
                    rays: 12_482,
                    poses: 2_048,
                    discretisation_um: 4e-7,
                },
                RefereeStage {
                    name: "worm against gear".to_owned(),
                    rays: 3_362,
                    poses: 1_204_000,
                    discretisation_um: 0.0021,
                },
            ],
        }),
        convergence: [0.45, 0.031, 0.0032, 0.0013]
            .iter()
            .zip(0..)
            .map(|(&error, round)| ConvergenceRound {
                round,
                error_um: Sides { left: Some(error), right: Some(1.2 * error) },
            })
            .collect(),
        timing: vec![
            timing("decomposition and ratio", 0.021),
            timing("precompensation", 0.048),
            timing("dressing motion", 0.037),
            timing("referee", 1.94),
        ],
        files: vec![
            written("result.json", "all figures of this report"),
            written("topography.csv", "target, planned and simulated topography"),
            written("motions/grinding.csv", "grinding motion over the feed"),
            written("motions/dressing-left.csv", "dressing corrections, left flank"),
        ],
    }
}

/// The conventional method: the natural twist is missed, one flank with an opposite sign.
pub fn missed() -> GeneratingReport {
    let mut report = met();
    report.job_name = "radial-feed-crowning".to_owned();
    report.status = Status::Missed.into();
    report.verdict = verdict(true);
    report.reason = Some(Reason {
        code: "natural-twist".to_owned(),
        cause: "The radial method leaves its natural twist, −51.539 µm on the left and 51.539 µm on the right flank."
            .to_owned(),
        way_out: "Grind with the diagonal method.".to_owned(),
    });
    report.flanks = Sides::from_fn(|side| Some(flank(side, -51.539 * side.sign())));
    report.warnings.clear();
    report.convergence.clear();
    report
}

/// A job that found no way: only bodies, candidates and the reason.
pub fn not_producible() -> GeneratingReport {
    GeneratingReport {
        status: Stamp::NotProducible,
        verdict: Verdict::new(),
        reason: Some(Reason {
            code: "worm-too-short".to_owned(),
            cause: "The worm needs a width of 95.5 mm, 60 mm are given.".to_owned(),
            way_out: "Take a wider worm, fewer threads or a diagonal ratio nearer to zero.".to_owned(),
        }),
        flanks: Sides::from_fn(|_| None),
        grinding_motions: Vec::new(),
        dressing: Sides::from_fn(|_| None),
        ratio: Some(RatioChoice {
            chosen: None,
            reason: "All candidates need more width than the worm has.".to_owned(),
            candidates: vec![
                candidate(
                    -1.916_05,
                    "dresser",
                    Some((0.020, 79.0, 0.0013)),
                    "dropped: 95.5 mm of width needed",
                ),
                candidate(1.916_05, "dresser", None, "dropped: no-zero at v = 31.2 mm, right flank"),
            ],
        }),
        control: None,
        programs: None,
        warnings: vec![],
        verification: None,
        convergence: vec![],
        timing: vec![],
        files: vec![],
        ..met()
    }
}
