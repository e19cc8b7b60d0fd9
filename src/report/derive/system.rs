//! A declared system's derivation as a page.

use crate::notation::{self, document::Format};
use crate::report::derive::letters::Formula;
use crate::report::derive::{About, Block, Derivation, Piece, Row};
use crate::verify::derivation::{Derived, Law, Part, Step, Subject, Text};
use crate::verify::{self, Finding, Sheet, Verdict};
use std::collections::HashSet;

/// The page that tells the derivation of a system.
pub fn of_system(derived: &Derived) -> Derivation {
    let mut blocks = vec![Block::Heading(1, title(derived))];
    blocks.push(said(format!(
        "Components are those on the axes of {}. A component that is zero has no line.",
        derived.axes
    )));
    let mut label = 0;
    for part in &derived.parts {
        blocks.extend(heading(part).map(|heading| Block::Heading(2, heading)));
        blocks.extend(opening(part).map(said));
        for step in &part.steps {
            blocks.extend(told(step, &mut label));
        }
    }
    Derivation {
        about: About::System {
            letters: derived.sentences.clone(),
        },
        blocks,
    }
}

/// The derivation without the rows that the checker does not prove by the same declarations, and how many these are.
///
/// An author's own rules for marks and labels may give a row another meaning than the one that it was derived in.
pub fn proved_part(derived: &Derived, sheets: &[Sheet]) -> (Derived, usize) {
    let page = of_system(derived).markdown();
    let (document, _) = notation::read("derivation", &page, Format::Markdown);
    let declared = verify::declarations(&document, sheets);
    let report = verify::check_declared(&document, &declared);
    let proved = |finding: &&Finding| matches!(finding.verdict, Verdict::Proved(_));
    let labels = report.findings.iter().filter(proved);
    let labels: HashSet<&str> = labels.filter_map(|f| f.label.as_deref()).collect();
    let mut part = derived.clone();
    let (mut number, mut left_out) = (0, 0);
    for part in &mut part.parts {
        for step in &mut part.steps {
            step.rows.retain(|_| {
                number += 1;
                let holds = labels.contains(format!("({number})").as_str());
                left_out += usize::from(!holds);
                holds
            });
        }
        part.steps.retain(|step| !step.rows.is_empty());
    }
    (part, left_out)
}

fn title(derived: &Derived) -> String {
    if let Some(sought) = &derived.sought {
        return capital(sought.trim());
    }
    let mut bodies = derived.parts.iter().filter_map(|part| match &part.subject {
        Subject::Body(name) if !name.is_empty() => Some(with_article(name)),
        _ => None,
    });
    match (bodies.next(), bodies.next()) {
        (Some(body), None) => format!("The equations of motion of {body}"),
        (Some(_), Some(_)) => "The equations of motion of the system".to_owned(),
        (None, _) => "The derivation".to_owned(),
    }
}

fn heading(part: &Part) -> Option<String> {
    match &part.subject {
        Subject::Frames => Some("How the frames turn".to_owned()),
        Subject::Body(name) if name.is_empty() => None,
        Subject::Body(name) => Some(capital(&with_article(name))),
        Subject::Steady { .. } => Some("Steady motion".to_owned()),
    }
}

/// What is said before the first step.
fn opening(part: &Part) -> Option<String> {
    match &part.subject {
        Subject::Steady { held, .. } if held.is_empty() => Some(
            "No steady motion is found. It needs a body that turns by angles about a fixed point and whose loads are declared; some angle must not change its energy."
                .to_owned(),
        ),
        Subject::Steady { held, even } => {
            let keeps = match held.as_slice() {
                [one] => format!("${one}$ keeps its value"),
                _ => format!("{} keep their values", listed(held)),
            };
            let changes = match even.as_slice() {
                [one] => format!("${one}$ changes at a constant rate"),
                _ => format!("{} change at constant rates", listed(even)),
            };
            Some(format!("Here {keeps}, and {changes}."))
        }
        Subject::Frames | Subject::Body(_) => None,
    }
}

/// "$a$, $b$ and $c$".
fn listed(letters: &[String]) -> String {
    let shown: Vec<String> = letters.iter().map(|letter| format!("${letter}$")).collect();
    match shown.as_slice() {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// A word is a noun; a letter is a name.
fn with_article(name: &str) -> String {
    match name.chars().count() > 2 && name.chars().all(|c| c.is_lowercase() || " -".contains(c)) {
        true => format!("the {name}"),
        false => name.to_owned(),
    }
}

fn capital(text: &str) -> String {
    match text.strip_prefix("the ") {
        Some(rest) => format!("The {rest}"),
        None => text.to_owned(),
    }
}

fn said(sentence: String) -> Block {
    Block::Prose(vec![Piece::Sentence(sentence)])
}

/// The letters, the law, and its rows.
fn told(step: &Step, label: &mut usize) -> Vec<Block> {
    let mut sentences = step.letters.clone();
    sentences.push(because(step.law).to_owned());
    let rows = step.rows.iter().map(|row| {
        *label += 1;
        Row {
            left: formula(&row.left),
            right: formula(&row.right),
            label: *label,
        }
    });
    let rows = rows.collect();
    vec![said(sentences.join(" ")), Block::Display(rows)]
}

fn formula(text: &Text) -> Formula {
    Formula {
        latex: text.latex.clone(),
        unicode: text.unicode.clone(),
    }
}

/// The law that a step rests on.
fn because(law: Law) -> &'static str {
    match law {
        Law::AngularVelocities => "Angular velocities add up from frame to frame.",
        Law::PointOfBody => {
            "The mass centre is a point of the body, which turns about a fixed point: its velocity is the angular velocity times the arm."
        }
        Law::Velocity => "The velocity of the mass centre is the rate of its position.",
        Law::Acceleration => {
            "The acceleration is the rate of the velocity. The transport law gives the part that comes from the turning axes."
        }
        Law::Momentum => "The momentum is the mass times the velocity of the mass centre.",
        Law::Newton => {
            "By Newton's law the force is the rate of the momentum. The transport law gives the part that comes from the turning axes."
        }
        Law::AngularMomentum => {
            "The inertia tensor takes the angular velocity to the angular momentum."
        }
        Law::SumOfParts => "The angular momentum of a whole is the sum over its parts.",
        Law::Moment => {
            "By the moment law the moment is the rate of the angular momentum. The transport law gives the part that comes from the turning axes."
        }
        Law::MomentPutIn => "With the angular momentum put in:",
        Law::Weight => "The weight points down.",
        Law::MomentsOfLoads => "The moment is the arm times the weight.",
        Law::Equations => "No other load has a moment, and the equations of motion follow.",
        Law::EquationsOfCentre => "No other force acts, and the motion of the mass centre follows.",
        Law::KineticEnergy => {
            "The kinetic energy is half the angular velocity times the angular momentum."
        }
        Law::Koenig => {
            "By König's law the kinetic energy is that of the mass centre and that of the turning about it."
        }
        Law::PotentialEnergy => "The potential energy is the weight times the height.",
        Law::TotalEnergy => "The total energy is the sum of both.",
        Law::FirstIntegrals => "The equations of motion keep this constant:",
        Law::Steady => "The equations of motion then need:",
        Law::Definition => "By its definition:",
    }
}
