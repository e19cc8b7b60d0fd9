//! A function and its derivative, computed together once at each point.

use nalgebra::DVector;
use std::cell::RefCell;

/// A function that returns value and derivative, and what it returned last: solvers ask for the two one after the other, and
/// some hold their problem by a shared reference.
#[derive(Clone, Debug)]
pub(super) struct Evaluated<F, V> {
    function: F,
    latest: RefCell<(DVector<f64>, Option<V>)>,
}

impl<V, F: Fn(&DVector<f64>) -> Option<V>> Evaluated<F, V> {
    pub(super) fn new(start: DVector<f64>, function: F) -> Self {
        let value = function(&start);
        let latest = RefCell::new((start, value));
        Self { function, latest }
    }

    /// Goes to other parameters.
    pub(super) fn go_to(&self, parameters: DVector<f64>) {
        if self.latest.borrow().0 != parameters {
            let value = (self.function)(&parameters);
            self.latest.replace((parameters, value));
        }
    }
}

impl<F, V> Evaluated<F, V> {
    /// Where it is.
    pub(super) fn parameters(&self) -> DVector<f64> {
        self.latest.borrow().0.clone()
    }

    /// What `take` makes of value and derivative there.
    pub(super) fn found<R>(&self, take: impl FnOnce(&V) -> R) -> Option<R> {
        self.latest.borrow().1.as_ref().map(take)
    }
}
