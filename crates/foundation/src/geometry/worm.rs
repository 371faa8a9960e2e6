//! The grinding worm for a given gear: which rack both share and which body that makes
//! (`docs/mathematics/involute-gears.md#the-worm-as-a-helical-gear`).

use super::{Gear, GearData, GeometryError, Rack, Sides};
use crate::numerics::wrapped_angle;

/// What is chosen of a worm; the rest follows from the gear. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WormChoice {
    /// Number of threads.
    pub threads: i32,
    /// +1 right-handed, -1 left-handed.
    pub hand: f64,
    /// Pitch diameter d_S; from the tip diameter (addendum 1.25 m_n0) when absent.
    pub pitch_diameter: Option<f64>,
    /// Tip diameter; pitch diameter + 2.5 m_n0 when absent.
    pub tip_diameter: Option<f64>,
    /// Normal profile angle of the worm's rack on the left flank; the gear's own rack when absent.
    pub pressure_angle: Option<f64>,
    /// Profile shift x_1 (default of the field: 0).
    pub profile_shift: f64,
    /// Cone angle theta_1.
    pub cone_angle: f64,
}

/// A worm that meshes with the gear on both flanks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WormForGear {
    /// The worm as a toothed body.
    pub worm: Gear,
    /// The rack shared by both, seen from the gear.
    pub rack: Rack,
    /// Crossed-axes angle gamma = -(beta_w1 + beta_w2), rad.
    pub crossed_axes_angle: f64,
    /// Tip radius r_a1, mm.
    pub tip_radius: f64,
}

/// Builds the worm: rack, pitch radius, helix, crossed-axes angle.
///
/// # Errors
/// [`GeometryError::InvalidNumber`] without any diameter, [`GeometryError::WormTooSmall`], [`GeometryError::NoRack`],
/// [`GeometryError::CylindricalOnly`], those of [`Gear::new`].
pub fn worm_for_gear(gear: &Gear, choice: &WormChoice) -> Result<WormForGear, GeometryError> {
    if choice.threads < 1 {
        return Err(GeometryError::InvalidNumber {
            field: "worm.threads",
            value: f64::from(choice.threads),
            allowed: "an integer >= 1",
        });
    }
    let own = gear.own_rack();
    let rack = match choice.pressure_angle {
        None => own,
        Some(angle) if (angle - own.pressure_angle.left).abs() < 1e-12 => own,
        Some(angle) => gear.rack_with_pressure_angle(super::Flank::Left, angle)?,
    };
    let m = rack.normal_module;
    let addendum = 1.25 * m;
    let (pitch_diameter, tip_diameter) = match (choice.pitch_diameter, choice.tip_diameter) {
        (Some(pitch), Some(tip)) => (pitch, tip),
        (Some(pitch), None) => (pitch, pitch + 2.0 * addendum),
        (None, Some(tip)) => (tip - 2.0 * addendum, tip),
        (None, None) => {
            return Err(GeometryError::InvalidNumber {
                field: "worm.pitch_diameter",
                value: 0.0,
                allowed: "> 0 mm; give pitch_diameter or tip_diameter",
            });
        }
    };
    let least = f64::from(choice.threads) * m;
    if pitch_diameter.is_nan() || pitch_diameter <= least {
        return Err(GeometryError::WormTooSmall {
            threads: choice.threads,
            module: m,
            least,
            diameter: pitch_diameter,
        });
    }
    if tip_diameter <= pitch_diameter {
        return Err(GeometryError::DiametersInconsistent {
            inner: "worm.pitch_diameter",
            inner_value: pitch_diameter,
            outer: "worm.tip_diameter",
            outer_value: tip_diameter,
        });
    }
    let helix_angle = choice.hand.signum() * (least / pitch_diameter).acos();
    let worm = Gear::new(GearData {
        teeth: choice.threads,
        normal_module: m,
        pressure_angle: rack.pressure_angle,
        helix_angle,
        profile_shift: choice.profile_shift,
        cone_angle: choice.cone_angle,
    })?;
    check_mating(&worm, gear)?;
    Ok(WormForGear {
        worm,
        rack,
        crossed_axes_angle: wrapped_angle(-(helix_angle + rack.helix_angle)),
        tip_radius: tip_diameter / 2.0,
    })
}

/// Tests that the normal base pitches of both flanks agree to 1e-9 relative
/// (`docs/mathematics/involute-gears.md#the-worm-as-a-helical-gear`).
///
/// # Errors
/// [`GeometryError::NotMating`] with the first flank that differs.
pub fn check_mating(worm: &Gear, gear: &Gear) -> Result<(), GeometryError> {
    let pitches = Sides::from_fn(|flank| (worm.normal_base_pitch(flank), gear.normal_base_pitch(flank)));
    for (flank, &(worm, gear)) in pitches.iter() {
        if (worm - gear).abs() > 1e-9 * gear {
            return Err(GeometryError::NotMating { flank, worm, gear });
        }
    }
    Ok(())
}
