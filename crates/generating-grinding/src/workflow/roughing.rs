//! Whether a roughing stroke that shifts by a ratio of its own stays above the finished flank. The worm's lines then lie elsewhere on the
//! gear: the stroke leaves another twist, which the stock that it is to leave has to cover.

use super::execution::{ExecutedTool, Execution};
use super::prepare::Prepared;
use super::programs::StrokeLaw;
use super::programs::work::levers_of;
use contact::{ContactSolution, StandOff};
use dressing::DressedWorm;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::GeneratingMotion;
use generating::PlanningGrid;
use verdict::{Remark, Verdict};

/// One flank after a roughing stroke.
struct Roughed {
    /// Number of the stroke, from 1.
    stroke: usize,
    flank: Flank,
    /// What the stroke is to leave, mm.
    left: f64,
    /// Least height over the finished flank, mm; why it is not known otherwise.
    least: Result<f64, String>,
}

/// Judges each roughing stroke with a shift of its own by the exact contact of the worm as it is dressed.
pub fn judge_roughing(verdict: &mut Verdict, prepared: &Prepared, execution: &Execution) {
    for Roughed { stroke, flank, left, least } in roughed(prepared, execution) {
        let listed = (stroke - 1) % prepared.technology.strokes_of_a_pass();
        let item = format!("{flank} flank after stroke {stroke}, which shifts by a ratio of its own");
        match least {
            Ok(least) => {
                let detail = if least >= 0.0 {
                    format!("{:.2} µm or more above the finished flank", 1e3 * least)
                } else {
                    format!("up to {:.2} µm below the finished flank", -1e3 * least)
                };
                verdict.judge(item, least >= 0.0, detail, || {
                    Remark::new(
                        "roughing-below-finished",
                        format!(
                            "stroke {stroke} goes {:.2} um below the finished {flank} flank: its shift leaves another twist than the plan, more than the {:.1} um that it is to leave",
                            -1e3 * least,
                            1e3 * left
                        ),
                        format!(
                            "leave {:.1} um or more (technology.strokes[{}].left_um), or leave its shift.ratio out",
                            1e3 * (left - least).max(0.0),
                            listed
                        ),
                    )
                });
            }
            Err(error) => verdict.owe(
                item,
                Remark::new(
                    "roughing-not-judged",
                    format!("what stroke {stroke} leaves on the {flank} flank is not known: {error}"),
                    "leave its shift.ratio out, or take a ratio nearer to that of the plan",
                ),
            ),
        }
    }
}

fn roughed(prepared: &Prepared, execution: &Execution) -> Vec<Roughed> {
    let own: Vec<_> = (prepared.technology.strokes.iter().enumerate())
        .filter(|(_, stroke)| !stroke.finishes())
        .filter_map(|(k, stroke)| match &stroke.shift {
            StrokeLaw::Own(law) => Some((k, stroke, law)),
            StrokeLaw::Planned => None,
        })
        .collect();
    if own.is_empty() {
        return Vec::new();
    }
    let setup = &prepared.setup;
    let (profile_points, helix_points) = prepared.rules.grid();
    let grid = PlanningGrid::new(setup, profile_points, helix_points);
    let of = |flank: Flank, motion: &GeneratingMotion| flank_of(prepared, execution, (flank, &grid), motion);
    let finished = Sides::from_fn(|flank| of(flank, &execution.motion));
    let mut found = Vec::new();
    for (k, stroke, law) in own {
        let mut motion = execution.motion.clone();
        let ground: Vec<Flank> =
            stroke.ground.flanks().filter(|&flank| execution.flanks[flank].is_some()).collect();
        let infeed = StandOff::of_ground(levers_of(setup, &ground), stroke.left);
        motion.delta_d = motion.delta_d.raised(infeed.delta_d);
        motion.delta_phi_2 = motion.delta_phi_2.raised(infeed.delta_phi_2);
        motion.shift = law.clone();
        for &flank in &ground {
            let height = || {
                let finished = finished[flank].as_ref().map_err(Clone::clone)?;
                let roughed = of(flank, &motion)?;
                let apart = roughed.iter().zip(finished).map(|(above, below)| above.f_n - below.f_n);
                Ok(apart.fold(f64::INFINITY, f64::min))
            };
            found.push(Roughed { stroke: k + 1, flank, left: stroke.left[flank], least: height() });
        }
    }
    found
}

/// The flank that the worm of a run leaves under a motion.
fn flank_of(
    prepared: &Prepared,
    execution: &Execution,
    (flank, grid): (Flank, &PlanningGrid),
    motion: &GeneratingMotion,
) -> Result<Vec<ContactSolution>, String> {
    let setup = &prepared.setup;
    let executed = execution.flanks[flank].as_ref().ok_or("it is not ground")?;
    let found = match (&executed.tool, &execution.dresser) {
        (ExecutedTool::Dressed(dressing), Some(dresser)) => {
            grid.ground(setup, flank, motion, &DressedWorm::new(dresser, flank, &dressing.corrections))
        }
        (ExecutedTool::Made(made), _) => grid.ground(setup, flank, motion, &made.surface(setup, flank)),
        _ => return Err("the worm is dressed in strokes".into()),
    };
    found.map_err(|error| error.to_string())
}
