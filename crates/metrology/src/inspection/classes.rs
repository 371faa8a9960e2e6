//! Which tolerance class measured values reach (`docs/mathematics/inspection.md#tolerances`).

use super::error::usable;
use super::tolerances::CLASSES;
use super::{InspectionError, ToleranceQuantity, Tolerances};

/// How much a value may exceed the rounded tolerance and still count as equal to it, mm.
const SAME: f64 = 1e-12;

/// Classes reached by the values of a part.
#[derive(Clone, Debug, PartialEq)]
pub struct ReachedClasses {
    /// Class of each value in the order given; `None`: worse than class 11.
    pub each: Vec<(ToleranceQuantity, Option<i32>)>,
    /// The worst of them; `None` if a value is worse than class 11, or nothing was judged.
    pub overall: Option<i32>,
}

/// The best class whose rounded tolerance holds the magnitude of a value, mm; `None` if class 11 does not. Means of slopes go in with the
/// sign that averaging has left them.
///
/// # Errors
/// [`InspectionError::InvalidNumber`].
pub fn reached_class(
    tolerances: &Tolerances,
    quantity: ToleranceQuantity,
    value: f64,
) -> Result<Option<i32>, InspectionError> {
    usable("value to be judged", value, true, "a finite deviation")?;
    for class in CLASSES {
        if value.abs() <= tolerances.rounded(quantity, class)? + SAME {
            return Ok(Some(class));
        }
    }
    Ok(None)
}

/// The classes of several values, mm, and of the part.
///
/// # Errors
/// [`InspectionError::InvalidNumber`].
pub fn reached_classes(
    tolerances: &Tolerances,
    values: &[(ToleranceQuantity, f64)],
) -> Result<ReachedClasses, InspectionError> {
    let each = values
        .iter()
        .map(|(quantity, value)| Ok((*quantity, reached_class(tolerances, *quantity, *value)?)))
        .collect::<Result<Vec<_>, InspectionError>>()?;
    // One value without a class leaves the part without one.
    let classes: Option<Vec<i32>> = each.iter().map(|(_, class)| *class).collect();
    let overall = classes.and_then(|classes| classes.into_iter().max());
    Ok(ReachedClasses { each, overall })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inspection::ToleranceGear;

    fn tolerances() -> Tolerances {
        let gear = ToleranceGear {
            teeth: 41,
            normal_module: 2.5,
            reference_diameter: 105.0,
            face_width: 28.0,
            helix_angle: 0.2,
        };
        Tolerances::new(&gear).unwrap()
    }

    #[test]
    fn a_value_at_its_tolerance_reaches_the_class() {
        let t = tolerances();
        for quantity in ToleranceQuantity::ALL {
            for class in CLASSES {
                let limit = t.rounded(quantity, class).unwrap();
                assert_eq!(reached_class(&t, quantity, -limit).unwrap(), Some(class));
                let next = (class < 11).then_some(class + 1);
                assert_eq!(reached_class(&t, quantity, limit + 2e-12).unwrap(), next);
            }
        }
    }

    #[test]
    fn the_part_is_as_good_as_its_worst_value() {
        let t = tolerances();
        let (fp, fr) = (ToleranceQuantity::SinglePitch, ToleranceQuantity::RunOut);
        let judged = reached_classes(&t, &[(fp, 4.2e-3), (fr, 30e-3)]).unwrap();
        assert_eq!((judged.each[0], judged.overall), ((fp, Some(4)), judged.each[1].1));
        let lost = reached_classes(&t, &[(fp, 4.2e-3), (fr, 3.0)]).unwrap();
        assert_eq!((lost.each[1], lost.overall), ((fr, None), None));
        assert_eq!(reached_classes(&t, &[]).unwrap().overall, None);
        assert_eq!(reached_class(&t, fp, f64::NAN).unwrap_err().code(), "invalid-number");
    }
}
