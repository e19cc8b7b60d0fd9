//! One step of a free body, with its derivative in everything that it depends on.

use nalgebra::{Matrix3, Vector3};
use polhode::motion::{MotionError, Rk4, Scheme, State, System, Torque};

fn main() -> Result<(), MotionError> {
    let inertia = Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0));
    let system = System::new(inertia, Torque::None)?;
    let start = State::at_rest().turning(Vector3::new(3.0, 0.5, -0.9));
    // Columns: attitude, angular velocity, torque, inertia and the length of the step; with 6 the first two alone.
    let step = Rk4.step_with_jacobian::<16>(&system, 0.0, &start, 0.01);
    println!("ω after the step: {}", step.state.angular_velocity);
    println!("∂(θ', ω')/∂(θ, ω, torque, inertia, dt): {:.4}", step.matrix);
    Ok(())
}
