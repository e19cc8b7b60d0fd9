//! What is declared of documents: in front matter, in comments, and in files named by `--declare`.

use crate::cli::{input, output};
use crate::diagnostic::Diagnostic;
use crate::notation::document::Document;
use crate::notation::sentences;
use crate::report::{Checked, Failure, terminal};
use crate::source::Source;
use crate::verify::{Declared, Misunderstood, Sheet, Unused, Wants};
use anstream::ColorChoice;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// The files of sentences; says which could not be read.
pub(super) fn sheets(paths: &[PathBuf]) -> (Vec<Sheet>, Vec<Failure>) {
    let (mut sheets, mut failures) = (vec![], vec![]);
    for path in paths {
        match input::read(path) {
            Ok(text) => sheets.push(Sheet {
                sentences: sentences(&text),
                source: Source::new(input::name(path), text),
            }),
            Err(error) => failures.push(failure(path, &error.to_string())),
        }
    }
    (sheets, failures)
}

/// That an input can't be read.
pub(super) fn failure(path: &Path, message: &str) -> Failure {
    Failure {
        path: input::name(path),
        message: message.to_owned(),
        ..Failure::default()
    }
}

/// Draws the sentences that were not understood, and returns them as failures.
pub(super) fn misunderstood(
    document: &Document,
    sheets: &[Sheet],
    declared: &Declared,
    color: ColorChoice,
) -> Vec<Failure> {
    let mut failures = vec![];
    for wrong in &declared.misunderstood {
        let misread = &wrong.misread;
        let mut diagnostic = Diagnostic::error("declaration", wrong.span, misread.message.clone());
        diagnostic.helps.extend(misread.help.clone());
        let sheet = wrong.sheet.and_then(|number| sheets.get(number));
        let text = match sheet {
            Some(sheet) => terminal::diagnostics(&sheet.source, &[diagnostic]),
            None => terminal::of_document(document, &[diagnostic]),
        };
        output::say(&text, color);
        let source = sheet.map_or(&document.source, |sheet| &sheet.source);
        failures.push(of(wrong, &source.name));
    }
    failures
}

fn of(wrong: &Misunderstood, path: &str) -> Failure {
    Failure {
        path: path.to_owned(),
        message: wrong.misread.message.clone(),
        cell: wrong.cell,
        place: Some((wrong.misread.line, wrong.misread.column)),
        help: wrong.misread.help.clone(),
    }
}

/// What is wrong with a sentence of which nothing was made, and what to do.
fn about(unused: &Unused) -> (String, String) {
    let sentence = &unused.sentence;
    if unused.beyond {
        return (
            format!("the model grows too large with the sentence \"{sentence}\""),
            "leave out what the document does not need, or say by which angles about which axes the frames turn".into(),
        );
    }
    let help = match &unused.wants {
        Some(Wants::Frame(name)) => format!(
            "no sentence says what `{name}` is: add one, such as \"{name} is a frame fixed in the body.\""
        ),
        Some(Wants::Point(name)) => format!(
            "no sentence says what `{name}` is: add one, such as \"{name} is a point fixed in B.\""
        ),
        Some(Wants::Name(name)) => format!("no sentence says what `{name}` is: add one"),
        Some(Wants::Sentence(other)) => format!("it waits for another sentence of which nothing was made: \"{other}\""),
        Some(Wants::Alone(other)) => {
            format!("another sentence tells of the same letter: \"{other}\"; leave one of them out, or say how the two go together")
        }
        Some(Wants::OneOfTwo(other)) => {
            format!("another sentence says otherwise: \"{other}\"; leave out the one that does not hold")
        }
        Some(Wants::Heading(title)) => format!(
            "no heading of the document reads \"{title}\": put the text of a heading between the quotation marks"
        ),
        Some(Wants::Adjective(word, noun)) => format!(
            "`{word}` isn't worked with before `{noun}`: say it in another way; leave it out only if it changes nothing"
        ),
        Some(Wants::Direction(shape)) => format!(
            "say the sizes of the {shape}, and along which axis of its frame it lies: \"$z$ is the axis of the {shape}.\""
        ),
        None => "this isn't worked with yet: say it in another way; leave it out only if no line needs it; polhode help language".into(),
    };
    (
        format!("nothing was made of the sentence \"{sentence}\""),
        help,
    )
}

/// Warns of sentences of which nothing was made: at their place in the document, or at once for those of a sheet.
pub(super) fn warn_of_unused(
    checked: &mut Checked,
    sheets: &[Sheet],
    declared: &Declared,
    color: ColorChoice,
) {
    let mut said: Vec<&str> = vec![];
    for unused in &checked.report.unused {
        if said.contains(&unused.sentence.as_str()) {
            continue;
        }
        said.push(&unused.sentence);
        let (sheet, span) = declared.place(&unused.sentence).unwrap_or_default();
        let (message, help) = about(unused);
        let diagnostic = Diagnostic::warning("unused-sentence", span, message).help(&help);
        match sheet.and_then(|number| sheets.get(number)) {
            Some(sheet) => output::say(&terminal::diagnostics(&sheet.source, &[diagnostic]), color),
            None => checked.diagnostics.push(diagnostic),
        }
    }
}

/// The reading of documents as declarations that can be pasted into front matter.
pub(super) fn meaning(checked: &[Checked]) -> String {
    let mut text = String::new();
    let several = checked.len() > 1;
    for checked in checked {
        let report = &checked.report;
        if several {
            let _ = writeln!(text, "# {}", on_one_line(&report.path));
        }
        for reading in &report.readings {
            let _ = writeln!(text, "# read as {}", on_one_line(reading));
        }
        if report.meaning.is_empty() {
            text.push_str("# nothing is declared: polhode help language\n");
            continue;
        }
        text.push_str("polhode:\n");
        for meant in &report.meaning {
            let sentence = quoted(&on_one_line(&meant.sentence));
            let _ = writeln!(text, "- {sentence}  # {}", on_one_line(&meant.source));
        }
    }
    text
}

fn on_one_line(text: &str) -> String {
    text.replace(char::is_control, " ")
}

/// A sentence as YAML takes it: in quotes where it begins or goes on like something else.
fn quoted(sentence: &str) -> String {
    let special = sentence.starts_with(|c: char| "`'\"[]{}&*!|>%@#-?:,".contains(c));
    match special || sentence.contains(": ") || sentence.contains(" #") {
        true => format!("'{}'", sentence.replace('\'', "''")),
        false => sentence.to_owned(),
    }
}
