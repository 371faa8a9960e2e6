//! How far a flank may differ from its target, from place to place. Knows no target and no verdict.

use super::error::ModificationError;
use super::limits;

/// Name under which the map reports its errors.
const KIND: &str = "tolerance map";

/// Largest deviation allowed over the flank, normal to it: bilinear between the places of a grid. Beyond the grid the
/// values of its border continue.
#[derive(Clone, Debug, PartialEq)]
pub struct ToleranceMap {
    w: Vec<f64>,
    z: Vec<f64>,
    /// `[w][z]`, mm.
    tolerance: Vec<Vec<f64>>,
}

impl ToleranceMap {
    /// A map over lengths of roll `w` and face positions `z` (mm, ascending, one or more each) with one row of tolerances
    /// (mm) for each `w`.
    ///
    /// # Errors
    /// `InvalidModification` naming the cell for a tolerance that is not more than 0, for places that do not ascend and
    /// for a table of another shape; `InvalidNumber` for numbers that are not finite or absurdly large.
    pub fn new(w: Vec<f64>, z: Vec<f64>, tolerance: Vec<Vec<f64>>) -> Result<Self, ModificationError> {
        places("w_mm", &w)?;
        places("z_mm", &z)?;
        if tolerance.len() != w.len() {
            return refuse(
                "tolerance_um",
                format!("{} rows", tolerance.len()),
                format!("{} rows, one for each w_mm", w.len()),
            );
        }
        for (i, row) in tolerance.iter().enumerate() {
            if row.len() != z.len() {
                let found = format!("{} values in row {i}", row.len());
                return refuse("tolerance_um", found, format!("{} values, one for each z_mm", z.len()));
            }
            for (j, t) in row.iter().enumerate() {
                number(&format!("tolerance_um[{i}][{j}]"), *t * 1e3, limits::AMOUNT_UM)?;
                if *t <= 0.0 {
                    let found = format!("{} at w = {} mm, z = {} mm", t * 1e3, w[i], z[j]);
                    return refuse(&format!("tolerance_um[{i}][{j}]"), found, "more than 0 um".into());
                }
            }
        }
        Ok(Self { w, z, tolerance })
    }

    /// The same tolerance (mm) everywhere.
    ///
    /// # Errors
    /// As [`ToleranceMap::new`].
    pub fn uniform(tolerance: f64) -> Result<Self, ModificationError> {
        Self::new(vec![0.0], vec![0.0], vec![vec![tolerance]])
    }

    /// The tolerance at a place (mm), in mm; always more than 0.
    pub fn value(&self, w: f64, z: f64) -> f64 {
        let (i, p) = between(&self.w, w);
        let (j, q) = between(&self.z, z);
        let next = |index: usize, share: f64| if share > 0.0 { index + 1 } else { index };
        let (below, above) = (&self.tolerance[i], &self.tolerance[next(i, p)]);
        let along = |row: &[f64]| row[j] * (1.0 - q) + row[next(j, q)] * q;
        along(below) * (1.0 - p) + along(above) * p
    }

    /// The tightest tolerance, mm.
    pub fn tightest(&self) -> f64 {
        self.tolerance.iter().flatten().copied().fold(f64::INFINITY, f64::min)
    }

    /// Whether it is the same everywhere.
    pub fn is_uniform(&self) -> bool {
        let tightest = self.tightest();
        self.tolerance.iter().flatten().all(|t| *t == tightest)
    }
}

/// Interval of ascending places and the share of it that lies before `x`; beyond the ends the end itself.
fn between(places: &[f64], x: f64) -> (usize, f64) {
    let after = places.partition_point(|place| *place <= x);
    let Some(i) = after.checked_sub(1) else { return (0, 0.0) };
    match places.get(after) {
        Some(next) => (i, (x - places[i]) / (next - places[i])),
        None => (i, 0.0),
    }
}

fn places(key: &str, places: &[f64]) -> Result<(), ModificationError> {
    if places.is_empty() {
        return refuse(key, "an empty list".into(), "one ascending number or more".into());
    }
    for x in places {
        number(key, *x, limits::LENGTH_MM)?;
    }
    if let Some(i) = places.windows(2).position(|pair| pair[1] <= pair[0]) {
        return refuse(
            &format!("{key}[{}]", i + 1),
            places[i + 1].to_string(),
            format!("more than {}", places[i]),
        );
    }
    Ok(())
}

fn number(key: &str, value: f64, limit: f64) -> Result<(), ModificationError> {
    if value.is_finite() && value.abs() <= limit {
        Ok(())
    } else {
        Err(ModificationError::InvalidNumber { kind: KIND.into(), key: key.into(), value, limit })
    }
}

fn refuse<T>(key: &str, value: String, allowed: String) -> Result<T, ModificationError> {
    Err(ModificationError::InvalidModification { kind: KIND.into(), key: key.into(), value, allowed })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bilinear_inside_border_values_outside() {
        // t = 1 + w z on [0, 2] x [1, 4]: bilinear, so met everywhere inside.
        let (w, z) = (vec![0.0, 0.5, 2.0], vec![1.0, 2.0, 4.0]);
        let t = |w: f64, z: f64| 1e-3 * (1.0 + w * z);
        let table = w.iter().map(|w| z.iter().map(|z| t(*w, *z)).collect()).collect();
        let map = ToleranceMap::new(w, z, table).unwrap();
        for i in 0..=20 {
            for j in 0..=20 {
                let (w, z) = (0.1 * f64::from(i), 1.0 + 0.15 * f64::from(j));
                assert!((map.value(w, z) - t(w, z)).abs() < 1e-17, "{w}, {z}");
                assert_eq!(map.value(w, 9.0), map.value(w, 4.0));
                assert_eq!(map.value(-3.0, z), map.value(0.0, z));
            }
        }
        assert_eq!(map.value(5.0, -7.0), t(2.0, 1.0));
        assert_eq!((map.tightest(), map.is_uniform()), (1e-3, false));
        let uniform = ToleranceMap::uniform(2e-3).unwrap();
        assert!(uniform.is_uniform());
        for (w, z) in [(0.0, 0.0), (-9.0, 3.0), (1e9, f64::NAN)] {
            assert_eq!(uniform.value(w, z), 2e-3);
        }
    }

    #[test]
    fn impossible_maps_name_the_cell() {
        let key = |w: &[f64], z: &[f64], t: &[&[f64]]| match ToleranceMap::new(
            w.to_vec(),
            z.to_vec(),
            t.iter().map(|row| row.to_vec()).collect(),
        )
        .unwrap_err()
        {
            ModificationError::InvalidModification { key, .. }
            | ModificationError::InvalidNumber { key, .. } => key,
            other => panic!("{other}"),
        };
        assert_eq!(key(&[1.0, 1.0], &[0.0], &[&[1.0], &[1.0]]), "w_mm[1]");
        assert_eq!(key(&[1.0], &[], &[&[]]), "z_mm");
        assert_eq!(key(&[1.0, 2.0], &[0.0], &[&[1.0]]), "tolerance_um");
        assert_eq!(key(&[1.0, 2.0], &[0.0], &[&[1.0], &[1.0, 2.0]]), "tolerance_um");
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e6] {
            assert_eq!(key(&[1.0, 2.0], &[0.0, 1.0], &[&[1.0, 1.0], &[1.0, bad]]), "tolerance_um[1][1]");
        }
        assert!(ToleranceMap::uniform(0.0).is_err());
    }
}
