//! What a document speaks of: frames, points, bodies, loads, and the laws that tie their quantities together.

pub(crate) mod atoms;
pub(crate) mod blows;
pub(crate) mod bodies;
pub(crate) mod changes;
pub(crate) mod common_list;
pub(crate) mod contact;
pub(crate) mod dimensions;
mod equal_angles;
pub(crate) mod frames;
pub(crate) mod inertial_loads;
pub(crate) mod kernels;
pub(crate) mod loads;
pub(crate) mod partial;
pub(crate) mod points;
pub(crate) mod powers;
pub(crate) mod rates;
mod roots;
pub(crate) mod steady;
pub(crate) mod sums;
pub(crate) mod swings;
pub(crate) mod system;
pub(crate) mod unplaced;
pub(crate) mod variations;
pub(crate) mod virtual_power;
