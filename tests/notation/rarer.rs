//! Spellings that are rarer: relative rates, packages for physics, digits in groups, letters of Unicode.

use super::outline::{document, each_plain_reads, each_reads, latex, plain};
use polhode::notation::document::Format;

#[test]
fn a_ring_or_a_marked_d_is_the_rate_on_axes_that_turn() {
    each_reads(&[
        (
            r"\overset{\circ}{\vec L} + \omega\times L",
            "(+ (dot@' vec:L) (* omega × L))",
        ),
        (r"\mathring{L}_x", "(dot@' L_x)"),
        (r"\overset{\circ\circ}{r}", "(ddot@' r)"),
        (r"\frac{d' L}{dt}", "(d/dt@' L)"),
        (r"\frac{d'^2 r}{dt^2}", "(d2/dt2@' r)"),
        (r"\frac{\tilde d L}{dt}", "(d/dt@' L)"),
        (r"\frac{\tilde{d} L}{dt}", "(d/dt@' L)"),
        (r"\frac{\mathring{d} L}{dt}", "(d/dt@' L)"),
        (r"\frac{d^* L}{dt}", "(d/dt@' L)"),
        (r"\frac{d^{*}L}{dt}", "(d/dt@' L)"),
    ]);
    // What is written with small deltas keeps their label until somebody says what it means.
    each_reads(&[(r"\frac{\delta L}{\delta t}", "(d/dt@δ L)")]);
    each_plain_reads(&[("L̊ + ω × L = M", "(+ (dot@' L) (* omega × L)) = M")]);
}

#[test]
fn matrices_by_the_commands_of_plain_tex_are_read() {
    each_reads(&[
        (r"\pmatrix{a & b \\ c & d}", "(matrix [a b] [c d])"),
        (r"\pmatrix{a \cr b}", "(matrix [a] [b])"),
        (r"\pmatrix{a\\ \noalign{\smallskip} b}", "(matrix [a] [b])"),
        (r"\matrix{a & b}", "(matrix [a b])"),
        (r"\begin{pmatrix}a & b\end{pmatrix}", "(matrix [a b])"),
    ]);
}

#[test]
fn a_minus_may_lead_what_a_sum_adds_up() {
    each_reads(&[
        (r"\sum_i -m_i r_i", "(sum i (- (* m_i r_i)))"),
        (r"(J a)\dot{}", "(dot (group (* J a)))"),
        (r"a\ddot{}", "(ddot a)"),
    ]);
}

#[test]
fn the_commands_of_the_package_physics_are_read() {
    each_reads(&[
        (r"\mqty{a & b \\ c & d}", "(matrix [a b] [c d])"),
        (r"\mqty(a & b \\ c & d)x", "(* (matrix [a b] [c d]) x)"),
        (r"\mqty[a & b \\ c & d]", "(matrix [a b] [c d])"),
        (r"\bmqty{a \\ b}", "(matrix [a] [b])"),
        (r"\pmqty{a & b}", "(matrix [a b])"),
        (r"\mqty|a & b \\ c & d|", "(det [a b] [c d])"),
        (r"\vmqty{a & b \\ c & d}", "(det [a b] [c d])"),
        (r"I = \mqty(\dmat{a,b,c})", "I = (diag (tuple a b c))"),
        (
            r"\vb{a} \vdot \vb*{b} = \va{a}\cross\vu{b}",
            "(* vec:a · vec:b) = (* vec:a × hat:b)",
        ),
        (r"\dv*{L}{t}", "(d/dt L)"),
        (
            r"\cos[2](x) + \sin[2]{x} = 1",
            "(+ (^ (cos x) 2) (^ (sin x) 2)) = 1",
        ),
        (r"\pdv{f}{x}{y}", "(partial f x y)"),
        (r"\int_0^t M \dd{t}", "(int M t 0 t)"),
        (r"\frac{\dd L}{\dd t}", "(d/dt L)"),
        (r"\frac{\dd[2]{x}}{\dd{t}^2}", "(d2/dt2 x)"),
        (
            r"\frac{\mathop{}\!\mathrm{d} L}{\mathop{}\!\mathrm{d} t}",
            "(d/dt L)",
        ),
    ]);
}

#[test]
fn digits_in_groups_are_one_number() {
    each_reads(&[
        (r"1\,000", "1000"),
        (r"12\,000\,\text{N}", "(unit 12000 \"N\")"),
        (r"12\,000.5", "24001/2:1"),
        (r"1~000", "1000"),
        (r"1{,}000{,}000", "1000000"),
        (r"1{,}234.5", "2469/2:1"),
        (r"3{,}5", "7/2:1"),
        (r"0{,}125", "1/8:3"),
        (r"\frac 1 2 a", "(* (/ 1 2) a)"),
        (r"I_{1{,}2}", "I_1,2"),
        (r"a = 3, 5", "a = 3\n5"),
        (r"\omega_i = 0, i = 1,2", "omega_i = 0 {i: 1 2}"),
        (r"(3,5)", "(tuple 3 5)"),
    ]);
    each_plain_reads(&[("x = 5 000", "x = 5000")]);
}

#[test]
fn digits_that_may_be_two_things_are_not_guessed() {
    for source in [r"x = 1{,}000", "x = 1,000", "x = 3,5", "x = 1 0"] {
        assert!(latex(source).contains('<'), "{source}: {}", latex(source));
    }
    for source in ["x = 1,000", "x = 3,5", "x = 1.000,5", "I = [1 0 0]"] {
        assert!(plain(source).contains('<'), "{source}: {}", plain(source));
    }
    assert!(latex("x^-1").contains('<'));
    each_plain_reads(&[("x^-1 = x**-2", "(^ x (- 1)) = (^ x (- 2))")]);
}

#[test]
fn roots_have_a_degree() {
    each_reads(&[
        (r"\sqrt[3]{x}", "(^ x (/ 1 3))"),
        (r"\sqrt[3]{a+b}", "(^ (group (+ a b)) (/ 1 3))"),
        (r"\sqrt[2]{x}", "(sqrt x)"),
        (r"\nicefrac12 + \sfrac{1}{2}", "(+ (/ 1 2) (/ 1 2))"),
        (r"\vcenter{b}", "b"),
    ]);
    assert!(latex(r"\sqrt[n]{x}").contains("whole number"));
    each_plain_reads(&[("∛x = 2", "(^ x (/ 1 3)) = 2")]);
}

#[test]
fn alphabets_and_signs_of_unicode_are_those_of_latex() {
    each_plain_reads(&[
        ("𝝎 × 𝑳 = 𝐌", "(* vec:omega × vec:L) = vec:M"),
        ("ℒ = 𝓛", "cal:L = cal:L"),
        ("L″ = ℎ", "L'' = h"),
        ("a ⨉ b = 0", "(* a × b) = 0"),
        ("a ⊥ b", "a ? b"),
        ("ⅆL/ⅆt = M", "(d/dt L) = M"),
    ]);
}

#[test]
fn digits_behind_a_letter_of_plain_text_are_its_index() {
    each_plain_reads(&[
        ("ω1**2 = ω_1²", "(^ omega_1 2) = (^ omega_1 2)"),
        ("m1 v1² = 3 x2", "(* m_1 (^ v_1 2)) = (* 3 x_2)"),
        ("d2θ/dt2 = 2x", "(d2/dt2 theta) = (* 2 x)"),
    ]);
}

#[test]
fn comments_of_obsidian_hide_what_they_hold() {
    let text = "Text %% hidden $a = b$ %% and $c = d$, 5 %% more.";
    assert_eq!(document(text, Format::Markdown), "c = d");
    let text = "Is $a = b$ at 5%% or $c = d$?";
    assert_eq!(document(text, Format::Markdown), "a = b\nc = d");
}

#[test]
fn formulas_stand_in_lists_quotations_and_tables() {
    let text = "- item \\(a = b\\)\n- second \\[c = d\\]\n\n> quote \\(e = f\\)\n\n\
                | x | y |\n|---|---|\n| \\(g = h\\) | $i = j$ |\n";
    assert_eq!(
        document(text, Format::Markdown),
        "a = b\nc = d\ne = f\ng = h\ni = j"
    );
}

#[test]
fn commands_of_packages_are_read_or_passed_over() {
    each_reads(&[
        (r"\qty[a + b]c", "(* (square (+ a b)) c)"),
        (r"\qty\big(a + b)", "(group (+ a b))"),
        (r"\qty{3}{kg}", "(unit 3 \"kg\")"),
        (r"\smash[b]{c} + \kern-2pt d\mkern 3mu", "(+ c d)"),
        (r"a \hskip 1em b", "a\nb"),
        (r"\bbox[5px,border:2px solid red]{a = b}", "a = b"),
        (r"a \overset{\eqref{eq:1}}{=} b", "a = b"),
        (r"\frac{d^{\mathcal{B}}L}{dt}", "(d/dt@B L)"),
        (r"\frac{d^2 L}{dt^2}", "(d2/dt2 L)"),
        (r"\tg x + \cosec x + \Tr A", "(+ (tan x) (csc x) (trace A))"),
    ]);
    for unread in [
        r"\grad f",
        r"\curl{\vec v}",
        r"\sum_{\substack{i = 1 \\ j = 2}} m",
    ] {
        assert!(latex(unread).contains("not read"), "{unread}");
    }
}

#[test]
fn scripts_on_an_empty_base_belong_to_what_stands_beside_them() {
    each_reads(&[
        // What follows takes them, and if nothing does, what stands before.
        (r"{^N}v^{C} = {}^N v^C", "v^N^C = v^N^C"),
        (r"m {^N}v", "(* m v^N)"),
        (r"\omega{_1}\omega{_2}^2", "(* omega_1 (^ omega_2 2))"),
        (r"x{^2}", "(^ x 2)"),
        (r"x_k{}^2 - 1", "(+ (^ x_k 2) (- 1))"),
        (r"y = x{}^2", "y = (^ x 2)"),
        (r"{A{^{^\top}_{B}}} r", "(* (T A_B) r)"),
        (r"\omega^{\prime 2}", "(^ omega' 2)"),
    ]);
    // Both might be meant.
    assert!(latex(r"m{^N}v").contains('<'));
}

#[test]
fn the_box_at_the_end_of_a_proof_is_no_part_of_it() {
    each_reads(&[
        (r"a = b \quad\blacksquare", "a = b"),
        (r"a = b. \qed", "a = b"),
        (r"a = b \square", "a = b"),
        // Before an operand it is a letter.
        (r"a = \square b", "a = (* square b)"),
    ]);
    each_plain_reads(&[("a = b. ∎", "a = b"), ("a = b ∎₁", "a = b")]);
}

#[test]
fn half_an_environment_may_be_a_macro() {
    let text = r"\def\mopen{\left(\begin{matrix}} \def\mclose{\end{matrix}\right)}
\[ \mopen a \\ b \mclose = \mopen c \\ d \mclose \]";
    assert_eq!(
        document(text, Format::Latex),
        "(matrix [a] [b]) = (matrix [c] [d])"
    );
}

#[test]
fn signs_of_web_pages_are_those_that_they_name() {
    each_reads(&[
        (r"a &#8211; b &lt; c", "(+ a (- b)) < c"),
        (
            r"\begin{matrix} a \\ &minus; b \end{matrix}",
            "(matrix [a] [(- b)])",
        ),
        (
            r"\begin{matrix} a & x; \\ b & c \end{matrix}",
            "(matrix [a x] [b c])",
        ),
    ]);
}

#[test]
fn an_equals_sign_on_both_sides_of_a_row_break_is_one() {
    each_reads(&[(r"\begin{align} a =& b =\\ =& c \end{align}", "a = b\n= c")]);
}

#[test]
fn a_macro_may_stand_for_a_command_that_asks_for_an_argument() {
    let text = r"\newcommand{\bs}{\boldsymbol}\newcommand{\vc}{\bs}\newcommand{\om}{\omega}
\[ \bs{L} = J\bs\om \] \[ \vc{L} = \vc r \times \vc{p} \]";
    assert_eq!(
        document(text, Format::Latex),
        "vec:L = (* J vec:omega)\nvec:L = (* vec:r × vec:p)"
    );
}

#[test]
fn cases_with_numbers_are_displays() {
    let text = r"\begin{subnumcases}{} a = b \label{x} \\ c = d \end{subnumcases}";
    assert_eq!(document(text, Format::Latex), "a = b #x\nc = d");
}

#[test]
fn the_mass_of_an_element_is_no_function() {
    each_reads(&[
        (r"\mathrm{d}m (a + b)", "(* up:d m (group (+ a b)))"),
        (r"m (a + b)", "(call m (+ a b))"),
    ]);
}
