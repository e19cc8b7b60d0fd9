//! What a sentence of which nothing was made may bear on: what other sentences connect with the things that it names.

use crate::verify::language::is_body;
use crate::verify::language::statement::{Declaration, Statement, Term};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{name_of, node_of};
use crate::verify::reading::unused::Unused;
use crate::verify::reading::unused_letters::letters_of;
use crate::verify::term::letters::spelled;
use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

/// What sentences name: things by their names, letters as they are spelled.
type Named = BTreeSet<String>;

impl Builder<'_> {
    /// A sentence of which nothing was made, and that says what letters are, bears on what others say of these: a magnitude of
    /// a letter of which nothing is known may be that of anything.
    fn widen_by_what_hangs(&mut self) {
        let told = |d: &Declaration| match &d.statement {
            Statement::Is { subjects, what } => {
                let own = subjects.iter().flat_map(letters_in_term);
                let of = what.slots.iter().flat_map(|(_, of)| letters_in_term(of));
                Some((own.collect::<Named>(), of.collect::<Named>()))
            }
            _ => None,
        };
        let told: Vec<(Named, Named)> = self.declarations.iter().filter_map(told).collect();
        for unused in &mut self.reading.unused {
            let Some(letters) = &mut unused.letters else {
                continue;
            };
            let mut grows = true;
            while grows {
                let before = letters.len();
                for (own, of) in &told {
                    if !letters.is_disjoint(of) {
                        letters.extend(own.iter().cloned());
                    }
                }
                grows = letters.len() > before;
            }
        }
    }

    /// Keeps sentences that were understood, and of which nothing was made, to the letters that are connected with them;
    /// `conditional` are those that hold under a condition.
    pub(super) fn connect_unused(&mut self, conditional: &[Declaration]) {
        self.widen_by_what_hangs();
        let waits = |u: &Unused| u.understood && !u.beyond && u.letters.is_none();
        if !self.reading.unused.iter().any(waits) {
            return;
        }
        let all = || self.declarations.iter().chain(conditional);
        let named: Vec<Named> = all().map(|d| self.named_in(d)).collect();
        let letters = by_component(&named);
        // A sentence that says several things bears on what any of them names.
        let mut of_sentence: HashMap<&str, Vec<Arc<Named>>> = HashMap::new();
        for (declaration, named) in all().zip(&named) {
            // What one declaration names is connected by it.
            let own = named.iter().find_map(|name| letters.get(name.as_str()));
            let known = of_sentence.entry(declaration.sentence()).or_default();
            let own = own.filter(|own| !known.iter().any(|known| Arc::ptr_eq(known, own)));
            known.extend(own.cloned());
        }
        for unused in self.reading.unused.iter_mut().filter(|u| waits(u)) {
            let own = of_sentence.get(unused.sentence.as_str());
            unused.connected = own.filter(|own| !own.is_empty()).cloned();
        }
    }

    /// The things and letters of a sentence. All things are connected with the inertial frame, so it connects none.
    fn named_in(&self, declaration: &Declaration) -> Named {
        let ground = self.reading.system.ground;
        let is_ground = |name: &str| {
            let axis = self
                .axes
                .get(name)
                .is_some_and(|&(frame, _)| frame == ground);
            axis || self.frames.get(name) == Some(&ground)
        };
        let statement = &declaration.statement;
        let terms = statement.terms().into_iter();
        let name = |term: &Term| match term {
            Term::Member { family, .. } => Some(family.clone()),
            // A kind of body is one as well: "the body is a cube" says it of the cube.
            Term::Phrase(phrase) => is_body(phrase.head).then(|| phrase.head.to_owned()),
            term => name_of(term),
        };
        let mut all: Vec<String> = terms.filter_map(name).collect();
        if let Statement::Is { what, .. } | Statement::Premise(what) = statement
            && is_body(what.head)
        {
            all.push(what.head.to_owned());
        }
        let one = |name: &String| name.strip_suffix('s').map(str::to_owned);
        all.extend(all.iter().filter_map(one).collect::<Vec<_>>());
        let mut named: Named = all.into_iter().filter(|n| !is_ground(n)).collect();
        if let Statement::Holds(formula)
        | Statement::Means {
            meaning: formula, ..
        } = statement
        {
            named.extend(letters_of(formula));
        }
        for term in statement.terms() {
            if let Term::Formula(formula) = term {
                named.extend(letters_of(formula).into_iter().filter(|l| !is_ground(l)));
                named.extend(node_of(formula).map(spelled).filter(|l| !is_ground(l)));
            }
        }
        named
    }
}

/// The letters of a term that is a formula or on which one hangs.
fn letters_in_term(term: &Term) -> Named {
    match term {
        Term::Formula(formula) => letters_of(formula),
        Term::Phrase(phrase) => {
            let inner = phrase.slots.iter();
            inner.flat_map(|(_, of)| letters_in_term(of)).collect()
        }
        _ => Named::new(),
    }
}

/// The names with which each is connected through sentences, in sets that they share.
fn by_component(named: &[Named]) -> HashMap<&str, Arc<Named>> {
    let mut component: HashMap<&str, usize> = HashMap::new();
    let mut members: Vec<BTreeSet<&str>> = vec![];
    for names in named {
        let known = names.iter().filter_map(|name| component.get(name.as_str()));
        let known: BTreeSet<usize> = known.copied().collect();
        // The others go over into the largest one.
        let largest = known.iter().copied().max_by_key(|&at| members[at].len());
        let at = largest.unwrap_or(members.len());
        if largest.is_none() {
            members.push(BTreeSet::new());
        }
        let others = known.into_iter().filter(|&other| other != at);
        let mut new: BTreeSet<&str> = names.iter().map(String::as_str).collect();
        others.for_each(|other| new.extend(std::mem::take(&mut members[other])));
        for name in new {
            component.insert(name, at);
            members[at].insert(name);
        }
    }
    let owned = |names: BTreeSet<&str>| Arc::new(names.into_iter().map(str::to_owned).collect());
    let shared: Vec<Arc<Named>> = members.into_iter().map(owned).collect();
    let all = component.into_iter();
    all.map(|(name, at)| (name, shared[at].clone())).collect()
}
