//! The strokes in which a job dresses its worm: which dressers there are, what of them cuts, and which part of the worm's profile
//! each stroke dresses. Knows no wanted modification and no correction.

use super::dressed::with_profiles;
use super::setup::dressing_place;
use super::{
    Carried, Decomposition, DresserChoice, GeneratingError, GrindingSetup, IdealWorm, StrokeLayout,
    StrokePlace,
};
use dressing::{ActiveArea, DresserTool, MovingSection, WidthLaw, divide_moving};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::MotionLaw;
use foundation::modification::Modification;

/// A dresser that exists, with its own profile modification.
#[derive(Clone, Debug)]
pub struct GivenDresser {
    /// Its sizes.
    pub choice: DresserChoice,
    /// What it leaves on the gear where it dresses the worm as it was designed to: functions of the profile, transverse, mm.
    pub carries: Sides<Vec<Modification>>,
}

/// A part of a dresser's profile that touches the worm: shares of the used profile that it was designed for, 0 at w_NfS and 1 at
/// w_NaS.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AreaOfDresser {
    /// Number of the dresser, from 0.
    pub dresser: usize,
    /// Share at its start.
    pub from: f64,
    /// Share at its end.
    pub to: f64,
}

/// A section of the worm's used profile, which begins where the one before it ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DressedSection {
    /// Share of the used profile at its end, over q from -1 to 1 over the evaluated face.
    pub to: WidthLaw,
    /// Number of the area that dresses it, from 0.
    pub area: usize,
}

/// What a job says of its strokes.
#[derive(Clone, Debug)]
pub struct StrokeChoice {
    /// The dressers; the first is that of the setup.
    pub dressers: Vec<GivenDresser>,
    /// Active areas.
    pub areas: Vec<AreaOfDresser>,
    /// Sections in ascending order; the last ends at 1.
    pub sections: Vec<DressedSection>,
    /// Overlap of neighbouring strokes, mm.
    pub overlap: f64,
}

/// Share of the used profile by which the outer sections go beyond it: the contact moves with the modification.
const CONTINUED: f64 = 0.05;

impl StrokeLayout {
    /// Puts the dressers onto the worm and divides its profile.
    ///
    /// # Errors
    /// [`GeneratingError::NotDressed`]; dressers without conjugate; those of [`ActiveArea::new`] and [`divide`].
    pub fn new(setup: &GrindingSetup, choice: &StrokeChoice) -> Result<Self, GeneratingError> {
        let first = setup.dresser()?;
        let mut dressers = Vec::with_capacity(choice.dressers.len());
        for (number, given) in choice.dressers.iter().enumerate() {
            let plain = if number == 0 { first.clone() } else { beside(setup, first, &given.choice)? };
            let worms = Sides::from_fn(|flank| {
                let lines = setup.lines[flank];
                Some(IdealWorm {
                    lines,
                    shift: MotionLaw::zero(),
                    parts: Decomposition::nothing(lines.t_k),
                    carried: Carried::default(),
                    reliefs: given.carries[flank].clone(),
                    moved: None,
                    spline: None,
                    given: None,
                })
            });
            dressers.push(with_profiles(&plain, &worms));
        }
        let strokes = Sides::try_from_fn(|flank| places(&dressers, choice, flank))?;
        let profile = first.flanks.map(|_, dresser| {
            let range = dresser.range;
            let beyond = CONTINUED * range.length();
            let tip = dresser.worm.length_of_roll(setup.largest_tip_radius).unwrap_or(0.0);
            [range.w_nf - beyond, (range.w_na + beyond).min(tip)]
        });
        let tip_radii = choice.dressers.iter().map(|given| 0.5 * given.choice.tip_diameter).collect();
        Ok(Self { dressers, tip_radii, strokes, profile })
    }
}

/// Another dresser of the same worm: it stands as the first one does, at its own distance.
fn beside(
    setup: &GrindingSetup,
    first: &DresserTool,
    choice: &DresserChoice,
) -> Result<DresserTool, GeneratingError> {
    let worm = &setup.pair.worm;
    let (_, chains) = dressing_place(choice, worm, setup.worm_root_radius);
    Ok(DresserTool::conjugate(worm, chains, Sides::from_fn(|flank| first.flanks[flank].range))?)
}

/// The strokes of one flank.
fn places(
    dressers: &[DresserTool],
    choice: &StrokeChoice,
    flank: Flank,
) -> Result<Vec<StrokePlace>, GeneratingError> {
    let mut areas = Vec::with_capacity(choice.areas.len());
    for area in &choice.areas {
        let tool = dressers.get(area.dresser).ok_or(GeneratingError::NotDressed)?;
        let part = ActiveArea::of_shares(&tool.flanks[flank], [area.from, area.to], choice.overlap)?;
        areas.push((area.dresser, tool, part));
    }
    let mut sections = Vec::with_capacity(choice.sections.len());
    let mut numbers = Vec::with_capacity(choice.sections.len());
    let mut start = WidthLaw::constant(-CONTINUED);
    for (k, section) in choice.sections.iter().enumerate() {
        let &(dresser, tool, area) = areas.get(section.area).ok_or(GeneratingError::NotDressed)?;
        let range = tool.flanks[flank].range;
        let continued = if k + 1 == choice.sections.len() { CONTINUED } else { 0.0 };
        let end = section.to + WidthLaw::constant(continued);
        let on_worm = |share: WidthLaw| share.times(range.length()) + WidthLaw::constant(range.w_nf);
        sections.push(MovingSection { tool, area, range: [on_worm(start), on_worm(end)] });
        numbers.push((dresser, area));
        start = end;
    }
    let place = |(section, laws): (usize, [WidthLaw; 2])| {
        let (dresser, area) = numbers[section];
        let moves = laws.iter().any(|law| !law.is_constant());
        StrokePlace { dresser, area, range: laws.map(|law| law.value(0.0)), over_face: moves.then_some(laws) }
    };
    Ok(divide_moving(&sections, flank, choice.overlap)?.into_iter().map(place).collect())
}
