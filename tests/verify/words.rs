//! What the words of a document say: the roles of lines, which way an attitude goes, in which order angles turn, and which
//! moment is which.

use polhode::notation::{document::Format, read};
use polhode::verify::{Report, check};

fn checked(text: &str) -> Report {
    check(&read("a document", text, Format::Markdown).0)
}

/// The first letters of the verdicts.
fn verdicts(text: &str) -> String {
    let report = checked(text);
    let findings = report.findings.iter();
    findings.map(|f| &f.verdict.name()[..1]).collect()
}

/// The role of a line about known letters behind a sentence; all but a definition of a component says something of it.
fn role(sentence: &str) -> &'static str {
    role_of_last(&format!("{sentence}\n\n$$ \\omega_x = 2A $$\n"))
}

fn role_of_last(text: &str) -> &'static str {
    let known = "The axes are fixed in the body, and its principal moments are $A$, $B$, $C$.";
    let report = checked(&format!("{known}\n\n{text}"));
    report.findings.last().expect("a line").role.name()
}

#[test]
fn the_sentence_sets_the_role() {
    let cases = [
        (
            "Now choose the principal axes of inertia, that is, assume",
            "assume",
        ),
        ("Let us expand", "claim"),
        ("let us say this is", "claim"),
        ("Let a vector be resolved on the moving axes:", "assume"),
        ("Assume I_xy = 0, then the equation becomes", "claim"),
        ("Define the body precession rate", "define"),
        ("They are defined by", "define"),
        ("The kinetic energy is", "claim"),
        ("The plane is a plane of symmetry, so assume", "assume"),
        ("Choose the time origin such that", "assume"),
        ("With zero torque the equations of motion are", "claim"),
        ("Its derivative is given by", "claim"),
        ("Combinations with two moments left out", "claim"),
        ("For $c = 0$ the second line must fall back to", "claim"),
        ("For $s > 0$ we may also write", "claim"),
        ("Solved for the acceleration,", "claim"),
        ("With $s = 0$ the rate of the spin is", "claim"),
        ("The rule for $s$ is s $a+b$ t $b+c$. u $a+c$", "claim"),
        ("For $s$ the rate is $a+b$. Now assume", "assume"),
        ("For a given $L$ the energy satisfies", "claim"),
        ("At given $L$ the energy obeys", "claim"),
        ("For $L$ the energy obeys", "claim"),
        ("With $s$ suppose the rate satisfies", "assume"),
        ("The rates are given:", "given"),
        ("For given", "given"),
    ];
    let found = cases.map(|(sentence, _)| (sentence, role(sentence)));
    assert_eq!(found, cases);
    // In the sentence itself it is another condition, and apart from it what follows.
    let condition = "If the spin is kept at constant $s$, that is";
    let within = format!("{condition} $\\omega_x = 2A$, it is steady.");
    assert_eq!(role_of_last(&within), "assume");
    assert_eq!(role(condition), "claim");
}

#[test]
fn the_way_of_an_attitude_is_read_from_the_words() {
    let (to_space, to_body) = ("pr", "rp");
    for (sentence, expected) in [
        (
            "Let $R$ be the matrix that takes body components to space components.",
            to_space,
        ),
        (
            "Let $R(q)$ be the matrix that takes space\ncomponents to body components.",
            to_body,
        ),
        (
            "Let $R$ be the rotation matrix from the inertial frame to the body frame.",
            to_body,
        ),
        (
            "The body turns, and $R$ turns body components into space components.",
            to_space,
        ),
        (
            "Let $R$ be the attitude; it takes components along the axes of the body to components in space.",
            to_space,
        ),
        // These two say nothing of components.
        (
            "The matrix $R$ rotates the space axes into the body axes.",
            to_space,
        ),
        (
            "$R$ is the attitude of the body relative to the inertial frame.",
            to_space,
        ),
        ("The columns of $R$ are the axes of the body.", to_space),
        ("The rows of $R$ are the axes of the body.", to_body),
        (
            "The matrix $R$ transforms a vector from world coordinates to body coordinates.",
            to_body,
        ),
    ] {
        let text = format!(
            "{sentence} The angular velocity $\\omega$ has its components on the body axes.\n\nThen\n\n\
             $$ \\dot R = R\\,[\\omega]_\\times $$\n\n$$ \\dot R = -[\\omega]_\\times R $$\n"
        );
        assert_eq!(verdicts(&text), expected, "{sentence}");
    }
}

/// The components of the angular velocity for the turns φ, θ, ψ about z, x, z.
const ABOUT_Z_X_Z: &str =
    "$$ \\omega_x = \\dot\\phi\\sin\\theta\\sin\\psi + \\dot\\theta\\cos\\psi $$
$$ \\omega_y = \\dot\\phi\\sin\\theta\\cos\\psi - \\dot\\theta\\sin\\psi $$
$$ \\omega_z = \\dot\\psi + \\dot\\phi\\cos\\theta $$
";

/// The same for the turns ψ, θ, φ about z, y, x.
const ABOUT_Z_Y_X: &str = "$$ \\omega_x = \\dot\\phi - \\dot\\psi\\sin\\theta $$
$$ \\omega_y = \\dot\\theta\\cos\\phi + \\dot\\psi\\cos\\theta\\sin\\phi $$
$$ \\omega_z = -\\dot\\theta\\sin\\phi + \\dot\\psi\\cos\\theta\\cos\\phi $$
";

#[test]
fn sequences_are_read_as_they_are_written() {
    let (zxz, zyx, none) = ([true, false], [false, true], [false, false]);
    let turned = "We turn by $\\psi$ about the down axis, then by $\\theta$ about the new $y$, then by $\\phi$ about \
                  the new $x$ axis, so";
    let cases = [
        (
            "With the Euler angles $\\phi$, $\\theta$, $\\psi$ in the sequence 3-1-3",
            zxz,
        ),
        (
            "With the $z$-$x'$-$z''$ Euler angles $\\phi$, $\\theta$, $\\psi$",
            zxz,
        ),
        (
            "With the angles $\\psi$, $\\theta$, $\\phi$ in the rotation order ZYX",
            zyx,
        ),
        (
            "With the Euler angles $\\phi$, $\\theta$, $\\psi$ in the x-convention",
            zxz,
        ),
        (
            "On the axes xyz, with the angles of Euler $\\phi$, $\\theta$, $\\psi$,",
            none,
        ),
        (turned, zyx),
        (
            "It turns by $\\psi$ about x and by $\\phi$ about y, so",
            none,
        ),
        (
            "With the angles $\\phi$, $\\theta$, $\\psi$, which in 1-2 days have the order 3-3-1,",
            none,
        ),
    ];
    let found = cases.map(|(sentence, _)| {
        let proves = |lines: &str| {
            let text =
                format!("{sentence} the components of $\\vec\\omega$ on body axes become\n{lines}");
            verdicts(&text) == "ppp"
        };
        (sentence, [proves(ABOUT_Z_X_Z), proves(ABOUT_Z_Y_X)])
    });
    assert_eq!(found, cases);
}

#[test]
fn adjectives_stand_before_and_behind() {
    for (sentence, expected) in [
        (
            "Its transverse moment of inertia is $A$ and its axial moment of inertia is $C$.",
            "ppr",
        ),
        (
            "It has the axial moment $C$ and the transverse moment $A$.",
            "ppr",
        ),
        (
            "$C$ is the polar moment\nof inertia, and $A$ is the transverse moment of inertia.",
            "ppr",
        ),
        (
            "It has the moments $A$ (transverse) and $C$ (axial).",
            "ppr",
        ),
        ("The axial and transverse moments are $C$ and $A$.", "ppr"),
        (
            "The transverse rate is $A$ and the axial rate is $C$.",
            "uuu",
        ),
    ] {
        let text = format!(
            "The axes are fixed in the body, $z$ is its symmetry axis. {sentence}\n\nThen\n\n\
             $$ L_x = A\\omega_x $$\n\n$$ L_z = C\\omega_z $$\n\n$$ L_z = A\\omega_z $$\n"
        );
        assert_eq!(verdicts(&text), expected, "{sentence}");
    }
}
