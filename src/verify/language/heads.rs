//! Nouns by which other rooms make sentences, each the first form of its entry in the lexicon.

pub(crate) const ANGULAR_VELOCITY: &str = "angular velocity";
pub(crate) const POSITION: &str = "position";
/// The adverb of what moves smoothly.
pub(crate) const WITHOUT_FRICTION: &str = "without friction";
/// A vector of length one.
pub(crate) const UNIT_VECTOR: &str = "unit vector";
pub(crate) const VELOCITY: &str = "velocity";
pub(crate) const ACCELERATION: &str = "acceleration";
pub(crate) const SPECIFIC_FORCE: &str = "specific force";
pub(crate) const MASS: &str = "mass";
/// The point of a body by which its mass moves.
pub(crate) const MASS_CENTRE: &str = "mass centre";
pub(crate) const HEIGHT: &str = "height";
pub(crate) const MOMENTUM: &str = "momentum";
pub(crate) const ANGULAR_MOMENTUM: &str = "angular momentum";
pub(crate) const FORCE: &str = "force";
pub(crate) const MOMENT: &str = "moment";
pub(crate) const WEIGHT: &str = "weight";
pub(crate) const KINETIC_ENERGY: &str = "kinetic energy";
pub(crate) const POTENTIAL_ENERGY: &str = "potential energy";
pub(crate) const TOTAL_ENERGY: &str = "total energy";
pub(crate) const PRINCIPAL_MOMENTS: &str = "principal moments";
/// The axes on which the products of inertia vanish.
pub(crate) const PRINCIPAL_AXES: &str = "principal axes";
pub(crate) const INERTIA_TENSOR: &str = "inertia tensor";
pub(crate) const MOMENT_OF_INERTIA: &str = "moment of inertia";
/// Letters that are set bold, by what is said of their marks.
pub(crate) const BOLD_LETTER: &str = "bold letter";
/// What a sign means by which no rule is meant.
pub(crate) const NOTHING: &str = "nothing of its own";
/// The verb of what integrals do with a body, and letters under them with its places.
pub(crate) const RUN_OVER: &str = "run over";
/// A plane on whose two sides a body is alike.
pub(crate) const PLANE_OF_SYMMETRY: &str = "plane of symmetry";
/// What does not change.
pub(crate) const CONSTANT: &str = "constant";
/// The number whose square is −1.
pub(crate) const IMAGINARY_UNIT: &str = "imaginary unit";
/// The verb of what does not turn.
pub(crate) const KEEPS_DIRECTION: &str = "keep its direction";
/// The number e.
pub(crate) const NATURAL_BASE: &str = "base of the natural logarithm";
/// A unit vector that stands on a surface.
pub(crate) const NORMAL: &str = "normal vector";
/// The direction in which a plane falls most steeply.
pub(crate) const DOWNHILL: &str = "downhill direction";
/// The acceleration with which things fall.
pub(crate) const GRAVITY: &str = "acceleration of gravity";
/// The adverb of what turns from one direction to another.
pub(crate) const TOWARDS: &str = "towards";
/// In which direction something is counted.
pub(crate) const POSITIVE_TOWARDS: &str = "positive towards";
/// In which sense something about an axis is counted.
pub(crate) const POSITIVE_ABOUT: &str = "positive about";
/// The direction that goes with an angle.
pub(crate) const TOWARDS_GROWING: &str = "towards growing";
/// Where something lies seen from something between.
pub(crate) const OPPOSITE_TO: &str = "opposite to";
/// The opposite direction.
pub(crate) const UPHILL: &str = "uphill direction";
/// What a plane does to a body that touches it.
pub(crate) const CONTACT_FORCE: &str = "contact force";
/// The part of that along the normal of the plane.
pub(crate) const NORMAL_FORCE: &str = "normal force";
/// Its part in the plane.
pub(crate) const FRICTION: &str = "friction";
/// The vector of a cross-product matrix, as its operator.
pub(crate) const INVERSE_MAP: &str = "inverse map";
/// A point in time.
pub(crate) const INSTANT: &str = "instant";
/// What happens at once.
pub(crate) const SUDDEN: [&str; 2] = ["impulse", "impact"];
/// The instant from which time is counted.
pub(crate) const START_OF_MOTION: &str = "start";
/// What a letter is where nothing is disturbed.
pub(crate) const REFERENCE: &str = "reference value";
/// By how much it is more.
pub(crate) const DISTURBANCE: &str = "disturbance";
/// By how much it is more in a motion nearby, to first order.
pub(crate) const FIRST_ORDER_CHANGE: &str = "first-order change";
/// The matrix of the partial derivatives of a vector.
pub(crate) const JACOBIAN: &str = "Jacobian";
/// How the entries of a Jacobian stand: a row for each component of the function.
pub(crate) const OUTPUTS_IN_ROWS: &str = "with outputs in rows";
/// The same transposed.
pub(crate) const OUTPUTS_IN_COLUMNS: &str = "with outputs in columns";
/// What something is at the start.
pub(crate) const INITIAL_VALUE: &str = "initial value";
/// The rate of a rate.
pub(crate) const SECOND_RATE: &str = "second rate";
/// The mark of a second rate.
pub(crate) const TWO_DOTS: &str = "two dots";
/// The conjugate of a quaternion.
pub(crate) const CONJUGATE: &str = "conjugate quaternion";
/// Hamilton's product.
pub(crate) const QUATERNION_PRODUCT: &str = "quaternion product";
/// The scalar part of a quaternion.
pub(crate) const SCALAR_PART: &str = "scalar part";
/// Its vector part.
pub(crate) const VECTOR_PART: &str = "vector part";
pub(crate) const QUATERNION: &str = "quaternion";
/// A quaternion whose scalar part is written first.
pub(crate) const SCALAR_FIRST: &str = "scalar first";
/// A quaternion whose scalar part is written last.
pub(crate) const SCALAR_LAST: &str = "scalar last";
/// A frame that is written as a label above.
pub(crate) const FRAME_ABOVE: &str = "frame at the upper right";

/// A frame that is written before a rate.
pub(crate) const FRAME_BEFORE_RATE: &str = "frame at the upper left of a derivative";
/// What such a frame means.
pub(crate) const RATE_FROM_FRAME: &str = "the rate seen from that frame";
/// Vectors below one another.
pub(crate) const COLUMN_OF_VECTORS: &str = "column of vectors";
/// What such a column may hold.
pub(crate) const ROWS_OF_MATRIX: &str = "rows of a matrix";

/// The adverb of what is left out.
pub(crate) const EXCEPT: &str = "except";

/// What a column of vectors is by custom.
pub(crate) const LIST: &str = "a list";

/// A sign that multiplies matrices as juxtaposition does.
pub(crate) const DOT_OF_MATRICES: &str = "dot between matrices";

/// What multiplies matrices.
pub(crate) const MATRIX_PRODUCT: &str = "the matrix product";

/// How customs of a frame before or behind a letter begin.
pub(crate) const FRAME_AT_UPPER: &str = "frame at the upper";

/// The noun of a matrix that takes components on axes to components on these axes after they have turned.
pub(crate) const COMPONENT_ROTATION: &str = "passive rotation matrix";
pub(crate) const AERODYNAMIC_FORCE: &str = "aerodynamic force";
/// What a motor exerts.
pub(crate) const MOTOR_MOMENT: &str = "motor moment";
/// Where two bodies touch.
pub(crate) const CONTACT_POINT: &str = "contact point";
/// The time from one step to the next.
pub(crate) const STEP_SIZE: &str = "step size";
/// Angles that lead from one frame to another, one after the other.
pub(crate) const EULER_ANGLES: &str = "Euler angles";
/// The axis of a body that is symmetric.
pub(crate) const OF_SYMMETRY: [&str; 2] = ["symmetry axis", "spin axis"];
/// What a moment may be about, beside points.
pub(crate) const AXES: [&str; 4] = [VERTICAL, "axis", "symmetry axis", "spin axis"];
/// Words of from where something is counted, and which way, and of which hand axes are.
pub(crate) const OF_COUNTING: [&str; 18] = [
    "zero",
    "vanishes",
    "begins",
    "starts",
    "grows",
    "increases",
    "against",
    "counted",
    "measured",
    "reckoned",
    "sense",
    "clockwise",
    "reversed",
    "left-handed",
    "left-hand",
    "handed",
    "hand",
    "oblique",
];
/// Words of sentences about where up is.
pub(crate) const OF_BEARINGS: [&str; 10] = [
    "vertical",
    "vertically",
    "up",
    "upward",
    "upwards",
    "down",
    "downward",
    "downwards",
    "horizontal",
    "horizontally",
];
/// Turning steadily about an axis without a moment: the mass centre is on it, and it is a principal axis.
pub(crate) const DYNAMICALLY_BALANCED: &str = "dynamically balanced";
/// With the mass centre on an axis.
pub(crate) const STATICALLY_BALANCED: &str = "statically balanced";
/// Not balanced, in one way or the other.
pub(crate) const UNBALANCED: &str = "unbalanced";
/// How long a spring is on which nothing acts.
pub(crate) const NATURAL_LENGTH: &str = "natural length";
/// Words of sentences about loads.
pub(crate) const OF_LOADS: [&str; 6] = ["spring", "force", "forces", "load", "loads", "exerts"];
/// Words of sentences about where a potential energy is zero.
pub(crate) const OF_POTENTIALS: [&str; 3] = ["potential", "energy", "gravity"];
pub(crate) const VERTICAL: &str = "vertical";
/// What is said of densities.
pub(crate) const PER_UNIT: [&str; 4] = [
    "per unit length",
    "per unit area",
    "per unit volume",
    "per unit mass",
];
/// What a motion is said to be without being another one.
pub(crate) const PLAIN_ADVERBS: [&str; 2] = ["without slipping", "freely"];
/// The letters that tell how a system lies.
pub(crate) const COORDINATES: &str = "generalised coordinates";
/// The second derivatives of the kinetic energy in the rates of the coordinates.
pub(crate) const MASS_MATRIX: &str = "mass matrix";
/// The matrix that changes nothing.
pub(crate) const IDENTITY_MATRIX: &str = "identity matrix";
/// The energy that a body would have as a particle at its mass centre.
pub(crate) const ENERGY_OF_TRANSLATION: &str = "kinetic energy of translation";
/// The noun of what is left of a kinetic energy without that of the mass centre.
pub(crate) const ENERGY_OF_ROTATION: &str = "kinetic energy of rotation";
/// The meaning of an index over which there is no sum.
pub(crate) const NOT_SUMMED: &str = "not summed";
/// What the square of a letter means that is a vector.
pub(crate) const SQUARE_OF_VECTOR: &str = "square of a vector";
/// The matrix of a turn by an angle about a vector.
pub(crate) const ROTATION_MATRIX: &str = "rotation matrix";
/// The tensor a bᵀ of two vectors.
pub(crate) const TENSOR_PRODUCT: &str = "tensor product";
/// A sign of a custom: the full stop of `a.b`.
pub(crate) const FULL_STOP: &str = "full stop between vectors";
/// Quaternions side by side.
pub(crate) const PRODUCT_OF_QUATERNIONS: &str = "product of quaternions";
/// The vector a × b.
pub(crate) const CROSS_PRODUCT: &str = "cross product";
/// Vectors without a sign between them.
pub(crate) const VECTORS_SIDE_BY_SIDE: &str = "vectors side by side";
/// A dot that is no dot product.
pub(crate) const QUATERNION_DOT: &str = "dot between quaternions";
/// Ways to set formulas of which a sentence says that they change nothing.
pub(crate) const WAY_OF_SETTING: &str = "way of setting";
/// Braces over or under a part of a formula, with a label.
pub(crate) const UNDERBRACE: &str = "underbrace";
/// The derivatives of a function.
pub(crate) const DERIVATIVE: &str = "derivative";
pub(crate) const PARTIAL_DERIVATIVE: &str = "partial derivative";
/// Columns of a motion in a plane.
pub(crate) const COLUMNS_OF_TWO: &str = "columns of two";
/// Products that no letter names.
pub(crate) const OTHER_PRODUCTS: &str = "other products of inertia";

/// Half of what an ellipsoid measures along a principal axis.
pub(crate) const SEMI_AXIS: &str = "semi-axis";

/// What a sentence tells of a thing with its noun: "a rod of mass `$m$` and length `$l$`".
pub(crate) const SIZES: [&str; 11] = [
    MASS,
    HEIGHT,
    "length",
    "radius",
    "width",
    "side",
    "diameter",
    "thickness",
    "edge",
    SEMI_AXIS,
    "density",
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verify::language::lexicon::{Class, Lexicon};

    #[test]
    fn the_lexicon_has_each() {
        let heads = [
            ANGULAR_VELOCITY,
            POSITION,
            VELOCITY,
            ACCELERATION,
            SPECIFIC_FORCE,
            FIRST_ORDER_CHANGE,
            JACOBIAN,
            OUTPUTS_IN_ROWS,
            OUTPUTS_IN_COLUMNS,
            MASS,
            MASS_CENTRE,
            MOMENTUM,
            ANGULAR_MOMENTUM,
            FORCE,
            MOMENT,
            WEIGHT,
            KINETIC_ENERGY,
            POTENTIAL_ENERGY,
            TOTAL_ENERGY,
            PRINCIPAL_MOMENTS,
            INERTIA_TENSOR,
            MOMENT_OF_INERTIA,
            NORMAL,
            DOWNHILL,
            UPHILL,
            GRAVITY,
            FRAME_BEFORE_RATE,
            RATE_FROM_FRAME,
            COLUMN_OF_VECTORS,
            ROWS_OF_MATRIX,
            LIST,
            DOT_OF_MATRICES,
            MATRIX_PRODUCT,
            CONTACT_FORCE,
            NORMAL_FORCE,
            FRICTION,
            FRAME_ABOVE,
            INVERSE_MAP,
            SECOND_RATE,
            TWO_DOTS,
            CONJUGATE,
            QUATERNION_PRODUCT,
            SCALAR_PART,
            VECTOR_PART,
            QUATERNION,
            SCALAR_FIRST,
            SCALAR_LAST,
            COMPONENT_ROTATION,
            CONSTANT,
            IMAGINARY_UNIT,
            KEEPS_DIRECTION,
            OTHER_PRODUCTS,
            COORDINATES,
            MASS_MATRIX,
            IDENTITY_MATRIX,
            ENERGY_OF_TRANSLATION,
            ENERGY_OF_ROTATION,
            SQUARE_OF_VECTOR,
            NOTHING,
            BOLD_LETTER,
            FULL_STOP,
            PRODUCT_OF_QUATERNIONS,
            QUATERNION_DOT,
            TENSOR_PRODUCT,
            ROTATION_MATRIX,
            COLUMNS_OF_TWO,
            WAY_OF_SETTING,
            UNDERBRACE,
            DERIVATIVE,
            PARTIAL_DERIVATIVE,
            STEP_SIZE,
            POSITIVE_ABOUT,
            CONTACT_POINT,
            NATURAL_LENGTH,
            DYNAMICALLY_BALANCED,
            STATICALLY_BALANCED,
            UNBALANCED,
            AERODYNAMIC_FORCE,
            MOTOR_MOMENT,
        ];
        for head in heads.into_iter().chain(PLAIN_ADVERBS) {
            let entry = Lexicon::shared().entry(
                head,
                &[
                    Class::Noun,
                    Class::Place,
                    Class::Custom,
                    Class::Adverb,
                    Class::Mark,
                    Class::Meaning,
                    Class::Verb,
                    Class::Adjective,
                ],
            );
            assert!(entry.is_some(), "{head}");
        }
    }
}
