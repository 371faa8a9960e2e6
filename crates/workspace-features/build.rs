//! Cargo takes the features of build dependencies into account where a package has a build script.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
}
