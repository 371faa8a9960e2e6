//! `dressing.conditions` and `degrees_of_freedom` of a job as the four rows of its dressing motion, and where they lay a dresser that
//! exists. Knows no plan.

use super::PlanningRules;
use crate::job::{
    Condition, ConditionOf, ConditionWord, DegreeOfFreedom, Dressing, DressingFlanks, FixedCondition, Job,
};
use crate::workflow::generating_finding;
use dressing::{RowAlong, RowSet, WidthLaw};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::MotionLaw;
use foundation::modification::Modification;
use generating::{
    DressingRows, FeedLaw, FlankLines, FlankTarget, GeneratingError, GrindingSetup, MovedProfile,
};
use job::checks::contradiction;
use run::RunFailure;
use std::sync::Arc;

/// The rows; their number has been checked.
pub(super) fn rows_of_job(dressing: &Dressing, axial_pitch: f64) -> DressingRows {
    let two = dressing.flanks == DressingFlanks::Two;
    if two && dressing.has_usual_conditions() {
        return DressingRows::BothFlanks(RowSet::exact(RowAlong::two_points_on_each_flank()));
    }
    let mut rows = Vec::new();
    for condition in &dressing.conditions {
        match condition {
            Condition::Word(word) => rows.extend(of_word(*word).into_iter().map(|row| (row, None))),
            Condition::Of(condition) => rows.push((of_table(condition, axial_pitch), condition.weight())),
        }
    }
    rows.extend(dressing.fixed().into_iter().map(|axis| (RowAlong::fixed(number(axis)), None)));
    let rows = RowSet::weighed(&rows).unwrap_or_else(|| RowSet::exact(RowAlong::three_points_with_map()));
    if two { DressingRows::BothFlanks(rows) } else { DressingRows::Alone(rows) }
}

/// Index of a component in the correction vector.
fn number(axis: DegreeOfFreedom) -> usize {
    DegreeOfFreedom::ALL.iter().position(|other| *other == axis).unwrap_or(0)
}

/// The rows of a word; components that keep their nominal value follow from [`Dressing::fixed`].
fn of_word(word: ConditionWord) -> Vec<RowAlong> {
    let points = |count: usize| (0..count).map(|k| RowAlong::point(k as f64 / (count - 1) as f64)).collect();
    match word {
        ConditionWord::ThreePoint => points(3),
        ConditionWord::FourPoint => points(4),
        ConditionWord::RadiusMap => vec![RowAlong::map_of_upper_end()],
        ConditionWord::Head => vec![RowAlong::Head { position: 0.0, above: WidthLaw::constant(0.0) }],
        ConditionWord::FixPhiS | ConditionWord::FixGamma | ConditionWord::FixD | ConditionWord::FixVy => {
            Vec::new()
        }
    }
}

fn of_table(condition: &ConditionOf, axial_pitch: f64) -> RowAlong {
    match condition {
        ConditionOf::Point(point) => RowAlong::Point { flank: point.flank, at: point.at.law(1.0) },
        ConditionOf::Map(map) => {
            RowAlong::Map { flank: map.flank, dresser: map.dresser.law(1.0), at: map.at.law(1.0) }
        }
        ConditionOf::Stretch(stretch) => {
            RowAlong::Stretch { flank: stretch.flank, stretch: stretch.percent.law(0.01) }
        }
        ConditionOf::Head(head) => RowAlong::Head {
            position: head.position + f64::from(head.thread) * axial_pitch,
            above: head.above_um.law(1e-3),
        },
        ConditionOf::Fixed(FixedCondition { axis, deg, mm, .. }) => {
            let angle = deg.as_ref().map(|law| law.law(1f64.to_radians()));
            let length = mm.as_ref().map(|law| law.law(1.0));
            RowAlong::Fixed { j: number(*axis), x: angle.or(length).unwrap_or(WidthLaw::constant(0.0)) }
        }
    }
}

/// Where the profile of a dresser that exists is laid on the flanks.
pub(super) struct DresserPlaces {
    moved: Sides<Option<Arc<MovedProfile>>>,
    shift: MotionLaw,
}

impl DresserPlaces {
    /// Where it was designed for.
    pub fn designed() -> Self {
        Self { moved: Sides { left: None, right: None }, shift: MotionLaw::zero() }
    }

    /// The target of a flank less what the dresser makes of it.
    ///
    /// # Errors
    /// Evaluation errors of the modifications over their fields.
    pub fn target(
        &self,
        lines: &FlankLines,
        wanted: Modification,
        made: Modification,
    ) -> Result<FlankTarget, GeneratingError> {
        let Some(moved) = &self.moved[lines.flank()] else {
            return FlankTarget::with_given_dresser(wanted, made);
        };
        let place = |w: f64, z: f64| {
            let (w_1, z_1) = lines.worm_point(w, z, &self.shift);
            lines.work_roll(moved.own_roll(w_1, z_1))
        };
        FlankTarget::with_moved_dresser(wanted, made, moved.clone(), &place)
    }
}

/// Where the conditions of a job lay its dresser.
///
/// # Errors
/// [`RunFailure`]: a finding on `dressing.conditions` where they move the profile of the dresser on other bodies than cylinders or under a
/// shift that is not known before the plan; conditions that cannot be met.
pub(super) fn places_of_job(
    setup: &GrindingSetup,
    rows: DressingRows,
    rules: &PlanningRules,
    job: &Job,
) -> Result<DresserPlaces, RunFailure> {
    const FIELD: &str = "dressing.conditions";
    if !MovedProfile::is_asked_by(&rows) {
        return Ok(DresserPlaces::designed());
    }
    let refuse = |value: &str, allowed: &str, way_out: &str| {
        let message = "the conditions move the profile of the dresser that exists along the worm's";
        Err(RunFailure::bad_input(contradiction(message, FIELD, value.into(), allowed, way_out)))
    };
    if !(setup.pair.worm.is_cylindrical() && setup.pair.work.is_cylindrical()) {
        return refuse(
            "a conical worm or gear",
            "a cylindrical worm and gear, or conditions that leave the profile in its place",
            "leave maps and stretch out, or let the dresser be made for the target",
        );
    }
    let Some(ratio) = rules.known_ratio() else {
        return refuse(
            "a diagonal ratio that the plan chooses",
            "grinding.diagonal_ratio as a number, or grinding.method = \"radial\"",
            "give the diagonal ratio: it says what of the gear which place of the worm grinds",
        );
    };
    let which: Vec<Flank> =
        Flank::BOTH.into_iter().filter(|&flank| job.grinding.flanks.includes(flank)).collect();
    let shift = FeedLaw::Ratio(ratio).law(setup, &which);
    let moved = MovedProfile::of_rows(setup, rows, &shift, &which)
        .map_err(|e| generating_finding::on_field(&e, FIELD))?;
    Ok(DresserPlaces { moved: moved.map(|_, moved| moved.clone().map(Arc::new)), shift })
}
