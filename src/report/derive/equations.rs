//! The equations of a derivation: `mechanics` run on polynomials.

use crate::algebra::Polynomial;
use crate::mechanics::{self, Products};
use crate::report::derive::letters::{Formula, Symbol, collected, formula, vector};
use crate::report::derive::{Axes, Body};
use nalgebra::{Matrix3, Vector3};
use num_traits::Zero;

/// Row and column of the six numbers of a tensor.
const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
const NAMES: [&str; 3] = ["x", "y", "z"];

/// A line: left side and right side.
pub(super) type Line = (Formula, Formula);

/// A body on axes, in symbols.
#[derive(Clone, Debug)]
pub(super) struct Equations {
    body: Body,
    axes: Axes,
    tensor: Matrix3<Polynomial>,
    frame: Vector3<Polynomial>,
}

impl Equations {
    pub(super) fn new(body: Body, axes: Axes) -> Self {
        // The symbol that each of the six numbers is written with; none for a product that vanishes.
        let symbols: [Option<usize>; 6] = match body {
            Body::Full => [0, 1, 2, 3, 4, 5].map(Some),
            Body::OnePlane => [Some(0), Some(1), Some(2), None, Some(4), None],
            Body::Principal => [Some(0), Some(1), Some(2), None, None, None],
            Body::Axisymmetric => [Some(0), Some(0), Some(2), None, None, None],
            Body::Sphere => [Some(0), Some(0), Some(0), None, None, None],
        };
        let [xx, yy, zz, xy, xz, yz] =
            symbols.map(|symbol| symbol.map_or_else(Polynomial::zero, |i| Symbol::Inertia.of(i)));
        let tensor = mechanics::inertia([xx, yy, zz], [xy, xz, yz], Products::Integrals);
        // Axes that leave the tensor its form: about the normal of a plane of symmetry, about an axis of symmetry.
        let free = match (axes, body) {
            (Axes::Body, _) => [false; 3],
            (Axes::Turning, Body::OnePlane) => [false, true, false],
            (Axes::Turning, Body::Axisymmetric) => [false, false, true],
            (Axes::Turning, _) => [true; 3],
        };
        let frame = Vector3::from_fn(|i, _| {
            let symbol = if free[i] {
                Symbol::Frame
            } else {
                Symbol::Omega
            };
            symbol.of(i)
        });
        Self {
            body,
            axes,
            tensor,
            frame,
        }
    }

    fn omega(&self) -> Vector3<Polynomial> {
        Vector3::from_fn(|i, _| Symbol::Omega.of(i))
    }

    fn omega_rate(&self) -> Vector3<Polynomial> {
        Vector3::from_fn(|i, _| Symbol::OmegaRate.of(i))
    }

    /// İ by the core; entries that vanish at all times have no rate.
    fn inertia_rate(&self) -> Matrix3<Polynomial> {
        let rate = mechanics::inertia_rate(&self.tensor, &self.omega(), &self.frame);
        rate.zip_map(
            &self.tensor,
            |rate, entry| {
                if entry.is_zero() { entry } else { rate }
            },
        )
    }

    /// What the body and the axes assume.
    pub(super) fn assumptions(&self) -> Vec<Formula> {
        let equal = |names: &[&str], value: &str| {
            let latex: Vec<_> = names.iter().map(|n| format!("I_{{{n}}}")).collect();
            let unicode: Vec<_> = names.iter().map(|n| format!("I_{n}")).collect();
            let end = if value.is_empty() {
                String::new()
            } else {
                format!(" = {value}")
            };
            vector(&(latex.join(" = ") + &end), &(unicode.join(" = ") + &end))
        };
        let mut assumed = match self.body {
            Body::Full => vec![],
            Body::OnePlane => vec![equal(&["xy", "yz"], "0")],
            Body::Principal => vec![equal(&["xy", "xz", "yz"], "0")],
            Body::Axisymmetric => vec![equal(&["xy", "xz", "yz"], "0"), equal(&["xx", "yy"], "")],
            Body::Sphere => vec![
                equal(&["xy", "xz", "yz"], "0"),
                equal(&["xx", "yy", "zz"], ""),
            ],
        };
        if self.axes == Axes::Turning {
            let own = |i: &usize| self.frame[*i] == Symbol::Omega.of(*i);
            assumed.extend((0..3).filter(own).map(|i| {
                let (frame, omega) = (Symbol::Frame.formula(i), Symbol::Omega.formula(i));
                vector(
                    &format!("{} = {}", frame.latex, omega.latex),
                    &format!("{} = {}", frame.unicode, omega.unicode),
                )
            }));
        }
        assumed
    }

    /// ΣM_x = L̇_x − L_y Ω_z + L_z Ω_y and its companions, with the angular velocity of the axes.
    pub(super) fn transported(&self) -> [Line; 3] {
        let momentum = Vector3::from_fn(|i, _| Symbol::Momentum.of(i));
        let rate = Vector3::from_fn(|i, _| Symbol::MomentumRate.of(i));
        self.moment_lines(mechanics::transport(&rate, &self.frame, &momentum), formula)
    }

    /// L = I ω with the tensor written out.
    pub(super) fn tensor_line(&self) -> Line {
        let column = |symbol: Symbol| -> String {
            let entries: Vec<_> = (0..3).map(|i| symbol.formula(i).latex).collect();
            format!(
                "\\begin{{bmatrix}} {} \\end{{bmatrix}}",
                entries.join(" \\\\ ")
            )
        };
        let row = |r: usize| -> String {
            let entries: Vec<_> = (0..3)
                .map(|c| formula(&self.tensor[(r, c)]).latex)
                .collect();
            entries.join(" & ")
        };
        let tensor = [0, 1, 2].map(row).join(" \\\\ ");
        let right = format!(
            "\\begin{{bmatrix}} {tensor} \\end{{bmatrix}} {}",
            column(Symbol::Omega)
        );
        (
            vector(&column(Symbol::Momentum), "L"),
            vector(&right, "I ω"),
        )
    }

    /// The components of L.
    pub(super) fn momentum(&self) -> [Line; 3] {
        let momentum = mechanics::angular_momentum(&self.tensor, &self.omega());
        [0, 1, 2].map(|i| (Symbol::Momentum.formula(i), formula(&momentum[i])))
    }

    /// The rates of the tensor's numbers, those that change.
    pub(super) fn inertia_rates(&self) -> Vec<Line> {
        let rate = self.inertia_rate();
        let line = |i: usize| {
            let (row, column) = ENTRIES[i];
            let entry = rate[(row, column)].clone();
            // The tensor holds the products with a minus sign.
            let value = if i < 3 { entry } else { -entry };
            (!value.is_zero()).then(|| (Symbol::InertiaRate.formula(i), collected(&value)))
        };
        (0..6).filter_map(line).collect()
    }

    /// The rates of the components of L, with the rates of the tensor as symbols.
    pub(super) fn momentum_rates(&self) -> [Line; 3] {
        let actual = self.inertia_rate();
        let symbol = |i: usize| {
            if actual[ENTRIES[i]].is_zero() {
                Polynomial::zero()
            } else {
                Symbol::InertiaRate.of(i)
            }
        };
        let rate = mechanics::inertia(
            [symbol(0), symbol(1), symbol(2)],
            [symbol(3), symbol(4), symbol(5)],
            Products::Integrals,
        );
        let rates =
            mechanics::momentum_rate(&self.tensor, &rate, &self.omega(), &self.omega_rate());
        [0, 1, 2].map(|i| (Symbol::MomentumRate.formula(i), formula(&rates[i])))
    }

    /// The components of the moment in inertia and motion alone.
    pub(super) fn moments(&self) -> [Line; 3] {
        let moment = mechanics::moment_in_axes(
            &self.tensor,
            &self.inertia_rate(),
            &self.omega(),
            &self.omega_rate(),
            &self.frame,
        );
        self.moment_lines(moment, collected)
    }

    fn moment_lines(
        &self,
        moment: Vector3<Polynomial>,
        print: fn(&Polynomial) -> Formula,
    ) -> [Line; 3] {
        [0, 1, 2].map(|i| {
            let name = NAMES[i];
            let left = vector(&format!("\\Sigma M_{name}"), &format!("ΣM_{name}"));
            (left, print(&moment[i]))
        })
    }
}
