//! What the derive macro makes of the attributes of variants.

use finding::Finding;
use std::borrow::Cow;
use thiserror::Error;

#[derive(Clone, Copy, Debug, PartialEq, Error, Finding)]
enum Inner {
    #[error("plain")]
    #[finding(code = "plain")]
    #[way_out("say {nothing} of fields", nothing = "nothing")]
    Plain,
    #[error("{name} = {value}")]
    #[finding(code = "named-2", bad_input)]
    #[way_out("keep {name:?} below {:.2} or at {{0}}", value * 2.0)]
    Named { name: &'static str, value: f64 },
}

#[derive(Debug, Error, Finding)]
enum Outer<T: std::fmt::Debug> {
    #[error(transparent)]
    #[finding(transparent)]
    Inner(#[from] Inner),
    #[error("stroke {number}: {error}")]
    #[finding(transparent = error, bad_input = error.is_bad_input() && *number > 1)]
    Stroke { number: usize, error: Box<Inner> },
    #[error("way {error}")]
    #[finding(transparent = error)]
    #[way_out(with = if *last { "turn back" } else { "go on" })]
    Way { last: bool, error: Inner },
    #[error("{0:?} and {1}")]
    #[finding(code = "tuple")]
    #[way_out("{{{0:?}}} or {1:>4}, {}{0:?}", _1 + 1)]
    Tuple(T, usize),
    #[error("by hand")]
    #[finding(code = by_hand.0, bad_input)]
    #[way_out(with = by_hand.1.clone())]
    ByHand { by_hand: (&'static str, String) },
    #[error("foreign")]
    #[finding(transparent)]
    Foreign(#[source] Foreign),
}

/// An error with tables of its own.
#[derive(Debug, Error)]
#[error("foreign")]
struct Foreign;

impl Foreign {
    const fn code(&self) -> &'static str {
        "foreign"
    }

    const fn way_out(&self) -> &'static str {
        "ask elsewhere"
    }
}

fn named() -> Inner {
    Inner::Named { name: "w", value: 1.5 }
}

/// Through the trait.
fn told(finding: &dyn Finding) -> (&'static str, String) {
    (finding.code(), finding.way_out().into_owned())
}

#[test]
fn texts_are_formatted_with_the_fields() {
    assert_eq!(told(&Inner::Plain), ("plain", "say nothing of fields".into()));
    assert_eq!(told(&named()), ("named-2", "keep \"w\" below 3.00 or at {0}".into()));
    assert_eq!(told(&Outer::Tuple([7], 3)), ("tuple", "{[7]} or    3, 4[7]".into()));
}

#[test]
fn a_text_without_fields_is_borrowed() {
    assert!(matches!(Outer::<()>::Foreign(Foreign).way_out(), Cow::Borrowed("ask elsewhere")));
    assert!(matches!(Outer::<()>::Way { last: true, error: named() }.way_out(), Cow::Borrowed("turn back")));
}

#[test]
fn a_field_has_code_and_way_out() {
    let stroke = |number| Outer::<()>::Stroke { number, error: Box::new(named()) };
    assert_eq!(told(&Outer::<()>::from(named())), told(&named()));
    assert_eq!(told(&stroke(1)), told(&named()));
    assert_eq!(told(&Outer::<()>::Way { last: false, error: named() }), ("named-2", "go on".into()));
    assert_eq!((stroke(1).is_bad_input(), stroke(2).is_bad_input()), (false, true));
}

#[test]
fn expressions_stand_for_texts() {
    let by_hand = Outer::<()>::ByHand { by_hand: ("own", "find it".into()) };
    assert_eq!(told(&by_hand), ("own", "find it".into()));
    assert!(by_hand.is_bad_input() && !Outer::Tuple((), 0).is_bad_input());
    assert!(named().is_bad_input() && !Inner::Plain.is_bad_input());
}
