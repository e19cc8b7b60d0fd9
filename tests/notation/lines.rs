//! What is a line, what goes on from one, and what only stands beside it.

use super::outline::{each_reads, latex};

#[test]
fn environments_and_big_braces_are_lists_of_lines() {
    let two = "a = b\nc = d";
    for source in [
        r"a = b \\ c = d",
        r"a = b \cr c = d",
        r"a = b \qquad c = d",
        r"a = b, \quad c = d",
        r"a = b,\; c = d",
        r"a = b;\ c = d",
        r"a = b \quad\text{and}\quad c = d",
        r"a = b \text{ and } c = d",
        r"\begin{aligned} a &= b \\ c &= d \end{aligned}",
        r"\begin{align} a &= b \\ c &= d \end{align}",
        r"\begin{align*} a ={}& b \\ c ={}& d \end{align*}",
        r"\begin{align} a &= b, & c &= d \end{align}",
        r"\begin{gather} a = b \\ c = d \end{gather}",
        r"\begin{split} a &= b \\ c &= d \end{split}",
        r"\begin{eqnarray} a &=& b \nonumber \\ c &=& d \end{eqnarray}",
        r"\begin{cases} a=b\\ c=d\end{cases}",
        r"\begin{cases} a=b, & c=d \end{cases}",
        r"\left. \begin{aligned} a &= b \\ c &= d \end{aligned} \right\}",
        r"\left\{\begin{array}{l} a=b\\ c=d\end{array}\right.",
        r"\left\{ \begin{array}{rcl} a&=&b\\ c&=&d\end{array}\right.",
        r"\boxed{a = b} \quad \boxed{\;c = d\;}",
        r"\fbox{$a = b$} \\ c = d",
    ] {
        assert_eq!(latex(source), two, "{source}");
    }
}

#[test]
fn a_row_that_begins_with_a_sign_goes_on() {
    each_reads(&[
        (
            r"\begin{align*} a &= b + c \\ &\quad + d \end{align*}",
            "a = (+ b c d)",
        ),
        (
            r"\begin{split} a &= b + {}\\ & c \end{split}",
            "a = (+ b c)",
        ),
        (
            r"\begin{multline} a = b \\ + c \\ - d\end{multline}",
            "a = (+ b c (- d))",
        ),
        (
            r"\begin{eqnarray} a &=& b \\ &=& c\end{eqnarray}",
            "a = b\n= c",
        ),
        (
            r"\begin{eqnarray} d &=& e + f \\ & & + g \end{eqnarray}",
            "d = (+ e f g)",
        ),
        (r"a = b \\ \phantom{a} = c", "a = b\n= c"),
        (r"a = b \\ \phantom{=} + c", "a = (+ b c)"),
        (r"= b", "= b"),
        (r"a = b = c", "a = b = c"),
    ]);
}

#[test]
fn relations_say_what_they_are() {
    each_reads(&[
        (r"a \equiv b", "a := b"),
        (r"a := b", "a := b"),
        (r"a \mathrel{:=} b", "a := b"),
        (r"a \triangleq b", "a := b"),
        (r"a \stackrel{\text{def}}{=} b", "a := b"),
        (r"a \overset{(3)}{=} b", "a = b"),
        (r"a \overset{!}{=} b", "a = b"),
        (r"a \approx b", "a ~ b"),
        (r"a = b \implies c = d", "a = b\nc = d"),
        (r"a = b \rightarrow c = d", "a = b\nc = d"),
        (r"a = b \in \mathbb{R}^{3 \times 3}", "a = b"),
        (r"\Rightarrow a = b", "a = b"),
        (r"\therefore\quad a = b", "a = b"),
        (
            r"I_\perp\omega_\perp = L_\perp",
            "(* I_perp omega_perp) = L_perp",
        ),
    ]);
}

#[test]
fn labels_are_taken_from_where_people_put_them() {
    for source in [
        r"a = b \tag{3}",
        r"a = b \tag*{(3)}",
        r"a = b \quad\text{(3)}",
        r"a = b \qquad (3)",
        r"a = b \hspace{1cm} (3)",
        r"a = b \hfill (3)",
        r"a = b \eqno(3)",
        r"a = b \eqno{(3)}",
        r"a = b \leqno (3)",
        r"a = b \text{--- (3)}",
        r"a = b \quad \ldots (3)",
        r"a = b \cdots (3)",
        r"a = b.\; (3)",
        r"a = b \; (3)",
        r"\boxed{a = b}\tag{3}",
        r"(3)\quad a = b",
        r"\text{(3)}\quad a = b",
    ] {
        assert_eq!(latex(source), "a = b #(3)", "{source}");
    }
    assert_eq!(latex(r"a = b \label{eq:tx}"), "a = b #eq:tx");
    assert_eq!(latex(r"a = b (eq:tx)"), "a = b #(eq:tx)");
}

#[test]
fn decoration_is_passed_over() {
    for source in [
        r"a = b + c.",
        r"a = b + c\,,",
        r"a = b + c \notag",
        r"\displaystyle a = b + c",
        r"a = \underbrace{b}_{\text{Coriolis}} + c",
        r"a = \overbrace{b}^{0} + c",
        r"a = \cancel{b} + c",
        r"a = b + \cancelto{0}{c}",
        r"a = b {\color{red} + c}",
        r"a = b \color{red}{+ c}",
        r"a = \textcolor{red}{b} + c",
        r"a = \textcircled{1} b + c",
        r"a{}={}b+c",
        r"a = b\mathbin{+}c",
    ] {
        assert_eq!(latex(source), "a = (+ b c)", "{source}");
    }
}

#[test]
fn words_names_and_units_are_told_apart() {
    each_reads(&[
        (r"T = \text{const}", "T = up:const"),
        (r"T = \text{ constant}.", "T = up:const"),
        (
            r"\text{KE} = \frac12 I\omega^2",
            "up:KE = (* (/ 1 2) I (^ omega 2))",
        ),
        (
            r"\text{Iyy}\,\dot\omega_y = 0",
            "(* up:Iyy (dot omega_y)) = 0",
        ),
        (r"\text{Torque } M = 0", "M = 0"),
        (r"m = 5\,\text{kg}", "m = (unit 5 \"kg\")"),
        (r"I_\text{xx}", "I_xx"),
        (r"a = b \quad\text{by symmetry}", "a = b \"by symmetry\""),
    ]);
}

#[test]
fn indices_run_over_what_stands_behind_the_line() {
    for source in [
        r"a_i = b_i \qquad (i=1,2,3)",
        r"a_i = b_i,\quad i = 1,2,3",
        r"a_i = b_i \text{ for } i = 1,2,3",
        r"a_i = b_i, \quad i = 1,\ldots,3",
    ] {
        assert_eq!(latex(source), "a_i = b_i {i: 1 2 3}", "{source}");
    }
    assert_eq!(latex(r"a_i = b_i, \ i=x,y,z"), "a_i = b_i {i: x y z}");
}

#[test]
fn values_by_cases_are_refused_and_conditions_are_lines_of_their_own() {
    each_reads(&[
        (
            r"f = \begin{cases} 1 & x>0 \\ 0 & x<0\end{cases}",
            "f = <a value by cases is not read>",
        ),
        (r"a = b \quad (c = 0)", "a = b\nc = 0"),
        (r"a = b \quad (\text{since } c = 0)", "a = b\nc = 0"),
        (r"a = b \quad\text{if}\quad c = d", "a = b\nc = d"),
    ]);
}

#[test]
fn a_full_stop_joins_vectors_and_a_thin_space_keeps_a_prime() {
    each_reads(&[
        (
            r"2T = \mathbf w.(\mathbf J.\mathbf w)",
            "(* 2 T) = (* vec:w · (group (* vec:J · vec:w)))",
        ),
        (
            r"\vec v = \vec r\,' + \vec r\,''",
            "vec:v = (+ vec:r' vec:r'')",
        ),
    ]);
}
