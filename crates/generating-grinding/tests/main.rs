//! Tests of the crate through its public interface, in one program. Its modules are the tests, and what several of them share.

mod areas;
mod best_fit;
mod catalogue_plans;
mod changes;
#[path = "../../generating/tests/cylindrical_pair/mod.rs"]
mod cylindrical_pair;
mod deviations;
mod economy;
mod explore;
mod judged_traces;
mod line_dressing_job;
mod measured_worm;
mod page;
mod plan;
mod plan_bodies;
mod program_areas;
mod removal;
mod stroke_plans;
mod targets;
mod truck_gear;
mod verdicts;
mod wanted_worm;
mod weighed_conditions;
mod worm_life;
