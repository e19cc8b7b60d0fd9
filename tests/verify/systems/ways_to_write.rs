//! How authors write, and what they say of it: axes by their names, columns of two, primes, signs and braces.

use super::{judged, verdicts};

#[test]
fn the_name_of_an_axis_is_its_unit_vector_where_nothing_else_is_told_of_it() {
    let sentences = r"
N is an inertial frame.
n, w, u are the axes of N.
B turns relative to N about u by the angle $\psi$.
a, b, u are the axes of B.
$\vec\omega$ is the angular velocity of B relative to N.
O is a point fixed in N.
P lies at the distance $l$ from O along a.
$l$ is constant.
$\vec v$ is the velocity of P relative to N.
";
    let text = r"
$$ a=\cos\psi\,n+\sin\psi\,w $$
$$ \hat a=\cos\psi\,\hat n+\sin\psi\,\hat w $$
$$ \vec\omega=\dot\psi\,\vec u $$
$$ \vec v=l\dot\psi\,b $$
$$ \vec v=l\dot\psi\cos\psi\,w-l\dot\psi\sin\psi\,n $$
$$ \vec v=l\dot\psi\cos\psi\,w+l\dot\psi\sin\psi\,n $$
";
    assert_eq!(judged(sentences, text), "pppppu");
}

#[test]
fn what_may_be_a_number_or_another_vector_is_not_denied_by_the_axis_of_its_name() {
    let sentences = r"
N is an inertial frame.
x, y, z are the axes of N.
B turns relative to N about z by the angle $\psi$.
P is a particle of mass $m$.
$\vec F$ is the total force on P.
$\vec v$ is the velocity of P relative to N.
";
    let text = r"
$$ x=-y\tan\psi $$
$$ \vec v=\dot x $$
$$ \vec F=k x $$
";
    let found = judged(sentences, text);
    assert!(!found.contains(['r', 'p']), "{found}");
}

#[test]
fn axes_of_two_frames_with_one_name_are_taken_only_where_they_are_the_same() {
    let sentences = |turn: &str| {
        format!(
            "
N is an inertial frame.
n, w, u are the axes of N.
a, b, u are the axes of B.
{turn}
$\\vec\\omega$ is the angular velocity of B relative to N.
"
        )
    };
    let text = r"$$ \vec\omega=\dot\psi\,u $$";
    let same = sentences("B turns relative to N about u by the angle $\\psi$.");
    assert_eq!(judged(&same, text), "p");
    let other = sentences(
        "B is turned relative to N first about n by $\\psi$ and then about a by $\\chi$.",
    );
    assert_ne!(verdicts(&other, text).0, "p");
    assert_ne!(verdicts(&other, text).0, "r");
}

#[test]
fn a_frame_turns_about_a_combination_of_axes_that_another_one_has_too() {
    let sentences = r"
N is an inertial frame.
$\vec n$, $\vec w$, $\vec u$ are the axes of E.
E turns relative to N about $\cos\lambda\,\vec n+\sin\lambda\,\vec u$ at the constant rate $\Omega$.
$\lambda$ is constant.
D turns relative to E about $\vec u$ by the angle $\psi$.
$\vec p$, $\vec q$, $\vec u$ are the axes of D.
B is a frame fixed in the rotor.
The rotor is symmetric about $\vec p$.
B turns relative to D about $\vec p$ by the angle $\phi$.
$\vec w_E$ is the angular velocity of E relative to N.
$\vec w_D$ is the angular velocity of D relative to N.
";
    let text = r"
$$ \vec w_E=\Omega\cos\lambda\,\vec n+\Omega\sin\lambda\,\vec u $$
$$ \vec w_D=\Omega\cos\lambda\cos\psi\,\vec p-\Omega\cos\lambda\sin\psi\,\vec q+(\dot\psi+\Omega\sin\lambda)\vec u $$
$$ \vec w_D=\Omega\cos\lambda\cos\psi\,\vec p+\Omega\cos\lambda\sin\psi\,\vec q+(\dot\psi+\Omega\sin\lambda)\vec u $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn no_moment_along_two_axes_is_none_along_either() {
    for said in [
        "No moment acts on the body about G along x and along y.",
        "No moment acts on the body about G along x or along y.",
    ] {
        let sentences = format!(
            "{}{said}\nx, y, z are the axes of B.\n$L$ is the total moment on the body about G.\n$L_x$, $L_y$, $L_z$ are the components of $L$ on B.\n",
            super::BODY
        );
        let text = "$$ L_x=0 $$\n$$ L_y=0 $$\n$$ L_z=0 $$\n";
        let found = judged(&sentences, text);
        assert!(found.starts_with("pp") && !found.ends_with('p'), "{found}");
    }
}

#[test]
fn a_column_of_two_entries_holds_components_on_two_axes() {
    let sentences = r"
N is an inertial frame.
x, y, z are the axes of N.
A turns relative to N about z by the angle $q$.
$x_1$, $y_1$, $z_1$ are the axes of A.
O is a point fixed in N and in A.
P lies at the distance $l$ from O along $x_1$.
$l$ is constant.
$\mathbf p$ is the position of P from O in components on x and y.
";
    let text = r"
$$ \mathbf p=l\begin{bmatrix}\cos q\\ \sin q\end{bmatrix} $$
$$ \dot{\mathbf p}=l\dot q\begin{bmatrix}-\sin q\\ \cos q\end{bmatrix} $$
$$ |\dot{\mathbf p}|^2=l^2\dot q^2 $$
$$ \mathbf p=l\begin{bmatrix}\sin q\\ \cos q\end{bmatrix} $$
";
    assert_eq!(judged(sentences, text), "pppr");
    let swapped = sentences.replace("on x and y", "on y and x");
    assert_eq!(judged(&swapped, text), "rrpp");
    let columns = sentences.replace(" in components on x and y", "")
        + "A column of two entries holds components on x and y.\n";
    let text = r"
$$ \mathbf p=\begin{pmatrix}l\cos q\\ l\sin q\end{pmatrix} $$
$$ \mathbf p=\begin{pmatrix}l\sin q\\ l\cos q\end{pmatrix} $$
";
    assert_eq!(judged(&columns, text), "pr");
}

#[test]
fn a_prime_may_be_what_a_dot_is() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the rod.
x, y, z are the axes of B.
B turns relative to N about z by the angle $\theta$.
O is a point fixed in N and in B.
$I$ is the moment of inertia of the rod about the axis through O along z.
$L$ is the angular momentum of the rod about O relative to N along z.
$M$ is the total moment on the rod about O along z.
A prime means the rate.
";
    let text = r"
$$ L=I\theta' $$
$$ M=I\theta'' $$
$$ M=I\theta' $$
";
    assert_eq!(judged(sentences, text), "ppr");
    let named = sentences.replace(
        "A prime means the rate.",
        "A prime is a part of the name, not a rate.",
    );
    let found = judged(&named, text);
    assert!(!found.contains(['p', 'r']), "{found}");
}

#[test]
fn remarks_on_signs_change_nothing() {
    let remarks = [
        "The sign − is the minus sign.",
        "The sign $-$ means minus.",
        "The sign ∴ means therefore.",
        "The sign $\\therefore$ means therefore and is no part of a formula.",
        "\\bbox only draws a frame around the formula.",
        "A box around a formula only marks it.",
        "The tags 13.104 and 13.106 are the labels of lines 6 and 18.",
        "\\_ is the same as _ (an escape of Markdown).",
        "An underscore with a backslash before it means the plain subscript.",
        "The names cos and sin without a backslash mean the functions $\\cos$ and $\\sin$.",
        "A raised T means the transpose.",
        "$(\\cdot)\\dot{}$ means the rate of the bracket.",
        "\\diff{f}{t} means the derivative of f with respect to t.",
        "\\pdiff{f}{x} means the partial derivative of f with respect to x.",
        "An overbrace or an underbrace with a label only names the term.",
        "The labels under the braces only name the terms.",
    ];
    let sentences = r"
N is an inertial frame.
B turns relative to N about z by the angle $\theta$.
$w$ is the rate of $\theta$.
$a$ is the rate of $w$.
";
    let text = "$$ w=\\dot\\theta $$\n$$ a=\\dot w $$\n$$ w=2\\dot\\theta $$\n";
    for remark in remarks {
        let said = format!("{sentences}{remark}\n");
        assert_eq!(judged(&said, text), "ppr", "{remark}");
    }
}

#[test]
fn remarks_that_would_change_something_are_not_taken_for_others() {
    let sentences = r"
N is an inertial frame.
B turns relative to N about z by the angle $\theta$.
$w$ is the rate of $\theta$.
";
    for said in [
        "The sign − means plus.",
        "The sign $+$ is the minus sign.",
        "\\diff{f}{t} means the integral of f.",
        "An underscore means a power.",
    ] {
        let (found, _) = verdicts(&format!("{sentences}{said}\n"), "$$ w=\\dot\\theta $$\n");
        let proved = found == "p";
        let (_, misread) = verdicts(&format!("{sentences}{said}\n"), "$$ w=\\dot\\theta $$\n");
        assert!(!proved || !misread.is_empty(), "{said}");
    }
}

#[test]
fn a_brace_that_only_names_says_nothing_of_its_term() {
    let sentences = r"
N is an inertial frame.
B turns relative to N about z by the angle $\theta$.
$w$ is the rate of $\theta$.
$a$ is the rate of $w$.
";
    let text = r"$$ w=\underbrace{\dot\theta}_{a} $$";
    assert_ne!(judged(sentences, text), "p");
    let naming = format!("{sentences}An underbrace only names the term.\n");
    assert_eq!(judged(&naming, text), "p");
}

#[test]
fn dots_behind_a_bracket_are_its_rate() {
    let sentences = r"
N is an inertial frame.
B turns relative to N about z by the angle $\theta$.
$w$ is the rate of $\theta$.
$c$ is constant.
";
    let text = r"
$$ (c w)\dot{}=c\ddot\theta $$
$$ (c w)\dot{}=\dot c\dot w $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_letter_with_a_prime_that_means_the_rate_moves() {
    let sentences = r"
N is an inertial frame.
$e$, $s$, $k$ are the axes of A.
A turns relative to N about $k$ by the angle $\psi$.
O is a point fixed in N and in A.
P is a particle of mass $m$.
P is placed from O by $R\sin\theta\,e-R\cos\theta\,k$.
The force $F(\sin\theta\,e-\cos\theta\,k)$ and the force $S s$ are the only loads on P.
A prime means the rate seen from N.
";
    let text = r"
$$ \theta' = 0 $$
$$ S = m R (\psi''\sin\theta + 2\psi'\theta'\cos\theta) $$
$$ S = m R (\psi''\sin\theta + \psi'\theta'\cos\theta) $$
";
    assert_eq!(judged(sentences, text), "rpr");
}

#[test]
fn an_index_of_components_numbers_axes() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
x, y, z are the axes of B.
G is the mass centre of the body.
$I$ is the inertia tensor of the body about G on B.
$I_{ij}$ is entry $(i, j)$ of $I$ on B.
$\omega$ is the angular velocity of B relative to N in components on B.
$\omega_i$ are the components of $\omega$ on B.
$T$ is the kinetic energy of rotation of the body.
A repeated index is summed.
No force and no moment acts on the body.
";
    let text = r"
$$ 2T = I_{ij}\omega_i\omega_j $$
$$ T = I_{ij}\omega_i\omega_j $$
$$ \frac{dT}{dt} = 0 $$
";
    assert_eq!(judged(sentences, text), "prp");
}

#[test]
fn an_axis_with_a_number_is_one_letter_in_a_formula() {
    let sentences = r"
N is an inertial frame.
x, y, z are the axes of N.
A turns relative to N about z by the angle $q$.
a1, a2, z are the axes of A.
O is a point fixed in N and in A.
P is placed from O by $-l a_2$.
$v$ is the velocity of P relative to N.
$w$ is the component of $v$ along a1.
";
    let text = r"
$$ w = l\dot q $$
$$ w = -l\dot q $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_letter_may_be_the_rate() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the wheel.
G is the mass centre of the wheel.
$D$ is the rate.
$D^2$ is the rate of the rate.
The axes of B are principal axes of the wheel.
$A$, $B$, $C$ are the principal moments of the wheel about G on B.
$w$ is the angular velocity of the wheel relative to N.
$p$, $q$, $r$ are the components of $w$ on B.
$T$ is the total moment on the wheel about G.
$L$ is the first component of $T$ on B.
";
    let text = r"
$$ A D p - (B-C) q r = L $$
$$ D^2 (p q) = p D^2 q + 2 Dp Dq + q D^2 p $$
$$ A D p + (B-C) q r = L $$
";
    assert_eq!(judged(sentences, text), "ppr");
    let any = sentences.replace("$D$ is the rate", "$D x$ is the rate of $x$, for any $x$");
    assert_eq!(judged(&any, text), "ppr");
}
