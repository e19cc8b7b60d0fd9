//! What `derive` prints of a declared system is proved by `check` with the same declarations.

use polhode::notation::{document::Format, read, sentences};
use polhode::report::derive::{Derivation, of_system, proved_part};
use polhode::source::Source;
use polhode::verify::derivation::{Derived, Law, Refusal, Wish, derive_system};
use polhode::verify::{Declared, Sheet, check_declared, declarations};
use std::fs;

const SYSTEMS: [&str; 5] = ["heavy-top", "pendulum", "gyroscope", "platform", "wheel"];

fn sheet(text: &str) -> Sheet {
    Sheet {
        source: Source::new("system.declare", text),
        sentences: sentences(text),
    }
}

pub(super) fn example(name: &str) -> Sheet {
    let text = fs::read_to_string(format!("examples/{name}.declare")).expect("an example");
    sheet(&text)
}

fn declared(sheet: &Sheet) -> Declared {
    let (nothing, _) = read("", "", Format::Markdown);
    let declared = declarations(&nothing, std::slice::from_ref(sheet));
    assert_eq!(declared.misunderstood, []);
    declared
}

pub(super) fn derived(sheet: &Sheet, find: Option<&str>, steady: bool) -> Derived {
    let wish = Wish {
        find: find.map(str::to_owned),
        steady,
    };
    derive_system(&declared(sheet), &wish).expect("a derivation")
}

/// Checks a page with the declarations that it was derived from, and returns how many lines are proved: all.
fn proved(page: &str, format: Format, sheet: &Sheet) -> usize {
    let (document, findings) = read("derived", page, format);
    assert!(findings.is_empty(), "{findings:?}");
    let declared = declarations(&document, std::slice::from_ref(sheet));
    assert_eq!(declared.misunderstood, []);
    let report = check_declared(&document, &declared);
    assert_eq!(report.unused, []);
    for finding in &report.findings {
        let verdict = finding.verdict.name();
        assert_eq!(verdict, "proved", "{}\n{page}", finding.source);
    }
    report.findings.len()
}

fn rows(derived: &Derived) -> usize {
    let steps = derived.parts.iter().flat_map(|part| &part.steps);
    steps.map(|step| step.rows.len()).sum()
}

/// The rows of a law, in Unicode.
fn told(derived: &Derived, law: Law) -> Vec<String> {
    let steps = derived.parts.iter().flat_map(|part| &part.steps);
    let rows = steps.filter(|step| step.law == law).flat_map(|s| &s.rows);
    rows.map(|row| format!("{} = {}", row.left.unicode, row.right.unicode))
        .collect()
}

fn assert_proved(print: impl Fn(&Derivation) -> String, format: Format) {
    for name in SYSTEMS {
        let sheet = example(name);
        let derived = derived(&sheet, None, true);
        let page = print(&of_system(&derived));
        assert_eq!(proved(&page, format, &sheet), rows(&derived), "{page}");
        assert!(rows(&derived) >= 12, "{page}");
    }
}

#[test]
fn markdown_is_proved() {
    assert_proved(Derivation::markdown, Format::Markdown);
}

#[test]
fn latex_is_proved() {
    assert_proved(Derivation::latex, Format::Latex);
}

#[test]
fn unicode_is_proved() {
    assert_proved(Derivation::unicode, Format::Text);
}

#[test]
fn a_heavy_top_has_the_equations_of_the_books() {
    let derived = derived(&example("heavy-top"), None, true);
    assert_eq!(
        told(&derived, Law::Equations),
        [
            "A ω̇_x + (C − A) ω_y ω_z = m a g cos ψ sin θ",
            "A ω̇_y + (A − C) ω_x ω_z = −m a g sin ψ sin θ",
            "C ω̇_z = 0",
        ]
    );
    assert_eq!(
        told(&derived, Law::FirstIntegrals),
        ["E\u{307} = 0", "L\u{307}_Z = 0", "L\u{307}_z = 0"]
    );
    assert_eq!(
        told(&derived, Law::Steady),
        ["−C ψ̇ φ̇ + (A − C) φ̇² cos θ + m a g = 0"]
    );
}

#[test]
fn a_pendulum_swings_by_its_equation() {
    let derived = derived(&example("pendulum"), None, false);
    assert_eq!(told(&derived, Law::Equations), ["I θ̈ = −m a g sin θ"]);
}

#[test]
fn one_quantity_is_found_by_its_noun() {
    let sheet = example("heavy-top");
    for (noun, law, count) in [
        ("the moment on the top about O", Law::MomentPutIn, 3),
        (
            "the angular velocity of B relative to N",
            Law::AngularVelocities,
            3,
        ),
        ("the velocity of G relative to N", Law::PointOfBody, 2),
        ("the acceleration of G relative to N", Law::Acceleration, 3),
        ("the kinetic energy of the top", Law::KineticEnergy, 1),
        (
            "the angular momentum of the top about O relative to N",
            Law::AngularMomentum,
            3,
        ),
    ] {
        let derived = derived(&sheet, Some(noun), false);
        assert_eq!(told(&derived, law).len(), count, "{noun}: {derived:?}");
        let last = derived.parts.last().and_then(|part| part.steps.last());
        assert_eq!(last.map(|step| step.law), Some(law), "{noun}");
        let page = of_system(&derived).markdown();
        assert_eq!(proved(&page, Format::Markdown, &sheet), rows(&derived));
    }
}

#[test]
fn a_wish_that_is_not_understood_is_told_with_its_place() {
    let declared = declared(&example("heavy-top"));
    let refusal = |find: &str| {
        let wish = Wish {
            find: Some(find.to_owned()),
            steady: false,
        };
        derive_system(&declared, &wish).expect_err("no derivation")
    };
    let Refusal::Misread(misread) = refusal("the momnt on the top about O") else {
        panic!("it is misread");
    };
    assert_eq!(misread.column, 5);
    assert!(misread.message.contains("momnt"));
    assert_eq!(misread.help.as_deref(), Some("did you mean `moment`?"));
    let unknown = "the angular velocity of B relative to Q";
    assert_eq!(refusal(unknown), Refusal::NoSuchQuantity);
}

#[test]
fn the_letters_of_the_author_are_taken() {
    let text = fs::read_to_string("examples/heavy-top.declare").expect("an example");
    let own = "$\\mathbf{H}$ is the angular momentum of the top about O relative to N.\n\
               $p, q, r$ are the components of $\\mathbf{w}$ on B.\n\
               $\\mathbf{w}$ is the angular velocity of B relative to N.\n";
    let sheet = sheet(&(text + own));
    let derived = derived(&sheet, None, false);
    assert_eq!(
        told(&derived, Law::AngularMomentum),
        ["H_x = A p", "H_y = A q", "H_z = C r"]
    );
    let page = of_system(&derived).markdown();
    assert_eq!(proved(&page, Format::Markdown, &sheet), rows(&derived));
}

#[test]
fn a_system_that_says_nothing_has_no_derivation() {
    let sheet = sheet("N is an inertial frame.\n");
    let refused = derive_system(&declared(&sheet), &Wish::default());
    assert_eq!(refused, Err(Refusal::NothingToDerive));
}

/// Systems in a few sentences, and how many rows each has at least.
const SHORT: [(&str, usize); 3] = [
    (
        "N is an inertial frame.\nB is a frame fixed in the craft.\n\
         The craft is a rigid body of mass $m$.\nG is the mass centre of the craft.\n\
         $g$ is the acceleration of gravity.\n$u$ is the upward vertical.\n\
         The weight is the only load on the craft.\n",
        20,
    ),
    (
        "N is an inertial frame.\nB is a frame fixed in the body.\n1, 2, 3 are the axes of B.\n\
         G is the mass centre of the body.\n\
         $I_1$, $I_2$, $I_3$ are the principal moments of the body about G on B.\n\
         No moment acts on the body about G.\n",
        20,
    ),
    (
        "N is an inertial frame.\n$z$ is the upward vertical.\nO is a point fixed in N.\n\
         P is a particle of mass $m$.\n$\\mathbf r$ is the position of P from O.\n\
         $g$ is the acceleration of gravity.\nThe weight is the only load on P.\n",
        14,
    ),
];

#[test]
fn letters_are_found_where_the_author_has_none() {
    for (text, least) in SHORT {
        let sheet = sheet(text);
        let derived = derived(&sheet, None, false);
        assert!(rows(&derived) >= least, "{derived:?}");
        let page = of_system(&derived);
        for (page, format) in [
            (page.markdown(), Format::Markdown),
            (page.unicode(), Format::Text),
        ] {
            assert_eq!(proved(&page, format, &sheet), rows(&derived));
        }
    }
}

#[test]
fn a_whole_has_the_momentum_of_its_parts() {
    let derived = derived(&example("platform"), None, false);
    let momentum = told(&derived, Law::SumOfParts);
    assert_eq!(
        momentum.last().map(String::as_str),
        Some("L_{s,z} = I_3 ω_{B,z} + J ω_{D,z}")
    );
    assert_eq!(told(&derived, Law::Equations).len(), 3);
}

#[test]
fn a_row_that_the_authors_marks_give_another_meaning_is_left_out() {
    let text = "N is an inertial frame.\nB is a frame fixed in the body.\n\
                G is the mass centre of the body.\nA tilde means components on B.\n\
                A vector or tensor without a tilde has components on N.\n";
    let sheet = sheet(text);
    let derived = derived(&sheet, None, false);
    let (part, left_out) = proved_part(&derived, std::slice::from_ref(&sheet));
    assert!(left_out > 0, "{derived:?}");
    assert_eq!(rows(&part) + left_out, rows(&derived));
    let page = of_system(&part).markdown();
    assert_eq!(proved(&page, Format::Markdown, &sheet), rows(&part));
    let top = example("heavy-top");
    let derived = self::derived(&top, None, true);
    assert_eq!(proved_part(&derived, &[top]), (derived, 0));
}
