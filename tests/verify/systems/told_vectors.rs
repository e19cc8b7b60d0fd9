//! Turns about vectors that formulas tell, wholes whose parts move apart, and sentences by the thing of which they speak.

use super::judged;

const ASKEW: &str = r"N is an inertial frame.
B is a frame fixed in the disc.
The axes of B are $i$, $j$, $k$.
The disc is a uniform thin disc of mass $m$ and radius $r$.
G is the centre of the disc.
G is at rest relative to N.
The disc is symmetric about $k$.
$\hat n=-\sin\beta\,i+\cos\beta\,k$
$\omega$ is constant.
$w$ is the angular velocity of B relative to N.
$H$ is the angular momentum of the disc about G relative to N.
$T$ is the kinetic energy of the disc relative to N.
";

#[test]
fn a_turn_about_a_vector_that_a_formula_tells() {
    let text = r"
$$ w=\omega\hat n $$
$$ w=\omega(\cos\beta k-\sin\beta i) $$
$$ w=\omega(\cos\beta k+\sin\beta i) $$
$$ H\cdot\hat n=\tfrac14 m r^2\omega(1+\cos^2\beta) $$
$$ T=\tfrac18 m r^2\omega^2(1+\cos^2\beta) $$
$$ T=\tfrac18 m r^2\omega^2(1+\sin^2\beta) $$
";
    for turn in [
        r"$\omega\hat n$ is the angular velocity of B relative to N.",
        r"B turns relative to N about $\hat n$ at the rate $\omega$.",
        r"B turns relative to N about $\hat n$ at the constant rate $\omega$.",
    ] {
        let said = format!("{ASKEW}$\\hat n$ is a unit vector.\n{turn}\n");
        assert_eq!(judged(&said, text), "pprppr", "{turn}");
    }
}

const LINKS: &str = r"N is an inertial frame.
x, y and z are the axes of N.
y is the upward vertical.
O is a point fixed in N.
Link 1 is a uniform thin rod of mass $m$ and length $a$, which is hinged at O to the ceiling.
Link 2 is a uniform thin rod of mass $p$ and length $b$ and is hinged to the free end A of link 1 by its own end.
$\alpha$ and $\beta$ are the angles that link 1 and link 2 make with the downward vertical, counted positive about z.
$S$ and $T$ are the kinetic energies of link 1 and link 2 relative to N.
$V$ is the potential energy of the two links; it is zero at O.
$g$ is the acceleration of gravity.
";

#[test]
fn two_links_of_which_one_hangs_from_the_other() {
    let text = r"
$$ S=\tfrac16 m a^2\dot\alpha^2 $$
$$ S=\tfrac1{24} m a^2\dot\alpha^2 $$
$$ T=\tfrac12 p(a^2\dot\alpha^2+a b\dot\alpha\dot\beta\cos(\alpha-\beta)+\tfrac13 b^2\dot\beta^2) $$
$$ T=\tfrac12 p(a^2\dot\alpha^2+a b\dot\alpha\dot\beta\cos(\alpha-\beta)+\tfrac14 b^2\dot\beta^2) $$
$$ V=-\left(\tfrac12 m+p\right) g a\cos\alpha-\tfrac12 p g b\cos\beta $$
$$ V=-\left(\tfrac12 m+\tfrac12 p\right) g a\cos\alpha-\tfrac12 p g b\cos\beta $$
";
    assert_eq!(judged(LINKS, text), "prprpr");
}

#[test]
fn what_holds_in_a_state_that_is_not_worked_with_is_not_denied() {
    let sentences = "K is an inertial frame.
L is a frame that turns relative to K.
O is a point fixed in K and in L.
P is a particle.
$R$ takes components on L to components on K.
$r$ is the position of P from O in components on L.
$v$ is the velocity of P relative to K in components on K.
$u$ is the velocity of P relative to L in components on L.
$w$ is the angular velocity of L relative to K in components on L.
";
    let text = r"
$$ v=w\times r+u $$
";
    for state in [
        "at the instant at which $R$ is the identity matrix",
        "at the instant when L coincides with K",
    ] {
        let said = format!("{sentences}Line 2 holds {state}.\n");
        assert_ne!(super::verdicts(&said, text).0, "r", "{state}");
    }
}
