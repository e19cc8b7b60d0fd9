//! Cases and how long an assumption holds, parts that spin, names with a number, and moments on turned axes.

#[path = "outcome/verdicts.rs"]
mod outcome;
use outcome::verdicts;

#[test]
fn a_propeller_has_a_momentum_of_its_own() {
    let text = r"Relative to the fuselage the propeller has the angular momentum $h_e$. With the inertia matrix $\mathbf I$ and the angular velocity
$\boldsymbol\omega$ on principal axes

$$ H_x = I_x\,\omega_x + h_e, \qquad H_y = I_y\,\omega_y, \qquad H_z = I_z\,\omega_z $$

and the moment is

$$ M_y = I_y\dot\omega_y + (I_x - I_z)\,\omega_z\omega_x + h_e\,\omega_z $$

$$ M_z = I_z\dot\omega_z + (I_y - I_x)\,\omega_x\omega_y + h_e\,\omega_y $$
";
    assert_eq!(verdicts(text), "aaapr");
}

#[test]
fn a_two_behind_a_letter_may_be_its_square() {
    let text = r"The angular momentum is $L = I\omega$, the torque $\tau$. With

$$ L_2 = |L|^2 $$

$$ \frac{dL_2}{dt} = 2\,L\cdot\tau $$

$$ \frac{dL_2}{dt} = L\cdot\tau $$
";
    assert_eq!(verdicts(text), "papr");
}

#[test]
fn one_index_names_the_moment_about_a_turned_axis() {
    let text = r"The plate has

$$ I_x = \int y^2\,dm, \qquad I_y = \int x^2\,dm, \qquad I_{xy} = \int xy\,dm $$

On axes turned by the angle $\beta$

$$ u = x\cos\beta + y\sin\beta, \qquad v = -x\sin\beta + y\cos\beta $$

and squaring gives the new set

$$ I_u = I_x\cos^2\beta + I_y\sin^2\beta - 2I_{xy}\sin\beta\cos\beta $$

$$ I_v = I_x\sin^2\beta + I_y\cos^2\beta - 2I_{xy}\sin\beta\cos\beta $$

$$ I_u + I_v = I_x + I_y $$
";
    assert_eq!(verdicts(text), "appaaprp");
}

#[test]
fn a_bound_in_a_condition_is_taken() {
    let text = r"The inertia matrix is $\mathbf J$, the torque is

$$ \mathbf u = -k\,\boldsymbol\omega $$

with $k > 0$.
";
    assert_eq!(verdicts(text), "aa");
}

#[test]
fn a_paragraph_with_a_title_opens_another_case() {
    let text = r"The moment is $\mathbf M$, on principal axes.

**Spin about the first axis.** Let $\omega_y = \omega_z = 0$. Then

$$ M_z = I_z\dot\omega_z $$

**Spin about the third axis.** Let $\omega_x = \omega_y = 0$ and $\omega_z = n$, a constant. Then

$$ L_z = I_z\,n $$

$$ L_z = 0 $$
";
    assert_eq!(verdicts(text), "apaapr");
}

#[test]
fn what_is_assumed_twice_in_one_case_must_agree() {
    let text = r"Let $\omega_x = 2$. Let further $\omega_x = 3$.";
    assert_eq!(verdicts(text), "ar");
}

#[test]
fn a_bracket_may_speak_of_another_case() {
    let text = r"The edges are $a = 0.4$ and $b = 0.2$. For a square plate ($a = b$) it would be $2a = 2b$. But $a = 3b$.";
    assert_eq!(verdicts(text), "aauur");
}

#[test]
fn a_hat_makes_the_matrix_of_a_cross_product() {
    let text = r"The hat turns a vector into a matrix, $\hat a\,b = a\times b$. With the inertia matrix $J$, the angular velocity $\omega$ and the torque $\tau$

$$ J\dot\omega = \tau - \hat\omega J\omega $$

$$ J\dot\omega = \tau + \widehat{J\omega}\,\omega $$

$$ J\dot\omega = \tau + \hat\omega J\omega $$
";
    assert_eq!(verdicts(text), "pppr");
}

#[test]
fn the_same_spin_about_another_axis_is_another_case() {
    let text = r"No torque acts on the body, and $I_1$, $I_2$, $I_3$ are its principal moments.

**Spin about axis 1.** Let $\omega_1 \approx n$, with $\omega_2$ and $\omega_3$ small. Then

$$ \dot\omega_2 \approx \frac{I_3 - I_1}{I_2}\,n\,\omega_3 $$

**Spin about axis 3.** Now $\omega_3 \approx n$, and the same steps give

$$ \ddot\omega_1 \approx -\frac{(I_3 - I_2)(I_3 - I_1)}{I_1 I_2}\,n^2\,\omega_1 $$

$$ \ddot\omega_1 \approx \frac{(I_3 - I_2)(I_3 - I_1)}{I_1 I_2}\,n^2\,\omega_1 $$
";
    assert_eq!(verdicts(text), "apapr");
}

#[test]
fn axes_that_were_attached_to_the_body_may_turn_in_another_way_in_the_next_case() {
    let text = r"The body has the principal moments $I_1 = I_2 = A$ and $I_3 = C$, the axes turn with
$$ \boldsymbol\Omega = \omega_1\,\mathbf e_1 + \omega_2\,\mathbf e_2 + \Omega_3\,\mathbf e_3 $$
and the body with
$$ \boldsymbol\omega = \omega_1\,\mathbf e_1 + \omega_2\,\mathbf e_2 + \omega_3\,\mathbf e_3 $$
On these axes the moment is
$$ N_2 = A\dot\omega_2 + A\Omega_3\omega_1 - C\omega_1\omega_3 $$

*(i) Axes fixed in the body*, $\Omega_3 = \omega_3$. Then
$$ N_2 = A\dot\omega_2 + (A - C)\,\omega_1\omega_3 $$

*(ii) Axes that do not turn about* $\mathbf e_3$, that is $\Omega_3 = 0$:
$$ N_2 = A\dot\omega_2 - C\,\omega_1\omega_3 $$
$$ N_2 = A\dot\omega_2 + C\,\omega_1\omega_3 $$
";
    assert_eq!(verdicts(text), "aaaapppapr");
}

#[test]
fn a_limit_holds_in_its_sentence() {
    let text = |value: &str| {
        verdicts(&format!(
            r"A body has the principal moments $A$, $B$, $C$. The constant $k$ is defined by $k^2 = \frac{{A - C}}{{B}}$.

For a long thin body ($C \to 0$, $A = B$) it becomes $k = {value}$. The momentum about the third axis is

$$ L_3 = C\omega_3 $$

$$ L_3 = 2C\omega_3 $$
"
        ))
    };
    assert_eq!(text("1"), "aaappr");
    assert_eq!(text("2"), "aaaupr");
}

#[test]
fn a_component_of_the_rate_of_the_axes_takes_another_value_in_another_case() {
    let text = |size: &str| {
        verdicts(&format!(
            r"The axes turn at $\vec\Omega$ and the body at $\vec\omega = \vec\Omega + s\,\vec e_3$. The moments are $A$, $A$, $C$ and the torque is $\vec M$.

When the axes turn steadily with $\Omega_2 = q$, the other rates are zero,

$$ \Omega_1 = \Omega_3 = 0 $$

$$ M_1 = C s q $$

When instead $\Omega_1 = p\cos kt$, the greatest torque is

$$ \max|M_2| = {size} $$
"
        ))
    };
    assert_eq!(text("C s p"), "aaapap");
    assert_eq!(text("A s p"), "aaapar");
}
