//! From a key and the work of a student to marks.

use crate::grade::key::{Key, Milestone};
use crate::grade::paper::{Paper, PaperLine, Work, Worth};
use crate::grade::policy::{FollowThrough, Marks};
use crate::grade::result::{Assumption, Graded, Line, Outcome, Reached, Slip};
use crate::grade::rules::{Decision, Marker};
use crate::grade::slip;
use crate::source::Span;
use std::collections::BTreeMap;

/// Marks the work of one student.
///
/// The result depends on the key and the work alone.
pub fn mark(key: &Key, work: &Work) -> Graded {
    let paper = Paper::read(key, work);
    if paper.lines.is_empty() {
        // What could not be read may be worth something; what is not there is not.
        let (outcome, reason) = match paper.troubles.is_empty() {
            true => (Outcome::None, "there is no line in it that can be marked"),
            false => (Outcome::Human, "nothing in it was marked"),
        };
        return unmarked(key, work, &paper.troubles, reason, outcome);
    }
    let mut markers: Vec<Marker<'_>> = (0..key.stages.len())
        .map(|stage| Marker::new(key, &paper, stage))
        .collect();
    let mut troubles = paper.troubles.clone();
    if markers.iter().any(Marker::conflict) {
        troubles.push("a letter is defined in another way than in the key".to_owned());
    }
    let milestones: Vec<Reached> = key
        .milestones
        .iter()
        .map(|milestone| {
            let decided = markers[milestone.stage].milestone(milestone);
            reached(
                key,
                &paper,
                milestone,
                decided,
                markers[milestone.stage].conflict(),
            )
        })
        .collect();
    let carried = carried(&mut markers, &paper);
    let is_missing = |m: &Reached| m.outcome != Outcome::Full;
    if milestones.iter().any(is_missing) {
        troubles.extend(paper.remarks.doubts.iter().cloned());
    }
    troubles.extend(waiting(&milestones));
    Graded {
        id: work.id.clone(),
        marks: key.policy.total(milestones.iter().map(|m| m.marks)),
        milestones,
        first_slip: first_slip(&markers, &paper, &carried),
        assumptions: assumptions(&paper),
        queue: joined(&troubles),
        lines: shown(&paper, &carried),
        questions: paper.questions.clone(),
        notes: paper.remarks.notes.clone(),
    }
}

/// What is said of work that could not be marked: a person should look at all of it.
pub fn not_marked(key: &Key, id: &str, reason: &str) -> Graded {
    let work = Work {
        id: id.to_owned(),
        texts: vec![],
        troubles: vec![],
        answers: vec![],
    };
    unmarked(key, &work, &[], reason, Outcome::Human)
}

fn unmarked(key: &Key, work: &Work, troubles: &[String], reason: &str, outcome: Outcome) -> Graded {
    let milestones = key.milestones.iter().map(|milestone| Reached {
        label: milestone.label.clone(),
        max: milestone.max,
        marks: Marks::default(),
        outcome,
        place: None,
        reason: reason.to_owned(),
    });
    let mut said = troubles.to_vec();
    said.push(reason.to_owned());
    Graded {
        id: work.id.clone(),
        marks: Marks::default(),
        milestones: milestones.collect(),
        first_slip: None,
        assumptions: vec![],
        queue: joined(&said),
        lines: vec![],
        questions: vec![],
        notes: vec![],
    }
}

/// Why milestones wait for a person, those for one reason together.
fn waiting(milestones: &[Reached]) -> Vec<String> {
    let mut reasons: Vec<(&str, Vec<&str>)> = vec![];
    for waits in milestones.iter().filter(|m| m.outcome == Outcome::Human) {
        match reasons
            .iter_mut()
            .find(|(reason, _)| *reason == waits.reason)
        {
            Some((_, labels)) => labels.push(&waits.label),
            None => reasons.push((&waits.reason, vec![&waits.label])),
        }
    }
    let said = reasons.iter();
    said.map(|(reason, labels)| format!("{}: {reason}", labels.join(", ")))
        .collect()
}

fn joined(reasons: &[String]) -> Option<String> {
    let mut once: Vec<&str> = vec![];
    for reason in reasons {
        if !once.contains(&reason.as_str()) {
            once.push(reason);
        }
    }
    (!once.is_empty()).then(|| once.join("; "))
}

fn reached(
    key: &Key,
    paper: &Paper<'_>,
    milestone: &Milestone,
    decided: Decision,
    conflict: bool,
) -> Reached {
    let mut decided = decided;
    if conflict {
        decided.outcome = Outcome::Human;
        decided.reason = "a letter is defined in another way than in the key".to_owned();
    }
    let follow = match key.policy.follow_through {
        FollowThrough::Full => milestone.max,
        FollowThrough::Half => milestone.max.half(),
        FollowThrough::None => Marks::default(),
    };
    Reached {
        label: milestone.label.clone(),
        max: milestone.max,
        marks: match decided.outcome {
            Outcome::Full => milestone.max,
            Outcome::FollowThrough => follow,
            Outcome::None | Outcome::Human => Marks::default(),
        },
        outcome: decided.outcome,
        place: decided.line.map(|line| paper.lines[line].place.clone()),
        reason: decided.reason,
    }
}

/// The wrong lines that only carry on an earlier one, or have its slip again.
fn carried(markers: &mut [Marker<'_>], paper: &Paper<'_>) -> BTreeMap<usize, bool> {
    let wrong = (0..paper.lines.len()).filter(|&line| paper.lines[line].is_wrong());
    let wrong: Vec<usize> = wrong.collect();
    let mut carried = BTreeMap::new();
    for line in wrong {
        let follows = markers.iter_mut().any(|marker| {
            let attempts = marker.attempts(line).to_vec();
            let mut attempts = attempts.into_iter();
            marker.is_repeated(line)
                || attempts.any(|attempt| {
                    marker
                        .carries(attempt, line)
                        .is_some_and(|from| !from.is_empty())
                })
        });
        carried.insert(line, follows);
    }
    carried
}

fn first_slip(
    markers: &[Marker<'_>],
    paper: &Paper<'_>,
    carried: &BTreeMap<usize, bool>,
) -> Option<Slip> {
    let (&line, _) = carried.iter().find(|(_, carried)| !**carried)?;
    let found = paper.lines[line].kindest();
    let beside = markers.iter().find_map(|marker| {
        let attempt = marker.attempts(line).first()?;
        marker.beside(*attempt, line)
    });
    let (kind, message) = match (&found.diagnosis, beside) {
        (Some(diagnosis), _) => (diagnosis.kind, diagnosis.message.clone()),
        (None, Some((own, key))) => {
            let (kind, message) = slip::name(own, key);
            (kind, message.to_owned())
        }
        (None, None) => ("other", found.reason.clone().unwrap_or_default()),
    };
    Some(Slip {
        place: paper.lines[line].place.clone(),
        kind: kind.to_owned(),
        message,
        repair: found.diagnosis.as_ref().and_then(|d| d.suggestion.clone()),
    })
}

fn assumptions(paper: &Paper<'_>) -> Vec<Assumption> {
    let assumed = |line: &&PaperLine| line.worth.contains(&Worth::Assumed);
    let lines = paper.lines.iter().filter(assumed);
    let assumptions = lines.map(|line| Assumption {
        place: line.place.clone(),
        text: line.found[0].source.clone(),
        in_key: line.follows_from_key,
    });
    assumptions.collect()
}

/// The lines with their verdicts, at the stage that is kindest to each, and those that are not claimed.
fn shown(paper: &Paper<'_>, carried: &BTreeMap<usize, bool>) -> Vec<Line> {
    let claimed = paper.lines.iter().enumerate().map(|(at, line)| {
        let mut shown = Line::of(line.kindest(), line.place.file.clone());
        shown.carried = carried.get(&at).copied().unwrap_or(false);
        if shown.carried {
            // What puts it right stands beside the line that it carries on.
            (shown.mistake, shown.repair) = (None, None);
        }
        ((line.document, line.found[0].span), shown)
    });
    let mut lines: Vec<((usize, Span), Line)> = claimed.collect();
    for (at, (document, withdrawn)) in paper.documents.iter().zip(&paper.withdrawn).enumerate() {
        let several = paper.documents.len() > 1;
        let file = several.then(|| document.source.name.clone());
        let own = withdrawn.lines.iter();
        lines.extend(own.map(|&(span, why)| {
            (
                (at, span),
                Line::withdrawn(document, span, file.clone(), why),
            )
        }));
    }
    lines.sort_by_key(|(place, _)| *place);
    lines.into_iter().map(|(_, line)| line).collect()
}
