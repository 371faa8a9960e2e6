//! Workpiece, worm and settings of the closed loop's cases.

use super::super::expected::Expected;
use super::super::given::{Checked, MOST, count, number, whole};
use super::super::ledger::Ledger;
use contact::Pair;
use foundation::geometry::{Flank, Gear, GearData, Sides, WormChoice, worm_for_gear};
use foundation::modification::EvaluationField;
use foundation::numerics::equidistant;
use generating::FlankLines;
use generating::correction::{FlankPoint, Setting, SettingUnit};

/// A micrometre, mm.
pub(super) const UM: f64 = 1e-3;

/// Pair, field and lines of a case.
pub(super) struct Grinding {
    pub pair: Pair,
    pub fields: Sides<EvaluationField>,
    pub lines: Sides<FlankLines>,
    pub face_width: f64,
    pub ratio: f64,
}

impl Grinding {
    /// From `workpiece`, `worm` and `K_ZV1`.
    pub fn read(input: &mut Expected<'_>, ledger: &mut Ledger) -> Checked<Self> {
        let mut work = input.object("workpiece", ledger).ok_or("workpiece is missing")?;
        let mut get = |key: &str| number(&mut work, key, ledger);
        let [module, left, right, beta, shift] =
            ["m_n_mm", "alpha_n_left_deg", "alpha_n_right_deg", "beta_deg", "profile_shift_x"].map(&mut get);
        let [face_width, start, end] = ["face_width_mm", "d_Nf_mm", "d_Na_mm"].map(&mut get);
        let (face_width, start, end) = (face_width?, start?, end?);
        let teeth = count(&mut work, "teeth", 1..=10_000)?;
        work.finish(ledger);
        let gear = Gear::new(GearData {
            teeth: i32::try_from(teeth)?,
            normal_module: module?,
            pressure_angle: Sides { left: left?.to_radians(), right: right?.to_radians() },
            helix_angle: beta?.to_radians(),
            profile_shift: shift?,
            cone_angle: 0.0,
        })?;
        let pair = Self::pair(gear, input, ledger)?;
        let fields = Sides::try_from_fn(|flank| -> Checked<EvaluationField> {
            let f = pair.work.flank(flank);
            let roll = [f.length_of_roll(start / 2.0)?, f.length_of_roll(end / 2.0)?];
            let half = face_width / 2.0;
            Ok(EvaluationField::new(roll, [-half, half], f.base_radius, f.base_helix_angle)?)
        })?;
        let lines = Sides::from_fn(|flank| {
            let own = &pair.flanks[flank];
            FlankLines::new(
                own,
                &fields[flank],
                own.axial_section_line(fields[flank].roll_middle()).rho.tan(),
            )
        });
        let ratio = number(input, "K_ZV1", ledger)?;
        Ok(Self { pair, fields, lines, face_width, ratio })
    }

    fn pair(gear: Gear, input: &mut Expected<'_>, ledger: &mut Ledger) -> Checked<Pair> {
        let mut worm = input.object("worm", ledger).ok_or("worm is missing")?;
        let threads = whole("threads", worm.take("threads"), 1..=100)?;
        let diameter = number(&mut worm, "reference_diameter_mm", ledger)?;
        let extra = number(&mut worm, "extra_centre_distance_mm", ledger)?;
        let hand = super::super::given::requires(&mut worm, "hand", &["right", "left"], ledger)?;
        worm.finish(ledger);
        let choice = WormChoice {
            threads: i32::try_from(threads)?,
            hand: if hand == 0 { 1.0 } else { -1.0 },
            pitch_diameter: Some(diameter),
            tip_diameter: None,
            pressure_angle: None,
            profile_shift: 0.0,
            cone_angle: 0.0,
        };
        let made = worm_for_gear(&gear, &choice)?;
        let close = Pair::without_backlash(made.worm, gear, made.crossed_axes_angle)?;
        let mut chain = close.chain;
        chain.centre_distance += extra;
        Ok(Pair::new(close.worm, close.work, chain)?)
    }

    /// An even grid over both flanks, borders included: left first, then over w, then over z.
    pub fn grid(&self, input: &mut Expected<'_>) -> Checked<Vec<FlankPoint>> {
        let sizes = [count(input, "grid_n_w", 2..=MOST)?, count(input, "grid_n_z", 2..=MOST)?];
        let mut points = Vec::new();
        for flank in Flank::BOTH {
            let z = equidistant(self.fields[flank].face(), sizes[1]);
            for w in equidistant(self.fields[flank].roll(), sizes[0]) {
                points.extend(z.iter().map(|&z| FlankPoint { flank, w, z }));
            }
        }
        Ok(points)
    }
}

/// The file's unit of a setting in that of the library.
pub(super) fn unit(setting: Setting) -> f64 {
    match setting.unit() {
        SettingUnit::Length => UM,
        SettingUnit::Angle => (1.0f64 / 3600.0).to_radians(),
        SettingUnit::Ratio => 1.0,
    }
}

/// The file's name of a setting.
pub(super) fn key(setting: Setting) -> String {
    let unit = match setting.unit() {
        SettingUnit::Length => "_um",
        SettingUnit::Angle => "_arcsec",
        SettingUnit::Ratio => "",
    };
    format!("{}{unit}", setting.name())
}

/// The setting of a name.
pub(super) fn setting(name: &str) -> Checked<Setting> {
    let known = Setting::USUAL.into_iter().find(|s| key(*s) == name);
    known.ok_or_else(|| format!("{name} is no setting").into())
}
