//! Steps of a computation, and rotations by vectors.

use super::verdicts;

#[test]
fn a_step_has_a_length_and_functions_are_stepped() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
The axes of B are principal axes of the body.
No moment acts on the body about G.
$w$ is the angular velocity of B relative to N in components on B.
$J$ is the inertia tensor of the body about G in components on B.
$w_k$ is the value of $w$ at step $k$; the step is explicit Euler.
$h$ is the length of the step.
$T$ is the kinetic energy of rotation of the body.
$T_k$ is the value of $T$ at step $k$.
";
    let text = r"
$$ w_{k+1}=w_k+h\,\dot w $$
$$ w_{k+1}=w_k-h\,\dot w $$
$$ T_{k+1}-T_k=\tfrac12h^2\dot w^TJ\dot w $$
$$ T_{k+1}=T_k $$
";
    assert_eq!(verdicts(sentences, text).0, "prpr");
}

#[test]
fn the_rotation_by_its_length_about_a_vector() {
    let sentences = "\
N is an inertial frame.
$E$ is the identity matrix.
$W(a)$ is the cross-product matrix of $a$, for any vector $a$.
$Q(a)$ is the matrix of the rotation by $|a|$ about $a$.
$a$ is any vector.
";
    let text = r"
$$ Q(a)=E+\frac{\sin|a|}{|a|}W(a)+\frac{1-\cos|a|}{|a|^2}W(a)^2 $$
$$ Q(a)=E-\frac{\sin|a|}{|a|}W(a)+\frac{1-\cos|a|}{|a|^2}W(a)^2 $$
$$ Q(a)\,a=a $$
";
    assert_eq!(verdicts(sentences, text).0, "prp");
}
