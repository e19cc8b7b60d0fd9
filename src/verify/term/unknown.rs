//! Letters that no sentence tells of: those of custom, and new ones.

use crate::algebra::{Fraction, Place};
use crate::notation::ast::{Node, Symbol};
use crate::notation::print;
use crate::verify::model::atoms::{Key, Motion, Nature, Space, fraction, whole};
use crate::verify::term::labels::{letters_of, plain};

use crate::verify::term::lower::Lowering;
use crate::verify::term::symbols::symbol_node;
use crate::verify::term::value::{Basis, Shape, Trouble, Value, Valued, beyond};

impl Lowering<'_> {
    /// δ_{jk}, ε_{ijk}, π.
    pub(super) fn by_custom(&mut self, symbol: &Symbol) -> Option<Valued> {
        let axes: Option<Vec<usize>> = match symbol.subscripts.as_slice() {
            [] => Some(vec![]),
            [label] => letters_of(label, |l| self.axis_of_letter(l).is_some())
                .iter()
                .map(|letter| self.axis_of_letter(letter))
                .collect(),
            labels => labels
                .iter()
                .map(|l| self.axis_of_letter(&plain(l)))
                .collect(),
        };
        let number = |n: i64| Some(Ok(Value::scalar(whole(n))));
        match (symbol.name.as_str(), axes?.as_slice()) {
            ("delta", [j, k]) => number(i64::from(j == k)),
            ("epsilon" | "varepsilon", &[i, j, k]) => {
                let sign = [(0, 1, 2), (1, 2, 0), (2, 0, 1)].contains(&(i, j, k));
                let other = [(0, 2, 1), (2, 1, 0), (1, 0, 2)].contains(&(i, j, k));
                number(i64::from(sign) - i64::from(other))
            }
            ("pi", []) => Some(Ok(Value::scalar(self.system.atoms.pi()))),
            ("t", [])
                if symbol.superscripts.is_empty() && !symbol.style.vector && !symbol.style.hat =>
            {
                Some(Ok(Value::scalar(self.system.atoms.time())))
            }
            _ => None,
        }
    }

    /// An angle in degrees; other units are not worked with.
    pub(super) fn with_unit(&mut self, number: &Node, unit: &str) -> Valued {
        if unit != "deg" {
            return beyond("units of measurement");
        }
        let degree = self.system.atoms.pi() * Fraction::from_ratio(1, 180);
        Ok(self.value(number)?.scaled(&degree))
    }

    /// A letter of which nothing is told: variables that a definition may settle.
    pub(super) fn unknown(&mut self, symbol: &Symbol) -> Valued {
        self.unknown_by(symbol, print::latex(&symbol_node(symbol)))
    }

    /// A letter of which nothing is told, by its name in messages.
    pub(super) fn unknown_by(&mut self, symbol: &Symbol, text: String) -> Valued {
        if self.only_known {
            return Err(Trouble::Unknown(text));
        }
        let shape = self.known.shapes.get(&text).copied();
        let vector = symbol.style.vector || self.unknown.get(&text).is_some_and(|vector| *vector);
        let (rows, columns) = if symbol.style.tensor {
            (3, 3)
        } else if vector || symbol.resultant && symbol.style.hat {
            (3, 1)
        } else {
            (1, 1)
        };
        let drawn = Shape {
            rows,
            columns,
            basis: [Basis::Itself; 2],
        };
        let member = self.member_of(symbol);
        let value = self.unknown_entries(&text, shape.unwrap_or(drawn), member);
        let told = |e: &Fraction| {
            e.as_variable()
                .is_some_and(|v| self.system.atoms.atom(v).nature != Nature::Unknown)
        };
        if !value.entries.iter().all(told) {
            self.unknown.entry(text).or_default();
        }
        Ok(value)
    }

    /// A letter to which a sign is put that only vectors take: so it is one, also where nothing else is told of it.
    pub(super) fn vector(&mut self, symbol: &Symbol) -> Valued {
        let text = print::latex(&symbol_node(symbol));
        let before = self.unknown.contains_key(&text);
        let value = self.symbol(symbol)?;
        if before || !self.unknown.contains_key(&text) || !value.is_scalar() {
            return Ok(value);
        }
        let shape = Shape {
            rows: 3,
            columns: 1,
            basis: [Basis::Itself; 2],
        };
        self.unknown.insert(text.clone(), true);
        Ok(self.unknown_entries(&text, shape, None))
    }

    /// A letter of which nothing is told, in a shape that the other side of its line has.
    pub(crate) fn unknown_of_shape(&mut self, text: &str, shape: Shape) -> Value {
        self.unknown_entries(text, shape, None)
    }

    pub(super) fn member_of(&self, symbol: &Symbol) -> Option<String> {
        symbol
            .subscripts
            .iter()
            .find_map(|label| self.system.index_in(label).map(|(_, index)| index))
    }

    pub(super) fn unknown_entries(
        &mut self,
        text: &str,
        shape: Shape,
        member: Option<String>,
    ) -> Value {
        let Shape {
            rows,
            columns,
            basis,
        } = shape;
        let entries = (0..rows * columns).map(|at| {
            let text = match (rows, columns) {
                (1, 1) => text.to_owned(),
                (_, 1) => crate::verify::model::system::component_text(text, at),
                _ => format!("{{{text}}}_{{{}{}}}", at / columns + 1, at % columns + 1),
            };
            let key = Key {
                member: member.clone(),
                space: Space::Unknown,
                ..Key::new(text)
            };
            let known = self.system.atoms.find(&key).is_some();
            let variable = self
                .system
                .atoms
                .variable(key, Place::Coordinate, Motion::Free);
            if !known {
                self.system.atoms.atom_mut(variable).nature = Nature::Unknown;
            }
            fraction(variable)
        });
        let entries = entries.collect();
        Value {
            rows,
            columns,
            entries,
            basis,
        }
    }
}
