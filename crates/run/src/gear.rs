//! The gear of a job as bodies, and what is wanted of its flanks: for every process that makes one.

use super::finding::{geometry_finding, modification_finding};
use foundation::geometry::{Blank, Flank, Gear};
use foundation::modification::{
    EvaluationField, GridTable, Modification, ModificationFiles, ModificationSpec,
};
use job::tables::Gear as JobGear;
use job::{Diagnostic, Loaded, read_grid_target, read_points, read_profile, read_traces};

/// Grid and point files named in a job, beside the job file.
struct Beside<'a, J>(&'a Loaded<J>);

impl<J> ModificationFiles for Beside<'_, J> {
    fn grid(&self, file: &str) -> Result<GridTable, String> {
        let table = read_grid_target(&self.0.beside(file)).map_err(|e| e.to_string())?;
        Ok(GridTable { w_mm: table.w_mm, z_mm: table.z_mm, f_um: table.f_um })
    }

    fn traces(&self, file: &str) -> Result<GridTable, String> {
        let table = read_traces(&self.0.beside(file)).map_err(|e| e.to_string())?;
        Ok(GridTable { w_mm: table.w_mm, z_mm: table.z_mm, f_um: table.f_um })
    }

    fn points(&self, file: &str) -> Result<Vec<[f64; 3]>, String> {
        read_points(&self.0.beside(file)).map_err(|e| e.to_string())
    }

    fn profile(&self, file: &str) -> Result<Vec<[f64; 2]>, String> {
        read_profile(&self.0.beside(file)).map_err(|e| e.to_string())
    }
}

/// The tables that the modifications of a job lie in.
pub fn job_files<J>(loaded: &Loaded<J>) -> impl ModificationFiles + '_ {
    Beside(loaded)
}

/// The gear of the table `[gear]` of a job, in the middle between the allowances of its thickness.
///
/// # Errors
/// A finding on the key concerned.
pub fn gear_of_job(g: &JobGear) -> Result<Gear, Diagnostic> {
    g.body().map_err(|e| geometry_finding(&e, "gear"))
}

/// Diameters and face width of the table `[gear]` of a job.
pub fn blank_of_job(gear: &JobGear) -> Blank {
    Blank {
        face_width: gear.face_width,
        tip_diameter: gear.tip_diameter,
        root_diameter: gear.root_diameter,
        tip_form_diameter: gear.tip_diameter,
        form_diameter: gear.root_form_diameter(),
        rack_addendum: None,
    }
}

/// Modifications of the list `target.modifications` on a flank; a finding names the entry.
pub fn specs_of_flank<J>(
    loaded: &Loaded<J>,
    specs: &[ModificationSpec],
    flank: Flank,
    field: &EvaluationField,
) -> Result<Modification, Diagnostic> {
    // The position of the offending entry makes the message point into the file.
    Modification::of_entries(specs, flank, field, &Beside(loaded))
        .map_err(|(index, error)| modification_finding(&error, &format!("target.modifications[{index}]")))
}
