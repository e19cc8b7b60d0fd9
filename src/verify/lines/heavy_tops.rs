//! The moment of the weight of a top, l k × (−m g K): K is the upward vertical, about which the first of the body's angles
//! turns, and k the axis of the top, on which the mass centre lies.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{inner, symbols};
use crate::verify::theory::Premise;
use crate::verify::values::atoms::{Entity, Owner, variable_fraction};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::value::Value;
use crate::verify::verdict::{Finding, Verdict};
use num_traits::Zero;

const NAME: &str = "moment of the weight";

/// Words of what acts.
const WEIGHT: &[&str] = &[
    "weight",
    "gravity",
    "heavy top",
    "heavy symmetric",
    "potential energy",
];
/// Words of a vertical that points down, and of what acts beside the weight.
const OTHERWISE: &[&str] = &[
    "downward", "hang", "pendulum", "below", "torque", "couple", "friction", "drag", "motor",
];

impl Checker<'_> {
    /// Takes the weight for what acts, where a claim with a weight in it is proved by that and has the moment alone on
    /// its left or nowhere.
    pub(crate) fn tie_weight(&mut self, sides: &[Node], finding: &Finding) {
        let said = self.text.says(WEIGHT) && !self.text.says(OTHERWISE);
        let met: Vec<&Symbol> = sides.iter().flat_map(symbols).collect();
        let weighs = met.iter().any(|s| s.name == "g" && s.subscripts.is_empty());
        if !said || !weighs || !self.reading.speaks_of(Quantity::Mass) {
            return;
        }
        let Some(angles) = self.reading.euler_angles.clone() else {
            return;
        };
        let moment = self.theory.atoms.quantity(Quantity::Moment);
        // `\Sigma M_x = mgl\sin\theta` says what the words do.
        let says = matches!(sides, [left, right] if matches!(inner(left).kind, Kind::Symbol(_))
            && !self.entities([right]).contains(&moment));
        let written = self.entities(sides).contains(&moment);
        if self.theory.mentions_entity(moment) || written && !says {
            return;
        }
        let Some(up) = self.first_axis(&angles) else {
            return;
        };
        let across = Value::axis(2).cross(&Value::column(up.as_slice().to_vec()));
        let Ok(across) = across else { return };
        for arm in self.arms_of_weight(&met) {
            if self.is_moved_by(&across, arm, &met, sides, finding) {
                return;
            }
        }
    }

    /// Whether a claim is proved with the weight at such a distance; it is kept then.
    fn is_moved_by(
        &mut self,
        across: &Value,
        arm: Entity,
        met: &[&Symbol],
        sides: &[Node],
        finding: &Finding,
    ) -> bool {
        let gravity = met.iter().find(|s| s.name == "g");
        let Some(gravity) = gravity.and_then(|s| self.entity_named(s)) else {
            return false;
        };
        let mass = self.theory.atoms.quantity(Quantity::Mass);
        let [mass, pull, length] = [mass, gravity, arm].map(|e| self.theory.atoms.value(e, 0, 0));
        let moment = self.theory.atoms.quantity(Quantity::Moment);
        let parts = [0, 1, 2].map(|c| self.theory.atoms.part(moment, c, 0));
        let acts = across.scaled(&(mass * pull * length));
        let residual =
            |(part, acts): (&Variable, &Fraction)| variable_fraction(*part) + acts.clone();
        self.theory.assume(Premise {
            name: NAME.to_owned(),
            residuals: parts.iter().zip(&acts.entries).map(residual).collect(),
            preferred: parts.to_vec(),
            definition: false,
        });
        let known = self.known.clone();
        self.known.extend([arm, gravity]);
        let verdict = self.verdict_as_claim(sides, finding);
        let proved = matches!(verdict, Verdict::Proved(_));
        if proved {
            self.keep(NAME, false);
        } else {
            self.known = known;
            self.theory.retain(|premise| premise.name != NAME);
        }
        proved
    }

    /// Whether a premise speaks of an entity that is no definition of something by it, as that of a potential energy is.
    fn is_said_of(&self, entity: Entity) -> bool {
        let premises = self.theory.premises().iter().filter(|p| !p.definition);
        let mut said = premises
            .flat_map(|p| &p.residuals)
            .flat_map(Fraction::variables);
        said.any(|v| self.theory.atoms.entity_of(v) == Some(entity))
    }

    /// Numbers of the document that may be the distance of the mass centre.
    fn arms_of_weight(&mut self, met: &[&Symbol]) -> Vec<Entity> {
        let mut arms = vec![];
        for symbol in met.iter().filter(|s| s.name != "g") {
            let Some(entity) = self.entity_named(symbol) else {
                continue;
            };
            let info = self.theory.atoms.info(entity);
            let number = info.shape == Shape::Scalar && matches!(info.owner, Owner::Symbol(_));
            let number = number && info.constant && !arms.contains(&entity);
            if number && self.is_free(entity) && !self.is_said_of(entity) {
                arms.push(entity);
            }
        }
        arms.truncate(3);
        arms
    }

    /// Whether what is called a potential energy is not the weight times a height of the mass centre, where the angles and
    /// the mass of a top are known.
    pub(crate) fn misses_the_height(&mut self, right: &Node) -> bool {
        let met = symbols(right);
        let gravity = met
            .iter()
            .find(|s| s.name == "g" && s.subscripts.is_empty());
        let known = self.text.says(WEIGHT) && !self.text.says(OTHERWISE);
        if !known || !self.reading.speaks_of(Quantity::Mass) {
            return false;
        }
        let Some(gravity) = gravity.and_then(|s| self.entity_named(s)) else {
            return false;
        };
        let Some(angles) = self.reading.euler_angles.clone() else {
            return false;
        };
        let (Some(up), Some(energy)) = (
            self.first_axis(&angles),
            self.lowering(Frame::Moving).scalar(right),
        ) else {
            return false;
        };
        let mass = self.theory.atoms.quantity(Quantity::Mass);
        let [mass, pull] = [mass, gravity].map(|e| self.theory.atoms.value(e, 0, 0));
        !self.arms_of_weight(&met).into_iter().any(|arm| {
            let height = self.theory.atoms.value(arm, 0, 0) * up[2].clone();
            let rest = energy.clone() - mass.clone() * pull.clone() * height;
            let changes = self.theory.atoms.derivative(&rest);
            self.theory.normal(&changes).is_zero()
        })
    }
}
