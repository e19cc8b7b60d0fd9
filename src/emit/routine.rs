//! What a piece of code takes and returns, and the recorded operations between the two.

use crate::emit::Request;
use crate::emit::equations::Given;
use crate::emit::graph::{Graph, Symbol, record};

/// A number by its name in code and in LaTeX.
#[derive(Clone, Debug)]
pub(super) struct Letter {
    pub(super) code: String,
    pub(super) latex: String,
}

/// What is given: a vector, or a single number.
#[derive(Clone, Debug)]
pub(super) struct Argument {
    pub(super) name: &'static str,
    pub(super) about: String,
    pub(super) letters: Vec<Letter>,
    pub(super) is_number: bool,
}

/// What is returned: a vector where there are no columns, a matrix row by row else.
#[derive(Clone, Debug)]
pub(super) struct Output {
    pub(super) name: &'static str,
    pub(super) about: &'static str,
    pub(super) rows: Vec<Letter>,
    pub(super) columns: Vec<Letter>,
    pub(super) entries: Vec<Symbol>,
}

/// Code of no language yet.
#[derive(Debug)]
pub(super) struct Routine {
    pub(super) graph: Graph,
    pub(super) arguments: Vec<Argument>,
    pub(super) outputs: Vec<Output>,
}

impl Routine {
    pub(super) fn new(request: &Request) -> Self {
        let (graph, (arguments, outputs)) = record(|| {
            let mut given = Given::new(request);
            let outputs = given.outputs();
            (given.arguments, outputs)
        });
        Self {
            graph,
            arguments,
            outputs,
        }
    }
}

pub(super) fn vector(
    name: &'static str,
    about: &'static str,
    rows: &[Letter],
    entries: &[Symbol],
) -> Output {
    Output {
        name,
        about,
        rows: rows.to_vec(),
        columns: vec![],
        entries: entries.to_vec(),
    }
}

pub(super) fn matrix<'a>(
    name: &'static str,
    about: &'static str,
    (rows, columns): ([Letter; 3], Vec<Letter>),
    entries: impl Iterator<Item = &'a [Symbol]> + Clone,
) -> Output {
    let row = |r: usize| entries.clone().map(move |column| column[r]);
    Output {
        name,
        about,
        entries: (0..3).flat_map(row).collect(),
        rows: rows.into(),
        columns,
    }
}

pub(super) fn plain(name: &str) -> Letter {
    Letter {
        code: name.to_owned(),
        latex: name.to_owned(),
    }
}

/// A component; a prime behind the stem says that it is the one after a step.
pub(super) fn letter(stem: &str, index: &str) -> Letter {
    let (stem, prime) = match stem.strip_suffix('\'') {
        Some(stem) => (stem, "'"),
        None => (stem, ""),
    };
    let latex = match stem {
        "w" => "\\omega",
        "a" => "\\dot\\omega",
        "theta" => "\\theta",
        "i" => "I",
        "m" => "M",
        other => other,
    };
    Letter {
        code: format!("{stem}_{index}{prime}"),
        latex: format!("{latex}{prime}_{{{index}}}"),
    }
}

pub(super) fn three(stem: &str) -> [Letter; 3] {
    ["x", "y", "z"].map(|index| letter(stem, index))
}
