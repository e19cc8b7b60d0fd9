//! The texts of a student as documents in which only what is claimed is left.

use crate::diagnostic::Severity;
use crate::grade::key::Key;
use crate::grade::lookalike::lookalike;
use crate::grade::paper::withdrawn::{Withdrawn, take_out};
use crate::grade::paper::{Work, chains, told};
use crate::grade::size;
use crate::notation;
use crate::notation::document::{Document, FrontMatter, Item};

/// What was read.
#[derive(Default)]
pub(super) struct Texts {
    pub(super) documents: Vec<Document>,
    /// For each document.
    pub(super) withdrawn: Vec<Withdrawn>,
    /// Sentences by which the student says what is meant.
    pub(super) told: Vec<String>,
    /// Sentences that may say such a thing, and how they were not taken in: of consequence where marks are missing.
    pub(super) doubts: Vec<String>,
    /// Why a person should look.
    pub(super) troubles: Vec<String>,
    /// What a file sets products of inertia to be.
    pub(super) products: Option<String>,
}

/// Reads the work of a student.
pub(super) fn read(key: &Key, work: &Work) -> Texts {
    let mut found = Texts {
        troubles: work.troubles.clone(),
        ..Texts::default()
    };
    for text in &work.texts {
        let (mut document, troubles) = notation::read(&text.name, &text.text, text.format);
        let errors = troubles.iter().filter(|t| t.severity == Severity::Error);
        let place = errors.take(1).map(|error| {
            let line = document.place(error.primary.span.start).line;
            format!("line {line} is not read: {}", error.message)
        });
        found.troubles.extend(place);
        if !document.front_matter.sentences.is_empty() && key.is_declared {
            let left_out = "it declares meanings of its own, which were left out";
            found.troubles.push(left_out.to_owned());
        }
        found.troubles.extend(lookalike(&document));
        let products = document.front_matter.products.clone();
        found.products = found.products.or(products);
        give_no_orders(&mut document, &key.settings);
        found.documents.push(document);
    }
    if let Some(excess) = size::excess(&found.documents, |letter| {
        !key.is_declared || key.speaks_of(letter)
    }) {
        found.troubles.push(excess);
        found.documents.clear();
    }
    let several = found.documents.len() > 1;
    for document in &mut found.documents {
        found.withdrawn.push(take_out(document));
        chains::part(document);
        if key.is_declared {
            let told = told::told(key, document, several);
            found.told.extend(told.sentences);
            found.doubts.extend(told.doubts);
            found.troubles.extend(told.unheard);
        }
    }
    found
}

/// A submission sets nothing but how it writes; comments in it play no roles.
fn give_no_orders(document: &mut Document, settings: &FrontMatter) {
    let front = std::mem::take(&mut document.front_matter);
    let mut symbols = settings.symbols.clone();
    symbols.extend(front.symbols);
    document.front_matter = FrontMatter {
        products: front.products.or_else(|| settings.products.clone()),
        axes: front.axes.or_else(|| settings.axes.clone()),
        symbols,
        ..FrontMatter::default()
    };
    document
        .items
        .retain(|item| !matches!(item, Item::Comment { .. }));
}
