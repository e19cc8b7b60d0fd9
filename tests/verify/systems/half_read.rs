//! Sentences that are easily read by half: each tells all that it says, or keeps lines open.

use super::judged;

#[test]
fn a_principal_moment_about_one_axis_is_the_one_about_that() {
    for told in [
        "The body has the principal moments of inertia $A$, $D$, $C$ about $b_1$, $b_2$, $b_3$ respectively.",
        "$A$, $D$, $C$ are the principal moments of the body about $b_1$, $b_2$, $b_3$.",
        "$D$, $A$, $C$ are the principal moments of inertia of the body about $b_2$, $b_1$, $b_3$.",
    ] {
        let sentences = format!(
            "N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
$b_1$, $b_2$, $b_3$ are the axes of B.
$\\omega$ is the angular velocity of B relative to N.
$p$, $q$, $r$ are the components of $\\omega$ on B.
$L$ is the angular momentum of the body about G relative to N.
{told}
"
        );
        let text = r"
$$ L = A p\,b_1+D q\,b_2+C r\,b_3 $$
$$ L = D p\,b_1+A q\,b_2+C r\,b_3 $$
";
        assert_eq!(judged(&sentences, text), "pr", "{told}");
    }
}

#[test]
fn fewer_letters_than_axes_tell_no_principal_moments() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
$b_1$, $b_2$, $b_3$ are the axes of B.
$p$, $q$, $r$ are the components of the angular velocity of B relative to N on B.
$L$ is the angular momentum of the body about G relative to N.
$A$ and $C$ are the principal moments of the body about G on B.
";
    let text = r"
$$ L\cdot b_1 = A p $$
$$ L\cdot b_2 = C q $$
";
    assert_eq!(judged(sentences, text), "uu");
}

/// A disc that rolls, with other sentences for some of its own.
fn coin(others: &[(&str, &str)]) -> String {
    let mut sentences = "\
N is an inertial frame.
$z$ is the upward vertical.
The table is a horizontal plane fixed in N.
The coin is a uniform thin disc of mass $m$ and radius $r$.
G is the mass centre of the coin.
P is the point where the coin touches the table.
The coin rolls on the table at P without slipping.
H is a frame that turns relative to N about $z$ by the angle $\\phi$.
D is a frame that turns relative to H about $d_1$ by the angle $\\theta$, with $d_3=z$ at $\\theta=0$.
$d_1$, $d_2$, $d_3$ are the axes of D.
$d_2$ is the unit vector from P to G.
The coin turns relative to D about its axis $d_3$ by the angle $\\psi$.
$L$ is the angular momentum of the coin about G relative to N.
$T$ is the kinetic energy of the coin relative to N.
$g$ is the acceleration of gravity.
The weight and the force of the table at P are the only loads on the coin.
"
    .to_owned();
    for (plain, other) in others {
        sentences = sentences.replace(plain, other);
    }
    sentences
}

const OF_COIN: &str = r"
$$ z = \sin\theta\,d_2+\cos\theta\,d_3 $$
$$ z = \cos\theta\,d_2+\sin\theta\,d_3 $$
$$ L\cdot d_3 = \frac12 m r^2(\dot\psi+\dot\phi\cos\theta) $$
$$ L\cdot d_3 = \frac14 m r^2(\dot\psi+\dot\phi\cos\theta) $$
$$ \frac{d}{dt}(T+m g r\sin\theta) = 0 $$
";

#[test]
fn sizes_beside_a_shape_are_its_own() {
    let plain = "The coin is a uniform thin disc of mass $m$ and radius $r$.";
    for other in [
        "The coin, a uniform thin disc, has mass $m$ and radius $r$.",
        "The coin is a body of mass $m$ and radius $r$. It is a uniform thin disc.",
    ] {
        let sentences = coin(&[(plain, &other.replace(". It", ".\nThe coin"))]);
        assert_eq!(judged(&sentences, OF_COIN), "prprp", "{other}");
    }
}

#[test]
fn the_normal_of_a_level_plane_that_points_up_is_the_vertical() {
    for other in [
        "$z$ is the upward normal of the table.",
        "$z$ is the upward vertical unit vector.",
    ] {
        let sentences = coin(&[("$z$ is the upward vertical.", other)]);
        assert_eq!(judged(&sentences, OF_COIN), "prprp", "{other}");
    }
}

#[test]
fn a_weight_that_is_written_out_makes_no_vector_of_the_letter_of_gravity() {
    let sentences = coin(&[(
        "$g$ is the acceleration of gravity.",
        "The weight of the coin is $mg$, where $g$ is the acceleration of gravity.",
    )]);
    assert_eq!(judged(&sentences, OF_COIN), "prprp");
}

#[test]
fn that_no_couple_acts_tells_no_moment_of_forces() {
    let plain = "The weight and the force of the table at P are the only loads on the coin.";
    let other = "The only forces on the coin are its weight and the force of the table at P, and no couple acts on it.";
    assert_eq!(judged(&coin(&[(plain, other)]), OF_COIN), "prprp");
    let other = format!("{plain}\nNo moment acts on the coin.");
    let text = r"
$$ \frac{d}{dt}(\dot\phi\sin^2\theta) = 2\dot\theta(\dot\psi+\dot\phi\cos\theta)\sin\theta $$
$$ \dot L = 0 $$
";
    let found = judged(&coin(&[(plain, &other)]), text);
    assert!(!found.starts_with('r') && !found.ends_with('p'), "{found}");
}

#[test]
fn a_body_fixed_frame_and_point_are_fixed_in_the_body() {
    for (frame, point) in [
        (
            "F is a body-fixed frame.",
            "P is a point fixed in the body.",
        ),
        (
            "F is the body frame, which is attached to the body.",
            "P is a point fixed in the body.",
        ),
        ("F is a frame fixed in the body.", ""),
    ] {
        let told = match point {
            "" => "The position of the body-fixed point P from G is $s$.",
            _ => "$s$ is the position of P from G.",
        };
        let sentences = format!(
            "N is an inertial frame.
{frame}
G is the mass centre of the body.
{point}
{told}
$\\omega$ is the angular velocity of F relative to N.
$v$ is the velocity of P relative to N.
$u$ is the velocity of G relative to N.
"
        );
        let text = r"
$$ v = u+\omega\times s $$
$$ v = u-\omega\times s $$
";
        assert_eq!(judged(&sentences, text), "pr", "{frame}");
    }
}

#[test]
fn a_point_told_behind_a_position_is_no_letter() {
    let sentences = "\
N is an inertial frame.
F is a frame fixed in the body.
G is the mass centre of the body.
$s$ is the position from G of P, a point fixed in F.
$\\omega$ is the angular velocity of F relative to N.
$v$ is the velocity of P relative to N.
$u$ is the velocity of G relative to N.
";
    let text = r"
$$ v = u+\omega\times s $$
$$ v = u-\omega\times s $$
";
    assert_eq!(judged(sentences, text), "pr");
}
