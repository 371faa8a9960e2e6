//! Splines against what they must be.

extern crate std;

use std::vec;
use std::vec::Vec;

use proptest::prelude::*;

use super::{CubicTable, EndRule, solve_slopes};
use crate::{Error, TableFault};

fn slopes(values: &[f64], spacing: f64, ends: EndRule) -> Vec<f64> {
    let mut slopes = vec![f64::NAN; values.len()];
    let mut room = vec![f64::NAN; 2 * values.len()];
    solve_slopes(values, spacing, ends, &mut slopes, &mut room).unwrap();
    slopes
}

fn fault(values: &[f64], spacing: f64, ends: EndRule) -> TableFault {
    let (mut slopes, mut room) = (vec![0.0; values.len()], vec![0.0; 2 * values.len()]);
    let solved = solve_slopes(values, spacing, ends, &mut slopes, &mut room);
    let table = CubicTable::new(0.0, spacing, values, &slopes, ends);
    match (solved, table) {
        (Err(Error::BadTable { reason }), Err(Error::BadTable { reason: same })) if reason == same => reason,
        other => panic!("{other:?}"),
    }
}

#[test]
fn data_that_make_no_table_are_refused() {
    assert_eq!(fault(&[1.0], 1.0, EndRule::Natural), TableFault::TooFewKnots { knots: 1 });
    assert_eq!(fault(&[], 1.0, EndRule::Periodic), TableFault::TooFewKnots { knots: 0 });
    assert_eq!(fault(&[1.0, 2.0], 0.0, EndRule::Natural), TableFault::Spacing { value: 0.0 });
    assert_eq!(fault(&[1.0, 2.0], -1.0, EndRule::Natural), TableFault::Spacing { value: -1.0 });
    assert!(matches!(
        CubicTable::new(0.0, f64::NAN, &[1.0, 2.0], &[0.0; 2], EndRule::Natural),
        Err(Error::BadTable { reason: TableFault::Spacing { .. } })
    ));
    assert_eq!(fault(&[1.0, f64::NAN], 1.0, EndRule::Natural), TableFault::NotFinite { index: 1 });
    assert_eq!(
        fault(&[1.0, 3.0, 2.0], 1.0, EndRule::Periodic),
        TableFault::NotPeriodic { first: 1.0, last: 2.0 }
    );
}

#[test]
fn storage_of_the_wrong_length_is_refused() {
    let values = [0.0, 1.0, 0.0];
    let short = solve_slopes(&values, 1.0, EndRule::Natural, &mut [0.0; 2], &mut [0.0; 6]);
    assert_eq!(short, Err(Error::BadTable { reason: TableFault::Storage { values: 3, slopes: 2 } }));
    let narrow = solve_slopes(&values, 1.0, EndRule::Periodic, &mut [0.0; 3], &mut [0.0; 5]);
    assert_eq!(narrow, Err(Error::BadTable { reason: TableFault::Workspace { needed: 6, given: 5 } }));
    let table = CubicTable::new(0.0, 1.0, &values, &[0.0; 4], EndRule::Natural);
    assert_eq!(table, Err(Error::BadTable { reason: TableFault::Storage { values: 3, slopes: 4 } }));
    let open = CubicTable::new(0.0, 1.0, &values, &[0.0, 0.0, 1.0], EndRule::Periodic);
    assert_eq!(open, Err(Error::BadTable { reason: TableFault::NotPeriodic { first: 0.0, last: 1.0 } }));
}

#[test]
fn curves_beyond_the_range_of_numbers_are_refused() {
    let of = |start, spacing, values: &[f64], slopes: &[f64]| {
        CubicTable::new(start, spacing, values, slopes, EndRule::Natural).map(|_| ())
    };
    let not_finite = Err(Error::BadTable { reason: TableFault::NotFinite { index: 0 } });
    assert_eq!(of(0.0, 1.0, &[1e308, -1e308], &[0.0; 2]), not_finite);
    assert_eq!(of(0.0, 1e-300, &[1.0, 0.0], &[0.0; 2]), not_finite);
    assert_eq!(of(0.0, 1.0, &[1.0, 0.0], &[f64::NAN, 0.0]), not_finite);
    assert!(matches!(of(f64::NAN, 1.0, &[1.0, 0.0], &[0.0; 2]), Err(Error::BadParameter { .. })));
    assert!(matches!(of(1e308, 1e308, &[1.0, 0.0], &[0.0; 2]), Err(Error::BadParameter { .. })));
    let huge = solve_slopes(&[1e308, -1e308], 1.0, EndRule::Natural, &mut [0.0; 2], &mut [0.0; 4]);
    assert!(matches!(huge, Err(Error::BadTable { reason: TableFault::NotFinite { .. } })));
}

#[test]
fn arguments_that_are_no_place_are_refused() {
    let values = [0.0, 1.0, 0.0];
    for ends in [EndRule::Natural, EndRule::Periodic] {
        let slopes = slopes(&values, 1.0, ends);
        let table = CubicTable::new(0.0, 1.0, &values, &slopes, ends).unwrap();
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(matches!(table.value(bad), Err(Error::BadParameter { .. })));
            assert!(matches!(table.derivative(bad), Err(Error::BadParameter { .. })));
            assert!(matches!(table.second_derivative(bad), Err(Error::BadParameter { .. })));
            assert!(matches!(table.counts(bad), Err(Error::BadParameter { .. })));
        }
        assert_eq!(table.value(1e300).is_err(), ends == EndRule::Periodic);
    }
}

#[test]
fn two_knots_make_a_straight_line() {
    let slopes = slopes(&[1.0, 4.0], 2.0, EndRule::Natural);
    assert_eq!(slopes, [1.5, 1.5]);
    let table = CubicTable::new(-1.0, 2.0, &[1.0, 4.0], &slopes, EndRule::Natural).unwrap();
    assert_eq!(table.value(0.0), Ok(2.5));
    assert_eq!(table.end_slopes(), (1.5, 1.5));
    assert_eq!((table.value(-1.5), table.derivative(-1.5)), (Ok(1.0), Ok(0.0)));
    assert_eq!((table.value(7.0), table.second_derivative(7.0)), (Ok(4.0), Ok(0.0)));
    assert_eq!((table.value(1.0), table.derivative(1.0)), (Ok(4.0), Ok(1.5)));
}

#[test]
fn short_periods_are_symmetric() {
    assert_eq!(slopes(&[2.0, 2.0], 1.0, EndRule::Periodic), [0.0; 2]);
    assert_eq!(slopes(&[2.0, 5.0, 2.0], 1.0, EndRule::Periodic), [0.0; 3]);
    // Three unknowns: the sum of the equations makes the sum of the slopes 0.
    let three = slopes(&[0.0, 1.0, 5.0, 0.0], 1.0, EndRule::Periodic);
    assert!((three[0] + three[1] + three[2]).abs() < 1e-14, "{three:?}");
    assert!((4.0 * three[0] + three[1] + three[2] - 3.0 * (1.0 - 5.0)).abs() < 1e-14);
}

#[test]
fn counts_are_rounded_and_limited() {
    let table = CubicTable::new(0.0, 1.0, &[0.0, 3.0], &[3.0, 3.0], EndRule::Natural).unwrap();
    assert_eq!(table.counts(0.5), Ok(2));
    assert_eq!(table.counts(0.4), Ok(1));
    let high = CubicTable::new(0.0, 1.0, &[1e19, 1e19], &[0.0, 0.0], EndRule::Natural).unwrap();
    assert_eq!(high.counts(0.5), Err(Error::GearRange { name: "value of a table", value: i64::MAX }));
}

proptest! {
    #[test]
    fn splines_pass_the_knots_with_continuous_curvature(
        mut values in prop::collection::vec(-10.0f64..10.0, 2..40), spacing in 0.1f64..10.0, start in -100.0f64..100.0, repeats: bool,
    ) {
        let ends = if repeats { EndRule::Periodic } else { EndRule::Natural };
        if repeats {
            *values.last_mut().unwrap() = values[0];
        }
        let slopes = slopes(&values, spacing, ends);
        let table = CubicTable::new(start, spacing, &values, &slopes, ends).unwrap();
        let last = values.len() - 2;
        let curvature = |index: usize, at: f64| table.cell(index).unwrap().second_derivative(at);
        for index in 0..=last {
            prop_assert!((table.cell(index).unwrap().value(1.0) - values[index + 1]).abs() < 1e-12);
            prop_assert!((table.value(start + index as f64 * spacing).unwrap() - values[index]).abs() < 1e-10);
            if index > 0 {
                prop_assert!((curvature(index - 1, 1.0) - curvature(index, 0.0)).abs() < 1e-10);
            }
        }
        if repeats {
            prop_assert!((curvature(last, 1.0) - curvature(0, 0.0)).abs() < 1e-10);
        } else {
            prop_assert!(curvature(0, 0.0).abs() < 1e-10 && curvature(last, 1.0).abs() < 1e-10);
        }
    }

    #[test]
    fn a_periodic_curve_repeats(x in -50.0f64..50.0, periods in -1000i32..1000) {
        let values = [0.0, 2.0, -1.0, 3.0, 0.0];
        let slopes = slopes(&values, 1.0, EndRule::Periodic);
        let table = CubicTable::new(0.25, 1.0, &values, &slopes, EndRule::Periodic).unwrap();
        let away = table.value(x + 4.0 * f64::from(periods)).unwrap();
        prop_assert!((table.value(x).unwrap() - away).abs() < 1e-10);
    }

    #[test]
    fn derivatives_are_those_of_the_value(x in 0.01f64..3.99) {
        let values = [0.0, 2.0, -1.0, 3.0, 1.0];
        let slopes = slopes(&values, 1.0, EndRule::Natural);
        let table = CubicTable::new(0.0, 1.0, &values, &slopes, EndRule::Natural).unwrap();
        let step = 1e-5;
        let [left, right] = [x - step, x + step].map(|x| table.value(x).unwrap());
        prop_assert!((table.derivative(x).unwrap() - (right - left) / (2.0 * step)).abs() < 1e-8);
        let [left, right] = [x - step, x + step].map(|x| table.derivative(x).unwrap());
        prop_assert!((table.second_derivative(x).unwrap() - (right - left) / (2.0 * step)).abs() < 2e-4);
    }

    #[test]
    fn any_finite_argument_gives_a_finite_value_or_an_error(bits: u64, repeats: bool) {
        let x = f64::from_bits(bits);
        let values = [1.0, 2.0, -1.0, 1.0];
        let ends = if repeats { EndRule::Periodic } else { EndRule::Natural };
        let slopes = slopes(&values, 0.7, ends);
        let table = CubicTable::new(3.0, 0.7, &values, &slopes, ends).unwrap();
        match table.value(x) {
            Ok(value) => prop_assert!(value.abs() < 5.0),
            Err(error) => prop_assert!(!x.is_finite() || repeats && x.abs() > 1e15, "{error}"),
        }
    }
}
