//! What `polhode help language` shows.

use super::lexicon::{Class, Lexicon};

/// The grammar in examples.
const GRAMMAR: &str = include_str!("manual.md");

/// The headings of the lexicon, in the order in which they are shown.
const KINDS: [(Class, &str); 11] = [
    (Class::Noun, "Quantities"),
    (Class::Place, "Points, frames and axes"),
    (Class::Thing, "Bodies"),
    (Class::Adjective, "Adjectives"),
    (Class::Verb, "Verbs"),
    (Class::Passive, "Verbs behind \"is\""),
    (Class::Adverb, "Ends of a sentence"),
    (Class::Preposition, "Prepositions"),
    (Class::Mark, "Marks"),
    (Class::Custom, "Customs of notation"),
    (Class::Meaning, "What marks and customs may mean"),
];

/// The manual of the language in Markdown: its sentences and all its words.
pub fn manual(lexicon: &Lexicon) -> String {
    let mut text = GRAMMAR.to_owned();
    for (class, heading) in KINDS {
        text.push_str(&format!("\n## {heading}\n\n"));
        for entry in lexicon
            .entries()
            .iter()
            .filter(|entry| entry.class == class)
        {
            text.push_str(&format!("- {}", entry.name));
            let others: Vec<String> = lexicon
                .synonyms(entry)
                .into_iter()
                .filter(|form| !form.eq_ignore_ascii_case(entry.name))
                .collect();
            if !others.is_empty() {
                text.push_str(&format!(", also {}", others.join(", ")));
            }
            let mut taken: Vec<String> = vec![];
            for (preposition, _) in &entry.slots {
                let words = lexicon.words_of(preposition);
                if class != Class::Preposition && words != "object" && !taken.contains(&words) {
                    taken.push(words);
                }
            }
            if !taken.is_empty() {
                text.push_str(&format!(" ({} …)", taken.join(" …, ")));
            }
            text.push('\n');
        }
    }
    text
}
