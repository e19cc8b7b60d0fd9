//! What letters denote.

use crate::notation::ast::Kind;
use crate::verify::language::heads::{
    COMPONENT_ROTATION, COORDINATES, DISTURBANCE, DOWNHILL, DYNAMICALLY_BALANCED,
    FIRST_ORDER_CHANGE, IMAGINARY_UNIT, JACOBIAN, MOMENT, MOMENT_OF_INERTIA, NATURAL_BASE,
    NATURAL_LENGTH, NORMAL, OTHER_PRODUCTS, PLANE_OF_SYMMETRY, QUATERNION, REFERENCE, SEMI_AXIS,
    STATICALLY_BALANCED, STEP_SIZE, TENSOR_PRODUCT, UNBALANCED, UPHILL,
};
use crate::verify::language::statement::{
    Declaration, Formula, NounPhrase, Slot, Statement, Term, slot,
};
use crate::verify::model::system::Vector;
use crate::verify::reading::bodies_read::WHOLES;
use crate::verify::reading::body_ends::{APEX, END};
use crate::verify::reading::builder::{Builder, place_in};
use crate::verify::reading::contact_read::CONTACT_POINT;
use crate::verify::reading::loads_read::{is_force_at, rests_for_long};
use crate::verify::reading::matrices_read::is_made_of_matrix;
use crate::verify::reading::named_loads_read::{may_be_size, names_load};
use crate::verify::reading::names::{
    CROSS_PRODUCT_MATRIX, EULER_ANGLES, MASS_CENTRE, PRINCIPAL_MOMENTS, PRODUCTS, UNIT_VECTOR,
    are_products, is_of_products, node_of, reach_of, tells_gravity,
};
use crate::verify::reading::operators_read::reads_derivative;
use crate::verify::reading::order::{BEFORE_LOADS, in_order};
use crate::verify::reading::orders_read::REMAINDER;
use crate::verify::reading::oscillations_read::{ANGULAR_FREQUENCY, EIGENVALUE, FREQUENCY, PERIOD};
use crate::verify::reading::quaternions_read::{is_free_quaternion, layout};
use crate::verify::reading::rate_matrices_read::rates_in;
use crate::verify::reading::reactions_read::is_reaction;
use crate::verify::reading::relations_read::labelled_entry;
use crate::verify::reading::rotations_read::turns_by_argument;
use crate::verify::reading::shapes_read::{is_known_by_name, is_shape};
use crate::verify::reading::steps_read::EXPLICIT_EULER;
use crate::verify::term::letters::{Meaning, spelled};
use crate::verify::term::quantity::Quantity;

/// Nouns that name no quantity: others hear of these things.
const THINGS: [&str; 27] = [
    PLANE_OF_SYMMETRY,
    "frame",
    "point",
    "origin",
    END,
    APEX,
    MASS_CENTRE,
    "axes",
    "axis",
    "vertical",
    "fixed",
    "plane",
    "orthogonal",
    "horizontal",
    "nonzero",
    "zero",
    EULER_ANGLES,
    CONTACT_POINT,
    "symmetric",
    DYNAMICALLY_BALANCED,
    STATICALLY_BALANCED,
    UNBALANCED,
    COORDINATES,
    "integral",
    "cross product",
    "dot product",
    TENSOR_PRODUCT,
];

impl Builder<'_> {
    /// Goes through the sentences about letters, each behind those that tell the letters it speaks of.
    pub(super) fn read_letters(&mut self) {
        let mut loads_read = false;
        for (stage, declaration) in in_order(self.declarations) {
            if stage > BEFORE_LOADS && !loads_read {
                self.read_loads();
                loads_read = true;
            }
            match self.is_full() {
                true => self.say_beyond(declaration),
                false => self.read_letter(declaration),
            }
        }
        if !loads_read {
            self.read_loads();
        }
        self.name_magnitudes_by_type();
    }

    fn read_letter(&mut self, declaration: &Declaration) {
        match &declaration.statement {
            Statement::Is { subjects, what }
                if self.read_letter_at_blow(subjects, what, declaration) => {}
            Statement::Is { subjects, what } if reads_derivative(subjects, what) => {}
            Statement::Is { subjects, what } => {
                self.read_noun(subjects, what, declaration);
                self.read_where_letter_differs(subjects, what, declaration);
            }
            Statement::Same { .. } => self.read_same(declaration),
            Statement::Means { .. } => self.read_means(declaration),
            Statement::Holds(formula) => self.read_definition(formula, declaration),
            Statement::Does {
                subjects,
                verb: "take",
                slots,
            } => {
                let from = slot(slots, Slot::From).and_then(|term| self.frame(term));
                let to = slot(slots, Slot::To).and_then(|term| self.frame(term));
                let (Some(from), Some(to), [Term::Formula(formula)]) =
                    (from, to, subjects.as_slice())
                else {
                    return self.say_unused(declaration);
                };
                match layout(slots) {
                    Some(layout) => {
                        self.denote_quaternion(formula, (from, to), layout, declaration)
                    }
                    None => {
                        self.denote_matrix(formula, Quantity::Rotation { from, to }, declaration);
                    }
                }
            }
            Statement::Does {
                subjects,
                verb: "have components",
                slots,
            } => {
                let Some(frame) = slot(slots, Slot::On).and_then(|term| self.frame(term)) else {
                    return self.say_unused(declaration);
                };
                for subject in subjects {
                    let Term::Formula(formula) = subject else {
                        continue;
                    };
                    match self.quantity_of(formula, declaration) {
                        Some(quantity) => {
                            let on = Quantity::On(quantity.boxed(), frame);
                            self.denote(formula, Meaning::Quantity(on), declaration);
                        }
                        // Entries that are written out are those on the customary frame.
                        None if frame == self.reading.letters.component_frame => {}
                        None => self.say_unused(declaration),
                    }
                }
            }
            _ => {}
        }
    }

    /// A matrix by its letter, or by the letter of its transpose.
    fn denote_matrix(&mut self, formula: &Formula, quantity: Quantity, declaration: &Declaration) {
        let (Some(node), Quantity::Rotation { from, to }) = (node_of(formula), &quantity) else {
            return;
        };
        if let Kind::Transpose(inner) = &node.kind {
            let inner = Formula::of(inner);
            let other = Quantity::Rotation {
                from: *to,
                to: *from,
            };
            return self.denote(&inner, Meaning::Quantity(other), declaration);
        }
        self.denote(formula, Meaning::Quantity(quantity), declaration);
    }

    pub(super) fn read_noun(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        if subjects.len() == 1 && subjects.iter().all(are_products) {
            return self.read_rule_of_products(what, declaration);
        }
        // Without labels no custom says which product is which.
        let unlabelled = |f: &Formula| labelled_entry(f).is_none();
        if is_of_products(what) && formulas(subjects).any(unlabelled) || rests_for_long(what) {
            return self.say_unused(declaration);
        }
        if self.read_product_in_brackets(subjects, what, declaration) {
            return;
        }
        let thing = WHOLES.contains(&what.head) || THINGS.contains(&what.head);
        if thing || is_shape(what.head) || is_force_at(what) || is_reaction(what) {
            return;
        }
        match what.head {
            "component" => self.read_components_or_operator(subjects, what, declaration),
            PRODUCTS | OTHER_PRODUCTS => self.read_products(subjects, what, declaration),
            PRINCIPAL_MOMENTS => self.read_principal_moments(subjects, what, declaration),
            _ if tells_gravity(what) => self.read_gravity(subjects, what, declaration),
            "vector" if what.slot(Slot::Which).is_some() => {
                self.read_same_vector(subjects, what, declaration)
            }
            "vector" | UNIT_VECTOR => self.read_vectors(subjects, what, declaration),
            "constant" => self.read_constants_said(subjects, what, declaration),
            "scalar" if what.slots.is_empty() => self.read_scalars(subjects, declaration),
            IMAGINARY_UNIT => self.read_imaginary_unit(subjects, declaration),
            QUATERNION if formulas(subjects).all(|q| self.is_told_turn(q)) => {}
            QUATERNION if is_free_quaternion(what) => {
                self.read_free_quaternions(subjects, what, declaration);
            }
            _ if self.says_nothing_new(subjects, what) => {}
            "positive" | "negative" => self.read_sign(subjects, what, declaration),
            "time" => self.read_time(subjects, declaration),
            "radius" | "length" | "width" | "thickness" | "side" | SEMI_AXIS | "diameter"
            | "stiffness" | "damping" | NATURAL_LENGTH => {
                self.read_size(subjects, declaration);
            }
            DOWNHILL | UPHILL if self.is_tilted() => {}
            NORMAL if self.normal_of_incline().is_some() => {}
            "column" | "row" => self.read_column(subjects, what, declaration),
            "cosine" | "sine" | "tangent" => self.read_kernels(subjects, what, declaration),
            CROSS_PRODUCT_MATRIX | "rotation matrix" | COMPONENT_ROTATION
                if what.slot(Slot::ForAny).is_some() || turns_by_argument(subjects, what) =>
            {
                self.read_operator(subjects, what, declaration);
            }
            _ => match self.read_relation(subjects, what, declaration) {
                Some(Some(())) => {}
                Some(None) => self.say_unused(declaration),
                None => self.read_quantity(subjects, what, declaration),
            },
        }
    }

    fn read_time(&mut self, subjects: &[Term], declaration: &Declaration) {
        for formula in formulas(subjects) {
            self.denote(formula, Meaning::Time, declaration);
        }
    }

    /// What the products of inertia are is a rule of notation.
    fn read_rule_of_products(&mut self, what: &NounPhrase, declaration: &Declaration) {
        if !matches!(what.head, "integral" | "entry" | "zero") {
            self.say_unused(declaration);
        }
    }

    /// What a letter is by another one. `None` for other nouns; `Some(None)` where nothing was made of the sentence.
    fn read_relation(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Option<()>> {
        Some(match what.head {
            REFERENCE | DISTURBANCE => self.read_reference(subjects, what, declaration),
            "angle" if what.slot(Slot::Between).is_some() => {
                self.read_angle(subjects, what, declaration)
            }
            "angle" if self.is_angle_by_turns(subjects, what, declaration) => Some(()),
            "entry" => self.read_entries_or_column(subjects, what, declaration),
            "value" => self.read_value(subjects, what, declaration),
            PERIOD | FREQUENCY | ANGULAR_FREQUENCY => {
                self.read_oscillation(subjects, what, declaration)
            }
            EIGENVALUE => self.read_eigenvalue(subjects, what, declaration),
            EXPLICIT_EULER => Some(()),
            FIRST_ORDER_CHANGE => self.read_change(subjects, what, declaration),
            JACOBIAN if rates_in(what).is_none() => self.read_jacobian(subjects, what, declaration),
            STEP_SIZE => self.read_step_size(subjects, declaration),
            REMAINDER => self.read_remainder(subjects, what, declaration),
            head if is_made_of_matrix(head) => self.read_made_of(subjects, what, declaration),
            "product" | "quotient" => self.read_product(subjects, what, declaration),
            NATURAL_BASE => {
                let is_e = |f: &Formula| matches!(f.source.as_str(), "e" | "\\mathrm{e}");
                formulas(subjects).all(is_e).then_some(())
            }
            _ => return None,
        })
    }

    fn read_quantity(&mut self, subjects: &[Term], what: &NounPhrase, declaration: &Declaration) {
        let named =
            |term: &Term| matches!(term, Term::Formula(_)) || matches!(term, Term::Phrase(_));
        if !subjects.iter().any(named) {
            // A shape of which no more than the name is known.
            if is_known_by_name(what.head) && !what.slots.is_empty() {
                self.say_unused(declaration);
            }
            return;
        }
        let about_axes = what.head == MOMENT_OF_INERTIA && subjects.len() == 3;
        if about_axes
            && self
                .read_moments_about_axes(subjects, what, declaration)
                .is_some()
        {
            return;
        }
        let named = names_load(what)
            || self.names_touch(what)
            || self.agent_outside(what, None).is_some()
            || self.reversed(what).is_some();
        // The moment of a spring is known by its law, as that of a weight.
        let by_law = what.head == MOMENT && self.is_by_spring(what);
        let open = named && !by_law;
        if open && subjects.iter().any(|subject| may_be_size(subject, what)) {
            return self.say_unused(declaration);
        }
        let Some(quantity) = self.quantity(what, declaration) else {
            return self.say_unused(declaration);
        };
        for subject in subjects {
            if let (Term::Formula(formula), Some(square)) =
                (subject, self.square_of_length(&quantity))
            {
                self.read_length(formula, square, declaration);
                continue;
            }
            match subject {
                Term::Formula(formula) if self.is_worked_out(formula, declaration) => {
                    self.hold_formula_is(formula, &quantity, declaration);
                }
                Term::Formula(formula) => match self.told_there(formula, declaration) {
                    // What two sentences say of one letter holds both.
                    Some(told) => self.hold_quantities(&told, &quantity, declaration),
                    None => self.denote(formula, Meaning::Quantity(quantity.clone()), declaration),
                },
                Term::Phrase(phrase) => self.read_phrase_is(phrase, &quantity, declaration),
                _ => {}
            }
        }
    }

    /// The quantity that another sentence gives a letter for the same part of the document, if this one may be the same.
    pub(super) fn told_there(
        &self,
        formula: &Formula,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        if matches!(&declaration.statement, Statement::Is { what, .. } if what.is("also")) {
            return None;
        }
        let writing = spelled(node_of(formula)?);
        let reach = reach_of(&declaration.extent);
        let mut letters = self.reading.letters.letters.iter().rev();
        let told = letters.find(|l| l.spelled == writing && l.reach == reach && !l.besides)?;
        match &told.meaning {
            Meaning::Quantity(told @ (Quantity::Scalar { .. } | Quantity::Mass(_))) => {
                Some(told.clone())
            }
            _ => None,
        }
    }

    /// "The rate of `\phi` is the angular velocity of B": what is said of a phrase holds.
    fn read_phrase_is(
        &mut self,
        phrase: &NounPhrase,
        quantity: &Quantity,
        declaration: &Declaration,
    ) {
        if phrase.head == "rate"
            && let Some(Term::Formula(formula)) = phrase.slot(Slot::Of)
            && self.quantity_of(formula, declaration).is_none()
        {
            let text = formula.source.clone();
            let vector = Quantity::Vector {
                text,
                carried: None,
            };
            self.denote(&formula.clone(), Meaning::Quantity(vector), declaration);
        }
        let Some(left) = self.quantity(phrase, declaration) else {
            return self.say_unused(declaration);
        };
        let (left, right) = (
            self.system().value_of(&left),
            self.system().value_of(quantity),
        );
        if let (Ok(left), Ok(right)) = (left, right) {
            self.hold_equal(&left, &right, declaration);
        }
    }

    /// Whether sentences tell what a formula is: its letters, or angles and rates by which something turns.
    pub(super) fn is_told(&mut self, formula: &Formula, declaration: &Declaration) -> bool {
        let quantity = self.quantity_of(formula, declaration);
        let at = place_in(&reach_of(&declaration.extent));
        let value = self.value_at(formula, &at, declaration);
        quantity.is_some() || value.is_some_and(|value| self.reading.system.is_told(&value))
    }

    pub(super) fn is_scalar(&mut self, quantity: &Quantity) -> bool {
        let value = self.system().value_of(quantity);
        value.is_ok_and(|value| value.is_scalar())
    }

    pub(super) fn is_vector(&mut self, quantity: &Quantity) -> bool {
        self.vector_of(quantity).is_some()
    }

    pub(super) fn vector_of(&mut self, quantity: &Quantity) -> Option<Vector> {
        self.system().value_of(quantity).ok()?.to_vector().ok()
    }

    pub(super) fn hold_quantities(
        &mut self,
        left: &Quantity,
        right: &Quantity,
        declaration: &Declaration,
    ) {
        let (left, right) = (self.system().value_of(left), self.system().value_of(right));
        if let (Ok(left), Ok(right)) = (left, right) {
            self.hold_equal(&left, &right, declaration);
        }
    }
}

/// The formulas among terms.
pub(super) fn formulas(terms: &[Term]) -> impl Iterator<Item = &Formula> {
    terms.iter().filter_map(|term| match term {
        Term::Formula(formula) => Some(formula),
        _ => None,
    })
}
