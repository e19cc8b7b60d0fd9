//! What is written for one student: pages, and files of gradebooks.

use crate::cli::grade::names::file_stem;
use crate::grade::{Graded, Key};
use crate::report::grade::told::{Detail, told};
use crate::report::grade::{self, gradebook, markdown, page};
use clap::ValueEnum;
use std::cell::LazyCell;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

/// The forms of feedback.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
pub(super) enum Page {
    Html,
    Md,
    Json,
}

impl Page {
    fn ending(self) -> &'static str {
        match self {
            Self::Html => "html",
            Self::Md => "md",
            Self::Json => "json",
        }
    }
}

/// What students are told, and in which forms.
pub(super) struct Telling {
    pub(super) detail: Detail,
    pub(super) pages: Vec<Page>,
    pub(super) gradebooks: Vec<gradebook::Form>,
}

impl Telling {
    /// Also in the forms in which an earlier run told more or less: what stands in the folder tells the same.
    pub(super) fn and_those_in(mut self, out: &Path) -> Self {
        let files = fs::read_dir(out.join("feedback"))
            .into_iter()
            .flatten()
            .flatten();
        for file in files {
            let path = PathBuf::from(file.file_name());
            let ending = path.extension().and_then(OsStr::to_str);
            let page = Page::value_variants()
                .iter()
                .find(|page| Some(page.ending()) == ending);
            self.pages
                .extend(page.filter(|page| !self.pages.contains(page)));
        }
        let books = gradebook::Form::ALL.into_iter();
        let there = books.filter(|form| out.join(form.place()).exists());
        self.gradebooks.extend(there);
        self.gradebooks.sort_unstable();
        self.gradebooks.dedup();
        self.pages.sort_unstable();
        self
    }

    /// Files of a student that a run before wrote, and that must not stand beside those of this one.
    pub(super) fn outdated(&self, graded: &Graded) -> Vec<String> {
        let stem = file_stem(&graded.id);
        let forms = self.gradebooks.iter();
        forms
            .filter_map(|form| gradebook::outdated(*form, graded, &stem))
            .collect()
    }

    /// The files of a student.
    pub(super) fn files(&self, key: &Key, graded: &Graded) -> Vec<gradebook::File> {
        let (told, stem) = (told(graded, self.detail), file_stem(&graded.id));
        let markdown = LazyCell::new(|| markdown::student(key, &told));
        let pages = self.pages.iter().map(|form| {
            let text = match form {
                Page::Html => page::student(key, &told),
                Page::Md => markdown.clone(),
                Page::Json => grade::student(key, &told).unwrap_or_default(),
            };
            gradebook::File {
                path: format!("feedback/{stem}.{}", form.ending()),
                text,
            }
        });
        let forms = self.gradebooks.iter();
        let books =
            forms.filter_map(|form| gradebook::of_student(*form, key, &told, &stem, &markdown));
        pages.chain(books).collect()
    }
}
