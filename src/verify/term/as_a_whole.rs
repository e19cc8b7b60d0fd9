//! Writings that sentences give a meaning as a whole: `[I_s]`, `dA/dt_{rotating}`, `I\omega^2`, `R_1^0`.

use crate::notation::ast::{Kind, Node};
use crate::verify::term::letters::{Meaning, loosely, spelled};
use crate::verify::term::lower::Lowering;
use crate::verify::term::value::Valued;

impl Lowering<'_> {
    /// A writing that a sentence gives a meaning as a whole: `[I_s]`, `dA/dt_{rotating}`, `I\omega^2`.
    pub(super) fn as_a_whole(&mut self, node: &Node) -> Option<Valued> {
        if matches!(node.kind, Kind::Symbol(_) | Kind::Number(_)) || !self.letters.has_wholes() {
            return None;
        }
        let is_letter = |exact: &str| self.letters.letters.iter().any(|l| l.spelled == exact);
        let (exact, loose) = (spelled(node), loosely(node));
        if let Some((rate, letter)) = rate_of_whole(node)
            && is_letter(&letter)
            && !is_letter(&exact)
        {
            return Some(self.deeper(|lowering| lowering.value(&rate)));
        }
        let grouped = matches!(node.kind, Kind::Group(..));
        let number = match is_letter(&exact) && !grouped {
            true => self.count(&exact),
            false => 1,
        };
        self.meaning_of(&exact, (!grouped).then_some(loose.as_str()), number)
    }

    /// What sentences tell of a formula as it is spelled: what it means, or the letter that it is.
    pub(super) fn meaning_of(
        &mut self,
        exact: &str,
        loose: Option<&str>,
        number: usize,
    ) -> Option<Valued> {
        if let Some(meaning) = self.letters.told_meaning(exact, self.at) {
            return Some(self.deeper(|lowering| lowering.value(meaning)));
        }
        let letters = self.letters;
        let letter = letters.find(exact, loose?, self.at, number)?;
        match &letter.meaning {
            Meaning::Quantity(quantity) => Some(self.letter(&letter.latex, quantity)),
            Meaning::Same(same) => Some(self.deeper(|lowering| lowering.value(same))),
            _ => None,
        }
    }
}

/// `\dot R_1^0`, where `R_1^0` may be a letter with a label at the upper right, or `\dot R(\psi)`, where `R(\psi)` may be one:
/// its rate, and how the letter is spelled.
fn rate_of_whole(node: &Node) -> Option<(Node, String)> {
    let (Kind::Power(base, _) | Kind::Call(base, _)) = &node.kind else {
        return None;
    };
    let Kind::TimeDerivative {
        operand,
        order,
        style,
        frame,
    } = &base.kind
    else {
        return None;
    };
    let at = |kind| Node {
        kind,
        span: node.span,
    };
    let letter = at(match &node.kind {
        Kind::Call(_, arguments) => Kind::Call(operand.clone(), arguments.clone()),
        Kind::Power(_, label) => Kind::Power(operand.clone(), label.clone()),
        _ => return None,
    });
    let spelled = spelled(&letter);
    let rate = Kind::TimeDerivative {
        operand: Box::new(letter),
        order: *order,
        style: *style,
        frame: frame.clone(),
    };
    Some((at(rate), spelled))
}
