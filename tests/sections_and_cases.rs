//! Documents of several sections or cases: what goes on from one to the next.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn a_motion_goes_on_under_the_next_headings_where_nothing_moves_in_another_way() {
    let text = |later: &str| {
        format!(
            r"A thin disk of mass $m$ and radius $r$ sits on a shaft. Axes fixed in the disk: $\mathbf e_2$ is the normal, the axes are principal, and the moments of inertia are $P$ about the normal and $D$ about a diameter.

## Rates

The shaft turns at the constant rate $n$, so

$$ \boldsymbol\omega = n\sin\gamma\,\mathbf e_1 + n\cos\gamma\,\mathbf e_2 $$

## Momentum

$$ \mathbf H = D n\sin\gamma\,\mathbf e_1 + P n\cos\gamma\,\mathbf e_2 $$

## Moment

$$ {later} $$
"
        )
    };
    let found = |later| verdicts(&text(later));
    assert_eq!(found(r"M_3 = (P - D) n^2\sin\gamma\cos\gamma"), "app");
    assert_eq!(found(r"M_3 = (D - P) n^2\sin\gamma\cos\gamma"), "apr");
    // Under a heading of its own the rate may change.
    assert_eq!(
        found(r"M_2 = P\dot\omega_2 + (P - D)\omega_1\omega_3"),
        "apr"
    );
}
