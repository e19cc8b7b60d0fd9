//! Rotors in gimbals: the moment about an axis that a spin is turned about.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn the_moment_about_a_gimbal_has_the_rate_of_the_spin_momentum() {
    let text = |first: &str, second: &str| {
        format!(
            r"The carriage leans by $\beta$ about $x$; $\mathbf i$, $\mathbf j$, $\mathbf k$ are fixed in it:

$$ \boldsymbol\omega = \dot\beta\,\mathbf i $$

The rotor has the constant spin momentum $h$, and its frame turns about $y$ through the angle $\gamma$. Define

$$ \mathbf h = h\,(\cos\gamma\,\mathbf k + \sin\gamma\,\mathbf i) $$

With the inertia $J$ and the load $Q$ of the carriage, and the inertia $J_f$, the spring $c$ and the motor torque $Q_f$ of the frame the equations are

$$ J\ddot\beta {first} h\dot\gamma\cos\gamma = Q $$

$$ J_f\ddot\gamma + c\gamma {second} h\dot\beta\cos\gamma = Q_f $$

Let the energy be

$$ T = \tfrac12 J\dot\beta^2 + \tfrac12 J_f\dot\gamma^2 + \tfrac12 c\gamma^2 $$
"
        )
    };
    assert_eq!(verdicts(&text("+", "-")), "aappa");
    assert_eq!(verdicts(&text("+", "+")), "aapra");
    assert_eq!(verdicts(&text("-", "-")), "aarpa");
}

#[test]
fn a_constant_letter_beside_its_vector_is_the_length() {
    let text = |rate: &str| {
        format!(
            r"A rotor has the constant spin momentum $h$; its axis makes the angle $\alpha$ with $z$. Define

$$ \vec h = h\,(\sin\alpha\,\vec i + \cos\alpha\,\vec k) $$

$$ (\dot{{\vec h}})_{{xyz}} = h\dot\alpha\,({rate}) $$
"
        )
    };
    let right = r"\cos\alpha\,\vec i - \sin\alpha\,\vec k";
    let wrong = r"\cos\alpha\,\vec i + \sin\alpha\,\vec k";
    assert_eq!(verdicts(&text(right)), "ap");
    assert_eq!(verdicts(&text(wrong)), "ar");
}

#[test]
fn the_spin_momentum_along_an_axis_is_a_component() {
    let text = |sign: &str| {
        format!(
            r"The principal moments are $A$, $B$, $C$. Four propellers turn with the speeds $n_1, n_2, n_3, n_4 > 0$. The net spin momentum along $x$ is

$$ h = J_p\,(n_1 - n_2 + n_3 - n_4) $$

and the whole angular momentum, with the body rates $p$, $q$, $r$,

$$ \mathbf H = \begin{{bmatrix}} Ap + h \\ Bq \\ Cr \end{{bmatrix}} $$

The pitch moment is

$$ M = B\dot q + (A - C)\,rp {sign} h\,r $$

At rest the four speeds are equal, $n_1 = n_2 = n_3 = n_4$, so $h = 0$.
"
        )
    };
    let found = verdicts(&text("+"));
    assert!(found.contains('p') && !found.contains('r'), "{found}");
    assert!(verdicts(&text("-")).contains('r'));
}

#[test]
fn a_wheel_with_a_label_is_no_body() {
    let text = |energy: &str, torque: &str| {
        verdicts(&format!(
            r"A tram has a flywheel. Given: $J_w = 10\ \mathrm{{kg\,m^2}}$, $\omega_w = 200\ \mathrm{{rad/s}}$, $\nu = 0.2\ \mathrm{{rad/s}}$.

The stored energy is

$$ E = \tfrac12 J_w\omega_w^2 = {energy}\ \mathrm{{kJ}} $$

The spin momentum is

$$ H = J_w\omega_w = 2000\ \mathrm{{N\,m\,s}} $$

It is carried round at the rate $\nu$:

$$ \frac{{d\mathbf H}}{{dt}} = \nu\,\mathbf k\times H\,\mathbf j = -\nu H\,\mathbf i $$

The torque on the tram is

$$ \mathbf T = \nu H\,\mathbf i $$

with the magnitude

$$ T = \nu H = {torque}\ \mathrm{{N\,m}} $$
"
        ))
    };
    let right = text("200", "400");
    assert!(
        right.starts_with("aaap") && !right.contains('r') && right.ends_with('p'),
        "{right}"
    );
    assert_eq!(text("400", "400").chars().nth(3), Some('r'));
    assert!(text("200", "800").ends_with('r'));
}
