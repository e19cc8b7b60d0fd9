//! The derived equations of a heavy top, evaluated on numbers, are those that `motion` integrates.

use super::derive_systems::{derived, example};
use nalgebra::{Matrix3, Vector3};
use polhode::motion::{Quaternion, State, System, Torque};
use polhode::notation::ast::{Function, Kind, Node, Operator};
use polhode::notation::{Macros, document::Row as Written, print, read_formula};
use polhode::verify::derivation::{Derived, Law, Row};
use proptest::prelude::*;
use std::collections::HashMap;

/// Values of letters and of rates, by how they are printed.
type Values = HashMap<String, f64>;

fn tree(latex: &str) -> Node {
    match read_formula(latex, 0, &Macros::default()).remove(0) {
        Written::Expression(node) => node,
        other => panic!("{latex} is no expression: {other:?}"),
    }
}

fn value(node: &Node, values: &Values) -> f64 {
    let of = |node: &Node| value(node, values);
    match &node.kind {
        Kind::Number(number) => print::latex(node).parse().unwrap_or_else(|_| {
            let exact = &number.value;
            let [top, bottom] = [exact.numer(), exact.denom()].map(ToString::to_string);
            top.parse::<f64>().expect("digits") / bottom.parse::<f64>().expect("digits")
        }),
        Kind::Symbol(_) | Kind::TimeDerivative { .. } => {
            let name = print::latex(node);
            *values
                .get(&name)
                .unwrap_or_else(|| panic!("no value for {name}"))
        }
        Kind::Negate(inner) => -of(inner),
        Kind::Group(_, inner) => of(inner),
        Kind::Quotient(top, bottom) => of(top) / of(bottom),
        Kind::Power(base, exponent) => of(base).powf(of(exponent)),
        Kind::Function(Function::Sin, angle) => of(angle).sin(),
        Kind::Function(Function::Cos, angle) => of(angle).cos(),
        Kind::Sum(terms) => terms
            .iter()
            .map(|term| {
                if term.negative {
                    -of(&term.node)
                } else {
                    of(&term.node)
                }
            })
            .sum(),
        Kind::Product(factors) => factors
            .iter()
            .map(|factor| {
                assert_eq!(factor.operator, Operator::Juxtaposed);
                of(&factor.node)
            })
            .product(),
        other => panic!("a test has no value for {other:?}"),
    }
}

fn rows(derived: &Derived, law: Law) -> Vec<&Row> {
    let steps = derived.parts.iter().flat_map(|part| &part.steps);
    let steps = steps.filter(|step| step.law == law);
    steps.flat_map(|step| &step.rows).collect()
}

/// A top by its numbers, and how it stands and turns: angles and their rates.
#[derive(Clone, Debug)]
struct Top {
    moments: [f64; 2],
    mass: f64,
    arm: f64,
    gravity: f64,
    angles: [f64; 3],
    rates: [f64; 3],
}

fn tops() -> impl Strategy<Value = Top> {
    (
        (1.0_f64..3.0, 0.2_f64..1.8),
        (0.1_f64..2.0, 0.05_f64..1.0, 1.0_f64..20.0),
        prop::array::uniform3(-3.0_f64..3.0),
        prop::array::uniform3(-4.0_f64..4.0),
    )
        .prop_map(|((a, c), (mass, arm, gravity), angles, rates)| Top {
            moments: [a, c],
            mass,
            arm,
            gravity,
            angles,
            rates,
        })
}

impl Top {
    fn attitude(&self, later: f64) -> Quaternion<f64> {
        let angle = |k: usize| self.angles[k] + later * self.rates[k];
        let about = |axis: Vector3<f64>, k: usize| Quaternion::exp(&(axis * angle(k)));
        about(Vector3::z(), 0) * about(Vector3::x(), 1) * about(Vector3::z(), 2)
    }

    fn values(&self) -> Values {
        let mut values: Values = [
            ("A", self.moments[0]),
            ("C", self.moments[1]),
            ("m", self.mass),
            ("a", self.arm),
            ("g", self.gravity),
        ]
        .map(|(name, value)| (name.to_owned(), value))
        .into();
        for (k, letter) in ["\\varphi", "\\theta", "\\psi"].into_iter().enumerate() {
            values.insert(print::latex(&tree(letter)), self.angles[k]);
            let rate = tree(&format!("\\dot{{{letter}}}"));
            values.insert(print::latex(&rate), self.rates[k]);
        }
        values
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn a_heavy_top_moves_as_derived(top in tops()) {
        let derived = derived(&example("heavy-top"), None, false);
        let mut values = top.values();
        let omega: Vec<f64> = rows(&derived, Law::AngularVelocities)
            .into_iter()
            .map(|row| {
                let omega = value(&tree(&row.right.latex), &values);
                values.insert(print::latex(&tree(&row.left.latex)), omega);
                omega
            })
            .collect();
        let omega = Vector3::from_column_slice(&omega);
        // The angular velocity is that of the attitude.
        let h = 1e-5;
        let turn = top.attitude(-h).conjugate() * top.attitude(h);
        prop_assert!((turn.log() / (2.0 * h) - omega).norm() < 1e-7);

        let [a, c] = top.moments;
        let inertia = Matrix3::from_diagonal(&Vector3::new(a, a, c));
        let torque = Torque::Gravity {
            weight: top.mass * top.gravity,
            arm: Vector3::new(0.0, 0.0, top.arm),
        };
        let system = System::new(inertia, torque).expect("a possible body");
        let state = State { attitude: top.attitude(0.0), angular_velocity: omega };
        let rate = system.rates(0.0, &state).angular_acceleration;
        for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let letter = tree(&format!("\\dot{{\\omega}}_{axis}"));
            values.insert(print::latex(&letter), rate[k]);
        }
        let equations = rows(&derived, Law::Equations);
        prop_assert_eq!(equations.len(), 3);
        for row in equations {
            let [left, right] = [&row.left, &row.right].map(|side| value(&tree(&side.latex), &values));
            let size = 1.0 + omega.norm_squared() * a + top.mass * top.gravity * top.arm;
            prop_assert!((left - right).abs() < 1e-13 * size, "{} is {left}, not {right}", row.left.latex);
        }
    }
}
