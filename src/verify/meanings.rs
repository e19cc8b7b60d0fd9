//! Checks a document in each of the readings that it leaves open, and keeps the one that most of its lines bear out.

use crate::notation::document::{Document, Item};
use crate::verify::check::Checker;
use crate::verify::letters::central_letter::bar_central_letter;
use crate::verify::letters::components_at::take_components_at;
use crate::verify::letters::convention::UNDECIDED;
use crate::verify::letters::named_axes::number_named_axes;
use crate::verify::letters::point_axes::name_axes_alone;
use crate::verify::letters::point_labels::note_marks;
use crate::verify::letters::primed_axes::label_primed_axes;
use crate::verify::letters::raised_labels::lower_labels;
use crate::verify::letters::raised_steps::lower_steps;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::skew_marks::note_skew_marks;
use crate::verify::letters::turned_primes::label_turned_primes;
use crate::verify::letters::two_states::tell_states_apart;
use crate::verify::letters::world_labels::drop_world_labels;
use crate::verify::lines::index::written_out;
use crate::verify::lines::trust::{unexplained, withhold};
use crate::verify::reason;
use crate::verify::verdict::Report;
use crate::verify::words::euler_words::sequences;
use crate::verify::words::sizes_of_vectors::sizes_of_vectors;
use crate::verify::words::text::Text;

/// Checks every line of a document.
pub fn check(document: &Document) -> Report {
    let (mut document, summed) = written_out(document);
    take_components_at(&mut document);
    name_axes_alone(&mut document);
    let axis_labels = number_named_axes(&mut document);
    let turned_primes = label_turned_primes(&mut document);
    bar_central_letter(&mut document);
    lower_labels(&mut document);
    lower_steps(&mut document);
    let states = tell_states_apart(&mut document);
    drop_world_labels(&mut document);
    note_skew_marks(&mut document);
    note_marks(&mut document);
    label_primed_axes(&mut document);
    let document = &Text::of(&document);
    let mut reading = Reading::of(document);
    reading.summed = summed;
    reading.turned_primes = turned_primes;
    reading.states = states;
    reading.axis_labels = axis_labels;
    reading.sizes = sizes_of_vectors(document, &reading.usage);
    // Steps in general inertia matrices are long.
    let any_axes = reading.writes_no_components(document);
    reading.on_chosen_axes = any_axes && reading.usage.counts_steps();
    let first = checked(document, reading.clone());
    let (reading, (first, looked_ahead)) = with_angles(document, reading, first);
    // Which way matrix and quaternion go, where no word says it; and whether a symbol is what the clause behind its
    // first use says or what that use makes it: as most lines have it.
    let by_use = looked_ahead && first.summary().refuted > 0;
    let with = |change: &dyn Fn(&mut Reading)| {
        let mut other = reading.clone();
        change(&mut other);
        other
    };
    let ways = reading.attitude.other_ways();
    let attitudes = ways
        .iter()
        .map(|way| with(&|reading| reading.attitude = way.clone()));
    let by_use = by_use.then(|| with(&|reading| reading.by_use = true));
    let mut best = attitudes.chain(by_use).fold(first, |best, other| {
        let (now, then) = (best.summary(), tried(document, &other).summary());
        match then.refuted < now.refuted && then.proved > now.proved {
            true => checked(document, other).0,
            false => best,
        }
    });
    // Nor may any word or matrix say which sign products of inertia have. One line may be a slip.
    if best.products.decided_by == UNDECIDED && reading.writes_products() && failing(&best) > 0 {
        let other = with(&|reading| reading.products_as_entries = true);
        let entries = tried(document, &other);
        let gain = entries
            .summary()
            .proved
            .saturating_sub(best.summary().proved);
        if failing(&entries) < failing(&best) && (gain > 1 || gain > 0 && is_impossible(&best)) {
            best = checked(document, other).0;
        }
    }
    if grows(&best) && any_axes && !reading.on_chosen_axes {
        let chosen = with(&|reading| reading.on_chosen_axes = true);
        let decided = |report: &Report| report.summary().proved + report.summary().refuted;
        if decided(&tried(document, &chosen)) > decided(&best) {
            best = checked(document, chosen).0;
        }
    }
    withhold(&mut best);
    best
}

/// Lines that fail, those included for which no possible body shows it.
fn failing(report: &Report) -> usize {
    report.summary().refuted + without_witness(report)
}

fn without_witness(report: &Report) -> usize {
    let reasons = report.findings.iter().filter_map(|f| f.reason.as_deref());
    reasons.filter(|r| *r == reason::NO_WITNESS).count()
}

/// Whether no body can be as the document has it, as far as its lines are refuted.
fn is_impossible(report: &Report) -> bool {
    without_witness(report) > 0 && report.summary().refuted == 0
}

/// Whether lines stay open because a general inertia matrix makes them long.
fn grows(report: &Report) -> bool {
    let reasons = report.findings.iter().filter_map(|f| f.reason.as_deref());
    let long = [reason::BUDGET, reason::GROWN, reason::NO_PROOF_IN_NUMBERS];
    reasons.into_iter().any(|found| long.contains(&found))
}

/// The verdicts of a reading that may not be kept: nobody looks for the mistakes of its false lines, which takes longest.
fn tried<'d>(document: &'d Text<'d>, reading: &Reading) -> Report {
    let mut reading = reading.clone();
    reading.on_trial = true;
    checked(document, reading).0
}

/// Whether a display stands behind a paragraph.
fn goes_into_display(behind: &[Item]) -> bool {
    let blank = |item: &&Item| matches!(item, Item::Prose { text, .. } if text.trim().is_empty());
    let next = behind.iter().find(|item| !blank(item));
    matches!(next, Some(Item::Formula(formula)) if formula.display)
}

fn checked<'d>(document: &'d Text<'d>, reading: Reading) -> (Report, bool) {
    let mut checker = Checker::new(document, reading);
    for (at, item) in document.items.iter().enumerate() {
        checker.look_ahead(at);
        checker.hear_ahead(at);
        checker.hear_instant(at);
        checker.goes_into_display = goes_into_display(&document.items[at + 1..]);
        checker.item(item);
        // A reading that is only tried and grows beyond its budget goes no further.
        if checker.theory.terms_left == Some(0) {
            break;
        }
    }
    let ahead = checker.looked_ahead;
    (checker.report(), ahead)
}

/// The reading with the angles that the words name, if it proves more lines than it refutes.
fn with_angles<'d>(
    document: &'d Text<'d>,
    reading: Reading,
    first: (Report, bool),
) -> (Reading, (Report, bool)) {
    let sequences = sequences(document);
    let angles = (!sequences.is_empty())
        .then(|| Checker::new(document, reading.clone()).euler_angles(&sequences));
    let Some(angles) = angles.flatten() else {
        return (reading, first);
    };
    let mut turned = reading.clone();
    turned.euler_angles = Some(angles);
    let second = checked(document, turned.clone());
    let (now, then) = (first.0.summary(), second.0.summary());
    let whole = second.0.findings.len() == first.0.findings.len();
    // A line that a named slip puts right, or that only carries one on, speaks for the reading.
    let against = |report: &Report| unexplained(report).count();
    let better = whole
        && then.proved > now.proved
        && then.refuted.saturating_sub(now.refuted) <= then.proved - now.proved
        && against(&second.0).saturating_sub(against(&first.0)) * 2 <= then.proved - now.proved;
    if better {
        (turned, second)
    } else {
        (reading, first)
    }
}
