//! Tops under their weight, on axes that do not take part in the spin.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

fn top(words: &str, weight: &str, twice: &str, spin: &str) -> String {
    verdicts(&format!(
        r"A symmetric top turns by the precession angle $\phi$ about the vertical, the nutation angle $\theta$ about the line of nodes and the spin angle $\psi$ about its axis. $\hat k$ is along its axis and $\hat i$ along the line of nodes; the axes do not take part in the spin and turn with

$$ \boldsymbol\Omega = \dot\theta\,\hat i + \dot\phi\sin\theta\,\hat j + \dot\phi\cos\theta\,\hat k $$

$$ \boldsymbol\omega = \boldsymbol\Omega + \dot\psi\,\hat k $$

Let $s = \dot\psi + \dot\phi\cos\theta$. With the moments of inertia $A$, $A$, $C$

$$ \mathbf L = A\dot\theta\,\hat i + A\dot\phi\sin\theta\,\hat j + Cs\,\hat k $$

{words} So the components are

$$ {weight} = A\ddot\theta - A\dot\phi^2\sin\theta\cos\theta + Cs\dot\phi\sin\theta $$

$$ 0 = A\ddot\phi\sin\theta + {twice}A\dot\phi\dot\theta\cos\theta - Cs\dot\theta $$

$$ 0 = {spin}C\dot s $$
"
    ))
}

#[test]
fn the_weight_makes_a_moment_about_the_line_of_nodes() {
    let words = "The weight $mg$ acts at the distance $d$ from $O$.";
    let ends = |found: String| found[found.len() - 3..].to_owned();
    assert_eq!(ends(top(words, r"mgd\sin\theta", "2", "")), "ppp");
    assert_eq!(ends(top(words, r"mgd\sin\theta", "", "")), "prp");
    let false_one = ends(top(words, r"mgd\cos\theta", "2", ""));
    assert!(
        !false_one.starts_with('p') && !false_one.starts_with('a'),
        "{false_one}"
    );
    let other = "The weight $mg$ acts at the distance $d$ from $O$, and so does the friction.";
    assert!(!ends(top(other, r"mgd\sin\theta", "", "")).contains('r'));
}

#[test]
fn the_vertical_of_numbered_axes_is_no_third_axis() {
    let text = |end: &str| {
        verdicts(&format!(
            r"A top spins with its tip $O$ held. The moments of inertia at $O$ are $C$ about the axis and $A$ about any line across it.
The axes $\mathbf e_1,\mathbf e_2,\mathbf e_3$ follow the tilt $\theta$ and the precession $\phi$ of the top but not the spin $\psi$:

$$ \boldsymbol\Omega = \dot\theta\,\mathbf e_1 + \dot\phi\sin\theta\,\mathbf e_2 + \dot\phi\cos\theta\,\mathbf e_3 $$

$$ \boldsymbol\omega = \dot\theta\,\mathbf e_1 + \dot\phi\sin\theta\,\mathbf e_2 + n\,\mathbf e_3, \qquad n = \dot\psi + \dot\phi\cos\theta $$

$$ \mathbf L = A\dot\theta\,\mathbf e_1 + A\dot\phi\sin\theta\,\mathbf e_2 + C n\,\mathbf e_3 $$

The weight has the moment $\mathbf N = m g l\sin\theta\,\mathbf e_1$, and

$$ \mathbf N = \dot{{\mathbf L}}_{{\rm rot}} + \boldsymbol\Omega\times\mathbf L $$

{end}
"
        ))
    };
    for (words, bend, verdict) in [
        (
            "In a steady precession we have",
            r"C n\dot\phi - A\dot\phi^2\cos\theta = m g l",
            "paap",
        ),
        (
            "For a regular precession",
            r"C n\dot\phi - A\dot\phi^2\cos\theta = m g l",
            "paap",
        ),
        (
            "During a steady motion one has",
            r"C n\dot\phi + A\dot\phi^2\cos\theta = m g l",
            "paar",
        ),
    ] {
        let end = format!(
            r"{words} $\dot\theta = \ddot\theta = 0$, and for $\sin\theta\neq 0$ the equation becomes

$$ {bend} $$"
        );
        let found = text(&end);
        assert!(found.ends_with(verdict), "{words}: {found}");
    }
    for (sign, verdict) in [("+", "pp"), ("-", "pr")] {
        let end = format!(
            r"The component of $\mathbf L$ along the vertical is

$$ L_z = A\dot\phi\sin^2\theta {sign} C n\cos\theta $$"
        );
        let found = text(&end);
        assert!(found.ends_with(verdict), "{sign}: {found}");
    }
}

#[test]
fn a_frame_follows_the_precession_and_gravity_acts_about_one_axis() {
    let text = |nodes: &str, steady: &str| {
        verdicts(&format!(
            r"A top spins about its fixed tip $O$; its centre of mass is at the distance $\ell$ on the symmetry axis $z$. The $xyz$ frame follows the precession $\psi$ and the nutation $\theta$ but not the spin, so its angular velocity has the components

$$ \Omega_x = \dot\theta, \qquad \Omega_y = \dot\psi\sin\theta, \qquad \Omega_z = \dot\psi\cos\theta $$

The body differs from the frame only by its spin $\dot\phi$ about $z$, hence $\omega_z = \dot\psi\cos\theta + \dot\phi$.

## Equations of motion

With the moments $A, A, C$ the angular momentum is

$$ \mathbf H_O = A\dot\theta\,\mathbf i + A\dot\psi\sin\theta\,\mathbf j + C\omega_z\,\mathbf k $$

Gravity has a moment about $x$ only: $\sum M_x = mg\ell\sin\theta$. Hence

$$ A\ddot\psi\sin\theta + {nodes}\dot\psi\dot\theta\cos\theta - C\omega_z\dot\theta = 0 $$

## Steady precession

Assume that $\theta$ is constant and that $\theta \ne 0$. Then

$$ C\omega_z\dot\psi - A\dot\psi^2\cos\theta = mg\ell $$

For a horizontal axis, put $\theta = \pi/2$. The condition shrinks to ${steady}$.
"
        ))
    };
    assert_eq!(text("2A", r"C\dot\phi\,\dot\psi = mg\ell"), "pppppppapap");
    assert_eq!(text("A", r"C\dot\phi\,\dot\psi = 2mg\ell"), "pppppprapar");
}

#[test]
fn a_top_precesses_steadily_at_a_constant_angle() {
    let text = |sign: &str| {
        verdicts(&format!(
            "A symmetric top with the moments $A, A, C$ about its fixed point precesses steadily at the rate $\\dot\\psi$ while \
             its axis makes the constant angle $\\theta$ with the vertical; its spin is $\\dot\\phi$, constant as well, the weight \
             is $mg$ and the mass centre is at the distance $l$ from the point.\n\n\
             $$ \\omega_3 = \\dot\\phi + \\dot\\psi\\cos\\theta $$\n\n\
             $$ C\\omega_3\\dot\\psi {sign} A\\dot\\psi^2\\cos\\theta = mgl $$\n"
        ))
    };
    assert_eq!(text("-"), "pp");
    assert!(!text("+").ends_with(['p', 'a']));
}

#[test]
fn axes_that_do_not_spin_leave_the_spin_to_words() {
    let text = |spin: &str, second: &str, vertical: &str, steady: &str| {
        verdicts(&format!(
            "Wheel of mass $m$ on a pivot $O$, centre of mass at the distance $\\ell$ from $O$ along the axle. Moments of inertia \
             about $O$: $A$ across the axle, $C$ along it. A frame follows the axle but does not spin: $\\mathbf e_3$ on the axle, \
             $\\mathbf e_1$ horizontal, and\n\n$$ \\mathbf k = \\sin\\theta\\,\\mathbf e_2 + \\cos\\theta\\,\\mathbf e_3 $$\n\n\
             The frame turns with\n\n\
             $$ \\boldsymbol\\Omega = \\dot\\theta\\,\\mathbf e_1 + \\dot\\phi\\sin\\theta\\,\\mathbf e_2 + \\dot\\phi\\cos\\theta\\,\\mathbf e_3 $$\n\n\
             and the wheel {spin} about the axle. Write $s = \\dot\\psi + \\dot\\phi\\cos\\theta$. Then\n\n\
             $$ \\mathbf L_O = A\\dot\\theta\\,\\mathbf e_1 + A\\dot\\phi\\sin\\theta\\,\\mathbf e_2 + {second} s\\,\\mathbf e_3 $$\n\n\
             The weight pulls at the centre of mass:\n\n\
             $$ \\mathbf M_O = \\ell\\,\\mathbf e_3\\times(-mg\\,\\mathbf k) = mg\\ell\\sin\\theta\\;\\mathbf e_1 $$\n\n\
             $$ \\mathbf L_O\\cdot\\mathbf k = A\\dot\\phi{vertical}\\theta + C s\\cos\\theta $$\n\n\
             Now let $\\dot\\theta = 0$ at all times. Then\n\n$$ C s\\,\\dot\\phi - A\\dot\\phi^2\\cos\\theta = {steady} $$\n\n\
             With the axle horizontal ($\\cos\\theta$ vanishes)\n\n$$ \\dot\\phi = \\frac{{mg\\ell}}{{C s}} $$\n"
        ))
    };
    let (adds, square, weight) = ("only adds $\\dot\\psi$", "\\sin^2", "mg\\ell");
    assert_eq!(text(adds, "C", square, weight), "aaapppapp");
    let spins = "spins at $\\dot\\psi$";
    assert_eq!(text(spins, "C", square, weight), "aaapppapp");
    assert_eq!(text(adds, "A", square, weight), "aaarppapp");
    assert_eq!(text(adds, "C", square, "2mg\\ell"), "aaappparp");
    // A false line changes nothing of what follows.
    let slip = text(adds, "C", "\\sin", weight);
    assert!(slip.ends_with("rapp"), "{slip}");
}
