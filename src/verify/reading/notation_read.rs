//! Rules for marks, labels and operators.

use crate::notation::ast::Kind;
use crate::verify::language::heads::{
    COLUMN_BY_COLUMN, COLUMN_OF_VECTORS, COLUMNS_OF_TWO, CROSS_WITH_MATRIX, DECIMAL_NUMBERS,
    DOT_OF_MATRICES, FRAME_ABOVE, FRAME_BEFORE_RATE, FRAME_ON_BRACKETS, IDENTITY_MATRIX, INSTANT,
    LIST, MATRIX_PRODUCT, NOT_SUMMED, NOTHING, NUMBER_BESIDE_MATRIX, QUATERNION_DOT,
    RATE_FROM_FRAME, ROWS_OF_MATRIX, TENSOR_PRODUCT, TIMES_IDENTITY, UNDERBRACE,
    VECTORS_SIDE_BY_SIDE,
};
use crate::verify::language::rate_letters::rate_letter;
use crate::verify::language::statement::{
    Declaration, Formula, NotationMeaning, NounPhrase, Sign, Slot, Statement, Term, slot,
};
use crate::verify::model::blows::Side;
use crate::verify::reading::blows_read::side;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::customary_notation::{is_custom, plain_label};
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::{
    CROSS_PRODUCT_MATRIX, are_products, index_letter, is_letter, name_of, node_of, reach_of,
};
use crate::verify::reading::operators_read::{component_of_cross, is_quaternion_product};
use crate::verify::term::labels::plain;
use crate::verify::term::letters::{
    Arguments, Effect, IndexRule, LabelRule, Mark, MarkRule, Reach, spelled,
};

/// The signs of a dot between factors.
const DOTS: [&str; 2] = ["\\cdot", "·"];

impl Builder<'_> {
    /// Takes in the rules of notation.
    pub(super) fn read_notation(&mut self) {
        for declaration in self.declarations {
            match &declaration.statement {
                Statement::Notation { sign, meaning } => self.read_rule(sign, meaning, declaration),
                Statement::Does {
                    subjects,
                    verb: "number",
                    slots,
                } => {
                    if let Some(Term::Phrase(axes)) = slot(slots, Slot::Of)
                        && axes.head == "axes"
                    {
                        let frame = axes.slot(Slot::Of).and_then(|term| self.frame(term));
                        self.number_axes(subjects, frame.unwrap_or(0), declaration);
                    }
                    self.number_things(subjects, slots, declaration);
                }
                Statement::Is { subjects, what } => {
                    self.read_convention(subjects, what);
                    if what.head == IDENTITY_MATRIX && subjects.iter().any(is_one) {
                        let reach = reach_of(&declaration.extent);
                        let products = &mut self.reading.letters.customs.products;
                        products.numbers_beside_matrices.push(reach);
                    }
                }
                _ => {}
            }
        }
        self.number_by_labels();
    }

    /// "`I_{ij}` is entry (i, j) of `I` on B": letters that no sentence tells of number the axes.
    fn number_by_labels(&mut self) {
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            let count = match what.head {
                "entry" => 2,
                "component" => 1,
                _ => continue,
            };
            let inner = what.slot(Slot::Of).and_then(|of| match of {
                Term::Phrase(phrase) => phrase.slot(Slot::On),
                _ => None,
            });
            let on = what.slot(Slot::On).or(inner);
            let frame = match on.and_then(|term| self.frame(term)) {
                Some(frame) => frame,
                // The entries of a matrix are numbered by its rows and columns.
                None if count == 2 => self.reading.system.ground,
                None => continue,
            };
            let which = what.slot(Slot::Which).and_then(name_of);
            for formula in formulas(subjects) {
                let letters = last_label(formula);
                let fits = letters.len() == count
                    && letters.iter().all(|letter| ('i'..='n').contains(letter))
                    && (count == 2
                        || which == Some(String::from_iter(&letters))
                        || which.is_none() && self.is_indexed_vector(formula, subjects, what));
                for letter in letters.into_iter().filter(|_| fits) {
                    if self.is_told_nothing(&letter.to_string()) {
                        self.reading.letters.indices.push(IndexRule {
                            letter: letter.to_string(),
                            axes_of: Some(frame),
                            members: None,
                            reach: reach_of(&declaration.extent),
                        });
                    }
                }
            }
        }
    }

    /// Whether no sentence says what a letter is or numbers.
    fn is_told_nothing(&self, letter: &str) -> bool {
        let system = &self.reading.system;
        let rules = &self.reading.letters.indices;
        let subject = self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, .. } | Statement::Same { subjects, .. } => subjects
                .iter()
                .any(|s| name_of(s).as_deref() == Some(letter)),
            _ => false,
        });
        let numbers = rules.iter().any(|rule| rule.letter == letter);
        !subject
            && !numbers
            && self.axes.get(letter).is_none()
            && system.family_of(letter).is_none()
    }

    fn number_axes(&mut self, subjects: &[Term], frame: usize, declaration: &Declaration) {
        for subject in subjects {
            let Term::Formula(formula) = subject else {
                continue;
            };
            self.reading.letters.indices.push(IndexRule {
                letter: index_letter(formula),
                axes_of: Some(frame),
                members: None,
                reach: reach_of(&declaration.extent),
            });
        }
    }

    /// "`$i$` numbers P and Q": so many of them.
    fn number_things(
        &mut self,
        subjects: &[Term],
        things: &[(Slot, Term)],
        declaration: &Declaration,
    ) {
        if things.len() < 2 || things.iter().any(|(slot, _)| *slot != Slot::Of) {
            return;
        }
        for index in formulas(subjects) {
            self.reading.letters.indices.push(IndexRule {
                letter: index_letter(index),
                axes_of: None,
                members: Some(things.len()),
                reach: reach_of(&declaration.extent),
            });
        }
    }

    /// "Products of inertia are integrals."
    fn read_convention(&mut self, subjects: &[Term], what: &NounPhrase) {
        if subjects.iter().any(are_products) && matches!(what.head, "integral" | "entry") {
            let customs = &mut self.reading.letters.customs;
            customs.integrals = what.head == "integral";
            customs.products.of_inertia_told = true;
        }
    }

    /// Rules of writing, and those that say no more than what is custom: whether it is one of these.
    fn read_custom(&mut self, sign: &Sign, meaning: &NotationMeaning, reach: &Reach) -> bool {
        let letters = &mut self.reading.letters;
        match (sign, meaning) {
            (Sign::Custom("repeated axis index" | "repeated index"), _) => {
                if let NotationMeaning::Fixed(said @ ("summed" | NOT_SUMMED)) = meaning {
                    let summed = (reach.clone(), *said == "summed");
                    letters.customs.summed.push(summed);
                }
            }
            (Sign::Operator(operator), NotationMeaning::FunctionsOf(of)) => {
                letters.arguments.push(Arguments {
                    of: node_of(operator)
                        .filter(|_| is_letter(operator))
                        .map(spelled),
                    letters: of.iter().filter_map(node_of).cloned().collect(),
                });
            }
            (Sign::Custom(UNDERBRACE), NotationMeaning::Fixed(NOTHING)) => {
                letters.customs.naming_braces.push(reach.clone());
            }
            (Sign::Custom(COLUMN_OF_VECTORS), NotationMeaning::Fixed(ROWS_OF_MATRIX)) => {
                letters.customs.vectors_in_rows.push(reach.clone());
            }
            (Sign::Custom(VECTORS_SIDE_BY_SIDE), NotationMeaning::Noun(dyad))
                if dyad.head == TENSOR_PRODUCT =>
            {
                letters.customs.products.dyads = true;
            }
            (Sign::Operator(cross), NotationMeaning::Fixed(MATRIX_PRODUCT))
                if cross.source.trim() == "\\times" =>
            {
                letters
                    .customs
                    .products
                    .matrices_crossed
                    .push(reach.clone());
            }
            (Sign::Custom(NUMBER_BESIDE_MATRIX), NotationMeaning::Fixed(TIMES_IDENTITY)) => {
                let products = &mut letters.customs.products;
                products.numbers_beside_matrices.push(reach.clone());
            }
            // Between matrices, and before one, a dot is no other product.
            (Sign::Operator(dot), NotationMeaning::Fixed(MATRIX_PRODUCT))
                if DOTS.contains(&dot.source.trim()) => {}
            // Which axes columns of two are on is read behind the signs.
            (Sign::Custom(COLUMNS_OF_TWO), _)
            | (Sign::Custom(CROSS_WITH_MATRIX), NotationMeaning::Fixed(COLUMN_BY_COLUMN))
            | (Sign::Custom(COLUMN_OF_VECTORS), NotationMeaning::Fixed(LIST))
            | (Sign::Custom(DOT_OF_MATRICES), NotationMeaning::Fixed(MATRIX_PRODUCT)) => {}
            _ => return is_custom(sign, meaning) || *meaning == NotationMeaning::Fixed(NOTHING),
        }
        true
    }

    fn read_rule(&mut self, sign: &Sign, meaning: &NotationMeaning, declaration: &Declaration) {
        let reach = reach_of(&declaration.extent);
        if self.read_custom(sign, meaning, &reach) || rate_letter(declaration).is_some() {
            return;
        }
        if let (Sign::Label { labels, .. }, NotationMeaning::Noun(instants)) = (sign, meaning)
            && instants.head == INSTANT
        {
            let read = self.label_instants(labels, instants, &reach);
            return read.unwrap_or_else(|| self.say_unused(declaration));
        }
        if let (Sign::Custom(between), true) = (sign, is_quaternion_product(sign, meaning)) {
            // Side by side quaternions are multiplied so by custom.
            self.reading.letters.customs.products.quaternion_dots |= *between == QUATERNION_DOT;
            return;
        }
        if let Some(component) = component_of_cross(sign, meaning) {
            return self.read_cross_across(component, declaration);
        }
        let Some(effect) = self.effect(meaning) else {
            return self.say_unused(declaration);
        };
        // Of a label it would not tell from where the rate is seen.
        if effect == Effect::Rate && !matches!(sign, Sign::Mark(_)) {
            return self.say_unused(declaration);
        }
        match sign {
            Sign::Mark(mark) => match mark_of(mark) {
                Some(mark) => self.mark_means(mark, effect, reach),
                None => self.say_unused(declaration),
            },
            Sign::Label { labels, on_whole } => {
                self.labels_mean(labels, *on_whole, &effect, &reach)
            }
            Sign::Operator(formula) => {
                self.read_operator_rule(formula, meaning, effect, declaration)
            }
            Sign::Custom("frame at the upper left") => {
                self.reading.letters.customs.raised_frames =
                    *meaning == NotationMeaning::Fixed("that frame");
            }
            Sign::Custom(FRAME_BEFORE_RATE) => {
                self.reading.letters.customs.frames_above_rates =
                    *meaning == NotationMeaning::Fixed(RATE_FROM_FRAME);
            }
            Sign::Custom(FRAME_ABOVE) => self.label_components(false, &reach),
            Sign::Custom(FRAME_ON_BRACKETS) => self.label_components(true, &reach),
            Sign::Custom(brackets) if hold_components(brackets, &effect) => {
                self.mark_means(Mark::Brackets, effect, reach);
            }
            Sign::Custom(brackets) if brackets.starts_with("square") => {
                let customs = &mut self.reading.letters.customs;
                customs.crossing_brackets = effect == Effect::CrossProductMatrix;
            }
            // Numbers are taken as they are written.
            Sign::Custom(DECIMAL_NUMBERS) => self.say_unused(declaration),
            Sign::Custom(_) => {}
        }
    }

    fn mark_means(&mut self, mark: Mark, effect: Effect, reach: Reach) {
        let rule = MarkRule {
            mark,
            effect,
            reach,
        };
        self.reading.letters.marks.push(rule);
    }

    fn labels_mean(&mut self, labels: &[String], on_whole: bool, effect: &Effect, reach: &Reach) {
        for (place, label) in labels.iter().enumerate() {
            let component = (labels.len() == 3).then_some(place);
            self.reading.letters.labels.push(LabelRule {
                label: plain_label(label),
                effect: effect.clone(),
                on_whole,
                component,
                reach: reach.clone(),
            });
        }
    }

    /// "The labels 0 and 1 mean at the instants `$t_0$` and `$t_1$`", the earlier one first.
    fn label_instants(
        &mut self,
        labels: &[String],
        instants: &NounPhrase,
        reach: &Reach,
    ) -> Option<()> {
        let which: Vec<&Term> = instants.all(Slot::Which).collect();
        if which.len() != labels.len() {
            return None;
        }
        let sides: Option<Vec<Side>> = which.iter().map(|term| side(term)).collect();
        if let Some(sides) = sides {
            for (label, side) in labels.iter().zip(sides) {
                let effect = Effect::AtBlow(side);
                self.labels_mean(std::slice::from_ref(label), false, &effect, reach);
            }
            return Some(());
        }
        for (label, instant) in labels.iter().zip(which) {
            let Term::Formula(instant) = instant else {
                return None;
            };
            let known = &mut self.reading.letters.instants;
            known.push(spelled(node_of(instant)?));
            let effect = Effect::AtInstant(known.len() - 1);
            self.labels_mean(std::slice::from_ref(label), false, &effect, reach);
        }
        Some(())
    }

    /// Each frame's name as a label says that components on it are meant.
    fn label_components(&mut self, on_whole: bool, reach: &Reach) {
        let frames = self.reading.system.frames.iter().enumerate();
        let rules = frames.map(|(frame, named)| LabelRule {
            label: plain_label(&named.name),
            effect: Effect::ComponentsOn(frame),
            on_whole,
            component: None,
            reach: reach.clone(),
        });
        let rules: Vec<LabelRule> = rules.collect();
        self.reading.letters.labels.extend(rules);
    }

    fn effect(&self, meaning: &NotationMeaning) -> Option<Effect> {
        match meaning {
            NotationMeaning::Noun(rate) if rate.head == "rate" && rate.slots.is_empty() => {
                Some(Effect::Rate)
            }
            NotationMeaning::Noun(phrase) => match phrase.head {
                rate if rate.ends_with("rate") => Some(Effect::RateSeenFrom(
                    self.frame(phrase.slot(Slot::SeenFrom)?)?,
                )),
                "component" => Some(Effect::ComponentsOn(self.frame(phrase.slot(Slot::On)?)?)),
                CROSS_PRODUCT_MATRIX => Some(Effect::CrossProductMatrix),
                _ => None,
            },
            NotationMeaning::Fixed("itself") => Some(Effect::Itself),
            NotationMeaning::Fixed(_) => Some(Effect::Itself),
            NotationMeaning::FunctionsOf(_) => None,
        }
    }
}

/// "`$1$`", of which a sentence says that it is the identity matrix.
pub(super) fn is_one(term: &Term) -> bool {
    match term {
        Term::Formula(formula) => formula.source.trim() == "1",
        Term::Numbers(numbers) => numbers == &[1],
        _ => false,
    }
}

/// "Braces hold components on B."
fn hold_components(brackets: &str, effect: &Effect) -> bool {
    matches!(brackets, "braces" | "round brackets") && matches!(effect, Effect::ComponentsOn(_))
}

/// A mark by its name: "dot on a vector".
fn mark_of(name: &str) -> Option<Mark> {
    match name.split(' ').next()? {
        "tilde" => Some(Mark::Tilde),
        "hat" | "wide" => Some(Mark::Hat),
        "bar" | "underline" => Some(Mark::Bar),
        "prime" => Some(Mark::Prime),
        "small" => Some(Mark::Ring),
        "dot" => Some(Mark::Dot),
        "no" => Some(Mark::NoLabel),
        "base" => Some(Mark::AxisWithoutLabel),
        _ => None,
    }
}

/// The letters of the last label at the lower right.
fn last_label(formula: &Formula) -> Vec<char> {
    match node_of(formula).map(|node| &node.kind) {
        Some(Kind::Symbol(symbol)) => symbol
            .subscripts
            .last()
            .map_or_else(Vec::new, |label| plain(label).chars().collect()),
        _ => vec![],
    }
}
