//! What several tests begin with: a particle on an axis, a wheel about its own.

/// A particle on the third axis of an inertial frame, and what is said of it besides.
pub(super) fn of_particle(more: &str) -> String {
    format!(
        r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s z$.
{more}"
    )
}

/// A cylinder about the third axis of its frame, and what is said of it besides.
pub(super) fn of_wheel(more: &str) -> String {
    format!(
        r"B is a frame fixed in the wheel.
$i, j, k$ are the axes of B.
G is the mass centre of the wheel.
$I$ is the moment of inertia of the wheel about k through G.
The wheel is a cylinder of mass $m$, radius $r$ and length $l$.
k is the axis of the cylinder.
{more}"
    )
}
