//! Down to which diameter a worm can be dressed later on before it turns out that today's dressing has cut into its flanks: undermining
//! (`docs/mathematics/dressing.md#limits-of-a-correction`). Cylindrical worms under one dresser. Knows no worm function.

use super::workshop::GearWorkshop;
use super::{GeneratingError, GrindingSetup};
use dressing::catalogue::{DresserSize, Workshop};
use dressing::{DresserSection, DresserTool, WormFlank, WormSeat};
use foundation::geometry::{Flank, Sides, WormChoice};
use foundation::numerics::{Chebyshev, equidistant};

/// Where dressing a worm cuts into a smaller one that is to be left in it. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Undermined {
    /// The flank that was dressed.
    pub dressed: Flank,
    /// The flank of the smaller worm that is cut.
    pub flank: Flank,
    /// How deep, normal.
    pub depth: f64,
    /// Where on the worm, z.
    pub z: f64,
}

/// The worms that today's dressing leaves whole. Tip diameters, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SparedWorms {
    /// The smallest worm that was looked at: the last one, or the one within today's root diameter.
    pub looked_down_to: f64,
    /// The smallest that is left whole, and all between it and the worm of today.
    pub spared_down_to: f64,
    /// What is cut of the smallest that was looked at, if anything.
    pub cut: Option<Undermined>,
}

/// Worm positions at which smaller worms are looked at: DK(v) is smooth, and the leads differ most at the ends.
const POSITIONS: usize = 5;
/// Diameters between the worm of today and the smallest.
const MARCH: usize = 6;
/// Halvings of the step in which the worms that are spared end: 1/64 of it.
const HALVINGS: usize = 6;

impl GrindingSetup {
    /// The worms that the motions DK(v) of the flanks leave whole, from today's tip diameter down to `last` (mm), the addendum
    /// kept. The dresser does not reach below today's root diameter: worms within it are left whole by any motion. `dresser`: as
    /// it stands on the worm of today; `tip_land`: its tip land, mm.
    ///
    /// # Errors
    /// Those of [`DresserSection`]; [`GeneratingError`] for a worm hardly smaller than that of today that is impossible or has no
    /// place under the dresser. Where smaller ones are impossible, the search ends before them.
    pub fn spared_worms(
        &self,
        dresser: &DresserTool,
        corrections: &Sides<Option<&[Chebyshev; 4]>>,
        tip_land: f64,
        last: Option<f64>,
    ) -> Result<SparedWorms, GeneratingError> {
        let Some(choice) = &self.input.dresser else { return Err(GeneratingError::NotDressed) };
        let workshop = GearWorkshop {
            gear: self.input.gear,
            blank: self.input.blank,
            evaluation: self.input.evaluation,
            root_clearance: self.input.root_clearance,
        };
        let size = DresserSize {
            tip_radius: 0.5 * choice.tip_diameter,
            pitch_radius: choice.pitch_diameter.map(|d| 0.5 * d),
        };
        let first = 2.0 * self.worm_tip_radius;
        let within_root = 2.0 * self.worm_root_radius;
        let last = last.map_or(within_root, |last| last.max(within_root));
        let shrunk = 2.0 * (self.worm_tip_radius - self.worm_pitch_radius);
        let cut = |tip_diameter: f64| -> Result<Option<Undermined>, GeneratingError> {
            let worm = WormChoice {
                pitch_diameter: Some(tip_diameter - shrunk),
                tip_diameter: Some(tip_diameter),
                ..self.input.worm
            };
            let later = workshop.seat(&worm, size)?;
            let mut deepest: Option<Undermined> = None;
            for (flank, motion) in corrections.iter() {
                let Some(motion) = motion else { continue };
                let section = DresserSection::new(dresser, flank, size.tip_radius)?;
                let land = tip_land.min(section.full_land());
                let here = cut_by(&section, (flank, motion), land, &later)?;
                if here.is_some_and(|cut| deepest.is_none_or(|deepest| cut.depth > deepest.depth)) {
                    deepest = here;
                }
            }
            Ok(deepest)
        };
        let (mut spared, mut looked, mut stopped) = (first, first, None);
        for tip_diameter in equidistant([first, last], MARCH + 1).into_iter().skip(1) {
            match cut(tip_diameter) {
                Ok(None) => (spared, looked) = (tip_diameter, tip_diameter),
                Ok(Some(here)) => {
                    (looked, stopped) = (tip_diameter, Some(here));
                    break;
                }
                // No worm of today gets as small as one that is impossible.
                Err(_) if looked < first => break,
                Err(error) => return Err(error),
            }
        }
        if stopped.is_some() {
            let mut cut_at = looked;
            for _ in 0..HALVINGS {
                let between = 0.5 * (spared + cut_at);
                match cut(between)? {
                    None => spared = between,
                    Some(_) => cut_at = between,
                }
            }
        }
        Ok(SparedWorms { looked_down_to: looked, spared_down_to: spared, cut: stopped })
    }
}

/// The deepest cut of the motion of one flank into both flanks of a smaller worm.
fn cut_by(
    section: &DresserSection<'_>,
    (dressed, motion): (Flank, &[Chebyshev; 4]),
    land: f64,
    later: &WormSeat,
) -> Result<Option<Undermined>, GeneratingError> {
    let other = later.worm.flanks().map(|flank, &f| WormFlank { flank: f, range: later.ranges[flank] });
    let (from, to) = motion[0].interval();
    let mut deepest: Option<Undermined> = None;
    for v in equidistant([from, to], POSITIONS) {
        let dk = std::array::from_fn(|j| motion[j].value(v));
        // At worm position v the dresser works about z = -v.
        for (flank, planes) in section.undermining(&dk, land, &other, &[-v])?.iter() {
            for at in planes.iter().flatten().filter(|at| at.f < 0.0) {
                if deepest.is_none_or(|deepest| -at.f > deepest.depth) {
                    deepest = Some(Undermined { dressed, flank, depth: -at.f, z: at.b });
                }
            }
        }
    }
    Ok(deepest)
}
