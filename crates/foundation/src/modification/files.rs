//! Grids and clouds that lie in files: what a reader must deliver. Reading itself happens elsewhere.

/// A table f(w, z) as a file holds it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GridTable {
    /// Lengths of roll, ascending, mm.
    pub w_mm: Vec<f64>,
    /// Face positions, ascending, mm.
    pub z_mm: Vec<f64>,
    /// `[w][z]`, um, positive = material left.
    pub f_um: Vec<Vec<f64>>,
}

/// Finds what the key `file` of a grid, of traces or of a cloud refers to.
pub trait ModificationFiles {
    /// The grid in `file`.
    ///
    /// # Errors
    /// One phrase that says why it can't be had.
    fn grid(&self, file: &str) -> Result<GridTable, String>;

    /// The traces in `file`, two or three values of w.
    ///
    /// # Errors
    /// One phrase that says why they can't be had.
    fn traces(&self, file: &str) -> Result<GridTable, String>;

    /// The points (w mm, z mm, f um) in `file`.
    ///
    /// # Errors
    /// One phrase that says why they can't be had.
    fn points(&self, file: &str) -> Result<Vec<[f64; 3]>, String>;

    /// The profile (w mm, f um) in `file`.
    ///
    /// # Errors
    /// One phrase that says why it can't be had.
    fn profile(&self, file: &str) -> Result<Vec<[f64; 2]>, String>;
}

/// No files at hand: every reference to one is refused.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl ModificationFiles for NoFiles {
    fn grid(&self, _file: &str) -> Result<GridTable, String> {
        Err("files are not read here".into())
    }

    fn traces(&self, _file: &str) -> Result<GridTable, String> {
        Err("files are not read here".into())
    }

    fn points(&self, _file: &str) -> Result<Vec<[f64; 3]>, String> {
        Err("files are not read here".into())
    }

    fn profile(&self, _file: &str) -> Result<Vec<[f64; 2]>, String> {
        Err("files are not read here".into())
    }
}
