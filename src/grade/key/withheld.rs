//! Milestones that the sentences of the key say already: "the disc rolls on the floor" says that v = rω, and where it turns by
//! angles its angular velocity is known.
//!
//! With that taken in any line would reach the milestone. It is looked for without, and all other milestones with it.

use crate::grade::key::{Key, Milestone, Stage, not_told_apart};
use crate::grade::matching::Board;
use crate::verify::Withheld;
use crate::verify::language::statement::Declaration;

impl Key {
    /// Gives each milestone that is declared a stage without what declares it, where it is told apart by that.
    pub(super) fn withhold(&mut self) {
        for at in 0..self.milestones.len() {
            let milestone = &self.milestones[at];
            let stage = milestone.stage;
            if self.tells_apart(milestone, &Withheld::default()) {
                continue;
            }
            let Some(withheld) = self.saying(milestone) else {
                continue;
            };
            let known = self
                .stages
                .iter()
                .position(|own| own.judged_as == Some(stage) && own.withheld == withheld);
            self.milestones[at].stage = known.unwrap_or(self.stages.len());
            if known.is_none() {
                let meaning = [false, true]
                    .map(|entries| self.meaning_without(&withheld, stage, entries, &[]));
                self.stages.push(Stage {
                    meaning,
                    given: self.stages[stage].given.clone(),
                    routes: vec![],
                    withheld,
                    judged_as: Some(stage),
                });
            }
        }
    }

    /// What says a milestone, as little as can be, so that it is told apart without; none where it never is.
    fn saying(&self, milestone: &Milestone) -> Option<Withheld> {
        let declared = self.stages[milestone.stage].meaning[usize::from(self.entries)].declared();
        let sentences = declared.declarations.iter().map(Declaration::sentence);
        let mut sentences: Vec<String> = sentences.map(str::to_owned).collect();
        sentences.dedup();
        let ways = [
            (false, sentences.clone()),
            (true, vec![]),
            (true, sentences),
        ];
        let mut ways = ways
            .into_iter()
            .map(|(values, sentences)| Withheld { sentences, values });
        let mut withheld = ways.find(|way| self.tells_apart(milestone, way))?;
        for at in (0..withheld.sentences.len()).rev() {
            let sentence = withheld.sentences.remove(at);
            if !self.tells_apart(milestone, &withheld) {
                withheld.sentences.insert(at, sentence);
            }
        }
        Some(withheld)
    }

    /// Whether a milestone says something where this does not count.
    fn tells_apart(&self, milestone: &Milestone, withheld: &Withheld) -> bool {
        let meaning = self.meaning_without(withheld, milestone.stage, self.entries, &[]);
        let given = &self.stages[milestone.stage].given;
        let board = Board::new(&meaning, self.sheet(given), &[]);
        not_told_apart(&self.document, &board, milestone).is_empty()
    }
}
