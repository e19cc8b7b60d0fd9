//! Two points of one rigid body, `\mathbf v_B = \mathbf v_A + \boldsymbol\omega\times\mathbf r_{AB}`, one of which may be at rest.

use crate::notation::ast::Symbol;
use crate::verify::check::Checker;
use crate::verify::letters::particles::PLACES;
use crate::verify::lines::points::{Law, label};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::value::Value;
use crate::verify::words::book::{has_any, lowered};

/// Words for a point of the body, and for the one that it turns about.
const ELEMENTS: &[&str] = &["element", "particle", "point of the body", "mass point"];
const FIXED_POINT: &[&str] = &["fixed point", "point fixed", "pivot"];
/// Words behind the letter of a point that does not move.
const AT_REST: &[&str] = &["is fixed", "is at rest", "does not move", "is stationary"];

impl Checker<'_> {
    /// The velocity of a point of a rigid body by that of another, with the arm that a line has between them.
    pub(crate) fn points_of_one_body(&mut self, left: &Symbol, met: &[&Symbol]) -> Option<Law> {
        let to = point_of_velocity(left)?;
        if self.reading.moving_point.is_some() || !self.is_new(left) || !self.text.says(&["rigid"])
        {
            return None;
        }
        let others = met.iter().filter(|s| **s != left && s.name == left.name);
        let others: Vec<&str> = others
            .map(|s| point_of_velocity(s))
            .collect::<Option<_>>()?;
        let (arm, from, there) = met.iter().find_map(|s| {
            let labels = arm_labels(s)?;
            let from = labels.iter().find(|from| **from != to)?;
            Some((*s, from.clone(), self.leads(s, from, to)?))
        })?;
        if others.iter().any(|other| *other != from) {
            return None;
        }
        let base = Symbol {
            subscripts: vec![from],
            ..left.clone()
        };
        let [base, arm] = [self.entity_named(&base)?, self.entity_named(arm)?];
        // Between points of the body the vector keeps its components on the axes of the body.
        self.theory.atoms.info_mut(arm).constant = true;
        self.known.extend([base, arm]);
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let [base, arm, omega] =
            [base, arm, omega].map(|e| Value::column(self.theory.atoms.vector(e, 0)));
        let turned = omega.cross(&arm).ok()?;
        let value = base.plus(&turned, !there).ok()?;
        let entity = self.entity_named(left)?;
        Some(Law::new("points of a rigid body", entity, value).said())
    }

    /// The velocity of an element of a rigid body that turns about a fixed point, with its place as the author calls it:
    /// `\mathbf v = \boldsymbol\omega\times\mathbf r`.
    pub(crate) fn element_about_fixed_point(
        &mut self,
        left: &Symbol,
        met: &[&Symbol],
    ) -> Option<Law> {
        let plain =
            |s: &Symbol| s.style.vector && s.subscripts.is_empty() && s.superscripts.is_empty();
        let place = |s: &&&Symbol| plain(s) && PLACES.contains(&s.name.as_str());
        if left.name != "v"
            || !plain(left)
            || self.reading.moving_point.is_some()
            || !self.is_new(left)
            || !self.text.says(&["rigid"])
            || !has_any(&lowered(&self.sentence), ELEMENTS)
            || !self.text.says(FIXED_POINT)
        {
            return None;
        }
        let place = *met.iter().find(place)?;
        let (velocity, place) = (self.entity_named(left)?, self.entity_named(place)?);
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let [place, omega] = [place, omega].map(|e| Value::column(self.theory.atoms.vector(e, 0)));
        let value = omega.cross(&place).ok()?;
        Some(Law::new("rigid", velocity, value))
    }

    /// "If A is fixed": the velocity and the acceleration that have its letter vanish.
    pub(crate) fn note_points_at_rest(&mut self, met: &[&Symbol]) {
        let sentence = lowered(&self.sentence);
        if !has_any(&sentence, AT_REST) {
            return;
        }
        let arms = met.iter().filter_map(|s| Some((s, arm_labels(s)?)));
        let ends = arms.flat_map(|(arm, points)| points.map(|point| (arm, point)));
        for (arm, point) in ends {
            let letter = point.to_lowercase();
            let mut said = AT_REST.iter().flat_map(|words| {
                [
                    format!(" {letter} {words}"),
                    format!(" {letter} ⟨⟩ {words}"),
                ]
            });
            if !said.any(|words| format!(" {sentence}").contains(&words)) {
                continue;
            }
            for name in ["v", "a"] {
                let of = Symbol {
                    name: name.to_owned(),
                    subscripts: vec![point.clone()],
                    style: arm.style,
                    ..Symbol::default()
                };
                self.put_at_rest(&of, &point);
            }
        }
    }

    fn put_at_rest(&mut self, symbol: &Symbol, point: &str) {
        let Some(entity) = self.entity_named(symbol).filter(|&e| self.is_free(e)) else {
            return;
        };
        let name = format!("{point} is at rest: {}", symbol.name);
        self.vanishes_in(&name, entity, &[0, 1, 2]);
        self.known.insert(entity);
    }
}

/// The letter of the point that a velocity is of.
fn point_of_velocity(symbol: &Symbol) -> Option<&str> {
    let vector = symbol.style.vector && symbol.superscripts.is_empty() && symbol.primes == 0;
    label(symbol).filter(|point| vector && symbol.name == "v" && !point.is_empty())
}

/// The letters of the two points that a vector leads between.
fn arm_labels(symbol: &Symbol) -> Option<[String; 2]> {
    let index = symbol.subscripts.concat().replace('/', "");
    let letters = match index.is_empty() {
        true => symbol.name.as_str(),
        false => index.as_str(),
    };
    let mut points = letters.chars().filter(char::is_ascii_uppercase);
    let found = [points.next()?, points.next()?].map(String::from);
    (symbol.style.vector && letters.len() == 2).then_some(found)
}
