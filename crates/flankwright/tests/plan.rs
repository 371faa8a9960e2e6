//! Plans of the example jobs.
use flankwright::exchange::read_job;
use flankwright::geometry::Flank;
use flankwright::workflow::prepare;

fn try_plan(name: &str) {
    let path = std::path::PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples")).join(name);
    let loaded = read_job(&path).unwrap();
    let prepared = prepare(&loaded).map_err(|e| format!("{:?}", e.0)).unwrap();
    println!(
        "{name}: d {} gamma {} tan rho1 {:?} root_cut {} tip_short {} root {}",
        prepared.setup.pair.chain.centre_distance,
        prepared.setup.pair.chain.crossed_axes_angle.to_degrees(),
        prepared.setup.dressed_direction,
        prepared.setup.root_cut,
        prepared.setup.tip_short,
        prepared.setup.worm_root_radius
    );
    let task = prepared.task(&loaded.job);
    let t0 = std::time::Instant::now();
    let plan = task.plan();
    println!("took {:?}", t0.elapsed());
    let plan = plan.unwrap();
    println!(
        "K {} {:?} stars {:?} place {:?}",
        plan.choice.ratio, plan.choice.reason, plan.choice.lead_correction, plan.choice.place
    );
    for c in &plan.choice.candidates {
        println!(
            "  cand {} {} {} {} {}",
            c.ratio,
            c.dressing_share,
            c.delta_d_share,
            c.occupation,
            c.error * 1e3
        );
    }
    println!("failed {:?}", plan.choice.failed);
    println!("occ {:?} zv01 {}", plan.ideal.occupation, plan.ideal.shift_origin);
    println!(
        "ideal {:?}\ndressed {:?} det {}",
        plan.ideal_error_by_round, plan.dressed_error_by_round, plan.determinant
    );
    for flank in Flank::BOTH {
        let f = plan.flanks[flank].as_ref().unwrap();
        let e = f.target.iter().zip(&f.planned).map(|(t, p)| (t - p.f_n).abs()).fold(0.0, f64::max);
        let it: f64 = f.planned.iter().map(|p| p.iterations as f64).sum::<f64>() / f.planned.len() as f64;
        println!("{flank}: max error {} um, mean iterations {it}", e * 1e3);
        for n in f.dressed.nodes.iter().step_by(8) {
            println!(
                "   v {} dk {} {} {} {}",
                n.v,
                n.dk[0].to_degrees(),
                n.dk[1].to_degrees(),
                n.dk[2],
                n.dk[3]
            );
        }
    }
}

#[test]
fn twist_free() {
    try_plan("twist-free-crowning.toml");
}
#[test]
fn bias() {
    try_plan("automotive-bias.toml");
}
#[test]
fn radial() {
    try_plan("radial-feed-crowning.toml");
}
