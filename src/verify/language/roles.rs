//! What sentences say of lines: their roles, and where they hold.

use super::clause::as_formula;
use super::extent::LINES;
use super::heads::INSTANT;
use super::lexicon::Class;
use super::reader::{Read, Reader};
use super::statement::{DeclaredRole, Extent, NounPhrase, Slot, Statement, Term};
use super::words::{Kind, Token};

impl Reader<'_> {
    /// "Line 5 is given", "lines 15 and 16 hold at `$t = 0$`".
    pub(crate) fn of_lines(&mut self) -> Read<Option<Vec<Statement>>> {
        let Some(lines) = self.spoken_of()? else {
            return Ok(None);
        };
        if self.take_any(&["hold", "holds"]) {
            let slots = self.holding()?;
            let one = |lines| Statement::LineHolds {
                lines,
                slots: slots.clone(),
            };
            return Ok(Some(lines.into_iter().map(one).collect()));
        }
        let roles = self.roles()?;
        let of_line = |lines: Extent| {
            let one = move |role: &DeclaredRole| Statement::Role {
                lines: lines.clone(),
                role: role.clone(),
            };
            roles.iter().map(one)
        };
        Ok(Some(lines.into_iter().flat_map(of_line).collect()))
    }

    /// The part of the document that a sentence speaks of: "lines 3 to 5", "cell 2", "the section "Tops"", "everything".
    pub(crate) fn spoken_of(&mut self) -> Read<Option<Vec<Extent>>> {
        let next = self.tokens.get(self.at + 1).map(|t| t.kind);
        match self.word() {
            "line" | "lines" | "row" | "rows" if next == Some(Kind::Number) => {
                self.lines().map(Some)
            }
            "cell" | "cells" if next == Some(Kind::Number) => {
                self.at += 1;
                self.cells_or_lines().map(Some)
            }
            "equation" | "equations" if next == Some(Kind::Open) => {
                self.at += 1;
                self.labels_from_to().map(Some)
            }
            _ if self.at_label() => self.labels_from_to().map(Some),
            "the" if self.word_at(1) == "section" && self.word_at(2).is_empty() => {
                self.at += 2;
                match self.kind() {
                    Some(Kind::Quoted) => Ok(Some(vec![Extent::Section(self.quoted()?)])),
                    _ => {
                        self.at -= 2;
                        Ok(None)
                    }
                }
            }
            "everything" => {
                self.at += 1;
                Ok(Some(vec![Extent::Document]))
            }
            _ => Ok(None),
        }
    }

    /// "cells 3 to 5", "cell 6, lines 7 and 8", behind the noun.
    pub(super) fn cells_or_lines(&mut self) -> Read<Vec<Extent>> {
        let cells = self.cells()?;
        let start = self.at;
        self.take_sign(Kind::Comma);
        let own = match cells.as_slice() {
            [own] if LINES.contains(&self.word()) => *own,
            _ => {
                self.at = start;
                return Ok(vec![Extent::Cells(cells)]);
            }
        };
        let of_cell = |lines: Extent| match lines {
            Extent::Lines { first, last, .. } => Extent::Lines {
                cell: Some(own),
                first,
                last,
            },
            other => other,
        };
        Ok(self.lines()?.into_iter().map(of_cell).collect())
    }

    fn roles(&mut self) -> Read<Vec<DeclaredRole>> {
        if self.take("starts from") || self.take("start from") {
            let formulas = self.terms()?;
            return match formulas.first().and_then(as_formula) {
                Some(formula) if formulas.len() == 1 => Ok(vec![DeclaredRole::StartsFrom(formula)]),
                _ => Err(self.unexpected("formula", "the first side could stand here", &[])),
            };
        }
        if self.take_any(&["continues", "continue"]) {
            return match self.spoken_of()?.as_deref() {
                Some([lines]) => Ok(vec![DeclaredRole::GoesOnFrom(lines.clone())]),
                _ => Err(self.unexpected("line", "one line could stand here", &[])),
            };
        }
        if !self.take_any(&["define", "defines"]) {
            return Ok(vec![self.role()?]);
        }
        if !self.at_formula() {
            return Err(self.unexpected("formula", "what the line defines could stand here", &[]));
        }
        let formulas = self.terms()?;
        let formulas = formulas.iter().filter_map(as_formula);
        Ok(formulas.map(|f| DeclaredRole::Define(Some(f))).collect())
    }

    fn role(&mut self) -> Read<DeclaredRole> {
        if self.take_any(&["is", "are"]) {
            self.take_any(&["a", "an", "the"]);
            let start = self.at;
            self.at += 1;
            match self.tokens.get(start).map_or("", |t| t.lower.as_str()) {
                "given" => return Ok(DeclaredRole::Given),
                "assumed" | "assumption" | "assumptions" | "premise" | "premises" => {
                    return Ok(DeclaredRole::Assume);
                }
                "claim" | "claims" | "claimed" | "consequence" | "consequences" | "result"
                | "results" => {
                    self.skip_remark();
                    return Ok(DeclaredRole::Claim);
                }
                "definition" | "definitions" if self.take("of") => {
                    let formula = self.terms()?.first().and_then(as_formula);
                    return Ok(DeclaredRole::Define(formula));
                }
                "definition" | "definitions" => return Ok(DeclaredRole::Define(None)),
                "left" if self.take("out") => return Ok(DeclaredRole::LeftOut),
                _ => self.at = start,
            }
        }
        Err(self.unexpected(
            "role of a line",
            "`is given`, `is assumed`, `is a claim`, `is a definition`, `is left out` or `defines …` could stand here",
            &[],
        ))
    }

    /// How a claim comes about changes nothing of what is claimed: "a claim, from the line above".
    fn skip_remark(&mut self) {
        let ends = |token: &Token| token.kind == Kind::Semicolon || token.lower == "and";
        if !self.peek().is_some_and(ends) {
            let rest = self.tokens.get(self.at..).unwrap_or_default();
            self.at += rest.iter().take_while(|token| !ends(token)).count();
        }
    }

    /// Where a line holds, behind "holds".
    fn holding(&mut self) -> Read<Vec<(Slot, Term)>> {
        let order = self.find(&[Class::Preposition]).and_then(|found| {
            let slot = match found.entry.name {
                "to first order in" => Slot::In,
                "to second order in" => Slot::InSecondOrder,
                _ => return None,
            };
            Some((slot, found.length))
        });
        let slot = if let Some((slot, length)) = order {
            self.at += length;
            slot
        } else if let Some(instant) = self.told_instant() {
            return Ok(vec![(Slot::At, instant)]);
        } else if self.take_any(&["at", "for", "when", "if"]) {
            Slot::At
        } else if self.take("in the section") {
            let name = Term::Name(self.quoted()?);
            let section = NounPhrase::new("section", vec![(Slot::Which, name)]);
            return Ok(vec![(Slot::In, Term::Phrase(Box::new(section)))]);
        } else if self.done() {
            return Ok(vec![]);
        } else {
            let help = "`at …`, `to first order in …` or `in the section \"…\"` could stand here";
            return Err(self.unexpected("word that fits", help, &[]));
        };
        let terms = self.terms()?;
        Ok(terms.into_iter().map(|term| (slot, term)).collect())
    }

    /// "at the instant when the ball begins to roll": one that is told by words has these as its name.
    fn told_instant(&mut self) -> Option<Term> {
        let words = |from: usize| self.tokens.get(from).map_or("", |t| t.lower.as_str());
        let instant = words(self.at) == "at"
            && words(self.at + 1) == "the"
            && ["instant", "moment", "time"].contains(&words(self.at + 2));
        let told = ["when", "after", "before", "at", "in", "that", "of"];
        if !instant || !told.contains(&words(self.at + 3)) {
            return None;
        }
        let rest = self.tokens.get(self.at + 3..)?;
        if rest.iter().any(|token| token.kind == Kind::Semicolon) {
            return None;
        }
        let name: Vec<&str> = rest.iter().map(|token| token.text.as_str()).collect();
        let which = Term::Name(name.join(" "));
        self.at = self.tokens.len();
        let phrase = NounPhrase::new(INSTANT, vec![(Slot::Which, which)]);
        Some(Term::Phrase(Box::new(phrase)))
    }
}
