//! Generating grinding.
