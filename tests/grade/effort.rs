//! What marking takes, by the products of terms that are worked out: the same on every machine and in every build.

use super::hostile::too_much;
use super::{ANSWER, COMPONENT, KEY, LAW, MOMENTUM, key};
use polhode::algebra::products_of_terms;
use polhode::grade::{Key, Work, mark};
use polhode::notation::document::Format;

/// A million take about a tenth of a second.
const MOST: u64 = 4_000_000;

fn effort(key: &Key, text: &str) -> u64 {
    let before = products_of_terms();
    mark(key, &Work::of_text("s", "s.md", Format::Markdown, text));
    products_of_terms() - before
}

#[test]
fn no_submission_takes_more_than_a_bound() {
    let key = key(KEY);
    let mut over = vec![];
    for (name, text) in too_much() {
        let effort = effort(&key, &String::from_utf8_lossy(&text));
        println!("{name}: {effort}");
        if effort > MOST {
            over.push(format!("{name}: {effort}"));
        }
    }
    assert!(over.is_empty(), "{over:?}");
}

#[test]
fn what_the_key_says_is_worked_out_once() {
    let key = key(KEY);
    let text = [LAW, COMPONENT, MOMENTUM, ANSWER].concat();
    let first = effort(&key, &text);
    let next = [effort(&key, &text), effort(&key, &text)];
    println!("{first}, then {next:?}");
    assert_eq!(next[0], next[1]);
    assert!(next[0] < first, "{first}, then {next:?}");
    assert!(next[0] < 2_000, "{next:?}");
}

#[test]
fn ten_times_the_lines_take_ten_times_as_much() {
    let key = key(KEY);
    let of = |lines: usize| effort(&key, &COMPONENT.repeat(lines));
    let (_, few, many) = (of(1), of(30), of(300));
    println!("{few}, {many}");
    assert!(many <= 11 * few, "{few}, {many}");
}
