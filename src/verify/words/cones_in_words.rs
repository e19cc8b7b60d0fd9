//! Words that give the angles and the transverse rate of a free symmetric body their names: "the angle θ between L and
//! the symmetry axis".

use crate::notation::ast::Symbol;
use crate::verify::check::Checker;
use crate::verify::letters::usage::{Letter, axis};
use crate::verify::lines::points::Law;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::values::value::Value;
use crate::verify::words::book::has_any;
use crate::verify::words::sentences::{Paragraphs, sentences};

const AXES: &[&str] = &[
    "symmetry axis",
    "symmetry-axis",
    "axis of symmetry",
    "axis of the body",
    "body's axis",
    "figure axis",
    "axis of figure",
    "spin axis",
    "3-axis",
    "third axis",
];
const ANGLES: &[&str] = &[
    "theta", "vartheta", "alpha", "beta", "gamma", "delta", "nu", "phi",
];
/// What is said of the part of the angular velocity across the axis.
const ACROSS: &[&str] = &["transverse", "perpendicular to the", "equatorial"];
/// Labels of that part.
const LABELS: &[&str] = &["t", "T", "tr", "perp", "⊥", "n", "12"];

impl Checker<'_> {
    /// Notes what the words call such an angle, and ties the transverse rate.
    pub(crate) fn note_cones(&mut self) {
        for sentence in sentences(self.document, Paragraphs::Apart) {
            let symbols: Vec<&Symbol> = sentence.symbols().map(|(symbol, _)| symbol).collect();
            if symbols.is_empty() {
                continue;
            }
            let text = sentence.numbered();
            let axis = has_any(&text, AXES);
            for clause in text.split([',', ';', ':']).flat_map(|c| c.split(" while ")) {
                let named = self.names_axis(clause, &symbols);
                let axis = axis || named.is_some();
                if axis && clause.contains("angle") && !clause.contains("vertical") {
                    self.note_cone(clause, &symbols, named);
                }
                if has_any(clause, ACROSS) {
                    self.note_transverse_rate(clause, &symbols);
                }
            }
        }
    }

    /// The axis that a clause names by a formula, "the ⟨z⟩ axis", "⟨\hat e_3⟩", or by its number, "axis 3".
    fn names_axis(&mut self, clause: &str, symbols: &[&Symbol]) -> Option<u8> {
        let words: Vec<&str> = clause.split([' ', '.']).collect();
        let mut pairs = words.windows(2);
        let numbered = pairs.find_map(|pair| axis(pair[1]).filter(|_| pair[0] == "axis"));
        numbered.or_else(|| {
            in_clause(clause, symbols)
                .into_iter()
                .find_map(|(at, symbol)| {
                    if let Meaning::UnitVector(axis) = self.meaning_of(symbol) {
                        return Some(axis);
                    }
                    let mark = format!("⟨{at}⟩");
                    let (before, behind) = clause.split_once(&mark)?;
                    let lead = before.trim_end();
                    let spoken = behind.trim_start_matches(['-', ' ']).starts_with("axis")
                        || lead.ends_with("axis");
                    let plain = symbol.subscripts.is_empty() && !symbol.style.vector;
                    axis(&symbol.name).filter(|_| spoken && plain)
                })
        })
    }

    fn note_cone(&mut self, clause: &str, symbols: &[&Symbol], axis: Option<u8>) {
        let met = in_clause(clause, symbols);
        let names_angle = |(at, symbol): &&(usize, &Symbol)| {
            let mark = format!("⟨{at}⟩");
            let (before, behind) = clause.split_once(&mark).unwrap_or((clause, ""));
            let lead = before.trim_end();
            let rest = behind.trim_start().replacen("constant angle", "angle", 1);
            let rest = rest.replacen("fixed angle", "angle", 1);
            let said = [
                "is the angle",
                "the angle",
                "be the angle",
                "denotes the angle",
            ];
            let plain = symbol.subscripts.is_empty() && ANGLES.contains(&symbol.name.as_str());
            plain && (lead.ends_with("angle") || said.iter().any(|words| rest.starts_with(words)))
        };
        let mut angles = met.iter().filter(names_angle);
        let (Some((_, angle)), None) = (angles.next(), angles.next()) else {
            return;
        };
        let speaks = |quantity: Quantity, words: &str| {
            let letter =
                |s: &Symbol| self.reading.quantities.get(&Letter::of(s)) == Some(&quantity);
            clause.contains(words) || met.iter().any(|(_, s)| letter(s))
        };
        let momentum = speaks(Quantity::Momentum, "angular momentum");
        let rate = speaks(Quantity::AngularVelocity, "angular velocity");
        let quantity = match (momentum, rate) {
            (true, false) => Quantity::Momentum,
            (false, true) => Quantity::AngularVelocity,
            _ => return,
        };
        if let Meaning::Whole(entity) = self.meaning_of(angle) {
            let variable = self.theory.atoms.part(entity, 0, 0);
            self.theory.cones.insert(variable, (quantity, axis));
        }
    }

    /// "⟨ω_t⟩ the magnitude of the transverse component", beside an ω along the third axis.
    fn note_transverse_rate(&mut self, clause: &str, symbols: &[&Symbol]) {
        let turns = |s: &Symbol| {
            let letter = Letter::of(s);
            let labelled = matches!(s.subscripts.as_slice(), [one] if LABELS.contains(&one.trim()));
            let usage = &self.reading.usage;
            let axial = ["3", "z"].iter().any(|axis| usage.has_index(&letter, axis))
                || usage.get(&letter).component == 0;
            let rate = self.reading.quantities.get(&letter) == Some(&Quantity::AngularVelocity);
            labelled && axial && rate && !s.style.vector
        };
        let found = in_clause(clause, symbols)
            .into_iter()
            .find(|(_, s)| turns(s));
        let Some((_, symbol)) = found.filter(|(_, s)| self.is_new(s)) else {
            return;
        };
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let [x, y, _] = self.theory.atoms.vector(omega, 0);
        let across = x.clone() * x + y.clone() * y;
        let across = self
            .theory
            .kernel(crate::notation::ast::Function::Sqrt, across);
        if let Some(entity) = self.entity_named(symbol) {
            self.take_law(Law::new("transverse part", entity, Value::scalar(across)));
        }
    }
}

/// The symbols of a clause with their numbers.
fn in_clause<'d>(clause: &str, symbols: &[&'d Symbol]) -> Vec<(usize, &'d Symbol)> {
    let marked = symbols.iter().enumerate();
    marked
        .filter(|(at, _)| clause.contains(&format!("⟨{at}⟩")))
        .map(|(at, symbol)| (at, *symbol))
        .collect()
}
