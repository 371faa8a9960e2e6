//! Bodies and target of a planning case, built the way jobs are.

use super::super::ledger::Ledger;
use foundation::geometry::{Blank, Flank, Gear, GearData, Sides, WormChoice};
use foundation::modification::{Modification, ModificationSpec, NoFiles};
use generating::{
    DresserChoice, DressingLimits, FlankTarget, GeneratingError, GrindingSetup, ProfilePlace, SetupInput,
};
use serde::Deserialize;
use serde_json::Value;

const UM: f64 = 1e-3;

/// `input` of a case. Keys after `profile_crowning_by` follow from the others and are compared.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Input {
    teeth: i32,
    normal_module_mm: f64,
    alpha_n_deg: f64,
    beta_deg: f64,
    profile_shift: f64,
    face_width_mm: f64,
    end_diameter_mm: f64,
    start_diameter_mm: f64,
    worm_threads: i32,
    worm_hand: f64,
    worm_tip_diameter_mm: f64,
    worm_width_mm: Option<f64>,
    dresser_tip_diameter_mm: f64,
    dresser_pitch_diameter_mm: Option<f64>,
    modifications: PerFlank,
    profile_crowning_by: Place,
    limits: Option<Limits>,
    tolerance_um: Option<f64>,
    worm_pitch_radius_mm: Option<f64>,
    worm_root_radius_mm: Option<f64>,
    d_mm: Option<f64>,
    gamma_deg: Option<f64>,
    #[serde(rename = "d_A0_mm")]
    d_a0_mm: Option<f64>,
    #[serde(rename = "gamma_A0_deg")]
    gamma_a0_deg: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PerFlank {
    left: Option<Vec<Value>>,
    right: Option<Vec<Value>>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Place {
    Auto,
    Dresser,
    Diagonal,
    Correction,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
struct Limits {
    #[serde(rename = "phi_S_deg")]
    phi_deg: f64,
    gamma_deg: f64,
    d_mm: f64,
    v_y_mm: f64,
    #[serde(rename = "Delta_d_mm")]
    delta_d_mm: f64,
}

impl Input {
    /// All bodies in place.
    pub fn setup(&self) -> Result<GrindingSetup, GeneratingError> {
        let gear = Gear::new(GearData {
            teeth: self.teeth,
            normal_module: self.normal_module_mm,
            pressure_angle: Sides::both(self.alpha_n_deg.to_radians()),
            helix_angle: self.beta_deg.to_radians(),
            profile_shift: self.profile_shift,
            cone_angle: 0.0,
        })?;
        // The file evaluates the whole usable flank; its root circle lies below by something that no listed number sees.
        let root_diameter = self.start_diameter_mm - 0.5 * self.normal_module_mm;
        let half = self.face_width_mm / 2.0;
        GrindingSetup::new(SetupInput {
            gear,
            blank: Blank {
                face_width: self.face_width_mm,
                tip_diameter: self.end_diameter_mm,
                root_diameter,
                tip_form_diameter: self.end_diameter_mm,
                form_diameter: self.start_diameter_mm,
                rack_addendum: None,
            },
            evaluation: [self.start_diameter_mm, self.end_diameter_mm, -half, half],
            worm: WormChoice {
                threads: self.worm_threads,
                hand: self.worm_hand,
                pitch_diameter: None,
                tip_diameter: Some(self.worm_tip_diameter_mm),
                pressure_angle: None,
                profile_shift: 0.0,
                cone_angle: 0.0,
            },
            worm_width: self.worm_width_mm,
            dresser: Some(DresserChoice {
                tip_diameter: self.dresser_tip_diameter_mm,
                pitch_diameter: self.dresser_pitch_diameter_mm,
                designed_for: None,
            }),
            tool_direction: None,
            root_clearance: None,
            gear_root: None,
        })
    }

    /// Compares what the file derives from its own input.
    pub fn derived(&self, case: &str, setup: &GrindingSetup, relative: f64, ledger: &mut Ledger) {
        let chain = &setup.pair.chain;
        let Ok(dresser) = setup.dresser() else { return };
        let dressing = &dresser.flanks.left.chain;
        let values = [
            ("worm_pitch_radius_mm", self.worm_pitch_radius_mm, setup.worm_pitch_radius),
            ("worm_root_radius_mm", self.worm_root_radius_mm, setup.worm_root_radius),
            ("d_mm", self.d_mm, chain.centre_distance),
            ("gamma_deg", self.gamma_deg, chain.crossed_axes_angle.to_degrees()),
            ("d_A0_mm", self.d_a0_mm, dressing.centre_distance),
            ("gamma_A0_deg", self.gamma_a0_deg, dressing.crossing_angle.to_degrees()),
        ];
        for (key, listed, found) in values {
            if let Some(listed) = listed {
                ledger.number(case, &format!("input.{key}"), listed, found, relative * listed.abs());
            }
        }
    }

    /// Targets of the flanks that have a list of modifications.
    pub fn targets(&self, setup: &GrindingSetup) -> Result<Sides<Option<FlankTarget>>, GeneratingError> {
        Sides::try_from_fn(|flank| {
            let list = match flank {
                Flank::Left => &self.modifications.left,
                Flank::Right => &self.modifications.right,
            };
            let Some(list) = list else { return Ok(None) };
            let specs = list.iter().map(ModificationSpec::from_json).collect::<Result<Vec<_>, _>>()?;
            let wanted = Modification::for_flank(&specs, flank, &setup.fields[flank], &NoFiles)?;
            FlankTarget::new(wanted).map(Some)
        })
    }

    /// mm; that of a job which names none.
    pub fn tolerance(&self) -> f64 {
        self.tolerance_um.unwrap_or(1.0) * UM
    }

    /// Limits of the correcting axes.
    pub fn limits(&self) -> DressingLimits {
        self.limits.map_or_else(DressingLimits::default, |l| DressingLimits {
            correction: [l.phi_deg.to_radians(), l.gamma_deg.to_radians(), l.d_mm, l.v_y_mm],
            delta_d: l.delta_d_mm,
        })
    }

    /// Places allowed for the profile crowning; the dresser of a file is made for its target.
    pub fn places(&self) -> Vec<ProfilePlace> {
        match self.profile_crowning_by {
            Place::Auto | Place::Dresser => vec![ProfilePlace::Dresser],
            Place::Diagonal => vec![ProfilePlace::Diagonal],
            Place::Correction => vec![ProfilePlace::Correction],
        }
    }
}
