//! A step and its derivatives under every law: polhode against num-dual at its best, central differences, CasADi and SymForce.
//!
//! Nanoseconds of this library, how many times those of a free body they are, and how many times longer the others take. A row
//! in which another is faster says why. CasADi and SymForce generate their code in scripts of `rivals`, if Python has them.

#[path = "rivals/differences.rs"]
mod differences;
#[path = "rivals/num_dual.rs"]
mod num_dual_step;
#[path = "reference/step.rs"]
mod reference_step;
#[path = "rivals/scripts.rs"]
mod scripts;
#[path = "reference/turns.rs"]
mod turns;

use nalgebra::{SVector, Vector3, Vector6};
use num_dual_step::{Law, Scalar, cross, seen};
use polhode::motion::{
    Frame, Number, Rk4, Rollout, Scheme, SmoothLaw, State, System, Torque, TorqueLaw,
};
use reference_step::{STEP, full, start};
use scripts::Times;
use std::hint::black_box;
use turns::{TURNS, in_turns, repeated};

/// What is timed, in the order of the rows.
const ROWS: [&str; 7] = [
    "step",
    "6 columns",
    "9 columns",
    "15 columns",
    "Jacobian times a direction",
    "covector times Jacobian",
    "100 steps with gradient",
];

/// A drag that grows with the square of the spin, in a wind from the side: a law that the library does not know.
#[derive(Clone, Copy)]
struct Own;

const WIND: [f64; 3] = [0.3, 0.0, -0.1];
const DRAG: f64 = 0.02;

impl<T: Number> TorqueLaw<T> for Own {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn torque(&self, _time: T, state: &State<T>) -> Vector3<T> {
        let spin = state.angular_velocity.z;
        let mut torque = state.attitude.constant_to_body(&Vector3::from(WIND));
        torque.z -= (spin * spin).scaled(DRAG);
        torque
    }
}

impl Law for Own {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn torque<T: Scalar>(&self, _: T, attitude: &[T; 4], omega: &[T; 3]) -> [T; 3] {
        let [x, y, z] = seen(attitude, WIND);
        [x, y, z - omega[2] * omega[2] * DRAG]
    }
}

/// A law that the library knows, written out for the rival.
trait Known: Law {
    const TORQUE: Torque;
}

macro_rules! known {
    ($name:ident, $in_space:literal, $torque:expr, |$time:ident, $attitude:ident, $omega:ident| $rival:expr) => {
        #[derive(Clone, Copy)]
        struct $name;

        impl Known for $name {
            const TORQUE: Torque = $torque;
        }

        impl Law for $name {
            const IN_SPACE: bool = $in_space;

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn torque<T: Scalar>(&self, $time: T, $attitude: &[T; 4], $omega: &[T; 3]) -> [T; 3] {
                $rival
            }
        }
    };
}

const VALUE: [f64; 3] = [0.1, -0.2, 0.3];
const WEIGHT: f64 = 9.81;
const ARM: [f64; 3] = [0.05, -0.1, 0.3];
const DAMPING: f64 = 0.02;
const PACE: f64 = 2.0;
const PHASE: f64 = 0.3;

known!(Free, false, Torque::None, |_t, _q, _w| [T::from(0.0); 3]);
known!(
    Gravity,
    false,
    Torque::Gravity {
        weight: WEIGHT,
        arm: Vector3::new(ARM[0], ARM[1], ARM[2])
    },
    |_t, q, _w| cross(ARM.map(T::from), seen(q, [0.0, 0.0, -WEIGHT]))
);
known!(
    InSpace,
    true,
    Torque::Constant {
        frame: Frame::Space,
        value: Vector3::new(VALUE[0], VALUE[1], VALUE[2])
    },
    |_t, q, _w| seen(q, VALUE)
);
known!(
    Damping,
    false,
    Torque::Damping {
        coefficient: DAMPING
    },
    |_t, _q, w| w.map(|w| w * -DAMPING)
);
known!(
    Sinusoid,
    true,
    Torque::Sinusoid {
        frame: Frame::Space,
        amplitude: Vector3::new(VALUE[0], VALUE[1], VALUE[2]),
        angular_frequency: PACE,
        phase: PHASE
    },
    |t, q, _w| {
        let sine = (t * PACE + PHASE).sin();
        seen(q, VALUE).map(|component| component * sine)
    }
);

fn main() {
    // What is timed, and compiled alone, by `cargo test`.
    if std::env::args().any(|arg| arg == "--test") {
        return;
    }
    let generated = [
        scripts::times("CasADi", "casadi_step.py"),
        scripts::times("SymForce", "symforce_step.py"),
    ];
    let free = of_law("free", Free::TORQUE, Free, None, &generated);
    known("gravity", Gravity, &free, &generated);
    known("torque in space", InSpace, &free, &generated);
    known("damping", Damping, &free, &generated);
    known("sinusoid in space", Sinusoid, &free, &generated);
    of_law("one's own", Own, Own, Some(&free), &generated);
}

fn known<K: Known>(name: &str, law: K, free: &[f64; 7], generated: &[Times; 2]) {
    of_law(name, K::TORQUE, law, Some(free), generated);
}

/// Times a law and prints its rows; the times of this library.
fn of_law<L: SmoothLaw>(
    name: &str,
    law: L,
    rival: impl Law,
    free: Option<&[f64; 7]>,
    generated: &[Times; 2],
) -> [f64; 7] {
    let (system, state) = (System::new(full(), law).expect("a body"), start());
    let torques = vec![Vector3::new(0.1, 0.0, -0.2); 100];
    let costs = vec![Vector6::from_fn(|i, _| 0.3 * i as f64 - 0.7); 101];
    let step = Rk4.step_with_jacobian::<15>(&system, 0.0, &state, STEP);
    let apart = step.matrix - num_dual_step::columns::<15>(&rival, &full(), &state, STEP).1;
    assert!(apart.amax() < 1e-12, "{name}: one and the same is timed");
    for sum in generated
        .iter()
        .filter_map(|of| of.get(name, "sum of entries"))
    {
        let apart = (sum - step.matrix.sum()).abs();
        assert!(apart < 1e-12, "{name}: one and the same is timed");
    }
    let ours = polhode(&system, &state, &torques, &costs);
    let dual = num_dual(rival, &state, &costs);
    let differences = differences::times(&system, &state, &torques, &costs);
    println!(
        "{name:<28}{:>12}{:>10}{:>12}{:>14}{:>10}{:>10}",
        "polhode, ns", "of free", "num-dual", "differences", "CasADi", "SymForce"
    );
    for (i, row) in ROWS.iter().enumerate() {
        let of_free = ours[i] / free.unwrap_or(&ours)[i];
        let [casadi, symforce] = generated.each_ref().map(|of| of.get(name, row));
        let others = [Some(dual[i]), Some(differences[i]), casadi, symforce];
        let others = others.map(|time| time.map(|time| time / ours[i]));
        let [dual, differences, casadi, symforce] =
            others.map(|ratio| ratio.map(|ratio| format!("{ratio:.1}")).unwrap_or_default());
        println!(
            "  {row:<26}{:>12.1}{of_free:>10.2}{dual:>12}{differences:>14}{casadi:>10}{symforce:>10}",
            ours[i],
        );
        // What is closer is as fast.
        if others.into_iter().flatten().any(|ratio| ratio < 0.95) {
            let why = match *row {
                "step" => "without derivatives, differences time our own step once more",
                _ => "no reason is known",
            };
            println!("    behind: {why}");
        }
    }
    ours
}

fn direction() -> SVector<f64, 15> {
    SVector::from_fn(|i, _| 0.1 * i as f64 - 0.7)
}

fn covector() -> Vector6<f64> {
    Vector6::from_fn(|i, _| 0.3 * i as f64 - 0.7)
}

fn polhode<L: SmoothLaw>(
    system: &System<f64, L>,
    state: &State<f64>,
    torques: &[Vector3<f64>],
    costs: &[Vector6<f64>],
) -> [f64; 7] {
    let (direction, covector) = (&direction(), &covector());
    let (system, state) = black_box((system, state));
    in_turns(
        TURNS,
        [
            repeated!(Rk4.step(black_box(system), 0.0, state, STEP)),
            repeated!(Rk4.step_with_jacobian::<6>(black_box(system), 0.0, state, STEP)),
            repeated!(Rk4.step_with_jacobian::<9>(black_box(system), 0.0, state, STEP)),
            repeated!(Rk4.step_with_jacobian::<15>(black_box(system), 0.0, state, STEP)),
            repeated!(Rk4.jvp(black_box(system), 0.0, state, STEP, black_box(direction))),
            repeated!(Rk4.vjp::<15>(black_box(system), 0.0, state, STEP, black_box(covector))),
            repeated!({
                let rollout = Rollout::new(Rk4, *black_box(system), *state, STEP, torques);
                rollout.expect("finite").gradient(costs)
            }),
        ],
    )
}

fn num_dual(law: impl Law, state: &State<f64>, costs: &[Vector6<f64>]) -> [f64; 7] {
    use num_dual_step::{along, columns, gradient, plain};
    let (inertia, direction, covector) = (&full(), &direction(), &covector());
    let (inertia, state) = black_box((inertia, state));
    in_turns(
        TURNS,
        [
            repeated!(plain(&law, black_box(inertia), state, STEP)),
            repeated!(columns::<6>(&law, black_box(inertia), state, STEP)),
            repeated!(columns::<9>(&law, black_box(inertia), state, STEP)),
            repeated!(columns::<15>(&law, black_box(inertia), state, STEP)),
            repeated!(along(
                &law,
                black_box(inertia),
                state,
                STEP,
                black_box(direction)
            )),
            repeated!(
                columns::<15>(&law, black_box(inertia), state, STEP)
                    .1
                    .tr_mul(black_box(covector))
            ),
            repeated!(gradient(&law, black_box(inertia), state, STEP, costs)),
        ],
    )
}
