//! What the words of a document say: roles of lines, premises, moments, what is constant.

pub(super) mod attitude_words;
pub(super) mod book;
pub(super) mod cones_in_words;
pub(super) mod constants_in_words;
pub(super) mod euler_words;
pub(super) mod legend;
pub(super) mod moments_by_adjective;
pub(super) mod moments_in_words;
pub(super) mod only_product;
pub(super) mod outlasting;
pub(super) mod phrases;
pub(super) mod points_in_words;
pub(super) mod premise;
pub(super) mod prose;
pub(super) mod quantity_names;
pub(super) mod residuals;
pub(super) mod role;
pub(super) mod role_words;
pub(super) mod running_sentence;
pub(super) mod sentences;
pub(super) mod small_rates;
pub(super) mod small_words;
pub(super) mod suppositions;
pub(super) mod symmetric_body;
pub(super) mod torque_free;
pub(super) mod turning_axes;
