//! How products of inertia are written, where a matrix of the document tells it.

use super::judged;

const CRAFT: &str = r"
N is an inertial frame.
K is a frame fixed in the hull.
x, y, z are the axes of K.
The craft consists of the hull and the wheel.
D is the mass centre of the craft.
$\mathbf{J}$ is the inertia tensor of the craft about D in components on K.
$p$, $q$, $r$ are the components on K of the angular velocity of K relative to N.
Line 2 is given.
";

/// Also the tensor of several bodies is symmetric, and has one letter for each product.
#[test]
fn a_matrix_tells_the_sign_of_products_of_inertia() {
    let integrals = r"
$$ \mathbf{J} = \begin{pmatrix} J_{xx} & 0 & -J_{xz} \\ 0 & J_{yy} & 0 \\ -J_{xz} & 0 & J_{zz} \end{pmatrix} $$
$$ J_{xz} = 0 $$
$$ \mathbf{J}\begin{pmatrix} p\\q\\r\end{pmatrix} = \begin{pmatrix} J_{xx}p-J_{xz}r\\J_{yy}q\\J_{zz}r-J_{xz}p\end{pmatrix} $$
$$ \mathbf{J}\begin{pmatrix} p\\q\\r\end{pmatrix} = \begin{pmatrix} J_{xx}p+J_{xz}r\\J_{yy}q\\J_{zz}r+J_{xz}p\end{pmatrix} $$
";
    assert_eq!(judged(CRAFT, integrals), "arpr");
    let entries = integrals.replacen("-J_{xz}", "J_{xz}", 2);
    assert_eq!(judged(CRAFT, &entries), "arrp");
}
