//! Tooth thickness from measured span and balls, and whether the two agree (`docs/mathematics/inspection.md#pitch-run-out-eccentricity`).

use super::{InspectionError, InspectionWarning};
use foundation::geometry::{GearData, ThicknessMeasure};

/// Resolution of the sizes that are compared, mm.
const RESOLUTION: f64 = 1e-3;

/// Measured sizes of the teeth. mm
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ThicknessSizes {
    /// Spanned teeth k and span W_k.
    pub span: Option<(u32, f64)>,
    /// Ball diameter D_M and size over (between) balls M_dK.
    pub balls: Option<(f64, f64)>,
}

/// Profile shift coefficients that the sizes mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredThickness {
    /// x by the span.
    pub by_span: Option<f64>,
    /// x by the balls.
    pub by_balls: Option<f64>,
    /// What to know about them.
    pub warning: Option<InspectionWarning>,
}

impl MeasuredThickness {
    /// The x to work with: of the balls, which see every tooth space, else of the span.
    pub fn profile_shift(&self) -> Option<f64> {
        self.by_balls.or(self.by_span)
    }
}

/// Profile shift of a gear by its measured sizes; the profile shift of `data` itself is ignored.
///
/// # Errors
/// Those of [`ThicknessMeasure::profile_shift`].
pub fn measured_thickness(
    data: GearData,
    sizes: &ThicknessSizes,
) -> Result<MeasuredThickness, InspectionError> {
    let shift = |measure: ThicknessMeasure| measure.profile_shift(data);
    let span = sizes.span.map(|(teeth, length)| ThicknessMeasure::Span { teeth, length });
    let balls = sizes.balls.map(|(ball, size)| ThicknessMeasure::OverBalls { ball, size });
    let (by_span, by_balls) = (span.map(shift).transpose()?, balls.map(shift).transpose()?);
    let warning = by_span.zip(by_balls).and_then(|(by_span, by_balls)| {
        // Twice the x that one step of the span's resolution means.
        let allowed = 2.0 * RESOLUTION / (2.0 * data.normal_module * data.pressure_angle.left.sin());
        ((by_span - by_balls).abs() > allowed).then_some(InspectionWarning::ThicknessInconsistent {
            by_span,
            by_balls,
            allowed,
        })
    });
    Ok(MeasuredThickness { by_span, by_balls, warning })
}

#[cfg(test)]
mod tests {
    use super::*;
    use foundation::geometry::{Gear, Sides};

    fn data() -> GearData {
        GearData {
            teeth: 24,
            normal_module: 2.0,
            pressure_angle: Sides::both(20f64.to_radians()),
            helix_angle: 20f64.to_radians(),
            profile_shift: 0.3,
            cone_angle: 0.0,
        }
    }

    #[test]
    fn sizes_that_disagree_are_told() {
        let gear = Gear::new(data()).unwrap();
        let (span, balls) = (gear.span(4).unwrap().length, gear.over_balls(3.5, 0.0).unwrap().size);
        let of = |dw: f64, dm: f64| {
            let sizes = ThicknessSizes { span: Some((4, span + dw)), balls: Some((3.5, balls + dm)) };
            measured_thickness(GearData { profile_shift: -9.0, ..data() }, &sizes).unwrap()
        };
        let exact = of(0.0, 0.0);
        assert!(
            (exact.by_span.unwrap() - 0.3).abs() < 1e-12 && (exact.by_balls.unwrap() - 0.3).abs() < 1e-12
        );
        assert_eq!(exact.warning, None);
        assert_eq!(of(0.0005, -0.0005).warning, None);
        let off = of(0.0, 0.006);
        assert_eq!(off.warning.unwrap().code(), "thickness-inconsistent");
        assert_eq!(off.profile_shift(), off.by_balls);
        let none = measured_thickness(data(), &ThicknessSizes::default()).unwrap();
        assert_eq!((none.profile_shift(), none.warning), (None, None));
    }
}
