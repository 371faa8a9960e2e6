//! What the texts of the repository are held to: the terms of `docs/glossary.md`, pages that exist, German help for every description.

mod glossary;
mod references;
mod repository;
mod spellings;
