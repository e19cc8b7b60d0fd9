//! Quantities of the members of a family: which have an index, and the same of another member.

use crate::verify::term::quantity::{Quantity, Spot, Whole};

impl Quantity {
    /// The same of another member of the family.
    pub(crate) fn with_index(&self, from: &str, to: &str) -> Self {
        let index = |own: &String| {
            if own == from {
                to.to_owned()
            } else {
                own.clone()
            }
        };
        let spot = |s: &Spot| match s {
            Spot::Member(family, own) => Spot::Member(*family, index(own)),
            Spot::Point(_) | Spot::Carried(_) => s.clone(),
        };
        let whole = |w: &Whole| match w {
            Whole::Member(family, own) => Whole::Member(*family, index(own)),
            Whole::Body(_) => w.clone(),
        };
        let inner = |q: &Self| q.with_index(from, to).boxed();
        let mut changed = self.clone();
        match &mut changed {
            Self::Position { of, .. }
            | Self::Velocity { of, .. }
            | Self::Acceleration { of, .. } => *of = spot(of),
            Self::Mass(of)
            | Self::Inertia { of, .. }
            | Self::Momentum { of, .. }
            | Self::AngularMomentum { of, .. }
            | Self::KineticEnergy { of, .. }
            | Self::InertialForce { of, .. }
            | Self::Force(of) => *of = whole(of),
            Self::ExternalForce(_, own)
            | Self::Volume(_, own)
            | Self::Density(_, own)
            | Self::MemberScalar { index: own, .. }
            | Self::MemberVector { index: own, .. } => *own = index(own),
            Self::MomentOf { force, at, .. } => {
                *force = inner(force);
                *at = spot(at);
            }
            Self::Distance { of, axis, .. } => {
                *of = spot(of);
                *axis = inner(axis);
            }
            Self::Along { of, axis } | Self::Part { of, axis, .. } => {
                *of = inner(of);
                *axis = inner(axis);
            }
            Self::Rate { of, .. }
            | Self::Component { of, .. }
            | Self::Entry { of, .. }
            | Self::Magnitude(of)
            | Self::CrossProductMatrix(of)
            | Self::On(of, _)
            | Self::Pair(of, ..)
            | Self::Scaled(of, _) => *of = inner(of),
            Self::Sum(terms) => *terms = terms.iter().map(|t| t.with_index(from, to)).collect(),
            _ => {}
        }
        changed
    }

    pub(crate) fn is_indexed(&self) -> bool {
        match self {
            Self::Position { of, .. }
            | Self::Velocity { of, .. }
            | Self::Acceleration { of, .. } => {
                matches!(of, Spot::Member(..))
            }
            Self::Mass(of)
            | Self::Inertia { of, .. }
            | Self::Momentum { of, .. }
            | Self::AngularMomentum { of, .. }
            | Self::KineticEnergy { of, .. }
            | Self::InertialForce { of, .. }
            | Self::Force(of) => matches!(of, Whole::Member(..)),
            Self::Distance { of, .. } => matches!(of, Spot::Member(..)),
            Self::ExternalForce(..) | Self::MemberScalar { .. } | Self::MemberVector { .. } => true,
            Self::Volume(..) | Self::Density(..) => true,
            Self::MomentOf { at, force, .. } => {
                matches!(at, Spot::Member(..)) || force.is_indexed()
            }
            Self::Rate { of, .. }
            | Self::Along { of, .. }
            | Self::Part { of, .. }
            | Self::Component { of, .. }
            | Self::Entry { of, .. }
            | Self::Magnitude(of)
            | Self::CrossProductMatrix(of)
            | Self::On(of, _)
            | Self::Pair(of, ..)
            | Self::Scaled(of, _) => of.is_indexed(),
            Self::Sum(terms) => terms.iter().any(Self::is_indexed),
            _ => false,
        }
    }
}
