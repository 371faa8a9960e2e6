//! Contradictions between entries of a job that are each in range, as far as jobs of several processes share them. Knows no geometry
//! beyond the order of diameters.

pub mod clamping;
pub mod control;
pub mod diameters;
pub mod gear;
pub mod passes;
pub mod title_block;

pub use clamping::check as clamping_bodies;
pub use control::check as control_of_job;
pub use diameters::{dresser_diameters, inside_tip, root_clearance, worm_diameters};
pub use gear::check as drawing;
pub use passes::falling_stock;
pub use title_block::machine_named_twice;

pub use super::contradiction::contradiction;

use super::diagnostic::{Diagnostic, Problem};
use super::tables::{Gear, Grid, JobInfo};

/// What a job of any process must be free of.
pub fn every_job(info: &JobInfo, gear: &Gear, grid: &Grid, findings: &mut Vec<Diagnostic>) {
    name(info, findings);
    gear::check(gear, findings);
    points(grid, findings);
}

/// Result points per flank: a finer grid shows nothing more and takes minutes.
const MOST_POINTS: usize = 40_401;

fn points(grid: &Grid, findings: &mut Vec<Diagnostic>) {
    let points = grid.profile_points * grid.helix_points;
    if points > MOST_POINTS {
        findings.push(
            Diagnostic::new(Problem::InvalidJob, format!("the result grid has {points} points per flank"))
                .field("grid.profile_points")
                .value(grid.profile_points)
                .allowed(format!("profile_points x helix_points up to {MOST_POINTS} (201 x 201)"))
                .way_out("use a coarser grid, e.g. 41 x 41"),
        );
    }
}

/// A name that can be that of a directory.
pub fn name(info: &JobInfo, findings: &mut Vec<Diagnostic>) {
    let name = &info.name;
    let plain = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | '.' | ' ');
    // The name becomes a directory: nothing that leads elsewhere or that a file system trims.
    if !name.chars().all(plain) || name.starts_with(['.', ' ']) || name.ends_with(['.', ' ']) {
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "the name of the job cannot name a directory")
                .field("job.name")
                .value(format!("{name:?}"))
                .allowed("letters, digits, `-`, `_`, and inside also `.` and spaces")
                .way_out("choose a plain name such as \"twist-free-crowning\""),
        );
    }
}

/// A part of the format that this version does not carry out.
pub fn not_yet(field: &str, what: &str) -> Diagnostic {
    Diagnostic::new(
        Problem::NotYetSupported,
        format!("{what}: part of the job format, but not yet supported"),
    )
    .field(field)
}
