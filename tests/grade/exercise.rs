//! An exercise from loads to motion: a disc on a horizontal axle that turns about the vertical, as students hand it in.

use super::{marked_by, outcomes};
use polhode::grade::{Graded, Key, Work, mark};
use polhode::notation::document::Format;

const KEY: &str = include_str!("../../examples/grading/precession.md");

const START: &str = r"$$\vec\omega = p\vec i + \Omega\vec k$$
$$I_1 = \tfrac12 mR^2,\qquad I_2 = \tfrac14 mR^2 + ml^2$$
$$\vec L = \tfrac12 mR^2 p\,\vec i + (\tfrac14 mR^2+ml^2)\Omega\,\vec k$$
";
const RATE: &str = "$$\\dot{\\vec L} = \\tfrac12 mR^2p\\Omega\\,\\vec j$$\n";
const MOMENT: &str = "$$\\vec M = mgl\\,\\vec j$$\n";
const ANSWER: &str = "$$\\Omega = \\frac{2gl}{R^2p}$$\n";

fn graded(text: &str) -> Graded {
    marked_by(KEY, text)
}

/// Outcomes of (1) to (6) by their first letters.
fn letters(graded: &Graded) -> String {
    let names = outcomes(graded).into_iter();
    names.filter_map(|name| name.chars().next()).collect()
}

#[test]
fn right_work_has_all_marks_in_any_letters() {
    let plain = format!("{START}{RATE}{MOMENT}{ANSWER}");
    let bold = plain
        .replace("\\vec ", "\\mathbf ")
        .replace("\\vec\\omega", "\\boldsymbol\\omega");
    let bare = plain
        .replace("\\vec L", "L")
        .replace("\\vec M", "M")
        .replace("\\vec\\omega", "\\omega");
    let symbols = r"$$\vec\omega = p\vec i + \Omega\vec k$$
We have $I_1 = \frac12 mR^2$ and $I_2 = \frac14 mR^2 + ml^2$.
$$\vec L = I_1p\vec i + I_2\Omega\vec k$$
$$\frac{d\vec L}{dt} = \Omega\vec k\times\vec L = I_1p\Omega\vec j$$
$$\vec M = l\vec i\times(-mg\vec k) = mgl\vec j$$
Equating, $I_1p\Omega = mgl$ and so
$$\Omega = \frac{mgl}{I_1p}$$";
    for text in [plain, bold, bare, symbols.to_owned()] {
        let graded = graded(&text);
        assert_eq!(letters(&graded), "ffffff", "{text}: {graded:?}");
        assert_eq!(graded.queue, None, "{text}");
    }
}

#[test]
fn plain_text_is_marked_too() {
    let text = "omega = p i + Omega k\nI1 = 1/2 m R^2\nI2 = 1/4 m R^2 + m l^2\nL = I1 p i + I2 Omega k\n\
                dL/dt = I1 p Omega j\nM = m g l j\nI1 p Omega = m g l\nOmega = 2 g l/(R^2 p)\n";
    let key = Key::read("key.md", KEY, Format::Markdown).expect("a key");
    let graded = mark(&key, &Work::of_text("s", "s.txt", Format::Text, text));
    assert_eq!(letters(&graded), "ffffff", "{graded:?}");
}

#[test]
fn a_wrong_vector_is_refuted_and_what_follows_from_it_by_the_law_is_carried() {
    let moment = graded(&format!(
        "{START}{RATE}{}{}",
        MOMENT.replace("mgl", "-mgl"),
        ANSWER.replace("\\frac", "-\\frac")
    ));
    let outcome = outcomes(&moment);
    assert_eq!(outcome[..4], ["full"; 4], "{moment:?}");
    assert_eq!(outcome[4..], ["none", "follow-through"], "{moment:?}");
    let slip = moment.first_slip.expect("a slip");
    assert_eq!((slip.kind.as_str(), slip.place.source_line), ("sign", 5));
}

#[test]
fn an_early_slip_is_punished_once() {
    let rate = RATE.replace("= ", "= \\Omega\\vec k\\times\\vec L = ");
    let text = format!("{START}{rate}{MOMENT}{ANSWER}").replace("\\tfrac12 ", "");
    let graded = graded(&text.replace("2gl", "gl"));
    let outcome = outcomes(&graded);
    assert_eq!(outcome[1], "none", "{graded:?}");
    assert_eq!(outcome[2..4], ["follow-through"; 2], "{graded:?}");
    assert_eq!(outcome[4..], ["full", "follow-through"], "{graded:?}");
}

#[test]
fn the_answer_alone_is_no_working() {
    let alone = graded(ANSWER);
    assert_eq!(letters(&alone), "nnnnnn", "{alone:?}");
    assert!(alone.milestones[5].reason.contains("only asserted"));
}

#[test]
fn a_moment_does_not_count_as_the_rate_that_the_law_makes_of_it() {
    let text = format!("{START}$$\\dot{{\\vec L}} = mgl\\,\\vec j$$\n");
    let graded = graded(&text);
    assert_ne!(outcomes(&graded)[3], "full", "{graded:?}");
}
