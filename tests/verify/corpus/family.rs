//! What is true of a rigid body, by subject: the lines that a page about it writes.

use super::energy::{conservation, energy, principal_energy};
use super::expr::{
    Expr, Line, Seen, Vector, cross, equal, frame, inertia, minus, moment, momentum, momentum_dot,
    omega, omega_dot, over, plus, square, times,
};
use super::moving_centre::{
    moving_point, newton, parallel_axes, said_of_moving_point, said_of_newton,
    said_of_parallel_axes,
};
use super::random::Random;
use super::slopes::{gradients, jacobian, quaternion, quaternion_rule, tensor_rate};
use super::style::Style;
use super::tensors::{attitude, changing_inertia, tensor_and_vectors};
use super::world::{Body, Premises};

/// Lines of one subject and what is presupposed.
pub(crate) struct Family {
    pub(crate) name: &'static str,
    pub(crate) premises: Premises,
    /// What the words say of its own symbols.
    pub(crate) said: fn(&Style) -> String,
    /// How it can be written: in plain text too, with indices 1, 2, 3 too.
    plain: bool,
    digits: bool,
    /// Lines that the page assumes before it begins.
    pub(crate) assumed: Vec<Line>,
    pub(crate) lines: Vec<Line>,
}

const BODY: Premises = Premises {
    body: Body::Full,
    turning: false,
    free: false,
};
const TURNING: Premises = Premises {
    turning: true,
    ..BODY
};
const PRINCIPAL: Premises = Premises {
    body: Body::Principal,
    ..BODY
};

pub(crate) fn all() -> Vec<Family> {
    let family = |name, premises, lines| Family {
        name,
        premises,
        said: |_| "The origin is the mass centre. ".to_owned(),
        plain: true,
        digits: true,
        assumed: vec![],
        lines,
    };
    vec![
        family("component equations", BODY, components(&omega)),
        family("components on turning axes", TURNING, components(&frame)),
        family("vector laws", BODY, vector_laws(Vector::Omega)),
        family(
            "vector laws on turning axes",
            TURNING,
            vector_laws(Vector::Frame),
        ),
        family("angular momentum", BODY, momenta()),
        family("full moments", BODY, moments()),
        Family {
            plain: false,
            ..family("matrices", BODY, matrices())
        },
        family("Euler's equations", PRINCIPAL, euler()),
        family(
            "free Euler's equations",
            Premises {
                free: true,
                ..PRINCIPAL
            },
            free_euler(),
        ),
        family(
            "symmetric body",
            Premises {
                body: Body::Symmetric,
                ..BODY
            },
            symmetric(),
        ),
        family("energy", BODY, energy()),
        family("principal energy", PRINCIPAL, principal_energy()),
        family(
            "conservation",
            Premises { free: true, ..BODY },
            conservation(),
        ),
        family("gradients", BODY, gradients()),
        family("Jacobian", PRINCIPAL, jacobian()),
        Family {
            assumed: quaternion_rule(),
            ..family("quaternion", BODY, quaternion())
        },
        family("rate of the tensor", TURNING, tensor_rate()),
        family("changing inertia", TURNING, changing_inertia()),
        family("tensor and vectors", BODY, tensor_and_vectors()),
        Family {
            plain: false,
            ..family("attitude", BODY, attitude())
        },
        Family {
            said: said_of_newton,
            plain: false,
            ..family("Newton's law", BODY, newton())
        },
        Family {
            said: said_of_parallel_axes,
            plain: false,
            digits: false,
            ..family("parallel axes", BODY, parallel_axes())
        },
        Family {
            said: said_of_moving_point,
            plain: false,
            ..family("moving point", BODY, moving_point())
        },
    ]
}

impl Family {
    /// A way to write that can say all that the family says.
    pub(crate) fn style(&self, random: &mut Random) -> Style {
        self.fitted(Style::draw(random))
    }

    /// A way to write, changed where the family cannot be written so.
    pub(crate) fn fitted(&self, style: Style) -> Style {
        let style = match style.plain && !self.plain {
            true => style.in_latex(),
            false => style,
        };
        Style {
            digits: style.digits && self.digits,
            ..style
        }
    }
}

pub(crate) fn ring(line: impl Fn(usize) -> Line) -> Vec<Line> {
    (0..3).map(line).collect()
}

pub(crate) fn product(factors: [Expr; 2]) -> Expr {
    times(factors.into())
}

/// A sum with signs.
pub(crate) fn signed(terms: Vec<(bool, Expr)>) -> Expr {
    Expr::Sum(terms)
}

fn components(turn: &dyn Fn(usize) -> Expr) -> Vec<Line> {
    ring(|i| {
        let first = product([momentum(i + 1), turn(i + 2)]);
        let second = product([momentum(i + 2), turn(i + 1)]);
        equal(
            moment(i),
            signed(vec![
                (false, momentum_dot(i)),
                (true, first),
                (false, second),
            ]),
        )
    })
}

pub(crate) fn whole(vector: Vector) -> Expr {
    Expr::Whole(vector, Seen::Value)
}

fn vector_laws(turn: Vector) -> Vec<Line> {
    let momentum = |seen| Expr::Whole(Vector::Momentum, seen);
    let carried = || cross(whole(turn), whole(Vector::Momentum));
    let mut lines = vec![
        equal(whole(Vector::Moment), momentum(Seen::Space)),
        equal(
            momentum(Seen::Space),
            plus(vec![momentum(Seen::Moving), carried()]),
        ),
        equal(
            whole(Vector::Moment),
            plus(vec![momentum(Seen::Moving), carried()]),
        ),
        equal(
            whole(Vector::Momentum),
            product([Expr::Tensor(0), whole(Vector::Omega)]),
        ),
    ];
    if turn == Vector::Omega {
        let turned = product([Expr::Tensor(0), whole(Vector::Omega)]);
        let rate = Expr::Whole(Vector::Omega, Seen::Moving);
        let inertial = product([Expr::Tensor(0), rate]);
        let gyroscopic = cross(whole(Vector::Omega), turned);
        lines.push(equal(
            whole(Vector::Moment),
            plus(vec![inertial, gyroscopic]),
        ));
    }
    lines
}

/// I_ii a_i − I_ij a_j − I_ik a_k.
fn row(i: usize, of: &dyn Fn(usize) -> Expr) -> Expr {
    let term = |j: usize| product([inertia(i, j), of(j)]);
    signed(vec![
        (false, term(i)),
        (true, term(i + 1)),
        (true, term(i + 2)),
    ])
}

fn momenta() -> Vec<Line> {
    let values = (0..3).map(|i| equal(momentum(i), row(i, &omega)));
    let rates = (0..3).map(|i| equal(momentum_dot(i), row(i, &omega_dot)));
    values.chain(rates).collect()
}

/// Every product of inertia kept.
fn moments() -> Vec<Line> {
    ring(|i| {
        let (j, k) = (i + 1, i + 2);
        let with = |a: usize, b: usize| product([omega(a), omega(b)]);
        let terms = vec![
            (false, product([inertia(i, i), omega_dot(i)])),
            (
                true,
                times(vec![
                    minus(inertia(j, j), inertia(k, k)),
                    omega(j),
                    omega(k),
                ]),
            ),
            (
                true,
                product([inertia(i, j), minus(omega_dot(j), with(k, i))]),
            ),
            (
                true,
                product([inertia(i, k), plus(vec![omega_dot(k), with(i, j)])]),
            ),
            (
                true,
                product([inertia(j, k), minus(square(omega(j)), square(omega(k)))]),
            ),
        ];
        equal(moment(i), signed(terms))
    })
}

fn matrices() -> Vec<Line> {
    let entry = |i: usize, j: usize| match i == j {
        true => inertia(i, j),
        false => signed(vec![(true, inertia(i, j))]),
    };
    let tensor = || Expr::Matrix((0..9).map(|at| entry(at / 3, at % 3)).collect());
    let column = |of: &dyn Fn(usize) -> Expr| Expr::Column((0..3).map(of).collect());
    vec![
        equal(column(&momentum), product([tensor(), column(&omega)])),
        equal(
            column(&momentum_dot),
            product([tensor(), column(&omega_dot)]),
        ),
        equal(
            column(&momentum),
            Expr::Column((0..3).map(|i| row(i, &omega)).collect()),
        ),
    ]
}

/// (I_jj − I_kk) ω_j ω_k.
fn gyroscopic(j: usize, k: usize) -> Expr {
    times(vec![
        minus(inertia(j, j), inertia(k, k)),
        omega(j),
        omega(k),
    ])
}

fn euler() -> Vec<Line> {
    let direct = |i: usize| {
        let inertial = product([inertia(i, i), omega_dot(i)]);
        equal(moment(i), minus(inertial, gyroscopic(i + 1, i + 2)))
    };
    let solved = |i: usize| {
        let top = plus(vec![moment(i), gyroscopic(i + 1, i + 2)]);
        equal(omega_dot(i), over(top, inertia(i, i)))
    };
    let momentum = |i: usize| equal(momentum(i), product([inertia(i, i), omega(i)]));
    (0..3)
        .map(direct)
        .chain((0..3).map(solved))
        .chain((0..3).map(momentum))
        .collect()
}

fn free_euler() -> Vec<Line> {
    let mut lines = ring(|i| {
        let inertial = product([inertia(i, i), omega_dot(i)]);
        equal(inertial, gyroscopic(i + 1, i + 2))
    });
    lines.extend(ring(|i| {
        equal(omega_dot(i), over(gyroscopic(i + 1, i + 2), inertia(i, i)))
    }));
    let powers = (0..3).map(|i| times(vec![inertia(i, i), omega(i), omega_dot(i)]));
    lines.push(equal(plus(powers.collect()), Expr::Number(0, 1)));
    lines
}

fn symmetric() -> Vec<Line> {
    let first = product([inertia(0, 0), omega_dot(0)]);
    let second = product([inertia(0, 0), omega_dot(1)]);
    vec![
        equal(
            moment(0),
            minus(first, gyroscopic(0, 2).map(&mut swap_rate)),
        ),
        equal(
            moment(1),
            plus(vec![
                second,
                times(vec![
                    minus(inertia(0, 0), inertia(2, 2)),
                    omega(2),
                    omega(0),
                ]),
            ]),
        ),
        equal(moment(2), product([inertia(2, 2), omega_dot(2)])),
        equal(momentum(1), product([inertia(0, 0), omega(1)])),
    ]
}

/// ω_y for ω_x: (I_xx − I_zz) ω_x ω_z is written with the moments of the second and third axes.
fn swap_rate(expr: Expr) -> Expr {
    if expr == omega(0) { omega(1) } else { expr }
}
