//! Lines with ±: both values satisfy the equation above, or are the principal moments of two axes.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

fn last(text: &str) -> char {
    verdicts(text).chars().last().unwrap_or(' ')
}

#[test]
fn both_values_are_roots_of_the_equation_above() {
    let of = |root: &str| {
        last(&format!(
            "The frequencies are the roots of $\\lambda^2 + 2b\\lambda + c = 0$, so that\n\n$$ \\lambda_{{1,2}} = {root} $$\n"
        ))
    };
    assert_eq!(of(r"-b \pm \sqrt{b^2 - c}"), 'p');
    assert_eq!(of(r"-b \pm \sqrt{b^2 + c}"), 'r');
    assert_eq!(of(r"b \pm \sqrt{b^2 - c}"), 'r');
}

#[test]
fn both_precessions_of_a_top_solve_its_equation() {
    let with = |under: &str| {
        last(&format!(
            "Steady precession of a heavy top needs\n\n$$ I_1\\cos\\theta\\,\\dot\\phi^2 - I_3\\omega_3\\dot\\phi + Mgl = 0 $$\n\nwith the solutions\n\n\
             $$ \\dot\\phi_\\pm = \\frac{{I_3\\omega_3 \\pm \\sqrt{{I_3^2\\omega_3^2 - {under}}}}}{{2I_1\\cos\\theta}} $$\n"
        ))
    };
    assert_eq!(with(r"4I_1Mgl\cos\theta"), 'p');
    assert_eq!(with(r"4I_1Mgl"), 'r');
}

#[test]
fn principal_moments_of_two_axes_come_from_their_entries() {
    for letter in ["I", "\\lambda"] {
        let with = |product: &str| {
            last(&format!(
                "A plate has the entries $I_{{xx}}$, $I_{{yy}}$ and $I_{{xy}}$. Its principal moments in the plane are\n\n\
                 $$ {letter}_{{1,2}} = \\frac{{I_{{xx}} + I_{{yy}}}}{{2}} \\pm \\sqrt{{\\left(\\frac{{I_{{xx}} - I_{{yy}}}}{{2}}\\right)^2 + {product}}} $$\n"
            ))
        };
        assert_eq!(with("I_{xy}^2"), 'p', "{letter}");
        assert_eq!(with("4I_{xy}^2"), 'r', "{letter}");
    }
}

#[test]
fn words_say_at_which_angle_the_product_vanishes() {
    let with = |value: &str| {
        last(&format!(
            "A lamina has $I_x$, $I_y$ and $I_{{xy}}$ on axes that are turned about $z$ through $\\alpha$:\n\n\
             $$ I_{{x'y'}} = \\tfrac12(I_x - I_y)\\sin 2\\alpha + I_{{xy}}\\cos 2\\alpha $$\n\n\
             The product of inertia vanishes on the principal axes, which are found from\n\n$$ \\tan 2\\alpha = {value} $$\n"
        ))
    };
    assert_eq!(with(r"\frac{2I_{xy}}{I_y - I_x}"), 'a');
    assert_ne!(with(r"\frac{I_{xy}}{I_y - I_x}"), 'a');
    assert_ne!(with(r"\frac{2I_{xy}}{I_x - I_y}"), 'a');
}

#[test]
fn roots_are_real_where_the_discriminant_is_positive() {
    let text = |words: &str, condition: &str, least: &str| {
        let text = format!(
            r"A top of moments $A$, $A$, $C$ about its fixed tip spins steadily. Its mass is $m$ and the centre of mass is at the distance $h$. Suppose

$$ A\cos\theta\,\Omega^2 - C n\,\Omega + mgh = 0 $$

The roots must be real{words}, that is,

$$ {condition} $$

and the least spin is

$$ n_{{\min}} = {least} $$
"
        );
        verdicts(&text)
    };
    let small = " also for a small inclination";
    let (right, least) = (r"C^2 n^2 \ge 4Amgh", r"\frac{2}{C}\sqrt{Amgh}");
    assert_eq!(text(small, right, least), "aaa");
    assert_eq!(text(small, r"4Amgh \le C^2 n^2", least), "aaa");
    assert_eq!(text(small, r"C^2 n^2 \ge 2Amgh", least), "ara");
    assert_eq!(text(small, r"C^2 n^2 \le 4Amgh", least), "ara");
    assert_eq!(text(small, right, r"\frac{4}{C}\sqrt{Amgh}"), "aar");
    assert_eq!(text(small, right, r"\frac{2}{A}\sqrt{Amgh}"), "aar");
    let inclined = text(
        "",
        r"C^2 n^2 \ge 4Amgh\cos\theta",
        r"\frac{2}{C}\sqrt{Amgh\cos\theta}",
    );
    assert_eq!(inclined, "aaa");
}

#[test]
fn a_size_with_the_letter_of_its_vector_has_both_roots() {
    let text = |below: &str| {
        verdicts(&format!(
            r"The axes turn with the rate $\Omega$ about the vertical, the moments are $A$ and $C$:

$$ \boldsymbol{{\Omega}} = \Omega\sin\theta\,\mathbf{{e}}_2 + \Omega\cos\theta\,\mathbf{{e}}_3 $$

The weight gives

$$ A\,\Omega^2\cos\theta - C\,\omega_3\,\Omega + m g l = 0. $$

The two roots are

$$ \Omega = \frac{{C\,\omega_3 \pm \sqrt{{C^2\omega_3^2 - 4A\,m g l\cos\theta}}}}{{{below}A\cos\theta}} $$
"
        ))
    };
    assert!(text("2").ends_with('p'));
    assert!(text("").ends_with('r'));
}

#[test]
fn a_proved_balance_has_its_roots_too() {
    let text = |under: &str, bound: &str| {
        format!(
            r"A symmetric top has the moments of inertia $A$ about $x$ and $y$ and $C$ about its axis $z$ at the fixed point $O$. The axes turn by the precession $\psi$ about the vertical and the nutation $\theta$ about the line of nodes $x$, and not by the spin $\varphi$:

$$ \vec\Omega = \dot\theta\,\hat i + \dot\psi\sin\theta\,\hat j + \dot\psi\cos\theta\,\hat k, \qquad \vec\omega = \vec\Omega + \dot\varphi\,\hat k $$

The weight $mg$ acts at the distance $\ell$ from $O$, so

$$ \sum M_x = mg\ell\sin\theta, \qquad \sum M_y = 0 $$

Suppose $\ddot\theta = 0$ and $\dot\theta = 0$. Then

$$ mg\ell = C\omega_z\dot\psi - A\dot\psi^2\cos\theta $$

with the two roots

$$ \dot\psi = \frac{{C\omega_z \pm \sqrt{{C^2\omega_z^2 - {under}\cos\theta}}}}{{2A\cos\theta}} $$

The motion is possible only when $C^2\omega_z^2 \ge {bound}\cos\theta$.
"
        )
    };
    let found = |under, bound| verdicts(&text(under, bound));
    assert_eq!(found(r"4Amg\ell", r"4Amg\ell"), "ppppaappa");
    assert_eq!(found(r"2Amg\ell", r"4Amg\ell"), "ppppaapra");
    assert_eq!(found(r"4Amg\ell", r"2Amg\ell"), "ppppaappr");
}
