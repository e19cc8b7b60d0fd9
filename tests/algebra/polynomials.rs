//! Products, powers and compositions of polynomials, linear equations, and square factors of numbers.

use num_traits::{One, Zero};
use polhode::algebra::{
    Fraction, LinearError, Monomial, Polynomial, Rational, TooLarge, Variable, compose,
    solve_linear,
};
use proptest::prelude::*;
use std::collections::HashMap;
use std::ops::Add;

/// Sums with like terms, terms of several forms, and coefficients that cancel.
fn sums() -> impl Strategy<Value = Polynomial> {
    let monomial = prop::collection::vec((0u32..4, 1u32..3), 0..3);
    let term = (monomial, -2i64..3, 1i64..3).prop_map(|(powers, n, d)| {
        let factors = powers.iter().flat_map(|&(v, e)| vec![5 * v; e as usize]);
        factors.fold(
            Polynomial::constant(Rational::from((n, d))),
            |product, v| product * Polynomial::variable(v),
        )
    });
    prop::collection::vec(term, 0..5)
        .prop_map(|terms| terms.into_iter().fold(Polynomial::zero(), Add::add))
}

proptest! {
    #[test]
    fn a_power_is_a_repeated_product(sum in sums(), exponent in 0u32..6) {
        let product = (0..exponent).fold(Polynomial::one(), |power, _| power * sum.clone());
        prop_assert_eq!(sum.pow(exponent), product);
    }

    #[test]
    fn a_product_distributes_over_a_sum(a in sums(), b in sums(), c in sums()) {
        let apart = a.clone() * b.clone() + a.clone() * c.clone();
        prop_assert_eq!(a * (b + c), apart);
    }
}

/// Many terms are gathered by their hashes, and a few merged in their order.
#[test]
fn a_product_of_many_terms_is_the_sum_of_products_of_few() {
    let sum = |from, step: i64| {
        (from..from + 8).fold(Polynomial::constant(step.into()), |sum, v| {
            let coefficient = Rational::from((i64::from(v) * step - 6, 2));
            sum + Polynomial::term(Monomial::of(v), coefficient)
        })
    };
    let (a, b) = (sum(0, 1).pow(2), sum(9, -1).pow(2) * sum(0, 3));
    let pairs = a.len() * b.len();
    assert!(pairs > 4_096, "{pairs} are few");
    let products = a.clone() * b.clone();
    let by_terms = |sum: Polynomial, (monomial, coefficient): &(Monomial, Rational)| {
        sum + b.times_term(monomial, coefficient)
    };
    assert_eq!(
        products,
        a.terms().iter().fold(Polynomial::zero(), by_terms)
    );
    assert!(products.len() < pairs, "some are alike");
}

fn variable(v: Variable) -> Polynomial {
    Polynomial::variable(v)
}

#[test]
fn a_common_denominator_stands_below_once() {
    // x² + x y with x = a/c, y = b/c is (a² + a b)/c².
    let [x, y, a, b, c] = [0, 1, 2, 3, 4].map(variable);
    let quotient = |top: &Polynomial| Fraction::from(top.clone()) / Fraction::from(c.clone());
    let images = HashMap::from([(0, quotient(&a)), (1, quotient(&b))]);
    let value = compose(&(x.clone() * x.clone() + x * y), &images, 100);
    let expected = Fraction::new(a.clone() * a.clone() + a.clone() * b, c.clone() * c.clone());
    assert_eq!(value.ok(), expected);
}

#[test]
fn growth_is_bounded() {
    let x = variable(0);
    let wide = (1..40)
        .map(variable)
        .fold(Polynomial::default(), |sum, v| sum + v);
    let images = HashMap::from([(0, Fraction::from(wide))]);
    assert_eq!(
        compose(&(x.clone() * x.clone() * x), &images, 2_000),
        Err(TooLarge)
    );
}

/// The symmetric tensor in variables 0 to 5, acting on the unknowns 6, 7, 8; the right side is 9, 10, 11.
fn tensor_equations() -> Vec<Polynomial> {
    let at = |r: usize, c: usize| [[0, 3, 4], [3, 1, 5], [4, 5, 2]][r][c];
    let line = |r: usize| {
        let product =
            |c: usize| Polynomial::variable(at(r, c)) * Polynomial::variable(6 + c as u32);
        (0..3)
            .map(product)
            .fold(-Polynomial::variable(9 + r as u32), |sum, p| sum + p)
    };
    (0..3).map(line).collect()
}

#[test]
fn the_solution_satisfies_the_equations() {
    let equations = tensor_equations();
    let solution = solve_linear(&equations, &[6, 7, 8], 1000).expect("the tensor is regular");
    assert_eq!(
        solution.determinant.len(),
        5,
        "a symmetric determinant has five terms"
    );
    for mut equation in equations {
        // Linear in the unknowns, so one determinant clears all three.
        equation = equation.clone() * solution.determinant.clone();
        for (unknown, numerator) in (6..).zip(&solution.numerators) {
            let slope = equation.coefficient_of(unknown, 1);
            let value = slope
                .exact_quotient(&solution.determinant)
                .expect("was multiplied by it");
            equation = equation.coefficient_of(unknown, 0) + value * numerator.clone();
        }
        assert!(equation.is_zero(), "{equation:?}");
    }
}

#[test]
fn each_failure_has_its_name() {
    let [x, y, a] = [0, 1, 2].map(Polynomial::variable);
    let solve = |equations: &[Polynomial]| solve_linear(equations, &[0, 1], 2);
    let sum = x.clone() + y.clone();
    assert_eq!(
        solve(std::slice::from_ref(&sum)),
        Err(LinearError::NotSquare)
    );
    assert_eq!(
        solve(&[x.clone() * y.clone(), x.clone()]),
        Err(LinearError::NotLinear)
    );
    assert_eq!(solve(&[sum.clone(), sum]), Err(LinearError::Singular));
    let long = a.clone() * a.clone() + a.clone() + Polynomial::one();
    let rows = [x.clone() * long.clone() - y.clone() * a, x * long + y];
    assert_eq!(solve(&rows), Err(LinearError::OutOfBudget));
}

#[test]
fn a_number_is_a_square_times_one_that_has_none() {
    for ((n, d), (root, rest)) in [
        ((2, 1), ((1, 1), 2)),
        ((1, 2), ((1, 2), 2)),
        ((12, 1), ((2, 1), 3)),
        ((3, 8), ((1, 4), 6)),
        ((9, 4), ((3, 2), 1)),
        ((10_403 * 10_403, 1), ((10_403, 1), 1)),
    ] {
        let number = Rational::from((n, d));
        let expected = Some((Rational::from(root), rest));
        assert_eq!(number.without_square(), expected, "{number}");
    }
    assert_eq!(Rational::from(0).without_square(), None);
    assert_eq!(Rational::from(-4).without_square(), None);
}
