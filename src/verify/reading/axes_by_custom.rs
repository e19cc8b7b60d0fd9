//! The names of axes: their places by custom, and which of two frames are alike.

use crate::verify::language::messages::numbered_frame;
use crate::verify::language::statement::Term;
use crate::verify::reading::frames_read::CUSTOMARY;
use crate::verify::reading::names::name_of;

/// The axes of a frame with the number of each: in the order in which they are named, but for two of three, which have their
/// places by custom: "x and z are the axes of B".
pub(super) fn places_of_axes(subjects: &[Term]) -> Vec<(usize, &Term)> {
    let by_custom = |names: &[&str]| -> Option<Vec<usize>> {
        let place = |subject: &Term| {
            let name = name_of(subject)?;
            let label = name.rsplit('_').next();
            names.iter().position(|own| Some(*own) == label)
        };
        subjects.iter().map(place).collect()
    };
    let mut customs = CUSTOMARY.iter().chain([&UNIT_VECTORS]);
    let places = match subjects.len() {
        2 => customs.find_map(|names| by_custom(names)),
        _ => None,
    };
    let in_order = || (0..subjects.len()).collect();
    let places: Vec<usize> = places.unwrap_or_else(in_order);
    places.into_iter().zip(subjects).collect()
}

/// Unit vectors along the axes, as they are called most often.
const UNIT_VECTORS: [&str; 3] = ["i", "j", "k"];

/// Whether two axes are called alike: `b_3` and `n_3`, `Z` and `z`.
pub(super) fn same_label(one: &str, other: &str) -> bool {
    let [one, other] = [one, other].map(|name| {
        let label = name.rsplit('_').next().unwrap_or(name);
        let label = label.trim_start_matches("\\hat ").to_lowercase();
        let customary = CUSTOMARY.iter().chain([&UNIT_VECTORS]);
        let place = customary
            .filter_map(|names| names.iter().position(|n| *n == label))
            .next();
        (place, label)
    });
    one.1 == other.1 || one.0.is_some() && one.0 == other.0
}

/// Whether two axes have one letter, each with its frame for the label: `Z_1` of 1 and `Z_0` of 0.
pub(super) fn labelled_alike(one: (&str, &str), other: (&str, &str)) -> bool {
    let letter = |(name, frame): (&'_ str, &'_ str)| {
        let (letter, label) = name.split_once('_')?;
        let own = label == frame || numbered_frame(label) == frame;
        own.then(|| letter.to_owned())
    };
    letter(one).is_some() && letter(one) == letter(other)
}
