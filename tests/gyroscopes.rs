//! Gyroscopes by their spin alone, on axes along and around that turn with the axle.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn a_spin_alone_has_the_momentum_on_axes_that_turn_at_a_vector() {
    let text = |last: &str| {
        format!(
            r"A gyroscope on a stand. The rotor has the moment of inertia $I$ and spins at the constant rate $\omega$ about $\hat x$. Its spin angular momentum is

$$\vec L = I\omega\,\hat x$$

The frame precesses with $\vec\Omega = \Omega\,\hat z$, which is constant. Hence

$$\frac{{d\vec L}}{{dt}} = \vec\Omega\times\vec L = I\omega\Omega\,\hat y$$

$${last}$$
"
        )
    };
    let found = |last| verdicts(&text(last));
    assert_eq!(found(r"\vec\tau = I\omega\Omega\,\hat y"), "appp");
    assert_eq!(found(r"\vec\tau = -I\omega\Omega\,\hat y"), "appr");
    assert_eq!(found(r"\tau = I\omega\Omega"), "appp");
}

#[test]
fn lengths_of_a_bend_go_on_under_the_next_heading() {
    let text = |momentum: &str, wheels: &str| {
        format!(
            r"## Axes

The car follows a bend of radius $R$ at the constant speed $v$. The axes $\hat\imath$, $\hat\jmath$, $\hat k$ move with it:

$$ \vec\Omega = \frac{{v}}{{R}}\,\hat k $$

The crankshaft has the moment of inertia $J$ about its axis and spins at the constant rate $\omega_e$. What matters of its angular momentum is

$$ \vec H = J\omega_e\,\hat\imath $$

## The couple

$$ \vec M = \frac{{d\vec H}}{{dt}} = \frac{{v}}{{R}}\,J\omega_e\,\hat\jmath $$

The angular momentum of the wheels is $\vec H_w = 4I_w\omega_w\,\hat\jmath$, which changes at the rate

$$ \vec\Omega\times\vec H_w = {wheels}\frac{{4I_w\omega_w v}}{{R}}\,\hat\imath $$

## Numbers

Take $J = 0.25~\mathrm{{kg\,m^2}}$, $\omega_e = 600~\mathrm{{rad/s}}$, $v = 20~\mathrm{{m/s}}$, $R = 40~\mathrm{{m}}$. Then

$$ H = {momentum}~\mathrm{{kg\,m^2/s}} $$
"
        )
    };
    assert_eq!(verdicts(&text("150", "-")), "aapapaaaap");
    assert!(!verdicts(&text("150", "")).contains("pap"));
    assert!(!verdicts(&text("160", "-")).ends_with(['p', 'a']));
}

#[test]
fn unit_vectors_along_around_and_up_turn_with_the_axle() {
    let text = |rate: &str, turn: &str| {
        format!(
            r"A gyroscope of mass $m$ hangs at one end of its axle of length $\ell$. $\mathbf e_z$ is vertical, $\mathbf e_\rho$ points along the axle and $\mathbf e_\varphi = \mathbf e_z\times\mathbf e_\rho$. Its moment of inertia about the axle is $J$ and it spins at $s$. Only the spin counts,

$$ \mathbf L = J s\,\mathbf e_\rho $$

It precesses with $\boldsymbol\Omega = \Omega\,\mathbf e_z$, so

$$ \dot{{\mathbf e}}_\varphi = {rate}\Omega\,\mathbf e_\rho $$

$$ \dot{{\mathbf L}} = J s\Omega\,\mathbf e_\varphi $$

The weight has the moment

$$ \boldsymbol\tau = \ell\,\mathbf e_\rho\times(-mg\,\mathbf e_z) = mg\ell\,\mathbf e_\varphi $$

Therefore

$$ \Omega = \frac{{mg\ell}}{{{turn}}} $$
"
        )
    };
    assert_eq!(verdicts(&text("-", "Js")), "pappppp");
    assert_eq!(verdicts(&text("", "Js")), "paprppp");
    assert_eq!(verdicts(&text("-", "2Js")), "pappppr");
}

#[test]
fn a_spin_that_is_carried_round_needs_no_axes() {
    let text = |rate: &str, turn: &str| {
        verdicts(&format!(
            r"A flywheel of mass $M$ with the moment of inertia $J$ about its axle turns at the rate $\omega$. The axle is horizontal and is held at one end, the distance $b$ from the flywheel. The spin angular momentum has the size

$$ H = J\omega $$

The weight has a torque about the support of the size

$$ N = Mgb $$

The gyroscope precesses with the angular velocity $\vec\Omega$ about the vertical, and

$$ \vec N = \frac{{d\vec H}}{{dt}} = {rate} $$

The sizes give

$$ N = \Omega H $$

$$ \Omega = {turn} $$
"
        ))
    };
    let right = r"\frac{Mgb}{J\omega}";
    assert_eq!(text(r"\vec\Omega\times\vec H", right), "pappp");
    assert_eq!(text(r"\vec H\times\vec\Omega", right), "parpp");
    let wrong = r"\frac{Mgb}{2J\omega}";
    assert_eq!(text(r"\vec\Omega\times\vec H", wrong), "pappr");
}

#[test]
fn the_spin_and_what_carries_it_may_have_one_letter() {
    let text = |cross: &str, couple: &str| {
        verdicts(&format!(
            r"A rotor has the moment of inertia $I = 36$ and the spin $\omega_s = 250$. With the spin vector $\boldsymbol\omega_s$ its angular momentum is $\mathbf L = I\boldsymbol\omega_s$. The gyroscopic couple in a turn with the angular velocity $\boldsymbol\omega_p$ is

$$ \mathbf M = {cross} $$

and at right angles

$$ M = {couple} $$

The rate is $\omega_p = 0.2$. In numbers

$$ M = 36\cdot 250\cdot 0.2 = 1800 $$
"
        ))
    };
    let (right, size) = (r"\boldsymbol\omega_p\times\mathbf L", r"I\omega_s\omega_p");
    assert_eq!(text(right, size), "aapppap");
    let swapped = r"\mathbf L\times\boldsymbol\omega_p";
    assert!(text(swapped, size).starts_with("aaprp"));
    assert!(text(right, r"2 I\omega_s\omega_p").starts_with("aappr"));
}

#[test]
fn a_spin_alone_is_carried_at_omega_where_its_rate_has_another_letter() {
    let text = |sign: &str| {
        format!(
            r"The propeller of a plane (moment of inertia $J$) turns at $n$ about the $x$ axis, $\mathbf h = Jn\,\hat{{\mathbf i}}$, $n$ constant. In a yaw at the rate $r$, $\boldsymbol\omega = r\hat{{\mathbf k}}$, the moment on the propeller is

$$ \mathbf M = \boldsymbol\omega\times\mathbf h = {sign}Jnr\,\hat{{\mathbf j}} $$
"
        )
    };
    assert_eq!(verdicts(&text("")), "aap");
    assert_eq!(verdicts(&text("-")), "aar");
}

#[test]
fn a_momentum_that_turns_with_its_axes_may_do_so() {
    let rate = |side: &str| {
        let text = format!(
            "A rotor spins at $\\omega_s$. Its axle turns at $\\Omega$ about the vertical, with the axle horizontal. The angular \
             momentum is $L = I_s\\omega_s$ along the axle.\n\n$$ \\frac{{dL}}{{dt}} = {side} $$\n"
        );
        verdicts(&text).chars().last()
    };
    assert_ne!(rate(r"\Omega\times L"), Some('r'));
    assert_ne!(rate(r"L\times\Omega"), Some('p'));
}
