//! Parts of a document by their headings.

use super::reader::{Read, Reader};
use super::statement::Extent;
use super::words::Kind;

/// How parts of a document are called that have a heading.
pub(super) const PARTS: [&str; 4] = ["section", "sections", "subsection", "subsections"];

impl Reader<'_> {
    /// "the section", "sections", before a heading.
    pub(super) fn take_heads_of_parts(&mut self) -> bool {
        let start = self.at;
        self.take("the");
        let part = self.take_any(&PARTS);
        if !part {
            self.at = start;
        }
        part
    }

    /// "\"A\"", "\"A\", \"B\" and \"C\"", "\"A\" and in the section \"B\"": the parts under these headings.
    pub(super) fn headings(&mut self) -> Read<Vec<Extent>> {
        let mut parts = vec![Extent::Section(self.quoted()?)];
        loop {
            let start = self.at;
            let mut goes_on = self.take_separator();
            if goes_on && self.take("in") {
                goes_on = self.take_heads_of_parts();
            }
            if !goes_on || self.kind() != Some(Kind::Quoted) {
                self.at = start;
                return Ok(parts);
            }
            parts.push(Extent::Section(self.quoted()?));
        }
    }

    /// A heading between quotation marks.
    pub(crate) fn quoted(&mut self) -> Read<String> {
        let text = self
            .peek()
            .filter(|t| t.kind == Kind::Quoted)
            .map(|t| t.text.clone());
        match text {
            Some(text) => {
                self.at += 1;
                Ok(text)
            }
            None => Err(self.unexpected("heading", "put the heading between quotation marks", &[])),
        }
    }
}
