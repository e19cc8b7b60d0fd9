//! Axes that words call principal through the mass centre, in a document that takes the inertia about another point too.

use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::values::about_point::tensor_about;
use crate::verify::words::book::{has_any, lowered};

/// Names of the mass centre.
const CENTRE: &[&str] = &[
    "through the centre",
    "through the center",
    "centre of mass",
    "center of mass",
    "mass centre",
    "mass center",
    "centroid",
    "central principal",
];

/// The premise in words, as a report shows it.
const PREMISE: &str = "principal axes through the mass centre: the products of inertia vanish";

impl Checker<'_> {
    /// Takes in that axes through the mass centre are principal, where that is one of two points and not the one that the
    /// laws are about; whether the sentence says so.
    pub(crate) fn central_axes_are_principal(&mut self, span: Span) -> bool {
        let Some(points) = self.reading.points.clone() else {
            return false;
        };
        let sentence = lowered(&self.sentence);
        let label = points.centre.to_lowercase();
        let ends = sentence.match_indices('⟨').map(|(at, _)| &sentence[..at]);
        let mut names = ends.filter_map(|text| text.split_whitespace().next_back());
        let of_centre = has_any(&sentence, CENTRE) || names.any(|name| name == label);
        if points.main == points.centre || !of_centre {
            return false;
        }
        let tensor = tensor_about(&points.centre, &points, &mut self.theory.atoms);
        if self.vanishes_in(PREMISE, tensor, &[3, 4, 5]) {
            self.tell(span, PREMISE.to_owned());
        }
        true
    }
}
