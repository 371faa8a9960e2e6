//! Contradictions around `[catalogue]`: it takes the place of `[worm]` and `[dresser]`.

use crate::job::{
    CatalogueSource, Dressing, DressingFlanks, Explore, FreeQuantity, FreeWorm, Job, ProfileCrowningBy,
    RankBy,
};
use job::{Diagnostic, Problem, shown_number};

pub(super) fn check(job: &Job, findings: &mut Vec<Diagnostic>) {
    let study = job.explore.as_ref().and_then(|explore| explore.catalogue.as_ref());
    match (&job.catalogue, study) {
        (Some(source), _) => with_catalogue(job, source, findings),
        (None, Some(_)) => findings.push(
            Diagnostic::new(Problem::InvalidJob, "a study of a catalogue needs one")
                .field("explore.catalogue")
                .value("a table")
                .allowed("no key, or a table [catalogue]")
                .way_out("add `[catalogue]`, or remove this study"),
        ),
        (None, None) => {}
    }
}

fn with_catalogue(job: &Job, source: &CatalogueSource, findings: &mut Vec<Diagnostic>) {
    let tables = [
        ("worm", !job.worm.is_absent()),
        ("dresser", job.dresser.is_some()),
        ("settings", job.settings.is_some()),
    ];
    for (table, _) in tables.into_iter().filter(|(_, given)| *given) {
        findings.push(
            Diagnostic::new(
                Problem::InvalidJob,
                format!(
                    "worm and dresser are chosen from the catalogue, yet the job has a table `[{table}]`"
                ),
            )
            .field(table)
            .value("a table")
            .allowed("either [catalogue], or [worm] and [dresser]")
            .way_out(format!("remove `[{table}]`, or `[catalogue]`")),
        );
    }
    files(source, findings);
    whole_target(job, source, findings);
    dressing(&job.dressing, findings);
    if let Some(explore) = &job.explore {
        studies(explore, findings);
    }
}

/// One file, or two tables.
fn files(source: &CatalogueSource, findings: &mut Vec<Diagnostic>) {
    let allowed = "either `file`, or `worms_csv` and `dressers_csv`";
    let given =
        [("file", &source.file), ("worms_csv", &source.worms_csv), ("dressers_csv", &source.dressers_csv)];
    match given.map(|(_, name)| name.is_some()) {
        [true, false, false] | [false, true, true] => {}
        [false, ..] => {
            let key = match (&source.worms_csv, &source.dressers_csv) {
                (None, Some(_)) => "worms_csv",
                (Some(_), None) => "dressers_csv",
                _ => "file",
            };
            findings.push(
                Diagnostic::new(Problem::MissingKey, "`catalogue` does not say where all its bodies stand")
                    .field(format!("catalogue.{key}"))
                    .allowed(allowed)
                    .way_out(format!("add `{key} = \"...\"`")),
            );
        }
        [true, ..] => {
            for (key, name) in given.into_iter().skip(1) {
                let Some(name) = name else { continue };
                findings.push(
                    Diagnostic::new(Problem::InvalidJob, "the bodies of the catalogue are given twice")
                        .field(format!("catalogue.{key}"))
                        .value(format!("{name:?}"))
                        .allowed(allowed)
                        .way_out("keep the file or the tables"),
                );
            }
        }
    }
}

/// What a ranking by plans alone reads.
fn whole_target(job: &Job, source: &CatalogueSource, findings: &mut Vec<Diagnostic>) {
    let given = [
        ("plans", source.plans.map(|plans| plans.to_string())),
        ("crowning_at", source.crowning_at.as_ref().map(|at| format!("{} positions", at.len()))),
    ];
    for (key, value) in given {
        let Some(value) = value.filter(|_| source.rank_by != RankBy::WholeTarget) else { continue };
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "a ranking by the profile plans no pair")
                .field(format!("catalogue.{key}"))
                .value(value)
                .allowed("no key, or rank_by = \"whole-target\"")
                .way_out(format!("add `rank_by = \"whole-target\"`, or remove `{key}`")),
        );
    }
    if source.rank_by == RankBy::WholeTarget && job.explore.as_ref().is_some_and(|e| e.catalogue.is_some()) {
        findings.push(
            Diagnostic::new(
                Problem::InvalidJob,
                "a study with a free quantity of the worm looks at profiles",
            )
            .field("catalogue.rank_by")
            .value("\"whole-target\"")
            .allowed("\"profile\" beside explore.catalogue")
            .way_out("rank the catalogue by plans in a job of its own"),
        );
    }
    let range = job.gear.evaluation_range();
    let (from, to) = (range.z_start, range.z_end);
    for (k, &z) in source.crowning_at.iter().flatten().enumerate() {
        let at = source.crowning_at.as_deref().unwrap_or_default();
        let ascends = k == 0 || at[k - 1] < z;
        if !(from..=to).contains(&z) || !ascends {
            findings.push(
                Diagnostic::new(
                    Problem::InvalidNumber,
                    if ascends {
                        "a position of the crowning is outside the evaluated width"
                    } else {
                        "the positions of the crowning do not ascend"
                    },
                )
                .field(format!("catalogue.crowning_at[{k}]"))
                .value(shown_number(z))
                .allowed(format!("{} to {} mm, ascending", shown_number(from), shown_number(to)))
                .way_out("give positions within the evaluated width, the smallest first, each once"),
            );
        }
    }
}

/// Dressers that are there are used as they are: one flank after the other, by three points and the radius map.
fn dressing(dressing: &Dressing, findings: &mut Vec<Diagnostic>) {
    let mut refuse = |field: &str, value: String, allowed: &str| {
        findings.push(
            Diagnostic::new(
                Problem::InvalidJob,
                "a dresser of a catalogue is there and is not made for this job",
            )
            .field(field)
            .value(value)
            .allowed(allowed)
            .way_out("leave the key out"),
        );
    };
    if dressing.profile_crowning_by == ProfileCrowningBy::Dresser {
        let allowed = "\"auto\", \"correction\" or \"diagonal\"";
        refuse("dressing.profile_crowning_by", "\"dresser\"".into(), allowed);
    }
    if dressing.flanks == DressingFlanks::Two {
        refuse("dressing.flanks", "\"two\"".into(), "\"one\"");
    }
    for (field, given) in [
        ("dressing.line_direction_deg", dressing.line_direction_deg.is_some()),
        ("dressing.scallop_um", dressing.scallop_um.is_some()),
    ] {
        if given {
            refuse(field, "given".into(), "no key: a dresser of a catalogue touches along a line");
        }
    }
    if !dressing.has_usual_conditions() {
        refuse(
            "dressing.conditions",
            format!("{} conditions", dressing.rows()),
            "[\"three-point\", \"radius-map\"], all four motions free",
        );
    }
}

/// A catalogue has its own study.
fn studies(explore: &Explore, findings: &mut Vec<Diagnostic>) {
    if (Explore { catalogue: None, ..explore.clone() }) != Explore::default() {
        findings.push(
            Diagnostic::new(
                Problem::InvalidJob,
                "this study varies one worm, the job has a catalogue of them",
            )
            .field("explore")
            .value("a table")
            .allowed("no key but `catalogue`")
            .way_out("plan the best pair first, then study the worm that it has"),
        );
    }
    if let Some(study) = &explore.catalogue {
        free(study, findings);
    }
}

fn free(study: &FreeWorm, findings: &mut Vec<Diagnostic>) {
    let [least, most] = study.free.range();
    for (key, value) in [("from", study.from), ("to", study.to)] {
        let whole = study.free != FreeQuantity::Threads || value.fract() == 0.0;
        if !(least..=most).contains(&value) || !whole {
            let kind = if study.free == FreeQuantity::Threads { "a whole number " } else { "" };
            findings.push(
                Diagnostic::new(
                    Problem::InvalidNumber,
                    format!("`{}` cannot be {}", study.free.name(), shown_number(value)),
                )
                .field(format!("explore.catalogue.{key}"))
                .value(shown_number(value))
                .allowed(format!("{kind}{least} to {most}"))
                .way_out("give the range in which a worm can be had"),
            );
        }
    }
    if study.to <= study.from && study.free != FreeQuantity::Threads || study.to < study.from {
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "the range of the free quantity does not ascend")
                .field("explore.catalogue.to")
                .value(shown_number(study.to))
                .allowed(format!("> from = {}", shown_number(study.from)))
                .way_out("give the smaller value as `from`"),
        );
    }
}
