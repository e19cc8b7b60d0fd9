//! Letters and marks of older texts and of engineers': u, v, w; w for ω; plain i, j, k; δ/δt; bold letters with a number.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn velocities_of_the_mass_centre_change_under_the_force() {
    let text = r"The velocity of the centre of mass is $\mathbf V = [u, v, w]^T$ and the rates are $\boldsymbol\omega = [p, q, r]^T$.

$$ \mathbf F = m\left(\dot{\mathbf V} + \boldsymbol\omega\times\mathbf V\right) $$

$$ \dot u = \frac{F_x}{m} + rv - qw, \quad \dot v = \frac{F_y}{m} + pw - ru $$

$$ \dot w = \frac{F_z}{m} + qu + pv $$
";
    assert_eq!(verdicts(text), "pppppr");
}

#[test]
fn the_velocity_may_be_that_of_another_point_where_an_arm_is_spoken_of() {
    let text = r"Let $\mathbf v$ be the velocity of the point $A$ and $\mathbf r$ the vector from there to the centre of mass.

$$ \mathbf F = m\left(\dot{\mathbf v} + \boldsymbol\omega\times\mathbf v\right) $$

$$ \mathbf v_P = \boldsymbol\omega\times\mathbf r $$
";
    assert!(!verdicts(text).starts_with(['p', 'r']));
}

#[test]
fn a_w_that_stands_beside_a_cross_is_the_angular_velocity() {
    let text = r"The moment of momentum $h$ about the centre of mass is

$$ h = \int r\times(w\times r)\,dm $$

with $w = w_x i + w_y j + w_z k$ and the products of inertia $I_{xy}, I_{yz}, I_{xz}$. Along $x$,

$$ h_x = I_x w_x - I_{xy} w_y - I_{xz} w_z $$

$$ h_x = I_x w_x - I_{xy} w_y + I_{xz} w_z $$

$$ \frac{dh}{dt} = \frac{\delta h}{\delta t} + w\times h $$

$$ \frac{dh}{dt} = \frac{\delta h}{\delta t} - w\times h $$

$$ \frac{dh}{dt} = \frac{\partial h}{\partial t} + \begin{vmatrix} i & j & k \\ w_x & w_y & w_z \\ h_x & h_y & h_z \end{vmatrix} $$
";
    assert_eq!(verdicts(text), "paprprp");
}

#[test]
fn a_link_between_pages_is_read_as_its_words() {
    let text = r"No [[torque]] acts on the body, whose [[moment of inertia|principal moments]] are $I_1 > I_2 > I_3$.

$$ I_1\dot\omega_1 = (I_2 - I_3)\omega_2\omega_3 $$

$$ I_2\dot\omega_2 = (I_1 - I_3)\omega_3\omega_1 $$
";
    assert_eq!(verdicts(text), "apr");
}

#[test]
fn a_bold_letter_with_a_number_beside_a_cross_is_a_vector_of_its_own() {
    let text = r"Define the operator $\mathbf S$ by $\mathbf S(\mathbf a)\mathbf b = \mathbf a\times\mathbf b$. Then

$$ \mathbf S(\mathbf a)^T = -\mathbf S(\mathbf a) $$
";
    assert_eq!(verdicts(text), "ap");
    let arms = r"Let $\mathbf F_1$ and $\mathbf F_2$ act at $\mathbf r_1$ and $\mathbf r_2$. For any vectors

$$ \mathbf r_1\times(\mathbf F_1 + \mathbf F_2) = \mathbf r_1\times\mathbf F_1 + \mathbf r_1\times\mathbf F_2 $$
";
    assert_eq!(verdicts(arms), "p");
}

#[test]
fn letters_that_the_words_call_the_components_of_the_angular_velocity() {
    let body = r"
$$ A\,\dot u = (B - C)\,v w $$

$$ B\,\dot v = (C - A)\,w u $$

$$ C\,\dot w = (B - A)\,u v $$

$$ 2T = A u^2 + B v^2 + C w^2 $$
";
    for words in [
        "$u$, $v$ and $w$ are the components of the angular velocity along them.",
        "The components of the angular velocity along them are $u, v, w$.",
    ] {
        let text = format!(
            "No moment acts on the body. $A$, $B$ and $C$ are its principal moments of inertia. {words} $T$ is the kinetic energy.\n{body}"
        );
        assert_eq!(verdicts(&text), "pprp", "{words}");
    }
}
