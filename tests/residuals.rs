//! Residuals of implicit steps, and derivatives in what a line has given a name.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

fn step(slope: &str, torque: &str) -> String {
    verdicts(&format!(
        r"All vectors are on body axes, $\mathbf J$ is the constant symmetric inertia matrix and $E$ the $3\times 3$ identity. With the step $k$ define the mean

$$ \mathbf m = \tfrac12(\boldsymbol\omega_n + \boldsymbol\omega_{{n+1}}) $$

The new velocity is the root of the residual

$$ \mathbf r = \mathbf J(\boldsymbol\omega_{{n+1}} - \boldsymbol\omega_n) + k\,\mathbf m\times(\mathbf J\mathbf m) - k\boldsymbol\tau $$

By the chain rule

$$ \frac{{\partial\mathbf r}}{{\partial\boldsymbol\omega_{{n+1}}}} = \mathbf J + {slope}\left([\mathbf m]_\times\mathbf J - [\mathbf J\mathbf m]_\times\right) $$

$$ \frac{{\partial\mathbf r}}{{\partial\boldsymbol\tau}} = {torque} $$

$$ \frac{{\partial}}{{\partial\mathbf m}}\left(\mathbf m\times\mathbf J\mathbf m\right) = [\mathbf m]_\times\mathbf J - [\mathbf J\mathbf m]_\times $$
"
    ))
}

#[test]
fn a_residual_is_no_position() {
    assert_eq!(step(r"\tfrac k2", "-kE"), "aappp");
    assert_eq!(step("k", "-kE"), "aarpp");
    assert_eq!(step(r"\tfrac k2", "kE"), "aaprp");
}

#[test]
fn it_vanishes_at_its_root() {
    let with = |words: &str, power: &str| {
        verdicts(&format!(
            r"Body axes. $\mathbf I$ is the constant inertia matrix. The new velocity is the root of the residual

$$ \mathbf g = \mathbf I(\boldsymbol\omega_{{k+1}} - \boldsymbol\omega_k) + \tfrac h4(\boldsymbol\omega_k + \boldsymbol\omega_{{k+1}})\times\mathbf I(\boldsymbol\omega_k + \boldsymbol\omega_{{k+1}}) $$

{words}

$$ (\boldsymbol\omega_k + \boldsymbol\omega_{{k+1}})\cdot\mathbf I(\boldsymbol\omega_{{k+1}} - {power}\boldsymbol\omega_k) = 0 $$
"
        ))
    };
    assert_eq!(with("At the root of the residual", ""), "ap");
    assert_ne!(with("At the root of the residual", "2"), "ap");
    assert_ne!(with("For any velocities", ""), "ap");
}

#[test]
fn a_derivative_is_no_definition() {
    let text = "Body axes, a moment $\\boldsymbol\\tau$. Define\n\n$$ \\mathbf u = h\\boldsymbol\\tau + ? $$\n\n\
                $$ \\frac{\\partial\\mathbf u}{\\partial\\boldsymbol\\tau} = 3h $$\n";
    assert!(!verdicts(text).ends_with('a'));
}
