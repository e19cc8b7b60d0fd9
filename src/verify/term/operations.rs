//! Sums, products and rates of values.

use crate::algebra::{Fraction, Place};
use crate::mechanics;
use crate::verify::model::atoms::{Law, fraction};
use crate::verify::model::system::{FrameId, KeptApart, System, component_text};
use crate::verify::term::value::{Basis, GROWN, Trouble, Value, Valued, beyond, ill_typed};
use num_traits::{One, Zero};

impl System {
    /// The sum of two values of one shape.
    pub(crate) fn plus(&mut self, a: &Value, b: &Value, custom: FrameId) -> Valued {
        if (a.rows, a.columns) != (b.rows, b.columns) {
            if a.is_zero() && a.is_scalar() {
                return Ok(b.clone());
            }
            if b.is_zero() && b.is_scalar() {
                return Ok(a.clone());
            }
            let unequal = format!("{} and {} are added", a.shape(), b.shape());
            return match is_number_beside_matrix(a, b) {
                true => beyond(unequal),
                false => ill_typed(unequal),
            };
        }
        let (a, b) = self.brought_together(a, b, custom)?;
        let (shape, entries) = (a.with_entries(vec![]), a.entries);
        let entries = entries.into_iter().zip(b.entries).map(|(a, b)| a + b);
        Ok(shape.with_entries(entries.collect()))
    }

    /// a b, as a matrix product or a product with a number.
    pub(crate) fn times(&mut self, a: &Value, b: &Value, custom: FrameId) -> Valued {
        if a.is_scalar() {
            return Ok(b.scaled(&a.entries[0]));
        }
        if b.is_scalar() {
            return Ok(a.scaled(&b.entries[0]));
        }
        if let (3, 2, Some(a)) = (a.columns, b.rows, self.in_plane(a)) {
            return self.times(&a, b, custom);
        }
        if let (2, 3, Some(b)) = (a.columns, b.rows, self.in_plane(b)) {
            return self.times(a, &b, custom);
        }
        if a.columns != b.rows {
            let unfit = format!("{} is multiplied by {}", a.shape(), b.shape());
            // Vectors below one another may be the rows of a matrix.
            return match a.is_matrix() && b.rows == 9 {
                true => beyond(unfit),
                false => ill_typed(unfit),
            };
        }
        let (a, b) = self.fitted(a, b, custom)?;
        let mut entries = Vec::with_capacity(a.rows * b.columns);
        for r in 0..a.rows {
            for c in 0..b.columns {
                let mut sum = Fraction::zero();
                for k in 0..a.columns {
                    let (left, right) =
                        (&a.entries[r * a.columns + k], &b.entries[k * b.columns + c]);
                    if !left.is_zero() && !right.is_zero() {
                        sum += left.clone() * right.clone();
                    }
                }
                entries.push(sum);
            }
        }
        let basis = outer(&a, &b);
        Ok(Value {
            rows: a.rows,
            columns: b.columns,
            entries,
            basis,
        })
    }

    /// Factors whose inner indices run over the same axes.
    fn fitted(&mut self, a: &Value, b: &Value, custom: FrameId) -> Result<(Value, Value), Trouble> {
        let (left, right) = (a.basis[1], b.basis[0]);
        let inner = a.columns > 1;
        let fits = match (left, right) {
            _ if !inner => {
                // An outer product: both must be lists, or neither.
                (a.basis[0] == Basis::Written) == (b.basis[1] == Basis::Written)
            }
            (Basis::Written, Basis::Written) => true,
            (Basis::Written, _) | (_, Basis::Written) => false,
            (Basis::On(f), Basis::On(g)) => f == g,
            _ => true,
        };
        match fits {
            true => Ok((a.clone(), b.clone())),
            false => {
                // A list beside an array on a frame is a list on that frame.
                let near = |basis: Basis| match basis {
                    Basis::On(frame) => frame,
                    _ => custom,
                };
                Ok((
                    self.written_out(a, near(right))?,
                    self.written_out(b, near(left))?,
                ))
            }
        }
    }

    /// a · b.
    pub(crate) fn dot(&mut self, a: &Value, b: &Value, custom: FrameId) -> Valued {
        if a.is_scalar() || b.is_scalar() {
            return self.times(a, b, custom);
        }
        if a.is_matrix() {
            return self.times(a, b, custom);
        }
        if b.is_matrix() {
            let transposed = b.transposed();
            return self.times(&transposed, a, custom);
        }
        let row = if a.rows == 1 {
            a.clone()
        } else {
            a.transposed()
        };
        let column = if b.columns == 1 {
            b.clone()
        } else {
            b.transposed()
        };
        self.times(&row, &column, custom)
    }

    /// a × b.
    pub(crate) fn cross(&mut self, a: &Value, b: &Value, custom: FrameId) -> Valued {
        if a.is_scalar() && b.is_scalar() {
            return self.times(a, b, custom);
        }
        if a.is_vector() && b.is_matrix() {
            return self.times(&a.cross_product_matrix()?, b, custom);
        }
        if !a.is_vector() || !b.is_vector() {
            return ill_typed(format!("{} is crossed with {}", a.shape(), b.shape()));
        }
        let (a, b) = self.brought_together(a, b, custom)?;
        let cross = mechanics::cross(&a.to_vector()?, &b.to_vector()?);
        Ok(Value::vector(&cross, a.basis[0]))
    }

    /// a over b.
    pub(crate) fn quotient(&mut self, a: &Value, b: &Value) -> Valued {
        let below = b.to_scalar()?;
        if below.is_zero() {
            return beyond("a division by zero");
        }
        Ok(a.scaled(&(Fraction::one() / below)))
    }

    /// The rate of a value: of an array and of a list entry by entry, of a thing itself as seen from a frame.
    pub(crate) fn rate_of_value(&mut self, value: &Value, seen: FrameId) -> Valued {
        let entries = value.entries.iter();
        let rates = entries.map(|e| self.atoms.short_derivative(e));
        let Some(entries) = rates.collect::<Option<Vec<Fraction>>>() else {
            return beyond(GROWN);
        };
        let mut rate = value.with_entries(entries);
        if value.is_scalar() {
            return Ok(rate);
        }
        let on_work = rate.entries.clone();
        let frame = |basis: Basis| match basis {
            Basis::Itself => Some(seen),
            Basis::On(frame) => Some(frame),
            Basis::Any | Basis::Written => None,
        };
        let size = self.dimensions();
        if value.rows == size
            && let Some(frame) = frame(value.basis[0])
        {
            let turn = self.turning(self.work, frame, value.basis[0])?;
            let carried = self.times(&turn, value, frame)?;
            rate = self.plus(&rate, &carried, frame)?;
        }
        if value.columns == size
            && let Some(frame) = frame(value.basis[1])
        {
            let turn = self.turning(self.work, frame, value.basis[1])?;
            let carried = self.times(value, &turn, frame)?.negated();
            rate = self.plus(&rate, &carried, frame)?;
        }
        if self.apart != KeptApart::Sums && rate.entries != on_work {
            rate.entries = self.kept_apart(&rate);
        }
        Ok(rate)
    }

    /// Variables of their own for the entries of a rate that the transport law gives.
    fn kept_apart(&mut self, rate: &Value) -> Vec<Fraction> {
        let entries = rate.entries.iter().enumerate();
        let apart = entries.map(|(at, entry)| {
            let law = Law {
                name: "transport",
                value: entry.clone(),
            };
            let text = component_text("\\text{rate}", at);
            fraction(self.atoms.determined(&text, Place::Acceleration, law))
        });
        apart.collect()
    }

    /// The square root of a number: a length by its square.
    pub(crate) fn root(&mut self, of: &Fraction) -> Valued {
        match self.atoms.root(of) {
            Some(root) => Ok(Value::scalar(root)),
            None => beyond("a root that is not worked out"),
        }
    }

    /// The inverse of a number or of a matrix.
    pub(crate) fn inverse(&mut self, value: &Value) -> Valued {
        if value.is_scalar() {
            return self.quotient(&Value::scalar(Fraction::one()), value);
        }
        let matrix = value.to_matrix()?;
        let determinant = mechanics::determinant(&matrix);
        if determinant.is_zero() {
            return beyond("the inverse of a matrix that has none");
        }
        let inverse = mechanics::adjugate(&matrix).map(|e| e / determinant.clone());
        Ok(Value::matrix(&inverse, [value.basis[1], value.basis[0]]))
    }

    /// Sides that are compared: of one shape and on the same axes.
    pub(crate) fn compared(
        &mut self,
        a: &Value,
        b: &Value,
        custom: FrameId,
    ) -> Result<(Value, Value), Trouble> {
        let same = (a.rows, a.columns) == (b.rows, b.columns);
        if same {
            return self.brought_together(a, b, custom);
        }
        if let Some(pair) = self.axis_pair.filter(|pair| pair.told) {
            let plane = (pair.frame, pair.axes);
            let column = |value: &Value| (value.rows, value.columns) == (2, 1);
            if a.is_vector() && column(b) {
                return Ok((self.on_two_axes(a, plane)?, b.clone()));
            }
            if column(a) && b.is_vector() {
                return Ok((a.clone(), self.on_two_axes(b, plane)?));
            }
        }
        let alike = |a: &Value, b: &Value| (a.rows, a.columns) == (b.rows, b.columns);
        if let Some(a) = self.in_plane(a).filter(|a| alike(a, b)) {
            return Ok((a, b.clone()));
        }
        if let Some(b) = self.in_plane(b).filter(|b| alike(a, b)) {
            return Ok((a.clone(), b));
        }
        // A lone 0 stands for whatever is zero, a bold one for whatever array is, and a row for a column where only one of
        // them is written out.
        if stands_for_zero_of(a, b) {
            return Ok((zero_like(b), b.clone()));
        }
        if stands_for_zero_of(b, a) {
            return Ok((a.clone(), zero_like(a)));
        }
        if a.is_row() && b.is_vector() && a.basis[1] == Basis::Written {
            return self.brought_together(&a.transposed(), b, custom);
        }
        if a.is_vector() && b.is_row() && b.basis[1] == Basis::Written {
            return self.brought_together(a, &b.transposed(), custom);
        }
        let unequal = format!("{} is set equal to {}", a.shape(), b.shape());
        // Columns of two are for motion in a plane, which the model need not know of.
        // Vectors below one another may be the rows of a matrix.
        let in_rows = a.entries.len() == 9 && b.entries.len() == 9;
        let one = |value: &Value| value.is_scalar() && value.entries[0].is_one();
        let identity = is_number_beside_matrix(a, b) && (one(a) || one(b));
        match a.rows == 2 || b.rows == 2 || in_rows || identity {
            true => beyond(unequal),
            false => ill_typed(unequal),
        }
    }
}

/// Whether a value is a 0 that may be one of the shape of another.
fn stands_for_zero_of(zero: &Value, other: &Value) -> bool {
    let bold = zero.basis[0] == Basis::Any && !other.is_scalar();
    zero.is_zero() && (zero.is_scalar() || bold)
}

fn zero_like(value: &Value) -> Value {
    Value {
        entries: vec![Fraction::zero(); value.entries.len()],
        ..value.clone()
    }
}

/// Whether one of two values is a number and the other one a square matrix: the number may mean as many times the identity.
fn is_number_beside_matrix(a: &Value, b: &Value) -> bool {
    let square = |matrix: &Value| matrix.rows > 1 && matrix.rows == matrix.columns;
    a.is_scalar() && square(b) || square(a) && b.is_scalar()
}

impl System {
    /// What a matrix or a column on axes is in the plane of columns of two: a matrix leaves that plane to itself, and where no
    /// sentence says which plane that is, it is the one across which a column has nothing.
    fn in_plane(&self, value: &Value) -> Option<Value> {
        let axes = self.axis_pair.map_or([0, 1], |pair| pair.axes);
        let across = 3 - axes[0] - axes[1];
        let entry = |row: usize, column: usize| &value.entries[row * value.columns + column];
        let zero = |&axis: &usize| entry(axis, across).is_zero() && entry(across, axis).is_zero();
        let on_axes = |basis: &Basis| matches!(basis, Basis::On(_));
        match (value.rows, value.columns, value.basis[0]) {
            (3, 3, _) if value.basis.iter().all(on_axes) && axes.iter().all(zero) => {
                let pairs = axes
                    .iter()
                    .flat_map(|&row| axes.map(|column| (row, column)));
                let entries = pairs.map(|(row, column)| entry(row, column).clone());
                Some(Value::written(2, 2, entries.collect()))
            }
            (3, 1, Basis::On(frame)) => {
                let within = match self.axis_pair {
                    Some(pair) => pair.frame == frame,
                    None => entry(across, 0).is_zero(),
                };
                let entries = axes.iter().map(|&row| entry(row, 0).clone());
                within.then(|| Value::written(2, 1, entries.collect()))
            }
            _ => None,
        }
    }

    /// The components of a vector on two axes of a frame.
    pub(super) fn on_two_axes(
        &mut self,
        vector: &Value,
        (frame, axes): (FrameId, [usize; 2]),
    ) -> Valued {
        let vector = vector.to_vector()?;
        let entries = axes.map(|axis| self.axis(frame, axis).dot(&vector));
        Ok(Value::written(2, 1, entries.to_vec()))
    }
}

/// The axes of what a product leaves; of the thing itself times an array those of the array.
fn outer(a: &Value, b: &Value) -> [Basis; 2] {
    let taken = |own: Basis, other: Basis| match (own, other) {
        (Basis::Itself | Basis::Any, Basis::On(frame)) => Basis::On(frame),
        (Basis::Any, Basis::Itself) => Basis::Itself,
        _ => own,
    };
    let square = |value: &Value| value.columns == value.rows && value.rows > 1;
    let left = if square(a) {
        taken(a.basis[0], inner_if_same(a, b.basis[0]))
    } else {
        a.basis[0]
    };
    let right = if square(b) {
        taken(b.basis[1], inner_if_same(b, a.basis[1]))
    } else {
        b.basis[1]
    };
    [left, right]
}

/// The axes of the other factor, where this one is a tensor itself.
fn inner_if_same(tensor: &Value, other: Basis) -> Basis {
    match tensor.basis {
        [a, b] if a == b => other,
        [own, _] => own,
    }
}
