//! The variables of the polynomials: what each number in a [`Polynomial`]
//! stands for.
//!
//! An *entity* is a quantity or a symbol of the document; an *atom* is one component of it, or of one of its
//! time derivatives (a jet: ω_x, ω̇_x, ω̈_x), or a kernel such as sin θ, or a component of a rate seen
//! from space. d/dt on a polynomial shifts jets.

use crate::algebra::{Fraction, Polynomial, Variable};
use crate::mechanics::transport;
use crate::notation::ast::{Function, Symbol};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::symbol::Meaning;
use foldhash::HashMap;
use nalgebra::Vector3;
use num_traits::{One, Zero};

/// Whose value it is.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Owner {
    /// A quantity of the theory; the word tells apart several of the kind (`k` and `k+1`, the point P).
    Quantity(Quantity, String),
    /// A symbol that only the document knows.
    Symbol(String),
}

/// An index into the table of entities.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Entity(pub u32);

/// A quantity or symbol.
#[derive(Clone, Debug)]
pub(crate) struct EntityInfo {
    /// Whose value.
    pub owner: Owner,
    /// Its shape.
    pub shape: Shape,
    /// Whether its derivative in time is zero.
    pub constant: bool,
    /// The letter in LaTeX, as the document writes it.
    pub latex: String,
    /// The same vector or tensor on body axes, where this one is on space axes.
    pub in_body: Option<Entity>,
}

/// What a variable stands for.
#[derive(Clone, Debug)]
pub(crate) enum Atom {
    /// A component of an entity's derivative of some order in time.
    Part {
        /// The entity.
        entity: Entity,
        /// The component, from 0.
        component: u8,
        /// The order of the derivative.
        order: u8,
    },
    /// A function of an argument that no polynomial is.
    Kernel {
        /// The function: sin, cos, exp, sqrt or ln.
        function: Function,
        /// Its argument.
        argument: Fraction,
    },
    /// A component of the rate, seen from space, of the vector with these components on the axes used.
    SpaceRate {
        /// The vector.
        of: Box<[Fraction; 3]>,
        /// The component, from 0.
        component: u8,
    },
    /// A value that is only named: an integral, a function at a point.
    Opaque {
        /// Its LaTeX.
        latex: String,
    },
}

/// The table of entities and variables of a document.
#[derive(Clone, Debug, Default)]
pub(crate) struct Atoms {
    entities: Vec<EntityInfo>,
    by_owner: HashMap<Owner, Entity>,
    atoms: Vec<Atom>,
    parts: HashMap<(Entity, u8, u8), Variable>,
    named: HashMap<Key, Variable>,
    spelled: HashMap<(Entity, u8), String>,
    /// What symbols were found to stand for.
    meanings: HashMap<Symbol, Meaning>,
    changes: usize,
    second_rates: bool,
    /// Whether the document numbers its axes.
    pub numbered: bool,
    /// The label of what stands on the body's axes, where the plain letters are those on space axes.
    pub body_label: Option<String>,
    /// The letters of the inertia on space axes and on the body's, where these are two.
    pub inertia_letters: Option<[String; 2]>,
}

impl Atoms {
    /// The entity of an owner, made on first sight.
    pub(crate) fn entity(
        &mut self,
        owner: &Owner,
        shape: Shape,
        constant: bool,
        latex: &str,
    ) -> Entity {
        if let Some(&entity) = self.by_owner.get(owner) {
            return entity;
        }
        let entity = Entity(self.entities.len() as u32);
        let latex = latex.to_owned();
        self.entities.push(EntityInfo {
            owner: owner.clone(),
            shape,
            constant,
            latex,
            in_body: None,
        });
        self.by_owner.insert(owner.clone(), entity);
        entity
    }

    /// The entity of an owner that was met before.
    pub(crate) fn entity_of_owner(&self, owner: &Owner) -> Option<Entity> {
        self.by_owner.get(owner).copied()
    }

    /// A quantity of the theory, made on first sight with its usual letter.
    pub(crate) fn quantity(&mut self, quantity: Quantity) -> Entity {
        let letter = usual_letter(quantity);
        let owner = Owner::Quantity(quantity, String::new());
        self.entity(&owner, quantity.shape(), quantity.constant(), letter)
    }

    /// What is known of an entity.
    pub(crate) fn info(&self, entity: Entity) -> &EntityInfo {
        &self.entities[entity.0 as usize]
    }

    /// Notes how the document writes a component; the first spelling stays.
    pub(crate) fn spell(&mut self, entity: Entity, component: u8, latex: impl FnOnce() -> String) {
        let spelled = self.spelled.entry((entity, component));
        spelled.or_insert_with(latex);
    }

    /// How the document writes a component.
    pub(crate) fn spelling(&self, entity: Entity, component: u8) -> Option<&str> {
        self.spelled.get(&(entity, component)).map(String::as_str)
    }

    /// What a symbol was found to stand for.
    pub(crate) fn meaning(&self, symbol: &Symbol) -> Option<Meaning> {
        self.meanings.get(symbol).copied()
    }

    /// Notes what a symbol stands for, as long as neither the reading nor a shape changes.
    pub(crate) fn note_meaning(&mut self, symbol: &Symbol, meaning: Meaning) {
        self.meanings.insert(symbol.clone(), meaning);
    }

    /// Looks again what symbols stand for.
    pub(crate) fn forget_meanings(&mut self) {
        self.meanings.clear();
    }

    /// Whether second rates of symbols of the document were met.
    pub(crate) fn has_second_rates(&self) -> bool {
        self.second_rates
    }

    /// How often what is known of entities was changed.
    pub(crate) fn changes(&self) -> usize {
        self.changes
    }

    /// Changes what is known of an entity.
    pub(crate) fn info_mut(&mut self, entity: Entity) -> &mut EntityInfo {
        self.changes += 1;
        &mut self.entities[entity.0 as usize]
    }

    /// The entity that a variable is a component of, or a rate of one.
    pub(crate) fn entity_of(&self, variable: Variable) -> Option<Entity> {
        match *self.atom(variable) {
            Atom::Part { entity, .. } => Some(entity),
            _ => None,
        }
    }

    /// Whose value a variable is a part of.
    pub(crate) fn owner(&self, variable: Variable) -> Option<&Owner> {
        let entity = self.entity_of(variable)?;
        Some(&self.info(entity).owner)
    }

    /// A variable, or the variables of the argument of a kernel.
    pub(crate) fn with_arguments(&self, variable: Variable) -> Vec<Variable> {
        match self.atom(variable) {
            Atom::Kernel { argument, .. } => argument
                .variables()
                .into_iter()
                .flat_map(|v| self.with_arguments(v))
                .collect(),
            _ => vec![variable],
        }
    }

    /// The number of variables.
    pub(crate) fn count(&self) -> usize {
        self.atoms.len()
    }

    /// What a variable stands for.
    pub(crate) fn atom(&self, variable: Variable) -> &Atom {
        &self.atoms[variable as usize]
    }

    /// The variable of a component.
    pub(crate) fn part(&mut self, entity: Entity, component: u8, order: u8) -> Variable {
        let key = (entity, component, order);
        if let Some(&variable) = self.parts.get(&key) {
            return variable;
        }
        self.second_rates |= order > 1 && matches!(self.info(entity).owner, Owner::Symbol(_));
        let variable = self.push(Atom::Part {
            entity,
            component,
            order,
        });
        self.parts.insert(key, variable);
        variable
    }

    /// The variable of a kernel, a rate seen from space or an opaque value; equal ones are one variable.
    pub(crate) fn special(&mut self, atom: Atom) -> Variable {
        let Some(key) = key(&atom) else {
            return self.push(atom);
        };
        if let Some(&variable) = self.named.get(&key) {
            return variable;
        }
        let variable = self.push(atom);
        self.named.insert(key, variable);
        variable
    }

    fn push(&mut self, atom: Atom) -> Variable {
        self.atoms.push(atom);
        (self.atoms.len() - 1) as Variable
    }

    /// The component as a fraction.
    pub(crate) fn value(&mut self, entity: Entity, component: u8, order: u8) -> Fraction {
        variable_fraction(self.part(entity, component, order))
    }

    /// The three components of a vector's derivative of some order.
    pub(crate) fn vector(&mut self, entity: Entity, order: u8) -> [Fraction; 3] {
        [0, 1, 2].map(|component| self.value(entity, component, order))
    }

    /// The derivative of a fraction in time, each jet shifted by one.
    pub(crate) fn derivative(&mut self, fraction: &Fraction) -> Fraction {
        let (numerator, denominator) = (fraction.numerator(), fraction.denominator());
        let top = self.polynomial_derivative(numerator);
        if denominator.is_constant().is_some() {
            return top / Fraction::from(denominator.clone());
        }
        let bottom = self.polynomial_derivative(denominator);
        let whole = Fraction::from(denominator.clone());
        let quotient = fraction.clone() * bottom;
        (top - quotient) / whole
    }

    fn polynomial_derivative(&mut self, polynomial: &Polynomial) -> Fraction {
        let mut sum = Fraction::zero();
        for variable in polynomial.variables() {
            let rate = self.rate(variable);
            if !rate.is_zero() {
                sum += Fraction::from(polynomial.partial(variable)) * rate;
            }
        }
        sum
    }

    /// The derivative of a variable in time, as the table alone knows it: jets shift, kernels follow the chain
    /// rule, constants stand still.
    pub(crate) fn rate(&mut self, variable: Variable) -> Fraction {
        match self.atoms[variable as usize].clone() {
            Atom::Part {
                entity,
                component,
                order,
            } => {
                let info = self.info(entity);
                if info.owner == Owner::Quantity(Quantity::Time, String::new()) {
                    if order == 0 {
                        Fraction::one()
                    } else {
                        Fraction::zero()
                    }
                } else if info.constant {
                    Fraction::zero()
                } else {
                    self.value(entity, component, order + 1)
                }
            }
            Atom::Kernel { function, argument } => {
                let inner = self.derivative(&argument);
                if inner.is_zero() {
                    inner
                } else {
                    self.kernel_slope(function, &argument) * inner
                }
            }
            Atom::SpaceRate { of, component } => {
                let rate = self.transported(&of, component);
                self.derivative(&rate)
            }
            Atom::Opaque { .. } => Fraction::zero(),
        }
    }

    /// A component of the rate, seen from space, of a vector given on the axes used: (Q̇)_xyz + Ω × Q.
    pub(crate) fn transported(&mut self, of: &[Fraction; 3], component: u8) -> Fraction {
        let frame_rate = self.quantity(Quantity::FrameRate);
        let turning = Vector3::from(self.vector(frame_rate, 0));
        let rates = Vector3::from(of.each_ref().map(|entry| self.derivative(entry)));
        transport(&rates, &turning, &Vector3::from(of.clone()))[component as usize].clone()
    }

    /// The derivative of a kernel in its argument.
    pub(crate) fn kernel_slope(&mut self, function: Function, argument: &Fraction) -> Fraction {
        let mut kernel = |function| {
            variable_fraction(self.special(Atom::Kernel {
                function,
                argument: argument.clone(),
            }))
        };
        match function {
            Function::Sin => kernel(Function::Cos),
            Function::Cos => -kernel(Function::Sin),
            Function::Exp => kernel(Function::Exp),
            Function::Ln => Fraction::one() / argument.clone(),
            _ => {
                let root = kernel(Function::Sqrt);
                Fraction::one() / (root.clone() + root)
            }
        }
    }
}

/// A variable as a fraction.
pub(crate) fn variable_fraction(variable: Variable) -> Fraction {
    Fraction::from(Polynomial::variable(variable))
}

/// What tells atoms that are no parts apart: fractions by their written form.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Key {
    Kernel(Function, [Polynomial; 2]),
    SpaceRate([[Polynomial; 2]; 3], u8),
    Opaque(String),
}

/// The key of an atom; `None` for a part.
fn key(atom: &Atom) -> Option<Key> {
    let written = |f: &Fraction| [f.numerator().clone(), f.denominator().clone()];
    match atom {
        Atom::Part { .. } => None,
        Atom::Kernel { function, argument } => Some(Key::Kernel(*function, written(argument))),
        Atom::SpaceRate { of, component } => {
            Some(Key::SpaceRate(of.each_ref().map(written), *component))
        }
        Atom::Opaque { latex } => Some(Key::Opaque(latex.clone())),
    }
}

/// The letter that a quantity has where the document gives it none.
fn usual_letter(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::AngularVelocity => "\\omega",
        Quantity::FrameRate => "\\Omega",
        Quantity::AngularAcceleration => "\\alpha",
        Quantity::Momentum => "L",
        Quantity::RelativeMomentum => "h",
        Quantity::Moment => "M",
        Quantity::Inertia => "I",
        Quantity::Energy => "T",
        Quantity::Power => "P",
        Quantity::Position => "r",
        Quantity::Velocity | Quantity::CentreVelocity => "v",
        Quantity::OriginVelocity => "v_O",
        Quantity::Acceleration => "a",
        Quantity::Force => "F",
        Quantity::LinearMomentum => "p",
        Quantity::Mass => "m",
        Quantity::Time => "t",
        Quantity::Attitude => "R",
        Quantity::Quaternion => "q",
    }
}
