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
