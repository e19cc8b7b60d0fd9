//! Relations of a document that give no symbol a value are used all the same: to prove, and to refute on points that
//! satisfy them.

use polhode::notation::{document::Format, read};
use polhode::verify::{Finding, check};

fn findings(text: &str) -> Vec<Finding> {
    let (document, _) = read("relations.md", text, Format::Markdown);
    check(&document).findings
}

/// The last line of an opening with one displayed claim behind it.
fn claim(opening: &str, line: &str) -> Finding {
    let text = format!("{opening}\n\nHence we find\n\n$$\n{line}\n$$\n");
    findings(&text).pop().expect("a line stands in the text")
}

/// Holds claims against their verdicts, and what is proved against the number of the line that it must name.
fn decide(opening: &str, uses: &str, cases: &[(&str, &str)]) {
    for (line, verdict) in cases {
        let found = claim(opening, line);
        assert_eq!(found.verdict.name(), *verdict, "{line}: {:?}", found.reason);
        if *verdict == "proved" {
            assert!(
                found.uses.iter().any(|u| u == uses),
                "{line}: {:?}",
                found.uses
            );
        }
    }
}

/// The angle between the axis of a top and its angular momentum.
#[test]
fn a_component_is_a_share_of_the_magnitude_that_it_is_part_of() {
    let opening = r"
The angular momentum is $\mathbf{M}$ and the principal moments are $I_1, I_2, I_3$, so that

$$M_1 = I_1\Omega_1, \quad M_2 = I_2\Omega_2, \quad M_3 = I_3\Omega_3$$

Let $\theta$ be the angle between the axis and $\mathbf{M}$, that is $M_3 = M\cos\theta$.";
    let cases = [
        (r"\Omega_3 = \frac{M}{I_3}\cos\theta", "proved"),
        (r"I_3\Omega_3 = M\cos\theta", "proved"),
        (r"\Omega_3 = \frac{M}{I_1}\cos\theta", "refuted"),
        (r"\Omega_3 = \frac{M}{I_3}\sin\theta", "refuted"),
        (r"\Omega_3 = -\frac{M}{I_3}\cos\theta", "refuted"),
    ];
    decide(opening, "line 6", &cases);
}

/// The precession and the spin of a free symmetric body (Hibbeler, Dynamics, section 21.6).
#[test]
fn a_vector_is_its_magnitude_times_a_direction() {
    let opening = r"
Body axes are $x, y, z$, principal axes with $I_{xx}=I_{yy}=I$, $I_{zz}=I_z$. The angular velocity of the body is

$$\omega_x = \dot\theta, \quad \omega_y = \dot\phi\sin\theta,\quad \omega_z = \dot\phi\cos\theta+\dot\psi$$

$$\mathbf H_G = I\omega_x \mathbf i + I\omega_y\mathbf j + I_z\omega_z \mathbf k$$

Let the $y$ and $z$ axes and $\mathbf{H}_G$ lie in one plane, $\mathbf{H}_G = H_G\sin\theta\,\mathbf{j} + H_G\cos\theta\,\mathbf{k}$.";
    let cases = [
        (r"\omega_x = 0", "proved"),
        (r"\omega_y = \frac{H_G\sin\theta}{I}", "proved"),
        (r"\omega_z = \frac{H_G\cos\theta}{I_z}", "proved"),
        (r"\dot\phi = \frac{H_G}{I}", "proved"),
        (r"\dot\psi = \frac{I - I_z}{I\,I_z}H_G\cos\theta", "proved"),
        (
            r"\dot\psi = \frac{I - I_z}{I_z}\dot\phi\cos\theta",
            "proved",
        ),
        (r"\omega_y = \frac{H_G\sin\theta}{I_z}", "refuted"),
        (r"\omega_y = \frac{H_G\cos\theta}{I}", "refuted"),
        (r"\dot\phi = \frac{H_G}{I_z}", "refuted"),
        (r"\dot\psi = \frac{I_z - I}{I\,I_z}H_G\cos\theta", "refuted"),
    ];
    decide(opening, "line 8", &cases);
    let slope = claim(opening, r"\dot\phi = \frac{H_G}{I}");
    let says_so = |c: &String| c.contains(r"\theta") && c.contains(r"\ne 0");
    assert!(
        slope.conditions.iter().any(says_so),
        "{:?}",
        slope.conditions
    );
}

/// Both components of a direction, with a root in one of them.
#[test]
fn two_shares_give_their_quotient() {
    let opening = r"
The body is symmetric, with principal moments $I_1 = I_2$ and $I_3$. Let $\omega_\perp = \sqrt{\omega_1^2 + \omega_2^2}$.
Let $\theta$ be the angle of the axis with $\mathbf{L}$: $L\sin\theta = I_1\omega_\perp$ and $L\cos\theta = I_3\omega_3$.";
    let cases = [
        (
            r"\tan\theta = \frac{I_1\omega_\perp}{I_3\omega_3}",
            "proved",
        ),
        (
            r"\tan\theta = \frac{I_3\omega_\perp}{I_1\omega_3}",
            "refuted",
        ),
        (r"\sin\theta = \frac{I_1\omega_\perp}{L}", "proved"),
        (r"\sin\theta = \frac{I_3\omega_\perp}{L}", "refuted"),
    ];
    decide(opening, "line 3 (2)", &cases[..1]);
    for (line, verdict) in cases {
        let found = claim(opening, line);
        assert_eq!(found.verdict.name(), verdict, "{line}: {:?}", found.reason);
    }
}

/// A direction fixed in the body, by its cosines.
#[test]
fn squares_of_the_components_of_a_unit_vector_add_up_to_one() {
    let opening = r"
Suppose the components of the unit vector satisfy $c_1^2 + c_2^2 + c_3^2 = 1$.";
    let cases = [
        (r"1 - c_3^2 = c_1^2 + c_2^2", "proved"),
        (
            r"(c_1^2 + c_2^2)^2 + c_3^2 (c_1^2 + c_2^2) = 1 - c_3^2",
            "proved",
        ),
        (r"1 + c_3^2 = c_1^2 + c_2^2", "refuted"),
        (r"c_1 + c_2 + c_3 = 1", "refuted"),
    ];
    decide(opening, "line 2", &cases);
}

#[test]
fn a_chain_may_end_in_a_constant() {
    let last = |line: &str| {
        let all = findings(&format!(
            "A body turns without torque about its mass centre, on principal axes.\n\n\
             $$ \\mathbf L = I\\boldsymbol\\omega $$\n\n$$ L^2 = I_1^2\\omega_1^2 + I_2^2\\omega_2^2 + I_3^2\\omega_3^2 $$\n\n$$ {line} $$\n"
        ));
        let last = all.last();
        last.map(|f| {
            (
                f.verdict.name(),
                f.diagnosis.clone().and_then(|d| d.suggestion),
            )
        })
    };
    let energy = r"\tfrac12(I_1\omega_1^2 + I_2\omega_2^2 + I_3\omega_3^2) = \text{const}";
    assert_eq!(last(&format!("T = {energy}")), Some(("proved", None)));
    let slip = last(r"T = I_1\omega_1^2 + I_2\omega_2^2 + I_3\omega_3^2 = \text{const}");
    assert!(matches!(slip, Some(("refuted", Some(_)))), "{slip:?}");
    let moving = last(r"\omega_1 = \text{const}");
    assert_eq!(moving.map(|(verdict, _)| verdict), Some("refuted"));
}
