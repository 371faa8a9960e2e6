//! The tilt chart of dressing kinematics, which has no pole at crossing angle 0 (`docs/mathematics/dressing.md#limits-of-a-correction`).

use super::DressingError;

/// Dressing kinematics as (phi_S, gamma_X, d_X, tau): rad, rad, mm, rad; tau is a swivel that changes the pressure angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TiltChart {
    /// phi_S, rad.
    pub phi: f64,
    /// gamma_X, rad.
    pub gamma: f64,
    /// d_X, mm.
    pub d: f64,
    /// tau, rad.
    pub tau: f64,
}

impl TiltChart {
    /// From absolute kinematics K = (phi_S, gamma, d, v_y); p = screw parameter.
    pub fn from_kinematics([phi, g, d, v_y]: [f64; 4], p: f64) -> Self {
        let de = -(-v_y * g.cos()).atan2(d);
        let a = [-de.sin() * g.sin(), de.cos() * g.sin(), g.cos()];
        Self {
            phi: phi + de + v_y * g.sin() / p,
            gamma: a[1].atan2(a[2]),
            d: d.hypot(v_y * g.cos()),
            tau: a[0].clamp(-1.0, 1.0).asin(),
        }
    }

    /// dK/dtau at the kinematics (phi_S, gamma, d, 0), sin(gamma) != 0: how the corrections follow a small swivel, per rad.
    pub fn swivel_direction(gamma: f64, d: f64, p: f64) -> [f64; 4] {
        let (sin, cos) = gamma.sin_cos();
        [1.0 / sin + d / (p * cos), 0.0, 0.0, -d / (sin * cos)]
    }

    /// The axis of the dresser in the room; its part across the worm axis is 0 at the pole of the K chart.
    pub fn axis(&self) -> [f64; 3] {
        [self.tau.sin(), self.tau.cos() * self.gamma.sin(), self.tau.cos() * self.gamma.cos()]
    }

    /// Back to K; of the two solutions the one whose d is nearer to `previous_d`, phi_S unwrapped to `previous_phi`.
    ///
    /// # Errors
    /// [`DressingError::PoleOfChart`] when the dresser axis is parallel to the worm axis.
    pub fn to_kinematics(
        &self,
        p: f64,
        previous_d: f64,
        previous_phi: f64,
    ) -> Result<[f64; 4], DressingError> {
        let [plus, minus] = [self.branch(p, 1.0)?, self.branch(p, -1.0)?];
        let nearer = if (plus[2] - previous_d).abs() <= (minus[2] - previous_d).abs() { plus } else { minus };
        Ok(unwrapped(nearer, previous_phi))
    }

    /// Back to K on the branch of a path that comes from the kinematics `previous`. Along a path the crossing angle keeps its
    /// sign, because the branches meet at the pole only; near the pole d changes too fast to tell them apart.
    ///
    /// # Errors
    /// [`DressingError::PoleOfChart`] when the dresser axis is parallel to the worm axis here or there.
    pub fn to_kinematics_along(&self, p: f64, previous: &[f64; 4]) -> Result<[f64; 4], DressingError> {
        if previous[1].sin() == 0.0 {
            return Err(DressingError::PoleOfChart);
        }
        Ok(unwrapped(self.branch(p, previous[1].sin().signum())?, previous[0]))
    }

    /// The kinematics whose crossing angle has the given sign.
    fn branch(&self, p: f64, sign: f64) -> Result<[f64; 4], DressingError> {
        let a = self.axis();
        let across = a[0].hypot(a[1]);
        if across == 0.0 {
            return Err(DressingError::PoleOfChart);
        }
        let g = (sign * across).atan2(a[2]);
        let de = sign * std::f64::consts::FRAC_PI_2 - a[1].atan2(a[0]);
        let d = self.d * de.cos();
        let v_y = -self.d * de.sin() / g.cos();
        Ok([self.phi + de - v_y * g.sin() / p, g, d, v_y])
    }
}

/// The same kinematics with phi_S within half a turn of another one.
fn unwrapped([phi, gamma, d, v_y]: [f64; 4], near: f64) -> [f64; 4] {
    let turn = 2.0 * std::f64::consts::PI;
    [phi - turn * ((phi - near) / turn).round(), gamma, d, v_y]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn charts_go_round() {
        for (g, v_y) in [(-0.17, 3.0), (0.05, -2.0), (-0.01, 0.3), (0.2, 0.0)] {
            let k = [-1.57, g, 107.2, v_y];
            let back = TiltChart::from_kinematics(k, 8.9).to_kinematics(8.9, 107.0, -1.5).unwrap();
            for j in 0..4 {
                assert!((back[j] - k[j]).abs() < 1e-11, "{g} {j}: {} {}", back[j], k[j]);
            }
            // A path keeps the sign of the crossing angle wherever d has got to.
            let along = TiltChart::from_kinematics(k, 8.9)
                .to_kinematics_along(8.9, &[-1.57, 0.5 * g, -107.0, 40.0])
                .unwrap();
            assert!((0..4).all(|j| (along[j] - k[j]).abs() < 1e-11), "{along:?}");
        }
        let (phi, g, d, p) = (-1.57, -0.17, 107.2, 8.9);
        let still = TiltChart::from_kinematics([phi, g, d, 0.0], p);
        let swivelled = |tau: f64| TiltChart { tau, ..still }.to_kinematics(p, d, phi).unwrap();
        let (ahead, behind) = (swivelled(1e-6), swivelled(-1e-6));
        let direction = TiltChart::swivel_direction(g, d, p);
        for j in 0..4 {
            let difference = (ahead[j] - behind[j]) / 2e-6;
            assert!((direction[j] - difference).abs() < 1e-4 * (1.0 + difference.abs()), "{j}");
        }
        let pole = TiltChart { phi: 0.0, gamma: 0.0, d: 100.0, tau: 0.0 };
        assert_eq!(pole.to_kinematics(8.9, 100.0, 0.0), Err(DressingError::PoleOfChart));
        assert_eq!(still.to_kinematics_along(p, &[0.0; 4]), Err(DressingError::PoleOfChart));
    }
}
