//! What stands side by side: numbers, products, functions and their arguments, powers, indices, sums, integrals.

use super::outline::each_reads;

#[test]
fn a_power_of_ten_belongs_to_its_number() {
    each_reads(&[
        (r"5.0\times 10^{-5}", "1/20000:1"),
        (r"2\cdot 10^{3}", "2000"),
        (
            r"5.0\times10^{-5}\,\mathrm{kg\,m^2}",
            "(unit 1/20000:1 \"kg m^2\")",
        ),
        (r"3\times 4", "(* 3 × 4)"),
        (r"10^{-3}", "(^ 10 (- 3))"),
        (r"90^\circ", "(unit 90 \"deg\")"),
        ("90°", "(unit 90 \"deg\")"),
    ]);
}

#[test]
fn letters_side_by_side_are_a_product() {
    each_reads(&[
        (r"pq", "(* p q)"),
        (r"qr(I_z-I_y)", "(* q (call r (+ I_z (- I_y))))"),
        (r"(I_z-I_y)qr", "(* (group (+ I_z (- I_y))) q r)"),
        (r"2\pi", "(* 2 pi)"),
        (r"R^{T}\dot R", "(* (T R) (dot R))"),
        (r"a*b \cdot c", "(* a b · c)"),
        (r"q\otimes p \circ r", "(* q ⊗ p ⊗ r)"),
    ]);
}

#[test]
fn a_slash_divides_what_stands_close_to_it() {
    each_reads(&[
        (r"1/2mv^2", "(* (/ 1 2) m (^ v 2))"),
        (r"\tfrac12", "(/ 1 2)"),
        (r"\frac12 I", "(* (/ 1 2) I)"),
        (r"\frac 1 2", "(/ 1 2)"),
        (r"\frac1{2}I", "(* (/ 1 2) I)"),
        (r"H^2/2I", "(/ (^ H 2) (* 2 I))"),
        (
            r"(I_2-I_3)/I_1 \omega_2\omega_3",
            "(* (/ (group (+ I_2 (- I_3))) I_1) omega_2 omega_3)",
        ),
        (r"a/b/c", "(/ (/ a b) c)"),
    ]);
}

#[test]
fn a_function_without_brackets_takes_what_belongs_to_it() {
    each_reads(&[
        (r"\cos\Omega t", "(cos (* Omega t))"),
        (
            r"\sin\omega_n t\,\cos\omega t",
            "(* (sin (* omega_n t)) (cos (* omega t)))",
        ),
        (r"\sin 2\theta", "(sin (* 2 theta))"),
        (r"\sin\theta\,\dot\phi", "(* (sin theta) (dot phi))"),
        (r"\sin\theta\cos\phi", "(* (sin theta) (cos phi))"),
        (r"\sin\theta(a + b)", "(* (sin theta) (group (+ a b)))"),
        (r"\sin\chi(a + b)", "(* (sin chi) (group (+ a b)))"),
        (r"\cos\theta\mathbf{e}_x", "(* (cos theta) vec:e_x)"),
        (r"\sin^2\theta\,\dot\psi", "(* (^ (sin theta) 2) (dot psi))"),
        (r"\sin^2(\pi t/T_s)", "(^ (sin (* pi (/ t T_s))) 2)"),
        (r"\tan^{-1}x", "(arctan x)"),
        (r"\sin\theta/\cos\theta", "(/ (sin theta) (cos theta))"),
        (r"\cos\theta/2", "(cos (/ theta 2))"),
        (r"\cos\frac{\theta}{2}", "(cos (/ theta 2))"),
        (
            r"\cos(\Omega t + \phi)\,A",
            "(* (cos (+ (* Omega t) phi)) A)",
        ),
        (r"e^{-\lambda t}", "(exp (- (* lambda t)))"),
        (r"\mathrm{e}^{\lambda t}", "(exp (* lambda t))"),
        (r"e^{\mathrm{i}\lambda t}", "(exp (* up:i lambda t))"),
        (r"\sqrt{a}\,b", "(* (sqrt a) b)"),
        (r"\theta(t)", "(call theta t)"),
        (r"\omega(0) = \omega_0", "(call omega 0) = omega_0"),
        (r"r(\theta)^2", "(* r (^ (group theta) 2))"),
    ]);
}

#[test]
fn raised_things_are_powers_transposes_inverses_or_labels() {
    each_reads(&[
        (r"\omega_x^2", "(^ omega_x 2)"),
        (r"\omega^2_x", "(^ omega_x 2)"),
        (r"x^2y", "(* (^ x 2) y)"),
        (r"J^{-1}", "(^ J (- 1))"),
        (r"J^{-T}", "(T (^ J (- 1)))"),
        (r"A^T", "(T A)"),
        (r"A^{\mathsf T}", "(T A)"),
        (r"A^\top", "(T A)"),
        (r"A^{\intercal}", "(T A)"),
        (r"|\mathbf H|^2", "(^ (norm vec:H) 2)"),
        (r"\left\|H\right\|", "(norm H)"),
        (r"\lVert H\rVert", "(norm H)"),
        (r"\omega^{(n+1)}", "omega^(n+1)"),
        (r"\omega^{n+1}", "(^ omega (+ n 1))"),
    ]);
}

#[test]
fn steps_primes_variations_and_resultants_are_parts_of_the_symbol() {
    each_reads(&[
        (r"\omega_{k+1}", "omega_k+1"),
        (r"\omega_{x,k+1}", "omega_x_k+1"),
        (
            r"\sum M_{x'} = I_{x'}\alpha_{x'}",
            "sum:M_x' = (* I_x' alpha_x')",
        ),
        (r"\Sigma\vec M_O", "sum:vec:M_O"),
        (r"\sum \mathbf{F} = m\mathbf{a}", "sum:vec:F = (* m vec:a)"),
        (r"M_{G \text{ or } O}", "M_G·or·O"),
        (r"\delta\omega_x", "delta:omega_x"),
        (r"\delta\dot\omega", "(dot delta:omega)"),
        (r"\Delta t", "delta:t"),
        (r"\delta_{ij}", "delta_ij"),
    ]);
}

#[test]
fn sums_and_integrals_have_an_index_a_variable_and_limits() {
    each_reads(&[
        (
            r"\sum_{i=1}^{3} I_i\omega_i^2",
            "(sum i 1 3 (* I_i (^ omega_i 2)))",
        ),
        (r"\sum_{j} I_{ij}\omega_j", "(sum j (* I_ij omega_j))"),
        (r"\int_0^{T_s}\dot\theta\,dt", "(int (dot theta) t 0 T_s)"),
        (
            r"\int (y^2+z^2)\,\mathrm{d}m",
            "(int (group (+ (^ y 2) (^ z 2))) m)",
        ),
        (r"\iiint xy\,dm", "(int (* x y) m)"),
        (r"\iiint\limits_V{\rho}{xy}{dV}", "(int (* rho (* x y)) V)"),
        (r"\int x_{dm}\,dm", "(int x_dm m)"),
        (r"-\int xz\,dm", "(- (int (* x z) m))"),
        (r"\iiint_V \rho xy \,dx\,dy\,dz", "(int (* rho x y) V)"),
        (r"\int dm = m", "(int 1 m) = m"),
    ]);
}

#[test]
fn what_is_not_known_is_an_error_at_its_place_and_the_rest_is_read() {
    each_reads(&[
        (
            r"a = \foo b + c",
            "a = (+ (* <the command \\foo is not known> b) c)",
        ),
        (
            r"a = b \\ c = \foo{x} \\ d = e",
            "a = b\nc = <the command \\foo is not known>\nd = e",
        ),
        (r"a = ", "a = <an empty place where an expression belongs>"),
        (
            r"a = b +",
            "a = (+ b <the formula ends where more is expected>)",
        ),
        (r"a = (b", "a = <a bracket that is not closed>"),
        (
            r"\sqrt[n]{x}",
            "unreadable: a root needs a whole number for its degree",
        ),
    ]);
}
