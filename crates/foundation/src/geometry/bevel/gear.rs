//! A bevel gear from its drawing data: cones, distances and checks of `docs/mathematics/milling.md#flanks-as-patches`.

use super::flank_line::{LineForm, Spiral};
use super::tangent_line::TangentLine;
use super::{CircularLine, FlankLine};
use crate::geometry::GeometryError;
use std::f64::consts::{FRAC_PI_2, PI};

/// Share of the way from the lowest cone to the tip cone at which the active flank begins if nothing else is known
/// (`docs/mathematics/milling.md#flanks-as-patches`).
const FORM_SHARE: f64 = 0.12;

/// Drawing data of a bevel gear whose cones share one apex. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BevelData {
    /// m_et: transverse module at the heel.
    pub outer_transverse_module: f64,
    /// Number of teeth.
    pub teeth: u32,
    /// delta: pitch cone angle, 90 deg for a crown gear.
    pub pitch_angle: f64,
    /// alpha: pressure angle.
    pub pressure_angle: f64,
    /// b: face width along the pitch cone.
    pub face_width: f64,
    /// h_aP: addendum at the heel over the module.
    pub addendum_factor: f64,
    /// h_fP: dedendum at the heel over the module.
    pub dedendum_factor: f64,
    /// The flank line; `None`: straight teeth.
    pub spiral: Option<Spiral>,
    /// theta_form: polar angle at which the active flank begins; `None`: the rule of `docs/mathematics/milling.md#flanks-as-patches`.
    pub form_angle: Option<f64>,
}

/// A checked bevel gear with what follows from its drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct BevelGear {
    data: BevelData,
    outer_distance: f64,
    /// Ends of the teeth, their width and their middle.
    face: [f64; 2],
    width: f64,
    mean_distance: f64,
    base_angle: f64,
    tip_angle: f64,
    root_angle: f64,
    form_angle: f64,
    pitch_roll: f64,
    base_space_half_angle: f64,
    line: FlankLine,
    heights: [f64; 2],
}

/// inv_s(xi) on the sphere of a base cone: by how much the spherical involute has moved round the axis, rad.
fn spherical_involute_function(xi: f64, sin_base: f64) -> f64 {
    // On the tip of a crown gear xi is above 90 deg.
    xi / sin_base - xi.sin().atan2(sin_base * xi.cos())
}

impl BevelData {
    /// Straight teeth with h_aP = 1 and h_fP = 1.25.
    pub fn new(
        outer_transverse_module: f64,
        teeth: u32,
        pitch_angle: f64,
        pressure_angle: f64,
        face_width: f64,
    ) -> Self {
        Self {
            outer_transverse_module,
            teeth,
            pitch_angle,
            pressure_angle,
            face_width,
            addendum_factor: 1.0,
            dedendum_factor: 1.25,
            spiral: None,
            form_angle: None,
        }
    }

    fn check(&self) -> Result<(), GeometryError> {
        let number = |field, value: f64, good: bool, allowed| {
            let good = good && value.is_finite();
            if good { Ok(()) } else { Err(GeometryError::InvalidNumber { field, value, allowed }) }
        };
        let m = self.outer_transverse_module;
        number("outer_transverse_module", m, m > 0.0, "> 0 mm")?;
        number("teeth", f64::from(self.teeth), self.teeth > 0, "at least 1")?;
        let (pitch, pressure) = (self.pitch_angle, self.pressure_angle);
        let up_to_crown = pitch > 0.0 && pitch <= FRAC_PI_2;
        number("pitch_angle_deg", pitch.to_degrees(), up_to_crown, "above 0 and up to 90 deg")?;
        let between = "between 0 and 90 deg, both excluded";
        number("pressure_angle_deg", pressure.to_degrees(), pressure > 0.0 && pressure < FRAC_PI_2, between)?;
        number("face_width", self.face_width, self.face_width > 0.0, "> 0 mm")?;
        number("addendum_factor", self.addendum_factor, self.addendum_factor > 0.0, "> 0")?;
        number("dedendum_factor", self.dedendum_factor, self.dedendum_factor > 0.0, "> 0")?;
        if let Some(spiral) = self.spiral {
            let angle = spiral.mean_angle;
            let good = (0.0..FRAC_PI_2).contains(&angle);
            number("spiral_angle_deg", angle.to_degrees(), good, "0 to below 90 deg, the hand apart")?;
            if let LineForm::Circle { radius } | LineForm::Epicycloid { radius, .. } = spiral.form {
                number("cutter_radius", radius, radius > 0.0, "> 0 mm")?;
            }
            if let LineForm::Epicycloid { groups, .. } = spiral.form {
                number("blade_groups", groups, groups >= 1.0, "at least 1")?;
            }
        }
        if let Some(angle) = self.form_angle {
            let between = "between 0 and 180 deg, both excluded";
            number("form_angle_deg", angle.to_degrees(), angle > 0.0 && angle < PI, between)?;
        }
        Ok(())
    }
}

impl BevelGear {
    /// Cones and base data.
    ///
    /// # Errors
    /// [`GeometryError::InvalidNumber`] and [`GeometryError::InvalidGeometry`] (`E_GEOM_INPUT` of `docs/mathematics/milling.md#limits`),
    /// [`GeometryError::BelowBaseCone`] and [`GeometryError::FlankLineOutOfReach`] (`E_GEOM_BASE`),
    /// [`GeometryError::BevelToothPointed`] (`E_GEOM_POINTED`).
    pub fn new(data: BevelData) -> Result<Self, GeometryError> {
        Self::over(data, None)
    }

    /// One of two halves of opposite hand: teeth between two distances of the face of `data`. Its flank line has the mean spiral angle in the
    /// middle of the half, and meets that of the other half, if both went on, at the distance `meeting`. mm.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    pub fn half(data: BevelData, face: [f64; 2], meeting: f64) -> Result<Self, GeometryError> {
        Self::over(data, Some((face, meeting)))
    }

    fn over(data: BevelData, half: Option<([f64; 2], f64)>) -> Result<Self, GeometryError> {
        data.check()?;
        let geometry = |what: &str, value, good, allowed: &str| {
            if good {
                Ok(())
            } else {
                Err(GeometryError::InvalidGeometry { what: what.into(), value, allowed: allowed.into() })
            }
        };
        let teeth = f64::from(data.teeth);
        let delta = data.pitch_angle;
        let outer = data.outer_transverse_module * teeth / (2.0 * delta.sin());
        geometry("cone distance at the heel", outer, outer.is_finite(), "a finite length")?;
        let inner = outer - data.face_width;
        geometry("cone distance at the toe", inner, inner > 0.0, "> 0 mm: a face that ends before the apex")?;
        let mut face = [inner, outer];
        let (mut width, mut mean) = (data.face_width, outer - data.face_width / 2.0);
        if let Some((ends, _)) = half {
            let [from, to] = ends;
            let whole = format!("two ends that ascend between {inner} and {outer} mm");
            geometry("begin of a half of the face", from, from >= inner && from < to && to <= outer, &whole)?;
            (face, width, mean) = (ends, to - from, 0.5 * (from + to));
        }
        let base_angle = (delta.sin() * data.pressure_angle.cos()).asin();
        let tip_angle = delta + (data.addendum_factor * data.outer_transverse_module / outer).atan();
        let root_angle = delta - (data.dedendum_factor * data.outer_transverse_module / outer).atan();
        // Beyond the plane through the apex the involute goes on to the base cone that faces the other way.
        let beyond = PI - base_angle;
        let allowed = format!("below {:.4} deg, where the involute ends", beyond.to_degrees());
        geometry("tip cone angle in degrees", tip_angle.to_degrees(), tip_angle < beyond, &allowed)?;
        geometry("root cone angle in degrees", root_angle.to_degrees(), root_angle > 0.0, "> 0 deg")?;
        let lowest = root_angle.max(base_angle);
        let form_angle = data.form_angle.unwrap_or(lowest + FORM_SHARE * (tip_angle - lowest));
        geometry(
            "polar angle of the form cone in degrees",
            form_angle.to_degrees(),
            form_angle < tip_angle,
            "below that of the tip cone",
        )?;

        let sin_base = base_angle.sin();
        let pitch_roll = (delta.cos() / base_angle.cos()).acos();
        let base_space_half_angle = FRAC_PI_2 / teeth - spherical_involute_function(pitch_roll, sin_base);
        let line = match data.spiral {
            None => FlankLine::Straight,
            Some(spiral) => {
                let circular = |radius: f64, groups: f64| {
                    let rolling = groups * delta.sin() / teeth;
                    CircularLine::new(&spiral, (radius, rolling), mean, delta).map(FlankLine::Circular).ok_or(
                        GeometryError::InvalidGeometry {
                            what: "radius of a cutter head with these groups of blades".into(),
                            value: radius,
                            allowed: format!("> {:.4} mm", mean * spiral.mean_angle.cos() * rolling),
                        },
                    )
                };
                let tangent = |involute| {
                    let scale = spiral.hand.sign() / delta.sin();
                    FlankLine::Tangent(TangentLine::new(involute, spiral.mean_angle, mean, scale))
                };
                match spiral.form {
                    LineForm::Circle { radius } => circular(radius, 0.0)?,
                    LineForm::Epicycloid { radius, groups } => circular(radius, groups)?,
                    LineForm::Straight => tangent(false),
                    LineForm::Involute => tangent(true),
                }
            }
        };
        line.check(face)?;
        let line = match half {
            None => line,
            Some((_, meeting)) => {
                line.check([meeting; 2])?;
                line.through(meeting)
            }
        };
        let mut gear = Self {
            data,
            outer_distance: outer,
            face,
            width,
            mean_distance: mean,
            base_angle,
            tip_angle,
            root_angle,
            form_angle,
            pitch_roll,
            base_space_half_angle,
            line,
            heights: [0.0; 2],
        };
        gear.heights = [gear.roll_angle(form_angle)?, gear.roll_angle(tip_angle)?];
        let at_tip = spherical_involute_function(gear.heights[1] * sin_base, sin_base);
        let half = PI / teeth - base_space_half_angle - at_tip;
        if half <= 0.0 {
            return Err(GeometryError::BevelToothPointed { half_angle_deg: half.to_degrees() });
        }
        Ok(gear)
    }

    /// The drawing data.
    pub fn data(&self) -> &BevelData {
        &self.data
    }

    /// R_e: cone distance at the heel, mm.
    pub fn outer_distance(&self) -> f64 {
        self.outer_distance
    }

    /// R_m: cone distance at the middle of the face, or of that of a half, mm.
    pub fn mean_distance(&self) -> f64 {
        self.mean_distance
    }

    /// Distances from the apex at toe and heel of the gear, or at both ends of a half, mm.
    pub fn face(&self) -> [f64; 2] {
        self.face
    }

    /// Width of the teeth between them, mm.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// delta_b: angle of the base cone, rad.
    pub fn base_angle(&self) -> f64 {
        self.base_angle
    }

    /// delta_a: angle of the tip cone, rad.
    pub fn tip_angle(&self) -> f64 {
        self.tip_angle
    }

    /// delta_f: angle of the root cone, rad.
    pub fn root_angle(&self) -> f64 {
        self.root_angle
    }

    /// theta_form: polar angle at which the active flank begins, rad.
    pub fn form_angle(&self) -> f64 {
        self.form_angle
    }

    /// xi_p: arc on the plane of action from the base cone to the pitch cone, rad.
    pub fn pitch_roll(&self) -> f64 {
        self.pitch_roll
    }

    /// eta_b: half angle of the space on the base cone, rad.
    pub fn base_space_half_angle(&self) -> f64 {
        self.base_space_half_angle
    }

    /// The flank line of the drawing.
    pub fn line(&self) -> &FlankLine {
        &self.line
    }

    /// a_root and a_tip: roll angles of form cone and tip cone, rad.
    pub fn heights(&self) -> [f64; 2] {
        self.heights
    }

    /// omega(theta): roll angle of the flank at a polar angle, rad.
    ///
    /// # Errors
    /// [`GeometryError::BelowBaseCone`] below the base cone and beyond the one that faces it (`E_GEOM_BASE` of
    /// `docs/mathematics/milling.md#limits`).
    pub fn roll_angle(&self, polar_angle: f64) -> Result<f64, GeometryError> {
        if !(self.base_angle..=PI - self.base_angle).contains(&polar_angle) {
            return Err(GeometryError::BelowBaseCone {
                angle_deg: polar_angle.to_degrees(),
                base_angle_deg: self.base_angle.to_degrees(),
            });
        }
        // |cos theta| > cos delta_b by rounding only.
        Ok((polar_angle.cos() / self.base_angle.cos()).clamp(-1.0, 1.0).acos() / self.base_angle.sin())
    }
}
