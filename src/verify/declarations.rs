//! Gathers the sentences by which an author says what a document means, and keeps where each stands.

use crate::notation::document::{Document, Sentence, line_name};
use crate::source::{Source, Span};
use crate::verify::language::either::cases;
use crate::verify::language::statement::{Declaration, Misread};
use crate::verify::language::{Lexicon, read_declarations, sentence};
use crate::verify::verdict::Meant;
use std::fmt;

/// A document has no more sentences than this.
const MOST: usize = 4_000;

/// What products of inertia may be set to be.
const PRODUCTS: [&str; 2] = ["entries", "integrals"];

/// What may stand before a colon.
const SETTINGS: &str =
    "the settings are `products`, `axes` and `symbol NAME`; anything else is a sentence";

/// Sentences of a file beside the document.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The file.
    pub source: Source,
    /// Its sentences.
    pub sentences: Vec<Sentence>,
}

/// What was declared of a document.
#[derive(Clone, Debug, Default)]
pub struct Declared {
    /// The declarations; a sentence may make several.
    pub declarations: Vec<Declaration>,
    /// Sentences that were not understood.
    pub misunderstood: Vec<Misunderstood>,
    /// The same in each of two cases, where a sentence leaves open which of them is so.
    pub(crate) cases: Vec<Declared>,
    /// Where each sentence stands.
    origins: Vec<Origin>,
    /// The sentence that each declaration is of.
    of: Vec<usize>,
}

/// A sentence that was not understood, and its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Misunderstood {
    /// The sheet that it stands on, by its number; `None` for the document.
    pub sheet: Option<usize>,
    /// The notebook cell, from 0.
    pub cell: Option<usize>,
    /// The bytes from what was not understood to the end of the sentence.
    pub span: Span,
    /// What is wrong; line and column are those of the file, or of the cell.
    pub misread: Misread,
}

impl fmt::Display for Misunderstood {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.cell {
            Some(cell) => write!(f, "cell {cell}, {}", self.misread),
            None => write!(f, "{}", self.misread),
        }
    }
}

/// Where a sentence stands.
#[derive(Clone, Debug)]
struct Origin {
    /// The sheet; `None` for the document.
    sheet: Option<usize>,
    /// Its bytes; `None` for what a setting says.
    span: Option<Span>,
    /// For people: `line 12`, `words.txt, line 3`.
    name: String,
    /// As it was read.
    text: String,
}

/// Reads what the front matter and comments of a document declare, and what the sheets beside it do.
///
/// ```
/// use polhode::notation::{document::Format, read};
/// use polhode::verify::declarations;
///
/// let text = "---\npolhode:\n- N is an inertial frame.\n---\nHere $L = I\\omega$.\n";
/// let (document, _) = read("note.md", text, Format::Markdown);
/// let declared = declarations(&document, &[]);
/// assert_eq!(declared.meaning()[0].sentence, "N is an inertial frame.");
/// assert_eq!(declared.meaning()[0].source, "line 3");
/// ```
pub fn declarations(document: &Document, sheets: &[Sheet]) -> Declared {
    let mut origins: Vec<Origin> = vec![];
    let own = document.front_matter.sentences.iter();
    origins.extend(own.map(|said| origin(document, None, said)));
    for (number, sheet) in sheets.iter().enumerate() {
        let said = sheet.sentences.iter();
        origins.extend(said.map(|said| origin(document, Some((number, &sheet.source)), said)));
    }
    let mut declared = Declared::default();
    if origins.is_empty() {
        return declared;
    }
    if let Some(beyond) = origins.get(MOST).cloned() {
        let misread = Misread {
            line: 1,
            column: 1,
            message: format!("more than {MOST} sentences are not read"),
            help: Some("keep to those that the document needs".to_owned()),
        };
        let place = placed(document, sheets, &beyond, misread);
        declared.misunderstood.push(place);
        origins.truncate(MOST);
        declared.of.push(MOST);
        declared
            .declarations
            .push(Declaration::unread(beyond.text.clone()));
    }
    let products = document.front_matter.products.as_deref();
    if let Some(products) = products.filter(|products| PRODUCTS.contains(products)) {
        origins.push(Origin {
            sheet: None,
            span: None,
            name: "front matter".to_owned(),
            text: format!("Products of inertia are {products}."),
        });
    }
    let stuck = declared.read(document, sheets, origins);
    declared.part_cases(document, sheets, &stuck);
    declared
}

fn origin(document: &Document, sheet: Option<(usize, &Source)>, said: &Sentence) -> Origin {
    let name = match sheet {
        Some((_, source)) => {
            let (line, _) = source.line_column(said.span.start);
            format!("{}, {}", source.name, line_name(None, line))
        }
        None => {
            let place = document.place(said.span.start);
            line_name(place.cell, place.line)
        }
    };
    Origin {
        sheet: sheet.map(|(number, _)| number),
        span: Some(said.span),
        name,
        text: said.text.clone(),
    }
}

/// What is wrong with a sentence, at its place in the file.
fn placed(
    document: &Document,
    sheets: &[Sheet],
    origin: &Origin,
    mut misread: Misread,
) -> Misunderstood {
    let sheet = origin.sheet.and_then(|number| sheets.get(number));
    let source = sheet.map_or(&document.source, |sheet| &sheet.source);
    let whole = origin.span.unwrap_or_default();
    let mut characters = source.slice(whole).char_indices();
    let at = characters.nth(misread.column.saturating_sub(1));
    let start = at.map_or(whole.end as usize, |(at, _)| whole.start as usize + at);
    let span = Span::new(start, whole.end as usize);
    let place = sheet.is_none().then(|| document.place(span.start));
    (misread.line, misread.column) =
        place.map_or_else(|| source.line_column(span.start), |p| (p.line, p.column));
    if is_setting(&origin.text) {
        misread.help = Some(SETTINGS.to_owned());
    }
    Misunderstood {
        sheet: origin.sheet,
        cell: place.and_then(|p| p.cell),
        span,
        misread,
    }
}

/// Whether a text looks like a setting: `products: entries`.
fn is_setting(text: &str) -> bool {
    let key = text.split_once(':').map(|(key, _)| key.trim_end());
    key.is_some_and(|key| !key.is_empty() && key.chars().all(|c| c.is_alphabetic() || c == '_'))
}

impl Declared {
    /// Reads sentences, and returns the numbers of those that are not understood.
    fn read(&mut self, document: &Document, sheets: &[Sheet], origins: Vec<Origin>) -> Vec<usize> {
        let texts: Vec<&str> = origins.iter().map(|origin| origin.text.as_str()).collect();
        let (found, misread) =
            read_declarations(&texts.join("\n"), &document.macros, Lexicon::shared());
        for mut declaration in found {
            self.of.push(declaration.line.saturating_sub(1));
            let words: Vec<&str> = declaration.text.split_whitespace().collect();
            declaration.text = words.join(" ");
            self.declarations.push(declaration);
        }
        let mut stuck = vec![];
        for misread in misread {
            let number = misread.line.saturating_sub(1);
            if let Some(origin) = origins.get(number) {
                stuck.push(number);
                self.misunderstood
                    .push(placed(document, sheets, origin, misread));
            }
        }
        self.origins = origins;
        stuck
    }

    /// Of the first sentence that leaves open which of two things is so, and that is understood in both cases, each of them.
    fn part_cases(&mut self, document: &Document, sheets: &[Sheet], stuck: &[usize]) {
        let parted = stuck.iter().enumerate().find_map(|(place, &number)| {
            let texts = cases(&self.origins[number].text)?;
            let read = |text: String| {
                let mut origins = self.origins.clone();
                origins[number].text = text;
                let mut case = Declared::default();
                let left = case.read(document, sheets, origins);
                (!left.contains(&number)).then_some(case)
            };
            let cases: Option<Vec<Declared>> = texts.into_iter().map(read).collect();
            Some((place, cases?))
        });
        if let Some((place, cases)) = parted {
            let before = self.misunderstood.len() - stuck.len();
            self.misunderstood.remove(before + place);
            self.cases = cases;
        }
    }

    /// Whether nothing was declared, and nothing tried.
    pub fn is_empty(&self) -> bool {
        self.declarations.is_empty() && self.misunderstood.is_empty()
    }

    /// The sentences in the words of the language, each with where it comes from.
    pub fn meaning(&self) -> Vec<Meant> {
        let lexicon = Lexicon::shared();
        let each = self.declarations.iter().zip(&self.of);
        let each = each.filter(|(said, _)| !said.is_unread());
        let meant = each.map(|(declaration, &of)| Meant {
            sentence: sentence(declaration, lexicon),
            source: self
                .origins
                .get(of)
                .map_or(String::new(), |origin| origin.name.clone()),
        });
        let mut meant: Vec<Meant> = meant.collect();
        // A sentence that leaves two cases open is printed as it stands.
        if let [first, ..] = self.cases.as_slice() {
            let differ = |(own, case): (&Origin, &Origin)| {
                (own.text != case.text).then(|| Meant {
                    sentence: own.text.clone(),
                    source: own.name.clone(),
                })
            };
            meant.extend(self.origins.iter().zip(&first.origins).filter_map(differ));
        }
        meant
    }

    /// The sheet and the bytes of a sentence, by the text of its declarations.
    pub fn place(&self, text: &str) -> Option<(Option<usize>, Span)> {
        let text = text.trim_end_matches('.');
        let mut all = self.declarations.iter();
        let at = all.position(|declaration| declaration.sentence() == text)?;
        let origin = self.origins.get(*self.of.get(at)?)?;
        Some((origin.sheet, origin.span?))
    }
}
