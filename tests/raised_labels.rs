//! Labels of axes where powers stand.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

const ARM: &str = r"The rotation matrix $R$ takes body components to those in space. For every vector $u$ let $\hat u$ be the skew matrix with $\hat u\,w = u\times w$. With the label $b$ a vector or tensor is on body axes, without it in space.

$$ \omega = R\,\omega^b $$

$$ \dot R = R\,\hat\omega^b $$

With $\tau$ the moment, $\tau^b = R^T\tau$, Euler's equation is

$$ \tau^b = J^b\dot\omega^b + \omega^b\times J^b\omega^b $$

### Numbers

";

#[test]
fn a_letter_over_a_vector_names_its_axes() {
    assert_eq!(verdicts(ARM), "apppp");
    let turned = ARM.replace(r"R\,\hat\omega^b", r"\hat\omega^b R");
    assert_eq!(verdicts(&turned), "aprpp");
    let power = r"$$ (a + b)^n (a + b) = (a + b)(a + b)^n $$";
    assert_ne!(verdicts(power), "r");
}

#[test]
fn what_is_said_on_body_axes_holds_for_other_lines_there() {
    let with = |second: &str| {
        let data = r"Take $J^b = \mathrm{diag}(2, 3, 4)$,
the rate $\omega^b = (2, 1, 1)^T$
and the acceleration $\dot\omega^b = (0, 3, 0)^T$. Then

$$ \omega^b\times J^b\omega^b = \begin{pmatrix} 1 \\ SECOND \\ 2 \end{pmatrix} $$
";
        verdicts(&format!("{ARM}{}", data.replace("SECOND", second)))
    };
    assert_eq!(with("-4"), "appppaaap");
    assert_eq!(with("4"), "appppaaar");
}

#[test]
fn a_rate_is_given_beside_the_rest_of_a_list() {
    let with = |third: &str| {
        let text = r"Take $\mathbf I = \mathrm{diag}(1, 2, 3)$, the rate $\boldsymbol\omega = (1, 1, 1)^T$ and the acceleration $\dot{\boldsymbol\omega} = (0, 0, 2)^T$. Then the moment is

$$ \mathbf M = (1, -2, THIRD)^T $$
";
        verdicts(&text.replace("THIRD", third))
    };
    assert_eq!(with("7"), "aaap");
    assert_eq!(with("5"), "aaar");
}

#[test]
fn a_label_of_the_body_under_every_vector_tells_nothing_apart() {
    let text = r"The torque $\tau_b$, the inertia tensor $I_b$ and the angular velocity $\omega_b$ are on the axes of the body.

$$ L_b = I_b\,\omega_b $$

$$ I_b\dot\omega_b = \tau_b - \omega_b\times(I_b\omega_b) $$

$$ I_b\dot\omega_b = \tau_b + \omega_b\times(I_b\omega_b) $$
";
    assert_eq!(verdicts(text), "ppr");
}
