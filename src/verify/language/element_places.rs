//! A point by the element of a body that is there: what is said of its place is said of the place of the element. Particles
//! that an index counts are placed by letters that denote their positions.

use super::fixed_axes::replace;
use super::heads::POSITION;
use super::one_thing::is_letter;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term};

/// What bodies that are spread out are made of.
const ELEMENT: &str = "element";

/// "p is the point of element `dm`. `$r$` is the position of p from O": r is the position of the element.
pub(crate) fn place_elements(declarations: &mut Vec<Declaration>) {
    let whole = declarations.iter().filter(|d| d.extent == Extent::Document);
    let places: Vec<(Term, Term)> = whole.filter_map(place_of_element).collect();
    for (point, element) in places {
        declarations.retain(|d| !d.statement.subjects().contains(&point));
        for declaration in declarations.iter_mut() {
            for term in declaration.statement.terms_mut() {
                replace(term, &point, &element);
            }
        }
    }
}

/// A point, and the element whose place alone it is.
pub(super) fn place_of_element(declaration: &Declaration) -> Option<(Term, Term)> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return None;
    };
    match (subjects.as_slice(), what.slots.as_slice(), what.head) {
        ([point], [(Slot::Of | Slot::FixedIn, element)], "point") => {
            let own = matches!(element, Term::Member { family, .. } if family == ELEMENT);
            own.then(|| (point.clone(), element.clone()))
        }
        _ => None,
    }
}

/// "Particle `$i$` is placed from O by `$r_i$`" says what the letter is: the position of the particle from O.
pub(crate) fn tell_places_of_particles(declarations: &mut [Declaration]) {
    for declaration in declarations {
        let Statement::Does {
            subjects,
            verb: "place",
            slots,
        } = &declaration.statement
        else {
            continue;
        };
        if let ([particle], [(Slot::From, from), (Slot::By, Term::Formula(letter))]) =
            (subjects.as_slice(), slots.as_slice())
            && is_counted_particle(particle)
            && is_letter(letter)
        {
            let slots = vec![
                (Slot::Of, particle.clone()),
                (Slot::RelativeTo, from.clone()),
            ];
            declaration.statement = Statement::Is {
                subjects: vec![Term::Formula(letter.clone())],
                what: NounPhrase::new(POSITION, slots),
            };
        }
    }
}

fn is_counted_particle(particle: &Term) -> bool {
    match particle {
        Term::Member { family, index } => {
            let number = index.source.trim().chars().all(|c| c.is_ascii_digit());
            family == "particle" && !number
        }
        _ => false,
    }
}
