//! The verifier: documents with their verdicts, the corpus of known truth, mutants, and what stands beside a verdict.
#![cfg(feature = "verify")]

mod common {
    pub(crate) mod documents;
}

mod verify {
    mod corpus;
    mod cues;
    mod derivations;
    mod documents;
    mod either;
    mod findings;
    mod invariance;
    mod known_truth;
    mod language;
    mod lexicon;
    mod many_lines;
    mod mutants;
    mod numbers;
    mod rejected;
    mod relations;
    mod systems;
    mod ways;
    mod wordings;
    mod words;
    mod wrong_verdicts;
}
