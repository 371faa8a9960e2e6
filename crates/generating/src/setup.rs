//! The bodies of a grinding job by the one table of defaults (`docs/mathematics/involute-gears.md#the-worm-as-a-helical-gear`): gear, worm,
//! dresser and how they stand.

use super::{FlankLines, GearRootChoice, GeneratingError, StrokeLayout};
use contact::Pair;
use dressing::{ContactLine, DresserTool, GeometricRange, WormSeat};
use foundation::geometry::{
    Blank, Flank, Gear, GeometryError, Sides, WormChoice, WormForGear, worm_for_gear,
};
use foundation::kinematics::{DressingChain, MotionLaw};
use foundation::modification::{EvaluationField, Modification};

/// What a job says of the bodies. mm, rad.
#[derive(Clone, Debug, PartialEq)]
pub struct SetupInput {
    /// The workpiece.
    pub gear: Gear,
    /// Its diameters and face width.
    pub blank: Blank,
    /// Evaluation range: start diameter, end diameter, z from, z to.
    pub evaluation: [f64; 4],
    /// The worm.
    pub worm: WormChoice,
    /// Usable width of the worm, if limited.
    pub worm_width: Option<f64>,
    /// The dresser; `None` for a tool that is not dressed.
    pub dresser: Option<DresserChoice>,
    /// tan(rho_1) of the tool's lines; default those that the dresser leaves, or the generatrix of a tool that is not dressed.
    pub tool_direction: Option<Sides<f64>>,
    /// Clearance between gear tip and worm root; default 0.25 m_n0.
    pub root_clearance: Option<f64>,
    /// What is wanted of the gear's root where the worm's tip grinds it: the tip radius then follows from the root diameter.
    pub gear_root: Option<GearRootChoice>,
}

/// What is chosen of a dresser. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DresserChoice {
    /// Tip diameter.
    pub tip_diameter: f64,
    /// Pitch diameter, if given.
    pub pitch_diameter: Option<f64>,
    /// The worm it was designed for, if that is another one than it dresses.
    pub designed_for: Option<WormChoice>,
}

/// Where the flank of the tool comes from.
#[derive(Clone, Debug)]
pub enum Tool {
    /// A dresser profiles it; here the plain one, conjugate of the unmodified worm.
    Dressed(Box<DresserTool>),
    /// It is made for the target, free of any dresser (plated worm, shaving or honing tool, ground hob).
    Made,
    /// It exists with this modification over (w_1, z_1), transverse, mm.
    Given(Box<Sides<Modification>>),
}

/// Who carries the u^2 part of the profile (`docs/mathematics/planning.md#who-carries-what`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProfilePlace {
    /// The dresser's profile.
    Dresser,
    /// A constant part of the dressing correction.
    Correction,
    /// The diagonal: F_K and F_L.
    Diagonal,
}

impl ProfilePlace {
    /// As job files spell it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Dresser => "dresser",
            Self::Correction => "correction",
            Self::Diagonal => "diagonal",
        }
    }
}

/// Ranges of the correcting axes (`docs/mathematics/planning.md#choice-of-the-ratio`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DressingLimits {
    /// |d_phi_S|, |d_gamma| (rad), |d_d|, |d_v_yA| (mm).
    pub correction: [f64; 4],
    /// |Delta_d|, mm.
    pub delta_d: f64,
}

impl Default for DressingLimits {
    fn default() -> Self {
        Self { correction: [10f64.to_radians(), 3f64.to_radians(), 5.0, 10.0], delta_d: 1.0 }
    }
}

/// All bodies of a job, in place.
#[derive(Clone, Debug)]
pub struct GrindingSetup {
    /// What it was made from.
    pub input: SetupInput,
    /// Worm and workpiece without backlash.
    pub pair: Pair,
    /// Pitch radius of the worm, mm.
    pub worm_pitch_radius: f64,
    /// Tip radius of the worm, mm; of a conical one at z = 0.
    pub worm_tip_radius: f64,
    /// Largest tip radius over the width of the worm, mm.
    pub largest_tip_radius: f64,
    /// Root radius of the worm, mm.
    pub worm_root_radius: f64,
    /// Evaluation field per flank.
    pub fields: Sides<EvaluationField>,
    /// Where the tool's flank comes from.
    pub tool: Tool,
    /// The strokes in which the worm is dressed; `None`: in one, by the dresser of `tool`.
    pub strokes: Option<Box<StrokeLayout>>,
    /// What the flanks of a dressed worm are to be, over (w_1, z_1), transverse, mm; `None`: whatever the target of the gear asks for.
    pub wanted_worm: Option<Box<Sides<Modification>>>,
    /// Direction of the tool's lines, tan(rho_1).
    pub tool_direction: Sides<f64>,
    /// Numbers per flank.
    pub lines: Sides<FlankLines>,
    /// The worm's tip reaches beyond the gear's root circle by this much, mm (<= 0: it does not).
    pub root_cut: f64,
    /// The worm's tip reaches beyond the point that grinds the gear's base circle by this much in roll, mm (> 0: the gear is
    /// undercut; <= 0: it is not).
    pub undercut: f64,
    /// The worm's tip fails to reach the largest roll needed by this much in radius, mm (<= 0: it reaches).
    pub tip_short: f64,
}

impl GrindingSetup {
    /// Puts all bodies in place.
    ///
    /// # Errors
    /// Impossible bodies, bodies that do not mesh, a worm without conjugate dresser.
    pub fn new(input: SetupInput) -> Result<Self, GeneratingError> {
        input.blank.check(&input.gear)?;
        let Placed { mut made, pair, engaged, root_by_gear, fields, ranges } = Placed::new(
            &input.gear,
            &input.blank,
            input.evaluation,
            &input.worm,
            input.worm_width,
            input.root_clearance,
        )?;
        if input.gear_root.is_some() {
            made.tip_radius = engaged - 0.5 * input.blank.root_diameter;
        }
        let r_w1 = made.worm.pitch_radius();
        let (tool, root_radius) = match &input.dresser {
            None => (Tool::Made, root_by_gear),
            Some(_) if !made.worm.is_cylindrical() && input.worm_width.is_none() => {
                return Err(GeneratingError::ConicalWormWithoutWidth {
                    cone_angle_deg: made.worm.data().cone_angle.to_degrees(),
                });
            }
            Some(choice) => {
                let (root, chains) = dressing_place(choice, &made.worm, root_by_gear);
                let tool = match &choice.designed_for {
                    None => DresserTool::conjugate(&made.worm, chains, ranges)?,
                    Some(designed) => {
                        let seat = WormSeat { worm: made.worm, chains, ranges, tip_radius: made.tip_radius };
                        designed_dresser(&input, choice, designed)?.settled_on(&seat)?
                    }
                };
                (Tool::Dressed(Box::new(tool)), root)
            }
        };
        check_depth(&made.worm, root_radius)?;
        let tool_direction = match (&input.tool_direction, &tool) {
            (Some(given), _) => *given,
            (None, Tool::Dressed(dresser)) => {
                Sides::try_from_fn(|flank| ContactLine::fit(dresser, flank, [0.0; 4]).map(|l| l.rho.tan()))?
            }
            (None, _) => Sides::from_fn(|flank| {
                let f = made.worm.flank(flank);
                -f.s() / f.base_helix_angle.tan()
            }),
        };
        let lines = Sides::from_fn(|flank| {
            FlankLines::new(&pair.flanks[flank], &fields[flank], tool_direction[flank])
        });
        let reach = Flank::BOTH
            .map(|flank| ranges[flank].w_na.hypot(made.worm.flank(flank).base_radius))
            .into_iter()
            .fold(0.0, f64::max);
        let undercut = Flank::BOTH
            .map(|flank| {
                let f = &pair.flanks[flank];
                f.worm.length_of_roll(made.tip_radius).unwrap_or(0.0) - f.worm_roll(0.0, 0.0, 0.0)
            })
            .into_iter()
            .fold(f64::NEG_INFINITY, f64::max);
        let cone = made.worm.data().cone_angle.tan().abs();
        let largest_tip_radius = made.tip_radius + 0.5 * cone * input.worm_width.unwrap_or(0.0);
        Ok(Self {
            undercut,
            largest_tip_radius,
            pair,
            worm_pitch_radius: r_w1,
            worm_tip_radius: made.tip_radius,
            worm_root_radius: root_radius,
            fields,
            tool,
            strokes: None,
            wanted_worm: None,
            tool_direction,
            lines,
            root_cut: made.tip_radius - (engaged - input.blank.root_diameter / 2.0),
            tip_short: reach - largest_tip_radius,
            input,
        })
    }

    /// Diameter in the section z = 0 from which the worm's tip generates the involute of a flank, mm; `None` for a tip inside the base
    /// circle of the worm's own involute.
    pub fn generated_from(&self, flank: Flank) -> Option<f64> {
        let pair = &self.pair.flanks[flank];
        let at_tip = pair.worm.length_of_roll(self.worm_tip_radius).ok()?;
        Some(2.0 * pair.work.radius(pair.work_roll(at_tip, 0.0, 0.0).max(0.0)))
    }

    /// The same bodies with other lines on the tool, tan(rho_1).
    pub fn with_tool_direction(mut self, direction: Sides<f64>) -> Self {
        self.input.tool_direction = Some(direction);
        self.tool_direction = direction;
        self.lines = Sides::from_fn(|flank| {
            FlankLines::new(&self.pair.flanks[flank], &self.fields[flank], direction[flank])
        });
        self
    }

    /// The plain dresser.
    ///
    /// # Errors
    /// [`GeneratingError::NotDressed`] for another tool.
    pub fn dresser(&self) -> Result<&DresserTool, GeneratingError> {
        match &self.tool {
            Tool::Dressed(dresser) => Ok(dresser),
            Tool::Made | Tool::Given(_) => Err(GeneratingError::NotDressed),
        }
    }

    /// Normal module of the worm, mm.
    pub fn worm_module(&self) -> f64 {
        self.pair.worm.data().normal_module
    }

    /// Run-in, and run-out, of the worm beside what touches the gear, mm (`docs/mathematics/planning.md#choice-of-the-ratio`).
    pub fn run_in(&self) -> f64 {
        1.5 * self.worm_module() + 3.0
    }
}

/// Worm and gear in place, before any dresser.
pub(super) struct Placed {
    pub made: WormForGear,
    pub pair: Pair,
    /// Centre distance as the pitch planes engage, mm.
    pub engaged: f64,
    /// Root radius of the worm that leaves the clearance to the gear's tip, mm.
    pub root_by_gear: f64,
    pub fields: Sides<EvaluationField>,
    /// Lengths of roll on the worm that generate the gear's form circles.
    pub ranges: Sides<GeometricRange>,
}

impl Placed {
    pub fn new(
        gear: &Gear,
        blank: &Blank,
        evaluation: [f64; 4],
        worm: &WormChoice,
        worm_width: Option<f64>,
        root_clearance: Option<f64>,
    ) -> Result<Self, GeneratingError> {
        let made = worm_for_gear(gear, worm)?;
        let pair = Pair::without_backlash(made.worm, *gear, made.crossed_axes_angle)?;
        let d = pair.chain.centre_distance;
        let clearance = root_clearance.unwrap_or(0.25 * made.rack.normal_module);
        // On cones d is only a measure (`docs/mathematics/generating-contact.md`); the pitch planes tell how deep the bodies engage.
        let (rack_1, rack_2) = pair.rack_radii();
        let engaged = if pair.worm.is_cylindrical() && pair.work.is_cylindrical() {
            d
        } else {
            rack_1 + rack_2 + pair.backlash_free_gap(rack_1, rack_2)
        };
        let root_by_gear = engaged - blank.tip_diameter / 2.0 - clearance;
        let [start, end, z_from, z_to] = evaluation;
        let fields = Sides::try_from_fn(|flank| -> Result<_, GeneratingError> {
            let f = gear.flank(flank);
            let roll = [f.length_of_roll(start / 2.0)?, f.length_of_roll(end / 2.0)?];
            Ok(EvaluationField::new(roll, [z_from, z_to], f.base_radius, f.base_helix_angle)?)
        })?;
        let forms = blank.limits(gear)?;
        let ranges = Sides::try_from_fn(|flank| {
            let f = &pair.flanks[flank];
            let (a, b) = (forms[flank].w_a, forms[flank].w_f);
            let (mut w_nf, mut w_na) = (f.worm_roll(a, 0.0, 0.0), f.worm_roll(b, 0.0, 0.0));
            // The rack height of a given roll changes along a cone: over the face width of the gear, over the width of the worm.
            let lines = FlankLines::new(f, &fields[flank], 0.0);
            let shifts = match worm_width {
                _ if pair.worm.is_cylindrical() && pair.work.is_cylindrical() => Vec::new(),
                Some(width) if !pair.worm.is_cylindrical() => vec![-0.5 * width, 0.5 * width],
                _ => vec![0.0],
            };
            for shift in shifts {
                let [low, high] = lines.worm_rolls(&MotionLaw::polynomial(0.0, vec![shift]));
                (w_nf, w_na) = (w_nf.min(low), w_na.max(high));
            }
            if w_nf > 0.0 {
                Ok(GeometricRange { w_nf, w_na })
            } else {
                Err(contact::ContactError::ContactBelowBase { w_2: a, w_1: w_nf })
            }
        })?;
        Ok(Self { made, pair, engaged, root_by_gear, fields, ranges })
    }
}

/// The dresser on the worm that it was designed for.
fn designed_dresser(
    input: &SetupInput,
    choice: &DresserChoice,
    designed: &WormChoice,
) -> Result<DresserTool, GeneratingError> {
    let SetupInput { gear, blank, evaluation, worm_width, root_clearance, .. } = input;
    let there = Placed::new(gear, blank, *evaluation, designed, *worm_width, *root_clearance)?;
    let (root, chains) = dressing_place(choice, &there.made.worm, there.root_by_gear);
    check_depth(&there.made.worm, root)?;
    Ok(DresserTool::conjugate(&there.made.worm, chains, there.ranges)?)
}

/// A tool reaches about 1.25 modules below its pitch cylinder; far from that it is another one.
pub(super) fn check_depth(worm: &Gear, root_radius: f64) -> Result<(), GeometryError> {
    let depth = (worm.pitch_radius() - root_radius) / worm.data().normal_module;
    if (0.5..=3.0).contains(&depth) {
        return Ok(());
    }
    Err(GeometryError::InvalidGeometry {
        what: "depth of the tool's space below its pitch cylinder, in normal modules".into(),
        value: depth,
        allowed: "0.5 to 3; it follows from dresser.pitch_diameter, else from gear and root clearance".into(),
    })
}

/// Root radius of the worm and nominal dressing chain of each flank (`docs/mathematics/involute-gears.md#the-worm-as-a-helical-gear`): the
/// flanks of a conical worm are helicoids of different lead (`docs/mathematics/dressing.md#symbols`).
pub(super) fn dressing_place(
    choice: &DresserChoice,
    worm: &Gear,
    root_by_gear: f64,
) -> (f64, Sides<DressingChain>) {
    let r_w1 = worm.pitch_radius();
    let r_aa = choice.tip_diameter / 2.0;
    let (root_radius, d_a0) = match choice.pitch_diameter {
        Some(pitch) => {
            let d_a0 = r_w1 + pitch / 2.0;
            (d_a0 - r_aa, d_a0)
        }
        None => (root_by_gear, root_by_gear + r_aa),
    };
    let chains = Sides::from_fn(|flank| {
        let p = worm.screw_parameter(flank);
        DressingChain {
            worm_angle: -std::f64::consts::FRAC_PI_2,
            crossing_angle: -(p / r_w1).atan(),
            centre_distance: d_a0,
            offset: 0.0,
            screw_parameter: p,
        }
    });
    (root_radius, chains)
}
