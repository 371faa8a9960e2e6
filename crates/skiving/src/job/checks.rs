//! Contradictions between entries of a job of measuring a skiving tool that are each in range. Knows the job, no geometry beyond the
//! order of sizes.

use super::{RakeForm, Senses, SkivingJob};
use crate::history::{MOMENT, is_moment};
use job::checks::{contradiction, drawing, name, not_yet};
use job::{Diagnostic, Problem, shown_number};

/// All contradictions in a job; without places, which the caller knows.
pub(crate) fn check(job: &SkivingJob) -> Vec<Diagnostic> {
    let mut findings = Vec::new();
    name(&job.job, &mut findings);
    drawing(&job.gear, &mut findings);
    workpiece(job, &mut findings);
    rake(job, &mut findings);
    edge(job, &mut findings);
    measuring(job, &mut findings);
    tool_errors(job, &mut findings);
    calibration(job, &mut findings);
    teeth_of_stylus(job, &mut findings);
    uses(job, &mut findings);
    findings
}

fn workpiece(job: &SkivingJob, findings: &mut Vec<Diagnostic>) {
    let gear = &job.gear;
    if gear.cone_angle_deg != 0.0 {
        findings.push(
            not_yet("gear.cone_angle_deg", "skiving of gears with a cone angle")
                .value(shown_number(gear.cone_angle_deg))
                .allowed("0")
                .way_out("leave the cone angle out"),
        );
    }
    if gear.teeth.abs() < 3 {
        findings.push(
            Diagnostic::new(Problem::InvalidGeometry, "a workpiece with less than three teeth")
                .field("gear.teeth")
                .value(gear.teeth)
                .allowed("3 or more, -3 or less for an internal gear")
                .way_out("give the number of teeth of the drawing"),
        );
    }
}

fn edge(job: &SkivingJob, findings: &mut Vec<Diagnostic>) {
    let tool = &job.skiving_tool;
    let chamfered = tool.rake_chamfer.is_some() || tool.clearance_chamfer_angle_deg != 0.0;
    if tool.edge_radius == 0.0 && chamfered {
        findings.push(contradiction(
            "a sharp edge has no chamfers beside its rounding",
            "skiving_tool.edge_radius",
            shown_number(0.0),
            "> 0 beside chamfers",
            "give the radius of the rounding, or leave the chamfers out",
        ));
    }
}

fn rake(job: &SkivingJob, findings: &mut Vec<Diagnostic>) {
    let rake = &job.skiving_tool.rake;
    if rake.form != RakeForm::Plane && rake.step_angle_deg != 0.0 {
        findings.push(contradiction(
            "only planes are ground tooth by tooth with a step",
            "skiving_tool.rake.step_angle_deg",
            shown_number(rake.step_angle_deg),
            "0 beside form = \"cone\" or \"sphere\"",
            "leave the step angle out, or give form = \"plane\"",
        ));
    }
    if rake.form == RakeForm::Sphere && rake.angle_deg <= 0.0 {
        findings.push(contradiction(
            "a hollow sphere has a rake angle above 0",
            "skiving_tool.rake.angle_deg",
            shown_number(rake.angle_deg),
            "> 0 beside form = \"sphere\"",
            "give a rake angle above 0, or another form",
        ));
    }
}

fn measuring(job: &SkivingJob, findings: &mut Vec<Diagnostic>) {
    let tracks = &job.measuring.tracks;
    for (k, pair) in tracks.windows(2).enumerate().filter(|(_, pair)| pair[0] >= pair[1]) {
        findings.push(contradiction(
            "the tracks do not ascend",
            format!("measuring.tracks[{}]", k + 1),
            shown_number(pair[1]),
            &format!("> {}", shown_number(pair[0])),
            "give the tracks from the smaller to the larger length of roll, each once",
        ));
    }
    for (key, [least, greatest]) in job.measuring.travel.ends().filter(|(_, ends)| ends[0] >= ends[1]) {
        findings.push(contradiction(
            "the travel has no length",
            format!("measuring.travel.{key}"),
            format!("[{}, {}]", shown_number(least), shown_number(greatest)),
            "the least position before the greatest",
            "give both ends of travel, the smaller first",
        ));
    }
    let beam = job.light_barrier.radius;
    if let Some(radius) = job.evaluation.switching_radius.filter(|radius| (radius - beam).abs() > 0.5 * beam)
    {
        findings.push(contradiction(
            "the beam switches far from its radius",
            "evaluation.switching_radius",
            shown_number(radius),
            &format!(
                "{} to {}, half as much as the radius of the beam about it",
                shown_number(0.5 * beam),
                shown_number(1.5 * beam)
            ),
            "give the radius at which the calibrated beam switches, in mm",
        ));
    }
    if job.measuring.senses == Senses::Both
        && let Some(radius) = job.evaluation.switching_radius
    {
        findings.push(contradiction(
            "a measurement in both senses needs no switching radius: hysteresis drops out of it",
            "evaluation.switching_radius",
            shown_number(radius),
            "no key beside measuring.senses = \"both\"",
            "leave it out, or measure in one sense",
        ));
    }
}

fn tool_errors(job: &SkivingJob, findings: &mut Vec<Diagnostic>) {
    let Some(errors) = &job.tool_errors else { return };
    let teeth = job.skiving_tool.teeth as usize;
    let given = errors.pitch_um.len();
    if given != 0 && given != teeth {
        findings.push(contradiction(
            "the tool has another number of teeth",
            "tool_errors.pitch_um",
            format!("{given} entries"),
            &format!("{teeth} entries, one for each tooth"),
            "give one pitch deviation for each tooth",
        ));
    }
    let numbers: Vec<usize> = errors.teeth.iter().map(|one| one.tooth).collect();
    for (k, tooth) in numbers.iter().enumerate() {
        let field = format!("tool_errors.teeth[{k}].tooth");
        if *tooth >= teeth {
            findings.push(no_such_tooth(field, *tooth, teeth));
        } else if numbers[..k].contains(tooth) {
            findings.push(contradiction(
                "the tooth is given twice",
                field,
                tooth.to_string(),
                "each tooth once",
                "put its errors into one entry",
            ));
        }
    }
}

fn teeth_of_stylus(job: &SkivingJob, findings: &mut Vec<Diagnostic>) {
    let Some(stylus) = &job.stylus else { return };
    let teeth = job.skiving_tool.teeth as usize;
    for (k, tooth) in stylus.teeth.iter().enumerate().filter(|(_, tooth)| **tooth >= teeth) {
        findings.push(no_such_tooth(format!("stylus.teeth[{k}]"), *tooth, teeth));
    }
}

fn no_such_tooth(field: String, tooth: usize, teeth: usize) -> Diagnostic {
    contradiction(
        "the tool has no such tooth",
        field,
        tooth.to_string(),
        &format!("0 to {}", teeth - 1),
        "teeth count from 0",
    )
}

fn calibration(job: &SkivingJob, findings: &mut Vec<Diagnostic>) {
    let Some(given) = &job.calibration else { return };
    let switches = given.switches.len();
    match given.heights {
        Some([low, high]) if low == high => findings.push(contradiction(
            "at one height the tilt of the beam cannot be determined",
            "calibration.heights",
            format!("[{0}, {0}]", shown_number(low)),
            "two positions Z",
            "approach the beam at two heights",
        )),
        Some([low, high]) if switches > 0 => findings.push(contradiction(
            "the switches have heights of their own",
            "calibration.heights",
            format!("[{}, {}]", shown_number(low), shown_number(high)),
            "no key beside `switches`",
            "leave `heights` out",
        )),
        None if switches == 0 => findings.push(
            Diagnostic::new(
                Problem::MissingKey,
                "`calibration` does not say at which heights the beam is approached",
            )
            .field("calibration.heights")
            .allowed("two positions Z, or `switches`")
            .way_out("add e.g. heights = [140.0, 240.0], or the switches of a calibration"),
        ),
        _ => {}
    }
    if (1..5).contains(&switches) {
        findings.push(contradiction(
            "a beam has five unknowns",
            "calibration.switches",
            format!("{switches} entries"),
            "none, or 5 and more",
            "give all switches of the calibration: at each height two along Y and one along X",
        ));
    }
}

/// What needs something else.
fn uses(job: &SkivingJob, findings: &mut Vec<Diagnostic>) {
    if let (Some(_), Some(readings)) = (&job.tool_errors, &job.readings) {
        findings.push(contradiction(
            "readings of a real tool stand beside errors of one that is simulated",
            "readings.file",
            format!("{:?}", readings.file),
            "[readings] or [tool_errors]",
            "leave one of the tables out",
        ));
    }
    if let Some(history) = job.history.as_ref().filter(|history| !is_moment(&history.time)) {
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "the time of the measurement is no date and time")
                .field("history.time")
                .value(format!("{:?}", history.time))
                .allowed(MOMENT)
                .way_out("give the time with its zone"),
        );
    }
    if !job.output.programs.is_empty() && job.machine.is_none() {
        findings.push(contradiction(
            "programs are wanted, and no machine is given",
            "output.programs",
            format!("a list of {}", job.output.programs.len()),
            "no programs, or a table [machine] with `file`",
            "add `[machine]`, or leave `programs` out",
        ));
    }
}
