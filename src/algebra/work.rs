//! How much was worked out: a measure of effort that is the same on every machine.

use std::cell::Cell;

thread_local! {
    static PRODUCTS: Cell<u64> = const { Cell::new(0) };
}

/// How many products of terms this thread has worked out so far.
///
/// ```
/// use polhode::algebra::{Polynomial, products_of_terms};
///
/// let before = products_of_terms();
/// let sum = Polynomial::variable(0) + Polynomial::variable(1);
/// let square = sum.clone() * sum;
/// assert_eq!(square.len(), 3);
/// assert_eq!(products_of_terms() - before, 4);
/// ```
pub fn products_of_terms() -> u64 {
    PRODUCTS.get()
}

/// Counts the products of so many terms with so many others.
#[inline]
pub(in crate::algebra) fn count_products(one: usize, other: usize) {
    let products = one.saturating_mul(other) as u64;
    PRODUCTS.set(PRODUCTS.get().saturating_add(products));
}
