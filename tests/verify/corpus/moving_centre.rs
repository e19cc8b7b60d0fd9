//! Families with a mass: Newton's law for the mass centre, the inertia about two points, moments about a point that moves.

use super::expr::{
    Atom, Expr, Line, Point, Seen, Vector, cross, equal, minus, omega, plus, square, times,
};
use super::family::{product, ring, signed, whole};
use super::style::Style;

fn mass() -> Expr {
    Expr::Atom(Atom::Mass)
}

fn part(vector: Vector, i: usize, dots: u8) -> Expr {
    Expr::Atom(Atom::Part(vector, i % 3, dots))
}

/// m v, for a whole vector.
fn carried(velocity: Vector) -> Expr {
    product([mass(), whole(velocity)])
}

pub(crate) fn newton() -> Vec<Line> {
    use Vector::{Force, LinearMomentum, Omega, Velocity};
    let rate = Expr::Whole(Velocity, Seen::Moving);
    let acceleration = plus(vec![rate, cross(whole(Omega), whole(Velocity))]);
    let mut lines = vec![
        equal(whole(LinearMomentum), carried(Velocity)),
        equal(whole(Force), Expr::Whole(LinearMomentum, Seen::Space)),
        equal(whole(Force), product([mass(), acceleration])),
    ];
    lines.extend(ring(|i| {
        let turned = |a: usize, b: usize| product([omega(a), part(Velocity, b, 0)]);
        let terms = vec![
            (false, part(Velocity, i, 1)),
            (false, turned(i + 1, i + 2)),
            (true, turned(i + 2, i + 1)),
        ];
        equal(part(Force, i, 0), product([mass(), signed(terms)]))
    }));
    lines.extend(ring(|i| {
        let right = product([mass(), part(Velocity, i, 0)]);
        equal(part(LinearMomentum, i, 0), right)
    }));
    lines
}

pub(crate) fn said_of_newton(style: &Style) -> String {
    let all = [
        ("The body has the mass ", style.expr(&mass())),
        (
            "The velocity of the mass centre is ",
            style.vector(Vector::Velocity),
        ),
        (
            "The linear momentum is ",
            style.vector(Vector::LinearMomentum),
        ),
        ("The resultant force is ", style.vector(Vector::Force)),
    ];
    let said = all.map(|(words, text)| format!("{words}{}. ", style.formula(&text)));
    format!("The origin is the mass centre. {}", said.concat())
}

pub(crate) fn parallel_axes() -> Vec<Line> {
    let place = |i: usize| Expr::Atom(Atom::Place(i % 3));
    let about = |point, i: usize, j: usize| {
        let (i, j) = (i % 3, j % 3);
        Expr::Atom(Atom::About(point, i.min(j), i.max(j)))
    };
    let shifted = |i, j, more| {
        let right = plus(vec![about(Point::Centre, i, j), more]);
        equal(about(Point::Origin, i, j), right)
    };
    let mut lines = ring(|i| {
        let squares = plus(vec![square(place(i + 1)), square(place(i + 2))]);
        shifted(i, i, product([mass(), squares]))
    });
    lines.extend(ring(|i| {
        shifted(i, i + 1, times(vec![mass(), place(i), place(i + 1)]))
    }));
    lines
}

pub(crate) fn said_of_parallel_axes(style: &Style) -> String {
    let place = style.formula("(x_G, y_G, z_G)");
    let [m, centre, origin] =
        [style.expr(&mass()), "G".into(), "O".into()].map(|t| style.formula(&t));
    format!(
        "The body has the mass {m}. The mass centre {centre} is at {place} on axes through the point {origin} of the body. The axes at {centre} are parallel to those at {origin}. "
    )
}

/// r × m v_G.
fn moment_of_momentum() -> Expr {
    cross(whole(Vector::Arm), carried(Vector::CentreVelocity))
}

/// v_P × m v_G.
fn extra() -> Expr {
    cross(
        whole(Vector::PointVelocity),
        carried(Vector::CentreVelocity),
    )
}

pub(crate) fn moving_point() -> Vec<Line> {
    use Vector::{
        Arm, CentreMoment, CentreMomentum, CentreVelocity, Force, PointMoment, PointMomentum,
    };
    let rate = |vector| Expr::Whole(vector, Seen::Space);
    let pushed = || cross(whole(Arm), whole(Force));
    vec![
        equal(whole(CentreMoment), rate(CentreMomentum)),
        equal(
            rate(PointMomentum),
            signed(vec![
                (false, rate(CentreMomentum)),
                (true, extra()),
                (false, pushed()),
            ]),
        ),
        equal(whole(PointMoment), plus(vec![rate(PointMomentum), extra()])),
        equal(rate(PointMomentum), minus(whole(PointMoment), extra())),
        equal(
            whole(PointMoment),
            plus(vec![rate(CentreMomentum), pushed()]),
        ),
        equal(
            whole(PointMoment),
            plus(vec![
                rate(CentreMomentum),
                cross(whole(Arm), product([mass(), rate(CentreVelocity)])),
            ]),
        ),
    ]
}

pub(crate) fn said_of_moving_point(style: &Style) -> String {
    use Vector::{
        Arm, CentreMoment, CentreMomentum, CentreVelocity, Force, PointMoment, PointMomentum,
        PointVelocity,
    };
    let formula = |vector| style.formula(&style.vector(vector));
    let line = |line: Line| style.formula(&style.line(&line));
    let shift = minus(whole(CentreVelocity), whole(PointVelocity));
    let rate = |vector| Expr::Whole(vector, Seen::Space);
    format!(
        "The body has the mass {} and the mass centre {}, whose velocity is {}. {} is a point that moves in any way with velocity {}. The vector from {} to {} is {}. The resultant force is {}. Given {}. Given {}. Define {}. Define {}. ",
        style.formula(&style.expr(&mass())),
        style.formula("G"),
        formula(CentreVelocity),
        style.formula("P"),
        formula(PointVelocity),
        style.formula("P"),
        style.formula("G"),
        formula(Arm),
        formula(Force),
        line(equal(rate(Arm), shift)),
        line(equal(whole(Force), product([mass(), rate(CentreVelocity)]))),
        line(equal(
            whole(PointMomentum),
            plus(vec![whole(CentreMomentum), moment_of_momentum()]),
        )),
        line(equal(
            whole(PointMoment),
            plus(vec![whole(CentreMoment), cross(whole(Arm), whole(Force))]),
        )),
    )
}
