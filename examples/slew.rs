//! A satellite turns from rest to rest with the least effort, its torques limited: multiple shooting, by quadratic programs.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettingsBuilder, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus, ZeroConeT,
};
use nalgebra::{DVector, Matrix3, Matrix6, Vector3, Vector6};
use polhode::motion::{Rk4, State, System, Torque};
use polhode::optimise::{Blocks, Csc, Nodes};
use std::error::Error;

/// A slew from rest to rest.
pub struct Slew {
    /// The satellite.
    pub system: System<f64, Torque>,
    /// From the first attitude to the last: axis times angle.
    pub turn: Vector3<f64>,
    /// How many steps.
    pub steps: usize,
    /// How long each, s.
    pub dt: f64,
    /// The most that each torque may be, N m.
    pub limit: f64,
}

/// The slew of least effort.
pub struct Found {
    /// The motion.
    pub nodes: Nodes,
    /// How many quadratic programs it took.
    pub iterations: usize,
}

impl Slew {
    /// ½ Σ |torque|² dt.
    pub fn effort(&self, nodes: &Nodes) -> f64 {
        let squares = nodes.torques.iter().map(Vector3::norm_squared);
        self.dt * squares.sum::<f64>() / 2.0
    }

    /// Sequential quadratic programming: the motion linearised, the effort quadratic as it is.
    pub fn solve(&self) -> Result<Found, Box<dyn Error>> {
        let mut nodes = self.uniform_turn();
        for iterations in 1..=30 {
            let change = self.best_change(&nodes)?;
            nodes = nodes.perturbed(&change);
            if change.amax() < 1e-8 {
                return Ok(Found { nodes, iterations });
            }
        }
        Err("no convergence".into())
    }

    /// The start of the search: from the first attitude to the last about one axis.
    fn uniform_turn(&self) -> Nodes {
        let tangent = |k: usize| {
            let (part, speed) = (
                k as f64 / self.steps as f64,
                1.0 / (self.steps as f64 * self.dt),
            );
            let speed = if k == 0 || k == self.steps {
                0.0
            } else {
                speed
            };
            let (turn, omega) = (self.turn * part, self.turn * speed);
            Vector6::new(turn.x, turn.y, turn.z, omega.x, omega.y, omega.z)
        };
        let states = (0..=self.steps).map(|k| State::at_rest().perturbed(&tangent(k)));
        Nodes {
            states: states.collect(),
            torques: vec![Vector3::zeros(); self.steps],
        }
    }

    /// The change of the nodes that makes the effort least, among those that mend the linearised defects, leave both ends where
    /// they are and keep the torques within their limits.
    fn best_change(&self, nodes: &Nodes) -> Result<DVector<f64>, Box<dyn Error>> {
        let (steps, size) = (self.steps, nodes.dimension());
        let (missed, mut rows) = nodes.defects(&Rk4, &self.system, self.dt);
        let mut bounds: Vec<f64> = missed.iter().map(|d| -d).collect();
        for node in [0, steps] {
            rows.add(bounds.len(), 9 * node, &Matrix6::identity());
            bounds.extend([0.0; 6]);
        }
        let equations = bounds.len();
        for sign in [1.0, -1.0] {
            for (k, torque) in nodes.torques.iter().enumerate() {
                rows.add(bounds.len(), 9 * k + 6, &(Matrix3::identity() * sign));
                bounds.extend(torque.iter().map(|u| self.limit - sign * u));
            }
        }
        let (mut gradient, mut hessian) = (vec![0.0; size], Blocks::default());
        for (k, torque) in nodes.torques.iter().enumerate() {
            let place = 9 * k + 6;
            gradient[place..place + 3].copy_from_slice((torque * self.dt).as_slice());
            hessian.add(place, place, &(Matrix3::identity() * self.dt));
        }
        let cones = [
            ZeroConeT(equations),
            NonnegativeConeT(bounds.len() - equations),
        ];
        let settings = DefaultSettingsBuilder::default()
            .verbose(false)
            .tol_feas(1e-11)
            .build()?;
        let [hessian, rows] = [hessian.csc(size, size), rows.csc(bounds.len(), size)].map(clarabel);
        let mut solver = DefaultSolver::new(&hessian, &gradient, &rows, &bounds, &cones, settings)?;
        solver.solve();
        match solver.solution.status {
            SolverStatus::Solved | SolverStatus::AlmostSolved => {
                Ok(DVector::from_vec(solver.solution.x))
            }
            status => Err(format!("the quadratic program is {status}").into()),
        }
    }
}

/// The matrix in the solver's own type.
fn clarabel(m: Csc) -> CscMatrix<f64> {
    CscMatrix::new(m.rows, m.columns, m.starts, m.row_indices, m.values)
}

fn main() -> Result<(), Box<dyn Error>> {
    let inertia = Matrix3::new(60.0, 2.0, -3.0, 2.0, 80.0, 5.0, -3.0, 5.0, 100.0);
    let slew = Slew {
        system: System::new(inertia, Torque::None)?,
        turn: Vector3::new(1.0, 1.5, -1.2),
        steps: 60,
        dt: 0.5,
        limit: 0.9,
    };
    let found = slew.solve()?;
    let effort = slew.effort(&found.nodes);
    println!(
        "{} quadratic programs, effort {effort:.6} N² m² s",
        found.iterations
    );
    for torque in found.nodes.torques.iter().step_by(6) {
        println!(
            "torque {:8.4} {:8.4} {:8.4} N m",
            torque.x, torque.y, torque.z
        );
    }
    Ok(())
}
