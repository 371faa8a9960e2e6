//! From gear data to ratios and coefficients; for the set-up of a machine, not for its running loop.

use crate::status::{Failure, Refused, Status, give, told};
use electronic_gearbox::Sign;
use electronic_gearbox::coefficient::{Coefficient, CouplingSigns, Couplings, GearGeometry};
use electronic_gearbox::coupling::{Ratio, dyadic, endless_ratio};

/// `eg_gear`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Gear {
    normal_module_mm: f64,
    helix_angle_rad: f64,
    normal_pressure_angle_rad: f64,
    teeth: i32,
}

impl Gear {
    fn geometry(gear: Option<&Self>) -> Result<GearGeometry, Failure> {
        let Self { normal_module_mm, helix_angle_rad, normal_pressure_angle_rad, teeth } =
            *gear.ok_or(Status::NullPointer)?;
        Ok(GearGeometry::new(normal_module_mm, teeth, helix_angle_rad, normal_pressure_angle_rad)?)
    }
}

/// `eg_coefficient`.
#[repr(C)]
pub struct RateCoefficient {
    exact: f64,
    word: u32,
    hand: i32,
}

/// `eg_couplings`.
#[repr(C)]
pub struct AxisCouplings {
    worm_turn: f64,
    feed: f64,
    shift: f64,
}

/// `eg_ratio`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Fraction {
    pub(crate) numerator: i64,
    pub(crate) denominator: i64,
}

impl From<Ratio> for Fraction {
    fn from(ratio: Ratio) -> Self {
        Self { numerator: ratio.numerator(), denominator: ratio.denominator() }
    }
}

/// `eg_gear_coefficient`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_gear_coefficient(
    gear: Option<&Gear>,
    pulses_per_revolution: u32,
    pulses_per_metre: f64,
    reversed: bool,
    coefficient: Option<&mut RateCoefficient>,
    error: Option<&mut Refused>,
) -> Status {
    let made = || {
        let machine = if reversed { Sign::Minus } else { Sign::Plus };
        let gear = Gear::geometry(gear)?;
        let found = Coefficient::new(&gear, pulses_per_revolution, pulses_per_metre, machine)?;
        let hand = if found.hand() == Sign::Plus { 1 } else { -1 };
        give(coefficient, RateCoefficient { exact: found.exact(), word: found.word(), hand })
    };
    told(made(), error)
}

/// `eg_gear_couplings`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_gear_couplings(
    gear: Option<&Gear>,
    worm_starts: u32,
    worm_helix_angle_rad: f64,
    couplings: Option<&mut AxisCouplings>,
    error: Option<&mut Refused>,
) -> Status {
    let made = || {
        let gear = Gear::geometry(gear)?;
        let found = Couplings::new(&gear, worm_starts, worm_helix_angle_rad, CouplingSigns::default())?;
        give(couplings, AxisCouplings { worm_turn: found.worm_turn, feed: found.feed, shift: found.shift })
    };
    told(made(), error)
}

/// `eg_endless_ratio`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_endless_ratio(
    tool_starts: i64,
    workpiece_counts: i64,
    workpiece_teeth: i64,
    tool_counts: i64,
    ratio: Option<&mut Fraction>,
    error: Option<&mut Refused>,
) -> Status {
    let found = endless_ratio(tool_starts, workpiece_counts, workpiece_teeth, tool_counts);
    told(found.map_err(Failure::from).and_then(|found| give(ratio, found.into())), error)
}

/// `eg_nearest_ratio`.
#[unsafe(no_mangle)]
pub extern "C" fn eg_nearest_ratio(
    value: f64,
    ratio: Option<&mut Fraction>,
    error: Option<&mut Refused>,
) -> Status {
    told(dyadic(value).map_err(Failure::from).and_then(|found| give(ratio, found.ratio().into())), error)
}
