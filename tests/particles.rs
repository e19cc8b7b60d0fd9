//! Sums over the particles of a body: angular momentum and kinetic energy from where they begin.

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

fn last(line: &str) -> char {
    let text = format!(
        r"A rigid body has one point $O$ fixed, and for the $i$-th particle of it $\vec v_i = \vec\omega\times\vec r_i$. The angular momentum about $O$ is $\vec L$, its kinetic energy is $T$.

$$ {line} $$
"
    );
    verdicts(&text).chars().last().unwrap_or(' ')
}

#[test]
fn momentum_and_energy_are_sums_over_particles() {
    for (line, verdict) in [
        (r"\vec L = \sum_i m_i\,(\vec r_i\times\vec v_i)", 'p'),
        (
            r"\vec L = \sum_i m_i\,\vec r_i\times(\vec\omega\times\vec r_i)",
            'p',
        ),
        (
            r"\vec L = \sum_i m_i\,[r_i^2\,\vec\omega - (\vec r_i\cdot\vec\omega)\,\vec r_i]",
            'p',
        ),
        (r"\vec L = \sum_i m_i\,(\vec v_i\times\vec r_i)", 'r'),
        (
            r"\vec L = \sum_i m_i\,[r_i^2\,\vec\omega + (\vec r_i\cdot\vec\omega)\,\vec r_i]",
            'r',
        ),
        (r"T = \frac12\sum_i m_i v_i^2", 'p'),
        (
            r"T = \frac12\sum_i m_i\,\vec v_i\cdot(\vec\omega\times\vec r_i)",
            'p',
        ),
        (r"T = \sum_i m_i v_i^2", 'r'),
    ] {
        let found = last(line);
        match verdict {
            'p' => assert_eq!(found, 'p', "{line}"),
            _ => assert!(!matches!(found, 'p' | 'a'), "{line}: {found}"),
        }
    }
}

#[test]
fn places_of_particles_are_fixed_in_the_body_and_measured_from_its_centre() {
    let text = |sign: &str| {
        format!(
            "A rigid body has particles with the mass $m_i$ at $\\vec\\rho_i$, measured from the mass centre $G$.\n\n\
             $$ \\vec H_G = \\sum_i \\vec\\rho_i\\times m_i\\dot{{\\vec\\rho}}_i $$\n\n\
             $$ \\sum_i m_i\\vec\\rho_i = \\vec 0 $$\n\n$$ \\dot{{\\vec\\rho}}_i = {sign}\\vec\\omega\\times\\vec\\rho_i $$\n\n\
             $$ \\vec H_G = \\sum_i m_i\\,\\vec\\rho_i\\times(\\vec\\omega\\times\\vec\\rho_i) $$\n"
        )
    };
    assert!(matches!(verdicts(&text("")).as_str(), "pppp" | "appp"));
    assert_eq!(verdicts(&text("-")).chars().nth(2), Some('r'));
}

#[test]
fn a_mass_element_of_a_rigid_body_moves_by_its_turn() {
    let text = |velocity: &str| {
        verdicts(&format!(
            "# Momentum of a rigid body\n\nLet $\\mathbf r$ be the position of a mass element relative to the mass centre. Its \
             velocity is $\\dot{{\\mathbf r}} = {velocity}$, so\n\n\
             $$ \\mathbf L = \\int\\mathbf r\\times(\\boldsymbol\\omega\\times\\mathbf r)\\,dm = \
             \\int\\left[r^2\\boldsymbol\\omega - (\\mathbf r\\cdot\\boldsymbol\\omega)\\mathbf r\\right]dm $$\n"
        ))
    };
    assert_eq!(text("\\boldsymbol\\omega\\times\\mathbf r"), "pp");
    assert_eq!(text("\\mathbf r\\times\\boldsymbol\\omega"), "rp");
}
