//! The derivation itself, from ΣM = dL/dt to Euler's equations, by running `mechanics` on polynomials.
//!
//! No component is typed in: each comes out of the one generic equation, run on the body and the axes asked for.

mod equations;
mod letters;
mod print;
mod system;

pub use system::{of_system, proved_part};

use crate::report::derive::equations::Equations;
use crate::report::derive::letters::{Formula, vector};
use serde::Serialize;

/// Which components are printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[expect(missing_docs, reason = "the components are named for their axes")]
pub enum Component {
    X,
    Y,
    Z,
    #[default]
    All,
}

/// What is known of the body's inertia tensor on the axes used.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Body {
    /// All three products of inertia.
    #[default]
    Full,
    /// xz is a plane of symmetry: I_xz alone.
    OnePlane,
    /// No products of inertia.
    Principal,
    /// No products, and I_yy = I_xx: z is an axis of symmetry.
    Axisymmetric,
    /// No products, and all three moments equal.
    Sphere,
}

/// How the axes turn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Axes {
    /// With the body: Ω = ω.
    #[default]
    Body,
    /// On their own, Ω ≠ ω, as far as the tensor keeps its form on them.
    Turning,
}

/// What to derive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct DeriveOptions {
    /// The components to print.
    pub component: Component,
    /// The body.
    pub body: Body,
    /// The axes.
    pub axes: Axes,
}

/// A derivation, ready to be printed: see [`Derivation::markdown`] and its neighbours.
#[derive(Clone, Debug, PartialEq)]
pub struct Derivation {
    about: About,
    blocks: Vec<Block>,
}

/// What is derived.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
enum About {
    /// One body on axes.
    Body {
        #[serde(flatten)]
        options: DeriveOptions,
        products: &'static str,
    },
    /// A declared system, and the sentences that declare the letters which its author has not.
    System { letters: Vec<String> },
}

/// A piece of the page.
#[derive(Clone, Debug, PartialEq)]
enum Block {
    Heading(usize, String),
    Prose(Vec<Piece>),
    Display(Vec<Row>),
}

/// A piece of a sentence.
#[derive(Clone, Debug, PartialEq)]
enum Piece {
    Words(&'static str),
    /// A sentence with formulas between dollar signs.
    Sentence(String),
    Formula(Formula),
}

/// A relation of a display.
#[derive(Clone, Debug, PartialEq)]
struct Row {
    left: Formula,
    right: Formula,
    /// The number of a line that others may speak of.
    label: usize,
}

/// Derives the components of the moment equation for a body on axes.
///
/// ```
/// use polhode::report::derive::{Body, Component, DeriveOptions, derive};
/// let options = DeriveOptions { component: Component::X, body: Body::Principal, ..Default::default() };
/// let page = derive(&options).unicode();
/// assert!(page.contains("ΣM_x = I_xx ω̇_x + (I_zz − I_yy) ω_y ω_z"));
/// ```
pub fn derive(options: &DeriveOptions) -> Derivation {
    let mut page = Page {
        equations: Equations::new(options.body, options.axes),
        options: *options,
        blocks: vec![],
        label: 0,
    };
    page.opening();
    page.law();
    page.momentum();
    page.moments("The moments", page.equations.clone());
    if matches!(options.body, Body::Full | Body::OnePlane) {
        page.principal();
    }
    Derivation {
        about: About::Body {
            options: *options,
            products: "integrals",
        },
        blocks: page.blocks,
    }
}

/// The page while it is written.
struct Page {
    options: DeriveOptions,
    equations: Equations,
    blocks: Vec<Block>,
    label: usize,
}

impl Page {
    fn heading(&mut self, level: usize, text: &str) {
        self.blocks.push(Block::Heading(level, text.to_owned()));
    }

    fn words(&mut self, text: &'static str) {
        self.blocks.push(Block::Prose(vec![Piece::Words(text)]));
    }

    fn rows(&mut self, rows: Vec<(Formula, Formula)>) {
        let labelled = rows.into_iter().map(|(left, right)| {
            self.label += 1;
            Row {
                left,
                right,
                label: self.label,
            }
        });
        let display = Block::Display(labelled.collect());
        self.blocks.push(display);
    }

    /// Of a line for each axis, those that are asked for.
    fn chosen_rows(&mut self, lines: [(Formula, Formula); 3]) {
        let rows = self.components().into_iter().map(|i| lines[i].clone());
        self.rows(rows.collect());
    }

    /// The indices of the components asked for.
    fn components(&self) -> Vec<usize> {
        match self.options.component {
            Component::X => vec![0],
            Component::Y => vec![1],
            Component::Z => vec![2],
            Component::All => vec![0, 1, 2],
        }
    }

    /// What is assumed, before the first section so that it holds in all of them.
    fn opening(&mut self) {
        self.heading(1, "The moment equation of a rigid body");
        self.words(match self.options.axes {
            Axes::Body => {
                "The axes $xyz$ are attached to the body, with their origin at its mass centre or at a fixed point."
            }
            Axes::Turning => {
                "The axes $xyz$ turn with an angular velocity of their own, not that of the body. Their origin is its mass centre or a fixed point."
            }
        });
        self.words(match self.options.body {
            Body::Full => "No product of inertia is left out.",
            Body::OnePlane => "One plane of the axes divides the body into two mirror images.",
            Body::Principal => "On these axes no product of inertia occurs at any time.",
            Body::Axisymmetric => "The third axis is an axis of symmetry.",
            Body::Sphere => "All moments of inertia are equal, as those of a sphere or a cube.",
        });
        let assumed = self.equations.assumptions();
        if !assumed.is_empty() {
            let mut pieces = vec![Piece::Words("Assume ")];
            let last = assumed.len() - 1;
            for (i, formula) in assumed.into_iter().enumerate() {
                if i > 0 {
                    pieces.push(Piece::Words(if i == last { " and " } else { ", " }));
                }
                pieces.push(Piece::Formula(formula));
            }
            pieces.push(Piece::Words("."));
            self.blocks.push(Block::Prose(pieces));
        }
    }

    /// ΣM = dL/dt and the transport theorem, in vectors and in components.
    fn law(&mut self) {
        self.heading(2, "The law");
        self.words(
            "The resultant moment is the rate of the angular momentum as fixed axes see it.",
        );
        let moment = || vector("\\Sigma \\vec{M}", "ΣM");
        self.rows(vec![(
            moment(),
            vector("(\\dot{\\vec{L}})_{XYZ}", "(dL/dt)_XYZ"),
        )]);
        self.words("Seen from the axes used, the transport theorem adds a cross product.");
        let right = match self.options.axes {
            Axes::Body => vector(
                "(\\dot{\\vec{L}})_{xyz} + \\vec{\\omega} \\times \\vec{L}",
                "(dL/dt)_xyz + ω × L",
            ),
            Axes::Turning => vector(
                "(\\dot{\\vec{L}})_{xyz} + \\vec{\\Omega} \\times \\vec{L}",
                "(dL/dt)_xyz + Ω × L",
            ),
        };
        self.rows(vec![(moment(), right)]);
        self.words("Component by component this is");
        self.chosen_rows(self.equations.transported());
    }

    /// L = I ω, its components and their rates.
    fn momentum(&mut self) {
        self.heading(2, "The angular momentum");
        self.words("The inertia tensor takes the angular velocity to the angular momentum.");
        self.rows(vec![self.equations.tensor_line()]);
        self.words("Row by row, the components are");
        self.rows(self.equations.momentum().to_vec());
        let rates = self.equations.inertia_rates();
        if rates.is_empty() {
            self.words("The entries of the tensor do not change on these axes, so the dots fall on the angular velocity alone.");
        } else {
            self.words(
                "The body turns past these axes, and the entries of the tensor change at the rates",
            );
            self.rows(rates);
            self.words("So the rates of the components have two parts.");
        }
        self.chosen_rows(self.equations.momentum_rates());
    }

    /// The components of the moment in inertia and motion alone.
    fn moments(&mut self, heading: &str, equations: Equations) {
        self.heading(2, heading);
        self.words("Put together, the moments are");
        self.chosen_rows(equations.moments());
    }

    /// Euler's equations, as what is left of the general ones.
    fn principal(&mut self) {
        let special = Equations::new(Body::Principal, Axes::Body);
        self.heading(2, "Euler's equations");
        let mut pieces = vec![Piece::Words(
            "Let the axes be attached to the body, and choose them as its principal axes: assume ",
        )];
        let assumed = special.assumptions();
        for (i, formula) in assumed.into_iter().enumerate() {
            if i > 0 {
                pieces.push(Piece::Words(" and "));
            }
            pieces.push(Piece::Formula(formula));
        }
        if self.options.axes == Axes::Turning {
            pieces.push(Piece::Words(" and "));
            pieces.push(Piece::Formula(vector(
                "\\vec{\\Omega} = \\vec{\\omega}",
                "Ω = ω",
            )));
        }
        pieces.push(Piece::Words(". Then the moments are"));
        self.blocks.push(Block::Prose(pieces));
        self.chosen_rows(special.moments());
    }
}
