//! Parts that spin, squares with a number for a name, and moments on turned axes.

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
