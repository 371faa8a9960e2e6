//! The derive macro of the crate `finding`, whose documentation says what each attribute means.

use proc_macro::TokenStream;
use syn::{DeriveInput, parse_macro_input};

mod attributes;
mod expand;

/// Code and way out of an enum from the attributes of its variants; see the crate `finding`.
#[proc_macro_derive(Finding, attributes(finding, way_out))]
pub fn derive_finding(input: TokenStream) -> TokenStream {
    let input = parse_macro_input!(input as DeriveInput);
    expand::expand(&input).unwrap_or_else(|error| error.to_compile_error()).into()
}
