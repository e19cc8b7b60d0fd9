//! First-order changes, Jacobians and steps.

use super::verdicts;

const FREE: &str = "\
N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
The axes of B are principal axes of the body.
No moment acts on the body about G.
$w$ is the angular velocity of B relative to N in components on B.
$p$, $q$, $r$ are the components of $w$ on B.
$J$ is the inertia tensor of the body about G in components on B.
$A$, $B$, $C$ are the principal moments of the body about G on B.
";

#[test]
fn changes_obey_the_varied_equations_of_motion() {
    let sentences = format!(
        "{FREE}$\\delta w$ is the first-order change of $w$.
$\\delta p$, $\\delta q$, $\\delta r$ are the components of $\\delta w$ on B.
$T$ is the kinetic energy of rotation of the body.
$\\delta T$ is the first-order change of $T$.
"
    );
    let text = r"
$$ J\,\delta\dot w+\delta w\times Jw+w\times J\,\delta w=0 $$
$$ J\,\delta\dot w+\delta w\times Jw=0 $$
$$ A\,\delta\dot p=(B-C)(q\,\delta r+r\,\delta q) $$
$$ A\,\delta\dot p=(B-C)(q\,\delta r-r\,\delta q) $$
$$ \delta T=Ap\,\delta p+Bq\,\delta q+Cr\,\delta r $$
$$ \delta T=Ap\,\delta p+Bq\,\delta q $$
$$ \delta(w\times Jw)=\delta w\times Jw+w\times J\,\delta w $$
$$ \delta(w\times Jw)=w\times J\,\delta w $$
$$ \delta J=0 $$
";
    assert_eq!(verdicts(&sentences, text).0, "prprprpra");
}

#[test]
fn what_is_told_of_one_motion_denies_nothing_of_motions_nearby() {
    let sentences = format!(
        "{FREE}$\\delta w$ is the first-order change of $w$.
$\\delta p$, $\\delta q$, $\\delta r$ are the components of $\\delta w$ on B.
$p=0$.
$q=0$.
"
    );
    let text = r"
$$ A\,\delta\dot p=(B-C)r\,\delta q $$
$$ \delta p=0 $$
$$ \delta p=\delta q $$
";
    assert_eq!(verdicts(&sentences, text).0, "puu");
}

#[test]
fn a_constant_changes_where_a_sentence_tells_it() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body.
x, y, z are the axes of B.
$m$ is the mass of the body.
G is the mass centre of the body.
O is a point fixed in B.
G lies at the distance $a$ from O along x.
$K$ is the moment of inertia of the body about the axis through G along z.
$I$ is the moment of inertia of the body about the axis through O along z.
$\\delta a$ is the first-order change of $a$.
$\\delta I$ is the first-order change of $I$.
";
    let text = r"
$$ I=K+ma^2 $$
$$ \delta I=2ma\,\delta a $$
$$ \delta I=ma\,\delta a $$
$$ \delta\dot a=0 $$
";
    assert_eq!(verdicts(sentences, text).0, "pprp");
}

#[test]
fn the_jacobian_of_what_a_line_defines() {
    let sentences = format!(
        "{FREE}$F$ is the Jacobian of $f$ in $w$ with outputs in rows.
$K$ is the Jacobian of $f$ with respect to $w$ with outputs in columns.
$\\delta w$ is the first-order change of $w$.
"
    );
    let text = r"
$$ F=0 $$
Let
$$ f(w)=-J^{-1}(w\times Jw) $$
be the right side. Then
$$ F=\begin{pmatrix}0&\frac{B-C}{A}r&\frac{B-C}{A}q\\ \frac{C-A}{B}r&0&\frac{C-A}{B}p\\
\frac{A-B}{C}q&\frac{A-B}{C}p&0\end{pmatrix} $$
$$ F=\begin{pmatrix}0&\frac{B-C}{A}r&\frac{B-C}{A}q\\ \frac{C-A}{B}r&0&\frac{A-C}{B}p\\
\frac{A-B}{C}q&\frac{A-B}{C}p&0\end{pmatrix} $$
$$ K=F^T $$
$$ K=F $$
$$ \delta\dot w=F\,\delta w $$
$$ \delta\dot w=F^T\,\delta w $$
$$ \dot w=F\,w $$
$$ \dot w=\tfrac12F\,w $$
";
    assert_eq!(verdicts(&sentences, text).0, "uaprprprrp");
}

#[test]
fn the_jacobian_of_a_rate_by_the_laws_alone() {
    let sentences = format!(
        "{FREE}$f$ is the rate of $w$.
$F$ is the Jacobian of $f$ in $w$ with outputs in rows.
"
    );
    let text = r"
$$ F=\begin{pmatrix}0&\frac{B-C}{A}r&\frac{B-C}{A}q\\ \frac{C-A}{B}r&0&\frac{C-A}{B}p\\
\frac{A-B}{C}q&\frac{A-B}{C}p&0\end{pmatrix} $$
$$ F=0 $$
";
    assert_eq!(verdicts(&sentences, text).0, "pr");
    // Without the equations of motion nothing tells of what the rate is a function.
    let open = sentences.replace("No moment acts on the body about G.\n", "");
    assert_eq!(verdicts(&open, text).0, "uu");
    // Without the layout it may be the transpose.
    let either = sentences.replace(" with outputs in rows", "");
    assert_eq!(verdicts(&either, text).0, "uu");
}

#[test]
fn the_jacobian_of_a_place_in_its_angles() {
    let sentences = "\
N is an inertial frame.
z is the third axis of N.
O is a point fixed in N.
A turns relative to N about z by the angle $a$.
C turns relative to N about z by the angle $a+b$.
$\\vec u$ is the first axis of A.
$\\vec v$ is the first axis of C.
P is placed from O by $l\\,\\vec u+k\\,\\vec v$.
$l$ and $k$ are constant.
$p$ is the position of P from O in components on N.
$D$ is the Jacobian of $p$ in $a$ and $b$ with outputs in rows.
";
    let text = r"
$$ D=\begin{pmatrix}-l\sin a-k\sin(a+b)&-k\sin(a+b)\\ l\cos a+k\cos(a+b)&k\cos(a+b)\\0&0\end{pmatrix} $$
$$ D=\begin{pmatrix}-l\sin a-k\sin(a+b)&-k\sin b\\ l\cos a+k\cos(a+b)&k\cos(a+b)\\0&0\end{pmatrix} $$
";
    // The place is a vector itself, and whether its components are meant is open.
    assert_eq!(verdicts(sentences, text).0, "uu");
}

#[test]
fn a_step_has_a_length_and_functions_are_stepped() {
    let sentences = format!(
        "{FREE}$f(w)$ is the rate of $w$.
$w_k$ is the value of $w$ at step $k$; the step is explicit Euler.
$h$ is the length of the step.
$T$ is the kinetic energy of rotation of the body.
$T_k$ is the value of $T$ at step $k$.
"
    );
    let text = r"
$$ w_{k+1}=w_k+h\,f(w_k) $$
$$ w_{k+1}=w_k-h\,f(w_k) $$
$$ w_k^TJf(w_k)=0 $$
$$ T_{k+1}-T_k=\tfrac12h^2f(w_k)^TJf(w_k) $$
$$ T_{k+1}-T_k=h^2f(w_k)^TJf(w_k) $$
$$ T_{k+1}=T_k $$
";
    assert_eq!(verdicts(&sentences, text).0, "prpprr");
    let several = format!("{sentences}$\\eta$ is the step size.\n");
    assert_eq!(&verdicts(&several, text).0[..2], "uu");
}

#[test]
fn the_changes_of_loads_by_disturbances() {
    let sentences = format!(
        "{}$M$ is the total moment on the body about G in components on B.
$L$ is the first component of $M$ on B.
$P_0$, $Q_0$, $R_0$ are the reference values of $p$, $q$, $r$.
$x$, $y$, $z$ are the small disturbances of $p$, $q$, $r$.
$\\Delta L$ is the first-order change of $L$.
$P_0$, $Q_0$ and $R_0$ are constant.
",
        FREE.replace("No moment acts on the body about G.\n", "")
    );
    let text = r"
$$ \Delta L=A\dot x+(C-B)(Q_0z+R_0y) $$
$$ \Delta L=A\dot x+(C-B)(Q_0z-R_0y) $$
$$ \Delta L=A\dot x+(C-B)(qz+ry) $$
";
    assert_eq!(verdicts(&sentences, text).0, "prr");
}

#[test]
fn what_the_model_holds_fixed_has_no_change() {
    let sentences = "\
N is an inertial frame.
B turns relative to N about z at the constant rate $n$.
$w$ is the angular velocity of B relative to N in components on B.
$\\delta w$ is the first-order change of $w$.
";
    let text = r"
$$ \delta\dot w=w\times\delta w $$
$$ \delta w=2\,\delta w $$
";
    assert_eq!(verdicts(sentences, text).0, "uu");
}

#[test]
fn a_function_with_its_argument_is_raised_as_a_whole() {
    let sentences = format!("{FREE}$f(w)$ is the rate of $w$.\n");
    let text = r"
$$ f(w)^Tf(w)=\dot p^2+\dot q^2+\dot r^2 $$
$$ f(w)^Tw=p\,\dot p+q\,\dot q+r\,\dot r $$
$$ f(w)^Tw=p\,\dot p+q\,\dot q-r\,\dot r $$
";
    assert_eq!(verdicts(&sentences, text).0, "ppr");
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

#[test]
fn components_of_a_change_that_is_not_worked_out_are_not_either() {
    let sentences = format!(
        "{FREE}$\\delta w$ is the first-order change of $w$.
$\\delta p$, $\\delta q$, $\\delta r$ are the components of $\\delta w$ on B.
The body turns about the first axis of B at the constant rate $\\Omega$.
"
    );
    let text = r"
$$ \delta q=0 $$
$$ A\,\delta\dot p=0 $$
";
    assert_eq!(verdicts(&sentences, text).0, "uu");
}

#[test]
fn a_change_that_equations_leave_open_is_not_worked_out() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body.
x, y, z are the axes of B.
$m$ is the mass of the body.
G is the mass centre of the body.
O is a point fixed in B.
G lies at the distance $a$ from O along x.
$K$ is the moment of inertia of the body about the axis through G along z.
$I$ is the moment of inertia of the body about the axis through O along z.
$b$ is constant.
$\\delta a$ is the first-order change of $a$.
$\\delta I$ is the first-order change of $I$.
";
    let text = r"
$$ \delta I=2ma\,\delta a $$
$$ \delta I=2mb\,\delta a $$
$$ \delta a=0 $$
$$ \delta(ma)=m\,\delta a $$
";
    let by_others = format!("{sentences}$a=2b$.\n");
    assert_eq!(verdicts(&by_others, text).0, "puup");
    let as_number = format!("{sentences}$a=2$.\n");
    assert_eq!(verdicts(&as_number, text).0, "puup");
}

#[test]
fn whether_disturbances_are_changes_is_open() {
    let sentences = "\
N is an inertial frame.
B turns relative to N about z at the rate $P$.
$P_0$ is the reference value of $P$, and $p$ its small disturbance.
$\\Delta P$ is the first-order change of $P$.
";
    let text = r"
$$ \Delta P=p $$
$$ \Delta P=P-P_0 $$
$$ \Delta P=P_0 $$
$$ \delta(P^2)=2P\,\Delta P $$
$$ \delta(P^2)=2Pp $$
";
    assert_eq!(verdicts(sentences, text).0, "uurpu");
}

#[test]
fn lists_within_a_list_are_rows() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body.
$w$ is the angular velocity of B relative to N in components on B.
$p$, $q$, $r$ are the components of $w$ on B.
";
    let text = r"
$$ [[0,1,0],[0,0,0],[0,0,0]]\,w=[q,0,0] $$
$$ [[0,1,0],[0,0,0],[0,0,0]]\,w=[0,p,0] $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}
