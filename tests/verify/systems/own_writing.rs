//! Ways of writing that sentences tell: frames at the left, rates by primes and rings, sides that are missing, and things told by one letter.

use super::judged;

#[test]
fn frames_at_the_left_of_rates_and_of_letters() {
    let sentences = r"N is an inertial frame.
B is a frame.
O is a point fixed in N and in B.
Q is a point fixed in B.
$\frac{^{X} d}{dt}$ is the rate seen from X, for any frame X.
$^N$ and $^{N}$ are the same.
$^{X}\mathbf{\omega}^{Y}$ is the angular velocity of Y relative to X, for any frames X and Y.
$^{X}\mathbf{v}^{Y}$ is the velocity of Y relative to X, for any frame X and any point Y.
$\mathbf{r}^{XY}$ is the position of Y from X, for any points X and Y.
The words in \textrm are no part of the formulas.
";
    let text = r"
$$
\begin{aligned}
  \textrm{We have: }
  ^{N}\mathbf{v}^Q &= ^N\mathbf{\omega}^{B}\times\mathbf{r}^{OQ} \\
  ^{N}\mathbf{v}^Q &= \mathbf{r}^{OQ}\times ^N\mathbf{\omega}^{B} \\
  \frac{^{N} d ^{N}\mathbf{\omega}^{B}}{dt} &= \frac{^{B} d ^{N}\mathbf{\omega}^{B}}{dt} \\
  \frac{^{N} d \mathbf{r}^{OQ}}{dt} &= \frac{^{B} d \mathbf{r}^{OQ}}{dt} \\
  ^{N}\mathbf{v}^Q + ^{N}\mathbf{v}^Q &= 2 ^N\mathbf{\omega}^{B}\times\mathbf{r}^{OQ} . \; (4)
\end{aligned}
$$
";
    assert_eq!(judged(sentences, text), "prprp");
}

#[test]
fn the_axis_of_a_body_by_its_unit_vector_and_a_shaft_without_mass() {
    let sentences = r"N is an inertial frame.
A is a frame fixed in the disc.
$\vec i$, $\vec j$, $\vec k$ are the axes of A.
A turns relative to N about $\vec k$ at the constant rate $\Omega$.
The disc is a uniform thin disc of mass $m$ and radius $r$.
$G$ is the mass centre of the disc.
$G$ is a point fixed in N and in A.
$\vec n$ is the unit vector along the axis of the disc.
The axis of the disc is turned from $\vec k$ towards $\vec i$ by the angle $\alpha$.
$\alpha$ is constant.
The shaft has no mass.
The shaft is fixed in A.
The rotor consists of the disc and the shaft.
$\vec H$ is the angular momentum of the rotor about $G$ relative to N.
";
    let text = r"
$$ \vec n = \sin\alpha\,\vec i+\cos\alpha\,\vec k $$
$$ \vec H=\frac{m r^2\Omega}{4}\left[\sin\alpha\cos\alpha\,\vec i+(1+\cos^2\alpha)\,\vec k\right] $$
$$ \vec H=\frac{m r^2\Omega}{2}\vec k $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn rates_by_primes_on_brackets_and_by_rings() {
    let sentences = r"N is an inertial frame.
B is a frame that turns relative to N.
$\mathbf w$ is the angular velocity of B relative to N.
$\mathbf a$ and $\mathbf b$ are fixed in N.
A prime means the rate seen from B.
A ring means the rate seen from B.
Line 7 starts from $\mathbf a'$.
";
    let text = r"
$$ (\mathbf a+\mathbf b)'=-\mathbf w\times(\mathbf a+\mathbf b) $$
$$ (\mathbf a+\mathbf b)'=\mathbf w\times(\mathbf a+\mathbf b) $$
$$ \mathring{\mathbf a}=-\mathbf w\times\mathbf a $$
$$ \mathring{\mathbf a}=\mathbf w\times\mathbf a $$

$$ = -\mathbf w\times\mathbf a $$
";
    assert_eq!(judged(sentences, text), "prprp");
}

#[test]
fn an_axis_that_points_along_its_like() {
    let sentences = r"N is an inertial frame.
A is a frame that turns relative to N about $\mathbf e_3$ at the constant rate $n$.
$\mathbf e_1$, $\mathbf e_2$, $\mathbf e_3$ are the axes of A.
$\mathbf b_1$, $\mathbf b_2$, $\mathbf b_3$ are the axes of B.
$\mathbf b_3$ points along $\mathbf e_3$.
B turns relative to A about $\mathbf e_3$ by the angle $\theta$.
$\mathbf w$ is the angular velocity of B relative to N.
";
    let text = r"
$$ \mathbf w=(n+\dot\theta)\mathbf b_3 $$
$$ \mathbf e_1=\cos\theta\,\mathbf b_1-\sin\theta\,\mathbf b_2 $$
$$ \mathbf e_1=\cos\theta\,\mathbf b_1+\sin\theta\,\mathbf b_2 $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn parts_of_which_only_sums_are_told() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the body.
The spacecraft consists of the body and the devices.
G is the mass centre of the spacecraft.
$w$ is the angular velocity of B relative to N in components on B.
$H$ is the angular momentum of the spacecraft about G with velocities relative to G in components on B.
$h$ is the angular momentum of the body about G with velocities relative to G in components on B.
$k$ is the angular momentum of the devices about G with velocities relative to G in components on B.
";
    let text = r"
$$ H=h+k $$
$$ H=h-k $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_rate_is_told_by_what_stands_beside_its_d() {
    let ways = [
        (r"\frac{\delta}{\delta t}", r"\frac{\delta H}{\delta t}"),
        (r"\delta/\delta t", r"\frac{\delta}{\delta t} H"),
        (r"\frac{d'}{dt}", r"\frac{d'H}{dt}"),
        (r"\frac{\tilde d}{dt}", r"\frac{\tilde d H}{dt}"),
        (r"\frac{d^*}{dt}", r"\frac{d^* H}{dt}"),
        (
            r"\frac{\text{d}_B}{\text{d}t}",
            r"\frac{\text{d}_B H}{\text{d}t}",
        ),
        (
            r"\frac{\text{d}_r}{\text{d}t}",
            r"\frac{\text{d}_r H}{\text{d}t}",
        ),
    ];
    for (sign, rate) in ways {
        let sentences = format!(
            r"N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
$\omega$ is the angular velocity of B relative to N.
$H$ is the angular momentum of the body about G relative to N.
$\frac{{d}}{{dt}}$ is the rate seen from N.
${sign}$ is the rate seen from B."
        );
        let text = format!(
            r"
$$ \frac{{d H}}{{dt}} = {rate} + \omega\times H $$
$$ \frac{{d H}}{{dt}} = {rate} $$
"
        );
        assert_eq!(judged(&sentences, &text), "pr", "{sign}");
    }
}

#[test]
fn a_rate_of_one_vector_shows_how_rates_are_written() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
$\omega$ is the angular velocity of B relative to N.
$H$ is the angular momentum of the body about G relative to N.
$\frac{d}{dt}$ is the rate seen from N.
$\frac{\delta H}{\delta t}$ is the rate of $H$ seen from B.
";
    let text = r"
$$ \frac{d H}{dt} = \frac{\delta H}{\delta t} + \omega\times H $$
$$ \frac{d \omega}{dt} = \frac{\delta \omega}{\delta t} $$
";
    assert_eq!(judged(sentences, text), "pp");
}
