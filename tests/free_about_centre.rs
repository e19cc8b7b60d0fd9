//! Bodies that move freely about their mass centre: no torque acts on them.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn what_moves_freely_about_its_mass_centre_is_free_of_torque() {
    let text = |about: &str| {
        format!(
            "The body {about}, and $T$ is its kinetic energy. With the principal moments $A$, $B$, $C$\n\n\
             $$ 2T = A\\omega_1^2 + B\\omega_2^2 + C\\omega_3^2 $$\n\n\
             $$ \\dot T = 0 $$\n"
        )
    };
    assert_eq!(
        verdicts(&text("moves freely about its centre of mass")),
        "pp"
    );
    assert_eq!(
        verdicts(&text("can turn freely about its mass center")),
        "pp"
    );
    assert_ne!(verdicts(&text("turns about a hinge")), "pp");
}
