//! Words that give the angles and the parts of the rate of a free symmetric body their names: "the angle θ between L and
//! the symmetry axis".

use crate::notation::ast::{Function, Kind, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::usage::{Letter, axis, inner};
use crate::verify::lines::points::Law;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::values::value::Value;
use crate::verify::words::book::{has_any, lowered};

const AXES: &[&str] = &[
    "symmetry axis",
    "symmetry-axis",
    "axis of symmetry",
    "axis of the body",
    "'s axis",
    "drum axis",
    "polar axis",
    "its axis",
    "figure axis",
    "axis of figure",
    "spin axis",
    "bearing axis",
    "rotor axis",
    "axis of the rotor",
    "wheel axis",
    "axis of the wheel",
    "axis of the plate",
    "axis of the disc",
    "axis of the disk",
    "axis of the coin",
    "axis of the top",
    "axis of the cylinder",
    "axis of the satellite",
    "axis of the spacecraft",
    "axis of the projectile",
    "common axis",
    "3-axis",
    "third axis",
];
/// What is along the angular velocity.
const TURNING: &[&str] = &[
    "angular velocity",
    "rotation axis",
    "axis of rotation",
    "instantaneous axis",
];
const ANGLES: &[&str] = &[
    "theta", "vartheta", "alpha", "beta", "gamma", "delta", "nu", "phi",
];
/// How a vector stands off the axis.
const LEANS: &[&str] = &[
    "leans",
    "is inclined",
    "are inclined",
    "is tilted",
    "are tilted",
    "deviates",
];
/// A part of the angular velocity.
struct Part {
    name: &'static str,
    across: bool,
    /// What is said of it.
    said: &'static [&'static str],
    labels: &'static [&'static str],
}

const PARTS: [Part; 2] = [
    Part {
        name: "transverse part",
        across: true,
        said: &[
            "transverse",
            "perpendicular to the",
            "equatorial",
            "across the",
            "across it",
            "across ⟨",
        ],
        labels: &["t", "T", "tr", "perp", "⊥", "n", "12"],
    },
    Part {
        name: "axial part",
        across: false,
        said: &[
            "axial",
            "along the",
            "along ⟨",
            "along it",
            "about the symmetry axis",
            "about the axis of symmetry",
            "about its axis",
            "about the figure axis",
        ],
        labels: &["a", "A", "s", "ax", "axial", "∥", "parallel"],
    },
];

impl Checker<'_> {
    /// Notes what the words call such an angle, and ties the parts of the angular velocity.
    pub(crate) fn note_cones(&mut self) {
        let mut spoken_of = false;
        let mut before = None;
        for sentence in self.text.sentences() {
            let text = sentence.numbered();
            spoken_of |= has_any(&text, AXES);
            let symbols: Vec<&Symbol> = sentence.symbols().map(|(symbol, _)| symbol).collect();
            let last = std::mem::replace(&mut before, self.vector_of(&text, &symbols));
            if symbols.is_empty() {
                continue;
            }
            let axis = spoken_of && text.contains("axis");
            let leans = axis && has_any(&text, LEANS);
            for clause in text.split([',', ';', ':']).flat_map(parted) {
                let named = self.names_axis(clause, &symbols);
                let axis = axis || named.is_some();
                if axis && clause.contains("angle") && !clause.contains("vertical") {
                    self.note_cone(clause, &symbols, named, last);
                }
                if leans {
                    self.note_lean(clause, &symbols);
                }
                for part in PARTS.iter().filter(|part| has_any(clause, part.said)) {
                    self.note_part(clause, &symbols, part);
                }
            }
        }
    }

    /// Notes the angle of which a line gives the tangent, sine or cosine, right behind words for it that have no letter:
    /// "the nutation angle is given by ⟨\tan\theta = …⟩", "and the angle between ⟨ω⟩ and the spin axis by".
    pub(crate) fn note_cone_by_line(&mut self, sides: &[Node]) {
        let Some(Kind::Function(Function::Tan | Function::Sin | Function::Cos, argument)) =
            sides.first().map(|side| &inner(side).kind)
        else {
            return;
        };
        let new = self.new_symbol(argument).filter(|(_, at)| at.is_none());
        let Some((Kind::Symbol(angle), _)) = new.map(|found| (&inner(argument).kind, found)) else {
            return;
        };
        let said = lowered(&self.sentence);
        // Words that give the angle a letter are heard elsewhere.
        let letters = said.split(|c: char| !c.is_alphanumeric());
        if letters.into_iter().any(|word| word == angle.name) {
            return;
        }
        let clause = said.rsplit([',', ';', ':']).find(|c| c.contains("angle"));
        let Some(clause) = clause.filter(|clause| !clause.contains("vertical")) else {
            return;
        };
        let nutation = has_any(clause, &["nutation angle", "angle of nutation"]);
        let quantity = match self.vector_of(clause, &[]) {
            None if nutation => Some(Quantity::Momentum),
            found => found.filter(|_| nutation || has_any(clause, AXES)),
        };
        let angle = angle.clone();
        if let (Some(quantity), Meaning::Whole(entity)) = (quantity, self.meaning_of(&angle)) {
            let variable = self.theory.atoms.part(entity, 0, 0);
            self.theory
                .cones
                .entry(variable)
                .or_insert((quantity, None));
            self.known.insert(entity);
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

    /// "The angular velocity leans from the axis by ⟨α⟩", "the angular momentum by ⟨θ⟩".
    fn note_lean(&mut self, clause: &str, symbols: &[&Symbol]) {
        let met = in_clause(clause, symbols);
        let named = met.iter().find(|(at, symbol)| {
            let mark = format!(" by ⟨{at}⟩");
            symbol.subscripts.is_empty()
                && ANGLES.contains(&symbol.name.as_str())
                && clause.contains(&mark)
        });
        let (Some((_, angle)), Some(quantity)) = (named, self.vector_of(clause, symbols)) else {
            return;
        };
        if let Meaning::Whole(entity) = self.meaning_of(angle) {
            let variable = self.theory.atoms.part(entity, 0, 0);
            self.theory.cones.insert(variable, (quantity, None));
        }
    }

    /// `last` is the vector that the sentence before speaks of, which "the angle between it and the axis" is of.
    fn note_cone(
        &mut self,
        clause: &str,
        symbols: &[&Symbol],
        axis: Option<u8>,
        last: Option<Quantity>,
    ) {
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
            let rest = rest.replacen("nutation angle", "angle", 1);
            let plain = symbol.subscripts.is_empty() && ANGLES.contains(&symbol.name.as_str());
            let between = lead.contains("angle between") && lead.ends_with(" is");
            plain
                && (lead.ends_with("angle")
                    || between
                    || said.iter().any(|words| rest.starts_with(words)))
        };
        let mut angles = met.iter().filter(names_angle);
        let (Some((_, angle)), None) = (angles.next(), angles.next()) else {
            return;
        };
        let it = ["between it and", "and it ", "that it makes"];
        let it = last.filter(|_| has_any(clause, &it));
        let Some(quantity) = self.vector_of(clause, symbols).or(it) else {
            return;
        };
        if let Meaning::Whole(entity) = self.meaning_of(angle) {
            let variable = self.theory.atoms.part(entity, 0, 0);
            self.theory.cones.insert(variable, (quantity, axis));
        }
    }

    /// The one of momentum and angular velocity that a text speaks of.
    fn vector_of(&self, text: &str, symbols: &[&Symbol]) -> Option<Quantity> {
        let met = in_clause(text, symbols);
        let speaks = |quantity: Quantity, words: &[&str]| {
            let letter =
                |s: &Symbol| self.reading.quantities.get(&Letter::of(s)) == Some(&quantity);
            // Plain text has the letter of a vector as a word: "the angle θ between the axis and H".
            let mut quantities = self.reading.quantities.iter();
            let spelled = quantities.any(|(letter, of)| {
                let mut words = text.split([' ', '.']);
                *of == quantity && words.any(|word| word.eq_ignore_ascii_case(&letter.name))
            });
            has_any(text, words) || spelled || met.iter().any(|(_, s)| letter(s))
        };
        let momentum = speaks(Quantity::Momentum, &["angular momentum"]);
        let rate = speaks(Quantity::AngularVelocity, TURNING);
        match (momentum, rate) {
            (true, false) => Some(Quantity::Momentum),
            (false, true) => Some(Quantity::AngularVelocity),
            _ => None,
        }
    }

    /// "⟨ω_t⟩ the magnitude of the transverse component", "the component along the axis is ⟨ω_a⟩", beside an ω along the
    /// third axis.
    fn note_part(&mut self, clause: &str, symbols: &[&Symbol], part: &Part) {
        let turns = |s: &Symbol| {
            let letter = Letter::of(s);
            let label = |one: &String| part.labels.contains(&one.trim());
            let labelled = matches!(s.subscripts.as_slice(), [one] if label(one));
            let usage = &self.reading.usage;
            let met = |axes: &[&str]| axes.iter().any(|axis| usage.has_index(&letter, axis));
            // An ω₁ and an ω₂ without a third are rates before and after.
            let axial = met(&["3", "z"]) || !met(&["x", "y"]);
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
        let [x, y, z] = self.theory.atoms.vector(omega, 0);
        let value = match part.across {
            true => self
                .theory
                .kernel(Function::Sqrt, x.clone() * x + y.clone() * y),
            false => z,
        };
        if let Some(entity) = self.entity_named(symbol) {
            self.take_law(Law::new(part.name, entity, Value::scalar(value)));
        }
    }
}

/// The parts of a clause that name an angle each: "⟨θ⟩ the angle …", "and ⟨γ⟩ the angle …", "while …".
fn parted(clause: &str) -> Vec<&str> {
    let mut all = vec![];
    for part in clause.split(" while ") {
        let named = |at: usize| {
            let behind = part[at..]
                .split_once('⟩')
                .map(|(_, rest)| rest.trim_start());
            behind.is_some_and(|rest| rest.starts_with("the angle"))
        };
        let starts: Vec<usize> = part.match_indices(" and ⟨").map(|(at, _)| at).collect();
        let cut = starts.into_iter().find(|&at| named(at));
        match cut {
            Some(at) => all.extend([&part[..at], &part[at..]]),
            None => all.push(part),
        }
    }
    all
}

/// The symbols of a clause with their numbers.
fn in_clause<'d>(clause: &str, symbols: &[&'d Symbol]) -> Vec<(usize, &'d Symbol)> {
    let marked = symbols.iter().enumerate();
    marked
        .filter(|(at, _)| clause.contains(&format!("⟨{at}⟩")))
        .map(|(at, symbol)| (at, *symbol))
        .collect()
}
