//! The bodies of a dressing case: gear, worm that grinds it, dresser with the nominal kinematics of the reference files.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use contact::Pair;
use dressing::{DresserTool, DressingError, GeometricRange, WormSeat};
use foundation::geometry::{Flank, Gear, GearData, Sides, ThicknessMeasure, WormChoice, worm_for_gear};
use foundation::kinematics::DressingChain;
use generating::GeneratingError;
use serde_json::Value;
use std::f64::consts::{FRAC_PI_2, PI};

/// Half length of the worm's head over which the files design the head profile, mm.
const HEAD_HALF_WIDTH: f64 = 1.5;
/// Share of the used range by which the files' profiles reach on at each end. Their design range is 0.6; paths without solution
/// were followed on the extrapolated series until its rounding errors grew up, a tenth of the used range further. Within the
/// design range nothing depends on it.
const REACH: f64 = 0.7;
/// Clearance at tip and root in the files, in modules of the gear.
const CLEARANCE: f64 = 0.25;

/// Bodies and what the files list of them.
pub(crate) struct Bodies {
    pub gear: Gear,
    pub worm: Gear,
    /// Dresser with head part.
    pub tool: DresserTool,
    pub range: GeometricRange,
    pub reference_radius: f64,
    pub tip_radius: f64,
    space_width: f64,
    dedendum: f64,
    addendum: f64,
    numbers: Numbers,
}

#[derive(Clone, Copy)]
struct Numbers {
    teeth: [i32; 2],
    module: f64,
    angles: [f64; 3],
    form: [f64; 2],
    worm_diameter: f64,
    dresser_diameter: f64,
    hand: f64,
}

/// What differs on another worm for the same gear. mm, rad.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OtherWorm {
    pub threads: i32,
    pub diameter: f64,
    pub angle: f64,
}

impl Bodies {
    /// `None` if a number is missing (reported); an error if the bodies are impossible.
    pub fn read(input: &mut Expected<'_>, ledger: &mut Ledger) -> Option<Result<Self, GeneratingError>> {
        // What other blocks list again beside their results, and inputs of blocks to come.
        input.informative(&[
            "name",
            "DK_list",
            "c_list_um",
            "c_small_um",
            "topo_lin_per_mm",
            "topo_quad_per_mm2",
            "deviation",
            "other_d_S",
            "smaller_d_S",
        ]);
        let keys = ["m_n", "alpha_n_deg", "beta_deg", "alpha_nS_deg", "d_Na", "d_Nf", "d_S", "d_aA"];
        let numbers = keys.map(|key| input.given(key, ledger));
        let teeth = ["z_V", "z_S"].map(|key| input.given(key, ledger));
        let hand = input.given_optional("hand", ledger).unwrap_or(1.0);
        let whole = |x: f64| (x.fract() == 0.0 && x.abs() < 1e6).then_some(x as i32);
        let [Some(z_v), Some(z_s)] = teeth.map(|z| z.and_then(whole)) else { return None };
        let [Some(module), Some(a), Some(b), Some(c), Some(d_na), Some(d_nf), Some(d_s), Some(d_aa)] =
            numbers
        else {
            return None;
        };
        let numbers = Numbers {
            teeth: [z_v, z_s],
            module,
            angles: [a, b, c].map(f64::to_radians),
            form: [d_na, d_nf],
            worm_diameter: d_s,
            dresser_diameter: d_aa,
            hand,
        };
        Some(Self::new(&numbers))
    }

    fn new(n: &Numbers) -> Result<Self, GeneratingError> {
        let [alpha, beta, worm_alpha] = n.angles;
        let gear = Gear::new(GearData {
            teeth: n.teeth[0],
            normal_module: n.module,
            pressure_angle: Sides::both(alpha),
            helix_angle: beta,
            profile_shift: 0.0,
            cone_angle: 0.0,
        })?;
        let rack = gear.rack_with_pressure_angle(Flank::Left, worm_alpha)?;
        let r_w = rack.pitch_radius;
        // The worm's space holds the gear's tooth on their common rack.
        let space_width = gear.transverse_thickness(r_w, 0.0)? * rack.helix_angle.cos();
        let [dedendum, addendum] =
            [n.form[0] / 2.0 - r_w, r_w - n.form[1] / 2.0].map(|h| h + CLEARANCE * n.module);
        let mut choice = WormChoice {
            threads: n.teeth[1],
            hand: n.hand,
            pitch_diameter: Some(n.worm_diameter),
            tip_diameter: Some(n.worm_diameter + 2.0 * addendum),
            pressure_angle: Some(worm_alpha),
            profile_shift: 0.0,
            cone_angle: 0.0,
        };
        let unshifted = worm_for_gear(&gear, &choice)?;
        let thickness = PI * rack.normal_module - space_width;
        choice.profile_shift =
            ThicknessMeasure::NormalThickness(thickness).profile_shift(*unshifted.worm.data())?;
        let made = worm_for_gear(&gear, &choice)?;
        let pair = Pair::without_backlash(made.worm, gear, made.crossed_axes_angle)?;
        let f = gear.flank(Flank::Left);
        let [w_nf, w_na] = [
            pair.flanks.left.worm_roll(f.length_of_roll(n.form[0] / 2.0)?, 0.0, 0.0),
            pair.flanks.left.worm_roll(f.length_of_roll(n.form[1] / 2.0)?, 0.0, 0.0),
        ];
        let range = GeometricRange { w_nf, w_na };
        let reference_radius = n.worm_diameter / 2.0;
        let screw_parameter = made.worm.screw_parameter(Flank::Left);
        // Groove centre on +x, disc along the thread, disc tip on the root.
        let chain = DressingChain {
            worm_angle: -FRAC_PI_2,
            crossing_angle: -(screw_parameter / reference_radius).atan(),
            centre_distance: n.dresser_diameter / 2.0 + reference_radius - dedendum,
            offset: 0.0,
            screw_parameter,
        };
        let tip_radius = n.dresser_diameter / 2.0;
        let tool = DresserTool::conjugate_beyond(&made.worm, Sides::both(chain), Sides::both(range), REACH)?
            .with_head(reference_radius + addendum, HEAD_HALF_WIDTH)?;
        Ok(Self {
            gear,
            worm: made.worm,
            tool,
            range,
            reference_radius,
            tip_radius,
            space_width,
            dedendum,
            addendum,
            numbers: *n,
        })
    }

    /// The worm of the case.
    pub fn own_worm(&self) -> OtherWorm {
        let Numbers { teeth: [_, threads], angles: [.., angle], worm_diameter: diameter, .. } = self.numbers;
        OtherWorm { threads, diameter, angle }
    }

    /// The bodies with another worm, and a dresser of this diameter made for it.
    pub fn with(&self, worm: OtherWorm, dresser_diameter: f64) -> Result<Self, GeneratingError> {
        let [alpha, beta, _] = self.numbers.angles;
        Self::new(&Numbers {
            teeth: [self.numbers.teeth[0], worm.threads],
            angles: [alpha, beta, worm.angle],
            worm_diameter: worm.diameter,
            dresser_diameter,
            ..self.numbers
        })
    }

    /// Another worm under the dresser of the case.
    pub fn seat(&self, worm: OtherWorm, dresser_diameter: f64) -> Result<WormSeat, DressingError> {
        let other = self.with(worm, dresser_diameter).map_err(|e| match e {
            GeneratingError::Dressing(e) => e,
            GeneratingError::Geometry(e) => e.into(),
            _ => DressingError::InvalidNumber {
                field: "d_S",
                value: worm.diameter,
                allowed: "a worm that meshes with the gear",
            },
        })?;
        let chains = other.tool.flanks.map(|_, f| f.chain);
        Ok(WormSeat {
            worm: other.worm,
            chains,
            ranges: Sides::both(other.range),
            tip_radius: other.reference_radius + other.addendum,
        })
    }

    /// Block `worm`.
    pub fn worm_block(&self, case: &mut Expected<'_>, ledger: &mut Ledger) {
        let Some(mut block) = case.object("worm", ledger) else { return };
        let tolerances = Tolerances::table(block.take("tolerance").unwrap_or(&Value::Null));
        let f = self.worm.flank(Flank::Left);
        let lengths = [
            ("m_nS_mm", self.worm.data().normal_module),
            ("lead_per_rad_mm", self.tool.flanks.left.chain.screw_parameter),
            ("e_n_mm", self.space_width),
            ("h_f_mm", self.dedendum),
            ("h_a_mm", self.addendum),
            ("r_f_mm", self.reference_radius - self.dedendum),
            ("r_b_mm", f.base_radius),
            ("w_NfS_mm", self.range.w_nf),
            ("w_NaS_mm", self.range.w_na),
        ];
        let angles = [
            ("beta_deg", self.worm.data().helix_angle),
            ("beta_b_deg", f.base_helix_angle),
            ("gear_beta_b_deg", self.gear.flank(Flank::Left).base_helix_angle),
        ];
        block.numbers(&lengths, tolerances.get("mm"), ledger);
        block.numbers(&angles.map(|(key, x)| (key, x.to_degrees())), tolerances.get("deg"), ledger);
        block.number("eta_b_rad", f.base_space_half_angle, tolerances.get("rad"), ledger);
        block.finish(ledger);
    }

    /// Block `nominal_kinematics`, to the tolerances of the worm.
    pub fn kinematics_block(&self, case: &mut Expected<'_>, ledger: &mut Ledger) {
        let table = case.peek("worm").map_or(&Value::Null, |worm| &worm["tolerance"]);
        let Some(mut block) = case.object("nominal_kinematics", ledger) else { return };
        let tolerances = Tolerances::table(block.take("tolerance").unwrap_or(table));
        let chain = &self.tool.flanks.left.chain;
        let lengths = [("d_mm", chain.centre_distance), ("v_yA_mm", chain.offset)];
        let angles = [("phi_S_deg", chain.worm_angle), ("gamma_A_deg", chain.crossing_angle)];
        block.numbers(&lengths, tolerances.get("mm"), ledger);
        block.numbers(&angles.map(|(key, x)| (key, x.to_degrees())), tolerances.get("deg"), ledger);
        block.finish(ledger);
    }
}
