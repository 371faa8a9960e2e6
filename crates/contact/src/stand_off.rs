//! Centre distance and workpiece angle that leave given amounts on both flanks: an involute flank stays one when the centre distance changes.

use foundation::geometry::{Flank, Sides};

/// How far a tool stands off, and by how much the workpiece is turned.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StandOff {
    /// Added to the centre distance, mm.
    pub delta_d: f64,
    /// Added to the workpiece's angle, rad.
    pub delta_phi_2: f64,
}

/// What the normal amount of a flank depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lever {
    /// sin(alpha_n): normal amount per centre distance.
    pub sine: f64,
    /// r_b2 cos(beta_b2): normal amount per angle of the workpiece, mm.
    pub arm: f64,
}

impl StandOff {
    /// That leaves `left` (normal, mm) on both flanks.
    pub fn of_both(levers: Sides<Lever>, left: Sides<f64>) -> Self {
        let Sides { left: l, right: r } = levers;
        let by = l.sine * r.arm + r.sine * l.arm;
        Self {
            delta_d: (left.left * r.arm + left.right * l.arm) / by,
            delta_phi_2: (left.right * l.sine - left.left * r.sine) / by,
        }
    }

    /// That leaves `left` on the flanks that are ground: one alone stands off by the centre distance.
    pub fn of_ground(levers: Sides<Option<Lever>>, left: Sides<f64>) -> Self {
        match levers {
            Sides { left: Some(l), right: Some(r) } => Self::of_both(Sides { left: l, right: r }, left),
            one => Flank::BOTH
                .into_iter()
                .find_map(|flank| one[flank].map(|lever| left[flank] / lever.sine))
                .map_or(Self::default(), |delta_d| Self { delta_d, delta_phi_2: 0.0 }),
        }
    }
}
