//! A Jacobian held against the right one.

use super::by_differences::{Grain, Ladder, Quotient};
use super::by_dual_numbers::{Reference, reference};
use super::cause::{Cause, Kind};
use super::dual_vector::DualVector;
use super::explain::{Problem, causes};
use super::report::{Entry, Report, Verdict};
use super::scale::equilibrate;
use super::slot::Slot;
use nalgebra::{
    DMatrix, DVector, DefaultAllocator, Dim, OMatrix, OVector, Scalar, allocator::Allocator,
};
use num_dual::Dual64;
use std::collections::BTreeSet;

/// Holds the `jacobian` of `f` at a point against dual numbers.
///
/// `f` is generic over its number, as `fn f<T: Number>(x: &SVector<T, 3>) -> SVector<T, 2>`, or a closure over
/// `&SVector<Dual64, 3>`; vectors of a length that is known at run time only (`DVector`) are taken as well. A Jacobian that
/// has been computed already is given as `|_| matrix`. To name rows and columns, use [`Check`]. Costs five times as many
/// values of `f` as it has inputs.
pub fn check<M: Dim, N: Dim, X: DualVector<N>, Y: DualVector<M>>(
    f: impl Fn(&X) -> Y,
    jacobian: impl FnOnce(&OVector<f64, N>) -> OMatrix<f64, M, N>,
    at: &OVector<f64, N>,
) -> Report
where
    DefaultAllocator: Allocator<M> + Allocator<N> + Allocator<M, N>,
{
    Check::default().of(f, jacobian, at)
}

/// Holds the `jacobian` of a function of which only values can be had against its differences.
///
/// Takes differences over a range of steps. Where the Jacobian is right, the Taylor remainder |f(x + h) − f(x) − h J| falls as
/// h²; where it is wrong, as h. An entry of which the differences are noise at every step, or on either side of a kink, is
/// said to be [`Verdict::Unsure`], not wrong. Costs 240 values of `f` for each input.
///
/// ```
/// use nalgebra::{SMatrix, SVector};
/// use polhode::jacobian::{Verdict, check_black_box};
/// let f = |x: &SVector<f64, 2>| SVector::from([x[0].sin() * x[1], x[1].powi(3)]);
/// let right = |x: &SVector<f64, 2>| {
///     SMatrix::<f64, 2, 2>::new(x[0].cos() * x[1], x[0].sin(), 0.0, 3.0 * x[1] * x[1])
/// };
/// let at = SVector::from([0.4, 1.7]);
/// assert!(check_black_box(f, right, &at).is_right());
/// let report = check_black_box(f, |x| right(x) * 2.0, &at);
/// assert_eq!(report.verdict(), Verdict::Wrong);
/// assert!((report.entries()[0].slope.unwrap() - 1.0).abs() < 0.1);
/// // Values in single precision hide the derivative's last digits, and are no reason to blame it.
/// let coarse = |x: &SVector<f64, 2>| f(x).map(|y| f64::from(y as f32));
/// assert_ne!(check_black_box(coarse, right, &at).verdict(), Verdict::Wrong);
/// ```
pub fn check_black_box<M: Dim, N: Dim>(
    f: impl Fn(&OVector<f64, N>) -> OVector<f64, M>,
    jacobian: impl FnOnce(&OVector<f64, N>) -> OMatrix<f64, M, N>,
    at: &OVector<f64, N>,
) -> Report
where
    DefaultAllocator: Allocator<M> + Allocator<N> + Allocator<M, N>,
{
    Check::default().of_black_box(f, jacobian, at)
}

/// A check with names for rows and columns and a tolerance of one's own.
#[derive(Clone, Debug)]
pub struct Check {
    rows: Vec<Slot>,
    columns: Vec<Slot>,
    tolerance: f64,
}

impl Default for Check {
    fn default() -> Self {
        Self {
            rows: vec![],
            columns: vec![],
            tolerance: 1e-9,
        }
    }
}

impl Check {
    /// With names for the rows. What the slots leave over is numbered.
    pub fn rows(mut self, slots: impl IntoIterator<Item = Slot>) -> Self {
        self.rows = slots.into_iter().collect();
        self
    }

    /// With names for the columns. What the slots leave over is numbered.
    pub fn columns(mut self, slots: impl IntoIterator<Item = Slot>) -> Self {
        self.columns = slots.into_iter().collect();
        self
    }

    /// With the part of itself that an entry may be off, 1e-9 unless said.
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// As [`check`].
    pub fn of<M: Dim, N: Dim, X: DualVector<N>, Y: DualVector<M>>(
        &self,
        f: impl Fn(&X) -> Y,
        jacobian: impl FnOnce(&OVector<f64, N>) -> OMatrix<f64, M, N>,
        at: &OVector<f64, N>,
    ) -> Report
    where
        DefaultAllocator: Allocator<M> + Allocator<N> + Allocator<M, N>,
    {
        let dynamic = |x: &DVector<Dual64>| {
            let x = X::of(sized_like(at, x));
            unsized_vector(&f(&x).vector())
        };
        let given = unsized_matrix(&jacobian(at));
        let at = unsized_vector(at);
        let right = reference(&dynamic, &at, self.tolerance);
        let judge = |r: usize, c: usize| {
            let (given, right, slack) = (given[(r, c)], right.matrix[(r, c)], right.slack[(r, c)]);
            let verdict = if !(right.is_finite() && slack.is_finite()) {
                Verdict::Unsure
            } else if (given - right).abs() <= slack {
                Verdict::Right
            } else {
                Verdict::Wrong
            };
            (verdict, None)
        };
        self.report(&given, &right, judge, false)
    }

    /// As [`check_black_box`].
    pub fn of_black_box<M: Dim, N: Dim>(
        &self,
        f: impl Fn(&OVector<f64, N>) -> OVector<f64, M>,
        jacobian: impl FnOnce(&OVector<f64, N>) -> OMatrix<f64, M, N>,
        at: &OVector<f64, N>,
    ) -> Report
    where
        DefaultAllocator: Allocator<M> + Allocator<N> + Allocator<M, N>,
    {
        let dynamic = |x: &DVector<f64>| unsized_vector(&f(&sized_like(at, x)));
        let given = unsized_matrix(&jacobian(at));
        let at = unsized_vector(at);
        let quotients = quotients(&dynamic, &at, &given);
        self.by_differences(&at, &given, &quotients)
    }

    /// The verdicts from what differences tell of each entry.
    fn by_differences(
        &self,
        at: &DVector<f64>,
        given: &DMatrix<f64>,
        quotients: &DMatrix<Quotient>,
    ) -> Report {
        let right = Reference {
            matrix: quotients.map(|q| q.value),
            slack: quotients.map(|q| 4.0 * q.error + self.tolerance * q.value.abs()),
        };
        let told = |q: Quotient| {
            if q.value.abs() > 4.0 * q.error {
                q.value
            } else {
                0.0
            }
        };
        let (rows, columns) = equilibrate(&quotients.map(told));
        let largest = largest(at);
        let judge = |r: usize, c: usize| {
            let q = quotients[(r, c)];
            let natural = (rows[r] * columns[c]).max(q.size / largest);
            let size = natural.max(q.value.abs()).max(given[(r, c)].abs());
            let off = (given[(r, c)] - q.value).abs();
            let linear = || q.slope.is_some_and(|slope| (0.5..1.5).contains(&slope));
            let verdict = if !q.error.is_finite() || !q.smooth {
                Verdict::Unsure
            } else if off > right.slack[(r, c)] {
                if linear() {
                    Verdict::Wrong
                } else {
                    Verdict::Unsure
                }
            } else if q.error <= 1e-3 * size {
                Verdict::Right
            } else {
                Verdict::Unsure
            };
            (verdict, q.slope)
        };
        self.report(given, &right, judge, true)
    }

    fn report(
        &self,
        given: &DMatrix<f64>,
        right: &Reference,
        judge: impl Fn(usize, usize) -> (Verdict, Option<f64>),
        black_box: bool,
    ) -> Report {
        let Reference { matrix, slack } = right;
        if given.shape() != matrix.shape() {
            return self.misshapen(given, matrix, slack, black_box);
        }
        let entries = entries(given, right, judge);
        let wrong: BTreeSet<_> = entries
            .iter()
            .filter(|e| e.verdict == Verdict::Wrong)
            .map(|e| (e.row, e.column))
            .collect();
        let problem = Problem {
            given,
            right: matrix,
            slack,
            wrong: &wrong,
            rows: &self.rows,
            columns: &self.columns,
        };
        let causes = if wrong.is_empty() {
            vec![]
        } else {
            causes(&problem)
        };
        self.told([matrix.nrows(), matrix.ncols()], entries, causes, black_box)
    }

    /// The report on a matrix of the wrong shape, which may be the transpose.
    fn misshapen(
        &self,
        given: &DMatrix<f64>,
        right: &DMatrix<f64>,
        slack: &DMatrix<f64>,
        black_box: bool,
    ) -> Report {
        let shape = [right.nrows(), right.ncols()];
        let turned = given.transpose();
        let mut close = turned.shape() == right.shape();
        close = close
            && turned
                .iter()
                .zip(right.iter().zip(slack.iter()))
                .all(|(g, (r, s))| (g - r).abs() <= *s);
        let cause = Cause {
            kind: Kind::Shape([given.nrows(), given.ncols()], shape),
            or: if close {
                vec![Kind::Transposed]
            } else {
                vec![]
            },
            rows: (0..shape[0]).collect(),
            columns: (0..shape[1]).collect(),
            explains: 0,
        };
        self.told(shape, vec![], vec![cause], black_box)
    }

    fn told(
        &self,
        shape: [usize; 2],
        entries: Vec<Entry>,
        causes: Vec<Cause>,
        black_box: bool,
    ) -> Report {
        Report {
            entries,
            causes,
            rows: self.rows.clone(),
            columns: self.columns.clone(),
            shape,
            black_box,
        }
    }
}

/// The entries and what is known of each, the worst first.
fn entries(
    given: &DMatrix<f64>,
    Reference { matrix, slack }: &Reference,
    judge: impl Fn(usize, usize) -> (Verdict, Option<f64>),
) -> Vec<Entry> {
    let (rows, columns) = equilibrate(&matrix.map(|x| if x.is_finite() { x } else { 0.0 }));
    let places = (0..matrix.nrows()).flat_map(|r| (0..matrix.ncols()).map(move |c| (r, c)));
    let entry = |(r, c): (usize, usize)| {
        let (given, right) = (given[(r, c)], matrix[(r, c)]);
        let natural = (rows[r] * columns[c]).max(right.abs());
        let off = (given - right).abs();
        let (verdict, slope) = judge(r, c);
        Entry {
            row: r,
            column: c,
            given,
            right,
            error: slack[(r, c)],
            discrepancy: if natural > 0.0 { off / natural } else { off },
            verdict: if given.is_finite() {
                verdict
            } else {
                Verdict::Wrong
            },
            slope,
        }
    };
    let mut entries: Vec<_> = places.map(entry).collect();
    let rank = |off: f64| if off.is_nan() { f64::INFINITY } else { off };
    entries.sort_by(|a, b| {
        let by_size = rank(b.discrepancy).total_cmp(&rank(a.discrepancy));
        b.verdict.cmp(&a.verdict).then(by_size)
    });
    entries
}

/// The largest input, and at least 1: where an input is zero, the only scale that is known.
fn largest(at: &DVector<f64>) -> f64 {
    at.iter().fold(1.0_f64, |most, x| most.max(x.abs()))
}

/// What differences tell of each entry, with the slope of the remainder of what was given for it.
fn quotients(
    f: &impl Fn(&DVector<f64>) -> DVector<f64>,
    at: &DVector<f64>,
    given: &DMatrix<f64>,
) -> DMatrix<Quotient> {
    let largest = largest(at);
    // An input that is not zero tells its own scale, if roughly.
    let scale = |x: f64| {
        if x == 0.0 {
            largest
        } else {
            largest.min(100.0 * x.abs())
        }
    };
    let ladder = |c: usize| Ladder::new(f, at, c, scale(at[c]));
    let ladders: Vec<_> = (0..at.len()).map(ladder).collect();
    let height = f(at).len();
    let grains: Vec<_> = (0..height).map(|r| Grain::of(&ladders, r)).collect();
    DMatrix::from_fn(height, at.len(), |r, c| {
        let given = given.get((r, c)).copied().unwrap_or(0.0);
        ladders[c].quotient(r, grains[r], given)
    })
}

/// A vector with the length of another.
fn sized_like<T: Scalar + Copy, N: Dim>(
    other: &OVector<f64, N>,
    entries: &DVector<T>,
) -> OVector<T, N>
where
    DefaultAllocator: Allocator<N>,
{
    let (rows, columns) = other.shape_generic();
    OVector::from_fn_generic(rows, columns, |i, _| entries[i])
}

fn unsized_vector<T: Scalar + Copy, N: Dim>(vector: &OVector<T, N>) -> DVector<T>
where
    DefaultAllocator: Allocator<N>,
{
    DVector::from_iterator(vector.len(), vector.iter().copied())
}

fn unsized_matrix<M: Dim, N: Dim>(matrix: &OMatrix<f64, M, N>) -> DMatrix<f64>
where
    DefaultAllocator: Allocator<M, N>,
{
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |r, c| matrix[(r, c)])
}
