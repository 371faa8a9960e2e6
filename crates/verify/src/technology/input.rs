//! The input of a case: tables of a job with their units, and what the library makes of them.

use foundation::geometry::{Flank, Gear, GearData, Sides, WormChoice, worm_for_gear};
use foundation::kinematics::GeneratingChain;
use grinding_technology::{
    Axes, Axis, Bodies, Cycle, Direction, DressingTechnology, Ground, HobMarks, OptimumTask, PartTimes,
    Rates, Rotation, RunOut, Shift, Stock, StockField, StockTerm, Stroke, TechnologyError, WormLife,
    ZoneLimits,
};
use serde::Deserialize;

const UM: f64 = 1e-3;
const RPM: f64 = 1.0 / 60.0;

/// One value, or one for each flank.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(untagged)]
enum Both {
    One(f64),
    Each { left: f64, right: f64 },
}

impl Both {
    fn sides(self, unit: f64) -> Sides<f64> {
        match self {
            Self::One(value) => Sides::both(unit * value),
            Self::Each { left, right } => Sides { left: unit * left, right: unit * right },
        }
    }
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct GearInput {
    teeth: i32,
    normal_module: f64,
    normal_pressure_angle_deg: Both,
    helix_angle_deg: f64,
    profile_shift: f64,
    face_width: f64,
    tip_diameter: f64,
    form_diameter: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct WormInput {
    threads: i32,
    hand: Hand,
    pitch_diameter: f64,
    tip_diameter: f64,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Hand {
    Left,
    Right,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct StockInput {
    allowance_um: Both,
    #[serde(default)]
    profile: Vec<ProfilePlace>,
    #[serde(default)]
    terms: Vec<TermInput>,
    pitch_um: Option<PitchInput>,
    run_out: Option<RunOutInput>,
    hob: Option<HobInput>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct ProfilePlace {
    diameter: f64,
    um: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct TermInput {
    i: u32,
    j: u32,
    um: f64,
    #[serde(default)]
    flank: FlankInput,
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum FlankInput {
    Left,
    Right,
    #[default]
    Both,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct PitchInput {
    left: Vec<f64>,
    right: Vec<f64>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct RunOutInput {
    eccentricity_um: f64,
    angle_deg: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct HobInput {
    feed: f64,
    height_um: f64,
    #[serde(default)]
    origin: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct StrokeInput {
    left_um: Both,
    #[serde(default = "usual_feed")]
    feed_per_revolution: f64,
    #[serde(default = "usual_speed")]
    cutting_speed_m_per_s: f64,
    #[serde(default)]
    direction: DirectionInput,
    #[serde(default)]
    shift: ShiftInput,
    #[serde(default = "usual_overrun")]
    overrun: f64,
    #[serde(default)]
    dwell_s: f64,
    #[serde(default = "only_zone")]
    zone: String,
}

fn usual_feed() -> f64 {
    0.3
}

fn usual_speed() -> f64 {
    50.0
}

fn usual_overrun() -> f64 {
    1.0
}

fn only_zone() -> String {
    "all".into()
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum DirectionInput {
    #[default]
    Up,
    Down,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct ShiftInput {
    ratio: f64,
    origin: f64,
    step_per_part: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(non_snake_case, reason = "axes are named by capitals in the file")]
struct AxesInput {
    X: [f64; 3],
    Z: [f64; 3],
    V: [f64; 3],
    B: [f64; 3],
    C: [f64; 3],
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(non_snake_case, reason = "V_w is written with a capital in the file")]
struct LimitsInput {
    zone_width: f64,
    zone_gap: f64,
    allowed_Vw_roughing: f64,
    allowed_Vw_finishing: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct DressingInput {
    worm_speed_rpm: f64,
    dresser_speed_rpm: f64,
    dresser_tip_diameter: f64,
    dresser_pitch_diameter: f64,
    direction: RotationInput,
    depth_um: f64,
    passes: usize,
    flanks: FlanksInput,
    worm_width: f64,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
enum RotationInput {
    Same,
    Opposite,
}

#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase")]
enum FlanksInput {
    One,
    Both,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct TimesInput {
    load_s: f64,
    index_s: f64,
    other_s: f64,
    dressing_aux_s: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(non_snake_case, reason = "V_w is written with a capital in the file")]
struct LifeInput {
    first_tip_diameter: f64,
    last_tip_diameter: f64,
    radial_per_dressing: f64,
    cutting_speed_m_per_s: f64,
    largest_worm_speed_rpm: f64,
    largest_work_speed_rpm: f64,
    allowed_Vw: f64,
    zone_width: f64,
    section_per_part: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct CostInput {
    machine_per_hour: f64,
    worm_price: f64,
    worm_change_min: f64,
    dresser_price: f64,
    dressings_per_dresser: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(non_snake_case, reason = "Q_w, V_w and K are written with capitals in the file")]
struct OptimiseInput {
    stock_um: f64,
    cutting_speed_m_per_s: f64,
    least_feed: f64,
    largest_feed: f64,
    feed_mark_um: f64,
    Qw_roughing: f64,
    Qw_finishing: f64,
    least_finishing_um: f64,
    most_finishing_um: f64,
    most_roughing_strokes: usize,
    K_finishing: f64,
    overrun: f64,
    clearance: f64,
    auxiliary_s: f64,
    between_strokes_s: f64,
    dressing_s: f64,
    zone_width: f64,
    zone_gap: f64,
    allowed_Vw_roughing: f64,
    allowed_Vw_finishing: f64,
}

/// Everything a case gives.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(non_snake_case, reason = "V_w is written with a capital in the file")]
pub(super) struct Input {
    gear: GearInput,
    worm: WormInput,
    stock: StockInput,
    strokes: Vec<StrokeInput>,
    /// Spaces listed one by one.
    pub spaces: Vec<usize>,
    /// Parts of the map of the worm's load.
    pub parts: usize,
    pub allowed_Vw_map: f64,
    axes: AxesInput,
    pub clearance: f64,
    limits: LimitsInput,
    dressing: DressingInput,
    times: TimesInput,
    life: LifeInput,
    cost: CostInput,
    optimise: Option<OptimiseInput>,
}

impl Input {
    pub fn stock_is_constant(&self) -> bool {
        let StockInput { profile, terms, pitch_um, run_out, hob, .. } = &self.stock;
        profile.is_empty() && terms.is_empty() && pitch_um.is_none() && run_out.is_none() && hob.is_none()
    }

    fn bodies(&self) -> Result<Bodies, TechnologyError> {
        let input = &self.gear;
        let gear = Gear::new(GearData {
            teeth: input.teeth,
            normal_module: input.normal_module,
            pressure_angle: input.normal_pressure_angle_deg.sides(1.0).map(|_, angle| angle.to_radians()),
            helix_angle: input.helix_angle_deg.to_radians(),
            profile_shift: input.profile_shift,
            cone_angle: 0.0,
        })?;
        let choice = WormChoice {
            threads: self.worm.threads,
            hand: match self.worm.hand {
                Hand::Left => -1.0,
                Hand::Right => 1.0,
            },
            pitch_diameter: Some(self.worm.pitch_diameter),
            tip_diameter: Some(self.worm.tip_diameter),
            pressure_angle: None,
            profile_shift: 0.0,
            cone_angle: 0.0,
        };
        let made = worm_for_gear(&gear, &choice)?;
        let gap = input.profile_shift * input.normal_module;
        let chain = GeneratingChain {
            centre_distance: made.worm.pitch_radius() + gear.pitch_radius() + gap,
            crossed_axes_angle: made.crossed_axes_angle,
            worm_cone: 0.0,
            work_cone: 0.0,
            worm_pivot: 0.0,
            work_pivot: 0.0,
        };
        let roll = Sides::try_from_fn(|flank| {
            let at = |diameter: f64| gear.flank(flank).length_of_roll(0.5 * diameter);
            Ok::<_, TechnologyError>([at(input.form_diameter)?, at(input.tip_diameter)?])
        })?;
        let pair = contact::Pair::new(made.worm, gear, chain)?;
        Bodies::new(pair, made.tip_radius, input.face_width, roll)
    }

    fn stock(&self) -> Stock {
        let input = &self.stock;
        let term = |term: &TermInput| StockTerm {
            i: term.i,
            j: term.j,
            amount: UM * term.um,
            flank: match term.flank {
                FlankInput::Left => Some(Flank::Left),
                FlankInput::Right => Some(Flank::Right),
                FlankInput::Both => None,
            },
        };
        let um = |values: &[f64]| values.iter().map(|value| UM * value).collect();
        Stock {
            allowance: input.allowance_um.sides(UM),
            profile: input.profile.iter().map(|place| (place.diameter, UM * place.um)).collect(),
            terms: input.terms.iter().map(term).collect(),
            pitch: input.pitch_um.as_ref().map(|p| Sides { left: um(&p.left), right: um(&p.right) }),
            run_out: input.run_out.as_ref().map(|run_out| RunOut {
                eccentricity: UM * run_out.eccentricity_um,
                angle: run_out.angle_deg.to_radians(),
            }),
            map: Sides::both(None),
            hob: input.hob.as_ref().map(|hob| HobMarks {
                feed: hob.feed,
                height: UM * hob.height_um,
                origin: hob.origin,
            }),
        }
    }

    pub fn cycle(&self) -> Result<Cycle, TechnologyError> {
        let bodies = self.bodies()?;
        let stock = StockField::new(self.stock(), &bodies)?;
        let stroke = |stroke: &StrokeInput| Stroke {
            left: stroke.left_um.sides(UM),
            feed_per_revolution: stroke.feed_per_revolution,
            cutting_speed: stroke.cutting_speed_m_per_s,
            direction: match stroke.direction {
                DirectionInput::Up => Direction::Up,
                DirectionInput::Down => Direction::Down,
            },
            ground: Ground::Both,
            shift: Shift {
                step_per_part: stroke.shift.step_per_part,
                ..Shift::straight(stroke.shift.ratio, stroke.shift.origin)
            },
            overrun: stroke.overrun,
            dwell: stroke.dwell_s,
            zone: stroke.zone.clone(),
        };
        Cycle::new(bodies, stock, self.strokes.iter().map(stroke).collect())
    }

    pub fn axes(&self) -> Axes {
        let axis = |[speed, acceleration, jerk]: [f64; 3]| Axis { speed, acceleration, jerk };
        let AxesInput { X, Z, V, B, C } = self.axes;
        Axes { x: axis(X), z: axis(Z), v: axis(V), b: axis(B), c: axis(C) }
    }

    pub fn zones(&self) -> ZoneLimits {
        ZoneLimits {
            zone_width: self.limits.zone_width,
            zone_gap: self.limits.zone_gap,
            allowed_roughing: self.limits.allowed_Vw_roughing,
            allowed_finishing: self.limits.allowed_Vw_finishing,
        }
    }

    pub fn dressing(&self) -> DressingTechnology {
        let input = &self.dressing;
        DressingTechnology {
            worm_speed: RPM * input.worm_speed_rpm,
            dresser_speed: RPM * input.dresser_speed_rpm,
            dresser_tip_diameter: input.dresser_tip_diameter,
            dresser_pitch_diameter: input.dresser_pitch_diameter,
            rotation: match input.direction {
                RotationInput::Same => Rotation::Same,
                RotationInput::Opposite => Rotation::Opposite,
            },
            depth: UM * input.depth_um,
            passes: input.passes,
            one_flank: input.flanks == FlanksInput::One,
            worm_width: input.worm_width,
        }
    }

    pub fn part_times(&self) -> PartTimes {
        PartTimes {
            load: self.times.load_s,
            index: self.times.index_s,
            other: self.times.other_s,
            dressing_aux: self.times.dressing_aux_s,
        }
    }

    pub fn life(&self) -> WormLife {
        let input = &self.life;
        WormLife {
            first_tip_diameter: input.first_tip_diameter,
            last_tip_diameter: input.last_tip_diameter,
            radial_per_dressing: input.radial_per_dressing,
            cutting_speed: input.cutting_speed_m_per_s,
            largest_worm_speed: RPM * input.largest_worm_speed_rpm,
            largest_work_speed: RPM * input.largest_work_speed_rpm,
            allowed: input.allowed_Vw,
            zone_width: input.zone_width,
            section_per_part: input.section_per_part,
        }
    }

    pub fn rates(&self) -> Rates {
        Rates {
            machine_per_hour: self.cost.machine_per_hour,
            worm_price: self.cost.worm_price,
            worm_change: 60.0 * self.cost.worm_change_min,
            dresser_price: self.cost.dresser_price,
            dressings_per_dresser: self.cost.dressings_per_dresser,
        }
    }

    pub fn optimise(&self) -> Option<OptimumTask> {
        let input = self.optimise.as_ref()?;
        Some(OptimumTask {
            passes: vec![Ground::Both],
            cost: None,
            stock: UM * input.stock_um,
            cutting_speed: input.cutting_speed_m_per_s,
            least_feed: input.least_feed,
            largest_feed: input.largest_feed,
            feed_mark: UM * input.feed_mark_um,
            rate_roughing: input.Qw_roughing,
            rate_finishing: input.Qw_finishing,
            least_finishing: UM * input.least_finishing_um,
            most_finishing: UM * input.most_finishing_um,
            most_roughing_strokes: input.most_roughing_strokes,
            ratio_roughing: 0.0,
            ratio_finishing: input.K_finishing,
            overrun: input.overrun,
            clearance: input.clearance,
            auxiliary: input.auxiliary_s,
            between_strokes: input.between_strokes_s,
            dressing: input.dressing_s,
            zones: ZoneLimits {
                zone_width: input.zone_width,
                zone_gap: input.zone_gap,
                allowed_roughing: input.allowed_Vw_roughing,
                allowed_finishing: input.allowed_Vw_finishing,
            },
        })
    }
}
