//! A body that swings about a fixed horizontal axis under its weight.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

const ABOUT_AXIS: &str = "A compound pendulum of mass $m$ swings about a fixed horizontal axis through $O$. Its moment of inertia \
    about that axis is $I_O$, the distance from $O$ to the mass centre is $d$, and $\\theta$ is the angle from the vertical.";
const ABOUT_CENTRE: &str = "A rigid body of mass $m$ is hung from a pivot $P$. The distance $h$ between the pivot and the centre of \
    mass $G$ and the central moment $I_G$ are known; $\\theta$ is measured from the downward vertical.";

#[test]
fn the_weight_turns_it_back() {
    let with = |words: &str, line: &str| verdicts(&format!("{words}\n\n$$ {line} $$\n"));
    assert_eq!(with(ABOUT_AXIS, r"I_O\ddot\theta = -mgd\sin\theta"), "p");
    assert_eq!(with(ABOUT_AXIS, r"I_O\ddot\theta = mgd\sin\theta"), "r");
    assert_eq!(
        with(ABOUT_CENTRE, r"(I_G + mh^2)\ddot\theta + mgh\sin\theta = 0"),
        "p"
    );
    assert_eq!(
        with(ABOUT_CENTRE, r"I_G\ddot\theta + mgh\sin\theta = 0"),
        "r"
    );
}

#[test]
fn small_swings_have_one_frequency() {
    let with = |words: &str, square: &str| {
        verdicts(&format!(
            "{ABOUT_AXIS}\n\n$$ I_O\\ddot\\theta = -mgd\\sin\\theta $$\n\n{words}\n\n$$ \\ddot\\theta + \\nu^2\\theta = 0 $$\n\n\
             $$ \\nu^2 = {square} $$\n"
        ))
    };
    for words in ["For small angles", "For small $\\theta$ this is"] {
        assert_eq!(with(words, r"\frac{mgd}{I_O}"), "ppp", "{words}");
        assert_eq!(with(words, r"\frac{mgd}{2I_O}"), "ppr", "{words}");
    }
    let told = |square: &str| {
        verdicts(&format!(
            "{ABOUT_CENTRE}\n\n$$ (I_G + mh^2)\\ddot\\theta + mgh\\sin\\theta = 0 $$\n\nFor small angles this is\n\n\
             $$ \\ddot\\theta + \\omega_0^2\\theta = 0 $$\n\nwith\n\n$$ \\omega_0^2 = {square} $$\n"
        ))
    };
    assert_eq!(told(r"\frac{mgh}{I_G + mh^2}"), "ppp");
    assert_eq!(told(r"\frac{mgh}{I_G}"), "ppr");
}

#[test]
fn what_starts_from_rest_gains_its_rate_on_the_way() {
    let document = |rate: &str| {
        format!(
            r"A rigid body of mass $m$ swings about a fixed horizontal axis through $O$. Its centre of mass $G$ is at the distance $\ell$ from $O$, and $\theta$ is the angle between $OG$ and the downward vertical.
The moment of inertia about $G$ is expressed by the radius of gyration, $I_G = m k^2$. By the theorem of parallel axes

$$ I_O = I_G + m\ell^2 $$

$$ I_O\,\ddot\theta = -mg\ell\sin\theta $$

Let the pendulum be released from rest at the angle $\theta_0$. Equating energies we get

$$ \dot\theta^2 = {rate} $$
"
        )
    };
    let text = |rate: &str| verdicts(&document(rate));
    let right = r"\frac{2mg\ell}{I_O}(\cos\theta - \cos\theta_0)";
    let half = r"\frac{mg\ell}{I_O}(\cos\theta - \cos\theta_0)";
    let other_way = r"\frac{2mg\ell}{I_O}(\cos\theta_0 - \cos\theta)";
    assert_eq!(text(right), "appa");
    // What k is follows from nothing before.
    let rod = format!(
        "{}\nFor a uniform rod we have $k^2 = \\ell^2/3$.\n",
        document(right)
    );
    assert!(!verdicts(&rod).ends_with('r'));
    assert_eq!(text(half), "appr");
    assert_eq!(text(other_way), "appr");
}

#[test]
fn the_period_says_no_more_of_the_moment_than_the_frequency_did() {
    let document = |moment: &str| {
        format!(
            r"The model hangs from a pivot $O$, with the centre of gravity $G$ at the distance $d$ below it. For the swing angle $\theta$ the moment of the weight gives

$$ I_O\,\ddot\theta = -m g d\sin\theta $$

For small angles define the circular frequency by

$$ \omega_0^2 = \frac{{m g d}}{{I_O}} $$

With the period $T_0 = 2\pi/\omega_0$ the moment of inertia about the pivot is

$$ I_O = \frac{{{moment}}}{{4\pi^2}} $$

and the parallel axis theorem takes us to the centre of gravity,

$$ I_y = I_O - m d^2 $$

## Energy

The energy $E = \tfrac12 I_O\,\dot\theta^2 + m g d\,(1 - \cos\theta)$ stays constant,

$$ \dot E = 0 $$
"
        )
    };
    assert_eq!(verdicts(&document("m g d\\,T_0^2")), "paapaap");
    assert_eq!(verdicts(&document("m g d\\,T_0")), "paaraap");
}

#[test]
fn where_it_is_let_go_is_where_it_begins() {
    for words in [
        r"If it is let go from rest at $\theta = \theta_0$, its angular velocity follows from",
        r"It is released from rest at $\theta = \theta_0$. Then",
    ] {
        let with = |square: &str| {
            verdicts(&format!(
                "{ABOUT_AXIS}\n\n$$ I_O\\ddot\\theta = -mgd\\sin\\theta $$\n\n{words}\n\n\
                 $$ \\dot\\theta^2 = {square}(\\cos\\theta - \\cos\\theta_0) $$\n"
            ))
        };
        assert_eq!(with(r"\frac{2mgd}{I_O}"), "paa", "{words}");
        assert_eq!(with(r"\frac{mgd}{I_O}"), "par", "{words}");
    }
}

#[test]
fn an_angle_is_small_where_it_is_about_its_sine() {
    let with = |turned: &str| {
        verdicts(&format!(
            "{ABOUT_AXIS}\n\n$$ I_O\\ddot\\theta = -mgd\\sin\\theta $$\n\nWith $\\sin\\theta\\approx\\theta$ this becomes\n\n\
             $$ I_O\\ddot\\theta = {turned}mgd\\theta $$\n"
        ))
    };
    assert_eq!(with("-"), "pap");
    assert_eq!(with(""), "par");
}

#[test]
fn a_length_may_be_any_again() {
    let with = |moment: &str| {
        verdicts(&format!(
            "A uniform rod of mass $M$ and length $l$ swings about a horizontal pivot $P$ at the distance $s > 0$ from its centre of \
             mass $G$; $\\theta$ is the angle of the rod from its position of rest. $I_G = \\frac{{1}}{{12}}Ml^2$ and $I_P = I_G + Ms^2$.\n\n\
             With $s = l/2$ this is $I_P = \\frac13Ml^2$. We go back to a general $s$:\n\n\
             $$ I_P\\ddot\\theta = -Mgs\\sin\\theta $$\n\n$$ {moment}\\ddot\\theta = -gs\\sin\\theta $$\n"
        ))
    };
    assert!(
        with(r"\left(\frac{l^2}{12} + s^2\right)").ends_with("appp"),
        "{}",
        with(r"\left(\frac{l^2}{12} + s^2\right)")
    );
    assert!(
        with(r"\frac{l^2}{3}").ends_with("appr"),
        "{}",
        with(r"\frac{l^2}{3}")
    );
}
