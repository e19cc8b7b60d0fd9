//! Commands of an author's own that mark letters: by what the sentences say of them they are read, or they are not.

use super::outline::formulas;
use polhode::notation::document::Format;
use polhode::notation::read_declared;

/// A formula as it is read behind a sentence; none where something in it is not known.
fn read(sentence: &str, formula: &str) -> Option<String> {
    let text = format!("$${formula}$$\n");
    let (document, troubles) = read_declared("note.md", &text, Format::Markdown, &[sentence]);
    troubles.is_empty().then(|| formulas(&document))
}

#[test]
fn commands_around_single_letters_mark_them() {
    for (sentence, formula) in [
        ("$\\uvec{k}$ is fixed in B.", "\\uvec{k} = 1"),
        ("$\\pvec\\tau_1$ is constant.", "\\pvec\\tau = 1"),
    ] {
        let marked = read(sentence, formula);
        assert!(marked.is_some(), "{sentence}");
        assert_ne!(marked, read(sentence, "k = 1"), "{sentence}");
        assert_eq!(read("It is fixed in B.", formula), None, "{sentence}");
    }
}

#[test]
fn operators_and_commands_around_more_than_a_letter_are_none() {
    for (sentence, formula) in [
        (
            "$\\oper{v}$ is the matrix of $v$, for any vector $v$.",
            "\\oper{v} = 1",
        ),
        ("$\\own{a b}$ is not known.", "\\own{a} = 1"),
    ] {
        assert_eq!(read(sentence, formula), None, "{sentence}");
    }
    // What is known stays what it is.
    let known = "$\\vec{k}$ and $\\dot{\\theta}$ are known.";
    for formula in ["\\vec{k} = 1", "\\dot{\\theta} = 1"] {
        assert_eq!(read(known, formula), read("", formula), "{formula}");
    }
}

#[test]
fn letters_that_different_commands_mark_are_different() {
    let both = "$\\one{r}$ and $\\two{s}$ are vectors.";
    let [one, two] = ["\\one{r} = 1", "\\two{r} = 1"].map(|formula| read(both, formula));
    assert!(one.is_some() && two.is_some());
    assert_ne!(one, two);
}

#[test]
fn commands_that_sentences_name_alone_are_letters() {
    let named = "$\\th$ is the angle between x and y.";
    for formula in ["\\sin\\th = 1", "\\frac{d\\th}{dt} = 1", "m g(\\th) = 1"] {
        assert!(read(named, formula).is_some(), "{formula}");
        assert_eq!(read("It is an angle.", formula), None, "{formula}");
    }
    // What has an argument is no letter.
    assert_eq!(
        read("$\\size$ is the length of a vector.", "\\size{v} = 1"),
        None
    );
}
