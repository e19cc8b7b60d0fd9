//! A particle seen from two frames, and two points of one rigid body.

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

/// Velocities and accelerations in the space frame and in the turning one, under some labels.
fn seen_from(space: &str, turning: &str, coriolis: &str) -> String {
    verdicts(&format!(
        r"The position of a particle is $\mathbf r$, ${space}$ is the space frame and ${turning}$ the rotating frame.
$$\left(\frac{{d\mathbf r}}{{dt}}\right)_{{{space}}} = \left(\frac{{d\mathbf r}}{{dt}}\right)_{{{turning}}} + \boldsymbol\Omega\times\mathbf r$$
$$\mathbf v_{{{space}}} = \mathbf v_{{{turning}}} + \boldsymbol\Omega\times\mathbf r$$
$$\mathbf a_{{{space}}} = \mathbf a_{{{turning}}} + \dot{{\boldsymbol\Omega}}\times\mathbf r + {coriolis}\boldsymbol\Omega\times\mathbf v_{{{turning}}} + \boldsymbol\Omega\times(\boldsymbol\Omega\times\mathbf r)$$
"
    ))
}

#[test]
fn labels_of_frames_say_who_sees_a_velocity() {
    for (space, turning) in [("S", "R"), ("space", "rot"), ("in", "rel"), ("N", "B")] {
        assert_eq!(seen_from(space, turning, "2"), "ppp", "{space}, {turning}");
        assert_eq!(seen_from(space, turning, ""), "ppr", "{space}, {turning}");
    }
}

#[test]
fn newtons_law_in_a_turning_frame_has_the_inertial_forces() {
    let text = |sign: &str| {
        format!(
            r"In the inertial frame $m\mathbf a_i = \mathbf F$. Let $\mathbf v_r$ and $\mathbf a_r$ be the velocity and the acceleration of the particle seen from a frame that turns with $\boldsymbol\omega$, and $\mathbf r$ its position from the common origin. Then
$$\mathbf v_i = \mathbf v_r + \boldsymbol\omega\times\mathbf r$$
$$\mathbf a_i = \mathbf a_r + 2\boldsymbol\omega\times\mathbf v_r + \dot{{\boldsymbol\omega}}\times\mathbf r + \boldsymbol\omega\times(\boldsymbol\omega\times\mathbf r)$$
For constant $\boldsymbol\omega$,
$$m\mathbf a_r = \mathbf F {sign} 2m\boldsymbol\omega\times\mathbf v_r - m\boldsymbol\omega\times(\boldsymbol\omega\times\mathbf r)$$
"
        )
    };
    assert_eq!(verdicts(&text("-")), "pppp");
    assert_eq!(verdicts(&text("+")), "pppr");
}

#[test]
fn points_of_a_rigid_body_share_its_turn() {
    let text = |sign: &str, case: &str, end: &str| {
        format!(
            r"The points A and B belong to a rigid body with the angular velocity $\boldsymbol\omega$ and the angular acceleration $\boldsymbol\alpha$, and $\mathbf r_{{AB}}$ is the vector from A to B.
$$\mathbf v_B = \mathbf v_A {sign} \boldsymbol\omega\times\mathbf r_{{AB}}$$
$$\mathbf a_B = \mathbf a_A + \boldsymbol\alpha\times\mathbf r_{{AB}} + \boldsymbol\omega\times(\boldsymbol\omega\times\mathbf r_{{AB}})$$
{case}
$$\mathbf a_B = \boldsymbol\alpha\times\mathbf r_{{AB}} {end} \boldsymbol\omega\times(\boldsymbol\omega\times\mathbf r_{{AB}})$$
"
        )
    };
    assert_eq!(verdicts(&text("+", "If A is fixed,", "+")), "ppp");
    assert_eq!(verdicts(&text("+", "If A is fixed,", "-")), "ppr");
    assert_eq!(verdicts(&text("-", "If A is fixed,", "+")), "rpp");
    assert_eq!(verdicts(&text("+", "In general", "+")), "ppr");
}

#[test]
fn unit_vectors_along_and_around_turn_with_their_angle() {
    let text = |around: &str, coriolis: &str| {
        verdicts(&format!(
            r"A bead slides on a rotating hoop. In cylindrical coordinates the position is

$$ \vec r = \rho\,\hat\rho + z\,\hat z $$

The unit vectors change as

$$ \dot{{\hat\rho}} = \dot\phi\,\hat\phi, \qquad \dot{{\hat\phi}} = {around}\dot\phi\,\hat\rho $$

and the acceleration is

$$ \vec a = (\ddot\rho - \rho\dot\phi^2)\hat\rho + (\rho\ddot\phi + {coriolis}\dot\rho\dot\phi)\hat\phi + \ddot z\,\hat z $$
"
        ))
    };
    assert_eq!(text("-", "2"), "appp");
    assert_eq!(text("", "2"), "aprp");
    assert_eq!(text("-", ""), "appr");
}

#[test]
fn a_prime_or_a_label_is_what_a_turning_frame_sees() {
    let text = |words: &str, line: &str| {
        verdicts(&format!(
            "For an observer in a frame that rotates at the constant angular velocity $\\boldsymbol\\Omega$, a particle at \
             $\\mathbf r$ has {words}.\n\n$$ {line} $$\n"
        ))
    };
    let primed = "the velocity $\\mathbf v'$ and the acceleration $\\mathbf a'$; in the laboratory they are $\\mathbf v$ and $\\mathbf a$";
    let coriolis = |times: &str| {
        format!(
            "\\mathbf a = \\mathbf a' + {times}\\boldsymbol\\Omega\\times\\mathbf v' + \\boldsymbol\\Omega\\times(\\boldsymbol\\Omega\\times\\mathbf r)"
        )
    };
    assert_eq!(text(primed, &coriolis("2")), "p");
    assert_eq!(text(primed, &coriolis("")), "r");
    assert_eq!(
        text(
            primed,
            "\\mathbf v = \\mathbf v' + \\boldsymbol\\Omega\\times\\mathbf r"
        ),
        "p"
    );
    let labelled = "the velocity $\\mathbf v_{rel}$ and the acceleration $\\mathbf a_{rel}$. With its mass $m$ and the force $\\mathbf F$";
    let force = |sign: &str| {
        format!(
            "m\\mathbf a_{{rel}} = \\mathbf F {sign} 2m\\boldsymbol\\Omega\\times\\mathbf v_{{rel}} - m\\boldsymbol\\Omega\\times(\\boldsymbol\\Omega\\times\\mathbf r)"
        )
    };
    assert_eq!(text(labelled, &force("-")), "p");
    assert_eq!(text(labelled, &force("+")), "r");
}
