//! What the attributes of a variant say.

use proc_macro2::{Span, TokenStream, TokenTree};
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Attribute, Error, Fields, Ident, LitStr, Member, Result, Token, Variant};

/// A variant with what its attributes say.
pub struct Said<'a> {
    pub variant: &'a Variant,
    pub code: Code,
    /// `None` only where the code is a field's.
    pub way_out: Option<WayOut>,
    pub bad_input: Option<TokenStream>,
}

/// Where the code of a variant comes from.
pub enum Code {
    /// A text, or an expression of the fields.
    Own(TokenStream),
    /// This field has it.
    Of(Ident),
}

/// How the way out of a variant is made.
pub enum WayOut {
    /// A text with arguments of `format!`.
    Text(LitStr, TokenStream),
    /// An expression of the fields.
    With(TokenStream),
}

impl<'a> Said<'a> {
    pub fn of(variant: &'a Variant) -> Result<Self> {
        let (mut code, mut bad_input) = (None, None);
        for Entry { name, value } in entries(variant)? {
            match (name.to_string().as_str(), value) {
                ("code", Some(value)) => set(&mut code, &name, Code::Own(checked(value)?))?,
                ("transparent", value) => set(&mut code, &name, Code::Of(field(variant, value)?))?,
                ("bad_input", value) => {
                    set(&mut bad_input, &name, value.unwrap_or_else(|| quote::quote!(true)))?;
                }
                _ => {
                    let known = "`code = \"..\"`, `transparent`, `transparent = field`, `bad_input`, `bad_input = ..`";
                    return Err(Error::new(name.span(), format!("not one of {known}")));
                }
            }
        }
        let lacking = |what| Error::new(variant.ident.span(), format!("`{}` has no {what}", variant.ident));
        let code = code.ok_or_else(|| lacking("`#[finding(code = \"..\")]`"))?;
        let mut way_outs = attributes(variant, "way_out").map(Attribute::parse_args);
        let way_out = way_outs.next().transpose()?;
        if way_outs.next().is_some() {
            return Err(Error::new(variant.ident.span(), "two ways out of one variant"));
        }
        if way_out.is_none() && matches!(code, Code::Own(_)) {
            return Err(lacking("`#[way_out(\"..\")]`"));
        }
        Ok(Self { variant, code, way_out, bad_input })
    }
}

fn attributes<'a>(variant: &'a Variant, name: &'a str) -> impl Iterator<Item = &'a Attribute> {
    variant.attrs.iter().filter(move |attribute| attribute.path().is_ident(name))
}

fn entries(variant: &Variant) -> Result<Vec<Entry>> {
    let mut entries = Vec::new();
    for attribute in attributes(variant, "finding") {
        entries.extend(attribute.parse_args_with(Punctuated::<Entry, Token![,]>::parse_terminated)?);
    }
    Ok(entries)
}

fn set<T>(place: &mut Option<T>, name: &Ident, value: T) -> Result<()> {
    match place.replace(value) {
        None => Ok(()),
        Some(_) => Err(Error::new(name.span(), "stated twice")),
    }
}

/// The code, if it is no text or one in kebab case.
fn checked(code: TokenStream) -> Result<TokenStream> {
    let Ok(text) = syn::parse2::<LitStr>(code.clone()) else { return Ok(code) };
    let part =
        |part: &str| !part.is_empty() && part.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit());
    if text.value().split('-').all(part) {
        Ok(code)
    } else {
        Err(Error::new(text.span(), "a code is in kebab case"))
    }
}

/// The field that has code and way out.
fn field(variant: &Variant, named: Option<TokenStream>) -> Result<Ident> {
    match named {
        Some(named) => syn::parse2(named),
        None if variant.fields.len() == 1 => Ok(names(&variant.fields).remove(0)),
        None => Err(Error::new(variant.ident.span(), "say which field: `transparent = field`")),
    }
}

/// Names under which the fields are known to expressions.
pub fn names(fields: &Fields) -> Vec<Ident> {
    let name = |member| match member {
        Member::Named(name) => name,
        Member::Unnamed(place) => Ident::new(&format!("_{}", place.index), Span::call_site()),
    };
    fields.members().map(name).collect()
}

/// `name` or `name = value` of `#[finding(..)]`.
struct Entry {
    name: Ident,
    value: Option<TokenStream>,
}

impl Parse for Entry {
    fn parse(input: ParseStream) -> Result<Self> {
        let name = input.parse()?;
        if !input.peek(Token![=]) {
            return Ok(Self { name, value: None });
        }
        input.parse::<Token![=]>()?;
        let mut value = TokenStream::new();
        while !input.is_empty() && !input.peek(Token![,]) {
            value.extend([input.parse::<TokenTree>()?]);
        }
        if value.is_empty() {
            return Err(input.error("a value is missing"));
        }
        Ok(Self { name, value: Some(value) })
    }
}

impl Parse for WayOut {
    fn parse(input: ParseStream) -> Result<Self> {
        if input.peek(LitStr) {
            return Ok(Self::Text(input.parse()?, input.parse()?));
        }
        let name: Ident = input.parse()?;
        if name != "with" {
            return Err(Error::new(name.span(), "a text, or `with = ..`"));
        }
        input.parse::<Token![=]>()?;
        if input.is_empty() {
            return Err(input.error("a value is missing"));
        }
        Ok(Self::With(input.parse()?))
    }
}
