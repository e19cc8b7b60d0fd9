//! Complex equations: two real ones joined by the imaginary unit.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn two_equations_are_joined_by_the_imaginary_unit() {
    let last = |right: &str| {
        let text = format!(
            "Principal axes, moments $A$, $A$, $C$, components of the angular velocity $p$, $q$, $r$. No torque acts. Define the complex rate\n\n\
             $$ \\zeta = p + i\\,q $$\n\nThe two equations across the axis become one,\n\n\
             $$ \\dot\\zeta = {right}\\frac{{C - A}}{{A}}r\\,\\zeta $$\n"
        );
        verdicts(&text)
    };
    assert_eq!(last("i\\,"), "ap");
    assert_ne!(last("-i\\,"), "ap");
    assert_ne!(last(""), "ap");
}

#[test]
fn an_i_without_complex_numbers_is_a_symbol() {
    let text = "Let $i = 3$ and $k = 2$. Then\n\n$$ i^2 = -1 $$\n";
    assert_ne!(verdicts(text).chars().last(), Some('p'));
}

#[test]
fn a_complex_solution_leaves_its_parts_free() {
    let text = |sign: &str| {
        format!(
            "Principal axes, moments $A$, $A$, $C$. No torque acts. Put $\\lambda = \\frac{{C - A}}{{A}}\\omega_z$ and \
             $\\eta = \\omega_x + i\\,\\omega_y$. Then\n\n$$ \\dot\\eta = i\\lambda\\eta, \\qquad \\eta(t) = \\eta(0)\\,e^{{i\\lambda t}} $$\n\n\
             In real form, with the amplitude $w$,\n\n$$ \\begin{{aligned}} \\omega_x &= w\\cos\\lambda t \\\\ \
             \\omega_y &= {sign}w\\sin\\lambda t \\end{{aligned}} $$\n"
        )
    };
    assert_eq!(verdicts(&text("")), "aapaap");
    assert_eq!(verdicts(&text("-")), "aapaar");
}

/// A free symmetric body, and what is said of its motion.
fn free_symmetric(line: &str) -> String {
    let all = verdicts(&format!(
        "The top is symmetric, $I_1 = I_2 = A$, $I_3 = C$, and free of torque. Then $\\omega_3 = n$ is constant and with \
         $\\lambda = (C-A)n/A$ and $\\zeta = \\omega_1 + i\\omega_2$\n\n$$ {line} $$\n"
    ));
    all.chars().skip(5).collect()
}

#[test]
fn a_solution_is_taken_in_where_it_solves_the_equation_of_motion() {
    let real = |turns: &str, sign: &str| {
        free_symmetric(&format!(
            r"\omega_1 = a\cos({turns}\lambda t + \phi), \qquad \omega_2 = {sign}a\sin({turns}\lambda t + \phi)"
        ))
    };
    assert_eq!(real("", ""), "ap");
    assert_eq!(real("", "-"), "ar");
    assert_ne!(real("2", "").chars().next(), Some('a'));
    assert_eq!(free_symmetric(r"\omega_1 = a\cos 2\lambda t"), "r");
    assert_eq!(free_symmetric(r"\omega_1 = a\cos\lambda t"), "a");
    assert_eq!(free_symmetric(r"\zeta = \zeta_0 e^{i\lambda t}"), "a");
    assert_eq!(free_symmetric(r"\zeta = \zeta_0 e^{-i\lambda t}"), "u");
}

#[test]
fn an_exponential_of_an_imaginary_angle_has_a_cosine_and_a_sine() {
    assert_eq!(
        free_symmetric(r"e^{i\lambda t} = \cos\lambda t + i\sin\lambda t"),
        "p"
    );
    assert_ne!(
        free_symmetric(r"e^{i\lambda t} = \cos\lambda t - i\sin\lambda t"),
        "p"
    );
    assert_eq!(
        free_symmetric(r"|\zeta|^2 = \omega_1^2 + \omega_2^2 = \text{const}"),
        "p"
    );
}

#[test]
fn an_upright_i_stands_beside_unit_vectors_with_marks() {
    let text = r"The axes $Gxyz$ are fixed in the body and $Gz$ is the axis of revolution. The moment of inertia about $Gz$ is $C$, about any transverse axis through $G$ it is $A$. No moment acts about $G$.

$$ \vec H = A\,\omega_x\,\vec\imath + A\,\omega_y\,\vec\jmath + C\,\omega_z\,\vec k $$

Let $w = \omega_x + \mathrm{i}\,\omega_y$ and $\lambda = \frac{C - A}{A}\omega_z$. Then

$$ \dot w = \mathrm{i}\lambda\,w $$

$$ \dot w = -\mathrm{i}\lambda\,w $$
";
    let found = verdicts(text);
    assert!(matches!(found.as_str(), "paapr" | "paapu"), "{found}");
}
