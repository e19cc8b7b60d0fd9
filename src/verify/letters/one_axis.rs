//! Documents of a turn about one fixed axis, in which ω, L, M and I are numbers.

use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::Letter;
use crate::verify::values::quantity::Quantity;

impl Reading {
    /// Whether the inertia and the rate of turning are only ever numbers, as of a turn about one fixed axis.
    pub(crate) fn is_flat(&self) -> bool {
        let number = |name: &str| {
            let used = self.usage.get(&Letter::plain(name));
            used.vector + used.tensor + used.component + used.double == 0
        };
        let letters = ["omega", "Omega", "I", "J", "Theta", "L", "H", "h", "M"];
        let inertia = ["I", "J", "Theta"];
        self.components.is_empty()
            && letters.into_iter().all(number)
            && inertia.into_iter().any(|name| self.has_bare(name))
            && ["omega", "Omega"]
                .into_iter()
                .any(|name| self.has_bare(name))
    }

    /// A document in which ω, L, M and I are only ever numbers speaks of a turn about one fixed axis, z.
    pub(crate) fn in_a_plane(&mut self) {
        let turning = |q: &Quantity| {
            matches!(
                q,
                Quantity::AngularVelocity
                    | Quantity::AngularAcceleration
                    | Quantity::Momentum
                    | Quantity::Moment
                    | Quantity::Inertia
            )
        };
        let letters: Vec<(Letter, Quantity)> = self
            .quantities
            .iter()
            .filter(|(_, q)| turning(q))
            .map(|(l, q)| (l.clone(), *q))
            .collect();
        let number = |letter: &Letter| {
            let used = self.usage.get(letter);
            let indices = self.usage.subscripts.get(letter);
            let points = indices.is_none_or(|all| !all.iter().any(|s| runs(s)));
            points && used.vector + used.tensor + used.component + used.double == 0
        };
        let spins = |(_, q): &(Letter, Quantity)| *q == Quantity::AngularVelocity;
        let turns = self.usage.only_angle().is_some() || letters.iter().any(spins);
        let weighs = letters.iter().any(|(_, q)| *q == Quantity::Inertia);
        let parts = self.components.values().any(|(q, _)| turning(q));
        if turns && weighs && !parts && letters.iter().all(|(l, _)| number(l)) {
            for (letter, quantity) in letters {
                self.quantities.remove(&letter);
                self.components.insert(letter, (quantity, 2));
            }
            self.plane = true;
        }
    }
}

/// Whether an index runs: i, jk, k+1.
fn runs(index: &str) -> bool {
    let mut letters = index.chars().filter(|c| c.is_alphabetic());
    let runs = |c| matches!(c, 'i'..='n');
    index.len() <= 3 && letters.next().is_some_and(runs) && letters.all(runs)
}
