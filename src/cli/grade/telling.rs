//! What is written for one student: pages, and files of gradebooks.

use crate::cli::grade::names::file_stem;
use crate::grade::{Graded, Key};
use crate::report::grade::told::{Detail, told};
use crate::report::grade::{self, gradebook, markdown, page};
use clap::ValueEnum;
use std::cell::LazyCell;

/// The forms of feedback.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
pub(super) enum Page {
    Html,
    Md,
    Json,
}

/// What students are told, and in which forms.
pub(super) struct Telling {
    pub(super) detail: Detail,
    pub(super) pages: Vec<Page>,
    pub(super) gradebooks: Vec<gradebook::Form>,
}

impl Telling {
    /// The files of a student.
    pub(super) fn files(&self, key: &Key, graded: &Graded) -> Vec<gradebook::File> {
        let (told, stem) = (told(graded, self.detail), file_stem(&graded.id));
        let markdown = LazyCell::new(|| markdown::student(key, &told));
        let pages = self.pages.iter().map(|form| {
            let (ending, text) = match form {
                Page::Html => ("html", page::student(key, &told)),
                Page::Md => ("md", markdown.clone()),
                Page::Json => ("json", grade::student(key, &told).unwrap_or_default()),
            };
            gradebook::File {
                path: format!("feedback/{stem}.{ending}"),
                text,
            }
        });
        let forms = self.gradebooks.iter();
        let books =
            forms.filter_map(|form| gradebook::of_student(*form, key, &told, &stem, &markdown));
        pages.chain(books).collect()
    }
}
