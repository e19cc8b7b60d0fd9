//! A point that one part of the document tells anew: it is another point there.

use super::element_places::place_of_element;
use super::extent::common;
use super::fixed_axes::replace;
use super::heads::MASS_CENTRE;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term};

/// "G is the mass centre of the top. On lines 8 to 12 G is the mass centre of the disc": there G is another point, and
/// what is said of letters by G everywhere is said there by that one.
pub(crate) fn part_points_told_anew(declarations: &mut Vec<Declaration>) {
    let elements: Vec<Anew> = declarations.iter().filter_map(element_in_a_part).collect();
    declarations.retain(|declaration| element_in_a_part(declaration).is_none());
    let centres = points_told_anew(declarations);
    for anew in centres.into_iter().chain(elements) {
        let there = anew.letters_there(declarations);
        for declaration in declarations.iter_mut() {
            if declaration.extent == anew.extent {
                anew.rename(declaration);
            }
        }
        declarations.extend(there);
    }
}

/// A point by its name, the part of the document where it is another one, and how it is called there.
struct Anew {
    point: Term,
    extent: Extent,
    other: Term,
}

impl Anew {
    /// What is said in the part of the letters that speak of the point, and of those that speak of these.
    fn letters_there(&self, declarations: &[Declaration]) -> Vec<Declaration> {
        let letters = declarations
            .iter()
            .filter(|d| tells_letters(d) && d.extent != self.extent);
        let mut others: Vec<&Declaration> = letters.collect();
        let mut spoken = vec![self.point.clone()];
        let mut there = vec![];
        loop {
            let (speaking, silent): (Vec<_>, Vec<_>) = others
                .into_iter()
                .partition(|d| d.statement.terms().iter().any(|term| spoken.contains(term)));
            if speaking.is_empty() {
                return there;
            }
            for declaration in speaking {
                spoken.extend_from_slice(declaration.statement.subjects());
                there.extend(self.said_there(declaration));
            }
            others = silent;
        }
    }

    /// What a sentence says in the part, of the point that is meant there.
    fn said_there(&self, declaration: &Declaration) -> Option<Declaration> {
        let mut there = Declaration {
            extent: common(&declaration.extent, &self.extent)?,
            ..declaration.clone()
        };
        self.rename(&mut there);
        Some(there)
    }

    fn rename(&self, declaration: &mut Declaration) {
        for term in declaration.statement.terms_mut() {
            replace(term, &self.point, &self.other);
        }
    }
}

/// "On lines 8 to 12 P is the place of element `dm`": there P is the element.
fn element_in_a_part(declaration: &Declaration) -> Option<Anew> {
    let (point, other) = place_of_element(declaration)?;
    (declaration.extent != Extent::Document).then(|| Anew {
        point,
        extent: declaration.extent.clone(),
        other,
    })
}

/// The points that are the mass centre of one thing everywhere, and of another thing in a part of the document.
fn points_told_anew(declarations: &[Declaration]) -> Vec<Anew> {
    let centres = declarations.iter().filter_map(centre);
    let centres: Vec<(&Extent, &Term, &NounPhrase)> = centres.collect();
    let everywhere = |point: &Term, what: &NounPhrase| {
        let mut told = centres.iter();
        told.any(|(extent, term, other)| {
            **extent == Extent::Document
                && *term == point
                && other.slot(Slot::Of) != what.slot(Slot::Of)
        })
    };
    let anew = centres.iter().enumerate();
    let anew = anew.filter(|(_, (extent, point, what))| {
        **extent != Extent::Document && everywhere(point, what)
    });
    anew.map(|(at, (extent, point, _))| Anew {
        point: (*point).clone(),
        extent: (*extent).clone(),
        other: Term::Name(format!("{} (there {at})", name(point))),
    })
    .collect()
}

fn name(point: &Term) -> &str {
    match point {
        Term::Name(name) => name,
        Term::Formula(letter) => &letter.source,
        _ => "",
    }
}

/// A point that is told to be a mass centre.
fn centre(declaration: &Declaration) -> Option<(&Extent, &Term, &NounPhrase)> {
    match &declaration.statement {
        Statement::Is { subjects, what } if what.head == MASS_CENTRE => {
            let point = subjects.first().filter(|_| subjects.len() == 1)?;
            Some((&declaration.extent, point, what))
        }
        _ => None,
    }
}

/// Whether a sentence tells what letters are.
fn tells_letters(declaration: &Declaration) -> bool {
    let subjects = declaration.statement.subjects();
    let letter = |term: &Term| matches!(term, Term::Formula(_));
    let does = matches!(declaration.statement, Statement::Does { .. });
    !does && !subjects.is_empty() && subjects.iter().all(letter)
}
