//! A function and its derivative, computed together once at each point.

use nalgebra::DVector;
use std::cell::RefCell;

/// What a function gives at a point: the cost there and its gradient, or what they are made of.
pub(super) trait Valued {
    /// The cost.
    fn cost(&self) -> f64;

    /// Its gradient.
    fn gradient(&self) -> DVector<f64>;
}

/// A function that returns value and derivative, and what it returned last: solvers ask for the two one after the other, and
/// some hold their problem by a shared reference.
#[derive(Clone, Debug)]
pub(super) struct Evaluated<F, V> {
    function: F,
    latest: RefCell<Latest<V>>,
}

#[derive(Clone, Debug)]
struct Latest<V> {
    at: DVector<f64>,
    value: Option<V>,
    /// The last point of a value before this one.
    before: Option<(DVector<f64>, V)>,
    /// The highest cost so far.
    highest: f64,
}

impl<V: Valued, F: Fn(&DVector<f64>) -> Option<V>> Evaluated<F, V> {
    pub(super) fn new(start: DVector<f64>, function: F) -> Self {
        let value = function(&start);
        let latest = RefCell::new(Latest {
            highest: value.as_ref().map_or(f64::NEG_INFINITY, V::cost),
            at: start,
            value,
            before: None,
        });
        Self { function, latest }
    }

    /// Goes to other parameters.
    pub(super) fn go_to(&self, parameters: DVector<f64>) {
        if self.latest.borrow().at != parameters {
            let value = (self.function)(&parameters);
            self.latest.borrow_mut().move_to(parameters, value);
        }
    }
}

impl<V: Valued> Latest<V> {
    fn move_to(&mut self, parameters: DVector<f64>, value: Option<V>) {
        if let Some(value) = &value {
            self.highest = self.highest.max(value.cost());
        }
        let at = std::mem::replace(&mut self.at, parameters);
        if let Some(left) = std::mem::replace(&mut self.value, value) {
            self.before = Some((at, left));
        }
    }
}

impl<F, V> Evaluated<F, V> {
    /// Where it is.
    pub(super) fn parameters(&self) -> DVector<f64> {
        self.latest.borrow().at.clone()
    }

    /// What `take` makes of value and derivative there.
    pub(super) fn found<R>(&self, take: impl FnOnce(&V) -> R) -> Option<R> {
        self.latest.borrow().value.as_ref().map(take)
    }

    /// What `take` makes of value and derivative at the last point that had them.
    #[cfg(feature = "levenberg-marquardt")]
    pub(super) fn found_last<R>(&self, take: impl FnOnce(&V) -> R) -> Option<R> {
        self.latest.borrow().before.as_ref().map(|(_, v)| take(v))
    }
}

/// How many times longer a step that has no value is taken to be than the best one.
#[cfg(feature = "argmin")]
const TOO_LONG: f64 = 10.0;

#[cfg(feature = "argmin")]
impl<F, V: Valued> Evaluated<F, V> {
    /// Cost and gradient, also where the function has no value: there they are those of a parabola from the last point that
    /// had one, which falls at first and is back above all costs so far, so that a line search turns back. `None` if there is
    /// no such point.
    pub(super) fn with_wall(&self) -> Option<(f64, DVector<f64>)> {
        let latest = self.latest.borrow();
        if let Some(value) = &latest.value {
            return Some((value.cost(), value.gradient()));
        }
        let (from, value) = latest.before.as_ref()?;
        let (way, gradient) = (&latest.at - from, value.gradient());
        let slope = gradient.dot(&way);
        let rise = (0.5 * TOO_LONG - 1.0) * slope.abs();
        let cost = (value.cost() + rise).max(latest.highest);
        let curvature = 2.0 * (cost - value.cost() - slope) / way.norm_squared();
        Some((cost, gradient + way * curvature))
    }
}
