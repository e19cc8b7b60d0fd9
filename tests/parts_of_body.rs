//! Bodies of several parts on one axis, of which a line writes the momentum by the moments of the parts.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

fn dual_spin(momentum: &str, lines: &[&str]) -> String {
    let text = format!(
        r"A bus B and a wheel W turn about the bearing axis $\hat k$. The transverse moment of inertia of the whole is $J_n$, the axial moments are $J_B$ and $J_W$, the axial rates in space are $\Omega_B$ and $\Omega_W$. We use axes fixed in the bus, so the axes turn with

$$ \vec\Omega = \Omega_x\hat i + \Omega_y\hat j + \Omega_B\hat k $$

and the angular momentum is

$$ \vec H = J_n\Omega_x\hat i + J_n\Omega_y\hat j + ({momentum})\hat k $$

"
    );
    let rest: String = lines
        .iter()
        .map(|line| format!("Hence\n\n$$ {line} $$\n\n"))
        .collect();
    verdicts(&(text + &rest))
}

const MOMENTUM: &str = r"J_B\Omega_B + J_W\Omega_W";

#[test]
fn the_parts_give_momentum_and_energy() {
    let moment = r"M_y = J_n\dot\Omega_y - (J_B\Omega_B + J_W\Omega_W - J_n\Omega_B)\Omega_x";
    let wrong = r"M_y = J_n\dot\Omega_y + (J_B\Omega_B + J_W\Omega_W - J_n\Omega_B)\Omega_x";
    let energy = r"T = \tfrac12 J_n(\Omega_x^2 + \Omega_y^2) + \tfrac12 J_B\Omega_B^2 + \tfrac12 J_W\Omega_W^2";
    assert_eq!(dual_spin(MOMENTUM, &[moment, energy]), "aapp");
    assert_eq!(dual_spin(MOMENTUM, &[wrong, energy]), "aarp");
    let lost =
        r"T = \tfrac12 J_n(\Omega_x^2 + \Omega_y^2) + \tfrac12 J_B\Omega_B^2 + J_W\Omega_W^2";
    assert_eq!(dual_spin(MOMENTUM, &[moment, lost]), "aapr");
}

#[test]
fn a_moment_beside_the_rate_of_another_part_is_not_taken_in() {
    assert!(!dual_spin(r"J_B\Omega_B + J_B\Omega_W", &[]).ends_with('a'));
}

#[test]
fn axes_under_a_dotted_vector_are_those_of_its_rate() {
    let text = |mark: &str| {
        format!("$$ \\bar M = \\dot{{\\bar H}}_{{{mark}}} + \\bar\\omega\\times\\bar H $$\n")
    };
    assert_eq!(verdicts(&text("xyz")), "p");
    assert_eq!(verdicts(&text("XYZ")), "r");
}
