//! Writes what is of the whole class, in one go through the students.

use crate::cli::grade::class::{Class, Count, failed};
use crate::cli::grade::journal::Students;
use crate::cli::grade::neighbours;
use crate::cli::output::Replacement;
use crate::cli::{input, output};
use crate::grade::{Graded, Key};
use crate::report::grade::class::Tally;
use crate::report::grade::told::{Detail, told};
use crate::report::grade::{self, class, gradebook, worksheet};
use std::io::{self, Write};
use std::path::Path;

/// A gradebook of the class under way.
struct Book {
    form: gradebook::Form,
    file: Replacement,
}

impl Book {
    /// None for a form with a file for each student.
    fn begin(form: gradebook::Form, key: &Key, out: &Path) -> io::Result<Option<Self>> {
        let Some(head) = gradebook::head_of_class(form, key) else {
            return Ok(None);
        };
        let mut file = Replacement::of(&out.join(&head.path))?;
        file.write_all(head.text.as_bytes())?;
        Ok(Some(Self { form, file }))
    }

    fn add(&mut self, key: &Key, student: &Graded, detail: Detail) -> io::Result<()> {
        let row = gradebook::row_of_class(self.form, key, student, detail);
        self.file.write_all(row.as_bytes())
    }
}

impl Class<'_> {
    /// Writes the results, the page of the class and its gradebooks, and counts.
    pub(super) fn finish(
        &self,
        students: &Students,
        missing: Option<&[String]>,
    ) -> Result<Count, String> {
        let path = self.out.join("results.json");
        let mut tally = Tally::default();
        let results = Replacement::of(&path).and_then(|mut results| {
            self.write_all(students, missing, &mut tally, &mut results)?;
            Ok(results)
        });
        let results = results.map_err(|error| failed(&path, &error))?;
        let page = self.out.join("class.html");
        let written = output::replace_by(&page, |file| {
            let student = |place| students.at(place);
            class::page(self.key, &tally, student, missing.unwrap_or(&[]), file)
        });
        written.map_err(|error| failed(&page, &error))?;
        match &self.worksheet {
            Some(path) => self.fill(path, students)?,
            None => neighbours::warn_of_worksheet(self.out),
        }
        // Where the results stand, all else does.
        results.finish().map_err(|error| failed(&path, &error))?;
        Ok(Count {
            marked: students.len(),
            waiting: tally.waiting(),
            missing: missing.map_or(0, <[String]>::len),
        })
    }

    /// Writes results, and gradebooks beside them.
    fn write_all(
        &self,
        students: &Students,
        missing: Option<&[String]>,
        tally: &mut Tally,
        results: &mut Replacement,
    ) -> io::Result<()> {
        let forms = self.telling.gradebooks.iter();
        let books = forms.map(|form| Book::begin(*form, self.key, self.out));
        let books = books.collect::<io::Result<Vec<_>>>()?;
        let mut books: Vec<Book> = books.into_iter().flatten().collect();
        let mut done = Ok(());
        students.show(|all| {
            let each = all.inspect(|student| {
                tally.add(student);
                for book in &mut books {
                    let added = book.add(self.key, student, self.telling.detail);
                    done = std::mem::replace(&mut done, Ok(())).and(added);
                }
            });
            grade::results(self.key, each, missing, results)
        })?;
        done?;
        books.into_iter().try_for_each(|book| book.file.finish())
    }

    /// Fills in a worksheet that was downloaded, and says who is not in it.
    fn fill(&self, path: &Path, students: &Students) -> Result<(), String> {
        let text = input::read_with_mark(path).map_err(|error| failed(path, &error))?;
        let ids = students.show(|all| Ok(all.map(|student| student.id).collect::<Vec<_>>()));
        let ids = ids.map_err(|error| failed(self.out, &error))?;
        let student = |place: usize| {
            let student = students.at(place).map_err(|error| error.to_string())?;
            Ok(told(&student, self.telling.detail))
        };
        let filled = self.out.join("worksheet.csv");
        let mut file = Replacement::of(&filled).map_err(|error| failed(&filled, &error))?;
        let unknown = worksheet::fill(&text, self.key, &ids, student, &mut file);
        let unknown = unknown.map_err(|why| failed(path, &why))?;
        if !unknown.is_empty() {
            let unknown = unknown.join(", ");
            eprintln!(
                "warning: {}: these students are not in it: {unknown}",
                input::name(path)
            );
        }
        file.finish().map_err(|error| failed(&filled, &error))
    }
}
