//! The expression tree behind a modification: checked leaves and their algebra. Knows no files and no units
//! other than mm.

use super::HIGHEST_DEGREE;
use super::curve::Curve;
use super::error::EvaluationError;
use super::formula::Formula;
use super::point_cloud::PointCloud;
use super::profile_trace::ProfileTrace;
use super::smoothness::Smoothness;
use super::traces::Traces;
use super::waviness::Waviness;
use crate::numerics::{Jet2, Polynomial2, TensorSpline};

/// um to mm.
const UM: f64 = 1e-3;

/// f_t(w, z) in mm. Built only from checked numbers.
#[derive(Clone, Debug)]
pub(super) enum Node {
    /// curve(a w + b z + c): constant across one direction.
    Ridge { a: f64, b: f64, c: f64, curve: Curve },
    /// Sine with varying amplitude.
    Waviness(Waviness),
    /// Polynomial in (w - origin[0], z - origin[1]).
    Polynomial { origin: [f64; 2], polynomial: Polynomial2 },
    /// Interpolated table.
    Grid(Box<TensorSpline>),
    /// Scattered points.
    Points(Box<PointCloud>),
    /// Traces along the face width, mm.
    Traces(Traces),
    /// A measured profile.
    ProfileTrace(Box<ProfileTrace>),
    /// Formula in um.
    Formula(Box<Formula>),
    /// Sum; empty = 0.
    Sum(Vec<Node>),
    /// Product of the values in mm.
    Product(Vec<Node>),
    /// Multiple.
    Scale(f64, Box<Node>),
    /// f(w, -z).
    MirrorZ(Box<Node>),
}

impl Node {
    #[inline]
    pub(super) fn value(&self, w: f64, z: f64) -> Result<f64, EvaluationError> {
        Ok(match self {
            Node::Ridge { .. } | Node::Waviness(_) | Node::Points(_) | Node::ProfileTrace(_) => {
                self.jet(w, z)?.f
            }
            Node::Polynomial { origin, polynomial } => polynomial.value(w - origin[0], z - origin[1]),
            Node::Grid(spline) => spline.value(w, z),
            Node::Traces(traces) => traces.value(w, z),
            Node::Formula(formula) => formula.value(w, z) * UM,
            Node::Sum(children) => {
                children.iter().try_fold(0.0, |sum, child| child.value(w, z).map(|f| sum + f))?
            }
            Node::Product(children) => {
                children.iter().try_fold(1.0, |product, child| child.value(w, z).map(|f| product * f))?
            }
            Node::Scale(factor, child) => factor * child.value(w, z)?,
            Node::MirrorZ(child) => child.value(w, -z)?,
        })
    }

    #[inline]
    pub(super) fn jet(&self, w: f64, z: f64) -> Result<Jet2, EvaluationError> {
        Ok(match self {
            Node::Ridge { a, b, c, curve } => {
                let x = a * w + b * z + c;
                let beyond = |radius| EvaluationError::BeyondArc { w, z, distance: x.abs(), radius };
                Jet2::ridge(curve.jet(x).map_err(beyond)?, *a, *b)
            }
            Node::Waviness(waviness) => waviness.jet(w, z),
            Node::Polynomial { origin, polynomial } => polynomial.jet(w - origin[0], z - origin[1]),
            Node::Grid(spline) => spline.jet(w, z),
            Node::Traces(traces) => traces.jet(w, z),
            Node::Formula(formula) => formula.jet(w, z) * UM,
            Node::Points(cloud) => cloud.jet(w, z)?,
            Node::ProfileTrace(trace) => trace.jet(w),
            Node::Sum(children) => {
                children.iter().try_fold(Jet2::default(), |sum, child| child.jet(w, z).map(|f| sum + f))?
            }
            Node::Product(children) => children
                .iter()
                .try_fold(Jet2::constant(1.0), |product, child| child.jet(w, z).map(|f| product * f))?,
            Node::Scale(factor, child) => child.jet(w, z)? * *factor,
            Node::MirrorZ(child) => child.jet(w, -z)?.mirrored_v(),
        })
    }

    pub(super) fn smoothness(&self) -> Smoothness {
        match self {
            Node::Ridge { curve, .. } => curve.smoothness(),
            Node::Waviness(_) | Node::Polynomial { .. } => Smoothness::Cinf,
            Node::Grid(_) | Node::Traces(_) | Node::ProfileTrace(_) => Smoothness::C2,
            Node::Formula(formula) => formula.smoothness(),
            Node::Points(cloud) => cloud.smoothness(),
            Node::Sum(children) | Node::Product(children) => {
                children.iter().map(Node::smoothness).min().unwrap_or(Smoothness::Cinf)
            }
            Node::Scale(_, child) | Node::MirrorZ(child) => child.smoothness(),
        }
    }

    /// The polynomial in (w - w_m, z - z_m), if the node is one of moderate degree.
    pub(super) fn polynomial(&self, w_m: f64, z_m: f64) -> Option<Polynomial2> {
        let polynomial = match self {
            Node::Ridge { a, b, c, curve } => {
                let [c_0, c_1, c_2] = curve.polynomial()?;
                let x = Polynomial2::linear(*a, *b, a * w_m + b * z_m + c);
                Polynomial2::constant(c_0).add(&x.scale(c_1)).add(&x.multiply(&x).scale(c_2))
            }
            Node::Polynomial { origin, polynomial } => {
                if polynomial.degree() > HIGHEST_DEGREE {
                    return None;
                }
                polynomial.shifted(w_m - origin[0], z_m - origin[1])
            }
            // Written about the middle of the field, which is (w_m, z_m).
            Node::Formula(formula) => formula.polynomial()?.scale(UM),
            Node::Waviness(_) | Node::Grid(_) | Node::Points(_) | Node::Traces(_) | Node::ProfileTrace(_) => {
                return None;
            }
            Node::Sum(children) => {
                let mut sum = Polynomial2::constant(0.0);
                for child in children {
                    sum = sum.add(&child.polynomial(w_m, z_m)?);
                }
                sum
            }
            Node::Product(children) => {
                let mut product = Polynomial2::constant(1.0);
                for child in children {
                    let factor = child.polynomial(w_m, z_m)?;
                    if product.degree() + factor.degree() > HIGHEST_DEGREE {
                        return None;
                    }
                    product = product.multiply(&factor);
                }
                product
            }
            Node::Scale(factor, child) => child.polynomial(w_m, z_m)?.scale(*factor),
            // With y = z - z_m the child is asked at -z - z_m = -y - 2 z_m.
            Node::MirrorZ(child) => child.polynomial(w_m, z_m)?.shifted(0.0, -2.0 * z_m).mirrored_v(),
        };
        let finite = polynomial.terms().all(|term| term.2.is_finite());
        finite.then_some(polynomial)
    }

    pub(super) fn depends_on_profile_only(&self) -> bool {
        match self {
            Node::Ridge { b, .. } => *b == 0.0,
            Node::Polynomial { polynomial, .. } => polynomial.terms().all(|term| term.1 == 0),
            Node::Waviness(_) | Node::Grid(_) | Node::Points(_) | Node::Traces(_) => false,
            Node::ProfileTrace(_) => true,
            Node::Formula(formula) => formula.depends_on_profile_only(),
            Node::Sum(children) | Node::Product(children) => {
                children.iter().all(Node::depends_on_profile_only)
            }
            Node::Scale(_, child) | Node::MirrorZ(child) => child.depends_on_profile_only(),
        }
    }

    /// Variance at a length of roll of what is fitted to measured profiles, mm^2.
    pub(super) fn measured_variance(&self, w: f64) -> f64 {
        match self {
            Node::ProfileTrace(trace) => trace.deviation_at(w).powi(2),
            Node::Sum(children) => children.iter().map(|child| child.measured_variance(w)).sum(),
            Node::Scale(factor, child) => factor * factor * child.measured_variance(w),
            Node::MirrorZ(child) => child.measured_variance(w),
            // A product with what is known only is not fitted to anything.
            _ => 0.0,
        }
    }

    /// Appends the summands of this node, or the node itself.
    pub(super) fn collect_terms(&self, terms: &mut Vec<Node>) {
        match self {
            Node::Sum(children) => children.iter().for_each(|child| child.collect_terms(terms)),
            other => terms.push(other.clone()),
        }
    }
}
