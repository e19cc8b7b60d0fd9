//! What is false does not pass: under a brace, as a definition of what is defined elsewhere, by a bound that nothing
//! else has, and by a sentence that ended.

use super::{BODY, judged};
use polhode::notation::{document::Format, read, sentences};
use polhode::source::Source;
use polhode::verify::{Sheet, check_declared, declarations};
use std::fmt::Write;

#[test]
fn a_brace_says_that_its_part_is_what_it_names() {
    let line = |name: &str| {
        format!(
            r"
It follows that

$$ \underbrace{{\mathbf J\vec\omega}}_{{{name}}} = \vec L $$
"
        )
    };
    assert_eq!(judged(BODY, &line(r"\vec L")), "p");
    assert_eq!(judged(BODY, &line(r"-\vec L")), "r");
    assert_eq!(judged(BODY, &line(r"\text{spin}")), "p");
    assert_eq!(judged(BODY, &line(r"q")), "p");
    assert_eq!(judged(BODY, &line(r"1")), "p");
}

#[test]
fn a_new_letter_among_known_ones_is_not_defined_by_the_way() {
    let text = r"
We write the balance as

$$ \mathbf J\dot{\vec\omega} + \vec\omega\times\mathbf J\vec\Gamma = \vec M $$

and define the rest

$$ \vec s = \vec M - \vec\omega\times\vec L $$
";
    assert_eq!(judged(BODY, text), "ua");
}

#[test]
fn a_letter_that_a_line_is_said_to_define_is_defined_by_no_other() {
    let sentences = format!("{BODY}Line 4 defines $h$.\n");
    let text = r"
Here $h = \vec\omega\cdot\vec M$ stands.

$$ h = \vec\omega\cdot\vec L $$
";
    assert_eq!(judged(&sentences, text), "ua");
}

#[test]
fn a_sum_runs_as_far_as_the_sums_of_the_document_do() {
    let sentences = format!(
        "{BODY}The body consists of particles.\n$i$ numbers the particles.\n$m_i$ is the mass of particle $i$.\n$\\vec r_i$ is the position of particle $i$ from G.\n"
    );
    let with = |first: &str| {
        format!(
            r"
$$ \sum_{{i=1}}^{first} m_i\vec r_i = 0 $$

$$ \sum_{{i=1}}^n m_i\dot{{\vec r}}_i = 0 $$

$$ \sum_{{i=1}}^n m_i\ddot{{\vec r}}_i = 0 $$
"
        )
    };
    assert_eq!(judged(&sentences, &with("n")), "ppp");
    assert_eq!(judged(&sentences, &with("s")), "upp");
}

#[test]
fn a_full_stop_in_a_display_ends_the_sentence() {
    let text = r"
We define the rest

$$ \vec s = \vec M - \vec\omega\times\vec L. $$

Then come words $\vec\omega\cdot\vec s = \vec q\cdot\vec M$ and more.
";
    assert_eq!(judged(BODY, text), "au");
}

#[test]
fn a_model_that_grows_too_large_is_bounded_and_said() {
    let mut said = String::from(BODY);
    for k in 1..12 {
        let parent = match k {
            1 => "N".to_owned(),
            _ => format!("F{}", k - 1),
        };
        let _ = writeln!(said, "F{k} is a frame that turns relative to {parent}.");
    }
    said += "The axes of F11 are principal axes of the body.\n";
    let text =
        "\n$$ \\vec L = \\mathbf J\\vec\\omega $$\n\n$$ \\vec L = 2\\mathbf J\\vec\\omega $$\n";
    let (document, _) = read("a document", text, Format::Markdown);
    let sheet = Sheet {
        sentences: sentences(&said),
        source: Source::new("what is declared", &said),
    };
    let declared = declarations(&document, &[sheet]);
    assert!(declared.misunderstood.is_empty(), "{declared:?}");
    let report = check_declared(&document, &declared);
    let verdicts: Vec<_> = report.findings.iter().map(|f| f.verdict.name()).collect();
    // A proof stands; nothing is denied while a sentence is not in force.
    assert_eq!(verdicts, ["proved", "undecided"]);
    assert!(
        report.unused.iter().any(|unused| unused.beyond),
        "{report:?}"
    );
}
