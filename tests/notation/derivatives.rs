//! Rates as people write them: dots in every style, quotients of differentials, and the frame beside them.

use super::outline::{each_reads, latex};

#[test]
fn one_dot_is_written_in_many_ways() {
    each_reads(&[
        (r"\dot\omega_1", "(dot omega_1)"),
        (r"\dot{\omega}_{1}", "(dot omega_1)"),
        (r"\dot{\omega_1}", "(dot omega_1)"),
        (r"{\dot\omega}_x", "(dot omega_x)"),
        (r"\bm{\dot{H}}_C", "(dot vec:H_C)"),
        (r"\dot{\vec L}", "(dot vec:L)"),
        (r"\vec{\dot L}", "(dot vec:L)"),
        (r"\dot{\hat{\mathbf e}}_1", "(dot vec:hat:e_1)"),
        (r"\overset{.}{\omega}_x", "(dot omega_x)"),
        (r"\stackrel{\cdot}{\omega}_x", "(dot omega_x)"),
        (r"\overset{\cdot\cdot}{\theta}", "(ddot theta)"),
        (r"\ddot\theta", "(ddot theta)"),
        (r"\dot\theta(t)", "(dot (call theta t))"),
        (r"\dot{(L^2)}", "(dot (group (^ L 2)))"),
        (r"\alpha_x", "alpha_x"),
    ]);
}

#[test]
fn a_quotient_of_differentials_in_the_time_is_a_rate() {
    each_reads(&[
        (r"\frac{d\omega_1}{dt}", "(d/dt omega_1)"),
        (r"\frac{d \mathbf L_G}{dt}", "(d/dt vec:L_G)"),
        (r"\frac{d\,\mathbf L}{d\,t}", "(d/dt vec:L)"),
        (
            r"\frac{\mathrm{d} \boldsymbol{L}}{\mathrm{~d} t}",
            "(d/dt vec:L)",
        ),
        (r"\frac{\mathrm{~d} L_{x}}{\mathrm{~d} t}", "(d/dt L_x)"),
        (r"\frac{\text{d}L}{\text{d}t}", "(d/dt L)"),
        (r"\frac{\dd{\omega}}{\dd{t}}", "(d/dt omega)"),
        (r"\frac{D L}{D t}", "(d/dt L)"),
        (r"\frac{d}{dt}(I\omega)", "(d/dt (* I omega))"),
        (r"\frac{d}{dt}\left(I\omega\right)", "(d/dt (* I omega))"),
        (r"\frac{d^2\theta}{dt^2}", "(d2/dt2 theta)"),
        (
            r"\frac{\mathrm{d}^{2} \theta}{\mathrm{d} t^{2}}",
            "(d2/dt2 theta)",
        ),
        (r"\frac{d^{2}}{dt^{2}}\theta", "(d2/dt2 theta)"),
        (r"\dv{L}{t}", "(d/dt L)"),
        (r"\dv{t}(I\omega)", "(d/dt (* I omega))"),
        (r"\dv[2]{\theta}{t}", "(d2/dt2 theta)"),
        (r"\derivative{L}{t}", "(d/dt L)"),
        (r"d\omega_x/dt", "(d/dt omega_x)"),
        (r"\mathrm d L/\mathrm d t", "(d/dt L)"),
        (r"\frac{\partial F}{\partial\omega}", "(partial F omega)"),
        (r"\frac{DL}{I}", "(/ (* D L) I)"),
    ]);
}

#[test]
fn the_frame_stands_beside_below_before_or_behind_a_bar() {
    each_reads(&[
        (r"(\dot{L})_{XYZ}", "(dot@XYZ L)"),
        (r"\left(\dot{\mathbf L}_G\right)_{xyz}", "(dot@xyz vec:L_G)"),
        (r"(d\mathbf L/dt)_{xyz}", "(d/dt@xyz vec:L)"),
        (r"\left(\frac{dL}{dt}\right)_{\text{body}}", "(d/dt@body L)"),
        (
            r"\left(\frac{dL}{dt}\right)_{\!\mathrm{space}}",
            "(d/dt@space L)",
        ),
        (
            r"\left(\frac{dL}{dt}\right)_{inertial}",
            "(d/dt@inertial L)",
        ),
        (r"\left(\frac{dL}{dt}\right)_{\rm rot}", "(d/dt@rot L)"),
        (r"\left(\frac{dL}{dt}\right)_{S_0}", "(d/dt@S0 L)"),
        (r"\left(\frac{dL}{dt}\right)_f", "(d/dt@f L)"),
        (r"\left(\frac{dL}{dt}\right)_m", "(d/dt@m L)"),
        (r"\left.\frac{dU}{dt}\right|_{R_0}", "(d/dt@R0 U)"),
        (
            r"\left.\dv{\vec L}{t}\right|_{\text{rot}}",
            "(d/dt@rot vec:L)",
        ),
        (r"\frac{dL}{dt}\bigg|_{xyz}", "(d/dt@xyz L)"),
        (r"\dot{\mathbf L}\big|_{B}", "(dot@B vec:L)"),
        (r"\frac{{}^{N}d\,\vec v}{dt}", "(d/dt@N vec:v)"),
        (r"\frac{^N d\,\vec v}{dt}", "(d/dt@N vec:v)"),
        (r"\frac{d_B\mathbf L}{dt}", "(d/dt@B vec:L)"),
        (r"{}^{\mathcal B}\frac{d}{dt}(H)", "(d/dt@B H)"),
        (r"^{\mathcal N}\frac{d}{dt}\mathbf H", "(d/dt@N vec:H)"),
        (r"\Big[\frac{d r}{dt}\Big]_{in\,B}", "(d/dt@inB r)"),
        (
            r"\left[\frac{d\vec{r}}{dt}\right]_{\text{in }B}",
            "(d/dt@in·B vec:r)",
        ),
    ]);
}

#[test]
fn an_operator_without_an_operand_is_no_rate() {
    let read = latex(r"\left(\frac{d}{dt}\right)_{s} = \left(\frac{d}{dt}\right)_b + \omega\times");
    assert!(read.contains('<'), "{read}");
}

#[test]
fn a_slash_divides_by_a_variable_with_its_marks() {
    let whole = |line: &str, variable: &str| {
        let read = latex(line);
        assert!(!read.contains('<'), "{read}");
        assert!(read.contains("(partial T "), "{line}: {read}");
        assert!(read.contains(variable), "{line}: {read}");
    };
    whole(r"\partial T/\partial\vec\omega", "vec:omega");
    whole(r"\partial T/\partial{\bm\omega}", "vec:omega");
    whole(r"\partial T/\partial\dot{\theta}", "dot");
    whole(r"\partial T/\partial\boldsymbol\omega_k", "vec:omega_k");
}
