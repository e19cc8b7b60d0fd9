//! A product, or two, that a sum has lost: found by their value in one world of the prime field.

use crate::scalar::Prime;
use crate::verify::correction::edit::Edit;
use crate::verify::repair::wanted::Wanted;
use std::collections::HashMap;

/// Words that products are made of.
const FACTORS: usize = 64;

/// Products and differences of words, by their value.
struct Products<'a> {
    factors: Vec<Factor<'a>>,
    products: HashMap<Prime, (usize, usize)>,
    /// The products again, in the order in which they were made.
    list: Vec<(Prime, usize, usize)>,
    /// Sums and differences of two words; true for a difference.
    pairs: HashMap<Prime, (usize, usize, bool)>,
    unicode: bool,
}

struct Factor<'a> {
    text: &'a str,
    value: Prime,
    inverse: Prime,
}

impl Wanted<'_> {
    /// Edits that write a lost product into a sum, or two of them.
    pub(crate) fn terms(&self) -> Vec<Edit> {
        let products = Products::new(self);
        let mut edits = vec![];
        for slot in self.slots.iter().filter(|slot| slot.is_sum()) {
            if let Some((term, cost)) = products.term(slot.more) {
                edits.push(slot.with_term(&term, cost));
            }
        }
        edits
    }
}

impl<'a> Products<'a> {
    fn new(wanted: &'a Wanted<'_>) -> Self {
        let mut factors: Vec<Factor<'a>> = vec![];
        for (word, value) in wanted.words.iter().zip(&wanted.values) {
            let Some((value, inverse)) = value.and_then(|v| Some((v, v.inverse()?))) else {
                continue;
            };
            if factors.len() < FACTORS && factors.iter().all(|f| f.value != value) {
                factors.push(Factor {
                    text: &word.text,
                    value,
                    inverse,
                });
            }
        }
        let (mut products, mut pairs, mut list) = (HashMap::new(), HashMap::new(), vec![]);
        for (i, a) in factors.iter().enumerate() {
            for (j, b) in factors.iter().enumerate() {
                if i <= j {
                    list.push((a.value * b.value, i, j));
                    products.entry(a.value * b.value).or_insert((i, j));
                }
                if i < j {
                    pairs.entry(a.value + b.value).or_insert((i, j, false));
                }
                if i != j {
                    pairs.entry(a.value - b.value).or_insert((i, j, true));
                }
            }
        }
        Self {
            factors,
            products,
            list,
            pairs,
            unicode: wanted.unicode,
        }
    }

    /// Signed terms that come to a value, the shortest first, with their cost.
    fn term(&self, value: Prime) -> Option<(String, u32)> {
        let signs = [("+", value), ("-", -value)];
        let of = |find: &dyn Fn(Prime) -> Option<String>| {
            signs
                .iter()
                .find_map(|(sign, value)| Some(format!(" {sign} {}", find(*value)?)))
        };
        of(&|v| self.pair(v))
            .or_else(|| of(&|v| self.triple(v)))
            .or_else(|| of(&|v| self.with_number(v)))
            .or_else(|| of(&|v| self.quotient(v)))
            .map(|text| (text, 20))
            .or_else(|| Some((self.two(value)?, 22)))
            .or_else(|| Some((of(&|v| self.bracketed(v))?, 23)))
    }

    fn pair(&self, value: Prime) -> Option<String> {
        let &(i, j) = self.products.get(&value)?;
        self.product(&[i, j])
    }

    fn triple(&self, value: Prime) -> Option<String> {
        self.factors.iter().enumerate().find_map(|(i, factor)| {
            let &(j, k) = self.products.get(&(value * factor.inverse))?;
            self.product(&[i, j, k])
        })
    }

    /// Twice a product of two or three words, or half of it.
    fn with_number(&self, value: Prime) -> Option<String> {
        let half = if self.unicode { "½" } else { "\\tfrac{1}{2}" };
        let two = Prime::new(2);
        let inverse = two.inverse()?;
        [("2", inverse), (half, two)]
            .into_iter()
            .find_map(|(number, by)| {
                let term = self.pair(value * by).or_else(|| self.triple(value * by))?;
                Some(format!("{number} {term}"))
            })
    }

    /// A word or a product of two over a third.
    fn quotient(&self, value: Prime) -> Option<String> {
        self.factors.iter().find_map(|below| {
            let top = value * below.value;
            let one = || self.factors.iter().find(|f| f.value == top);
            let top = self
                .pair(top)
                .or_else(|| one().map(|f| f.text.to_owned()))?;
            Some(match self.unicode {
                true => format!("{top} / {}", below.text),
                false => format!("\\frac{{{top}}}{{{}}}", below.text),
            })
        })
    }

    /// Two products, each with its sign.
    fn two(&self, value: Prime) -> Option<String> {
        self.list.iter().find_map(|&(first, i, j)| {
            let signs = [("+", first), ("-", -first)];
            signs.into_iter().find_map(|(sign, first)| {
                let rest = value - first;
                let second = [("+", rest), ("-", -rest)];
                let (other, &(k, l)) = second
                    .into_iter()
                    .find_map(|(sign, rest)| Some((sign, self.products.get(&rest)?)))?;
                let (a, b) = (self.product(&[i, j])?, self.product(&[k, l])?);
                Some(format!(" {sign} {a} {other} {b}"))
            })
        })
    }

    /// (a ± b) c or (a ± b) c d.
    fn bracketed(&self, value: Prime) -> Option<String> {
        let written = |&(a, b, minus): &(usize, usize, bool), rest: &[usize]| {
            let sign = if minus { "-" } else { "+" };
            let (a, b) = (self.factors.get(a)?.text, self.factors.get(b)?.text);
            Some(format!("({a} {sign} {b}) {}", self.product(rest)?))
        };
        let one = self
            .factors
            .iter()
            .enumerate()
            .find_map(|(i, factor)| written(self.pairs.get(&(value * factor.inverse))?, &[i]));
        one.or_else(|| {
            self.list.iter().find_map(|&(_, i, j)| {
                let inverse = self.factors.get(i)?.inverse * self.factors.get(j)?.inverse;
                written(self.pairs.get(&(value * inverse))?, &[i, j])
            })
        })
    }

    fn product(&self, factors: &[usize]) -> Option<String> {
        let texts: Option<Vec<&str>> = factors
            .iter()
            .map(|&i| self.factors.get(i).map(|f| f.text))
            .collect();
        let texts = texts?;
        let mut written: Vec<String> = vec![];
        let mut at = 0;
        while let Some(text) = texts.get(at) {
            let plain =
                !text.contains("dot") && !text.contains("frac") && !text.contains('\u{307}');
            let twice = texts.get(at + 1) == Some(text) && plain;
            written.push(match (twice, self.unicode) {
                (true, true) => format!("{text}²"),
                (true, false) => format!("{text}^2"),
                (false, _) => (*text).to_owned(),
            });
            at += 1 + usize::from(twice);
        }
        Some(written.join(" "))
    }
}
