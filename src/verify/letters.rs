//! What the letters of a document stand for, decided for it as a whole.

pub(super) mod attitude_layouts;
pub(super) mod attitude_matrix;
pub(super) mod attitude_parts;
pub(super) mod attitude_reading;
pub(super) mod axes_by_label;
pub(super) mod beginnings;
pub(super) mod body;
pub(super) mod convention;
pub(super) mod custom;
pub(super) mod frame;
pub(super) mod named_rates;
pub(super) mod naming;
pub(super) mod one_axis;
pub(super) mod point_labels;
pub(super) mod primes;
pub(super) mod reading;
pub(super) mod rivals;
pub(super) mod roles_by_law;
pub(super) mod sequences;
pub(super) mod sightings;
pub(super) mod skew_marks;
pub(super) mod space_axes;
pub(super) mod triad;
pub(super) mod two_points;
pub(super) mod usage;
pub(super) mod wholes;
