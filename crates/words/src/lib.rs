//! The words of the project. `docs/glossary.md` says which term is used for which thing, in English and German; the tests of this crate
//! hold the texts of the repository to it. There is no code here.
