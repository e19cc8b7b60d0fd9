//! What a student says of letters and marks, in the text or by what is written.

use super::{ANSWER, COMPONENT, KEY, LAW, MOMENTUM, marked, marked_by, outcomes};

#[test]
fn a_sentence_of_meaning_in_the_text_is_heard() {
    let plain = "$$\\vec M = \\dot{\\vec L} + \\vec\\omega\\times\\vec L$$\n\n";
    let body = format!("{plain}{MOMENTUM}{ANSWER}");
    // By the sheet the dot is the rate seen from N.
    assert_eq!(outcomes(&marked(&body))[0], "none");
    for told in [
        "The dot means the rate seen from B.",
        "Here, the dot denotes the rate seen from B.",
        "In what follows the dot means the rate seen from B.",
    ] {
        let graded = marked(&format!("{told}\n\n{body}"));
        assert_eq!(outcomes(&graded), ["full"; 4], "{told}: {graded:?}");
        assert!(graded.notes[0].contains("seen from B"), "{graded:?}");
    }
    // It holds from its place on.
    let late = format!("{plain}From here on the dot means the rate seen from B.\n\n{MOMENTUM}");
    assert_eq!(outcomes(&marked(&late))[0], "none");
}

#[test]
fn a_sentence_of_meaning_that_is_not_understood_waits_for_a_person() {
    let good = format!("{LAW}{COMPONENT}{MOMENTUM}{ANSWER}");
    let graded = marked(&format!(
        "The dot means the wobble of the frumble.\n\n{good}"
    ));
    let queue = graded.queue.unwrap_or_default();
    assert!(
        queue.contains("line 1") && queue.contains("frumble"),
        "{queue}"
    );
    // What all mean by it is no news, and nor is what the sheet says.
    for told in [
        "The dot means the time derivative.",
        "Here $\\vec L$ is the angular momentum.",
        "This means that the moment is not zero.",
    ] {
        let graded = marked(&format!("{told}\n\n{good}"));
        assert_eq!(outcomes(&graded), ["full"; 4], "{told}: {graded:?}");
        assert_eq!(graded.queue, None, "{told}");
    }
}

#[test]
fn a_letter_of_the_student_for_a_quantity_of_the_sheet_is_that_quantity() {
    let law =
        "and the law is $$\\vec M = (\\dot{\\vec H})_{xyz} + \\vec\\omega\\times\\vec H.$$\n\n";
    let named = [
        "The angular momentum is $$\\vec H = I\\vec\\omega$$",
        "The angular momentum of the rotor about G is given by $$\\vec H = I\\vec\\omega$$",
        "Let $\\vec H$ be the angular momentum. Then $$\\vec H = I\\vec\\omega$$",
    ];
    for named in named {
        let graded = marked(&format!("{named} {law}"));
        assert_eq!(outcomes(&graded)[..3], ["full"; 3], "{named}: {graded:?}");
    }
    let wrong = marked("The angular momentum is $$\\vec H = 2I\\vec\\omega$$");
    assert_eq!(outcomes(&wrong)[2], "none", "{wrong:?}");
    assert!(wrong.first_slip.is_some(), "{wrong:?}");
}

#[test]
fn a_letter_that_is_defined_as_what_the_key_says_of_another_waits_for_a_person() {
    let graded = marked("We write $$\\vec H = I\\vec\\omega.$$");
    assert_eq!(outcomes(&graded)[2], "human", "{graded:?}");
    let side = "(\\dot{\\vec L})_{xyz} + \\vec\\omega\\times\\vec L";
    for text in [
        format!("Let $$\\vec\\tau = {side}.$$"),
        format!("Let $\\vec\\tau$ be the torque. Then $$\\vec\\tau = {side}.$$"),
    ] {
        let graded = marked(&text);
        assert_eq!(outcomes(&graded)[0], "human", "{text}: {graded:?}");
    }
    // Where it is said what the letter is, nobody is asked.
    let graded = marked(&format!(
        "Let $$\\vec\\tau = \\vec M.$$ Then $$\\vec\\tau = {side}.$$"
    ));
    assert_eq!(outcomes(&graded)[0], "full", "{graded:?}");
    assert!(graded.assumptions.is_empty(), "{graded:?}");
}

#[test]
fn a_wrong_formula_for_a_quantity_that_the_sheet_does_not_name_is_a_slip() {
    let good = format!("{LAW}{COMPONENT}{MOMENTUM}{ANSWER}");
    let graded = marked(&format!(
        "{good}\nThe kinetic energy of the rotor relative to N is $$T = 2\\vec\\omega\\cdot\\vec L.$$"
    ));
    assert_eq!(outcomes(&graded), ["full"; 4], "{graded:?}");
    assert!(graded.first_slip.is_some(), "{graded:?}");
    // It may be that of the rotation alone.
    let right = marked(&format!(
        "{good}\nThe kinetic energy is $$T = \\frac12\\vec\\omega\\cdot\\vec L.$$"
    ));
    assert_eq!(right.first_slip, None, "{right:?}");
}

#[test]
fn a_matrix_of_inertia_tells_the_convention() {
    let flipped = |text: &str| text.replace("- I_{xz}", "+ I_{xz}");
    let body = format!("{}{}", flipped(MOMENTUM), flipped(ANSWER));
    let matrix = |sign: &str| {
        format!(
            "\\begin{{bmatrix}} I_{{xx}} & 0 & {sign}I_{{xz}} \\\\ 0 & I_{{yy}} & 0 \\\\ \
             {sign}I_{{xz}} & 0 & I_{{zz}} \\end{{bmatrix}}"
        )
    };
    let column = |entries: &str| format!("\\begin{{bmatrix}}{entries}\\end{{bmatrix}}");
    let product = format!(
        "$${} = {}{}$$",
        column("L_x \\\\ L_y \\\\ L_z"),
        matrix(""),
        column("\\omega_x \\\\ \\omega_y \\\\ \\omega_z")
    );
    let shown = [
        format!("The inertia matrix is $$I = {}$$", matrix("")),
        format!("Let\n\n$$I = {}$$\n\nbe the inertia matrix.", matrix("")),
        product,
        "With $I_{xz} = -\\int xz\\,dm$".to_owned(),
    ];
    for shown in &shown {
        // It rules what the key sets, too.
        for key in [
            KEY.to_owned(),
            KEY.replacen("working:", "products: integrals\nworking:", 1),
        ] {
            let graded = marked_by(&key, &format!("{LAW}{COMPONENT}{shown}\n\n{body}"));
            assert_eq!(outcomes(&graded), ["full"; 4], "{shown}: {graded:?}");
            assert!(
                graded.notes[0].contains("products of inertia"),
                "{graded:?}"
            );
        }
    }
    let own = format!("The inertia matrix is $$I = {}$$", matrix("-"));
    let graded = marked(&format!("{LAW}{COMPONENT}{own}\n\n{MOMENTUM}{ANSWER}"));
    assert_eq!(outcomes(&graded), ["full"; 4], "{graded:?}");
    assert!(graded.notes.is_empty(), "{graded:?}");
}
