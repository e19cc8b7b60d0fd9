//! Roots of an equation that a document writes: `a x² + b x + c = 0`, "with the roots ⟨x_1 = …⟩ and ⟨x_2 = …⟩".

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::given::is_zero;
use crate::verify::values::atoms::{Owner, variable_fraction};
use crate::verify::values::lower::substituted;
use crate::verify::values::value::Value;
use crate::verify::verdict::{Finding, Verdict};

/// What tells roots apart.
const NUMBERS: &[&str] = &["1", "2", "3", "+", "-", "a", "b"];

/// An equation for one of its symbols.
#[derive(Clone, Debug)]
pub(crate) struct Sought {
    /// The symbol.
    unknown: u32,
    /// Its letter.
    letter: String,
    /// What must vanish.
    residual: Fraction,
}

impl Checker<'_> {
    /// Keeps an equation of the second degree or higher in a symbol that nothing determines.
    pub(crate) fn note_sought(&mut self, sides: &[Node], finding: &Finding) {
        let settled = matches!(finding.verdict, Verdict::Proved(_) | Verdict::Refuted);
        if settled || sides.len() != 2 || !sides.last().is_some_and(is_zero) {
            return;
        }
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return;
        };
        let Some(residual) = read.equations.first().and_then(|e| e.residual.as_scalar()) else {
            return;
        };
        let above = residual.numerator();
        let sought = above.variables().into_iter().find_map(|v| {
            let Some(Owner::Symbol(key)) = self.theory.atoms.owner(v) else {
                return None;
            };
            let letter = key.strip_suffix(" Scalar")?;
            (above.degree_in(v) > 1 && !letter.contains(' ')).then(|| (v, letter.to_owned()))
        });
        if let Some((unknown, letter)) = sought {
            self.sought = Some(Sought {
                unknown,
                letter,
                residual: residual.clone(),
            });
        }
    }

    /// Leaves a value open that is named as a root and does not satisfy the equation above.
    pub(crate) fn is_no_root(&mut self, left: &Node, value: &Value, finding: &mut Finding) -> bool {
        let Kind::Symbol(Symbol {
            name, subscripts, ..
        }) = &inner(left).kind
        else {
            return false;
        };
        let [label] = subscripts.as_slice() else {
            return false;
        };
        let sought = self.sought.clone().filter(|sought| sought.letter == *name);
        let (Some(sought), Some(value)) = (sought, value.as_scalar()) else {
            return false;
        };
        if !NUMBERS.contains(&label.trim()) {
            return false;
        }
        let put_in = |v: u32| match v == sought.unknown {
            true => value.clone(),
            false => variable_fraction(v),
        };
        let rest = substituted(&sought.residual, &put_in);
        let rest = self.theory.normal(&rest);
        let rest = self.theory.kernels_reduced(rest);
        // A number may be rounded; and what other lines bring in may be theirs.
        let own: Vec<u32> = [&sought.residual, value]
            .into_iter()
            .flat_map(Fraction::variables)
            .collect();
        let mut met = rest.variables().into_iter();
        let fails = rest.to_rational().is_none() && met.all(|v| own.contains(&v));
        if fails {
            finding.reason = Some("it is no root of the equation above".to_owned());
        }
        fails
    }
}
