//! Sines and cosines of parts of π.

use super::judged;

#[test]
fn parts_of_pi_have_the_values_that_they_have() {
    let sentences = "N is an inertial frame.
B turns relative to N about z by the angle $\\gamma$.
";
    let text = r"
$$ \cos(\pi/2) = 0 $$
$$ \sin(-\pi/2) = -1 $$
$$ \sin(\pi/6) = \tfrac12 $$
$$ \cos(\pi/3) = -\tfrac12 $$
$$ \cos(2\pi/3) = -\tfrac12 $$
$$ \sin(\pi/4)^2 = \tfrac12 $$
$$ \sin 30^\circ = \tfrac12 $$
$$ \sin(\gamma + \pi/2) = \cos\gamma $$
$$ \cos(\gamma - \pi) = -\cos\gamma $$
$$ \cos(\gamma + \pi/2) = \sin\gamma $$
";
    assert_eq!(judged(sentences, text), "ppprpppppr");
}

#[test]
fn of_other_parts_of_pi_nothing_is_said() {
    let sentences = "N is an inertial frame.\n";
    let text = "$$ \\cos(\\pi/5) = 0 $$\n$$ \\cos(\\pi/5) > 0 $$\n";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn bounds_of_an_angle_tell_the_sign_of_its_sine() {
    let sentences = "N is an inertial frame.
x, y, z are the axes of N.
A is a frame that turns relative to N about z by the angle $\\beta$.
$u$, $v$, $w$ are the axes of A.
$\\beta$ lies between $-\\pi/2$ and $0$.
";
    let text = r"
$$ |\sin\beta| = -\sin\beta $$
$$ |\sin\beta| = \sin\beta $$
$$ \sqrt{1-\sin^2\beta} = \cos\beta $$
";
    assert_eq!(judged(sentences, text), "prp");
    let free = sentences.replace("$\\beta$ lies between $-\\pi/2$ and $0$.\n", "");
    assert!(!judged(&free, r"$$ |\sin\beta| = \sin\beta $$").contains('p'));
}

#[test]
fn axes_are_not_the_same_where_a_sentence_tells_how_they_lie() {
    let said = [
        "$b_3=-a_3$.",
        "$b_3$ is normal to $a_3$.",
        "$b_2$ points along $a_1$.",
    ];
    for said in said {
        let sentences = format!(
            "A is an inertial frame.
$a_1$, $a_2$, $a_3$ are the axes of A.
$b_1$, $b_2$, $b_3$ are the axes of B.
B turns relative to A about $b_3$ by the angle $\\gamma$.
{said}
"
        );
        let text = r"
$$ b_1 = \cos\gamma\,a_1 + \sin\gamma\,a_2 $$
$$ b_3 = a_3 $$
";
        assert!(!judged(&sentences, text).contains('p'), "{said}");
    }
}

#[test]
fn unit_vectors_of_members_move_unless_they_are_fixed() {
    let sentences = "N is an inertial frame.
The body consists of particles.
$j$ numbers the particles.
$\\hat p_j$ is a unit vector.
$\\frac{d}{dt}$ is the rate seen from N.
";
    let text = r"
$$ \hat p_j\cdot\hat p_j = 1 $$
$$ \frac{d\hat p_j}{dt} = 0 $$
";
    assert!(!judged(sentences, text).ends_with('p'));
}

#[test]
fn an_angle_about_an_axis_from_a_direction_turns_a_line() {
    let sentences = r"
N is an inertial frame.
$i$, $j$, $k$ are the axes of N.
$j$ is the upward vertical.
The cart is a rigid body of mass $M$.
The cart keeps its direction relative to N.
The beam is a uniform thin rod of mass $m$ and length $2l$.
The beam is hinged to the cart at Q.
Q is an end of the beam.
O is a fixed point of N.
$x$ is the component along $i$ of the position of Q from O.
$\theta$ is the angle about $k$ from the downward vertical to the beam.
C is the mass centre of the beam.
$a$ and $b$ are the components along $i$ and $j$ of the position of C from Q.
";
    let text = r"
$$ a = l\sin\theta $$
$$ b = -l\cos\theta $$
$$ a = -l\sin\theta $$
";
    assert_eq!(judged(sentences, text), "ppr");
    let backwards = sentences.replace("angle about $k$", "angle about $-k$");
    assert_eq!(judged(&backwards, text), "rpp");
    let sense = sentences.replace(
        "about $k$ from the downward vertical to the beam",
        "from the downward vertical to the beam, positive about $k$",
    );
    assert_eq!(judged(&sense, text), "ppr");
    let upward = sentences.replace("$j$ is the upward vertical", "$j$ is upward");
    assert_eq!(judged(&upward, text), "ppr");
}

#[test]
fn equal_angles_have_equal_sines() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the body.
Z is the third axis of N.
x, y, z are the axes of B.
$\phi$, $\theta$, $\psi$ are the Euler angles of B relative to N in the order Z, x, z.
$\omega_1$, $\omega_2$, $\omega_3$ are the components on B of the angular velocity of B relative to N.
$\theta_0$ is constant.
$\theta=\theta_0$.
$p$ is the rate of $\phi$.
";
    let text = r"
$$ \sin\theta = \sin\theta_0 $$
$$ \cos 2\theta = \cos 2\theta_0 $$
$$ \omega_1 = p\sin\theta_0\sin\psi $$
$$ \omega_2 = p\sin\theta_0\sin\psi $$
$$ \cos\theta = \sin\theta_0 $$
";
    assert_eq!(judged(sentences, text), "ppprr");
    let sum = sentences.replace(r"$\theta=\theta_0$", r"$\theta=\theta_0+\phi$");
    let text = r"
$$ \sin\theta = \sin\theta_0\cos\phi + \cos\theta_0\sin\phi $$
$$ \sin\theta = \sin\theta_0\cos\phi - \cos\theta_0\sin\phi $$
";
    assert_eq!(judged(&sum, text), "pr");
}

/// Twelfths of π whose cosines are halves, or half a root.
#[test]
fn cosines_of_common_angles_are_exact() {
    let values = [
        (0, "1"),
        (2, "\\sqrt{3}/2"),
        (3, "\\sqrt{2}/2"),
        (4, "1/2"),
        (6, "0"),
        (8, "-1/2"),
        (9, "-\\sqrt{2}/2"),
        (10, "-\\sqrt{3}/2"),
        (12, "-1"),
        (14, "-\\sqrt{3}/2"),
        (18, "0"),
        (20, "1/2"),
        (22, "\\sqrt{3}/2"),
    ];
    let line = |(steps, value): &(i32, &str)| format!("$$ \\cos({steps}\\pi/12) = {value} $$\n");
    let text: String = values.iter().map(line).collect();
    assert_eq!(judged("N is an inertial frame.\n", &text), "p".repeat(13));
}

/// An angle that is told as a part of π has its sine and cosine, and the laws hold there; π itself is told by nothing.
#[test]
fn angles_told_by_parts_of_pi() {
    let sentences = r"
R is an inertial frame.
i, j, k are the axes of R.
j is the upward vertical.
K is a frame fixed in the bar.
O is a point fixed in R and in K.
K turns relative to R about k by the angle $q$.
D is the mass centre of the bar.
D is placed from O by $a(\sin q\,i-\cos q\,j)$.
$m$ is the mass of the bar.
$J$ is the moment of inertia of the bar about the axis through O along k.
$g$ is the acceleration of gravity.
$M$ is the moment of the motor on the bar along k.
The weight, the moment of the motor and a force at O are the only loads on the bar.
";
    let text = r"
$$ \sin q=1 $$
$$ \cos^2 q=0 $$
$$ M=m g a $$
$$ M=-m g a $$
$$ \dot q=0 $$
$$ \sin q=\tfrac12 $$
$$ M=\tfrac12 m g a $$
";
    let judged_at = |value: &str| judged(&format!("{sentences}$q={value}$.\n"), text);
    assert_eq!(judged_at(r"\pi/2"), "ppprprr");
    assert_eq!(judged_at(r"\frac{\pi}{6}"), "rrrrppp");
    assert_eq!(judged_at(r"-\frac12\pi"), "rprpprr");
}
