//! How the author writes all letters.

use crate::verify::model::system::{FrameId, Vector};
use crate::verify::term::letters::{At, Reach};
use crate::verify::term::quaternions::Layout;
use std::collections::{BTreeMap, BTreeSet};

/// Customs of writing.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Customs {
    /// Where a repeated axis index is summed, and where it is not.
    pub(crate) summed: Vec<(Reach, bool)>,
    /// A frame written above a letter takes components on it.
    pub(crate) raised_frames: bool,
    /// A frame written above a dotted letter says from where its rate is seen.
    pub(crate) frames_above_rates: bool,
    /// Where vectors below one another are the rows of a matrix.
    pub(crate) vectors_in_rows: Vec<Reach>,
    /// Whether products of inertia are integrals: I_xy = ∫ x y dm.
    pub(crate) integrals: bool,
    /// Square brackets around a vector make its cross-product matrix.
    pub(crate) crossing_brackets: bool,
    /// Where a brace with a label only names what stands in it.
    pub(crate) naming_braces: Vec<Reach>,
    pub(crate) products: Products,
    /// Where the scalar stands in a quaternion.
    pub(crate) layout: Layout,
    /// The names of axes that only one frame has.
    pub(crate) named_axes: BTreeMap<String, (FrameId, usize)>,
    /// Letters of which nothing is told but that axes have their names.
    pub(crate) named_only: BTreeSet<String>,
    /// How many dimensions space has, where.
    pub(crate) dimensions: Vec<(Reach, usize)>,
}

/// What signs of products mean, and factors without one.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Products {
    /// A sentence or a matrix tells whether products of inertia are integrals.
    pub(crate) of_inertia_told: bool,
    /// A dot between quaternions is their product.
    pub(crate) quaternion_dots: bool,
    /// Any two vectors side by side are a dyad; two unit vectors are one in any case.
    pub(crate) dyads: bool,
    /// Where a cross product of vectors of a plane is its component across that plane, and along what.
    pub(crate) across: Vec<(Reach, Vector)>,
    /// Where a cross is the sign of the product of matrices.
    pub(crate) matrices_crossed: Vec<Reach>,
    /// Where a number that is added to a matrix is its product with the identity matrix.
    pub(crate) numbers_beside_matrices: Vec<Reach>,
    /// Which products two vectors in brackets are, by how these open.
    pub(crate) in_brackets: BTreeMap<char, BracketProduct>,
}

/// What two vectors in brackets with a comma between them are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BracketProduct {
    Dot,
    Cross,
}

impl Products {
    /// Along what a cross product is its component at a place.
    pub(crate) fn across_at(&self, at: &At) -> Option<&Vector> {
        let own = self.across.iter().find(|(reach, _)| reach.covers(at, 0));
        own.map(|(_, axis)| axis)
    }

    /// Whether a number that is added to a matrix is that many times the identity at a place.
    pub(crate) fn adds_identity_at(&self, at: &At) -> bool {
        let mut told = self.numbers_beside_matrices.iter();
        told.any(|reach| reach.covers(at, 0))
    }

    /// Whether a cross beside a matrix is the sign of the product of matrices at a place.
    pub(crate) fn cross_matrices_at(&self, at: &At) -> bool {
        self.matrices_crossed
            .iter()
            .any(|reach| reach.covers(at, 0))
    }
}

impl Customs {
    /// Whether a brace with a label says nothing at a place.
    pub(crate) fn braces_name_at(&self, at: &At) -> bool {
        self.naming_braces.iter().any(|reach| reach.covers(at, 0))
    }

    /// Whether vectors below one another are the rows of a matrix at a place.
    pub(crate) fn vectors_are_rows_at(&self, at: &At) -> bool {
        self.vectors_in_rows.iter().any(|reach| reach.covers(at, 0))
    }

    /// Whether an index that stands twice is summed over at a place.
    pub(crate) fn sums_at(&self, at: &At) -> bool {
        let said = |sums: bool| {
            let mut said = self.summed.iter().filter(|(_, summed)| *summed == sums);
            said.any(|(reach, _)| reach.covers(at, 0))
        };
        said(true) && !said(false)
    }
}
