//! A document with what is asked of its words again and again, each made once.

use crate::notation::document::Document;
use crate::verify::words::attitude_words::{self, named};
use crate::verify::words::book::{has_any, lowered};
use crate::verify::words::sentences::{Paragraphs, Sentence, sentences};
use foldhash::HashMap;
use std::cell::{OnceCell, RefCell};
use std::ops::Deref;

/// A document and its words.
pub(crate) struct Text<'d> {
    document: &'d Document,
    lower: OnceCell<String>,
    sentences: OnceCell<Vec<Sentence<'d>>>,
    named: OnceCell<Vec<attitude_words::Sentence>>,
    /// By the place of the phrases, which is theirs alone.
    said: RefCell<HashMap<(usize, usize), bool>>,
}

impl<'d> Text<'d> {
    /// The words of a document.
    pub(crate) fn of(document: &'d Document) -> Self {
        Self {
            document,
            lower: OnceCell::new(),
            sentences: OnceCell::new(),
            named: OnceCell::new(),
            said: RefCell::default(),
        }
    }

    /// The whole source in lower case.
    pub(crate) fn lower(&self) -> &str {
        self.lower
            .get_or_init(|| lowered(&self.document.source.text))
    }

    /// Whether one of some phrases stands in the source in lower case.
    pub(crate) fn says(&self, phrases: &'static [&'static str]) -> bool {
        let mut said = self.said.borrow_mut();
        let known = said.entry((phrases.as_ptr().addr(), phrases.len()));
        *known.or_insert_with(|| has_any(self.lower(), phrases))
    }

    /// Its sentences, none of which goes on in another paragraph.
    pub(crate) fn sentences(&self) -> &[Sentence<'d>] {
        self.sentences
            .get_or_init(|| sentences(self.document, Paragraphs::Apart))
    }

    /// The same with the names of lone symbols, those without anything in them left out.
    pub(crate) fn named_sentences(&self) -> &[attitude_words::Sentence] {
        self.named.get_or_init(|| named(self.sentences()))
    }
}

impl Deref for Text<'_> {
    type Target = Document;

    fn deref(&self) -> &Document {
        self.document
    }
}
