//! Euler's equation for one body of several, with the body's label on every symbol.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

fn chain(named: &str, right: &str) -> String {
    verdicts(&format!(
        r"Body $k$ of the chain has the tensor $\mathbf J_k$ about its mass centre and the angular velocity $\boldsymbol\omega_k$. {named} body $k$ is

$$ \mathbf g_k = {right} $$
"
    ))
}

#[test]
fn the_moment_on_a_labelled_body_obeys_eulers_equation() {
    let moment = "The moment on";
    let rate = r"\mathbf J_k\dot{\boldsymbol\omega}_k";
    let turning = r"\boldsymbol\omega_k\times\mathbf J_k\boldsymbol\omega_k";
    assert_eq!(chain(moment, &format!("{rate} + {turning}")), "a");
    assert_eq!(chain(moment, &format!("{rate} - {turning}")), "r");
    assert_eq!(chain(moment, &format!("-{rate} - {turning}")), "u");
    assert_eq!(chain("This vector of", &format!("{rate} - {turning}")), "u");
}
