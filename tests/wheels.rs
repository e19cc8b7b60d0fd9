//! Wheels in a body, told by a list of symbols, by words or by the line that brings them in.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::{verdicts, verdicts_in};
use polhode::notation::{document::Format, read};
use polhode::verify::check;

#[test]
fn a_momentum_beside_that_of_the_body_is_in_the_rotor() {
    let text = |sign: &str| {
        format!(
            "A rotor inside turns at the constant rate $s$ about $x$, and no torque acts. On principal axes\n\n\
             $$ \\mathbf L = (I_x\\omega_x + cs)\\,\\mathbf i + I_y\\omega_y\\,\\mathbf j + I_z\\omega_z\\,\\mathbf k $$\n\n\
             $$ I_y\\dot\\omega_y = (I_z - I_x)\\,\\omega_z\\omega_x {sign} cs\\,\\omega_z $$\n"
        )
    };
    assert_eq!(verdicts(&text("-")), "ap");
    assert_eq!(verdicts(&text("+")), "ar");
}

#[test]
fn a_label_tells_the_momentum_of_a_wheel_from_the_whole() {
    let text = |component: &str, sign: &str| {
        format!(
            "A wheel lies along the pitch axis 2 and stores the constant angular momentum $H_w$ relative to the satellite. \
             The axes are principal. No torque acts.\n\n\
             $$ \\begin{{aligned}} H_1 &= I_1\\omega_1 \\\\ H_2 &= I_2\\omega_2 {component} \\\\ \
             H_3 &= I_3\\omega_3 \\end{{aligned}} $$\n\nHence\n\n\
             $$ I_1\\dot\\omega_1 = (I_2 - I_3)\\omega_2\\omega_3 {sign} H_w\\omega_3 $$\n"
        )
    };
    assert_eq!(verdicts(&text("+ H_w", "+")), "pppp");
    assert_eq!(verdicts(&text("+ H_w", "-")), "pppr");
}

#[test]
fn a_wheel_has_no_momentum_across_its_axis() {
    let text = |letter: &str| {
        format!(
            "The rotor turns about the $z$ axis and has the relative angular momentum ${letter}$. Axes are principal.\n\n\
             $$ L_y = I_y\\omega_y + {letter} $$\n\n$$ L_z = I_z\\omega_z + {letter} $$\n"
        )
    };
    assert_eq!(verdicts(&text("k")), "rp");
    assert!(!verdicts(&text("L_r")).starts_with(['a', 'p']));
}

#[test]
fn a_motor_gives_a_wheel_the_rate_of_its_own_momentum() {
    let text = |torque: &str| {
        format!(
            "The rotor turns relative to the platform about the common axis 3 at the rate $\\sigma$. The moments of inertia \
             are $I_1 = I_2 = I_t$ and $I_3 = I_s$. Its relative angular momentum is defined by $h = J\\sigma$. \
             The total angular momentum is\n\n\
             $$ \\mathbf H = I_t\\omega_1\\,\\mathbf e_1 + I_t\\omega_2\\,\\mathbf e_2 + (I_s\\omega_3 + h)\\,\\mathbf e_3 $$\n\n\
             No external torque acts, so\n\n$$ I_t\\dot\\omega_1 + (I_s - I_t)\\,\\omega_2\\omega_3 + h\\,\\omega_2 = 0 $$\n\n\
             The rotor is driven by the motor torque\n\n$$ g = {torque} $$\n"
        )
    };
    assert_eq!(
        verdicts(&text("J(\\dot\\omega_3 + \\dot\\sigma)")),
        "aaappa"
    );
    assert_eq!(
        verdicts(&text("J(\\dot\\omega_3 - \\dot\\sigma)")),
        "aaappu"
    );
}

#[test]
fn what_is_not_of_wheels_alone_is_no_momentum_of_theirs() {
    let text = "A rotor inside turns at the rate $s$.\n\n\
                $$ \\mathbf L = I_x\\omega_x\\,\\mathbf i + (I_y\\omega_x + cs)\\,\\mathbf j + I_z\\omega_z\\,\\mathbf k $$\n";
    assert_ne!(verdicts(text), "a");
}

#[test]
fn a_table_of_symbols_names_wheel_speeds() {
    let text = r"| symbol | meaning |
|---|---|
| $\omega$ | angular velocity, components $\omega_i$ |
| $J$ | inertia matrix, the three wheels locked |
| $\Omega$ | speeds of the wheels |

$$ \mathbf H = J\omega + c\,\Omega $$

There are no external torques. A dot is the rate on body axes, so

$$ J\dot\omega + c\,\dot\Omega + \omega\times(J\omega + c\,\Omega) = 0 $$

$$ J_1\dot\omega_1 = (J_2 - J_3)\,\omega_2\omega_3 - c\,(\omega_2\Omega_3 - \omega_3\Omega_2) - c\,\dot\Omega_1 $$
";
    assert_eq!(verdicts(text), "app");
}

#[test]
fn a_list_of_symbols_in_plain_text_names_them() {
    let text = "Symbols\n\n  w    angular velocity of the body\n  J    inertia matrix\n  k    momentum stored in the rotors\n  \
                N    external torque\n  T    torque of the motors\n\n    H = J w + k\n\n    dH/dt + w x H = N\n\n    \
                dH/dt = w x H + N\n\n    J dw/dt + dk/dt + w x (J w + k) = N\n";
    let (document, _) = read("a list", text, Format::Text);
    let report = check(&document);
    let found: Vec<&str> = report.findings.iter().map(|f| f.verdict.name()).collect();
    assert_eq!(found, ["proved", "proved", "refuted", "proved"]);
    assert!(report.readings.iter().any(|r| r == "N: moment"));
    assert!(report.readings.iter().all(|r| !r.starts_with("T:")));
}

#[test]
fn numbers_beyond_three_count_rotors() {
    let text = r"With $\Omega_i$ the speed of rotor $i$,

$$ \Omega_r = \Omega_1 + \Omega_2 + \Omega_3 + \Omega_4 $$

They run at constant speed, $\dot\Omega_r = 0$. Then

$$ \dot\Omega_1 + \dot\Omega_2 + \dot\Omega_3 + \dot\Omega_4 = 0 $$
";
    assert_eq!(verdicts(text), "aap");
}

#[test]
fn angles_of_a_list_move_with_it() {
    let text = r"Let $\eta = [\phi \; \theta \; \psi]^T$ and let $\boldsymbol\omega = T\,\dot\eta$.

$$ T = \begin{bmatrix} 1 & 0 & 2 \\ 0 & 3 & 1 \\ 0 & -1 & 1 \end{bmatrix} $$

$$ \omega_x = 17\,\omega_y $$

$$ \omega_x = \dot\phi + 2\dot\psi $$
";
    let found = verdicts(text);
    assert!(!found[3..4].contains('p'), "{found}");
}

#[test]
fn the_momentum_of_a_wheel_may_be_a_number_along_an_axis() {
    let text = r"A satellite with the principal inertias $J_1$, $J_2$, $J_3$ has a wheel along the second body axis, with the constant spin momentum $h$. No torque acts.

$$ J_1\dot\omega_1 = (J_2 - J_3)\,\omega_2\omega_3 + h\,\omega_3 $$

$$ J_2\dot\omega_2 = (J_3 - J_1)\,\omega_3\omega_1 $$

$$ J_3\dot\omega_3 = (J_1 - J_2)\,\omega_1\omega_2 + h\,\omega_1 $$
";
    assert_eq!(verdicts(text), "ppr");
}

/// A platform and a rotor on one axis.
const DUAL_SPIN: &str = r"Platform and rotor share the axis $\mathbf{e}_3$. Together they have the moments of inertia $A, A, C$; the rotor alone has the axial moment of inertia $J_w$ and spins with the rate $\nu$ relative to the platform. Let $h = J_w\nu$. The angular momentum is

$$ \mathbf{L} = A\omega_1\mathbf{e}_1 + A\omega_2\mathbf{e}_2 + (C\omega_3 + h)\,\mathbf{e}_3 $$

";

#[test]
fn the_kinetic_energy_of_body_and_wheel_has_both() {
    let with = |part: &str| {
        let line = format!(
            "$$ T = \\frac12 A(\\omega_1^2 + \\omega_2^2) + \\frac12 C\\omega_3^2 {part} $$\n"
        );
        verdicts(&format!("{DUAL_SPIN}The kinetic energy is\n\n{line}"))
    };
    assert_eq!(with(r"+ J_w\nu\omega_3 + \frac12 J_w\nu^2"), "aap");
    assert_ne!(with(r"+ \frac12 J_w\nu^2"), "aap");
    assert_ne!(with(r"+ J_w\nu\omega_3 + J_w\nu^2"), "aap");
}

#[test]
fn products_of_rates_that_are_dropped_are_of_second_order() {
    let text = r"No external torque acts. The motor is off, and $\dot h = 0$ may be assumed. All rates are small, and products of two rates are dropped. Then

$$ A\dot\omega_1 = -h\,\omega_2 $$

$$ A\dot\omega_2 = -h\,\omega_1 $$
";
    let found = verdicts(&format!("{DUAL_SPIN}{text}"));
    assert_eq!(&found[2..], "apr");
}

#[test]
fn torques_may_be_told_apart_by_the_angles() {
    let text = r"A rigid body on principal axes with the rates $p, q, r$ and the torques $\tau_\phi, \tau_\theta, \tau_\psi$ obeys

$$ I_x\dot p = (I_y - I_z)\,qr + \tau_\phi $$

$$ I_y\dot q = (I_x - I_z)\,pr + \tau_\theta $$

$$ I_z\dot r = (I_x - I_y)\,pq + \tau_\psi $$
";
    assert_eq!(verdicts(text), "prp");
}

#[test]
fn a_rotor_alone_takes_the_moment_that_turns_its_momentum() {
    let with = |sign: &str| {
        let text = r"A turbine in a car has the polar moment of inertia $J$ and the constant spin rate $\nu$. Its spin angular momentum is

$$ \mathbf{h} = J\nu\,\mathbf{i} $$

The car turns with $\boldsymbol\Omega = \dot\psi\,\mathbf{k}$, and the bearings deliver

$$ \mathbf{M} = \boldsymbol\Omega\times\mathbf{h} = SIGN J\nu\dot\psi\,\mathbf{j} $$
";
        verdicts(&text.replace("SIGN", sign)).pop()
    };
    assert_eq!(with(""), Some('p'));
    assert_ne!(with("-"), Some('p'));
    assert_ne!(with("-"), Some('a'));
}

#[test]
fn a_rate_of_the_wheels_in_a_sum_is_seen_from_their_carrier() {
    let text = |gyro: &str| {
        format!(
            "A satellite carries wheels; $\\mathbf h$ is the angular momentum of the wheels relative to it. The torque is\n\n\
             $$ \\mathbf M = \\mathbf I\\dot{{\\boldsymbol\\omega}} + \\dot{{\\mathbf h}} + \\boldsymbol\\omega\\times({gyro}) $$\n"
        )
    };
    let both = r"\mathbf I\boldsymbol\omega + \mathbf h";
    assert_eq!(verdicts(&text(both)), "p");
    assert_eq!(verdicts(&text(r"\mathbf I\boldsymbol\omega")), "r");
}

#[test]
fn wheels_have_the_momentum_and_an_engine_adds_it() {
    let text = |term: &str| {
        format!(
            "All vectors are on axes fixed in the satellite. $J$ is its inertia matrix with the wheels locked, \
             $\\mathbf h$ is the angular momentum that the wheels have relative to the satellite.\n\n\
             $$ \\mathbf H = J\\boldsymbol\\omega + \\mathbf h $$\n\nAssume $\\mathbf M = \\mathbf 0$.\n\n\
             $$ J\\dot{{\\boldsymbol\\omega}} + \\dot{{\\mathbf h}} + \\boldsymbol\\omega\\times({term}) = \\mathbf 0 $$\n"
        )
    };
    assert_eq!(verdicts(&text("J\\boldsymbol\\omega + \\mathbf h")), "pap");
    // A dot beside ω × is a rate on the axes, so that what is lost is not in it.
    assert_ne!(verdicts(&text("J\\boldsymbol\\omega")), "pap");
    let text = |sign: &str| {
        format!(
            "$A$, $B$, $C$ are the moments of inertia about $x$, $y$, $z$, and the only product of inertia is $E = \\int xz\\,dm$. \
             The components of the angular velocity are $p$, $q$, $r$, the moments are $L$, $M$, $N$. \
             The rotor of the engine adds an angular momentum $h$ about the $x$ axis.\n\n\
             $$ H_x = Ap - Er + h $$\n$$ H_z = Cr - Ep $$\n$$ N = C\\dot r - E\\dot p + (B - A)\\,pq + E\\,qr {sign} h\\,q $$\n"
        )
    };
    assert_eq!(verdicts(&text("-")), "appp");
    assert_eq!(verdicts(&text("+")), "appr");
}

#[test]
fn a_motor_changes_the_momentum_of_its_wheel_until_the_speed_is_supposed_constant() {
    let text = |motor: &str, second: &str| {
        format!(
            r"Let $h_w = J_w\,\Omega_w$, where $\Omega_w$ is the speed of the wheel relative to the body, along the principal axis 2. {motor}

$$ \mathbf h = \begin{{bmatrix}} I_1\omega_1 \\ I_2\omega_2 + h_w \\ I_3\omega_3 \end{{bmatrix}} $$

The second component is

$$ T_2 = I_2\dot\omega_2 + (I_1 - I_3)\,\omega_3\omega_1 {second} $$

Assume $\mathbf T = \mathbf 0$, a constant wheel speed, and $\omega_2 = 0$. Then

$$ I_1\dot\omega_1 = h_w\,\omega_3 $$
"
        )
    };
    assert_eq!(verdicts(&text("", "")), "aapaap");
    let motor = "The motor can change this speed.";
    assert_eq!(verdicts(&text(motor, r"+ \dot h_w")), "aapaap");
    assert_eq!(verdicts(&text(motor, "")), "aaraap");
    let governor = "The motor keeps it constant, no load changes it.";
    assert_eq!(verdicts(&text(governor, "")), "aapaap");
}

#[test]
fn a_component_of_the_stored_momentum_that_is_written_elsewhere_is_missed_where_it_is_not() {
    let text = |second: &str| {
        format!(
            r"The wheels have the momentum $\mathbf h$ relative to the body, whose total momentum on principal axes is

$$ \mathbf H = \mathbf J\boldsymbol\omega + \mathbf h $$

With the wheel momenta $h_1$, $h_2$, $h_3$ along the axes the components of $\mathbf H$ are

$$ H_1 = J_1\omega_1 + h_1, \quad H_2 = J_2\omega_2 {second}, \quad H_3 = J_3\omega_3 + h_3 $$
"
        )
    };
    assert_eq!(verdicts(&text("+ h_2")), "pppp");
    assert_eq!(verdicts(&text("")), "pprp");
}

#[test]
fn a_constant_momentum_of_the_rotor_may_be_said_in_a_formula() {
    let text = r"The components of the angular velocity are $p$, $q$, $r$. The rotor of the engine adds an angular momentum $h$ about the $x$ axis. It runs at constant speed, so $\dot{h} = 0$.

$$ H_x = I_x p + h, \qquad H_y = I_y q $$
";
    assert_eq!(verdicts(text), "app");
}

#[test]
fn a_number_in_a_component_is_the_momentum_of_the_rotor_along_its_axis() {
    let text = |rotor: &str, h: &str, sign: &str| {
        format!(
            r"The aircraft has the plane of symmetry $xz$. {rotor} The body rates are $p$, $q$, $r$ and the external moments $L$, $M$, $N$. The angular momentum is

$$ H_x = I_x p - I_{{xz}} r + {h}, \qquad H_y = I_y q $$

$$ M = I_y\dot q + (I_x - I_z)\,rp + I_{{xz}}(p^2 - r^2) {sign} {h}\,r $$
"
        )
    };
    let carries = "The engine rotor turns about an axis parallel to $x$ and carries the constant angular momentum $h_E$ relative to the airframe.";
    assert_eq!(verdicts(&text(carries, "h_E", "+")), "ppp");
    assert_eq!(verdicts(&text(carries, "h_E", "-")), "ppr");
    let has = "The rotor turns about an axis parallel to $x$. Relative to the airframe it has the constant angular momentum $h$.";
    assert_eq!(verdicts(&text(has, "h", "+")), "ppp");
    assert_eq!(verdicts(&text(has, "h", "-")), "ppr");
}

#[test]
fn the_rate_of_the_wheels_momentum_is_no_torque_from_outside() {
    let text = r"A satellite has the inertia matrix $\mathbf J$ with the wheels locked. The total momentum on body axes is

$$ \mathbf K = \mathbf J\boldsymbol\omega + \mathbf h $$

where $\mathbf h$ is the momentum of the wheels relative to the satellite. No external torque acts.

$$ \dot{\mathbf K} + \boldsymbol\omega\times\mathbf K = 0 $$

The wheels exert the control torque $\boldsymbol\tau = -\dot{\mathbf h}$, so that

$$ \mathbf J\dot{\boldsymbol\omega} = \boldsymbol\tau - \boldsymbol\omega\times(\mathbf J\boldsymbol\omega + \mathbf h) $$

$$ \mathbf J\dot{\boldsymbol\omega} = -\boldsymbol\tau - \boldsymbol\omega\times(\mathbf J\boldsymbol\omega + \mathbf h) $$

$$ \boldsymbol\omega\cdot\mathbf J\dot{\boldsymbol\omega} = \boldsymbol\omega\cdot\boldsymbol\tau $$
";
    assert_eq!(verdicts(text), "ppaprp");
}

/// A log in plain text, in which words name the letters.
fn log(days: &str) -> String {
    let text = format!(
        "w is the angular velocity of the satellite on body axes, I its inertia matrix and\n\
         h the momentum of the wheels. M is the external torque.\n\n    H = I*w + h\n    Hdot + cross(w, H) = M\n\n{days}\n"
    );
    verdicts_in(&text, Format::Text)
}

#[test]
fn words_of_plain_text_name_the_momentum_of_wheels_and_lock_them() {
    let locked = |difference: &str| {
        log(&format!(
            "Wheels locked, h = 0. On principal axes\n\n    I1*w1dot = {difference}*w2*w3 + M1\n"
        ))
    };
    assert_eq!(locked("(I2 - I3)"), "ppap");
    assert_eq!(locked("(I3 - I2)"), "ppar");
}

#[test]
fn a_torque_is_supposed_axis_by_axis() {
    let damped = |rate: &str| {
        log(&format!(
            "Wheels off, h = 0. Thrusters damp the rates, with a gain k:\n\n    \
             M1 = -k*w1, M2 = -k*w2, M3 = -k*w3\n\nThe energy changes by\n\n    \
             I1*w1*w1dot + I2*w2*w2dot + I3*w3*w3dot = {rate}\n"
        ))
    };
    assert_eq!(damped("-k*(w1^2 + w2^2 + w3^2)"), "ppaaaap");
    assert_eq!(damped("-k*(w1^2 + w2^2 - w3^2)"), "ppaaaar");
}

#[test]
fn a_feedback_ends_where_the_motors_rest() {
    let text = |last: &str| {
        format!(
            "The hull has the constant inertia matrix $J$, and $\\bm h$ is the momentum of the wheels in it. \
             On hull axes $\\bm H = J\\bm\\omega + \\bm h$, and with the external torque $\\bm\\tau$\n\n\
             $$ \\dot{{\\bm H}} + \\bm\\omega\\times\\bm H = \\bm\\tau $$\n\n\
             The torque of the motors is defined as the negative rate of the wheel momentum,\n\n\
             $$ \\bm u = -\\dot{{\\bm h}} $$\n\nFrom here on $\\bm\\tau = \\bm 0$. With the feedback $\\bm u = -D\\bm\\omega$ this gives\n\n\
             $$ J\\dot{{\\bm\\omega}} = -D\\bm\\omega - \\bm\\omega\\times(J\\bm\\omega + \\bm h) $$\n\n\
             **Bias.** Now let the motors hold the speed, $\\bm u = \\bm 0$, and let one wheel turn about the negative $y$ \
             axis, $\\bm h = (0,\\ -h_0,\\ 0)^\\top$. The matrix $J$ is diagonal with the entries $J_x, J_y, J_z$. \
             To first order in the rates, the roll and yaw equations are\n\n$$ {last} $$\n"
        )
    };
    assert_eq!(
        verdicts(&text("J_x\\dot\\omega_x = -h_0\\,\\omega_z")),
        "ppaaapaap"
    );
    assert_eq!(
        verdicts(&text("J_x\\dot\\omega_x = h_0\\,\\omega_z")),
        "ppaaapaar"
    );
}

#[test]
fn the_moment_of_a_rotor_is_its_own() {
    let text = |sign: &str| {
        format!(
            "A satellite of inertia $J$ carries a rotor spinning at the constant rate $\\Omega_s$ about its axis $\\hat{{\\mathbf a}}$, \
             fixed in the satellite; the rotor's moment about this axis is $C$. The momentum of the whole is\n\n\
             $$ \\mathbf H = J\\boldsymbol\\omega + C\\Omega_s\\hat{{\\mathbf a}} $$\n\n\
             $$ \\boldsymbol\\tau = J\\dot{{\\boldsymbol\\omega}} + \\boldsymbol\\omega\\times J\\boldsymbol\\omega \
             {sign} C\\Omega_s\\,\\boldsymbol\\omega\\times\\hat{{\\mathbf a}} $$\n"
        )
    };
    assert_eq!(verdicts(&text("+")), "ap");
    assert_eq!(verdicts(&text("-")), "ar");
}

#[test]
fn what_drives_wheels_of_which_nothing_is_said_may_be_named() {
    let text = |sign: &str| {
        format!(
            "Let $\\mathbf h$ be the momentum of the reaction wheels relative to the satellite, whose inertia is $\\mathbf J$. \
             With the external torque $\\mathbf T$ and the motor torque $\\mathbf u = \\dot{{\\mathbf h}}$ on the wheels\n\n\
             $$ \\mathbf J\\dot{{\\boldsymbol\\omega}} = \\mathbf T {sign} \\mathbf u - \
             \\boldsymbol\\omega\\times(\\mathbf J\\boldsymbol\\omega + \\mathbf h) $$\n"
        )
    };
    assert_eq!(verdicts(&text("-")), "ap");
    assert_eq!(verdicts(&text("+")), "ar");
}
