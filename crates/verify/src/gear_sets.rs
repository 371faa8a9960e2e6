//! The gears of a modification file with their worms, to which its blocks refer by name.

use super::expected::Expected;
use super::ledger::Ledger;
use super::reference::{self, Reference};
use contact::{ContactError, DiagonalLine, Pair};
use foundation::geometry::{Flank, Gear, GearData, GeometryError, Sides};
use foundation::kinematics::GeneratingChain;
use foundation::modification::EvaluationField;
use generating::{FlankLines, GeneratingError};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Workpiece {
    teeth: i32,
    m_n_mm: f64,
    alpha_n_left_deg: f64,
    alpha_n_right_deg: f64,
    beta_deg: f64,
    profile_shift_x: f64,
    face_width_mm: f64,
    #[serde(rename = "d_Nf_mm")]
    start_diameter: f64,
    #[serde(rename = "d_Na_mm")]
    end_diameter: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct WormInput {
    threads: i32,
    pub reference_diameter_mm: f64,
    pub hand: Hand,
    pub beta_deg: f64,
}

#[derive(Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Hand {
    Right,
    Left,
}

/// A gear of the file with its worm; what the other blocks refer to by name.
pub(super) struct Set {
    pub workpiece: Workpiece,
    pub worm: WormInput,
    pub pair: Pair,
}

impl Set {
    pub fn read(name: &str, entry: &Value, ledger: &mut Ledger) -> Option<Self> {
        let workpiece = reference::read::<Workpiece>(name, &entry["workpiece"], ledger)?;
        let worm = reference::read::<WormInput>(name, &entry["worm"], ledger)?;
        let distance = reference::read::<f64>(name, &entry["centre_distance_mm"], ledger)?;
        let gamma = reference::read::<f64>(name, &entry["crossed_axes_angle_deg"], ledger)?;
        match Self::pair(&workpiece, &worm, distance, gamma) {
            Ok(pair) => Some(Self { workpiece, worm, pair }),
            Err(error) => {
                ledger.fail(name, "input", entry.clone(), error.to_string().into());
                None
            }
        }
    }

    fn pair(work: &Workpiece, worm: &WormInput, distance: f64, gamma: f64) -> Result<Pair, ContactError> {
        let data = GearData {
            teeth: work.teeth,
            normal_module: work.m_n_mm,
            pressure_angle: Sides {
                left: work.alpha_n_left_deg.to_radians(),
                right: work.alpha_n_right_deg.to_radians(),
            },
            helix_angle: work.beta_deg.to_radians(),
            profile_shift: work.profile_shift_x,
            cone_angle: 0.0,
        };
        let body = |data| -> Result<Gear, GeometryError> { Gear::new(data) };
        let worm = GearData {
            teeth: worm.threads,
            helix_angle: worm.beta_deg.to_radians(),
            profile_shift: 0.0,
            ..data
        };
        let chain = GeneratingChain {
            centre_distance: distance,
            crossed_axes_angle: gamma.to_radians(),
            worm_cone: 0.0,
            work_cone: 0.0,
            worm_pivot: 0.0,
            work_pivot: 0.0,
        };
        Pair::new(body(worm)?, body(data)?, chain)
    }

    /// [w_f, w_a] of a flank.
    pub fn roll(&self, flank: Flank) -> Result<[f64; 2], GeometryError> {
        let f = self.pair.work.flank(flank);
        Ok([
            f.length_of_roll(self.workpiece.start_diameter / 2.0)?,
            f.length_of_roll(self.workpiece.end_diameter / 2.0)?,
        ])
    }

    pub fn face(&self) -> [f64; 2] {
        let half = self.workpiece.face_width_mm / 2.0;
        [-half, half]
    }

    /// The worm's dressed lines: axial sections at the middle of the profile.
    pub fn worm_line(&self, flank: Flank) -> Result<DiagonalLine, GeometryError> {
        let [w_f, w_a] = self.roll(flank)?;
        Ok(self.pair.flanks[flank].axial_section_line(0.5 * (w_f + w_a)))
    }

    /// The evaluation field of a flank.
    pub fn field(&self, flank: Flank) -> Result<EvaluationField, GeneratingError> {
        let f = self.pair.work.flank(flank);
        let roll = self.roll(flank)?;
        Ok(EvaluationField::new(roll, self.face(), f.base_radius, f.base_helix_angle)?)
    }

    /// Numbers of a flank for lines dressed in direction tan(rho_1).
    pub fn lines(&self, flank: Flank, t_1: f64) -> Result<FlankLines, GeneratingError> {
        Ok(FlankLines::new(&self.pair.flanks[flank], &self.field(flank)?, t_1))
    }
}

/// The gear that an entry names, its flank and everything the check needs.
pub(super) fn named(
    file: &Reference<'_>,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Option<(Set, Flank)> {
    let name = item.given_text("gear", ledger)?;
    let flank = item.given_flank(ledger)?;
    let set = Set::read(name, &file.root["gears"][name], ledger)?;
    Some((set, flank))
}

pub(super) fn entries(
    block_name: &str,
    block: &Value,
    ledger: &mut Ledger,
    check: impl Fn(&mut Expected<'_>, &mut Ledger) -> Result<(), GeneratingError>,
) {
    for (k, entry) in block.as_array().into_iter().flatten().enumerate() {
        let mut item = Expected::new(&format!("{block_name}[{k}]"), "", entry, ledger);
        if let Err(error) = check(&mut item, ledger) {
            item.refused(&error, ledger);
        }
        item.finish(ledger);
    }
}
