//! Vectors, tensors, frames of components and the product that turns: how each is written, and what it is read as.

use super::outline::{each_reads, latex};

#[test]
fn every_mark_that_makes_a_vector_does() {
    for source in [
        r"\vec{L}_G",
        r"{\vec L}_G",
        r"\vec{L_G}",
        r"\mathbf L_G",
        r"\mathbf{L}_{G}",
        r"{\bf L}_G",
        r"\boldsymbol{L}_G",
        r"\bm L_G",
        r"\overrightarrow{L}_G",
        r"\underline{L}_G",
        r"\overset{\rightarrow}{L}_G",
        r"\vb{L}_G",
        r"\pmb{L}_{\mathrm{G}}",
    ] {
        assert_eq!(latex(source), "vec:L_G", "{source}");
    }
    each_reads(&[
        (r"\overrightarrow{OP}", "vec:OP"),
        (r"\mathbf{r}_{P/O}", "vec:r_P/O"),
        (r"\mathbf{a+b}", "(+ vec:a vec:b)"),
        (r"\bar L", "bar:L"),
        (r"\vec{\omega}'", "vec:omega'"),
        (r"\vec L^{\,G}", "vec:L^G"),
        (r"\mathcal{L}", "cal:L"),
    ]);
}

#[test]
fn unit_vectors_have_hats_arrows_or_bold_letters() {
    each_reads(&[
        (
            r"\vec{\omega} = \omega_x\hat{i} + \omega_y\hat{j} + \omega_z\hat{k}",
            "vec:omega = (+ (* omega_x hat:i) (* omega_y hat:j) (* omega_z hat:k))",
        ),
        (
            r"L_x \vec i + L_y \vec j",
            "(+ (* L_x vec:i) (* L_y vec:j))",
        ),
        (r"L_x\mathbf{e}_x", "(* L_x vec:e_x)"),
        (r"\hat{\mathbf{b}}_1", "vec:hat:b_1"),
        (r"\mathbf{\hat b}_1", "vec:hat:b_1"),
        (r"\hat{\boldsymbol\imath}", "vec:hat:i"),
        (
            r"\hat{\imath}\times\hat{\jmath}=\hat{k}",
            "(* hat:i × hat:j) = hat:k",
        ),
    ]);
}

#[test]
fn components_stand_in_lists_columns_and_rows() {
    each_reads(&[
        (r"(p, q, r)", "(tuple p q r)"),
        (r"\langle p, q, r\rangle", "(tuple p q r)"),
        (r"[p\ q\ r]^T", "(T (tuple p q r))"),
        (r"[\,p\;\;q\;\;r\,]^{\mathsf T}", "(T (tuple p q r))"),
        (
            r"\left(A\omega_1,\ B\omega_2\right)",
            "(tuple (* A omega_1) (* B omega_2))",
        ),
        (
            r"\begin{bmatrix} p\\q\\r\end{bmatrix}",
            "(matrix [p] [q] [r])",
        ),
        (r"\begin{Bmatrix} p \\ q \end{Bmatrix}", "(matrix [p] [q])"),
        (
            r"\left(\begin{array}{c} p \\ q \end{array}\right)",
            "(matrix [p] [q])",
        ),
        (
            r"\left\{\begin{array}{c} p \\ q\end{array}\right\}",
            "(matrix [p] [q])",
        ),
        (
            r"\begin{pmatrix} a & b\end{pmatrix}^T",
            "(T (matrix [a b]))",
        ),
        (
            r"\left[\begin{array}{cc}{I_{x x}} & {-I_{x y}} \\ {-I_{x y}} & {I_{y y}}\end{array}\right]",
            "(matrix [I_xx (- I_xy)] [(- I_xy) I_yy])",
        ),
        (
            r"\begin{smallmatrix} a & b \\ c & d \end{smallmatrix}",
            "(matrix [a b] [c d])",
        ),
    ]);
}

#[test]
fn tensors_are_letters_with_two_marks_or_another_alphabet() {
    for (source, expected) in [
        (r"\underline{\underline{I}}", "vec:tensor:I"),
        (r"\vec{\vec I}", "vec:tensor:I"),
        (r"\overline{\overline I}", "bar:tensor:I"),
        (r"\bar{\bar I}", "bar:tensor:I"),
        (r"\mathbb{I}", "tensor:I"),
        (r"\mathsf{I}", "tensor:I"),
        (r"\overleftrightarrow{I}", "tensor:I"),
        (r"\stackrel{\leftrightarrow}{I}", "tensor:I"),
        (r"[I]", "(square I)"),
        (r"\mathbf I", "vec:I"),
        (r"\mathbf{1}", "bold:1"),
        (r"\mathbf 0", "bold:0"),
        (r"\mathbf{1}_{3\times3}", "(in@3×3 bold:1)"),
    ] {
        assert_eq!(latex(source), expected, "{source}");
    }
}

#[test]
fn moments_keep_their_indices_points_and_primes() {
    each_reads(&[
        (r"I_{xx} + I_x + I_{11} + I_1", "(+ I_xx I_x I_11 I_1)"),
        (r"I_{x x} \omega_{x}", "(* I_xx omega_x)"),
        (r"I_\text{xx}", "I_xx"),
        (r"I_{\mathrm{xx}}", "I_xx"),
        (r"(I_{xy})_G", "(in@G (group I_xy))"),
        (r"I_{xx}^O", "I_xx^O"),
        (r"I^{O}_{xx}", "I_xx^O"),
        (r"I_{xx}^{(G)}", "I_xx^(G)"),
        (r"{}^{B}I_{xx}", "I_xx^B"),
        (r"I_{zz,G}", "I_zz_G"),
        (r"\bar{I}_{xx}", "bar:I_xx"),
        (r"I_{\bar x\bar x}", "I_x\u{304}x\u{304}"),
        (r"I_{x'x'}", "I_x'x'"),
        (r"I_{xx}'", "I'_xx"),
        (r"I_\perp", "I_perp"),
    ]);
}

#[test]
fn the_cross_product_has_many_signs_and_matrices() {
    for source in [
        r"\omega\times L",
        r"\omega \wedge L",
        r"\omega\land L",
        r"\omega\,\boldsymbol{\times}\, L",
        r"\omega \mathbf\times L",
        r"\omega {\times} L",
        r"\omega\mathbin{\times}L",
    ] {
        assert_eq!(latex(source), "(* omega × L)", "{source}");
    }
    for source in [
        r"[\omega]_\times L",
        r"[\omega]_{\times}L",
        r"\left[\omega\right]_\times L",
        r"[\omega]^{\times} L",
        r"\omega^\times L",
        r"[\omega\times]L",
        r"(\omega\times)\,L",
        r"\lfloor\omega\rfloor_\times L",
        r"\lfloor\omega\times\rfloor L",
        r"\mathrm{skew}(\omega) L",
        r"\operatorname{skew}(\omega) L",
    ] {
        assert_eq!(latex(source), "(* (skew omega) L)", "{source}");
    }
    each_reads(&[
        (r"\omega\times I\omega", "(* omega × I omega)"),
        (r"\omega^\times I\omega", "(* (skew omega) I omega)"),
        (r"\tilde{\boldsymbol\omega}", "(skew vec:omega)"),
        (r"\tilde\omega", "tilde:omega"),
        (r"[\omega]", "(square omega)"),
        (r"S(\omega)", "(call S omega)"),
        (
            r"\begin{vmatrix} i & j \\ a & b\end{vmatrix}",
            "(det [i j] [a b])",
        ),
        (
            r"\left|\begin{array}{cc} i & j \\ a & b\end{array}\right|",
            "(det [i j] [a b])",
        ),
        (
            r"\det\begin{bmatrix} a & b \\ c & d\end{bmatrix}",
            "(det [a b] [c d])",
        ),
        (
            r"(\vec\omega\times\vec L)_x",
            "(in@x (group (* vec:omega × vec:L)))",
        ),
    ]);
}
