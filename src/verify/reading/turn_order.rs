//! In which order turns are read: from the frame on whose axes all is worked out outwards, for the rate of an axis that is fixed
//! in another frame needs the turns between.

use crate::verify::language::statement::{Declaration, Slot, Statement, Term, slot};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::frames_read::Said;
use crate::verify::reading::names::{along_of, is_letter, name_of};

impl Builder<'_> {
    /// How frames turn by the verbs and the nouns of sentences.
    pub(super) fn read_turns(&mut self) {
        let declarations = self.declarations.iter();
        let turns = declarations.filter_map(|d| Some((self.links_to_work(d)?, d)));
        let mut turns: Vec<((bool, usize, bool), &Declaration)> = turns.collect();
        turns.sort_by_key(|(order, _)| *order);
        for (_, declaration) in turns {
            self.read_turn(declaration);
            self.read_turning_frame(declaration);
        }
    }

    /// When a turn is read: about a combination of axes last, as its letters may be axes of frames that turn otherwise;
    /// then by how far from the work frame something turns, and by a noun behind those with a verb.
    fn links_to_work(&self, declaration: &Declaration) -> Option<(bool, usize, bool)> {
        let (subjects, slots, by_noun) = match &declaration.statement {
            Statement::Does {
                subjects,
                verb: "turn",
                slots,
            } => (subjects, slots, false),
            Statement::Is { subjects, what } if what.head == "frame" => {
                (subjects, &what.slots, true)
            }
            _ => return None,
        };
        let about = slot(slots, Slot::About).map(along_of);
        let combined = matches!(about, Some(Term::Formula(formula)) if !is_letter(formula));
        let system = &self.reading.system;
        let links = |frame| system.distance(system.work, frame, &[]);
        let frames = subjects.iter().filter_map(|subject| self.frame(subject));
        let nearest = frames.map(|frame| {
            let parent = system.frames[frame].parent.unwrap_or(frame);
            links(frame).min(links(parent))
        });
        Some((combined, nearest.min()?, by_noun))
    }

    /// "The top turns about O", of a point that is fixed where it turns: that it is fixed in the top is another sentence.
    fn is_about_point(&self, slots: &[(Slot, Term)]) -> bool {
        let mut told = slots.iter();
        let more = told.any(|(slot, _)| !matches!(slot, Slot::About | Slot::RelativeTo));
        let about = slot(slots, Slot::About).and_then(name_of);
        let Some(about) = about.filter(|_| !more) else {
            return false;
        };
        let ground = self.reading.system.ground;
        let base = slot(slots, Slot::RelativeTo).map_or(Some(ground), |term| self.frame(term));
        let fixed = |d: &Declaration| match &d.statement {
            Statement::Is { subjects, what } if what.head == "point" => {
                let mut names = subjects.iter().filter_map(name_of);
                let at_rest = what.is("fixed") && base == Some(ground);
                let mut carriers = what.all(Slot::FixedIn);
                let carried = at_rest || carriers.any(|frame| self.frame(frame) == base);
                names.any(|name| name == about) && carried
            }
            _ => false,
        };
        base.is_some() && self.declarations.iter().any(fixed)
    }

    fn read_turn(&mut self, declaration: &Declaration) {
        let Some((subjects, slots)) = declaration.statement.does("turn") else {
            return;
        };
        if self.is_about_point(slots) || self.tells_attitude(declaration) {
            return;
        }
        let relative = slot(slots, Slot::RelativeTo).and_then(name_of);
        let said = Said {
            relative,
            slots,
            declaration,
        };
        for subject in subjects {
            if let Some(frame) = self.frame(subject) {
                self.turn_frame(frame, &said);
            }
        }
    }
}
