//! What hangs on nouns and verbs by prepositions.

use super::heads::{SIZES, START_OF_MOTION, VERTICAL};
use super::is_body;
use super::lexicon::{Class, Entry};
use super::phrase::NOUNS;
use super::reader::{Read, Reader};
use super::statement::{NounPhrase, Slot, Statement, Term};
use super::words::Kind;

impl<'a> Reader<'a> {
    /// "the point where the disc touches the floor" is their contact point.
    pub(crate) fn point_where(&mut self, phrase: &mut NounPhrase) -> Read<Option<&'a Entry>> {
        if phrase.head != "point" || !self.take("where") {
            return Ok(None);
        }
        let start = self.at;
        let subjects = self.deeper(Self::terms)?;
        let verb = self.take_entry(&[Class::Verb]);
        let lexicon = self.lexicon;
        let noun = verb
            .and_then(|verb| lexicon.entry(verb.entry.name, &[Class::Where]))
            .and_then(|rule| lexicon.entry(rule.slots.first()?.0, &NOUNS));
        let Some(noun) = noun else {
            self.at = start;
            return Err(self.error(
                "no point is known by what happens there",
                "`where … touches …` or `where … acts` could stand here",
            ));
        };
        phrase.head = noun.name;
        phrase
            .slots
            .extend(subjects.into_iter().map(|term| (Slot::Of, term)));
        if self.starts_term() {
            let objects = self.deeper(Self::terms)?;
            phrase
                .slots
                .extend(objects.into_iter().map(|term| (Slot::On, term)));
        }
        Ok(Some(noun))
    }

    /// What hangs on a noun or a verb by prepositions. What the entry does not take is left to what stands around it.
    pub(crate) fn slots(&mut self, entry: &Entry, slots: &mut Vec<(Slot, Term)>) -> Read<()> {
        let outer = self.owner.clone();
        let mut last: Option<(&'static str, Slot)> = None;
        loop {
            let start = self.at;
            let comma = self.take_sign(Kind::Comma);
            let and = self.take("and");
            if self.at_extent() {
                self.at = start;
                break;
            }
            let Some(found) = self.take_entry(&[Class::Preposition]) else {
                self.at = start;
                break;
            };
            let name = found.entry.name;
            let again =
                last.filter(|(before, _)| *before == name || before.ends_with(&format!(" {name}")));
            // "relative to E and relative to S" says it of two in turn.
            let in_plane = entry.class == Class::Verb && name == "in";
            if !(and && again.is_some() || in_plane) {
                about_first(entry, name, slots);
            }
            let slot = match again {
                Some((_, slot)) if and || comma => Some(slot),
                _ if and => None,
                _ => entry.slot(name).and_then(|slot| free(slot, name, slots)),
            };
            let of_verb = entry.class == Class::Place && slot == Some(Slot::At) && self.at_rate();
            let Some(slot) = slot.filter(|_| !of_verb) else {
                self.at = start;
                break;
            };
            // "of mass $m$" says whose nothing is
            let size = |term: &Term| match term {
                Term::Phrase(phrase) => self.lexicon.entry(phrase.head, &[Class::Noun]).is_some(),
                _ => false,
            };
            let sized = entry.class == Class::Thing;
            let of = slots
                .iter()
                .filter(|(s, term)| matches!(s, Slot::Of | Slot::Upon) && !(sized && size(term)));
            self.owner = of.map(|(_, term)| term.clone()).collect();
            if self.owner.is_empty() {
                self.owner.clone_from(&outer);
            }
            let sizes = self.sizes(entry, slot);
            let (slot, terms) = match sizes.is_empty() {
                true => (slot, self.deeper(|reader| reader.in_slot(slot))?),
                false => (Slot::Of, sizes),
            };
            slots.extend(terms.into_iter().map(|term| (slot, term)));
            last = Some((again.map_or(name, |(before, _)| before), slot));
        }
        self.owner = outer;
        Ok(())
    }

    /// "with the mass `$m$` and the radius `$r$`" behind a thing: its sizes.
    fn sizes(&mut self, entry: &Entry, slot: Slot) -> Vec<Term> {
        let mut sizes = vec![];
        if entry.class != Class::Thing || !matches!(slot, Slot::Of | Slot::With) {
            return sizes;
        }
        let start = self.at;
        let mut behind = self.at;
        while let Some(size) = self.size() {
            sizes.push(size);
            behind = self.at;
            if !self.take_separator() {
                break;
            }
        }
        // A list with other quantities is read as one.
        let others = !sizes.is_empty() && self.at > behind && self.noun_next();
        if others {
            sizes.clear();
        }
        self.at = if others { start } else { behind };
        sizes
    }

    /// "the mass `$m$`", with its article or without.
    fn size(&mut self) -> Option<Term> {
        let start = self.at;
        if self.noun_next()
            && let Ok((size, _)) = self.named()
            && SIZES.contains(&size.head)
            && matches!(size.slots.as_slice(), [(Slot::Which, Term::Formula(_))])
        {
            return Some(Term::Phrase(Box::new(size)));
        }
        self.at = start;
        None
    }

    /// The terms of a slot.
    fn in_slot(&mut self, slot: Slot) -> Read<Vec<Term>> {
        if matches!(slot, Slot::At | Slot::By)
            && let Some(measure) = self.measure()
        {
            return Ok(vec![measure]);
        }
        let terms = self.terms_alike()?;
        let particles = slot == Slot::Of && !self.particles;
        if particles && (self.take("as particles") || self.take("as a particle")) {
            self.particles = true;
            let start = self.at;
            let mut particles = vec![];
            for part in terms {
                self.at = start;
                self.owner = vec![part.clone()];
                let mut slots = vec![(Slot::Of, part)];
                if let Some(entry) = self.lexicon.entry("particle", &[Class::Thing]) {
                    self.slots(entry, &mut slots)?;
                }
                particles.push(Term::Phrase(Box::new(NounPhrase::new("particle", slots))));
            }
            self.particles = false;
            return Ok(particles);
        }
        Ok(terms)
    }

    /// "the angle `$\theta$`", "the constant rate `$\Omega$`": what follows hangs on the verb again.
    fn measure(&mut self) -> Option<Term> {
        let start = self.at;
        if self.kind() == Some(Kind::Word)
            && let Ok((mut phrase, entry)) = self.named()
            && entry.class == Class::Noun
            && phrase.slot(Slot::Which).is_some()
        {
            phrase.slots.extend(self.reckoned_from_vertical());
            return Some(Term::Phrase(Box::new(phrase)));
        }
        self.at = start;
        None
    }

    /// Whether the rate of a turn comes next: it hangs on what turns, and on no axis.
    fn at_rate(&mut self) -> bool {
        let start = self.at;
        let measure = self.measure();
        self.at = start;
        matches!(measure, Some(Term::Phrase(rate)) if rate.head == "rate")
    }

    /// "from the downward vertical", behind an angle: what else something turns from hangs on the verb.
    fn reckoned_from_vertical(&mut self) -> Option<(Slot, Term)> {
        let start = self.at;
        if self.take("from")
            && let Ok(terms) = self.deeper(Self::terms_alike)
            && let [Term::Phrase(vertical)] = terms.as_slice()
            && vertical.head == VERTICAL
        {
            return terms
                .into_iter()
                .next()
                .map(|term| (Slot::RelativeTo, term));
        }
        self.at = start;
        None
    }

    /// "without slipping", "at `$t = 0$`", "for any frames X and Y", at the end of a clause.
    pub(crate) fn tail(&mut self, entry: &Entry, slots: &mut Vec<(Slot, Term)>) -> Read<()> {
        // a body that something is said to be has a place as well
        let lie = self.lexicon.entry("lie", &[Class::Verb]);
        let placed = lie.filter(|_| entry.class == Class::Thing);
        loop {
            if let Some(lie) = placed {
                self.slots(lie, slots)?;
            }
            let start = self.at;
            if self.take_sign(Kind::Comma) && self.find(&[Class::Meaning]).is_some() {
                self.at = start;
                return Ok(());
            }
            if let Some(adverb) = self.take_entry(&[Class::Adverb]) {
                let mut phrase = NounPhrase::new(adverb.entry.name, vec![]);
                if let Some(slot) = adverb.entry.slot("object") {
                    let terms = self.terms_alike()?;
                    phrase
                        .slots
                        .extend(terms.into_iter().map(|term| (slot, term)));
                }
                slots.push((Slot::With, Term::Phrase(Box::new(phrase))));
                self.slots(entry, slots)?;
                continue;
            }
            if let Some(condition) = self.condition()? {
                slots.push((Slot::At, condition));
                continue;
            }
            let any = self
                .find(&[Class::Preposition])
                .filter(|f| f.entry.name == "for any");
            let Some(any) = any else {
                self.at = start;
                self.take_sign(Kind::Comma);
                if !self.take("respectively") {
                    self.at = start;
                }
                return Ok(());
            };
            self.at += any.length;
            self.take_entry(&NOUNS);
            let letters = self.terms()?;
            let letters = letters.into_iter().map(name_of_any);
            slots.extend(letters.map(|letter| (Slot::ForAny, letter)));
        }
    }

    /// "the start", behind "at".
    fn start_of_motion(&mut self) -> Option<Term> {
        let from = self.at;
        self.take("the");
        let noun = self.take_entry(&NOUNS);
        if noun.is_some_and(|found| found.entry.name == START_OF_MOTION) {
            let phrase = NounPhrase::new(START_OF_MOTION, vec![]);
            return Some(Term::Phrase(Box::new(phrase)));
        }
        self.at = from;
        None
    }

    /// "at `$t = 0$`", "when `$t = 0$`", "at the start".
    fn condition(&mut self) -> Read<Option<Term>> {
        let at = self
            .find(&[Class::Preposition])
            .filter(|f| f.entry.name == "at");
        let Some(at) = at else { return Ok(None) };
        let start = self.at;
        self.at += at.length;
        if let Some(begin) = self.start_of_motion() {
            return Ok(Some(begin));
        }
        let mut formulas = self.formulas();
        if formulas.len() != 1 {
            self.at = start;
            return Ok(None);
        }
        Ok(formulas.pop().map(Term::Formula))
    }

    /// Conditions with which a clause begins.
    pub(crate) fn conditions(&mut self) -> Read<Vec<Term>> {
        let mut conditions = vec![];
        while let Some(condition) = self.condition()? {
            conditions.push(condition);
            self.take_sign(Kind::Comma);
        }
        Ok(conditions)
    }

    /// Says of a statement when it holds.
    pub(crate) fn limit(&self, statement: &mut Statement, conditions: &[Term]) -> Read<()> {
        if conditions.is_empty() {
            return Ok(());
        }
        let at = conditions.iter().map(|term| (Slot::At, term.clone()));
        match statement {
            Statement::Is { what, .. } | Statement::Premise(what) => what.slots.extend(at),
            Statement::Does { slots, .. } | Statement::LineHolds { slots, .. } => slots.extend(at),
            Statement::Holds(formula) => {
                *statement = Statement::Does {
                    subjects: vec![Term::Formula(formula.clone())],
                    verb: "hold",
                    slots: at.collect(),
                };
            }
            Statement::Same { subjects, others } if subjects.len() == 1 && others.len() == 1 => {
                let mut alike = std::mem::take(subjects);
                alike.append(others);
                *statement = Statement::Is {
                    subjects: alike,
                    what: NounPhrase::new("same", at.collect()),
                };
            }
            _ => {
                let help = "say it of a formula or of a thing";
                return Err(self.error("this cannot hold under a condition", help));
            }
        }
        Ok(())
    }
}

/// The slot that a preposition fills if another term stands in its own: "the moment on the body about G, on B".
fn free(slot: Slot, preposition: &str, slots: &[(Slot, Term)]) -> Option<Slot> {
    let taken = |slot: Slot| slots.iter().any(|(s, _)| *s == slot);
    match slot {
        _ if !taken(slot) => Some(slot),
        Slot::Upon if !taken(Slot::On) => Some(Slot::On),
        // "it turns relative to N in a vertical plane"
        Slot::RelativeTo if preposition == "in" && !taken(Slot::In) => Some(Slot::In),
        _ => None,
    }
}

/// "with respect to O, as seen from N": of two, the first says about which point.
fn about_first(entry: &Entry, preposition: &str, slots: &mut [(Slot, Term)]) {
    let about = entry
        .slot("about")
        .filter(|about| slots.iter().all(|(s, _)| s != about));
    let relative = Some(Slot::RelativeTo);
    if let Some(about) = about
        && entry.slot(preposition) == relative
        && let Some((slot, _)) = slots.iter_mut().find(|(s, _)| Some(*s) == relative)
    {
        *slot = about;
    }
}

/// "any point Y" in a list: the name alone.
fn name_of_any(term: Term) -> Term {
    match term {
        Term::Phrase(phrase) if phrase.is("any") && phrase.slots.len() == 1 => {
            let name = phrase.slot(Slot::Which).cloned();
            name.unwrap_or(Term::Phrase(phrase))
        }
        other => other,
    }
}

/// "The force of the smooth rail on the rod at P": what stands behind whose load it is hangs on the load.
pub(super) fn leave_to_load(entry: &Entry, load: &mut NounPhrase) {
    if !entry.is_load() || load.slot(Slot::Upon).is_some() {
        return;
    }
    let Some((_, Term::Phrase(agent))) = load.slots.iter_mut().find(|(s, _)| *s == Slot::Of) else {
        return;
    };
    if !is_body(agent.head) || agent.slot(Slot::On).is_none() {
        return;
    }
    let own = |slot: &Slot| matches!(slot, Slot::Of | Slot::Which | Slot::FixedIn | Slot::With);
    let (kept, left): (Vec<_>, Vec<_>) = std::mem::take(&mut agent.slots)
        .into_iter()
        .partition(|(slot, _)| own(slot));
    agent.slots = kept;
    let upon = |(slot, term): (Slot, Term)| match slot {
        Slot::On => (Slot::Upon, term),
        slot => (slot, term),
    };
    load.slots.extend(left.into_iter().map(upon));
}
