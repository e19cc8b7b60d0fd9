//! The table of uniform bodies by name.

use crate::mechanics::Moments;
use crate::mechanics::shapes::bodies::{Form, Height, Wall, unit};
use crate::mechanics::shapes::chart::Unit;
use crate::mechanics::shapes::range::Part;
use crate::scalar::Field;
use std::fmt;

/// A size that a shape takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Size {
    /// Its name, in lower case, words apart: `inner radius`.
    pub name: &'static str,
    /// How many numbers it has: three edges, two coordinates.
    pub count: usize,
    /// Whether the numbers are coordinates, of either sign, and not lengths.
    pub is_place: bool,
}

const fn lengths(name: &'static str, count: usize) -> Size {
    Size {
        name,
        count,
        is_place: false,
    }
}

const fn length(name: &'static str) -> Size {
    lengths(name, 1)
}

const fn place(name: &'static str, count: usize) -> Size {
    Size {
        name,
        count,
        is_place: true,
    }
}

const RADIUS: Size = length("radius");
const HEIGHT: Size = length("height");
const THICKNESS: Size = length("thickness");
const LENGTH: Size = length("length");
const EDGE: Size = length("edge");
const INNER: Size = length("inner radius");
const OUTER: Size = length("outer radius");

struct Row {
    name: &'static str,
    sizes: &'static [Size],
    dimension: u8,
    axes: &'static str,
    form: Form,
}

const fn row(
    name: &'static str,
    dimension: u8,
    sizes: &'static [Size],
    form: Form,
    axes: &'static str,
) -> Row {
    Row {
        name,
        sizes,
        dimension,
        axes,
        form,
    }
}

const PLATE: &str = "the plate in the plane z = 0, the origin in its middle";
const EDGES: &str = "edges along x, y, z, the origin in the middle";
const FLAT: &str = "axis along z, the origin in the centre";
const UPRIGHT: &str = "axis along z, the origin halfway up it";
const HALF_FLAT: &str = "the half y ≥ 0 in the plane z = 0, the origin in the centre of the circle";
const HALF_UPRIGHT: &str = "the half y ≥ 0, axis along z, the origin halfway up it";
const QUARTER: &str = "the quarter x ≥ 0, y ≥ 0 of the whole, the origin where the whole has it";
const TIP: &str = "axis along z, the origin in the centre of the base, the tip at z = height";
const HALF_TIP: &str =
    "the half y ≥ 0, axis along z, the origin in the centre of the base, the tip at z = height";
const CENTRE: &str = "the origin in the centre";
const DOME: &str = "the half z ≥ 0, the origin in the centre of the whole";
const CORNERS: &str = "the axes and the origin of the corners";

use Form::{Ball, Cone, Ellipsoid, Elliptic, Round};
use Height::{Flat, Given};
use Part::{Half, Quarter, Whole};
use Wall::{Solid, Thick, Thin};

#[rustfmt::skip]
static TABLE: [Row; 42] = [
    row("rod", 1, &[LENGTH], Form::Rod, "along z, the origin in the middle"),
    row("ring", 1, &[RADIUS], Round(Thin, Whole, Flat), FLAT),
    row("half ring", 1, &[RADIUS], Round(Thin, Half, Flat), HALF_FLAT),
    row("quarter ring", 1, &[RADIUS], Round(Thin, Quarter, Flat), QUARTER),
    row("plate", 2, &[lengths("size", 2)], Form::Plate, PLATE),
    row("square plate", 2, &[EDGE], Form::SquarePlate, PLATE),
    row("triangle", 2, &[place("first corner", 2), place("second corner", 2), place("third corner", 2)], Form::Triangle, CORNERS),
    row("disc", 2, &[RADIUS], Round(Solid, Whole, Flat), FLAT),
    row("half disc", 2, &[RADIUS], Round(Solid, Half, Flat), HALF_FLAT),
    row("quarter disc", 2, &[RADIUS], Round(Solid, Quarter, Flat), QUARTER),
    row("elliptic disc", 2, &[lengths("semi-axes", 2)], Elliptic(Flat), "semi-axes along x, y, the origin in the centre"),
    row("annulus", 2, &[INNER, OUTER], Round(Thick, Whole, Flat), FLAT),
    row("half annulus", 2, &[INNER, OUTER], Round(Thick, Half, Flat), HALF_FLAT),
    row("cylindrical shell", 2, &[RADIUS, HEIGHT], Round(Thin, Whole, Given), UPRIGHT),
    row("half cylindrical shell", 2, &[RADIUS, HEIGHT], Round(Thin, Half, Given), HALF_UPRIGHT),
    row("conical shell", 2, &[RADIUS, HEIGHT], Cone(Thin, Whole), TIP),
    row("half conical shell", 2, &[RADIUS, HEIGHT], Cone(Thin, Half), HALF_TIP),
    row("shell", 2, &[RADIUS], Ball(Thin, Half), CENTRE),
    row("half shell", 2, &[RADIUS], Ball(Thin, Quarter), DOME),
    row("box", 3, &[lengths("size", 3)], Form::Box, EDGES),
    row("cube", 3, &[EDGE], Form::Cube, EDGES),
    row("tetrahedron", 3, &[place("first corner", 3), place("second corner", 3), place("third corner", 3), place("fourth corner", 3)], Form::Tetrahedron, CORNERS),
    row("thick rod", 3, &[RADIUS, LENGTH], Round(Solid, Whole, Given), UPRIGHT),
    row("thick disc", 3, &[RADIUS, THICKNESS], Round(Solid, Whole, Given), UPRIGHT),
    row("cylinder", 3, &[RADIUS, HEIGHT], Round(Solid, Whole, Given), UPRIGHT),
    row("half cylinder", 3, &[RADIUS, HEIGHT], Round(Solid, Half, Given), HALF_UPRIGHT),
    row("quarter cylinder", 3, &[RADIUS, HEIGHT], Round(Solid, Quarter, Given), QUARTER),
    row("elliptic cylinder", 3, &[lengths("semi-axes", 2), HEIGHT], Elliptic(Given), "semi-axes along x, y, the origin halfway up the axis"),
    row("tube", 3, &[INNER, OUTER, HEIGHT], Round(Thick, Whole, Given), UPRIGHT),
    row("half tube", 3, &[INNER, OUTER, HEIGHT], Round(Thick, Half, Given), HALF_UPRIGHT),
    row("quarter tube", 3, &[INNER, OUTER, HEIGHT], Round(Thick, Quarter, Given), QUARTER),
    row("cone", 3, &[RADIUS, HEIGHT], Cone(Solid, Whole), TIP),
    row("half cone", 3, &[RADIUS, HEIGHT], Cone(Solid, Half), HALF_TIP),
    row("quarter cone", 3, &[RADIUS, HEIGHT], Cone(Solid, Quarter), QUARTER),
    row("pyramid", 3, &[lengths("base", 2), HEIGHT], Form::Pyramid, "the base in the plane z = 0, its edges along x, y, the origin in its centre, the tip at z = height"),
    row("paraboloid", 3, &[RADIUS, HEIGHT], Form::Paraboloid, TIP),
    row("sphere", 3, &[RADIUS], Ball(Solid, Half), CENTRE),
    row("half sphere", 3, &[RADIUS], Ball(Solid, Quarter), DOME),
    row("thick shell", 3, &[INNER, OUTER], Ball(Thick, Half), CENTRE),
    row("half thick shell", 3, &[INNER, OUTER], Ball(Thick, Quarter), DOME),
    row("ellipsoid", 3, &[lengths("semi-axes", 3)], Ellipsoid(Half), "semi-axes along x, y, z, the origin in the centre"),
    row("half ellipsoid", 3, &[lengths("semi-axes", 3)], Ellipsoid(Quarter), "semi-axes along x, y, z, the half z ≥ 0, the origin in the centre of the whole"),
];

/// A uniform body, by its name in the table.
///
/// A rod lies along z; whatever is round has its axis along z. Where the origin lies, [`Self::axes`] says. `sphere`,
/// `cylinder` and `cone` are solid; `disc`, `plate` and `ring` have no thickness.
///
/// ```
/// use polhode::mechanics::Shape;
/// let cone = Shape::by_name("cone").ok_or("no cone")?;
/// let names: Vec<_> = cone.sizes().iter().map(|size| size.name).collect();
/// assert_eq!(names, ["radius", "height"]);
/// let moments = cone.moments(&2.0, &[0.1, 0.4], &std::f64::consts::PI).ok_or("two sizes")?;
/// assert!((moments.mass_centre().z - 0.1).abs() < 1e-15);
/// assert!((moments.central_inertia()[(2, 2)] - 0.3 * 2.0 * 0.01).abs() < 1e-15);
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy)]
pub struct Shape(&'static Row);

impl Shape {
    /// All shapes, wires first, then surfaces, then solids.
    pub fn all() -> impl Iterator<Item = Self> {
        TABLE.iter().map(Self)
    }

    /// The shape of a name, as [`Self::name`] writes it. A `thin` before a wire or a surface says what it is anyway:
    /// `thin disc` is `disc`, while a thin cylinder is none of these.
    pub fn by_name(name: &str) -> Option<Self> {
        let named = |name: &str| Self::all().find(|shape| shape.name() == name);
        let thin = || named(name.strip_prefix("thin ")?).filter(|shape| shape.dimension() < 3);
        named(name).or_else(thin)
    }

    /// Its name, in lower case.
    pub fn name(self) -> &'static str {
        self.0.name
    }

    /// The sizes that it takes, in order.
    pub fn sizes(self) -> &'static [Size] {
        self.0.sizes
    }

    /// 1 for a wire, 2 for a surface, 3 for a solid.
    pub fn dimension(self) -> u8 {
        self.0.dimension
    }

    /// How its own axes lie and where their origin is.
    pub fn axes(self) -> &'static str {
        self.0.axes
    }

    /// The moments of this body with the mass in kg and the sizes in m, on its own axes.
    ///
    /// `sizes` are the numbers of [`Self::sizes`] one after another. Lengths must not be zero; the height of a round
    /// solid may be, and so may the distance of two radii.
    ///
    /// `pi` is π in the field. An exact field has none: give it a variable, and read the result as a formula in π. Only
    /// the halves and quarters of round bodies have π in their moments; for all else any number but zero will do.
    ///
    /// `None` if there are more or fewer sizes.
    pub fn moments<T: Field>(self, mass: &T, sizes: &[T], pi: &T) -> Option<Moments<T>> {
        Some(self.unit(sizes, pi)?.moments.scaled(mass))
    }

    /// The length in m of a wire, the area in m² of a surface, the volume in m³ of a solid.
    ///
    /// A triangle with its corners clockwise has a negative area, and a tetrahedron is signed alike. `None` if there are
    /// more or fewer sizes, and of a conical shell, whose area takes a root.
    pub fn content<T: Field>(self, sizes: &[T], pi: &T) -> Option<T> {
        self.unit(sizes, pi)?.content
    }

    /// [`Self::moments`] for a density in kg per m, m² or m³, by [`Self::content`]; `None` where that is.
    pub fn uniform<T: Field>(self, density: &T, sizes: &[T], pi: &T) -> Option<Moments<T>> {
        let unit = self.unit(sizes, pi)?;
        let mass = unit.content? * density.clone();
        Some(unit.moments.scaled(&mass))
    }

    fn unit<T: Field>(self, sizes: &[T], pi: &T) -> Option<Unit<T>> {
        let count: usize = self.sizes().iter().map(|size| size.count).sum();
        if sizes.len() != count {
            return None;
        }
        unit(self.0.form, sizes, pi)
    }
}

impl PartialEq for Shape {
    /// Names are unlike each other.
    fn eq(&self, other: &Self) -> bool {
        self.name() == other.name()
    }
}

impl Eq for Shape {}

impl fmt::Debug for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Shape").field(&self.name()).finish()
    }
}
