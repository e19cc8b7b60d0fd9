//! Inertia that is possible by construction, for optimisers.
//!
//! A body can exist if the second moments of its mass, with its first moments and its mass beside them, form a positive definite
//! matrix: the pseudo-inertia. Its Cholesky factor U, upper triangular with P = U Uᵀ, has a positive diagonal and else any
//! entries; with the logarithms of the diagonal every real vector is a body. Rucker and Wensing (2022), *Smooth
//! parameterization of rigid-body inertia*, IEEE Robotics and Automation Letters 7(2).

use crate::mechanics::InertiaParameters;
use nalgebra::{Matrix3, Matrix4, SMatrix, SVector};

/// Mass, first moments m c (x, y, z) and the tensor's own entries xx, yy, zz, xy, xz, yz about the origin.
pub type TenParameters = SVector<f64, 10>;

/// The ten inertial parameters of ten log-Cholesky parameters (α, d₁, d₂, d₃, s₁₂, s₂₃, s₁₃, t₁, t₂, t₃), and the derivative of
/// the former in the latter.
///
/// U = e^α [[e^d₁, s₁₂, s₁₃, t₁], [0, e^d₂, s₂₃, t₂], [0, 0, e^d₃, t₃], [0, 0, 0, 1]], and U Uᵀ holds ∫ x xᵀ dm, m c and m.
/// Parameters too large give entries that are not finite.
///
/// ```
/// use nalgebra::{Matrix3, SVector};
/// use polhode::mechanics::{InertiaParameters, inertial_parameters, possible_body};
/// let (body, _) = inertial_parameters(&SVector::from([0.3, -1.0, 0.5, 0.2, 4.0, -3.0, 0.1, 2.0, -2.0, 1.0]));
/// let entries: [f64; 6] = std::array::from_fn(|i| body[4 + i]);
/// assert!(body[0] > 0.0 && possible_body(&InertiaParameters::MuJoCo.tensor(entries)).is_ok());
/// ```
pub fn inertial_parameters(
    log_cholesky: &SVector<f64, 10>,
) -> (TenParameters, SMatrix<f64, 10, 10>) {
    let [alpha, d1, d2, d3, s12, s23, s13, t1, t2, t3] = (*log_cholesky).into();
    let scale = f64::exp(alpha);
    let [e1, e2, e3] = [d1, d2, d3].map(f64::exp);
    let unit = Matrix4::new(
        e1, s12, s13, t1, 0.0, e2, s23, t2, 0.0, 0.0, e3, t3, 0.0, 0.0, 0.0, 1.0,
    );
    let factor = unit * scale;
    let value = of_pseudo_inertia(&(factor * factor.transpose()));
    let mut jacobian = SMatrix::<f64, 10, 10>::zeros();
    for (column, (place, slope)) in ENTRIES
        .iter()
        .zip([e1, e2, e3, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0])
        .enumerate()
    {
        let mut change = Matrix4::zeros();
        change[*place] = slope * scale;
        let half = change * factor.transpose();
        jacobian.set_column(column + 1, &of_pseudo_inertia(&(half + half.transpose())));
    }
    // The whole grows as e^2α.
    jacobian.set_column(0, &(value * 2.0));
    (value, jacobian)
}

/// Where d₁ … t₃ stand in U.
const ENTRIES: [(usize, usize); 9] = [
    (0, 0),
    (1, 1),
    (2, 2),
    (0, 1),
    (1, 2),
    (0, 2),
    (0, 3),
    (1, 3),
    (2, 3),
];

/// The log-Cholesky parameters of ten inertial parameters, and the derivative of the former in the latter: the inverse of
/// [`inertial_parameters`]. `None` if no body has them, or if the body is a plate, a rod or a point, which stands at infinity.
///
/// ```
/// use nalgebra::SVector;
/// use polhode::mechanics::{inertial_parameters, log_cholesky};
/// // 2 kg at (0.1, 0, 0).
/// let body = SVector::from([2.0, 0.2, 0.0, 0.0, 0.5, 0.6, 0.7, 0.0, 0.0, 0.0]);
/// let (parameters, _) = log_cholesky(&body).ok_or("no body")?;
/// assert!((inertial_parameters(&parameters).0 - body).norm() < 1e-15);
/// # Ok::<(), &str>(())
/// ```
pub fn log_cholesky(body: &TenParameters) -> Option<(SVector<f64, 10>, SMatrix<f64, 10, 10>)> {
    let factor = upper_cholesky(&pseudo_inertia(body))?;
    let inverse = factor.try_inverse()?;
    let last = factor[(3, 3)];
    let parameters = |of: &dyn Fn((usize, usize)) -> f64| {
        let mut found = SVector::<f64, 10>::zeros();
        for (i, place) in ENTRIES.iter().enumerate() {
            found[i + 1] = of(*place);
        }
        found
    };
    let mut value = parameters(&|(r, c)| {
        let entry = factor[(r, c)] / last;
        if r == c { entry.ln() } else { entry }
    });
    value[0] = last.ln();
    let mut jacobian = SMatrix::<f64, 10, 10>::zeros();
    for column in 0..10 {
        let mut unit = TenParameters::zeros();
        unit[column] = 1.0;
        // dU = U Φ(U⁻¹ dP U⁻ᵀ), Φ the upper triangle with half of the diagonal.
        let inner = inverse * pseudo_inertia(&unit) * inverse.transpose();
        let half = Matrix4::from_fn(|r, c| match r.cmp(&c) {
            std::cmp::Ordering::Less => inner[(r, c)],
            std::cmp::Ordering::Equal => inner[(r, c)] / 2.0,
            std::cmp::Ordering::Greater => 0.0,
        });
        let change = factor * half;
        let alpha = change[(3, 3)] / last;
        let mut slopes = parameters(&|(r, c)| {
            let entry = factor[(r, c)];
            if r == c {
                change[(r, c)] / entry - alpha
            } else {
                (change[(r, c)] - entry * alpha) / last
            }
        });
        slopes[0] = alpha;
        jacobian.set_column(column, &slopes);
    }
    let finite = value.iter().chain(jacobian.iter()).all(|x| x.is_finite());
    finite.then_some((value, jacobian))
}

/// [[½ tr(I) 1 − I, m c], [(m c)ᵀ, m]], linear in the parameters.
fn pseudo_inertia(body: &TenParameters) -> Matrix4<f64> {
    let [m, hx, hy, hz, xx, yy, zz, xy, xz, yz] = (*body).into();
    let half = (xx + yy + zz) / 2.0;
    Matrix4::new(
        half - xx,
        -xy,
        -xz,
        hx,
        -xy,
        half - yy,
        -yz,
        hy,
        -xz,
        -yz,
        half - zz,
        hz,
        hx,
        hy,
        hz,
        m,
    )
}

/// The parameters of a pseudo-inertia.
fn of_pseudo_inertia(matrix: &Matrix4<f64>) -> TenParameters {
    let p = |r: usize, c: usize| matrix[(r, c)];
    SVector::from([
        p(3, 3),
        p(0, 3),
        p(1, 3),
        p(2, 3),
        p(1, 1) + p(2, 2),
        p(0, 0) + p(2, 2),
        p(0, 0) + p(1, 1),
        -p(0, 1),
        -p(0, 2),
        -p(1, 2),
    ])
}

/// U, upper triangular, of U Uᵀ: from the last row up.
fn upper_cholesky(matrix: &Matrix4<f64>) -> Option<Matrix4<f64>> {
    let mut factor = Matrix4::zeros();
    for c in (0..4).rev() {
        for r in (0..=c).rev() {
            let behind: f64 = (c + 1..4).map(|k| factor[(r, k)] * factor[(c, k)]).sum();
            let rest: f64 = matrix[(r, c)] - behind;
            if r == c {
                if !(rest > 0.0 && rest.is_finite()) {
                    return None;
                }
                factor[(r, c)] = rest.sqrt();
            } else {
                factor[(r, c)] = rest / factor[(c, c)];
            }
        }
    }
    Some(factor)
}

/// The tensor of a body about its mass centre or a fixed point, of six log-Cholesky parameters (α, d₁, d₂, s₁₂, s₂₃, s₁₃), and
/// the derivative of its own entries xx, yy, zz, xy, xz, yz in them.
///
/// U = e^α [[e^d₁, s₁₂, s₁₃], [0, e^d₂, s₂₃], [0, 0, 1]] and ∫ x xᵀ dm = U Uᵀ: every real vector is a body, none a plate. The
/// derivative of a step in the parameters is that in the inertia times this one.
///
/// ```
/// use nalgebra::SVector;
/// use polhode::mechanics::{log_cholesky_of_inertia, possible_body, possible_inertia};
/// let parameters = SVector::from([-0.7, 1.0, -0.5, 0.3, -2.0, 0.1]);
/// let (tensor, _) = possible_inertia(&parameters);
/// assert!(possible_body(&tensor).is_ok());
/// let (back, _) = log_cholesky_of_inertia(&tensor).ok_or("a body of finite parameters")?;
/// assert!((back - parameters).norm() < 1e-13);
/// # Ok::<(), &str>(())
/// ```
pub fn possible_inertia(log_cholesky: &SVector<f64, 6>) -> (Matrix3<f64>, SMatrix<f64, 6, 6>) {
    let [alpha, d1, d2, s12, s23, s13] = (*log_cholesky).into();
    let scale = alpha.exp();
    // The body of mass 1 about the origin, of which the third diagonal entry is the scale.
    let [a, b, c] = [s12, s23, s13].map(|s| s * scale);
    let ten = [0.0, alpha + d1, alpha + d2, alpha, a, b, c, 0.0, 0.0, 0.0];
    let (body, by_ten) = inertial_parameters(&ten.into());
    let mut by_six = SMatrix::<f64, 10, 6>::zeros();
    by_six.set_column(
        0,
        &SVector::from([0.0, 1.0, 1.0, 1.0, a, b, c, 0.0, 0.0, 0.0]),
    );
    for (column, (row, slope)) in [(1, 1.0), (2, 1.0), (4, scale), (5, scale), (6, scale)]
        .into_iter()
        .enumerate()
    {
        by_six[(row, column + 1)] = slope;
    }
    let entries = std::array::from_fn(|i| body[4 + i]);
    let tensor = InertiaParameters::MuJoCo.tensor(entries);
    (tensor, by_ten.fixed_view::<6, 10>(4, 0) * by_six)
}

/// The six log-Cholesky parameters of a tensor, and their derivative in its entries: the inverse of [`possible_inertia`]. `None` if
/// no body has the tensor, or if the body is a plate or a rod, which stands at infinity.
pub fn log_cholesky_of_inertia(
    tensor: &Matrix3<f64>,
) -> Option<(SVector<f64, 6>, SMatrix<f64, 6, 6>)> {
    let mut body = TenParameters::zeros();
    body[0] = 1.0;
    let entries = InertiaParameters::MuJoCo.of_tensor(tensor);
    body.as_mut_slice()[4..].copy_from_slice(&entries);
    let (ten, by_body) = log_cholesky(&body)?;
    let scale = ten[3].exp();
    let [a, b, c] = [ten[4], ten[5], ten[6]].map(|s| s / scale);
    let value = SVector::from([ten[3], ten[1] - ten[3], ten[2] - ten[3], a, b, c]);
    let by_ten = SMatrix::<f64, 6, 10>::from_fn(|row, column| match (row, column) {
        (0, 3) | (1, 1) | (2, 2) => 1.0,
        (1 | 2, 3) => -1.0,
        (3.., 3) => -value[row],
        (3.., _) if column == row + 1 => 1.0 / scale,
        _ => 0.0,
    });
    Some((value, by_ten * by_body.fixed_view::<10, 6>(0, 4)))
}
