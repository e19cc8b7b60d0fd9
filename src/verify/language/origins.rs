//! The origins of frames: "the origin of B" is a point fixed in B, also where no sentence gives it a name.

use super::heads::MOMENT_OF_INERTIA;
use super::kinds::name;
use super::messages::origin_of;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term};
use std::collections::BTreeMap;

/// Names the origins that sentences speak of, each by the name that another sentence gives it, or by its frame.
pub(crate) fn name_origins(declarations: &mut Vec<Declaration>) {
    let mut named: BTreeMap<String, Term> = BTreeMap::new();
    for declaration in declarations.iter() {
        if let Statement::Is { subjects, what } = &declaration.statement
            && let ([point], Some(frame)) = (subjects.as_slice(), frame_of(what))
            && name(point).is_some()
        {
            named.entry(frame).or_insert_with(|| point.clone());
        }
    }
    let mut told = vec![];
    for declaration in declarations.iter_mut() {
        let mut new = vec![];
        let mut called = |frame: &Term| -> Option<Term> {
            let of = name(frame)?;
            let point = named.entry(of.clone()).or_insert_with(|| {
                let point = Term::Name(origin_of(&of.replace('_', "")));
                let what = NounPhrase::new("origin", vec![(Slot::Of, frame.clone())]);
                new.push(Statement::one_is(point.clone(), what));
                point
            });
            Some(point.clone())
        };
        meet(&mut declaration.statement, &mut called);
        let terms = declaration.statement.terms_mut();
        terms.into_iter().for_each(|term| call(term, &mut called));
        told.extend(new.into_iter().map(|statement| Declaration {
            statement,
            extent: Extent::Document,
            ..declaration.clone()
        }));
    }
    declarations.extend(told);
}

/// The name of the frame of which a noun is the origin.
fn frame_of(what: &NounPhrase) -> Option<String> {
    match (what.head, what.slots.as_slice()) {
        ("origin", [(Slot::Of, frame)]) => name(frame),
        _ => None,
    }
}

/// "The origin of B is the origin of A": it lies there. "The origin of B is fixed in A": it is a point fixed there.
fn meet(statement: &mut Statement, called: &mut impl FnMut(&Term) -> Option<Term>) {
    if let Statement::Premise(premise) = statement
        && premise.head == "origin"
        && premise.is("fixed")
        && let Some(point) = premise.slot(Slot::Of).and_then(&mut *called)
    {
        premise.slots.retain(|(slot, _)| *slot != Slot::Of);
        let slots = std::mem::take(&mut premise.slots);
        *statement = Statement::one_is(point, NounPhrase::new("point", slots));
    }
    let Statement::Is { subjects, what } = statement else {
        return;
    };
    let origins = subjects
        .iter()
        .all(|subject| matches!(subject, Term::Phrase(own) if frame_of(own).is_some()));
    if let ("origin", [(Slot::Of, frame)], true) = (what.head, what.slots.as_slice(), origins)
        && let Some(point) = called(frame)
    {
        *statement = Statement::Does {
            subjects: subjects.clone(),
            verb: "lie",
            slots: vec![(Slot::At, point)],
        };
    }
}

fn call(term: &mut Term, called: &mut impl FnMut(&Term) -> Option<Term>) {
    let Term::Phrase(phrase) = term else { return };
    if frame_of(phrase).is_some()
        && let [(_, frame)] = phrase.slots.as_slice()
        && let Some(point) = called(frame)
    {
        *term = point;
        return;
    }
    let slots = phrase.slots.iter_mut();
    slots.for_each(|(_, term)| call(term, called));
}

/// "the moment of inertia of the body about x", of an axis of a frame whose origin is told: about the axis through it.
pub(crate) fn take_axes_through_origins(declarations: &mut [Declaration]) {
    let axes: Vec<(Term, Term)> = declarations
        .iter()
        .filter_map(|d| {
            let (axes, frame) = axes_of(&d.statement)?;
            let origin = declarations.iter().find_map(|d| origin_told(d, &frame))?;
            Some(axes.into_iter().map(move |axis| (axis, origin.clone())))
        })
        .flatten()
        .collect();
    for declaration in declarations {
        let Statement::Is { what, .. } = &mut declaration.statement else {
            continue;
        };
        let pointless = what.slots.iter().all(|(slot, _)| *slot != Slot::Through);
        if what.head != MOMENT_OF_INERTIA || !pointless {
            continue;
        }
        for (_, about) in what
            .slots
            .iter_mut()
            .filter(|(slot, _)| *slot == Slot::About)
        {
            let mut own = axes.iter().filter(|(axis, _)| axis == about);
            if let (Some((axis, origin)), None) = (own.next(), own.next()) {
                let slots = vec![(Slot::Through, origin.clone()), (Slot::Along, axis.clone())];
                *about = Term::Phrase(Box::new(NounPhrase::new("axis", slots)));
            }
        }
    }
}

/// "x, y and z are the axes of B"
fn axes_of(statement: &Statement) -> Option<(Vec<Term>, Term)> {
    match statement {
        Statement::Is { subjects, what } if what.head == "axes" => {
            Some((subjects.clone(), what.slot(Slot::Of)?.clone()))
        }
        _ => None,
    }
}

/// "O is the origin of B"
fn origin_told(declaration: &Declaration, frame: &Term) -> Option<Term> {
    match &declaration.statement {
        Statement::Is { subjects, what } if frame_of(what) == name(frame) => {
            let told = declaration.extent == Extent::Document && name(frame).is_some();
            subjects.first().filter(|_| told).cloned()
        }
        _ => None,
    }
}
