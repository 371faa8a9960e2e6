//! Files made for the purpose in the grammar of `docs/mathematics/inspection.md`, real ones where they lie beside the repository, and
//! damaged ones.

mod damaged;
mod made;
mod model;
mod real;
mod recovery;
mod traces;
