//! What becomes of a line: a claim, a definition, something given, or a reason to leave it open.

pub(super) mod accept;
pub(super) mod cases;
pub(super) mod claim;
pub(super) mod data;
pub(super) mod decimals;
pub(super) mod define;
pub(super) mod digits;
pub(super) mod doubt;
pub(super) mod entities;
pub(super) mod euler_angles;
pub(super) mod euler_rates;
pub(super) mod forward;
pub(super) mod given;
pub(super) mod given_motion;
pub(super) mod goes_on;
pub(super) mod index;
pub(super) mod inequality;
pub(super) mod laws_in_words;
pub(super) mod line;
pub(super) mod named_only;
pub(super) mod news;
pub(super) mod numbers;
pub(super) mod points;
pub(super) mod small;
pub(super) mod space_line;
pub(super) mod trust;
