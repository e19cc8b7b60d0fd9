//! The equations, run on symbols.

use crate::emit::adjoint::pull_back;
use crate::emit::body::INDICES;
use crate::emit::graph::{Operation, Symbol};
use crate::emit::routine::{Argument, Letter, Output, letter, matrix, plain, three, vector};
use crate::emit::{Column, KnownInertia, Quantity, Request};
use crate::mechanics::{self, InertiaParameters, Products, apply};
use crate::motion::{Number, Quaternion, Rk4, Scheme, State, System, Torque};
use crate::scalar::{Jet, Ring};
use nalgebra::{Matrix3, Vector3};
use num_traits::{One, Zero};

/// The arguments as far as they have been taken.
pub(super) struct Given<'a> {
    request: &'a Request,
    pub(super) arguments: Vec<Argument>,
    parameters: Vec<Symbol>,
    tensor: Matrix3<Symbol>,
    omega: Vector3<Symbol>,
}

impl<'a> Given<'a> {
    pub(super) fn new(request: &'a Request) -> Self {
        Self {
            request,
            arguments: vec![],
            parameters: vec![],
            tensor: Matrix3::zeros(),
            omega: Vector3::zeros(),
        }
    }

    /// What the request asks for, and in `arguments` what it takes.
    pub(super) fn outputs(&mut self) -> Vec<Output> {
        let Request { of, known, .. } = self.request;
        if *of == Quantity::StepJacobian || *of == Quantity::Step {
            return self.step();
        }
        if *of != Quantity::Regressor {
            self.take_inertia();
        }
        self.take_omega();
        let (tensor, omega) = (self.tensor, self.omega);
        match of {
            Quantity::Moment => {
                let alpha = self.take_vector("alpha", "angular acceleration, rad/s^2", "a");
                let moment = moment(known, &tensor, &omega, &alpha);
                vec![vector("moment", "N m", &three("m"), moment.as_slice())]
            }
            Quantity::Regressor => {
                let alpha = self.take_vector("alpha", "angular acceleration, rad/s^2", "a");
                let columns = self.regressor(&omega, &alpha);
                let names = self.parameter_letters();
                vec![matrix(
                    "regressor",
                    "the moment is regressor * inertia",
                    (three("m"), names),
                    columns.iter().map(|column| column.as_slice()),
                )]
            }
            _ => {
                let torque = self.take_torque();
                let system = system(known, tensor, torque);
                let alpha = acceleration(&system, omega);
                let mut outputs = vec![vector("alpha", "rad/s^2", &three("a"), alpha.as_slice())];
                if *of == Quantity::Jacobian {
                    outputs.push(self.jacobian(&system, &alpha));
                }
                outputs
            }
        }
    }

    /// The Jacobian of the acceleration α in ω, torque and inertia.
    ///
    /// It solves M = Iα + ω × Iω, so I δα = δM − δ(Iα + ω × Iω) with α held: no inverse is differentiated.
    fn jacobian(&self, system: &System<Symbol, Torque>, alpha: &Vector3<Symbol>) -> Output {
        let known = &self.request.known;
        let mut moments = vec![];
        if self.wants(Column::AngularVelocity) {
            let moving = Vector3::from_fn(|i, _| Jet::<Symbol, 3>::variable(self.omega[i], i));
            let (tensor, alpha) = (self.tensor.map(Jet::constant), alpha.map(Jet::constant));
            let moment = moment(known, &tensor, &moving, &alpha);
            moments.extend((0..3).map(|k| moment.map(|m| -m.partials[k])));
        }
        if self.wants(Column::Torque) {
            moments.extend((0..3).map(|k| Vector3::ith(k, Symbol::one())));
        }
        if self.wants(Column::Inertia) {
            moments.extend(self.regressor(&self.omega, alpha).iter().map(|m| -m));
        }
        let columns: Vec<_> = moments
            .iter()
            .map(|moment| apply(system.inverse(), moment))
            .collect();
        matrix(
            "jacobian",
            "of alpha",
            (three("a"), self.column_letters()),
            columns.iter().map(|column| column.as_slice()),
        )
    }

    /// The moment of each parameter's own unit: what it is multiplied by, as the moment is linear in the tensor.
    fn regressor(&self, omega: &Vector3<Symbol>, alpha: &Vector3<Symbol>) -> Vec<Vector3<Symbol>> {
        let Request {
            known, parameters, ..
        } = self.request;
        let count = known.places(*parameters).len();
        let unit = |k: usize| {
            let values: Vec<_> = (0..count)
                .map(|i| Symbol::of(f64::from(u8::from(i == k))))
                .collect();
            known.tensor(*parameters, &values, Symbol::of)
        };
        // Not Euler's equations: differences of moments would part what stands in one product.
        let moment = |k| mechanics::moment(&unit(k), omega, alpha);
        (0..count).map(moment).collect()
    }

    /// A Runge–Kutta step from no turn, which the attitude is then turned by: the body does not know where it stands in space.
    fn step(&mut self) -> Vec<Output> {
        self.take_inertia();
        let letters = ["w", "x", "y", "z"].map(|i| letter("q", i));
        let about = "unit quaternion w, x, y, z, body to space".to_owned();
        let attitude = self.take("attitude", about, letters.into());
        self.take_omega();
        let torque = self.take_torque();
        let dt = self.take("dt", "length of the step, s".into(), vec![plain("dt")])[0];
        let system = system(&self.request.known, self.tensor, torque);
        let start = State::at_rest().turning(self.omega);
        let end = Rk4.step(&system, Symbol::zero(), &start, dt);
        let attitude: [Symbol; 4] = std::array::from_fn(|i| attitude[i]);
        // Made unit again: many steps would add up what rounding does to the length.
        let turned = (Quaternion::new(attitude) * end.attitude).normalised();
        let [omega, attitude] = [end.angular_velocity.as_slice(), &turned.components()];
        let letters = ["w", "x", "y", "z"].map(|i| letter("q'", i));
        let mut outputs = vec![
            vector("attitude_after", "unit quaternion", &letters, attitude),
            vector("omega_after", "rad/s", &three("w'"), omega),
        ];
        if self.request.of == Quantity::StepJacobian {
            outputs.push(self.step_jacobian(&end, torque, dt));
        }
        outputs
    }

    fn step_jacobian(&self, end: &State<Symbol>, torque: Vector3<Symbol>, dt: Symbol) -> Output {
        let mut inputs = vec![];
        for (column, symbols) in [
            (Column::AngularVelocity, self.omega.as_slice()),
            (Column::Torque, torque.as_slice()),
            (Column::Inertia, &self.parameters),
            (Column::Dt, &[dt]),
        ] {
            if self.wants(column) {
                inputs.extend_from_slice(symbols);
            }
        }
        let back = end.attitude.matrix().transpose();
        let mut entries = vec![];
        for row in 0..6 {
            if self.wants(Column::Attitude) {
                let by_attitude = |k| {
                    if row < 3 {
                        back[(row, k)]
                    } else {
                        Symbol::zero()
                    }
                };
                entries.extend((0..3).map(by_attitude));
            }
            // The only root is the length of the attitude, and a change of length is no turn.
            let is_held = |operation| matches!(operation, Operation::Root(_));
            entries.extend(pull_back(tangent(end, row), &inputs, is_held));
        }
        Output {
            name: "jacobian",
            about: "of the tangent (theta, omega) after the step, theta on the body side: q exp(theta/2)",
            rows: [three("theta'"), three("w'")].concat(),
            columns: self.column_letters(),
            entries,
        }
    }

    fn wants(&self, column: Column) -> bool {
        self.request.columns().contains(&column)
    }

    /// The names of the columns of a Jacobian.
    fn column_letters(&self) -> Vec<Letter> {
        let letters = |column: &Column| match column {
            Column::Attitude => three("theta").into(),
            Column::AngularVelocity => three("w").into(),
            Column::Torque => three("m").into(),
            Column::Inertia => self.parameter_letters(),
            Column::Dt => vec![plain("dt")],
        };
        self.request.columns().iter().flat_map(letters).collect()
    }

    fn parameter_letters(&self) -> Vec<Letter> {
        let places = self.request.known.places(self.request.parameters);
        places
            .into_iter()
            .map(|i| letter("i", INDICES[i]))
            .collect()
    }

    fn take(&mut self, name: &'static str, about: String, letters: Vec<Letter>) -> Vec<Symbol> {
        let first: usize = self.arguments.iter().map(|a| a.letters.len()).sum();
        let symbols = (first..).map(Symbol::input).take(letters.len()).collect();
        self.arguments.push(Argument {
            name,
            about,
            is_number: name == "dt",
            letters,
        });
        symbols
    }

    fn take_vector(&mut self, name: &'static str, about: &str, stem: &str) -> Vector3<Symbol> {
        let symbols = self.take(name, about.to_owned(), three(stem).into());
        Vector3::from_fn(|i, _| symbols[i])
    }

    fn take_omega(&mut self) {
        self.omega = self.take_vector("omega", "angular velocity, body axes, rad/s", "w");
    }

    fn take_torque(&mut self) -> Vector3<Symbol> {
        self.take_vector("torque", "torque, body axes, N m", "m")
    }

    /// The parameters of the tensor, and the tensor; a tensor that is known takes no argument.
    fn take_inertia(&mut self) {
        let Request {
            known, parameters, ..
        } = self.request;
        let letters = self.parameter_letters();
        if !letters.is_empty() {
            self.parameters = self.take("inertia", about_inertia(known, *parameters), letters);
        }
        self.tensor = known.tensor(*parameters, &self.parameters, Symbol::of);
    }
}

/// The order, the sign and what is known.
fn about_inertia(known: &KnownInertia, parameters: InertiaParameters) -> String {
    let listed = known.places(parameters).into_iter().map(|i| INDICES[i]);
    let order = listed.collect::<Vec<_>>().join(", ");
    let more = match known {
        KnownInertia::Full | KnownInertia::OnePlane => match parameters.products() {
            Products::Entries => ", the tensor's own entries: its xy is -integral of x y dm",
            Products::Integrals => ", with xy = integral of x y dm: the tensor holds -xy",
        },
        KnownInertia::Axisymmetric => ", along principal axes with I_yy = I_xx",
        KnownInertia::Sphere => ", the moment about any axis",
        KnownInertia::Principal | KnownInertia::Tensor(_) => ", along principal axes",
    };
    format!("{order}, kg m^2{more}")
}

/// Tangent component `row` of a state, as a sum of the state's numbers with weights: 2 Im(q⁻¹ δq), then δω.
fn tangent(state: &State<Symbol>, row: usize) -> Vec<(Symbol, Symbol)> {
    if row >= 3 {
        return vec![(state.angular_velocity[row - 3], Symbol::one())];
    }
    let weight = |k: usize| {
        let unit = std::array::from_fn(|i| Symbol::of(if i == k { 2.0 } else { 0.0 }));
        (state.attitude.conjugate() * Quaternion::new(unit)).v[row]
    };
    let components = state.attitude.components().into_iter().enumerate();
    components.map(|(k, q)| (q, weight(k))).collect()
}

fn system(
    known: &KnownInertia,
    tensor: Matrix3<Symbol>,
    torque: Vector3<Symbol>,
) -> System<Symbol, Torque> {
    let system = System::over(tensor, Torque::None, torque);
    match known.is_principal() {
        true => system.along_principal_axes(),
        false => system,
    }
}

fn acceleration(system: &System<Symbol, Torque>, omega: Vector3<Symbol>) -> Vector3<Symbol> {
    let state = State::at_rest().turning(omega);
    system.rates(Symbol::zero(), &state).angular_acceleration
}

fn moment<T: Ring>(
    known: &KnownInertia,
    tensor: &Matrix3<T>,
    omega: &Vector3<T>,
    alpha: &Vector3<T>,
) -> Vector3<T> {
    match known.is_principal() {
        true => mechanics::euler_principal(&tensor.diagonal(), omega, alpha),
        false => mechanics::moment(tensor, omega, alpha),
    }
}
