//! Documents of several sections or cases: what goes on from one to the next.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn a_motion_goes_on_under_the_next_headings_where_nothing_moves_in_another_way() {
    let text = |later: &str| {
        format!(
            r"A thin disk of mass $m$ and radius $r$ sits on a shaft. Axes fixed in the disk: $\mathbf e_2$ is the normal, the axes are principal, and the moments of inertia are $P$ about the normal and $D$ about a diameter.

## Rates

The shaft turns at the constant rate $n$, so

$$ \boldsymbol\omega = n\sin\gamma\,\mathbf e_1 + n\cos\gamma\,\mathbf e_2 $$

## Momentum

$$ \mathbf H = D n\sin\gamma\,\mathbf e_1 + P n\cos\gamma\,\mathbf e_2 $$

## Moment

$$ {later} $$
"
        )
    };
    let found = |later| verdicts(&text(later));
    assert_eq!(found(r"M_3 = (P - D) n^2\sin\gamma\cos\gamma"), "app");
    assert_eq!(found(r"M_3 = (D - P) n^2\sin\gamma\cos\gamma"), "apr");
    // Under a heading of its own the rate may change.
    assert_eq!(
        found(r"M_2 = P\dot\omega_2 + (P - D)\omega_1\omega_3"),
        "apr"
    );
}

#[test]
fn each_case_spins_about_an_axis_of_its_own() {
    let text = |second: &str, growth: &str| {
        format!(
            r"A free body has the principal moments $A$, $B$, $C$.

**Case 1.** The body turns nearly about $z$; $\omega_x$ and $\omega_y$ are small. Neglecting the product $\omega_x\omega_y$ we have

$$ \dot\omega_z = 0 $$

so that $\omega_x$ oscillates with the frequency, since $\ddot\omega_x = -\frac{{(C-A)(C-B)}}{{AB}}\omega_z^2\omega_x$,

$$ \Omega_z^2 = \frac{{(C-A)(C-B)}}{{AB}}\omega_z^2 $$

**Case 2.** Same steps. Now $\omega_x$ is constant and

$$ \ddot\omega_y = -\frac{{(C-A)(B-A)}}{{BC}}\omega_x^2\omega_y $$

$$ \Omega_x^2 = \frac{{{second}}}{{BC}}\omega_x^2 $$

**Case 3.** $\omega_x$ and $\omega_z$ are small and $\omega_y$ remains constant. Then

$$ \ddot\omega_x = \frac{{(C-B)(B-A)}}{{AC}}\omega_y^2\omega_x $$

and $\omega_x$ grows as $e^{{\lambda t}}$ with

$$ \lambda = \omega_y{growth} $$
"
        )
    };
    let found = |second, growth| verdicts(&text(second, growth));
    let root = r"\sqrt{\frac{(C-B)(B-A)}{AC}}";
    assert_eq!(found("(C-A)(B-A)", root), "ppapapa");
    assert_eq!(found("(C-A)(A-B)", root), "ppaprpa");
    let square = r"\frac{(C-B)(B-A)}{AC}";
    assert_eq!(found("(C-A)(B-A)", square), "ppapapr");
}

#[test]
fn the_rate_of_the_spin_vanishes_to_first_order_by_the_law() {
    let text = |rate: &str| {
        verdicts(&format!(
            r"A free body has the principal moments $J_1$, $J_2$, $J_3$. No torque acts. Let

$$ \omega_3 = n + \epsilon_3 $$

where $n$ is constant and $\omega_1$, $\omega_2$, $\epsilon_3$ are small. To first order

$$ J_1\dot\omega_1 = -(J_3-J_2) n\omega_2 $$

$$ J_3\dot\epsilon_3 = {rate} $$
"
        ))
    };
    assert_eq!(text("0"), "app");
    assert!(!text(r"(J_1 - J_2) n\omega_2").ends_with(['p', 'a']));
}

#[test]
fn a_square_that_a_line_adds_is_not_below_zero() {
    let text = |relation: &str| {
        verdicts(&format!(
            r"A free body. Principal axes, no torque. The kinetic energy is

$$ T = \tfrac12(I_1\omega_1^2 + I_2\omega_2^2 + I_3\omega_3^2) $$

With a step $h$ let $E = T + \tfrac12 h^2(I_1\dot\omega_1^2 + I_2\dot\omega_2^2 + I_3\dot\omega_3^2)$. Then $E {relation} T$.
"
        ))
    };
    assert_eq!(text(r"\ge"), "pap");
    assert_eq!(text(r"\le"), "par");
    assert_eq!(text("<"), "par");
}

#[test]
fn a_torque_that_acts_now_ends_that_none_did() {
    let power = |watts: &str| {
        let text = format!(
            "A body has $I_x = 2$, $I_y = 3$, $I_z = 4$ about its principal axes and turns at $\\omega_x = 1$, $\\omega_y = 2$, $\\omega_z = -1$.\n\n\
             (i) Without torque\n\n$$ \\dot\\omega_x = \\frac{{(I_y - I_z)\\omega_y\\omega_z}}{{I_x}} = 1 $$\n\n\
             (ii) The torque now has the components $M_x = 4$, $M_y = -1$, $M_z = 0$. The power is\n\n\
             $$ P = M_x\\omega_x + M_y\\omega_y + M_z\\omega_z = {watts} $$\n"
        );
        verdicts(&text).chars().last()
    };
    assert_eq!(power("2"), Some('p'));
    assert_eq!(power("6"), Some('r'));
}

#[test]
fn numbers_of_a_case_take_the_place_of_numbers_alone() {
    let text = |moment: &str| {
        verdicts(&format!(
            "A disc has the mass $m$, the radius $R$ and the principal moments $I_1 = I_2 = \\tfrac14 mR^2$, $I_3 = \\tfrac12 mR^2$.\n\n\
             **Numbers.** With $m = 2$ and $R = 0.15$ we get\n\n$$ I_1 = 0.01125 $$\n\n\
             **Other numbers.** With $m = 3$ we get\n\n$$ I_1 = {moment} $$\n"
        ))
    };
    assert_eq!(text("0.016875"), "aaaapap");
    assert_eq!(text("0.01125"), "aaaapar");
}

#[test]
fn what_vanishes_now_is_supposed() {
    let text = |moment: &str| {
        verdicts(&format!(
            "A disc has the principal moments $I_1 = I_2 = A$ and $I_3 = C$. The angular velocity $\\vec\\omega$ points along the shaft:\n\n\
             $$ \\omega_1 = \\omega\\sin\\beta, \\qquad \\omega_2 = 0, \\qquad \\omega_3 = \\omega\\cos\\beta $$\n\n\
             with a fixed angle $\\beta$. Now $\\dot\\omega = 0$, and Euler's equations leave one moment:\n\n\
             $$ M_1 = 0, \\qquad M_2 = {moment}\\,\\omega_3\\omega_1 $$\n"
        ))
    };
    assert_eq!(text("(A - C)"), "aaaaaapp");
    assert_eq!(text("(C - A)"), "aaaaaapr");
}
