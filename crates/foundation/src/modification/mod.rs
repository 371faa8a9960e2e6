//! What a flank should be: functions f_t(w, z) on the evaluation field, their description in files and their
//! algebra (`docs/mathematics/modifications.md`). Knows no process: whether a modification can be made is not asked here.
//!
//! A [`ModificationSpec`] is what a job file says. [`Modification::build`] checks it once against an
//! [`EvaluationField`]; the result is immutable and answers with value, gradient and second derivatives.
//!
//! ```
//! use foundation::modification::{EvaluationField, Modification, ModificationSpec};
//!
//! let field = EvaluationField::new([6.5, 20.8], [-15.0, 15.0], 38.45, 0.327)?;
//! let spec = ModificationSpec::from_json(&serde_json::json!({ "kind": "helix_crowning", "amount_um": 10.0 }))?;
//! let crowning = Modification::build(&spec, &field)?;
//! assert!((crowning.value(12.0, 15.0)? + 0.010).abs() < 1e-15); // mm, negative = material removed
//! # Ok::<(), foundation::modification::ModificationError>(())
//! ```

mod build;
mod curve;
mod direction;
mod error;
mod faces;
mod field;
mod files;
mod formula;
mod from_json;
mod limits;
mod node;
mod point_cloud;
mod profile_trace;
mod smoothness;
mod spec;
mod tolerance_map;
mod traces;
mod warning;
mod waviness;

use crate::geometry::Flank;
use crate::numerics::{Jet2, Polynomial2};
use node::Node;

pub use error::{EvaluationError, ModificationError};
pub use field::EvaluationField;
pub use files::{GridTable, ModificationFiles, NoFiles};
pub use smoothness::Smoothness;
pub use spec::{
    AmountSpec, Axis, CompositeSpec, CornerFace, CornerProfile, DirectedSpec, FlankChoice, FormulaSpec,
    GridSpec, HelixTracesSpec, HelixTwoArcSpec, MirrorSpec, ModificationSpec, PointMethod, PointsSpec,
    PolynomialSpec, ProfileTraceSpec, ProfileTwoArcSpec, Reference, ReliefSpec, ScaleSpec, TriangularSpec,
    WavinessSpec,
};
pub use tolerance_map::ToleranceMap;
pub use warning::ModificationWarning;

/// Polynomials above this total degree are not handed out: their coefficients about the middle of the field say
/// little and their dense table grows with the square.
const HIGHEST_DEGREE: usize = 64;

/// A checked modification of one flank: f_t(w, z) in mm, transverse, positive = material left standing
/// (`docs/mathematics/modifications.md`). Reliefs, crownings and grids continue by their own law beyond the evaluation field;
/// only point clouds end at their hull and arcs where the circle ends.
#[derive(Clone, Debug)]
pub struct Modification {
    field: EvaluationField,
    root: Node,
    warnings: Vec<ModificationWarning>,
}

impl Modification {
    /// Checks a description against the field it is meant for. The key `flank` of the spec is not looked at: see
    /// [`Modification::for_flank`].
    ///
    /// # Errors
    /// [`ModificationError`] naming kind, key, value and allowed range; `FileUnavailable` for a grid or cloud
    /// that lies in a file (use [`Modification::build_with_files`]).
    pub fn build(spec: &ModificationSpec, field: &EvaluationField) -> Result<Self, ModificationError> {
        Self::build_with_files(spec, field, &NoFiles)
    }

    /// As [`Modification::build`], with a reader for the key `file` of grids and clouds.
    ///
    /// # Errors
    /// As [`Modification::build`].
    pub fn build_with_files(
        spec: &ModificationSpec,
        field: &EvaluationField,
        files: &dyn ModificationFiles,
    ) -> Result<Self, ModificationError> {
        let mut builder = build::Builder::new(field, files);
        let root = builder.node(spec)?;
        Ok(Self { field: *field, root, warnings: builder.into_warnings() })
    }

    /// The sum of those descriptions that apply to `flank`; no description at all is the unmodified flank.
    ///
    /// # Errors
    /// As [`Modification::build`].
    pub fn for_flank(
        specs: &[ModificationSpec],
        flank: Flank,
        field: &EvaluationField,
        files: &dyn ModificationFiles,
    ) -> Result<Self, ModificationError> {
        Self::of_entries(specs, flank, field, files).map_err(|(_, error)| error)
    }

    /// As [`Modification::for_flank`], for callers whose message names the entry.
    ///
    /// # Errors
    /// The index of the description in `specs` that cannot be built, with the reason.
    pub fn of_entries(
        specs: &[ModificationSpec],
        flank: Flank,
        field: &EvaluationField,
        files: &dyn ModificationFiles,
    ) -> Result<Self, (usize, ModificationError)> {
        let mut builder = build::Builder::new(field, files);
        let nodes: Result<Vec<Node>, (usize, ModificationError)> = (0..)
            .zip(specs)
            .filter(|(_, spec)| spec.flank().includes(flank))
            .map(|(index, spec)| builder.node(spec).map_err(|error| (index, error)))
            .collect();
        Ok(Self { field: *field, root: Node::Sum(nodes?), warnings: builder.into_warnings() })
    }

    /// The unmodified flank: f_t = 0.
    pub fn none(field: &EvaluationField) -> Self {
        Self { field: *field, root: Node::Sum(Vec::new()), warnings: Vec::new() }
    }

    /// f_t at length of roll `w` and face position `z` (mm), in mm.
    ///
    /// # Errors
    /// [`EvaluationError`]: outside the hull of a point cloud, beyond the circle of an arc, or (far outside the
    /// field) more than a number can hold. Never NaN.
    #[inline]
    pub fn value(&self, w: f64, z: f64) -> Result<f64, EvaluationError> {
        finite_point(w, z)?;
        let f = self.root.value(w, z)?;
        if f.is_finite() { Ok(f) } else { Err(EvaluationError::NotFinite { w, z }) }
    }

    /// (df_t/dw, df_t/dz), dimensionless; at kinks the mean of the one-sided derivatives.
    ///
    /// # Errors
    /// As [`Modification::jet`].
    #[inline]
    pub fn gradient(&self, w: f64, z: f64) -> Result<(f64, f64), EvaluationError> {
        self.jet(w, z).map(|jet| (jet.fu, jet.fv))
    }

    /// Value (mm), gradient and second derivatives (1/mm) with u = w, v = z. First and second derivatives are the
    /// mean of the one-sided ones where these differ; a second derivative that grows without bound at one side
    /// (relief exponents between 1 and 2) is reported from the other side at that very point.
    ///
    /// # Errors
    /// As [`Modification::value`], also where the derivative of an arc becomes infinite.
    #[inline]
    pub fn jet(&self, w: f64, z: f64) -> Result<Jet2, EvaluationError> {
        finite_point(w, z)?;
        let jet = self.root.jet(w, z)?;
        if jet.is_finite() { Ok(jet) } else { Err(EvaluationError::NotFinite { w, z }) }
    }

    /// Whether value and gradient exist on the whole evaluation field. Only a point cloud whose hull misses a
    /// corner of the field fails here; ask once, before an evaluation of many points.
    ///
    /// # Errors
    /// [`EvaluationError`] at the first corner that has no value.
    pub fn check_field(&self) -> Result<(), EvaluationError> {
        let ([w_f, w_a], [z_1, z_2]) = (self.field.roll(), self.field.face());
        [(w_f, z_1), (w_f, z_2), (w_a, z_1), (w_a, z_2)]
            .into_iter()
            .try_for_each(|(w, z)| self.value(w, z).map(|_| ()))
    }

    /// The field for which the modification was checked.
    pub fn field(&self) -> &EvaluationField {
        &self.field
    }

    /// How often the function can be differentiated without a jump: the worst of its parts.
    pub fn smoothness(&self) -> Smoothness {
        self.root.smoothness()
    }

    /// The exact polynomial in the centred variables u = w - w_m, y = z - z_m (mm), if the modification is one:
    /// coefficients a_ij in mm/mm^(i+j), f_t = sum a_ij u^i y^j (`docs/mathematics/generating-contact.md#decomposition-of-a-target`).
    /// `None` for everything else and for polynomials of a degree above 64.
    pub fn polynomial(&self) -> Option<Polynomial2> {
        self.root.polynomial(self.field.roll_middle(), self.field.face_middle())
    }

    /// Whether the function is one of w alone (profile crownings, slopes, tip and root relief and what is composed
    /// of them): such a modification can be put into the dresser.
    pub fn depends_on_profile_only(&self) -> bool {
        self.root.depends_on_profile_only()
    }

    /// Standard deviation at a length of roll of what is fitted to measured profiles, mm; 0 without any.
    pub fn measured_deviation(&self, w: f64) -> f64 {
        self.root.measured_variance(w).sqrt()
    }

    /// The parts that a sum consists of, sums inside sums opened; a modification that is no sum is its only part.
    /// Lets a planner treat polynomial and profile parts each in its own way.
    pub fn terms(&self) -> Vec<Modification> {
        let mut nodes = Vec::new();
        self.root.collect_terms(&mut nodes);
        nodes.into_iter().map(|root| Self { field: self.field, root, warnings: Vec::new() }).collect()
    }

    /// The parts that the descriptions of a sum became, each with its description, sums inside sums opened: `specs` are the
    /// first of those that [`Modification::for_flank`] built for `flank`.
    pub fn described_terms<'a>(
        &self,
        specs: &'a [ModificationSpec],
        flank: Flank,
    ) -> Vec<(&'a ModificationSpec, Modification)> {
        fn open<'a>(
            spec: &'a ModificationSpec,
            node: &Node,
            into: &mut impl FnMut(&'a ModificationSpec, &Node),
        ) {
            match (spec, node) {
                (ModificationSpec::Sum(sum), Node::Sum(children)) => {
                    sum.children.iter().zip(children).for_each(|(child, node)| open(child, node, into));
                }
                _ => into(spec, node),
            }
        }
        let Node::Sum(nodes) = &self.root else { return Vec::new() };
        let mut terms = Vec::new();
        let specs = specs.iter().filter(|spec| spec.flank().includes(flank));
        for (spec, node) in specs.zip(nodes) {
            open(spec, node, &mut |spec, node| {
                let root = node.clone();
                terms.push((spec, Self { field: self.field, root, warnings: Vec::new() }));
            });
        }
        terms
    }

    /// What was accepted but looks unintended.
    pub fn warnings(&self) -> &[ModificationWarning] {
        &self.warnings
    }
}

#[inline]
fn finite_point(w: f64, z: f64) -> Result<(), EvaluationError> {
    if w.is_finite() && z.is_finite() { Ok(()) } else { Err(EvaluationError::NotFinite { w, z }) }
}
