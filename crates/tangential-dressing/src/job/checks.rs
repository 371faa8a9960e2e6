//! Contradictions between entries of a job of tangential dressing that are each in range; what it shares with other
//! processes is checked by their code. Knows the job, no geometry beyond the order of diameters.

use super::{
    Channel, Passes, ShiftRatio, ShiftRule, TangentialDressing, TangentialExplore, TangentialJob,
    TangentialSettings, VariableRule, Variables,
};
use generating_grinding::job::checks::{ascending, existing_dresser};
use job::checks::{
    clamping_bodies, contradiction, control_of_job, dresser_diameters, every_job, falling_stock, not_yet,
    root_clearance, worm_diameters,
};
use job::tables::{Flanks, Gear};
use job::{Diagnostic, Problem, shown_number};

/// All contradictions in a job; without places, which the caller knows.
pub(crate) fn check(job: &TangentialJob) -> Vec<Diagnostic> {
    let mut findings = Vec::new();
    every_job(&job.job, &job.gear, &job.grid, &mut findings);
    bodies(&job.gear, &mut findings);
    target(job, &mut findings);
    worm_diameters(job.worm.pitch_diameter, job.worm.tip_diameter, &mut findings);
    let dresser = &job.dresser;
    dresser_diameters("dresser", dresser.pitch_diameter, dresser.tip_diameter, &mut findings);
    root_clearance(dresser.pitch_diameter, dresser.root_clearance, &mut findings);
    existing_dresser(&dresser.modification, dresser.designed_for.as_ref(), &mut findings);
    if dresser.exists() {
        profile_of_existing(&job.dressing, &mut findings);
    }
    shift(job, &mut findings);
    passes(job, &mut findings);
    excluded(&job.dressing, &mut findings);
    control_of_job(job.control.as_ref(), job.grinding.feed_per_revolution, &mut findings);
    let splines = job.dressing.splines.iter().map(|spline| spline.channel);
    spline_twice("dressing", splines, &mut findings);
    clamping_bodies(job.machine.as_ref().map_or(&[], |machine| &machine.clamping), &mut findings);
    falling_stock(job.machine.as_ref(), &mut findings);
    if let Some(explore) = &job.explore {
        varied(explore, &mut findings);
    }
    if let Some(settings) = &job.settings {
        values(settings, &mut findings);
    }
    findings
}

/// Gears that the process is worked out for.
fn bodies(gear: &Gear, findings: &mut Vec<Diagnostic>) {
    if gear.teeth < 0 {
        findings.push(
            not_yet("gear.teeth", "tangential dressing for internal gears")
                .value(gear.teeth)
                .allowed("> 0")
                .way_out("give an external gear: a worm does not reach into an internal one"),
        );
    }
}

fn target(job: &TangentialJob, findings: &mut Vec<Diagnostic>) {
    let allowed = "either `modifications = [ ... ]` or `edge_amounts = { ... }`";
    match (&job.target.modifications, &job.target.edge_amounts) {
        (None, None) => findings.push(
            Diagnostic::new(Problem::MissingKey, "`target` does not say which flank is wanted")
                .field("target.modifications")
                .allowed(allowed)
                .way_out("add `modifications`; an empty list asks for the pure involute"),
        ),
        (Some(_), Some(_)) => findings.push(contradiction(
            "the target is given twice",
            "target.edge_amounts",
            "a table beside `modifications`".into(),
            allowed,
            "keep one of them",
        )),
        _ => {}
    }
}

fn shift(job: &TangentialJob, findings: &mut Vec<Diagnostic>) {
    let grinding = &job.grinding;
    if grinding.shift_ratio == ShiftRatio::Rule(ShiftRule::Width) && grinding.shift_width.is_none() {
        findings.push(
            Diagnostic::new(
                Problem::MissingKey,
                "the ratio of the tool shift follows from its range, which is not given",
            )
            .field("grinding.shift_width")
            .allowed("the range of the tool shift in mm, or a number or \"neutral\" as shift_ratio")
            .way_out("add `shift_width`, e.g. 1.2 times the face width"),
        );
    }
    if job.gear.helix_angle_deg == 0.0 && grinding.shift_ratio == ShiftRatio::Rule(ShiftRule::Neutral) {
        findings.push(contradiction(
            "a spur gear has no neutral ratio: the contact runs across its face at once",
            "grinding.shift_ratio",
            "\"neutral\"".into(),
            "a number or \"width\" for a spur gear",
            "use \"width\" with `shift_width`, or give a ratio",
        ));
    }
}

fn passes(job: &TangentialJob, findings: &mut Vec<Diagnostic>) {
    if job.dressing.passes != Passes::One {
        return;
    }
    if job.grinding.flanks != Flanks::Both {
        let which = if job.grinding.flanks == Flanks::Left { "left" } else { "right" };
        findings.push(contradiction(
            &format!("both flanks share the motions of one pass, yet only the {which} flank is ground"),
            "dressing.passes",
            "\"one\"".into(),
            "\"each\", or grinding.flanks = \"both\"",
            "leave `passes` out",
        ));
    }
    let settings = job.settings.iter().flat_map(TangentialSettings::tables);
    for (key, _) in settings.filter(|(key, _)| *key != "both") {
        findings.push(contradiction(
            "both flanks share the motions of one pass, yet a flank has values of its own",
            format!("settings.{key}"),
            "a table".into(),
            "only the table `both`, or dressing.passes = \"each\"",
            "write the values into `settings.both`; the sides of the dresser are FpL and FpR",
        ));
    }
}

/// Variables and splines that would change the profile of a dresser that is there.
fn profile_of_existing(dressing: &TangentialDressing, findings: &mut Vec<Diagnostic>) {
    let is_profile = |channel: Channel| channel.whole() == Channel::Profile;
    let mut refuse = |field: String, value: String, way_out: &str| {
        findings.push(contradiction(
            "the profile of a dresser that exists is not free",
            field,
            value,
            "channels other than Fp, FpL, FpR, or dresser.modification = \"target\"",
            way_out,
        ));
    };
    match &dressing.variables {
        Variables::Rule(VariableRule::Auto) => {}
        Variables::Rule(VariableRule::Source) => refuse(
            "dressing.variables".into(),
            "\"source\"".into(),
            "use \"auto\", or list variables of the motions",
        ),
        Variables::List(list) => {
            for (i, variable) in list.iter().enumerate().filter(|(_, v)| is_profile(v.channel())) {
                refuse(
                    format!("dressing.variables[{i}]"),
                    format!("\"{variable}\""),
                    "delete the variable, or let the dresser be made for the target",
                );
            }
        }
    }
    for (i, spline) in dressing.splines.iter().enumerate().filter(|(_, s)| is_profile(s.channel)) {
        refuse(
            format!("dressing.splines[{i}].channel"),
            format!("\"{}\"", spline.channel.name()),
            "delete the spline, or let the dresser be made for the target",
        );
    }
}

/// What the machine lacks takes no part.
fn excluded(dressing: &TangentialDressing, findings: &mut Vec<Diagnostic>) {
    let lacking = |channel: Channel| dressing.exclude.contains(&channel.whole());
    let mut refuse = |field: String, value: String, channel: Channel, way_out: &str| {
        let name = channel.whole().name();
        findings.push(contradiction(
            &format!("the channel {name} is excluded and wanted"),
            field,
            value,
            &format!(
                "channels other than {}",
                dressing.exclude.iter().map(|c| c.name()).collect::<Vec<_>>().join(", ")
            ),
            way_out,
        ));
    };
    let named = dressing.variables.named().unwrap_or_default();
    match dressing.variables {
        Variables::Rule(VariableRule::Auto) => {}
        // One finding: the list does not stand in the job.
        Variables::Rule(VariableRule::Source) => {
            if let Some(variable) = named.iter().find(|variable| lacking(variable.channel())) {
                let way_out = "use \"auto\", or list the variables that the machine has";
                refuse("dressing.variables".into(), "\"source\"".into(), variable.channel(), way_out);
            }
        }
        Variables::List(_) => {
            for (i, variable) in named.iter().enumerate().filter(|(_, v)| lacking(v.channel())) {
                let field = format!("dressing.variables[{i}]");
                refuse(
                    field,
                    format!("\"{variable}\""),
                    variable.channel(),
                    "delete the variable, or its channel from `exclude`",
                );
            }
        }
    }
    for (i, spline) in dressing.splines.iter().enumerate().filter(|(_, s)| lacking(s.channel)) {
        refuse(
            format!("dressing.splines[{i}].channel"),
            format!("\"{}\"", spline.channel.name()),
            spline.channel,
            "delete the spline, or its channel from `exclude`",
        );
    }
}

/// A study varies something, in ascending steps.
fn varied(explore: &TangentialExplore, findings: &mut Vec<Diagnostic>) {
    if *explore == TangentialExplore::default() {
        findings.push(
            Diagnostic::new(Problem::MissingKey, "`explore` does not say what varies")
                .field("explore.shift_ratio")
                .allowed("one or more of shift_ratio, worm_tip_diameter, dresser_tip_diameter, worm_threads")
                .way_out("add one, e.g. shift_ratio = { from = 0.5, to = 2.5, count = 9 }"),
        );
    }
    for (key, steps) in [
        ("shift_ratio", explore.shift_ratio),
        ("worm_tip_diameter", explore.worm_tip_diameter),
        ("dresser_tip_diameter", explore.dresser_tip_diameter),
    ] {
        ascending(key, steps, findings);
    }
}

/// A channel has one spline.
fn spline_twice(table: &str, channels: impl Iterator<Item = Channel>, findings: &mut Vec<Diagnostic>) {
    let mut seen = Vec::new();
    for (i, channel) in channels.enumerate() {
        if seen.contains(&channel) {
            findings.push(
                Diagnostic::new(Problem::InvalidList, "two splines of the same channel")
                    .field(format!("{table}.splines[{i}].channel"))
                    .value(format!("\"{}\"", channel.name()))
                    .allowed("each channel once")
                    .way_out("delete one of the two"),
            );
        }
        seen.push(channel);
    }
}

/// Largest coefficient of the crossing angle of dressing, rad: its range in mm would be thousands of turns.
const LARGEST_ANGLE: f64 = 1.5;

/// Values that the schema, which knows one range for all variables, lets pass.
fn values(settings: &TangentialSettings, findings: &mut Vec<Diagnostic>) {
    let mut angle = |field: String, value: f64| {
        if value.abs() > LARGEST_ANGLE {
            findings.push(
                Diagnostic::new(Problem::InvalidNumber, "a crossing angle that no dresser takes")
                    .field(field)
                    .value(shown_number(value))
                    .allowed(format!("-{LARGEST_ANGLE} to {LARGEST_ANGLE} rad"))
                    .way_out("give the coefficient of gA in rad"),
            );
        }
    };
    for (key, table) in settings.tables() {
        let angles = table.values.iter().filter(|(v, _)| v.channel() == Channel::DressingAngle);
        for (variable, value) in angles {
            angle(format!("settings.{key}.values.{variable}"), *value);
        }
        for (i, spline) in table.splines.iter().enumerate() {
            if spline.channel == Channel::DressingAngle {
                for (k, value) in spline.coefficients.iter().enumerate() {
                    angle(format!("settings.{key}.splines[{i}].coefficients[{k}]"), *value);
                }
            }
        }
    }
    for (key, table) in settings.tables() {
        let channels = table.splines.iter().map(|spline| spline.channel);
        spline_twice(&format!("settings.{key}"), channels, findings);
    }
}
