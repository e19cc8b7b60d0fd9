//! Parts of a system that are spoken of together alone: "the spacecraft consists of the body and the devices".

use super::heads::{ANGULAR_MOMENTUM, KINETIC_ENERGY, MOMENTUM};
use super::statement::{Declaration, Slot, Statement, Term};

/// Quantities of several bodies that are those of one: the sums over them.
const SUMS: [&str; 3] = [ANGULAR_MOMENTUM, MOMENTUM, KINETIC_ENERGY];

/// A plural of which sentences tell only sums, and no member, is one body.
pub(crate) fn join_uncounted(declarations: &mut [Declaration]) {
    let parts = declarations
        .iter()
        .filter_map(|d| d.statement.does("consist"));
    let parts = parts.flat_map(|(_, slots)| slots.iter().map(|(_, part)| part));
    let plurals: Vec<String> = parts.filter_map(plural).collect();
    for plural in plurals {
        let Some(single) = plural.strip_suffix('s') else {
            continue;
        };
        let summed = declarations
            .iter()
            .all(|d| speaks_of_sum(&d.statement, &plural));
        let member = |term: &Term| match term {
            Term::Member { family, .. } => family == single,
            Term::Name(name) => {
                let index = name.strip_prefix(single);
                index.is_some_and(|index| index.is_empty() || index.starts_with(' '))
            }
            _ => false,
        };
        let mut terms = declarations.iter().flat_map(|d| d.statement.terms());
        if !summed || terms.any(member) {
            continue;
        }
        for declaration in declarations.iter_mut() {
            for term in declaration.statement.terms_mut() {
                if *term == Term::Name(plural.clone()) {
                    *term = Term::Name(single.to_owned());
                }
            }
        }
    }
}

/// The name of a part that ends as a plural does.
fn plural(part: &Term) -> Option<String> {
    match part {
        Term::Name(name) if name.ends_with('s') && !name.ends_with("ss") => {
            let word = name.len() > 3 && name.chars().all(|c| c.is_lowercase() || c == ' ');
            word.then(|| name.clone())
        }
        _ => None,
    }
}

/// Whether a sentence says of a plural no more than that it is a part, or what a sum over it is.
fn speaks_of_sum(statement: &Statement, plural: &str) -> bool {
    let own = |term: &&Term| matches!(term, Term::Name(name) if name == plural);
    let all = statement.terms().into_iter().filter(own).count();
    let allowed = match statement {
        Statement::Does {
            verb: "consist",
            slots,
            ..
        } => slots.iter().map(|(_, part)| part).filter(own).count(),
        Statement::Is { what, .. } if SUMS.contains(&what.head) => {
            what.all(Slot::Of).filter(own).count()
        }
        _ => 0,
    };
    all == allowed
}
