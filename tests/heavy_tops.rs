//! Tops under their weight, on axes that do not take part in the spin.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

fn top(words: &str, weight: &str, twice: &str, spin: &str) -> String {
    verdicts(&format!(
        r"A symmetric top turns by the precession angle $\phi$ about the vertical, the nutation angle $\theta$ about the line of nodes and the spin angle $\psi$ about its axis. $\hat k$ is along its axis and $\hat i$ along the line of nodes; the axes do not take part in the spin and turn with

$$ \boldsymbol\Omega = \dot\theta\,\hat i + \dot\phi\sin\theta\,\hat j + \dot\phi\cos\theta\,\hat k $$

$$ \boldsymbol\omega = \boldsymbol\Omega + \dot\psi\,\hat k $$

Let $s = \dot\psi + \dot\phi\cos\theta$. With the moments of inertia $A$, $A$, $C$

$$ \mathbf L = A\dot\theta\,\hat i + A\dot\phi\sin\theta\,\hat j + Cs\,\hat k $$

{words} So the components are

$$ {weight} = A\ddot\theta - A\dot\phi^2\sin\theta\cos\theta + Cs\dot\phi\sin\theta $$

$$ 0 = A\ddot\phi\sin\theta + {twice}A\dot\phi\dot\theta\cos\theta - Cs\dot\theta $$

$$ 0 = {spin}C\dot s $$
"
    ))
}

#[test]
fn the_weight_makes_a_moment_about_the_line_of_nodes() {
    let words = "The weight $mg$ acts at the distance $d$ from $O$.";
    let ends = |found: String| found[found.len() - 3..].to_owned();
    assert_eq!(ends(top(words, r"mgd\sin\theta", "2", "")), "ppp");
    assert_eq!(ends(top(words, r"mgd\sin\theta", "", "")), "prp");
    let false_one = ends(top(words, r"mgd\cos\theta", "2", ""));
    assert!(
        !false_one.starts_with('p') && !false_one.starts_with('a'),
        "{false_one}"
    );
    let other = "The weight $mg$ acts at the distance $d$ from $O$, and so does the friction.";
    assert!(!ends(top(other, r"mgd\sin\theta", "", "")).contains('r'));
}
