//! Lines that a student writes and does not claim.

use super::{ANSWER, COMPONENT, LAW, MOMENTUM, marked, outcomes};

/// The second milestone, which nothing else gives here.
const LINE: &str = r"M_x = \dot L_x + \omega_y L_z - \omega_z L_y";

/// The outcome of the second milestone, and the verdicts of the lines.
fn second(text: &str) -> (&'static str, Vec<String>) {
    let graded = marked(text);
    let verdicts = graded.lines.iter().map(|line| line.verdict.clone());
    (outcomes(&graded)[1], verdicts.collect())
}

#[test]
fn a_line_that_is_taken_back_earns_nothing_and_costs_nothing() {
    let asked = |sign: &str| format!("$${}$$", LINE.replace('=', sign));
    let texts = [
        format!("It is not true that $${LINE}.$$"),
        format!("It is not true that\n\n$${LINE}$$\n\nfor this body."),
        format!("We do not have $${LINE}.$$"),
        format!("It would be wrong to stop. It is false that ${LINE}$."),
        format!("$${LINE}$$ (false)"),
        format!("$${LINE}$$ is not true."),
        format!("$${LINE}$$ No, that is wrong."),
        format!("$${LINE} \\quad\\text{{(false)}}$$"),
        format!("Is it $${LINE}?$$"),
        format!("Is ${LINE}$ right?"),
        asked("\\stackrel{?}{=}"),
        asked("\\overset{?}{=}"),
        asked("\\overset{\\text{?}}{=}"),
        asked("\u{225f}"),
        format!("~~${LINE}$~~"),
        format!("~~The component is $${LINE}$$ so far~~"),
        format!("<del>${LINE}$</del>"),
        format!("$$\\cancel{{{LINE}}}$$"),
        format!("$$\\sout{{{LINE}}}$$"),
        format!("$$\\enclose{{horizontalstrike}}{{{LINE}}}$$"),
    ];
    for text in texts {
        let (outcome, verdicts) = second(&format!("{text}\n\n{MOMENTUM}"));
        assert_eq!(outcome, "none", "{text}");
        let withdrawn = verdicts.iter().filter(|verdict| *verdict == "withdrawn");
        assert_eq!(withdrawn.count(), 1, "{text}: {verdicts:?}");
    }
    // A false line costs nothing either.
    let wrong = LINE.replace('+', "-");
    for text in [
        format!("It is not true that $${wrong}.$$"),
        format!("~~${wrong}$~~"),
    ] {
        let graded = marked(&format!("{LAW}{text}\n\n{COMPONENT}{MOMENTUM}{ANSWER}"));
        assert_eq!(outcomes(&graded), ["full"; 4], "{text}: {graded:?}");
        assert_eq!((graded.first_slip, graded.queue), (None, None));
    }
}

#[test]
fn a_line_that_may_be_taken_back_waits_for_a_person() {
    for text in [
        format!("Is it $${LINE}?$$ Yes."),
        format!("Why do we have ${LINE}$?"),
        "$$M_x = \\dot L_x + \\cancel{\\omega_y L_z} - \\omega_z L_y$$".to_owned(),
        format!("~~\n\n$${LINE}$$\n\n~~"),
        format!("Rather than ${LINE}$ we take the other one."),
    ] {
        let graded = marked(&text);
        assert_eq!(outcomes(&graded)[1], "human", "{text}: {graded:?}");
        let queue = graded.queue.unwrap_or_default();
        assert!(queue.contains("was not decided: "), "{queue}");
    }
}

#[test]
fn words_that_deny_something_else_leave_a_line_alone() {
    for text in [
        format!(
            "The moment does not vanish. Since the body is not symmetric, we have $${LINE}$$ which is not zero."
        ),
        format!("What is the first component? $${LINE}$$ This is not the only one."),
        format!("It is not true that the moment vanishes, but $${LINE}.$$"),
        format!("$${LINE}$$ It would be wrong to leave out the second term."),
        format!("Without friction $${LINE}$$ No external force acts."),
        format!("We neglect nothing, e.g. no product of inertia. So ${LINE}$."),
        "$$M_x = \\dot L_x + \\omega_y L_z - \\omega_z L_y + \\cancel{I_{xx}} - \\cancel{I_{xx}}$$"
            .to_owned(),
    ] {
        assert_eq!(second(&text).0, "full", "{text}");
    }
}
