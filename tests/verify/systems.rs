//! Systems that sentences declare: the equations of each come out of the laws, and slips in them are denied.

mod angles;
mod arms_and_plates;
mod at_one_time;
mod at_zero;
mod balance;
mod between_instants;
mod blows;
mod by_vectors;
mod called_by_kind;
mod chains;
mod changes;
mod counted;
mod defaults_give_way;
mod everyday_motion;
mod families_and_types;
mod family_loads;
mod frames_that_move;
mod free_wording;
mod half_read;
mod hung_rods;
mod idle_words;
mod impacts;
mod in_other_orders;
mod incline;
mod instants;
mod integrals;
mod joint_loads;
mod labels_and_moments;
mod letters;
mod lists_and_asides;
mod loads;

mod loads_in_words;
mod long_laws;
mod matrices;
mod members;
mod named_loads;
mod not_taken_in;
mod one_of_several;
mod own_words;
mod own_writing;
mod parts;
mod parts_at_rest;
mod parts_by_plural;
mod placed_by_angles;
mod plane_motion;
mod planes;
mod planes_and_rates;
mod products_of_inertia;
mod quaternions;
mod raised_frames;
mod rates_and_frames;
mod reading;
mod remarks_and_signs;
mod rods;
mod rolling;
mod round_surfaces;
mod rules_of_writing;
mod said_in_passing;
mod scenes;
mod sentence_forms;
mod shapes_and_wholes;
mod shapes_left_open;
mod signs_and_orders;
mod simply_said;
mod single_edits;
mod slopes;
mod small_oscillations;
mod sound;
mod springs;
mod start;
mod steps;
mod taken_in_whole;
mod tensors;
mod textbook;
mod things_by_letters;
mod told_by_equations;
mod told_by_lines;
mod told_places;
mod told_vectors;
mod virtual_power;
mod ways_to_write;
mod what_is_not_heard;
mod whose;
mod word_for_word;

use polhode::notation::sentences;
use polhode::notation::{document::Format, read};
use polhode::source::Source;
use polhode::verify::{Misunderstood, Sheet, check_declared, declarations};

/// The verdicts of the lines, a letter each. All sentences have to be understood.
fn judged(said: &str, text: &str) -> String {
    let (verdicts, misread) = verdicts(said, text);
    assert!(misread.is_empty(), "{misread:?}");
    verdicts
}

/// Asserts the verdicts of the lines, whichever of the sentences stands first.
fn judged_in_any_order(sentences: &[&str], text: &str, verdicts: &str) {
    for turn in 0..sentences.len() {
        let mut said = sentences.to_vec();
        said.rotate_left(turn);
        assert_eq!(judged(&said.join("\n"), text), verdicts, "{said:?}");
    }
}

/// The verdicts of the lines, a letter each, and the sentences that are not understood.
pub(crate) fn verdicts(said: &str, text: &str) -> (String, Vec<Misunderstood>) {
    let (document, _) = read("a document", text, Format::Markdown);
    let sheet = Sheet {
        sentences: sentences(said),
        source: Source::new("what is declared", said),
    };
    let declared = declarations(&document, &[sheet]);
    let report = check_declared(&document, &declared);
    let letter = |name: &str| name.chars().next().unwrap_or('?');
    let findings = report.findings.iter();
    let verdicts = findings.map(|f| letter(f.verdict.name())).collect();
    (verdicts, declared.misunderstood)
}

const BODY: &str = "N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
$\\vec\\omega$ is the angular velocity of B relative to N.
$\\mathbf J$ is the inertia tensor of the body about G.
$\\vec L$ is the angular momentum of the body about G relative to N.
$\\vec M$ is the total moment on the body about G.
";

#[test]
fn a_free_body_with_its_full_tensor() {
    let text = r"
$$ \vec L = \mathbf J\vec\omega $$
$$ \vec M = \dot{\vec L} $$
$$ \vec M = \mathbf J\dot{\vec\omega} + \vec\omega\times\mathbf J\vec\omega $$
$$ \vec M = \mathbf J\dot{\vec\omega} - \vec\omega\times\mathbf J\vec\omega $$
";
    assert_eq!(judged(BODY, text), "pppr");
}

#[test]
fn a_false_line_is_put_right_by_one_change() {
    let text = r"
$$ \vec M = \mathbf J\dot{\vec\omega} - \vec\omega\times\mathbf J\vec\omega $$
$$ \vec M = \mathbf J\vec\omega + \vec\omega\times\mathbf J\vec\omega $$
";
    let (document, _) = read("a document", text, Format::Markdown);
    let sheet = Sheet {
        sentences: sentences(BODY),
        source: Source::new("what is declared", BODY),
    };
    let report = check_declared(&document, &declarations(&document, &[sheet]));
    let diagnoses = report.findings.iter().map(|f| f.diagnosis.as_ref());
    let kinds: Vec<Option<&str>> = diagnoses.map(|d| d.map(|d| d.kind)).collect();
    assert_eq!(kinds, [Some("sign"), Some("missing-dot")]);
}

#[test]
fn components_on_principal_axes() {
    let sentences = format!(
        "{BODY}$p$, $q$, $r$ are the components of $\\vec\\omega$ on B.
$A$, $B$, $C$ are the principal moments of the body about G on B.
No moment acts on the body about G.
"
    );
    let text = r"
$$ A\dot p = (B - C)qr $$
$$ B\dot q = (A - C)pr $$
$$ \frac{d}{dt}\left(Ap^2 + Bq^2 + Cr^2\right) = 0 $$
$$ C\dot r = (A - B)pq $$
";
    assert_eq!(judged(&sentences, text), "prpp");
}

#[test]
fn a_rate_seen_from_two_frames() {
    let sentences = "N is an inertial frame.
A is a frame that turns relative to N.
$\\vec\\Omega$ is the angular velocity of A relative to N.
$\\vec u$ is any vector.
$\\frac{d}{dt}$ is the rate seen from N.
A prime means the rate seen from A.
";
    let text = r"
$$ \frac{d\vec u}{dt} = \vec u' + \vec\Omega\times\vec u $$
$$ \frac{d\vec u}{dt} = \vec u' - \vec\Omega\times\vec u $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_rotation_matrix_joins_arrays_on_two_frames() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
$C$ takes components on B to components on N.
$w$ is the angular velocity of B relative to N in components on B.
$[w]_\\times$ is the cross-product matrix of $w$.
";
    let text = r"
$$ \dot C = C\,[w]_\times $$
$$ \dot C = [w]_\times C $$
$$ C^T C = 1_{3\times 3} $$
";
    assert_eq!(judged(sentences, text), "prp");
}

#[test]
fn sums_over_the_particles_of_a_body() {
    let sentences = "N is an inertial frame.
O is a point fixed in N and in B.
B is a frame fixed in the body.
The body consists of particles.
$k$ numbers the particles.
$\\mu_k$ is the mass of particle $k$.
$\\vec s_k$ is the position of particle $k$ from O.
$\\vec\\omega$ is the angular velocity of B relative to N.
$\\vec H$ is the angular momentum of the body about O relative to N.
";
    let text = r"
$$ \vec H = \sum_k \mu_k\,\vec s_k\times(\vec\omega\times\vec s_k) $$
$$ \vec H = \sum_k \mu_k\left((\vec s_k\cdot\vec s_k)\,\vec\omega - (\vec s_k\cdot\vec\omega)\,\vec s_k\right) $$
$$ \vec H = \sum_k \mu_k\left((\vec s_k\cdot\vec s_k)\,\vec\omega + (\vec s_k\cdot\vec\omega)\,\vec s_k\right) $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn a_heavy_top_by_its_angles() {
    let sentences = "N is an inertial frame.
$Z$ is the upward vertical.
The top is a rigid body of mass $m$.
B is a frame fixed in the top.
x, y, z are the axes of B.
O is a point fixed in N and in B.
G is the mass centre of the top.
G lies at the distance $h$ from O along z.
$A$, $A$, $C$ are the principal moments of the top about O on B.
$\\alpha$, $\\beta$, $\\gamma$ are the Euler angles of B relative to N in the order Z, x, z.
$g$ is the acceleration of gravity.
$T$ is the kinetic energy of the top relative to N.
$V$ is the potential energy of the top.
The potential energy is zero at O.
";
    let text = r"
$$ T = \tfrac12 A(\dot\beta^2 + \dot\alpha^2\sin^2\beta) + \tfrac12 C(\dot\gamma + \dot\alpha\cos\beta)^2 $$
$$ T = \tfrac12 A(\dot\beta^2 + \dot\alpha^2\cos^2\beta) + \tfrac12 C(\dot\gamma + \dot\alpha\cos\beta)^2 $$
$$ V = m g h\cos\beta $$
$$ V = -m g h\cos\beta $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn wheels_in_a_spacecraft() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the bus.
The craft consists of the bus and the wheels.
$n$ numbers the wheels.
Wheel $n$ turns relative to B about $\\hat a_n$ at the rate $\\Omega_n$.
C is the mass centre of the craft.
$j_n$ is the moment of inertia of wheel $n$ about $\\hat a_n$.
$\\vec\\omega$ is the angular velocity of B relative to N.
$\\mathbf J$ is the inertia tensor of the craft about C.
$\\vec H$ is the angular momentum of the craft about C relative to N.
$\\vec M$ is the total moment on the craft about C.
";
    let text = r"
$$ \vec H = \mathbf J\vec\omega + \sum_n j_n\Omega_n\hat a_n $$
$$ \vec M = \mathbf J\dot{\vec\omega} + \sum_n j_n\dot\Omega_n\hat a_n + \vec\omega\times\vec H $$
$$ \vec M = \mathbf J\dot{\vec\omega} + \sum_n j_n\dot\Omega_n\hat a_n + \vec\omega\times\mathbf J\vec\omega $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn nothing_is_denied_while_a_sentence_is_not_taken_in() {
    let sentences = format!("{BODY}The body wobbles relative to N.\n");
    let text = r"$$ \vec L = 0 $$";
    assert_eq!(verdicts(&sentences, text).0, "u");
    assert_eq!(judged(BODY, text), "r");
}

#[test]
fn to_first_order_in_what_is_small() {
    let sentences = "N is an inertial frame.
A is a frame that turns relative to N about z by the angle $\\varphi$.
Line 2 holds to first order in $\\varphi$.
Line 3 holds to first order in $\\varphi$.
";
    let text = r"
$$ \sin\varphi\cos\varphi = \varphi $$
$$ \sin\varphi\cos\varphi = 2\varphi $$
$$ \sin^2\varphi + \cos^2\varphi = 1 $$
";
    assert_eq!(judged(sentences, text), "prp");
}

#[test]
fn rotations_in_any_number_of_dimensions() {
    let sentences = |dimensions: &str| {
        format!(
            "Space has {dimensions} dimensions.
N is an inertial frame.
B is a frame fixed in the body.
$Q$ takes components on B to components on N.
A tilde means components on B.
A vector or tensor without a tilde has components on N.
O is a point fixed in N and in B.
P is a point fixed in B.
$s$ is the position of P from O.
$u$ is the velocity of P relative to N.
$b$ is any vector.
$\\mathbb{{1}}$ is the identity matrix.
$\\partial_t$ is the rate, entry by entry.
"
        )
    };
    let text = r"
$$ W := \dot Q Q^T $$

$$ Q Q^T = Q^T Q = \mathbb{1} $$
$$ u = W s $$
$$ u = -W s $$
$$ W^T = -W $$
$$ W^T = W $$
$$ \ddot s = (\dot W + W W) s $$
$$ \ddot s = (\dot W - W W) s $$
$$ \partial_t(Q\tilde b) = Q(\tilde W\tilde b + \dot{\tilde b}) $$
$$ \partial_t(Q\tilde b) = Q(\dot{\tilde b} - \tilde W\tilde b) $$
$$ s^T u = 0 $$
";
    for dimensions in ["two", "three", "4", "5"] {
        assert_eq!(
            judged(&sentences(dimensions), text),
            "apprprprprp",
            "{dimensions}"
        );
    }
}

#[test]
fn what_is_settled_in_one_space_is_settled_anew_in_another() {
    let sentences = "Space has four dimensions.
On line 6, space has three dimensions.
N is an inertial frame.
B is a frame fixed in the body.
$Q$ takes components on B to components on N.
$\\vec w$ is the angular velocity of B relative to N in components on N.
$[\\vec w]_\\times$ is the cross-product matrix of $\\vec w$.
";
    let text = r"
$$ W := \dot Q Q^T $$

In space of three dimensions alone

$$ W = [\vec w]_\times $$

$$ W^T = -W $$
";
    assert_eq!(judged(sentences, text), "app");
}

#[test]
fn types_tell_which_of_two_meanings_a_letter_has() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
$\\alpha$, $\\beta$, $\\gamma$ are the Euler angles of B relative to N in the order z, y, x.
$\\beta$ is also the column of $\\alpha$, $\\beta$ and $\\gamma$.
$w$ is the angular velocity of B relative to N in components on B.
";
    let text = r"
$$ \beta = (\alpha, \beta, \gamma)^T $$
$$ \dot\beta = (\dot\alpha, \dot\beta, \dot\gamma)^T $$
$$ w = \begin{bmatrix} -\sin\beta & 0 & 1 \\ \cos\beta\sin\gamma & \cos\gamma & 0 \\ \cos\beta\cos\gamma & -\sin\gamma & 0 \end{bmatrix} \dot\beta $$
$$ w = \begin{bmatrix} \sin\beta & 0 & 1 \\ \cos\beta\sin\gamma & \cos\gamma & 0 \\ \cos\beta\cos\gamma & -\sin\gamma & 0 \end{bmatrix} \dot\beta $$
";
    assert_eq!(judged(sentences, text), "pppr");
}

#[test]
fn letters_with_numbers_are_read_in_cyclic_order() {
    let sentences = format!(
        "{BODY}$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components of $\\vec\\omega$ on B.
$A_1$, $A_2$, $A_3$ are the principal moments of the body about G on B.
No moment acts on the body about G.
"
    );
    let text = r"
$$ A_i\dot\omega_i = (A_j - A_k)\,\omega_j\omega_k $$
$$ A_i\dot\omega_i = (A_k - A_j)\,\omega_j\omega_k $$
";
    assert_eq!(judged(&sentences, text), "pr");
}

#[test]
fn an_integral_reaches_behind_a_differential_that_comes_first() {
    let text = r"
$$ \vec L = \int dm\, \vec r\times(\vec\omega\times\vec r) $$
";
    let (document, _) = read("a document", text, Format::Markdown);
    let report = polhode::verify::check(&document);
    let verdicts: Vec<_> = report.findings.iter().map(|f| f.verdict.name()).collect();
    assert_ne!(verdicts, ["refuted"]);
}

#[test]
fn a_line_that_later_words_explain_is_looked_at_again() {
    let sentences = format!("{BODY}$\\vec r$ is any vector.\n");
    let text = r"
It follows that

$$ \vec c = \vec a + \vec\omega\times\vec L $$

where $\vec a = \mathbf J\dot{\vec\omega}$ and $\vec c = \vec M$.
";
    assert_eq!(judged(&sentences, text), "paa");
}

#[test]
fn bold_and_plain_of_one_sentence_are_two_letters() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
C is the mass centre of the body.
$\\mathbf w$ is the angular velocity of B relative to N.
$\\hat{\\mathbf n}$ is a unit vector.
$\\mathbf w = w\\hat{\\mathbf n}$.
$T$ is the kinetic energy of rotation of the body relative to N.
$I$ is the moment of inertia of the body about the axis through C along $\\hat{\\mathbf n}$.
";
    let text = r"
$$ T = \tfrac12 I w^2 $$
$$ T = I w^2 $$
";
    let verdicts = judged(sentences, text);
    assert!(
        verdicts.starts_with('p') && !verdicts.ends_with('p'),
        "{verdicts}"
    );
}

#[test]
fn rarer_notation_means_what_it_means_when_written_plainly() {
    let sentences = "$a$, $b$, $c$ and $d$ are constant.
$\\vec v$ is any vector.
";
    let text = r"
$$ \begin{bmatrix} a + b \\ c - d \end{bmatrix} = \left[ {\begin{matrix} a \\ c \end{matrix}} \hspace{.5cm} \begin{matrix} + \\ - \end{matrix} \begin{matrix} b \\ d \end{matrix} \right] $$
$$ \begin{bmatrix} a + b \\ c + d \end{bmatrix} = \left[ {\begin{matrix} a \\ c \end{matrix}} \hspace{.5cm} \begin{matrix} + \\ - \end{matrix} \begin{matrix} b \\ d \end{matrix} \right] $$
$$ ||\vec v||^2 = \vec v\cdot\vec v $$
$$ \frac a2\,b = \frac{ab}2 $$
$$ a^\frac42 = a^2 \quad~Eq. (7) $$
";
    assert_eq!(judged(sentences, text), "prppp");
}

#[test]
fn a_line_is_no_premise_of_itself() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
$R$ takes components on B to components on N.
$W$ is the cross-product matrix of $\\omega$.
$\\omega$ is the angular velocity of B relative to N in components on B.
";
    let text = r"
We define
$$ K = k\,R W R^T $$
$$ K = 2 k\,R W R^T. $$

Here $k$ is a number.
";
    let verdicts = judged(sentences, text);
    assert!(!verdicts[1..].starts_with('p'), "{verdicts}");
}

#[test]
fn an_assumption_says_what_one_quantity_is() {
    let text = r"
When it is written out,
$$ \vec\omega\times\vec L = \vec L\times\vec\omega $$
Suppose that
$$ \vec M = 0 $$
";
    assert_eq!(judged(BODY, text), "ua");
}

#[test]
fn a_partial_derivative_takes_a_function_of_what_is_said() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
$\\phi$, $\\theta$, $\\psi$ are the Euler angles of B relative to N in the order 3, 1, 3.
$T$ is the kinetic energy of rotation of the body relative to N.
$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components on B of the angular velocity of B relative to N.
$I_1$, $I_2$, $I_3$ are the principal moments of the body about G on B.
$i$ numbers the axes of B.
A repeated axis index is summed.
$\\frac{\\partial}{\\partial\\omega_i}$ takes functions of $\\omega_1$, $\\omega_2$, $\\omega_3$.
";
    let text = r"
$$ \frac{\partial T}{\partial\omega_1} = I_1\omega_1 $$
$$ \frac{\partial T}{\partial\omega_i}\frac{\partial\omega_i}{\partial\psi} = (I_1 - I_2)\omega_1\omega_2 $$
$$ \frac{\partial T}{\partial\omega_i}\frac{\partial\omega_i}{\partial\psi} = 0 $$
$$ \frac{\partial T}{\partial\eta} = 0 $$
";
    assert_eq!(judged(sentences, text), "ppru");
}

#[test]
fn an_entry_by_its_numbers_is_the_entry_itself() {
    let sentences = format!(
        "{BODY}The products of inertia are integrals.
$j_{{xx}}$, $j_{{xy}}$, $j_{{xz}}$ are entries (1, 1), (1, 2), (1, 3) of $\\mathbf J$ on B.
$k$ is entry (1, 3) of $\\mathbf J$ on B, also written $k'$.
"
    );
    let text = r"
$$ j_{xz} = k $$
$$ k' = k $$
$$ j_{xz} = -k $$
";
    assert_eq!(judged(&sentences, text), "ppr");
}

#[test]
fn what_two_sentences_say_of_one_thing_holds_both() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the top.
O is a point fixed in N and in B.
$\\phi$, $\\theta$, $\\psi$ are the Euler angles of B relative to N in the order Z, x, z.
$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components on B of the angular velocity of B relative to N.
On lines 2 to 5 $\\theta$ is the same as $\\theta_0$.
$\\theta_0$, $\\omega_p$ are constant.
$\\omega_p$ is the rate of $\\phi$.
";
    let text = r"
$$ \dot\theta = 0 $$
$$ \omega_1 = \omega_p\sin\theta\sin\psi $$
$$ \omega_1 = \omega_p\sin\theta\cos\psi $$

$$ \dot\theta = 0 $$
";
    let verdicts = judged(sentences, text);
    assert!(verdicts.starts_with("pp"), "{verdicts}");
    assert!(!verdicts[2..].contains('p'), "{verdicts}");
}

#[test]
fn turns_one_after_another_may_name_axes_of_the_last_frame() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
x, y, z are the axes of B.
$a$, $b$, $c$ are the Euler angles of B relative to N in the order z, y, x.
F is turned relative to N about z by the angle $a$.
K is turned relative to F about y by the angle $b$.
B is turned relative to K about x by the angle $c$.
$p$, $q$, $r$ are the components on B of the angular velocity of B relative to N.
";
    let text = r"
$$ r = -\sin c\,\dot b + \cos c\cos b\,\dot a $$
$$ r = -\sin c\,\dot b + \cos c\sin b\,\dot a $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn particles_beside_a_rigid_part_are_no_rotors_of_it() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the hub.
O is a point fixed in B.
The ship consists of the hub and of particles.
$j$ numbers the particles.
G is the mass centre of the hub.
$\\vec r$ is the position of G from O.
$\\vec r_j$ is the position of particle $j$ from O.
$m$ is the mass of the hub.
$m_j$ is the mass of particle $j$.
$\\mathbf I_G$ is the inertia tensor of the hub about G.
$\\mathbf I_O$ is the inertia tensor of the ship about O.
A tilde means the cross-product matrix.
";
    let text = r"
$$ \mathbf I_O = \mathbf I_G + m \tilde{\vec r}\tilde{\vec r}^T + \sum_j m_j \tilde{\vec r}_j \tilde{\vec r}_j^T $$
";
    assert!(!judged(sentences, text).contains('r'));
}

#[test]
fn an_unused_sentence_withholds_what_its_letters_stand_in() {
    let sentences =
        format!("{BODY}$e$ is the coefficient of restitution between the body and the floor.\n");
    let text = r"
$$ \vec L = 2\,\mathbf J\vec\omega $$
$$ e\,\vec L = \mathbf J\vec\omega $$
";
    assert_eq!(judged(&sentences, text), "ru");
}

#[test]
fn no_line_is_denied_by_what_is_named_and_not_introduced() {
    // Without a sentence on C its position is not that from the origin.
    let sentences = format!("{BODY}$\\vec c$ is the position of C from O.\n");
    let text = r"
$$ \vec c = 0 $$
$$ \dot{\vec c} = \vec\omega\times\vec c $$
";
    assert!(!judged(&sentences, text).contains(['p', 'r']));
    // Without a mass for each, the sum over particles may be anything.
    let sentences = format!("{BODY}$\\vec r_i$ is the position of particle $i$ from G.\n");
    assert_eq!(
        judged(&sentences, r"$$ \sum_i m_i \vec r_i = \vec L $$"),
        "u"
    );
}

#[test]
fn a_noun_may_name_the_point_that_something_is_about() {
    let sentences = format!(
        "{BODY}The pivot is a point fixed in N and in B.\n$\\vec K$ is the angular momentum of the body about the pivot relative to N.\n$\\vec r$ is the position of G from the pivot.\n$m$ is the mass of the body.\n"
    );
    let text = r"
$$ \vec K = \vec L + m \vec r\times\dot{\vec r} $$
$$ \vec K = \vec L $$
";
    assert_eq!(judged(&sentences, text), "pr");
}
