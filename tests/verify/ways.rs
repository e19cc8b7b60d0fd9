//! One motion said in many ways: the verdicts of the lines stay as they are, whatever words a sentence has.
//!
//! A file has sentences, lines with their verdicts, and on each line below another way to say some of the sentences: `start of
//! the sentence => what stands in its place | another sentence && start of the next one => …`.

use super::systems::verdicts;

fn check(file: &str) {
    let parts: Vec<&str> = file.split("\n---\n").collect();
    let [told, lines, ways] = parts.as_slice() else {
        panic!("a file has three parts");
    };
    let told: Vec<&str> = told.lines().filter(|l| !l.starts_with('#')).collect();
    let lines = lines.lines().filter_map(|line| line.split_once(' '));
    let (expected, lines): (Vec<&str>, Vec<&str>) = lines.unzip();
    let text: String = lines.iter().map(|l| format!("$$ {l} $$\n\n")).collect();
    let wrong: Vec<String> = ways
        .lines()
        .chain([""])
        .filter_map(|way| {
            let (found, misread) = verdicts(&said(&told, way), &text);
            let same = found == expected.concat() && misread.is_empty();
            (!same).then(|| format!("{found} {way} {misread:?}"))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The sentences with some of them said in another way.
fn said(told: &[&str], way: &str) -> String {
    let mut told: Vec<String> = told.iter().map(|s| (*s).to_owned()).collect();
    for change in way.split(" && ").filter(|change| !change.is_empty()) {
        let (start, new) = change.split_once(" =>").unwrap_or((change, ""));
        let at = told.iter().position(|sentence| sentence.starts_with(start));
        let at = at.unwrap_or_else(|| panic!("no sentence starts with {start}"));
        let new: Vec<&str> = new.split('|').map(str::trim).collect();
        told[at] = new.join("\n");
    }
    told.join("\n")
}

#[test]
fn a_wheel_rolls() {
    check(include_str!("ways/rolling_wheel.txt"));
}

#[test]
fn a_rod_swings() {
    check(include_str!("ways/hinged_rod.txt"));
}

#[test]
fn a_roller_runs_down_a_slope() {
    check(include_str!("ways/slope.txt"));
}

#[test]
fn a_top_turns_under_its_weight() {
    check(include_str!("ways/heavy_top.txt"));
}
