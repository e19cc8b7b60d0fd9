//! The time of the exact work that a check is made of, for the component line of the full inertia tensor.
//!
//! Rivals, measured on one core for the same work: a zero test of the line 2.5 µs in FLINT, 6.3 µs in SymEngine;
//! the Jacobian 168 µs in FLINT; L·L 111 µs in FLINT; the sixth power 211 µs in FLINT.

use criterion::{Criterion, criterion_group, criterion_main};
use num_traits::Zero;
use polhode::algebra::Polynomial;
use polhode::scalar::{Prime, Ring};
use std::hint::black_box;
use std::process::Command;

/// Moments and products of inertia in the order xx, yy, zz, xy, xz, yz, the angular velocity and its rate.
struct World<T> {
    inertia: [T; 6],
    omega: [T; 3],
    alpha: [T; 3],
}

/// ΣM_x as the determinant gives it: I_xx ω̇_x − I_xy ω̇_y − I_xz ω̇_z + ω_y L_z − ω_z L_y.
fn expanded<T: Ring>(world: &World<T>) -> T {
    let [xx, yy, zz, xy, xz, yz] = world.inertia.clone();
    let [x, y, z] = world.omega.clone();
    let [ax, ay, az] = world.alpha.clone();
    let last = -(xz.clone() * x.clone()) - yz.clone() * y.clone() + zz * z.clone();
    let middle = -(xy.clone() * x) + yy * y.clone() - yz * z.clone();
    xx * ax - xy * ay - xz * az + y * last - z * middle
}

/// The same, grouped by the products of inertia.
fn grouped<T: Ring>(world: &World<T>) -> T {
    let [xx, yy, zz, xy, xz, yz] = world.inertia.clone();
    let [x, y, z] = world.omega.clone();
    let [ax, ay, az] = world.alpha.clone();
    let squares = y.clone() * y.clone() - z.clone() * z.clone();
    xx * ax
        - (yy - zz) * y.clone() * z.clone()
        - xy * (ay - z * x.clone())
        - xz * (az + x * y)
        - yz * squares
}

fn tensor(inertia: &[Polynomial; 6]) -> [[Polynomial; 3]; 3] {
    let [xx, yy, zz, xy, xz, yz] = inertia.clone();
    let [xy, xz, yz] = [-xy, -xz, -yz];
    [
        [xx, xy.clone(), xz.clone()],
        [xy, yy, yz.clone()],
        [xz, yz, zz],
    ]
}

fn apply(m: &[[Polynomial; 3]; 3], v: &[Polynomial; 3]) -> [Polynomial; 3] {
    std::array::from_fn(|r| {
        (0..3).fold(Polynomial::zero(), |sum, c| {
            sum + m[r][c].clone() * v[c].clone()
        })
    })
}

fn cross(a: &[Polynomial; 3], b: &[Polynomial; 3]) -> [Polynomial; 3] {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j].clone() * b[k].clone() - a[k].clone() * b[j].clone()
    })
}

fn adjugate(m: &[[Polynomial; 3]; 3]) -> [[Polynomial; 3]; 3] {
    let columns: [[Polynomial; 3]; 3] =
        std::array::from_fn(|c| std::array::from_fn(|r| m[r][c].clone()));
    [
        cross(&columns[1], &columns[2]),
        cross(&columns[2], &columns[0]),
        cross(&columns[0], &columns[1]),
    ]
}

/// adj(I)·(M − ω × Iω), the angular acceleration times det I.
fn acceleration(world: &World<Polynomial>, moment: &[Polynomial; 3]) -> [Polynomial; 3] {
    let inertia = tensor(&world.inertia);
    let gyroscopic = cross(&world.omega, &apply(&inertia, &world.omega));
    let net = std::array::from_fn(|i| moment[i].clone() - gyroscopic[i].clone());
    apply(&adjugate(&inertia), &net)
}

fn polynomials() -> World<Polynomial> {
    World {
        inertia: std::array::from_fn(|i| Polynomial::variable(i as u32)),
        omega: std::array::from_fn(|i| Polynomial::variable(6 + i as u32)),
        alpha: std::array::from_fn(|i| Polynomial::variable(9 + i as u32)),
    }
}

fn primes() -> World<Prime> {
    let drawn = |i: usize| Prime::new(0x9e37_79b9_7f4a_7c15u64.wrapping_mul(i as u64 + 1));
    World {
        inertia: std::array::from_fn(drawn),
        omega: std::array::from_fn(|i| drawn(6 + i)),
        alpha: std::array::from_fn(|i| drawn(9 + i)),
    }
}

fn line(c: &mut Criterion) {
    let mut group = c.benchmark_group("component line");
    let (exact, filter) = (polynomials(), primes());
    let differs = |world| (expanded::<Polynomial>(world) - grouped(world)).is_zero();
    assert!(differs(&exact), "the two forms are one");
    group.bench_function("zero test on polynomials", |b| {
        b.iter(|| differs(black_box(&exact)))
    });
    group.bench_function("filter in the prime field", |b| {
        b.iter(|| (expanded(black_box(&filter)) - grouped(black_box(&filter))).is_zero());
    });
}

fn dynamics(c: &mut Criterion) {
    let world = polynomials();
    let moment: [_; 3] = std::array::from_fn(|i| Polynomial::variable(12 + i as u32));
    c.bench_function("jacobian of the angular acceleration", |b| {
        b.iter(|| {
            let numerators = acceleration(black_box(&world), &moment);
            numerators.map(|n| [6, 7, 8].map(|v| n.partial(v)))
        });
    });
    let rate = |world: &World<Polynomial>| {
        let inertia = tensor(&world.inertia);
        let momentum = apply(&inertia, &world.omega);
        let rate = apply(
            &inertia,
            &acceleration(world, &[0; 3].map(|_| Polynomial::zero())),
        );
        (0..3).fold(Polynomial::zero(), |sum, i| {
            sum + momentum[i].clone() * rate[i].clone()
        })
    };
    assert!(rate(&world).is_zero(), "L·L is conserved without a moment");
    c.bench_function("conservation of L·L", |b| {
        b.iter(|| rate(black_box(&world)))
    });
}

fn power(c: &mut Criterion) {
    let sum = (0..8).fold(Polynomial::zero(), |sum, v| sum + Polynomial::variable(v));
    assert_eq!(sum.pow(6).len(), 1716);
    c.bench_function("sixth power of eight symbols", |b| {
        b.iter(|| black_box(&sum).pow(6))
    });
}

/// The same work in other systems, where Python has them.
fn rivals(_: &mut Criterion) {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/rivals/algebra.py");
    match Command::new("python3").arg(script).status() {
        Ok(status) if status.success() => {}
        outcome => eprintln!("the rivals were left out: {outcome:?}"),
    }
}

criterion_group!(benches, line, dynamics, power, rivals);
criterion_main!(benches);
