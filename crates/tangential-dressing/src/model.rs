//! The bodies of tangential dressing in place (`docs/mathematics/tangential-dressing.md#bodies-in-place`): gear, worm, dresser, their
//! distances and angles, the coupling of the shift. All closed form.

use super::TangentialError;
use super::channel::{Abscissa, Channel};
use super::existing::ExistingDresser;
use super::profile::{Profile, ProfileKind};
use super::settings::Scales;
use contact::{FlankPair, Pair};
use foundation::geometry::{Flank, Gear, Sides};
use foundation::kinematics::{DressingChain, GeneratingChain, MotionLaw};
use std::f64::consts::FRAC_PI_2;

/// Tool shift per feed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShiftRatio {
    /// This one.
    Given(f64),
    /// Width of the shift over the face width.
    Width,
    /// kappa_0, at which the place on the worm depends on the place along the gear alone; the mean where flanks that are ground have
    /// different ones.
    Neutral(Sides<bool>),
}

/// Tool shift at the middle of the gear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShiftOffset {
    /// FT0*: the contact at the middle of the flank is dressed at x_D = 0; 0 where both flanks share a motion, for theirs are opposite.
    Contact,
    /// This one, mm.
    Given(f64),
}

/// What is chosen of the bodies. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TangentialInput {
    /// The workpiece.
    pub gear: Gear,
    /// The worm.
    pub worm: Gear,
    /// Tip radius of the worm, if it limits.
    pub worm_tip_radius: Option<f64>,
    /// Pitch radius of the dresser r_pd.
    pub dresser_pitch_radius: f64,
    /// Tip radius of the dresser, if it limits.
    pub dresser_tip_radius: Option<f64>,
    /// Depth of the dresser's flank below its pitch circle; without it that of the worm's tip.
    pub dresser_depth: Option<f64>,
    /// Its profile.
    pub profile: ProfileKind,
    /// Radii between which the flank is evaluated: r_s, r_e.
    pub radii: [f64; 2],
    /// Axial positions between which it is evaluated.
    pub faces: [f64; 2],
    /// Face width b_g.
    pub face_width: f64,
    /// Range of the tool shift b_w, which is the scale along the worm as well.
    pub shift_width: f64,
    /// Tool shift per feed.
    pub shift_ratio: ShiftRatio,
    /// Tool shift at z = 0.
    pub shift_offset: ShiftOffset,
}

/// The straight line on which the unmodified flank is dressed: x_D = offset + slope (w - w_star) + along z while the tool stands unshifted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DressedLine {
    /// w_star: length of roll on the gear that touches in the plane z_g = 0 at z = 0; of a cylindrical gear in that of every z.
    pub w_star: f64,
    /// FT0*, mm.
    pub offset: f64,
    /// e1.
    pub slope: f64,
    /// e2: how the place moves along the worm with the feed z; 0 for a cylindrical gear.
    pub along: f64,
    /// Largest distance of the true places from it, mm.
    pub nonlinearity: f64,
}

/// Bodies in place.
#[derive(Clone, Debug)]
pub struct TangentialModel {
    input: TangentialInput,
    /// Worm and gear.
    pub pair: Pair,
    /// Nominal motion of dressing.
    pub chain: DressingChain,
    /// Where each flank is dressed.
    pub lines: Sides<DressedLine>,
    /// kappa_0 of each flank, equal where the gear is cylindrical and symmetric; `None` for a spur gear.
    pub neutral_ratios: Sides<Option<f64>>,
    /// kappa.
    pub shift_ratio: f64,
    /// The dresser's sides without the functions that the variables add.
    pub(super) profiles: Sides<Profile>,
    /// What a dresser that exists lacks of them, over s.
    pub(super) existing: Sides<Option<MotionLaw>>,
    pub(super) scales: Scales,
    /// Heights of the dresser that exist, mm.
    pub(super) heights: [f64; 2],
}

/// Share by which the abscissae of splines reach beyond what the unmodified flank needs: a small part of an interval, so that the outermost
/// functions have contacts that settle them.
const SPLINE_MARGIN: f64 = 0.02;

impl TangentialModel {
    /// Puts the bodies in place.
    ///
    /// # Errors
    /// [`TangentialError::InvalidNumber`] for lengths and ratios that are none, bodies that do not mesh, a worm without involute
    /// profile or without conjugate dresser.
    pub fn new(input: TangentialInput) -> Result<Self, TangentialError> {
        let TangentialInput { gear, worm, .. } = &input;
        let data = gear.data();
        let (alpha, module) = (worm.data().pressure_angle, worm.data().normal_module);
        check(&input)?;
        // A worm of another profile angle meets the gear on another rack, on which it stands under another angle.
        let own_rack = alpha == data.pressure_angle;
        let rack =
            if own_rack { gear.own_rack() } else { gear.rack_with_pressure_angle(Flank::Left, alpha.left)? };
        let (beta_1, beta_2) = (worm.data().helix_angle, rack.helix_angle);
        let (r_p1, r_p2) = (worm.pitch_radius(), gear.pitch_radius());
        let angle = -(beta_1 + beta_2);
        let pair = if gear.is_cylindrical() && own_rack {
            Pair::new(
                *worm,
                *gear,
                GeneratingChain {
                    centre_distance: r_p1 + r_p2 + data.profile_shift * module,
                    crossed_axes_angle: angle,
                    worm_cone: 0.0,
                    work_cone: 0.0,
                    worm_pivot: 0.0,
                    work_pivot: 0.0,
                },
            )?
        } else {
            Pair::without_backlash(*worm, *gear, angle)?
        };
        let chain = DressingChain {
            worm_angle: -FRAC_PI_2,
            crossing_angle: beta_1 - beta_1.signum() * FRAC_PI_2,
            centre_distance: r_p1 + input.dresser_pitch_radius,
            offset: 0.0,
            screw_parameter: worm.screw_parameter(Flank::Left),
        };
        // Along the face the rack climbs a cone.
        let climb = input.faces.into_iter().map(f64::abs).fold(0.0, f64::max) * data.cone_angle.tan().abs();
        let profiles = Sides::try_from_fn(|flank| {
            let radii = [input.dresser_pitch_radius, r_p1];
            let kind = (input.profile, climb);
            Profile::new(worm.flank(flank), &chain, radii, [module, alpha[flank]], kind)
        })?;
        let lines = Sides::from_fn(|flank| dressed_line(&pair, &profiles[flank], flank, input.radii));
        // x_D = e1 (w - w_star) + (e2 - kappa) z, and z moves with w while z_g stays.
        let neutral_ratios = Sides::from_fn(|flank| {
            let by_roll = feed_by_roll(&pair.flanks[flank]);
            let DressedLine { slope, along, .. } = lines[flank];
            (by_roll.abs() > 1e-12).then(|| along + slope / by_roll)
        });
        let shift_ratio = match input.shift_ratio {
            ShiftRatio::Given(ratio) => ratio,
            ShiftRatio::Width => input.shift_width / input.face_width,
            ShiftRatio::Neutral(flanks) => {
                let ratios: Vec<f64> = Flank::BOTH
                    .into_iter()
                    .filter(|&f| flanks[f])
                    .filter_map(|f| neutral_ratios[f])
                    .collect();
                if ratios.is_empty() {
                    return Err(TangentialError::InvalidNumber {
                        field: "shift_ratio",
                        value: beta_2.to_degrees(),
                        allowed: "a number: the helix angle of a spur gear leaves no neutral ratio",
                    });
                }
                ratios.iter().sum::<f64>() / ratios.len() as f64
            }
        };
        let [low, high] = profiles.left.heights;
        let lowest = match (input.dresser_depth, input.worm_tip_radius) {
            (Some(depth), _) if depth > 0.0 && depth <= -low => -depth,
            (Some(value), _) => {
                return Err(TangentialError::InvalidNumber {
                    field: "dresser.flank_depth",
                    value,
                    allowed: "above 0 and at most 1.75 normal modules",
                });
            }
            (None, Some(tip)) => low.max(r_p1 - tip),
            (None, None) => low,
        };
        let dresser_tip = input.dresser_tip_radius.map_or(high, |r| high.min(r - input.dresser_pitch_radius));
        Ok(Self {
            pair,
            chain,
            lines,
            neutral_ratios,
            shift_ratio,
            profiles,
            existing: Sides { left: None, right: None },
            heights: [lowest, dresser_tip],
            scales: Scales {
                normal_module: data.normal_module,
                mean_tangent: 0.5 * (data.pressure_angle.left.tan() + data.pressure_angle.right.tan()),
                shift_width: input.shift_width,
                face_width: input.face_width,
                work_pitch_radius: r_p2,
            },
            input,
        })
    }

    /// The same bodies with a dresser that exists: its sides are what they are, whatever worm they were made for.
    ///
    /// # Errors
    /// [`TangentialError::InvalidNumber`] for a profile that has no value, or that turns back on itself.
    pub fn with_dresser(self, dresser: &ExistingDresser) -> Result<Self, TangentialError> {
        let existing = Sides::try_from_fn(|flank| dresser.lacking(&self.profiles[flank], flank).map(Some))?;
        Ok(Self { existing, ..self })
    }

    /// kappa_0 where both flanks have the same, within what rounding leaves; `None` for a spur gear too.
    pub fn neutral_ratio(&self) -> Option<f64> {
        let Sides { left: Some(left), right: Some(right) } = self.neutral_ratios else { return None };
        ((left - right).abs() <= 1e-9 * (1.0 + left.abs())).then_some(left)
    }

    /// What it was made from.
    pub fn input(&self) -> &TangentialInput {
        &self.input
    }

    /// Heights of the dresser above its pitch circle that are there, mm.
    pub fn dresser_heights(&self) -> [f64; 2] {
        self.heights
    }

    /// Lengths of roll of the evaluated range on a flank, from start to end, mm.
    pub fn rolls(&self, flank: Flank) -> [f64; 2] {
        let r_b = self.pair.work.flank(flank).base_radius;
        // `check` has seen both radii above the base circle.
        self.input.radii.map(|r| (r * r - r_b * r_b).sqrt())
    }

    /// Radius of a length of roll, mm.
    pub fn radius(&self, flank: Flank, w: f64) -> f64 {
        self.pair.work.flank(flank).radius(w)
    }

    /// Tool shift at z = 0 for the flanks of one pass, mm.
    pub fn shift_offset(&self, flanks: &[Flank]) -> f64 {
        match (self.input.shift_offset, flanks) {
            (ShiftOffset::Given(offset), _) => offset,
            (ShiftOffset::Contact, [only]) => self.lines[*only].offset,
            (ShiftOffset::Contact, _) => 0.0,
        }
    }

    /// Abscissae over which a spline of a channel is laid: what the unmodified flanks of one pass need, and a little more.
    pub fn spline_range(&self, channel: Channel, flanks: &[Flank]) -> [f64; 2] {
        let offset = self.shift_offset(flanks);
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        for &flank in flanks {
            for w in self.rolls(flank) {
                for z_g in self.input.faces {
                    let (line, pair) = (&self.lines[flank], &self.pair.flanks[flank]);
                    let z = (pair.work_z(w, 0.0, 0.0) - z_g) / pair.c_zv22;
                    let x_d =
                        line.offset + line.slope * (w - line.w_star) + (line.along - self.shift_ratio) * z
                            - offset;
                    let at = match channel.abscissa() {
                        Abscissa::Profile => self.profiles[flank].height(pair.worm_roll(w, 0.0, -z)),
                        Abscissa::Worm => x_d,
                        Abscissa::Gear => z,
                    };
                    let at = at * self.scales.per_length(channel.abscissa());
                    range = [range[0].min(at), range[1].max(at)];
                }
            }
        }
        let margin = SPLINE_MARGIN * (range[1] - range[0]);
        [range[0] - margin, range[1] + margin]
    }
}

fn check(input: &TangentialInput) -> Result<(), TangentialError> {
    let TangentialInput { gear, worm, radii: [r_s, r_e], .. } = *input;
    let number = |field, value: f64, good: bool, allowed| {
        if good { Ok(()) } else { Err(TangentialError::InvalidNumber { field, value, allowed }) }
    };
    let data = gear.data();
    number("teeth", gear.tooth_count(), data.teeth > 0, "an external gear: > 0")?;
    number("cone angle of the worm", worm.data().cone_angle.to_degrees(), worm.is_cylindrical(), "0 deg")?;
    for (_, alpha) in data.pressure_angle.iter() {
        let degrees = alpha.to_degrees();
        number("normal_pressure_angle", degrees, degrees > 0.0 && degrees < 45.0, "between 0 and 45 deg")?;
    }
    let least = worm.tooth_count() * data.normal_module;
    let diameter = 2.0 * worm.pitch_radius();
    number("pitch diameter of the worm", diameter, diameter > least, "> threads times normal module")?;
    let r_b2 = Flank::BOTH.map(|flank| gear.flank(flank).base_radius).into_iter().fold(0.0, f64::max);
    number("start radius", r_s, r_s.is_finite() && r_s > r_b2, "above the base circle of the gear")?;
    number("end radius", r_e, r_e.is_finite() && r_e > r_s, "above the start radius")?;
    let [from, to] = input.faces;
    number("end of the face", to, from.is_finite() && to.is_finite() && to > from, "above its beginning")?;
    for (field, value) in [
        ("face_width", input.face_width),
        ("shift_width", input.shift_width),
        ("pitch radius of the dresser", input.dresser_pitch_radius),
    ] {
        number(field, value, value.is_finite() && value > 0.0, "> 0 mm")?;
    }
    if let ShiftRatio::Given(ratio) = input.shift_ratio {
        number("shift_ratio", ratio, ratio.is_finite(), "a finite number")?;
    }
    if let ShiftOffset::Given(offset) = input.shift_offset {
        number("shift_offset", offset, offset.is_finite(), "a finite number")?;
    }
    Ok(())
}

/// Equidistant lengths of roll through which the dressed line is laid.
const LINE_POINTS: u32 = 9;

/// dz/dw: how the feed of the tool follows the length of roll at the same place of the gear.
pub(super) fn feed_by_roll(pair: &FlankPair) -> f64 {
    pair.c_w2 / pair.c_zv22
}

/// The dressed line of a flank: the straight line of least squares through equidistant lengths of roll.
fn dressed_line(pair: &Pair, profile: &Profile, flank: Flank, radii: [f64; 2]) -> DressedLine {
    let both = &pair.flanks[flank];
    let r_b = pair.work.flank(flank).base_radius;
    let [from, to] = radii.map(|r| (r * r - r_b * r_b).sqrt());
    // work_z is affine in w and vanishes at w_star; a spur gear touches in its plane everywhere.
    let (at_0, at_1) = (both.work_z(0.0, 0.0, 0.0), both.work_z(1.0, 0.0, 0.0));
    let w_star = if (at_1 - at_0).abs() > 1e-12 { at_0 / (at_0 - at_1) } else { 0.5 * (from + to) };
    let places = (0..LINE_POINTS).map(|i| {
        let w = from + (to - from) * f64::from(i) / f64::from(LINE_POINTS - 1);
        let w_1 = both.worm_roll(w, 0.0, 0.0);
        (w - w_star, both.worm_z(w_1, 0.0, 0.0) - profile.line(w_1))
    });
    let n = f64::from(LINE_POINTS);
    let (sum_w, sum_x) = places.clone().fold((0.0, 0.0), |(a, b), (w, x)| (a + w, b + x));
    let (mean_w, mean_x) = (sum_w / n, sum_x / n);
    let (across, along) = places.clone().fold((0.0, 0.0), |(a, b), (w, x)| {
        (a + (w - mean_w) * (x - mean_x), b + (w - mean_w) * (w - mean_w))
    });
    let slope = across / along;
    let offset = mean_x - slope * mean_w;
    let nonlinearity = places.map(|(w, x)| (x - offset - slope * w).abs()).fold(0.0, f64::max);
    // The feed z = -z_V2 moves the contact along a conical gear's rack, up or down the worm's profile.
    let roll_by_feed = both.hat_zv2 / both.hat_w1;
    let middle = both.worm_roll(0.5 * (from + to), 0.0, 0.0);
    let along = (both.c_w1 - profile.line_slope(middle)) * roll_by_feed - both.c_zv21;
    DressedLine { w_star, offset, slope, along, nonlinearity }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use foundation::geometry::GearData;

    /// Table 2 of the source.
    pub(crate) fn source_input(profile: ProfileKind) -> Result<TangentialInput, TangentialError> {
        let data = GearData {
            teeth: 19,
            normal_module: 3.5,
            pressure_angle: Sides::both(17.5f64.to_radians()),
            helix_angle: (-35f64).to_radians(),
            profile_shift: 0.0,
            cone_angle: 0.0,
        };
        let lead_angle = (3.0 * 3.5 / (2.0 * 95.625f64)).asin();
        Ok(TangentialInput {
            gear: Gear::new(data)?,
            worm: Gear::new(GearData { teeth: 3, helix_angle: lead_angle - FRAC_PI_2, ..data })?,
            worm_tip_radius: None,
            dresser_pitch_radius: 57.825,
            dresser_tip_radius: None,
            dresser_depth: None,
            profile,
            radii: [38.10325, 44.26575],
            faces: [-20.0, 20.0],
            face_width: 40.0,
            shift_width: 48.1042,
            shift_ratio: ShiftRatio::Given(1.202605),
            shift_offset: ShiftOffset::Given(0.0),
        })
    }

    pub(crate) fn source_model(profile: ProfileKind) -> Result<TangentialModel, TangentialError> {
        TangentialModel::new(source_input(profile)?)
    }

    #[test]
    fn bodies_that_cannot_be_are_refused_by_name() {
        let good = source_input(ProfileKind::Conjugate).unwrap();
        let spur = GearData { helix_angle: 0.0, ..*good.gear.data() };
        let cases: [(&str, TangentialInput); 10] = [
            ("start radius", TangentialInput { radii: [37.8, 44.0], ..good }),
            ("start radius", TangentialInput { radii: [f64::NAN, 44.0], ..good }),
            ("end radius", TangentialInput { radii: [39.0, 39.0], ..good }),
            ("face_width", TangentialInput { face_width: 0.0, ..good }),
            ("shift_width", TangentialInput { shift_width: -1.0, ..good }),
            ("shift_ratio", TangentialInput { shift_ratio: ShiftRatio::Given(f64::INFINITY), ..good }),
            ("shift_offset", TangentialInput { shift_offset: ShiftOffset::Given(f64::NAN), ..good }),
            ("end of the face", TangentialInput { faces: [3.0, -3.0], ..good }),
            ("pitch radius of the dresser", TangentialInput { dresser_pitch_radius: 0.0, ..good }),
            (
                "shift_ratio",
                TangentialInput {
                    gear: Gear::new(spur).unwrap(),
                    shift_ratio: ShiftRatio::Neutral(Sides::both(true)),
                    ..good
                },
            ),
        ];
        for (field, input) in cases {
            let error = TangentialModel::new(input).unwrap_err();
            assert!(error.is_bad_input() && !error.way_out().is_empty(), "{error}");
            assert!(
                matches!(&error, TangentialError::InvalidNumber { field: f, .. } if *f == field),
                "{error}"
            );
        }
    }
}
