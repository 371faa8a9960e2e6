//! Technology beside a plan of the examples in `examples/cycles`: seconds of stock, strokes, load of the worm, times and figures; of the cycles
//! within the shop's limits (standard, fastest, time over the load); and of the plan itself. Medians of several runs in one process.
//!
//! `cargo bench -p flankwright-generating-grinding --bench technology -- [RUNS]`; 5 runs where no number is given.

use foundation::numerics::Silent;
use generating_grinding::job::Job;
use generating_grinding::workflow::plan_job;
use job::read_job_of;
use std::error::Error;
use std::path::Path;

/// Stages of a run that are shown.
const STAGES: [&str; 3] = ["stock and strokes", "cycles within the limits", "plan"];
/// Constant stock, then blanks on which every tooth space has its own.
const EXAMPLES: [&str; 5] = ["ev-gear", "spur-gear", "planet-gear", "truck-gear", "measured-blank"];

fn main() -> Result<(), Box<dyn Error>> {
    let runs = std::env::args().skip(1).find_map(|argument| argument.parse().ok()).unwrap_or(5_usize).max(1);
    println!("{:<16}{:>20}{:>26}{:>12}", "example", STAGES[0], STAGES[1], STAGES[2]);
    for name in EXAMPLES {
        let file = format!("{}/../../examples/cycles/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        let loaded = read_job_of::<Job>(Path::new(&file))?;
        let mut seconds = STAGES.map(|_| Vec::new());
        for _ in 0..runs {
            let outcome = plan_job(&loaded, &Silent).map_err(|failure| format!("{name}: {failure:?}"))?;
            for (stage, list) in STAGES.iter().zip(&mut seconds) {
                list.push(outcome.result.timing_s.get(stage).copied().ok_or("a stage without time")?);
            }
        }
        let [technology, cycles, plan] = seconds.map(|mut list| {
            list.sort_by(f64::total_cmp);
            1e3 * list[list.len() / 2]
        });
        println!("{name:<16}{technology:>17.1} ms{cycles:>23.1} ms{plan:>9.1} ms");
    }
    Ok(())
}
