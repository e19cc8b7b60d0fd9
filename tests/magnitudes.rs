//! Lines between magnitudes: roots of squares, and roots that no world of rational numbers has.

use polhode::notation::{document::Format, read};
use polhode::verify::check;

fn verdicts(text: &str) -> Vec<&'static str> {
    let (document, _) = read("magnitudes.md", text, Format::Markdown);
    let findings = check(&document).findings;
    findings.iter().map(|f| f.verdict.name()).collect()
}

const SPIN: &str = r"No torque acts. On principal axes $I_{xx} = I_{yy} = A$ and $I_{zz} = C$. We take $\omega_x = a\cos nt$ and $\omega_y = a\sin nt$.";

fn last(line: &str) -> &'static str {
    let found = verdicts(&format!("{SPIN} So\n\n$$ {line} $$\n"));
    found.last().copied().unwrap_or("nothing")
}

#[test]
fn the_root_of_a_square_is_the_size_that_was_squared() {
    assert_eq!(last(r"\sqrt{L_x^2 + L_y^2} = A a"), "proved");
    assert_eq!(last(r"\sqrt{L_x^2 + L_y^2} = A a^2"), "refuted");
    assert_ne!(last(r"\sqrt{L_x^2 + L_y^2} = -A a"), "proved");
    assert_eq!(
        last(r"|\vec L| = A\sqrt{a^2 + \frac{C^2}{A^2}\omega_z^2}"),
        "proved"
    );
}

#[test]
fn the_sign_of_a_component_is_not_known() {
    assert_eq!(last(r"\sqrt{\omega_x^2} = \omega_x"), "undecided");
}

#[test]
fn angles_between_a_vector_and_a_lettered_axis_are_those_of_the_cones() {
    let text = format!(
        r"{SPIN} If $\beta$ is the angle from the $z$ axis to $\vec\omega$ then $\tan\beta = \frac{{a}}{{\omega_z}}$. If $\theta$ is the angle between $\vec L$ and the $z$ axis, then

$$ \tan\theta = \frac{{A}}{{C}}\tan\beta $$

$$ \tan\theta = \frac{{C}}{{A}}\tan\beta $$
"
    );
    let found = verdicts(&text);
    assert_eq!(found[4..], ["proved", "proved", "refuted"], "{found:?}");
}

#[test]
fn a_false_line_is_shown_where_lengths_are_no_rational_numbers() {
    let text = r"
The plate has the mass $M$ and the sides $2a$ and $2b$. On principal axes its moments are $I_1 = \tfrac13 Mb^2$, $I_2 = \tfrac13 Ma^2$, $I_3 = \tfrac13 M(a^2 + b^2)$. Let $d = \sqrt{a^2 + b^2}$. It turns with $\omega_1 = \frac{a}{d}\omega$, $\omega_2 = \frac{b}{d}\omega$, $\omega_3 = 0$. Let $a = 2b$. Then

$$ T = \tfrac{4}{15} Mb^2\omega^2 $$

$$ T = \tfrac{2}{15} Mb^2\omega^2 $$
";
    let found = verdicts(text);
    assert_eq!(found[found.len() - 2..], ["proved", "refuted"], "{found:?}");
}

#[test]
fn two_pi_over_a_rate_is_a_period() {
    let text = r"
The wheel has $\omega = 2.0\ \mathrm{rad/s}$. It needs for one turn

$$ T = \frac{2\pi}{\omega} = 3.14\ \mathrm{s} $$
";
    assert_eq!(verdicts(text).last(), Some(&"proved"));
    let text = text.replace("3.14", "3.41");
    assert_eq!(verdicts(&text).last(), Some(&"refuted"));
}

#[test]
fn a_length_in_metres_is_no_multiple_of_the_mass() {
    let text = "A disc has the mass m and the radius R.\n\n    m = 8 kg\n    R = 0.25 m\n\n    m R^2 = 0.5 kg m^2\n    m R^2 = 0.6 kg m^2\n";
    let (document, _) = read("disc.txt", text, Format::Text);
    let findings = check(&document).findings;
    let found: Vec<&str> = findings.iter().map(|f| f.verdict.name()).collect();
    assert_eq!(found[2..], ["proved", "refuted"], "{found:?}");
}

#[test]
fn a_definition_adds_what_is_of_one_dimension() {
    let opening = "A rigid body of mass m swings about a horizontal axle P. The centre of mass G is\nat the distance d from P.\n\n    I_P = I_G + m d²\n\nDefine the radius of gyration by I_G = m k². Then\n\n";
    for (line, verdict) in [
        ("ℓ = d + k² / d", "accepted"),
        ("ℓ = d + k / d", "undecided"),
    ] {
        let text = format!("{opening}    {line}\n");
        let (document, _) = read("pendulum.txt", &text, Format::Text);
        let found = check(&document).findings;
        let found = found.last().map(|f| f.verdict.name());
        assert_eq!(found, Some(verdict), "{line}");
    }
}

#[test]
fn a_root_beside_other_terms_is_put_alone_before_it_is_squared() {
    let text = |one: &str, other: &str| {
        verdicts(&format!(
            r"A thin plate lies in the $xy$ plane. The principal moments in the plane are

$$ I_1 = \frac{{I_x + I_y}}{{2}} + \sqrt{{\left(\frac{{I_x - I_y}}{{2}}\right)^2 + I_{{xy}}^2}} $$

$$ I_2 = \frac{{I_x + I_y}}{{2}} - \sqrt{{\left(\frac{{I_x - I_y}}{{2}}\right)^2 + I_{{xy}}^2}} $$

A square plate of mass $m$ and side $s$ has

$$ I_x = I_y = \frac{{1}}{{3}}ms^2, \qquad I_{{xy}} = \frac{{1}}{{4}}ms^2. $$

The principal moments are

$$ I_1 = {one}ms^2, \qquad I_2 = {other}ms^2 $$
"
        ))
    };
    let found = text(r"\frac{7}{12}", r"\frac{1}{12}");
    assert_eq!(found[4..], ["proved", "proved"]);
    let exchanged = text(r"\frac{1}{12}", r"\frac{7}{12}");
    assert_eq!(exchanged[4..], ["undecided", "undecided"]);
}

#[test]
fn words_call_a_letter_the_length_of_the_momentum() {
    let line = |last: &str| {
        let text = format!(
            "With the principal moments $I_1$, $I_2$, $I_3$ the length $h$ of the angular momentum follows from\n\n$$ {last} $$\n"
        );
        verdicts(&text).pop()
    };
    let square = r"h^2 = I_1^2\omega_1^2 + I_2^2\omega_2^2 + I_3^2\omega_3^2";
    assert_eq!(line(square), Some("proved"));
    assert_eq!(line(&square.replace("I_3^2", "I_3")), Some("refuted"));
}
