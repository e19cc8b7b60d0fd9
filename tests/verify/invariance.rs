//! A verdict does not hang on how a line is written: not on brackets and the order of terms, not on the letters, not on
//! the names of the axes, not on the notation.

use super::corpus::expr::Line;
use super::corpus::family::{self, Family};
use super::corpus::mistake;
use super::corpus::page::Page;
use super::corpus::random::Random;
use super::corpus::rewrite::rewritten;
use super::corpus::style::Style;
use super::corpus::world::{World, is_true};
use proptest::prelude::{ProptestConfig, any, prop_assert, proptest};
use proptest::sample::Index;
use proptest::test_runner::TestCaseError;

/// Pages of each test. Without optimisation the search for repairs takes ten times as long.
const CASES: u32 = if cfg!(debug_assertions) { 8 } else { 100 };

/// A family of true lines, in most cases with a mistake in one of them.
fn page(choice: Index, random: &mut Random) -> (Family, Vec<Line>) {
    let mut families = family::all();
    let family = families.swap_remove(choice.index(families.len()));
    let mut lines = family.lines.clone();
    let worlds: Vec<World> = (0..3)
        .map(|_| World::draw(family.premises, random))
        .collect();
    let at = random.below(lines.len());
    let made: Vec<Line> = random
        .pick(mistake::ALL)
        .into_iter()
        .flat_map(|mistake| mistake.made(&lines[at]))
        .filter(|line| is_true(&worlds, line) == Some(false))
        .collect();
    if let Some(spoiled) = random.pick(&made) {
        lines[at] = spoiled.clone();
    }
    (family, lines)
}

/// Holds the verdicts on two ways to write the same lines against each other.
fn alike(
    family: &Family,
    one: (&Style, &[Line]),
    other: (&Style, &[Line]),
) -> Result<(), TestCaseError> {
    let pages = [one, other].map(|(style, lines)| Page::new(family, style, lines));
    let [before, after] = pages.each_ref().map(|page| {
        let name = |finding: Option<polhode::verify::Finding>| {
            finding.map_or("lost", |found| found.verdict.name())
        };
        page.findings().into_iter().map(name).collect::<Vec<_>>()
    });
    prop_assert!(
        before == after,
        "{}\n{before:?}\n{after:?}\n{}\n\n{}",
        family.name,
        pages[0].text,
        pages[1].text
    );
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(CASES))]

    #[test]
    fn regrouping_changes_no_verdict(seed in any::<u64>(), choice in any::<Index>()) {
        let mut random = Random(seed);
        let (family, lines) = page(choice, &mut random);
        let style = family.style(&mut random);
        let regrouped: Vec<Line> = lines.iter().map(|line| rewritten(line, &mut random)).collect();
        alike(&family, (&style, &lines), (&style, &regrouped))?;
    }

    #[test]
    fn other_letters_change_no_verdict(seed in any::<u64>(), choice in any::<Index>()) {
        let mut random = Random(seed);
        let (family, lines) = page(choice, &mut random);
        let letters = Style::draw(&mut random).in_latex();
        let renamed = Style { dress: Style::BOOK.dress, quotients: false, digits: false, ..letters };
        alike(&family, (&Style::BOOK, &lines), (&renamed, &lines))?;
    }

    #[test]
    fn numbered_axes_change_no_verdict(seed in any::<u64>(), choice in any::<Index>()) {
        let mut random = Random(seed);
        let (family, lines) = page(choice, &mut random);
        let [lettered, numbered] =
            [false, true].map(|digits| family.fitted(Style { digits, ..Style::BOOK }));
        alike(&family, (&lettered, &lines), (&numbered, &lines))?;
    }

    #[test]
    fn other_notation_changes_no_verdict(seed in any::<u64>(), choice in any::<Index>()) {
        let mut random = Random(seed);
        let (family, lines) = page(choice, &mut random);
        let drawn = family.style(&mut random);
        let moment = if drawn.plain { "ΣM" } else { Style::BOOK.moment };
        let Style { plain, dress, quotients, .. } = drawn;
        let written = Style { plain, dress, quotients, moment, ..Style::BOOK };
        alike(&family, (&Style::BOOK, &lines), (&written, &lines))?;
    }
}
