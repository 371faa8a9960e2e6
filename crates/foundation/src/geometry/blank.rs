//! The machined body round the flanks: face width and diameters, and whether they fit the teeth (`docs/mathematics/involute-gears.md`).

use super::{Flank, Gear, GeometryError, OverBalls, Sides, Span};

/// Face width and diameters at z = 0 of a gear, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blank {
    /// Face width b.
    pub face_width: f64,
    /// Tip diameter d_a.
    pub tip_diameter: f64,
    /// Root diameter d_f.
    pub root_diameter: f64,
    /// Tip form diameter d_Fa (equal to d_a if the tip has no chamfer).
    pub tip_form_diameter: f64,
    /// Root form diameter d_Ff.
    pub form_diameter: f64,
    /// Addendum h_FaP0 of the straight part of the generating rack below its datum line, mm, where undercut is to be judged.
    pub rack_addendum: Option<f64>,
}

/// Usable flank of one side: lengths of roll at start and end in the section z = 0, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EvaluationLimits {
    /// Start (root side).
    pub w_f: f64,
    /// End (tip side).
    pub w_a: f64,
}

/// What is worth saying about a body that is valid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BlankWarning {
    /// The tooth is thinner than 0.2 m_n at the tip.
    ThinTip {
        /// Section, mm.
        z: f64,
        /// Transverse tip thickness, mm.
        thickness: f64,
    },
}

impl std::fmt::Display for BlankWarning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::ThinTip { z, thickness } => {
                write!(f, "tip thickness only {thickness:.3} mm at z = {z} mm (less than 0.2 normal modules)")
            }
        }
    }
}

impl Blank {
    /// Tests the body against the teeth in the order of `docs/mathematics/involute-gears.md`.
    ///
    /// # Errors
    /// [`GeometryError::InvalidNumber`], [`GeometryError::RadiusBelowBaseCircle`], [`GeometryError::DiametersInconsistent`],
    /// [`GeometryError::Undercut`], [`GeometryError::ToothPointed`].
    pub fn check(&self, gear: &Gear) -> Result<Vec<BlankWarning>, GeometryError> {
        for (field, value) in [
            ("face_width", self.face_width),
            ("tip_diameter", self.tip_diameter),
            ("root_diameter", self.root_diameter),
            ("tip_form_diameter", self.tip_form_diameter),
            ("form_diameter", self.form_diameter),
        ] {
            if !(value.is_finite() && value > 0.0) {
                return Err(GeometryError::InvalidNumber { field, value, allowed: "> 0 mm" });
            }
        }
        self.limits(gear)?;
        self.check_order(gear.external_sign())?;
        let half = self.face_width / 2.0;
        let slope = gear.data().cone_angle.tan();
        if let Some(addendum) = self.rack_addendum {
            let h = gear.data().profile_shift * gear.data().normal_module - addendum;
            for (flank, _) in gear.flanks().iter() {
                for z in [-half, half] {
                    let w_start = gear.roll_of_rack_height(flank, h, z);
                    if w_start < 0.0 {
                        return Err(GeometryError::Undercut { flank, z, w_start });
                    }
                }
            }
        }
        let mut warnings = Vec::new();
        for z in [-half, half] {
            let radius = self.tip_diameter / 2.0 - z * slope;
            let thickness = gear.transverse_thickness(radius, z)?;
            if thickness <= 0.0 {
                return Err(GeometryError::ToothPointed { radius, z, thickness });
            }
            if thickness < 0.2 * gear.data().normal_module {
                warnings.push(BlankWarning::ThinTip { z, thickness });
            }
            if slope == 0.0 {
                break; // one section stands for all
            }
        }
        Ok(warnings)
    }

    fn check_order(&self, external_sign: f64) -> Result<(), GeometryError> {
        let chain = [
            ("root_diameter", self.root_diameter, false),
            ("form_diameter", self.form_diameter, true),
            ("tip_form_diameter", self.tip_form_diameter, false),
            ("tip_diameter", self.tip_diameter, false),
        ];
        for pair in chain.windows(2) {
            let (mut inner, mut outer) = (pair[0], pair[1]);
            let strict = inner.2;
            if external_sign < 0.0 {
                std::mem::swap(&mut inner, &mut outer);
            }
            if inner.1 > outer.1 || (strict && inner.1 == outer.1) {
                return Err(GeometryError::DiametersInconsistent {
                    inner: inner.0,
                    inner_value: inner.1,
                    outer: outer.0,
                    outer_value: outer.1,
                });
            }
        }
        Ok(())
    }

    /// Whether the balls of a measure touch the usable flanks.
    ///
    /// # Errors
    /// [`GeometryError::ContactOffFlank`], [`GeometryError::RadiusBelowBaseCircle`].
    pub fn check_balls(&self, gear: &Gear, balls: &OverBalls) -> Result<(), GeometryError> {
        self.check_contact(gear, &balls.contact_w)
    }

    /// Whether the faces of a span measure touch the usable flanks.
    ///
    /// # Errors
    /// [`GeometryError::ContactOffFlank`], [`GeometryError::RadiusBelowBaseCircle`].
    pub fn check_span(&self, gear: &Gear, span: &Span) -> Result<(), GeometryError> {
        let contact = Sides::try_from_fn(|flank| gear.flank(flank).length_of_roll(span.contact_radius))?;
        self.check_contact(gear, &contact)
    }

    fn check_contact(&self, gear: &Gear, contact_w: &Sides<f64>) -> Result<(), GeometryError> {
        let limits = self.limits(gear)?;
        for (flank, &w) in contact_w.iter() {
            let (a, b) = (limits[flank].w_f, limits[flank].w_a);
            let (w_from, w_to) = (a.min(b), a.max(b));
            if !(w_from..=w_to).contains(&w) {
                return Err(GeometryError::ContactOffFlank { flank, w, w_from, w_to });
            }
        }
        Ok(())
    }

    /// Lengths of roll of the form circles, per flank.
    ///
    /// # Errors
    /// [`GeometryError::RadiusBelowBaseCircle`].
    pub fn limits(&self, gear: &Gear) -> Result<Sides<EvaluationLimits>, GeometryError> {
        Sides::try_from_fn(|flank: Flank| {
            let f = gear.flank(flank);
            Ok(EvaluationLimits {
                w_f: f.length_of_roll(self.form_diameter / 2.0)?,
                w_a: f.length_of_roll(self.tip_form_diameter / 2.0)?,
            })
        })
    }
}
