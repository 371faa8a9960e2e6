//! The code that the derive macro makes.

use super::attributes::{Code, Said, WayOut, names};
use proc_macro2::TokenStream;
use quote::quote;
use syn::{Data, DeriveInput, Error, Fields, LitStr, Result};

pub fn expand(input: &DeriveInput) -> Result<TokenStream> {
    let name = &input.ident;
    let variants = match &input.data {
        Data::Enum(data) if !data.variants.is_empty() => &data.variants,
        _ => return Err(Error::new(name.span(), "findings are enums with at least one variant")),
    };
    let variants: Vec<Said> = variants.iter().map(Said::of).collect::<Result<_>>()?;
    let visibility = &input.vis;
    let (generics, arguments, bounds) = input.generics.split_for_impl();
    let codes = variants.iter().map(code);
    let ways_out = variants.iter().map(way_out);
    let bad_input = variants.iter().any(|said| said.bad_input.is_some()).then(|| {
        let arms = variants.iter().map(bad_input);
        quote! {
            /// Whether the input itself is wrong, in distinction from a limit of the bodies.
            #[allow(unused_variables)]
            #visibility fn is_bad_input(&self) -> bool {
                match self { #(#arms)* }
            }
        }
    });
    Ok(quote! {
        #[automatically_derived]
        impl #generics #name #arguments #bounds {
            /// Stable kebab-case code.
            #[allow(unused_variables)]
            #visibility fn code(&self) -> &'static str {
                match self { #(#codes)* }
            }

            /// What the user can do about it, in one sentence.
            #[allow(unused_variables)]
            #visibility fn way_out(&self) -> ::std::borrow::Cow<'static, str> {
                match self { #(#ways_out)* }
            }

            #bad_input
        }

        #[automatically_derived]
        impl #generics ::finding::Finding for #name #arguments #bounds {
            fn code(&self) -> &'static str {
                self.code()
            }

            fn way_out(&self) -> ::std::borrow::Cow<'static, str> {
                self.way_out()
            }
        }
    })
}

fn code(said: &Said) -> TokenStream {
    let value = match &said.code {
        Code::Own(code) => quote!(#code),
        Code::Of(field) => quote!(#field.code()),
    };
    arm(said, value)
}

fn way_out(said: &Said) -> TokenStream {
    let value = match (&said.way_out, &said.code) {
        (Some(WayOut::Text(text, arguments)), _) => {
            let value = text.value();
            if value.contains(['{', '}']) {
                let text = with_fields(text, &said.variant.fields);
                quote!(::std::borrow::Cow::Owned(::std::format!(#text #arguments)))
            } else {
                quote!(::std::borrow::Cow::Borrowed(#text))
            }
        }
        (Some(WayOut::With(value)), _) => quote!(::std::convert::Into::into(#value)),
        (None, Code::Of(field)) => quote!(::std::convert::Into::into(#field.way_out())),
        (None, Code::Own(_)) => unreachable!("a variant with a code of its own has a way out"),
    };
    arm(said, value)
}

fn bad_input(said: &Said) -> TokenStream {
    arm(said, said.bad_input.clone().unwrap_or_else(|| quote!(false)))
}

/// An arm of a match in which the fields are known by their names.
fn arm(said: &Said, value: TokenStream) -> TokenStream {
    let (variant, names) = (&said.variant.ident, names(&said.variant.fields));
    match &said.variant.fields {
        Fields::Named(_) => quote!(Self::#variant { #(#names),* } => #value,),
        Fields::Unnamed(_) => quote!(Self::#variant(#(#names),*) => #value,),
        Fields::Unit => quote!(Self::#variant => #value,),
    }
}

/// The text with `{0}` as the field of a tuple.
fn with_fields(text: &LitStr, fields: &Fields) -> LitStr {
    if !matches!(fields, Fields::Unnamed(_)) {
        return text.clone();
    }
    let value = text.value();
    let mut named = String::new();
    let mut rest = value.chars().peekable();
    while let Some(c) = rest.next() {
        named.push(c);
        if c == '{' {
            match rest.peek() {
                Some('{') => named.extend(rest.next()),
                Some(next) if next.is_ascii_digit() => named.push('_'),
                _ => {}
            }
        }
    }
    LitStr::new(&named, text.span())
}
