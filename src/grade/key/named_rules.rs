//! The rules that lines use by name.

use crate::verify::Finding;

/// The rules that a line uses. The name of a rule is one word; premises and lines are said in several.
pub(in crate::grade) fn rules_of(finding: &Finding) -> impl Iterator<Item = &str> {
    let uses = finding.uses.iter().map(String::as_str);
    uses.filter(|rule| !rule.contains(' '))
}

/// How many rules each line uses that no line before it used.
pub(super) fn new_rules(findings: &[Finding]) -> Vec<usize> {
    let each = (0..findings.len()).map(|at| {
        let (before, rest) = findings.split_at(at);
        let own = rest.first().into_iter().flat_map(rules_of);
        let known: Vec<&str> = before.iter().flat_map(rules_of).collect();
        own.filter(|rule| !known.contains(rule)).count()
    });
    each.collect()
}
