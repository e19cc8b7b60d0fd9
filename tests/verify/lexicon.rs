//! The words of the language as they stand in their file: what the library asks for is there, and no more is said there
//! than it knows.

use polhode::mechanics::Shape;

const LEXICON: &str = include_str!("../../src/verify/language/lexicon.txt");
const FLAGS: &str = include_str!("../../src/verify/language/traits.rs");
const SHAPES_READ: &str = include_str!("../../src/verify/reading/shapes_read.rs");
const HEADS: &str = include_str!("../../src/verify/language/heads.rs");

/// An entry: its name is the first of its forms.
struct Entry {
    name: &'static str,
    flags: Vec<&'static str>,
}

impl Entry {
    fn is(&self, flag: &str) -> bool {
        self.flags.contains(&flag)
    }
}

fn entries() -> Vec<Entry> {
    let lines = LEXICON.lines().map(str::trim);
    let entry = |line: &'static str| {
        let (kind, rest) = line.split_once(' ')?;
        let (forms, rest) = rest.split_once(':').unwrap_or((rest, ""));
        let (_, flags) = rest.split_once(';').unwrap_or((rest, ""));
        (kind != "group").then(|| Entry {
            name: forms.split(['|', ',']).next().unwrap_or(forms).trim(),
            flags: flags.split_whitespace().collect(),
        })
    };
    let entries: Vec<_> = lines
        .filter(|line| !line.starts_with('#'))
        .filter_map(entry)
        .collect();
    assert!(entries.len() > 500, "{} entries", entries.len());
    entries
}

/// The string literals between two pieces of a source text.
fn literals(source: &'static str, from: &str, to: &str) -> Vec<&'static str> {
    let (_, behind) = source.split_once(from).expect("its beginning");
    let (inside, _) = behind.split_once(to).expect("its end");
    let code = inside
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"));
    let found: Vec<_> = code
        .flat_map(|line| line.split('"').skip(1).step_by(2))
        .collect();
    assert!(!found.is_empty(), "no literal behind {from}");
    found
}

#[test]
fn each_noun_and_verb_that_is_asked_for_has_an_entry() {
    let entries = entries();
    let heads = literals(HEADS, "\nheads! {", "\n}\n");
    let adverbs = literals(HEADS, "const PLAIN_ADVERBS: [&str; 2] = [", "];");
    for head in heads.into_iter().chain(adverbs) {
        assert!(entries.iter().any(|entry| entry.name == head), "{head}");
    }
}

#[test]
fn each_flag_is_known() {
    let known = literals(FLAGS, "const WRITTEN:", "];");
    for entry in entries() {
        for flag in &entry.flags {
            assert!(known.contains(flag), "{}: {flag}", entry.name);
        }
    }
}

#[test]
fn the_flags_of_shapes_agree() {
    let of_shape = [
        "round",
        "rim",
        "ball",
        "flat",
        "slender",
        "apex",
        "one-sided",
        "hollow",
        "right",
    ];
    for entry in entries() {
        let name = entry.name;
        if !entry.is("shape") {
            let is_shape = of_shape.iter().any(|flag| entry.is(flag));
            assert!(!is_shape, "{name} is no shape");
        }
        assert!(
            !entry.is("rim") || entry.is("round"),
            "{name} has a rim and is not round"
        );
        let lines = ["ball", "round", "slender"].into_iter();
        let lines = lines.filter(|flag| entry.is(flag)).count();
        assert!(lines < 2, "{name} is round in two ways");
        assert!(
            !entry.is("apex") || entry.is("one-sided"),
            "{name} has an apex on one side"
        );
    }
}

/// One number of a kind is told behind the noun, "a cone of radius `$r$` and height `$h$`"; where there are several, the
/// reader must know how a sentence tells them apart.
#[test]
fn each_shape_has_its_tensor_in_the_table() {
    let told_otherwise = literals(SHAPES_READ, "\nfn way_told(", "=> Told::InOne");
    for entry in entries().iter().filter(|entry| entry.is("shape")) {
        let noun = entry.name;
        // Halves have a hyphen in words: sentences tell no more of them than their names.
        let known = Shape::by_name(&noun.replace('-', " "));
        let shape = known.unwrap_or_else(|| panic!("{noun} is not in the table"));
        let several = shape.sizes().iter().any(|s| s.count > 1 && !s.is_place);
        assert!(
            !several || told_otherwise.contains(&noun),
            "no sentence tells the sizes of {noun}"
        );
    }
}
