//! Plain text, in ASCII and in Unicode: the formulas in it, and what they are.

use super::outline::{self, document, each_plain_reads, plain};
use polhode::notation::document::{Format, Item, Row};
use polhode::notation::read;

/// The formulas of a text and where each begins.
fn places(text: &str) -> Vec<(usize, String)> {
    let (document, _) = read("notes.txt", text, Format::Text);
    let formulas = document.items.iter().filter_map(|item| match item {
        Item::Formula(formula) => {
            let (line, _) = document.source.line_column(formula.span.start);
            Some((line, outline::rows(&formula.rows)))
        }
        _ => None,
    });
    formulas.collect()
}

#[test]
fn names_of_programs_are_symbols_with_indices_and_dots() {
    each_plain_reads(&[
        (
            "M_x = I_xx*wdot_x - (I_yy - I_zz)*w_y*w_z",
            "M_x = (+ (* I_xx (dot w_x)) (- (* (group (+ I_yy (- I_zz))) w_y w_z)))",
        ),
        ("2T = Ix ωx²", "(* 2 T) = (* I_x (^ omega_x 2))"),
        (
            "Mz = Izz wzdot - (Ixx - Iyy) wx wy",
            "M_z = (+ (* I_zz (dot w_z)) (- (* (group (+ I_xx (- I_yy))) w_x w_y)))",
        ),
        (
            "hxdot = Ixx*pdot - Ixz*rdot",
            "(dot h_x) = (+ (* I_xx (dot p)) (- (* I_xz (dot r))))",
        ),
        ("I1*w1dot = 0", "(* I_1 (dot w_1)) = 0"),
        ("w_x_dot = 0", "(dot w_x) = 0"),
        ("wx_dot = 0", "(dot w_x) = 0"),
        ("omega_dot_x = 0", "(dot omega_x) = 0"),
        ("omega_x_ddot = 0", "(ddot omega_x) = 0"),
        ("thetaddot = 0", "(ddot theta) = 0"),
        ("L_G = I_G omega", "L_G = (* I_G omega)"),
        ("pq = qr", "(* p q) = (* q r)"),
        ("torque = I alpha", "up:torque = (* I alpha)"),
        ("M_x = 0 => w_x = const", "M_x = 0\nw_x = up:const"),
    ]);
}

#[test]
fn signs_of_programs_and_of_unicode_are_operators() {
    each_plain_reads(&[
        ("T = 0.5*I*w**2", "T = (* 1/2:1 I (^ w 2))"),
        ("f = a^(2n)", "f = (^ a (* 2 n))"),
        ("f = e^(-k t)", "f = (exp (- (* k t)))"),
        (
            "dL/dt = (dL/dt)_body + w x L",
            "(d/dt L) = (+ (d/dt@body L) (* w × L))",
        ),
        (
            "M = I*alpha + w x (I*w)",
            "M = (+ (* I alpha) (* w × (group (* I w))))",
        ),
        (
            "M = cross(w, I w)",
            "M = (group (* (group w) × (group (* I w))))",
        ),
        ("T = 1/2 w.L", "T = (* (/ 1 2) w · L)"),
        ("L = I @ w", "L = (* I w)"),
        ("I_xy = ∫ x y dm", "I_xy = (int (* x y) m)"),
        ("m x y = 0", "(* m x y) = 0"),
        ("I_xx = 2.5e-3 kg m^2", "I_xx = (unit 1/400:1 \"kg m^2\")"),
        ("a ≈ b ≠ c", "a ~ b /= c"),
        ("sinx = cosOmega", "(sin x) = (cos Omega)"),
    ]);
}

#[test]
fn letters_with_marks_and_small_letters_are_those_of_latex() {
    each_plain_reads(&[
        (
            "ω̇ₓ + ½ Iₓₓ ωₓ² = 0",
            "(+ (dot omega_x) (* (/ 1 2) I_xx (^ omega_x 2))) = 0",
        ),
        (
            "ω̇₁ = (I₂ − I₃)/I₁ ω₂ω₃",
            "(dot omega_1) = (* (/ (group (+ I_2 (- I_3))) I_1) omega_2 omega_3)",
        ),
        ("θ̈ + Ω²θ = 0", "(+ (ddot theta) (* (^ Omega 2) theta)) = 0"),
        ("L⃗ = I ω⃗", "vec:L = (* I vec:omega)"),
        ("𝐋 = 𝐈𝝎", "vec:L = (* vec:I vec:omega)"),
        ("q̇ = ½ q ⊗ ω", "(dot q) = (* (/ 1 2) q ⊗ omega)"),
        ("R Rᵀ = 1", "(* R (T R)) = 1"),
        ("ΣM = dL/dt", "sum:M = (d/dt L)"),
        ("ẋ = ẏ", "(dot x) = (dot y)"),
        ("d²θ/dt² = 0", "(d2/dt2 theta) = 0"),
    ]);
}

#[test]
fn sentences_keep_their_words_and_give_their_formulas() {
    let text = "Assume I₁ = I₂ = A.\nSo ω₃ is constant, since ω̇₃ = 0. The energy = ½ I ω².\n\
                The torque is zero => L is constant.\n";
    assert_eq!(
        places(text),
        [
            (1, "I_1 = I_2 = A".to_owned()),
            (2, "omega_3".to_owned()),
            (2, "(dot omega_3) = 0".to_owned()),
            (2, "up:energy = (* (/ 1 2) I (^ omega 2))".to_owned()),
        ]
    );
    let (document, troubles) = read("notes.txt", text, Format::Text);
    assert_eq!(troubles, []);
    let words: String = document
        .items
        .iter()
        .filter_map(|item| match item {
            Item::Prose { text, .. } => Some(text.as_str()),
            _ => None,
        })
        .collect();
    assert_eq!(
        words,
        "Assume . So  is constant, since . The . The torque is zero => L is constant. "
    );
}

#[test]
fn an_entry_of_a_list_of_symbols_may_name_several() {
    let found = places("p, q, r    body rates\nhx hy hz\tangular momentum\nso it is\n");
    let p_q_r = ["p\nq\nr", "(* h_x h_y h_z)"].map(str::to_owned);
    assert_eq!(found, [(1, p_q_r[0].clone()), (2, p_q_r[1].clone())]);
}

#[test]
fn a_formula_may_run_over_lines_and_carry_a_label() {
    let text = "\
  M_x = I_xx*wdot_x
        - (I_yy - I_zz)*w_y*w_z   (4a)
  L = a +
      b
    = c ... (5)
1. T = 0
(a) H = 0
- w_x = 0
";
    assert_eq!(
        places(text),
        [
            (
                1,
                "M_x = (+ (* I_xx (dot w_x)) (- (* (group (+ I_yy (- I_zz))) w_y w_z))) \
                 #(4a)"
                    .to_owned()
            ),
            (3, "L = (+ a b)".to_owned()),
            (5, "= c #(5)".to_owned()),
            (6, "T = 0".to_owned()),
            (7, "H = 0".to_owned()),
            (8, "w_x = 0".to_owned()),
        ]
    );
}

#[test]
fn what_is_only_text_gives_no_formula() {
    for text in [
        "I am a rigid body. A body of mass is at rest, e.g. here - or there.",
        "See section 3 (b) and page 12-14.",
        "It was 5 o'clock; he / she went.",
        "----\n* * *\n",
        "x",
    ] {
        assert_eq!(document(text, Format::Text), "", "{text}");
    }
}

#[test]
fn a_typeset_minus_before_a_number_is_a_sign() {
    assert_eq!(plain("a = −2 b"), plain("a = -2 b"));
    assert_eq!(plain("a = b ×3"), plain("a = b × 3"));
}

#[test]
fn programs_call_products_and_inverses_by_name() {
    assert_eq!(
        plain("T = dot(w, J*w)"),
        "T = (group (* (group w) · (group (* J w))))"
    );
    assert_eq!(plain("a = inv(J)*b"), "a = (* (^ (group J) (- 1)) b)");
}

#[test]
fn a_point_with_space_around_it_is_that_of_a_product() {
    assert_eq!(plain("E = 0.5 w . (I w)"), plain("E = 0.5 w · (I w)"));
    assert_eq!(plain("(w x H) . w = 0"), plain("(w x H) · w = 0"));
    let sentence = document("The sum a + b = c . Then d = e.", Format::Text);
    assert_eq!(
        sentence,
        document("The sum a + b = c. Then d = e.", Format::Text)
    );
}

#[test]
fn a_dot_may_stand_before_the_index_of_a_component() {
    assert_eq!(plain("Ixx*wdotx"), plain("Ixx*wxdot"));
    assert_eq!(plain("omegaddot1"), plain("omega1ddot"));
}

#[test]
fn an_order_in_a_sentence_is_a_formula() {
    let orders = [
        ("Check: A + B > C  (0.015 > 0.013, ok)", "(+ A B) > C"),
        ("For the long body C < A.", "C < A"),
        (
            "It is found from cos(angle) = 2 T / L.",
            "(cos up:angle) = (* 2 (/ T L))",
        ),
    ];
    for (text, formula) in orders {
        assert_eq!(places(text), [(1, formula.to_owned())], "{text}");
    }
    assert!(places("> I think so, and he is not > you").is_empty());
}

#[test]
fn a_list_may_begin_with_the_letter_a() {
    let text = "Notes.\n\n    r = (a, b, s)\n\n    (x, y, z) = (a, b, c) + (u, v, w)\n";
    let (document, _) = read("notes", text, Format::Text);
    let rows = document.items.iter().filter_map(|item| match item {
        Item::Formula(formula) => Some(&formula.rows),
        _ => None,
    });
    let lines = rows.flatten().filter(|row| matches!(row, Row::Line(_)));
    assert_eq!(lines.count(), 2);
}

#[test]
fn stars_around_bold_words_are_no_signs() {
    let lines = |text: &str| {
        places(text)
            .into_iter()
            .map(|(_, line)| line)
            .collect::<Vec<_>>()
    };
    let text = "So **L = I ω**, that is **p = m v.** ∎";
    assert_eq!(lines(text), ["L = (* I omega)", "p = (* m v)"]);
}

#[test]
fn a_line_that_is_one_piece_of_code_is_a_formula_as_a_whole() {
    let text =
        "Then\n\n    `w = b + (x + z sin(lam)) u`\n\nand (see lam) so `a = b` holds (by lam).\n";
    let (document, _) = read("notes.txt", text, Format::Text);
    let formulas = document.items.iter().filter_map(|item| match item {
        Item::Formula(formula) => Some(document.source.slice(formula.span).trim()),
        _ => None,
    });
    let formulas: Vec<&str> = formulas.collect();
    assert_eq!(formulas, ["w = b + (x + z sin(lam)) u", "a = b"]);
}

#[test]
fn stops_of_chinese_end_a_formula_as_others_do() {
    let text = "由（1）：ω̇₁ = −Ω ω₂。\n令 L = I ω，其中 I 为转动惯量。\n  η = ω₁ + i ω₂：\n";
    let found: Vec<String> = places(text).into_iter().map(|(_, row)| row).collect();
    assert_eq!(
        found,
        [
            "(dot omega_1) = (- (* Omega omega_2))",
            "L = (* I omega)",
            "eta = (+ omega_1 (* i omega_2))"
        ]
    );
}
