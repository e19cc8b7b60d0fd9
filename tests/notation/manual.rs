//! The manual says what the reader does: every spelling in its tables is read as its row says.

use super::outline::{document, latex, plain};
use polhode::notation::{MANUAL, document::Format, read};
use polhode::verify::check;

/// A row of a table: the heads of its columns and its cells.
struct Entry {
    heads: Vec<String>,
    cells: Vec<String>,
}

/// The rows of all tables.
fn entries() -> Vec<Entry> {
    let mut heads: Vec<String> = vec![];
    let mut out = vec![];
    for line in MANUAL.lines() {
        let Some(inner) = line.strip_prefix("| ").and_then(|l| l.strip_suffix('|')) else {
            heads.clear();
            continue;
        };
        let bar = "\u{1}";
        let cells = inner.replace("\\|", bar);
        let cells: Vec<String> = cells
            .split('|')
            .map(|cell| cell.trim().replace(bar, "|"))
            .collect();
        match heads.is_empty() {
            true => heads = cells,
            false if cells[0].starts_with("---") => {}
            false => out.push(Entry {
                heads: heads.clone(),
                cells,
            }),
        }
    }
    out
}

/// What stands between backticks in a cell; a space inside longer runs of them belongs to the marks.
fn spellings(cell: &str) -> Vec<String> {
    let mut rest = cell;
    let mut out = vec![];
    while let Some(start) = rest.find('`') {
        let run = rest[start..].len() - rest[start..].trim_start_matches('`').len();
        let inner = &rest[start + run..];
        let mark = "`".repeat(run);
        let end = inner.find(&mark).expect("code that is closed");
        let text = if run > 1 {
            inner[..end].trim()
        } else {
            &inner[..end]
        };
        out.push(text.replace(" ⏎ ", "\n").replace('⏎', "\n"));
        rest = &inner[end + run..];
    }
    out
}

/// The readings of what a row promises, each written in LaTeX or in plain text.
fn promised(cell: &str) -> Vec<String> {
    let spellings = spellings(cell);
    assert!(!spellings.is_empty(), "{cell}: nothing is promised");
    let tex: Vec<String> = spellings.iter().map(|text| latex(text)).collect();
    let text: Vec<String> = spellings.iter().map(|text| plain(text)).collect();
    vec![tex.join("\n"), text.join("\n")]
}

/// Spellings of a column that are read otherwise than the row says.
fn strays(entry: &Entry, column: usize, reading: impl Fn(&str) -> String) -> Vec<String> {
    let last = entry.cells.last().expect("a row has cells");
    let promised = match last.as_str() {
        "no line" => vec![String::new()],
        cell => promised(cell),
    };
    let stray = |spelling: String| {
        let found = reading(&spelling);
        let good = promised.contains(&found)
            && !found.replace("<=", "").contains('<')
            && !found.contains("unreadable");
        (!good).then(|| format!("{spelling} is read as {found}, and {last} as {promised:?}"))
    };
    spellings(&entry.cells[column])
        .into_iter()
        .filter_map(stray)
        .collect()
}

fn strays_in_role(entry: &Entry) -> Vec<String> {
    let stray = |source: String| {
        let text = format!("The axes are attached to the body.\n\n{source}\n");
        let (document, _) = read("a.md", &text, Format::Markdown);
        let report = check(&document);
        let role = report.findings.last().map(|finding| finding.role.name());
        (role != Some(entry.cells[1].as_str())).then(|| format!("{source}: {role:?}"))
    };
    spellings(&entry.cells[0])
        .into_iter()
        .filter_map(stray)
        .collect()
}

#[test]
fn every_row_of_the_manual_is_true() {
    let (mut count, mut wrong) = (0, vec![]);
    for entry in entries() {
        let heads: Vec<&str> = entry.heads.iter().map(String::as_str).collect();
        match heads.as_slice() {
            ["LaTeX", "plain text", "read as"] => {
                wrong.extend(strays(&entry, 0, latex));
                wrong.extend(strays(&entry, 1, plain));
            }
            ["Markdown", "lines"] => {
                wrong.extend(strays(&entry, 0, |text| document(text, Format::Markdown)));
            }
            ["LaTeX file", "lines"] => {
                wrong.extend(strays(&entry, 0, |text| document(text, Format::Latex)));
            }
            ["Plain text", "lines"] => {
                wrong.extend(strays(&entry, 0, |text| document(text, Format::Text)));
            }
            ["Markdown", "role"] => wrong.extend(strays_in_role(&entry)),
            ["key", "value"] => {}
            other => panic!("a table without a test: {other:?}"),
        }
        count += 1;
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(count > 70, "only {count} rows were found");
}

#[test]
fn the_limits_are_those_of_the_manual() {
    let readable = |formula: &str| !latex(formula).contains(['<', ':']);
    let sum = |length: usize| format!("a = {}b", "a+".repeat((length - 5) / 2));
    assert!(MANUAL.contains("no formula above 50 000 bytes"));
    assert!(readable(&sum(50_000)) && !readable(&sum(50_002)));
    assert!(MANUAL.contains("at most 400 digits"));
    assert!(readable(&"7".repeat(400)) && !readable(&"7".repeat(401)));
    assert!(MANUAL.contains("at most 50 brackets"));
    let nested = |depth: usize| format!("{}x{}", "(".repeat(depth), ")".repeat(depth));
    assert!(readable(&nested(50)) && !readable(&nested(51)));
}

#[test]
fn the_command_shows_the_manual_without_its_marks() {
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_polhode"))
        .args(["help", "notation"])
        .output()
        .expect("the command starts");
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    assert!(output.status.success());
    for entry in entries() {
        for spelling in entry.cells[..entry.cells.len() - 1]
            .iter()
            .flat_map(|c| spellings(c))
        {
            let shown = spelling.replace('\n', " ⏎ ");
            assert!(text.contains(shown.trim()), "{shown} is not shown");
        }
    }
    assert!(text.lines().all(|line| line.chars().count() <= 120));
    assert!(!text.contains("---|") && !text.contains("| ---"));
}
