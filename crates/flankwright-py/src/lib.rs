//! The functions and classes for Python: thin classes over the library, which compute nothing. The pleasant names are in `python/flankwright/`; what is here is
//! private to them. Documents go over as JSON, numbers as NumPy arrays that Rust has filled.

mod arrays;
mod beside;
mod dressing;
mod failure;
mod forward;
mod gear;
mod gearbox;
mod inspection;
mod job;
mod measuring;
mod milling;
mod modification;
mod outcome;
mod pool;
mod samples;
mod tangential;
mod task;
mod verify;
mod watch;

use pyo3::prelude::*;

/// The extension module of the package `flankwright`.
#[pymodule]
mod _core {
    use pyo3::prelude::{Bound, PyModule, PyResult};

    #[pymodule_export]
    use crate::beside::use_threads;
    #[pymodule_export]
    use crate::dressing::CoreDresser;
    #[pymodule_export]
    use crate::failure::CoreRefusal;
    #[pymodule_export]
    use crate::forward::CoreForward;
    #[pymodule_export]
    use crate::gear::{CoreGear, CoreWorm};
    #[pymodule_export]
    use crate::gearbox::CoreGearbox;
    #[pymodule_export]
    use crate::inspection::{CoreBlank, inspect, inspect_series};
    #[pymodule_export]
    use crate::job::{CoreJob, schema, template};
    #[pymodule_export]
    use crate::measuring::CoreMeasuring;
    #[pymodule_export]
    use crate::milling::CoreMilling;
    #[pymodule_export]
    use crate::modification::CoreModification;
    #[pymodule_export]
    use crate::outcome::CoreResult;
    #[pymodule_export]
    use crate::tangential::CoreTangential;
    #[pymodule_export]
    use crate::task::{preview, preview_many, run, run_many};
    #[pymodule_export]
    use crate::verify::verify;

    /// Adds the processes of this wheel that the registry does not have of itself.
    #[pymodule_init]
    fn init(_module: &Bound<'_, PyModule>) -> PyResult<()> {
        #[cfg(feature = "sample-process")]
        flankwright::add_process(flankwright_sample_process::TipChamfering)
            .map_err(|error| pyo3::exceptions::PyRuntimeError::new_err(error.to_string()))?;
        Ok(())
    }

    /// The version of the program.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
}
