//! Monomials in each of their packed forms.

use polhode::algebra::{Monomial, Variable};
use proptest::prelude::*;
use std::cmp::Ordering;

/// Powers whose monomials fall into every form, and near the bounds between them.
fn powers() -> impl Strategy<Value = Vec<(Variable, u32)>> {
    let variable = prop_oneof![0u32..4, 13u32..18, 1020u32..1025];
    let exponent = prop_oneof![1u32..4, 30u32..34, 62u32..66, 126u32..130];
    prop::collection::btree_map(variable, exponent, 0..9).prop_map(|map| map.into_iter().collect())
}

fn joined(
    a: &[(Variable, u32)],
    b: &[(Variable, u32)],
    join: impl Fn(u32, u32) -> u32,
) -> Vec<(Variable, u32)> {
    let at = |list: &[(Variable, u32)], v| list.iter().find(|p| p.0 == v).map_or(0, |p| p.1);
    let mut variables: Vec<_> = a.iter().chain(b).map(|p| p.0).collect();
    variables.sort_unstable();
    variables.dedup();
    let all = variables.into_iter().map(|v| (v, join(at(a, v), at(b, v))));
    all.filter(|&(_, e)| e > 0).collect()
}

/// Among monomials of one degree the one with more of the first variable in which they differ is larger.
fn lexicographic(a: &[(Variable, u32)], b: &[(Variable, u32)]) -> Ordering {
    let differ = a.iter().zip(b).find(|(p, q)| p != q);
    match differ {
        Some((p, q)) => q.0.cmp(&p.0).then(p.1.cmp(&q.1)),
        None => a.len().cmp(&b.len()),
    }
}

proptest! {
    #[test]
    fn every_form_agrees_with_lists_of_powers(a in powers(), b in powers()) {
        let (p, q) = (Monomial::from_powers(a.clone()), Monomial::from_powers(b.clone()));
        prop_assert_eq!(p.powers(), a.clone());
        prop_assert_eq!(p.times(&q).powers(), joined(&a, &b, |x, y| x + y));
        prop_assert_eq!(p.gcd(&q).powers(), joined(&a, &b, u32::min));
        prop_assert_eq!(p.lcm(&q).powers(), joined(&a, &b, u32::max));
        prop_assert_eq!(p.times(&q).quotient(&q), Some(p.clone()));
        let divides = b.iter().all(|&(v, e)| p.exponent(v) >= e);
        prop_assert_eq!(p.quotient(&q).is_some(), divides);
        let degree = |list: &[(Variable, u32)]| list.iter().map(|p| p.1).sum::<u32>();
        let order = degree(&a).cmp(&degree(&b)).then_with(|| lexicographic(&a, &b));
        prop_assert_eq!(p.cmp(&q), order);
        for &(variable, exponent) in &a {
            prop_assert_eq!(p.exponent(variable), exponent);
            let rest: Vec<_> = a.iter().copied().filter(|f| f.0 != variable).collect();
            prop_assert_eq!(p.without(variable), Monomial::from_powers(rest));
        }
    }
}
