//! A document is checked without a panic, each line gets its verdict, and the same text gets the same ones.
//!
//! `cargo +nightly fuzz run check -- -timeout=30 -max_len=4096`

#![no_main]

use libfuzzer_sys::fuzz_target;
use polhode::notation::{document::Format, read};
use polhode::verify::check;

fuzz_target!(|text: &str| {
    let (document, _) = read("fuzz.md", text, Format::Markdown);
    let (one, two) = (check(&document), check(&document));
    assert_eq!(one.findings.len(), two.findings.len());
    for (a, b) in one.findings.iter().zip(&two.findings) {
        assert_eq!(a.verdict, b.verdict);
    }
});
