//! Where the methods that step may be used: what the map of `polhode stress` shows.

use crate::scene::{Member, Way, size};
use std::fmt;
use std::ops::RangeInclusive;

/// The motions on which a method that steps keeps six digits at its finest. The plan chooses within it.
///
/// ```
/// use polhode::scene::{Reach, Way};
/// let taylor = Reach::of(&Way::Taylor { tolerance: 1e-12 }).expect("it steps");
/// assert!(taylor.speed.contains(&3.0) && !taylor.speed.contains(&1e120));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Reach {
    /// Sizes of ω at the start, rad/s; a body at rest is always within.
    pub speed: RangeInclusive<f64>,
    /// The largest moment of inertia over the smallest, at most.
    pub ratio: f64,
    /// The angle turned, rad, at most.
    pub angle: f64,
}

impl Reach {
    /// That of a way with steps whose error is bounded; others have none.
    pub fn of(way: &Way) -> Option<Self> {
        let speed = match way {
            Way::Taylor { .. } => 1e-30..=1e30,
            Way::Dop853 { .. } => 1e-75..=1e75,
            _ => return None,
        };
        Some(Self {
            speed,
            ratio: 1e12,
            angle: 4e6,
        })
    }

    /// Whether the motion of a member lies within that turns by `angle` ([`angle()`](crate::scene::angle)).
    pub fn holds(&self, member: &Member, angle: f64) -> bool {
        let speed = size(&member.start.angular_velocity);
        let moments = member.body.moments();
        let ratio = moments.z / moments.x;
        (speed == 0.0 || self.speed.contains(&speed)) && ratio <= self.ratio && angle <= self.angle
    }
}

impl fmt::Display for Reach {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{:e} to {:e} rad/s, moments up to 1:{:e}, up to {:e} rad turned",
            self.speed.start(),
            self.speed.end(),
            self.ratio,
            self.angle
        )
    }
}
