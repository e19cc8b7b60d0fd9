//! Where forces act: "The force of the wheel on the body acts at A" says it of that force wherever it is spoken of, and of its
//! opposite.

use super::heads::FORCE;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term, slot};

/// A force of one thing on another, and the point where it acts.
struct Acting {
    agent: Term,
    on: Term,
    at: Term,
}

/// Puts the point into each phrase that names the force; then nothing is left of the sentence that told it.
pub(crate) fn tell_where_forces_act(declarations: &mut Vec<Declaration>) {
    let told = (0..declarations.len()).filter_map(|at| Some((at, acting(at, declarations)?)));
    for (at, force) in told.collect::<Vec<_>>().into_iter().rev() {
        let others = declarations.iter_mut().enumerate();
        let others = others.filter(|(other, _)| *other != at);
        let spoken = others.map(|(_, d)| force.put_into(&mut d.statement));
        if spoken.fold(false, |any, spoken| any | spoken) {
            declarations.remove(at);
        }
    }
}

/// "The force of the wheel acts on the body at A", or "`F` acts at A", where another sentence says of what on what `F` is.
fn acting(at: usize, declarations: &[Declaration]) -> Option<Acting> {
    let declaration = declarations.get(at)?;
    if declaration.extent != Extent::Document {
        return None;
    }
    let (subjects, slots) = declaration.statement.does("act")?;
    let [subject] = subjects else { return None };
    let subject = letter_alone(subject).unwrap_or(subject);
    let force = match subject {
        Term::Phrase(force) => (**force).clone(),
        Term::Formula(_) => declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if *subjects == [subject.clone()] => {
                Some(what.clone()).filter(|what| what.slot(Slot::At).is_none())
            }
            _ => None,
        })?,
        _ => return None,
    };
    let on = force.slot(Slot::Upon).or_else(|| slot(slots, Slot::Of));
    let mut agents = force.all(Slot::Of);
    let agent = agents.next().filter(|_| agents.next().is_none())?;
    // One that has a letter of its own is read as a load by that.
    let plain = force.slot(Slot::Which).is_none() && force.adjectives.is_empty();
    let known = |(slot, _): &(Slot, Term)| matches!(slot, Slot::Of | Slot::At);
    let one = slots.iter().all(known) && slots.len() <= 2 && plain && force.head == FORCE;
    one.then_some(Acting {
        agent: agent.clone(),
        on: on?.clone(),
        at: slot(slots, Slot::At)?.clone(),
    })
}

/// The letter of "the force `F`".
fn letter_alone(subject: &Term) -> Option<&Term> {
    let Term::Phrase(force) = subject else {
        return None;
    };
    match force.slots.as_slice() {
        [(Slot::Which, letter @ Term::Formula(_))] if force.head == FORCE => Some(letter),
        _ => None,
    }
}

impl Acting {
    fn put_into(&self, statement: &mut Statement) -> bool {
        let listed_on = match statement {
            Statement::Premise(list) if list.is("only") => list.slot(Slot::Of).cloned(),
            _ => None,
        };
        let mut spoken = match statement {
            Statement::Is { what, .. } => self.put_at(what, None),
            _ => false,
        };
        for term in statement.terms_mut() {
            if let Term::Phrase(phrase) = term {
                spoken |= self.put_at(phrase, listed_on.as_ref());
            }
        }
        spoken
    }

    /// The point in a phrase that names the force; in a list of loads it is a force on the body whose loads are listed.
    fn put_at(&self, phrase: &mut NounPhrase, listed_on: Option<&Term>) -> bool {
        let pair = (phrase.slot(Slot::Of), phrase.slot(Slot::Upon).or(listed_on));
        let (agent, on) = (Some(&self.agent), Some(&self.on));
        let own = pair == (agent, on) || pair == (on, agent);
        let mut spoken = phrase.head == FORCE && own;
        if spoken && phrase.slot(Slot::At).is_none() {
            phrase.slots.push((Slot::At, self.at.clone()));
        }
        for (_, inner) in &mut phrase.slots {
            if let Term::Phrase(inner) = inner {
                spoken |= self.put_at(inner, None);
            }
        }
        spoken
    }
}
