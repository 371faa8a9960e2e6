//! One worm over its life: every diameter with the dresser of the new worm.

use foundation::geometry::Flank;
use foundation::numerics::Silent;
use generating_grinding::job::{AxisLimits, DresserModification, LoadedJob, WormLifeStudy};
use generating_grinding::workflow::{plan_job, study_worm_life};
use job::read_job_of;
use run::{RunFailure, TaskOutcome};
use std::path::PathBuf;
use verdict::Status;

fn load() -> LoadedJob {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples/worm-life.toml");
    let mut loaded: LoadedJob = read_job_of(&path).unwrap();
    (loaded.job.grid.profile_points, loaded.job.grid.helix_points) = (5, 5);
    loaded
}

#[test]
fn diameters_are_planned_with_the_dresser_of_the_new_worm() {
    let loaded = load();
    let study = WormLifeStudy { last_tip_diameter: 220.0, count: 2 };
    let life = study_worm_life(&loaded, study, &Silent).unwrap();
    assert!(life.whole_life && life.last_usable_tip_diameter_mm == Some(220.0));
    let [new, worn] = life.worms.as_slice() else { panic!("{:?}", life.worms) };
    // The first one is the plan of the job itself.
    let mut plain = loaded.clone();
    plain.job.explore = None;
    let plan = plan_job(&plain, &Silent).unwrap();
    let of_new = new.plan.as_ref().unwrap();
    assert_eq!(of_new.settings, plan.result.settings.settings);
    // A smaller worm takes less centre distance by half of what it lost, and stands steeper.
    let of_worn = worn.plan.as_ref().unwrap();
    assert_eq!(of_worn.status, Status::Met);
    assert!((of_new.centre_distance_mm - of_worn.centre_distance_mm - 15.0).abs() < 1e-9);
    assert!((of_new.worm_pitch_diameter_mm - of_worn.worm_pitch_diameter_mm - 30.0).abs() < 1e-9);
    assert!(of_worn.worm_speed_rpm / of_new.worm_speed_rpm > 1.13);
    // The dresser is the same: its profile stands in the settings of both. It was made for the new worm and no longer fits by itself.
    let middle = |plan: &generating_grinding::workflow::PlanOfLife| plan.dressing[Flank::Left].unwrap();
    assert!(middle(of_new).d_gamma_deg.abs() < 0.01 && middle(of_worn).d_gamma_deg.abs() > 0.1);
    // A dresser that was made for the worn worm has another profile and needs no such correction.
    let mut own = plain;
    (own.job.worm.tip_diameter, own.job.worm.pitch_diameter) = (Some(220.0), None);
    let own = plan_job(&own, &Silent).unwrap();
    let dressing = own.execution.flanks.left.as_ref().unwrap().dressing().unwrap();
    let [from, to] = dressing.driven;
    assert!(dressing.corrections[1].value(0.5 * (from + to)).to_degrees().abs() < 0.01);
    assert!(life.headline().contains("220.00 mm") && life.summary(&[], 0).contains("met"));
}

/// The end of the life is found between the last diameter that meets the target and the first that does not.
#[test]
fn the_last_usable_diameter_lies_between_two_that_were_planned() {
    let mut loaded = load();
    // The dresser is settled on smaller worms by an offset, which this machine does not have.
    loaded.job.grinding.axis_limits = Some(AxisLimits { d_v_ya_mm: Some(2.0), ..AxisLimits::default() });
    let study = WormLifeStudy { last_tip_diameter: 210.0, count: 3 };
    let life = study_worm_life(&loaded, study, &Silent).unwrap();
    assert!(!life.whole_life);
    let last = life.last_usable_tip_diameter_mm.unwrap();
    assert!(life.worms.windows(2).all(|pair| pair[0].tip_diameter_mm > pair[1].tip_diameter_mm));
    assert!(
        life.worms.iter().all(|worm| worm.is_met() == (worm.tip_diameter_mm >= last)),
        "{:?}",
        life.headline()
    );
    let next = life.worms.iter().map(|worm| worm.tip_diameter_mm).filter(|d| *d < last).fold(0.0, f64::max);
    assert!(last - next < 20.0 / 32.0 + 1e-9, "{last} {next}");
    let ends = life.worms.iter().find(|worm| !worm.is_met()).unwrap();
    let why = ends.plan.as_ref().and_then(|plan| plan.reason.as_ref()).map(|reason| reason.text.clone());
    assert!(why.or(ends.refused.as_ref().map(|refused| refused.text.clone())).is_some());
}

#[test]
fn a_life_that_cannot_be_names_its_key() {
    let study = WormLifeStudy { last_tip_diameter: 250.0, count: 3 };
    let Err(RunFailure::BadInput(finding)) = study_worm_life(&load(), study, &Silent) else { panic!() };
    assert_eq!(finding.field.as_deref(), Some("explore.worm_life.last_tip_diameter"));
    assert!(finding.to_string().contains("250"), "{finding}");
}

/// A dresser that is there already stays what it is.
#[test]
fn a_given_dresser_is_taken_as_it_is() {
    let mut loaded = load();
    loaded.job.dresser.as_mut().unwrap().modification =
        DresserModification::Rule(generating_grinding::job::FixedDresser::None);
    let study = WormLifeStudy { last_tip_diameter: 235.0, count: 2 };
    let life = study_worm_life(&loaded, study, &Silent).unwrap();
    assert!(life.worms.iter().all(|worm| worm.plan.is_some()));
    let profile = &life.worms[1].plan.as_ref().unwrap().settings.left.as_ref().unwrap().profile_um;
    assert!(profile.iter().all(|c| *c == 0.0), "{profile:?}");
}
