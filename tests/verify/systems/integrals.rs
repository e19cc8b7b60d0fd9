//! Integrals over a body: sums over its elements.

use super::judged;

/// A body with a fixed point, and an element of it.
const BODY: &str = "N is an inertial frame.
B is a frame fixed in the rock.
Q is a point fixed in N and in B.
G is the mass centre of the rock.
$M$ is the mass of the rock.
$K$ is the inertia tensor of the rock about Q.
$K_{xx}$ and $K_{xy}$ are the entries (1, 1) and (1, 2) of $K$ on B.
$\\vec\\omega$ is the angular velocity of B relative to N.
$\\vec H$ is the angular momentum of the rock about Q relative to N.
$T$ is the kinetic energy of the rock relative to N.
$\\vec g$ is the position of G from Q.
";

fn with(said: &str) -> String {
    format!("{BODY}{said}")
}

#[test]
fn moments_of_mass_are_those_of_the_body() {
    let said = with(
        "$\\vec r$ is the position of the mass element $dm$ from Q.
$\\vec s$ is the position of the mass element $dm$ from G.
$x$, $y$, $z$ are the components of $\\vec r$ on B.
",
    );
    let text = r"
$$ \vec H = \int \vec r\times(\vec\omega\times\vec r)\,dm $$
$$ \vec H = \int_V \vec r\times\dot{\vec r}\,dm $$
$$ \vec H = -\int \vec r\times\dot{\vec r}\,dm $$
$$ T = \frac12\int \dot{\vec r}\cdot\dot{\vec r}\,dm $$
$$ T = \int \dot{\vec r}\cdot\dot{\vec r}\,dm $$
$$ K_{xx} = \iiint (y^2 + z^2)\,dm $$
$$ K_{xx} = \int (x^2 + z^2)\,dm $$
$$ K_{xy} = -\int xy\,dm $$
$$ M = \int dm $$
$$ M\vec g = \int\vec r\,dm $$
$$ \int\vec s\,dm = 0 $$
$$ \int\vec r\,dm = 0 $$
$$ \vec r = \vec g + \vec s $$
$$ K_{xx} = \int_N (y^2 + z^2)\,dm $$
$$ K_{xx} = \int_0^1 (y^2 + z^2)\,dm $$
";
    assert_eq!(judged(&said, text), "pprprprppppr".to_owned() + "puu");
}

#[test]
fn a_density_may_vary_over_the_body() {
    let said = with(
        "$\\rho$ is the density of the rock.
The integrals run over the rock.
$\\vec r$ is the position of an element of the rock from Q.
$x$, $y$, $z$ are the coordinates of an element of the rock from Q on B.
$dV$ is the volume element of the rock.
",
    );
    let text = r"
$$ K_{xx} = \int\rho(\vec r)(y^2 + z^2)\,dV $$
$$ K_{xx} = \int\rho(x, y, z)(y^2 + z^2)\,dx\,dy\,dz $$
$$ K_{xx} = \int_V d^3r\,\rho(\vec r)\,(x^2 + z^2) $$
$$ \vec g = \frac{\int\rho\vec r\,d^3r}{\int\rho\,d^{3}r} $$
$$ K_{xx} = \rho\int(y^2 + z^2)\,dV $$
$$ K_{xx} = \int(y^2 + z^2)\,dV $$
";
    assert_eq!(judged(&said, text), "pprpur");
}

#[test]
fn a_constant_density_comes_out_in_front() {
    let said = with(
        "$\\rho$ is the constant density of the rock.
The integrals over $V$ run over the rock.
$x$, $y$, $z$ are the coordinates of an element of the rock from Q on B.
",
    );
    let text = r"
$$ K_{xx} = \rho\int_V (y^2 + z^2)\,dV $$
$$ K_{xx} = \rho\int_V (y^2 - z^2)\,dV $$
$$ M = \rho\int_V dV $$
";
    assert_eq!(judged(&said, text), "prp");
}

#[test]
fn a_point_of_the_body_runs_through_it() {
    let point = "P, a point of the rock, is placed from Q by $\\vec r$.
$\\vec v$ is the velocity of P relative to N.
$r$ is the magnitude of $\\vec r$.
$\\rho$ is the density of the rock.
";
    let text = r"
$$ \vec v = \vec\omega\times\vec r $$
$$ \vec H = \int\rho\,\vec r\times\vec v\,dV $$
$$ \vec H = \int\rho\left[r^2\vec\omega - (\vec r\cdot\vec\omega)\vec r\right]dV $$
$$ \vec H = \int\rho\left[r^2\vec\omega + (\vec r\cdot\vec\omega)\vec r\right]dV $$
";
    let runs = [
        "The integrals run over the rock.\n",
        "The integrals over $V$ run over the rock, with $\\vec r$ varying.\n",
    ];
    for integrals in runs {
        let said = with(&format!("{point}{integrals}"));
        assert_eq!(judged(&said, text), "pppr", "{integrals}");
    }
}

#[test]
fn letters_of_entries_number_the_axes() {
    let said = with(
        "$\\vec r$ is the position of an element of the rock from Q.
The components of $\\vec r$ on B are $x$, $y$, $z$, also written $x_1$, $x_2$, $x_3$.
$K_{ij}$ is entry $(i, j)$ of $K$ on B.
$g_i$ is the component $i$ on B of $\\vec g$.
",
    );
    let text = r"
$$ K_{ij} = \int\Big(\delta_{ij}\sum_{k=1}^3 x_k^2 - x_ix_j\Big)dm $$
$$ K_{ij} = \int\Big(\delta_{ij}\sum_{k=1}^3 x_k{}^2 + x_ix_j\Big)dm $$
$$ \int x_i\,dm = Mg_i $$
";
    assert_eq!(judged(&said, text), "prp");
}

#[test]
fn elements_of_two_bodies_are_not_mixed() {
    let said = with(
        "$\\vec r$ is the position of an element of the rock from Q.
A is a frame fixed in the door.
$\\vec s$ is the position of an element of the door from Q.
",
    );
    let (verdicts, _) = super::verdicts(&said, r"$$ M = \int dm $$");
    assert_eq!(verdicts, "u");
}

#[test]
fn the_share_of_an_element_tells_the_whole() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
C is the mass centre of the body.
O is a point fixed in N.
The body consists of elements $dm$.
p is the place of element $dm$.
$r$ is the position of p from O.
$a$ is the acceleration of p relative to N.
$\tau$ is the total moment on the body about O.
";
    let text = r"
$$ d\tau = r\times a\,dm $$
$$ d\tau = a\times r\,dm $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_point_is_an_element_where_a_part_of_the_document_says_so() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
O is a point fixed in B.
The body consists of elements $dm$.
P is a point.
On lines 4 to 9 P is the place of element $dm$.
$r$ is the position of P from O.
$w$ is the angular velocity of B relative to N.
$v$ is the rate of $r$ seen from N.
";
    let text = r"
$$ v = w\times r $$


$$ v = w\times r $$
";
    assert_eq!(judged(sentences, text), "rp");
}

#[test]
fn any_element_of_a_body_is_fixed_in_it() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
O is a point fixed in B.
p is the place of an element of the body.
$r$ is the position of p from O.
$w$ is the angular velocity of B relative to N.
$v$ is the rate of $r$ seen from N.
";
    let text = r"
$$ v = w\times r $$
$$ v = r\times w $$
";
    assert_eq!(judged(sentences, text), "pr");
}
