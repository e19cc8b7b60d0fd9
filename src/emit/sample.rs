//! Values of the library itself, for the tests that stand beside the code.

use crate::emit::{Column, Quantity, Request};
use crate::mechanics::{InertiaParameters, angular_acceleration, moment};
use crate::motion::{Quaternion, Rk4, Scheme, State, System, Torque};
use crate::scalar::Jet;
use nalgebra::{Matrix3, SMatrix, Vector3};

/// What goes in and what must come out, each in the order of the function.
pub(super) struct Case {
    pub(super) arguments: Vec<Vec<f64>>,
    pub(super) outputs: Vec<Vec<f64>>,
}

/// Points in general position, of numbers that single precision holds too.
pub(super) fn cases(request: &Request) -> Vec<Case> {
    let points = [
        ([1.5, -0.75, 2.25], [0.25, -0.5, 0.125], 0.03125),
        ([-3.25, 0.5, 1.0], [0.75, 0.375, -1.5], 0.015625),
        ([0.0625, 4.0, -1.75], [-0.125, 2.0, 0.625], 0.0625),
    ];
    let numbered = points.into_iter().enumerate();
    numbered
        .map(|(n, (omega, other, dt))| Point::new(request, n, omega, other, dt).case())
        .collect()
}

struct Point<'a> {
    request: &'a Request,
    inertia: Vec<f64>,
    tensor: Matrix3<f64>,
    state: State<f64>,
    /// The torque or the angular acceleration.
    other: Vector3<f64>,
    dt: f64,
}

impl<'a> Point<'a> {
    fn new(request: &'a Request, n: usize, omega: [f64; 3], other: [f64; 3], dt: f64) -> Self {
        let parameters = [0.625, 0.8125, 1.0, 0.03125, -0.0625, 0.046875];
        let places = request.known.places(request.parameters);
        let scale = 1.0 + n as f64;
        let inertia: Vec<_> = places.into_iter().map(|i| parameters[i] * scale).collect();
        let turns = [
            [0.5, -0.5, 0.5, 0.5],
            [0.1, 0.7, -0.5, 0.5],
            [0.8, 0.0, -0.6, 0.0],
        ];
        Self {
            tensor: request.known.tensor(request.parameters, &inertia, |x| x),
            inertia,
            state: State {
                attitude: Quaternion::new(turns[n % turns.len()]),
                angular_velocity: omega.into(),
            },
            other: other.into(),
            dt,
            request,
        }
    }

    fn case(&self) -> Case {
        let Self { tensor, other, .. } = self;
        let attitude = self.state.attitude.components().to_vec();
        let omega = &self.state.angular_velocity;
        let vector = |v: &Vector3<f64>| v.as_slice().to_vec();
        let mut arguments = vec![self.inertia.clone(), vector(omega), vector(other)];
        let outputs = match self.request.of {
            Quantity::Moment => vec![vector(&moment(tensor, omega, other))],
            Quantity::Regressor => {
                arguments.remove(0);
                let entries = InertiaParameters::MuJoCo.regressor(omega, other) * self.spread();
                vec![entries.transpose().as_slice().to_vec()]
            }
            Quantity::Acceleration => vec![vector(&angular_acceleration(tensor, omega, other))],
            Quantity::Jacobian => {
                let alpha = angular_acceleration(tensor, omega, other);
                vec![vector(&alpha), self.jacobian()]
            }
            Quantity::Step | Quantity::StepJacobian => {
                arguments.insert(1, attitude);
                arguments.push(vec![self.dt]);
                self.step()
            }
        };
        // An inertia that is known is no argument.
        arguments.retain(|argument| !argument.is_empty());
        Case { arguments, outputs }
    }

    /// The derivative of xx, yy, zz, xy, xz, yz of the tensor in the parameters: one column each.
    fn spread(&self) -> nalgebra::OMatrix<f64, nalgebra::Const<6>, nalgebra::Dyn> {
        let count = self.inertia.len();
        let column = |k: usize| {
            let unit: Vec<_> = (0..count).map(|i| f64::from(u8::from(i == k))).collect();
            let Request {
                known, parameters, ..
            } = self.request;
            let tensor = known.tensor(*parameters, &unit, |_| 0.0);
            InertiaParameters::MuJoCo.of_tensor(&tensor)
        };
        nalgebra::OMatrix::<f64, nalgebra::Const<6>, nalgebra::Dyn>::from_fn(count, |r, k| {
            column(k)[r]
        })
    }

    /// The Jacobian of the acceleration, by jets through the inverse.
    fn jacobian(&self) -> Vec<f64> {
        let seed = |v: &Vector3<f64>, first: usize| {
            Vector3::from_fn(|i, _| Jet::<f64, 12>::variable(v[i], first + i))
        };
        let entry = |i: usize, value: f64| Jet::variable(value, 6 + i);
        let entries = InertiaParameters::MuJoCo.of_tensor(&self.tensor);
        let entries = std::array::from_fn(|i| entry(i, entries[i]));
        let tensor = InertiaParameters::MuJoCo.tensor(entries);
        let omega = seed(&self.state.angular_velocity, 0);
        let alpha = angular_acceleration(&tensor, &omega, &seed(&self.other, 3));
        let matrix = SMatrix::<f64, 3, 12>::from_fn(|r, c| alpha[r].partials[c]);
        self.chosen(&matrix, 3)
    }

    fn step(&self) -> Vec<Vec<f64>> {
        let system = System::over(self.tensor, Torque::None, self.other);
        let step = Rk4.step_with_jacobian::<16>(&system, 0.0, &self.state, self.dt);
        let mut outputs = vec![
            step.state.attitude.components().to_vec(),
            step.state.angular_velocity.as_slice().to_vec(),
        ];
        if self.request.of == Quantity::StepJacobian {
            outputs.push(self.chosen(&step.matrix, 0));
        }
        outputs
    }

    /// The columns asked for of a matrix of all columns from number `first` on, row by row.
    fn chosen<const R: usize, const C: usize>(
        &self,
        matrix: &SMatrix<f64, R, C>,
        first: usize,
    ) -> Vec<f64> {
        let spread = self.spread();
        let entry = |row: usize, column: Column| {
            let whole = |from: usize, count: usize| -> Vec<f64> {
                (from - first..from - first + count)
                    .map(|c| matrix[(row, c)])
                    .collect()
            };
            match column {
                Column::Attitude => whole(0, 3),
                Column::AngularVelocity => whole(3, 3),
                Column::Torque => whole(6, 3),
                Column::Dt => whole(15, 1),
                Column::Inertia => {
                    let entries = whole(9, 6);
                    let sum = |k: usize| (0..6).map(|i| entries[i] * spread[(i, k)]).sum();
                    (0..self.inertia.len()).map(sum).collect()
                }
            }
        };
        let columns = self.request.columns();
        (0..R)
            .flat_map(|row| columns.iter().flat_map(move |column| entry(row, *column)))
            .collect()
    }
}
