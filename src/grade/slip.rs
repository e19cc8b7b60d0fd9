//! The name of a mistake: how a wrong line differs from the line of the key that it is meant to be; and when two lines have
//! the same one.

use crate::algebra::{Monomial, Polynomial, Rational};
use crate::grade::matching::Part;
use crate::notation::document::Document;
use crate::verify::Finding;
use std::collections::BTreeMap;

/// The name of the difference, and one sentence that says it.
pub(super) fn name(own: &Part, key: &Part) -> (&'static str, &'static str) {
    let (own, key) = (
        terms(own.residual.numerator()),
        terms(key.residual.numerator()),
    );
    let scale = own
        .iter()
        .find_map(|(monomial, number)| Some(key.get(monomial)?.clone() / number.clone()));
    let Some(scale) = scale else {
        return OTHER;
    };
    // Most terms agree with one of the two signs.
    let flipped = -scale.clone();
    let agree = |scale: &Rational| {
        let same = own
            .iter()
            .filter(|(m, n)| key.get(*m) == Some(&((*n).clone() * scale.clone())));
        same.count()
    };
    let scale = if agree(&flipped) > agree(&scale) {
        flipped
    } else {
        scale
    };
    let missing = key.keys().filter(|m| !own.contains_key(*m)).count();
    let extra = own.keys().filter(|m| !key.contains_key(*m)).count();
    let differ = own.iter().filter_map(|(m, n)| {
        let (own, key) = (n.clone() * scale.clone(), key.get(m)?);
        (own != *key).then(|| own == -key.clone())
    });
    let differ: Vec<bool> = differ.collect();
    match (missing, extra, differ.as_slice()) {
        (0, 0, [_, ..]) if differ.iter().all(|sign| *sign) => ("sign", "a sign is wrong"),
        (0, 0, [_, ..]) => ("factor", "a factor is wrong"),
        (1.., 0, []) => ("missing-term", "a term is missing"),
        (0, 1.., []) => ("extra-term", "there is a term too many"),
        (a, b, []) if a == b => (
            "wrong-term",
            "a term has another letter or index than it should",
        ),
        _ => OTHER,
    }
}

const OTHER: (&str, &str) = ("other", "the line does not hold");

fn terms(of: &Polynomial) -> BTreeMap<Monomial, Rational> {
    of.terms().iter().cloned().collect()
}

/// A change that puts a line right: the name of the mistake, what is taken out, what is put in, and the term it stands before.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Mending {
    kind: &'static str,
    out: String,
    put: String,
    term: String,
}

/// The change that puts a line right, where one was found.
pub(super) fn mending(document: &Document, found: &Finding) -> Option<Mending> {
    let diagnosis = found.diagnosis.as_ref()?;
    let place = diagnosis
        .place
        .filter(|place| found.span.start <= place.start)?;
    let out = bare(document.source.slice(place));
    let line = document.source.slice(found.span);
    let behind = line.get((place.end - found.span.start) as usize..)?;
    let ahead = line.get(..(place.start - found.span.start) as usize)?;
    let (mended, behind, ahead) = (
        bare(diagnosis.suggestion.as_ref()?),
        bare(behind),
        bare(ahead),
    );
    let put = mended
        .strip_prefix(&ahead)?
        .strip_suffix(&behind)?
        .to_owned();
    let term = behind.split(['+', '-', '=']).next()?.to_owned();
    Some(Mending {
        kind: diagnosis.kind,
        out,
        put,
        term,
    })
}

/// A text without blanks and marks of alignment.
fn bare(text: &str) -> String {
    let mut bare = String::with_capacity(text.len());
    bare.extend(text.chars().filter(|c| !c.is_whitespace() && *c != '&'));
    bare
}
