//! Products of inertia: by their labels, by what is said of their sign, and those that vanish.

use crate::verify::language::heads::{INERTIA_TENSOR, OTHER_PRODUCTS};
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::model::system::FrameId;
use crate::verify::reading::builder::{Builder, place_in};
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::{are_products, reach_of, told};
use crate::verify::reading::relations_read::labelled_entry;
use crate::verify::reading::vectors_read::entry_of;
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::written::{PRODUCTS_AS_ENTRIES, PRODUCTS_AS_INTEGRALS, WrittenSymbols};

/// The places of the products, each of which stands twice in a tensor.
const PLACES: [(usize, usize); 3] = [(0, 1), (0, 2), (1, 2)];

/// Products that letters name: of a tensor, on a frame, and which ones.
type Named = (Quantity, FrameId, Vec<(usize, usize)>);

impl Builder<'_> {
    /// A matrix tells how products of inertia are written, where no sentence does.
    pub(super) fn write_products_as(&mut self, written: &WrittenSymbols) {
        let customs = &mut self.reading.letters.customs;
        let entries = written.has(PRODUCTS_AS_ENTRIES);
        let integrals = written.has(PRODUCTS_AS_INTEGRALS);
        customs.integrals = !entries || integrals;
        customs.products.of_inertia_told = entries != integrals;
    }

    /// Whether products of inertia are integrals, where a sentence says what they are in the part of the document of which
    /// another one speaks.
    fn products_are_integrals(&self, declaration: &Declaration) -> Option<bool> {
        let at = place_in(&reach_of(&declaration.extent));
        let told = self.declarations.iter().filter_map(|d| {
            let reach = reach_of(&d.extent);
            let integrals = match &d.statement {
                Statement::Is { subjects, what } if subjects.iter().any(are_products) => {
                    match what.head {
                        "integral" => true,
                        "entry" => false,
                        _ => return None,
                    }
                }
                _ => return None,
            };
            reach
                .covers(&at, 0)
                .then(|| (reach.narrowness(), integrals))
        });
        told.max_by_key(|(narrowness, _)| *narrowness)
            .map(|(_, integrals)| integrals)
    }

    /// Whether a sentence says that products of inertia are integrals there: entries are entries where none does.
    pub(super) fn says_integrals(&self, declaration: &Declaration) -> bool {
        self.products_are_integrals(declaration) == Some(true)
    }

    /// "`I_{xy}` is a product of inertia of the body about O on B", where a sentence says what the products are: the labels
    /// say which one.
    pub(super) fn read_products(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        if self.products_are_integrals(declaration).is_none() {
            return;
        }
        if !self.are_labelled_so(subjects, what) {
            return self.say_unused(declaration);
        }
        let slots = what.slots.iter().filter(|(s, _)| *s != Slot::Between);
        let (on, of): (Vec<_>, Vec<_>) = slots.cloned().partition(|(s, _)| *s == Slot::On);
        let tensor = Term::Phrase(Box::new(NounPhrase::new(INERTIA_TENSOR, of)));
        let slots = std::iter::once((Slot::Of, tensor)).chain(on);
        let entries = NounPhrase::new("entry", slots.collect());
        if self.read_entries(subjects, &entries, declaration).is_none() {
            self.say_unused(declaration);
        }
    }

    /// Whether the labels of letters are the axes between which a sentence says that the products are, if it does.
    fn are_labelled_so(&self, subjects: &[Term], what: &NounPhrase) -> bool {
        let between: Vec<&Term> = what.all(Slot::Between).collect();
        let axes: Option<Vec<usize>> = between.iter().map(|t| self.number_of_axis(t)).collect();
        match axes.as_deref() {
            Some([]) => true,
            Some(&[row, column]) => {
                let own = |letter| labelled_entry(letter) == Some([row, column]);
                formulas(subjects).all(own)
            }
            _ => false,
        }
    }

    /// "The products of inertia of the body about G on B are zero", "the other products of inertia are zero".
    pub(super) fn zero_products(
        &mut self,
        products: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let others = products.head == OTHER_PRODUCTS;
        let (tensor, on, named) = match self.named_products().filter(|_| others) {
            Some(named) => named,
            None if others => return None,
            None => {
                let of = self.whole_of(products)?;
                let about = self.about(products, &of)?;
                let customary = self.reading.letters.component_frame;
                let on = told(products.slot(Slot::On), customary, |t| self.frame(t))?;
                (Quantity::Inertia { of, about }, on, vec![])
            }
        };
        let zero = Quantity::Sum(vec![]);
        let only = self.places_between(products, on)?;
        for (row, column) in PLACES {
            if !named.contains(&(row, column))
                && only.as_ref().is_none_or(|o| o.contains(&(row, column)))
            {
                let product = entry_of(&tensor, row, column, on);
                self.hold_quantities(&product, &zero, declaration);
            }
        }
        Some(())
    }

    /// "between x and y and between y and z": which products are meant; all of them where no sentence says it, and `None`
    /// where it is not understood.
    fn places_between(
        &mut self,
        products: &NounPhrase,
        on: FrameId,
    ) -> Option<Option<Vec<(usize, usize)>>> {
        let between: Vec<Term> = products.all(Slot::Between).cloned().collect();
        if between.is_empty() {
            return Some(None);
        }
        let axis = |axis: &Term| {
            let (of, axis) = self.axis_of_frame(axis)?;
            (of == on).then_some(axis)
        };
        let axes: Vec<usize> = between.iter().map(axis).collect::<Option<_>>()?;
        let pairs = axes.chunks(2).map(|pair| match *pair {
            [one, other] if one != other => Some((one.min(other), one.max(other))),
            _ => None,
        });
        Some(Some(pairs.collect::<Option<_>>()?))
    }

    /// The products that letters name, where all are of one tensor on one frame.
    fn named_products(&self) -> Option<Named> {
        let mut found: Option<Named> = None;
        for letter in &self.reading.letters.letters {
            let Meaning::Quantity(Quantity::Entry {
                of,
                row,
                column,
                on,
                ..
            }) = &letter.meaning
            else {
                continue;
            };
            if row == column {
                continue;
            }
            let place = (*row.min(column), *row.max(column));
            match &mut found {
                None => found = Some(((**of).clone(), *on, vec![place])),
                Some((tensor, frame, places)) if *tensor == **of && frame == on => {
                    places.push(place);
                }
                Some(_) => return None,
            }
        }
        found
    }
}
