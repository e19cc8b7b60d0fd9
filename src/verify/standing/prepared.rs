//! What sentences make of a document before any line of it is looked at.

use crate::verify::facts::premises::Facts;
use crate::verify::language::statement::Declaration;
use crate::verify::reading::Reading;
use crate::verify::reading::builder::build;
use crate::verify::standing::recalled::Links;
use crate::verify::term::known::Known;
use crate::verify::term::letters::At;
use crate::verify::term::written::Written;

/// A reading, what was found out of letters by it, and the premises that are put in. Many documents may begin with it.
#[derive(Clone, Debug)]
pub(crate) struct Prepared {
    pub(crate) reading: Reading,
    pub(crate) known: Known,
    pub(crate) facts: Facts,
    /// What links came to in documents that began with it.
    pub(crate) links: Option<Links>,
}

impl Prepared {
    /// By these sentences, for a document that writes these symbols; the variables of the model are numbered from one on.
    pub(crate) fn new(declarations: &[Declaration], written: Written, first: usize) -> Self {
        let mut reading = build(declarations, written, first);
        reading.system.set_dimensions(3);
        Self {
            known: Known::of(reading.shapes.clone()),
            reading,
            facts: Facts::default(),
            links: None,
        }
    }

    /// Works out all letters and puts in the premises of the whole document, as any document needs most of them.
    pub(crate) fn work_out(&mut self) {
        let reading = &mut self.reading;
        reading.system.set_dimensions(3);
        self.known.work_out(&reading.letters, &mut reading.system);
        self.reading.taken = self.reading.active_premises(&At::default());
        let premises = self.reading.premises_in_force();
        let atoms = &mut self.reading.system.atoms;
        self.facts.extend_all(atoms, premises);
        // Documents write rates in an order of their own. What is there before has the same number in all of them, so
        // that what one of them found holds in the next. A dot that is tried over a rate asks for the rate of that.
        atoms.bring_up_rates();
        atoms.bring_up_rates();
        self.links = Links::of(&self.reading);
    }

    /// The same for a document that writes other symbols, if it would be read alike.
    pub(crate) fn for_writing(&self, written: &Written) -> Option<Self> {
        let letters = &self.reading.letters;
        letters.written.answers_as(written).then(|| {
            let mut own = self.clone();
            own.reading.letters.written.replace(written.clone());
            own
        })
    }
}
