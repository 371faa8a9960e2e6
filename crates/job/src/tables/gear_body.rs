//! The body that `[gear]` describes: its thickness by whichever measure, in the middle of its allowances or at their ends.

use super::gear::Gear;
use foundation::geometry::{Gear as Body, GearData, GeometryError, ThicknessMeasure};

const UM: f64 = 1e-3;

impl Gear {
    /// The gear that is made: in the middle between the allowances of its thickness.
    ///
    /// # Errors
    /// [`GeometryError`] for numbers that make no gear.
    pub fn body(&self) -> Result<Body, GeometryError> {
        self.body_at(self.allowances_um.map_or(0.0, |given| given.middle()))
    }

    /// The gears with the lower and the upper allowance of the measure; `None` without allowances.
    ///
    /// # Errors
    /// As [`Gear::body`].
    pub fn limits(&self) -> Result<Option<[Body; 2]>, GeometryError> {
        let Some(given) = self.allowances_um else { return Ok(None) };
        Ok(Some([self.body_at(given.lower)?, self.body_at(given.upper)?]))
    }

    /// With this allowance of the measure, um.
    fn body_at(&self, allowance_um: f64) -> Result<Body, GeometryError> {
        let more = UM * allowance_um;
        let data = GearData {
            teeth: self.teeth,
            normal_module: self.normal_module,
            pressure_angle: self.normal_pressure_angle_deg.sides().map(|_, angle| angle.to_radians()),
            helix_angle: self.helix_angle_deg.to_radians(),
            profile_shift: 0.0,
            cone_angle: self.cone_angle_deg.to_radians(),
        };
        let measure = if let Some(thickness) = self.normal_tooth_thickness {
            ThicknessMeasure::NormalThickness(thickness + more)
        } else if let Some(span) = &self.span {
            ThicknessMeasure::Span { teeth: span.teeth, length: span.length + more }
        } else if let Some(balls) = &self.over_balls {
            ThicknessMeasure::OverBalls { ball: balls.ball, size: balls.size + more }
        } else {
            // s_n = m_n (pi/2 + x (tan alpha_l + tan alpha_r)).
            let tangents = data.pressure_angle.left.tan() + data.pressure_angle.right.tan();
            let shift = self.profile_shift.unwrap_or(0.0) + more / (data.normal_module * tangents);
            ThicknessMeasure::ProfileShift(shift)
        };
        Body::new(GearData { profile_shift: measure.profile_shift(data)?, ..data })
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Allowances, Gear, OverBalls, Span};

    fn gear() -> Gear {
        serde_json::from_value(serde_json::json!({
            "teeth": 29, "normal_module": 2.0, "normal_pressure_angle_deg": 20.0, "helix_angle_deg": 15.0, "profile_shift": 0.2,
            "face_width": 20.0, "tip_diameter": 65.0, "root_diameter": 56.0, "form_diameter": 57.0,
        }))
        .unwrap()
    }

    /// Each measure reads its own allowances on the gears at both ends, and their middle on the gear that is made.
    #[test]
    fn allowances_are_those_of_the_measure_that_is_given() {
        let plain = gear().body().unwrap();
        let (span, balls) = (plain.span(4).unwrap(), plain.over_balls(3.5, 0.0).unwrap());
        let allowances_um = Some(Allowances { lower: -90.0, upper: -50.0 });
        let s_n = |body: &foundation::geometry::Gear| {
            body.transverse_thickness(body.pitch_radius(), 0.0).unwrap() * 15f64.to_radians().cos()
        };
        let without = Gear { profile_shift: None, allowances_um, ..gear() };
        type Read<'a> = Box<dyn Fn(&foundation::geometry::Gear) -> f64 + 'a>;
        let cases: [(Gear, Read); 4] = [
            (Gear { profile_shift: Some(0.2), ..without.clone() }, Box::new(s_n)),
            (Gear { normal_tooth_thickness: Some(s_n(&plain)), ..without.clone() }, Box::new(s_n)),
            (
                Gear { span: Some(Span { teeth: 4, length: span.length }), ..without.clone() },
                Box::new(|body| body.span(4).unwrap().length),
            ),
            (
                Gear { over_balls: Some(OverBalls { ball: 3.5, size: balls.size }), ..without.clone() },
                Box::new(|body| body.over_balls(3.5, 0.0).unwrap().size),
            ),
        ];
        for (gear, read) in cases {
            let [lower, upper] = gear.limits().unwrap().unwrap();
            let nominal = read(&plain);
            for (body, want) in [(&lower, -0.09), (&upper, -0.05), (&gear.body().unwrap(), -0.07)] {
                let got = read(body) - nominal;
                assert!((got - want).abs() < 1e-9, "{got} {want}");
            }
        }
        assert_eq!(gear().limits().unwrap(), None);
    }
}
