//! Contradictions between entries of a job of measuring a skiving tool that are each in range. Knows the job, no geometry beyond the
//! order of sizes.

use super::{MachineSetting, RakeForm, Senses, SkivingJob, ToolKinematics};
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
    shaping(job, &mut findings);
    beam(job, &mut findings);
    measuring(job, &mut findings);
    tool_errors(job, &mut findings);
    calibration(job, &mut findings);
    carrier(job, &mut findings);
    workpiece_probe(job, &mut findings);
    runout(job, &mut findings);
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
    let by_tooth = matches!(rake.form, RakeForm::Plane | RakeForm::Variable);
    if !by_tooth && rake.step_angle_deg != 0.0 {
        findings.push(contradiction(
            "only planes and variable faces are ground tooth by tooth with a step",
            "skiving_tool.rake.step_angle_deg",
            shown_number(rake.step_angle_deg),
            "0 beside form = \"cone\" or \"sphere\"",
            "leave the step angle out, or give form = \"plane\"",
        ));
    }
    for (key, change) in rake.changes() {
        if rake.form != RakeForm::Variable && change != 0.0 {
            findings.push(contradiction(
                "only a variable rake face changes its angle over the tooth",
                format!("skiving_tool.rake.{key}"),
                shown_number(change),
                "no key but beside form = \"variable\"",
                "leave the change out, or give form = \"variable\"",
            ));
        }
    }
    if rake.form == RakeForm::Variable && rake.changes().iter().all(|(_, change)| *change == 0.0) {
        findings.push(contradiction(
            "a variable rake face that does not change is a plane",
            "skiving_tool.rake.form",
            "\"variable\"".into(),
            "\"variable\" beside a change over the tooth",
            "give one of height_deg_per_mm, height_deg_per_mm2, hollow_deg_per_mm, twist_deg_per_mm, or form = \"plane\"",
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

fn shaping(job: &SkivingJob, findings: &mut Vec<Diagnostic>) {
    if job.skiving.kinematics != ToolKinematics::Shaping {
        return;
    }
    if let Some(angle) = job.skiving.crossed_axes_angle_deg.filter(|angle| *angle != 0.0) {
        findings.push(contradiction(
            "the axis of a shaping cutter is parallel to the workpiece's",
            "skiving.crossed_axes_angle_deg",
            shown_number(angle),
            "0, or no key, beside kinematics = \"shaping\"",
            "leave the crossed-axes angle out, or let the tool skive",
        ));
    }
    let settings = &job.evaluation.settings;
    if let Some(number) = settings.iter().position(|one| *one == MachineSetting::CrossedAxesAngle) {
        findings.push(contradiction(
            "a shaping machine has no crossed-axes angle that a correction could change",
            format!("evaluation.settings[{number}]"),
            "\"crossed-axes-angle\"".into(),
            "\"centre-distance\", \"tool-angle\", \"tool-shift\" beside kinematics = \"shaping\"",
            "give settings = [\"centre-distance\", \"tool-angle\"]",
        ));
    }
}

/// Tilt beyond which an upright mandrel does not tell where a beam lies, degrees.
const STEEPEST: f64 = 60.0;

fn beam(job: &SkivingJob, findings: &mut Vec<Diagnostic>) {
    let barrier = &job.light_barrier;
    let vector =
        |[x, y, z]: [f64; 3]| format!("[{}, {}, {}]", shown_number(x), shown_number(y), shown_number(z));
    if let Some(direction) = barrier.direction {
        if direction == [0.0; 3] {
            findings.push(contradiction(
                "the beam has no direction",
                "light_barrier.direction",
                vector(direction),
                "a vector that is not 0",
                "give x, y, z of a vector along the beam, or the tilts of a beam that rises",
            ));
            return;
        }
        for (key, tilt) in [("tilt_x_deg", barrier.tilt_x_deg), ("tilt_y_deg", barrier.tilt_y_deg)] {
            if tilt != 0.0 {
                findings.push(contradiction(
                    "the direction of the beam is given twice",
                    format!("light_barrier.{key}"),
                    shown_number(tilt),
                    "no key beside `direction`",
                    "leave the tilt or `direction` out",
                ));
            }
        }
    }
    let steep = match barrier.tilts_deg() {
        Some(tilts) => tilts.into_iter().any(|tilt| tilt.abs() > STEEPEST),
        None => true,
    };
    if steep && job.calibration.is_some() {
        let (key, value) = match barrier.direction {
            Some(direction) => ("direction", vector(direction)),
            None if barrier.tilt_x_deg.abs() > STEEPEST => ("tilt_x_deg", shown_number(barrier.tilt_x_deg)),
            None => ("tilt_y_deg", shown_number(barrier.tilt_y_deg)),
        };
        findings.push(contradiction(
            "an upright mandrel does not calibrate a beam that lies down",
            format!("light_barrier.{key}"),
            value,
            "a beam that rises, tilted by 60 deg at most, beside [calibration]",
            "leave [calibration] out, and give point and direction as they were measured otherwise",
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
    // Driven in along X it must still be dark where the approach ends.
    if given.reach > given.radius {
        findings.push(contradiction(
            "the mandrel would be driven through the beam where it is to end in it",
            "calibration.reach",
            shown_number(given.reach),
            &format!("at most the radius of the mandrel, {}", shown_number(given.radius)),
            "take a thicker mandrel, or give the beam more closely and a smaller reach",
        ));
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

fn workpiece_probe(job: &SkivingJob, findings: &mut Vec<Diagnostic>) {
    let Some(given) = &job.workpiece_probe else { return };
    let gaps = job.gear.teeth.unsigned_abs() as usize;
    for (k, gap) in given.gaps.iter().enumerate().filter(|(_, gap)| **gap >= gaps) {
        findings.push(contradiction(
            "the workpiece has no such tooth space",
            format!("workpiece_probe.gaps[{k}]"),
            gap.to_string(),
            &format!("0 to {}", gaps.saturating_sub(1)),
            "tooth spaces count from 0",
        ));
    }
    if let (Some(file), Some(_)) = (&given.readings, &given.setting_errors) {
        findings.push(contradiction(
            "values of a real workpiece stand beside errors of a machine that is simulated",
            "workpiece_probe.readings",
            format!("{file:?}"),
            "`readings` or `setting_errors`",
            "leave one of the keys out",
        ));
    }
    if given.height.abs() > 0.5 * job.gear.face_width {
        findings.push(contradiction(
            "the probe would scan beside the face",
            "workpiece_probe.height",
            shown_number(given.height),
            &format!("-{0} to {0}, half of the face width", shown_number(0.5 * job.gear.face_width)),
            "give a place within the face, 0 in its middle",
        ));
    }
}

fn carrier(job: &SkivingJob, findings: &mut Vec<Diagnostic>) {
    let Some(given) = job.machine.as_ref().and_then(|machine| machine.carrier.as_ref()) else { return };
    let (turns, slides) = ([given.measuring_deg, given.parked_deg], [given.measuring, given.parked]);
    let complete = |pair: [Option<f64>; 2]| pair.iter().all(Option::is_some);
    let absent = |pair: [Option<f64>; 2]| pair.iter().all(Option::is_none);
    if !((complete(turns) && absent(slides)) || (complete(slides) && absent(turns))) {
        let count = turns.iter().chain(&slides).flatten().count();
        findings.push(contradiction(
            "a carrier has one place in which it measures and one in which it is parked",
            "machine.carrier",
            format!("{count} places"),
            "measuring_deg and parked_deg, or measuring and parked",
            "give both angles of a carrier that swivels, or both positions of one that slides",
        ));
    }
}

fn runout(job: &SkivingJob, findings: &mut Vec<Diagnostic>) {
    let Some(given) = &job.runout else { return };
    let teeth = job.skiving_tool.teeth as usize;
    if 4 * given.orders > teeth {
        findings.push(contradiction(
            "the teeth do not tell so many orders",
            "runout.orders",
            given.orders.to_string(),
            &format!("1 to {}, a quarter of the teeth", teeth / 4),
            "give fewer orders; 1 answers an eccentric tool",
        ));
    }
    if given.stroke.is_some() && job.skiving.kinematics == ToolKinematics::Shaping {
        findings.push(contradiction(
            "a shaping cutter makes no skiving stroke",
            "runout.stroke",
            "a table".into(),
            "no key beside skiving.kinematics = \"shaping\"",
            "leave `stroke` out; the law itself stands in the result",
        ));
    }
    if given.stroke.is_some() && job.machine.is_none() {
        findings.push(contradiction(
            "a stroke is wanted as a program, and no machine is given",
            "runout.stroke",
            "a table".into(),
            "no key, or a table [machine] with `file`",
            "add `[machine]` and `output.programs`, or leave `stroke` out",
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
