//! Nouns and verbs by which other files make sentences and ask for them, each the first form of its entry in the lexicon.

/// Constants.
macro_rules! heads {
    ($($(#[$about:meta])* $name:ident = $words:literal;)*) => {
        $($(#[$about])* pub(crate) const $name: &str = $words;)*
    };
}

/// Letters that are unit vectors by custom.
pub(crate) const UNIT_VECTORS: [&str; 4] = ["i", "j", "k", "e"];

heads! {
    /// A number in a sum with a matrix.
    NUMBER_BESIDE_MATRIX = "number beside a matrix";
    /// What such a number means.
    TIMES_IDENTITY = "times the identity";
    /// A cross between a vector and a matrix.
    CROSS_WITH_MATRIX = "cross between a vector and a matrix";
    /// What such a cross means.
    COLUMN_BY_COLUMN = "column by column";
    /// What stands between them is a length.
    DOUBLE_BARS = "double bars";
    /// A quaternion without scalar part, by its vector.
    PURE_QUATERNION = "pure quaternion";
    /// A vector after it was turned about another one by an angle.
    TURNED_VECTOR = "turned vector";
    /// A row of a matrix as a column.
    TRANSPOSED_ROW = "transposed row";
    /// The matrix of the cofactors of a matrix.
    COFACTORS = "cofactor matrix";
    /// The mass of a body for its length, area or volume, in each place of it.
    DENSITY = "density";
    ANGULAR_VELOCITY = "angular velocity";
    POSITION = "position";
    /// A joint about whose point a body turns in any way.
    BALL_JOINT = "ball joint";
    /// The adverb of what moves smoothly.
    WITHOUT_FRICTION = "without friction";
    /// A vector of length one.
    UNIT_VECTOR = "unit vector";
    VELOCITY = "velocity";
    ACCELERATION = "acceleration";
    SPECIFIC_FORCE = "specific force";
    MASS = "mass";
    /// The point of a body by which its mass moves.
    MASS_CENTRE = "mass centre";
    /// How far a point has moved since the start.
    TRAVEL = "travel";
    HEIGHT = "height";
    MOMENTUM = "momentum";
    ANGULAR_MOMENTUM = "angular momentum";
    FORCE = "force";
    MOMENT = "moment";
    WEIGHT = "weight";
    KINETIC_ENERGY = "kinetic energy";
    POTENTIAL_ENERGY = "potential energy";
    TOTAL_ENERGY = "total energy";
    PRINCIPAL_MOMENTS = "principal moments";
    /// The axes on which the products of inertia vanish.
    PRINCIPAL_AXES = "principal axes";
    INERTIA_TENSOR = "inertia tensor";
    MOMENT_OF_INERTIA = "moment of inertia";
    /// Letters that are set bold, by what is said of their marks.
    BOLD_LETTER = "bold letter";
    /// What a sign means by which no rule is meant.
    NOTHING = "nothing of its own";
    /// The verb of what integrals do with a body, and letters under them with its places.
    RUN_OVER = "run over";
    /// A plane on whose two sides a body is alike.
    PLANE_OF_SYMMETRY = "plane of symmetry";
    /// What does not change.
    CONSTANT = "constant";
    /// The number whose square is −1.
    IMAGINARY_UNIT = "imaginary unit";
    /// The verb of what does not turn.
    KEEPS_DIRECTION = "keep its direction";
    /// The number e.
    NATURAL_BASE = "base of the natural logarithm";
    /// A unit vector that stands on a surface.
    NORMAL = "normal vector";
    /// The direction in which a plane falls most steeply.
    DOWNHILL = "downhill direction";
    /// The acceleration with which things fall.
    GRAVITY = "acceleration of gravity";
    /// The adverb of what turns from one direction to another.
    TOWARDS = "towards";
    /// In which direction something is counted.
    POSITIVE_TOWARDS = "positive towards";
    /// In which sense something about an axis is counted.
    POSITIVE_ABOUT = "positive about";
    /// The direction that goes with an angle.
    TOWARDS_GROWING = "towards growing";
    /// Where something lies seen from something between.
    OPPOSITE_TO = "opposite to";
    /// The opposite direction.
    UPHILL = "uphill direction";
    /// What a plane does to a body that touches it.
    CONTACT_FORCE = "contact force";
    /// The part of that along the normal of the plane.
    NORMAL_FORCE = "normal force";
    /// Its part in the plane.
    FRICTION = "friction";
    /// The vector of a cross-product matrix, as its operator.
    INVERSE_MAP = "inverse map";
    /// A point in time.
    INSTANT = "instant";
    /// The instant from which time is counted.
    START_OF_MOTION = "start";
    /// What a letter is where nothing is disturbed.
    REFERENCE = "reference value";
    /// By how much it is more.
    DISTURBANCE = "disturbance";
    /// By how much it is more in a motion nearby, to first order.
    FIRST_ORDER_CHANGE = "first-order change";
    /// The matrix of the partial derivatives of a vector.
    JACOBIAN = "Jacobian";
    /// How the entries of a Jacobian stand: a row for each component of the function.
    OUTPUTS_IN_ROWS = "with outputs in rows";
    /// The same transposed.
    OUTPUTS_IN_COLUMNS = "with outputs in columns";
    /// What something is at the start.
    INITIAL_VALUE = "initial value";
    /// The rate of a rate.
    SECOND_RATE = "second rate";
    /// The mark of a second rate.
    TWO_DOTS = "two dots";
    /// The conjugate of a quaternion.
    CONJUGATE = "conjugate quaternion";
    /// Hamilton's product.
    QUATERNION_PRODUCT = "quaternion product";
    /// The scalar part of a quaternion.
    SCALAR_PART = "scalar part";
    /// Its vector part.
    VECTOR_PART = "vector part";
    QUATERNION = "quaternion";
    /// A quaternion whose scalar part is written first.
    SCALAR_FIRST = "scalar first";
    /// A quaternion whose scalar part is written last.
    SCALAR_LAST = "scalar last";
    /// A frame that is written as a label above.
    FRAME_ABOVE = "frame at the upper right";
    /// A frame that is written as a label of brackets.
    FRAME_ON_BRACKETS = "frame on brackets";
    /// A frame that is written before a rate.
    FRAME_BEFORE_RATE = "frame at the upper left of a derivative";
    /// What such a frame means.
    RATE_FROM_FRAME = "the rate seen from that frame";
    /// Vectors below one another.
    COLUMN_OF_VECTORS = "column of vectors";
    /// What such a column may hold.
    ROWS_OF_MATRIX = "rows of a matrix";
    /// The adverb of what is left out.
    EXCEPT = "except";
    /// What a column of vectors is by custom.
    LIST = "a list";
    /// A sign that multiplies matrices as juxtaposition does.
    DOT_OF_MATRICES = "dot between matrices";
    /// What multiplies matrices.
    MATRIX_PRODUCT = "the matrix product";
    /// The noun of a matrix that takes components on axes to components on these axes after they have turned.
    COMPONENT_ROTATION = "passive rotation matrix";
    AERODYNAMIC_FORCE = "aerodynamic force";
    /// What a motor exerts.
    MOTOR_MOMENT = "motor moment";
    /// Where two bodies touch.
    CONTACT_POINT = "contact point";
    /// The time from one step to the next.
    STEP_SIZE = "step size";
    /// Angles that lead from one frame to another, one after the other.
    EULER_ANGLES = "Euler angles";
    /// Turning steadily about an axis without a moment: the mass centre is on it, and it is a principal axis.
    DYNAMICALLY_BALANCED = "dynamically balanced";
    /// With the mass centre on an axis.
    STATICALLY_BALANCED = "statically balanced";
    /// Not balanced, in one way or the other.
    UNBALANCED = "unbalanced";
    /// How long a spring is on which nothing acts.
    NATURAL_LENGTH = "natural length";
    VERTICAL = "vertical";
    /// The letters that tell how a system lies.
    COORDINATES = "generalised coordinates";
    /// The second derivatives of the kinetic energy in the rates of the coordinates.
    MASS_MATRIX = "mass matrix";
    /// The matrix that changes nothing.
    IDENTITY_MATRIX = "identity matrix";
    /// The energy that a body would have as a particle at its mass centre.
    ENERGY_OF_TRANSLATION = "kinetic energy of translation";
    /// The noun of what is left of a kinetic energy without that of the mass centre.
    ENERGY_OF_ROTATION = "kinetic energy of rotation";
    /// The meaning of an index over which there is no sum.
    NOT_SUMMED = "not summed";
    /// What the square of a letter means that is a vector.
    SQUARE_OF_VECTOR = "square of a vector";
    /// The matrix of a turn by an angle about a vector.
    ROTATION_MATRIX = "rotation matrix";
    /// The tensor a bᵀ of two vectors.
    TENSOR_PRODUCT = "tensor product";
    /// A sign of a custom: the full stop of `a.b`.
    FULL_STOP = "full stop between vectors";
    /// Quaternions side by side.
    PRODUCT_OF_QUATERNIONS = "product of quaternions";
    /// The vector a × b.
    CROSS_PRODUCT = "cross product";
    /// Vectors without a sign between them.
    VECTORS_SIDE_BY_SIDE = "vectors side by side";
    /// A dot that is no dot product.
    QUATERNION_DOT = "dot between quaternions";
    /// Ways to set formulas of which a sentence says that they change nothing.
    WAY_OF_SETTING = "way of setting";
    /// Braces over or under a part of a formula, with a label.
    UNDERBRACE = "underbrace";
    /// A letter of a vector that is set as one of a number.
    PLAIN_LETTER = "plain letter of a vector";
    /// The derivatives of a function.
    DERIVATIVE = "derivative";
    PARTIAL_DERIVATIVE = "partial derivative";
    /// Columns of a motion in a plane.
    COLUMNS_OF_TWO = "columns of two";
    /// Products that no letter names.
    OTHER_PRODUCTS = "other products of inertia";
    /// Half of what an ellipsoid measures along a principal axis.
    SEMI_AXIS = "semi-axis";
    DECIMAL_NUMBERS = "decimal numbers";
    VERTICALLY_ABOVE = "vertically above";
    DOT_PRODUCT = "dot product";
}

/// What happens at once.
pub(crate) const SUDDEN: [&str; 2] = ["impulse", "impact"];
/// How customs of a frame before or behind a letter begin.
pub(crate) const FRAME_AT_UPPER: &str = "frame at the upper";
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
/// Words of sentences about loads.
pub(crate) const OF_LOADS: [&str; 6] = ["spring", "force", "forces", "load", "loads", "exerts"];
/// Words of sentences that tell what bodies are made up of.
pub(crate) const OF_PARTS: [&str; 11] = [
    "assembly",
    "carries",
    "composed",
    "comprises",
    "consist",
    "consists",
    "contains",
    "includes",
    "particles",
    "parts",
    "system",
];
/// Words of sentences about where a potential energy is zero.
pub(crate) const OF_POTENTIALS: [&str; 3] = ["potential", "energy", "gravity"];
/// What is said of densities.
pub(crate) const PER_UNIT: [&str; 4] = [
    "per unit length",
    "per unit area",
    "per unit volume",
    "per unit mass",
];
/// What a motion is said to be without being another one.
pub(crate) const PLAIN_ADVERBS: [&str; 2] = ["without slipping", "freely"];
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
