//! Unit vectors along, around and up, `\hat r`, `\hat\phi`, `\hat z` or `e_r`, `e_\phi`, `e_z`: they are the axes used, and turn.

use crate::notation::ast::Symbol;
use crate::verify::letters::usage::{Letter, Usage};

/// Letters of what points outwards, and of what points around.
const OUTWARDS: &[&str] = &["r", "rho"];
const AROUND: &[&str] = &["phi", "varphi", "theta", "vartheta"];
/// Letters that unit vectors have an index on.
const BASES: &[&str] = &["e", "u"];

/// Three unit vectors by the letters in them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct RoundAxes {
    /// The letter that has the three as its indices; `None` where they wear hats.
    base: Option<String>,
    outwards: String,
    around: String,
}

impl RoundAxes {
    /// Those of a document that writes all three and no others.
    pub(crate) fn of(usage: &Usage) -> Option<Self> {
        let hatted = |name: &str| usage.get(&Letter::plain(name)).hats > 0;
        let bases = BASES.iter().map(|base| Some(Letter::plain(base)));
        bases.chain([None]).find_map(|base| {
            let met = |name: &str| match &base {
                Some(base) => {
                    usage.get(base).vector + usage.get(base).hats > 0 && usage.has_index(base, name)
                }
                None => hatted(name),
            };
            let one = |names: &[&str]| {
                let mut found = names.iter().filter(|name| met(name));
                found
                    .next()
                    .filter(|_| found.next().is_none())
                    .map(|name| (*name).to_owned())
            };
            let upwards = met("z") || met("k");
            let others = ["x", "y", "i", "j", "1", "2"].iter().any(|name| met(name));
            let (outwards, around) = (one(OUTWARDS)?, one(AROUND)?);
            (upwards && !others).then(|| Self {
                base: base.clone().map(|base| base.name),
                outwards,
                around,
            })
        })
    }

    /// The angle that they turn by, where it moves.
    pub(crate) fn angle(&self) -> Symbol {
        Symbol {
            name: self.around.clone(),
            ..Symbol::default()
        }
    }

    /// The place of a unit vector among them.
    pub(crate) fn axis(&self, symbol: &Symbol) -> Option<u8> {
        let name = match (&self.base, symbol.subscripts.as_slice()) {
            (None, []) if symbol.style.hat => &symbol.name,
            (Some(base), [index]) if symbol.name == *base => index,
            _ => return None,
        };
        match name.as_str() {
            name if name == self.outwards => Some(0),
            name if name == self.around => Some(1),
            "z" | "k" => Some(2),
            _ => None,
        }
    }
}
