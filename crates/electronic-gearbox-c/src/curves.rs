//! Couplings by a polynomial or a table.

use crate::array;
use crate::slot::{Slot, Stored};
use crate::status::{Failure, Refused, Status, give, status, told};
use electronic_gearbox::coupling::{CubicTable, EndRule, PolynomialCoupling, solve_slopes};

impl Stored for PolynomialCoupling {
    const WORDS: usize = 10;
    const MARK: u64 = 0x6567_706f_6c79_3031;
}

impl Stored for CubicTable<'static> {
    const WORDS: usize = 10;
    const MARK: u64 = 0x6567_7461_626c_6531;
}

fn end_rule(ends: u32) -> Result<EndRule, Status> {
    match ends {
        0 => Ok(EndRule::Natural),
        1 => Ok(EndRule::Periodic),
        _ => Err(Status::BadChoice),
    }
}

/// `eg_polynomial_init`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_polynomial_init(
    polynomial: Option<&mut Slot<PolynomialCoupling>>,
    coefficients: *const f64,
    count: usize,
    error: Option<&mut Refused>,
) -> Status {
    let made = || {
        let coefficients = array::read(coefficients, count)?;
        Ok(Slot::put(polynomial, PolynomialCoupling::new(coefficients)?)?)
    };
    told(made(), error)
}

/// `eg_polynomial_value`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_polynomial_value(
    polynomial: Option<&mut Slot<PolynomialCoupling>>,
    x: f64,
    value: Option<&mut f64>,
    derivative: Option<&mut f64>,
) -> Status {
    let made = || {
        let polynomial = Slot::value(polynomial)?;
        if let Some(derivative) = derivative {
            *derivative = polynomial.derivative(x)?;
        }
        give(value, polynomial.value(x)?)
    };
    status(made())
}

/// `eg_table_init`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_table_init(
    table: Option<&mut Slot<CubicTable<'static>>>,
    start: f64,
    spacing: f64,
    values: *const f64,
    slopes: *mut f64,
    count: usize,
    ends: u32,
    workspace: *mut f64,
    error: Option<&mut Refused>,
) -> Status {
    let made = || -> Result<(), Failure> {
        let ends = end_rule(ends)?;
        let room = count.checked_mul(2).ok_or(Status::BadParameter)?;
        let (values, solved) = (array::read(values, count)?, array::write(slopes, count)?);
        solve_slopes(values, spacing, ends, solved, array::write(workspace, room)?)?;
        let slopes = array::read(slopes, count)?;
        Ok(Slot::put(table, CubicTable::new(start, spacing, values, slopes, ends)?)?)
    };
    told(made(), error)
}

/// `eg_table_value`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_table_value(
    table: Option<&mut Slot<CubicTable<'static>>>,
    x: f64,
    value: Option<&mut f64>,
    derivative: Option<&mut f64>,
) -> Status {
    let made = || {
        let table = Slot::value(table)?;
        if let Some(derivative) = derivative {
            *derivative = table.derivative(x)?;
        }
        give(value, table.value(x)?)
    };
    status(made())
}
