//! The sentence that is being read, as far as it goes: what it sets, and the role that it gives to the next formula.

use crate::notation::document::{Formula, Row};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::space_axes::turns_to_body;
use crate::verify::verdict::Role;
use crate::verify::words::book::lowered;
use crate::verify::words::points_in_words::lone;
use crate::verify::words::prose::{said, symmetry_plane};
use crate::verify::words::role::{Words, ends_with_condition};
use crate::verify::words::sentences::closes_sentence;
use crate::verify::words::sizes_of_vectors::is_bare;

/// Bytes of a sentence that are kept: a page of formulas without a word between them is no sentence.
const LONGEST_SENTENCE: usize = 1_000;

/// Words that a sentence begins with, where no stop stands behind the display before it.
const OPENINGS: &[&str] = &[
    "For", "With", "If", "When", "Let", "Since", "Now", "In", "At", "On", "By", "From", "The",
    "This", "These", "It", "We", "As", "Here", "Assume", "Suppose",
];

/// Drops the beginning of a text that is longer than `most` bytes.
pub(crate) fn keep_end(text: &mut String, most: usize) {
    let excess = text.len().saturating_sub(most);
    let cut = (excess..text.len()).find(|&at| text.is_char_boundary(at));
    text.drain(..cut.unwrap_or(0));
}

/// Whether a clause concludes something and goes on with it: "it therefore starts to turn with".
fn concludes_with(sentence: &str) -> bool {
    let clause = sentence.rsplit([',', ';', ':', '.', '⟩']).next();
    let mut words = clause.unwrap_or_default().split_whitespace();
    let concludes = ["therefore", "hence", "thus", "so", "consequently"];
    words.next_back() == Some("with")
        && words.any(|word| concludes.contains(&word.to_lowercase().as_str()))
}

/// Whether a sentence says in another form what stands before: "needs ⟨T⟩ for one swing, or".
fn says_again(sentence: &str) -> bool {
    let clause = sentence
        .trim_end_matches([',', '.', ' '])
        .rsplit(',')
        .next();
    let clause = clause.unwrap_or_default().trim();
    sentence.contains('⟩') && matches!(clause, "or" | "or equivalently" | "that is" | "i.e.")
}

/// Whether a sentence that ends with a colon has named its things: "Let ⟨I⟩ be the tensor, with ⟨d⟩ from ⟨O⟩ to ⟨G⟩:".
fn has_named(sentence: &str) -> bool {
    let verbs = ["be the ", "be its ", "denote ", "stand for "];
    let behind = sentence
        .strip_prefix("Let ")
        .and_then(|rest| rest.split_once('⟩'))
        .map(|(_, behind)| behind.trim_start());
    sentence.ends_with("⟩:") && behind.is_some_and(|b| verbs.iter().any(|verb| b.starts_with(verb)))
}

impl Checker<'_> {
    /// Hears words, and takes what they set.
    pub(crate) fn prose(&mut self, text: &str, span: Span) {
        // What stands between a paragraph and its display ends no sentence.
        if text.trim().is_empty() {
            self.sentence.push(' ');
            return;
        }
        let lower = lowered(text);
        let opens_case = self.note_case(&lower, span, self.broken);
        // After a display, a new paragraph that opens with a capital, or another case, opens a sentence too, and so does
        // a word that has no capital but at the beginning of one.
        let opens = opens_case || text.trim_start().starts_with(char::is_uppercase);
        let first = text.trim_start().split(|c: char| !c.is_alphabetic()).next();
        let begins = self.displayed && first.is_some_and(|word| OPENINGS.contains(&word));
        let broken = std::mem::take(&mut self.broken);
        if broken && opens {
            self.led_in.clear();
        }
        if (broken && opens || begins) && self.sentence.trim_end().ends_with('⟩') {
            self.sentence.clear();
        }
        let speaks = text.contains(char::is_alphanumeric);
        if speaks {
            self.note_linear(&lower);
            self.turns_to_another_axis(&lower, span);
            self.constants_in_words(&lower, span);
            self.note_called_only_product(&lower, span);
        }
        self.sentence.push_str(text);
        if speaks {
            let whole = lowered(&self.sentence);
            if let Some(axes) = &mut self.reading.space_axes {
                axes.left |= turns_to_body(&whole);
            }
            self.residual_vanishes(&whole, span);
            self.note_momentum_on_body(&whole, span);
            for said in said(&whole).into_iter().chain(symmetry_plane(&whole)) {
                self.take(said, span);
            }
        }
        let ends = |text: &str| {
            text.rfind([". ", "? ", "! ", ".\n"].map(|s| s.chars().next().unwrap_or('.')))
        };
        if let Some(end) = ends(&self.sentence)
            && self.sentence[end..]
                .chars()
                .nth(1)
                .is_none_or(char::is_whitespace)
        {
            self.sentence.drain(..=end);
            self.cases.hypothesis = false;
        }
        keep_end(&mut self.sentence, LONGEST_SENTENCE);
    }

    /// The role that the words of the sentence give. A display right behind "with ⟨ω = Ω⟩," is the main clause.
    fn role(&self, words: Words, display: bool) -> Role {
        // "If the body is at rest, ⟨v = 0⟩" hands over; "if the products vanish: […]" claims.
        let role = match display && self.sentence.contains("if the ") {
            true => {
                let sentence = self.sentence.replace("if the ", "");
                Words::of(&sentence).role(&sentence)
            }
            false => words.role(&self.sentence),
        };
        let closed = self.sentence.trim_end().strip_suffix(',');
        let said = self.sentence.trim();
        // A display without a stop may have ended the sentence before.
        let last = said.rsplit("⟩").map(str::trim_start);
        let opened = ["With ", "For "].iter().any(|word| {
            said.starts_with(word) || last.clone().any(|piece| piece.starts_with(word))
        });
        // "… and with ⟨λ = μn⟩" and the display.
        let opened = opened
            || said
                .rfind(" with ")
                .is_some_and(|at| said[at..].matches('⟩').count() == 1);
        // "Choose, with a gain ⟨k⟩ greater than zero," and the display: what is chosen.
        let chosen = ["Choose", "Take", "Pick", "We choose", "We take"];
        let chosen = chosen.iter().any(|verb| said.starts_with(verb));
        let clause = display
            && !chosen
            && (closed.is_some_and(ends_with_condition)
                || opened && ["⟩", "⟩,", "⟩:"].iter().any(|end| said.ends_with(end)));
        match role {
            Role::Assume
                if display && (concludes_with(said) || says_again(said) || has_named(said)) =>
            {
                Role::Claim
            }
            Role::Assume | Role::Given if clause => Role::Claim,
            _ => role,
        }
    }

    /// Notes what the words before a formula say of it, and gives its role.
    pub(crate) fn listen(&mut self, display: bool) -> Role {
        let words = Words::of(&self.sentence);
        let speak = words.speak();
        self.asserted = speak && words.derive();
        self.obtained = speak && words.obtain()
            || display && words.expand()
            || follows_a_reason(&self.sentence);
        self.constrained = speak && words.constrain();
        self.firm = self.mark.is_some() || speak && words.assume();
        self.picked = words.pick();
        self.mark.unwrap_or_else(|| match speak {
            true => self.role(words, display),
            false => Role::Claim,
        })
    }

    /// A formula stands in the sentence as its letters and digits and a mark; a display with a stop in it ends it.
    pub(crate) fn hear_formula(&mut self, formula: &Formula) {
        // An axis is heard by the name that it is read by: the z of `Gz`, the x of a \xi.
        let axis = lone_axis(formula).map(str::to_owned);
        let plain = axis.unwrap_or_else(|| self.as_heard(formula.span));
        self.sentence.push_str(&format!(" {plain} ⟨⟩"));
        keep_end(&mut self.sentence, LONGEST_SENTENCE);
        if closes_sentence(self.document, formula) {
            self.sentence.clear();
        }
    }

    /// The letters and digits of a formula, as they stand in the sentence.
    pub(crate) fn as_heard(&self, span: Span) -> String {
        let text = self.document.source.slice(span).chars();
        text.filter(|c| c.is_alphanumeric() || *c == ' ').collect()
    }

    /// A paragraph ends a sentence that nothing holds open.
    pub(crate) fn end_paragraph(&mut self) {
        self.sentence.push(' ');
        if self.goes_into_display {
            self.led_in.push_str(&self.sentence);
            keep_end(&mut self.led_in, LONGEST_SENTENCE);
        }
        if !self.sentence.trim_end().ends_with([':', ',', '⟩']) {
            self.sentence.push_str(". ");
        }
        self.broken = true;
    }
}

/// The axis that a formula between words names.
fn lone_axis(formula: &Formula) -> Option<&str> {
    let [Row::Expression(node)] = formula.rows.as_slice() else {
        return None;
    };
    let symbol = lone(node).filter(|symbol| is_bare(symbol) && !formula.display)?;
    matches!(symbol.name.as_str(), "x" | "y" | "z").then_some(symbol.name.as_str())
}

/// "Since ⟨λμ = 0⟩, ⟨…⟩": what stands behind one formula of a reason follows from it.
fn follows_a_reason(sentence: &str) -> bool {
    let Some(reason) = sentence.trim_end().strip_suffix(',') else {
        return false;
    };
    let begins = ["Since ", "since ", "Because ", "because ", "As "];
    let begins = begins.iter().filter_map(|word| reason.rfind(word)).max();
    begins.is_some_and(|at| reason.ends_with('⟩') && reason[at..].matches('⟩').count() == 1)
}
