//! No code: `Cargo.toml` names the features of shared libraries, so that every package is built with the same ones, alone or with the others.
