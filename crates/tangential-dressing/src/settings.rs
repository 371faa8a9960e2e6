//! Values of design variables, and the laws of motion that they describe. Knows scales and constants of the bodies as numbers.

use super::channel::{Abscissa, Channel, Shape, Variable};
use foundation::kinematics::MotionLaw;

/// Values of design variables; those that are not named are zero. mm, rad.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TangentialSettings {
    values: Vec<(Variable, f64)>,
}

/// Lengths by which abscissae and coefficients are scaled. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scales {
    pub normal_module: f64,
    /// Mean of the tangents of both pressure angles.
    pub mean_tangent: f64,
    pub shift_width: f64,
    pub face_width: f64,
    pub work_pitch_radius: f64,
}

impl Scales {
    /// Abscissa per mm (over the feed: of the tool).
    pub fn per_length(&self, abscissa: Abscissa) -> f64 {
        match abscissa {
            Abscissa::Profile => 1.0 / self.normal_module,
            Abscissa::Worm => 2.0 / self.shift_width,
            Abscissa::Gear => 2.0 / self.face_width,
        }
    }

    /// What the motion does per unit of coefficient: mm or rad.
    pub fn effect(&self, channel: Channel) -> f64 {
        match channel {
            Channel::CrossedAxesAngle => 1.0 / (2.0 * std::f64::consts::PI * self.normal_module),
            Channel::CentreDistance => 1.0 / self.mean_tangent,
            Channel::WorkTurn => 1.0 / self.work_pitch_radius,
            _ => 1.0,
        }
    }
}

impl TangentialSettings {
    /// Values in the order in which they were set.
    pub fn values(&self) -> &[(Variable, f64)] {
        &self.values
    }

    /// The value of a variable, 0 where it is not named.
    pub fn value(&self, variable: &Variable) -> f64 {
        self.values.iter().find(|(v, _)| v == variable).map_or(0.0, |(_, value)| *value)
    }

    /// Sets a variable.
    pub fn set(&mut self, variable: &Variable, value: f64) {
        match self.values.iter_mut().find(|(v, _)| v == variable) {
            Some((_, old)) => *old = value,
            None => self.values.push((variable.clone(), value)),
        }
    }

    /// These values with those of some variables in their place.
    pub fn with(&self, variables: &[Variable], values: &[f64]) -> Self {
        let mut all = self.clone();
        for (variable, &value) in variables.iter().zip(values) {
            all.set(variable, value);
        }
        all
    }

    /// The law of a channel over its length in mm, in mm or rad of the motion; `toward` -1 runs the length backwards.
    pub(super) fn law(&self, channel: Channel, scales: &Scales, toward: f64) -> MotionLaw {
        let per_length = toward * scales.per_length(channel.abscissa());
        let effect = scales.effect(channel);
        let mut coefficients: Vec<f64> = Vec::new();
        let mut laws: Vec<MotionLaw> = Vec::new();
        for (variable, value) in self.values.iter().filter(|(v, c)| v.channel == channel && *c != 0.0) {
            match &variable.shape {
                Shape::Power(k) => {
                    let k = *k as usize;
                    coefficients.resize(coefficients.len().max(k + 1), 0.0);
                    coefficients[k] += value * effect * per_length.powi(k as i32);
                }
                Shape::Spline { function, .. } => laws.push(MotionLaw::BSpline {
                    spline: function.clone(),
                    stretch: per_length,
                    factor: value * effect,
                }),
            }
        }
        let polynomial = MotionLaw::polynomial(0.0, coefficients);
        if laws.is_empty() {
            return polynomial;
        }
        laws.push(polynomial);
        MotionLaw::Sum(laws)
    }
}
