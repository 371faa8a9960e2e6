//! Worms with which both flanks need the same diagonal ratio
//! (`docs/mathematics/generating-contact.md#contact-path-lines-and-the-diagonal-ratio`): one number of the worm's design is the lever, and
//! for each of its values the worm is built anew. Knows directions of lines, not what is written along them.

use super::GeneratingError;
use contact::{ContactError, DiagonalLine, FlankPair, Pair};
use foundation::geometry::{Gear, GeometryError, Sides, WormChoice, WormForGear, worm_for_gear};
use foundation::numerics::brent;

/// The number of the worm's design that is varied, rad.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lever {
    /// theta_1 of the worm.
    ConeAngle,
    /// Normal profile angle of the worm's rack on the left flank. Cylindrical gears only.
    ProfileAngle,
    /// gamma, by way of the worm's pitch diameter; rack, threads and hand stay.
    CrossingAngle,
}

/// Direction of the worm's lines on a flank, as the dressing of that worm gives it.
pub type WormLine<'a> = &'a dyn Fn(&FlankPair) -> Result<DiagonalLine, GeneratingError>;

/// What is given: everything of the worm but the lever.
#[derive(Clone, Copy)]
pub struct EqualRatioSearch<'a> {
    /// The workpiece.
    pub work: &'a Gear,
    /// The worm to start from.
    pub worm: WormChoice,
    /// Direction rho_2 of the modification on each flank of the workpiece.
    pub work_lines: Sides<DiagonalLine>,
    /// Direction rho_1 of the worm's lines, evaluated anew for every worm; [`generatrix`] where nothing better is known.
    pub worm_line: WormLine<'a>,
}

/// A worm on which K_ZV1 is the same for both flanks.
#[derive(Clone, Debug, PartialEq)]
pub struct RatioRoot {
    /// Value of the lever, rad.
    pub value: f64,
    /// The common K_ZV1.
    pub ratio: f64,
    /// The worm.
    pub design: WormForGear,
    /// Worm and workpiece without backlash.
    pub pair: Pair,
}

/// What a search found.
#[derive(Clone, Debug, PartialEq)]
pub struct EqualRatio {
    /// K_l and K_r of the worm that the search started from, or why there are none.
    pub start: Result<Sides<f64>, GeneratingError>,
    /// K_l = K_r for every value of the lever (mirrored directions on a symmetric gear whose worm stays symmetric): the
    /// lever changes nothing, and `roots` holds the start if it is such a worm.
    pub everywhere: bool,
    /// Worms with equal ratios, the smallest change of the design first; of the cone angle the smallest cone first.
    pub roots: Vec<RatioRoot>,
}

/// Lines along the straight generatrix of the worm flank, tan(rho_1) = -s/tan(beta_b1): the default estimate of dressed
/// lines (`docs/mathematics/generating-contact.md#contact-path-lines-and-the-diagonal-ratio`). On a cylindrical pair K_l/K_r of such lines
/// depends on sin(beta_b1) alone, whose proportion between the flanks neither the profile angle nor the crossing angle changes: only the
/// cone angle is a lever for them.
///
/// # Errors
/// None; the signature is that of [`WormLine`].
pub fn generatrix(flank: &FlankPair) -> Result<DiagonalLine, GeneratingError> {
    Ok(DiagonalLine { rho: (-flank.flank().sign() / flank.worm.base_helix_angle.tan()).atan() })
}

/// The worm whose crossed-axes angle is gamma = -(beta_w1 + beta_w2) (rad;
/// `docs/mathematics/involute-gears.md#the-worm-as-a-helical-gear`): the pitch diameter follows from the helix, tip and root go with it;
/// rack, threads and hand stay.
///
/// # Errors
/// Those of the rack; `InvalidNumber` for an angle that no worm of this hand has on the gear's rack.
pub fn worm_at_crossing_angle(
    work: &Gear,
    worm: &WormChoice,
    angle: f64,
) -> Result<WormChoice, GeneratingError> {
    let rack = worm_for_gear(work, worm)?.rack;
    let helix = -(angle + rack.helix_angle);
    let helix = helix - 2.0 * std::f64::consts::PI * (helix / (2.0 * std::f64::consts::PI)).round();
    let reached = helix * worm.hand > 0.0 && helix.cos() > 0.0;
    if !reached {
        return Err(ContactError::InvalidNumber {
            field: "crossed-axes angle (deg)",
            value: angle.to_degrees(),
            allowed: "one that a worm of the given hand has on the gear's rack",
        }
        .into());
    }
    let pitch = f64::from(worm.threads) * rack.normal_module / helix.cos();
    let tip_diameter = worm.pitch_diameter.and_then(|old| Some(worm.tip_diameter? - old + pitch));
    Ok(WormChoice { pitch_diameter: Some(pitch), tip_diameter, ..*worm })
}

/// Values of the lever that are tried (`docs/mathematics/generating-contact.md#contact-path-lines-and-the-diagonal-ratio`).
const SAMPLES: usize = 141;
/// Interval at which Brent stops, rad.
const SETTLED: f64 = 1e-15;
/// At a root K_l - K_r falls below this share of its values beside it; at a pole it does not
/// (`docs/mathematics/generating-contact.md#contact-path-lines-and-the-diagonal-ratio`).
const POLE: f64 = 1e-6;
/// Rounding of K_l - K_r as a share of the ratios: some ten operations on each with conditions up to a hundred.
const ROUNDING: f64 = 1e-12;

/// One worm with both its ratios.
struct Sample {
    design: WormForGear,
    pair: Pair,
    ratios: Sides<f64>,
}

impl Sample {
    fn difference(&self) -> f64 {
        self.ratios.left - self.ratios.right
    }

    /// Whether the difference is rounding.
    fn is_zero(&self) -> bool {
        self.difference().abs() <= ROUNDING * (self.ratios.left.abs() + self.ratios.right.abs())
    }

    fn root(self, value: f64) -> RatioRoot {
        let ratio = 0.5 * (self.ratios.left + self.ratios.right);
        RatioRoot { value, ratio, design: self.design, pair: self.pair }
    }
}

impl EqualRatioSearch<'_> {
    /// Ratios of the worm as chosen.
    ///
    /// # Errors
    /// Those of the bodies, the contact and the directions; `DiagonalRatioInfinite` where a flank has no ratio.
    pub fn ratios(&self) -> Result<Sides<f64>, GeneratingError> {
        Ok(self.sample(&self.worm)?.ratios)
    }

    /// All worms with equal ratios for values of the lever in `range` (rad). Values for which there is no worm, no contact
    /// or no ratio are passed over.
    ///
    /// # Errors
    /// `InvalidNumber` for the range, `CylindricalOnly` for the profile angle with a conical gear, and the first error of
    /// the bodies if no value of the lever gives a worm.
    pub fn search(&self, lever: Lever, range: [f64; 2]) -> Result<EqualRatio, GeneratingError> {
        let [from, to] = range;
        for value in range {
            if !value.is_finite() || to <= from {
                let allowed = "two finite ends, ascending";
                return Err(
                    ContactError::InvalidNumber { field: "range of the lever", value, allowed }.into()
                );
            }
        }
        if lever == Lever::ProfileAngle && !self.work.is_cylindrical() {
            return Err(GeometryError::CylindricalOnly.into());
        }
        let values = (0..SAMPLES).map(|k| from + (to - from) * k as f64 / (SAMPLES - 1) as f64);
        let samples: Vec<(f64, Result<Sample, GeneratingError>)> =
            values.map(|value| (value, self.at(lever, value))).collect();
        let good = || samples.iter().filter_map(|(value, sample)| Some((*value, sample.as_ref().ok()?)));
        // Where none of them is a worm, the first reason is as good as the others.
        if good().next().is_none()
            && let Some((_, Err(reason))) = samples.first()
        {
            return Err(reason.clone());
        }
        let start = self.ratios();
        let everywhere = good().all(|(_, sample)| sample.is_zero());
        let mut roots = Vec::new();
        if everywhere {
            let own = self.sample(&self.worm).ok().filter(Sample::is_zero);
            roots.extend(own.map(|sample| {
                let value = self.value_of(lever, &sample);
                sample.root(value)
            }));
        } else {
            let zeros: Vec<f64> = good().filter(|(_, s)| s.is_zero()).map(|(value, _)| value).collect();
            let crossings = samples.windows(2).filter_map(|pair| self.crossing(lever, &pair[0], &pair[1]));
            for value in zeros.into_iter().chain(crossings) {
                roots.push(self.at(lever, value)?.root(value));
            }
        }
        let origin = match lever {
            Lever::ConeAngle => 0.0,
            _ => self.sample(&self.worm).map_or(0.5 * (from + to), |sample| self.value_of(lever, &sample)),
        };
        roots.sort_by(|a, b| (a.value - origin).abs().total_cmp(&(b.value - origin).abs()));
        Ok(EqualRatio { start, everywhere, roots })
    }

    /// The root between two neighbours of the scan, if the difference changes its sign there through zero.
    fn crossing(
        &self,
        lever: Lever,
        (a, left): &(f64, Result<Sample, GeneratingError>),
        (b, right): &(f64, Result<Sample, GeneratingError>),
    ) -> Option<f64> {
        let (left, right) = (left.as_ref().ok()?, right.as_ref().ok()?);
        // Zeros of the scan are roots already.
        if left.is_zero() || right.is_zero() {
            return None;
        }
        let ends = [left.difference(), right.difference()];
        let difference = |value: f64| self.at(lever, value).ok().map(|sample| sample.difference());
        let root = brent([*a, *b], ends, SETTLED, difference)?;
        let rest = difference(root)?;
        (rest.abs() <= POLE * (1.0 + ends[0].abs() + ends[1].abs())).then_some(root)
    }

    /// The lever's value of a worm.
    fn value_of(&self, lever: Lever, sample: &Sample) -> f64 {
        match lever {
            Lever::ConeAngle => self.worm.cone_angle,
            Lever::ProfileAngle => sample.design.rack.pressure_angle.left,
            Lever::CrossingAngle => sample.design.crossed_axes_angle,
        }
    }

    /// The worm with a value of the lever.
    fn at(&self, lever: Lever, value: f64) -> Result<Sample, GeneratingError> {
        let choice = match lever {
            Lever::ConeAngle => WormChoice { cone_angle: value, ..self.worm },
            Lever::ProfileAngle => WormChoice { pressure_angle: Some(value), ..self.worm },
            Lever::CrossingAngle => worm_at_crossing_angle(self.work, &self.worm, value)?,
        };
        self.sample(&choice)
    }

    fn sample(&self, choice: &WormChoice) -> Result<Sample, GeneratingError> {
        let design = worm_for_gear(self.work, choice)?;
        let pair = Pair::without_backlash(design.worm, *self.work, design.crossed_axes_angle)?;
        let ratios = Sides::try_from_fn(|flank| {
            let relations = &pair.flanks[flank];
            let worm_line = (self.worm_line)(relations)?;
            Ok::<_, GeneratingError>(relations.ratio_of_directions(worm_line, self.work_lines[flank])?)
        })?;
        Ok(Sample { design, pair, ratios })
    }
}
