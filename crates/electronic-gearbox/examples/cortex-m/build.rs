//! Puts `memory.x`, the memory of the board, where the linker looks for it.

use std::path::PathBuf;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let directory = PathBuf::from(std::env::var("OUT_DIR")?);
    std::fs::copy("memory.x", directory.join("memory.x"))?;
    println!("cargo:rustc-link-search={}", directory.display());
    println!("cargo:rerun-if-changed=memory.x");
    Ok(())
}
