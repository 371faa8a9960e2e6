//! The disc dresser of a worm: both flank profiles as conjugates of the worm, optionally the head, and given offsets.

use super::{DressingError, nominal_contact};
use foundation::geometry::{Flank, Gear, InvoluteFlank, ProfileOffset, Revolution, Sides};
use foundation::kinematics::{DressingChain, DressingCorrection};
use foundation::numerics::{Chebyshev, value_of};
use std::sync::Arc;

/// Range of lengths of roll on the worm that generates the gear's usable flank, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeometricRange {
    /// w_NfS: smaller end (generates the gear's tip).
    pub w_nf: f64,
    /// w_NaS: larger end (generates the gear's root).
    pub w_na: f64,
}

impl GeometricRange {
    /// Length m = w_NaS - w_NfS.
    pub fn length(&self) -> f64 {
        self.w_na - self.w_nf
    }

    /// Middle of the range.
    pub fn middle(&self) -> f64 {
        0.5 * (self.w_na + self.w_nf)
    }
}

/// One flank of the dresser and the worm flank that it dresses.
#[derive(Clone, Debug)]
pub struct FlankDresser {
    /// The meridian over t = the w it was designed for.
    pub profile: Revolution,
    /// Range of t that serves the range of the worm it was designed for.
    pub designed: GeometricRange,
    /// The worm flank it dresses.
    pub worm: InvoluteFlank,
    /// Kinematics without corrections on that worm. The screw parameter is that of the flank: the flanks of a conical worm have
    /// different ones.
    pub chain: DressingChain,
    /// What `chain` holds beyond the nominal kinematics of that worm: zero unless a dresser that was designed for another worm has
    /// been settled on it.
    pub settled: DressingCorrection,
    /// Range of that worm.
    pub range: GeometricRange,
    /// Worm z of the nominal contact at v_zS = 0 over w, mm: exact on the worm it was designed for, a start value on others.
    pub line: Chebyshev,
}

/// A disc dresser on a given worm in nominal kinematics.
#[derive(Clone, Debug)]
pub struct DresserTool {
    /// Both flanks.
    pub flanks: Sides<FlankDresser>,
    /// Head part that dresses the worm's outside cylinder, parameter t_H = b.
    pub head: Option<Revolution>,
}

/// Nodes of the meridian series; 48 reach 1e-13 mm (`docs/mathematics/dressing.md#the-conjugate-profile`).
const NODES: usize = 48;
/// Share of the used range by which the profile is continued at each end, because DK moves the contact along it.
const MARGIN: f64 = 0.6;

impl DresserTool {
    /// Conjugate dresser of the unmodified worm.
    ///
    /// # Errors
    /// [`DressingError::NoConjugate`]; [`DressingError::InvalidNumber`] for an empty range.
    pub fn conjugate(
        worm: &Gear,
        chains: Sides<DressingChain>,
        ranges: Sides<GeometricRange>,
    ) -> Result<Self, DressingError> {
        Self::conjugate_beyond(worm, chains, ranges, MARGIN)
    }

    /// The same with the profile continued by the share `margin` of the used range at each end instead of 0.6.
    ///
    /// # Errors
    /// As [`DresserTool::conjugate`].
    pub fn conjugate_beyond(
        worm: &Gear,
        chains: Sides<DressingChain>,
        ranges: Sides<GeometricRange>,
        margin: f64,
    ) -> Result<Self, DressingError> {
        let flanks = Sides::try_from_fn(|flank| -> Result<_, DressingError> {
            let (range, chain) = (ranges[flank], chains[flank]);
            check(&chain, &range, margin)?;
            let m = range.length();
            let (from, to) = (range.w_nf - margin * m, range.w_na + margin * m);
            let contacts = Chebyshev::nodes(from, to, NODES)
                .into_iter()
                .map(|w| nominal_contact(worm.flank(flank), &chain, w))
                .collect::<Result<Vec<_>, _>>()?;
            let fit = |value: &dyn Fn(&super::NominalContact) -> f64| {
                Chebyshev::interpolate(from, to, &contacts.iter().map(value).collect::<Vec<_>>())
                    .truncated(1e-17)
            };
            let middle = &contacts[NODES / 2];
            let profile = oriented(fit(&|c| c.r), fit(&|c| c.z), 0.5 * (from + to), middle.n_r, middle.n_z);
            let worm = *worm.flank(flank);
            Ok(FlankDresser {
                profile,
                designed: range,
                worm,
                chain,
                settled: [0.0; 4],
                range,
                line: fit(&|c| c.b),
            })
        })?;
        Ok(Self { flanks, head: None })
    }

    /// Adds the head part: conjugate of the worm's outside cylinder over b in [-half_width, half_width].
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`] when the cylinder has no conjugate.
    pub fn with_head(mut self, radius: f64, half_width: f64) -> Result<Self, DressingError> {
        let chain = &self.flanks.left.chain;
        let (sin_g, cos_g) = chain.crossing_angle.sin_cos();
        let (d, v_y) = (chain.centre_distance, chain.offset);
        let contact = |b: f64| -> Result<[f64; 4], DressingError> {
            let mut angle: f64 = 0.0;
            for _ in 0..60 {
                let (s, c) = angle.sin_cos();
                let g = sin_g * (b - v_y * sin_g) * c - cos_g * (d * s + v_y * cos_g * c);
                let slope = -sin_g * (b - v_y * sin_g) * s - cos_g * (d * c - v_y * cos_g * s);
                let step = g / slope;
                angle -= step;
                if step.abs() < 1e-15 {
                    break;
                }
            }
            let (s, c) = angle.sin_cos();
            let arm = [radius * c - d, radius * s + v_y * cos_g, b - v_y * sin_g];
            let across = arm[1] * cos_g - arm[2] * sin_g;
            let r = arm[0].hypot(across);
            let values =
                [r, arm[1] * sin_g + arm[2] * cos_g, -(c * arm[0] + s * cos_g * across) / r, -s * sin_g];
            if values.iter().all(|x| x.is_finite()) {
                Ok(values)
            } else {
                Err(DressingError::InvalidNumber {
                    field: "worm head radius",
                    value: radius,
                    allowed: "a radius the dresser reaches",
                })
            }
        };
        let nodes = Chebyshev::nodes(-half_width, half_width, 24);
        let values = nodes.iter().map(|&b| contact(b)).collect::<Result<Vec<_>, _>>()?;
        let fit = |k: usize| {
            Chebyshev::interpolate(-half_width, half_width, &values.iter().map(|v| v[k]).collect::<Vec<_>>())
                .truncated(1e-17)
        };
        let at_zero = contact(0.0)?;
        self.head = Some(oriented(fit(0), fit(1), 0.0, at_zero[2], at_zero[3]));
        Ok(self)
    }

    /// The same dresser with normal profile offsets (g > 0: more dresser).
    pub fn with_offsets(&self, offsets: &Sides<Option<Arc<dyn ProfileOffset>>>) -> Self {
        let mut tool = self.clone();
        for (flank, offset) in offsets.iter() {
            if let Some(offset) = offset {
                tool.flanks[flank].profile = self.flanks[flank].profile.with_offset(offset.clone());
            }
        }
        tool
    }

    /// The same dresser without profile offsets.
    pub fn plain(&self) -> Self {
        let mut tool = self.clone();
        for flank in Flank::BOTH {
            tool.flanks[flank].profile = self.flanks[flank].profile.plain();
        }
        tool
    }
}

/// Nodes of the line in which a worm's conjugate dresser touches it.
const LINE_NODES: usize = 24;

/// Worm z over w of the contact with the conjugate dresser of this worm, over the used range with the share `margin` of it at
/// each end, but not below the base cylinder.
pub(super) fn conjugate_line(
    worm: &InvoluteFlank,
    chain: &DressingChain,
    range: &GeometricRange,
    margin: f64,
) -> Result<Chebyshev, DressingError> {
    let m = margin * range.length();
    let from = (range.w_nf - m).max(0.5 * range.w_nf);
    Chebyshev::fit(from, range.w_na + m, LINE_NODES, |w| nominal_contact(worm, chain, w).map(|at| at.b))
}

/// # Errors
/// [`DressingError::InvalidNumber`] for numbers from which no dresser can be made.
fn check(chain: &DressingChain, range: &GeometricRange, margin: f64) -> Result<(), DressingError> {
    let invalid = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
    if !(range.w_nf > 0.0 && range.w_na > range.w_nf && range.w_na.is_finite()) {
        return invalid("w_NfS", range.w_nf, "0 < w_NfS < w_NaS");
    }
    if !(margin.is_finite() && margin >= 0.0) {
        return invalid("continuation of the profile", margin, ">= 0, as a share of the used range");
    }
    for (field, value) in [
        ("worm angle phi_S", chain.worm_angle),
        ("crossing angle gamma_A", chain.crossing_angle),
        ("centre distance d_A", chain.centre_distance),
        ("offset v_yA", chain.offset),
        ("screw parameter", chain.screw_parameter),
    ] {
        if !value.is_finite() {
            return invalid(field, value, "finite numbers");
        }
    }
    if chain.screw_parameter == 0.0 {
        return invalid("screw parameter", 0.0, "other than 0");
    }
    Ok(())
}

/// A meridian whose outward normal at t agrees with (n_r, n_z).
fn oriented(radius: Chebyshev, axial: Chebyshev, t: f64, n_r: f64, n_z: f64) -> Revolution {
    let outward = Revolution::new(radius.clone(), axial.clone(), 1.0);
    let at = outward.at(t);
    if value_of(at.n_r) * n_r + value_of(at.n_z) * n_z > 0.0 {
        outward
    } else {
        Revolution::new(radius, axial, -1.0)
    }
}
