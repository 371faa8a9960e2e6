//! What the texts of the repository are held to.

mod german_help;
