//! Angles that words name: what the angular velocity is in their rates.

#[path = "outcome/verdicts.rs"]
mod outcome;
use outcome::verdicts;

#[test]
fn a_sequence_in_words_decides_the_body_rates() {
    let document = "The attitude is given by heading $\\psi$, pitch $\\theta$ and bank $\\phi$, turned in the order 3-2-1. \
        The components of $\\boldsymbol\\omega$ on body axes then become\n\
        $$\\omega_x = \\dot\\phi - \\dot\\psi\\sin\\theta$$\n\
        $$\\omega_y = \\dot\\theta\\cos\\phi + \\dot\\psi\\cos\\theta\\sin\\phi$$\n\
        $$\\omega_z = \\dot\\theta\\sin\\phi + \\dot\\psi\\cos\\theta\\cos\\phi$$\n\
        and solved the other way\n\
        $$\\dot\\theta = \\omega_y\\cos\\phi - \\omega_z\\sin\\phi$$\n\
        $$\\dot\\psi = (\\omega_y\\sin\\phi + \\omega_z\\cos\\phi)\\cos\\theta$$\n";
    assert_eq!(verdicts(document), "pprpr");
}

#[test]
fn axes_that_leave_the_spin_out_turn_slower_than_the_body() {
    let document = "The axes $x,y,z$ follow the precession $\\phi$ and the nutation $\\theta$ but not the spin $\\psi$ \
        of the top; $I_1 = I_2$. Thus\n\
        $$\\boldsymbol\\omega = \\dot\\theta\\,\\hat e_1 + \\dot\\phi\\sin\\theta\\,\\hat e_2 + (\\dot\\psi + \\dot\\phi\\cos\\theta)\\,\\hat e_3$$\n\
        Hence the energy is\n\
        $$T = \\tfrac12 I_1(\\dot\\theta^2 + \\dot\\phi^2\\sin^2\\theta) + \\tfrac12 I_3(\\dot\\psi + \\dot\\phi\\cos\\theta)^2$$\n\
        and not\n\
        $$T = \\tfrac12 I_1(\\dot\\theta^2 + \\dot\\phi^2) + \\tfrac12 I_3(\\dot\\psi + \\dot\\phi\\cos\\theta)^2$$\n";
    assert_eq!(verdicts(document), "appr");
}

#[test]
fn a_turn_about_fixed_axes_gives_components_in_space() {
    let document = "With the Euler angles $\\phi$, $\\theta$, $\\psi$ in the sequence z-x-z the angular velocity has on axes \
        fixed in space the components\n\
        $$\\omega_x = \\dot\\theta\\cos\\phi + \\dot\\psi\\sin\\theta\\sin\\phi$$\n\
        $$\\omega_y = \\dot\\theta\\sin\\phi - \\dot\\psi\\sin\\theta\\cos\\phi$$\n\
        $$\\omega_z = \\dot\\phi + \\dot\\psi\\cos\\theta$$\n\
        so that\n\
        $$\\omega_x^2 + \\omega_y^2 = \\dot\\theta^2 + \\dot\\psi^2\\sin^2\\theta$$\n";
    assert_eq!(verdicts(document), "pppp");
}

#[test]
fn angles_that_no_words_name_stay_as_the_lines_have_them() {
    let document = "Given\n$$\\omega_x = \\dot\\theta\\sin\\phi$$\n";
    assert!(!verdicts(document).contains('r'));
}

#[test]
fn euler_angles_are_known_by_an_energy_with_equal_moments() {
    let text = |energy: &str, momentum: &str| {
        verdicts(&format!(
            r"A symmetric top has the principal moments $I_1 = I_2$ and $I_3$. With the Euler angles $\phi$, $\theta$, $\psi$ the kinetic energy is

$$ T = \frac12I_1(\dot\theta^2 + \dot\phi^2\sin^2\theta) + \frac12I_3(\dot\psi + \dot\phi\cos\theta)^2 $$

$$ p_\psi = \frac{{\partial T}}{{\partial\dot\psi}} = {energy} $$

$$ p_\phi = \frac{{\partial T}}{{\partial\dot\phi}} = {momentum} $$
"
        ))
        .split_off(1)
    };
    let spin = r"I_3(\dot\psi + \dot\phi\cos\theta)";
    let turn = r"I_1\dot\phi\sin^2\theta + p_\psi\cos\theta";
    assert_eq!(text(spin, turn), "ppp");
    assert_eq!(text(spin, &turn.replace(r"\cos", r"\sin")), "ppr");
}

#[test]
fn euler_equations_give_the_second_rates_of_the_angles() {
    let tilt = |sign: char| {
        verdicts(&format!(
            r"A heavy symmetric top of mass $m$ has the principal moments $A$, $A$ and $C$ about its fixed tip. With the Euler angles $\phi$, $\theta$, $\psi$ the kinetic energy is

$$ T = \frac12A(\dot\theta^2 + \dot\phi^2\sin^2\theta) + \frac12C(\dot\psi + \dot\phi\cos\theta)^2 $$

and with the potential energy $V = mgl\cos\theta$ the equation for $\theta$ is

$$ A\ddot\theta = A\dot\phi^2\sin\theta\cos\theta {sign} C(\dot\psi + \dot\phi\cos\theta)\dot\phi\sin\theta + mgl\sin\theta $$
"
        ))
    };
    assert!(tilt('-').ends_with('p'), "{}", tilt('-'));
    assert!(tilt('+').ends_with(['r', 'u']), "{}", tilt('+'));
}
