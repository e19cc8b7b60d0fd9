//! Ten thousand lines whose truth is known apart from the verifier: none that is true is refuted, none that is false
//! is proved, and a single mistake is named and repaired.

use super::corpus::expr::Line;
use super::corpus::family::{self, Family};
use super::corpus::mistake::{self, Mistake};
use super::corpus::page::Page;
use super::corpus::parse;
use super::corpus::random::Random;
use super::corpus::rewrite::{rewritten, substituted};
use super::corpus::style::Style;
use super::corpus::world::{Body, World, is_true};
use polhode::verify::{Finding, Verdict};
use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Pages of each family. Without optimisation one of each must do: the search for repairs takes ten times as long there.
const ROUNDS: u64 = if cfg!(debug_assertions) { 1 } else { 12 };

fn worlds(family: &Family, random: &mut Random) -> Vec<World> {
    (0..3)
        .map(|_| World::draw(family.premises, random))
        .collect()
}

/// The lines of a family, each rewritten.
fn lines(family: &Family, random: &mut Random) -> Vec<Line> {
    let principal = family.premises.body != Body::Full;
    let rewrite = |line: &Line| {
        let mut line = rewritten(line, random);
        if random.one_in(4) {
            // What names the momentum keeps its name: a line that says that a row is that row is no use.
            let mut all = substituted(&line, principal);
            all.retain(|new| new.left == line.left);
            line = random.pick(&all).cloned().unwrap_or(line);
        }
        line
    };
    family.lines.iter().map(rewrite).collect()
}

#[test]
fn the_families_and_their_rewritings_are_true_by_the_oracle() {
    let mut random = Random(1);
    for family in family::all() {
        let worlds = worlds(&family, &mut random);
        for line in family.lines.iter() {
            assert_eq!(
                is_true(&worlds, line),
                Some(true),
                "{}: {}",
                family.name,
                Style::BOOK.line(line)
            );
        }
        let many: Vec<Line> = (0..20).flat_map(|_| lines(&family, &mut random)).collect();
        for line in many {
            assert_eq!(
                is_true(&worlds, &line),
                Some(true),
                "{}: {}",
                family.name,
                Style::BOOK.line(&line)
            );
            let text = family.style(&mut random).line(&line);
            let read = parse::line(&text);
            assert!(
                read.is_some_and(|line| is_true(&worlds, &line) == Some(true)),
                "{text}"
            );
        }
    }
}

/// What became of the lines.
#[derive(Default)]
struct Tally {
    lines: usize,
    verdicts: BTreeMap<(bool, &'static str), usize>,
    wrong: Vec<String>,
    /// True lines that are neither proved nor refuted, and false ones likewise.
    open: Vec<String>,
    /// By mistake: how many were made, how many named, how many repaired.
    named: BTreeMap<Mistake, [usize; 3]>,
    unnamed: Vec<String>,
    /// Repairs that the oracle does not find true.
    unsound: Vec<String>,
}

impl Tally {
    fn enter(&mut self, family: &str, truth: bool, text: &str, finding: Option<&Finding>) {
        self.lines += 1;
        let verdict = finding.map_or("lost", |f| f.verdict.name());
        *self.verdicts.entry((truth, verdict)).or_default() += 1;
        let said = || {
            let reason = finding.and_then(|f| f.reason.as_deref()).unwrap_or("");
            format!("{family}: {truth}, but {verdict}: {text} ({reason})")
        };
        match (truth, finding.map(|f| &f.verdict)) {
            (true, Some(Verdict::Refuted)) | (false, Some(Verdict::Proved(_))) => {
                self.wrong.push(said())
            }
            (true, Some(Verdict::Proved(_))) | (false, Some(Verdict::Refuted)) => {}
            _ => self.open.push(said()),
        }
    }

    fn join(&mut self, other: Self) {
        self.lines += other.lines;
        for (key, count) in other.verdicts {
            *self.verdicts.entry(key).or_default() += count;
        }
        for (mistake, counts) in other.named {
            let sums = self.named.entry(mistake).or_default();
            sums.iter_mut()
                .zip(counts)
                .for_each(|(sum, count)| *sum += count);
        }
        self.wrong.extend(other.wrong);
        self.open.extend(other.open);
        self.unnamed.extend(other.unnamed);
        self.unsound.extend(other.unsound);
    }

    fn print(&self) {
        println!("{} lines {:?}", self.lines, self.verdicts);
        for (mistake, [made, named, repaired]) in &self.named {
            println!("{mistake:?}: {made} made, {named} named, {repaired} repaired");
        }
        for list in [&self.wrong, &self.open, &self.unnamed, &self.unsound] {
            println!("{}:\n{}", list.len(), list.join("\n"));
        }
    }

    fn name(
        &mut self,
        mistake: Mistake,
        worlds: &[World],
        right: &str,
        text: &str,
        finding: &Finding,
    ) {
        let counts = self.named.entry(mistake).or_default();
        let diagnosis = finding.diagnosis.as_ref();
        let kind = diagnosis.map_or("nothing", |d| d.kind);
        let named = mistake.kinds().contains(&kind);
        let suggestion = diagnosis
            .and_then(|d| d.suggestion.as_deref())
            .unwrap_or("");
        let repair = parse::line(suggestion);
        let repaired = repair.as_ref().and_then(|line| is_true(worlds, line));
        counts[0] += 1;
        counts[1] += usize::from(named);
        counts[2] += usize::from(named && repaired == Some(true));
        if diagnosis.is_some() && repaired != Some(true) {
            let what = if repair.is_none() { "unread" } else { "false" };
            self.unsound
                .push(format!("{what}: {text}\n  {kind}: {suggestion}"));
        }
        if !named || repaired != Some(true) {
            self.unnamed.push(format!(
                "{mistake:?}: {text}\n  is {right}\n  {kind}: {suggestion}"
            ));
        }
    }
}

#[test]
fn no_true_line_is_refuted_and_no_false_one_proved() {
    let families = family::all();
    let rounds = std::env::var("CORPUS_ROUNDS")
        .ok()
        .and_then(|n| n.parse().ok())
        .unwrap_or(ROUNDS);
    let jobs: Vec<(u64, &Family)> = (0..rounds)
        .flat_map(|round| families.iter().map(move |family| (round, family)))
        .collect();
    let next = AtomicUsize::new(0);
    let tallies = Mutex::new(BTreeMap::new());
    let work = || {
        while let Some((i, (round, family))) = {
            let i = next.fetch_add(1, Ordering::Relaxed);
            jobs.get(i).map(|job| (i, job))
        } {
            let tally = page_and_its_spoilings(family, Random(1_000 * round + i as u64));
            tallies.lock().expect("no thread panicked").insert(i, tally);
        }
    };
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get());
    std::thread::scope(|scope| (0..threads).for_each(|_| drop(scope.spawn(work))));
    let mut whole = Tally::default();
    for tally in tallies
        .into_inner()
        .expect("no thread panicked")
        .into_values()
    {
        whole.join(tally);
    }
    whole.print();
    for (mistake, &[made, _, repaired]) in &whole.named {
        let share = repaired as f64 / made as f64;
        assert!(
            made < 20 || share >= 0.95,
            "{mistake:?}: {repaired} of {made} named and repaired"
        );
    }
    assert!(
        whole.lines >= 500 * rounds as usize,
        "only {} lines",
        whole.lines
    );
    assert!(whole.unsound.is_empty(), "{}", whole.unsound.join("\n"));
    assert!(
        whole.wrong.is_empty(),
        "{} wrong:\n{}",
        whole.wrong.len(),
        whole.wrong.join("\n")
    );
}

/// A page of the family as it should be, and once more with each mistake.
fn page_and_its_spoilings(family: &Family, mut random: Random) -> Tally {
    let mut tally = Tally::default();
    let worlds = worlds(family, &mut random);
    let style = family.style(&mut random);
    let lines = lines(family, &mut random);
    let page = Page::new(family, &style, &lines);
    for (line, finding) in lines.iter().zip(page.findings()) {
        tally.enter(family.name, true, &style.line(line), finding.as_ref());
    }
    for mistake in mistake::ALL {
        spoil(
            family,
            &style,
            &lines,
            *mistake,
            &worlds,
            &mut random,
            &mut tally,
        );
    }
    tally
}

/// One mistake in one line of a page.
fn spoil(
    family: &Family,
    style: &Style,
    lines: &[Line],
    mistake: Mistake,
    worlds: &[World],
    random: &mut Random,
    tally: &mut Tally,
) {
    // A page whose tensor has all its signs turned is a page in the other convention, and no mistake.
    if mistake == Mistake::Convention && family.name == "matrices" {
        return;
    }
    let mut false_lines = vec![];
    // What few families can show is shown more often there.
    let times = if mistake.is_rare() { 3 } else { 1 };
    for (at, line) in lines.iter().enumerate() {
        for made in mistake.made(line) {
            if is_true(worlds, &made) == Some(false) {
                false_lines.push((at, made));
            }
        }
    }
    for _ in 0..times {
        let Some((at, made)) = random.pick(&false_lines).cloned() else {
            return;
        };
        let mut spoiled = lines.to_vec();
        spoiled[at] = made;
        let page = Page::new(family, style, &spoiled);
        for (i, (line, finding)) in spoiled.iter().zip(page.findings()).enumerate() {
            let text = style.line(line);
            tally.enter(family.name, i != at, &text, finding.as_ref());
            if let (true, Some(finding)) = (i == at, finding) {
                tally.name(mistake, worlds, &style.line(&lines[at]), &text, &finding);
            }
        }
    }
}
