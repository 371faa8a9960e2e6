//! What evaluations of measurements must keep whatever was measured, and that no input ends them otherwise than with an error.

use foundation::geometry::{Flank, Sides};
use metrology::inspection::{
    BandFit, EvaluationRange, FlankAngles, KBand, PitchDeviations, SlopeReference, SlopeRule,
    SpecificationLimits, TeethSummary, ToleranceGear, ToleranceQuantity, Tolerances, TraceEvaluation,
    TraceSamples, eccentricity, evaluate_series, evaluate_trace, reached_class,
};
use proptest::prelude::*;

const RANGE: [f64; 2] = [1.0, 9.0];

fn evaluated(trace: &TraceSamples) -> TraceEvaluation {
    let range = EvaluationRange::new(RANGE[0], RANGE[1]).unwrap();
    let rule = SlopeRule { reference: SlopeReference::FaceWidth(10.0), ..SlopeRule::profile(Flank::Left) };
    evaluate_trace(trace, range, rule).unwrap()
}

/// Any number, also those that are none.
fn anything() -> impl Strategy<Value = f64> {
    prop_oneof![
        8 => -10.0..10.0,
        1 => any::<f64>(),
        1 => prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(f64::NEG_INFINITY), Just(0.0), Just(f64::MAX)],
    ]
}

proptest! {
    #[test]
    fn a_line_added_to_a_trace_changes_its_slope_alone(
        f in prop::collection::vec(-0.01..0.01f64, 101), offset in -1.0..1.0f64, gradient in -0.01..0.01f64,
    ) {
        let trace = TraceSamples::uniform([0.0, 10.0], f).unwrap();
        let tilted = trace.against(|a| -offset - gradient * a);
        let (before, after) = (evaluated(&trace), evaluated(&tilted));
        prop_assert!((after.slope.material() - before.slope.material() - 10.0 * gradient).abs() < 1e-13);
        prop_assert!((after.form - before.form).abs() < 1e-13);
        prop_assert!((after.crowning.height - before.crowning.height).abs() < 1e-13);
        prop_assert!((after.crowning.form - before.crowning.form).abs() < 1e-13);
        // Range and least squares bound each other.
        prop_assert!(after.total <= after.form + (gradient.abs() * 8.0 + before.slope.gradient.abs() * 8.0) + 1e-12);
    }

    #[test]
    fn a_trace_seen_from_the_other_end_has_the_opposite_slope(f in prop::collection::vec(-0.01..0.01f64, 101)) {
        let trace = TraceSamples::uniform([0.0, 10.0], f.clone()).unwrap();
        let mirrored = TraceSamples::uniform([0.0, 10.0], f.into_iter().rev().collect()).unwrap();
        let (one, other) = (evaluated(&trace), evaluated(&mirrored));
        prop_assert!((one.slope.material() + other.slope.material()).abs() < 1e-14);
        prop_assert!((one.crowning.height - other.crowning.height).abs() < 1e-14);
        prop_assert!((one.form - other.form).abs() < 1e-14);
    }

    #[test]
    fn no_shift_of_a_trace_lies_better_in_a_band_than_the_free_one(
        f in prop::collection::vec(-0.01..0.01f64, 101), beside in -0.01..0.01f64,
    ) {
        let band = KBand::new(&[1.0, 6.0, 9.0], &[-0.004, -0.004, -0.02], &[0.004, 0.004, -0.01]).unwrap();
        let trace = TraceSamples::uniform([0.0, 10.0], f).unwrap();
        let free = band.judge(&trace, BandFit::Free).unwrap();
        let moved = trace.against(|_| -free.shift - beside);
        let within = |a: &f64| (RANGE[0]..=RANGE[1]).contains(a);
        let margin = moved.abscissa().iter().zip(moved.deviation()).filter(|(a, _)| within(a)).map(|(a, f)| {
            let [lower, upper] = band.limits(*a);
            (f - lower).min(upper - f)
        });
        prop_assert!(margin.fold(f64::INFINITY, f64::min) <= free.margin + 1e-15);
    }

    #[test]
    fn the_tooth_that_is_counted_first_does_not_matter(
        fp in prop::collection::vec(-0.01..0.01f64, 5..60usize), first in 0..60usize,
    ) {
        let mean = fp.iter().sum::<f64>() / fp.len() as f64;
        let mut fp: Vec<f64> = fp.iter().map(|x| x - mean).collect();
        let teeth = fp.len();
        let one = PitchDeviations::new(fp.clone(), teeth).unwrap().evaluate(None).unwrap();
        fp.rotate_left(first % teeth);
        let other = PitchDeviations::new(fp, teeth).unwrap().evaluate(None).unwrap();
        prop_assert!((one.total - other.total).abs() < 1e-12);
        prop_assert!((one.sector - other.sector).abs() < 1e-12);
        prop_assert!((one.neighbours - other.neighbours).abs() < 1e-12);
        prop_assert!((one.first_harmonic.amplitude() - other.first_harmonic.amplitude()).abs() < 1e-12);
        prop_assert!(one.sector <= one.total + 1e-15);
    }

    #[test]
    fn what_an_eccentricity_leaves_has_none(
        left in prop::collection::vec(-0.01..0.01f64, 23), right in prop::collection::vec(-0.01..0.01, 23),
    ) {
        let flanks = FlankAngles { pressure_angle: 0.37, half_tooth_angle: 0.07 };
        let found = eccentricity(&Sides { left, right }, &flanks).unwrap();
        let again = eccentricity(&found.cumulative_without, &flanks).unwrap();
        prop_assert!(again.amount() < 1e-15);
    }

    #[test]
    fn a_larger_deviation_reaches_no_better_class(value in 0.0..0.2f64, more in 0.0..0.1f64) {
        let gear = ToleranceGear {
            teeth: 30, normal_module: 3.0, reference_diameter: 95.0, face_width: 30.0, helix_angle: 0.3,
        };
        let tolerances = Tolerances::new(&gear).unwrap();
        for quantity in ToleranceQuantity::ALL {
            let class = |value| reached_class(&tolerances, quantity, value).unwrap().unwrap_or(i32::MAX);
            prop_assert!(class(value + more) >= class(value));
            prop_assert_eq!(class(-value), class(value));
        }
    }

    #[test]
    fn any_numbers_give_values_or_errors(
        f in prop::collection::vec(anything(), 0..40), a in prop::collection::vec(anything(), 0..40),
        [from, to, zero] in [anything(), anything(), anything()], teeth in 0..40usize, k in 0..50usize,
    ) {
        let codes = |error: metrology::inspection::InspectionError| {
            assert!(!error.code().is_empty() && !error.way_out().is_empty() && !error.to_string().is_empty());
        };
        let band = KBand::new(&[from, to], &[-0.1, zero], &[0.1, 0.2]);
        for trace in [TraceSamples::new(a, f.clone()), TraceSamples::uniform([from, to], f.clone())] {
            let range = EvaluationRange::new(from, to);
            match (trace, range) {
                (Ok(trace), Ok(range)) => {
                    let rule = SlopeRule::profile(Flank::Right);
                    let relief = evaluate_trace(&trace, range, rule).and_then(|e| e.relief(&trace, [from, zero]));
                    relief.map_or_else(codes, |_| ());
                    if let Ok(band) = &band {
                        band.judge(&trace, BandFit::Fixed(zero)).map_or_else(codes, |_| ());
                    }
                }
                (trace, range) => {
                    trace.map_or_else(codes, |_| ());
                    range.map_or_else(codes, |_| ());
                }
            }
        }
        let pitch = PitchDeviations::new(f.clone(), teeth).and_then(|pitch| pitch.evaluate(Some(k)));
        pitch.map_or_else(codes, |_| ());
        PitchDeviations::from_cumulative(&f, f.len()).map_or_else(codes, |_| ());
        TeethSummary::of(&f).map_or_else(codes, |_| ());
        let limits = SpecificationLimits::new(Some(from), Some(to)).unwrap_or_default();
        evaluate_series(&f, &limits).map_or_else(codes, |_| ());
    }
}
