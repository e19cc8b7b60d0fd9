//! Frames above rates, vectors below one another, and letters in backticks that are LaTeX.

use super::judged;

#[test]
fn a_frame_above_a_dotted_vector_says_from_where_its_rate_is_seen() {
    let sentences = r"
e is an inertial frame.
b is a frame fixed in the body.
C is the mass centre of the body.
`\vec{p}_{b/e}` is the momentum of the body relative to e.
`\vec{\omega}_{b/e}` is the angular velocity of b relative to e.
`m` is the mass of the body.
`\vec{v}_{C/e}` is the velocity of C relative to e.
A frame at the upper left of a dotted vector means the rate seen from that frame.
";
    let text = r"
$$ {}^e\dot{\vec{p}}_{b/e}={}^b\dot{\vec{p}}_{b/e}+\vec{\omega}_{b/e}\times\vec{p}_{b/e} $$
$$ {^e \dot{\vec{p}_{b/e}}}={^b \dot{\vec{p}_{b/e}}}-\vec{\omega}_{b/e}\times\vec{p}_{b/e} $$
$$ {}^e\dot{\vec{p}}_{b/e}=m\,{}^e\dot{\vec{v}}_{C/e} $$
$$ {}^b\dot{\vec{p}}_{b/e}=m\,{}^e\dot{\vec{v}}_{C/e} $$
$$ {}^b\dot{\vec{p}}_{b/e}=m\,{}^b\dot{\vec{v}}_{C/e} $$
";
    assert_eq!(judged(sentences, text), "prprp");
}

#[test]
fn base_vectors_below_one_another_are_the_rows_of_a_matrix() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
$b_1$, $b_2$, $b_3$ are the axes of B.
$C$ takes components on N to components on B.
$w$ is the angular velocity of B relative to N.
$w_1$, $w_2$, $w_3$ are the components of $w$ on B.
A frame at the upper left of a vector means components on that frame.
${}^N\frac{d}{dt}$ is the rate seen from N.
A column of base vectors on lines 2 to 6 is the matrix with the components of these vectors in rows.
On lines 4 to 6 a base vector without a label has components on N.
A dot over a matrix means the rate entry by entry.
";
    let text = r"
$$ C=\begin{bmatrix}{}^N b_1\\ {}^N b_2\\ {}^N b_3\end{bmatrix} $$
$$ C=\begin{bmatrix}{}^N b_1\\ {}^N b_3\\ {}^N b_2\end{bmatrix} $$
$$ \dot C=\begin{bmatrix}{}^N\frac{d}{dt}\left(b_1\right)\\ {}^N\frac{d}{dt}\left(b_2\right)\\ {}^N\frac{d}{dt}\left(b_3\right)\end{bmatrix} $$
$$ \dot C=\begin{bmatrix}0&w_3&-w_2\\-w_3&0&w_1\\w_2&-w_1&0\end{bmatrix}\begin{bmatrix}b_1\\b_2\\b_3\end{bmatrix} $$
$$ \dot C=\begin{bmatrix}0&-w_3&w_2\\w_3&0&-w_1\\-w_2&w_1&0\end{bmatrix}\begin{bmatrix}b_1\\b_2\\b_3\end{bmatrix} $$
$$ C=\begin{bmatrix}{}^N b_1\\ {}^N b_2\\ {}^N b_3\end{bmatrix} $$
";
    assert_eq!(judged(sentences, text), "prppru");
}
