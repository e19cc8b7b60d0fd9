//! Letters of places that are taken as constant because nothing tells that they change, and what tells that they do.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node};
use crate::verify::language::heads::{SECOND_RATE, WEIGHT};
use crate::verify::language::statement::{
    Declaration, Formula, NotationMeaning, NounPhrase, Sign, Slot, Statement, Term, Touched, slot,
};
use crate::verify::model::system::{FrameId, PointId, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::definitions_read::defined_as;
use crate::verify::reading::names::{letter_of, node_of, nodes_of, told};
use crate::verify::reading::points_read::name_of_particle;
use crate::verify::reading::reactions_read::same_letter;
use crate::verify::term::labels::rate_of;
use crate::verify::term::letters::{letter_names, spelled};
use num_traits::Zero;

/// Nouns of how a point moves.
const MOTIONS: [&str; 3] = ["velocity", "speed", "acceleration"];

impl Builder<'_> {
    /// Whether the document writes the rate of a letter, or a sentence sets it by a formula, or says something of it that is
    /// not worked with: then it may change.
    pub(super) fn has_rate(&self, distance: &Term) -> bool {
        let Some(formula) = letter_of(distance) else {
            return false;
        };
        let defined = |d: &Declaration| defined_as(formula, &d.statement).is_some();
        self.writes_rate(distance)
            || self.declarations.iter().any(defined)
            || self.is_told_to_change(formula)
            || self.is_spoken_of_in_vain(formula)
    }

    /// Whether a sentence speaks of the rate of a letter.
    fn is_told_to_change(&self, letter: &Formula) -> bool {
        let rate_of = |term: &Term| match term {
            Term::Phrase(rate) if ["rate", SECOND_RATE].contains(&rate.head) => rate
                .all(Slot::Of)
                .filter_map(letter_of)
                .any(|of| same_letter(of, letter)),
            _ => false,
        };
        self.declarations.iter().any(|d| {
            let named = match &d.statement {
                Statement::Is { what, .. } => rate_of(&Term::Phrase(Box::new(what.clone()))),
                _ => false,
            };
            let formulas = d.statement.formulas().into_iter();
            let mut nodes = formulas.flat_map(nodes_of);
            named
                || d.statement.terms().into_iter().any(rate_of)
                || node_of(letter).is_some_and(|own| nodes.any(|node| has_rate_of(node, own)))
        })
    }

    /// Whether a sentence says of a letter what is not worked with: that it is not constant, or what was not understood.
    fn is_spoken_of_in_vain(&self, letter: &Formula) -> bool {
        let Some(node) = node_of(letter) else {
            return false;
        };
        let unused = &self.reading.unused;
        let own = letter_names(node);
        let speaks = |d: &Declaration| match &d.statement {
            Statement::Unread {
                touched: Touched::Letters { formulas, .. } | Touched::Written(formulas),
                ..
            } => {
                let mut names = formulas.iter().flat_map(nodes_of).flat_map(letter_names);
                names.any(|name| own.contains(&name))
            }
            _ => false,
        };
        unused.iter().any(|u| u.about.contains(&letter.source))
            || self.declarations.iter().any(speaks)
    }

    /// Whether the document writes the rate of a letter.
    pub(super) fn writes_rate(&self, letter: &Term) -> bool {
        let letter = letter_of(letter).and_then(node_of).map(spelled);
        letter.is_some_and(|letter| {
            let all = &self.reading.letters.written;
            let primed = || all.has(&format!("{letter}'")) || all.has(&format!("{letter}''"));
            all.has(&rate_of(&letter)) || self.primes_are_rates() && primed()
        })
    }

    /// "A prime means the rate."
    fn primes_are_rates(&self) -> bool {
        let mut declarations = self.declarations.iter();
        declarations.any(|d| match &d.statement {
            Statement::Notation {
                sign: Sign::Mark("prime"),
                meaning: NotationMeaning::Noun(noun),
            } => noun.head.ends_with("rate") || noun.head == "derivative",
            _ => false,
        })
    }

    /// A distance of which no rate is written is constant, unless something tells that what lies there moves.
    pub(super) fn make_constant(&mut self, value: &Fraction) {
        for variable in value.variables() {
            self.reading.system.atoms.hold_by_custom(variable);
        }
    }

    /// Letters of places that no sentence tells are constant by custom alone: not those of a point that would so be at rest
    /// in space, where no sentence says that it is fixed, nor those along which a point is said to move.
    pub(super) fn let_places_change(&mut self) {
        for spoken in self.spoken_points() {
            let Some(&point) = self.points.get(&spoken.name) else {
                continue;
            };
            let ground = self.reading.system.ground;
            if spoken.lies.is_some() && !spoken.fixed_in.contains(&ground) {
                let place = self.reading.system.position(point, 0);
                if self.hangs_on_custom(&place) && self.rests(&place, ground) {
                    self.let_change(&place);
                }
            }
        }
        self.let_movers_change();
        self.let_free_particles_change();
        self.let_sliders_change();
    }

    /// What moves, slides or swings along something changes its place along that.
    fn let_sliders_change(&mut self) {
        for declaration in self.declarations {
            let Statement::Does {
                subjects,
                verb: verb @ ("move" | "slide" | "swing"),
                slots,
            } = &declaration.statement
            else {
                continue;
            };
            for subject in subjects {
                // What slides moves along something, whether that is told or not.
                let told = self.way_of_mover(subject, slots, declaration);
                let whole = || self.whole_way(subject).filter(|_| *verb == "slide");
                if let Some(way) = told.or_else(whole) {
                    self.let_change(&way);
                }
            }
        }
    }

    /// What sentences give a velocity or an acceleration relative to a frame is not at rest there by custom.
    fn let_movers_change(&mut self) {
        let ground = self.reading.system.ground;
        let spoken = self.spoken_points();
        let fixed = |point: &Term, frame: FrameId| {
            let name = name_of_particle(point);
            let mut own = spoken.iter().filter(|s| Some(&s.name) == name.as_ref());
            own.any(|s| s.fixed_in.contains(&frame))
        };
        let declarations = self.declarations;
        for phrase in declarations.iter().flat_map(phrases_of) {
            let relative = told(phrase.slot(Slot::RelativeTo), ground, |term| {
                self.frame(term)
            });
            let (true, Some(frame)) = (MOTIONS.contains(&phrase.head), relative) else {
                continue;
            };
            for of in phrase.all(Slot::Of).filter(|of| !fixed(of, frame)) {
                let way = self.point(of).and_then(|point| self.told_place(of, point));
                if let Some(way) = way
                    && self.hangs_on_custom(&way)
                    && self.rests(&way, frame)
                {
                    self.let_change(&way);
                }
            }
        }
    }

    /// A particle on which nothing acts but its weight is held by nothing.
    fn let_free_particles_change(&mut self) {
        let declarations = self.declarations;
        for declaration in declarations {
            let Statement::Premise(premise) = &declaration.statement else {
                continue;
            };
            let weight = |load: &Term| load.is_noun(WEIGHT);
            let loads = matches!(premise.head, "force" | "load");
            let only = premise.adjectives == ["only"] && premise.all(Slot::With).all(weight);
            let none = premise.adjectives == ["no"];
            let plain = |(slot, _): &(Slot, Term)| matches!(slot, Slot::Of | Slot::With);
            if !loads || !(only || none && premise.slot(Slot::With).is_none()) {
                continue;
            }
            for of in premise
                .all(Slot::Of)
                .filter(|_| premise.slots.iter().all(plain))
            {
                let particle = self
                    .body(of)
                    .is_some_and(|body| self.reading.system.bodies[body].frame.is_none());
                if let (true, Some(way)) = (particle, self.whole_way(of)) {
                    self.let_change(&way);
                }
            }
        }
    }

    fn whole_way(&self, subject: &Term) -> Option<Vector> {
        self.told_place(subject, self.point(subject)?)
    }

    /// The part of the way to a point that changes where it is said to move along something, or relative to a frame.
    fn way_of_mover(
        &mut self,
        subject: &Term,
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) -> Option<Vector> {
        let point = self.point(subject)?;
        let way = self.told_place(subject, point)?;
        if let Some(frame) = slot(slots, Slot::RelativeTo).and_then(|term| self.frame(term)) {
            return self.rests(&way, frame).then_some(way);
        }
        // What swings along an axis is said to swing about it, as a body does.
        let along = slot(slots, Slot::Along).or_else(|| slot(slots, Slot::About))?;
        if self.body(along).is_some() {
            return Some(way);
        }
        let along = self.direction(along, declaration, None)?;
        Some(&along * way.dot(&along))
    }

    /// The way to a point from the one that it is said to be placed from.
    fn told_place(&self, subject: &Term, point: PointId) -> Option<Vector> {
        let name = name_of_particle(subject)?;
        let mut said = self.declarations.iter();
        let from = said.find_map(|d| {
            let of = |verb| d.statement.does(verb);
            let (subjects, slots) = of("place").or_else(|| of("lie"))?;
            let own = subjects.iter().filter_map(name_of_particle);
            let from = slot(slots, Slot::From).or_else(|| slot(slots, Slot::RelativeTo))?;
            own.into_iter().any(|own| own == name).then_some(from)
        })?;
        Some(self.reading.system.position(point, self.point(from)?))
    }

    fn hangs_on_custom(&self, place: &Vector) -> bool {
        let mut letters = place.iter().flat_map(Fraction::variables);
        letters.any(|letter| self.reading.system.atoms.is_held_by_custom(letter))
    }

    fn rests(&mut self, place: &Vector, frame: FrameId) -> bool {
        let rate = self.reading.system.rate_seen_from(frame, place);
        rate.iter().all(Zero::is_zero)
    }

    fn let_change(&mut self, way: &Vector) {
        for variable in way.iter().flat_map(Fraction::variables) {
            self.reading.system.atoms.let_change(variable);
        }
    }
}

/// The noun of a sentence, and all that hang on it.
fn phrases_of(declaration: &Declaration) -> impl Iterator<Item = &NounPhrase> {
    let own = match &declaration.statement {
        Statement::Is { what, .. } | Statement::Premise(what) => Some(what),
        _ => None,
    };
    let terms = declaration.statement.terms().into_iter();
    let hanging = terms.filter_map(|term| match term {
        Term::Phrase(phrase) => Some(phrase.as_ref()),
        _ => None,
    });
    own.into_iter().chain(hanging)
}

/// Whether a formula has the rate of a letter.
fn has_rate_of(node: &Node, letter: &Node) -> bool {
    let own = match &node.kind {
        Kind::TimeDerivative { operand, .. } => spelled(operand) == spelled(letter),
        _ => false,
    };
    own || node.children().any(|child| has_rate_of(child, letter))
}
