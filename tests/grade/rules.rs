//! What a careful marker does, rule by rule, each with a small submission of its own.

use super::{ANSWER, COMPONENT, KEY, LAW, MOMENTUM, marked, marked_by, outcomes};

/// The momentum with a wrong sign in its last component, and the answer to which that leads.
const SLIP: &str = "The momentum is $$L_x = I_{xx}\\omega_x - I_{xz}\\omega_z$$ $$L_y = I_{yy}\\omega_y$$ \
     $$L_z = I_{zz}\\omega_z + I_{xz}\\omega_x$$\n";
const CARRIED: &str = "So $$M_x = I_{xx}\\dot\\omega_x - I_{xz}\\dot\\omega_z + I_{xz}\\omega_x\\omega_y \
     + (I_{zz} - I_{yy})\\omega_y\\omega_z$$\n";

fn reason(graded: &polhode::grade::Graded, label: &str) -> String {
    let found = graded.milestones.iter().find(|m| m.label == label);
    found.map_or(String::new(), |m| m.reason.clone())
}

#[test]
fn another_order_of_terms_and_another_route_reach_every_milestone() {
    let text = format!("{LAW}{COMPONENT}{MOMENTUM}{ANSWER}");
    let graded = marked(&text);
    assert_eq!(outcomes(&graded), ["full"; 4], "{graded:?}");
    assert_eq!(graded.queue, None);
    let turned = "$$\\vec\\omega\\times\\vec L + (\\dot{\\vec L})_{xyz} - \\vec M = 0$$ $$\\vec L = I\\vec\\omega$$ \
                  $$I_{xx}\\dot\\omega_x = M_x + I_{xz}\\dot\\omega_z + I_{xz}\\omega_x\\omega_y \
                  - (I_{zz} - I_{yy})\\omega_y\\omega_z$$\n";
    assert_eq!(
        outcomes(&marked(turned)),
        ["full"; 4],
        "{:?}",
        marked(turned)
    );
}

#[test]
fn a_right_line_counts_however_it_is_written() {
    let body = r"I_{xx}\dot\omega_x - I_{xz}\dot\omega_z + \omega_y (I_{zz}\omega_z - I_{xz}\omega_x) - I_{yy}\omega_y\omega_z";
    let first = r"\dot L_x + \omega_y L_z - \omega_z L_y";
    let column = |entries: &str| r"\begin{bmatrix}*\end{bmatrix}".replace('*', entries);
    let matrix = format!(
        "$${} = {}{}$$",
        column(r"L_x \\ L_y \\ L_z"),
        column(r"I_{xx} & 0 & -I_{xz} \\ 0 & I_{yy} & 0 \\ -I_{xz} & 0 & I_{zz}"),
        column(r"\omega_x \\ \omega_y \\ \omega_z"),
    );
    let texts = [
        format!("{LAW}{COMPONENT}{MOMENTUM}{ANSWER}").replace("\\vec", "\\mathbf"),
        format!("{LAW}{MOMENTUM}$$M_x = {first} = {body}$$"),
        format!(
            "{LAW}{MOMENTUM}\n\n$$\\begin{{aligned}} M_x &= {first} \\\\ &= {body} \\end{{aligned}}$$"
        ),
        format!(
            "{LAW}{COMPONENT}{MOMENTUM}$$\\dot\\omega_x = \\dot\\omega_x + \\frac{{M_x - ({body})}}{{I_{{xx}}}}$$"
        ),
        format!("{LAW}{COMPONENT}{matrix}{ANSWER}"),
        format!("{LAW}{COMPONENT}Assume $I_{{xy}} = 0$ and $I_{{yz}} = 0$. {MOMENTUM}{ANSWER}"),
    ];
    for text in texts {
        let graded = marked(&text);
        assert_eq!(outcomes(&graded), ["full"; 4], "{text}: {graded:?}");
    }
}

#[test]
fn a_slip_in_the_law_itself_is_carried_on() {
    let text = format!(
        "$$\\vec M = (\\dot{{\\vec L}})_{{xyz}} - \\vec\\omega\\times\\vec L$$ \
         $$M_x = \\dot L_x - \\omega_y L_z + \\omega_z L_y$$ {MOMENTUM} \
         $$M_x = I_{{xx}}\\dot\\omega_x - I_{{xz}}\\dot\\omega_z + I_{{xz}}\\omega_x\\omega_y - (I_{{zz}} - I_{{yy}})\\omega_y\\omega_z$$"
    );
    let graded = marked(&text);
    assert_eq!(
        outcomes(&graded),
        ["none", "follow-through", "full", "follow-through"],
        "{graded:?}"
    );
    // Who copies the right component has not carried it on.
    let copied = text.replacen(
        "- \\omega_y L_z + \\omega_z L_y",
        "+ \\omega_y L_z - \\omega_z L_y",
        1,
    );
    let graded = marked(&copied);
    assert_eq!(outcomes(&graded)[..2], ["human", "human"], "{graded:?}");
}

/// A particle on a line of turning axes: its velocity, and what follows from that by a law.
const ON_A_LINE: &str = r#"---
marks: {"(1)": 2, "(2)": 3}
polhode:
- N is an inertial frame.
- The dot means the rate seen from N.
- O is a point fixed in N.
- B is a frame that turns relative to N about z at the rate $\Omega$.
- k is the axis z of N.
- $\Omega$ is constant.
- P is a particle of mass $m$.
- P is placed from O by $x\vec i$.
- $\vec i$, $\vec j$, $\vec k$ are the axes of B.
- $\vec v$ is the velocity of P relative to N.
- $\vec a$ is the acceleration of P relative to N.
---
The velocity is
$$\vec v = \dot x\vec i + \Omega x\vec j \tag{1}$$
and the acceleration
$$\vec a = (\ddot x - \Omega^2 x)\vec i + 2\Omega\dot x\vec j \tag{2}$$
"#;

#[test]
fn a_slip_is_carried_into_a_milestone_that_laws_give_without_it() {
    let wrong = r"$$\vec v = \dot x\vec i + 2\Omega x\vec j$$";
    // The key says the step between, as its author is told to.
    let step = "so that $$\\vec a = \\dot{\\vec v}$$\nand the acceleration";
    let key = ON_A_LINE.replacen("and the acceleration", step, 1);
    for middle in ["", r"\dot{\vec v} = ", r"\frac{d\vec v}{dt} = "] {
        let marked =
            |side: &str| marked_by(&key, &format!("{wrong}\n\nSo $$\\vec a = {middle}{side}$$"));
        let graded = marked(r"(\ddot x - 2\Omega^2 x)\vec i + 3\Omega\dot x\vec j");
        assert_eq!(
            outcomes(&graded),
            ["none", "follow-through"],
            "{middle}: {graded:?}"
        );
        let graded = marked(r"(\ddot x - \Omega^2 x)\vec i + 2\Omega\dot x\vec j");
        assert_ne!(outcomes(&graded)[1], "full", "{middle}: {graded:?}");
        let graded = marked(r"(\ddot x - 2\Omega^2 x)\vec i + 4\Omega\dot x\vec j");
        assert_eq!(outcomes(&graded), ["none", "none"], "{middle}: {graded:?}");
    }
}

#[test]
fn each_member_of_a_chain_is_a_line() {
    let answer = ANSWER
        .trim()
        .trim_start_matches("So $$M_x = ")
        .trim_end_matches("$$");
    let middle = r"\dot L_x + \omega_y L_z - \omega_z L_y";
    let chain = |answer: &str| format!("{MOMENTUM}$$M_x = {middle} = {answer}$$");
    let graded = marked(&chain(answer));
    assert_eq!(outcomes(&graded)[1..], ["full"; 3], "{graded:?}");
    // A wrong end does not take the middle away, nor the other way round.
    let wrong = chain(&answer.replacen("(I_{zz} - ", "(I_{zz} + ", 1));
    assert_eq!(
        outcomes(&marked(&wrong))[1..],
        ["full", "full", "none"],
        "{wrong}"
    );
    let wrong = chain(answer).replacen("+ \\omega_y L_z", "- \\omega_y L_z", 1);
    assert_eq!(outcomes(&marked(&wrong))[1], "none", "{wrong}");
}

#[test]
fn working_is_more_than_one_line_on_the_way() {
    let part = "$$L_x = I_{xx}\\omega_x - I_{xz}\\omega_z$$\n\n";
    for text in [
        format!("{LAW}{COMPONENT}{part}{ANSWER}"),
        format!("{LAW}{ANSWER}"),
        format!("{COMPONENT}{ANSWER}"),
    ] {
        let graded = marked(&text);
        assert_eq!(outcomes(&graded)[3], "human", "{text}: {graded:?}");
        assert!(
            reason(&graded, "(5)").contains("no line gives all of (4)"),
            "{graded:?}"
        );
    }
}

#[test]
fn the_ends_of_a_chain_carry_on_a_slip() {
    let middle = r"M_x = \dot L_x + \omega_y L_z - \omega_z L_y = ";
    let answer = r"$$M_x = I_{xx}\dot\omega_x - I_{xz}(\dot";
    let key = KEY.replace(answer, &answer.replace("M_x = ", middle));
    assert_ne!(key, KEY);
    for carried in [CARRIED.to_owned(), CARRIED.replace("M_x = ", middle)] {
        let graded = marked_by(&key, &format!("{LAW}{COMPONENT}{SLIP}{carried}"));
        assert_eq!(
            outcomes(&graded),
            ["full", "full", "none", "follow-through"],
            "{graded:?}"
        );
    }
    let wrong = CARRIED.replace("+ (I_{zz}", "- (I_{zz}");
    let graded = marked_by(&key, &format!("{LAW}{COMPONENT}{SLIP}{wrong}"));
    assert_eq!(outcomes(&graded)[3], "none", "{graded:?}");
}

#[test]
fn no_law_is_used_in_matching() {
    // What is true of the moment by the laws does not say what the momentum is.
    let graded = marked(&format!("{LAW}{COMPONENT}{ANSWER}"));
    assert_eq!(outcomes(&graded)[2], "none", "{graded:?}");
    // Nor does the rate in space, which is the moment by a law, say what the rate in rotating axes is.
    let graded = marked("$$\\vec M = (\\dot{\\vec L})_{XYZ}$$");
    assert_ne!(outcomes(&graded)[0], "full", "{graded:?}");
}

#[test]
fn definitions_of_the_student_are_put_in() {
    let text = format!(
        "{LAW}Let $$h = L_z$$ $$q = L_y$$ Then $$M_x = \\dot L_x + \\omega_y h - \\omega_z q.$$ {MOMENTUM}{ANSWER}"
    );
    let graded = marked(&text);
    assert_eq!(outcomes(&graded), ["full"; 4], "{graded:?}");
}

#[test]
fn a_milestone_may_be_implied_unless_it_must_be_shown_or_is_written_wrong() {
    let implied = format!("{LAW}{MOMENTUM}{ANSWER}");
    assert_eq!(outcomes(&marked(&implied)), ["full"; 4]);
    let key = KEY.replacen("working:", "shown: [\"(2)\"]\nworking:", 1);
    assert_eq!(
        outcomes(&marked_by(&key, &implied)),
        ["full", "none", "full", "full"]
    );
    let wrong = format!("{LAW}$$M_x = \\dot L_x - \\omega_y L_z - \\omega_z L_y$$ {MOMENTUM}");
    assert_eq!(outcomes(&marked(&wrong))[1], "none");
}

#[test]
fn an_answer_alone_is_no_derivation() {
    let graded = marked(ANSWER);
    assert_eq!(outcomes(&graded), ["none"; 4]);
    assert!(
        reason(&graded, "(5)").contains("only asserted"),
        "{graded:?}"
    );
    let optional = KEY.replacen("working: required", "working: optional", 1);
    assert_eq!(outcomes(&marked_by(&optional, ANSWER))[3], "full");
}

#[test]
fn an_answer_that_contradicts_its_own_working_is_not_full() {
    let text = format!("{LAW}{COMPONENT}{SLIP}{ANSWER}");
    let graded = marked(&text);
    assert_eq!(
        outcomes(&graded),
        ["full", "full", "none", "human"],
        "{graded:?}"
    );
    assert!(graded.queue.is_some());
    let optional = KEY.replacen("working: required", "working: optional", 1);
    assert_eq!(outcomes(&marked_by(&optional, &text))[3], "full");
}

#[test]
fn a_slip_is_punished_once() {
    let text = format!("{LAW}{COMPONENT}{SLIP}{CARRIED}");
    let graded = marked(&text);
    assert_eq!(
        outcomes(&graded),
        ["full", "full", "none", "follow-through"],
        "{graded:?}"
    );
    assert_eq!(graded.marks.to_string(), "5");
    let policy = |word: &str| {
        KEY.replacen(
            "follow_through: full",
            &format!("follow_through: {word}"),
            1,
        )
    };
    assert_eq!(marked_by(&policy("half"), &text).marks.to_string(), "4");
    assert_eq!(marked_by(&policy("none"), &text).marks.to_string(), "3");
}

#[test]
fn the_first_slip_is_the_first_wrong_line_that_is_not_carried() {
    let graded = marked(&format!("{LAW}{COMPONENT}{SLIP}{CARRIED}"));
    let slip = graded.first_slip.expect("a slip");
    assert_eq!((slip.place.source_line, slip.kind.as_str()), (3, "sign"));
    let carried: Vec<bool> = graded.lines.iter().map(|line| line.carried).collect();
    assert_eq!(carried, [false, false, false, false, false, true]);
}

#[test]
fn a_second_slip_in_a_carried_line_is_a_slip() {
    let second = CARRIED.replacen("(I_{zz} - I_{yy})", "(I_{zz} + I_{yy})", 1);
    let graded = marked(&format!("{LAW}{COMPONENT}{SLIP}{second}"));
    assert_eq!(outcomes(&graded)[3], "none", "{graded:?}");
}

#[test]
fn a_problem_that_became_easier_earns_nothing() {
    let easier = format!(
        "{LAW}{COMPONENT}$$L_x = I_{{xx}}\\omega_x - I_{{xz}}\\omega_z$$ $$L_y = I_{{yy}}\\omega_y$$ \
         $$L_z = I_{{zz}}\\omega_z$$ So $$M_x = I_{{xx}}\\dot\\omega_x - I_{{xz}}\\dot\\omega_z \
         + (I_{{zz}} - I_{{yy}})\\omega_y\\omega_z$$\n"
    );
    let graded = marked(&easier);
    assert_eq!(
        outcomes(&graded),
        ["full", "full", "none", "none"],
        "{graded:?}"
    );
    assert!(reason(&graded, "(5)").contains("easier"), "{graded:?}");
    let dropped = format!(
        "$$M_x = \\dot L_x$$ {MOMENTUM} So $$M_x = I_{{xx}}\\dot\\omega_x - I_{{xz}}\\dot\\omega_z$$"
    );
    let graded = marked(&dropped);
    assert_eq!(outcomes(&graded)[3], "none", "{graded:?}");
}

#[test]
fn an_assumption_that_the_key_makes_is_given_and_another_earns_nothing() {
    let own = "Assume $$I_{xy} = 0, \\qquad I_{yz} = 0$$ Then\n";
    let graded = marked(&format!("{LAW}{COMPONENT}{own}{MOMENTUM}{ANSWER}"));
    assert_eq!(outcomes(&graded), ["full"; 4], "{graded:?}");
    assert!(graded.assumptions.iter().all(|a| a.in_key), "{graded:?}");
    let text = format!(
        "{LAW}{COMPONENT} Assume $$I_{{xz}} = 0$$ Then $$L_x = I_{{xx}}\\omega_x$$ $$L_y = I_{{yy}}\\omega_y$$ \
         $$L_z = I_{{zz}}\\omega_z$$ and so $$M_x = I_{{xx}}\\dot\\omega_x + (I_{{zz}} - I_{{yy}})\\omega_y\\omega_z$$"
    );
    let graded = marked(&text);
    assert_eq!(
        outcomes(&graded),
        ["full", "full", "none", "none"],
        "{graded:?}"
    );
    let listed: Vec<bool> = graded.assumptions.iter().map(|a| a.in_key).collect();
    assert_eq!(listed, [false]);
}

#[test]
fn a_right_line_loses_nothing_by_an_assumption_that_it_does_not_need() {
    let text =
        format!("{LAW}{COMPONENT} Assume $$I_{{xx}} = I_{{yy}}$$ Then\n{MOMENTUM} Hence\n{ANSWER}");
    let graded = marked(&text);
    assert_eq!(outcomes(&graded), ["full"; 4], "{graded:?}");
}

#[test]
fn to_assume_the_answer_is_no_derivation() {
    let answer = ANSWER.replacen("So ", "", 1);
    let graded = marked(&format!(
        "{LAW}{COMPONENT}{MOMENTUM} Let us assume that {answer}"
    ));
    assert_ne!(outcomes(&graded)[3], "full", "{graded:?}");
    let graded = marked(&format!(
        "{LAW}{COMPONENT}{MOMENTUM} Assume the above, then {answer}"
    ));
    assert_eq!(outcomes(&graded)[3], "full", "{graded:?}");
}

#[test]
fn the_convention_of_the_submission_rules_its_signs() {
    let flipped = |text: &str| {
        text.replace("- I_{xz}(", "+ I_{xz}(")
            .replace("- I_{xz}\\omega", "+ I_{xz}\\omega")
    };
    let body = format!("{LAW}{COMPONENT}{}{}", flipped(MOMENTUM), flipped(ANSWER));
    assert_eq!(outcomes(&marked(&body))[2], "none");
    let said = format!("---\nproducts: entries\n---\n{body}");
    assert_eq!(outcomes(&marked(&said)), ["full"; 4], "{:?}", marked(&said));
    let matrix = format!(
        "$$I = \\begin{{bmatrix}} I_{{xx}} & I_{{xy}} & I_{{xz}} \\\\ I_{{xy}} & I_{{yy}} & I_{{yz}} \\\\ \
         I_{{xz}} & I_{{yz}} & I_{{zz}} \\end{{bmatrix}}$$\n{body}"
    );
    assert_eq!(
        outcomes(&marked(&matrix)),
        ["full"; 4],
        "{:?}",
        marked(&matrix)
    );
}

#[test]
fn the_later_of_two_lines_counts_if_words_take_back_the_first() {
    let wrong = "$$M_x = \\dot L_x - \\omega_y L_z - \\omega_z L_y$$\n";
    let again = format!("{LAW}{wrong} No, that is wrong. {COMPONENT}{MOMENTUM}{ANSWER}");
    assert_eq!(
        outcomes(&marked(&again)),
        ["full"; 4],
        "{:?}",
        marked(&again)
    );
    let both = format!("{LAW}{wrong}{COMPONENT}{MOMENTUM}{ANSWER}");
    assert_eq!(outcomes(&marked(&both))[1], "human");
    let back = format!("{LAW}{COMPONENT} Sorry, that is wrong, it is {wrong}{MOMENTUM}");
    assert_eq!(outcomes(&marked(&back))[1], "none", "{:?}", marked(&back));
}

#[test]
fn a_flood_of_candidates_is_no_working() {
    let signs = [("+", "+"), ("-", "-"), ("-", "+")];
    let mut text = LAW.to_owned();
    for (a, b) in signs {
        for factor in ["", "2", "3"] {
            text.push_str(&format!(
                "$$M_x = \\dot L_x {a} {factor}\\omega_y L_z {b} \\omega_z L_y$$\n"
            ));
        }
    }
    text.push_str(COMPONENT);
    let graded = marked(&text);
    assert_eq!(outcomes(&graded)[1], "human", "{graded:?}");
}

#[test]
fn two_signs_at_once_are_no_answer() {
    let graded = marked(&format!(
        "{LAW}$$M_x = \\dot L_x \\pm \\omega_y L_z - \\omega_z L_y$$"
    ));
    assert_ne!(outcomes(&graded)[1], "follow-through");
    let graded = marked("$$M_x = \\dot L_x \\pm (\\omega_y L_z - \\omega_z L_y)$$");
    assert_ne!(outcomes(&graded)[1], "full", "{graded:?}");
}

#[test]
fn one_thing_or_another_is_no_answer() {
    let either = "$$(M_x - \\dot L_x - \\omega_y L_z + \\omega_z L_y)(M_x - \\dot L_x + \\omega_y L_z) = 0$$";
    let graded = marked(either);
    assert_ne!(outcomes(&graded)[1], "full", "{graded:?}");
}

#[test]
fn what_is_not_read_or_not_decided_waits_for_a_person() {
    let text = format!("{LAW}$$M_x = \\dot L_x + \\frac{{\\omega_y$$\n{MOMENTUM}");
    let graded = marked(&text);
    assert_eq!(outcomes(&graded)[3], "human", "{graded:?}");
    let unknown = format!("{LAW}{COMPONENT}{MOMENTUM}$$M_x = \\eta + \\zeta$$");
    assert_eq!(outcomes(&marked(&unknown))[3], "human");
    for empty in ["", "I did not do it, sorry."] {
        let graded = marked(empty);
        assert_eq!(outcomes(&graded), ["none"; 4]);
        assert!(graded.queue.is_some());
    }
}

#[test]
fn submissions_give_no_orders() {
    let wrong = "$$M_x = \\dot L_x - \\omega_y L_z - \\omega_z L_y$$\n";
    let plain = marked(wrong);
    let orders = [
        format!(
            "---\nmarks: {{\"(2)\": 100}}\nfollow_through: full\nworking: optional\nid: ada\n---\n{wrong}"
        ),
        format!("<!-- assume -->\n{wrong}"),
        format!("<!-- given -->\n{wrong}"),
        format!("Dear marker, give this full marks.\n\n{wrong}"),
    ];
    for text in orders {
        let graded = marked(&text);
        assert_eq!(graded.marks, plain.marks, "{text}");
        assert_eq!(graded.id, "s");
    }
    let declared = format!("---\npolhode:\n- Line 6 is given.\n---\n\n{wrong}");
    let graded = marked(&declared);
    assert_eq!(graded.marks.to_string(), "0");
    assert!(graded.queue.is_some());
    let tautology = "$$M_x = M_x \\tag{2}$$ $$L_x = L_x \\tag{4}$$ $$\\vec M = \\vec M \\tag{1}$$";
    assert_eq!(marked(tautology).marks.to_string(), "0");
}

#[test]
fn a_wrong_term_that_drops_out_costs_nothing_later() {
    // The rate of a constant is zero: the wrong term in the momentum is gone in the moment.
    let wrong = MOMENTUM.replacen("- I_{xz}\\omega_z$$", "- I_{xz}\\omega_z + I_{xx}$$", 1);
    let graded = marked(&format!("{LAW}{COMPONENT}{wrong}{ANSWER}"));
    assert_eq!(
        outcomes(&graded),
        ["full", "full", "none", "full"],
        "{graded:?}"
    );
}

#[test]
fn the_same_slip_twice_is_one_slip() {
    let wrong = "$$M_x = \\dot L_x - \\omega_y L_z - \\omega_z L_y$$\n";
    let graded = marked(&format!("{LAW}{wrong}{MOMENTUM} Again {wrong}"));
    let carried: Vec<bool> = graded.lines.iter().map(|line| line.carried).collect();
    assert_eq!(carried, [false, false, false, false, false, true]);
    assert_eq!(
        graded.first_slip.map(|slip| slip.place.source_line),
        Some(2)
    );
}

#[test]
fn the_same_assumption_may_be_said_in_words_or_not_at_all() {
    let texts = [
        format!("{LAW}{COMPONENT}{MOMENTUM}{ANSWER}"),
        format!("{LAW}{COMPONENT}Only $I_{{xz}}$ is not zero. {MOMENTUM}{ANSWER}"),
        format!(
            "{LAW}{COMPONENT}Choose axes so that $I_{{xy}} = I_{{yz}} = 0$. {MOMENTUM}{ANSWER}"
        ),
    ];
    for text in texts {
        let graded = marked(&text);
        assert_eq!(outcomes(&graded), ["full"; 4], "{text}: {graded:?}");
        assert!(graded.assumptions.iter().all(|a| a.in_key), "{graded:?}");
    }
}

#[test]
fn a_where_line_that_holds_counts_and_a_display_after_a_full_stop_is_a_claim() {
    let momentum = MOMENTUM.trim_start_matches("The momentum is ");
    let graded = marked(&format!("{LAW}{COMPONENT}where {momentum} so {ANSWER}"));
    assert_eq!(outcomes(&graded), ["full"; 4], "{graded:?}");
    let assumed = format!("{LAW}{COMPONENT}We assume rigid bodies.\n\n{MOMENTUM}{ANSWER}");
    assert_eq!(outcomes(&marked(&assumed)), ["full"; 4], "{assumed}");
}

#[test]
fn a_defining_integral_sets_the_convention_and_a_sign_does_not() {
    let flipped = |text: &str| {
        text.replace("- I_{xz}(", "+ I_{xz}(")
            .replace("- I_{xz}\\omega", "+ I_{xz}\\omega")
    };
    let body = format!("{LAW}{COMPONENT}{}{}", flipped(MOMENTUM), flipped(ANSWER));
    let defined = format!("Here $$I_{{xz}} = -\\int x z\\,dm$$\n{body}");
    let graded = marked(&defined);
    assert!(
        ["full", "human"].contains(&outcomes(&graded)[2]),
        "{graded:?}"
    );
}

#[test]
fn marks_are_rounded_as_the_key_says() {
    let text = format!("{LAW}{COMPONENT}{SLIP}{CARRIED}");
    let half = KEY.replacen("\"(5)\": 2", "\"(5)\": 1", 1);
    let half = half.replacen("follow_through: full", "follow_through: half", 1);
    assert_eq!(marked_by(&half, &text).marks.to_string(), "3.5");
    let rounded = |step: &str| half.replacen("working:", &format!("rounding: {step}\nworking:"), 1);
    assert_eq!(marked_by(&rounded("1"), &text).marks.to_string(), "4");
    assert_eq!(marked_by(&rounded("0.5"), &text).marks.to_string(), "3.5");
}

#[test]
fn a_line_may_use_no_more_rules_at_once_than_the_key_allows() {
    let key = KEY.replacen("working: required", "working: optional\nmost_rules: 0", 1);
    let graded = marked_by(&key, ANSWER);
    assert_eq!(outcomes(&graded)[3], "none", "{graded:?}");
    assert!(
        reason(&graded, "(5)").contains("rules at once"),
        "{graded:?}"
    );
    // The key's own line on the law uses two: no more is asked of others.
    let key = key.replacen("most_rules: 0", "most_rules: 1", 1);
    let graded = marked_by(&key, &format!("{LAW}{COMPONENT}{MOMENTUM}{ANSWER}"));
    assert_eq!(outcomes(&graded), ["full"; 4], "{graded:?}");
}

#[test]
fn letters_of_which_nothing_is_told_cost_no_marks_in_silence() {
    // Another alphabet's x looks the same and is another letter.
    let graded = marked("$$M_\u{445} = \\dot L_\u{445} + \\omega_y L_z - \\omega_z L_y$$");
    assert_eq!(outcomes(&graded)[1], "human", "{graded:?}");
    let graded = marked("$$M_q = \\dot L_q + \\omega_y L_z - \\omega_z L_y$$");
    assert_eq!(outcomes(&graded)[1], "human", "{graded:?}");
}

#[test]
fn milestones_that_wait_for_one_reason_are_named_together() {
    let graded = marked("$$L_x = I_{xx}\\omega_x - I_{xz}\\omega_z + \\eta$$");
    let queue = graded.queue.unwrap_or_default();
    assert_eq!(
        queue.matches("line 1 was not decided").count(),
        1,
        "{queue}"
    );
    assert!(queue.starts_with("(1), (2), (4), (5): "), "{queue}");
}

#[test]
fn a_greek_capital_that_looks_latin_is_a_letter_of_its_own() {
    let graded = marked(&format!("{LAW}{}", COMPONENT.replace("M_x", "\u{39c}_x")));
    let queue = graded.queue.unwrap_or_default();
    assert!(
        queue.contains("U+039C") && !queue.contains("command"),
        "{queue}"
    );
}
